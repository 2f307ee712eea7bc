//! Scenes of many rigid bodies: their matrices are sparse, and so is what looks for their symmetries.

use rncf::app::{EquilibriumSettings, Judging, RunSettings, modes, run, static_equilibria};

rncf::model! {
    /// Equal masses on equal rods that hang from a point; they begin level.
    pub model Hanging {
        const n = 60;
        const rod = 0.1 m;
        load weight = gravity([0, 0, -9.81] m/s^2);
        for i in 0..n { rigid ball[i] { mass = 1 kg; origin = [(i + 1) * rod, 0 m, 0 m]; } }
        joint root = distance(ball[0], inertial.at([0, 0, 0] m));
        for i in 0..n - 1 { joint link[i] = distance(ball[i], ball[i + 1]); }
        output z = ball[n - 1].z;
        output pull = root.force;
        output energy = total.kinetic_energy + total.gravity_energy;
        run { t_end = 0.2 s; every = 10 ms; }
    }
}

/// `w^2 l / g` of equal masses on equal rods are the zeros of Laguerre's polynomial of their number.
fn laguerre(n: u32, x: f64) -> f64 {
    let (mut last, mut now) = (1.0, 1.0 - x);
    for k in 1..n {
        let k = f64::from(k);
        (last, now) = (now, ((2.0 * k + 1.0 - x) * now - k * last) / (k + 1.0));
    }
    now
}

/// The first zeros, by halving of steps that are far shorter than their distances.
fn zeros(n: u32, count: usize) -> Vec<f64> {
    let (mut found, mut low, step) = (Vec::new(), 0.0, 0.05 / f64::from(n));
    while found.len() < count {
        let high = low + step;
        if laguerre(n, low) * laguerre(n, high) < 0.0 {
            let [mut a, mut b] = [low, high];
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                if laguerre(n, a) * laguerre(n, middle) <= 0.0 {
                    b = middle
                } else {
                    a = middle
                }
            }
            found.push(0.5 * (a + b));
        }
        low = high;
    }
    found
}

#[test]
fn sixty_masses_hang_and_swing_as_laguerre_says() {
    let settings = EquilibriumSettings {
        count: 8,
        ..EquilibriumSettings::default()
    };
    let hanging = static_equilibria(&Hanging {}, &settings).unwrap();
    let last = |name: &str| {
        hanging
            .history
            .column(hanging.history.find(name).unwrap())
            .last()
            .unwrap()
    };
    assert!((last("z") + 6.0).abs() < 1e-9 && (last("pull.z").abs() / (60.0 * 9.81) - 1.0).abs() < 1e-9);
    let found = modes(&Hanging {}, &settings).unwrap().modes;
    // Each in two planes.
    for (place, zero) in zeros(60, 4).into_iter().enumerate() {
        let exact = (zero * 9.81 / 0.1).sqrt();
        for mode in &found[2 * place..2 * place + 2] {
            assert!(
                (mode.im / exact - 1.0).abs() < 1e-9 && mode.re.abs() < 1e-9,
                "{place}: {mode:?} {exact}"
            );
        }
    }
}

#[test]
fn sixty_masses_fall_without_loss() {
    let settings = RunSettings {
        judged: Judging::No,
        ..RunSettings::default()
    };
    let found = run(&Hanging {}, &settings).unwrap();
    let energy: Vec<f64> = found.history.column(found.history.find("energy").unwrap()).collect();
    let weight = 60.0 * 9.81 * 3.0;
    assert!(
        energy.iter().all(|now| (now - energy[0]).abs() < 1e-6 * weight),
        "{energy:?}"
    );
    // All that begins level falls freely at the far end.
    let z = found.history.column(found.history.find("z").unwrap()).last().unwrap();
    assert!((z / (-0.5 * 9.81 * 0.04) - 1.0).abs() < 1e-5, "{z}");
}

/// Times of one thread; run with `--release --ignored --nocapture`, and with more masses by `n`.
#[test]
#[ignore = "a measurement"]
fn time_of_many_bodies() {
    let settings = EquilibriumSettings::default();
    let time = |what: &str, work: &dyn Fn()| {
        let start = std::time::Instant::now();
        work();
        println!("{what:>8} {:.3} s", start.elapsed().as_secs_f64());
    };
    time("static", &|| drop(static_equilibria(&Hanging {}, &settings).unwrap()));
    time("modes", &|| drop(modes(&Hanging {}, &settings).unwrap()));
    let settings = RunSettings {
        judged: Judging::No,
        t_end: Some(0.5),
        ..RunSettings::default()
    };
    time("run", &|| drop(run(&Hanging {}, &settings).unwrap()));
}

mod links {
    rncf::model! {
        /// Equal bars on hinges in a plane that begin level, and hang on one end.
        pub model Links {
            const n = 60;
            load weight = gravity([0, 0, -9.81] m/s^2);
            for i in 0..n {
                rigid link[i] { plane zx; mass = 1 kg; inertia = 8.333333333333333e-4 kg*m^2; origin = [(i + 0.5) * 0.1 m, 0 m, 0 m]; }
            }
            joint root = revolute(link[0].at([-0.05, 0, 0] m), inertial);
            for i in 0..n - 1 {
                joint hinge[i] = revolute(link[i].at([0.05, 0, 0] m), link[i + 1].at([-0.05, 0, 0] m));
            }
            output z = link[n - 1].z;
            output pull = root.force;
        }
    }
}

/// What has far to fall is followed until it hangs: "a force along a motion that nothing ties is not balanced" from 40 bars on.
#[test]
fn sixty_bars_fall_until_they_hang() {
    let found = static_equilibria(&links::Links {}, &EquilibriumSettings::default()).unwrap();
    let last = |name: &str| {
        let column = found.history.find(name).unwrap();
        found.history.column(column).last().unwrap()
    };
    assert!((last("z") + 5.95).abs() < 1e-9 && (last("pull.z").abs() / (60.0 * 9.81) - 1.0).abs() < 1e-9);
}
