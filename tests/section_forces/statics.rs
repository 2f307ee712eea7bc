//! Cantilevers under dead loads.

use rncf::{Model, Rncf};
use rncf_models::{Bend45, PrincetonBeam};

use crate::cut::{Errors, Kind, at_rest, errors, sections};
use crate::models::{Blades, LENGTH, RADII, YOUNG, area, second_moment};
use rncf::nalgebra::Vector3;

/// Errors of both blades, the beam first.
fn blades(model: &Blades) -> [Errors; 2] {
    let mut scene = model.scene::<Rncf>().unwrap();
    let (states, q) = at_rest(scene.as_mut());
    let n = model.elements;
    let loads = [[model.pull_x, model.pull_y, 0.0], [0.0, 0.0, model.twist]].map(Vector3::from);
    let (mut states, mut q) = (&states[..], &q[..]);
    let half = states.len() / 2;
    [Kind::PlanarBeam, Kind::PlanarCable].map(|kind| {
        let (own, others) = states.split_at(half);
        let (vectors, rest) = q.split_at(kind.size(n));
        (states, q) = (others, rest);
        errors(kind, &sections(kind, n, LENGTH, vectors), own, loads)
    })
}

/// Beam-column: `M'' = k^2 M`, `k^2 = N/(E I)`, with M(L) the moment and -M'(0) the force across.
#[test]
fn a_slightly_bent_cantilever_has_the_forces_of_the_textbook() {
    let model = Blades {
        pull_x: 300.0,
        pull_y: 0.1,
        twist: -0.05,
        ..Blades::default()
    };
    let mut scene = model.scene::<Rncf>().unwrap();
    let (states, _) = at_rest(scene.as_mut());
    let k = (model.pull_x / (YOUNG * second_moment())).sqrt();
    let factor = (model.pull_y / k - model.twist * (k * LENGTH).sinh()) / (k * LENGTH).cosh();
    assert_eq!(states.len(), 48);
    let mut worst = [0.0f64; 3];
    for state in &states {
        let from_tip = k * (LENGTH - state.x);
        let moment = model.twist * from_tip.cosh() + factor * from_tip.sinh();
        let stress = state.forces[0] / area() + state.moments[2].abs() * RADII[0] / second_moment();
        let errors = [
            (state.forces[0] - model.pull_x).abs() / model.pull_x,
            (state.moments[2] - moment).abs() / 0.15,
            (state.stress.unwrap() / stress - 1.0).abs(),
        ];
        worst = std::array::from_fn(|i| worst[i].max(errors[i]));
    }
    println!("axial force, moment, stress: {worst:?}");
    assert!(worst[0] < 1e-5 && worst[1] < 3e-4 && worst[2] < 1e-4, "{worst:?}");
}

/// Sections balance with the loads beyond them whatever the mesh; what is left is that of Newton's iteration.
const BALANCED: f64 = 1e-7;

#[track_caller]
fn balanced(found: &Errors) {
    let all = [found.axial, found.shear, found.torque, found.moment];
    assert!(all.iter().all(|&error| error < BALANCED), "{found:?}");
}

#[test]
fn cut_parts_of_strongly_bent_blades_are_in_equilibrium() {
    // The tip is turned by more than a right angle.
    let scale = YOUNG * second_moment() / (LENGTH * LENGTH);
    for elements in [4, 8, 16] {
        let model = Blades {
            pull_x: -0.8 * scale,
            pull_y: 1.5 * scale,
            twist: 0.4 * scale * LENGTH,
            elements,
            ..Blades::default()
        };
        let found = blades(&model);
        println!("{elements} elements: {found:?}");
        found.iter().for_each(balanced);
    }
}

#[test]
fn a_strip_bent_about_both_axes_is_in_equilibrium() {
    for elements in [4, 16] {
        let model = PrincetonBeam {
            elements,
            ..PrincetonBeam::default()
        };
        let mut scene = model.scene::<Rncf>().unwrap();
        let (states, q) = at_rest(scene.as_mut());
        let force = [0.0, model.load * model.angle.cos(), model.load * model.angle.sin()];
        let sections = sections(Kind::SpatialBeam, elements, 0.508, &q);
        let found = errors(Kind::SpatialBeam, &sections, &states, [force.into(), Vector3::zeros()]);
        println!("{elements} elements: {found:?}");
        balanced(&found);
    }
}

#[test]
fn a_strip_under_a_small_load_has_the_stress_of_the_handbook() {
    let model = PrincetonBeam {
        load: 1e-3,
        ..PrincetonBeam::default()
    };
    let mut scene = model.scene::<Rncf>().unwrap();
    let (states, _) = at_rest(scene.as_mut());
    let (length, height, width) = (0.508, 12.3777e-3, 3.2024e-3);
    let [y, z] = [model.load * model.angle.cos(), model.load * model.angle.sin()];
    for state in &states {
        let arm = length - state.x;
        let moments = [-z * arm, y * arm];
        for (found, wanted) in state.moments.iter().skip(1).zip(moments) {
            assert!((found - wanted).abs() < 1e-5 * y * length, "{found} {wanted} {state:?}");
        }
        for (found, wanted) in state.forces.iter().skip(1).zip([y, z]) {
            assert!((found - wanted).abs() < 1e-4 * y, "{found} {wanted} {state:?}");
        }
        let bending = 6.0 * arm * (y / (width * height * height) + z / (height * width * width));
        // The axial force of the second order and, at the tip, shear alone.
        let shear = 3.0f64.sqrt() * 1.5 * model.load / (width * height);
        let wanted = bending.max(shear);
        let told = state.stress.unwrap();
        assert!((told - wanted).abs() < 1e-4 * wanted, "{told} {wanted} {state:?}");
    }
}

#[test]
fn a_bend_is_twisted_by_its_load() {
    for elements in [4, 16] {
        let model = Bend45 {
            elements,
            ..Bend45::default()
        };
        let mut scene = model.scene::<Rncf>().unwrap();
        let (states, q) = at_rest(scene.as_mut());
        let length = 100.0 * std::f64::consts::FRAC_PI_4;
        let sections = sections(Kind::SpatialBeam, elements, length, &q);
        let loads = [[0.0, 0.0, model.load], [0.0; 3]];
        let found = errors(Kind::SpatialBeam, &sections, &states, loads.map(Vector3::from));
        println!("{elements} elements: {found:?}");
        balanced(&found);
    }
}
