//! Loops whose number is known, and parts: chains and rotors against closed forms and against single ones.

use rncf::Output;
use rncf::app::{EquilibriumSettings, modes};
use rncf::prelude::*;

use super::scene;

rncf::model! {
    /// Discs in a row on one axis, from the ground on, with a torsion spring between each and the next; they hang on each other.
    pub model Row {
        const n = 5;
        param stiffness = 40 N*m/rad;
        param polar = 0.3 kg*m^2;
        param mass = 2 kg;
        for i in 0..n {
            rigid disc[i] { mass = mass; inertia = [polar, polar / 2, polar / 2]; origin = [i * 0.1 m, 0 m, 0 m]; }
            load weight[i] = force(disc[i], [0 N, 0 N, (i + 1) * -1 N]);
        }
        joint root = revolute(inertial, disc[0], axis = x);
        spring first = torsional(root, stiffness = stiffness);
        for i in 0..n - 1 {
            joint hinge[i] = revolute(disc[i], disc[i + 1].at([-0.1, 0, 0] m), axis = x);
            spring twist[i] = torsional(hinge[i], stiffness = stiffness);
            output force[i] = hinge[i].force.z;
        }
        output all = sum(i in 0..n - 1, abs(hinge[i].force.z));
        output root_force = root.force.z;
    }
}

rncf::model! {
    use rncf_reference::shared::blades;
    pub model ThreeBlades {
        param speed = 12.1 rpm;
        param elements: count = 6;
        const number = 3;
        frame hub = rotating(axis = x, angle = speed * t);
        for b in 0..number {
            part blade[b] = Blade(azimuth = 2*pi*b/number, root = hub, count = elements);
        }
        output all = sum(b in 0..number, blade[b].spar.mass);
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    use super::unfolded::taken::blades;
    pub model OneBlade {
        param speed = 12.1 rpm;
        param elements: count = 6;
        frame hub = rotating(axis = x, angle = speed * t);
        part blade = Blade(azimuth = 0 deg, root = hub, count = elements);
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// A library of another crate under a path of this one.
mod taken {
    pub(super) use rncf_reference::shared::blades;
}

/// Angular frequencies, ascending.
fn frequencies<M: Model + Clone + 'static>(model: &M, count: usize) -> Vec<f64> {
    let settings = EquilibriumSettings {
        count,
        ..EquilibriumSettings::default()
    };
    let found = modes(model, &settings).unwrap();
    found.modes.iter().map(|mode| mode.im).collect()
}

/// What is seen at the start, by name.
fn at_rest<M: Model>(model: &M) -> (Vec<String>, Vec<f64>) {
    let mut scene = scene(model);
    let state = scene.rest(0.0);
    let mut row = vec![0.0; scene.output_columns()];
    let mut integrator = Integrator::new(&mut *scene, state, 1.0, Method::Radau, Options::default()).unwrap();
    let state = integrator.state().clone();
    integrator.system().outputs(&state, &mut row);
    let columns = |output: &Output| -> Vec<String> {
        let name = output.name;
        match output.components {
            [] => vec![name.to_string()],
            components => components
                .iter()
                .map(|component| format!("{name}.{component}"))
                .collect(),
        }
    };
    (M::outputs().iter().flat_map(columns).collect(), row)
}

#[test]
fn a_row_of_discs_has_the_frequencies_of_the_chain() {
    let row = Row::default();
    let found = frequencies(&row, 5);
    // 2 sqrt(k/J) sin((2 k - 1) pi / (2 (2 n + 1))) of a chain with one free end.
    let stiffness = 2.0 * (row.stiffness / row.polar).sqrt();
    assert_eq!(found.len(), 5);
    for (k, frequency) in found.iter().enumerate() {
        let wanted = stiffness * ((2 * k + 1) as f64 * std::f64::consts::PI / 22.0).sin();
        assert!((frequency / wanted - 1.0).abs() < 1e-9, "{k}: {frequency} {wanted}");
    }
}

/// Reactions of repeated joints: each carries the loads of all discs beyond it.
#[test]
fn reactions_of_repeated_joints_are_seen() {
    let (names, row) = at_rest(&Row::default());
    assert_eq!(
        names,
        ["force[0]", "force[1]", "force[2]", "force[3]", "all", "root_force"]
    );
    for (i, force) in row[..4].iter().enumerate() {
        let beyond: f64 = (i + 1..5).map(|disc| (disc + 1) as f64).sum();
        assert!((force.abs() - beyond).abs() < 1e-9, "{i}: {force} {beyond}");
    }
    let sum: f64 = row[..4].iter().map(|force| force.abs()).sum();
    assert!(
        (row[4] - sum).abs() < 1e-12 && (row[5].abs() - 15.0).abs() < 1e-9,
        "{row:?}"
    );
}

/// In a hub that turns in a prescribed way blades know nothing of each other: each frequency is there three times.
#[test]
fn three_blades_of_one_component_vibrate_as_one() {
    let (three, one) = (ThreeBlades::default(), OneBlade::default());
    let (all, single) = (frequencies(&three, 12), frequencies(&one, 4));
    assert_eq!((all.len(), single.len()), (12, 4));
    for (at, frequency) in all.iter().enumerate() {
        let wanted = single[at / 3];
        assert!((frequency / wanted - 1.0).abs() < 1e-7, "{at}: {frequency} {wanted}");
    }
    // Flapwise at rest, Euler and Bernoulli: 1.8751^2 sqrt(E I / (rho A l^4)); rotation adds Southwell's 1.17 spin^2, nearly.
    let still = 1.875_104_f64.powi(2) * (70e9 * 0.02_f64.powi(2) / 12.0 / 2700.0 / 81.0).sqrt();
    let resting = frequencies(
        &OneBlade {
            speed: 1e-9,
            ..OneBlade::default()
        },
        1,
    )[0];
    assert!((resting / still - 1.0).abs() < 1e-3, "{resting} {still}");
    let southwell = (still.powi(2) + 1.193 * one.speed.powi(2)).sqrt();
    assert!((single[0] / southwell - 1.0).abs() < 1e-3, "{} {southwell}", single[0]);
}

#[test]
fn outputs_of_parts_have_the_names_of_parts() {
    let (names, row) = at_rest(&ThreeBlades::default());
    assert_eq!(
        names[..4],
        [
            "blade[0].root_moment.x",
            "blade[0].root_moment.y",
            "blade[0].root_moment.z",
            "blade[0].mass"
        ]
    );
    let mass = 2700.0 * 0.06 * 0.02 * 3.0;
    assert!(
        (row[3] / mass - 1.0).abs() < 1e-12 && (row[12] / (3.0 * mass) - 1.0).abs() < 1e-12,
        "{row:?}"
    );
}
