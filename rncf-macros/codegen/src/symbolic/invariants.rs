//! Inner products of the vectors of a set, and their derivatives.

use super::graph::{Graph, Id};
use super::linear::Vector;

/// Kind of an inner product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Product {
    /// `i . j`
    Dot,
    /// `i x j`, planar.
    Cross,
}

/// The inner product of two vectors of a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Invariant {
    /// Dot or cross.
    pub product: Product,
    /// First vector.
    pub i: usize,
    /// Second vector; not before the first.
    pub j: usize,
}

/// All independent invariants of `count` vectors with `dimension` components.
pub fn invariants(count: usize, dimension: usize) -> Vec<Invariant> {
    let mut list = Vec::new();
    for i in 0..count {
        list.extend((i..count).map(|j| Invariant {
            product: Product::Dot,
            i,
            j,
        }));
    }
    if dimension == 2 {
        for i in 0..count {
            list.extend((i + 1..count).map(|j| Invariant {
                product: Product::Cross,
                i,
                j,
            }));
        }
    }
    list
}

fn product(graph: &mut Graph, kind: Product, a: &[Id], b: &[Id]) -> Id {
    match kind {
        Product::Dot => graph.dot(a, b),
        Product::Cross => {
            let (left, right) = (graph.multiply(a[0], b[1]), graph.multiply(a[1], b[0]));
            graph.subtract(left, right)
        }
    }
}

impl Invariant {
    /// Name in generated code.
    pub fn name(self, vectors: &[String]) -> String {
        let word = match self.product {
            Product::Dot => "dot",
            Product::Cross => "cross",
        };
        format!("{word}_{}_{}", vectors[self.i], vectors[self.j])
    }

    /// Value for straight, unstretched vectors that are all the same unit vector.
    pub fn straight(self) -> f64 {
        match self.product {
            Product::Dot => 1.0,
            Product::Cross => 0.0,
        }
    }

    /// Value for unit vectors that are the same or, where `same` is false, turned by a right angle.
    pub fn orthonormal(self, same: bool) -> f64 {
        f64::from(u8::from(same == (self.product == Product::Dot)))
    }

    /// Value.
    pub fn value(self, graph: &mut Graph, vectors: &[Vector]) -> Id {
        product(graph, self.product, &vectors[self.i], &vectors[self.j])
    }

    /// Time derivative.
    pub fn rate(self, graph: &mut Graph, vectors: &[Vector], rates: &[Vector]) -> Id {
        let left = product(graph, self.product, &rates[self.i], &vectors[self.j]);
        let right = product(graph, self.product, &vectors[self.i], &rates[self.j]);
        graph.add(left, right)
    }

    /// Gradient with respect to vector `with`; `None` where it does not depend on it.
    pub fn gradient(self, graph: &mut Graph, with: usize, vectors: &[Vector]) -> Option<Vector> {
        let (i, j) = (self.i, self.j);
        match self.product {
            Product::Dot if i == j && with == i => {
                let two = graph.number(2.0);
                Some(graph.scale(two, &vectors[i]))
            }
            Product::Dot if with == i => Some(vectors[j].clone()),
            Product::Dot if with == j => Some(vectors[i].clone()),
            // d(i x j)/di = (j_y, -j_x),  d(i x j)/dj = (-i_y, i_x)
            Product::Cross if with == i => Some(vec![vectors[j][1], graph.negate(vectors[j][0])]),
            Product::Cross if with == j => Some(vec![graph.negate(vectors[i][1]), vectors[i][0]]),
            _ => None,
        }
    }

    /// Second derivative with respect to vectors `p` and `q` (rows p): a constant matrix.
    pub fn second(self, p: usize, q: usize, dimension: usize) -> Option<Vec<Vec<f64>>> {
        let diagonal = |factor: f64| {
            (0..dimension)
                .map(|r| (0..dimension).map(|c| if r == c { factor } else { 0.0 }).collect())
                .collect()
        };
        match self.product {
            Product::Dot if self.i == self.j && (p, q) == (self.i, self.i) => Some(diagonal(2.0)),
            Product::Dot if self.i != self.j && ((p, q) == (self.i, self.j) || (q, p) == (self.i, self.j)) => {
                Some(diagonal(1.0))
            }
            Product::Cross if (p, q) == (self.i, self.j) => Some(vec![vec![0.0, 1.0], vec![-1.0, 0.0]]),
            Product::Cross if (q, p) == (self.i, self.j) => Some(vec![vec![0.0, -1.0], vec![1.0, 0.0]]),
            _ => None,
        }
    }
}
