//! Pictures of runs: what is drawn is where the outputs say.

use rncf::app::{Pictures, RunSettings, run};
use rncf::vector::{add, apply, norm, subtract};
use rncf_models::FreeFlight;

/// A cable that tumbles through space: its ends in the pictures are those of the outputs, in inertial axes.
#[test]
fn ends_of_curves_are_where_the_outputs_say() {
    let settings = RunSettings {
        t_end: Some(0.2),
        every: Some(0.05),
        pictures: true,
        ..RunSettings::default()
    };
    let result = run(&FreeFlight::default(), &settings).expect("a run");
    let Some(Pictures {
        curves,
        frames,
        times,
        shots,
        ..
    }) = &result.pictures
    else {
        panic!("no pictures");
    };
    assert_eq!((frames.join(" ").as_str(), times.len()), ("inertial f", 5));
    assert_eq!((curves[0].name.as_str(), curves[0].frame), ("cable", 1));
    for (row, shot) in shots.iter().enumerate() {
        let values = &result.history.values[row * 7..];
        let (place, rotation) = &shot.poses[1];
        for (point, output) in [(0, &values[..3]), (curves[0].points - 1, &values[3..6])] {
            let drawn = add(*place, apply(&rotation.matrix(), shot.points[point]));
            assert!(norm(subtract(drawn, [output[0], output[1], output[2]])) < 1e-12);
        }
    }
}
