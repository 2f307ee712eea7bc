//! Energy-momentum integration: what it keeps to round-off, its order, and what it refuses.

use rncf::{Ancf, Formulation, Integrator, Joints, Method, Model, Options, Scene, SolveError, State, Stop};
use rncf_models::{Bend45, Elastica, FreeFlight, HeavyTop, RightAngleFrame, SpinUp};
use rncf_reference::free_cable::{FreeCable, Kept};
use rncf_reference::integrate::{Method as Explicit, agreed};

use crate::free_flight;
use crate::runs::{adaptive, apart, far, fixed, grid, orders, short, states_at};

rncf::model! {
    /// The cable of THEORY 9.6 with its mass, hung up at one end: a pendulum that stretches and bends.
    model ElasticPendulum {
        /// Number of elements.
        param elements: count = 3;
        /// Initial angular velocity about the vertical.
        param sweep = 1.5 rad/s;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        body cable {
            spatial;
            line from [0, 0, 0] m to [2, 0, 0] m;
            mesh elements * cable(flat, soft);
            initial velocity [0, sweep * x, 0];
        }
        joint top = pin(cable.start, inertial);
        fixture tip on cable.end { mass = 0.7 kg; }
        load weight = gravity([0, 0, -9.81] m/s^2);
        output end = cable.end;
    }
}

rncf::model! {
    /// A soft bow that flies and tumbles in space; its frame is no unknown in absolute coordinates.
    model Tumbling {
        /// Number of elements.
        param elements: count = 2;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; poisson = 0.3; }
        section bar = rectangle(y = 5 cm, z = 3 cm);
        frame f = free(velocity = [-3, 1, 2] m/s, angular_velocity = [2, -1, 1] rad/s);
        body bow in f {
            spatial;
            mean_axes;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius 1.5 m angle 80 deg;
            mesh elements * beam(bar, soft);
        }
        fixture tip on bow.end { mass = 0.7 kg; center = [30, 20, 10] mm; inertia = [1, 1.2, 1.5] g*m^2; }
        output end = bow.end.in(inertial);
    }
}

rncf::model! {
    /// A cable whose material damps.
    model Damped {
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; damping = 1 ms; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        body rope {
            planar xy;
            line from [0, 0, 0] m to [2, 0, 0] m;
            mesh 2 * cable(flat, soft);
        }
        joint top = pin(rope.start, inertial);
        output end = rope.end;
    }
}

rncf::model! {
    /// The same in its plane, clamped, with a force at its end.
    model Clamped {
        /// Number of elements.
        param elements: count = 3;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        body cable {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius 1.5 m angle 1 rad;
            mesh elements * cable(flat, soft);
        }
        joint wall = clamp(cable.start, inertial);
        fixture tip on cable.end { mass = 0.7 kg; offset = 5 cm; gyration = 3 cm; }
        load pull = force(cable.end, [0.5, -2, 0] N);
        output end = cable.end;
    }
}

/// Energy with what gravity and loads add, momentum and angular momentum of a state.
struct Watched<'c> {
    cable: &'c FreeCable,
    /// Of the start.
    first: Kept,
}

fn size(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Runs to the end; for every step what `look` sees of the state.
fn run<T>(
    scene: &mut dyn Scene,
    options: Options,
    method: Method,
    end: f64,
    mut look: impl FnMut(&mut dyn Scene, &State) -> T,
) -> Result<Vec<T>, SolveError> {
    let start = scene.rest(0.0);
    let mut seen = vec![look(scene, &start)];
    let mut integrator = Integrator::new(scene, start, end, method, options)?;
    loop {
        let stop = integrator.step()?;
        let state = integrator.state().clone();
        seen.push(look(integrator.system(), &state));
        if stop == Stop::End {
            return Ok(seen);
        }
    }
}

impl<'c> Watched<'c> {
    fn new(cable: &'c FreeCable, first: Kept) -> Self {
        Self { cable, first }
    }

    /// Relative changes of energy, momentum, angular momentum.
    fn changes(&self, scene: &mut dyn Scene, state: &State) -> [f64; 3] {
        let now = free_flight::kept(scene, state, self.cable);
        [
            (now.energy - self.first.energy) / self.first.energy,
            far(&now.momentum, &self.first.momentum) / size(self.first.momentum),
            far(&now.spin, &self.first.spin) / size(self.first.spin),
        ]
    }
}

/// Largest relative changes of energy, momentum and angular momentum of the tumbling cable at the ends of the steps.
fn tumble(method: Method, options: Options, end: f64) -> Result<[f64; 3], SolveError> {
    let model = FreeFlight::default();
    let cable = FreeCable::new(model.elements, model.tip_mass).unwrap();
    let mut scene = model.build(Formulation::Ancf, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let first = free_flight::kept(scene.as_mut(), &rest, &cable);
    let watched = Watched::new(&cable, first);
    let seen = run(scene.as_mut(), options, method, end, |scene, state| {
        watched.changes(scene, state)
    })?;
    Ok(std::array::from_fn(|kind| {
        seen.iter().fold(0.0, |most: f64, row| most.max(row[kind].abs()))
    }))
}

/// Energy, momentum and angular momentum of unknowns that are vectors in space, by the mass matrix.
fn sums(scene: &mut dyn Scene, state: &State) -> Kept {
    let n = scene.unknowns();
    let (pattern, mut mass, mut impulse) = (scene.pattern().clone(), Vec::new(), vec![0.0; n]);
    mass.resize(pattern.entries(), 0.0);
    scene.mass(state, &mut mass);
    pattern.multiply_add(1.0, &mass, &state.v, &mut impulse);
    let mut kept = Kept {
        energy: scene.energy(state).unwrap(),
        momentum: [0.0; 3],
        spin: [0.0; 3],
    };
    for first in (0..n).step_by(3) {
        let (q, p) = (&state.x[first..first + 3], &impulse[first..first + 3]);
        let is_position = scene.describe_unknown(first).contains("position");
        for k in 0..3 {
            let (l, m) = ((k + 1) % 3, (k + 2) % 3);
            kept.spin[k] += q[l] * p[m] - q[m] * p[l];
            if is_position {
                kept.momentum[k] += p[k];
            }
        }
    }
    kept
}

#[test]
fn a_tumbling_bow_keeps_energy_and_momenta_over_ten_thousand_steps() {
    let mut scene = Tumbling::default()
        .build(Formulation::Ancf, Joints::Eliminated)
        .unwrap();
    // What keeps the section below the tip rigid does no work.
    assert_eq!((scene.border(), scene.constraints()), (0, 6));
    let seen = run(scene.as_mut(), fixed(0.005), Method::EnergyMomentum, 50.0, sums).unwrap();
    let (steps, first) = (seen.len() - 1, seen[0]);
    let mut kept = [0.0_f64; 3];
    for now in &seen {
        let changes = [
            (now.energy - first.energy).abs() / first.energy,
            far(&now.momentum, &first.momentum) / size(first.momentum),
            far(&now.spin, &first.spin) / size(first.spin),
        ];
        kept = std::array::from_fn(|kind| kept[kind].max(changes[kind]));
    }
    let step = seen
        .windows(2)
        .map(|pair| (pair[1].energy - pair[0].energy).abs() / first.energy);
    let step = step.fold(0.0, f64::max);
    println!(
        "{steps} steps: changes {}, of the energy in a step {step:.1e}",
        short(&kept)
    );
    assert!((10_000..=10_001).contains(&steps), "{steps}");
    assert!(step < 2e-14, "{step:e}");
    // The bow is far from the origin in the end: angular momentum is the difference of large numbers.
    for (kept, name) in kept.iter().zip(["energy", "momentum", "angular momentum"]) {
        assert!(*kept < 1e-12, "{name} {kept:e}");
    }
}

#[test]
fn the_order_is_two_against_the_inertial_equations() {
    let model = FreeFlight::default();
    let times = grid(0.1, 1.0);
    let cable = FreeCable::new(model.elements, model.tip_mass).unwrap();
    let reference = agreed(
        &cable,
        Explicit::DoPri8,
        1e-13,
        &free_flight::start(&model),
        &times,
        2e-9,
    )
    .unwrap();
    let tip = 6 * model.elements;
    let expected: Vec<Vec<f64>> = reference.states.iter().map(|y| y[tip..tip + 3].to_vec()).collect();
    let errors = [0.002, 0.001, 0.0005].map(|h| {
        let (ends, drift) = free_flight::flight(Formulation::Ancf, Method::EnergyMomentum, fixed(h), &times);
        assert!(drift.iter().all(|drift| *drift < 1e-12), "{}", short(&drift));
        apart(&ends, &expected)
    });
    let found = orders(&errors);
    println!("errors {}, orders {found:.2?}", short(&errors));
    assert!(found.iter().all(|order| (order - 2.0).abs() < 0.1), "{found:.2?}");
}

#[test]
fn adaptive_steps_keep_energy_and_follow_the_tolerance() {
    let times = grid(0.1, 1.0);
    let (expected, _) = free_flight::flight(Formulation::Ancf, Method::Radau, adaptive(1e-11), &times);
    let errors = [1e-5, 1e-6, 1e-7].map(|rtol| {
        let (ends, drift) = free_flight::flight(Formulation::Ancf, Method::EnergyMomentum, adaptive(rtol), &times);
        // At the ends of the steps; between them dense output is of fourth order.
        let kept = tumble(Method::EnergyMomentum, adaptive(rtol), 1.0).unwrap();
        println!(
            "rtol {rtol:e}: drift {} at steps, {} at rows",
            short(&kept),
            short(&drift)
        );
        assert!(kept.iter().all(|change| *change < 1e-12), "{}", short(&kept));
        apart(&ends, &expected)
    });
    println!("errors {}", short(&errors));
    // A local error of third order: 2/3 of a decade for a decade of the tolerance.
    for pair in errors.windows(2) {
        let slope = (pair[0] / pair[1]).log10();
        assert!((slope - 2.0 / 3.0).abs() < 0.15, "slope {slope:.2}");
    }
}

/// Energy and angular momentum about the vertical, at every step.
fn swing(method: Method, h: f64, end: f64) -> Result<Vec<[f64; 2]>, SolveError> {
    let model = ElasticPendulum::default();
    let cable = FreeCable::new(model.elements, 0.7).unwrap();
    let mut scene = model.build(Formulation::Ancf, Joints::Eliminated).unwrap();
    run(scene.as_mut(), fixed(h), method, end, |scene, state| {
        let seen = scene.frame_state(state);
        let spin = cable.kept(&seen.q, &seen.v).spin[2];
        [scene.energy(state).unwrap(), spin]
    })
}

/// Largest changes from the first, relative to the kinetic energy of a fall by the length and to the first spin.
fn changes(seen: &[[f64; 2]]) -> [f64; 2] {
    let scale = [0.5 * 3.0 * 9.81 * 2.0 + 0.7 * 9.81 * 2.0, seen[0][1].abs()];
    std::array::from_fn(|kind| {
        let change = |row: &[f64; 2]| (row[kind] - seen[0][kind]).abs() / scale[kind];
        seen.iter().map(change).fold(0.0, f64::max)
    })
}

#[test]
fn an_elastic_pendulum_keeps_energy_and_its_vertical_angular_momentum() {
    for h in [0.002, 0.01] {
        let seen = swing(Method::EnergyMomentum, h, 10.0).unwrap();
        let kept = changes(&seen);
        println!("h = {h} s, {} steps: {}", seen.len() - 1, short(&kept));
        assert!(kept[0] < 1e-12 && kept[1] < 1e-12, "{}", short(&kept));
    }
}

#[test]
fn steps_that_others_fail_or_drift_with_are_kept() {
    // The fastest motion of the cable has a period of about 0.05 s.
    for h in [0.01, 0.02] {
        let kept = changes(&swing(Method::EnergyMomentum, h, 20.0).unwrap());
        println!("h = {h} s: {}", short(&kept));
        assert!(kept[0] < 1e-12 && kept[1] < 1e-12, "{}", short(&kept));
        for method in [
            Method::GeneralizedAlpha { rho_inf: 1.0 },
            Method::GeneralizedAlpha { rho_inf: 0.8 },
            Method::Hht { alpha: -0.05 },
        ] {
            match swing(method, h, 20.0) {
                Ok(seen) => {
                    let drift = changes(&seen);
                    println!("h = {h} s, {method:?}: {}", short(&drift));
                    assert!(drift[0] > 1e-4, "{method:?}: {}", short(&drift));
                }
                Err(error) => println!("h = {h} s, {method:?}: {error}"),
            }
        }
    }
}

/// Residuals that were evaluated over 2 s of the pendulum, the error of its end's place then (m), and the largest change
/// of the energy.
fn work(name: &str, method: Method, options: Options, reference: &[f64]) -> (u64, f64, f64) {
    let mut scene = ElasticPendulum::default()
        .build(Formulation::Ancf, Joints::Eliminated)
        .unwrap();
    let start = scene.rest(0.0);
    let clock = std::time::Instant::now();
    let (states, counts) = states_at(scene.as_mut(), start, method, options, &[0.0, 2.0]);
    let seconds = clock.elapsed().as_secs_f64();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&states[1], &mut row);
    let error = if reference.is_empty() {
        0.0
    } else {
        far(&row, reference)
    };
    let seen = run(scene.as_mut(), options, method, 2.0, |scene, state| {
        [scene.energy(state).unwrap(), 1.0]
    });
    let change = changes(&seen.unwrap())[0];
    println!(
        "| {name} | {} | {} | {} | {:.0} | {error:.1e} | {change:.1e} |",
        counts.steps,
        counts.residual_evaluations,
        counts.factorizations,
        1e3 * seconds
    );
    (counts.residual_evaluations, error, change)
}

#[test]
fn others_drift_at_the_same_work_and_radau_is_more_accurate() {
    let mut scene = ElasticPendulum::default()
        .build(Formulation::Ancf, Joints::Eliminated)
        .unwrap();
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start, Method::Radau, adaptive(1e-11), &[0.0, 2.0]);
    let mut reference = vec![0.0; scene.output_columns()];
    scene.outputs(&states[1], &mut reference);
    println!("| | steps | residuals | factorizations | ms | error of the end, m | change of energy |");
    let steps = [0.008, 0.004, 0.002, 0.001];
    let energy: Vec<_> = steps
        .map(|h| work(&format!("energy, {h} s"), Method::EnergyMomentum, fixed(h), &reference))
        .into();
    for (name, method) in [
        ("generalized-alpha 1", Method::GeneralizedAlpha { rho_inf: 1.0 }),
        ("generalized-alpha 0.8", Method::GeneralizedAlpha { rho_inf: 0.8 }),
        ("HHT -0.05", Method::Hht { alpha: -0.05 }),
    ] {
        for h in steps {
            let (.., change) = work(&format!("{name}, {h} s"), method, fixed(h), &reference);
            assert!(change > 1e-9, "{name}, {h} s: {change:e}");
        }
    }
    for rtol in [1e-5, 1e-6, 1e-7] {
        work(
            &format!("energy, rtol {rtol:e}"),
            Method::EnergyMomentum,
            adaptive(rtol),
            &reference,
        );
    }
    let radau = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7].map(|rtol| {
        work(
            &format!("Radau, rtol {rtol:e}"),
            Method::Radau,
            adaptive(rtol),
            &reference,
        )
    });
    assert!(energy.iter().all(|(.., change)| *change < 1e-12));
    let (most, error, _) = energy[energy.len() - 1];
    assert!(
        radau.iter().any(|row| row.0 <= most && row.1 < error),
        "no run with Radau is more accurate with as many residuals"
    );
}

#[test]
fn a_planar_arc_keeps_its_energy_under_a_constant_force() {
    let mut scene = Clamped::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let energies = run(
        scene.as_mut(),
        fixed(0.01),
        Method::EnergyMomentum,
        20.0,
        |scene, state| scene.energy(state).unwrap(),
    );
    let energies = energies.unwrap();
    let (low, high) = energies
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &e| {
            (low.min(e), high.max(e))
        });
    println!("{} steps: {:.1e} J", energies.len() - 1, high - low);
    assert!(high - low < 1e-12, "{:e}", high - low);
    // By multipliers instead of elimination, too: what they hold does not move.
    let mut scene = Clamped::default()
        .build(Formulation::Rncf, Joints::Multipliers)
        .unwrap();
    let other = run(
        scene.as_mut(),
        fixed(0.01),
        Method::EnergyMomentum,
        2.0,
        |scene, state| scene.energy(state).unwrap(),
    );
    let other = other.unwrap();
    let most = other.iter().fold(0.0, |most: f64, e| most.max((e - other[0]).abs()));
    assert!(most < 1e-12, "{most:e}");
}

#[test]
fn a_planar_beam_with_a_section_keeps_its_energy() {
    let elastica = Elastica {
        elements: 4,
        slenderness: 0.02,
        ..Elastica::default()
    };
    let mut scene = elastica.scene::<Ancf>().unwrap();
    let energies = run(
        scene.as_mut(),
        adaptive(1e-4),
        Method::EnergyMomentum,
        0.02,
        |scene, state| {
            let still = State {
                v: vec![0.0; state.v.len()],
                ..state.clone()
            };
            let energy = scene.energy(state).unwrap();
            [energy, energy - scene.energy(&still).unwrap()]
        },
    );
    let seen = energies.unwrap();
    let most = |kind: usize| {
        let change = |row: &[f64; 2]| (row[kind] - seen[0][kind]).abs();
        seen.iter().map(change).fold(0.0, f64::max)
    };
    println!("{} steps: {:.1e} J of {:.1e} J", seen.len() - 1, most(0), most(1));
    assert!(most(0) < 1e-10 * most(1), "{:e} of {:e}", most(0), most(1));
}

/// The derivative of the force between two states, against differences.
fn compare_matrix(mut scene: Box<dyn Scene>) {
    let from = scene.rest(0.0);
    let mut to = from.clone();
    let sizes = scene.sizes().to_vec();
    for (i, x) in to.x.iter_mut().enumerate() {
        *x += 0.1 * sizes[i] * (1.7 * i as f64).sin();
    }
    let (n, pattern) = (scene.unknowns(), scene.pattern().clone());
    let mut values = vec![0.0; pattern.entries()];
    let forces = scene.conserving().unwrap();
    forces.matrix(&from, &to, [0.0, 1.0], &mut values);
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    for column in 0..n {
        let h = 1e-5 * sizes[column];
        let sides = [h, -h].map(|h| {
            let mut moved = to.clone();
            moved.x[column] += h;
            let mut out = vec![0.0; n];
            forces.residual(&from, &moved, &mut out);
            out
        });
        for row in 0..n {
            // By the mean of both ends, which moves half as far.
            let difference = (sides[0][row] - sides[1][row]) / h;
            let found = pattern.find(row, column).map_or(0.0, |place| values[place]);
            assert!(
                (found - difference).abs() < 1e-7 * largest,
                "{row} {column}: {found} {difference}"
            );
        }
    }
}

#[test]
fn tangents_are_exact() {
    let scene = |built: Result<Box<dyn Scene>, _>| built.unwrap();
    compare_matrix(scene(Clamped::default().scene::<Ancf>()));
    compare_matrix(scene(ElasticPendulum::default().scene::<Ancf>()));
    let bend = Bend45 {
        elements: 2,
        ..Bend45::default()
    };
    compare_matrix(scene(bend.scene::<Ancf>()));
}

/// Why a scene is refused.
fn refusal(scene: &mut dyn Scene) -> String {
    let start = scene.rest(0.0);
    match Integrator::new(scene, start, 1.0, Method::EnergyMomentum, fixed(0.01)) {
        Ok(_) => panic!("accepted"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn what_does_not_suit_is_refused_by_name() {
    let build = |scene: Result<Box<dyn Scene>, _>| scene.unwrap();
    for (mut scene, words) in [
        (
            build(FreeFlight::default().build(Formulation::Rncf, Joints::Eliminated)),
            &["body `cable`", "free frame `f`", "--formulation ancf"][..],
        ),
        (
            build(SpinUp::default().build(Formulation::Ancf, Joints::Eliminated)),
            &["frame `hub` moves in a prescribed way", "another integrator"],
        ),
        (
            build(HeavyTop::default().build(Formulation::Ancf, Joints::Eliminated)),
            &["`top`", "rigid body", "another integrator"],
        ),
        (
            build(RightAngleFrame::default().build(Formulation::Ancf, Joints::Eliminated)),
            &["`corner`", "`share`", "another integrator"],
        ),
        (
            build(Damped::default().build(Formulation::Ancf, Joints::Eliminated)),
            &["body `rope` is damped", "another integrator"],
        ),
    ] {
        let text = refusal(scene.as_mut());
        println!("{text}");
        for word in words {
            assert!(text.contains(word), "{word}: {text}");
        }
    }
}
