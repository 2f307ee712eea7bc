//! Whether modes hinder a deflection that the whole body would not: a point of a bending body also
//! moves along it, by the square of the slope, and modes that do not contain this motion stretch the
//! body instead. They are then far too stiff, from deflections of the section's radius of gyration on.

use std::borrow::Cow;
use std::fmt;

use super::body::ModalBody;
use crate::linalg::{Dense, Lu, Pattern};
use crate::scene::bodies::described::Elements;

/// Part of a deflection that may be missing without a report.
const MISSING: f64 = 0.05;
/// Part of the modes' sizes below which round-off decides.
pub(super) const LEAST: f64 = 1e-6;
/// Part of the work of the elastic forces that may be left when the whole body is said to be in balance.
pub(super) const RELAXED: f64 = 1e-4;
/// Most steps of Newton's method towards this balance.
const MOST_ITERATIONS: usize = 40;
/// Steps in which the whole body is displaced further, relative to the displacement, and most of them: a thousand times.
const STEP: f64 = 0.15;
const MOST_STEPS: usize = 50;

/// Modes that hinder a deflection.
#[derive(Clone, Debug, PartialEq)]
pub struct Locking {
    /// Body.
    pub body: String,
    /// Number of its modes.
    pub modes: usize,
    /// Part of the deflection that is missing.
    pub missing: f64,
}

impl fmt::Display for Locking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, modes, missing } = self;
        let percent = 100.0 * missing;
        write!(
            f,
            "body `{body}`: its deflection is too large for its {modes} modes, which stretch it where the whole body only bends, so that about {percent:.0} % of the deflection are missing: leave `modal` out to use the whole body"
        )
    }
}

/// The potential along a deflection of size 1, `linear s^2 + cubic s^4`, J.
#[derive(Clone, Copy, Debug)]
struct Spring {
    linear: f64,
    cubic: f64,
}

impl Spring {
    /// From half the work of a linear force, and the work of the whole force at size 1. Softer than linear counts as linear.
    fn new(linear: f64, work: f64) -> Self {
        Self {
            linear,
            cubic: (0.25 * (work - 2.0 * linear)).max(0.0),
        }
    }

    fn energy(self, s: f64) -> f64 {
        let square = s * s;
        square * (self.linear + self.cubic * square)
    }

    /// Where it balances a load that does the work `load` at size 1.
    fn balance(self, load: f64) -> f64 {
        let force = |s: f64| s * (2.0 * self.linear + 4.0 * self.cubic * s * s);
        last_below(0.0, |s| force(s) < load)
    }

    /// How far it swings with an energy above that of its balance, J.
    fn swing(self, load: f64, above: f64) -> f64 {
        let balance = self.balance(load);
        let potential = |s: f64| self.energy(s) - load * s;
        let level = potential(balance) + above;
        last_below(balance, |s| potential(s) < level)
    }
}

/// The end of where a condition holds from `s` on.
fn last_below(s: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let mut wide = s.max(1.0);
    while holds(s + wide) && wide < 1e12 {
        wide *= 2.0;
    }
    let (mut low, mut high) = (s, s + wide);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Coordinates of the whole body that are held while all its other motions come into balance: what of a deflection they are, and the motions that
/// change one of them alone, row by row of the nodal components.
pub(super) struct Held<'b> {
    count: usize,
    momenta: Cow<'b, [f64]>,
    motions: Cow<'b, [f64]>,
}

impl Held<'_> {
    /// Forces on what is held.
    fn on_motions(&self, force: &[f64]) -> Vec<f64> {
        let mut held = vec![0.0; self.count];
        for (value, motions) in force.iter().zip(self.motions.chunks_exact(self.count)) {
            held.iter_mut()
                .zip(motions)
                .for_each(|(sum, motion)| *sum += motion * value);
        }
        held
    }

    /// Forces without what holds.
    fn without(&self, mut force: Vec<f64>, held: &[f64]) -> Vec<f64> {
        for (value, momenta) in force.iter_mut().zip(self.momenta.chunks_exact(self.count)) {
            *value -= dot(momenta, held);
        }
        force
    }

    /// One of the momenta.
    fn momentum(&self, index: usize) -> Vec<f64> {
        self.momenta.iter().skip(index).step_by(self.count).copied().collect()
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl ModalBody {
    /// How much modes hinder the deflection p, if they do: the part of the elastic work that a static displacement by all
    /// motions left out would release, with the stiffness at rest. Grows with the deflection.
    pub fn hindrance(&self, elements: &dyn Elements, p: &[f64]) -> Option<f64> {
        let moved = p.iter().zip(&self.sizes).any(|(p, size)| p.abs() > LEAST * size);
        if !moved || !self.moves() {
            return None;
        }
        let [q, _] = self.full(p, &vec![0.0; p.len()]);
        let force = self.elastic_forces(elements, &q);
        let held = self.all_modes();
        let modal = held.on_motions(&force);
        let left = self.nodal.reduced(&held.without(force, &modal));
        let mut displacement = left.clone();
        self.stiffness.as_ref()?.solve(&mut displacement);
        let (released, work) = (0.5 * dot(&left, &displacement), dot(&modal, p));
        (work > 0.0 && 4.0 * released > MISSING * work).then_some(released / self.linear_energy(p))
    }

    /// Modes that hinder the deflection p, if they do. The whole body with the same modal coordinates and all other motions
    /// in balance resists less. Under the load that the motion (p, p', p'') shows, and with its energy above the balance,
    /// the body in modes swings less far along p than the whole body would.
    pub fn locking(&self, elements: &dyn Elements, [p, v, a]: [&[f64]; 3]) -> Option<Locking> {
        let [q, _] = self.full(p, &vec![0.0; p.len()]);
        let work = dot(&self.all_modes().on_motions(&self.elastic_forces(elements, &q)), p);
        let hindered = Spring::new(self.linear_energy(p), work);
        let load = work + dot(a, p);
        let speed = dot(v, p);
        let energy = 0.5 * speed * speed / dot(p, p) + hindered.energy(1.0) - load;
        let load = load.abs();
        let balance = hindered.balance(load);
        let above = (energy - (hindered.energy(balance) - load * balance)).max(0.0);
        let whole = self.whole_swing(elements, p, (load, above), work)?;
        let missing = 1.0 - hindered.swing(load, above) / whole;
        (missing > MISSING).then(|| Locking {
            body: self.nodal.name.clone(),
            modes: self.modes(),
            missing,
        })
    }

    /// Energy of deflection where it is linear, J.
    pub(super) fn linear_energy(&self, p: &[f64]) -> f64 {
        0.5 * p
            .iter()
            .zip(&self.frequencies)
            .map(|(p, w)| (w * p).powi(2))
            .sum::<f64>()
    }

    /// How far the whole body swings along p under a load that does the work `load` at p, with an energy above that of its
    /// balance (J): found by displacing it step by step.
    fn whole_swing(&self, elements: &dyn Elements, p: &[f64], (load, above): (f64, f64), work: f64) -> Option<f64> {
        let mut further = vec![0.0; self.nodal.shape.len()];
        self.expand_rate(p, &mut further);
        let [q, _] = self.full(p, &vec![0.0; p.len()]);
        let held = self.all_modes();
        let (mut q, modal) = self.relaxed(elements, q, RELAXED * work, &held)?;
        let mut force = dot(&modal, p);
        let near = Spring::new(self.linear_energy(p), force);
        // Up to p.
        let swing = near.swing(load, above);
        if swing <= 1.0 {
            return Some(swing);
        }
        let (mut s, mut potential) = (1.0, near.energy(1.0) - load);
        let mut level = (force >= load).then(|| {
            let balance = near.balance(load);
            near.energy(balance) - load * balance + above
        });
        for _ in 0..MOST_STEPS {
            let step = STEP * s;
            let tried: Vec<f64> = q.iter().zip(&further).map(|(q, d)| q + step * d).collect();
            let (next, modal) = self.relaxed(elements, tried, RELAXED * work, &held)?;
            let reached = dot(&modal, p);
            let rise = step * (0.5 * (force + reached) - load);
            if level.is_none() && reached >= load {
                let stiffness = (reached - force) / step;
                let balance = (load - force) / stiffness;
                let swing = balance + (2.0 * above / stiffness).sqrt();
                if swing <= step {
                    return Some(s + swing);
                }
                level = Some(potential - 0.5 * stiffness * balance * balance + above);
            } else if let Some(level) = level.filter(|level| potential + rise >= *level) {
                return Some(s + step * ((level - potential) / rise).clamp(0.0, 1.0));
            }
            (q, force, s, potential) = (next, reached, s + step, potential + rise);
        }
        Some(s)
    }

    /// Elastic forces of all elements at rest.
    fn elastic_forces(&self, elements: &dyn Elements, q: &[f64]) -> Vec<f64> {
        let connectivity = &self.nodal.connectivity;
        let (mut local, rest) = (vec![0.0; connectivity.size], vec![0.0; connectivity.size]);
        let (mut sum, mut force) = (vec![0.0; q.len()], local.clone());
        for element in 0..connectivity.count() {
            connectivity.gather(element, q, &mut local);
            force.fill(0.0);
            elements.force(element, &local, &rest, &mut force);
            for (value, &component) in force.iter().zip(connectivity.element(element)) {
                sum[component] += value;
            }
        }
        sum
    }

    /// All modal coordinates: `M phi_i` and `phi_i`.
    fn all_modes(&self) -> Held<'_> {
        Held {
            count: self.modes(),
            momenta: Cow::from(&self.momenta),
            motions: Cow::from(&self.modes),
        }
    }

    /// The work of the linear elastic forces at a deflection p, which is what a load that they balance there holds: the force on it is 1 where the
    /// whole body resists as they do.
    pub(super) fn work_along(&self, p: &[f64]) -> Held<'static> {
        let forces: Vec<f64> = p.iter().zip(&self.frequencies).map(|(p, w)| w * w * p).collect();
        let momentum = self.momenta.chunks_exact(self.modes()).map(|row| dot(row, &forces));
        let work = 2.0 * self.linear_energy(p);
        let motion = (0..self.nodal.shape.len()).map(|component| dot(self.mode_row(component), p) / work);
        Held {
            count: 1,
            momenta: momentum.collect(),
            motions: motion.collect(),
        }
    }

    /// The whole body with what is held of q and all other motions in balance, by Newton's method from q, up to
    /// an energy (J) that may be left; and its elastic forces on what is held.
    pub(super) fn relaxed(
        &self,
        elements: &dyn Elements,
        mut q: Vec<f64>,
        enough: f64,
        held: &Held<'_>,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let nodal = &self.nodal;
        let pairs = nodal.connectivity.components.chunks_exact(nodal.connectivity.size);
        let freedoms = pairs.flat_map(|components| {
            let own = || {
                components
                    .iter()
                    .flat_map(|&component| nodal.map[component].iter().map(|entry| entry.0))
            };
            own().flat_map(move |row| own().map(move |column| (row, column)))
        });
        let pattern = Pattern::new(nodal.freedoms, nodal.freedoms, freedoms.collect::<Vec<_>>());
        let momenta: Vec<Vec<f64>> = (0..held.count)
            .map(|index| nodal.reduced(&held.momentum(index)))
            .collect();
        let mut factors = Lu::new(&pattern);
        let residual = |q: &[f64]| {
            let force = self.elastic_forces(elements, q);
            let on_held = held.on_motions(&force);
            (nodal.reduced(&held.without(force, &on_held)), on_held)
        };
        let mut left = residual(&q).0;
        for _ in 0..MOST_ITERATIONS {
            let mut values = vec![0.0; pattern.entries()];
            nodal.each_stiffness(elements, &q, |components, matrix| {
                for (&row, entries) in components.iter().zip(matrix.chunks_exact(components.len())) {
                    for (&column, value) in components.iter().zip(entries) {
                        for &(i, f) in &nodal.map[row] {
                            for &(j, g) in &nodal.map[column] {
                                if let Some(place) = pattern.find(i, j) {
                                    values[place] += f * g * value;
                                }
                            }
                        }
                    }
                }
            });
            factors.factor(&values).ok()?;
            // K^-1 of what is left and of the momenta, so that what is held stays.
            let solved = |factors: &mut Lu<f64>, load: &[f64]| {
                let mut x = load.to_vec();
                factors.solve(&mut x);
                x
            };
            let mut step = solved(&mut factors, &left);
            let kept: Vec<Vec<f64>> = momenta.iter().map(|momentum| solved(&mut factors, momentum)).collect();
            let mut small = Dense::new(momenta.len());
            small.clear();
            for (row, momentum) in momenta.iter().enumerate() {
                for (column, kept) in kept.iter().enumerate() {
                    let value = dot(momentum, kept);
                    small.add(row, column, value, value.abs());
                }
            }
            small.factor().ok()?;
            let mut multipliers: Vec<f64> = momenta.iter().map(|momentum| dot(momentum, &step)).collect();
            small.solve(&mut multipliers);
            for (factor, kept) in multipliers.iter().zip(&kept) {
                step.iter_mut().zip(kept).for_each(|(x, y)| *x -= factor * y);
            }
            let decrement = dot(&left, &step);
            let direction = nodal.expanded(std::slice::from_ref(&step));
            let mut length = 1.0;
            let next = loop {
                let tried: Vec<f64> = q.iter().zip(&direction).map(|(q, d)| q - length * d).collect();
                let (left, on_held) = residual(&tried);
                // Not far beyond the minimum along the step.
                if dot(&left, &step) > -0.5 * decrement.abs() || length < 1e-3 {
                    break (tried, left, on_held);
                }
                length *= 0.5;
            };
            let on_held;
            (q, left, on_held) = next;
            if decrement.abs() < enough && length == 1.0 {
                return Some((q, on_held));
            }
        }
        None
    }
}
