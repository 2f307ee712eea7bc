//! Equilibria at rest, and the small vibrations about them: as modes, and as motions in time.

use rncf::equilibrium::{Uniform, static_load};
use rncf::modes::{Mode, Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Options, Scene, State, Stop};

use super::run::{Columns, Maker, by_output};
use super::tree::{Kind, Tree};

/// Modes that are compared.
const MODES: usize = 4;
/// Amplitude of the vibrations, relative to the sizes of the unknowns.
const AMPLITUDE: f64 = 1e-4;
/// Part of a period over which a vibration is followed, and the longest time, s.
const PERIODS: f64 = 0.3;
const LONGEST: f64 = 0.5;

/// The scene without what depends on time: its text stays.
pub fn still(tree: &Tree) -> Tree {
    use super::tree::Load;
    let mut tree = tree.clone();
    for frame in &mut tree.frames {
        match &mut frame.kind {
            Kind::Rotating { rate, .. } | Kind::Moving { rate, .. } => *rate = f64::MIN_POSITIVE,
            Kind::Free | Kind::Rigid { .. } => {}
        }
    }
    for joint in &mut tree.joints {
        if let Some([_, rate]) = &mut joint.drive {
            *rate = f64::MIN_POSITIVE;
        }
    }
    for load in &mut tree.loads {
        if let Load::Force { rate, .. } | Load::Moment { rate, .. } = load
            && *rate != 0.0
        {
            *rate = f64::MIN_POSITIVE;
        }
    }
    tree
}

/// An equilibrium and its lowest modes.
pub struct Rest {
    /// Outputs, as in a history.
    pub row: Vec<[f64; 3]>,
    /// Growth and angular frequency.
    pub pairs: Vec<[f64; 2]>,
    /// Of the first mode that oscillates: displacement in time against that of the mode, relative to the latter.
    pub vibration: Option<f64>,
}

/// Equilibrium at rest, modes, and where `positions` are given the vibration in time of one of them.
///
/// # Errors
/// What the program says.
pub fn rest(
    maker: Maker,
    columns: &Columns,
    values: &[f64],
    (formulation, joints): (Formulation, Joints),
    positions: &[usize],
) -> Result<Rest, String> {
    let mut scene = maker(values, formulation, joints)?;
    let scene = scene.as_mut();
    let at = Uniform::at_rest(0.0);
    let found = static_load(scene, 0.0).map_err(|error| error.to_string())?;
    let state = found.state().ok_or("no state")?.clone();
    let mut flat = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&at, &state, &mut flat);
    let row = by_output(columns, &flat);
    let found = modes(scene, &at, &state, Wanted { count: MODES }).map_err(|error| error.to_string())?;
    let slow = found.iter().find(|mode| mode.im > 1.0 && mode.re.abs() < 0.1 * mode.im);
    let vibration = match (slow, positions.is_empty()) {
        (Some(mode), false) => Some(in_time(scene, &state, mode, columns, positions)?),
        _ => None,
    };
    let pairs = found.iter().map(|mode| [mode.re, mode.im]).collect();
    Ok(Rest { row, pairs, vibration })
}

/// The equilibrium displaced by the mode at time `t`.
fn displaced(scene: &dyn Scene, rest: &State, mode: &Mode, t: f64) -> State {
    let mut state = rest.clone();
    state.t = t;
    state.v.fill(0.0);
    state.a.fill(0.0);
    state.rebase(scene.turns());
    let (growth, (sin, cos)) = ((mode.re * t).exp() * AMPLITUDE, (mode.im * t).sin_cos());
    let phase = [growth * cos, growth * sin];
    for (k, [re, im]) in mode.shape.iter().enumerate() {
        let now = [re * phase[0] - im * phase[1], re * phase[1] + im * phase[0]];
        state.x[k] += now[0];
        state.v[k] += mode.re * now[0] - mode.im * now[1];
    }
    state
}

/// How far the vibration in time is from the mode's, relative to it.
fn in_time(
    scene: &mut dyn Scene,
    rest: &State,
    mode: &Mode,
    columns: &Columns,
    positions: &[usize],
) -> Result<f64, String> {
    let t = (PERIODS * std::f64::consts::TAU / mode.im).min(LONGEST);
    let (start, expected) = (displaced(scene, rest, mode, 0.0), displaced(scene, rest, mode, t));
    let mut flat = vec![0.0; scene.output_columns()];
    let mut seen = |scene: &mut dyn Scene, state: &State| {
        scene.outputs(state, &mut flat);
        let row = by_output(columns, &flat);
        positions.iter().map(|index| row[*index]).collect::<Vec<_>>()
    };
    let (origin, expected) = (seen(&mut *scene, rest), seen(&mut *scene, &expected));
    let begun = seen(&mut *scene, &start);
    let options = Options {
        rtol: 1e-8,
        ..Options::default()
    };
    let last = {
        let mut integrator =
            Integrator::new(&mut *scene, start, t, Method::Radau, options).map_err(|error| error.to_string())?;
        while integrator.step().map_err(|error| error.to_string())? != Stop::End {
            if integrator.statistics().steps > 2000 {
                return Err("more than 2000 steps of a small vibration".to_string());
            }
        }
        integrator.state().clone()
    };
    let last = seen(&mut *scene, &last);
    let most = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    Ok(most(&last, &expected) / most(&expected, &origin).max(most(&begun, &origin)))
}
