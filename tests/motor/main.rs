//! The high-speed motor of THEORY 9.3: what its waves are, and which shafts are unstable.

mod balanced;
mod steps;
mod waves;

use rncf::equilibrium::Uniform;
use rncf::modes::{Mode, Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, Stop, steady};
use rncf_models::Motor;

/// rad/s of one revolution a minute.
pub const RPM: f64 = std::f64::consts::PI / 30.0;

/// A scene in referenced coordinates.
fn scene(model: &Motor) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

/// The relative equilibrium behind the run-up, and the modes of small motions about it, ascending frequencies.
fn equilibrium(model: &Motor, scene: &mut dyn Scene) -> (State, Vec<Mode>) {
    let at = Uniform::steady(2.0 * model.T_s);
    let state = steady(scene, at.t).unwrap().state().unwrap().clone();
    let modes = modes(scene, &at, &state, Wanted { count: 4 }).unwrap();
    (state, modes)
}

/// Times and the outputs `v_mid`, `w_mid` on an even grid from `from` to `end` (s), by Radau from a state.
fn history(scene: &mut dyn Scene, start: State, rtol: f64, [from, end, every]: [f64; 3]) -> [Vec<f64>; 3] {
    let options = Options {
        rtol,
        ..Options::default()
    };
    let columns = scene.output_columns();
    let mut integrator = Integrator::new(scene, start, end, Method::Radau, options).unwrap();
    let (mut rows, mut row, mut state) = ([vec![], vec![], vec![]], vec![0.0; columns], integrator.state().clone());
    loop {
        let stop = integrator.step().unwrap();
        loop {
            let t = from + every * rows[0].len() as f64;
            if t > integrator.state().t {
                break;
            }
            integrator.interpolate(t, &mut state);
            integrator.system().outputs(&state, &mut row);
            for (column, value) in rows.iter_mut().zip([t, row[0], row[1]]) {
                column.push(value);
            }
        }
        if stop == Stop::End && integrator.state().t >= end * (1.0 - 1e-12) {
            return rows;
        }
    }
}
