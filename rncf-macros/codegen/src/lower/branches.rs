//! Where a law reads an angle by its sine and cosine: the angle is known up to whole turns, and jumps from pi to -pi.
//! A law that is not periodic jumps with it; the runtime looks whether a step passes such a place. Kinks of a law, where `max`, `min` or `abs` of
//! what moves changes over or a linear table has a row, and peaks of exponentials are told in the same way; steps end there.

use super::kernel::Kernel;
use super::markers::Marked;
use crate::model::{Binary, Expr, Function, Model};
use crate::symbolic::{Graph, Id};

/// Numbers that are written for each angle: sine, cosine, jump and size of the law; for each kink what changes its sign there, 0, -1, 0; for each peak
/// (`peaks.rs`) what changes its sign there, 0, -2, 0.
const NUMBERS: usize = 4;
/// Tells the runtime that numbers are of a kink.
const KINK: f64 = -1.0;

/// What such a function writes.
pub const TITLE: &str = "writes, for each angle in it, sine and cosine, by how much it jumps half a turn away, and its size; for each kink what changes its sign, and 0, -1, 0; for each peak what is positive before it and negative behind, and 0, -2, 0.";

/// Number of angles, kinks and peaks that a kernel writes about.
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

/// Calls of what moves that have a kink, each once. `v * abs(v)`, the drag of a fluid, has none: where `abs` turns, it is multiplied by zero.
fn kinks(components: &[Expr]) -> Vec<Expr> {
    fn collect(expr: &Expr, found: &mut Vec<Expr>) {
        let mut factors = Vec::new();
        factors_of(expr, &mut factors);
        if factors.len() > 1 {
            for factor in &factors {
                match factor {
                    Expr::Call(Function::Abs, of)
                        if factors.iter().any(|other| is_same_but_for_sign(other, &of[0])) =>
                    {
                        collect(&of[0], found)
                    }
                    _ => collect(factor, found),
                }
            }
            return;
        }
        let has_kink = matches!(expr, Expr::Call(Function::Max | Function::Min | Function::Abs, _));
        if has_kink && crate::model::fold::has_state(expr) && !found.contains(expr) {
            found.push(expr.clone());
        }
        expr.parts().into_iter().for_each(|part| collect(part, found));
    }
    let mut found = Vec::new();
    components.iter().for_each(|component| collect(component, &mut found));
    found
}

/// Where what moves is looked up in a linear table, with each row at which the column changes its slope or jumps.
fn rows(model: &Model, components: &[Expr]) -> Vec<(Expr, f64)> {
    fn collect(model: &Model, expr: &Expr, found: &mut Vec<(Expr, f64)>) {
        if let Expr::Lookup { table, column, at } = expr
            && crate::model::fold::has_state(at)
        {
            for place in model.tables[table.0].kinks(*column) {
                let kink = (at.as_ref().clone(), place);
                if !found.contains(&kink) {
                    found.push(kink);
                }
            }
        }
        expr.parts().into_iter().for_each(|part| collect(model, part, found));
    }
    let mut found = Vec::new();
    components
        .iter()
        .for_each(|component| collect(model, component, &mut found));
    found
}

/// What an expression is a product of, signs left out.
fn factors_of<'e>(expr: &'e Expr, factors: &mut Vec<&'e Expr>) {
    match expr {
        Expr::Negate(inner) => factors_of(inner, factors),
        Expr::Binary(Binary::Multiply, left, right) => {
            factors_of(left, factors);
            factors_of(right, factors);
        }
        expr => factors.push(expr),
    }
}

/// Whether `expr` is `of`, but for its sign.
fn is_same_but_for_sign(expr: &Expr, of: &Expr) -> bool {
    let unsigned = |mut expr: &Expr| {
        while let Expr::Negate(inner) = expr {
            expr = inner;
        }
        expr.clone()
    };
    unsigned(expr) == unsigned(of)
}

/// For each angle: its sine and cosine (times what they have in common), by how much the law jumps half a turn away, and its size there.
/// For each kink: what changes its sign there, and three numbers that no angle has.
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
    let gaps = gaps(marked, components);
    outputs.extend(told(&mut marked.time.graph, KINK, gaps, outputs.len()));
    outputs
}

/// What changes its sign at each kink.
pub(super) fn gaps(marked: &mut Marked, components: &[Expr]) -> Vec<Id> {
    let mut gaps = Vec::new();
    for kink in kinks(components) {
        let Expr::Call(_, arguments) = &kink else { continue };
        let sides: Vec<Id> = arguments.iter().map(|side| marked.time.expression(side)).collect();
        gaps.push(match sides[..] {
            [left, right] => marked.time.graph.subtract(left, right),
            _ => sides[0],
        });
    }
    for (at, row) in rows(marked.time.model, components) {
        let (at, graph) = (marked.time.expression(&at), &mut marked.time.graph);
        let row = graph.number(row);
        gaps.push(graph.subtract(at, row));
    }
    gaps
}

/// What is written for each value that changes its sign at a kink or peak, with the number that tells which, from a place on.
pub(super) fn told(graph: &mut Graph, what: f64, values: Vec<Id>, begin: usize) -> Vec<(String, Id)> {
    let numbers = [0.0, what, 0.0].map(|number| graph.number(number));
    let each = values.into_iter().flat_map(|value| [&[value][..], &numbers].concat());
    each.enumerate()
        .map(|(place, id)| (format!("out[{}]", begin + place), id))
        .collect()
}

/// An expression with a number instead of an angle; its derivatives do not jump where the angle does.
fn with(expr: &Expr, angle: &Expr, value: f64) -> Expr {
    if expr == angle {
        return Expr::Number(value);
    }
    if matches!(expr, Expr::Slope(..) | Expr::Rate(_)) {
        return expr.clone();
    }
    let rebuilt = expr.with_parts(&mut |part| Some(with(part, angle, value)));
    rebuilt.unwrap_or_else(|| expr.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{MarkerId, Observable};

    fn speed() -> Expr {
        Expr::Observed(Observable::Marker {
            marker: MarkerId(0),
            derivative: 1,
            component: 0,
        })
    }

    fn abs(of: Expr) -> Expr {
        Expr::Call(Function::Abs, vec![of])
    }

    fn times(a: Expr, b: Expr) -> Expr {
        Expr::Binary(Binary::Multiply, Box::new(a), Box::new(b))
    }

    #[test]
    fn drag_has_no_kink_and_a_stop_has_one() {
        let drag = times(times(Expr::Number(-3.0), abs(speed())), speed());
        assert_eq!(kinks(std::slice::from_ref(&drag)), []);
        assert_eq!(kinks(&[times(speed(), abs(Expr::Negate(Box::new(speed()))))]), []);
        let stop = Expr::Call(Function::Max, vec![speed(), Expr::Number(0.0)]);
        assert_eq!(kinks(&[times(Expr::Number(2.0), stop.clone()), drag]), [stop]);
        // A kink that nothing takes away, and one inside of what is multiplied.
        assert_eq!(kinks(&[times(Expr::Number(2.0), abs(speed()))]), [abs(speed())]);
        let inner = Expr::Binary(Binary::Add, Box::new(abs(speed())), Box::new(Expr::Number(-2.0)));
        assert_eq!(kinks(&[times(abs(inner.clone()), inner)]), [abs(speed())]);
    }
}
