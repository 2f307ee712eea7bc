//! Bodies that fly and turn freely: what an iteration leaves must not leak momentum (docs/free_frames.md).

use rncf::{Formulation, Joints, Method, Options};

use crate::runs::{adaptive, apart, grid, history, short};

rncf::model! {
    /// A beam that a force and a moment throw into the air; its frame follows its mean axes.
    model Thrown {
        param elements: count = 4;
        material soft { density = 1 kg/m^3; young = 10 kPa; poisson = 0; }
        section plate { area = 1 m^2; second_moment = 0.05 m^4; shear_factor = 1; }
        frame f = free(plane = xy, origin = [6, 0, 0] m, angle = 2.2143 rad);
        body beam in f { planar xy; line from [0, 0, 0] m to [10, 0, 0] m; mesh elements * beam(plate, soft); mean_axes; }
        load push = force(beam.start, [if t < 2.5 s { 8 N } else { 0 N }, 0, 0]);
        load twist = moment(beam.start, [0, 0, if t < 2.5 s { -80 [N*m] } else { 0 [N*m] }]);
        output start = beam.start.in(inertial);
        output end = beam.end.in(inertial);
        /// Centre of mass: it lies in the middle of the mean axes.
        output centre = f.at([5, 0, 0] m);
        output momentum = total.momentum;
        output spin = total.angular_momentum(about = total.center_of_mass);
    }
}

rncf::model! {
    /// The same beam in the frame of its chord.
    model Chord {
        param elements: count = 4;
        material soft { density = 1 kg/m^3; young = 10 kPa; poisson = 0; }
        section plate { area = 1 m^2; second_moment = 0.05 m^4; shear_factor = 1; }
        frame f = free(plane = xy, origin = [6, 0, 0] m, angle = 2.2143 rad);
        body beam in f { planar xy; line from [0, 0, 0] m to [10, 0, 0] m; mesh elements * beam(plate, soft); }
        joint root = pin(beam.start, f);
        joint tip = hold(beam.end.y);
        load push = force(beam.start, [if t < 2.5 s { 8 N } else { 0 N }, 0, 0]);
        load twist = moment(beam.start, [0, 0, if t < 2.5 s { -80 [N*m] } else { 0 [N*m] }]);
        output start = beam.start.in(inertial);
        output end = beam.end.in(inertial);
    }
}

const RNCF: (Formulation, Joints) = (Formulation::Rncf, Joints::Eliminated);
const ANCF: (Formulation, Joints) = (Formulation::Ancf, Joints::Eliminated);
/// Length of the beam, m.
const SIZE: f64 = 10.0;

/// The ends of the beam in a history.
fn ends(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    rows.iter().map(|row| row[..4].to_vec()).collect()
}

#[test]
fn the_centre_of_mass_of_a_thrown_beam_moves_by_the_impulse() {
    let times = grid(0.1, 4.0);
    // 8 N on 10 kg for 2.5 s, then 20 N s.
    let expected: Vec<Vec<f64>> = times
        .iter()
        .map(|&t| {
            let way = if t < 2.5 { 0.4 * t * t } else { 2.5 + 2.0 * (t - 2.5) };
            vec![6.0 + 5.0 * 2.2143f64.cos() + way, 5.0 * 2.2143f64.sin()]
        })
        .collect();
    for rtol in [1e-4, 1e-5] {
        let (rows, statistics) = history(&Thrown::default(), RNCF, Method::Radau, adaptive(rtol), &times);
        let centres: Vec<Vec<f64>> = rows.iter().map(|row| row[4..6].to_vec()).collect();
        let error = apart(&centres, &expected);
        // 20 N s, and what the moment has given, stay as they are without loads; 10 kg, 10 m, 2 m/s.
        let after: Vec<&Vec<f64>> = rows
            .iter()
            .zip(&times)
            .filter(|(_, t)| **t > 2.55)
            .map(|(row, _)| row)
            .collect();
        let momentum = after
            .iter()
            .map(|row| (row[6] - 20.0).hypot(row[7]))
            .fold(0.0, f64::max);
        let spin = after.iter().map(|row| (row[8] - after[0][8]).abs()).fold(0.0, f64::max);
        println!(
            "{rtol:e}: centre of mass off by {error:.1e} m, momentum by {momentum:.1e} of 20 N s, angular momentum by {spin:.1e} of {:.0} N m s, {} steps",
            after[0][8], statistics.steps
        );
        assert!(error < rtol * SIZE, "{error:e} m at {rtol:e}");
        assert!(
            momentum < 10.0 * rtol * 20.0 && spin < 10.0 * rtol * 200.0,
            "{momentum:e} {spin:e} at {rtol:e}"
        );
        assert!(after[0][8].abs() > 50.0);
    }
}

#[test]
fn a_thrown_beam_flies_in_its_frames_as_in_absolute_coordinates() {
    let times = grid(0.1, 4.0);
    let thrown = Thrown::default();
    let reference = ends(&history(&thrown, ANCF, Method::Radau, adaptive(1e-7), &times).0);
    for rtol in [1e-4, 1e-5] {
        let mean = ends(&history(&thrown, RNCF, Method::Radau, adaptive(rtol), &times).0);
        let chord = ends(&history(&Chord::default(), RNCF, Method::Radau, adaptive(rtol), &times).0);
        let errors = [apart(&mean, &reference), apart(&chord, &reference)];
        println!("{rtol:e}: ends off by {} m", short(&errors));
        assert!(
            errors.iter().all(|error| *error < 10.0 * rtol * SIZE),
            "{} at {rtol:e}",
            short(&errors)
        );
    }
    // Methods of second order keep what is asked of the result, not of a step.
    for (method, rtol) in [
        (Method::Hht { alpha: -0.05 }, 1e-4),
        (Method::Hht { alpha: -0.05 }, 1e-5),
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, 1e-5),
    ] {
        let options = Options {
            proportional: true,
            ..adaptive(rtol)
        };
        let (rows, statistics) = history(&thrown, RNCF, method, options, &times);
        let error = apart(&ends(&rows), &reference);
        println!(
            "{method:?} {rtol:e}: ends off by {error:.1e} m, {} steps",
            statistics.steps
        );
        assert!(error < 10.0 * rtol * SIZE, "{method:?}: {error:e} m at {rtol:e}");
    }
}

rncf::model! {
    /// A tube that a moment in its middle spins up within a second.
    model Tube {
        param torque = 10 N*m;
        param elements: count = 4;
        material alloy { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section hollow { area = 0.7299e-4 m^2; second_moment = 0.8215e-8 m^4; }
        frame f = free(plane = xy, origin = [-4, 0, 0] m);
        body tube in f { planar xy; line from [0, 0, 0] m to [8, 0, 0] m; mesh elements * cable(hollow, alloy); chord; }
        load motor = moment(tube.at(4 m), [0, 0, if t < 1 s { torque * sin(pi * t / 1 s)^2 } else { 0 [N*m] }]);
        output start = tube.start.in(inertial);
        output end = tube.end.in(inertial);
        output momentum = total.momentum;
        output spin = total.angular_momentum(about = total.center_of_mass);
    }
}

/// 10 and 100 rad/s: both formulations, centre of mass at rest, angular momentum kept.
#[test]
fn a_free_tube_is_spun_up() {
    let times = grid(0.05, 2.0);
    let inertia = 2766.67 * 0.7299e-4 * 8.0f64.powi(3) / 12.0;
    for (speed, rtol) in [(10.0, 1e-5), (100.0, 1e-5)] {
        // Half of the torque on the mean.
        let (given, size) = (inertia * speed, inertia * speed / 8.0);
        let model = Tube {
            torque: 2.0 * given,
            ..Tube::default()
        };
        let [(rows, statistics), (exact, absolute)] =
            [(RNCF, rtol), (ANCF, 1e-7)].map(|(way, rtol)| history(&model, way, Method::Radau, adaptive(rtol), &times));
        let error = apart(&ends(&rows), &ends(&exact));
        let after = &rows[times.iter().position(|t| *t > 1.02).unwrap()..];
        let most = |f: &dyn Fn(&Vec<f64>) -> f64| after.iter().map(f).fold(0.0, f64::max);
        let momentum = most(&|row| row[4].hypot(row[5]));
        let spin = most(&|row| (row[6] - given).abs());
        println!(
            "{speed} rad/s at {rtol:e}: ends off by {error:.1e} m, momentum {momentum:.1e} N s, angular momentum by {spin:.1e} of {given:.1} N m s; {} and {} steps",
            statistics.steps, absolute.steps
        );
        assert!(error < 10.0 * rtol * 8.0, "{error:e} m");
        assert!(momentum < 10.0 * rtol * size && spin < 10.0 * rtol * given);
    }
}

rncf::model! {
    /// A hub with four booms of unequal masses that a moment on the hub turns, while a thruster on one boom pushes.
    model Satellite {
        param elements: count = 3;
        material carbon { density = 1600 kg/m^3; young = 60 GPa; poisson = 0; }
        section rod { area = 1 cm^2; second_moment = 0.5 cm^4; }
        rigid hub { plane xy; mass = 40 kg; inertia = 8 kg*m^2; }
        body east in hub { planar xy; line from [0.5, 0, 0] m to [4.5, 0, 0] m; mesh elements * cable(rod, carbon); }
        body north in hub { planar xy; line from [0, 0.5, 0] m to [0, 4.5, 0] m; mesh elements * cable(rod, carbon); }
        body west in hub { planar xy; line from [-0.5, 0, 0] m to [-4.5, 0, 0] m; mesh elements * cable(rod, carbon); }
        body south in hub { planar xy; line from [0, -0.5, 0] m to [0, -4.5, 0] m; mesh elements * cable(rod, carbon); }
        joint east_root = clamp(east.start, hub);
        joint north_root = clamp(north.start, hub);
        joint west_root = clamp(west.start, hub);
        joint south_root = clamp(south.start, hub);
        fixture first on east.end { mass = 1.5 kg; }
        fixture second on north.end { mass = 0.5 kg; }
        load wheel = moment(hub, [0, 0, if t < 1 s { 120 [N*m] * sin(pi * t / 1 [s])^2 } else { 0 [N*m] }]);
        load thruster = force(south.end, [if t < 1 s { 4 [N] * sin(pi * t / 1 [s])^2 } else { 0 N }, 0, 0]);
        output east_tip = east.end.in(inertial);
        output north_tip = north.end.in(inertial);
        output west_tip = west.end.in(inertial);
        output south_tip = south.end.in(inertial);
        output momentum = total.momentum;
        output spin = total.angular_momentum(about = total.center_of_mass);
    }
}

/// Length of the satellite, m; the force's impulse, N s.
const SPAN: f64 = 9.0;
const IMPULSE: f64 = 2.0;

/// Of a run of the satellite in 4 s: distance of its tips from those of a reference (m), and what is lost of its momenta after the loads, as parts.
fn satellite(
    way: (Formulation, Joints),
    method: Method,
    rtol: f64,
    exact: Option<&[Vec<f64>]>,
) -> (Vec<Vec<f64>>, [f64; 3]) {
    let times = grid(0.05, 4.0);
    let (rows, _) = history(&Satellite::default(), way, method, adaptive(rtol), &times);
    let tips: Vec<Vec<f64>> = rows.iter().map(|row| row[..8].to_vec()).collect();
    let after = &rows[times.iter().position(|t| *t > 1.02).unwrap()..];
    let most = |f: &dyn Fn(&Vec<f64>) -> f64| after.iter().map(f).fold(0.0, f64::max);
    let linear = most(&|row| (row[8] - IMPULSE).hypot(row[9])) / IMPULSE;
    let angular = most(&|row| (row[10] - after[0][10]).abs()) / after[0][10].abs();
    let error = exact.map_or(0.0, |exact| apart(&tips, exact));
    (tips, [error, linear, angular])
}

/// Both formulations of a hub with four booms: 10 `rtol` of its size, the impulse of the thruster (a closed form), and angular momentum kept.
#[test]
fn a_satellite_flies_in_its_hub_as_in_absolute_coordinates() {
    let (exact, _) = satellite(ANCF, Method::Radau, 1e-9, None);
    for rtol in [1e-4, 1e-5, 1e-6, 1e-8] {
        let (_, [error, linear, angular]) = satellite(RNCF, Method::Radau, rtol, Some(&exact));
        println!("{rtol:e}: tips off by {error:.1e} m, momentum by {linear:.1e}, angular momentum by {angular:.1e}");
        assert!(error < 10.0 * rtol * SPAN, "{rtol:e}: {error:e}");
        assert!(
            linear < 10.0 * rtol && angular < 10.0 * rtol,
            "{rtol:e}: {linear:e} {angular:e}"
        );
    }
    for method in [Method::Hht { alpha: -0.05 }, Method::GeneralizedAlpha { rho_inf: 0.8 }] {
        let [coarse, fine] = [1e-5, 1e-7].map(|rtol| satellite(RNCF, method, rtol, Some(&exact)).1);
        println!("{method:?}: {coarse:?} at 1e-5, {fine:?} at 1e-7");
        // Second order: a hundredth of the tolerance is a fifth of the step.
        assert!(
            fine[0] < coarse[0] / 10.0 && fine[0] < 1e-3 * SPAN,
            "{method:?}: {coarse:?}, {fine:?}"
        );
    }
}

rncf::model! {
    /// Two masses on stiff springs that whirl about the origin: springs pull along their lines alone, so that angular momentum stays.
    model Whirling {
        param k = 1e9 N/m;
        rigid near { plane xy; mass = 1 kg; origin = [1, 0, 0] m; velocity = [0, 0.5, 0] m/s; }
        rigid far { plane xy; mass = 2 kg; origin = [1.5, 0, 0] m; }
        spring inner = linear(near, inertial, stiffness = k, length = 1 m);
        spring outer = linear(near, far, stiffness = 10*k, length = 0.5 m);
        output spin = total.angular_momentum;
    }
}

/// A force of 1 GN/m turns within a step, so that increments of Newton's iteration fall in one iteration and rise in the next: what stagnates
/// far above round-off is no noise.
#[test]
fn stiff_forces_that_turn_keep_the_angular_momentum() {
    let times = grid(0.1, 20.0);
    for (k, rtol) in [(1e9, 1e-5), (1e9, 1e-6), (1e11, 1e-5)] {
        let (rows, statistics) = history(&Whirling { k }, RNCF, Method::Radau, adaptive(rtol), &times);
        let lost = rows.iter().map(|row| (row[0] / 0.5 - 1.0).abs()).fold(0.0, f64::max);
        println!(
            "{k:e} N/m at {rtol:e}: {lost:.1e} of the angular momentum lost, {} steps",
            statistics.steps
        );
        assert!(lost < 10.0 * rtol, "{k:e} N/m at {rtol:e}: {lost:e}");
    }
}

rncf::model! {
    /// A damped bar that spins about its middle, which its chord follows.
    model Damped {
        param elements: count = 12;
        param c = 2 ms;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; damping = c; }
        section strip { area = 2 cm^2; second_moment = 0.2 cm^4; }
        frame f = free(plane = xy, speed = 20 rad/s);
        body bar in f { planar xy; line from [-1, 0, 0] m to [1, 0, 0] m; mesh elements * cable(strip, alloy); chord; }
        output end = bar.end.in(inertial);
    }
}

/// A step over a radian of the spin is refused, and the shorter one needs a matrix of its own: with that of the middle of the long one it never
/// converged. The spin stretches it by `u = density speed^2 (l^2 x - x^3/3) / 2 young`, so that it turns slower by `2 int x u / int x^2`.
#[test]
fn a_damped_bar_spins_on() {
    let times = grid(0.1, 10.0);
    for (elements, c, rtol) in [(12, 2e-3, 1e-6), (16, 2e-3, 1e-4), (12, 20e-3, 1e-6), (4, 20e-3, 1e-7)] {
        let bar = Damped { elements, c };
        let (rows, statistics) = history(&bar, RNCF, Method::Radau, adaptive(rtol), &times);
        let slower = 0.8 * 2700.0 * 400.0 / 70e9;
        let exact = times.iter().map(|t| 20.0 * (1.0 - slower) * t);
        let off = rows
            .iter()
            .zip(exact)
            .map(|(row, angle)| (row[0] - angle.cos()).hypot(row[1] - angle.sin()));
        let off = off.fold(0.0, f64::max);
        println!(
            "{elements} elements, {c} s, {rtol:e}: {off:.1e} m, {} steps",
            statistics.steps
        );
        assert!(
            off < (100.0 * rtol).max(5e-5) && statistics.steps < 5000,
            "{elements} elements, {c} s, {rtol:e}: {off:e} m"
        );
    }
}

rncf::model! {
    /// A shaft with a disc on bearings, in axes that do not turn with it, which a torque turns up in 0.1 s.
    model Shaft {
        material steel { density = 780 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 4 mm);
        body shaft { spatial; line from [0, 0, 0] m to [0.6, 0, 0] m; mesh 2 * beam(round, steel); }
        joint left = revolute(inertial.at([0, 0, 0] m), shaft.start, axis = [1, 0, 0]);
        fixture disc on shaft.at(0.3 m) { mass = 2 kg; inertia = [0.01, 0.005, 0.005] kg*m^2; }
        spring right = bushing(shaft.end, inertial.at([0.6, 0, 0] m), stiffness = [0, 1e6, 1e6] N/m);
        load drive = moment(shaft.start, [if t < 0.1 s { 5 [N*m] } else { 0 [N*m] }, 0, 0]);
        output energy = total.kinetic_energy + total.strain_energy;
        output torque = shaft.at(0.15 m).torque;
    }
}

/// What an iteration leaves where a body turns in the axes of its unknowns has one sign step after step: it drove the torsion of the shaft far
/// beyond what the torque can. One that comes at once twists by twice of it at most.
#[test]
fn a_shaft_that_turns_in_its_axes_gains_no_energy() {
    let times = grid(0.001, 0.15);
    let (rows, statistics) = history(&Shaft {}, RNCF, Method::Radau, adaptive(1e-4), &times);
    let behind = rows.iter().zip(&times).filter(|(_, t)| **t > 0.101).map(|(row, _)| row);
    let energy = behind.clone().map(|row| row[0]);
    let (first, last) = (energy.clone().next().unwrap(), energy.fold(0.0, f64::max));
    let torque = rows.iter().map(|row| row[1].abs()).fold(0.0, f64::max);
    println!("{first} to {last} J, {torque} N m, {} steps", statistics.steps);
    assert!(
        last < 1.01 * first && torque < 10.5,
        "{first} to {last} J, {torque} N m"
    );
}

/// The table of docs/free_frames.md: ten elements, 8 s.
#[test]
#[ignore = "a study of minutes"]
fn table() {
    let times = grid(0.1, 8.0);
    let (thrown, chord) = (Thrown { elements: 10 }, Chord { elements: 10 });
    let reference = ends(&history(&thrown, ANCF, Method::Radau, adaptive(1e-9), &times).0);
    let hht = Method::Hht { alpha: -0.05 };
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for method in [Method::Radau, hht, alpha] {
        for rtol in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            let runs = [
                ("mean axes", history(&thrown, RNCF, method, adaptive(rtol), &times)),
                ("chord", history(&chord, RNCF, method, adaptive(rtol), &times)),
                ("absolute", history(&thrown, ANCF, method, adaptive(rtol), &times)),
            ];
            for (name, (rows, statistics)) in runs {
                let error = apart(&ends(&rows), &reference);
                println!(
                    "{method:?}, {rtol:e}, {name}: {error:.1e} m, {} steps, {} iterations",
                    statistics.steps, statistics.newton_iterations
                );
            }
        }
    }
}
