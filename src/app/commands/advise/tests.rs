//! The search on runs whose errors are given, and its words.

use super::ladder::{Choices, Setting};
use super::search::{Found, Outcome, Search, Trial};
use super::told::Advice;
use crate::app::machine::clock::Seconds;
use crate::app::results::history::{Column, History};
use crate::app::results::run::RunSettings;
use crate::app::testing::Rotor;
use crate::model::Fidelity;

/// Bodies `crank` and `rod`, or the first of them alone, on meshes that `coils` counts.
fn choices(bodies: usize, meshes: &[f64]) -> Choices {
    let names = ["crank", "rod"].into_iter().take(bodies);
    Choices {
        bodies: names.map(|name| (name.to_string(), Fidelity::Full)).collect(),
        meshes: meshes.iter().map(|&count| vec![(1, count)]).collect(),
        declared: vec![(1, meshes[0])],
        has_others: false,
        notes: Vec::new(),
    }
}

/// Errors of a rung's parts and its cost, which stand for its run.
type Model<'m> = &'m dyn Fn(&Setting) -> Result<(f64, f64), &'static str>;

fn found(choices: &Choices, wanted: f64, model: Model<'_>) -> Found {
    let mut solve = |setting: &Setting, _: &str, _: f64| match model(setting) {
        Ok((error, cpu)) => {
            let mut history = History::new(&Rotor::default(), Column::time());
            history.push(0.0, &[0.0, 2.0, 5.0]).unwrap();
            history.push(1.0, &[1.0 + error, 2.0, 5.0]).unwrap();
            Outcome::Ran(Box::new(Trial {
                history,
                unknowns: 1,
                steps: 1,
                cpu,
                warnings: Vec::new(),
            }))
        }
        Err("stop") => Outcome::Interrupted,
        Err(reason) => Outcome::Impossible(reason.into()),
    };
    Search {
        model: &Rotor::default(),
        choices,
        wanted,
        outputs: None,
        solve: &mut solve,
    }
    .run()
}

fn named(found: &Found) -> Option<&str> {
    found.named.map(|named| found.rungs[named].name.as_str())
}

fn sentences(choices: &Choices, found: &Found, wanted: f64) -> String {
    let advice = Advice {
        model: &Rotor::default(),
        settings: &RunSettings::default(),
        choices,
        found,
        wanted,
        rtol: 1e-6,
        time_error: 0.0,
        seconds: Seconds::default(),
        warnings: &[],
    };
    advice.sentences().join("\n")
}

fn modes(fidelity: Fidelity) -> usize {
    match fidelity {
        Fidelity::Modal(count) => count,
        Fidelity::Full => 100,
        _ => 0,
    }
}

#[test]
fn rungs_that_agree_by_symmetry_do_not_suffice() {
    let choices = choices(1, &[4.0]);
    // Modes 1 and 2 give the same, and so does the rigid body.
    let model = |setting: &Setting| {
        let count = modes(setting.fidelity[0].1);
        Ok((
            if count <= 2 { 0.1 } else { 1e-5 * 8.0 / count as f64 },
            1.0 + count as f64,
        ))
    };
    let found = found(&choices, 1e-3, &model);
    assert_eq!(named(&found), Some("modal(4)"));
    let names: Vec<&str> = found.rungs.iter().map(|rung| rung.name.as_str()).collect();
    assert_eq!(
        names,
        ["point", "rigid", "modal(1)", "modal(2)", "modal(4)", "modal(8)", "full"]
    );
    let rigid = found.rungs[1].estimate.unwrap();
    assert_eq!(rigid.next, [Some(0.0), Some(0.0)]);
    assert!((rigid.richest - 0.1).abs() < 1e-5 && !found.rungs[1].suffices);
    assert_eq!(found.declared, Some(6));
    let text = sentences(&choices, &found, 1e-3);
    assert!(
        text.starts_with("`crank`: modal(4) suffices for 1e-3 (error about 2e-5, 5 s); as declared: 101 s."),
        "{text}"
    );
    assert!(
        text.contains("`body crank .. { .. modal(4); }`; to try it: `run --fidelity \"crank=modal(4)\"`"),
        "{text}"
    );
}

#[test]
fn each_body_goes_as_far_down_as_it_can() {
    let choices = choices(2, &[4.0]);
    let model = |setting: &Setting| {
        let [crank, rod] = [0, 1].map(|body| setting.fidelity[body].1);
        if crank == Fidelity::Point {
            return Err("nothing turns it");
        }
        // The rod needs two modes, the crank none.
        let count = modes(rod);
        let error = match count {
            0 | 1 => 0.2,
            _ => 1e-4 / count as f64,
        };
        Ok((error, 1.0 + modes(crank) as f64 + count as f64))
    };
    let found = found(&choices, 1e-3, &model);
    assert_eq!(named(&found), Some("crank: rigid, rod: modal(2)"));
    assert!(matches!(&found.rungs[0].outcome, Outcome::Impossible(reason) if reason == "nothing turns it"));
    let text = sentences(&choices, &found, 1e-3);
    assert!(
        text.starts_with("`crank`: rigid, `rod`: modal(2) suffice for 1e-3"),
        "{text}"
    );
}

#[test]
fn the_coarsest_mesh_that_suffices_carries_the_modes() {
    let choices = choices(1, &[2.0, 4.0, 8.0, 16.0]);
    // Fourth order in the mesh; modes are a little worse and need at least one element each.
    let model = |setting: &Setting| {
        let (count, elements) = (modes(setting.fidelity[0].1), setting.counts[0].1);
        let mesh = 0.05 / elements.powi(4);
        Ok((
            mesh + if count < 100 { 0.01 / (1.0 + count as f64) } else { 0.0 },
            1.0 + count as f64 * elements,
        ))
    };
    let found = found(&choices, 1e-3, &model);
    // 0.05/4^4 = 2e-4 suffices; modes never do here: 0.01/9.
    assert_eq!(named(&found), Some("full, coils = 4"));
    assert_eq!(found.rungs[0].setting.counts, [(1, 4.0)]);
    // The differences fall by 16: the last one by a quarter of itself at most is left.
    let last = 0.05 / 8f64.powi(4) - 0.05 / 16f64.powi(4);
    assert!((found.remaining.unwrap() - last / 3.0).abs() < 1e-10);
    let text = sentences(&choices, &found, 1e-3);
    assert!(
        text.contains("all nodal vectors suffices with coils = 4") && text.contains("coils=4"),
        "{text}"
    );
}

#[test]
fn an_accuracy_out_of_reach_is_said_with_what_to_do() {
    let choices = choices(1, &[2.0, 4.0, 8.0]);
    let model = |setting: &Setting| Ok((0.5 / setting.counts[0].1, 1.0));
    let found = found(&choices, 1e-3, &model);
    assert_eq!((named(&found), found.richest), (None, Some(8)));
    let text = sentences(&choices, &found, 1e-3);
    assert!(
        text.starts_with(
            "Nothing on the ladder is known to reach 1e-3: with the finest mesh (`full, coils = 8`) an error"
        ),
        "{text}"
    );
    assert!(
        text.contains("Give finer meshes, e.g. `coils=8,16,32`, or ask for no less than"),
        "{text}"
    );
}

#[test]
fn a_richer_rung_that_is_faster_is_told() {
    let choices = choices(1, &[4.0]);
    for (cost, is_told) in [(0.9, false), (0.4, true)] {
        let model = |setting: &Setting| match setting.fidelity[0].1 {
            Fidelity::Point => Ok((1.0, 1.0)),
            Fidelity::Modal(2) => Ok((0.0, cost)),
            _ => Ok((0.0, 1.0)),
        };
        let found = found(&choices, 1e-3, &model);
        assert_eq!(named(&found), Some("rigid"));
        let text = sentences(&choices, &found, 1e-3);
        assert_eq!(
            text.contains("the fastest is `modal(2)` with 400 ms"),
            is_told,
            "{text}"
        );
    }
}

#[test]
fn what_ran_before_an_interruption_is_kept() {
    let choices = choices(1, &[2.0, 4.0]);
    let model = |setting: &Setting| match setting.fidelity[0].1 {
        Fidelity::Modal(1) => Err("stop"),
        _ => Ok((0.0, 1.0)),
    };
    let found = found(&choices, 1e-3, &model);
    assert!(found.is_interrupted);
    let names: Vec<&str> = found.rungs.iter().map(|rung| rung.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "point, coils = 2",
            "rigid, coils = 2",
            "full, coils = 2",
            "full, coils = 4"
        ]
    );
}

#[test]
fn a_model_without_bodies_has_nothing_to_choose_from() {
    let error = super::advise(&Rotor::default(), &Default::default(), &super::Wanted::default()).unwrap_err();
    assert!(error.starts_with("Rotor has nothing to choose from"), "{error}");
}
