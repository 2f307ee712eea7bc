//! Where a law reads an angle by its sine and cosine: the angle is known up to whole turns, and jumps from pi to -pi.
//! A law that is not periodic jumps with it; the runtime looks whether a step passes such a place.

use super::kernel::Kernel;
use super::markers::Marked;
use crate::model::{Expr, Function};
use crate::symbolic::Id;

/// Numbers that are written for each angle: sine, cosine, jump and size of the law.
const NUMBERS: usize = 4;

/// What such a function writes.
pub const TITLE: &str =
    "writes, for each angle in it, sine and cosine, by how much it jumps half a turn away, and its size.";

/// Number of angles that a kernel writes about.
pub fn count(kernel: Option<&Kernel>) -> usize {
    kernel.map_or(0, |kernel| kernel.outputs.len() / NUMBERS)
}

/// The angles in the components of a law, as they stand there, each once.
fn angles(components: &[Expr]) -> Vec<Expr> {
    let mut found = Vec::new();
    components.iter().for_each(|component| collect(component, &mut found));
    found
}

fn collect(expr: &Expr, found: &mut Vec<Expr>) {
    let is_angle = matches!(expr, Expr::Call(Function::Atan2, _)) && crate::model::fold::has_state(expr);
    if is_angle && !found.contains(expr) {
        found.push(expr.clone());
    }
    expr.parts().into_iter().for_each(|part| collect(part, found));
}

/// For each angle: its sine and cosine (times what they have in common), by how much the law jumps half a turn away, and its size there.
pub fn outputs(marked: &mut Marked, components: &[Expr]) -> Vec<(String, Id)> {
    let mut outputs = Vec::new();
    for (number, angle) in angles(components).iter().enumerate() {
        let Expr::Call(_, arguments) = angle else { continue };
        let [sine, cosine] = [0, 1].map(|which| marked.time.expression(&arguments[which]));
        let pi = std::f64::consts::PI;
        let [behind, before, left, right] = [pi, -pi, pi / 2.0, -pi / 2.0].map(|value| {
            let law = components.iter().map(|component| with(component, angle, value));
            law.map(|component| marked.time.expression(&component))
                .collect::<Vec<Id>>()
        });
        let graph = &mut marked.time.graph;
        let differences: Vec<Id> = behind
            .iter()
            .zip(&before)
            .map(|(&a, &b)| graph.subtract(a, b))
            .collect();
        let mut magnitudes = |values: &[Id]| {
            let values: Vec<Id> = values.iter().map(|&value| graph.call(Function::Abs, value)).collect();
            graph.sum(&values)
        };
        let jump = magnitudes(&differences);
        let size = magnitudes(&[behind, before, left, right].concat());
        for (place, id) in [sine, cosine, jump, size].into_iter().enumerate() {
            outputs.push((format!("out[{}]", NUMBERS * number + place), id));
        }
    }
    outputs
}

/// An expression with a number instead of an angle.
fn with(expr: &Expr, angle: &Expr, value: f64) -> Expr {
    if expr == angle {
        return Expr::Number(value);
    }
    let rebuilt = expr.with_parts(&mut |part| Some(with(part, angle, value)));
    rebuilt.unwrap_or_else(|| expr.clone())
}
