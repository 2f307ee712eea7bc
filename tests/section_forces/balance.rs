//! Sections, joints and loads balance: at places inside elements, under loads per length, and however a body is
//! described.

use rncf::equilibrium::{Uniform, static_load, steady};
use rncf::model::{Fidelity, SectionState};
use rncf::{Formulation, Joints, Model, Scene};

use crate::models::{Blades, DENSITY, LENGTH, YOUNG, area, second_moment};

/// Mass per length, kg/m.
fn line_mass() -> f64 {
    DENSITY * area()
}

fn built(model: &Blades, rope: Fidelity) -> Box<dyn Scene> {
    model
        .build_as(Formulation::Rncf, Joints::Eliminated, &[("rope".into(), rope)])
        .unwrap()
}

/// What the outputs tell of the rope.
#[derive(Debug)]
struct Told {
    /// Place of the tip across the undeformed axis, m.
    tip: f64,
    /// Axial force and moment at the place that is read, and at the start.
    here: [f64; 2],
    start: [f64; 2],
    /// What the joint at the root exerts: force along and across, moment.
    grip: [f64; 3],
    states: Vec<SectionState>,
}

fn told(scene: &mut dyn Scene) -> Told {
    let is_still = scene.spin(0.0) == 0.0;
    let (found, at) = if is_still {
        (static_load(scene, 0.0), Uniform::at_rest(0.0))
    } else {
        (steady(scene, 0.0), Uniform::steady(0.0))
    };
    let state = found.unwrap().state().unwrap().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.uniform_outputs(&at, &state, &mut row);
    let mut states = Vec::new();
    scene.uniform_section_states(&at, &state, &mut states);
    Told {
        tip: row[1],
        here: [row[4], row[5]],
        start: [row[6], row[7]],
        grip: [row[8], row[9], row[10]],
        states,
    }
}

fn rope(model: &Blades, fidelity: Fidelity) -> Told {
    told(built(model, fidelity).as_mut())
}

#[track_caller]
fn near(found: f64, wanted: f64, size: f64) {
    assert!(
        (found - wanted).abs() <= size,
        "{found} instead of {wanted}, within {size:e}"
    );
}

#[test]
fn distributed_loads_have_the_moment_and_shear_of_the_textbook_at_every_place() {
    // So small that the deformed shape is the undeformed one to 1e-11.
    let (fall, snow) = (1e-3, 2e-3);
    for (elements, place) in [(1, 0.37), (2, 0.37), (3, 1.999), (16, 0.0), (16, 0.5)] {
        let model = Blades {
            fall,
            snow,
            elements,
            place,
            ..Blades::default()
        };
        let told = rope(&model, Fidelity::Full);
        let weight = line_mass() * fall;
        let moment = |load: f64, x: f64| -0.5 * load * (LENGTH - x).powi(2);
        let whole = moment(weight, 0.0);
        near(told.here[1], moment(weight, place), 1e-9 * whole.abs());
        near(told.start[1], whole, 1e-9 * whole.abs());
        // The joint exerts the opposite, to round-off.
        near(told.grip[2], -told.start[1], 1e-13 * whole.abs());
        near(told.grip[1], weight * LENGTH, 1e-9 * weight);
        let (blade, rope) = told.states.split_at(told.states.len() / 2);
        let load = weight + snow;
        for (state, other) in blade.iter().zip(rope) {
            near(state.moments[2], moment(load, state.x), 1e-9 * load);
            near(state.forces[1], -load * (LENGTH - state.x), 1e-9 * load);
            near(other.moments[2], moment(weight, other.x), 1e-9 * weight);
        }
    }
}

#[test]
fn a_force_inside_an_element_is_carried_to_the_root_from_its_place_on() {
    let model = Blades {
        poke: 1e-3,
        poked_at: 0.3,
        elements: 2,
        ..Blades::default()
    };
    for place in [0.0, 0.1, 0.299, 0.3, 0.31, 0.9, 1.0, 1.7] {
        let told = rope(&Blades { place, ..model.clone() }, Fidelity::Full);
        near(told.here[1], model.poke * (0.3 - place).max(0.0), 1e-10 * model.poke);
    }
}

#[test]
fn small_deformations_have_linear_reactions_and_no_axial_force() {
    // The tip moves by 38 mm a metre.
    let pull_y = 3.0 * YOUNG * second_moment() * 0.076 / LENGTH.powi(3);
    let model = Blades {
        pull_y,
        ..Blades::default()
    };
    for modes in [1, 4] {
        let told = rope(&model, Fidelity::Small(modes));
        println!("small({modes}): {told:?}");
        near(told.tip, 0.076, 0.04 * 0.076);
        near(told.grip[2] / (-pull_y * LENGTH), 1.0, 1e-9);
        near(told.grip[1] / -pull_y, 1.0, 1e-9);
        near(told.start[1] / (pull_y * LENGTH), 1.0, 1e-9);
        for state in &told.states[told.states.len() / 2..] {
            near(state.forces[0], 0.0, 1e-9 * pull_y);
            near(state.moments[2], pull_y * (LENGTH - state.x), 1e-9 * pull_y);
        }
    }
}

#[test]
fn the_root_of_a_spinning_body_carries_all_beyond_it_however_it_is_described() {
    let omega = 20.0;
    let pull = |x: f64| 0.5 * line_mass() * omega * omega * (LENGTH * LENGTH - x * x);
    for elements in [1, 3, 12] {
        let model = Blades {
            omega,
            elements,
            place: 0.5,
            ..Blades::default()
        };
        for fidelity in [Fidelity::Modal(2), Fidelity::Small(2), Fidelity::Rigid] {
            let told = rope(&model, fidelity);
            near(told.start[0] / pull(0.0), 1.0, 1e-9);
            near(told.here[0] / pull(0.5), 1.0, 1e-9);
            near(told.grip[0] / -told.start[0], 1.0, 1e-12);
            for state in &told.states[told.states.len() / 2..] {
                near(state.forces[0], pull(state.x), 1e-9 * pull(0.0));
            }
        }
    }
}

#[test]
fn a_bent_spinning_body_in_modes_balances_about_its_deformed_places() {
    // Two modes that only bend: the tip stays 2 m away along the axis, and the centrifugal forces, which are radial,
    // have no moment about the root. At the undeformed places that of the pull would be wrong by N v.
    let model = Blades {
        omega: 20.0,
        pull_y: 200.0,
        ..Blades::default()
    };
    let told = rope(&model, Fidelity::Modal(2));
    println!("modal(2): {told:?}");
    assert!(told.tip > 0.025 && told.start[0] > 1400.0);
    near(told.grip[2] / (-model.pull_y * LENGTH), 1.0, 1e-9);
    near(told.start[1] / (model.pull_y * LENGTH), 1.0, 1e-9);
}

#[test]
fn a_rigid_cantilever_carries_its_load_and_its_weight() {
    for elements in [1, 3, 12] {
        let model = Blades {
            pull_x: 7.0,
            pull_y: -5.0,
            twist: 3.0,
            fall: 9.81,
            elements,
            place: 0.7,
            ..Blades::default()
        };
        let told = rope(&model, Fidelity::Rigid);
        let weight = line_mass() * model.fall;
        let moment = |x: f64| 3.0 - 5.0 * (LENGTH - x) - 0.5 * weight * (LENGTH - x).powi(2);
        near(told.here[0], 7.0, 1e-9);
        near(told.here[1], moment(0.7), 1e-9);
        near(told.grip[2], -moment(0.0), 1e-9);
        let places = if elements < 4 { 9 } else { 3 };
        assert_eq!(told.states.len(), 2 * places * elements);
    }
}

#[test]
fn a_point_has_no_sections() {
    let model = Blades::default();
    let refused = model.build_as(
        Formulation::Rncf,
        Joints::Eliminated,
        &[("rope".into(), Fidelity::Point)],
    );
    let message = refused.err().unwrap().to_string();
    assert!(
        message.contains("section of body `rope`") && message.contains("`rigid`"),
        "{message}"
    );
}
