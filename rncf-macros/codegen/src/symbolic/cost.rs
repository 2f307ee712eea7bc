//! Exact operation counts.

use std::fmt;
use std::ops::{Add, Mul};

use super::graph::{Graph, Id, Node};

/// Counted operations of a straight-line evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and comparisons.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Calls of functions (square roots included).
    pub functions: usize,
}

impl Cost {
    /// Additions and multiplications count one, divisions four, functions twenty: latencies of a
    /// current processor, rounded.
    pub fn weighted(self) -> usize {
        self.additions + self.multiplications + 4 * self.divisions + 20 * self.functions
    }
}

impl Add for Cost {
    type Output = Cost;
    fn add(self, other: Cost) -> Cost {
        Cost {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            functions: self.functions + other.functions,
        }
    }
}

impl Mul<usize> for Cost {
    type Output = Cost;
    fn mul(self, times: usize) -> Cost {
        Cost {
            additions: self.additions * times,
            multiplications: self.multiplications * times,
            divisions: self.divisions * times,
            functions: self.functions * times,
        }
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} additions, {} multiplications",
            self.additions, self.multiplications
        )?;
        if self.divisions > 0 {
            write!(f, ", {} divisions", self.divisions)?;
        }
        if self.functions > 0 {
            write!(f, ", {} function calls", self.functions)?;
        }
        Ok(())
    }
}

impl Graph {
    /// Cost of one node, its children not counted. Negations are free: they become signs.
    pub fn node_cost(&self, id: Id) -> Cost {
        let mut cost = Cost::default();
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) | Node::Negate(_) => {}
            Node::Add(..) | Node::Subtract(..) | Node::Select(..) => cost.additions = 1,
            Node::Multiply(..) => cost.multiplications = 1,
            Node::Power(_, n) => cost.multiplications = (n.ilog2() + n.count_ones() - 1) as usize,
            Node::Divide(..) => cost.divisions = 1,
            Node::Call(..) | Node::Call2(..) | Node::Lookup(..) => cost.functions = 1,
        }
        cost
    }

    /// Cost of the given nodes, each counted once.
    pub fn cost(&self, nodes: &[Id]) -> Cost {
        nodes.iter().fold(Cost::default(), |sum, &id| sum + self.node_cost(id))
    }
}
