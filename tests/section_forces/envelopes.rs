//! Envelopes of whole runs.

use rncf::Model;
use rncf::app::{EquilibriumSettings, Range, RunSettings, run, static_equilibria, steady};
use rncf_models::SpinUp;

use crate::models::{Blades, DENSITY, LENGTH, RADII, area, second_moment};

#[test]
fn a_run_that_breaks_its_material_warns_once() {
    // From rest in a hub that turns: the blades swing and stretch.
    let model = Blades {
        omega: 200.0,
        ..Blades::default()
    };
    let settings = RunSettings {
        start: rncf::Start::Steady,
        t_end: Some(0.02),
        every: Some(0.005),
        ..RunSettings::default()
    };
    let result = run(&model, &settings).unwrap();
    let [blade, rope] = &result.envelopes.bodies[..] else {
        panic!("two bodies")
    };
    assert_eq!((&*blade.body.name, &*rope.body.name), ("blade", "rope"));
    let root = 0.5 * DENSITY * model.omega.powi(2) * LENGTH * LENGTH;
    for body in [blade, rope] {
        let (force, stress) = (body.axial_force.unwrap(), body.stress.unwrap());
        assert!((force.value / area() / root - 1.0).abs() < 5e-3, "{force:?}");
        assert!(
            (stress.value / root - 1.0).abs() < 5e-3 && stress.x == 0.0,
            "{stress:?}"
        );
        assert_eq!(body.yielding.map(|peak| (peak.at, peak.x)), Some((0.0, 0.0)));
    }
    // What the rows of the history say of the same places.
    let force = result.history.find("root_force").unwrap();
    let (_, high) = result.history.extremes(force).unwrap();
    assert_eq!(high.value, blade.axial_force.unwrap().value);
    assert!(rope.shear_force.is_none() && blade.shear_force.is_some() && blade.torque.is_none());
    let [warning] = &result.warnings[..] else {
        panic!("{:?}", result.warnings)
    };
    println!("{warning}");
    for part in [
        "passes the yield stress of `steel`, 250 MPa, at t = 0 s",
        "625",
        "x = 0 m",
    ] {
        assert!(warning.contains(part), "{warning}");
    }
}

#[test]
fn a_section_without_extents_tells_its_axial_stress() {
    let settings = RunSettings {
        t_end: Some(2.0),
        every: Some(0.1),
        ..RunSettings::default()
    };
    let result = run(&SpinUp::default(), &settings).unwrap();
    let body = &result.envelopes.bodies[0];
    let (stress, force) = (body.stress.unwrap(), body.axial_force.unwrap());
    assert!(!body.body.knows_stress && body.bending_moment.unwrap().value > 0.0);
    assert!((stress.value * 0.7299e-4 / force.value.abs() - 1.0).abs() < 1e-12);
    assert!(body.yielding.is_none() && result.warnings.is_empty());
}

#[test]
fn equilibria_name_the_value_at_which_the_material_yields() {
    let model = Blades {
        omega: 200.0,
        ..Blades::default()
    };
    let result = steady(&model, &EquilibriumSettings::default()).unwrap();
    let [warning] = &result.warnings[..] else {
        panic!("{:?}", result.warnings)
    };
    println!("{warning}");
    // rho w^2 L^2 / 2 is 250 MPa at 126.6 rad/s, of 32 steps the 21st.
    assert!(warning.contains("at spin = 131.25 rad/s"), "{warning}");
    let blade = &result.envelopes.bodies[0];
    assert_eq!(blade.yielding.unwrap().at, 131.25);
    assert_eq!(blade.stress.unwrap().at, 200.0);

    // Along a parameter, in its declared unit.
    let param = Blades::params().iter().position(|param| param.name == "omega").unwrap();
    let settings = EquilibriumSettings {
        range: Some(Range {
            param,
            from: 100.0,
            to: 150.0,
        }),
        steps: 10,
        ..EquilibriumSettings::default()
    };
    let result = steady(&model, &settings).unwrap();
    assert!(
        result.warnings[0].contains("at omega = 130 rad/s"),
        "{:?}",
        result.warnings
    );
}

#[test]
fn static_loads_have_their_envelope_too() {
    let model = Blades {
        pull_y: 2000.0,
        ..Blades::default()
    };
    let result = static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
    let blade = &result.envelopes.bodies[0];
    let moment = blade.bending_moment.unwrap();
    assert_eq!((moment.x, moment.at), (0.0, 1.0));
    let section = moment.value * RADII[0] / second_moment() + blade.axial_force.unwrap().value / area();
    assert!((blade.stress.unwrap().value / section - 1.0).abs() < 2e-2, "{blade:?}");
    assert!(
        result.warnings[0].contains("at load_factor = 0."),
        "{:?}",
        result.warnings
    );
}
