//! Derivatives that have no value where something is zero, in products that vanish there.

use std::collections::HashSet;

use super::graph::{Graph, Guards, Id, Node};

impl Graph {
    /// Takes derivatives of roots, logarithms and angles of what is zero as zero.
    pub fn guard_zeros(&mut self) {
        self.guards = Guards::Zeros;
    }

    /// Takes derivatives of roots and logarithms of what is zero as zero, which is right where something else in a product
    /// vanishes there, as in `norm(v) * v` and `x^(3/2)`; but not of roots that the expressions are divided by.
    pub fn guard_roots(&mut self, of: &[Id]) {
        let divisors = self.reachable(of).into_iter().filter_map(|id| match self.node(id) {
            Node::Divide(_, b) => Some(b),
            _ => None,
        });
        let mut open: Vec<Id> = divisors.collect();
        let mut all = HashSet::new();
        while let Some(id) = open.pop() {
            if all.insert(id) {
                match self.node(id) {
                    Node::Multiply(a, b) => open.extend([a, b]),
                    Node::Power(a, _) | Node::Negate(a) => open.push(a),
                    _ => {}
                }
            }
        }
        self.guards = Guards::Roots { divisors: all };
    }
}
