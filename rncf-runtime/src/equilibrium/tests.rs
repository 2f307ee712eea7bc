use super::*;
use crate::error::SolveErrorKind;
use crate::linalg::Pattern;
use crate::model::{FrameState, Scene};
use crate::system::{ConstraintLevel, State, System, Tangent};

/// A mass of 1 kg in a plane that turns with `spin`, on a spring along the arm (stiffness N/m, cubic
/// part N/m^3, length 1 m) and one sideways (N/m), pushed sideways (N), perhaps on a rod to the hub (m).
struct Arm {
    spin: f64,
    stiffness: f64,
    sideways: f64,
    cubic: f64,
    push: f64,
    rod: Option<f64>,
    obstacle: Option<String>,
    referenced: bool,
    pattern: Pattern,
    constraint_pattern: Pattern,
}

impl Arm {
    fn new(spin: f64, stiffness: f64, rod: Option<f64>) -> Self {
        let constraints = usize::from(rod.is_some());
        Self {
            spin,
            stiffness,
            sideways: stiffness,
            cubic: 0.0,
            push: 0.0,
            rod,
            obstacle: None,
            referenced: true,
            pattern: Pattern::new(2, 2, [(0, 0), (0, 1), (1, 0), (1, 1)]),
            constraint_pattern: Pattern::new(
                2,
                constraints,
                (0..2).flat_map(|row| (0..constraints).map(move |j| (row, j))),
            ),
        }
    }
}

impl System for Arm {
    fn unknowns(&self) -> usize {
        2
    }
    fn constraints(&self) -> usize {
        usize::from(self.rod.is_some())
    }
    fn pattern(&self) -> &Pattern {
        &self.pattern
    }
    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }
    fn mass(&mut self, _state: &State, values: &mut [f64]) {
        values.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
    }
    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let (v, a) = (&state.v[..], &state.a[..]);
        self.uniform_residual(&Uniform::steady(state.t), state, out);
        out[0] += a[0] - 2.0 * self.spin * v[1];
        out[1] += a[1] + 2.0 * self.spin * v[0];
    }
    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.small_motions(&Uniform::steady(state.t), state, out);
    }
    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        let dot = |a: &[f64], b: &[f64]| a[0] * b[0] + a[1] * b[1];
        if let (Some(rod), Some(out)) = (self.rod, out.first_mut()) {
            *out = match level {
                ConstraintLevel::Position => 0.5 * (dot(&state.x, &state.x) - rod * rod),
                ConstraintLevel::Velocity => 0.0,
                ConstraintLevel::Acceleration => dot(&state.v, &state.v),
                ConstraintLevel::Jerk => 3.0 * dot(&state.v, &state.a),
            };
        }
    }
    fn constraint_jacobian(&mut self, state: &State, values: &mut [f64]) {
        let count = values.len();
        values.copy_from_slice(&state.x[..count]);
    }
    fn constraint_rate_tangent(&mut self, state: &State, values: &mut [f64]) {
        let count = values.len();
        values.copy_from_slice(&state.v[..count]);
    }
    fn sizes(&self) -> &[f64] {
        &[1.0, 1.0]
    }
    fn describe_unknown(&self, index: usize) -> String {
        format!("mass, {}", ["x", "y"][index])
    }
    fn describe_constraint(&self, _index: usize) -> String {
        "rod".into()
    }
    fn kinks(&self) -> Vec<f64> {
        vec![]
    }
    fn energy(&mut self, _state: &State) -> Option<f64> {
        None
    }
}

impl Scene for Arm {
    fn output_columns(&self) -> usize {
        0
    }
    fn outputs(&mut self, _state: &State, _out: &mut [f64]) {}
    fn rest(&self, t: f64) -> State {
        let mut state = State::zeros(t, 2, self.constraints());
        state.x[0] = 1.0;
        state
    }
    fn frame_state(&mut self, state: &State) -> FrameState {
        FrameState {
            t: state.t,
            q: state.x.clone(),
            v: state.v.clone(),
            poses: Vec::new(),
        }
    }
    fn state_of_frame(&self, frame: &FrameState) -> State {
        let mut state = State::zeros(frame.t, 2, self.constraints());
        state.x.clone_from(&frame.q);
        state.v.clone_from(&frame.v);
        state
    }
    fn is_referenced(&self) -> bool {
        self.referenced
    }
    fn uniform_state(&mut self, at: &Uniform, state: &mut State) {
        state.t = at.t;
        state.v.fill(0.0);
        state.a.fill(0.0);
    }
    fn uniform_residual(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        let (x, square) = (&state.x, (at.speed() * self.spin).powi(2));
        let long = x[0] - 1.0;
        out[0] = self.stiffness * long + self.cubic * long.powi(3) - square * x[0];
        out[1] = self.sideways * x[1] - square * x[1] - at.load() * self.push;
    }
    fn small_motions(&mut self, at: &Uniform, state: &State, out: &mut Tangent) {
        let w = at.speed() * self.spin;
        let lambda = state.lambda.first().copied().unwrap_or(0.0);
        let along = self.stiffness + 3.0 * self.cubic * (state.x[0] - 1.0).powi(2);
        self.mass(state, &mut out.mass);
        out.stiffness
            .copy_from_slice(&[along - w * w + lambda, 0.0, 0.0, self.sideways - w * w + lambda]);
        out.damping.copy_from_slice(&[0.0, 2.0 * w, -2.0 * w, 0.0]);
    }
    fn uniform_outputs(&mut self, _at: &Uniform, _state: &State, _out: &mut [f64]) {}
    fn uniform_obstacle(&mut self, _at: &Uniform, _state: &State) -> Option<String> {
        self.obstacle.clone()
    }
    fn spin(&self, _t: f64) -> f64 {
        self.spin
    }
}

#[test]
fn spring_carries_the_centrifugal_force() {
    let found = steady(&mut Arm::new(3.0, 100.0, None), 2.0).unwrap();
    // k (x - 1) = m w^2 x.
    let state = found.state().unwrap();
    assert!((state.x[0] - 100.0 / 91.0).abs() < 1e-14 && state.x[1] == 0.0);
    assert_eq!((state.t, found.path.len(), found.wasted_iterations), (2.0, 1, 0));
    assert!(found.iterations() <= 3, "{}", found.iterations());
}

#[test]
fn hardening_spring_above_the_critical_spin_is_reached_by_continuation() {
    let mut arm = Arm::new(30.0, 100.0, None);
    arm.sideways = 1e4;
    arm.cubic = 1e5;
    let found = steady(&mut arm, 0.0).unwrap();
    let x = found.state().unwrap().x[0];
    let force = 100.0 * (x - 1.0) + 1e5 * (x - 1.0).powi(3);
    assert!((force - 900.0 * x).abs() < 1e-9 * force && x > 1.0, "{x}");
    assert_eq!(found.path.last().unwrap().scale, 1.0);
    assert!(found.path.len() > 1 && found.wasted_iterations > 0, "{found:?}");
}

#[test]
fn rod_holds_the_mass_where_stiffness_alone_is_singular() {
    // Along the arm there is the rod only, sideways 50 N/m: without spin K has a zero row.
    for spin in [0.0, 2.0] {
        let mut arm = Arm::new(spin, 0.0, Some(1.0));
        arm.sideways = 50.0;
        arm.push = 5.0;
        let found = steady(&mut arm, 0.0).unwrap();
        let state = found.state().unwrap();
        // The rod carries the centrifugal force, which therefore does not push sideways.
        assert!((state.lambda[0] - spin * spin).abs() < 1e-12, "{state:?}");
        assert!((state.x[1] - 0.1).abs() < 1e-14 && (state.x[0] - 0.99_f64.sqrt()).abs() < 1e-14);
    }
}

fn reason(arm: &mut Arm) -> (String, Option<String>) {
    let error = steady(arm, 1.0).unwrap_err();
    assert!(error.t == 1.0 && error.to_string().contains("no relative equilibrium"));
    match error.kind {
        SolveErrorKind::NoEquilibrium(text) => (text, error.worst),
        other => panic!("{other:?}"),
    }
}

#[test]
fn refusals_say_why() {
    let mut arm = Arm::new(3.0, 100.0, None);
    arm.obstacle = Some("gravity turns in the frame of body arm".into());
    assert_eq!(reason(&mut arm).0, "gravity turns in the frame of body arm");
    arm.referenced = false;
    assert!(reason(&mut arm).0.contains("rncf"));
    let (text, worst) = reason(&mut Arm::new(0.0, 0.0, None));
    assert!(
        text.contains("singular") && worst == Some("mass, x".into()),
        "{text} {worst:?}"
    );
    let mut arm = Arm::new(3.0, 100.0, None);
    arm.push = f64::NAN;
    assert!(reason(&mut arm).0.contains("not finite"));
}
