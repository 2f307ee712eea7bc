//! The functions of a model, and the constants of its elements, as text.

use super::elements::{rows_side_by_side, side_by_side};
use super::kernel::{arrays, documentation, fits_lanes, function, function_of_lanes};
use crate::elements::Library;
use crate::lower::courses::CourseKernel;
use crate::lower::form::Form;
use crate::lower::{Equations, Kernel, VariantKernels, camel_case};

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

    /// Whether four of its elements can be evaluated side by side: their elastic kernels are straight-line code of what numbers of lanes can do.
    pub fn side_by_side(&self) -> bool {
        let elastic = &self.elastic;
        elastic.fields.is_none()
            && self.variant.material.is_none()
            && [&elastic.force, &elastic.tangent].into_iter().all(fits_lanes)
    }
}

impl Equations {
    /// All functions and constants as text.
    pub fn functions(&self, library: &Library) -> String {
        let mut text = String::new();
        for (kernel, in_lanes) in self.kernels() {
            if in_lanes {
                text += &function_of_lanes(kernel);
                text += &side_by_side(kernel);
            } else {
                text += &function(kernel);
            }
        }
        let rows: String = self.variants.iter().map(|variant| row(variant, library)).collect();
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

/// The struct with the constants of an element.
fn row(kernels: &VariantKernels, library: &Library) -> String {
    let VariantKernels {
        variant, name, elastic, ..
    } = kernels;
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
    let lanes = kernels.side_by_side();
    let (generics, number) = if lanes { ("<T = f64>", "T") } else { ("", "f64") };
    let mut text = documentation(doc.iter().map(String::as_str));
    text += &format!(
        "#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {}{generics} {{\n/// Length, m.\npub length: {number},\n",
        camel_case(name)
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
        text += &rows_side_by_side(&camel_case(name), &fields);
    }
    text
}
