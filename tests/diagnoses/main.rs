//! What is said of mechanisms that cannot move as they are declared: by name, and with what to do.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Statistics};

/// The message of the start, or the counts of one that succeeds.
fn start<M: Model>(model: &M, formulation: Formulation) -> Result<Statistics, String> {
    let mut scene = model
        .build(formulation, Joints::Eliminated)
        .map_err(|error| error.to_string())?;
    let rest = scene.rest(0.0);
    Integrator::new(scene.as_mut(), rest, 1.0, Method::Radau, Options::default())
        .map(|integrator| integrator.statistics().clone())
        .map_err(|error| error.to_string())
}

/// The message of a start that fails.
fn refused<M: Model>(model: &M) -> String {
    start(model, Formulation::Rncf).expect_err("the model is refused")
}

/// Fails where a part is missing.
#[track_caller]
fn contains(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "`{part}` is missing in: {text}");
    }
    let unreadable = ["NaN", "Some(", "Err(", "{", "inf"];
    assert!(!unreadable.iter().any(|part| text.contains(part)), "{text}");
}

mod computed;
mod limits;
mod senseless;

mod redundant {
    rncf::model! {
        /// Bricard's mechanism with six revolute joints.
        pub model AllRevolute {
            const m = 1 kg;
            const along = 1 kg * (0.02 [m^2]) / 12;
            const across = 1 kg * (1.01 [m^2]) / 12;
            rigid p01 { mass = m; inertia = [along, across, across]; center = [0.5, 0, 0] m; }
            rigid p12 { mass = m; inertia = [across, along, across]; center = [0, -0.5, 0] m; origin = [1, 0, 0] m; }
            rigid p23 { mass = m; inertia = [across, across, along]; center = [0, 0, 0.5] m; origin = [1, -1, 0] m; }
            rigid p34 { mass = m; inertia = [along, across, across]; center = [-0.5, 0, 0] m; origin = [1, -1, 1] m; }
            rigid p45 { mass = m; inertia = [across, along, across]; center = [0, 0.5, 0] m; origin = [0, -1, 1] m; }
            joint p0 = revolute(p01, inertial.at([0, 0, 0] m), axis = y);
            joint p1 = revolute(p01.at([1, 0, 0] m), p12.at([0, 0, 0] m), axis = z);
            joint p2 = revolute(p12.at([0, -1, 0] m), p23.at([0, 0, 0] m), axis = x);
            joint p3 = revolute(p23.at([0, 0, 1] m), p34.at([0, 0, 0] m), axis = y);
            joint p4 = revolute(p34.at([-1, 0, 0] m), p45.at([0, 0, 0] m), axis = z);
            joint p5 = revolute(p45.at([0, 1, 0] m), inertial.at([0, 0, 1] m), axis = x);
            output x = p34.x;
        }
    }
    rncf::model! {
        /// A door on two hinges of one axis.
        pub model Door {
            /// Place of the upper hinge across the axis.
            param shift = 0 m;
            rigid door { mass = 20 kg; inertia = [7, 9, 2] kg*m^2; center = [0.5, 0, 1] m; }
            joint lower = revolute(door.at([0, 0, 0.2] m), inertial.at([0, 0, 0.2] m), axis = z);
            joint upper = revolute(door.at([0, 0, 1.8] m), inertial.at([0 m, shift, 1.8 m]), axis = z);
            output x = door.center.x;
        }
    }
    rncf::model! {
        /// The same door, on what is left of the two hinges: one, and nothing else.
        pub model DoorOnOne {
            rigid door { mass = 20 kg; inertia = [7, 9, 2] kg*m^2; center = [0.5, 0, 1] m; }
            joint lower = revolute(door.at([0, 0, 0.2] m), inertial.at([0, 0, 0.2] m), axis = z);
            output x = door.center.x;
        }
    }
    rncf::model! {
        /// A parallel crank whose coupler is also kept from turning: the parallelogram does that already.
        pub model Parallel {
            rigid left { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0, 0.5, 0] m; }
            rigid right { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0, 0.5, 0] m; origin = [2, 0, 0] m; }
            rigid coupler { plane xy; mass = 1 kg; inertia = 0.3 kg*m^2; center = [1, 0, 0] m; origin = [0, 1, 0] m; }
            joint a = revolute(left, inertial.at([0, 0, 0] m));
            joint b = revolute(right, inertial.at([2, 0, 0] m));
            joint c = revolute(left.at([0, 1, 0] m), coupler.at([0, 0, 0] m));
            joint d = revolute(right.at([0, 1, 0] m), coupler.at([2, 0, 0] m));
            joint rail = prismatic(coupler, inertial.at([0, 1, 0] m), axis = x);
            output x = coupler.x;
        }
    }
    rncf::model! {
        /// One condition written twice.
        pub model Twice {
            rigid ball { mass = 1 kg; }
            constraint floor = ball.z;
            constraint ground = 2 * ball.z;
            output x = ball.x;
        }
    }
    rncf::model! {
        /// A slider-crank's rod whose cross axis lies along x (THEORY 9.4).
        pub model CrossAxis {
            /// Turns the cross axis from the crank's tangent towards x.
            param tilt = 0 deg;
            const crank = 0.14 m;
            const length = 0.3 m;
            const radius = 8 mm;
            material soft { density = 7870 kg/m^3; young = 0.2 GPa; }
            section round { area = pi * radius^2; second_moment = pi * radius^4 / 4; }
            motion theta(t) = 8 [rad/s^2] * t^2;
            frame pin_frame = moving(origin = [0, -crank * sin(theta(t)), crank * (cos(theta(t)) - 1)]);
            frame rod in pin_frame = turning();
            body beam in rod {
                spatial;
                line from [0, 0, 0] m to [length, 0, 0];
                mesh 4 * cable(round, soft, bending = exact);
            }
            joint _root = clamp(beam.start, rod);
            constraint cross_axis = dot([sin(tilt), cos(tilt) * cos(theta(t)), cos(tilt) * sin(theta(t))], rod.ez);
            fixture slider on beam.end { mass = 0.08 kg; }
            constraint guide_y = beam.end.in(inertial).y;
            constraint guide_z = beam.end.in(inertial).z;
            output x_slider = beam.end.in(inertial).x;
        }
    }
}

mod massless {
    rncf::model! {
        /// A rod about its own axis: nothing but a spherical joint holds it, and it has no inertia about it.
        pub model Needle {
            /// Moment of inertia about the rod.
            param about = 0 kg*m^2;
            rigid rod { mass = 1 kg; inertia = [1e-3 [kg*m^2] + about, 0.1 [kg*m^2], 0.1 [kg*m^2]]; center = [0.5, 0, 0] m; }
            joint foot = spherical(rod, inertial.at([0, 0, 0] m));
            output x = rod.center.x;
        }
    }
}

mod values {
    rncf::model! {
        /// A ball on a rod of given length, begun at a given place with a given velocity.
        pub model Pendulum {
            /// Where it begins.
            param x_0 = 1 m;
            /// How fast.
            param v_0 = 0 m/s;
            rigid ball { mass = 1 kg; origin = [x_0, 0, 0]; velocity = [v_0, 2 [m/s], 0 [m/s]]; }
            joint string = distance(ball, inertial.at([0, 0, 0] m), length = 1 m);
            load weight = gravity([0, 0, -9.81] m/s^2);
            output x = ball.x;
        }
    }
    rncf::model! {
        /// Two balls on a spring.
        pub model Struts {
            /// Where the second ball begins.
            param gap = 1 m;
            rigid first { mass = 1 kg; }
            rigid second { mass = 1 kg; origin = [gap, 0, 0]; }
            spring strut = linear(first, second, stiffness = 10 [N/m], length = 1 m);
            output x = second.x;
        }
    }
    rncf::model! {
        /// A ball kept at a distance by a norm.
        pub model Norm {
            /// Where it begins.
            param x_0 = 1 m;
            rigid ball { mass = 1 kg; origin = [x_0, 0, 0]; }
            constraint leash = norm(ball.position) - 1 m;
            output x = ball.x;
        }
    }
    rncf::model! {
        /// Masses from parameters.
        pub model Masses {
            /// Mass of the arm.
            param arm_mass = 1 kg;
            /// Its moment of inertia about x.
            param j = 0.1 kg*m^2;
            /// Mass of a disc.
            param disc_mass = 1 kg;
            /// Its moment of inertia.
            param disc_inertia = 0.1 kg*m^2;
            /// Mass of a ball on the arm.
            param ball_mass = 1 kg;
            /// Mass at the end of the beam.
            param tip_mass = 1 kg;
            material steel { density = 7850 kg/m^3; young = 210 GPa; }
            section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
            rigid arm { mass = arm_mass; inertia = [j, 0.1 [kg*m^2], 0.1 [kg*m^2]]; }
            rigid disc { plane xy; mass = disc_mass; inertia = disc_inertia; }
            fixture ball on arm.at([1, 0, 0] m) { mass = ball_mass; }
            body beam in inertial {
                spatial;
                line from [0, 0, 0] m to [1, 0, 0] m;
                mesh 2 * cable(wire, steel);
            }
            joint root = clamp(beam.start, inertial);
            fixture tip on beam.end { mass = tip_mass; }
            output x = arm.x;
            output disc_x = disc.x;
            output tip_x = beam.end.x;
        }
    }
}

use massless::Needle;
use redundant::{AllRevolute, CrossAxis, Door, DoorOnOne, Parallel, Twice};
use values::{Masses, Norm, Pendulum, Struts};

#[test]
fn joints_that_take_a_freedom_twice_are_named_with_what_to_weaken() {
    contains(
        &refused(&AllRevolute::default()),
        &[
            "one constraint is redundant",
            "`p0`",
            "`p1`",
            "`p2`",
            "`p3`",
            "`p4`",
            "joint `p5` (revolute)",
            "weaken it",
        ],
    );
    // Bricard's mechanism with the last joint weakened starts.
    start(&rncf_models::Bricard::default(), Formulation::Rncf).unwrap();
    contains(
        &refused(&Door::default()),
        &[
            "5 constraints are redundant",
            "joint `upper` (revolute)",
            "`lower` (revolute)",
            "leave it out",
        ],
    );
    // A hinge beside the axis does not get that far off by itself: redundant all the same.
    contains(&refused(&Door { shift: 1e-3 }), &["`upper`", "redundant"]);
    start(&DoorOnOne::default(), Formulation::Rncf).unwrap();
    contains(
        &refused(&Parallel::default()),
        &["joint `rail` (prismatic)", "`a`", "`b`", "leave it out"],
    );
    contains(
        &refused(&Twice::default()),
        &["constraint `ground`", "constraint `floor`", "leave it out"],
    );
}

#[test]
fn a_cross_axis_along_x_is_singular_at_the_start() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        start(&CrossAxis::default(), formulation).unwrap();
        let tilt = std::f64::consts::FRAC_PI_2;
        let text = start(&CrossAxis { tilt }, formulation).expect_err("the rod can turn about its axis");
        contains(&text, &["at t = 0 s"]);
        assert!(
            text.contains("`cross_axis`") || text.contains("frame `rod`, rotation about x"),
            "{text}"
        );
    }
}

#[test]
fn motion_without_inertia_is_named() {
    start(&Needle::default(), Formulation::Rncf).unwrap();
    contains(
        &refused(&Needle { about: -1e-3 }),
        &["rigid body `rod`, rotation about x", "no inertia"],
    );
}

#[test]
fn starts_slightly_off_are_corrected_and_others_refused() {
    let corrections = |x_0: f64, v_0: f64| {
        let statistics = start(&Pendulum { x_0, v_0 }, Formulation::Rncf).unwrap();
        [statistics.position_correction, statistics.velocity_correction]
    };
    let near = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-3 * expected, "{value:e}");
    assert_eq!(corrections(1.0, 0.0), [0.0; 2]);
    near(corrections(1.0003, 0.0)[0], 3e-4);
    near(corrections(1.0, 1e-3)[1], 1e-3);
    let pendulum = |x_0: f64, v_0: f64| refused(&Pendulum { x_0, v_0 });
    contains(&pendulum(1.3, 0.0), &["violates", "joint `string` (distance)"]);
    let text = pendulum(1.0, 0.5);
    contains(
        &text,
        &[
            "violates its constraints by 0.5",
            "the rate of joint `string` (distance)",
        ],
    );
}

rncf::model! {
    /// A body that is driven from an angle which it has not.
    pub model Driven {
        param ahead = 0.3 rad;
        rigid body { mass = 1 kg; inertia = [1, 1, 1] g*m^2; }
        joint bearing = revolute(inertial.at([0, 0, 0] m), body, axis = z);
        joint motor = drive(bearing.angle, ahead + 0.1 [rad/s] * t);
        output angle = bearing.angle;
    }
}

#[test]
fn a_drive_that_begins_elsewhere_is_told_where_to_begin() {
    contains(
        &refused(&Driven::default()),
        &[
            "violates its constraints by 0.29552",
            "let what the drive prescribes begin with",
            "`motor`",
        ],
    );
    contains(
        &refused(&Driven { ahead: 0.0 }),
        &["violates its constraints by 0.1", "begins with a speed", "`motor`"],
    );
}

#[test]
fn what_has_no_value_is_named() {
    contains(
        &refused(&Pendulum { x_0: 0.0, v_0: 0.0 }),
        &["joint `string` (distance)", "move its points apart"],
    );
    contains(
        &refused(&Struts { gap: 0.0 }),
        &["the force of `strut` is not finite", "move its points apart"],
    );
    contains(
        &refused(&Norm { x_0: 0.0 }),
        &["constraint `leash`", "no finite derivative"],
    );
}

#[test]
fn impossible_masses_from_parameters_are_refused_by_name() {
    let given = Masses::default;
    start(&given(), Formulation::Rncf).unwrap();
    let cases: [(Masses, &[&str]); 7] = [
        (
            Masses {
                arm_mass: -1.0,
                ..given()
            },
            &["rigid body `arm`", "mass is -1 kg"],
        ),
        (
            Masses {
                arm_mass: 0.0,
                ..given()
            },
            &["rigid body `arm`", "greater than zero"],
        ),
        (
            Masses { j: 0.3, ..given() },
            &["rigid body `arm`", "no body has the inertia [0.3, 0.1, 0.1, 0.0"],
        ),
        (
            Masses {
                disc_mass: -1.0,
                ..given()
            },
            &["rigid body `disc`", "mass is -1 kg"],
        ),
        (
            Masses {
                disc_inertia: -1.0,
                ..given()
            },
            &["rigid body `disc`", "inertia is -1 kg*m^2"],
        ),
        (
            Masses {
                ball_mass: -1.0,
                ..given()
            },
            &["fixture `ball`", "mass is -1 kg"],
        ),
        (
            Masses {
                tip_mass: -1.0,
                ..given()
            },
            &["fixture `tip`", "mass is -1 kg"],
        ),
    ];
    for (model, parts) in cases {
        contains(&refused(&model), parts);
    }
}
