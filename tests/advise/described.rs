//! Bodies described otherwise than they are declared.

use rncf::app::{RunSettings, Wanted, advise, run};
use rncf::model::Fidelity;
use rncf::{Formulation, Joints, Model};

/// An arm on a hub that turns to and fro.
macro_rules! arm {
    ($name:ident, { $($fidelity:tt)* }) => {
        rncf::model! {
            pub model $name {
                material rubber { density = 1000 kg/m^3; young = 20 MPa; }
                section strip { area = 5 cm^2; second_moment = 5 cm^4; }
                frame hub = rotating(axis = z, angle = 0.1 rad * sin(3 [rad/s] * t)^2);
                body arm in hub {
                    planar xy;
                    line from [0, 0, 0] m to [1, 0, 0] m;
                    mesh 4 * cable(strip, rubber);
                    $($fidelity)*
                }
                joint root = clamp(arm.start, hub);
                output tip = arm.end.in(inertial);
                output carried = root.moment.z;
                run { t_end = 0.5 s; every = 0.05 s; }
            }
        }
    };
}
arm!(Arm, {});
arm!(ArmModal, {
    modal(3);
});
arm!(ArmRigid, {
    rigid;
});

rncf::model! {
    /// Bodies that cannot all be described in modes.
    pub model Net {
        const size = 1 m;
        /// Repeated over a param: one kind of body, whose number is chosen at run time.
        param spokes: count = 2;
        material rubber { density = 1000 kg/m^3; young = 20 MPa; }
        section strip { area = 5 cm^2; second_moment = 5 cm^4; }
        frame hub = rotating(axis = z, angle = 0.1 [rad/s] * t);
        body left in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(strip, rubber); }
        body right in hub { planar xy; line from [1, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(strip, rubber); }
        joint root = clamp(left.start, hub);
        joint node = merge(left.end, right.start);
        body loaded in hub { planar xy; line from [0, 1, 0] m to [1, 1, 0] m; mesh 2 * cable(strip, rubber); }
        joint loaded_root = clamp(loaded.start, hub);
        load wind = density(loaded, [0, 1, 0] N/m);
        frame wheel = rotating(axis = z, angle = 2 [rad/s] * t);
        body blade in wheel { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(strip, rubber); }
        joint blade_root = clamp(blade.start, wheel);
        start spun = spinning(wheel);
        frame float = free(plane = xy);
        body drifter in float { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(strip, rubber); mean_axes; }
        body stiff in hub { planar xy; line from [0, 2, 0] m to [1, 2, 0] m; mesh 2 * cable(strip, rubber); rigid; }
        joint stiff_root = clamp(stiff.start, hub);
        for a in 0..spokes {
            body spoke[a] in hub { planar xy; line from [0, 0, 0] m to [0, (1 + a) * size, 0]; mesh 2 * cable(strip, rubber); }
            joint spoke_root[a] = clamp(spoke[a].start, hub);
        }
        output tip = right.end;
        output others = loaded.end.x + blade.end.x + drifter.end.x + stiff.end.x + spoke[0].end.x;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A stick that flies: as a point nothing gives it an orientation.
    pub model Stick {
        material wood { density = 600 kg/m^3; young = 10 GPa; }
        section round { area = 3 cm^2; second_moment = 1 cm^4; }
        frame f = free(plane = xy, velocity = [1, 2, 0] m/s, speed = 3 rad/s);
        body stick in f { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(round, wood); }
        joint _tie = clamp(stick.start, f);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output end = stick.end.in(inertial);
        run { t_end = 0.3 s; every = 0.02 s; }
    }
}

fn as_described(words: &[(&str, Fidelity)]) -> RunSettings {
    RunSettings {
        fidelity: words
            .iter()
            .map(|(name, fidelity)| (name.to_string(), *fidelity))
            .collect(),
        ..RunSettings::default()
    }
}

#[test]
fn a_body_described_at_run_time_is_the_declared_one() {
    let modal = run(&ArmModal::default(), &RunSettings::default())
        .unwrap()
        .history
        .values;
    let settings = as_described(&[("arm", Fidelity::Modal(3))]);
    assert_eq!(run(&Arm::default(), &settings).unwrap().history.values, modal);
    let rigid = run(&ArmRigid::default(), &RunSettings::default())
        .unwrap()
        .history
        .values;
    let settings = as_described(&[("arm", Fidelity::Rigid)]);
    assert_eq!(run(&Arm::default(), &settings).unwrap().history.values, rigid);
    assert_eq!(run(&ArmModal::default(), &settings).unwrap().history.values, rigid);
    let full = run(&Arm::default(), &RunSettings::default()).unwrap().history.values;
    let settings = as_described(&[("arm", Fidelity::Full)]);
    assert_eq!(run(&ArmModal::default(), &settings).unwrap().history.values, full);
}

#[test]
fn the_root_of_a_point_carries_its_mass_at_its_centre() {
    let moment = |fidelity| {
        let result = run(&Arm::default(), &as_described(&[("arm", fidelity)])).unwrap();
        let carried = result.history.find("carried").unwrap();
        result.history.column(carried).collect::<Vec<f64>>()
    };
    // m L^2/4 against m L^2/3, with 0.5 kg and 1 m.
    let (point, rigid) = (moment(Fidelity::Point), moment(Fidelity::Rigid));
    assert!(rigid.iter().any(|moment| moment.abs() > 0.1));
    for (point, rigid) in point.iter().zip(&rigid) {
        assert!((point - 0.75 * rigid).abs() < 1e-9, "{point} {rigid}");
    }
}

#[test]
fn what_cannot_be_described_so_is_refused_by_name() {
    let refusal = |name: &str, fidelity| {
        let wanted = [(name.to_string(), fidelity)];
        let built = Net::default().build_as(Formulation::Rncf, Joints::Eliminated, &wanted);
        built.err().unwrap_or_else(|| panic!("{name} is built")).message
    };
    let cases = [
        ("spoke", Fidelity::Modal(2), "body `spoke` is repeated"),
        ("stiff", Fidelity::Modal(2), "body `stiff` is declared `rigid`"),
        (
            "drifter",
            Fidelity::Rigid,
            "body `drifter` cannot be `rigid` since its frame follows its mean axes",
        ),
        ("left", Fidelity::Rigid, "of body `left` out"),
        (
            "loaded",
            Fidelity::Point,
            "on body `loaded`, which is described by modes",
        ),
        (
            "blade",
            Fidelity::Modal(1),
            "body `blade` is described by modes, which have no initial shape",
        ),
        (
            "lft",
            Fidelity::Rigid,
            "there is no meshed body `lft`: there are `left`, `right`, `loaded`",
        ),
    ];
    for (name, fidelity, expected) in cases {
        let text = refusal(name, fidelity);
        assert!(text.contains(expected), "{text}");
    }
    let twice = vec![("left".to_string(), Fidelity::Full); 2];
    let built = Net::default().build_as(Formulation::Rncf, Joints::Eliminated, &twice);
    assert_eq!(built.err().unwrap().message, "body `left` is described twice");
    let right = [
        ("stiff".to_string(), Fidelity::Point),
        ("spoke".to_string(), Fidelity::Full),
    ];
    let scene = Net::default()
        .build_as(Formulation::Rncf, Joints::Eliminated, &right)
        .unwrap();
    let bodies = scene.bodies();
    let stiff = bodies.iter().find(|body| body.name == "stiff").unwrap();
    assert_eq!(stiff.fidelity, Fidelity::Point);
    let spoke = bodies.iter().find(|body| body.name == "spoke").unwrap();
    assert_eq!((spoke.repetitions, spoke.elements), (Some(2), 4));
}

#[test]
fn a_point_that_nothing_turns_is_reported_and_no_rung() {
    let text = run(&Stick::default(), &as_described(&[("stick", Fidelity::Point)]))
        .unwrap_err()
        .to_string();
    assert!(text.contains("frame `f`") && text.contains("no inertia"), "{text}");
    let found = advise(&Stick::default(), &RunSettings::default(), &Wanted::default()).unwrap();
    assert!(found.rungs[0].name == "point" && !found.rungs[0].suffices);
    assert!(
        found.rungs[0].reason.as_ref().unwrap().contains("no inertia"),
        "{:?}",
        found.rungs[0]
    );
    assert!(found.named.is_some(), "{found:#?}");
}
