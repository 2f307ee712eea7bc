//! Inner products of vectors and their derivatives. Every objective energy is a function of these,
//! so that force and tangent follow from dU/dI and d2U/dI2 alone, in the plane and in space alike:
//!
//! ```text
//! f_i  = S_A dI_A/di                                                     S_A = dU/dI_A + damping
//! K_ij = S_A d2I_A/didj + dI_A/di (H_AB dI_B/dj + Y_AB dI'_B/dj)^T       H = dS/dI, Y = dS/dI'
//! C_ij = dI_A/di Y_AB (dI_B/dj)^T
//! ```

use crate::symbolic::{Graph, Id, linear::Vector};

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
    fn second(self, p: usize, q: usize, dimension: usize) -> Option<Vec<Vec<f64>>> {
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

/// Vectors, their invariants, and the stress on each: what force and tangent follow from.
#[derive(Debug)]
pub struct Response<'a> {
    /// Invariants that carry stress.
    pub invariants: &'a [Invariant],
    /// Stress S of each invariant.
    pub stress: &'a [Id],
    /// dS/dI.
    pub stiffness: &'a [Vec<Id>],
    /// dS/dI', empty without damping.
    pub viscosity: &'a [Vec<Id>],
    /// The vectors.
    pub vectors: &'a [Vector],
    /// Their rates, empty without damping.
    pub rates: &'a [Vector],
}

/// A block matrix: `blocks[i][j][r][c]`.
pub type Blocks = Vec<Vec<Vec<Vec<Id>>>>;

impl Response<'_> {
    /// Force on each vector.
    pub fn force(&self, graph: &mut Graph) -> Vec<Vector> {
        let dimension = self.vectors[0].len();
        (0..self.vectors.len())
            .map(|vector| {
                let mut force = vec![graph.zero(); dimension];
                for (invariant, &stress) in self.invariants.iter().zip(self.stress) {
                    if let Some(gradient) = invariant.gradient(graph, vector, self.vectors) {
                        let term = graph.scale(stress, &gradient);
                        force = graph.add_vectors(&force, &term);
                    }
                }
                force
            })
            .collect()
    }

    /// Stiffness and damping blocks; the latter `None` without damping.
    pub fn tangent(&self, graph: &mut Graph) -> (Blocks, Option<Blocks>) {
        let count = self.invariants.len();
        let symmetric = (0..count).all(|a| (0..a).all(|b| self.stiffness[a][b] == self.stiffness[b][a]));
        let gradients = self.gradients(graph, self.vectors);
        let along_stiffness = self.contract(graph, self.stiffness, &gradients);
        let mut stiffness = self.outer(graph, &gradients, &along_stiffness, symmetric);
        self.add_geometric(graph, &mut stiffness);
        if symmetric {
            mirror(&mut stiffness);
        }
        if self.viscosity.is_empty() {
            return (stiffness, None);
        }
        let rate_gradients = self.gradients(graph, self.rates);
        let along_rates = self.contract(graph, self.viscosity, &rate_gradients);
        let material_rates = self.outer(graph, &gradients, &along_rates, false);
        let stiffness = add_blocks(graph, &stiffness, &material_rates);
        let along_viscosity = self.contract(graph, self.viscosity, &gradients);
        (stiffness, Some(self.outer(graph, &gradients, &along_viscosity, false)))
    }

    /// The same with fewer operations where every block is wanted: one outer product for the stiffness,
    /// the upper half of the damping.
    pub fn combined_tangent(&self, graph: &mut Graph) -> (Blocks, Option<Blocks>) {
        if self.viscosity.is_empty() {
            return self.tangent(graph);
        }
        let gradients = self.gradients(graph, self.vectors);
        let rate_gradients = self.gradients(graph, self.rates);
        let mut along = self.contract(graph, self.stiffness, &gradients);
        let along_rates = self.contract(graph, self.viscosity, &rate_gradients);
        for (sum, part) in along.iter_mut().flatten().zip(along_rates.iter().flatten()) {
            *sum = graph.add_vectors(sum, part);
        }
        let mut stiffness = self.outer(graph, &gradients, &along, false);
        self.add_geometric(graph, &mut stiffness);
        let along = self.contract(graph, self.viscosity, &gradients);
        let count = self.invariants.len();
        let symmetric = (0..count).all(|a| (0..a).all(|b| self.viscosity[a][b] == self.viscosity[b][a]));
        let mut viscosity = self.outer(graph, &gradients, &along, symmetric);
        if symmetric {
            mirror(&mut viscosity);
        }
        (stiffness, Some(viscosity))
    }

    /// Derivative of the force with respect to the mean `vectors` of two states at a fixed first one, where the stress
    /// is that of the mean of the invariants: `S_A d2I_A/didj + dI_A/di (H_AB dI_B/dj)^T`, the last gradient at the
    /// second state, `ends`. Not symmetric.
    pub fn averaged_tangent(&self, graph: &mut Graph, ends: &[Vector]) -> Blocks {
        let gradients = self.gradients(graph, self.vectors);
        let at_end = self.gradients(graph, ends);
        let along = self.contract(graph, self.stiffness, &at_end);
        let mut blocks = self.outer(graph, &gradients, &along, false);
        self.add_geometric(graph, &mut blocks);
        blocks
    }

    /// `[A][j]`: gradient of invariant A with respect to vector j.
    fn gradients(&self, graph: &mut Graph, vectors: &[Vector]) -> Vec<Vec<Option<Vector>>> {
        let of = |graph: &mut Graph, invariant: &Invariant| {
            (0..vectors.len())
                .map(|j| invariant.gradient(graph, j, vectors))
                .collect()
        };
        self.invariants.iter().map(|invariant| of(graph, invariant)).collect()
    }

    /// `[A][j]`: `sum_B matrix_AB gradient_Bj`.
    fn contract(&self, graph: &mut Graph, matrix: &[Vec<Id>], gradients: &[Vec<Option<Vector>>]) -> Vec<Vec<Vector>> {
        let (dimension, count) = (self.vectors[0].len(), self.vectors.len());
        let row = |graph: &mut Graph, a: usize, j: usize| {
            let mut sum = vec![graph.zero(); dimension];
            for (b, gradient) in gradients.iter().enumerate() {
                if let Some(gradient) = &gradient[j] {
                    let term = graph.scale(matrix[a][b], gradient);
                    sum = graph.add_vectors(&sum, &term);
                }
            }
            sum
        };
        (0..gradients.len())
            .map(|a| (0..count).map(|j| row(graph, a, j)).collect())
            .collect()
    }

    /// `sum_A gradient_Ai (along_Aj)^T`; of a symmetric result only blocks and entries on and above
    /// the diagonal.
    fn outer(
        &self,
        graph: &mut Graph,
        gradients: &[Vec<Option<Vector>>],
        along: &[Vec<Vector>],
        upper: bool,
    ) -> Blocks {
        let (dimension, count) = (self.vectors[0].len(), self.vectors.len());
        let mut blocks = zero_blocks(graph, count, dimension);
        for (gradient, along) in gradients.iter().zip(along) {
            for i in 0..count {
                let Some(left) = &gradient[i] else { continue };
                for j in if upper { i } else { 0 }..count {
                    for r in 0..dimension {
                        for c in if upper && i == j { r } else { 0 }..dimension {
                            let product = graph.multiply(left[r], along[j][c]);
                            blocks[i][j][r][c] = graph.add(blocks[i][j][r][c], product);
                        }
                    }
                }
            }
        }
        blocks
    }

    fn add_geometric(&self, graph: &mut Graph, blocks: &mut Blocks) {
        let (dimension, count) = (self.vectors[0].len(), self.vectors.len());
        for (invariant, &stress) in self.invariants.iter().zip(self.stress) {
            for i in 0..count {
                for j in 0..count {
                    let Some(second) = invariant.second(i, j, dimension) else {
                        continue;
                    };
                    for r in 0..dimension {
                        for c in 0..dimension {
                            let factor = graph.number(second[r][c]);
                            let term = graph.multiply(factor, stress);
                            blocks[i][j][r][c] = graph.add(blocks[i][j][r][c], term);
                        }
                    }
                }
            }
        }
    }
}

/// Blocks of zeros.
pub fn zero_blocks(graph: &mut Graph, count: usize, dimension: usize) -> Blocks {
    vec![vec![vec![vec![graph.zero(); dimension]; dimension]; count]; count]
}

fn add_blocks(graph: &mut Graph, a: &Blocks, b: &Blocks) -> Blocks {
    let mut sum = a.clone();
    for (i, row) in sum.iter_mut().enumerate() {
        for (j, block) in row.iter_mut().enumerate() {
            for (r, line) in block.iter_mut().enumerate() {
                for (c, entry) in line.iter_mut().enumerate() {
                    *entry = graph.add(*entry, b[i][j][r][c]);
                }
            }
        }
    }
    sum
}

/// Copies the part above the diagonal below it.
pub fn mirror(blocks: &mut Blocks) {
    let (count, dimension) = (blocks.len(), blocks[0][0].len());
    for i in 0..count {
        for j in i..count {
            for r in 0..dimension {
                for c in if i == j { r + 1 } else { 0 }..dimension {
                    blocks[j][i][c][r] = blocks[i][j][r][c];
                }
            }
        }
    }
}
