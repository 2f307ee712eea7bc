use serde_json::Value;

use super::*;
use crate::model::{SectionBody, SignKind, SignPlace};
use crate::space::{Rotation, Vector};

/// A beam of one element and two pieces in the second frame, and a rigid body in the first.
fn pictures() -> Pictures {
    let curve = |name: &str, frame, points, is_flexible| Curve {
        name: name.into(),
        frame,
        points,
        is_flexible,
    };
    let body = SectionBody {
        name: "beam".into(),
        length: 2.0,
        elements: 1,
        states: 3,
        has_section: false,
        is_planar: true,
        knows_stress: false,
        knows_area: true,
        material: "steel",
    };
    let curves = vec![curve("beam", 1, 3, true), curve("ball", 0, 1, false)];
    Pictures {
        colours: Colours::of_bodies(vec![body], vec![[1e-3, 0.0, 0.0, 0.0, 0.0, 0.0]; 3], &curves),
        curves,
        frames: vec!["inertial".into(), "</script>".into()],
        signs: vec![Sign {
            name: "root".into(),
            kind: SignKind::Joint,
            place: Some(SignPlace::Curve { curve: 0, point: 0.0 }),
        }],
        times: Vec::new(),
        shots: Vec::new(),
        rest: vec![Vector::zeros(), Vector::x(), 2.0 * Vector::x(), Vector::repeat(5.0)],
        is_referenced: true,
        values: Vec::new(),
        rows: 5,
        stride: 2,
        is_short: false,
    }
}

fn states(forces: [f64; 3]) -> Vec<SectionState> {
    let state = |(place, force): (usize, f64)| SectionState {
        x: place as f64,
        forces: Vector::new(force, 0.0, 0.0),
        moments: Vector::new(0.0, 0.0, -2.0 * force),
        stress: None,
        axial_stress: Some(force.abs() / 0.5),
        least_bending: None,
        yield_stress: None,
        is_planar: true,
    };
    forces.into_iter().enumerate().map(state).collect()
}

fn take(pictures: &mut Pictures, t: f64, deflection: f64, states: &[SectionState]) {
    let mut points = pictures.rest.clone();
    points[2][1] += deflection;
    pictures.colours.meet(t, states);
    pictures.times.push(t);
    pictures.shots.push(Configuration {
        points,
        poses: vec![(Vector::zeros(), Rotation::identity()); 2],
        acting: Vec::new(),
    });
    let values = pictures.colours.values(states);
    pictures.values.push(values);
}

fn words(data: &Value) -> Vec<u16> {
    let text = data["shots"].as_str().unwrap();
    let bytes = base64::decoded(text);
    bytes
        .chunks(2)
        .map(|pair| u16::from_le_bytes([pair[0], pair[1]]))
        .collect()
}

#[test]
fn what_is_written_are_displacements_and_colours_over_their_ranges() {
    let mut pictures = pictures();
    take(&mut pictures, 0.0, -1e-3, &states([8.0, 4.0, 0.0]));
    // A row without a picture counts for the scale.
    pictures.colours.meet(0.5, &states([10.0, 4.0, -2.0]));
    take(&mut pictures, 1.0, 3e-3, &states([6.0, f64::NAN, 1.0]));
    let data = view::of_run("a <beam>", &pictures);
    let scales = pictures.scales();
    let names: Vec<&str> = scales.iter().map(|scale| scale.name).collect();
    assert_eq!(names, ["axial force", "axial strain", "stress", "bending moment"]);
    assert_eq!(scales[0].range, [-2.0, 10.0]);
    assert_eq!(scales[1].range, [-2e-3, 1e-2]);
    assert_eq!(scales[2].range, [0.0, 20.0]);
    assert_eq!(scales[3].range, [0.0, 20.0]);
    assert_eq!(scales[0].largest, "largest 10 N in beam at x = 0 m, t = 0.5 s");
    assert_eq!(
        (&data["low"][1][1], &data["high"][1][1]),
        (&(-1e-3).into(), &3e-3.into())
    );
    let all = words(&data);
    // Four points with three components, then three points of each quantity; two pictures.
    let size = 4 * 3 + 4 * 3;
    assert_eq!(all.len(), 2 * size);
    let tip = 2 * 3 + 1;
    assert_eq!((all[tip], all[size + tip], all[1]), (0, 65535, 16384));
    let force = |code: u16| -2.0 + 12.0 * f64::from(code) / 65534.0;
    for (point, wanted) in [8.0, 4.0, 0.0].into_iter().enumerate() {
        assert!((force(all[12 + point]) - wanted).abs() < 1e-3, "{all:?}");
    }
    assert_eq!(all[size + 13], 65535, "what is not a number has no colour");
    assert_eq!(data["curves"][0]["told"], true);
    assert_eq!(data["curves"][1]["told"], false);
    assert_eq!(data["signs"][0]["curve"], 0);
    let page = animation::page("a <beam>", &pictures);
    assert_eq!(page.matches("</script>").count(), 2, "no name ends the data");
    assert_eq!(page, animation::page("a <beam>", &pictures));
    assert!(page.contains("2 of the 5 rows of the run are drawn, one in 2;"));
}

#[test]
fn a_point_between_the_ends_and_the_middle_has_a_value_between_theirs() {
    let mut pictures = pictures();
    pictures.curves[0].points = 5;
    let body = pictures.colours.bodies().next().unwrap().clone();
    pictures.colours = Colours::of_bodies(vec![body], Vec::new(), &pictures.curves);
    let values = pictures.colours.values(&states([8.0, 4.0, -4.0]));
    assert_eq!(values[..5], [8.0, 6.0, 4.0, 0.0, -4.0]);
}

#[test]
fn in_absolute_coordinates_nothing_is_magnified() {
    let mut pictures = pictures();
    take(&mut pictures, 0.0, 1e-3, &[]);
    assert!(view::of_run("", &pictures)["magnified"].is_string());
    assert!(pictures.scales().is_empty(), "nothing is known of sections");
    pictures.is_referenced = false;
    let data = view::of_run("", &pictures);
    assert!(data["magnified"].is_null() && data["notes"].to_string().contains("take `--formulation rncf`"));
}
