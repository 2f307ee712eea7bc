//! A small model written by hand for the tests: a mass on an isotropic spring in a frame that
//! turns at a constant rate; its spring may fail at a given time.

use std::path::PathBuf;

use crate::equilibrium::Uniform;
use crate::linalg::Pattern;
use crate::model::{ConstantArray, Fidelity, FrameState, KernelCount, Output, Param, ParamKind, RunDefaults};
use crate::system::{ConstraintLevel, Tangent};
use crate::{Caution, Formulation, Joints, Model, ModelError, Scene, State, System, Warning};

/// A folder of this process alone, not yet there.
pub(super) fn temporary_folder(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("rncf-{}-{name}", std::process::id()))
}

#[derive(Clone, Debug)]
pub(super) struct Rotor {
    pub omega: f64,
    pub coils: u32,
    pub stiffness: f64,
    pub loss: f64,
    pub fail_at: f64,
    /// Length of the spring, m; 0: balanced.
    pub length: f64,
}

const LENGTH: f64 = 2.0;
const SECOND: [i8; 6] = [0, 0, 1, 0, 0, 0];
const PARAMS: [Param; 5] = [
    quantity(
        "omega",
        "rad/s",
        [0, 0, -1, 0, 0, 1],
        3.0,
        "Angular velocity of the frame",
    ),
    Param {
        kind: ParamKind::Count,
        ..quantity("coils", "1", [0; 6], 2.0, "Coils in series")
    },
    quantity("stiffness", "N/m", [0, 1, -2, 0, 0, 0], 100.0, "Stiffness of one coil"),
    quantity("loss", "1", [0; 6], 0.01, "Share of critical damping"),
    quantity("fail_at", "s", SECOND, 100.0, "When the spring fails"),
];
const OUTPUTS: [Output; 2] = [
    Output {
        name: "tip",
        unit: "m",
        time_exponent: 0.0,
        components: &["x", "y"],
        doc: "Mass in the frame",
    },
    Output {
        name: "pull",
        unit: "N",
        time_exponent: -2.0,
        components: &[],
        doc: "Force of the spring",
    },
];

const fn quantity(
    name: &'static str,
    unit: &'static str,
    dimension: [i8; 6],
    default: f64,
    doc: &'static str,
) -> Param {
    Param {
        name,
        kind: ParamKind::Quantity,
        unit,
        unit_si: 1.0,
        dimension,
        default,
        doc,
    }
}

impl Default for Rotor {
    fn default() -> Self {
        let [omega, coils, stiffness, loss, fail_at] = PARAMS.map(|param| param.default);
        Self {
            omega,
            coils: coils as u32,
            stiffness,
            loss,
            fail_at,
            length: LENGTH,
        }
    }
}

impl Model for Rotor {
    const NAME: &'static str = "Rotor";
    const DOC: &'static str = "A mass on a spring in a turning frame.";
    const SOURCE: &'static str = "pub model Rotor {\n    param omega = 3 rad/s;  // a < b & c\n}";
    const EQUATIONS_HASH: u64 = 1;
    const NOTES: &'static [&'static str] = &["The spring has no mass."];
    const CONSTANTS: &'static [ConstantArray] = &[];
    const KERNELS: &'static [KernelCount] = &[];

    fn params() -> &'static [Param] {
        &PARAMS
    }

    fn outputs() -> &'static [Output] {
        &OUTPUTS
    }

    fn get(&self, index: usize) -> f64 {
        [
            self.omega,
            f64::from(self.coils),
            self.stiffness,
            self.loss,
            self.fail_at,
        ][index]
    }

    fn set(&mut self, index: usize, value: f64) {
        match index {
            0 => self.omega = value,
            1 => self.coils = value as u32,
            2 => self.stiffness = value,
            3 => self.loss = value,
            _ => self.fail_at = value,
        }
    }

    fn run(&self) -> RunDefaults {
        RunDefaults {
            t_end: 4.0,
            every: 0.05,
            start: crate::Start::Rest,
        }
    }

    fn cautions(&self, t_end: f64) -> Vec<Caution> {
        let mut cautions = Vec::new();
        if self.coils == 7 && t_end < 1.0 {
            cautions.push(Caution {
                name: "touching",
                text: "seven coils touch <each other>",
                outputs: &[0],
            });
            cautions.push(Caution {
                name: "many",
                text: "seven is many",
                outputs: &[],
            });
        }
        cautions
    }

    fn build_as(
        &self,
        formulation: Formulation,
        _: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError> {
        if let [(name, _), ..] = fidelity {
            return Err(ModelError::new(format!("there is no body `{name}`")));
        }
        if self.stiffness <= 0.0 {
            return Err(ModelError::new("parameter `stiffness` must be positive"));
        }
        let stiffness = self.stiffness / f64::from(self.coils);
        Ok(Box::new(RotorScene {
            omega: self.omega,
            stiffness,
            damping: 2.0 * self.loss * stiffness.sqrt(),
            fail_at: self.fail_at,
            length: self.length,
            absolute: formulation == Formulation::Ancf,
            pattern: Pattern::new(2, 2, [(0, 0), (0, 1), (1, 0), (1, 1)]),
            none: Pattern::new(2, 0, []),
        }))
    }
}

/// Mass 1 kg; unknowns in the frame (RNCF) or in absolute axes (ANCF).
struct RotorScene {
    omega: f64,
    stiffness: f64,
    damping: f64,
    fail_at: f64,
    length: f64,
    absolute: bool,
    pattern: Pattern,
    none: Pattern,
}

impl RotorScene {
    /// Position and velocity in the frame of those in absolute axes, or back with `sign` -1.
    fn turned(&self, t: f64, x: &[f64], v: &[f64], sign: f64) -> ([f64; 2], [f64; 2]) {
        let omega = sign * self.omega;
        let (sin, cos) = (omega * t).sin_cos();
        let turn = |a: &[f64]| [cos * a[0] + sin * a[1], cos * a[1] - sin * a[0]];
        (turn(x), turn(&[v[0] + omega * x[1], v[1] - omega * x[0]]))
    }

    fn in_frame(&self, state: &State) -> ([f64; 2], [f64; 2]) {
        if self.absolute {
            self.turned(state.t, &state.x, &state.v, 1.0)
        } else {
            ([state.x[0], state.x[1]], [state.v[0], state.v[1]])
        }
    }

    fn force(&self, x: [f64; 2], v: [f64; 2]) -> [f64; 2] {
        let spring = [self.stiffness * (x[0] - self.length), self.stiffness * x[1]];
        [spring[0] + self.damping * v[0], spring[1] + self.damping * v[1]]
    }
}

impl System for RotorScene {
    fn unknowns(&self) -> usize {
        2
    }

    fn constraints(&self) -> usize {
        0
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn constraint_pattern(&self) -> &Pattern {
        &self.none
    }

    fn mass(&mut self, _: &State, values: &mut [f64]) {
        values.copy_from_slice(&[1.0, 0.0, 0.0, 1.0]);
    }

    fn residual(&mut self, state: &State, out: &mut [f64]) {
        let (t, x, v, a) = (state.t, &state.x[..], &state.v[..], &state.a[..]);
        let w = self.omega;
        if t > self.fail_at {
            out.fill(f64::NAN);
        } else if self.absolute {
            let (p, q) = self.turned(t, x, v, 1.0);
            let (force, _) = self.turned(t, &self.force(p, q), &[0.0; 2], -1.0);
            out.copy_from_slice(&[a[0] + force[0], a[1] + force[1]]);
        } else {
            let force = self.force([x[0], x[1]], [v[0], v[1]]);
            out[0] = a[0] - 2.0 * w * v[1] - w * w * x[0] + force[0];
            out[1] = a[1] + 2.0 * w * v[0] - w * w * x[1] + force[1];
        }
    }

    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        let (k, c, w) = (self.stiffness, self.damping, self.omega);
        out.mass.resize(4, 0.0);
        self.mass(state, &mut out.mass);
        out.stiffness.clear();
        out.damping.clear();
        if self.absolute {
            out.stiffness.extend([k, -c * w, c * w, k]);
            out.damping.extend([c, 0.0, 0.0, c]);
        } else {
            out.stiffness.extend([k - w * w, 0.0, 0.0, k - w * w]);
            out.damping.extend([c, 2.0 * w, -2.0 * w, c]);
        }
    }

    fn constraint(&mut self, _: ConstraintLevel, _: &State, _: &mut [f64]) {}

    fn constraint_jacobian(&mut self, _: &State, _: &mut [f64]) {}

    fn constraint_rate_tangent(&mut self, _: &State, _: &mut [f64]) {}

    fn sizes(&self) -> &[f64] {
        &[LENGTH, LENGTH]
    }

    fn describe_unknown(&self, index: usize) -> String {
        format!("mass, position {}", ["x", "y"][index])
    }

    fn describe_constraint(&self, _: usize) -> String {
        String::new()
    }

    fn kinks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The energy integral of the turning frame, kept where nothing damps.
    fn energy(&mut self, state: &State) -> Option<f64> {
        if self.damping > 0.0 {
            return None;
        }
        let (x, v) = self.in_frame(state);
        let (dx, w) = (x[0] - self.length, self.omega);
        let kinetic = 0.5 * (v[0] * v[0] + v[1] * v[1] - w * w * (x[0] * x[0] + x[1] * x[1]));
        Some(kinetic + 0.5 * self.stiffness * (dx * dx + x[1] * x[1]))
    }
}

impl Scene for RotorScene {
    fn output_columns(&self) -> usize {
        3
    }

    fn outputs(&mut self, state: &State, out: &mut [f64]) {
        let (x, v) = self.in_frame(state);
        let force = self.force(x, v);
        out.copy_from_slice(&[x[0], x[1], force[0].hypot(force[1])]);
    }

    fn rest(&self, t: f64) -> State {
        self.state_of_frame(&FrameState {
            t,
            q: vec![self.length, 0.0],
            v: vec![0.0; 2],
            poses: Vec::new(),
        })
    }

    fn frame_state(&mut self, state: &State) -> FrameState {
        let (q, v) = self.in_frame(state);
        FrameState {
            t: state.t,
            q: q.to_vec(),
            v: v.to_vec(),
            poses: Vec::new(),
        }
    }

    fn state_of_frame(&self, frame: &FrameState) -> State {
        let mut state = State::zeros(frame.t, 2, 0);
        let (x, mut v) = ([frame.q[0], frame.q[1]], [frame.v[0], frame.v[1]]);
        if self.absolute {
            let w = self.omega;
            v = [v[0] - w * x[1], v[1] + w * x[0]];
            let (sin, cos) = (w * frame.t).sin_cos();
            let turn = |a: [f64; 2]| vec![cos * a[0] - sin * a[1], cos * a[1] + sin * a[0]];
            (state.x, state.v) = (turn(x), turn(v));
        } else {
            (state.x, state.v) = (x.to_vec(), v.to_vec());
        }
        state
    }

    fn is_referenced(&self) -> bool {
        !self.absolute
    }

    fn uniform_state(&mut self, at: &Uniform, state: &mut State) {
        state.t = at.t;
        state.v.fill(0.0);
        state.a.fill(0.0);
    }

    fn uniform_residual(&mut self, at: &Uniform, state: &State, out: &mut [f64]) {
        let (w, x) = (at.speed() * self.omega, [state.x[0], state.x[1]]);
        let force = self.force(x, [0.0; 2]);
        out.copy_from_slice(&[force[0] - w * w * x[0], force[1] - w * w * x[1]]);
    }

    fn small_motions(&mut self, at: &Uniform, state: &State, out: &mut Tangent) {
        let w = at.speed() * self.omega;
        let k = self.stiffness - w * w;
        out.mass.resize(4, 0.0);
        self.mass(state, &mut out.mass);
        out.stiffness.clear();
        out.damping.clear();
        out.stiffness.extend([k, 0.0, 0.0, k]);
        out.damping.extend([self.damping, 2.0 * w, -2.0 * w, self.damping]);
    }

    fn uniform_outputs(&mut self, _: &Uniform, state: &State, out: &mut [f64]) {
        self.outputs(state, out);
    }

    fn uniform_obstacle(&mut self, _: &Uniform, _: &State) -> Option<String> {
        None
    }

    /// In the plane z = x + i y; the sense of the spin is that of omega.
    fn circulation(&mut self, at: &Uniform, _: &State, shape: &[[f64; 2]]) -> Option<f64> {
        let ([re1, im1], [re2, im2]) = (shape[0], shape[1]);
        let size = re1 * re1 + im1 * im1 + re2 * re2 + im2 * im2;
        let spin = at.speed() * self.omega;
        (spin != 0.0 && size > 0.0).then(|| 2.0 * (im1 * re2 - re1 * im2) / size * spin.signum())
    }

    fn warnings(&mut self, _: &State) -> Vec<Warning> {
        let soft = 2.0 * self.omega * self.omega > self.stiffness;
        let warning = || Warning {
            text: format!("the spring is soft at {} rad/s", self.omega),
            weight: 1.0,
        };
        soft.then(warning).into_iter().collect()
    }

    fn spin(&self, _: f64) -> f64 {
        self.omega.abs()
    }
}
