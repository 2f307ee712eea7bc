//! What a body in modes carries between its joints. Its equations balance in the modes alone: what they leave
//! unbalanced at the nodes is carried to the joints as a static load is, by the stiffness of all elements (mode
//! acceleration). In a body that is held at one place this is the balance of the part beyond a section; between
//! several joints it is shared as an elastic body shares it.

use super::body::{ModalBody, Nodal};
use crate::emitted::Fidelity;
use crate::linalg::Cholesky;
use crate::scene::bodies::described::{Described, Elements, Inertial};
use crate::space::Vector;

/// Most iterations in which an elastic structure in the deformed place is solved with the factors of the undeformed
/// one, and the part of the energy that may be left.
const MOST_ITERATIONS: usize = 200;
const SOLVED: f64 = 1e-28;
/// Nodal vectors of an element of a centre line: others have sections.
const CENTRE_LINE: usize = 4;
/// Rigid motions of an element below this part of their size follow from others.
const DEPENDENT: f64 = 1e-10;

/// The elements' stiffness in the undeformed shape.
struct Structure<'a> {
    nodal: &'a Nodal,
    /// Of every element, rows first.
    stiffness: Vec<Vec<f64>>,
    /// Weights of an element's components in products of its motions.
    weights: Vec<f64>,
    /// Rigid motions of every element in the deformed shape, orthonormal: they meet no stiffness, so that its forces
    /// have no moment about the deformed places, but for that of a centre line in space about its own chord. None where forces act at the undeformed ones.
    rigid: Vec<Vec<Vec<f64>>>,
}

impl<'a> Structure<'a> {
    fn new(nodal: &'a Nodal, elements: &dyn Elements, deformed: Option<&[f64]>) -> Self {
        let mut stiffness = Vec::new();
        nodal.each_stiffness(elements, &nodal.shape, |_, matrix| stiffness.push(matrix.to_vec()));
        let connectivity = &nodal.connectivity;
        let length = nodal.extent() / connectivity.count() as f64;
        let components = connectivity.element(0).iter();
        let weight = |&component: &usize| {
            if nodal.is_position(component) {
                1.0
            } else {
                length * length
            }
        };
        let mut structure = Self {
            nodal,
            stiffness,
            weights: components.map(weight).collect(),
            rigid: Vec::new(),
        };
        if let Some(q) = deformed {
            structure.rigid = (0..connectivity.count())
                .map(|element| structure.motions(element, q))
                .collect();
        }
        structure
    }

    /// Orthonormal rigid motions of an element.
    fn motions(&self, element: usize, q: &[f64]) -> Vec<Vec<f64>> {
        let (nodal, d) = (self.nodal, self.nodal.dimension);
        let components = nodal.connectivity.element(element);
        let origin: Vec<f64> = components[..d].iter().map(|&component| q[component]).collect();
        let vectors = || components.chunks_exact(d);
        let shift = |axis: usize| -> Vec<f64> {
            let of = |vector: &[usize]| if nodal.is_position(vector[0]) { 1.0 } else { 0.0 };
            let all = vectors().flat_map(|vector| (0..d).map(move |c| if c == axis { of(vector) } else { 0.0 }));
            all.collect()
        };
        let spread = |at: &[f64]| -> Vector { Vector::from_fn(|i, _| at.get(i).copied().unwrap_or(0.0)) };
        let turn = |axis: Vector| -> Vec<f64> {
            let all = vectors().flat_map(|vector| {
                let counted = nodal.is_position(vector[0]);
                let place = |c: usize| q[vector[c]] - if counted { origin[c] } else { 0.0 };
                let place: Vec<f64> = (0..d).map(place).collect();
                axis.cross(&spread(&place)).iter().copied().take(d).collect::<Vec<_>>()
            });
            all.collect()
        };
        let units: [Vector; 3] = [Vector::x(), Vector::y(), Vector::z()];
        let axes = if d == 2 {
            vec![units[2]]
        } else if vectors().count() > CENTRE_LINE {
            units.to_vec()
        } else {
            // About its own chord a centre line does not resist: a slightly bent one would lose the stiffness of its bend.
            let mut ends = vectors().filter(|vector| nodal.is_position(vector[0]));
            let end: Vec<f64> = ends
                .next_back()
                .map_or(Vec::new(), |end| end.iter().map(|&c| q[c]).collect());
            let chord = spread(&end) - spread(&origin);
            let least = (0..3).min_by(|&i, &j| chord[i].abs().total_cmp(&chord[j].abs()));
            let first = chord.cross(&units[least.unwrap_or(0)]);
            let first = 1.0 / first.norm() * first;
            let second = chord.cross(&first);
            vec![first, 1.0 / second.norm() * second]
        };
        let shifts = (0..d).map(shift);
        let turns = axes.into_iter().map(turn);
        let mut kept: Vec<Vec<f64>> = Vec::new();
        for mut motion in shifts.chain(turns) {
            let before = self.product(&motion, &motion).sqrt();
            for _ in 0..2 {
                for other in &kept {
                    let part = self.product(other, &motion);
                    motion.iter_mut().zip(other).for_each(|(x, y)| *x -= part * y);
                }
            }
            let after = self.product(&motion, &motion).sqrt();
            if after > DEPENDENT * before {
                motion.iter_mut().for_each(|x| *x /= after);
                kept.push(motion);
            }
        }
        kept
    }

    fn product(&self, a: &[f64], b: &[f64]) -> f64 {
        let parts = a.iter().zip(b).zip(&self.weights);
        parts.map(|((a, b), weight)| weight * a * b).sum()
    }

    /// Forces of an element that is displaced in this way.
    fn force(&self, element: usize, displacement: &[f64]) -> Vec<f64> {
        let components = self.nodal.connectivity.element(element);
        let mut moved: Vec<f64> = components.iter().map(|&component| displacement[component]).collect();
        let rigid = self.rigid.get(element).map_or(&[][..], |rigid| rigid);
        for motion in rigid {
            let part = self.product(motion, &moved);
            moved.iter_mut().zip(motion).for_each(|(x, y)| *x -= part * y);
        }
        let rows = self.stiffness[element].chunks_exact(moved.len());
        let mut force: Vec<f64> = rows.map(|row| dot(row, &moved)).collect();
        for motion in rigid {
            let part = dot(motion, &force);
            let sums = force.iter_mut().zip(motion).zip(&self.weights);
            sums.for_each(|((f, y), weight)| *f -= part * weight * y);
        }
        force
    }

    /// Forces of all elements on the freedoms, displaced by them.
    fn forces(&self, freedoms: &[f64]) -> Vec<f64> {
        let displacement = self.nodal.expanded(&[freedoms.to_vec()]);
        let mut sum = vec![0.0; displacement.len()];
        for element in 0..self.stiffness.len() {
            let components = self.nodal.connectivity.element(element);
            for (&component, force) in components.iter().zip(self.force(element, &displacement)) {
                sum[component] += force;
            }
        }
        self.nodal.reduced(&sum)
    }

    /// The freedoms at which the elements bear a load on them.
    fn bearing(&self, factor: &Cholesky, mut load: Vec<f64>) -> Vec<f64> {
        let solved = |load: &[f64]| {
            let mut x = load.to_vec();
            factor.solve(&mut x);
            x
        };
        let mut direction = solved(&load);
        if self.rigid.is_empty() {
            return direction;
        }
        // Conjugate gradients: beside the undeformed structure the deformed one is a small change.
        let mut x = vec![0.0; load.len()];
        let mut energy = dot(&load, &direction);
        let enough = SOLVED * energy;
        for _ in 0..MOST_ITERATIONS {
            let image = self.forces(&direction);
            let step = energy / dot(&direction, &image);
            // Also where nothing is left to bear.
            if step.is_nan() || step <= 0.0 || energy <= enough {
                break;
            }
            x.iter_mut().zip(&direction).for_each(|(x, d)| *x += step * d);
            load.iter_mut().zip(&image).for_each(|(r, f)| *r -= step * f);
            let next = solved(&load);
            let before = energy;
            energy = dot(&load, &next);
            let kept = energy / before;
            let both = direction.iter_mut().zip(&next);
            both.for_each(|(d, next)| *d = next + kept * *d);
        }
        x
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Described for ModalBody {
    fn shape(&self) -> &[f64] {
        &self.nodal.shape
    }

    fn is_linear(&self) -> bool {
        !matches!(self.fidelity, Fidelity::Modal(_))
    }

    fn is_loose(&self) -> bool {
        self.stiffness.is_none()
    }

    fn inertial(&self, spin: Vector, at: [&[f64]; 2]) -> Option<Inertial> {
        self.inertial(spin, at)
    }

    fn strain_energy(&self, q: &[f64]) -> Option<f64> {
        self.strain_of(q)
    }

    fn add_linear_forces(&self, elements: &dyn Elements, [q, v]: [&[f64]; 2], force: &mut [f64]) {
        if self.elsewhere.is_some() {
            return;
        }
        for element in 0..self.nodal.connectivity.count() {
            let components = self.nodal.connectivity.element(element);
            for (&component, value) in components.iter().zip(self.linear_force(elements, element, [q, v])) {
                force[component] += value;
            }
        }
    }

    fn linear_force(&self, elements: &dyn Elements, element: usize, [q, v]: [&[f64]; 2]) -> Vec<f64> {
        let size = self.nodal.connectivity.size;
        if self.modes() == 0 || self.elsewhere.is_some() {
            return vec![0.0; size];
        }
        let (shape, moved) = (self.gathered(element, &self.nodal.shape), self.gathered(element, q));
        let moved: Vec<f64> = moved.iter().zip(&shape).map(|(q, q0)| q - q0).collect();
        let rates = self.gathered(element, v);
        let [mut stiffness, mut damping] = [vec![0.0; size * size], vec![0.0; size * size]];
        elements.tangent(element, &shape, &vec![0.0; size], &mut stiffness, &mut damping);
        let rows = stiffness.chunks_exact(size).zip(damping.chunks_exact(size));
        rows.map(|(k, c)| dot(k, &moved) + dot(c, &rates)).collect()
    }

    fn held(&self, elements: &dyn Elements, q: &[f64], force: &mut [f64]) -> Vec<f64> {
        let connectivity = &self.nodal.connectivity;
        let mut added = vec![0.0; connectivity.components.len()];
        let Some(factor) = &self.stiffness else {
            return added;
        };
        // Forces of linear descriptions act on the undeformed body.
        let deformed = (!self.is_linear()).then_some(q);
        let structure = Structure::new(&self.nodal, elements, deformed);
        let freedoms = structure.bearing(factor, self.nodal.reduced(force));
        let displacement = self.nodal.expanded(&[freedoms]);
        for (element, added) in added.chunks_exact_mut(connectivity.size).enumerate() {
            let components = connectivity.element(element);
            for ((&component, value), added) in components
                .iter()
                .zip(structure.force(element, &displacement))
                .zip(added)
            {
                *added = -value;
                force[component] -= value;
            }
        }
        added
    }
}
