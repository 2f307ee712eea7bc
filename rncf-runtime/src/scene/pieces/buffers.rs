//! The full (not reduced) state, and what is kept beside it.

use super::point_force::PointForce;
use super::reach::Reaches;
use crate::emitted::{FrameMotion, LANES};
use crate::scene::bodies::nodal_mass::Padded;
use crate::space::Vector;

/// Buffers of the full (not reduced) state.
pub(crate) struct Buffers {
    /// Time of the loaded state, s.
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    /// Jerks of prescribed vectors, else zero.
    pub jerks: Vec<f64>,
    /// Components at the start of a step, for forces between two states.
    pub begun: Vec<f64>,
    pub force: Vec<f64>,
    pub frames: Vec<FrameMotion>,
    /// Added to the accelerations of what is prescribed, where it is looked at.
    pub jolt: Option<Jolt>,
    /// Results of elements side by side.
    pub lanes: Vec<[f64; LANES]>,
    /// Accelerations in space of a body's vectors.
    pub nodal: Vec<f64>,
    /// Places, velocities and accelerations in space of a body's vectors.
    pub nodal_rates: Vec<[Padded; 3]>,
    /// Gravity of the loads that are applied, m/s^2, inertial axes; for section forces.
    pub gravity: Vector,
    /// What acts inside the elements of every body, for section forces.
    pub point_forces: Vec<Vec<PointForce>>,
    /// Reaches on the elements of every body that was read.
    pub reaches: Vec<Reaches>,
    /// What is added to the forces of the elements of every body in modes, for section forces; else nothing.
    pub held: Vec<Vec<f64>>,
    /// Values of densities and the part of them that is applied, for section forces.
    pub density_values: Vec<Vec<f64>>,
    pub density_scale: f64,
    /// How the fields on every free frame change with each of its unknowns, inertial axes.
    pub field_changes: Vec<Vec<Vector>>,
}

impl Buffers {
    pub fn new(components: usize, frames: Vec<FrameMotion>) -> Self {
        let zeros = || vec![0.0; components];
        Self {
            t: 0.0,
            q: zeros(),
            v: zeros(),
            a: zeros(),
            jerks: zeros(),
            begun: Vec::new(),
            force: zeros(),
            frames,
            jolt: None,
            lanes: Vec::new(),
            nodal: Vec::new(),
            nodal_rates: Vec::new(),
            gravity: Vector::zeros(),
            point_forces: Vec::new(),
            reaches: Vec::new(),
            held: Vec::new(),
            density_values: Vec::new(),
            density_scale: 0.0,
            field_changes: Vec::new(),
        }
    }
}

/// By how much prescribed velocities jump at once.
#[derive(Clone, Debug)]
pub(crate) struct Jolt {
    /// Of the origins of all frames, m/s, inertial axes, and of their angular velocities, rad/s, frame axes.
    pub frames: Vec<[Vector; 2]>,
    /// Of the components of prescribed vectors, m/s; of others zero.
    pub values: Vec<f64>,
}

/// How the frames are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Regime {
    /// As the motions say.
    Moving,
    /// In uniform rotation with this multiple of the spin: prescribed frames turn on so, and what
    /// they prescribe rests in its frame. Free frames move as the state says.
    Uniform(f64),
}
