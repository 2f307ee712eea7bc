//! Inner products of vectors and their derivatives. Every objective energy is a function of these,
//! so that force and tangent follow from dU/dI and d2U/dI2 alone, in the plane and in space alike:
//!
//! ```text
//! f_i  = S_A dI_A/di                                                     S_A = dU/dI_A + damping
//! K_ij = S_A d2I_A/didj + dI_A/di (H_AB dI_B/dj + Y_AB dI'_B/dj)^T       H = dS/dI, Y = dS/dI'
//! C_ij = dI_A/di Y_AB (dI_B/dj)^T
//! ```

use crate::symbolic::{Graph, Id, Invariant, linear::Vector};

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
