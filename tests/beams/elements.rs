//! Elements that models declare: against closed forms.

use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options};

use crate::scenes::at_rest;

rncf::model! {
    /// A cantilever of thin beam elements of the user's own: quintic between three nodes.
    pub model Quintic {
        /// Elements.
        param elements: count = 1;
        /// What acts per length, along the axis and across it.
        param along = 0 N/m;
        param across = 0 N/m;

        /// Centre line with position and slope at three nodes.
        element quintic(section, material) {
            domain xi in 0..1;
            vector r0 = r   at 0,   shape (1 + 6*xi)*(1 - 3*xi + 2*xi^2)^2;
            vector s0 = r_x at 0,   shape xi*(1 - 3*xi + 2*xi^2)^2;
            vector rm = r   at 1/2, shape 16*xi^2*(1 - xi)^2;
            vector sm = r_x at 1/2, shape 16*(xi - 1/2)*xi^2*(1 - xi)^2;
            vector r1 = r   at 1,   shape (7 - 6*xi)*(2*xi^2 - xi)^2;
            vector s1 = r_x at 1,   shape (xi - 1)*(2*xi^2 - xi)^2;
            field a = r_x;
            field b = r_xx;
            coefficient EA: N      = material.young * section.area;
            coefficient EI: N m^2  = material.young * section.second_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            damping = material.damping;
            strain e = (dot(a, a) - 1)/2;
            strain k in plane = cross(a, b);
            energy axial_strain = 1/2*EA*e^2;
            energy bending in plane = 1/2*EI*k^2;
            energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
        }
        material unit { density = 1 kg/m^3; young = 10 kPa; }
        section slender { area = 1 m^2; second_moment = 1e-4 m^4; }
        body beam in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * quintic(slender, unit); }
        joint root = clamp(beam.start, inertial);
        load weight = distributed(beam, [along, across, 0]);
        output tip = beam.end.position;
        output inside = beam.at(0.7 m).moment;
        output drawn = beam.at(0.7 m).axial_force;
    }
}

rncf::model! {
    /// A bar fixed at its start and drawn at its end, of two-node elements with an axial force alone.
    pub model Bar {
        /// Elements.
        param elements: count = 4;
        /// Force at the end.
        param pull = 0 N;

        /// Truss bar: positions alone, straight, no bending.
        element bar(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient EA: N      = material.young * section.area;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            damping = material.damping;
            strain e = (dot(a, a) - 1)/2;
            energy axial_strain = 1/2*EA*e^2;
        }
        material unit { density = 1 kg/m^3; young = 1 Pa; }
        section unit_area { area = 1 m^2; }
        body rod in inertial { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * bar(unit_area, unit); }
        joint root = pin(rod.start, inertial);
        joint guide = hold(rod.end.y);
        load tip_force = force(rod.end, [pull, 0, 0]);
        output tip = rod.end.position;
    }
}

rncf::model! {
    /// A string that stiffens, hung up and loaded by a weight.
    pub model Rope {
        /// How much it stiffens.
        param stiffening = 20;
        /// Stiffness at small strains.
        param stiffness = 3 N;
        /// Weight at the end.
        param weight = 1 N;

        /// String with the tension `stiffness (l + stiffening l^3)` of the stretch less one, l.
        element rope(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = stiffness*(l^2/2 + stiffening*l^4/4);
        }
        material light { density = 1e-3 kg/m^3; }
        section thin { area = 1 m^2; }
        body line in inertial { spatial; line from [0, 0, 0] m to [0, 0, -1] m; mesh 1 * rope(thin, light); }
        joint top = pin(line.start, inertial);
        joint guide_x = hold(line.end.x);
        joint guide_y = hold(line.end.y);
        load pull = force(line.end, [0 N, 0 N, -weight]);
        output tip = line.end.position;
    }
}

rncf::model! {
    /// A bar on a pin that a moment turns: no node has a slope for it.
    pub model Lever {
        /// Truss bar, as in `Bar`.
        element bar(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient EA: N      = material.young * section.area;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain e = (dot(a, a) - 1)/2;
            energy axial_strain = 1/2*EA*e^2;
        }
        material unit { density = 1 kg/m^3; young = 1 Pa; }
        section unit_area { area = 1 m^2; }
        body rod in inertial { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 1 * bar(unit_area, unit); }
        joint root = pin(rod.start, inertial);
        load turn = moment(rod.end, [0, 0, 4] N*m);
        output tip = rod.end.acceleration;
    }
}

/// Frequencies at rest, rad/s.
fn frequencies(model: &impl Model, count: usize) -> Vec<f64> {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let state = scene.rest(0.0);
    let found = modes(scene.as_mut(), &Uniform::at_rest(0.0), &state, Wanted { count }).unwrap();
    found.iter().map(|mode| mode.im).collect()
}

/// Zeros of `cos(x) cosh(x) + 1`, squared: sqrt(EI/(rhoA L^4)) is one.
const CANTILEVER: [f64; 2] = [3.516_015_268_7, 22.034_491_564_7];

#[test]
fn a_quintic_element_converges_with_the_eighth_order() {
    let error = |elements: usize| {
        let found = frequencies(
            &Quintic {
                elements,
                ..Quintic::default()
            },
            2,
        );
        [0, 1].map(|k| (found[k] / CANTILEVER[k] - 1.0).abs())
    };
    let errors = [1, 2, 4].map(error);
    println!("{errors:?}");
    // Of the second frequency the error is above round-off; that of a cubic one is of the fourth order.
    let order = (errors[0][1] / errors[1][1]).log2();
    assert!(order > 7.0, "order {order}: {errors:?}");
    assert!(errors[2][1] < 1e-7 && errors[1][0] < 1e-7, "{errors:?}");
}

/// What acts per length counts within an element as at its ends: six shape functions of a vector need six points.
#[test]
fn sections_within_a_quintic_element_carry_what_acts_beyond_them() {
    for elements in 1..=3 {
        let model = Quintic {
            elements,
            along: 1e-4,
            across: 1e-5,
        };
        let [.., inside, drawn] = at_rest(&model, 1.0)[..] else {
            panic!("four outputs")
        };
        assert!(
            (inside / (1e-5 * 0.3 * 0.3 / 2.0) - 1.0).abs() < 1e-4,
            "{elements}: {inside}"
        );
        assert!((drawn / (1e-4 * 0.3) - 1.0).abs() < 1e-4, "{elements}: {drawn}");
    }
}

/// Fixed and free: `w_k^2 = 6/h^2 (1 - cos b)/(2 + cos b)` with `b = (2 k - 1) pi/(2 n)`, of linear elements with their
/// consistent masses.
#[test]
fn a_bar_vibrates_as_linear_elements_do() {
    let elements = 4;
    let found: Vec<f64> = frequencies(&Bar { elements, pull: 0.0 }, 8);
    let lengthwise: Vec<f64> = found.into_iter().filter(|&frequency| frequency > 1e-3).collect();
    for k in 1..=elements {
        let angle = (2.0 * k as f64 - 1.0) * std::f64::consts::PI / (2.0 * elements as f64);
        let square = 6.0 * 16.0 * (1.0 - angle.cos()) / (2.0 + angle.cos());
        let ratio = lengthwise[k - 1] / square.sqrt();
        assert!((ratio - 1.0).abs() < 1e-9, "mode {k}: {ratio}");
    }
}

/// With Green's strain (one element: what is not tight does not hold nodes across) the force is `EA/2 s (s^2 - 1)` at a stretch s: 0.6 N stretches it to the root of s^3 - s = 1.2.
#[test]
fn a_bar_is_stretched_by_a_force() {
    let tip = at_rest(&Bar { elements: 1, pull: 0.6 }, 1.0)[0];
    let cubic = tip * tip * tip - tip - 1.2;
    assert!(cubic.abs() < 1e-9 && tip > 1.0, "{tip}");
}

#[test]
fn a_law_of_the_users_own_carries_the_weight() {
    for stiffening in [0.0, 20.0] {
        let model = Rope {
            stiffening,
            ..Rope::default()
        };
        let longer = -at_rest(&model, 1.0)[2] - 1.0;
        let tension = 3.0 * (longer + stiffening * longer.powi(3));
        assert!(
            (tension - 1.0).abs() < 1e-9,
            "stiffening {stiffening}: {longer}, {tension}"
        );
    }
}

/// As on a rigid rod about its end: `M/(m L^2/3)` times the length.
#[test]
fn a_moment_acts_on_a_bar_as_a_couple_on_its_nodes() {
    let mut scene = Lever::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), start, 1.0, Method::Radau, Options::default()).unwrap();
    let state = integrator.state().clone();
    let mut row = vec![0.0; integrator.system().output_columns()];
    integrator.system().outputs(&state, &mut row);
    assert!((row[1] - 3.0).abs() < 1e-12 && row[0].abs() < 1e-12, "{row:?}");
}
