//! A balanced shaft (THEORY 10, T5): internal damping bends it above its critical speed, slowly and without end until
//! the axial restraint holds it.

use super::{RPM, equilibrium, history, scene};
use rncf::{Scene, State};
use rncf_models::Motor;
use rncf_reference::fit::{growth, strongest};

/// The motor behind its run-up, without unbalance.
fn balanced(rpm: f64, damping: f64) -> Motor {
    Motor {
        speed: rpm * RPM,
        T_s: 0.1,
        damping,
        eccentricity: 0.0,
        ..Motor::default()
    }
}

/// The straight equilibrium, displaced along the real part of a mode until the shaft's middle is `size` (m) off the
/// axis, at rest in the frame: whatever motions belong to that.
fn displaced(scene: &mut dyn Scene, straight: &State, shape: &[[f64; 2]], size: f64) -> State {
    let mut outputs = vec![0.0; scene.output_columns()];
    let mut at = |factor: f64| {
        let mut state = straight.clone();
        for (x, [re, _]) in state.x.iter_mut().zip(shape) {
            *x += factor * re;
        }
        scene.outputs(&state, &mut outputs);
        (outputs[0].hypot(outputs[1]), state)
    };
    let (unit, _) = at(1e-6);
    at(1e-6 * size / unit).1
}

/// Deflection of 1 um about the straight shaft: decay below 17240 rpm and growth above, at the rates of the linearised
/// motion and with the signs of THEORY 10 (its rates are those of another damping law).
#[test]
fn damping_bends_a_balanced_shaft_above_its_critical_speed() {
    for (rpm, sign) in [
        (15000.0, -1.0),
        (17000.0, -1.0),
        (17500.0, 1.0),
        (20000.0, 1.0),
        (25000.0, 1.0),
    ] {
        let model = balanced(rpm, 1e-6);
        let mut scene = scene(&model);
        let (straight, modes) = equilibrium(&model, scene.as_mut());
        let mode = &modes[0];
        let start = displaced(scene.as_mut(), &straight, &mode.shape, 1e-6);
        let begin = start.t;
        let [t, v, _] = history(scene.as_mut(), start, 1e-11, [begin + 1.0, begin + 4.0, 1e-3]);
        let wave = strongest(&t, &v);
        let rate = growth(&t, &v, wave.frequency);
        println!(
            "{rpm} rpm: {wave}, {rate:.4} 1/s; linear {:.4} rad/s, {:.4} 1/s",
            mode.im, mode.re
        );
        assert!(mode.re * sign > 0.0, "{rpm} rpm: {}", mode.re);
        assert!(
            (rate - mode.re).abs() < 0.02 * mode.re.abs() + 1e-3,
            "{rpm} rpm: {rate} {}",
            mode.re
        );
        assert!((wave.frequency / mode.im - 1.0).abs() < 2e-3, "{rpm} rpm: {wave:?}");
    }
}
