//! Loads per length at a particle, with both tangents; gravity that changes from place to place.

use super::branches;
use super::courses::{CourseKernel, course_along, course_of};
use super::kernel::{Kernel, derivatives, values};
use super::markers::{Marked, function_name};
use crate::model::{Distributed, Expr, LoadKind, MarkerId, Model, Observable, ParticleVector};
use crate::symbolic::Id;

/// What functions of kinks write.
const GAPS: &str = "writes what changes its sign at each kink.";

/// The functions of one load.
#[derive(Clone, Debug)]
pub struct DistributedKernels {
    /// Vectors of the particle that it depends on and acts on, ascending.
    pub vectors: Vec<ParticleVector>,
    /// Forces per length on them.
    pub force: Kernel,
    /// Their derivatives, where not zero.
    pub tangent: Option<Kernel>,
    /// What changes its sign at each kink, where there is one.
    pub gaps: Option<Kernel>,
    /// What it does along the axis and over time that points and steps could jump over.
    pub course: Option<CourseKernel>,
}

/// The functions of all such loads of a model.
pub fn distributed_kernels(model: &Model) -> Vec<DistributedKernels> {
    let mut names = Vec::new();
    let loads = model.distributed.iter().map(|load| {
        let name = function_name(&load.name, &names);
        names.push(name.clone());
        kernels(model, load, &name)
    });
    loads.collect()
}

/// An expression with the vectors of the particle counted in a list.
fn localise(expr: &Expr, vectors: &[ParticleVector]) -> Expr {
    if let Expr::Observed(Observable::Marker {
        marker,
        derivative,
        component,
    }) = expr
        && let Some(own) = ParticleVector::of(*marker)
    {
        let place = vectors.iter().position(|&vector| vector == own).unwrap_or(0);
        return Expr::Observed(Observable::Marker {
            marker: MarkerId(place),
            derivative: *derivative,
            component: *component,
        });
    }
    let rebuilt = expr.with_parts(&mut |part| Some(localise(part, vectors)));
    rebuilt.unwrap_or_else(|| expr.clone())
}

/// Vectors of the particle that stand in expressions.
fn read<'e>(exprs: impl Iterator<Item = &'e Expr> + Clone) -> Vec<ParticleVector> {
    let is = |vector: &ParticleVector| {
        let marker = vector.marker();
        let reads =
            |part: &Expr| matches!(part, Expr::Observed(Observable::Marker { marker: other, .. }) if *other == marker);
        exprs.clone().any(|expr| expr.contains(&reads))
    };
    ParticleVector::ALL.into_iter().filter(is).collect()
}

fn kernels(model: &Model, load: &Distributed, name: &str) -> DistributedKernels {
    let mut vectors = read(load.forces.iter().flat_map(|(_, components)| components));
    vectors.extend(load.forces.iter().map(|&(of, _)| of));
    vectors.sort_unstable();
    vectors.dedup();
    let count = vectors.len();
    let in_graph = || {
        let mut marked = Marked::values_and_rates(model, count);
        marked.time.graph.guard_zeros();
        let zero = marked.time.graph.zero();
        let mut forces = vec![zero; 3 * count];
        for (of, components) in &load.forces {
            let place = 3 * vectors.iter().position(|vector| vector == of).unwrap_or(0);
            for (axis, component) in components.iter().enumerate() {
                forces[place + axis] = marked.time.expression(&localise(component, &vectors));
            }
        }
        (marked, forces)
    };
    let repeated = model.bodies[load.body.0].repeat.is_some();
    let kernel = |marked: Marked, what: &str, title: &str, outputs: Vec<(String, Id)>, results: &[&str]| {
        let title = format!("Load per length `{}`: {title}", load.name);
        let mut arguments = vec!["[x, length]: [f64; 2]"];
        arguments.extend(repeated.then_some("index: f64"));
        arguments.extend(["z: &[::rncf::emitted::Vector]", "velocity: &[::rncf::emitted::Vector]"]);
        arguments.extend(results);
        let mut kernel = marked.kernel(format!("distributed_{what}_{name}"), title, outputs, &arguments);
        let words: Vec<String> = vectors.iter().map(|vector| format!("{vector:?}")).collect();
        kernel.doc.push(format!(
            "At the arclength `x` of an axis with the length `length`; `z` and `velocity` are those of: {} (inertial axes).",
            words.join(", ")
        ));
        kernel
    };
    let (marked, forces) = in_graph();
    let graph = &marked.time.graph;
    let outputs = values(&forces, "out").into_iter();
    let outputs = outputs.filter(|&(_, id)| !graph.is_zero(id)).collect();
    let title = "writes f(x, z, z', t) on the vectors of a particle; entries that are always zero are left alone.";
    let force = kernel(marked, "force", title, outputs, &["out: &mut [f64]"]);
    let (mut marked, forces) = in_graph();
    let (z, velocity) = (marked.symbols[0].clone(), marked.symbols[1].clone());
    let mut outputs = derivatives(&mut marked.time.graph, &forces, &z, "by_value");
    outputs.extend(derivatives(&mut marked.time.graph, &forces, &velocity, "by_velocity"));
    let title = "writes df/dz and df/dz', rows first; entries that are always zero are left alone.";
    let results = ["by_value: &mut [f64]", "by_velocity: &mut [f64]"];
    let tangent = (!outputs.is_empty()).then(|| kernel(marked, "tangent", title, outputs, &results));
    let components: Vec<Expr> = load
        .forces
        .iter()
        .flat_map(|(_, components)| components)
        .map(|one| localise(one, &vectors))
        .collect();
    let mut marked = Marked::values_and_rates(model, count);
    let gaps = branches::gaps(&mut marked, &components);
    let gaps = (!gaps.is_empty()).then(|| kernel(marked, "gaps", GAPS, values(&gaps, "out"), &["out: &mut [f64]"]));
    DistributedKernels {
        vectors,
        force,
        tangent,
        gaps,
        course: course_along(model, load, name),
    }
}

/// Gravity as a function of the place.
#[derive(Clone, Debug)]
pub struct AroundKernels {
    /// Index of the load.
    pub load: usize,
    /// Its value and its derivatives.
    pub kernels: [Kernel; 2],
    /// What changes its sign at each kink, where there is one.
    pub gaps: Option<Kernel>,
    /// What it does over the place that steps could jump over.
    pub course: Option<CourseKernel>,
}

/// The functions of all gravity that is a function of the place.
pub fn around_kernels(model: &Model) -> Vec<AroundKernels> {
    let mut names = Vec::new();
    let loads = model.loads.iter().enumerate();
    let kernels = loads.filter_map(|(index, load)| {
        let LoadKind::Around(components) = &load.kind else {
            return None;
        };
        let name = function_name(&load.name, &names);
        names.push(name.clone());
        let components: Vec<Expr> = components
            .iter()
            .map(|component| localise(component, &[ParticleVector::Position]))
            .collect();
        let in_graph = || {
            let mut marked = Marked::new(model, 1, &[&|_, component| format!("place[{component}]")]);
            let field: Vec<Id> = components.iter().map(|one| marked.time.expression(one)).collect();
            (marked, field)
        };
        let title = format!("Gravity `{}`: g(r, t), m/s^2, inertial axes.", load.name);
        let (marked, field) = in_graph();
        let outputs = values(&field, "gravity");
        let arguments = ["place: ::rncf::emitted::Vector", "gravity: &mut [f64; 3]"];
        let value = marked.kernel(format!("around_{name}"), title, outputs, &arguments);
        let (mut marked, field) = in_graph();
        let place = marked.symbols[0].clone();
        let outputs = derivatives(&mut marked.time.graph, &field, &place, "gradient");
        let title = format!(
            "Gravity `{}`: writes dg/dr, rows first; zeros are left alone.",
            load.name
        );
        let arguments = ["place: ::rncf::emitted::Vector", "gradient: &mut [f64; 9]"];
        let gradient = marked.kernel(format!("around_gradient_{name}"), title, outputs, &arguments);
        let mut marked = Marked::new(model, 1, &[&|_, component| format!("place[{component}]")]);
        let gaps = branches::gaps(&mut marked, &components);
        let title = format!("Gravity `{}`: {GAPS}", load.name);
        let arguments = ["place: ::rncf::emitted::Vector", "out: &mut [f64]"];
        let gaps = (!gaps.is_empty())
            .then(|| marked.kernel(format!("around_gaps_{name}"), title, values(&gaps, "out"), &arguments));
        Some(AroundKernels {
            load: index,
            kernels: [value, gradient],
            gaps,
            course: course_of(
                model,
                &components,
                &format!("around_{name}"),
                &format!("load `{}`", load.name),
            ),
        })
    });
    kernels.collect()
}
