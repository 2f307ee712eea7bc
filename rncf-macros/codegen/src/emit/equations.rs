//! All kernels of a model, derived once.

use super::conserving::{Conserving, not_conservative};
use super::elements::{rows_side_by_side, side_by_side};
use super::kernel::{arrays, documentation, fits_lanes, function, function_of_lanes};
use super::moving::document_rows;
use crate::elements::{Interpolant, Library};
use crate::lower::constraints::{ConstraintKernels, constraint_kernels};
use crate::lower::courses::CourseKernel;
use crate::lower::density::{DensityKernels, FieldKernels, density_kernels, field_kernels};
use crate::lower::distributed::{AroundKernels, DistributedKernels, around_kernels, distributed_kernels};
use crate::lower::elastic::Form;
use crate::lower::field_forces::field_forces_kernel;
use crate::lower::forces::{ForceKernels, force_kernels};
use crate::lower::free::free_kernel;
use crate::lower::inertia::mass_kernel;
use crate::lower::initial::{initial_kernel, path_kernel};
use crate::lower::joints::{JointKernels, joint_kernels};
pub use crate::lower::loads::Reduced;
use crate::lower::{ElasticKernels, Kernel, Variant, courses, elastic_kernels, loads, motions};
use crate::model::{BodyId, FrameId, INERTIAL, Joint, LoadKind, Model, Observable};

/// An element variant with its kernels.
pub struct VariantKernels {
    /// The variant.
    pub variant: Variant,
    /// Name in generated code.
    pub name: String,
    /// Elastic kernels.
    pub elastic: ElasticKernels,
    /// Mass matrix of the nodal vectors.
    pub mass: Kernel,
    /// Weights of the nodal vectors in each interpolant and its derivatives.
    pub shapes: Vec<(Interpolant, Vec<Kernel>)>,
    /// Forces on the fields at a point.
    pub field_forces: Kernel,
    /// Documentation of the struct with the constants, and the struct's fields.
    pub row: String,
}

impl VariantKernels {
    /// Its functions in the order of the text, and whether each is written for four elements side by side, too.
    fn kernels(&self) -> Vec<(&Kernel, bool)> {
        let elastic = &self.elastic;
        let points = elastic.fields.iter().flat_map(|fields| &fields.rules);
        let before = points.flat_map(|rule| rule.particles.iter().chain(&rule.kernels));
        let in_lanes = self.side_by_side();
        let mut after = vec![&elastic.energy];
        after.extend(&elastic.reference);
        after.extend((!self.variant.varying).then_some(&self.mass));
        after.extend(self.shapes.iter().flat_map(|(_, orders)| orders));
        after.push(&self.field_forces);
        let alone = |kernel| (kernel, false);
        let mut kernels: Vec<(&Kernel, bool)> = before.map(alone).collect();
        kernels.extend([&elastic.force, &elastic.tangent].map(|kernel| (kernel, in_lanes)));
        kernels.extend(after.into_iter().map(alone));
        kernels
    }

    /// Whether four of its elements can be evaluated side by side.
    pub fn side_by_side(&self) -> bool {
        fit_lanes(&self.variant, &self.elastic)
    }
}

/// Whether the elastic kernels of an element are straight-line code of what numbers of lanes can do.
fn fit_lanes(variant: &Variant, elastic: &ElasticKernels) -> bool {
    elastic.fields.is_none()
        && variant.material.is_none()
        && [&elastic.force, &elastic.tangent].into_iter().all(fits_lanes)
}

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

impl Equations {
    /// Derives all kernels.
    pub fn derive(model: &Model, library: &Library) -> Self {
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
        let mut constraints = constraint_kernels(model);
        constraints.iter_mut().for_each(|kernels| document_rows(kernels, model));
        let dissipation = not_conservative(model, library, (&variants, &variant_of));
        Self {
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
            constraints,
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

    /// All functions and constants as text.
    pub fn functions(&self) -> String {
        let mut text = String::new();
        for (kernel, in_lanes) in self.kernels() {
            if in_lanes {
                text += &function_of_lanes(kernel);
                text += &side_by_side(kernel);
            } else {
                text += &function(kernel);
            }
        }
        let rows: String = self.variants.iter().map(|variant| variant.row.clone()).collect();
        let tables = self.variants.iter().filter_map(|variant| {
            let fields = variant.elastic.fields.as_ref()?;
            Some(super::points::tables(&variant.name, variant.variant.dimension, fields))
        });
        let between = self
            .variants
            .iter()
            .zip(&self.conserving.kernels)
            .map(|(variant, between)| {
                let size = variant.elastic.fields.as_ref().map_or(0, |fields| fields.groups.size());
                super::points::tables_between(&variant.name, size, between)
            });
        let tables = tables.chain(between);
        rows + &arrays(self.of_elements()) + &tables.collect::<String>() + &text
    }

    /// The functions that read constant tensors of the unit elements.
    pub fn of_elements(&self) -> impl Iterator<Item = &Kernel> {
        let own = self.variants.iter().flat_map(|variant| {
            let elastic = &variant.elastic;
            let mass = (!variant.variant.varying).then_some(&variant.mass);
            mass.into_iter()
                .chain([&elastic.force, &elastic.tangent, &elastic.energy])
        });
        let densities = self
            .densities
            .iter()
            .flat_map(|kernels| [&kernels.force, &kernels.tangent]);
        own.chain(self.conserving.kernels.iter().flat_map(|between| &between.kernels))
            .chain(densities)
    }

    /// All functions in the order of the text, and whether each is written for four elements side by side, too.
    pub fn kernels(&self) -> Vec<(&Kernel, bool)> {
        let mut kernels = Vec::new();
        for variant in &self.variants {
            kernels.extend(variant.kernels());
        }
        let mut single: Vec<&Kernel> = Vec::new();
        for between in &self.conserving.kernels {
            single.extend(between.rules.iter().flat_map(|rule| &rule.kernels));
            single.extend(&between.kernels);
        }
        single.extend(self.rest());
        kernels.extend(single.into_iter().map(|kernel| (kernel, false)));
        kernels.extend(self.load_kernels());
        kernels
    }

    /// The functions that belong to no element.
    fn rest(&self) -> Vec<&Kernel> {
        let mut kernels: Vec<&Kernel> = Vec::new();
        let starts = self
            .frames
            .iter()
            .chain(&self.free)
            .chain(&self.initial)
            .chain(&self.paths);
        kernels.extend(starts.map(|(_, kernel)| kernel));
        kernels.extend(self.loads.iter().map(|(_, kernel)| kernel));
        for (referenced, absolute) in &self.joints {
            for joint in referenced.iter().chain(absolute) {
                kernels.extend(joint.levels.iter().flatten());
                kernels.extend([&joint.jacobian, &joint.prescribed]);
            }
        }
        for constraint in &self.constraints {
            kernels.extend(&constraint.levels);
            kernels.push(&constraint.gradient);
            let others = [&constraint.rate_gradient, &constraint.hessian, &constraint.branches];
            kernels.extend(others.into_iter().flatten());
        }
        for force in &self.forces {
            kernels.push(&force.force);
            kernels.extend([&force.tangent, &force.energy, &force.branches].into_iter().flatten());
            kernels.extend(force.course.as_ref().and_then(CourseKernel::kernel));
        }
        kernels.extend(self.moments.iter().flat_map(|(_, kernels)| kernels));
        kernels.extend(self.section_moments.iter().flatten());
        kernels.extend(self.reduced.iter().map(|reduced| &reduced.kernel));
        kernels.extend((self.switches.kinks.1 > 0).then_some(&self.switches.kinks.0));
        if self.switches.gaps.1 > 0 {
            kernels.push(&self.switches.gaps.0);
        }
        kernels.extend(self.switches.repeated.iter().map(|(_, kernel, _)| kernel));
        kernels.extend(self.courses.iter().filter_map(CourseKernel::kernel));
        kernels.extend([&self.outputs.0, &self.run]);
        kernels
    }
}

/// Whether a frame's pose is unknown.
pub fn is_free(model: &Model, frame: FrameId) -> bool {
    model.frames[frame.0].free.is_some()
}

/// Whether the nodes of a body carry the axes of its section.
pub fn has_section(model: &Model, body: BodyId, library: &Library) -> bool {
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

fn variant_kernels(variant: Variant, library: &Library) -> VariantKernels {
    let elastic = elastic_kernels(&variant, library);
    let name = variant.name(library);
    let row = row(&variant, &name, &elastic, library);
    VariantKernels {
        mass: mass_kernel(&variant, library),
        shapes: loads::shape_kernels(&variant, library),
        field_forces: field_forces_kernel(&variant, library),
        elastic,
        name,
        row,
        variant,
    }
}

/// The struct with the constants of an element.
fn row(variant: &Variant, name: &str, elastic: &ElasticKernels, library: &Library) -> String {
    let element = variant.declaration(library);
    let names = variant
        .vectors(library)
        .iter()
        .map(|vector| vector.name)
        .collect::<Vec<_>>()
        .join(", ");
    let mut doc = vec![
        format!("Constants of one element `{name}`. {}.", element.doc),
        format!("Nodal vectors: {names}, {} components each.", variant.dimension),
        elastic.choice.clone(),
    ];
    if elastic.form != Form::Tensor && variant.quadrature == crate::model::Quadrature::Exact {
        doc.push(format!(
            "The energy is integrated with {} Gauss points.",
            element.default_points
        ));
    }
    let lanes = fit_lanes(variant, elastic);
    let (generics, number) = if lanes { ("<T = f64>", "T") } else { ("", "f64") };
    let mut text = documentation(doc.iter().map(String::as_str));
    text += &format!(
        "#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {}{generics} {{\n/// Length, m.\npub length: {number},\n",
        crate::lower::camel_case(name)
    );
    let coefficients = variant.coefficients(library);
    for coefficient in &coefficients {
        let given = if coefficient.is_timed() {
            "what params and the time give"
        } else {
            "what params give"
        };
        let scale = coefficient.scale.as_ref().map(|_| given);
        let factors: Vec<&str> = scale.into_iter().chain(coefficient.factors.iter().copied()).collect();
        text += &format!(
            "/// {}, {}.\npub {}: {number},\n",
            factors.join(" * "),
            coefficient.unit,
            coefficient.name
        );
    }
    let damping = variant.damped.then_some("damping");
    if damping.is_some() {
        text += &format!("/// Damping of the strain measures, s.\npub damping: {number},\n");
    }
    match &variant.material {
        Some(material) => return text + &super::points::material_fields(name, material, variant.damped),
        None => text += "}\n",
    }
    if lanes {
        let coefficients = coefficients.iter().map(|coefficient| coefficient.name);
        let fields: Vec<&str> = ["length"].into_iter().chain(coefficients).chain(damping).collect();
        text += &rows_side_by_side(&crate::lower::camel_case(name), &fields);
    }
    text
}
