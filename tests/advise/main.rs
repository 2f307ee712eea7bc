//! `advise` on scenes of which it is known how much model they need, and bodies that are described at run time.

mod described;
#[path = "../../models/examples/advise/scenes.rs"]
mod scenes;

use rncf::Model;
use rncf::app::{Advised, AdvisedRung, RunSettings, Wanted, advise};
use scenes::{Boom, Engine, Spinner};

fn advised(model: &impl Model, accuracy: f64, settings: &RunSettings) -> Advised {
    let wanted = Wanted {
        accuracy,
        ..Wanted::default()
    };
    advise(model, settings, &wanted).unwrap()
}

/// The rung that is named, and its word for the body.
fn named<'a>(advised: &'a Advised, body: &str) -> (&'a AdvisedRung, String) {
    let rung = &advised.rungs[advised.named.unwrap_or_else(|| panic!("{:?}", advised.sentences))];
    let (_, fidelity) = rung.fidelity.iter().find(|(name, _)| name == body).unwrap();
    (rung, fidelity.to_string())
}

#[test]
fn a_stiff_short_rod_is_rigid_but_no_point() {
    let found = advised(&Engine::default(), 1e-3, &RunSettings::default());
    let (rung, word) = named(&found, "rod");
    assert_eq!(word, "rigid", "{:#?}", found.rungs);
    assert!(rung.error.unwrap() < 3e-4 && rung.unknowns < found.rungs[found.declared.unwrap()].unknowns);
    // The rotary inertia of the rod counts.
    let point = found.rungs.iter().find(|rung| rung.name.starts_with("point")).unwrap();
    assert!(!point.suffices && point.error.unwrap() > 1e-2, "{point:?}");
    assert!(
        found.sentences[0].starts_with("`rod`: rigid suffices for 1e-3"),
        "{:?}",
        found.sentences
    );
}

#[test]
fn a_slender_slow_boom_has_two_modes() {
    let found = advised(&Boom::default(), 1e-3, &RunSettings::default());
    let (rung, word) = named(&found, "boom");
    assert_eq!(word, "modal(2)", "{:#?}", found.rungs);
    assert_eq!(rung.unknowns, Some(2));
    // For a fiftieth one mode suffices: the advice follows what is wanted.
    let found = advised(&Boom::default(), 2e-2, &RunSettings::default());
    assert_eq!(named(&found, "boom").1, "modal(1)", "{:#?}", found.rungs);
}

#[test]
fn the_core_between_long_tethers_is_a_point() {
    let found = advised(&Spinner::default(), 1e-3, &RunSettings::default());
    let (rung, word) = named(&found, "core");
    assert_eq!(word, "point", "{:#?}", found.rungs);
    // Each tether is a body of its own in the ladder; one param counts the elements of both.
    let bodies: Vec<&str> = rung.fidelity.iter().map(|(body, _)| body.as_str()).collect();
    assert_eq!(bodies, ["core", "tether[0]", "tether[1]"]);
    assert_eq!(rung.counts.len(), 1);
}

#[test]
fn an_accuracy_that_nothing_reaches_is_said_with_what_to_do() {
    let short = RunSettings {
        t_end: Some(3.0),
        ..RunSettings::default()
    };
    let boom = Boom {
        elements: 1,
        ..Boom::default()
    };
    let found = advised(&boom, 1e-9, &short);
    assert_eq!(found.named, None, "{:#?}", found.rungs);
    let text = &found.sentences[0];
    assert!(
        text.starts_with("Nothing on the ladder is known to reach 1e-9"),
        "{text}"
    );
    assert!(text.contains("Give finer meshes, e.g. `elements=4,8,16`"), "{text}");
}
