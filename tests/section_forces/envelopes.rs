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
        start: Some(rncf::Start::Steady),
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
    // What the rows of the history say of the same places, beside which the ends of steps count.
    let force = result.history.find("root_force").unwrap();
    let (_, high) = result.history.extremes(force).unwrap();
    let largest = blade.axial_force.unwrap().value;
    assert!(
        largest >= high.value && largest < high.value * (1.0 + 1e-9),
        "{largest}"
    );
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

mod shaken {
    rncf::model! {
        /// A mass on the tip of a light beam, let go under a load: rows are a period of its motion apart.
        pub model Shaken {
            const length = 1 m;
            const radius = 10 mm;
            const load = 30 N;
            const tip = 50 kg;
            material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 60 MPa; }
            section rod = circle(radius = radius);
            body arm { planar xy; line from [0, 0, 0] m to [length, 0, 0]; mesh 4 * beam(rod, steel); }
            joint root = clamp(arm.start, inertial);
            rigid weight { plane xy; mass = tip; inertia = 1e-6 kg*m^2; origin = [length, 0 m, 0 m]; }
            joint end = weld(arm.end, weight);
            load pull = force(weight, [0 N, load, 0 N]);
            output y = weight.y;
            run { t_end = 1.27 s; every = 0.635 s; }
        }
    }
}

#[test]
fn what_breaks_between_rows_is_told() {
    let result = run(&shaken::Shaken {}, &RunSettings::default()).unwrap();
    assert_eq!(result.history.keys.len(), 3);
    // F (1 - cos(omega t)) at the root, with omega^2 = 3 EI / (m L^3).
    let (second_moment, load) = (std::f64::consts::PI / 4.0 * 1e-8, 30.0);
    let omega = (3.0 * 210e9 * second_moment / 50.0_f64).sqrt();
    let stress = |t: f64| load * (1.0 - (omega * t).cos()) * 0.01 / second_moment;
    let arm = &result.envelopes.bodies[0];
    let (largest, first) = (arm.stress.unwrap(), arm.yielding.unwrap());
    // And 2 F / k, half a period away from the rows.
    let (_, highest) = result.history.extremes(result.history.find("y").unwrap()).unwrap();
    let sag = 2.0 * load / (50.0 * omega * omega);
    assert!((highest.value / sag - 1.0).abs() < 1e-2, "{highest:?}, {sag}");
    assert!(
        (highest.at * omega / std::f64::consts::PI - 1.0).abs() < 0.1,
        "{highest:?}"
    );
    assert!(
        (largest.value / stress(std::f64::consts::PI / omega) - 1.0).abs() < 2e-2,
        "{largest:?}"
    );
    // 60 MPa are passed at 0.22 s.
    assert!((0.215..0.25).contains(&first.at), "{first:?}");
    let [warning] = &result.warnings[..] else {
        panic!("{:?}", result.warnings)
    };
    assert!(
        warning.contains("passes the yield stress of `steel`, 60 MPa"),
        "{warning}"
    );
}

mod stepped {
    rncf::model! {
        /// A shaft that is loaded at its thin end, and clamped at its thick one.
        pub model Stepped {
            param parts: count = 1;
            material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 50 MPa; }
            table radii { x = [0, 0.5, 0.5, 1] m; r = [10, 10, 20, 20] mm; }
            section round = circle(radius = radii.r);
            body shaft { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh parts at radii * beam(round, steel); }
            joint wall = clamp(shaft.end, inertial);
            load pull = force(shaft.start, [0, 0, 100] N);
            output z = shaft.start.z;
        }
    }
}

/// The thin side of a step has the largest stress: `4 F x / (pi r^3)`, 63.66 MPa, where the thick one has an eighth.
#[test]
fn both_sides_of_a_step_have_their_stress() {
    for parts in [1, 3] {
        let found = static_equilibria(&stepped::Stepped { parts }, &EquilibriumSettings::default()).unwrap();
        let largest = found.envelopes.bodies[0].stress.unwrap();
        let exact = 4.0 * 100.0 * 0.5 / (std::f64::consts::PI * 1e-6);
        assert!(
            (largest.value / exact - 1.0).abs() < 1e-3 && largest.x == 0.5,
            "{largest:?}, {exact}"
        );
        assert!(
            found
                .warnings
                .iter()
                .any(|warning| warning.contains("passes the yield stress"))
        );
    }
}

mod poked {
    rncf::model! {
        /// A bridge of one element, loaded at a quarter of its length.
        pub model Poked {
            param parts: count = 1;
            const length = 2 m;
            material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
            section rod = circle(radius = 10 mm);
            body bridge { planar xy; line from [0, 0, 0] m to [length, 0, 0]; mesh parts * beam(rod, steel); }
            joint left = pin(bridge.start, inertial);
            joint right = hold(bridge.end.y);
            load poke = force(bridge.at(0.25 * length), [0, -4, 0] N);
            load turn = moment(bridge.at(0.6 * length), [0, 0, 3] N*m);
            output y = bridge.end.x;
        }
    }
}

/// What acts between nodes makes its peak where it acts: 4 N and 3 N m at 0.5 and 1.2 m of 2 m, on supports of 4.5 and -0.5 N.
#[test]
fn a_load_within_an_element_has_its_peak() {
    for parts in [1, 3, 5] {
        let found = static_equilibria(&poked::Poked { parts }, &EquilibriumSettings::default()).unwrap();
        let peak = found.envelopes.bodies[0].bending_moment.unwrap();
        assert!(
            (peak.value / 2.6 - 1.0).abs() < 1e-3 && (peak.x - 1.2).abs() < 1e-9,
            "{parts}: {peak:?}"
        );
    }
}

mod uneven {
    rncf::model! {
        /// Rods that are pulled, with an area and a yield stress that change along them, and wires that bend, all without outermost fibres.
        pub model Uneven {
            param bending = 0 N;
            param pull = 10 kN;
            material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 150 MPa; }
            material weaker { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 300 [MPa] * (1 - 0.8 * x / (1 m)); }
            table areas { x = [0, 0.5, 0.5, 1] m; a = [2, 2, 0.5, 0.5] cm^2; i = [0.2, 0.2, 0.02, 0.02] cm^4; }
            section stepped { area = areas.a; second_moment = areas.i; torsion_constant = areas.i; shear_factor = 0.9; }
            section even { area = 1 cm^2; second_moment = 0.1 cm^4; }
            body thin { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 at areas * beam(stepped, steel); }
            body weak { planar xy; line from [0, 1, 0] m to [1, 1, 0] m; mesh 4 * cable(even, weaker); }
            joint thin_root = clamp(thin.start, inertial);
            joint weak_root = clamp(weak.start, inertial);
            load pull_thin = force(thin.end, [pull, 0 N, bending]);
            load pull_weak = force(weak.end, [pull, 0 N, 0 N]);
            output u = thin.end.x;
            output w = weak.end.x;
        }
    }
}

/// F / A is 200 MPa behind the step of the first rod, and 100 MPa in the second one, of which 60 MPa are too much at its end.
#[test]
fn area_and_yield_stress_are_those_of_the_place() {
    let found = |model: uneven::Uneven| static_equilibria(&model, &EquilibriumSettings::default()).unwrap();
    let pulled = found(uneven::Uneven::default());
    let [thin, weak] = &pulled.envelopes.bodies[..] else {
        panic!("two bodies")
    };
    let [first, second] = [thin, weak].map(|body| (body.yielding.unwrap(), body.yield_stress.unwrap()));
    assert!((thin.stress.unwrap().value / 200e6 - 1.0).abs() < 1e-3 && first.0.x >= 0.5);
    assert!((weak.stress.unwrap().value / 100e6 - 1.0).abs() < 1e-3);
    assert_eq!(first.1, 150e6);
    assert!(
        second.0.x > 0.8 && second.1 < 110e6 && second.0.value > second.1,
        "{second:?}"
    );
    let is_unknown = |warnings: &[String]| {
        warnings
            .iter()
            .any(|text| text.contains("while bending counts, in `thin`"))
    };
    assert!(!is_unknown(&pulled.warnings), "{:?}", pulled.warnings);
    // 50 N at 1 m: at the step 25 N m on a section of 0.02 cm^4, some 79 MPa at its radius of gyration.
    let bent = found(uneven::Uneven {
        bending: 50.0,
        pull: 10.0,
    });
    assert!(is_unknown(&bent.warnings), "{:?}", bent.warnings);
    assert!(bent.envelopes.bodies.iter().all(|body| body.yielding.is_none()));
}
