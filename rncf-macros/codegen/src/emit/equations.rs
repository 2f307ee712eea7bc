//! All kernels of a model, derived once.

use super::kernel::{documentation, function};
use crate::elements::Library;
use crate::lower::elastic::Form;
use crate::lower::inertia::{InertiaKernels, inertia_kernels};
use crate::lower::joints::{JointKernels, joint_kernels};
use crate::lower::{ElasticKernels, Kernel, Variant, elastic_kernels, loads, motions};
use crate::model::{FrameId, INERTIAL, LoadKind, Model, Observable};

/// An element variant with its kernels.
pub struct VariantKernels {
    /// The variant.
    pub variant: Variant,
    /// Name in generated code.
    pub name: String,
    /// Elastic kernels.
    pub elastic: ElasticKernels,
    /// Inertia kernels.
    pub inertia: InertiaKernels,
    /// Shape functions.
    pub shapes: Kernel,
    /// Documentation of the struct with the constants, and the struct's fields.
    pub row: String,
    /// Whether a body of this variant lives in a moving frame.
    pub moving: bool,
}

/// Everything that is derived for a model.
pub struct Equations {
    /// Element variants, each once.
    pub variants: Vec<VariantKernels>,
    /// Variant of every body.
    pub variant_of: Vec<usize>,
    /// Motion of every frame but the inertial one.
    pub frames: Vec<Kernel>,
    /// Conditions of every joint: in the body's frame (`None` where that is the inertial one), and in
    /// the inertial frame.
    pub joints: Vec<(Option<JointKernels>, JointKernels)>,
    /// Loads.
    pub loads: Vec<Kernel>,
    /// Moment on a slope, by dimension, where needed.
    pub moments: Vec<(usize, [Kernel; 2])>,
    /// Kinks and their number.
    pub kinks: (Kernel, usize),
    /// Outputs and what they observe.
    pub outputs: (Kernel, Vec<Observable>),
    /// Defaults of a run.
    pub run: Kernel,
    /// Whether energy is conserved.
    pub conservative: bool,
}

impl Equations {
    /// Derives all kernels.
    pub fn derive(model: &Model, library: &Library) -> Self {
        let mut variants: Vec<VariantKernels> = Vec::new();
        let mut variant_of = Vec::new();
        for body in &model.bodies {
            let variant = Variant::of(body, library);
            let index = variants
                .iter()
                .position(|other| other.variant == variant)
                .unwrap_or_else(|| {
                    variants.push(variant_kernels(variant, library));
                    variants.len() - 1
                });
            variants[index].moving |= body.frame != INERTIAL;
            variant_of.push(index);
        }
        let mut moments: Vec<(usize, [Kernel; 2])> = Vec::new();
        for load in &model.loads {
            if let LoadKind::Moment { body, .. } = &load.kind {
                let dimension = model.bodies[body.0].space.dimension();
                if moments.iter().all(|(other, _)| *other != dimension) {
                    moments.push((dimension, loads::moment_kernels(dimension)));
                }
            }
        }
        let joints = model.joints.iter().map(|joint| {
            let moving = model.bodies[joint.body.0].frame != INERTIAL;
            (
                moving.then(|| joint_kernels(model, joint, false)),
                joint_kernels(model, joint, true),
            )
        });
        Self {
            variant_of,
            frames: (1..model.frames.len())
                .map(|frame| motions::frame_kernel(model, FrameId(frame)))
                .collect(),
            joints: joints.collect(),
            loads: model.loads.iter().map(|load| loads::load_kernel(model, load)).collect(),
            moments,
            kinks: motions::kinks_kernel(model),
            outputs: loads::outputs_kernel(model),
            run: loads::run_kernel(model),
            conservative: conservative(model, &variants),
            variants,
        }
    }

    /// All functions and constants as text.
    pub fn functions(&self) -> String {
        let mut text = String::new();
        let mut add = |kernel: &Kernel| text += &function(kernel);
        for variant in &self.variants {
            for kernel in [
                &variant.elastic.force,
                &variant.elastic.tangent,
                &variant.elastic.energy,
            ] {
                add(kernel);
            }
            if let Some((kernel, _)) = &variant.elastic.reference {
                add(kernel);
            }
            let inertia = &variant.inertia;
            add(&inertia.mass);
            if variant.moving {
                add(&inertia.referenced);
                add(&inertia.referenced_tangent);
            }
            add(&inertia.absolute);
            add(&variant.shapes);
        }
        self.frames.iter().chain(&self.loads).for_each(&mut add);
        for (referenced, absolute) in &self.joints {
            for kernels in referenced.iter().chain([absolute]) {
                kernels.levels.iter().for_each(&mut add);
                add(&kernels.jacobian);
                add(&kernels.prescribed);
            }
        }
        for (_, kernels) in &self.moments {
            kernels.iter().for_each(&mut add);
        }
        add(&self.kinks.0);
        add(&self.outputs.0);
        add(&self.run);
        let rows: String = self.variants.iter().map(|variant| variant.row.clone()).collect();
        rows + &text
    }
}

fn variant_kernels(variant: Variant, library: &Library) -> VariantKernels {
    let elastic = elastic_kernels(&variant, library);
    let name = variant.name(library);
    let row = row(&variant, &name, &elastic, library);
    VariantKernels {
        inertia: inertia_kernels(&variant, library),
        shapes: loads::shapes_kernel(&variant, library),
        elastic,
        name,
        row,
        moving: false,
        variant,
    }
}

/// The struct with the constants of an element.
fn row(variant: &Variant, name: &str, elastic: &ElasticKernels, library: &Library) -> String {
    let element = variant.declaration(library);
    let names = element
        .vectors
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
    let mut text = documentation(doc.iter().map(String::as_str));
    text += &format!(
        "#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {} {{\n/// Length, m.\npub length: f64,\n",
        crate::lower::camel_case(name)
    );
    for coefficient in element.coefficients {
        let factors = coefficient.factors.join(" * ");
        text += &format!("/// {factors}, {}.\npub {}: f64,\n", coefficient.unit, coefficient.name);
    }
    text + "/// Damping of the strain measures, s.\npub damping: f64,\n}\n"
}

/// Energy is conserved where no frame that matters moves, no load varies and nothing damps. Moments
/// have no potential in general.
fn conservative(model: &Model, variants: &[VariantKernels]) -> bool {
    let frames = model
        .bodies
        .iter()
        .map(|body| body.frame)
        .chain(model.joints.iter().map(|joint| joint.frame));
    let mut frames = frames.chain(model.loads.iter().filter_map(|load| match load.kind {
        LoadKind::Force { frame, .. } => Some(frame),
        _ => None,
    }));
    let loads = model.loads.iter().all(|load| match &load.kind {
        LoadKind::Gravity(components) | LoadKind::Force { components, .. } => !motions::varies(model, components),
        LoadKind::Moment { .. } => false,
    });
    loads && variants.iter().all(|v| !v.variant.damped) && !frames.any(|frame| motions::moves(model, frame))
}
