//! Loads and outputs as kernels.

use super::kernel::Kernel;
use super::motions::Time;
use super::variant::Variant;
use crate::elements::Library;
use crate::model::{Load, Model, Observable};
use crate::symbolic::{Graph, Id};

/// Components of a load in its frame's axes.
pub fn load_kernel(model: &Model, load: &Load) -> Kernel {
    let mut time = Time::new(model);
    let value = time.vector(load.kind.components());
    let outputs = value
        .iter()
        .enumerate()
        .map(|(i, &id)| (format!("value[{i}]"), id))
        .collect();
    let title = format!("Load `{}` in its frame's axes.", load.name);
    let mut kernel = time.kernel(format!("load_{}", load.name), title, outputs);
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

/// Shape functions of a variant and their derivatives d/dx.
pub fn shapes_kernel(variant: &Variant, library: &Library) -> Kernel {
    let mut graph = Graph::new();
    let (length, xi) = (graph.symbol("length"), graph.symbol("xi"));
    let mut outputs = Vec::new();
    for (order, name) in ["values", "slopes"].into_iter().enumerate() {
        for (index, vector) in variant.declaration(library).vectors.iter().enumerate() {
            let polynomial = (vector.shape)().derivative(order);
            let mut sum = graph.zero();
            for coefficient in polynomial.coefficients().iter().rev() {
                let number = graph.number(coefficient.to_f64());
                let product = graph.multiply(sum, xi);
                sum = graph.add(product, number);
            }
            let scale = graph.power(length, vector.order as i32 - order as i32);
            outputs.push((format!("{name}[{index}]"), graph.multiply(sum, scale)));
        }
    }
    let count = variant.declaration(library).vectors.len();
    Kernel {
        name: format!("{}_shapes", variant.name(library)),
        doc: vec!["Shape functions of the nodal vectors at xi in [0, 1], and their derivatives d/dx.".to_string()],
        arguments: vec![
            "length: f64".to_string(),
            "xi: f64".to_string(),
            format!("values: &mut [f64; {count}]"),
            format!("slopes: &mut [f64; {count}]"),
        ],
        bindings: Vec::new(),
        graph,
        points: None,
        outputs,
        assign: true,
    }
}

/// Output columns from what they observe, and the list of what is observed.
pub fn outputs_kernel(model: &Model) -> (Kernel, Vec<Observable>) {
    let mut time = Time::new(model);
    let mut outputs = Vec::new();
    for (_, expr) in model.outputs.iter().flat_map(|output| &output.components) {
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
