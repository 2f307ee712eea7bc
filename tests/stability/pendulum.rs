//! The pendulum of THEORY 10, T1 and T2, as a model, and its exact motion.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, StepSize, Stop};
use rncf_reference::integrate::{Method as Explicit, agreed};
use rncf_reference::pendulum::Pendulum as Exact;

use crate::failing::index_3::{Change, Family, Index3};

rncf::model! {
    /// A point mass on a rod of 1 m, thrown downwards from where the rod lies flat.
    pub model Pendulum {
        rigid bob { plane xy; mass = 1 kg; origin = [1, 0, 0] m; velocity = [0, -3, 0] m/s; }
        constraint rod = (dot(bob.position, bob.position) - 1 [m^2]) / 2;
        load weight = gravity([0, -9.81, 0] m/s^2);
        output x = bob.x;
        output y = bob.y;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

/// Jerk at the start, m/s^3, and its part along the rod.
const JERK: [f64; 2] = [-88.29, 27.0];
const ALONG: [f64; 2] = [JERK[0], 0.0];

/// The end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Time, s.
    pub t: f64,
    /// Place, m.
    place: [f64; 2],
    /// Multiplier, N/m.
    multiplier: f64,
}

/// Errors at the end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Error {
    /// Time, s.
    pub t: f64,
    /// Of the place, m.
    pub place: f64,
    /// Of the multiplier, N/m.
    pub multiplier: f64,
}

pub fn scene() -> Box<dyn Scene> {
    Pendulum::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap()
}

/// Fixed steps, s; Newton's iteration goes on to round-off.
pub fn fixed(h: f64) -> Options {
    Options {
        rtol: 1e-12,
        step: StepSize::Fixed(h),
        ..Options::default()
    }
}

/// The start with its accelerations and multipliers.
pub fn consistent(scene: &mut dyn Scene) -> State {
    let rest = scene.rest(0.0);
    let integrator = Integrator::new(scene, rest, 1.0, Method::Radau, Options::default()).unwrap();
    integrator.state().clone()
}

fn point(scene: &mut dyn Scene, state: &State) -> Point {
    let mut place = [0.0; 2];
    scene.outputs(state, &mut place);
    Point {
        t: state.t,
        place,
        multiplier: state.lambda[0],
    }
}

/// Errors against the exact motion.
pub fn errors(points: &[Point]) -> Vec<Error> {
    let pendulum = Exact::published();
    let times: Vec<f64> = std::iter::once(0.0).chain(points.iter().map(|point| point.t)).collect();
    let start = pendulum.horizontal_start(-3.0);
    let run = agreed(&pendulum, Explicit::DoPri8, 1e-12, &start, &times, 1e-9).unwrap();
    let rows = points.iter().zip(run.states.iter().skip(1));
    rows.map(|(point, y)| {
        let [x, height] = pendulum.cartesian(y).position;
        Error {
            t: point.t,
            place: (point.place[0] - x).hypot(point.place[1] - height),
            multiplier: (point.multiplier - pendulum.multiplier(y)).abs(),
        }
    })
    .collect()
}

/// The largest error of the multiplier in a span of time, N/m.
pub fn largest(errors: &[Error], from: f64, to: f64) -> f64 {
    let within = errors.iter().filter(|error| error.t > from && error.t < to + 1e-9);
    within.fold(0.0, |most, error| error.multiplier.max(most))
}

/// A step of the runtime after the other, until one fails.
pub fn ours(method: Method, options: Options, end: f64) -> Vec<Point> {
    let mut scene = scene();
    let rest = scene.rest(0.0);
    run(scene.as_mut(), rest, method, options, end).0
}

/// The same from a state; the last state comes back.
pub fn run(scene: &mut dyn Scene, start: State, method: Method, options: Options, end: f64) -> (Vec<Point>, State) {
    let mut integrator = Integrator::new(scene, start, end, method, options).unwrap();
    let mut points = Vec::new();
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        points.push(point(integrator.system(), &state));
        if stop == Stop::End {
            return (points, state);
        }
    }
}

/// How a textbook's method starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Begin {
    /// With the accelerations of the start.
    Plain,
    /// As THEORY 10 corrects it.
    Corrected,
    /// With a velocity along the rod, m/s.
    Kicked(f64),
}

/// Steps of a textbook's method, until one fails.
pub fn textbook(family: Family, begin: Begin, change: Change, steps: &[f64]) -> Vec<Point> {
    let mut scene = scene();
    let mut state = consistent(scene.as_mut());
    if let Begin::Kicked(speed) = begin {
        state.v[0] += speed;
    }
    let mut method = Index3::new(scene.as_mut(), &state, family, change);
    if begin == Begin::Corrected {
        method.correct_start(&JERK, &ALONG, steps[0]);
    }
    let mut points = Vec::new();
    for &h in steps {
        if method.step(h).is_none() {
            break;
        }
        let state = method.state.clone();
        points.push(point(method.system, &state));
    }
    points
}
