//! What holds whatever the accuracy: the same bits, kinks as step boundaries, energy.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, Stop};
use rncf_models::{Esail, SpinUp};

use crate::models::{Conservative, Hanging};
use crate::runs::{WAYS, adaptive, fixed, grid, history, orders, short, states_at};

const METHODS: [Method; 3] = [
    Method::Hht { alpha: -0.3 },
    Method::GeneralizedAlpha { rho_inf: 0.8 },
    Method::Radau,
];

/// Repeated bodies, loads per length and a free frame: elements of all bodies are evaluated together, and so many that their
/// derivatives are shared out.
#[test]
fn threads_do_not_change_a_bit() {
    let model = Esail {
        tethers: 100,
        elements: 9,
        ..Esail::default()
    };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
            let start = scene.rest(0.0);
            let (states, _) = states_at(scene.as_mut(), start, METHODS[1], fixed(1.0), &[3.0]);
            let State { x, v, a, lambda, .. } = &states[0];
            let bits = [x, v, a, lambda].into_iter().flatten().map(|value| value.to_bits());
            bits.collect::<Vec<u64>>()
        })
    };
    let one = with(1);
    assert!(one.len() > 3 * 5000 && one.iter().filter(|&&bits| bits != 0).count() > 3 * 5000);
    assert!(one == with(2), "two threads");
    assert!(one == with(1), "again");
}

#[test]
fn end_of_the_run_up_is_a_step_boundary() {
    for way in WAYS {
        for method in METHODS {
            for options in [adaptive(1e-4), fixed(0.013)] {
                // So slow that a start at speed but undeformed is no blow.
                let slow = SpinUp {
                    omega_s: 0.1,
                    ..SpinUp::default()
                };
                let mut scene = slow.build(way.0, way.1).unwrap();
                assert_eq!(scene.kinks(), [15.0]);
                let start = scene.rest(14.5);
                let mut integrator = Integrator::new(scene.as_mut(), start, 15.5, method, options).unwrap();
                let mut kinks = vec![];
                loop {
                    match integrator.step().unwrap() {
                        Stop::Step => {}
                        Stop::Kink => kinks.push(integrator.state().t),
                        Stop::End => break,
                    }
                }
                assert_eq!(kinks, [15.0_f64.next_down()], "{way:?} {method:?}");
                assert_eq!(integrator.statistics().restarts, 1, "{way:?} {method:?}");
            }
        }
    }
    // The whole manoeuvre passes it once.
    let (_, statistics) = history(
        &SpinUp::default(),
        WAYS[0],
        Method::Radau,
        adaptive(1e-4),
        &grid(0.1, 20.0),
    );
    assert_eq!(statistics.restarts, 1);
}

/// The undamped cable, whose energy is known.
fn conservative(way: (Formulation, Joints)) -> Box<dyn Scene> {
    Conservative::default().build(way.0, way.1).unwrap()
}

/// Energy of the undamped cable at the states of a run, relative to its swing.
fn energies(states: &[State], way: (Formulation, Joints)) -> Vec<f64> {
    // Weight times length: what a fall of the whole cable by its length would give.
    let swing = 1000.0 * 2e-4 * 1.5 * 9.81 * 1.5;
    let mut scene = conservative(way);
    states
        .iter()
        .map(|state| scene.energy(state).expect("nothing dissipates or drives") / swing)
        .collect()
}

fn swing(model: &impl Model, way: (Formulation, Joints), method: Method, options: Options) -> Vec<State> {
    let mut scene = model.build(way.0, way.1).unwrap();
    let start = scene.rest(0.0);
    states_at(scene.as_mut(), start, method, options, &grid(0.05, 1.0)).0
}

/// Largest change of the energy.
fn drift(energies: &[f64]) -> f64 {
    energies
        .iter()
        .map(|energy| (energy - energies[0]).abs())
        .fold(0.0, f64::max)
}

#[test]
fn free_swing_conserves_its_energy_to_the_order() {
    for way in WAYS {
        let steps = [0.01, 0.005, 0.0025, 0.00125];
        let drifts = steps.map(|h| {
            drift(&energies(
                &swing(&Conservative::default(), way, Method::Radau, fixed(h)),
                way,
            ))
        });
        let observed = orders(&drifts);
        println!("{way:?}: energy drifts {}, orders {observed:.2?}", short(&drifts));
        assert!(observed.iter().all(|order| *order > 4.7), "{way:?}: {observed:?}");
        let rtols = [1e-5, 1e-7, 1e-9];
        let drifts = rtols.map(|rtol| {
            drift(&energies(
                &swing(&Conservative::default(), way, Method::Radau, adaptive(rtol)),
                way,
            ))
        });
        println!("{way:?}: energy drifts with rtol 1e-5, 1e-7, 1e-9: {}", short(&drifts));
        for (drift, rtol) in drifts.into_iter().zip(rtols) {
            assert!(drift < 0.1 * rtol, "{way:?}: {drift}");
        }
    }
}

#[test]
fn damping_dissipates() {
    for way in WAYS {
        let damped = Hanging {
            damping: 0.01,
            ..Hanging::default()
        };
        // The model itself makes no promise about its energy.
        let mut scene = damped.build(way.0, way.1).unwrap();
        let start = scene.rest(0.0);
        assert!(scene.energy(&start).is_none());
        let [free, lossy] = [Hanging::default(), damped].map(|model| {
            let states = swing(&model, way, Method::Radau, adaptive(1e-9));
            let energies = energies(&states, way);
            let rise = energies
                .windows(2)
                .map(|pair| pair[1] - pair[0])
                .fold(f64::MIN, f64::max);
            (energies[0] - energies[energies.len() - 1], rise)
        });
        println!(
            "{way:?}: energy lost in 1 s without damping {:.1e}, with damping {:.1e}, least loss in 0.05 s {:.1e}",
            free.0, lossy.0, -lossy.1
        );
        assert!(
            free.0.abs() < 1e-10 && lossy.0 > 1e-3 && lossy.1 < 0.0,
            "{free:?} {lossy:?}"
        );
    }
}
