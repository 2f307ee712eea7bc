//! From matrices to modes: natural ones of the body as it is held, or all motions of its interfaces and normal modes between
//! them (Craig and Bampton); or those that the file brings.

use super::body::{Imported, Interface};
use super::craig_bampton::craig_bampton;
use super::files::{FULL_NODE, Matrices, Sparse};
use super::freedoms::{Columns, Freedoms, loose, massless, rigid_motion, rigid_motions};
use super::inertia::Inertia;
use super::lacking::lacking;
use super::lowest::{lowest, orthonormal};
use crate::linalg::Cholesky;
use crate::space::{Vector, three};

/// Part of what a stiffness does to a rigid motion that may be left of it, as files of single precision have.
const RIGID: f64 = 1e-6;
/// Part of a displacement that ready-made modes may have where a joint holds.
const HELD: f64 = 1e-7;
/// Words for the rigid motions.
const MOTIONS: [&str; FULL_NODE] = [
    "translation along x",
    "translation along y",
    "translation along z",
    "rotation about x",
    "rotation about y",
    "rotation about z",
];

/// What is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// No deformation.
    Rigid,
    /// So many modes: the lowest natural ones, or normal ones beside all motions of the interfaces.
    Modes(usize),
}

/// A body by its modes, which have unit modal mass: coordinates in sqrt(kg) m.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// rad/s, ascending.
    pub frequencies: Vec<f64>,
    /// Of every mode the displacement and the rotation of each interface.
    pub interfaces: Vec<Vec<[Vector; 2]>>,
    /// Of every mode the rates of the axes e_x, e_y, e_z of each interface.
    pub axes: Vec<Vec<[Vector; 3]>>,
    /// Coordinates that displace some node by the body's extent, or turn one by 1.
    pub sizes: Vec<f64>,
    /// Damping matrix, rows first; none where nothing damps.
    pub damping: Option<Vec<f64>>,
    pub inertia: Inertia,
    /// What displacements and rotations of all interfaces by forces (N) and moments (N m) at them lack, m and rad, rows first; `None` where nothing does,
    /// or it is not known.
    pub lacking: Option<Vec<f64>>,
    /// What is to be told.
    pub notes: Vec<String>,
}

/// Modes of unit modal mass.
struct Found {
    frequencies: Vec<f64>,
    /// Of all degrees of freedom.
    shapes: Columns,
    /// Of each mode: displacement and rotation of every interface.
    interfaces: Vec<Vec<[Vector; 2]>>,
    /// What combines ready-made modes to these.
    combined: Columns,
    /// See [`Reduced::lacking`].
    lacking: Option<Vec<f64>>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Imported {
    /// Finds the modes. `held`: of every interface the displacements along and rotations about x, y, z that joints to the
    /// body's own frame hold.
    ///
    /// # Errors
    /// What is wrong with the body, by its name.
    pub fn reduced(&self, wanted: Wanted, held: &[[bool; FULL_NODE]]) -> Result<Reduced, String> {
        let name = self.name;
        let wrong = |what: String| format!("body `{name}`: {what}");
        let found = match (&self.elements.matrices, &self.elements.modes) {
            (Matrices::Full { mass, stiffness }, modes) => {
                self.check_rigid(stiffness).map_err(wrong)?;
                match (wanted, modes) {
                    (Wanted::Rigid, _) => Found::none(),
                    (Wanted::Modes(count), None) => self.of_matrices(mass, stiffness, held, count).map_err(wrong)?,
                    (Wanted::Modes(count), Some(modes)) => {
                        let columns = columns(&modes.values, modes.count);
                        let gram = |matrix: &Sparse| -> Vec<f64> {
                            let images: Columns = columns.iter().map(|column| matrix.times(column)).collect();
                            let pairs = (0..modes.count.pow(2)).map(|at| (at / modes.count, at % modes.count));
                            pairs.map(|(i, j)| dot(&columns[i], &images[j])).collect()
                        };
                        let (m, k) = (gram(mass), gram(stiffness));
                        self.of_modes(&columns, &m, &k, held, count).map_err(wrong)?
                    }
                }
            }
            (Matrices::Modal { mass, stiffness, .. }, Some(modes)) => match wanted {
                Wanted::Rigid => Found::none(),
                Wanted::Modes(count) => {
                    let columns = columns(&modes.values, modes.count);
                    self.of_modes(&columns, mass, stiffness, held, count).map_err(wrong)?
                }
            },
            (Matrices::Modal { .. }, None) => return Err(wrong("its file has no modes".into())),
        };
        let mut notes = Vec::new();
        let inertia = match &self.elements.matrices {
            Matrices::Full { mass, .. } => {
                let (inertia, is_lumped) = Inertia::of_mass(self, mass, &found.shapes).map_err(wrong)?;
                if is_lumped && !found.shapes.is_empty() {
                    notes.push(format!(
                        "body `{name}`: its mass matrix couples directions or rotations, as those of beams and shells do, so that the products of modes in its inertia (centrifugal and Coriolis terms of the deformed body) are summed with masses lumped at its {} nodes",
                        self.elements.nodes.len()
                    ));
                }
                inertia
            }
            Matrices::Modal { inertia, .. } => {
                let lumped = matches!(inertia, super::files::Inertia::Lumped(_));
                if lumped && !found.shapes.is_empty() {
                    notes.push(format!(
                        "body `{name}`: its inertia is summed with masses lumped at its {} nodes, as its file has them",
                        self.elements.nodes.len()
                    ));
                }
                Inertia::of_modes(self, inertia, &found.shapes, &found.combined).map_err(wrong)?
            }
        };
        let axes = self.axes_of(&found);
        Ok(Reduced {
            sizes: self.sizes(&found.shapes),
            damping: self.damping_of(&found),
            axes,
            interfaces: found.interfaces,
            frequencies: found.frequencies,
            lacking: found.lacking,
            inertia,
            notes,
        })
    }

    /// Shapes of the natural modes of the free body.
    #[cfg(test)]
    pub(super) fn shapes_of(&self, count: usize) -> Columns {
        let Matrices::Full { mass, stiffness } = &self.elements.matrices else {
            return Vec::new();
        };
        let held = vec![[false; FULL_NODE]; self.interfaces.len()];
        self.of_matrices(mass, stiffness, &held, count)
            .map_or(Vec::new(), |found| found.shapes)
    }

    /// Refuses a stiffness that resists rigid motions.
    fn check_rigid(&self, stiffness: &Sparse) -> Result<(), String> {
        let nodes = &self.elements.nodes;
        let middle = (1.0 / nodes.len() as f64) * nodes.iter().map(|&node| Vector::from(node)).sum::<Vector>();
        for ([shift, turn], word) in rigid_motions().into_iter().zip(MOTIONS) {
            let motion = rigid_motion(self, [shift - turn.cross(&middle), turn]);
            let per_node = self.elements.per_node;
            for kind in 0..per_node.div_ceil(3) {
                let rows = || {
                    stiffness
                        .rows
                        .iter()
                        .enumerate()
                        .filter(|(row, _)| row % per_node / 3 == kind)
                };
                let terms = |entries: &Vec<(usize, f64)>| -> [f64; 2] {
                    entries.iter().fold([0.0; 2], |[sum, size], &(column, value)| {
                        let term = value * motion[column];
                        [sum + term, size + term.abs()]
                    })
                };
                let [left, whole] = rows().fold([0.0_f64; 2], |most, (_, entries)| {
                    let [sum, size] = terms(entries);
                    [most[0].max(sum.abs()), most[1].max(size)]
                });
                if left > RIGID * whole {
                    return Err(format!(
                        "its stiffness `K` resists the rigid {word} (by {:.1e} of its entries): write the matrices of the body without supports, and hold it in its frame by a joint",
                        left / whole
                    ));
                }
            }
        }
        Ok(())
    }

    fn of_matrices(
        &self,
        mass: &Sparse,
        stiffness: &Sparse,
        held: &[[bool; FULL_NODE]],
        count: usize,
    ) -> Result<Found, String> {
        let freedoms = Freedoms::new(self, held, stiffness, mass);
        let (m, k) = (freedoms.reduced(mass), freedoms.reduced(stiffness));
        let is_free = !held.iter().flatten().any(|held| *held);
        let rigid = match is_free {
            true => {
                let motions = rigid_motions().map(|motion| freedoms.rigid(self, motion));
                orthonormal(&m, motions.to_vec()).ok_or_else(massless)?
            }
            false => Vec::new(),
        };
        let lowest = match self.keeps_interfaces {
            true => craig_bampton(&freedoms, &k, &m, &rigid, count)?,
            false => {
                let available = freedoms.count.saturating_sub(rigid.len());
                if count > available {
                    return Err(format!(
                        "is to have {count} modes but has only {available} freedoms: ask for fewer modes"
                    ));
                }
                lowest(&k, &m, &rigid, count).ok_or_else(|| loose(is_free))?
            }
        };
        let wanted = if self.keeps_interfaces {
            lowest.vectors.len()
        } else {
            count
        };
        if lowest.vectors.len() < wanted {
            return Err(format!(
                "has only {} modes with mass: ask for fewer modes",
                lowest.vectors.len()
            ));
        }
        let lacking = match self.keeps_interfaces {
            true => None,
            false => lacking(&freedoms, [&k, &m], &rigid, &lowest),
        };
        let interfaces = lowest.vectors.iter().map(|y| {
            let own = freedoms.interfaces.iter();
            let value = |unknown: Option<usize>| unknown.map_or(0.0, |unknown| y[unknown]);
            own.map(|own| [0, 3].map(|first| Vector::from_fn(|axis, _| value(own[first + axis]))))
                .collect()
        });
        Ok(Found {
            interfaces: interfaces.collect(),
            shapes: lowest.vectors.iter().map(|y| freedoms.expanded(y)).collect(),
            frequencies: lowest.frequencies,
            combined: Vec::new(),
            lacking,
        })
    }

    /// Natural modes among ready-made ones.
    fn of_modes(
        &self,
        columns: &Columns,
        mass: &[f64],
        stiffness: &[f64],
        held: &[[bool; FULL_NODE]],
        count: usize,
    ) -> Result<Found, String> {
        let k = columns.len();
        let interfaces: Vec<Vec<[Vector; 2]>> = columns.iter().map(|column| self.interface_motions(column)).collect();
        let is_free = !held.iter().flatten().any(|held| *held);
        for (mode, motions) in interfaces.iter().enumerate() {
            let per_node = self.elements.per_node;
            let most = |kind: usize| {
                let rows = columns[mode]
                    .iter()
                    .enumerate()
                    .filter(|(row, _)| row % per_node / 3 == kind);
                rows.map(|(_, value)| value.abs()).fold(0.0, f64::max)
            };
            let sizes = [most(0), most(1).max(most(0) / self.extent())];
            for ((motion, held), interface) in motions.iter().zip(held).zip(&self.interfaces) {
                for component in 0..FULL_NODE {
                    if held[component] && motion[component / 3][component % 3].abs() > HELD * sizes[component / 3] {
                        return Err(format!(
                            "mode {} of its file moves the interface `{}`, which a joint holds in the body's frame: write modes with it held, or tie it by a joint to another body",
                            mode + 1,
                            interface.name
                        ));
                    }
                }
            }
        }
        let rigid = if is_free {
            self.rigid_among(columns)?
        } else {
            Vec::new()
        };
        let (k_matrix, m_matrix) = (Sparse::dense(k, stiffness), Sparse::dense(k, mass));
        let rigid = orthonormal(&m_matrix, rigid).ok_or_else(massless)?;
        let available = k - rigid.len();
        // The interfaces move as the file's modes do.
        let count = if self.keeps_interfaces { available } else { count };
        if count > available {
            return Err(format!(
                "is to have {count} modes, and its file has {available} that deform it: ask for fewer modes"
            ));
        }
        let lowest = lowest(&k_matrix, &m_matrix, &rigid, count).ok_or_else(|| loose(is_free))?;
        if lowest.vectors.len() < count {
            return Err(format!(
                "has only {} modes with mass: ask for fewer modes",
                lowest.vectors.len()
            ));
        }
        let sum = |combination: &Vec<f64>| -> Vec<f64> {
            let row = |row: usize| {
                combination
                    .iter()
                    .zip(columns)
                    .map(|(factor, column)| factor * column[row])
                    .sum()
            };
            (0..self.elements.size()).map(row).collect()
        };
        let shapes: Columns = lowest.vectors.iter().map(sum).collect();
        Ok(Found {
            interfaces: shapes.iter().map(|shape| self.interface_motions(shape)).collect(),
            frequencies: lowest.frequencies,
            shapes,
            combined: lowest.vectors,
            lacking: None,
        })
    }

    /// The combinations of ready-made modes that are rigid motions: all of them, or none.
    fn rigid_among(&self, columns: &Columns) -> Result<Columns, String> {
        let k = columns.len();
        let sizes: Vec<f64> = columns.iter().map(|column| dot(column, column).sqrt()).collect();
        let gram: Vec<f64> = (0..k * k)
            .map(|at| dot(&columns[at / k], &columns[at % k]) / (sizes[at / k] * sizes[at % k]))
            .collect();
        let factor = Cholesky::new(k, &gram)
            .map_err(|_| "the modes of its file depend on each other, or one of them moves nothing".to_string())?;
        let mut found = Vec::new();
        for motion in rigid_motions() {
            let motion = rigid_motion(self, motion);
            let mut x: Vec<f64> = columns
                .iter()
                .zip(&sizes)
                .map(|(column, size)| dot(column, &motion) / size)
                .collect();
            factor.solve(&mut x);
            x.iter_mut().zip(&sizes).for_each(|(x, size)| *x /= size);
            let rest = motion.iter().enumerate().map(|(row, value)| {
                let sum: f64 = x.iter().zip(columns).map(|(factor, column)| factor * column[row]).sum();
                (value - sum).powi(2)
            });
            if rest.sum::<f64>().sqrt() <= RIGID * dot(&motion, &motion).sqrt() {
                found.push(x);
            }
        }
        match found.len() {
            0 | FULL_NODE => Ok(found),
            some => Err(format!(
                "the modes of its file hold {some} of the 6 rigid motions: write all of them or none"
            )),
        }
    }

    /// Displacement and rotation of every interface; of several nodes in the mean.
    fn interface_motions(&self, column: &[f64]) -> Vec<[Vector; 2]> {
        let per_node = self.elements.per_node;
        let vector = |node: usize, first: usize| -> Vector {
            Vector::from_fn(|axis, _| {
                let component = first + axis;
                if component < per_node {
                    column[node * per_node + component]
                } else {
                    0.0
                }
            })
        };
        let motion = |interface: &Interface| -> [Vector; 2] {
            let nodes = &interface.nodes;
            let mean = |first: usize| {
                let sum = nodes
                    .iter()
                    .fold(Vector::zeros(), |sum, &node| sum + vector(node, first));
                (1.0 / nodes.len() as f64) * sum
            };
            let shift = mean(0);
            if nodes.len() == 1 {
                return [shift, mean(3)];
            }
            let (mut turning, mut moment) = (vec![0.0; 9], Vector::zeros());
            for &node in nodes {
                let arm = Vector::from(self.elements.nodes[node]) - interface.place;
                moment += arm.cross(&vector(node, 0));
                let square = arm.norm_squared();
                for i in 0..3 {
                    turning[4 * i] += square;
                    for j in 0..3 {
                        turning[3 * i + j] -= arm[i] * arm[j];
                    }
                }
            }
            if let Ok(factor) = Cholesky::new(3, &turning) {
                factor.solve(moment.as_mut_slice());
            }
            [shift, moment]
        };
        self.interfaces.iter().map(motion).collect()
    }

    /// Rates of the axes of the interfaces: those of the file, or turned by the rotations.
    fn axes_of(&self, found: &Found) -> Vec<Vec<[Vector; 3]>> {
        let Some(axes) = self.axes() else {
            let units: [Vector; 3] = [Vector::x(), Vector::y(), Vector::z()];
            let turned = |[_, turn]: &[Vector; 2]| units.map(|unit| turn.cross(&unit));
            return found
                .interfaces
                .iter()
                .map(|mode| mode.iter().map(turned).collect())
                .collect();
        };
        let modes = self.elements.modes.as_ref().map_or(0, |modes| modes.count);
        let of = |combination: &Vec<f64>, interface: &Interface| -> [Vector; 3] {
            let node = interface.nodes[0];
            let mut sum = [Vector::zeros(); 3];
            for (mode, factor) in combination.iter().enumerate() {
                for (place, value) in axes[(node * modes + mode) * 9..][..9].iter().enumerate() {
                    sum[place / 3][place % 3] += factor * value;
                }
            }
            sum
        };
        let all = |combination| {
            self.interfaces
                .iter()
                .map(|interface| of(combination, interface))
                .collect()
        };
        found.combined.iter().map(all).collect()
    }

    fn sizes(&self, shapes: &Columns) -> Vec<f64> {
        let (per_node, extent) = (self.elements.per_node, self.extent());
        let size = |shape: &Vec<f64>| {
            let vectors = shape.chunks_exact(3).enumerate();
            let each = vectors.map(|(at, vector)| {
                let is_turn = per_node == FULL_NODE && at % 2 == 1;
                three(vector, 0).norm() / if is_turn { 1.0 } else { extent }
            });
            1.0 / each.fold(f64::MIN_POSITIVE, f64::max)
        };
        shapes.iter().map(size).collect()
    }

    fn damping_of(&self, found: &Found) -> Option<Vec<f64>> {
        let k = found.frequencies.len();
        let mut sum = vec![0.0; k * k];
        if let Matrices::Modal {
            damping: Some(damping), ..
        } = &self.elements.matrices
        {
            let damping = Sparse::dense(found.combined.first().map_or(0, Vec::len), damping);
            let images: Columns = found.combined.iter().map(|column| damping.times(column)).collect();
            for (place, value) in sum.iter_mut().enumerate() {
                *value = dot(&found.combined[place / k], &images[place % k]);
            }
        }
        let [part, time] = self.damping;
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            sum[mode * (k + 1)] += frequency * (2.0 * part + time * frequency);
        }
        sum.iter().any(|value| *value != 0.0).then_some(sum)
    }
}

impl Found {
    fn none() -> Self {
        Self {
            frequencies: Vec::new(),
            shapes: Vec::new(),
            interfaces: Vec::new(),
            combined: Vec::new(),
            lacking: None,
        }
    }
}

fn columns(values: &[f64], count: usize) -> Columns {
    (0..count)
        .map(|column| values.iter().skip(column).step_by(count).copied().collect())
        .collect()
}
