//! Places beside the axis: what acts there acts on the axis and turns the section.

use rncf::app::{RunSettings, run};
use rncf::equilibrium::{Uniform, static_load};
use rncf::nalgebra::Vector3;
use rncf::{Formulation, Joints, Model};

rncf::model! {
    /// Cantilevers with a small force beside their axis, at a node and inside an element.
    pub model Eccentric {
        param force = 1 mN;
        param lever = 50 mm;
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        table ends { x = [0, 1] m; }
        body noded { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * beam(bar, steel); }
        body coarse { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 3 at ends * beam(bar, steel); }
        body flat { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * beam(bar, steel); }
        joint noded_root = clamp(noded.start, inertial);
        joint coarse_root = clamp(coarse.start, inertial);
        joint flat_root = clamp(flat.start, inertial);
        load lift = force(noded.at(0.6 m).beside([0, lever, 0]), [0, 0, force]);
        load push = force(coarse.at(0.6 m).beside([0, lever, 0]), [0, 0, force]);
        load pull = force(flat.end.beside([0, lever, 0]), [force, 0, 0]);
        output noded_inner = noded.at(0.5 m).torque;
        output coarse_inner = coarse.at(0.5 m).torque;
        output noded_outer = noded.at(0.65 m).torque;
        output coarse_outer = coarse.at(0.65 m).torque;
        output noded_bent = noded.at(0.5 m).moment_y;
        output coarse_bent = coarse.at(0.5 m).moment_y;
        output noded_held = noded_root.moment;
        output coarse_held = coarse_root.moment;
        output flat_bent = flat.at(0.5 m).moment_z;
        output flat_held = flat_root.moment;
    }
}

rncf::model! {
    /// A cantilever whose end stands with a foot on a ball, under a load, beside its place on the axis.
    pub model Propped {
        param foot = 40 mm;
        material soft { density = 1200 kg/m^3; young = 2 GPa; poisson = 0.35; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        body arm { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 6 * beam(bar, soft); }
        joint root = clamp(arm.start, inertial);
        joint ball = spherical(arm.end.beside([0, 10 mm, -foot]), inertial);
        load weight = force(arm.at(0.5 m).beside([0, 15, 0] mm), [0, 0, -200] N);
        output held = ball.force;
        output root_force = root.force;
        output root_moment = root.moment;
        output foot_at = arm.end.beside([0, 10 mm, -foot]);
        output loaded_at = arm.at(0.5 m).beside([0, 15, 0] mm);
    }
}

rncf::model! {
    /// A rod that swings on two springs beside its axis, flexible, rigid or as a rigid body.
    pub model Swung {
        param young = 210 GPa;
        material steel { density = 7800 kg/m^3; young = young; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        frame own = free(angular_velocity = [1, 2, -1] rad/s);
        body rod in own { spatial; line from [-0.25, 0, 0] m to [0.25, 0, 0] m; mesh 2 * beam(bar, steel); rigid; }
        joint grip = clamp(rod.start, own);
        frame other = free(angular_velocity = [1, 2, -1] rad/s);
        body stiff in other { spatial; line from [-0.25, 0, 0] m to [0.25, 0, 0] m; mesh 2 * beam(bar, steel); chord; }
        rigid twin {
            mass = 2.34 kg;
            inertia = [2.34 * (0.0009 + 0.0004) / 12, 2.34 * (0.25 + 0.0004) / 12, 2.34 * (0.25 + 0.0009) / 12] kg*m^2;
            angular_velocity = [1, 2, -1] rad/s;
        }
        spring a = linear(rod.end.beside([0, 40, 0] mm), inertial.at([0.3, 0.1, 0.2] m), stiffness = 100 N/m, damping = 1 N*s/m, length = 0.1 m);
        spring b = linear(stiff.end.beside([0, 40, 0] mm), inertial.at([0.3, 0.1, 0.2] m), stiffness = 100 N/m, damping = 1 N*s/m, length = 0.1 m);
        spring c = linear(twin.at([0.25, 0.04, 0] m), inertial.at([0.3, 0.1, 0.2] m), stiffness = 100 N/m, damping = 1 N*s/m, length = 0.1 m);
        output first = rod.end.beside([0, 40, 0] mm).in(inertial);
        output second = stiff.end.beside([0, 40, 0] mm).in(inertial);
        output third = twin.at([0.25, 0.04, 0] m);
        run { t_end = 1 s; every = 100 ms; }
    }
}

fn row(model: &impl Model, joints: Joints) -> Vec<f64> {
    let mut scene = model.build(Formulation::Rncf, joints).unwrap();
    let found = static_load(scene.as_mut(), 0.0).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&Uniform::at_rest(0.0), found.state().unwrap(), &mut row);
    row
}

#[track_caller]
fn near(found: &[f64], wanted: &[f64], size: f64) {
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= size, "{found} instead of {wanted}");
    }
}

#[test]
fn a_force_beside_the_axis_twists_and_bends_it() {
    let model = Eccentric::default();
    let (torque, bent) = (model.force * model.lever, -0.1 * model.force);
    for joints in [Joints::Eliminated, Joints::Multipliers] {
        let found = row(&model, joints);
        println!("{found:?}");
        near(&found[..6], &[torque, torque, 0.0, 0.0, bent, bent], 1e-7 * torque);
        // What the joint exerts on the body.
        let held = [-torque, 0.6 * model.force, 0.0];
        near(&found[6..9], &held, 1e-7 * torque);
        near(&found[9..12], &held, 1e-7 * torque);
        near(&found[12..], &[-torque, torque], 1e-7 * torque);
    }
}

#[test]
fn a_foot_stays_where_it_is_held_and_all_balances() {
    for joints in [Joints::Eliminated, Joints::Multipliers] {
        let found = row(&Propped::default(), joints);
        println!("{found:?}");
        let vector = |first: usize| Vector3::from_column_slice(&found[first..first + 3]);
        let [ball, force, moment, foot, place] = [0, 3, 6, 9, 12].map(vector);
        let load = Vector3::new(0.0, 0.0, -200.0);
        near(foot.as_slice(), &[1.0, 0.01, -0.04], 1e-9);
        assert!(ball.norm() > 20.0 && place.z < -1e-3);
        near((ball + force + load).as_slice(), &[0.0; 3], 1e-7);
        let about_root = moment + foot.cross(&ball) + place.cross(&load);
        near(about_root.as_slice(), &[0.0; 3], 1e-6);
    }
}

#[test]
fn places_beside_the_axis_move_with_a_rigid_body() {
    let mut settings = RunSettings::default();
    settings.options.rtol = 1e-8;
    // Its deformation is below the tolerance of this.
    let found = run(&Swung { young: 210e9 }, &settings).unwrap().history;
    let row: Vec<f64> = (0..9).map(|column| found.column(column).last().unwrap()).collect();
    println!("{row:?}");
    near(&row[..3], &row[6..], 1e-7);
    near(&row[3..6], &row[6..], 1e-5);
}
