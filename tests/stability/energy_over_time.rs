//! T12 of THEORY 10: what methods take from the energy over long times.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, StepSize, Stop};

use crate::agrees;

rncf::model! {
    /// A mass on a spring, swinging along it: a linear oscillator.
    pub model Oscillator {
        /// Angular frequency.
        param omega = 10 rad/s;
        rigid bob { plane xy; mass = 1 kg; origin = [2.1, 0, 0] m; }
        spring coil = linear(bob, inertial.at([0, 0, 0] m), stiffness = 1 kg * omega^2, length = 2 m);
        output x = bob.x;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A mass on a spring under gravity, swinging sideways and along the spring.
    pub model ElasticPendulum {
        /// Stiffness of the spring.
        param stiffness = 400 N/m;
        /// Length of the spring at the start.
        param length = 1 m;
        rigid bob { plane xy; mass = 1 kg; origin = [length, 0, 0]; }
        spring cord = linear(bob, inertial.at([0, 0, 0] m), stiffness = stiffness, length = 1 m);
        load weight = gravity([0, -9.81, 0] m/s^2);
        /// Length of the spring beyond that without force.
        output stretch = norm(bob.position) - 1 m;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

const OMEGA: f64 = 10.0;

/// Energies (J) and first output (m) after every step of size `h`, s.
fn energies(model: &impl Model, method: Method, h: f64, steps: u32) -> Vec<[f64; 2]> {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let options = Options {
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let mut integrator = Integrator::new(scene.as_mut(), rest, h * f64::from(steps), method, options).unwrap();
    let (mut found, mut row) = (Vec::new(), vec![0.0]);
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        integrator.system().outputs(&state, &mut row);
        found.push([integrator.system().energy(&state).unwrap(), row[0]]);
        if stop == Stop::End {
            return found;
        }
    }
}

/// Damping ratio of THEORY 10, to leading order in omega h.
fn predicted(method: Method, wh: f64) -> f64 {
    let factor = match method {
        Method::Hht { alpha } => -alpha * (1.0 + alpha) * (1.0 + alpha) / 8.0,
        Method::GeneralizedAlpha { rho_inf } => 0.5 * ((1.0 - rho_inf) / (1.0 + rho_inf)).powi(3),
        other => panic!("{other:?} has another law"),
    };
    factor * wh.powi(3)
}

/// Damping ratio seen: E ~ exp(-2 zeta omega t), between means over the first and the last ten periods.
fn damping(method: Method, wh: f64) -> f64 {
    let window = (20.0 * std::f64::consts::PI / wh).round() as usize;
    let steps = 10 * window;
    let found = energies(&Oscillator { omega: OMEGA }, method, wh / OMEGA, steps as u32);
    let mean = |part: &[[f64; 2]]| part.iter().map(|row| row[0]).sum::<f64>() / part.len() as f64;
    let (first, last) = (mean(&found[..window]), mean(&found[steps - window..]));
    (first / last).ln() / (2.0 * wh * (steps - window) as f64)
}

#[test]
fn damping_follows_the_cube_of_the_step() {
    let methods = [
        (Method::Hht { alpha: -0.3 }, [1.432e-4, 1.825e-5]),
        (Method::GeneralizedAlpha { rho_inf: 0.5 }, [1.443e-4, 1.840e-5]),
        (Method::Hht { alpha: -0.05 }, [4.415e-5, 5.610e-6]),
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, [5.422e-6, 6.838e-7]),
        (Method::GeneralizedAlpha { rho_inf: 0.9 }, [5.771e-7, 7.270e-8]),
    ];
    let mut ratios = Vec::new();
    for (method, printed) in methods {
        let found = [0.2, 0.1].map(|wh| damping(method, wh));
        let slope = (found[0] / found[1]).log2();
        let near = [found[0] / predicted(method, 0.2), found[1] / predicted(method, 0.1)];
        println!(
            "{method:?}: zeta {:.3e}, {:.3e}; of the prediction {near:.4?}; slope {slope:.3}",
            found[0], found[1]
        );
        agrees(found[0], printed[0], 0.01);
        agrees(found[1], printed[1], 0.01);
        assert!((2.95..3.0).contains(&slope), "{slope}");
        assert!((near[1] - 1.0).abs() < 0.02, "{near:?}");
        ratios.push(found[1]);
    }
    let (equal, factor) = (ratios[0] / ratios[1], ratios[2] / ratios[4]);
    println!("HHT -0.3 damps {equal:.3} times as much as rho 0.5, HHT -0.05 {factor:.1} times as much as rho 0.9");
    assert!((0.98..1.02).contains(&equal));
    assert!((75.0..79.0).contains(&factor));
}

/// Largest energies (J) in the quarters of 1e5 steps. The pendulum starts with none; 9.81 J turn from potential to kinetic.
fn quarters(method: Method) -> Vec<f64> {
    let most = |rows: &[[f64; 2]]| rows.iter().fold(0.0_f64, |most, row| most.max(row[0].abs()));
    let found = energies(&ElasticPendulum::default(), method, 5e-3, 100_000);
    let quarters: Vec<f64> = found.chunks(25_000).map(most).collect();
    println!("{method:?}: off by {} J", crate::short(&quarters));
    quarters
}

#[test]
fn energy_stays_bounded_over_1e5_steps() {
    for rho_inf in [1.0, 0.9] {
        let found = quarters(Method::GeneralizedAlpha { rho_inf });
        agrees(found[0], 1.7e-3, 0.1);
        assert!((found[3] / found[0] - 1.0).abs() < 0.03, "no trend");
    }
}

#[test]
fn hht_loses_energy_over_1e5_steps() {
    let found = quarters(Method::Hht { alpha: -0.05 });
    // It loses all the time.
    for (found, printed) in found.iter().zip([3.2e-3, 4.4e-3, 5.5e-3, 6.8e-3]) {
        agrees(*found, printed, 0.1);
    }
}

#[test]
fn without_dissipation_what_steps_do_not_resolve_never_calms_down() {
    // The spring swings three times in a step, and starts with 400 N.
    let model = ElasticPendulum {
        stiffness: 4e6,
        length: 1.0001,
    };
    let noise = |method| {
        let found = energies(&model, method, 0.01, 3000);
        let late = &found[2000..];
        late.windows(2)
            .fold(0.0_f64, |most, pair| most.max((pair[1][1] - pair[0][1]).abs()))
            * 4e6
    };
    let undamped = noise(Method::GeneralizedAlpha { rho_inf: 1.0 });
    for method in [
        Method::GeneralizedAlpha { rho_inf: 0.8 },
        Method::Hht { alpha: -0.05 },
        Method::Radau,
    ] {
        let calm = noise(method);
        println!("{method:?}: the spring's force jumps by {calm:.2} N from step to step; undamped {undamped:.1} N");
        agrees(undamped, 806.0, 0.05);
        agrees(calm, 0.81, 0.05);
    }
}
