//! A scene that moves, as a part of a page: its data, style and script.

use serde_json::{Value, json};

use super::base64::encode;
use super::{Pictures, Shapes};
use crate::app::writing::html::escape;
use crate::model::{Configuration, Curve, Sign, SignKind, SignPlace};
use crate::space::{Vector, matrix, rows};

/// What the part needs once in a page.
pub const STYLE: &str = include_str!("view.css");
const SCRIPT: &str = include_str!("view.js");

/// Codes of a 16-bit number from the least to the greatest value; the one above them is what is not known.
const MOST: f64 = 65534.0;
const UNKNOWN: u16 = 65535;

/// The element with its data, and the script behind it.
pub fn part(data: &Value) -> String {
    // Nothing in the data ends the element that holds it.
    let data = data.to_string().replace('<', "\\u003c");
    format!(
        "<div class=\"scene\"><script type=\"application/json\">{data}</script></div>\n<script>\n{SCRIPT}</script>\n"
    )
}

/// The data of a run.
pub fn of_run(title: &str, pictures: &Pictures) -> Value {
    let frames = pictures.frames.len();
    let mut low = vec![[f64::INFINITY; 3]; frames];
    let mut high = vec![[f64::NEG_INFINITY; 3]; frames];
    for shot in &pictures.shots {
        for (frame, moved) in displacements(pictures, shot) {
            for axis in 0..3 {
                low[frame][axis] = low[frame][axis].min(moved[axis]);
                high[frame][axis] = high[frame][axis].max(moved[axis]);
            }
        }
    }
    let told = pictures.scales();
    let is_met: Vec<bool> = pictures.colours.is_met().collect();
    let mut bytes = Vec::new();
    for (shot, values) in pictures.shots.iter().zip(&pictures.values) {
        for (frame, moved) in displacements(pictures, shot) {
            for axis in 0..3 {
                let part = share(moved[axis], [low[frame][axis], high[frame][axis]]);
                bytes.extend(((part * f64::from(UNKNOWN)).round() as u16).to_le_bytes());
            }
        }
        let each = values.len() / is_met.len().max(1);
        let kept = values.chunks(each.max(1)).zip(&is_met).filter(|(_, is_met)| **is_met);
        for ((values, _), told) in kept.zip(&told) {
            for value in values {
                let code = if value.is_finite() {
                    (share(*value, told.range) * MOST).round() as u16
                } else {
                    UNKNOWN
                };
                bytes.extend(code.to_le_bytes());
            }
        }
    }
    let finite = |bounds: &[[f64; 3]]| -> Vec<[f64; 3]> {
        let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
        bounds.iter().map(|all| all.map(finite)).collect()
    };
    let quantities: Vec<Value> = told
        .iter()
        .map(|told| {
            let [low, high] = told.range;
            json!({"name": told.name, "unit": told.unit, "low": low, "high": high, "largest": told.largest})
        })
        .collect();
    let coloured: Vec<usize> = pictures.colours.curves().collect();
    let mut notes = vec![pictures.told_of_rows()];
    let deforms = pictures.curves.iter().any(|curve| curve.is_flexible);
    let magnified = (pictures.is_referenced && deforms).then_some(
        "Deformation is what moves relative to the undeformed shape, which the frame of each body carries along.",
    );
    if let Some(text) = magnified {
        notes.push(text.into());
    } else if deforms {
        notes.push("In absolute coordinates no frame carries the undeformed shapes along, and the deformation is not magnified: take `--formulation rncf`.".into());
    }
    let spread: Vec<&str> = pictures
        .signs
        .iter()
        .filter(|sign| sign.kind == SignKind::Spread)
        .map(|sign| sign.name.as_str())
        .collect();
    if !spread.is_empty() {
        notes.push(format!(
            "Not drawn is gravity that changes from place to place: {}.",
            spread.join(", ")
        ));
    }
    if !told.is_empty() {
        notes.extend(pictures.colours.notes());
    }
    let mut data = scenery(title, &pictures.curves, &pictures.frames, &pictures.signs);
    for (index, curve) in pictures.curves.iter().enumerate() {
        data["curves"][index] = json!({
            "name": curve.name, "frame": curve.frame, "points": curve.points, "flexible": curve.is_flexible,
            "told": !told.is_empty() && coloured.contains(&index),
        });
    }
    let acting = pictures.shots.iter().flat_map(|shot| shot.acting.iter().flatten());
    data["times"] = json!(pictures.times);
    data["low"] = json!(finite(&low));
    data["high"] = json!(finite(&high));
    data["rest"] = json!(singles(pictures.rest.iter().flatten()));
    data["poses"] = json!(poses(&pictures.shots));
    data["acting"] = json!(singles(acting));
    data["followed"] = json!(pictures.followed());
    data["shots"] = json!(encode(&bytes));
    data["quantities"] = json!(quantities);
    data["magnified"] = json!(magnified);
    data["notes"] = json!(notes);
    data
}

/// The data of modes: their names, and what is told of each, with its heads.
pub fn of_modes(title: &str, shapes: &Shapes, modes: &[(String, Vec<[String; 2]>)]) -> Value {
    let told = modes.iter().zip(&shapes.moved).map(|((name, facts), moved)| {
        let moved = moved.iter().flatten().flatten();
        json!({"name": name, "facts": facts, "shape": singles(moved)})
    });
    let told: Vec<Value> = told.collect();
    let mut notes = vec![
        "The mode moves about the equilibrium, in axes that turn with the system, without growth or decay, a period in two seconds. At ×1 its largest displacement is a tenth of what the picture spans.".to_owned(),
    ];
    if told.len() < modes.len() {
        notes.push(format!(
            "{} of the {} modes are drawn, so that the page stays small.",
            told.len(),
            modes.len()
        ));
    }
    let mut data = scenery(title, &shapes.curves, &shapes.frames, &shapes.signs);
    for hidden in shapes.visible..shapes.curves.len() {
        data["curves"][hidden]["hidden"] = json!(true);
    }
    data["origins"] = json!(shapes.origins);
    data["times"] = json!([0.0]);
    data["rest"] = json!(singles(shapes.at.points.iter().flatten()));
    data["poses"] = json!(poses(std::slice::from_ref(&shapes.at)));
    data["acting"] = json!(singles(shapes.at.acting.iter().flatten()));
    data["followed"] = json!(shapes.followed());
    data["magnified"] = json!("Displacements of the mode");
    data["modes"] = json!(told);
    data["notes"] = json!(notes);
    data
}

/// What is the same in all pictures.
fn scenery(title: &str, curves: &[Curve], frames: &[String], signs: &[Sign]) -> Value {
    let curves: Vec<Value> = curves
        .iter()
        .map(|curve| {
            json!({
                "name": curve.name, "frame": curve.frame, "points": curve.points, "flexible": curve.is_flexible, "told": false,
            })
        })
        .collect();
    let sign = |sign: &Sign| {
        let (name, kind) = (&sign.name, sign.kind.name());
        match sign.place {
            Some(SignPlace::Frame { frame, at }) => {
                json!({"name": name, "kind": kind, "frame": frame, "at": at.as_slice()})
            }
            Some(SignPlace::Curve { curve, point }) => {
                json!({"name": name, "kind": kind, "curve": curve, "point": point})
            }
            None => json!({"name": name, "kind": kind}),
        }
    };
    let signs: Vec<Value> = signs.iter().map(sign).collect();
    json!({
        "title": escape(title), "curves": curves, "frames": frames, "signs": signs, "quantities": [], "notes": [], "followed": 0,
    })
}

/// Origins and rotations, rows first, of all frames of all pictures: doubles as text.
fn poses(shots: &[Configuration]) -> String {
    let mut bytes = Vec::new();
    for (place, rotation) in shots.iter().flat_map(|shot| &shot.poses) {
        let rows = rows(&matrix(rotation));
        for value in place.iter().chain(rows.iter().flatten()) {
            bytes.extend(value.to_le_bytes());
        }
    }
    encode(&bytes)
}

/// Single precision as text.
fn singles<'v>(values: impl Iterator<Item = &'v f64>) -> String {
    let bytes: Vec<u8> = values.flat_map(|value| (*value as f32).to_le_bytes()).collect();
    encode(&bytes)
}

/// Where a value lies in a range, from 0 to 1.
fn share(value: f64, [low, high]: [f64; 2]) -> f64 {
    if high > low {
        ((value - low) / (high - low)).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// The frame of each point, and its displacement from the undeformed shape, frame axes.
fn displacements<'p>(pictures: &'p Pictures, shot: &'p Configuration) -> impl Iterator<Item = (usize, Vector)> + 'p {
    let curves = pictures.curves.iter();
    let frames = curves.flat_map(|curve| std::iter::repeat_n(curve.frame, curve.points));
    let moved = shot.points.iter().zip(&pictures.rest);
    frames.zip(moved.map(|(point, rest)| point - rest))
}
