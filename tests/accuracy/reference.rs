//! The soft beams of [`crate::models`] as references: their numbers by hand, the motion by russell_ode, the reactions
//! from the rows of the root.

use rncf::{Formulation, Joints, Scene, State};
use rncf_reference::beam::{Beam, Root};
use rncf_reference::dense::Matrix;
use rncf_reference::element::Data;
use rncf_reference::inertia::{Frame, State as Coordinates};
use rncf_reference::integrate::{Method, agreed};
use rncf_reference::rotating_beam::RotatingBeam;
use rncf_reference::spin_up::{Motion, SpinUp};
use rncf_reference::system::System;

/// Distance of the root from the axis, m.
const HUB_RADIUS: f64 = 0.7;
/// Length of the beam, m.
const LENGTH: f64 = 2.0;
/// Times of the comparison, s: within the run-up, where the frame moves in every way.
pub const START: f64 = 0.3;
/// Time between two comparisons, s.
pub const EVERY: f64 = 0.1;
/// Number of comparisons.
pub const COMPARISONS: usize = 8;

/// Which constant of the reference is wrong, by one per cent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// None: the reference is right.
    None,
    /// Axial stiffness.
    Axial,
    /// Bending stiffness.
    Bending,
    /// Radius of the hub.
    Radius,
    /// The factor 2 of the Coriolis force.
    Coriolis,
}

/// State of the beam in its frame and what its root holds.
pub struct Instant {
    /// Time, s.
    pub t: f64,
    /// Nodal vectors in the hub's frame, from its axis.
    pub q: Vec<f64>,
    /// Their rates.
    pub v: Vec<f64>,
    /// Force on the root (N) and generalised force on its slope (N m), frame axes.
    pub root: [[f64; 3]; 2],
    /// Angle of the frame, rad.
    pub angle: f64,
}

/// Reference motion of one soft beam.
pub struct Reference {
    /// 2 or 3.
    pub dimension: usize,
    /// Number of elements.
    pub elements: usize,
    /// The start and then one instant a comparison.
    pub instants: Vec<Instant>,
    /// How well two tolerances agree.
    pub agreement: f64,
}

/// Data of `SoftPlanar` (damped, p = 2) and `SoftSpatial` (undamped, p = 0).
fn beam(dimension: usize, elements: usize, mistake: Mistake) -> Beam {
    let wrong = |which| if mistake == which { 1.01 } else { 1.0 };
    Beam {
        elements,
        length: LENGTH,
        hub_radius: HUB_RADIUS * wrong(Mistake::Radius),
        root: Root::Clamped,
        element: Data {
            dimension,
            length: LENGTH,
            mass_per_length: 0.2,
            axial_stiffness: 40.0 * wrong(Mistake::Axial),
            bending_stiffness: 0.1 * wrong(Mistake::Bending),
            exponent: if dimension == 2 { 2 } else { 0 },
            damping: if dimension == 2 { 0.005 } else { 0.0 },
            points: 5,
        },
    }
}

/// The beam with a Coriolis force that is too large by `excess`.
struct Coriolis {
    inner: RotatingBeam,
    mass: Matrix,
    excess: f64,
}

impl System for Coriolis {
    fn size(&self) -> usize {
        self.inner.size()
    }

    fn rate(&self, t: f64, y: &[f64], rate: &mut [f64]) {
        self.inner.load(t, y, rate);
        let (_, qd) = self.inner.coordinates(y);
        let (n, spin) = (self.inner.chain().dimension(), self.inner.motion().at(t).rate);
        let (mut twice, mut force) = (vec![0.0; qd.len()], vec![0.0; qd.len()]);
        for at in (0..qd.len()).step_by(n) {
            twice[at] = -2.0 * spin * qd[at + 1];
            twice[at + 1] = 2.0 * spin * qd[at];
        }
        self.mass.add_product(&twice, &mut force);
        let size = y.len() / 2;
        for (row, force) in rate[size..].iter_mut().zip(free(&force, n)) {
            *row -= self.excess * force;
        }
        let whole = self.inner.mass().expect("the beam has a mass matrix");
        rate.copy_from_slice(&whole.solve(rate).expect("the mass matrix is regular"));
    }

    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix) {
        self.inner.load_jacobian(t, y, jacobian);
    }
}

/// The free ones of the chain's coordinates: all but the root's position and the slope across the beam.
fn free(full: &[f64], n: usize) -> impl Iterator<Item = f64> {
    [full[n]].into_iter().chain(full[2 * n..].iter().copied())
}

/// Shape and velocity of the start: bent and moving in every direction, as smooth as the coarsest mesh can be.
fn start(dimension: usize, elements: usize) -> [Vec<f64>; 2] {
    let (mut q, mut v) = (vec![], vec![]);
    for node in 0..=elements {
        let s = LENGTH * node as f64 / elements as f64;
        let (square, slope) = (s * s / (LENGTH * LENGTH), 2.0 * s / (LENGTH * LENGTH));
        q.extend_from_slice(&[s, 0.1 * square, 0.05 * square][..dimension]);
        q.extend_from_slice(&[1.0, 0.1 * slope, 0.05 * slope][..dimension]);
        v.extend_from_slice(&[0.05 * s, 0.3 * square, 0.2 * square][..dimension]);
        v.extend_from_slice(&[0.05, 0.3 * slope, 0.2 * slope][..dimension]);
    }
    [q, v]
}

impl Reference {
    /// Integrates the beam with the given mistake.
    pub fn new(dimension: usize, elements: usize, mistake: Mistake) -> Self {
        let motion = SpinUp::new(3.0, 2.0).unwrap();
        let inner = RotatingBeam::new(beam(dimension, elements, mistake), motion).unwrap();
        let system = Coriolis {
            mass: inner.chain().mass(),
            inner,
            excess: if mistake == Mistake::Coriolis { 0.01 } else { 0.0 },
        };
        let times: Vec<f64> = (0..=COMPARISONS).map(|k| START + EVERY * k as f64).collect();
        let y: Vec<f64> = start(dimension, elements)
            .iter()
            .flat_map(|full| free(full, dimension))
            .collect();
        let run = agreed(&system, Method::DoPri8, 1e-13, &y, &times, 3e-10).unwrap();
        let instants = times.iter().zip(&run.states).map(|(&t, y)| instant(&system, t, y));
        Self {
            dimension,
            elements,
            instants: instants.collect(),
            agreement: run.difference,
        }
    }

    /// The start as a state of the scene.
    pub fn start(&self, scene: &dyn Scene) -> State {
        let first = &self.instants[0];
        scene.state_of_frame(&rncf::model::FrameState {
            t: first.t,
            q: first.q.clone(),
            v: first.v.clone(),
            poses: Vec::new(),
        })
    }
}

/// Coordinates and reactions at the states `y`.
fn instant(system: &Coriolis, t: f64, y: &[f64]) -> Instant {
    let (inner, n) = (&system.inner, system.inner.chain().dimension());
    let (mut q, v) = inner.coordinates(y);
    let mut rate = vec![0.0; y.len()];
    system.rate(t, y, &mut rate);
    let (mut a, size) = (vec![0.0; q.len()], y.len() / 2);
    a[n] = rate[size];
    a[2 * n..].copy_from_slice(&rate[size + 1..]);
    let (turn, radius) = (inner.motion().at(t), inner.chain().beam().hub_radius);
    let frame = Frame {
        spin: [0.0, 0.0, turn.rate],
        spin_rate: [0.0, 0.0, turn.acceleration],
        origin_acceleration: [-radius * turn.rate * turn.rate, radius * turn.acceleration, 0.0],
    };
    let mut residual = vec![0.0; q.len()];
    let state = Coordinates { q: &q, qd: &v, qdd: &a };
    inner.chain().residual(state, &frame, &mut residual);
    let of = |from: usize| std::array::from_fn(|k| if k < n { residual[from + k] } else { 0.0 });
    let root = [of(0), of(n)];
    for at in (0..q.len()).step_by(2 * n) {
        q[at] += HUB_RADIUS;
    }
    let angle = turn.angle;
    Instant { t, q, v, root, angle }
}

impl Instant {
    /// Force and moment of the root as the models put them out: `m = slope x force on the slope`.
    pub fn reactions(&self, dimension: usize) -> Vec<f64> {
        let along = self.q[dimension];
        let [f, s] = self.root;
        if dimension == 2 {
            vec![f[0], f[1], along * s[1]]
        } else {
            vec![f[0], f[1], f[2], 0.0, -along * s[2], along * s[1]]
        }
    }

    /// Multipliers of the root's conditions in the given way: `M a + f + C_x^T lambda = 0`, position along the axes of
    /// the coordinates, then the slope's components across the beam (+y in the plane; +z and -y in space).
    pub fn multipliers(&self, formulation: Formulation, joints: Joints, dimension: usize) -> Vec<f64> {
        let [f, s] = self.root;
        let across = if dimension == 2 { vec![-s[1]] } else { vec![-s[2], s[1]] };
        let (sin, cos) = self.angle.sin_cos();
        let position = match (formulation, joints) {
            (Formulation::Rncf, Joints::Eliminated) => return vec![],
            (Formulation::Ancf, Joints::Eliminated) => vec![],
            (Formulation::Rncf, Joints::Multipliers) => f[..dimension].to_vec(),
            (Formulation::Ancf, Joints::Multipliers) => {
                [cos * f[0] - sin * f[1], sin * f[0] + cos * f[1], f[2]][..dimension].to_vec()
            }
        };
        position.into_iter().map(|f| -f).chain(across).collect()
    }
}
