//! T9 of THEORY 10: a body that tumbles through a pitch of 90 degrees, in Euler angles and on the rotation group.

use rncf::nalgebra::{Matrix3, UnitQuaternion};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Statistics, StepSize, Stop};

use crate::agrees;
use crate::failing::euler_angles::{self, Stopped};

rncf::model! {
    /// A body of three different moments of inertia that no moment acts on, turning about its middle axis.
    pub model Tumbling {
        /// Angular velocity about the other axes: by how much the body passes the singularity.
        param aside = 1e-3 rad/s;
        /// Pitch at the start.
        param pitch = 0 deg;
        rigid body {
            mass = 1 kg;
            inertia = [1, 2, 2.5] kg*m^2;
            axis = y;
            angle = pitch;
            angular_velocity = [aside, 1 [rad/s], aside];
        }
        output spin = body.angular_velocity.y;
        run { t_end = 20 s; every = 0.1 s; }
    }
}

pub const INERTIA: [f64; 3] = [1.0, 2.0, 2.5];
const END: f64 = 20.0;

/// What the runtime does.
struct Flight {
    attitude: Matrix3<f64>,
    /// Largest change of the energy, relative to it.
    energy: f64,
    /// Largest departure of `A^T A` from 1 after a step.
    orthogonality: f64,
    statistics: Statistics,
}

fn fly(model: &Tumbling, method: Method, options: Options) -> Flight {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let energy = scene.energy(&rest).unwrap();
    let turn = scene.turns()[0];
    let mut integrator = Integrator::new(scene.as_mut(), rest, END, method, options).unwrap();
    let mut flight = Flight {
        attitude: Matrix3::identity(),
        energy: 0.0,
        orthogonality: 0.0,
        statistics: Statistics::default(),
    };
    loop {
        let stop = integrator.step().unwrap();
        let state = integrator.state().clone();
        let change = (integrator.system().energy(&state).unwrap() / energy - 1.0).abs();
        flight.energy = flight.energy.max(change);
        flight.attitude = state.orientation(0, turn).to_rotation_matrix().into_inner();
        flight.orthogonality = flight.orthogonality.max(departure(&flight.attitude));
        if stop == Stop::End {
            flight.statistics = integrator.statistics().clone();
            return flight;
        }
    }
}

/// Largest entry of `A^T A - 1`.
fn departure(a: &Matrix3<f64>) -> f64 {
    (a.transpose() * a - Matrix3::identity()).amax()
}

fn apart(a: &Matrix3<f64>, b: &Matrix3<f64>) -> f64 {
    (a - b).amax()
}

#[test]
fn euler_angles_collapse_where_the_group_does_not_notice() {
    let tight = Options {
        rtol: 1e-9,
        ..Options::default()
    };
    for (aside, [theirs, few]) in [(1e-2, [570.0, 319.0]), (1e-4, [881.0, 117.0]), (1e-6, [1051.0, 42.0])] {
        let angles = euler_angles::run(INERTIA, [0.0, 0.0, 0.0, aside, 1.0, aside], END, 1e-9);
        let [yaw, pitch, roll, ..] = angles.state;
        let attitude = UnitQuaternion::from_euler_angles(roll, pitch, yaw)
            .to_rotation_matrix()
            .into_inner();
        let ours = fly(
            &Tumbling {
                aside,
                ..Tumbling::default()
            },
            Method::Radau,
            tight,
        );
        println!(
            "aside {aside:.0e}: angles {} steps, smallest {:.1e} s; ours {} steps, smallest {:.1e} s; attitudes {:.1e} apart",
            angles.steps,
            angles.smallest_step,
            ours.statistics.steps,
            ours.statistics.smallest_step,
            apart(&attitude, &ours.attitude)
        );
        // The step falls with the distance from the singularity.
        assert!((0.005..0.1).contains(&(angles.smallest_step / aside)));
        assert!(ours.statistics.smallest_step > 5e-3);
        agrees(angles.steps as f64, theirs, 0.05);
        agrees(ours.statistics.steps as f64, few, 0.2);
        assert!(apart(&attitude, &ours.attitude) < 1e-5, "both tumble alike");
    }
}

#[test]
fn at_ninety_degrees_the_angles_have_no_rates() {
    let upright = std::f64::consts::FRAC_PI_2;
    let angles = euler_angles::run(INERTIA, [0.0, upright, 0.0, 0.1, 1.0, 0.1], END, 1e-9);
    println!("angles from 90 degrees: {angles:?}");
    assert_eq!(angles.stopped, Stopped::StepTooSmall);
    let model = Tumbling {
        aside: 0.1,
        pitch: upright,
    };
    for method in [
        Method::GeneralizedAlpha { rho_inf: 0.8 },
        Method::Hht { alpha: -0.05 },
        Method::Radau,
    ] {
        let ours = fly(
            &model,
            method,
            Options {
                rtol: 1e-7,
                ..Options::default()
            },
        );
        println!(
            "{method:?}: {} steps, {} rejected",
            ours.statistics.steps, ours.statistics.rejected_steps
        );
        assert!(ours.statistics.smallest_step > 1e-3);
    }
}

#[test]
fn energy_has_the_order_of_the_method_and_axes_stay_orthogonal() {
    for (method, h, order) in [
        (Method::GeneralizedAlpha { rho_inf: 0.8 }, 0.02, 2.0),
        (Method::Hht { alpha: -0.05 }, 0.02, 2.0),
        (Method::Radau, 0.5, 5.0),
    ] {
        let found = [h, h / 2.0].map(|h| {
            let options = Options {
                rtol: 1e-13,
                step: StepSize::Fixed(h),
                ..Options::default()
            };
            fly(
                &Tumbling {
                    aside: 0.1,
                    ..Tumbling::default()
                },
                method,
                options,
            )
        });
        let seen = (found[0].energy / found[1].energy).log2();
        let worst = found[0].orthogonality.max(found[1].orthogonality);
        println!(
            "{method:?}: energy {:.1e}, {:.1e}, order {seen:.2}; orthogonality {worst:.1e}",
            found[0].energy, found[1].energy
        );
        assert!(seen > order - 0.2, "{seen}");
        assert!(worst < 1e-14, "{worst:e}");
    }
}
