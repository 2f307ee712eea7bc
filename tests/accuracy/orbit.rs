//! A long satellite in orbit: its librations beside the size of the orbit.

use rncf::equilibrium::{Uniform, steady};
use rncf::modes::{Wanted, modes, stability_margin};
use rncf::{Formulation, Joints, Model};

rncf::model! {
    /// A tube that points away from the Earth, 6800 km from its middle.
    model Satellite {
        param mu = 3.986004418e14 m^3/s^2;
        param radius = 6.8e6 m;
        /// Angle by which it starts off the vertical.
        param tilt = 1 deg;
        frame sat = free(origin = [radius, 0, 0], velocity = [0, sqrt(mu/radius), 0], axis = z, angle = tilt, angular_velocity = [0, 0, sqrt(mu/radius^3)]);
        material light { density = 1600 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section mast = tube(radius = 10 mm, thickness = 1 mm);
        body boom in sat { spatial; line from [-50, 0, 0] m to [50, 0, 0] m; mesh 2 * beam(mast, light); mean_axes; }
        load weight = gravity(-mu * position / norm(position)^3);
        output tip = boom.end.position;
    }
}

/// Seen from the vertical: the spin about the boom has no stiffness, nor has the place along the orbit; the orbit's shape and
/// its plane swing with n, the boom with sqrt(3) n in the plane and with 2 n across it. The stiffness of the tube is 25 orders
/// above that of gravity, and what cancels in its sums is no stiffness against the spin.
#[test]
fn a_boom_in_orbit_librates_as_the_gradient_of_gravity_tells() {
    for tilt in [0.0, 1_f64.to_radians()] {
        let model = Satellite {
            tilt,
            ..Satellite::default()
        };
        let n = (model.mu / model.radius.powi(3)).sqrt();
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let found = steady(scene.as_mut(), 0.0).unwrap();
        let at = Uniform::steady(0.0);
        let modes = modes(scene.as_mut(), &at, found.state().unwrap(), Wanted { count: 8 }).unwrap();
        println!("{:?}", modes.iter().map(|mode| mode.im / n).collect::<Vec<_>>());
        assert_eq!(modes.len(), 8);
        for (mode, exact) in modes.iter().zip([0.0, 0.0, 1.0, 1.0, 3.0_f64.sqrt(), 2.0]) {
            assert!((mode.im / n - exact).abs() < 1e-6, "{} for {exact}", mode.im / n);
        }
        assert!(stability_margin(&modes).unwrap() < 1e-9 * n);
    }
}

rncf::model! {
    /// Two masses on a lever, once as a rigid body in a plane, once as a free frame, in a field that grows with the place; and a lever with the same inertia.
    pub model Levers {
        rigid lever { plane xy; mass = 1 g; inertia = 0.001 kg*m^2; }
        fixture right on lever.at([1, 0, 0] m) { mass = 0.5 kg; }
        fixture left on lever.at([-1, 0, 0] m) { mass = 0.5 kg; }
        joint pivot = revolute(inertial.at([0, 0, 0] m), lever.at([0, 0, 0] m));
        frame other = free(plane = xy);
        fixture other_right on other.at([1, 0, 0] m) { mass = 0.5 kg; }
        fixture other_left on other.at([-1, 0, 0] m) { mass = 0.5 kg; }
        load field = gravity([0, -1 [1/s^2] * position.x, 0]);
        output angle = pivot.angle;
        output other_angle = other.angle;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A lever of which one moment of inertia is known.
    pub model Unplaced {
        rigid lever { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
        load field = gravity([0, -1 [1/s^2] * position.x, 0]);
        output angle = lever.angle;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// Masses at known places turn a planar body as they do one in space: `J a'' = -cos(a)^2` of two half kilograms at a metre.
#[test]
fn the_gradient_of_gravity_turns_planar_bodies_by_their_masses() {
    let found = rncf::app::run(&Levers {}, &rncf::app::RunSettings::default()).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    for (column, inertia) in [(0, 1.001), (1, 1.0)] {
        let steps = 1000;
        let (mut angle, mut speed) = (0.0f64, 0.0);
        let h = 1.0 / f64::from(steps);
        for _ in 0..steps {
            // The lever itself has half its inertia along either axis.
            let rate = |angle: f64| -(angle.cos().powi(2) + 0.5 * (inertia - 1.0)) / inertia;
            let middle = speed + 0.5 * h * rate(angle);
            angle += h * middle;
            speed = middle + 0.5 * h * rate(angle);
        }
        let own = found.history.column(column).last().unwrap();
        assert!((own / angle - 1.0).abs() < 1e-6, "{own} for {angle}");
    }
    let notes = rncf::app::run(&Unplaced {}, &rncf::app::RunSettings::default())
        .unwrap()
        .warnings;
    assert!(notes.iter().any(|note| note.contains("spread alike")), "{notes:?}");
}

mod far {
    rncf::model! {
        /// A satellite in a geostationary orbit that turns about an axis of its inertia, and a wheel on it.
        pub model Far {
            param spin = 1e-4 rad/s;
            rigid bus {
                mass = 5000 kg; inertia = [3000, 5000, 4000] kg*m^2; center = [0.2, 0.1, -0.1] m;
                origin = [42164, 0, 0] km; velocity = [0, 3.0746, 0] km/s; angular_velocity = spin * [0, 0, 1];
            }
            rigid probe {
                mass = 3 kg; inertia = [1, 1, 1] kg*m^2;
                origin = [42164, 0, 0.5] km; velocity = [0, 3.0746, 0] km/s;
            }
            output own = bus.angular_momentum(about = bus.center);
            output of_center = bus.angular_momentum(about = bus.center_of_mass);
            output of_all = total.angular_momentum(about = total.center_of_mass);
            run { t_end = 600 s; every = 60 s; }
        }
    }
}

/// J w, 0.4 kg m^2/s, beside m r v of 6.5e14: round-off of places and velocities does not come in.
#[test]
fn the_spin_of_what_is_far_away_and_fast_is_known() {
    let found = rncf::app::run(&far::Far::default(), &rncf::app::RunSettings::default()).unwrap();
    for (name, bound) in [("own.z", 1e-6), ("of_center.z", 1e-6), ("of_all.z", 2e-4)] {
        let column = found.history.find(name).unwrap();
        for value in found.history.column(column) {
            assert!((value / 0.4 - 1.0).abs() < bound, "{name}: {value}");
        }
    }
}
