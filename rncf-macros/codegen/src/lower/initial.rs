//! Initial shapes: a vector along a body's axis and its derivative with respect to the arclength.

use std::collections::HashMap;

use super::kernel::Kernel;
use super::motions::Time;
use crate::model::{Body, Expr, Model};
use crate::symbolic::Id;

/// Initial position and velocity of a body at the arclength x, with their derivatives by x. None of
/// both where the body starts undeformed and at rest.
pub fn initial_kernel(model: &Model, body: &Body) -> Option<Kernel> {
    let mut time = Time::new(model);
    let mut outputs = Vec::new();
    let initial = &body.initial;
    for (name, exprs) in [("position", &initial.position), ("velocity", &initial.velocity)] {
        let Some(exprs) = exprs else { continue };
        let [values, slopes] = derived(&mut time, exprs);
        for (what, ids) in [(0, values), (1, slopes)] {
            outputs.extend((0..3).map(|axis| (format!("{name}[{what}][{axis}]"), ids[axis])));
        }
    }
    if outputs.is_empty() {
        return None;
    }
    outputs.retain(|&(_, id)| !time.graph.is_zero(id));
    let title = format!(
        "Start of body `{}` at the arclength x (m): position (m) and velocity (m/s) in its frame, each with its derivative by x.",
        body.name
    );
    let mut kernel = time.kernel(format!("initial_{}", body.name), title, outputs);
    kernel.arguments[1] = "x: f64".to_string();
    if body.repeat.is_some() {
        kernel.arguments.push("index: f64".to_string());
    }
    for name in ["position", "velocity"] {
        kernel.arguments.push(format!("{name}: &mut [[f64; 3]; 2]"));
    }
    Some(kernel)
}

/// A vector at the arclength `x` and its derivative, with the parameters' defaults.
pub fn along_axis(model: &Model, exprs: &[Expr; 3], x: f64, index: f64) -> [[f64; 3]; 2] {
    let mut time = Time::new(model);
    let [values, slopes] = derived(&mut time, exprs);
    let mut inputs = HashMap::from([(time.t, 0.0), (time.x, x), (time.index, index)]);
    for (at, param) in model.params.iter().enumerate() {
        inputs.insert(time.param(at), param.default);
    }
    let roots: Vec<Id> = values.into_iter().chain(slopes).collect();
    let numbers = time.graph.evaluate(&roots, &inputs);
    [0, 3].map(|first| std::array::from_fn(|axis| numbers[first + axis]))
}

/// Components and their derivatives with respect to the arclength.
fn derived(time: &mut Time, exprs: &[Expr; 3]) -> [[Id; 3]; 2] {
    let values = exprs.each_ref().map(|expr| time.expression(expr));
    let x = time.x;
    let slopes = values.map(|value| time.graph.partial(value, x));
    [values, slopes]
}
