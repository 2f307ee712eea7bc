//! Free frames, rigid bodies and fixtures: what they become.

use super::model;
use crate::check::starts::ties::{self, Untied};
use crate::elements::Library;
use crate::model::{
    BodyId, Constraint, Expr, Fidelity, FrameId, FrameTie, Free, Held, INERTIAL, Joint, JointKind, Location, Marker,
    MarkerId, Model, Motions, Observable, ParamId, fold,
};
use Expr::{Number, Param};

/// Everything that moves freely, in one model.
pub const FREE: &str = r#"
model Flight {
    param m_arm = 2 kg;  param modes: count = 3;  param speed = 2 rad/s;
    material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    motion x(t) = 1 m * sin(2 [rad/s] * t);
    frame pin = moving(origin = [x(t), 0 m, 0 m]);
    frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
    frame f = free(origin = [0, 1, 0] m, axis = z, angle = 30 deg, velocity = [1, 0, 0] m/s, angular_velocity = [0, 0, 3] rad/s);
    frame flat in hub = free(plane = xy, origin = [1, 2, 0] m, angle = 10 deg, velocity = [0, 1, 0] m/s, speed = 2 * speed);
    frame gimbal in pin = turning(axis = x, angle = 10 deg, angular_velocity = [1, 2, 3] rad/s);
    frame hinge in pin = hinged(axis = [0, 0, 2], angle = 20 deg, speed = 60 rpm);
    /// An arm
    rigid arm in hub { mass = m_arm; inertia = [1, 2, 2.5, 0, 0, 0.1] kg*m^2; center = [0.5, 0, 0] m; axis = y; angle = 5 deg; angular_velocity = [0, 1, 0] rad/s; }
    rigid wheel { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [3, 0, 0] m; speed = 5 rad/s; }
    rigid bob in pin { mass = 3 kg; velocity = [0, 1, 0] m/s; }
    body b1 in f { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); mean_axes; }
    body b2 in flat { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); modal(modes); }
    body b3 in gimbal { spatial; line from [1, 0, 0] m to [1, 1, 0] m; mesh 2 * cable(thin, steel); small(2); }
    body b4 in hinge { planar xy; line from [0, 0, 0] m to [0, 2, 0] m; mesh 2 * cable(thin, steel); rigid; }
    body b5 in arm { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint c2 = clamp(b2.start, flat);
    joint c3 = clamp(b3.start, gimbal);
    joint c5 = clamp(b5.start, arm);
    fixture ball on b1.end { mass = 5 kg; offset = 20 cm; gyration = 10 cm; }
    fixture tool on arm.at([1, 0, 0] m) { mass = 2 * m_arm; inertia = [0, 1, 1] kg*m^2; }
    fixture lump on bob { mass = 1 kg; }
    load weight = gravity([0, -9.81, 0] m/s^2);
    output u = b1.end.x;
}
"#;

fn frame<'m>(model: &'m Model, name: &str) -> (&'m crate::model::Frame, &'m Free) {
    let frame = model.frames.iter().find(|frame| frame.name == name).expect(name);
    (frame, frame.free.as_ref().expect("free"))
}

#[test]
fn free_frames_and_their_start() {
    let model = model(FREE);
    let (f, free) = frame(&model, "f");
    assert_eq!((f.parent, &free.motions), (INERTIAL, &Motions::Spatial));
    assert_eq!(f.origin, [0.0, 1.0, 0.0].map(Number));
    assert_eq!(free.velocity, [1.0, 0.0, 0.0].map(Number));
    assert_eq!(free.spin, [0.0, 0.0, 3.0].map(Number));
    assert_eq!(f.rotation.as_ref().map(|r| r.axis), Some([0.0, 0.0, 1.0]));
    assert!(free.parts.is_empty() && !free.is_body);

    let (flat, free) = frame(&model, "flat");
    assert_eq!(model.frames[flat.parent.0].name, "hub");
    assert_eq!(free.motions, Motions::Planar { normal: 2 });
    let speed = Expr::Binary(
        crate::model::Binary::Multiply,
        Box::new(Number(2.0)),
        Box::new(Param(ParamId(2))),
    );
    assert_eq!(free.spin, [Number(0.0), Number(0.0), speed]);
    assert_eq!(flat.rotation.as_ref().map(|r| r.axis), Some([0.0, 0.0, 1.0]));

    let (gimbal, free) = frame(&model, "gimbal");
    assert_eq!(
        (&gimbal.origin, &free.motions),
        (&[0.0; 3].map(Number), &Motions::Turning)
    );
    let (_, free) = frame(&model, "hinge");
    let axis = [0.0, 0.0, 1.0];
    assert_eq!(free.motions, Motions::Hinged { axis });
    let [_, _, Number(speed)] = free.spin else {
        panic!("a number")
    };
    assert!((speed - 2.0 * std::f64::consts::PI).abs() < 1e-12);
}

#[test]
fn angular_velocities_are_vectors_of_any_form() {
    for text in [
        "3 * [0, 0, 1] rad/s",
        "[0, 0, 1] rad/s * (1 + 2)",
        "[0, 0, 1] rad/s * (if speed > 0 [rad/s] { 3 } else { 1 })",
        "[0, 0, 1] rad/s + [0, 0, 2] rad/s",
        "2*pi * [0, 0, 0.477464829275686] Hz",
    ] {
        let model = model(&FREE.replace("[0, 0, 3] rad/s", text));
        let (_, free) = frame(&model, "f");
        let spin = free
            .spin
            .each_ref()
            .map(|value| fold::with_defaults(&model, value, 0.0).unwrap());
        assert!(
            (spin[2] - 3.0).abs() < 1e-12 && spin[0] == 0.0 && spin[1] == 0.0,
            "{text}: {spin:?}"
        );
    }
}

#[test]
fn rigid_bodies_are_frames_with_parts() {
    let model = model(FREE);
    let (arm, free) = frame(&model, "arm");
    assert_eq!((arm.doc.as_str(), free.is_body), ("An arm", true));
    assert_eq!(free.motions, Motions::Spatial);
    let [own, tool] = free.parts.as_slice() else {
        panic!("two parts")
    };
    assert_eq!((own.name.as_str(), &own.mass), ("arm", &Param(ParamId(0))));
    assert_eq!(own.inertia, [1.0, 2.0, 2.5, 0.0, 0.0, 0.1].map(Number));
    assert_eq!(own.center, [0.5, 0.0, 0.0].map(Number));
    assert_eq!(
        (tool.name.as_str(), &tool.center),
        ("tool", &[1.0, 0.0, 0.0].map(Number))
    );
    let (_, wheel) = frame(&model, "wheel");
    assert_eq!(wheel.motions, Motions::Planar { normal: 2 });
    assert_eq!(wheel.parts[0].inertia, [0.0, 0.0, 0.1, 0.0, 0.0, 0.0].map(Number));
    let (bob, free) = frame(&model, "bob");
    assert_eq!((&free.motions, bob.rotation.is_none()), (&Motions::Shifting, true));
    assert_eq!(free.parts.len(), 2);
    let fixture = &model.fixtures[0];
    assert_eq!((fixture.body, &fixture.at), (BodyId(0), &Location::End));
    let constants = fixture.constants.each_ref().map(|value| match value {
        Number(value) => *value,
        other => panic!("{other:?}"),
    });
    let second = 5.0 * (0.04 + 0.01);
    let wanted = [5.0, 1.0, 0.0, 0.0, second, 0.0, 0.0, 0.0, 0.0, 0.0];
    for (found, want) in constants.into_iter().zip(wanted) {
        assert!((found - want).abs() < 1e-15, "{found} {want}");
    }
    let fidelity: Vec<_> = model.bodies.iter().map(|body| body.fidelity.clone()).collect();
    let want = [
        Fidelity::Full,
        Fidelity::Modal(Param(ParamId(1))),
        Fidelity::Small(Number(2.0)),
        Fidelity::Rigid,
        Fidelity::Full,
    ];
    assert_eq!(fidelity, want);
    let ties: Vec<bool> = model.bodies.iter().map(|body| body.tie == FrameTie::MeanAxes).collect();
    assert_eq!(ties, [true, false, false, false, false]);
}

/// The first body of [`FREE`] with other ties than its mean axes.
fn tied_by(joints: &[(JointKind, Location)]) -> Model {
    let mut model = model(FREE);
    model.bodies[0].tie = FrameTie::Joints;
    let frame = model.bodies[0].frame;
    for (at, (kind, place)) in joints.iter().enumerate() {
        model.joints.push(Joint {
            repeat: None,
            name: format!("j{at}"),
            doc: String::new(),
            kind: *kind,
            body: BodyId(0),
            at: place.clone(),
            frame,
            point: None,
        });
    }
    model
}

fn hold(order: usize, axis: usize) -> JointKind {
    JointKind::Hold {
        of: [Held::Position, Held::Slope][order],
        axis,
    }
}

fn loose(motions: &str) -> Result<(), Untied> {
    let motions = motions.into();
    Err(Untied::Loose { motions })
}

/// A straight spatial body along x in a free frame.
#[test]
fn six_ties_are_counted() {
    use JointKind::{Clamp, ClampFull, Pin};
    use Location::{End, Start};
    let check = |joints: &[(JointKind, Location)]| {
        let model = tied_by(joints);
        ties::check(&model, &Library::standard(), model.bodies[0].frame)
    };
    let twice = |tie: &str| Err(Untied::Twice { tie: tie.into() });
    assert_eq!(check(&[(Clamp, Start)]), loose("turning about the x axis"));
    assert_eq!(check(&[(ClampFull, Start)]), loose("turning about the x axis"));
    assert_eq!(
        check(&[(Pin, Start), (Pin, End)]),
        twice("j1"),
        "both hold the length of the body"
    );
    assert_eq!(
        check(&[(Pin, Start), (hold(0, 1), End), (hold(0, 2), End)]),
        loose("turning about the x axis")
    );
    assert_eq!(check(&[(Clamp, Start), (hold(0, 2), End)]), twice("j1"));
    assert_eq!(check(&[]), loose("any motion"));
    assert_eq!(
        check(&[(hold(0, 1), Start), (hold(0, 2), Start), (Pin, End)]),
        loose("turning about the x axis")
    );
    // Six conditions, one of them twice.
    assert_eq!(
        check(&[(Pin, Start), (hold(1, 1), Start), (hold(0, 1), End)]),
        twice("j2")
    );
}

/// Six, five and seven conditions of a planar body's three.
#[test]
fn planar_ties_are_counted() {
    use JointKind::{Clamp, Pin};
    let check = |kinds: &[(JointKind, Location)]| {
        let mut model = model(FREE);
        let flat = model.bodies[1].frame;
        model.joints.retain(|joint| joint.frame != flat);
        for (kind, at) in kinds {
            model.joints.push(Joint {
                repeat: None,
                name: "tie".into(),
                doc: String::new(),
                kind: *kind,
                body: BodyId(1),
                at: at.clone(),
                frame: flat,
                point: None,
            });
        }
        ties::check(&model, &Library::standard(), flat)
    };
    assert_eq!(check(&[(Clamp, Location::Start)]), Ok(()));
    assert_eq!(check(&[(Pin, Location::Start)]), loose("turning about the z axis"));
    assert_eq!(check(&[(Pin, Location::Start), (hold(0, 1), Location::End)]), Ok(()));
    let twice = Err(Untied::Twice { tie: "tie".into() });
    assert_eq!(check(&[(Clamp, Location::Start), (hold(0, 1), Location::End)]), twice);
    assert_eq!(
        check(&[(Pin, Location::Start), (hold(0, 0), Location::End)]),
        twice,
        "along the body is held by the pin"
    );
}

fn observed(marker: usize, component: usize) -> Expr {
    Expr::Observed(Observable::Marker {
        marker: MarkerId(marker),
        derivative: 0,
        component,
    })
}

fn product(a: usize, b: usize) -> Expr {
    use crate::model::Binary::{Add, Multiply};
    let term = |k| Expr::Binary(Multiply, Box::new(observed(a, k)), Box::new(observed(b, k)));
    let first = Expr::Binary(Add, Box::new(term(0)), Box::new(term(1)));
    Expr::Binary(Add, Box::new(first), Box::new(term(2)))
}

fn constrained(model: &mut Model, markers: Vec<Marker>, row: impl Fn(usize) -> Expr, absolute: Option<BodyId>) {
    let first = model.markers.len();
    let ids = (0..markers.len()).map(|at| MarkerId(first + at)).collect();
    model.markers.extend(markers);
    model.constraints.push(Constraint {
        name: "cross".into(),
        doc: String::new(),
        kind: "constraint".into(),
        markers: ids,
        first_party: 1,
        rows: vec![("direction".into(), row(first))],
        absolute,
    });
}

/// A cross axis that stays perpendicular is the sixth tie of a clamped body, but not one along it.
#[test]
fn constraints_that_turn_the_frame_count() {
    let clamped = || tied_by(&[(JointKind::Clamp, Location::Start)]);
    let direction = |frame, along: [f64; 3]| Marker::Direction {
        frame,
        along: along.map(Number),
    };
    let id = clamped().bodies[0].frame;
    let turning_x = loose("turning about the x axis");

    let mut model = clamped();
    let markers = vec![direction(id, [0.0, 1.0, 0.0]), direction(INERTIAL, [0.0, 0.0, 1.0])];
    constrained(&mut model, markers.clone(), |first| product(first, first + 1), None);
    assert_eq!(ties::check(&model, &Library::standard(), id), Ok(()));

    let mut model = clamped();
    constrained(&mut model, markers, |first| product(first, first + 1), Some(BodyId(0)));
    assert_eq!(
        ties::check(&model, &Library::standard(), id),
        turning_x,
        "not there where the body is relative"
    );

    // Only the axis of the body is held, which the clamp has done.
    let mut model = clamped();
    let markers = vec![direction(id, [1.0, 0.0, 0.0]), direction(INERTIAL, [0.0, 0.0, 1.0])];
    constrained(&mut model, markers, |first| product(first, first + 1), None);
    assert_eq!(ties::check(&model, &Library::standard(), id), turning_x);

    // Places of the body stay where they are when the frame turns.
    let mut model = clamped();
    let end = Marker::BodyPoint {
        body: BodyId(0),
        at: Location::End,
    };
    constrained(&mut model, vec![end], |first| observed(first, 2), None);
    assert_eq!(ties::check(&model, &Library::standard(), id), turning_x);

    // Fixed in the frame, and given by other directions at t = 0.
    for (which, want) in [(0, Ok(())), (1, Ok(()))] {
        let mut model = clamped();
        let markers = vec![
            Marker::BodySlope {
                body: BodyId(0),
                at: Location::Start,
            },
            Marker::Normal {
                frame: id,
                marker: MarkerId(0),
                which,
            },
            Marker::Normal {
                frame: INERTIAL,
                marker: MarkerId(0),
                which: 1 - which,
            },
        ];
        constrained(&mut model, markers, |first| product(first + 1, first + 2), None);
        assert_eq!(ties::check(&model, &Library::standard(), id), want);
    }
}

/// An angle counts, and a frame that is tied may be driven as well.
#[test]
fn angles_count() {
    let mut model = model(FREE);
    let hinge = FrameId(model.frames.iter().position(|frame| frame.name == "hinge").unwrap());
    model.bodies[3].fidelity = Fidelity::Full;
    assert_eq!(
        ties::check(&model, &Library::standard(), hinge),
        loose("turning about the z axis")
    );
    let mut driven = model.clone();
    let angle = Marker::Angle { frame: hinge };
    constrained(&mut driven, vec![angle.clone()], |first| observed(first, 0), None);
    assert_eq!(ties::check(&driven, &Library::standard(), hinge), Ok(()));
    model.joints.push(Joint {
        repeat: None,
        name: "root".into(),
        doc: String::new(),
        kind: JointKind::Clamp,
        body: BodyId(3),
        at: Location::Start,
        frame: hinge,
        point: None,
    });
    assert_eq!(ties::check(&model, &Library::standard(), hinge), Ok(()));
    constrained(&mut model, vec![angle], |first| observed(first, 0), None);
    assert_eq!(ties::check(&model, &Library::standard(), hinge), Ok(()));
}

/// A point mass does not hold the frame that it is fixed to.
#[test]
fn mass_without_inertia_needs_ties() {
    let hub = "rigid hub2 { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }";
    assert!(
        model(&FREE.replace("rigid bob", &format!("{hub} rigid bob")))
            .frames
            .len()
            > 9
    );
    let mut model = model(FREE);
    let arm = FrameId(model.frames.iter().position(|frame| frame.name == "arm").unwrap());
    let free = model.frames[arm.0].free.as_mut().unwrap();
    free.parts.truncate(1);
    free.parts[0].inertia = [0.0; 6].map(Number);
    free.parts[0].center = [0.0; 3].map(Number);
    // Its clamped body leaves the turning about the own axis.
    assert_eq!(
        ties::check(&model, &Library::standard(), arm),
        loose("turning about the x axis")
    );
    let free = model.frames[arm.0].free.as_mut().unwrap();
    free.parts[0].inertia[0] = Number(1e-6);
    assert_eq!(ties::check(&model, &Library::standard(), arm), Ok(()));
}

/// A cable that is tied to its frame by a clamp and by what its end holds.
const FLIGHT: &str = r#"
model Flight {
    param bend = 2 [1/m];
    material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    frame f = free();
    body b in f {
        spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel);
        initial position [x, bend * x^2, 0];
        initial velocity [0, 0, 1 [1/s] * x * (1 - x / 2 m)];
    }
    joint root = clamp(b.start, f);
    joint twist = hold(b.end.z);
    output u = b.end.x;
}
"#;

#[test]
fn initial_shapes_are_functions_of_the_arclength() {
    let model = model(FLIGHT);
    let initial = &model.bodies[0].initial;
    let position = initial.position.as_ref().expect("a position");
    assert_eq!((&position[0], &position[2]), (&Expr::Arclength, &Number(0.0)));
    assert!(initial.velocity.is_some());
    // Place, and slope by derivation: y = 2 x^2.
    let [place, slope] = crate::symbolic::along_axis(&model, position, 1.5, 0.0);
    assert_eq!((place, slope), ([1.5, 4.5, 0.0], [1.0, 6.0, 0.0]));
}

#[test]
fn ties_are_those_of_the_initial_shape() {
    let bent = model(FLIGHT);
    assert_eq!(ties::check(&bent, &Library::standard(), FrameId(1)), Ok(()));
    let mut straight = bent;
    straight.bodies[0].initial.position = None;
    // Of a straight body the end's height is fixed by the direction at its start.
    let tie = "twist".to_string();
    assert_eq!(
        ties::check(&straight, &Library::standard(), FrameId(1)),
        Err(Untied::Twice { tie })
    );
}

/// What numbers and params make of vectors has the components that are written one by one.
#[test]
fn vectors_of_params_are_multiplied_and_added() {
    let heads = [
        "inertia = [m/12*(3*r^2 + h^2), m/12*(3*r^2 + h^2), m/2*r^2]; origin = [1 m + r, -2*h, 0];",
        "inertia = m/12 * ([3*r^2, 3*r^2, 6*r^2] + [h^2, h^2, 0]); origin = [1, 0, 0] m - [-r, 2*h, 0];",
    ];
    let [one_by_one, vectors] = heads.map(|head| {
        let params = "param m = 3 kg; param r = 0.2 m; param h = 50 mm;";
        let model = model(&format!(
            "model Discs {{ {params} rigid disc {{ mass = m; {head} }} output top = disc.position; }}"
        ));
        let (_, disc) = frame(&model, "disc");
        let inertia = disc.parts[0].inertia.each_ref();
        inertia.map(|value| fold::with_defaults(&model, value, 0.0).expect("a number"))
    });
    for (one, other) in one_by_one.into_iter().zip(vectors) {
        assert!((one - other).abs() <= 1e-15, "{one} {other}");
    }
}
