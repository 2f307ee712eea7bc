//! T4 of THEORY 10: absolute coordinates follow every turn, so that their steps shrink with the spin; in a frame that
//! turns with the body only the deformation is left to follow.

use rncf::{Formulation, Joints, Method, Model, Options, StepSize};
use rncf_models::SpinUp;

use crate::agrees;
use crate::scenes::{outputs, run};

/// Half of the run-up.
const END: f64 = 7.5;

/// Accepted steps and evaluations of the residual.
fn counts(formulation: Formulation, omega_s: f64) -> [u64; 2] {
    let model = SpinUp {
        omega_s,
        ..SpinUp::default()
    };
    let mut scene = model.build(formulation, Joints::Eliminated).unwrap();
    let options = Options {
        rtol: 1e-7,
        ..Options::default()
    };
    let start = scene.rest(0.0);
    let (_, found) = run(scene.as_mut(), start, END, Method::Hht { alpha: -0.3 }, options).unwrap();
    [found.steps, found.residual_evaluations]
}

#[test]
fn steps_shrink_with_the_spin_in_absolute_coordinates_alone() {
    let [rncf, ancf] = [Formulation::Rncf, Formulation::Ancf].map(|formulation| {
        let found = [4.0, 40.0].map(|omega_s| counts(formulation, omega_s));
        println!("{formulation:?}: steps and residuals at 4 and 40 rad/s {found:?}");
        found
    });
    for (found, printed) in [(rncf, [[194, 488], [534, 1456]]), (ancf, [[638, 2396], [4729, 14255]])] {
        for (found, printed) in found.as_flattened().iter().zip(printed.as_flattened()) {
            agrees(*found as f64, f64::from(*printed), 0.2);
        }
    }
    for count in [0, 1] {
        let ratio = |slow: [u64; 2], fast: [u64; 2]| fast[count] as f64 / slow[count] as f64;
        let (ours, theirs) = (ratio(rncf[0], rncf[1]), ratio(ancf[0], ancf[1]));
        let [gain, gain_fast] = [0, 1].map(|spin: usize| ratio(rncf[spin], ancf[spin]));
        println!("grows {ours:.2} and {theirs:.2} times; absolute over referenced {gain:.1}, {gain_fast:.1}");
        assert!(theirs > 5.0, "absolute coordinates: {theirs}");
        assert!(ours < 0.6 * theirs && gain_fast > 1.5 * gain);
    }
}

rncf::model! {
    /// A rod of 1 kg, 1 m and EI = 32 N m^2, hardly stretched, that a hub brings to 10 rad/s within a second.
    pub model Rod {
        const axial = 1000 MN;
        const area = 1 m^2;
        motion theta(t) =
            if t <= 1 s { 10 [rad/s] / 1 [s] * (t^2/2 + (1 [s]/(2*pi))^2 * (cos(2*pi*t/1 [s]) - 1)) }
            else { 10 [rad/s] * (t - 0.5 s) };
        frame hub = rotating(axis = z, angle = theta(t));
        material any { density = 1 kg/m^3; young = axial / area; }
        section thin { area = area; second_moment = 32 [N*m^2] * area / axial; }
        body rod in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 6 * cable(thin, any);
        }
        joint root = clamp(rod.start, hub);
        output v = rod.end.y;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

/// Two cells of the map in docs/stability.md: a chord of a turn would stretch the rod, and Newton's method does not find
/// back; in the frame there is no turn.
#[test]
fn long_steps_of_a_stiff_rod_fail_in_absolute_coordinates() {
    let tip = |formulation: Formulation, method: Method, rtol: f64, step: StepSize| {
        let mut scene = Rod::default().build(formulation, Joints::Eliminated).unwrap();
        let options = Options {
            rtol,
            step,
            ..Options::default()
        };
        let start = scene.rest(0.0);
        run(scene.as_mut(), start, 2.0, method, options).map(|(state, _)| outputs(scene.as_mut(), &state)[0])
    };
    let exact = tip(Formulation::Rncf, Method::Radau, 1e-9, StepSize::Adaptive).unwrap();
    for (method, h, off) in [
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, 0.0631, 0.1),
        (Method::Radau, 4e-3, 0.01),
    ] {
        let [ours, absolute] = [Formulation::Rncf, Formulation::Ancf]
            .map(|formulation| tip(formulation, method, 1e-8, StepSize::Fixed(h)));
        println!("{method:?}, h = {h} s: exact {exact:.5e} m, referenced {ours:?} m, absolute {absolute:?}");
        assert!((ours.unwrap() - exact).abs() < off * 0.03);
        assert!(absolute.is_err());
    }
}
