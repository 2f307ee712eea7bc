//! Sizes of what outputs are made of.
//!
//! A difference of two long ways is known as well as the ways are, however small it is. So an output is measured by what stands in its expression: each
//! number that it reads has the size of the vector that it is a component of, and of what moments and rates have to do with forces and places.

use super::exerted::{Exerted, Held};
use crate::emitted::{BalanceQuantity, ObservedSpec, Owner, PointQuantity, SectionQuantity};
use crate::model::{Operands, SectionState};
use crate::scene::mesh_scene::MeshScene;
use crate::system::State;

/// Part of a size by which what is read changes, for its influence.
const STEP: f64 = 1e-6;

/// Sizes at a state.
struct Sizes {
    /// Of the longest body, m; zero: there is none.
    length: f64,
    /// The same, or where there is none the largest size of an unknown place, m.
    extent: f64,
    /// Largest rate of an unknown over its size, 1/s.
    rate: f64,
    /// Of reactions beside each other, where one is read.
    exerted: Option<Exerted>,
    /// Of all that moves: of places and momenta, kg m/s, and of moments of these, kg m^2/s.
    momentum: f64,
    angular_momentum: f64,
}

impl Sizes {
    fn length_or(&self, other: f64) -> f64 {
        if self.length > 0.0 { self.length } else { other }
    }

    /// Of a force or moment, where both act.
    fn of(&self, is_moment: bool, force: f64, moment: f64) -> f64 {
        match is_moment {
            true => moment + self.length * force,
            false if self.length > 0.0 => force + moment / self.length,
            false => force,
        }
    }

    /// Of a place or a rate of it.
    fn of_place(&self, derivative: usize, value: f64) -> f64 {
        match derivative {
            0 => self.length_or(value),
            _ => value + self.extent * self.rate.powi(derivative as i32),
        }
    }
}

impl MeshScene {
    /// What the output columns are made of at a state: the norm of what each number that they read contributes.
    pub(crate) fn operands_of_outputs(&mut self, state: &State) -> Vec<Operands> {
        let mut values = vec![0.0; self.parts.output_columns()];
        self.evaluate_outputs(state.t, 1.0, &state.lambda, &mut values);
        let mut out = values.clone();
        let rates = state
            .v
            .iter()
            .zip(&self.tabulated.sizes)
            .map(|(v, size)| (v / size).abs());
        let everything = self.balance_of(Owner::All, BalanceQuantity::KineticEnergy, state.t, 0);
        let mass = self.balance_of(Owner::All, BalanceQuantity::Mass, state.t, 0);
        let rate = rates.fold(0.0, f64::max);
        let reads_reactions = self.observes(is_reaction);
        let bodies = self.bodies.iter().map(|body| body.spec.line.length());
        let length = bodies.fold(0.0, f64::max);
        let places = self.tabulated.sizes.iter().enumerate();
        let places = places.filter(|(unknown, _)| self.is_length(*unknown));
        let sizes = Sizes {
            exerted: reads_reactions.then(|| self.exerted(state.t, &state.lambda)),
            length,
            extent: match length > 0.0 {
                true => length,
                false => places.map(|(_, size)| *size).fold(0.0, f64::max),
            },
            rate,
            momentum: (2.0 * mass * everything).max(0.0).sqrt(),
            // What turns one way and another the other way has no sum.
            angular_momentum: if rate > 0.0 { 2.0 * everything / rate } else { 0.0 },
        };
        let mut observed = self.observed_values(state.t, &state.lambda);
        let mut squares = vec![Operands::default(); values.len()];
        for index in 0..observed.len() {
            let step = STEP * self.size_of_observed(index, observed[index], state, &sizes);
            let value = observed[index];
            observed[index] += step;
            self.parts.outputs(state.t, &observed, &mut out);
            observed[index] = value;
            let is_balanced = is_balanced(&self.observed.specs[index]);
            for ((square, out), value) in squares.iter_mut().zip(&out).zip(&values) {
                let part = (out - value) / STEP;
                // Beside a place where a function ends there is no difference.
                if part.is_finite() {
                    square.size += part * part;
                    square.balanced += if is_balanced { part * part } else { 0.0 };
                }
            }
        }
        let roots = squares.into_iter().map(|square| Operands {
            size: square.size.sqrt(),
            balanced: square.balanced.sqrt(),
        });
        roots.collect()
    }

    /// Size of what is read; forces must be evaluated.
    fn size_of_observed(&self, index: usize, value: f64, state: &State, sizes: &Sizes) -> f64 {
        // A reaction balances others where it acts, and is not known better than the largest there.
        let reaction = |held: &mut dyn Iterator<Item = Held>, is_moment: bool| {
            let largest = sizes.exerted.as_ref().map(|exerted| exerted.largest(held));
            let [force, moment] = largest.unwrap_or_default();
            sizes.of(is_moment, force, moment)
        };
        match self.observed.specs[index] {
            ObservedSpec::Point { what, .. } => match what {
                PointQuantity::Position => sizes.of_place(0, value.abs()),
                PointQuantity::Velocity => sizes.of_place(1, value.abs()),
                PointQuantity::Slope | PointQuantity::SectionY | PointQuantity::SectionZ => value.abs().max(1.0),
            },
            ObservedSpec::Marker { marker, derivative, .. } => {
                let marker = &self.links.markers[marker];
                let norm = self.jet(marker)[derivative].norm();
                if marker.is_point() {
                    sizes.of_place(derivative, norm)
                } else {
                    norm + sizes.rate.powi(derivative as i32)
                }
            }
            ObservedSpec::ConstraintReaction { constraint, moment, .. } => {
                let linked = self.linked(constraint).map(|place| &self.links.constraints[place]);
                let mut held = linked.into_iter().flat_map(|linked| self.held_by(linked));
                reaction(&mut held, moment)
            }
            ObservedSpec::Reaction { joint, moment, .. } => {
                reaction(&mut [Held::Body(self.joints[joint].body)].into_iter(), moment)
            }
            ObservedSpec::Section { what, .. } => match &self.observed.points[index] {
                Some(point) => {
                    let mut reaches = self.buffers.reaches.clone();
                    let section = self.section_at(point, &mut reaches[point.body]);
                    let ends = self.sections_at_ends(point.body, &mut reaches[point.body]);
                    of_section(what, &[section, ends[0], ends[1]], value, sizes)
                }
                None => value.abs(),
            },
            ObservedSpec::Balance { of, what, component } => {
                let norm = |count| {
                    let all = (0..count).map(|component| self.balance_of(of, what, state.t, component));
                    all.map(|value| value * value).sum::<f64>().sqrt()
                };
                match what {
                    BalanceQuantity::Momentum => norm(3) + sizes.momentum,
                    BalanceQuantity::AngularMomentum(_) => {
                        norm(3) + sizes.angular_momentum.max(sizes.length * sizes.momentum)
                    }
                    BalanceQuantity::CenterOfMass => sizes.length_or(norm(3)),
                    _ => self.balance_of(of, what, state.t, component).abs(),
                }
            }
            ObservedSpec::Multiplier { .. } => value.abs(),
        }
    }
}

fn is_reaction(observed: &ObservedSpec) -> bool {
    matches!(
        observed,
        ObservedSpec::Reaction { .. } | ObservedSpec::ConstraintReaction { .. }
    )
}

fn is_balanced(observed: &ObservedSpec) -> bool {
    is_reaction(observed) || matches!(observed, ObservedSpec::Section { .. })
}

/// Of what a section carries, with those at the ends of its body: a free one carries nothing.
fn of_section(what: SectionQuantity, sections: &[SectionState], value: f64, sizes: &Sizes) -> f64 {
    let largest = |all: [SectionQuantity; 3]| {
        let norm = |section: &SectionState| {
            let all = all.iter().filter_map(|&what| section.value(what));
            all.map(|value| value * value).sum::<f64>().sqrt()
        };
        sections.iter().map(norm).fold(0.0, f64::max)
    };
    let force = largest([
        SectionQuantity::AxialForce,
        SectionQuantity::ShearY,
        SectionQuantity::ShearZ,
    ]);
    let moment = largest([
        SectionQuantity::Torque,
        SectionQuantity::MomentY,
        SectionQuantity::MomentZ,
    ]);
    match what {
        SectionQuantity::AxialForce | SectionQuantity::ShearY | SectionQuantity::ShearZ => {
            sizes.of(false, force, moment)
        }
        SectionQuantity::Stress => value.abs(),
        _ => sizes.of(true, force, moment),
    }
}
