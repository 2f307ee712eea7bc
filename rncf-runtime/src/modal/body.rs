//! A body with modal coordinates: its modes, and the forces that they make.

use super::elsewhere::Elsewhere;
use super::expansion::Elastic;
use super::invariants::{Action, Invariants, Motion};

use super::action::{CarriedTangent, FrameAction};
use crate::emitted::Fidelity;
use crate::error::ModelError;
use crate::linalg::{Cholesky, natural_modes};
use crate::scene::bodies::described::Elements;
use crate::scene::numbering::assembly::Connectivity;
use crate::space::Vector;

/// What a modal body is made of. Components are counted within the body.
#[derive(Clone, Debug)]
pub struct Nodal {
    /// Name in the declaration.
    pub name: String,
    /// Components of a nodal vector, 2 or 3.
    pub dimension: usize,
    /// Components of every element.
    pub connectivity: Connectivity,
    /// Undeformed nodal vectors q0, m or 1.
    pub shape: Vec<f64>,
    /// M^ab of all elements, kg for positions, rows first.
    pub mass: Vec<f64>,
    /// M^ab of fixtures. They shape the modes, and act through the nodal vectors otherwise.
    pub fixtures: Vec<f64>,
    /// Nodal values of the constant 1: one for positions, zero for slopes.
    pub whole: Vec<f64>,
    /// E: the freedoms that each component depends on, each with its factor; none where a joint to the
    /// body's own frame eliminates it.
    pub map: Vec<Vec<(usize, f64)>>,
    /// Number of freedoms.
    pub freedoms: usize,
}

/// A body with modal coordinates p, scaled so that a mode has unit modal mass: p in sqrt(kg) m.
#[derive(Clone, Debug)]
pub struct ModalBody {
    pub(super) nodal: Nodal,
    pub(super) fidelity: Fidelity,
    /// phi_ia: k numbers for every component.
    pub(super) modes: Vec<f64>,
    /// M^ab phi_ib in the same order.
    pub(super) momenta: Vec<f64>,
    /// At the undeformed shape, rad/s, ascending.
    pub(super) frequencies: Vec<f64>,
    pub(super) sizes: Vec<f64>,
    pub(super) invariants: Invariants,
    /// With the fixtures.
    pub(super) loaded: Invariants,
    pub(super) elastic: Elastic,
    /// Factor of E^T K E at the undeformed shape; none for a rigid body with loose freedoms, and for a body from elsewhere.
    pub(super) stiffness: Option<Cholesky>,
    /// Of a body from elsewhere, which has no elements.
    pub(super) elsewhere: Option<Elsewhere>,
}

impl ModalBody {
    /// Finds the modes and sums the invariants.
    ///
    /// # Errors
    /// More modes than freedoms, or a motion in the body's frame without stiffness, by the body's name.
    pub fn new(nodal: Nodal, fidelity: Fidelity, elements: &dyn Elements) -> Result<Self, ModelError> {
        let count = match fidelity {
            Fidelity::Modal(count) | Fidelity::Small(count) => count,
            Fidelity::Rigid | Fidelity::Point | Fidelity::Full => 0,
        };
        let (name, freedoms) = (&nodal.name, nodal.freedoms);
        if count > freedoms {
            return Err(ModelError::new(format!(
                "body `{name}` is to have {count} modes but its mesh has {freedoms} freedoms: ask for fewer modes, or refine the mesh"
            )));
        }
        let stiffness = nodal.reduced_stiffness(elements, &nodal.shape);
        let factor = Cholesky::new(freedoms, &stiffness).ok();
        let (mut reduced, mut frequencies) = (Vec::new(), Vec::new());
        if count > 0 {
            let found = natural_modes(freedoms, &stiffness, &nodal.reduced_mass(), count).map_err(|_| {
                ModelError::new(format!(
                    "body `{name}` can move in its frame without stiffness, and modes cannot describe that: clamp it in its frame, or leave `modal` and `small` out"
                ))
            })?;
            (reduced, frequencies) = (found.vectors, found.frequencies);
        }
        let modes = nodal.expanded(&reduced);
        let momenta = nodal.momenta(&modes, count);
        let sizes = nodal.sizes(&modes, count);
        let vectors = |full: &mut dyn Iterator<Item = f64>| nodal.vectors(full);
        let shapes: Vec<Vec<Vector>> = (0..count)
            .map(|mode| vectors(&mut modes.iter().skip(mode).step_by(count).copied()))
            .collect();
        let shape = vectors(&mut nodal.shape.iter().copied());
        let of = |mass: &[f64]| Invariants::new(mass, &nodal.whole, &shape, &shapes);
        let (mut invariants, loaded) = (of(&nodal.mass), of(&nodal.loaded_mass()));
        if fidelity == Fidelity::Point {
            invariants = invariants.at_centre(nodal.extent());
        }
        let mut body = Self {
            nodal,
            fidelity,
            modes,
            momenta,
            frequencies,
            sizes,
            invariants,
            loaded,
            elastic: Elastic::Elements,
            stiffness: factor,
            elsewhere: None,
        };
        body.elastic = body.prepare_elastic(elements);
        Ok(body)
    }

    /// Number of modes k.
    pub fn modes(&self) -> usize {
        self.frequencies.len()
    }

    /// Modal coordinates that displace some point by the body's length, or turn a slope by 1.
    pub fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    /// phi_i of a component, for i = 1..k.
    pub fn mode_row(&self, component: usize) -> &[f64] {
        let k = self.modes();
        &self.modes[component * k..(component + 1) * k]
    }

    /// Nodal vectors `q0 + phi_i p_i`.
    pub fn expand(&self, p: &[f64], q: &mut [f64]) {
        self.expand_rate(p, q);
        q.iter_mut().zip(&self.nodal.shape).for_each(|(q, q0)| *q += q0);
    }

    /// Rates or accelerations of nodal vectors, `phi_i p_i'`.
    pub fn expand_rate(&self, rate: &[f64], v: &mut [f64]) {
        for (component, value) in v.iter_mut().enumerate() {
            *value = self.mode_row(component).iter().zip(rate).map(|(a, b)| a * b).sum();
        }
    }

    /// Modal coordinates nearest to nodal vectors, in the norm of the mass matrix.
    pub fn coordinates(&self, q: &[f64]) -> Vec<f64> {
        let moved: Vec<f64> = q.iter().zip(&self.nodal.shape).map(|(q, q0)| q - q0).collect();
        self.coordinate_rates(&moved)
    }

    /// Rates of modal coordinates nearest to those of nodal vectors.
    pub fn coordinate_rates(&self, v: &[f64]) -> Vec<f64> {
        let k = self.modes();
        let mut p = vec![0.0; k];
        for (component, value) in v.iter().enumerate() {
            for (sum, momentum) in p.iter_mut().zip(&self.momenta[component * k..]) {
                *sum += momentum * value;
            }
        }
        p
    }

    /// Mass matrix of the modal coordinates without fixtures, k x k; with them it is unity.
    pub fn mass(&self) -> &[f64] {
        self.invariants.inner()
    }

    /// Whether the inertia follows the deformation: not for small deformations, Eqs. (18)-(20).
    pub(super) fn moves(&self) -> bool {
        !matches!(self.fidelity, Fidelity::Small(_))
    }

    /// Adds inertia, elastic and damping forces on the modal coordinates, Eq. (17) or (20).
    pub fn force(&self, elements: &dyn Elements, frame: &FrameAction, at: [&[f64]; 3], out: &mut [f64]) {
        let action = Action::new(frame, self.nodal.dimension);
        let [p, v, a] = at;
        self.with_motion(at, |motion| self.invariants.modal_force(&action, motion, out));
        assert_eq!(a.len(), out.len());
        self.elastic_force(elements, p, v, out);
    }

    /// Adds their derivatives with respect to p and p', k x k.
    pub fn tangent(
        &self,
        elements: &dyn Elements,
        frame: &FrameAction,
        [p, v]: [&[f64]; 2],
        stiffness: &mut [f64],
        damping: &mut [f64],
    ) {
        let action = Action::new(frame, self.nodal.dimension);
        if self.moves() {
            self.invariants.modal_tangent(&action, stiffness, damping);
        } else {
            let mut constant = vec![0.0; stiffness.len()];
            self.invariants.modal_tangent(&action, &mut constant, damping);
        }
        self.elastic_tangent(elements, p, v, stiffness, damping);
    }

    /// Adds force and moment about the origin that the body's inertia needs, Eqs. (15), (16) or (18),
    /// (19); two and one components for a planar body, else three and three.
    pub fn carried(&self, frame: &FrameAction, at: [&[f64]; 3], out: &mut [f64]) {
        let action = Action::new(frame, self.nodal.dimension);
        let [force, moment] = self.with_motion(at, |motion| self.invariants.frame_force(&action, motion));
        let all = [force[0], force[1], force[2], moment[0], moment[1], moment[2]];
        for (value, &place) in out.iter_mut().zip(self.rows()) {
            *value += all[place];
        }
    }

    /// Its derivatives, with the modal coordinates as q; every entry is overwritten.
    pub fn carried_tangent(&self, frame: &FrameAction, at: [&[f64]; 3], out: &mut CarriedTangent) {
        let action = Action::new(frame, self.nodal.dimension);
        self.with_motion(at, |motion| {
            self.invariants.frame_tangent(&action, motion, self.moves(), out);
        });
        if self.nodal.dimension == 3 {
            return;
        }
        let (k, rows) = (self.modes(), self.rows());
        let chosen = |first: &[usize], before: usize| -> Vec<usize> {
            first.iter().copied().chain(before..before + k).collect()
        };
        out.mass = picked(&out.mass, 6 + k, rows, &chosen(rows, 6));
        out.damping = picked(&out.damping, 3 + k, rows, &chosen(&[2], 3));
        out.stiffness = picked(&out.stiffness, k, rows, &chosen(&[], 0));
        out.spin = out.spin.iter().skip(2).step_by(3).copied().collect();
    }

    /// Rows of force and moment that a body of its dimension has.
    pub(super) fn rows(&self) -> &'static [usize] {
        if self.nodal.dimension == 2 {
            &[0, 1, 5]
        } else {
            &[0, 1, 2, 3, 4, 5]
        }
    }

    /// Calls with what inertia sees of the motion: for small deformations no displacement.
    pub(super) fn with_motion<T>(&self, [p, v, a]: [&[f64]; 3], mut call: impl FnMut(Motion) -> T) -> T {
        if self.moves() {
            return call(Motion { p, v, a });
        }
        let undeformed = vec![0.0; p.len()];
        call(Motion { p: &undeformed, v, a })
    }
}

/// Some rows and columns of a matrix.
fn picked(matrix: &[f64], width: usize, rows: &[usize], columns: &[usize]) -> Vec<f64> {
    let row = |&row: &usize| columns.iter().map(move |column| matrix[row * width + column]);
    rows.iter().flat_map(row).collect()
}

impl Nodal {
    /// Components of all vectors as vectors of space.
    pub(super) fn vectors(&self, full: &mut dyn Iterator<Item = f64>) -> Vec<Vector> {
        let full: Vec<f64> = full.collect();
        let vector = |part: &[f64]| Vector::from_fn(|i, _| part.get(i).copied().unwrap_or(0.0));
        full.chunks_exact(self.dimension).map(vector).collect()
    }

    /// `E x` of several x, interleaved: one number of each for every component.
    pub(super) fn expanded(&self, reduced: &[Vec<f64>]) -> Vec<f64> {
        let value = |entries: &[(usize, f64)], x: &[f64]| -> f64 {
            entries.iter().map(|&(unknown, factor)| factor * x[unknown]).sum()
        };
        let all = |entries: &'_ Vec<(usize, f64)>| -> Vec<f64> { reduced.iter().map(|x| value(entries, x)).collect() };
        self.map.iter().flat_map(all).collect()
    }

    /// `E^T full`
    pub(super) fn reduced(&self, full: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.freedoms];
        for (value, entries) in full.iter().zip(&self.map) {
            for &(unknown, factor) in entries {
                x[unknown] += factor * value;
            }
        }
        x
    }

    /// The freedoms that two components depend on, each pair with the product of its factors.
    pub(super) fn pairs(&self, row: usize, column: usize) -> impl Iterator<Item = (usize, usize, f64)> + '_ {
        let columns = &self.map[column];
        let rows = self.map[row].iter();
        rows.flat_map(move |&(a, f)| columns.iter().map(move |&(b, g)| (a, b, f * g)))
    }

    /// Calls back with the components and the elastic tangent of every element.
    pub(super) fn each_stiffness(&self, elements: &dyn Elements, q: &[f64], mut each: impl FnMut(&[usize], &[f64])) {
        let size = self.connectivity.size;
        let (mut local, rest) = (vec![0.0; size], vec![0.0; size]);
        let mut matrices = [vec![0.0; size * size], vec![0.0; size * size]];
        for element in 0..self.connectivity.count() {
            let [stiffness, damping] = &mut matrices;
            self.connectivity.gather(element, q, &mut local);
            stiffness.fill(0.0);
            elements.tangent(element, &local, &rest, stiffness, damping);
            each(self.connectivity.element(element), stiffness);
        }
    }

    /// `E^T K E` at nodal vectors q.
    pub(super) fn reduced_stiffness(&self, elements: &dyn Elements, q: &[f64]) -> Vec<f64> {
        let n = self.freedoms;
        let mut sum = vec![0.0; n * n];
        self.each_stiffness(elements, q, |components, matrix| {
            for (i, &row) in components.iter().enumerate() {
                for (j, &column) in components.iter().enumerate() {
                    for (a, b, factor) in self.pairs(row, column) {
                        sum[a * n + b] += factor * matrix[i * components.len() + j];
                    }
                }
            }
        });
        sum
    }

    /// M^ab with the fixtures.
    pub(super) fn loaded_mass(&self) -> Vec<f64> {
        self.mass.iter().zip(&self.fixtures).map(|(m, f)| m + f).collect()
    }

    /// `E^T M E`
    pub(super) fn reduced_mass(&self) -> Vec<f64> {
        let mass = self.loaded_mass();
        let (n, d, count) = (self.freedoms, self.dimension, self.whole.len());
        let mut sum = vec![0.0; n * n];
        for a in 0..count {
            for b in 0..count {
                for c in 0..d {
                    for (i, j, factor) in self.pairs(a * d + c, b * d + c) {
                        sum[i * n + j] += factor * mass[a * count + b];
                    }
                }
            }
        }
        sum
    }

    /// `M^ab u_b` of k interleaved sets of nodal vectors.
    pub(super) fn momenta(&self, sets: &[f64], k: usize) -> Vec<f64> {
        let loaded = self.loaded_mass();
        let (count, width) = (self.whole.len(), self.dimension * k);
        let mut result = vec![0.0; sets.len()];
        for a in 0..count {
            for b in 0..count {
                let mass = loaded[a * count + b];
                if mass != 0.0 {
                    for place in 0..width {
                        result[a * width + place] += mass * sets[b * width + place];
                    }
                }
            }
        }
        result
    }

    pub(super) fn is_position(&self, component: usize) -> bool {
        self.whole[component / self.dimension] != 0.0
    }

    /// Diagonal of the box about the undeformed body, m.
    pub(super) fn extent(&self) -> f64 {
        let span = |axis: usize| {
            let places = (axis..self.shape.len())
                .step_by(self.dimension)
                .filter(|&component| self.is_position(component));
            let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| {
                (low.min(self.shape[c]), high.max(self.shape[c]))
            });
            high - low
        };
        (0..self.dimension).map(span).map(|x| x * x).sum::<f64>().sqrt()
    }

    /// See [`ModalBody::sizes`].
    pub(super) fn sizes(&self, modes: &[f64], k: usize) -> Vec<f64> {
        let position = |component: usize| self.is_position(component);
        let extent = self.extent();
        let most = |mode: usize| {
            let size =
                |component: usize| modes[component * k + mode].abs() / if position(component) { extent } else { 1.0 };
            (0..self.map.len()).map(size).fold(0.0, f64::max)
        };
        (0..k).map(|mode| 1.0 / most(mode)).collect()
    }
}
