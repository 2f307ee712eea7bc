//! Equilibria of bodies that move freely, in uniform rotation and at rest, against closed forms.

use rncf::app::{EquilibriumSettings, Range, campbell, modes, static_equilibria, steady as equilibria_of};
use rncf::equilibrium::{Negative, Uniform, continue_from, critical_factor, follow, static_load};
use rncf::{Formulation, Joints, Method, Model, Scene, SolveError, State, steady};
use rncf_models::FlyballGovernor;

use crate::runs::{WAYS, adaptive, grid, states_at};

const G: f64 = 9.81;

rncf::model! {
    /// A pendulum on the rim of a carousel that is driven uniformly.
    model Carousel {
        param omega = 3 rad/s;
        param rim = 1 m;
        param start = 0.6 rad;
        frame carousel = rotating(axis = z, angle = omega * t + 1 rad);
        rigid bob in carousel {
            mass = 2 kg;
            inertia = [0.1, 0.1, 0.1] kg*m^2;
            center = [0, 0, -0.5] m;
            origin = [rim, 0, 0];
            axis = y;
            angle = -start;
        }
        joint hinge = revolute(carousel.at([rim, 0, 0]), bob.at([0, 0, 0] m), axis = y);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output phi = asin(-bob.ez.in(carousel).x);
        output across = bob.ez.in(carousel).y;
        output hold = hinge.force;
    }
}

rncf::model! {
    /// The same on a hub that a motor drives.
    model Driven {
        param omega = 3 rad/s;
        param late = 0 rad/s^2;
        param start = 0.6 rad;
        rigid hub { mass = 1 kg; inertia = [1, 2, 2.5] kg*m^2; angular_velocity = [0, 0, omega]; }
        rigid bob {
            mass = 2 kg;
            inertia = [0.1, 0.1, 0.1] kg*m^2;
            center = [0, 0, -0.5] m;
            origin = [1, 0, 0] m;
            axis = y;
            angle = -start;
            velocity = [0, omega * 1 m, 0];
            angular_velocity = [omega * sin(start), 0, omega * cos(start)];
        }
        joint bearing = revolute(inertial.at([0, 0, 0] m), hub, axis = z);
        joint motor = drive(bearing.angle, omega * t + late * t^2);
        joint hinge = revolute(hub.at([1, 0, 0] m), bob.at([0, 0, 0] m), axis = y);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output phi = asin(-bob.ez.in(hub).x);
        output torque = motor.moment.z;
    }
}

rncf::model! {
    /// A rigid rotor in two elastic bearings; one may be beside the axis.
    model Borne {
        param omega = 30 rad/s;
        param beside = 0 m;
        rigid rotor { mass = 2 kg; inertia = [0.3, 0.3, 0.5] kg*m^2; angular_velocity = [0, 0, omega]; }
        spring lower = linear(inertial.at([beside, 0, -1 m]), rotor.at([0, 0, -0.4] m), stiffness = 1000 N/m, length = 0.5 m);
        spring upper = linear(inertial.at([0, 0, 1] m), rotor.at([0, 0, 0.4] m), stiffness = 1000 N/m, length = 0.5 m);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output z = rotor.z;
        output tilt = norm(cross(rotor.ez, inertial.ez));
    }
}

rncf::model! {
    /// A cable that hangs on a hub which turns about the cable.
    model Hung {
        param omega = 0.5 rad/s;
        param pull = 0 N;
        param elements: count = 4;
        material rubber { density = 1000 kg/m^3; young = 1 MPa; }
        section cord { area = 1 cm^2; second_moment = 2 cm^4; }
        frame hub = rotating(axis = z, angle = omega * t);
        body cable in hub {
            spatial;
            line from [0, 0, 0] m to [0, 0, -2] m;
            mesh elements * cable(cord, rubber);
        }
        joint top = clamp(cable.start, hub);
        load weight = gravity([0, 0, -9.81] m/s^2);
        load end = force(cable.end, [0, 0, -pull]);
        output u = -cable.end.z - 2 m;
        output x = cable.end.x;
    }
}

rncf::model! {
    /// A column, clamped below, pressed from above by a dead load.
    model Column {
        param load_at_top = 6 N;
        param elements: count = 8;
        material stiff { density = 1000 kg/m^3; young = 10 GPa; }
        section strip { area = 10 cm^2; second_moment = 1e-9 m^4; }
        body column { spatial; line from [0, 0, 0] m to [0, 0, 2] m; mesh elements * cable(strip, stiff); }
        joint foot = clamp(column.start, inertial);
        load press = force(column.end, [0, 0, -load_at_top]);
        output top = column.end.z;
    }
}

rncf::model! {
    /// Two springs that meet at a mass above the line between their feet.
    model Truss {
        param press = 40 N;
        rigid tip { plane xy; mass = 1 kg; origin = [0, 0.3, 0] m; }
        spring left = linear(inertial.at([-1, 0, 0] m), tip, stiffness = 1000 N/m, length = sqrt(1.09) * 1 m);
        spring right = linear(inertial.at([1, 0, 0] m), tip, stiffness = 1000 N/m, length = sqrt(1.09) * 1 m);
        load push = force(tip, [0, -press, 0]);
        output height = tip.y;
    }
}

rncf::model! {
    /// A flexible blade on a rigid hub that turns freely.
    model Whirl {
        param omega = 20 rad/s;
        param elements: count = 3;
        material rubber { density = 1000 kg/m^3; young = 5 MPa; }
        section strip { area = 4 cm^2; second_moment = 4 cm^4; }
        rigid hub { mass = 2 kg; inertia = [0.2, 0.2, 0.3] kg*m^2; angular_velocity = [0, 0, omega]; }
        body blade in hub { spatial; line from [0.2, 0, 0] m to [1.2, 0, 0] m; mesh elements * cable(strip, rubber); }
        body other in hub { spatial; line from [-0.2, 0, 0] m to [-1.2, 0, 0] m; mesh elements * cable(strip, rubber); }
        joint root = clamp(blade.start, hub);
        joint root_2 = clamp(other.start, hub);
        output tip = blade.end.x;
        output spin = hub.angular_velocity.z;
        output x = hub.x;
    }
}

fn referenced(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

fn outputs(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Vec<f64> {
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(at, state, &mut row);
    row
}

fn text(outcome: Result<impl std::fmt::Debug, SolveError>) -> String {
    outcome.unwrap_err().to_string()
}

/// Root of a function that changes sign.
fn root(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let sign = f(low) > 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// `g tan(phi) = w^2 (R + l sin(phi))`
fn pendulum(omega: f64, rim: f64) -> f64 {
    root(0.0, 1.57, |phi| G * phi.tan() - omega * omega * (rim + 0.5 * phi.sin()))
}

#[test]
fn pendulum_on_a_carousel() {
    for omega in [0.5, 3.0, 6.0] {
        let exact = pendulum(omega, 1.0);
        let model = Carousel {
            omega,
            start: exact - 0.2,
            ..Carousel::default()
        };
        let mut scene = referenced(&model);
        for t in [0.0, 7.3] {
            let at = Uniform::steady(t);
            let found = steady(scene.as_mut(), t).unwrap();
            let row = outputs(scene.as_mut(), &at, found.state().unwrap());
            println!(
                "{omega} rad/s, t = {t} s: phi - exact {:.1e}, {row:?}, {} steps",
                row[0] - exact,
                found.path.len()
            );
            assert!((row[0] - exact).abs() < 1e-12 && row[1].abs() < 1e-12);
            let centrifugal = 2.0 * omega * omega * (1.0 + 0.5 * exact.sin());
            let hold = row[2].hypot(row[3]);
            assert!((hold - centrifugal).abs() < 1e-9 && (row[4].abs() - 2.0 * G).abs() < 1e-9);
        }
    }
}

/// From the equilibrium nothing moves in the carousel, in any formulation.
#[test]
fn motion_from_an_equilibrium_stays_in_it() {
    let exact = pendulum(3.0, 1.0);
    let mut scene = referenced(&Carousel::default());
    let found = steady(scene.as_mut(), 0.0).unwrap();
    let frame = scene.frame_state(found.state().unwrap());
    let whirl = Whirl::default();
    let mut hub = referenced(&whirl);
    let turning = steady(hub.as_mut(), 0.0).unwrap();
    let blades = hub.frame_state(turning.state().unwrap());
    let tip = outputs(hub.as_mut(), &Uniform::steady(0.0), turning.state().unwrap())[0];
    for (formulation, joints) in WAYS {
        let stays = |model: &dyn Fn() -> Box<dyn Scene>, frame, expected: &[f64], allowed: f64| {
            let mut scene = model();
            let start = scene.state_of_frame(frame);
            let (states, _) = states_at(scene.as_mut(), start, Method::Radau, adaptive(1e-8), &grid(0.1, 0.5));
            let mut row = vec![0.0; scene.output_columns()];
            let mut moved: f64 = 0.0;
            for state in &states {
                scene.outputs(state, &mut row);
                moved = row
                    .iter()
                    .zip(expected)
                    .fold(moved, |moved, (a, b)| moved.max((a - b).abs()));
            }
            println!("{formulation:?} {joints:?}: moves by {moved:.1e}");
            assert!(moved < allowed, "{moved}");
        };
        let model = Carousel::default();
        stays(
            &|| model.build(formulation, joints).unwrap(),
            &frame,
            &[exact, 0.0],
            1e-6,
        );
        stays(
            &|| whirl.build(formulation, joints).unwrap(),
            &blades,
            &[tip, 20.0],
            1e-5,
        );
    }
}

/// A motor at a constant rate is a relative equilibrium at any time; one that speeds up is not.
#[test]
fn pendulum_on_a_driven_hub() {
    let exact = pendulum(3.0, 1.0);
    let mut scene = referenced(&Driven::default());
    for t in [0.0, 1.0, 11.0] {
        let found = steady(scene.as_mut(), t).unwrap();
        let row = outputs(scene.as_mut(), &Uniform::steady(t), found.state().unwrap());
        println!("t = {t}: {:.1e}, torque {:.1e}", row[0] - exact, row[1]);
        assert!((row[0] - exact).abs() < 1e-12 && row[1].abs() < 1e-9);
    }
    let late = Driven {
        late: 0.2,
        ..Driven::default()
    };
    let refused = text(steady(referenced(&late).as_mut(), 1.0));
    assert!(refused.contains("joint `motor`"), "{refused}");
}

/// Angle of the governor's arms below the horizontal and height of its slider, from the balance of the
/// slider and of the moments about a pin.
fn governor(omega: f64) -> [f64; 2] {
    let (rod, ball, slider, stiffness): (f64, f64, f64, f64) = (0.3, 5.0, 3.0, 8e5);
    let across = rod * 1.0001 / 12.0 + rod * 0.25 + ball;
    let along = rod * 2e-4 / 12.0;
    // Height of the arm's middle above the slider, where half the slider hangs on the strut.
    let below = |alpha: f64| {
        let tension = |dz: f64| {
            let length = (0.5 * alpha.cos()).hypot(dz);
            stiffness * (length - 0.5) * dz / length - 0.5 * slider * G
        };
        root(
            (0.5_f64.powi(2) - (0.5 * alpha.cos()).powi(2)).sqrt() * 0.99,
            0.6,
            tension,
        )
    };
    let moment = |alpha: f64| {
        let dz = below(alpha);
        let length = (0.5 * alpha.cos()).hypot(dz);
        let tension = stiffness * (length - 0.5) / length;
        0.5 * tension * alpha.cos() * (0.5 * alpha.sin() + dz) + G * alpha.cos() * (0.5 * rod + ball)
            - omega * omega * (0.05 * alpha.sin() * (0.5 * rod + ball) + alpha.sin() * alpha.cos() * (across - along))
    };
    let alpha = root(0.2, 1.2, moment);
    [alpha, 1.0 - 0.5 * alpha.sin() - below(alpha)]
}

#[test]
fn flyball_governor() {
    let mut guess: Option<State> = None;
    for omega in [5.2, 5.0, 4.8, 4.6] {
        let model = FlyballGovernor { omega_0: omega };
        let [alpha, height] = governor(omega);
        let mut scene = referenced(&model);
        let at = Uniform::steady(0.0);
        // The first from the start, the others from the one before.
        let state = match &guess {
            None => steady(scene.as_mut(), 0.0).unwrap().state().unwrap().clone(),
            Some(guess) => continue_from(scene.as_mut(), &at, guess).unwrap().state,
        };
        let row = outputs(scene.as_mut(), &at, &state);
        println!(
            "{omega} rad/s: {row:?}, errors {:.1e}, {:.1e}",
            row[0] - alpha,
            row[1] - height
        );
        assert!((row[0] - alpha).abs() < 1e-9 && (row[1] - height).abs() < 1e-9);
        assert!((row[2] - omega).abs() < 1e-12);
        guess = Some(state);
    }
}

#[test]
fn rotor_in_elastic_bearings() {
    let mut scene = referenced(&Borne::default());
    let found = steady(scene.as_mut(), 0.0).unwrap();
    let row = outputs(scene.as_mut(), &Uniform::steady(0.0), found.state().unwrap());
    // Both springs together carry the weight.
    assert!((row[0] + 2.0 * G / 2000.0).abs() < 1e-13 && row[1] < 1e-13, "{row:?}");
    let beside = Borne {
        beside: 0.1,
        ..Borne::default()
    };
    let mut scene = referenced(&beside);
    let refused = text(steady(scene.as_mut(), 0.0));
    assert!(refused.contains("force `lower` does not stay the same"), "{refused}");
    // At rest it does no harm.
    static_load(scene.as_mut(), 0.0).unwrap();
}

/// Stretch of a bar with the force N: `EA/2 (s^2 - 1) s = N`.
fn stretch(force: f64) -> f64 {
    root(1.0, 1.6, |s| 50.0 * (s * s - 1.0) * s - force)
}

#[test]
fn cable_under_its_weight_and_an_end_force() {
    // Midpoint rule with many points on the cable.
    let elongation = |pull: f64| -> f64 {
        let count = 20_000;
        let at = |i: usize| 2.0 * (i as f64 + 0.5) / count as f64;
        let one = |i: usize| stretch(pull + 0.1 * G * (2.0 - at(i))) - 1.0;
        (0..count).map(one).sum::<f64>() * 2.0 / count as f64
    };
    for pull in [0.0, 3.0] {
        let model = Hung {
            pull,
            elements: 6,
            ..Hung::default()
        };
        let mut scene = referenced(&model);
        let exact = elongation(pull);
        let turning = steady(scene.as_mut(), 0.0).unwrap();
        let still = static_load(scene.as_mut(), 0.0).unwrap();
        for (found, at) in [(&turning, Uniform::steady(0.0)), (&still, Uniform::at_rest(0.0))] {
            let row = outputs(scene.as_mut(), &at, found.state().unwrap());
            println!("{pull} N, {:?}: u {:.9e}, exact {exact:.9e}", at.kind, row[0]);
            assert!((row[0] - exact).abs() < 1e-7 && row[1].abs() < 1e-12, "{row:?}");
        }
        assert_eq!(still.path.last().unwrap().negative, Negative::Counted(0));
        assert_eq!(turning.path.last().unwrap().negative, Negative::Even);
    }
    // Along the path the parts of the load are those asked for.
    let mut scene = referenced(&Hung::default());
    let mut scales = Vec::new();
    follow(scene.as_mut(), &Uniform::at_rest(0.0), 0.25, |_, step| {
        scales.push(step.scale)
    })
    .unwrap();
    assert_eq!(scales, [0.25, 0.5, 0.75, 1.0]);
}

#[test]
fn column_buckles_at_eulers_load() {
    let euler = std::f64::consts::PI.powi(2) * 10.0 / 16.0;
    for load_at_top in [5.0, 8.0] {
        let model = Column {
            load_at_top,
            ..Column::default()
        };
        let mut scene = referenced(&model);
        let found = critical_factor(scene.as_mut(), 0.0).unwrap();
        println!(
            "{load_at_top} N: {:?} of Euler's {euler:.6} N",
            found.as_ref().map(|c| c.factor * load_at_top)
        );
        if load_at_top < euler {
            assert!(found.is_none());
            continue;
        }
        let found = found.unwrap();
        assert!(!found.is_limit && (found.factor * load_at_top / euler - 1.0).abs() < 1e-5);
        // In space it buckles in two directions at once.
        let path = static_load(scene.as_mut(), 0.0).unwrap();
        assert_eq!(path.path.last().unwrap().negative, Negative::Counted(2));
    }
}

#[test]
fn truss_snaps_through_at_its_limit_point() {
    // Force at the height h: 2 k (l0 / l - 1) h; largest at l^3 = l0.
    let free = 1.09_f64.sqrt();
    let length = free.cbrt();
    let height = (length * length - 1.0).sqrt();
    let limit = 2000.0 * (free / length - 1.0) * height;
    let mut scene = referenced(&Truss::default());
    let found = critical_factor(scene.as_mut(), 0.0).unwrap().unwrap();
    println!("limit {:.9} N of {limit:.9} N", 40.0 * found.factor);
    assert!(
        found.is_limit && (40.0 * found.factor / limit - 1.0).abs() < 1e-5,
        "{found:?}"
    );
    let error = text(static_load(scene.as_mut(), 0.0));
    assert!(error.contains("of the load") && error.contains("tip"), "{error}");
    // Long steps do not leap to the truss that hangs either.
    for largest in [0.1, 0.3, 1.0] {
        let error = text(follow(scene.as_mut(), &Uniform::at_rest(0.0), largest, |_, _| ()));
        assert!(error.contains("of the load") && error.contains("tip"), "{error}");
    }
    let half = Truss { press: 0.5 * limit };
    let mut scene = referenced(&half);
    let found = static_load(scene.as_mut(), 0.0).unwrap();
    let row = outputs(scene.as_mut(), &Uniform::at_rest(0.0), found.state().unwrap());
    let exact = root(height, 0.3, |h| {
        2000.0 * (free / (1.0 + h * h).sqrt() - 1.0) * h - 0.5 * limit
    });
    assert!((row[0] - exact).abs() < 1e-12, "{row:?} {exact}");
    assert!(critical_factor(scene.as_mut(), 0.0).unwrap().is_none());
}

rncf::model! {
    /// A driven blade that a jet pushes up where its tip passes the x axis, and one in a jet all around the axis.
    model Blown {
        param width = 5 mm;
        param around = 0 N;
        param beside = 1 kN;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section rod = rectangle(y = 5 cm, z = 5 cm);
        frame rotor = rotating(axis = z, angle = 20 [rad/s] * t);
        body blade in rotor { spatial; line from [0, 0.5, 0] m to [0, 3, 0] m; mesh 6 * beam(rod, steel); }
        joint root = clamp(blade.start, rotor);
        load jet = force(blade.end, [0, 0, beside * exp(-(blade.end.in(inertial).y / width)^2)]);
        load ring = force(blade.end, [0, 0, around * exp(-((norm(blade.end.in(inertial)) - 3 m) / 1 m)^2)]);
        output up = blade.end.z;
    }
}

/// What acts at one angle alone lets nothing be at rest in a turning frame, however narrow it is, and though it couples that frame with no other.
#[test]
fn a_jet_beside_the_axis_lets_no_blade_be_in_equilibrium() {
    for width in [5e-3, 5.0] {
        let blown = Blown {
            width,
            ..Blown::default()
        };
        let refused = text(steady(referenced(&blown).as_mut(), 0.0));
        assert!(
            refused.contains("force `jet` does not stay the same"),
            "{width} m: {refused}"
        );
    }
    let ring = Blown {
        beside: 0.0,
        around: 10.0,
        ..Blown::default()
    };
    let mut scene = referenced(&ring);
    let found = steady(scene.as_mut(), 0.0).unwrap();
    let row = outputs(scene.as_mut(), &Uniform::steady(0.0), found.state().unwrap());
    assert!(row[0] > 1e-6, "{row:?}");
}

mod bumped {
    rncf::model! {
        /// A cart on a spring under a harmonic force.
        pub model Bumped {
            param k = 200 N/m;
            rigid cart { plane xy; mass = 5 kg; inertia = 1 kg*m^2; }
            joint guide = prismatic(inertial, cart, axis = x);
            spring mount = coordinate(guide.slide, stiffness = k);
            load bump = force(cart, [30 N * sin(4*pi * t / 1 s), 0 N, 0 N]);
            output x = cart.x;
            run { t_end = 5.1 s; }
        }
    }
}

mod driven {
    rncf::model! {
        /// A bob that slides on a hub, which a drive turns.
        pub model Driven {
            param w = 2 rad/s;
            rigid hub { mass = 5 kg; inertia = [1, 1, 2] kg*m^2; angular_velocity = [0, 0, 1] * w; }
            joint axle = revolute(inertial.at([0, 0, 0] m), hub, axis = z);
            joint motor = drive(axle.angle, w * t);
            rigid bob {
                mass = 5 kg; inertia = [1, 1, 2] kg*m^2; origin = [1, 0, 0] m;
                velocity = [0, w * 1 m, 0]; angular_velocity = [0, 0, 1] * w;
            }
            joint guide = prismatic(hub.at([1, 0, 0] m), bob, axis = x);
            spring coil = coordinate(guide.slide, stiffness = 200 N/m);
            output x = guide.slide;
            run { t_end = 1 s; }
        }
    }
}

/// What changes with time is taken as it is at the time of the equilibrium, and told.
#[test]
fn equilibria_at_rest_hold_what_changes_with_time() {
    let told = "What changes with time is taken as it is at t = 5.1 s (`--at`): force `bump`";
    let (model, settings) = (bumped::Bumped::default(), EquilibriumSettings::default());
    let found = modes(&model, &settings).unwrap();
    assert!((found.modes[0].im - 40.0_f64.sqrt()).abs() < 1e-9, "{:?}", found.modes);
    assert_eq!(found.warnings, [told]);
    for rests in [static_equilibria(&model, &settings), equilibria_of(&model, &settings)] {
        let rests = rests.unwrap();
        let x = rests.history.column(0).last().unwrap();
        let exact = 30.0 * (20.4 * std::f64::consts::PI).sin() / 200.0;
        assert!((x - exact).abs() < 1e-9, "{x} for {exact}");
        assert_eq!(rests.warnings, [told]);
    }
    let range = Range {
        param: 0,
        from: 200.0,
        to: 300.0,
    };
    let ranged = EquilibriumSettings {
        range: Some(range),
        ..settings
    };
    assert_eq!(campbell(&model, &ranged).unwrap().warnings, [told]);
}

/// A drive that turns with the rest is the same at every time: `x = m w^2 / (k - m w^2)`, and `nu^2 = k / m - w^2`.
#[test]
fn a_drive_that_turns_with_the_rest_is_not_told() {
    let (model, settings) = (driven::Driven::default(), EquilibriumSettings::default());
    let found = modes(&model, &settings).unwrap();
    assert!((found.modes[0].im - 6.0).abs() < 1e-9, "{:?}", found.modes);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let turns = equilibria_of(&model, &settings).unwrap();
    let x = turns.history.column(0).last().unwrap();
    assert!((x - 20.0 / 180.0).abs() < 1e-9, "{x}");
    assert!(turns.warnings.is_empty(), "{:?}", turns.warnings);
}
