//! Distributed loads and gravity of a point against closed forms.

use rncf::equilibrium::Uniform;
use rncf::model::Fidelity;
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, StepSize, Stop, steady};

rncf::model! {
    /// A cable towed through water: its weight against the drag across it.
    pub model Tow {
        param flow = 1.5 m/s;
        /// Angle from the plumb line at the start.
        param lean = 1.1 rad;
        material rubber { density = 3000 kg/m^3; young = 1 GPa; damping = 0.1 s; }
        section cord = circle(radius = 10 mm);
        body rope { planar xy; line from [0, 0, 0] m to [10 m * sin(lean), -10 m * cos(lean), 0]; mesh 5 * cable(cord, rubber); }
        joint hook = pin(rope.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        load drag = distributed(rope, 0.5 * 1000 [kg/m^3] * 1.2 * 0.02 [m] * norm(across) * across,
            seen = [flow, 0, 0] - velocity, across = seen - dot(seen, tangent) * tangent);
        output end = rope.end;
        output pull = rope.start.axial_force;
    }
}

rncf::model! {
    /// A clamped bar in a wind across its plane.
    pub model Bar {
        param wind = 20 m/s;
        param rise = -4;
        table polar { at = alpha; alpha = [-30, 30] deg; lift = [-0.5235987755982988, 0.5235987755982988]; }
        material wood { density = 500 kg/m^3; young = 8 GPa; poisson = 0.3; }
        section plank = rectangle(y = 20 mm, z = 60 mm);
        body bar { planar yz; line from [0, 0, 0] m to [0, 0, 2] m; mesh 6 * beam(plank, wood); }
        joint root = clamp(bar.start, inertial);
        load air = distributed(bar, [0, 0.5 * 1.2 [kg/m^3] * 0.06 [m] * norm(flow) * (-rise * polar.lift(atan2(-flow.y, wind)) * wind + 1.1 * flow.y), 0],
            flow = [wind, 0, 0] - velocity);
        output tip = bar.end.y;
    }
}

rncf::model! {
    /// A cantilever under thrust along its tangent, spread evenly, and a shaft under a moment along it.
    pub model Column {
        param thrust = 10 N/m;
        param twist = 0 N;
        param elements: count = 16;
        material unit { density = 1 kg/m^3; young = 1 MPa; }
        section slender { area = 1 m^2; second_moment = 1e-6 m^4; }
        body column { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(slender, unit); }
        joint root = clamp(column.start, inertial);
        material steel { density = 7800 kg/m^3; young = 200 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        body shaft { spatial; line from [0, 3, 0] m to [2, 3, 0] m; mesh 4 * beam(round, steel); }
        joint shaft_root = clamp(shaft.start, inertial);
        load torsion = distributed(shaft, [0, 0, 0] N/m, moment = [twist * x / (1 m), 0, 0], in = section);
        load jets = distributed(column, [-thrust, 0, 0], in = section);
        output tip = column.end;
        output root_force = column.start.axial_force;
        output angle = shaft.end.ey.z;
        output torque = shaft.at(1 m).torque;
    }
}

rncf::model! {
    /// A rod that falls broadside.
    pub model Rods {
        material steel { density = 7800 kg/m^3; young = 200 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        frame drop = free(plane = xy);
        body rod in drop { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mean_axes; mesh 3 * cable(round, steel); }
        load weight = gravity([0, -9.81, 0] m/s^2);
        load drag = distributed(rod, -0.6 [kg/m^2] * norm(velocity) * velocity);
        output fall = drop.velocity.y;
    }
}

rncf::model! {
    /// Bodies on a circle about a point that attracts: a rod of beams, and a rigid one.
    pub model Orbit {
        param mu = 1e13 m^3/s^2;
        param tilt = 1e-4 rad;
        const r = 100 km;
        const n = 0.1 rad/s;
        material light { density = 1000 kg/m^3; young = 50 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        frame carrier = free(origin = [r, 0, 0], axis = z, angle = tilt, velocity = [0, r * n, 0], angular_velocity = [0, 0, n]);
        body rod in carrier { spatial; line from [-1, 0, 0] m to [1, 0, 0] m; mean_axes; mesh 4 * beam(round, light); }
        rigid bar { mass = 2 kg; inertia = [1e-4, 1, 1] kg*m^2; origin = [-r, 0, 0]; axis = y; angle = tilt; velocity = [0, -r * n, 0]; angular_velocity = [-n * sin(tilt), 0, n * cos(tilt)]; }
        load sun = gravity(-mu * position / norm(position)^3);
        output along = carrier.ex.in(inertial);
        output at = carrier.position;
        output pull = rod.at(1 m).axial_force;
        output out = bar.ex.z;
        output momentum = total.angular_momentum;
    }
}

fn built(model: &impl Model, formulation: Formulation, fidelity: &[(String, Fidelity)]) -> Box<dyn Scene> {
    model.build_as(formulation, Joints::Eliminated, fidelity).unwrap()
}

fn outputs(scene: &mut dyn Scene, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(state, &mut row);
    row
}

/// State after a time, by the method of order five.
fn later(scene: &mut dyn Scene, end: f64, rtol: f64) -> State {
    let start = scene.rest(0.0);
    let options = Options {
        step: StepSize::Adaptive,
        rtol,
        ..Options::default()
    };
    let mut integrator = Integrator::new(scene, start, end, Method::Radau, options).unwrap();
    while integrator.step().unwrap() != Stop::End || integrator.state().t < end * (1.0 - 1e-12) {}
    integrator.state().clone()
}

/// Outputs after a time.
fn after(model: &impl Model, formulation: Formulation, end: f64, rtol: f64) -> Vec<f64> {
    let mut scene = built(model, formulation, &[]);
    let state = later(scene.as_mut(), end, rtol);
    outputs(scene.as_mut(), &state)
}

/// Growth (1/s) and frequency (rad/s) of the lowest modes about the equilibrium.
fn found(scene: &mut dyn Scene, count: usize) -> (State, Vec<[f64; 2]>) {
    let state = steady(scene, 0.0).unwrap().state().unwrap().clone();
    let modes = modes(scene, &Uniform::steady(0.0), &state, Wanted { count }).unwrap();
    (state, modes.iter().map(|mode| [mode.re, mode.im]).collect())
}

#[test]
fn a_towed_cable_hangs_at_its_critical_angle() {
    let model = Tow::default();
    let mut scene = built(&model, Formulation::Rncf, &[]);
    let state = later(scene.as_mut(), 40.0, 1e-6);
    let row = outputs(scene.as_mut(), &state);
    let modes = modes(scene.as_mut(), &Uniform::at_rest(0.0), &state, Wanted { count: 2 }).unwrap();
    // Across the cable, at the angle a from the plumb line: w sin a = q cos^2 a.
    let weight = 3000.0 * std::f64::consts::PI * 0.01f64.powi(2) * 9.81;
    let ratio = 0.5 * 1000.0 * 1.2 * 0.02 * model.flow.powi(2) / weight;
    let sine = ((1.0 + 4.0 * ratio * ratio).sqrt() - 1.0) / (2.0 * ratio);
    let angle = row[0].atan2(-row[1]);
    assert!((angle - sine.asin()).abs() < 1e-7);
    // Along it the weight alone pulls.
    assert!(
        (row[2] / (weight * 10.0 * sine.asin().cos()) - 1.0).abs() < 1e-5,
        "{}",
        row[2]
    );
    assert!(modes.iter().all(|mode| mode.re < -1e-2));
}

#[test]
fn a_bar_gallops_where_lift_falls_faster_than_drag() {
    let mass = 500.0 * 0.02 * 0.06;
    for (slope, wind) in [(-4.0, 20.0), (2.0, 10.0)] {
        let model = Bar { wind, rise: slope };
        // Den Hartog: d = 1/2 rho c U (a + C_d) per length.
        let damping = 0.5 * 1.2 * 0.06 * wind * (slope + 1.1);
        for modes in [None, Some(Fidelity::Modal(3)), Some(Fidelity::Small(3))] {
            let fidelity: Vec<_> = modes.into_iter().map(|modes| ("bar".to_string(), modes)).collect();
            let mut scene = built(&model, Formulation::Rncf, &fidelity);
            let (_, modes) = found(scene.as_mut(), 2);
            for mode in &modes {
                // Rotary inertia of the sections is not damped.
                assert!((mode[0] / (-0.5 * damping / mass) - 1.0).abs() < 3e-3, "{mode:?}");
            }
        }
    }
}

#[test]
fn what_a_load_cannot_be_is_told_by_its_name() {
    // An angle of attack beyond the rows of the table.
    let model = Bar {
        wind: -20.0,
        ..Bar::default()
    };
    let mut scene = built(&model, Formulation::Rncf, &[]);
    let start = scene.rest(0.0);
    let integrator = Integrator::new(scene.as_mut(), start, 1.0, Method::Radau, Options::default());
    let message = integrator.err().unwrap().to_string();
    assert!(message.contains("the force of `air` is not finite"), "{message}");
    let point = [("bar".to_string(), Fidelity::Point)];
    let error = Bar::default().build_as(Formulation::Rncf, Joints::Eliminated, &point);
    let message = error.err().unwrap().message;
    assert!(
        message.contains("`air` acts along body `bar`, which is described as a point"),
        "{message}"
    );
}

#[test]
fn a_column_under_spread_thrust_flutters_at_the_load_of_leipholz() {
    let growth = |factor: f64| {
        let model = Column {
            thrust: factor,
            ..Column::default()
        };
        let mut scene = built(&model, Formulation::Rncf, &[]);
        let (state, modes) = found(scene.as_mut(), 4);
        let row = outputs(scene.as_mut(), &state);
        assert!((row[2] + factor).abs() < 1e-9 * factor, "{row:?}");
        modes.iter().map(|mode| mode[0]).fold(f64::NEG_INFINITY, f64::max)
    };
    // 40.05 EI/L^3.
    let [below, above] = [40.04, 40.06].map(growth);
    assert!(below < 1e-3 && above > 0.1, "{below} {above}");
}

#[test]
fn a_rod_falls_as_the_hyperbolic_tangent() {
    let mass = 7800.0 * std::f64::consts::PI * 0.005f64.powi(2);
    let last = (mass * 9.81 / 0.6f64).sqrt();
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let row = after(&Rods::default(), formulation, 1.5, 1e-7);
        let exact = -last * (9.81 * 1.5 / last).tanh();
        assert!((row[0] / exact - 1.0).abs() < 1e-6, "{} {exact}", row[0]);
    }
}

#[test]
fn a_moment_along_a_shaft_twists_it() {
    let model = Column {
        twist: 0.3,
        elements: 2,
        ..Column::default()
    };
    let mut scene = built(&model, Formulation::Rncf, &[]);
    let (state, _) = found(scene.as_mut(), 1);
    let row = outputs(scene.as_mut(), &state);
    // m = m0 x: T(x) = m0 (L^2 - x^2)/2, angle = m0 L^3 / (3 G J).
    let torsion = 200e9 / 2.6 * 0.5 * std::f64::consts::PI * 0.005f64.powi(4);
    assert!(
        (row[3].asin() / (0.3 * 8.0 / (3.0 * torsion)) - 1.0).abs() < 1e-4,
        "{}",
        row[3]
    );
    assert!((row[4] / (0.3 * (4.0 - 1.0) / 2.0) - 1.0).abs() < 1e-6, "{}", row[4]);
}

#[test]
fn a_rod_librates_about_the_line_to_the_point_that_attracts_it() {
    let (model, n, end) = (Orbit::default(), 0.1, 40.0);
    let row = after(&model, Formulation::Rncf, end, 1e-9);
    let start = outputs_at_start(&model);
    let ahead = row[4].atan2(row[3]);
    let within = row[1].atan2(row[0]) - ahead;
    // In the plane sqrt(3) n, out of it 2 n.
    assert!((within / model.tilt - (3f64.sqrt() * n * end).cos()).abs() < 2e-3);
    // 3 n^2 rho A times half the square of the half length, less the tilt.
    let mass = 1000.0 * std::f64::consts::PI * 0.005f64.powi(2);
    assert!((row[6] / (1.5 * n * n * mass) - 1.0).abs() < 1e-3, "{}", row[6]);
    assert!((row[7] / model.tilt + (2.0 * n * end).cos()).abs() < 2e-3, "{}", row[7]);
    for axis in 8..11 {
        assert!((row[axis] - start[axis]).abs() < 1e-9 * start[10].abs());
    }
}

fn outputs_at_start(model: &impl Model) -> Vec<f64> {
    let mut scene = built(model, Formulation::Rncf, &[]);
    let start = scene.rest(0.0);
    outputs(scene.as_mut(), &start)
}
