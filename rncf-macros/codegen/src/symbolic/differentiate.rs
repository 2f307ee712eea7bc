//! Derivatives and substitution.

use std::collections::HashMap;
use std::ops::Index;

use super::graph::{Column, Graph, Id, Node};
use crate::model::Function;

/// What became of the nodes that a graph had at the start; a table, since a walk asks for each of them many times.
struct Done(Vec<Id>);

impl Done {
    fn new(graph: &Graph) -> Self {
        Self(vec![Id(0); graph.len()])
    }

    fn insert(&mut self, id: Id, new: Id) {
        self.0[id.0 as usize] = new;
    }
}

impl Index<&Id> for Done {
    type Output = Id;
    fn index(&self, id: &Id) -> &Id {
        &self.0[id.0 as usize]
    }
}

impl Graph {
    /// `sum_s d(of)/ds * rates[s]`: with `rates = {x: 1}` the partial derivative with respect to x,
    /// with `rates = {t: 1, q: v, v: a}` the total time derivative.
    ///
    /// `abs`, `min` and `max` are differentiated branch by branch; `if` likewise, as a motion is
    /// smooth between its kinks.
    pub fn differentiate(&mut self, of: Id, rates: &HashMap<Id, Id>) -> Id {
        let mut done = Done::new(self);
        for id in self.reachable(&[of]) {
            let derivative = self.node_derivative(id, rates, &done);
            done.insert(id, derivative);
        }
        done[&of]
    }

    /// Partial derivative with respect to a symbol.
    pub fn partial(&mut self, of: Id, with: Id) -> Id {
        let one = self.one();
        self.differentiate(of, &HashMap::from([(with, one)]))
    }

    /// Whether a node does not change at all along rates: its derivative is zero, and so is that of all that functions, conditions and tables in it
    /// are of, which might jump.
    pub fn is_still(&mut self, of: Id, rates: &HashMap<Id, Id>) -> bool {
        let mut done = Done::new(self);
        for id in self.reachable(&[of]) {
            let stays = match self.node(id) {
                Node::Call(_, a) | Node::Lookup(_, a) => self.is_zero(done[&a]),
                Node::Call2(_, a, b) => self.is_zero(done[&a]) && self.is_zero(done[&b]),
                Node::Select(_, [left, right, ..]) => done[&left] == done[&right],
                _ => true,
            };
            if !stays {
                return false;
            }
            let derivative = self.node_derivative(id, rates, &done);
            done.insert(id, derivative);
        }
        self.is_zero(done[&of])
    }

    fn node_derivative(&mut self, id: Id, rates: &HashMap<Id, Id>, done: &Done) -> Id {
        match self.node(id) {
            // Most nodes do not depend on one symbol.
            Node::Add(a, b) | Node::Subtract(a, b) | Node::Multiply(a, b) | Node::Divide(a, b)
                if self.is_zero(done[&a]) && self.is_zero(done[&b]) =>
            {
                done[&a]
            }
            Node::Number(_) => self.zero(),
            Node::Symbol(_) => match rates.get(&id) {
                Some(&rate) => rate,
                None => self.zero(),
            },
            Node::Add(a, b) => self.add(done[&a], done[&b]),
            Node::Subtract(a, b) => self.subtract(done[&a], done[&b]),
            Node::Negate(a) => self.negate(done[&a]),
            Node::Multiply(a, b) => {
                let left = self.multiply(done[&a], b);
                let right = self.multiply(a, done[&b]);
                self.add(left, right)
            }
            Node::Divide(a, b) => {
                // (a/b)' = (a' - (a/b) b') / b
                let product = self.multiply(id, done[&b]);
                let numerator = self.subtract(done[&a], product);
                self.divide(numerator, b)
            }
            Node::Power(a, n) => {
                let factor = self.number(f64::from(n));
                let power = self.power(a, n as i32 - 1);
                let outer = self.multiply(factor, power);
                self.multiply(outer, done[&a])
            }
            Node::Call(function, a) => {
                if self.is_zero(done[&a]) {
                    return self.zero();
                }
                let outer = self.function_derivative(function, a, id);
                self.multiply(outer, done[&a])
            }
            Node::Call2(function, a, b) => self.function2_derivative(function, (a, done[&a]), (b, done[&b])),
            Node::Select(comparison, [left, right, then, otherwise]) => {
                self.select(comparison, left, right, done[&then], done[&otherwise])
            }
            Node::Lookup(column, a) => {
                let is_line = self.table(column).between == crate::model::Between::Line;
                let last = if is_line { 1 } else { 3 };
                if self.is_zero(done[&a]) || column.order == last {
                    return self.zero();
                }
                let order = column.order + 1;
                let slope = self.intern(Node::Lookup(Column { order, ..column }, a));
                self.multiply(slope, done[&a])
            }
        }
    }

    /// Derivative of `value = function(a)` with respect to a.
    fn function_derivative(&mut self, function: Function, a: Id, value: Id) -> Id {
        let one = self.one();
        match function {
            Function::Sin => self.call(Function::Cos, a),
            Function::Cos => {
                let sine = self.call(Function::Sin, a);
                self.negate(sine)
            }
            Function::Tan => {
                let square = self.power(value, 2);
                self.add(one, square)
            }
            Function::Asin | Function::Acos => {
                let square = self.power(a, 2);
                let difference = self.subtract(one, square);
                let root = self.call(Function::Sqrt, difference);
                let derivative = self.divide(one, root);
                if function == Function::Asin {
                    derivative
                } else {
                    self.negate(derivative)
                }
            }
            Function::Atan => {
                let square = self.power(a, 2);
                let sum = self.add(one, square);
                self.divide(one, sum)
            }
            Function::Sinh => self.call(Function::Cosh, a),
            Function::Cosh => self.call(Function::Sinh, a),
            Function::Tanh => {
                let square = self.power(value, 2);
                self.subtract(one, square)
            }
            Function::Exp => value,
            Function::Ln => {
                let slope = self.divide(one, a);
                self.unless_zero(self.guards.of_root(a), a, slope)
            }
            Function::Sqrt => {
                let two = self.number(2.0);
                let double = self.multiply(two, value);
                let slope = self.divide(one, double);
                self.unless_zero(self.guards.of_root(value), value, slope)
            }
            Function::Abs => {
                let zero = self.zero();
                let minus = self.number(-1.0);
                self.select(crate::model::Comparison::Less, a, zero, minus, one)
            }
            Function::Min | Function::Max | Function::Atan2 | Function::Remainder => {
                unreachable!("{function:?} has two arguments")
            }
        }
    }

    /// A derivative that has no value where something that is never negative is zero: zero there, where that is guarded.
    fn unless_zero(&mut self, is_guarded: bool, value: Id, derivative: Id) -> Id {
        if !is_guarded || self.is_zero(derivative) {
            return derivative;
        }
        let zero = self.zero();
        self.select(crate::model::Comparison::Greater, value, zero, derivative, zero)
    }

    fn function2_derivative(&mut self, function: Function, (a, da): (Id, Id), (b, db): (Id, Id)) -> Id {
        use crate::model::Comparison::{Greater, Less};
        match function {
            Function::Min => self.select(Less, a, b, da, db),
            Function::Max => self.select(Greater, a, b, da, db),
            Function::Atan2 => {
                let (aa, bb) = (self.power(a, 2), self.power(b, 2));
                let norm = self.add(aa, bb);
                let (left, right) = (self.multiply(b, da), self.multiply(a, db));
                let numerator = self.subtract(left, right);
                let slope = self.divide(numerator, norm);
                self.unless_zero(self.guards.of_angle(), norm, slope)
            }
            // Nothing that is differentiated depends on the index of a repetition.
            Function::Remainder => da,
            _ => unreachable!("{function:?} has one argument"),
        }
    }

    /// The expression with nodes replaced.
    pub fn substitute(&mut self, of: Id, replacements: &HashMap<Id, Id>) -> Id {
        let mut done = Done::new(self);
        for id in self.reachable(&[of]) {
            let new = match replacements.get(&id) {
                Some(&replacement) => replacement,
                None => self.rebuild(id, &done),
            };
            done.insert(id, new);
        }
        done[&of]
    }

    fn rebuild(&mut self, id: Id, done: &Done) -> Id {
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => id,
            Node::Add(a, b) => self.add(done[&a], done[&b]),
            Node::Subtract(a, b) => self.subtract(done[&a], done[&b]),
            Node::Multiply(a, b) => self.multiply(done[&a], done[&b]),
            Node::Divide(a, b) => self.divide(done[&a], done[&b]),
            Node::Negate(a) => self.negate(done[&a]),
            Node::Power(a, n) => self.power(done[&a], n as i32),
            Node::Call(function, a) => self.call(function, done[&a]),
            Node::Lookup(column, a) => self.intern(Node::Lookup(column, done[&a])),
            Node::Call2(function, a, b) => self.call2(function, done[&a], done[&b]),
            Node::Select(comparison, [a, b, c, d]) => self.select(comparison, done[&a], done[&b], done[&c], done[&d]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Comparison;

    /// Every derivative rule against a central difference of the graph's own evaluation.
    #[test]
    fn derivatives_match_differences() {
        let mut g = Graph::new();
        let (x, y) = (g.symbol("x"), g.symbol("y"));
        let half = g.number(0.5);
        let mut values = Vec::new();
        for function in [
            Function::Sin,
            Function::Cos,
            Function::Tan,
            Function::Asin,
            Function::Acos,
            Function::Atan,
            Function::Sinh,
            Function::Cosh,
            Function::Tanh,
            Function::Exp,
            Function::Ln,
            Function::Sqrt,
            Function::Abs,
        ] {
            let product = g.multiply(x, y);
            values.push(g.call(function, product));
        }
        let quotient = g.divide(x, y);
        values.push(g.call2(Function::Atan2, quotient, y));
        values.push(g.call2(Function::Min, quotient, y));
        values.push(g.power(quotient, -3));
        values.push(g.general_power(x, y));
        values.push(g.select(Comparison::Less, x, half, quotient, y));
        for value in values {
            let derivative = g.partial(value, x);
            let at = |x0: f64, id: Id, g: &Graph| g.evaluate(&[id], &HashMap::from([(x, x0), (y, 0.7)]))[0];
            let step = 1e-6;
            let difference = (at(0.4 + step, value, &g) - at(0.4 - step, value, &g)) / (2.0 * step);
            let exact = at(0.4, derivative, &g);
            assert!(
                (exact - difference).abs() < 1e-8 * (1.0 + exact.abs()),
                "{:?}: {exact} {difference}",
                g.node(value)
            );
        }
    }
}
