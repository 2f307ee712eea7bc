//! Initial shapes, and axes along functions: a vector along a body and its derivative by the arclength or parameter.

use super::kernel::Kernel;
use crate::model::{Body, Line, Model};
use crate::symbolic::{Time, derived};

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
    let mut kernel = time.kernel(format!("initial_{}", body.identifier()), title, outputs);
    kernel.arguments[1] = "x: f64".to_string();
    if body.repeat.is_some() {
        kernel.arguments.push("index: f64".to_string());
    }
    for name in ["position", "velocity"] {
        kernel.arguments.push(format!("{name}: &mut [[f64; 3]; 2]"));
    }
    Some(kernel)
}

/// Place on a body's axis at the parameter of its curve, with the derivative by that. None where the axis is no such curve.
pub fn path_kernel(model: &Model, body: &Body) -> Option<Kernel> {
    let Line::Path { position, .. } = &body.line else {
        return None;
    };
    let mut time = Time::new(model);
    let [values, slopes] = derived(&mut time, position);
    let of = |what: usize, ids: [crate::symbolic::Id; 3]| {
        (0..3).map(move |axis| (format!("path[{what}][{axis}]"), ids[axis]))
    };
    let mut outputs: Vec<_> = of(0, values).chain(of(1, slopes)).collect();
    outputs.retain(|&(_, id)| !time.graph.is_zero(id));
    let title = format!(
        "Axis of body `{}` in its frame: position (m) at a parameter of the curve, and its derivative by that.",
        body.name
    );
    let mut kernel = time.kernel(format!("path_{}", body.identifier()), title, outputs);
    kernel.arguments[1] = "x: f64".to_string();
    if body.repeat.is_some() {
        kernel.arguments.push("index: f64".to_string());
    }
    kernel.arguments.push("path: &mut [[f64; 3]; 2]".to_string());
    Some(kernel)
}
