//! The guide is true: what its pages say of numbers is computed here from the models that stand there, beside a reference,
//! and each page shows the picture of a run. `BLESS=1 cargo test -p rncf-guide` draws the pictures anew.

mod beams;
mod blades;
mod equilibria;
mod first_rope;
mod frames;
mod imported;
mod joints;
mod labels;
mod own_element;
mod pages;
mod python;
mod rotors;
mod sail;
mod section_matrices;
mod sweeps;
mod trust;

use std::fs;
use std::path::{Path, PathBuf};

use rncf::app::charts::{Chart, Line};
use rncf::app::{EquilibriumSettings, Figure, History, Range, RunResult, RunSettings, run};
use rncf::equilibrium::{Kind, Uniform, follow};
use rncf::{AnyModel, Formulation, Joints};
use rncf_guide::drawing::{Drawing, Shots, picture};

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

/// That a page has a sentence with a number that was computed.
fn says(page: &str, words: &str) {
    let text = fs::read_to_string(docs().join(format!("guide/{page}.md"))).expect(page);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains(words), "{page}.md does not say `{words}`");
}

/// That the picture of a page is this drawing above these charts. Numbers may be apart by a unit where another processor rounds
/// otherwise.
fn shows(page: &str, drawing: Option<&Drawing<'_>>, figure: &Figure, title: &str) {
    let picture = &picture(drawing, figure, title);
    let name = format!("guide_{page}.svg");
    let path = docs().join("images").join(&name);
    if std::env::var_os("BLESS").is_some() {
        fs::write(&path, picture).expect("docs/images is there");
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        is_same(&kept, picture),
        "docs/images/{name} is another one: BLESS=1 cargo test -p rncf-guide {page}"
    );
    says(page, &format!("](../images/{name})"));
}

/// Whether two texts are the same but for units of the last place of their whole numbers.
fn is_same(one: &str, other: &str) -> bool {
    let parts = |text: &str| -> Vec<(String, bool)> {
        let mut parts: Vec<(String, bool)> = Vec::new();
        for letter in text.chars() {
            match parts.last_mut() {
                Some((part, digits)) if *digits == letter.is_ascii_digit() => part.push(letter),
                _ => parts.push((letter.to_string(), letter.is_ascii_digit())),
            }
        }
        parts
    };
    let (one, other) = (parts(one), parts(other));
    let near = |a: &str, b: &str| match (a.parse::<i64>(), b.parse::<i64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1,
        _ => a == b,
    };
    let same =
        |(a, b): (&(String, bool), &(String, bool))| a.1 == b.1 && if a.1 { near(&a.0, &b.0) } else { a.0 == b.0 };
    one.len() == other.len() && one.iter().zip(&other).all(same)
}

#[test]
fn pictures_are_compared_number_by_number() {
    assert!(is_same("<p x=\"12\">a 3</p>", "<p x=\"13\">a 3</p>"));
    assert!(!is_same("<p x=\"12\">a 3</p>", "<p x=\"14\">a 3</p>"));
    assert!(!is_same("<p x=\"12\">a 3</p>", "<p y=\"12\">a 3</p>"));
    assert!(!is_same("", "<p/>"));
}

/// A run with its pictures.
fn drawn(model: &dyn AnyModel, settings: RunSettings) -> (RunResult, Shots) {
    let result = run(
        model,
        &RunSettings {
            pictures: true,
            ..settings
        },
    )
    .unwrap_or_else(|error| panic!("{error}"));
    let shots = Shots::of_run(result.pictures.as_ref().expect("a scene is drawn"));
    (result, shots)
}

/// A column of a table.
fn column(history: &History, name: &str) -> Vec<f64> {
    let index = history.find(name).unwrap_or_else(|| panic!("no column {name}"));
    history.column(index).collect()
}

/// A column over the first one, in a unit of so much.
fn line(history: &History, name: &str, unit: f64, color: usize) -> Line {
    let values = column(history, name);
    Line::new(
        history
            .keys
            .iter()
            .copied()
            .zip(values.into_iter().map(|value| value / unit)),
        color,
    )
}

/// Equilibria over a range of a param.
fn over(model: &dyn AnyModel, name: &str, from: f64, to: f64, steps: u32) -> EquilibriumSettings {
    let param = model.params().iter().position(|param| param.name == name).expect(name);
    EquilibriumSettings {
        range: Some(Range { param, from, to }),
        steps,
        ..EquilibriumSettings::default()
    }
}

fn chart(x: &str, y: &str, lines: Vec<Line>) -> Chart {
    Chart {
        x: x.into(),
        y: y.into(),
        lines,
        ..Chart::default()
    }
}

/// The least and the largest value.
fn range(values: &[f64]) -> [f64; 2] {
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    values
        .iter()
        .fold(ends, |[low, high], &value| [low.min(value), high.max(value)])
}

/// The integral of a smooth function, by Simpson's rule.
fn integral(from: f64, to: f64, of: impl Fn(f64) -> f64) -> f64 {
    const PARTS: usize = 2000;
    let h = (to - from) / PARTS as f64;
    let weight = |i| {
        if i == 0 || i == PARTS {
            1.0
        } else if i % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    (0..=PARTS).map(|i| weight(i) * of(from + i as f64 * h)).sum::<f64>() * h / 3.0
}

/// The undeformed scene, and its equilibrium at rest under the whole load.
fn at_rest(model: &dyn AnyModel) -> Shots {
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .unwrap_or_else(|error| panic!("{error}"));
    let at = Uniform {
        kind: Kind::Static,
        ..Uniform::steady(0.0)
    };
    let found = follow(scene.as_mut(), &at, 0.05, |_, _| ()).unwrap_or_else(|error| panic!("{error}"));
    let state = found.state().expect("a path has an end").clone();
    Shots::of_states(scene.as_mut(), &[state])
}
