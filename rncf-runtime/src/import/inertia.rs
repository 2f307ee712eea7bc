//! Invariants of inertia of an imported body (THEORY 3.2), about the origin of its frame.

use super::body::Imported;
use super::files::{self, FULL_NODE, Invariants, Sparse, TRANSLATIONS};
use super::freedoms::{rigid_motion, rigid_motions};
use crate::space::{Matrix, Vector, crossed, second_moment, three};

/// Relative difference of masses along x, y and z that a file may have.
const ALIKE: f64 = 1e-6;
/// Part of a mass that is round-off where directions are not to be coupled.
const UNCOUPLED: f64 = 1e-9;

/// The constants of k modes, in their order; sums over the mass of the undeformed body, with the displacements phi_i of modes.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// m, kg.
    pub mass: f64,
    /// m r_c, kg m.
    pub moment: Vector,
    /// J0, kg m^2.
    pub inertia: Matrix,
    /// phibar_i = d^a phi_ia
    pub phibar: Vec<Vector>,
    /// gamma_i = M^ab q0_a x phi_ib
    pub gamma: Vec<Vector>,
    /// eta_ij = M^ab phi_ia x phi_jb, k x k
    pub eta: Vec<Vector>,
    /// Gamma_i = M^ab [q0_a]^T [phi_ib]
    pub first: Vec<Matrix>,
    /// Ups_ij = M^ab [phi_ia]^T [phi_jb], k x k
    pub second: Vec<Matrix>,
    /// I_ij = M^ab phi_ia . phi_jb, k x k
    pub inner: Vec<f64>,
}

/// A mass matrix that is the same in all directions: of the nodes' translations, and of the axes that each node carries.
struct Scalars {
    /// Of the nodes.
    nodes: Sparse,
    /// Second moments of what turns with each node, kg m^2; none where nothing does.
    axes: Vec<Matrix>,
}

/// A field: vectors of the nodes, then the three axes of each.
type Field = Vec<Vector>;

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `1/2 tr(J) 1 - J`: second moments from moments of inertia.
fn second_of(inertia: &Matrix) -> Matrix {
    Matrix::from_diagonal_element(0.5 * inertia.trace()) - inertia
}

impl Scalars {
    /// `None`: directions or rotations are coupled.
    fn new(body: &Imported, mass: &Sparse) -> Option<Self> {
        let (per_node, count) = (body.elements.per_node, body.elements.nodes.len());
        let mut entries = Vec::new();
        let mut turning = vec![Matrix::zeros(); if per_node == FULL_NODE { count } else { 0 }];
        for (row, own) in mass.rows.iter().enumerate() {
            let (node, component) = (row / per_node, row % per_node);
            for &(column, value) in own {
                let (other, of) = (column / per_node, column % per_node);
                let size = (mass.at(row, row) * mass.at(column, column)).abs().sqrt();
                let is_small = value.abs() <= UNCOUPLED * size;
                match (component < TRANSLATIONS, of < TRANSLATIONS) {
                    (true, true) if component == of => {
                        let first = mass.at(node * per_node, other * per_node);
                        if (value - first).abs() > UNCOUPLED * size {
                            return None;
                        }
                        if component == 0 {
                            entries.push((node, other, value));
                        }
                    }
                    (false, false) if node == other => turning[node][(component - 3, of - 3)] += value,
                    _ if is_small => {}
                    _ => return None,
                }
            }
        }
        // What the first direction lacks, the others must lack too.
        let nodes = Sparse::new(count, entries);
        for (node, own) in nodes.rows.iter().enumerate() {
            for axis in 1..TRANSLATIONS {
                let row = node * per_node + axis;
                let there = own.iter().all(|&(other, value)| {
                    let size = (mass.at(row, row) * mass.at(other * per_node + axis, other * per_node + axis))
                        .abs()
                        .sqrt();
                    (mass.at(row, other * per_node + axis) - value).abs() <= UNCOUPLED * size
                });
                if !there {
                    return None;
                }
            }
        }
        Some(Self {
            nodes,
            axes: turning.iter().map(second_of).collect(),
        })
    }

    /// Masses at the nodes: sums of the rows, or where one is negative the diagonal, scaled to the whole mass.
    fn lumped(body: &Imported, mass: &Sparse) -> Self {
        let (per_node, count) = (body.elements.per_node, body.elements.nodes.len());
        let mut sums = vec![0.0; count];
        for [shift, turn] in rigid_motions().into_iter().take(TRANSLATIONS) {
            let momentum = mass.times(&rigid_motion(body, [shift, turn]));
            for (node, sum) in sums.iter_mut().enumerate() {
                *sum += (0..3)
                    .map(|axis| shift[axis] * momentum[node * per_node + axis])
                    .sum::<f64>()
                    / 3.0;
            }
        }
        if sums.iter().any(|sum| *sum < 0.0) {
            let whole: f64 = sums.iter().sum();
            let diagonal = |node: usize| {
                (0..3)
                    .map(|axis| mass.at(node * per_node + axis, node * per_node + axis))
                    .sum()
            };
            sums = (0..count).map(diagonal).collect();
            let all: f64 = sums.iter().sum();
            sums.iter_mut().for_each(|sum| *sum *= whole / all);
        }
        Self {
            nodes: Sparse::new(
                count,
                sums.into_iter().enumerate().map(|(node, mass)| (node, node, mass)),
            ),
            axes: Vec::new(),
        }
    }

    /// Axes of the nodes that turn, behind the vectors of the nodes.
    fn field(&self, mut nodes: Vec<Vector>, axes: impl Fn(usize, Vector) -> Vector) -> Field {
        let units = [Vector::x(), Vector::y(), Vector::z()];
        nodes.extend((0..self.axes.len()).flat_map(|node| units.map(|unit| axes(node, unit))));
        nodes
    }

    fn shape(&self, body: &Imported) -> Field {
        self.field(
            body.elements.nodes.iter().copied().map(Vector::from).collect(),
            |_, unit| unit,
        )
    }

    fn mode(&self, per_node: usize, shape: &[f64]) -> Field {
        let vector = |place: usize| three(shape, place);
        let nodes = (0..shape.len() / per_node)
            .map(|node| vector(node * per_node))
            .collect();
        self.field(nodes, |node, unit| vector(node * per_node + TRANSLATIONS).cross(&unit))
    }

    /// The field of momenta.
    fn weighted(&self, field: &Field) -> Field {
        let count = self.nodes.size();
        let sum = |row: &Vec<(usize, f64)>| {
            row.iter()
                .fold(Vector::zeros(), |sum, &(node, mass)| sum + mass * field[node])
        };
        let mut all: Field = self.nodes.rows.iter().map(sum).collect();
        for (node, second) in self.axes.iter().enumerate() {
            for row in second.row_iter() {
                let own = &field[count + 3 * node..][..3];
                all.push(
                    row.iter()
                        .zip(own)
                        .fold(Vector::zeros(), |sum, (&m, &axis)| sum + m * axis),
                );
            }
        }
        all
    }
}

/// The symmetric part of Gamma_i from the momenta of a mode: `tr(S) 1 - S`, where S_ab is half their product with the motion of all nodes
/// `r_a e_b + r_b e_a`, which turns nothing. What lies between the nodes moves as the mass matrix has it, but for slopes of that motion across a beam.
fn stretched(body: &Imported, momenta: &[f64]) -> Matrix {
    let nodes = || {
        body.elements
            .nodes
            .iter()
            .zip(momenta.chunks_exact(body.elements.per_node))
    };
    let products = Matrix::from_fn(|a, b| nodes().map(|(node, momentum)| node[a] * momentum[b]).sum());
    let symmetric = 0.5 * (products + products.transpose());
    Matrix::from_diagonal_element(symmetric.trace()) - symmetric
}

impl Inertia {
    /// From the mass matrix of all degrees of freedom, and whether products of modes, of two of them, are those of lumped masses.
    pub(super) fn of_mass(body: &Imported, mass: &Sparse, shapes: &[Vec<f64>]) -> Result<(Self, bool), String> {
        let motions: Vec<Vec<f64>> = rigid_motions().map(|motion| rigid_motion(body, motion)).to_vec();
        let momenta: Vec<Vec<f64>> = motions.iter().map(|motion| mass.times(motion)).collect();
        let whole = |i: usize, j: usize| dot(&motions[i], &momenta[j]);
        let masses = [whole(0, 0), whole(1, 1), whole(2, 2)];
        let mean = masses.iter().sum::<f64>() / 3.0;
        let is_alike = masses.iter().all(|one| (one - mean).abs() <= ALIKE * mean);
        let is_apart = [(0, 1), (0, 2), (1, 2)]
            .iter()
            .all(|&(i, j)| whole(i, j).abs() <= ALIKE * mean);
        if !(mean > 0.0 && is_alike && is_apart) {
            return Err(format!(
                "its mass matrix `M` makes masses of {:e}, {:e} and {:e} kg along x, y and z of it, and a body has one mass: write the whole mass matrix, not one of held or condensed degrees of freedom",
                masses[0], masses[1], masses[2]
            ));
        }
        // T^T M R = -[m r_c]
        let moment = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| 0.5 * (whole(i, 3 + j) - whole(j, 3 + i)));
        let inertia = Matrix::from_fn(|i, j| 0.5 * (whole(3 + i, 3 + j) + whole(3 + j, 3 + i)));
        if let Some(axis) = (0..3).find(|&axis| inertia[(axis, axis)] < 0.0) {
            return Err(format!(
                "its mass matrix `M` makes a moment of inertia of {:e} kg m^2 about {} of it, and no body has that",
                inertia[(axis, axis)],
                ["x", "y", "z"][axis]
            ));
        }
        let on = |first: usize| {
            let of = |shape: &Vec<f64>| -> Vector { Vector::from_fn(|i, _| dot(&momenta[first + i], shape)) };
            shapes.iter().map(of).collect::<Vec<Vector>>()
        };
        let images: Vec<Vec<f64>> = shapes.iter().map(|shape| mass.times(shape)).collect();
        let pairs = (0..shapes.len().pow(2)).map(|at| (at / shapes.len(), at % shapes.len()));
        let exact = Scalars::new(body, mass);
        let is_lumped = exact.is_none();
        let scalars = exact.unwrap_or_else(|| Scalars::lumped(body, mass));
        let mut own = Self::of_scalars(body, &scalars, shapes);
        own.inner = pairs.map(|(i, j)| dot(&shapes[i], &images[j])).collect();
        (own.mass, own.moment, own.inertia, own.phibar) = (mean, moment.into(), inertia, on(0));
        if is_lumped {
            for (momenta, first) in images.iter().zip(&mut own.first) {
                *first = stretched(body, momenta);
            }
        }
        // The skew part of Gamma_i is -[gamma_i]/2.
        for (gamma, first) in on(3).into_iter().zip(&mut own.first) {
            *first = 0.5 * (*first + first.transpose() - gamma.cross_matrix());
        }
        own.gamma = on(3);
        Ok((own, is_lumped))
    }

    fn of_scalars(body: &Imported, scalars: &Scalars, shapes: &[Vec<f64>]) -> Self {
        let shape = scalars.shape(body);
        let modes: Vec<Field> = shapes
            .iter()
            .map(|mode| scalars.mode(body.elements.per_node, mode))
            .collect();
        let weighted: Vec<Field> = modes.iter().map(|mode| scalars.weighted(mode)).collect();
        let momentum = scalars.weighted(&shape);
        let count = scalars.nodes.size();
        let sum = |field: &Field| field[..count].iter().fold(Vector::zeros(), |sum, &u| sum + u);
        let pairs = || (0..modes.len().pow(2)).map(|at| (at / modes.len(), at % modes.len()));
        let inner =
            |(i, j): (usize, usize)| -> f64 { modes[i].iter().zip(&weighted[j]).map(|(&u, &v)| u.dot(&v)).sum() };
        Self {
            mass: scalars.nodes.rows.iter().flatten().map(|(_, mass)| mass).sum(),
            moment: sum(&momentum),
            inertia: second_moment(&shape, &momentum),
            phibar: weighted.iter().map(sum).collect(),
            gamma: weighted.iter().map(|mode| crossed(&shape, mode)).collect(),
            eta: pairs().map(|(i, j)| crossed(&modes[i], &weighted[j])).collect(),
            first: weighted.iter().map(|mode| second_moment(&shape, mode)).collect(),
            second: pairs().map(|(i, j)| second_moment(&modes[i], &weighted[j])).collect(),
            inner: pairs().map(inner).collect(),
        }
    }

    /// Of a body that is known by its modes: `combined` makes these modes of the file's.
    pub(super) fn of_modes(
        body: &Imported,
        inertia: &files::Inertia,
        shapes: &[Vec<f64>],
        combined: &[Vec<f64>],
    ) -> Result<Self, String> {
        let k = combined.len();
        let mut own = match inertia {
            files::Inertia::Lumped(masses) => {
                let nodes = masses
                    .iter()
                    .enumerate()
                    .map(|(node, mass)| (node, node, (mass[0] + mass[1] + mass[2]) / 3.0));
                let turning = |mass: &[f64; 6]| second_of(&Matrix::from_diagonal(&three(mass, 3)));
                let axes = match body.elements.per_node {
                    FULL_NODE => masses.iter().map(turning).collect(),
                    _ => Vec::new(),
                };
                let scalars = Scalars {
                    nodes: Sparse::new(masses.len(), nodes),
                    axes,
                };
                Self::of_scalars(body, &scalars, shapes)
            }
            files::Inertia::Invariants(given) => Self::given(body, given, combined),
        };
        // The modes have unit modal mass.
        own.inner = (0..k * k).map(|at| f64::from(u8::from(at / k == at % k))).collect();
        if own.mass.is_nan() || own.mass <= 0.0 {
            return Err(format!("its mass is {:e} kg", own.mass));
        }
        Ok(own)
    }

    fn given(body: &Imported, given: &Invariants, combined: &[Vec<f64>]) -> Self {
        let modes = body.elements.modes.as_ref().map_or(0, |modes| modes.count);
        let vectors =
            |values: &[f64]| -> Vec<Vector> { values.chunks_exact(3).map(Vector::from_column_slice).collect() };
        let matrices = |values: &[f64]| -> Vec<Matrix> { values.chunks_exact(9).map(Matrix::from_row_slice).collect() };
        let of_mode = |values: &[Vector]| -> Vec<Vector> {
            let sum = |combination: &Vec<f64>| {
                let parts = combination.iter().zip(values);
                parts.fold(Vector::zeros(), |sum, (&factor, &value)| sum + factor * value)
            };
            combined.iter().map(sum).collect()
        };
        let pairs = || {
            combined.iter().flat_map(|left| {
                combined.iter().map(move |right| {
                    let all = (0..modes * modes).map(move |at| (at, left[at / modes] * right[at % modes]));
                    all.filter(|(_, factor)| *factor != 0.0)
                })
            })
        };
        let (eta, first, second) = (vectors(&given.eta), matrices(&given.first), matrices(&given.second));
        let mut whole = matrices(&given.inertia);
        Self {
            mass: given.mass,
            moment: given.moment.into(),
            inertia: whole.pop().unwrap_or_default(),
            phibar: of_mode(&vectors(&given.phibar)),
            gamma: of_mode(&vectors(&given.gamma)),
            eta: pairs()
                .map(|all| all.fold(Vector::zeros(), |sum, (at, factor)| sum + factor * eta[at]))
                .collect(),
            first: combined
                .iter()
                .map(|combination| {
                    let mut sum = Matrix::zeros();
                    combination
                        .iter()
                        .zip(&first)
                        .for_each(|(factor, one)| sum += *factor * one);
                    sum
                })
                .collect(),
            second: pairs()
                .map(|all| {
                    let mut sum = Matrix::zeros();
                    all.for_each(|(at, factor)| sum += factor * second[at]);
                    sum
                })
                .collect(),
            inner: Vec::new(),
        }
    }
}
