//! Sections that say their stiffness by numbers, in a plane, of centre lines, and of a model's own elements: Timoshenko's beam, the exact rod, a string
//! that hangs, and the same body with a material.

use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Joints, Model};
use rncf_reference::rod::Rod;
use rncf_reference::timoshenko::Beam;

use crate::scenes::at_rest;

rncf::model! {
    /// A cantilever in its plane, with its tension centre beside the axis.
    pub model Plane {
        param along = 0 N;
        param across = 0 N;
        param turning = 0 N*m;
        param beside = 0 mm;
        param elements: count = 16;
        section bar { EA = 2 MN; GA = 400 kN; EI = 20 kN*m^2; mass = 12 kg/m; inertia_z = 0.12 kg*m; tension_y = beside; }
        body beam { planar xy; line from [0, 0, 0] m to [4, 0, 0] m; mesh elements * beam(bar); }
        joint root = clamp(beam.start, inertial);
        load tip_force = force(beam.end, [along, across, 0 N], in = inertial);
        load tip_moment = moment(beam.end, [0 [N m], 0 [N m], turning], in = inertial);
        output tip = beam.end.position;
        output moment = beam.start.moment_z;
    }
}

rncf::model! {
    /// A rope by a material, and by the numbers of it.
    pub model Ropes {
        material hemp { density = 1250 kg/m^3; young = 250 MPa; damping = 2 ms; }
        section strands { area = 1 cm^2; second_moment = 2 mm^4; }
        section numbers { EA = 25 kN; EI = 500e-6 [N*m^2]; mass = 0.125 kg/m; damping = 2 ms; }
        body first { planar xy; line from [0, 0, 0] m to [3, 0, 0] m; mesh 6 * cable(strands, hemp, bending = exact, axial = engineering); }
        body second { planar xy; line from [0, 0, 0] m to [3, 0, 0] m; mesh 6 * cable(numbers, bending = exact, axial = engineering); }
        joint one = clamp(first.start, inertial);
        joint two = clamp(second.start, inertial);
        load weight = gravity([0.7, -0.7, 0] m/s^2);
        output apart = first.end.position - second.end.position;
        output forces = first.at(1 m).axial_force - second.at(1 m).axial_force;
        output far = second.end.position;
    }
}

rncf::model! {
    /// A string of its own that grows thinner downwards, and hangs.
    pub model Hanging {
        param elements: count = 200;
        element string(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient EA: N = material.young * section.area;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = 1/2*EA*l^2;
        }
        section rope { EA = 2 MN * (1 - x / 200 [m]); mass = 12 kg/m; }
        body line { spatial; line from [0, 0, 0] m to [0, 0, -100] m; mesh elements * string(rope); }
        joint top = pin(line.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = line.end.z;
    }
}

/// Of small waves; the highest of five bends in half waves of 0.9 m.
#[test]
fn a_planar_section_in_numbers_vibrates_as_timoshenkos_beam() {
    let model = Plane {
        elements: 32,
        ..Plane::default()
    };
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let state = scene.rest(0.0);
    let found = modes(scene.as_mut(), &Uniform::at_rest(0.0), &state, Wanted { count: 7 }).unwrap();
    let exact = Beam {
        length: 4.0,
        mass: 12.0,
        rotary: 0.12,
        bending: 20e3,
        shear: 400e3,
    };
    let axial = std::f64::consts::FRAC_PI_2 / 4.0 * (2e6f64 / 12.0).sqrt();
    let mut exact = exact.frequencies(false, 5);
    exact.push(axial);
    for wanted in exact {
        let off = found
            .iter()
            .map(|mode| (mode.im / wanted - 1.0).abs())
            .fold(f64::INFINITY, f64::min);
        println!("{wanted:.4} rad/s: {off:.1e}");
        assert!(off < 1e-3, "{wanted} rad/s: {off:e}");
    }
}

#[test]
fn a_planar_section_in_numbers_bends_as_the_exact_rod() {
    let rod = Rod {
        length: 4.0,
        force_compliance: [1.0 / 2e6, 1.0 / 4e5, 1.0 / 4e5],
        moment_compliance: [1.0 / 2e4; 3],
        curvature: [0.0; 3],
        steps: 400,
    };
    let exact = rod.tip([-2e3, 3e3, 0.0], [0.0, 0.0, 1e3], 8).unwrap().position;
    let model = Plane {
        along: -2e3,
        across: 3e3,
        turning: 1e3,
        elements: 32,
        ..Plane::default()
    };
    let tip = at_rest(&model, 0.25);
    let off = (tip[0] - exact[0]).hypot(tip[1] - exact[1]);
    println!("{tip:?}, {exact:?}: {off:.1e} m");
    assert!(off < 1e-4 * exact[1].abs());
}

/// A small pull on the axis bends what holds it beside the axis, like the moment `F y` about its centre.
#[test]
fn a_pull_beside_the_tension_centre_bends_in_the_plane() {
    let (force, beside) = (1e-3, 0.05);
    let model = Plane {
        along: force,
        beside,
        ..Plane::default()
    };
    let tip = at_rest(&model, 1.0);
    let exact = force * beside * 16.0 / (2.0 * 2e4);
    println!("{:e} for {exact:e} m, moment at the root {:e}", tip[1], tip[2]);
    assert!((tip[1].abs() / exact - 1.0).abs() < 1e-6);
}

#[test]
fn numbers_of_a_rope_are_its_material_and_section() {
    let row = at_rest(&Ropes::default(), 0.1);
    println!("{row:?}");
    assert!(row[3..].iter().any(|place| place.abs() > 0.5));
    assert!(row[..3].iter().all(|apart| apart.abs() < 1e-9), "{row:?}");
}

/// `w/EA0 int (L - x)/(1 - x/2L) dx = 2 w L^2/EA0 (1 - ln 2)`, in lengths of the declared string.
#[test]
fn a_string_of_numbers_along_its_axis_is_stretched_by_its_weight() {
    let tip = at_rest(&Hanging::default(), 1.0)[0];
    let exact = 2.0 * 12.0 * 9.81 * 1e4 / 2e6 * (1.0 - 2f64.ln());
    println!("{} for {exact} m", -100.0 - tip);
    assert!(((-100.0 - tip) / exact - 1.0).abs() < 1e-5);
}
