//! Loads, outputs and shape functions as kernels.

use super::kernel::{Kernel, derivatives, values};
use super::variant::Variant;
use crate::elements::{Interpolant, Library};
use crate::model::{Expr, Load, LoadKind, Model, Observable, Reduction, RepeatId};
use crate::symbolic::Time;
use crate::symbolic::{Graph, Id};

/// Components of the loads that are functions of time alone, in their frames' axes, with their indices.
pub fn load_kernels(model: &Model) -> Vec<(usize, Kernel)> {
    let loads = model.loads.iter().enumerate();
    let timed = loads.filter(|(_, load)| !matches!(load.kind, LoadKind::Field { .. } | LoadKind::Around(_)));
    timed.map(|(index, load)| (index, load_kernel(model, load))).collect()
}

fn load_kernel(model: &Model, load: &Load) -> Kernel {
    let mut time = Time::new(model);
    let value = time.vector(load.kind.components());
    let outputs = value
        .iter()
        .enumerate()
        .map(|(i, &id)| (format!("value[{i}]"), id))
        .collect();
    let title = format!("Load `{}` in its frame's axes.", load.name);
    let mut kernel = time.kernel(format!("load_{}", crate::model::identifier(&load.name)), title, outputs);
    kernel.arguments.push("value: &mut [f64; 3]".to_string());
    kernel
}

/// Generalised force of a moment on a slope, `Q = m x s / (s . s)`, and its derivative.
pub fn moment_kernels(dimension: usize) -> [Kernel; 2] {
    let word = if dimension == 2 { "planar" } else { "spatial" };
    [false, true].map(|tangent| {
        let mut graph = Graph::new();
        let slope: Vec<Id> = (0..dimension).map(|i| graph.symbol(format!("slope[{i}]"))).collect();
        let moment: Vec<Id> = (0..3).map(|i| graph.symbol(format!("moment[{i}]"))).collect();
        let turned = if dimension == 2 {
            let (x, y) = (graph.multiply(moment[0], slope[0]), graph.multiply(moment[0], slope[1]));
            vec![graph.negate(y), x]
        } else {
            graph.cross(&moment, &slope)
        };
        let square = graph.dot(&slope, &slope);
        let force: Vec<Id> = turned.iter().map(|&component| graph.divide(component, square)).collect();
        let mut outputs = Vec::new();
        for (row, &component) in force.iter().enumerate() {
            if !tangent {
                outputs.push((format!("force[{row}]"), component));
                continue;
            }
            for (column, &symbol) in slope.iter().enumerate() {
                let derivative = graph.partial(component, symbol);
                outputs.push((format!("tangent[{}]", row * dimension + column), derivative));
            }
        }
        let (name, title, last) = if tangent {
            ("moment_tangent", "Adds its derivative with respect to the slope, rows first.", "tangent: &mut [f64]")
        } else {
            (
                "moment",
                "Adds the generalised force of a moment on a slope, Q = m x s / (s . s) (virtual work of a turning slope).",
                "force: &mut [f64]",
            )
        };
        Kernel {
            name: format!("{name}_{word}"),
            doc: vec![title.to_string()],
            arguments: ["slope: &[f64]", "moment: [f64; 3]", last].map(str::to_string).to_vec(),
            bindings: Vec::new(),
            graph,
            points: None,
            outputs,
            assign: false,
        }
    })
}

/// Generalised force of a moment on the axes r_y, r_z of a section in space, and its derivative: with b = r_y,
/// c = r_z, n = b x c and D = n . n the exact virtual work of a section that turns with its axes is
///
/// ```text
/// Q_y = -(M . c) n / D + (M . n) c / (2 D)
/// Q_z =  (M . b) n / D - (M . n) b / (2 D)      b x Q_y + c x Q_z = M
/// ```
pub fn section_moment_kernels() -> [Kernel; 2] {
    [false, true].map(|tangent| {
        let mut graph = Graph::new();
        let axes: Vec<Id> = (0..6).map(|i| graph.symbol(format!("axes[{i}]"))).collect();
        let moment: Vec<Id> = (0..3).map(|i| graph.symbol(format!("moment[{i}]"))).collect();
        let (b, c) = axes.split_at(3);
        let normal = graph.cross(b, c);
        let square = graph.dot(&normal, &normal);
        let [along_b, along_c, along_n] = [b, c, &normal].map(|axis| {
            let part = graph.dot(&moment, axis);
            graph.divide(part, square)
        });
        let half = graph.number(0.5);
        let twist = graph.multiply(half, along_n);
        let sum = |graph: &mut Graph, bending: Id, twist: Id, axis: &[Id]| {
            let (bent, twisted) = (graph.scale(bending, &normal), graph.scale(twist, axis));
            graph.add_vectors(&bent, &twisted)
        };
        let (minus_c, minus_twist) = (graph.negate(along_c), graph.negate(twist));
        let mut force = sum(&mut graph, minus_c, twist, c);
        force.extend(sum(&mut graph, along_b, minus_twist, b));
        let outputs = if tangent {
            derivatives(&mut graph, &force, &axes, "tangent")
        } else {
            values(&force, "force")
        };
        let (name, title, last) = if tangent {
            (
                "section_moment_tangent",
                "Adds its derivative with respect to the axes, rows first.",
                "tangent: &mut [f64; 36]",
            )
        } else {
            (
                "section_moment",
                "Adds the generalised force of a moment M on the axes b = r_y and c = r_z of a section: with n = b x c and \
                 D = n . n, Q_y = -(M . c) n/D + (M . n) c/(2 D), Q_z = (M . b) n/D - (M . n) b/(2 D), so that \
                 b x Q_y + c x Q_z = M.",
                "force: &mut [f64; 6]",
            )
        };
        Kernel {
            name: name.to_string(),
            doc: vec![title.to_string()],
            arguments: ["axes: &[f64; 6]", "moment: [f64; 3]", last].map(str::to_string).to_vec(),
            bindings: Vec::new(),
            graph,
            points: None,
            outputs,
            assign: false,
        }
    })
}

/// Weights of the nodal vectors in the derivatives d/dx of every interpolant, order by order up to the highest that
/// the strain energy, a slope or an axis of the section is a function of.
pub fn shape_kernels(variant: &Variant, library: &Library) -> Vec<(Interpolant, Vec<Kernel>)> {
    let vectors = variant.vectors(library);
    let highest = |of: Interpolant| {
        let fields = variant.declaration(library).fields_in(variant.dimension);
        let orders = fields.filter(|field| field.of == of).map(|field| field.order);
        orders.fold(usize::from(of == Interpolant::Position), usize::max)
    };
    let all = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ].into_iter();
    let there = all.filter(|of| vectors.iter().any(|vector| vector.of == *of));
    there
        .map(|of| {
            let orders = 0..=highest(of);
            (
                of,
                orders.map(|order| shape_kernel(variant, library, of, order)).collect(),
            )
        })
        .collect()
}

fn shape_kernel(variant: &Variant, library: &Library, of: Interpolant, order: usize) -> Kernel {
    let mut graph = Graph::new();
    let (length, xi) = (graph.symbol("length"), graph.symbol("xi"));
    let vectors = variant.vectors(library);
    let mut outputs = Vec::new();
    for (index, vector) in vectors.iter().enumerate().filter(|(_, vector)| vector.of == of) {
        let polynomial = vector.shape.derivative(order);
        let mut sum = graph.zero();
        for coefficient in polynomial.coefficients().iter().rev() {
            let number = graph.number(coefficient.to_f64());
            let product = graph.multiply(sum, xi);
            sum = graph.add(product, number);
        }
        let scale = graph.power(length, vector.order as i32 - order as i32);
        outputs.push((format!("weights[{index}]"), graph.multiply(sum, scale)));
    }
    let (word, what) = match of {
        Interpolant::Position => ("position", "the position"),
        Interpolant::SectionY => ("section_y", "the section's y axis"),
        Interpolant::SectionZ => ("section_z", "the section's z axis"),
    };
    let derivative = match order {
        0 => String::new(),
        1 => "d/dx of ".to_string(),
        order => format!("d{order}/dx{order} of "),
    };
    Kernel {
        name: format!("{}_shapes_{word}_{order}", variant.name(library)),
        doc: vec![format!(
            "Weights of the nodal vectors in {derivative}{what} at xi in [0, 1]; the others are left alone."
        )],
        arguments: vec![
            "length: f64".to_string(),
            "xi: f64".to_string(),
            format!("weights: &mut [f64; {}]", vectors.len()),
        ],
        bindings: Vec::new(),
        graph,
        points: None,
        outputs,
        assign: true,
    }
}

/// A reduction over the repetitions of a loop.
pub struct Reduced {
    /// What is told.
    pub reduction: Reduction,
    /// The loop.
    pub repeat: RepeatId,
    /// What each repetition reads, in order.
    pub observed: Vec<Observable>,
    /// Value of one repetition: `value[0]` from `index` and what is observed there.
    pub kernel: Kernel,
}

/// The reductions among what outputs observe, in order.
pub fn reductions(model: &Model, observed: &[Observable]) -> Vec<Reduced> {
    let mut all: Vec<Reduced> = Vec::new();
    for observable in observed {
        if let Observable::Reduced {
            reduction,
            repeat,
            value,
        } = observable
        {
            let mut time = Time::new(model);
            let outputs = vec![("value[0]".to_string(), time.expression(value))];
            let observed = time.observed.iter().map(|(observable, _)| observable.clone()).collect();
            let title = "What an output reduces, of one repetition.".to_string();
            let mut kernel = time.kernel(format!("outputs_of_one_{}", all.len()), title, outputs);
            kernel
                .arguments
                .extend(["index: f64", "observed: &[f64]", "value: &mut [f64; 1]"].map(str::to_string));
            all.push(Reduced {
                reduction: *reduction,
                repeat: *repeat,
                observed,
                kernel,
            });
        }
    }
    all
}

/// Output columns from what they observe, and the list of what is observed: reductions last.
pub fn outputs_kernel(model: &Model) -> (Kernel, Vec<Observable>) {
    let components = || model.outputs.iter().flat_map(|output| &output.components);
    let mut first = Time::new(model);
    for (_, expr) in components() {
        first.expression(expr);
    }
    let is_reduced = |observable: &Observable| matches!(observable, Observable::Reduced { .. });
    let found = first.observed.into_iter().map(|(observable, _)| observable);
    let (reduced, plain): (Vec<_>, Vec<_>) = found.partition(is_reduced);
    let mut time = Time::new(model);
    for observable in plain.into_iter().chain(reduced) {
        time.expression(&Expr::Observed(observable));
    }
    let mut outputs = Vec::new();
    for (_, expr) in components() {
        let id = time.expression(expr);
        outputs.push((format!("out[{}]", outputs.len()), id));
    }
    let observed = time.observed.iter().map(|(observable, _)| observable.clone()).collect();
    let title = "Output columns from what they observe.".to_string();
    let mut kernel = time.kernel("outputs".to_string(), title, outputs);
    kernel
        .arguments
        .extend(["observed: &[f64]", "out: &mut [f64]"].map(str::to_string));
    (kernel, observed)
}

/// Defaults of a run.
pub fn run_kernel(model: &Model) -> Kernel {
    let mut time = Time::new(model);
    let outputs = vec![
        ("run.t_end".to_string(), time.expression(&model.run.t_end)),
        ("run.every".to_string(), time.expression(&model.run.every)),
    ];
    let mut kernel = time.kernel(
        "run_defaults".to_string(),
        "Defaults of a run (s).".to_string(),
        outputs,
    );
    kernel.arguments.remove(1);
    kernel.arguments.push("run: &mut ::rncf::RunDefaults".to_string());
    kernel
}
