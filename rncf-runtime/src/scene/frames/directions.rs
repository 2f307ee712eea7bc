//! What the unknowns of a free frame do to it.

use crate::emitted::{FreeSpec, Motions};
use crate::space::Vector;

/// What one unknown does to a frame: the map from rates of unknowns to velocities, one column.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Direction {
    /// Velocity of the origin, inertial axes.
    pub shift: Vector,
    /// Angular velocity, frame axes.
    pub turn: Vector,
}

pub(crate) fn unit(axis: usize) -> Vector {
    Vector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 })
}

/// Motions along axes, then about axes.
pub(crate) fn directions(motions: Motions) -> Vec<Direction> {
    let shift = |axis: usize| Direction {
        shift: unit(axis),
        turn: Vector::zeros(),
    };
    let about = |turn: Vector| Direction {
        shift: Vector::zeros(),
        turn,
    };
    let turn = |axis: usize| about(unit(axis));
    let plane = |normal: usize| [(normal + 1) % 3, (normal + 2) % 3];
    match motions {
        Motions::Spatial => (0..3).map(shift).chain((0..3).map(turn)).collect(),
        Motions::Planar { normal } => plane(normal).map(shift).into_iter().chain([turn(normal)]).collect(),
        Motions::Turning => (0..3).map(turn).collect(),
        Motions::Hinged { axis } => vec![about(axis)],
        Motions::Shifting => (0..3).map(shift).collect(),
        Motions::ShiftingPlanar { normal } => plane(normal).map(shift).to_vec(),
        Motions::State => vec![Direction::default()],
    }
}

/// Number of unknown motions of a free frame.
pub fn motions_of(spec: &FreeSpec) -> usize {
    directions(spec.motions).len()
}
