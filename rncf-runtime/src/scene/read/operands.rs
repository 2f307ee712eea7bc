//! Sizes of what outputs are made of.
//!
//! A difference of two long ways is known as well as the ways are, however small it is. So an output is measured by what stands in its expression: each
//! number that it reads has the size of the vector that it is a component of, and of what moments and rates have to do with forces and places.

use crate::emitted::{BalanceQuantity, ObservedSpec, Owner, PointQuantity, SectionQuantity};
use crate::model::SectionState;
use crate::scene::mesh_scene::MeshScene;
use crate::space::Vector;
use crate::system::State;

/// Part of a size by which what is read changes, for its influence.
const STEP: f64 = 1e-6;

/// Sizes at a state.
struct Sizes {
    /// Of the longest body, m; zero: there is none.
    length: f64,
    /// Largest rate of an unknown over its size, 1/s.
    rate: f64,
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
            _ => value + self.length * self.rate.powi(derivative as i32),
        }
    }
}

impl MeshScene {
    /// What the output columns are made of at a state: the norm of what each number that they read contributes.
    pub(crate) fn operands_of_outputs(&mut self, state: &State, out: &mut [f64]) {
        let columns = out.len();
        self.evaluate_outputs(state.t, 1.0, &state.lambda, out);
        let values = out.to_vec();
        let rates = state
            .v
            .iter()
            .zip(&self.tabulated.sizes)
            .map(|(v, size)| (v / size).abs());
        let everything = self.balance_of(Owner::All, BalanceQuantity::KineticEnergy, state.t, 0);
        let mass = self.balance_of(Owner::All, BalanceQuantity::Mass, state.t, 0);
        let rate = rates.fold(0.0, f64::max);
        let sizes = Sizes {
            length: self
                .bodies
                .iter()
                .map(|body| body.spec.line.length())
                .fold(0.0, f64::max),
            rate,
            momentum: (2.0 * mass * everything).max(0.0).sqrt(),
            // What turns one way and another the other way has no sum.
            angular_momentum: if rate > 0.0 { 2.0 * everything / rate } else { 0.0 },
        };
        let mut observed = self.observed_values(state.t, &state.lambda);
        let mut squares = vec![0.0; columns];
        for index in 0..observed.len() {
            let step = STEP * self.size_of_observed(index, observed[index], state, &sizes);
            let value = observed[index];
            observed[index] += step;
            self.parts.outputs(state.t, &observed, out);
            observed[index] = value;
            for ((square, out), value) in squares.iter_mut().zip(&*out).zip(&values) {
                let part = (out - value) / STEP;
                // Beside a place where a function ends there is no difference.
                if part.is_finite() {
                    *square += part * part;
                }
            }
        }
        out.iter_mut()
            .zip(squares)
            .for_each(|(out, square)| *out = square.sqrt());
    }

    /// Size of what is read; forces must be evaluated.
    fn size_of_observed(&self, index: usize, value: f64, state: &State, sizes: &Sizes) -> f64 {
        let two = |[force, moment]: [Vector; 2], is_moment: bool| sizes.of(is_moment, force.norm(), moment.norm());
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
                let linked = self
                    .links
                    .constraints
                    .iter()
                    .position(|linked| linked.index == constraint);
                let reaction = linked.map(|linked| self.constraint_reaction(linked, state.t, &state.lambda));
                two(reaction.unwrap_or_default(), moment)
            }
            ObservedSpec::Reaction { joint, moment, .. } => {
                let of = |moment| self.reaction(joint, moment, state.t, &state.lambda);
                two([of(false), of(true)], moment)
            }
            ObservedSpec::Section { what, .. } => match &self.observed.points[index] {
                Some(point) => {
                    let mut reaches = self.buffers.reaches.clone();
                    let section = self.section_at(point, &mut reaches[point.body]);
                    of_section(what, &section, value, sizes)
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

fn of_section(what: SectionQuantity, section: &SectionState, value: f64, sizes: &Sizes) -> f64 {
    let norm = |all: [SectionQuantity; 3]| {
        let all = all.iter().filter_map(|&what| section.value(what));
        all.map(|value| value * value).sum::<f64>().sqrt()
    };
    let force = norm([
        SectionQuantity::AxialForce,
        SectionQuantity::ShearY,
        SectionQuantity::ShearZ,
    ]);
    let moment = norm([
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
