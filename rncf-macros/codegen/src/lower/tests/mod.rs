//! Kernels of what moves freely against complex steps, differences in time and sums written out.

mod beam;
mod conserving;
mod constraints;
mod density;
mod differences;
mod emitted;
pub mod model;
mod motions;
mod repeated;

use std::collections::HashMap;

use super::Kernel;
use crate::check;
use crate::elements::Library;
use crate::errors::Errors;
use crate::model::{Function, Model};
use crate::parse;
use crate::symbolic::{Id, Node, Scalar};

/// A model of a text without mistakes.
fn checked(text: &str) -> Model {
    let mut errors = Errors::new();
    let tree = parse::parse(text.parse().unwrap(), &mut errors).unwrap();
    let model = check::check(&tree, &Library::standard(), &mut errors);
    let mistakes: Vec<String> = errors.finish().into_iter().map(|mistake| mistake.message).collect();
    assert_eq!(mistakes, Vec::<String>::new());
    model.unwrap()
}

/// A complex number; with an imaginary part of 1e-200 first order is exact.
#[derive(Clone, Copy, Debug)]
struct Complex(f64, f64);

impl Scalar for Complex {
    fn from_f64(value: f64) -> Self {
        Self(value, 0.0)
    }
    fn real(self) -> f64 {
        self.0
    }
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
    fn subtract(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
    fn multiply(self, other: Self) -> Self {
        Self(self.0 * other.0, self.0 * other.1 + self.1 * other.0)
    }
    fn divide(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        Self(quotient, (self.1 - quotient * other.1) / other.0)
    }
    fn call(self, function: Function) -> Self {
        let value = self.0.call(function);
        let slope = match function {
            Function::Sqrt => 0.5 / value,
            Function::Sin => self.0.cos(),
            Function::Cos => -self.0.sin(),
            other => panic!("{other:?} occurs in no kernel here"),
        };
        Self(value, slope * self.1)
    }
    fn call2(self, function: Function, _: Self) -> Self {
        panic!("{function:?} occurs in no kernel here")
    }
}

/// Deterministic numbers in [-1, 1].
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

type Inputs = HashMap<String, f64>;

fn symbols(kernel: &Kernel) -> Vec<(Id, &str)> {
    let roots: Vec<Id> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let graph = &kernel.graph;
    let nodes = graph.reachable(&roots).into_iter();
    nodes
        .filter(|&id| matches!(graph.node(id), Node::Symbol(_)))
        .map(|id| (id, graph.symbol_text(id)))
        .collect()
}

/// Gives every symbol of a kernel that has no value yet a random one.
fn fill(kernel: &Kernel, inputs: &mut Inputs, random: &mut Random) {
    for (_, text) in symbols(kernel) {
        inputs.entry(text.to_string()).or_insert_with(|| random.next());
    }
}

fn input(inputs: &Inputs, text: &str) -> f64 {
    *inputs.get(text).unwrap_or_else(|| panic!("no value for {text}"))
}

/// Outputs of a kernel by place.
fn evaluate(kernel: &Kernel, inputs: &Inputs) -> HashMap<String, f64> {
    let roots: Vec<Id> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let values = symbols(kernel).into_iter().map(|(id, text)| (id, input(inputs, text)));
    let values = kernel.graph.evaluate(&roots, &values.collect());
    let places = kernel.outputs.iter().map(|(place, _)| place.clone());
    places.zip(values).collect()
}

/// Derivatives of a kernel's outputs with respect to a symbol, by place.
fn slope(kernel: &Kernel, inputs: &Inputs, with: &str) -> HashMap<String, f64> {
    let step = 1e-200;
    let roots: Vec<Id> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let value = |text: &str| Complex(input(inputs, text), if text == with { step } else { 0.0 });
    let values = symbols(kernel).into_iter().map(|(id, text)| (id, value(text)));
    let values = kernel.graph.evaluate(&roots, &values.collect());
    let places = kernel.outputs.iter().map(|(place, _)| place.clone());
    places.zip(values.iter().map(|value| value.1 / step)).collect()
}

/// `name[row * columns + column]` of a tangent against complex steps through `rows[row]` of a residual;
/// entries that are not written are zero.
#[track_caller]
fn assert_tangent(tangent: &Kernel, name: &str, residual: &Kernel, rows: &str, with: &[String], inputs: &Inputs) {
    let entries = evaluate(tangent, inputs);
    let mut largest = 0.0_f64;
    for (column, symbol) in with.iter().enumerate() {
        let exact = slope(residual, inputs, symbol);
        for (place, &value) in &exact {
            let row: usize = place[rows.len() + 1..place.len() - 1].parse().unwrap();
            let entry = format!("{name}[{}]", row * with.len() + column);
            let found = entries.get(&entry).copied().unwrap_or(0.0);
            assert!(
                (found - value).abs() <= 1e-12 * (1.0 + value.abs()),
                "{entry}, d{place}/d{symbol}: {found} instead of {value}"
            );
            largest = largest.max(value.abs());
        }
    }
    assert!(largest > 0.0, "{name}: the reference is zero");
}
