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
        /// The same door, the upper hinge weakened as the error says.
        pub model DoorOnBall {
            rigid door { mass = 20 kg; inertia = [7, 9, 2] kg*m^2; center = [0.5, 0, 1] m; }
            joint lower = revolute(door.at([0, 0, 0.2] m), inertial.at([0, 0, 0.2] m), axis = z);
            joint upper = cylindrical(door.at([0, 0, 1.8] m), inertial.at([0, 0, 1.8] m), axis = z);
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
            material soft { density = 7870 kg/m^3; young = 0.2 GPa; poisson = 0.29; }
            section round { area = pi * radius^2; second_moment = pi * radius^4 / 4; }
            motion theta(t) = 8 [rad/s] * t;
            frame pin_frame = moving(origin = [0, -crank * sin(theta(t)), crank * (cos(theta(t)) - 1)]);
            frame rod in pin_frame = turning();
            body beam in rod {
                spatial;
                line from [0, 0, 0] m to [length, 0, 0];
                mesh 4 * cable(round, soft, bending = exact);
            }
            joint root = clamp(beam.start, rod);
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
            material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
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
        }
    }
}

#[test]
fn print_all() {
    use redundant::*;
    let say = |name: &str, found: Result<Statistics, String>| println!("--- {name}: {found:?}");
    say("all revolute", start(&AllRevolute::default(), Formulation::Rncf));
    say("door", start(&Door::default(), Formulation::Rncf));
    say("door shifted", start(&Door { shift: 1e-3 }, Formulation::Rncf));
    say("door weak", start(&DoorOnBall::default(), Formulation::Rncf));
    say("parallel", start(&Parallel::default(), Formulation::Rncf));
    say("twice", start(&Twice::default(), Formulation::Rncf));
    let cross = |tilt: f64, formulation| start(&CrossAxis { tilt }, formulation);
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        say("cross 0", cross(0.0, formulation));
        say("cross", cross(std::f64::consts::FRAC_PI_2, formulation));
    }
    use massless::*;
    say("needle", start(&Needle::default(), Formulation::Rncf));
    say("needle 0", start(&Needle { about: -1e-3 }, Formulation::Rncf));
    use values::*;
    let p = |x_0, v_0| start(&Pendulum { x_0, v_0 }, Formulation::Rncf);
    say("pendulum", p(1.0, 0.0));
    say("pendulum near", p(1.0003, 0.0));
    say("pendulum v near", p(1.0, 1e-3));
    say("pendulum far", p(1.3, 0.0));
    say("pendulum v far", p(1.0, 0.5));
    say("pendulum 0", p(0.0, 0.0));
    say("struts", start(&Struts { gap: 0.0 }, Formulation::Rncf));
    say("norm", start(&Norm { x_0: 0.0 }, Formulation::Rncf));
    let d = Masses::default;
    for m in [
        Masses { arm_mass: -1.0, ..d() }, Masses { arm_mass: 0.0, ..d() }, Masses { j: 0.3, ..d() }, Masses { disc_mass: -1.0, ..d() }, Masses { disc_inertia: -1.0, ..d() },
        Masses { ball_mass: -1.0, ..d() }, Masses { tip_mass: -1.0, ..d() }, d(), Masses { arm_mass: f64::NAN, ..d() },
    ] {
        say("masses", start(&m, Formulation::Rncf));
    }
}
