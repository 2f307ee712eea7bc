//! All kernels of a model, derived once.

use super::conserving::{Conserving, not_conservative};
use super::constraints::{ConstraintKernels, constraint_kernels};
use super::courses::{self, CourseKernel};
use super::density::{DensityKernels, FieldKernels, density_kernels, field_kernels};
use super::distributed::{AroundKernels, DistributedKernels, around_kernels, distributed_kernels};
use super::forces::{ForceKernels, force_kernels};
use super::free::free_kernel;
use super::initial::{initial_kernel, path_kernel};
use super::joints::{JointKernels, joint_kernels};
use super::kernel::Kernel;
use super::loads::{self, Reduced};
use super::motions::{self, is_free};
use super::variant::Variant;
use super::variant_kernels::{VariantKernels, variant_kernels};
use crate::elements::Library;
use crate::model::{BodyId, FrameId, INERTIAL, Joint, LoadKind, Model, Observable};

/// Everything that is derived for a model.
pub struct Equations {
    /// Element variants, each once.
    pub variants: Vec<VariantKernels>,
    /// Variant of every body.
    pub variant_of: Vec<usize>,
    /// Motion of every prescribed frame but the inertial one, with its index.
    pub frames: Vec<(usize, Kernel)>,
    /// Start of every free frame, with its index.
    pub free: Vec<(usize, Kernel)>,
    /// Start of every body that has an initial shape, with its index.
    pub initial: Vec<(usize, Kernel)>,
    /// Axes along functions, with the index of the body.
    pub paths: Vec<(usize, Kernel)>,
    /// Conditions of every joint: in the body's frame (`None` where that is the inertial one, or
    /// where the two move relative to each other in an unknown way), and in the inertial frame
    /// (`None` where the joint's frame moves freely).
    pub joints: Vec<(Option<JointKernels>, Option<JointKernels>)>,
    /// Constraints of markers.
    pub constraints: Vec<ConstraintKernels>,
    /// Forces on markers.
    pub forces: Vec<ForceKernels>,
    /// Loads but fields, with their indices.
    pub loads: Vec<(usize, Kernel)>,
    /// Loads per length.
    pub densities: Vec<DensityKernels>,
    /// Loads per length at points.
    pub distributed: Vec<DistributedKernels>,
    /// Gravity that changes from place to place, with the indices of the loads.
    pub around: Vec<AroundKernels>,
    /// Gravity fields.
    pub fields: Vec<FieldKernels>,
    /// Moment on a slope, or in a plane on a section's axis, by dimension, where needed.
    pub moments: Vec<(usize, [Kernel; 2])>,
    /// Moment on a section's axes in space, where needed.
    pub section_moments: Option<[Kernel; 2]>,
    /// Kinks, and conditions that time decides otherwise.
    pub switches: motions::Switches,
    /// Motions and loads over time, as operations.
    pub courses: Vec<CourseKernel>,
    /// Outputs and what they observe, reductions last.
    pub outputs: (Kernel, Vec<Observable>),
    /// Those reductions.
    pub reduced: Vec<Reduced>,
    /// Defaults of a run.
    pub run: Kernel,
    /// Whether energy is conserved.
    pub conservative: bool,
    /// Forces between two states that conserve it.
    pub conserving: Conserving,
}

/// Derives all kernels of a model that was checked.
pub fn lower(model: &Model, library: &Library) -> Equations {
    let mut variants: Vec<VariantKernels> = Vec::new();
    let mut variant_of = Vec::new();
    for body in &model.bodies {
        let variant = Variant::of(model, body, library);
        let index = variants
            .iter()
            .position(|other| other.variant == variant)
            .unwrap_or_else(|| {
                variants.push(variant_kernels(variant, library));
                variants.len() - 1
            });
        variant_of.push(index);
    }
    let mut moments: Vec<(usize, [Kernel; 2])> = Vec::new();
    let mut section_moments = None;
    for load in &model.loads {
        if let LoadKind::Moment { body, .. } = &load.kind {
            let dimension = model.bodies[body.0].space.dimension();
            if dimension == 3 && has_section(model, *body, library) {
                section_moments = Some(loads::section_moment_kernels());
            } else if moments.iter().all(|(other, _)| *other != dimension) {
                moments.push((dimension, loads::moment_kernels(dimension)));
            }
        }
    }
    let frames = model.frames.iter().enumerate().skip(1);
    let prescribed = frames.clone().filter(|(_, frame)| frame.free.is_none());
    let free = frames.filter_map(|(index, frame)| Some((index, frame, frame.free.as_ref()?)));
    let bodies = model.bodies.iter().enumerate();
    let paths = bodies
        .clone()
        .filter_map(|(index, body)| Some((index, path_kernel(model, body)?)));
    let initial = bodies.filter_map(|(index, body)| Some((index, initial_kernel(model, body)?)));
    let outputs = loads::outputs_kernel(model);
    let dissipation = not_conservative(model, library, (&variants, &variant_of));
    Equations {
        conserving: Conserving::derive(model, library, (&variants, &variant_of), dissipation.as_deref()),
        conservative: dissipation.is_none(),
        variant_of,
        frames: prescribed
            .map(|(index, _)| (index, motions::frame_kernel(model, FrameId(index))))
            .collect(),
        free: free
            .map(|(index, frame, free)| (index, free_kernel(model, frame, free)))
            .collect(),
        initial: initial.collect(),
        paths: paths.collect(),
        joints: model
            .joints
            .iter()
            .map(|joint| conditions(model, joint, library))
            .collect(),
        constraints: constraint_kernels(model),
        forces: force_kernels(model),
        loads: loads::load_kernels(model),
        densities: density_kernels(model, library),
        distributed: distributed_kernels(model),
        around: around_kernels(model),
        fields: field_kernels(model),
        moments,
        section_moments,
        switches: motions::switches(model, library),
        courses: courses::courses(model, library),
        reduced: loads::reductions(model, &outputs.1),
        outputs,
        run: loads::run_kernel(model),
        variants,
    }
}

/// Whether the nodes of a body carry the axes of its section.
fn has_section(model: &Model, body: BodyId, library: &Library) -> bool {
    library.elements[model.bodies[body.0].element.0].has_section()
}

/// The conditions of a joint where they are linear in the nodal vectors.
fn conditions(model: &Model, joint: &Joint, library: &Library) -> (Option<JointKernels>, Option<JointKernels>) {
    let frame = model.bodies[joint.body.0].frame;
    let known = joint.frame == frame || !(is_free(model, frame) || is_free(model, joint.frame));
    let referenced = frame != INERTIAL && known;
    let has_section = has_section(model, joint.body, library);
    (
        referenced.then(|| joint_kernels(model, joint, has_section, false)),
        (!is_free(model, joint.frame)).then(|| joint_kernels(model, joint, has_section, true)),
    )
}
