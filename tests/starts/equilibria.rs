//! Relative equilibria at the start: closed forms, the same found in another way, and that nothing moves afterwards.

use std::time::Instant;

use rncf::app::{EquilibriumSettings, Range, RunSettings, campbell, modes, run, static_equilibria, steady};
use rncf::equilibrium::Uniform;
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, Start};

rncf::model! {
    /// A wire with a mass at its end in a turning hub.
    pub model Whirl {
        param spin = 30 rad/s;
        param elements: count = 16;
        material soft { density = 1000 kg/m^3; young = 10 MPa; }
        section round = circle(radius = 2 mm);
        frame hub = rotating(axis = z, angle = spin*t);
        body wire in hub {
            spatial;
            line from [0.5, 0, 0] m to [2.5, 0, 0] m;
            mesh elements * cable(round, soft);
        }
        joint root = clamp(wire.start, hub);
        fixture tip on wire.end { mass = 5 g; }
        start spun = spinning(hub);
        output x = wire.end.x;
        output y = wire.end.y;
        output root_force = wire.start.axial_force;
        output middle_force = wire.at(1 m).axial_force;
        output end_force = wire.end.axial_force;
    }
}

rncf::model! {
    /// A leaning blade that bends, in the plane.
    pub model Leaning {
        param spin = 20 rad/s;
        param elements: count = 8;
        material soft { density = 1000 kg/m^3; young = 100 MPa; }
        section flat = rectangle(y = 5 mm, z = 20 mm);
        frame hub = rotating(axis = z, angle = spin*t);
        body blade in hub {
            planar xy;
            line from [0.3, 0, 0] m to [1, 0.7, 0] m;
            mesh elements * cable(flat, soft, bending = exact);
        }
        joint root = clamp(blade.start, hub);
        start spun = spinning(hub);
        output tip = blade.end;
    }
}

rncf::model! {
    /// The same without a start.
    pub model Unprepared {
        param spin = 20 rad/s;
        param elements: count = 8;
        material soft { density = 1000 kg/m^3; young = 100 MPa; }
        section flat = rectangle(y = 5 mm, z = 20 mm);
        frame hub = rotating(axis = z, angle = spin*t);
        body blade in hub {
            planar xy;
            line from [0.3, 0, 0] m to [1, 0.7, 0] m;
            mesh elements * cable(flat, soft, bending = exact);
        }
        joint root = clamp(blade.start, hub);
        output tip = blade.end;
    }
}

rncf::model! {
    /// A rope between two points of the hub, straight and without force at first.
    pub model Rope {
        param spin = 5 rad/s;
        param elements: count = 12;
        param shift = 1 m;
        material nylon { density = 1100 kg/m^3; young = 2 GPa; }
        section round = circle(radius = 0.2 mm);
        frame hub = rotating(axis = z, angle = spin*t);
        body rope in hub {
            spatial;
            line from [shift, -0.5 m, 0 m] to [shift, 0.5 m, 0 m];
            mesh elements * cable(round, nylon, slack = true);
        }
        joint left = pin(rope.start, hub);
        joint right = pin(rope.end, hub);
        start spun = spinning(hub);
        output middle = rope.at(0.5 m);
        output slope = rope.at(0.5 m).slope;
        output force = rope.start.axial_force;
    }
}

rncf::model! {
    /// Two tethers on a free hub, in a gravity that the start leaves out.
    pub model Sail {
        param spin = 0.5 deg/s;
        param length = 10 km;
        param elements: count = 8;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; }
        section wire = circle(radius = 38 um);
        frame sail = free(velocity = [0, 3, 0] m/s, angular_velocity = [0, 0, spin]);
        fixture core on sail { mass = 300 kg; inertia = [100, 100, 100] kg*m^2; }
        body left in sail {
            spatial;
            line from [0, 0, 0] m to [length, 0 m, 0 m];
            mesh elements * tether(wire, aluminium, slack = true);
        }
        body right in sail {
            spatial;
            line from [0, 0, 0] m to [-length, 0 m, 0 m];
            mesh elements * tether(wire, aluminium);
        }
        joint hub_left = clamp(left.start, sail);
        joint hub_right = clamp(right.start, sail);
        fixture far_left on left.end { mass = 0.5 kg; }
        fixture far_right on right.end { mass = 0.5 kg; }
        start spun = spinning(sail, angular_velocity = [0, 0, spin]);
        output reach = left.end.x;
        output other = right.end.x;
        output tension = left.start.axial_force;
    }
}

fn outputs(scene: &mut dyn Scene) -> Vec<f64> {
    let state = scene.rest(0.0);
    let mut out = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut out);
    out
}

/// How far nodal vectors in their frames move in a run, relative to `length`.
fn moves(scene: &mut dyn Scene, t_end: f64, length: f64) -> f64 {
    let start = scene.rest(0.0);
    let before = scene.frame_state(&start).q;
    let options = Options {
        rtol: 1e-8,
        ..Options::default()
    };
    let method = Method::GeneralizedAlpha { rho_inf: 0.9 };
    let mut integrator = Integrator::new(scene, start, t_end, method, options).unwrap();
    let mut most: f64 = 0.0;
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        let now = integrator.system().frame_state(&state).q;
        let gap = now.iter().zip(&before).map(|(a, b)| (a - b).abs());
        most = gap.fold(most, f64::max);
        if stop == rncf::Stop::End {
            return most / length;
        }
    }
}

/// The bar that its own centrifugal force stretches, by shooting: `n' = -rho A w^2 r`, `n = EA/2 (r'^2 - 1) r'`,
/// `r(0) = 0.5`, `n(L) = m w^2 r(L)`. Forces at 0, 1 m and L, and the end's place.
fn bar(spin: f64) -> [f64; 4] {
    let area = std::f64::consts::PI * 2e-3_f64.powi(2);
    let (stiffness, density) = (10e6 * area, 1000.0 * area);
    let stretch = |n: f64| {
        let mut s = 1.0;
        for _ in 0..60 {
            s -= (0.5 * (s * s - 1.0) * s - n / stiffness) / (0.5 * (3.0 * s * s - 1.0));
        }
        s
    };
    let rate = |[r, n]: [f64; 2]| [stretch(n), -density * spin * spin * r];
    let end = |n0: f64| {
        let (steps, mut y, mut middle) = (2000, [0.5, n0], 0.0);
        let h = 2.0 / f64::from(steps);
        for step in 0..steps {
            if step == steps / 2 {
                middle = y[1];
            }
            let at = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let k1 = rate(y);
            let k2 = rate(at(k1, h / 2.0));
            let k3 = rate(at(k2, h / 2.0));
            let k4 = rate(at(k3, h));
            y = [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        }
        (y, middle)
    };
    let miss = |n0: f64| {
        let ([r, n], _) = end(n0);
        n - 5e-3 * spin * spin * r
    };
    let (mut low, mut high) = (0.0, stiffness);
    assert!(miss(low) < 0.0 && miss(high) > 0.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if miss(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let ([r, n], middle) = end(0.5 * (low + high));
    [low, middle, n, r]
}

#[test]
fn a_wire_is_stretched_by_its_own_centrifugal_force() {
    for spin in [1.0, 30.0] {
        let wanted = bar(spin);
        let model = Whirl {
            spin,
            ..Whirl::default()
        };
        for (formulation, joints) in [
            (Formulation::Rncf, Joints::Eliminated),
            (Formulation::Rncf, Joints::Multipliers),
            (Formulation::Ancf, Joints::Eliminated),
        ] {
            let mut scene = model.build(formulation, joints).unwrap();
            let found = outputs(scene.as_mut());
            println!("{spin} rad/s: {found:?}, closed form {wanted:?}");
            assert!((found[0] - wanted[3]).abs() < 1e-8 * wanted[3], "{found:?} {wanted:?}");
            assert_eq!(found[1], 0.0);
            // In absolute coordinates section forces need the accelerations, which come with the first step.
            let forces = if formulation == Formulation::Rncf { 3 } else { 0 };
            for (place, force) in wanted[..forces].iter().enumerate() {
                assert!(
                    (found[2 + place] - force).abs() < 2e-4 * wanted[0],
                    "{found:?} {wanted:?}"
                );
            }
        }
    }
}

#[test]
fn the_start_is_the_equilibrium_that_continuation_finds() {
    let model = Leaning::default();
    let mut settled = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let mut scene = Unprepared::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap();
    let found = rncf::steady(scene.as_mut(), 0.0).unwrap();
    let wanted = scene.frame_state(found.state().unwrap()).q;
    let rest = settled.rest(0.0);
    let start = settled.frame_state(&rest);
    let gap = start.q.iter().zip(&wanted).map(|(a, b)| (a - b).abs());
    let gap = gap.fold(0.0, f64::max);
    let undeformed = scene.rest(0.0);
    let bent = scene.frame_state(&undeformed).q;
    let bent = bent.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!("bent by {bent}, apart by {gap:.1e}");
    assert!(bent > 0.1, "{bent}");
    assert!(gap < 1e-11, "{gap}");
    assert!(start.v.iter().all(|&v| v == 0.0));
    let mut ancf = model.build(Formulation::Ancf, Joints::Eliminated).unwrap();
    let rest = ancf.rest(0.0);
    let other = ancf.frame_state(&rest);
    for (a, b) in other.q.iter().zip(&start.q).chain(other.v.iter().zip(&start.v)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn what_starts_in_equilibrium_stays_there() {
    let mut scenes = [
        Whirl::default().build(Formulation::Rncf, Joints::Eliminated).unwrap(),
        Leaning::default().build(Formulation::Rncf, Joints::Eliminated).unwrap(),
    ];
    for scene in &mut scenes {
        let moved = moves(scene.as_mut(), 2.0, 2.0);
        println!("moves by {moved:.1e}");
        assert!(moved < 1e-9, "{moved}");
    }
}

#[test]
fn a_rope_swings_out_from_a_straight_line() {
    let mut last = 0.0;
    for spin in [1.0, 5.0, 50.0] {
        let model = Rope {
            spin,
            ..Rope::default()
        };
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let out = outputs(scene.as_mut());
        println!("{spin} rad/s: {out:?}");
        // It bulges outwards, more the faster, and stays symmetric and in its plane.
        assert!(out[0] > 1.0 + last && out[1].abs() < 1e-12 && out[2] == 0.0, "{out:?}");
        assert!(out[3].abs() < 1e-11 && out[5] == 0.0, "{out:?}");
        // A flat arc under the load rho A w^2 r across it: H = q l^2/(8 f), and the stretch that belongs to f.
        let area = std::f64::consts::PI * 0.2e-3_f64.powi(2);
        let rise = out[0] - 1.0;
        let across = 1100.0 * area * spin * spin * (1.0 + 2.0 / 3.0 * rise);
        let tension = across / 8.0 / rise;
        assert!(
            (out[6] / tension - 1.0).abs() < 0.02 + 10.0 * rise * rise,
            "{out:?}, flat arc {tension}"
        );
        last = rise;
        let at = Uniform::steady(0.0);
        let state = scene.rest(0.0);
        let mut residual = vec![0.0; state.x.len()];
        scene.uniform_residual(&at, &state, &mut residual);
        let worst = residual.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        println!("left over {worst:.1e} of {}", out[6]);
        assert!(worst < 1e-9 * out[6], "{worst}");
    }
}

#[test]
fn a_free_sail_starts_taut_and_stays() {
    for spin in [0.25_f64, 1.0] {
        let model = Sail {
            spin: spin.to_radians(),
            ..Sail::default()
        };
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let out = outputs(scene.as_mut());
        println!("{spin} deg/s: {out:?}");
        // The smoothing of the slack one changes its strain by (d/2e)^2.
        assert!(out[0] > 10e3 && (out[0] + out[1]).abs() < 2e-5, "{out:?}");
        let line = 2700.0 * std::f64::consts::PI * 38e-6_f64.powi(2);
        let wanted = model.spin.powi(2) * (0.5 * 1e4 + line * 1e8 / 2.0);
        assert!((out[2] / wanted - 1.0).abs() < 0.01, "{} {wanted}", out[2]);
        let moved = moves(scene.as_mut(), 50.0, 10e3);
        println!("moves by {moved:.1e}");
        assert!(moved < 1e-9, "{moved}");
    }
}

#[test]
fn a_start_that_cannot_be_is_refused_by_name() {
    let error = Whirl {
        spin: f64::INFINITY,
        ..Whirl::default()
    };
    let error = error
        .build(Formulation::Rncf, Joints::Eliminated)
        .map(|_| ())
        .unwrap_err();
    assert!(error.to_string().contains("finite"), "{error}");
    let error = Whirl {
        spin: 1e150,
        ..Whirl::default()
    };
    let error = error
        .build(Formulation::Rncf, Joints::Eliminated)
        .map(|_| ())
        .unwrap_err();
    println!("{error}");
    assert!(
        error.to_string().contains("`hub`") && error.to_string().contains("`spun`"),
        "{error}"
    );
}

#[test]
#[ignore = "measures"]
fn ten_thousand_unknowns() {
    for elements in [170, 1700] {
        let model = Rope {
            elements,
            ..Rope::default()
        };
        let clock = Instant::now();
        let scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        println!("{} unknowns: {:.2} s", scene.unknowns(), clock.elapsed().as_secs_f64());
    }
}

rncf::model! {
    /// A weight on a lag hinge of a hub that turns, in air: Newton's iteration from the undeformed shape leaps to where the hinge is wound over.
    pub model Lagging {
        param speed = 20 rad/s;
        param drag = 0.3 kg/m;
        frame hub = rotating(axis = z, angle = speed * t);
        rigid weight in hub { plane xy; mass = 0.3 kg; inertia = 0.002 kg*m^2; origin = [0.5, 0, 0] m; }
        joint hinge = revolute(hub.at([0.3, 0, 0] m), weight.at([-0.2, 0, 0] m));
        spring centring = torsional(hinge, stiffness = 1 N*m/rad, damping = 0.01 N*m*s/rad, angle = 0.1 rad);
        load air = force(weight, -drag * norm(weight.velocity) * weight.velocity);
        output lag = hinge.angle;
        run { t_end = 1 s; every = 1 ms; }
    }
}

/// The lag at which centrifugal force, drag and spring balance on the branch from rest, and the rate and frequency of small swings about it.
fn lag(speed: f64) -> [f64; 3] {
    let (hinge, arm, mass, inertia) = (0.3f64, 0.2f64, 0.3f64, 0.002 + 0.3 * 0.2f64.powi(2));
    let radius = |a: f64| (hinge * hinge + arm * arm + 2.0 * hinge * arm * a.cos()).sqrt();
    let moment = |a: f64| {
        let drag = 0.3 * speed * speed * radius(a) * arm * (hinge * a.cos() + arm);
        -mass * speed * speed * hinge * arm * a.sin() - drag - (a - 0.1)
    };
    let (mut low, mut high) = (-1.2, 0.2);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        *(if moment(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    let stiffness = -(moment(low + 1e-5) - moment(low - 1e-5)) / 2e-5;
    let across = (hinge * low.cos() + arm) / radius(low);
    let damping = 0.01 + 0.3 * speed * radius(low) * arm * arm * (1.0 + across * across);
    let re = -0.5 * damping / inertia;
    [low, re, (stiffness / inertia - re * re).sqrt()]
}

#[test]
fn the_equilibrium_that_grows_out_of_rest_is_found_with_few_steps() {
    let [at, re, im] = lag(20.0);
    let model = Lagging::default();
    let range = |from, steps| EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from,
            to: 20.0,
        }),
        steps,
        ..EquilibriumSettings::default()
    };
    let mode = modes(&model, &EquilibriumSettings::default()).unwrap().modes[0];
    assert!(
        (mode.re - re).abs() < 1e-5 && (mode.im - im).abs() < 1e-5,
        "{mode:?}, {re} {im}"
    );
    for (from, steps) in [(18.0, 4), (0.0, 4), (0.0, 1)] {
        let found = steady(&model, &range(from, steps)).unwrap();
        let last = found.history.column(0).last().unwrap();
        assert!((last - at).abs() < 1e-8, "{from} {steps}: {last} for {at}");
        assert!(found.warnings.is_empty(), "{:?}", found.warnings);
        let found = campbell(&model, &range(from, steps)).unwrap();
        let mode = found.row(found.keys.len() - 1).next().unwrap();
        assert!(
            (mode.re - re).abs() < 1e-5 && (mode.im - im).abs() < 1e-5,
            "{mode:?}, {re} {im}"
        );
    }
    let settings = RunSettings {
        start: Some(Start::Steady),
        ..RunSettings::default()
    };
    let started = run(&model, &settings).unwrap();
    let off = started.history.column(0).map(|a| (a - at).abs()).fold(0.0, f64::max);
    assert!(off < 1e-5, "{off}");
}

rncf::model! {
    /// A plumb line in a car that brakes.
    pub model Plumb {
        param braking = 5 m/s^2;
        frame car = moving(origin = [20 [m/s] * t - braking * t^2 / 2, 0 m, 0 m]);
        rigid bob in car { plane xy; mass = 1 kg; origin = [0, -1, 0] m; inertia = 1e-3 kg*m^2; }
        joint string = revolute(car.at([0, 0, 0] m), bob.at([0, 1, 0] m));
        spring stiff = torsional(string, stiffness = 1 N*m/rad);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output angle = string.angle;
        run { t_end = 2 s; every = 1 s; }
    }
}

/// The plumb line of a car that brakes is oblique, and upright at rest.
#[test]
fn what_static_leaves_out_is_told() {
    let settings = EquilibriumSettings {
        at: Some(0.5),
        ..EquilibriumSettings::default()
    };
    let found = static_equilibria(&Plumb::default(), &settings).unwrap();
    let note = found.warnings.iter().find(|note| note.contains("`car` stands still"));
    assert!(
        note.is_some_and(|note| note.contains("at t = 0.5 s")),
        "{:?}",
        found.warnings
    );
}

rncf::model! {
    /// A mass that is pulled against something that gives way at 10 N.
    pub model Yielding {
        param pull = 1 N;
        rigid mass { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
        joint guide = prismatic(inertial, mass, axis = x);
        spring soft = law(mass, inertial.at([-1, 0, 0] m), force = 10 [N] * (length / 1 [m] - 1) * exp(2 - length / 1 [m]));
        load pulls = force(mass, [pull, 0, 0]);
        output x = mass.x;
    }
}

/// A diagram begins at the first of its steps that has an equilibrium, and leaves out none behind it.
#[test]
fn steps_without_an_equilibrium_alone_are_left_out_of_a_diagram() {
    let settings = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 19.0,
            to: 1.0,
        }),
        steps: 9,
        ..EquilibriumSettings::default()
    };
    let found = campbell(&Yielding::default(), &settings).unwrap();
    // Next to the largest pull a step is halved.
    assert_eq!(found.keys, [9.0, 8.0, 7.0, 5.0, 3.0, 1.0]);
}
