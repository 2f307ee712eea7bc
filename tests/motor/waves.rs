//! The waves behind the run-up are free oscillations about the bent, unbalanced equilibrium: frequency and decay.

use super::{RPM, equilibrium, history, scene};
use rncf_models::Motor;
use rncf_reference::fit::{growth, strongest};

/// Speed (rpm), time of the run-up (s), lowest frequency (rad/s) and, with damping 1e-6 s, largest real part (1/s) of
/// THEORY 9.3. Below 15000 rpm a run-up of 1 s leaves no waves at all.
const TABLE: [(f64, f64, f64, f64); 6] = [
    (10000.0, 0.1, 761.0, -0.684),
    (12500.0, 0.1, 506.0, -0.455),
    (15000.0, 1.0, 282.0, -0.254),
    (16000.0, 1.0, 230.0, -0.210),
    (17500.0, 1.0, 214.0, -0.216),
    (20000.0, 1.0, 235.0, -0.288),
];

/// The waves over 1.5 s behind the run-up, without and with damping: no frequency is put in, and both are compared with
/// the linearised motion.
#[test]
fn waves_are_free_oscillations_about_the_bent_shaft() {
    for (rpm, run_up, frequency, decay) in TABLE {
        for damping in [0.0, 1e-6] {
            let model = Motor {
                speed: rpm * RPM,
                T_s: run_up,
                damping,
                ..Motor::default()
            };
            let mut scene = scene(&model);
            let (state, modes) = equilibrium(&model, scene.as_mut());
            let mut bent = vec![0.0; scene.output_columns()];
            scene.outputs(&state, &mut bent);
            let start = scene.rest(0.0);
            let [t, v, _] = history(scene.as_mut(), start, 1e-11, [run_up, run_up + 1.5, 5e-4]);
            let wave = strongest(&t, &v);
            let rate = growth(&t, &v, wave.frequency);
            println!(
                "{rpm} rpm, T_s = {run_up} s, c = {damping} s: {wave}, {rate:.4} 1/s; linear {:.4} rad/s, {:.4} 1/s, v = {:.6e} m",
                modes[0].im, modes[0].re, bent[0]
            );
            assert!((modes[0].im - frequency).abs() < 0.51, "{rpm} rpm: {}", modes[0].im);
            assert!((wave.frequency / modes[0].im - 1.0).abs() < 1e-5, "{rpm} rpm: {wave:?}");
            assert!((wave.mean / bent[0] - 1.0).abs() < 1e-5, "{rpm} rpm: {wave:?}");
            let expected = if damping > 0.0 { decay } else { 0.0 };
            assert!((modes[0].re - expected).abs() < 5.1e-4, "{rpm} rpm: {}", modes[0].re);
            assert!((rate - modes[0].re).abs() < 1e-3, "{rpm} rpm: {rate}");
        }
    }
}

/// The faster the run-up, the higher the waves; their mean then sinks, as the shaft hardens.
#[test]
fn waves_grow_with_a_faster_run_up() {
    let mut before = 0.0;
    for run_up in [1.0, 0.5, 0.2, 0.1] {
        let model = Motor {
            speed: 15000.0 * RPM,
            T_s: run_up,
            ..Motor::default()
        };
        let mut scene = scene(&model);
        let start = scene.rest(0.0);
        let [t, v, _] = history(scene.as_mut(), start, 1e-10, [run_up, run_up + 0.5, 5e-4]);
        let wave = strongest(&t, &v);
        println!("15000 rpm, T_s = {run_up} s: {wave}");
        assert!(wave.amplitude > 3.0 * before, "{wave:?} after {before}");
        before = wave.amplitude;
    }
    assert!(before > 2e-4, "{before}");
}
