//! A fixed sample of the random scenes of docs/scenes.md: all checks of the study, in every run of the tests.
//!
//! The texts stand beside this file as the generator writes them; `BLESS=1` writes them anew.

// What the generator writes has params that no joint needs.
#![allow(deprecated)]

mod s102;
mod s12;
mod s146;
mod s197;
mod s231;
mod s4;
mod s55;

use super::random_scenes::run::{columns, maker};
use super::random_scenes::study::{Compiled, Entry, Verdict, checks};
use super::random_scenes::texts::texts;
use rncf::Model;

fn compiled<M: Model>() -> Compiled {
    (maker::<M>, columns::<M>)
}

/// Runs all checks of a seed; those that the program refuses are named.
#[track_caller]
fn agrees(seed: u64, original: Compiled, copy: Option<Compiled>, refused: &[&str]) {
    let has_copy = copy.is_some();
    let entry = Entry { seed, original, copy };
    let verdicts = checks(&entry, 0);
    let mut names = Vec::new();
    for (name, verdict) in &verdicts {
        match verdict {
            Verdict::Agrees(_) => {}
            Verdict::Differs(by) | Verdict::Unresolved(by) => panic!("seed {seed}, {name}: {by}"),
            Verdict::Refused(why) => {
                assert!(refused.contains(name), "seed {seed}, {name}: {why}");
                names.push(*name);
            }
        }
    }
    assert_eq!(names, refused, "seed {seed}: what is refused");
    let is_checked = |check: &str| verdicts.iter().any(|(name, _)| *name == check);
    assert_eq!(is_checked("copy"), has_copy, "seed {seed}");
    for check in [
        "ANCF",
        "HHT",
        "generalized-alpha",
        "units",
        "meshes",
        "forces balance momentum",
    ] {
        assert!(is_checked(check), "seed {seed}: {check} was not compared");
    }
}

/// Words and numbers of a text.
fn words(text: &str) -> Vec<&str> {
    let is_between = |c: char| !(c.is_alphanumeric() || "._+-".contains(c));
    text.split(is_between).filter(|word| !word.is_empty()).collect()
}

#[test]
fn the_texts_are_those_of_the_generator() {
    let checked_in = [
        (4, true, include_str!("sampled_scenes/s4.rs")),
        (12, false, include_str!("sampled_scenes/s12.rs")),
        (55, false, include_str!("sampled_scenes/s55.rs")),
        (102, false, include_str!("sampled_scenes/s102.rs")),
        (146, false, include_str!("sampled_scenes/s146.rs")),
        (197, false, include_str!("sampled_scenes/s197.rs")),
        (231, true, include_str!("sampled_scenes/s231.rs")),
    ];
    for (seed, has_copy, text) in checked_in {
        let written = texts(seed, has_copy);
        if std::env::var_os("BLESS").is_some() {
            let path = format!("{}/accuracy/sampled_scenes/s{seed}.rs", env!("CARGO_MANIFEST_DIR"));
            std::fs::write(&path, written).unwrap_or_else(|error| panic!("{path}: {error}"));
            continue;
        }
        let (a, b) = (words(text), words(&written));
        assert_eq!(a.len(), b.len(), "seed {seed}");
        for (a, b) in a.iter().zip(&b) {
            // Last digits of sines differ between machines.
            let near = match (a.parse::<f64>(), b.parse::<f64>()) {
                (Ok(a), Ok(b)) => (a - b).abs() <= 1e-9 * a.abs(),
                _ => a == b,
            };
            assert!(near, "seed {seed}: {a}, {b}");
        }
    }
}

#[test]
fn scene_4() {
    agrees(4, compiled::<s4::A>(), Some(compiled::<s4::B>()), &["at rest: ANCF"]);
}

#[test]
fn scene_12() {
    agrees(12, compiled::<s12::A>(), None, &["at rest: ANCF"]);
}

#[test]
fn scene_55() {
    agrees(55, compiled::<s55::A>(), None, &["at rest: ANCF"]);
}

#[test]
fn scene_102() {
    agrees(102, compiled::<s102::A>(), None, &["at rest"]);
}

#[test]
fn scene_146() {
    agrees(146, compiled::<s146::A>(), None, &["at rest: ANCF"]);
}

#[test]
fn scene_197() {
    agrees(197, compiled::<s197::A>(), None, &["at rest"]);
}

#[test]
fn scene_231() {
    agrees(231, compiled::<s231::A>(), Some(compiled::<s231::B>()), &["at rest"]);
}
