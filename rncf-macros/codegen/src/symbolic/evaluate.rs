//! Evaluation of a graph in any arithmetic, for folding and as the reference of compiled kernels.

use std::collections::HashMap;

use super::graph::{Graph, Id, Node, compare};
use crate::model::Function;

/// An arithmetic that a graph can be evaluated in: f64, complex steps, double-double, ...
pub trait Scalar: Copy {
    /// The number in this arithmetic.
    fn from_f64(value: f64) -> Self;
    /// The real part, which comparisons look at.
    fn real(self) -> f64;
    /// Sum.
    fn add(self, other: Self) -> Self;
    /// Difference.
    fn subtract(self, other: Self) -> Self;
    /// Product.
    fn multiply(self, other: Self) -> Self;
    /// Quotient.
    fn divide(self, other: Self) -> Self;
    /// Function of one argument.
    fn call(self, function: Function) -> Self;
    /// Function of two arguments.
    fn call2(self, function: Function, other: Self) -> Self;
}

impl Scalar for f64 {
    fn from_f64(value: f64) -> Self {
        value
    }
    fn real(self) -> f64 {
        self
    }
    fn add(self, other: Self) -> Self {
        self + other
    }
    fn subtract(self, other: Self) -> Self {
        self - other
    }
    fn multiply(self, other: Self) -> Self {
        self * other
    }
    fn divide(self, other: Self) -> Self {
        self / other
    }
    fn call(self, function: Function) -> Self {
        function
            .of(self)
            .unwrap_or_else(|| unreachable!("{function:?} has two arguments"))
    }
    fn call2(self, function: Function, other: Self) -> Self {
        function
            .of_two(self, other)
            .unwrap_or_else(|| unreachable!("{function:?} has one argument"))
    }
}

impl Graph {
    /// Values of the roots for given values of the symbols.
    ///
    /// # Panics
    /// If a symbol has no value.
    pub fn evaluate<T: Scalar>(&self, roots: &[Id], inputs: &HashMap<Id, T>) -> Vec<T> {
        let mut values: HashMap<Id, T> = HashMap::new();
        for id in self.reachable(roots) {
            let at = |id: Id| values[&id];
            let value = match self.node(id) {
                Node::Number(bits) => T::from_f64(f64::from_bits(bits)),
                Node::Symbol(_) => match inputs.get(&id) {
                    Some(&value) => value,
                    None => panic!("no value for the symbol {}", self.symbol_text(id)),
                },
                Node::Add(a, b) => at(a).add(at(b)),
                Node::Subtract(a, b) => at(a).subtract(at(b)),
                Node::Multiply(a, b) => at(a).multiply(at(b)),
                Node::Divide(a, b) => at(a).divide(at(b)),
                Node::Negate(a) => T::from_f64(0.0).subtract(at(a)),
                Node::Power(a, n) => (1..n).fold(at(a), |product, _| product.multiply(at(a))),
                Node::Call(function, a) => at(a).call(function),
                Node::Call2(function, a, b) => at(a).call2(function, at(b)),
                Node::Select(comparison, [left, right, then, otherwise]) => {
                    let holds = compare(comparison, at(left).real(), at(right).real());
                    if holds { at(then) } else { at(otherwise) }
                }
                Node::Lookup(column, a) => {
                    let table = self.table(column);
                    let look = |order: usize| T::from_f64(table.look_up(column.column, order, at(a).real()));
                    if column.order == 0 {
                        // The column is a line or a cubic near the place: its slope there is all that small changes need.
                        let apart = at(a).subtract(T::from_f64(at(a).real()));
                        look(0).add(look(1).multiply(apart))
                    } else {
                        look(column.order)
                    }
                }
            };
            values.insert(id, value);
        }
        roots.iter().map(|root| values[root]).collect()
    }
}
