//! Parts of the report on modes: their table, Campbell diagrams, and what to read off, also as plain text.

use std::fmt::Write;

use super::campbell::Campbell;
use super::charts::{Chart, Line};
use super::command::Frequency;
use super::history::Column;
use super::modes::{Modes, SeenMode, growth, neutral};
use super::parameters::digits;
use super::report::{escape, figure};
use crate::modes::{Critical, Whirl};

/// Colours of the senses of whirl, their order in legends.
const CLASSES: [(Whirl, usize, &str); 4] = [
    (Whirl::Forward, 0, "forward whirl"),
    (Whirl::Backward, 1, "backward whirl"),
    (Whirl::Mixed, 2, "mixed"),
    (Whirl::None, 5, "no whirl"),
];

fn color(whirl: Whirl) -> usize {
    let class = CLASSES.iter().find(|class| class.0 == whirl);
    class.map_or(0, |class| class.1)
}

/// The table of modes as plain text.
pub(super) fn mode_lines(result: &Modes, frequency: Frequency) -> String {
    let rows = mode_rows(result, frequency);
    let heads = mode_heads(frequency);
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.chain([heads[column].chars().count()]).max().unwrap_or(0)
    };
    let widths: [usize; COLUMNS] = std::array::from_fn(width);
    let mut text = String::new();
    for row in std::iter::once(&heads).chain(&rows) {
        let cells = row.iter().zip(widths).map(|(cell, width)| format!("{cell:>width$}"));
        let _ = writeln!(text, "  {}", cells.collect::<Vec<_>>().join("  "));
    }
    for line in readings(result) {
        let _ = writeln!(text, "{line}");
    }
    text
}

const COLUMNS: usize = 6;

fn mode_heads(frequency: Frequency) -> [String; COLUMNS] {
    let unit = frequency.unit();
    [
        "mode".into(),
        format!("frequency [{unit}]"),
        "growth re [1/s]".into(),
        "damping ratio".into(),
        "whirl".into(),
        format!("inertial frame [{unit}]"),
    ]
}

fn mode_rows(result: &Modes, frequency: Frequency) -> Vec<[String; COLUMNS]> {
    let row = |(index, mode): (usize, &SeenMode)| {
        let inertial = mode.inertial(result.spin, result.is_round);
        let inertial = inertial.into_iter().map(|value| digits(frequency.of(value), 7));
        [
            (index + 1).to_string(),
            digits(frequency.of(mode.im), 7),
            digits(without_noise(mode.re, mode), 5),
            mode.damping_ratio()
                .map_or("-".into(), |ratio| digits(without_noise(ratio, mode), 4)),
            sense(mode.whirl).into(),
            inertial.collect::<Vec<_>>().join(", "),
        ]
    };
    result.modes.iter().enumerate().map(row).collect()
}

/// 0 for what the mode's growth is but round-off of its frequency.
fn without_noise(value: f64, mode: &SeenMode) -> f64 {
    if mode.re.abs() > 1e-13 * mode.im { value } else { 0.0 }
}

fn sense(whirl: Whirl) -> &'static str {
    match whirl {
        Whirl::None => "-",
        whirl => whirl.name(),
    }
}

/// In which frame, and whether it is stable, in sentences.
fn readings(result: &Modes) -> Vec<String> {
    let mut lines = Vec::new();
    if result.spin == 0.0 {
        lines.push("Nothing turns: the reference frame is the inertial frame.".into());
    } else {
        lines.push("Frequencies and whirl are those seen in the reference frame, which turns with the system.".into());
        lines.push(if result.is_round {
            "The modes whirl on circles: in the inertial frame each appears at one frequency, nu + spin forward, |nu - spin| backward, nu where nothing moves across the axis.".into()
        } else {
            "The equilibrium is not axisymmetric: in the inertial frame each mode appears at nu + spin and at |nu - spin|.".to_owned()
        });
    }
    let Some(margin) = result.margin else {
        lines.push("No motion is free: there are no modes, and nothing is said of the stability.".into());
        return lines;
    };
    let still = result.modes.iter().filter(|mode| mode.is_still()).count();
    let count = result.modes.len();
    let told = digits(margin, 5);
    lines.push(match growth(&result.modes) {
        Some(growth) => format!(
            "The equilibrium is UNSTABLE: a disturbance grows by the factor e in {} s (largest re {told} 1/s).",
            digits(1.0 / growth, 4)
        ),
        None if still == count => {
            let more = if count < result.settings.count { "" } else { "; ask for more modes" };
            format!(
                "None of the {count} modes says whether the equilibrium is stable: they are motions without stiffness (s = 0), along which what is pushed drifts on{more}."
            )
        }
        None if margin.abs() <= neutral(&result.modes) => {
            format!("No mode grows of these {count}: neutrally stable, largest re 0 to round-off.")
        }
        None => format!("No mode grows of these {count}: stability margin (largest re) {told} 1/s."),
    });
    if (1..count).contains(&still) {
        lines.push(format!(
            "{still} of the modes are motions without stiffness (s = 0), along which what is pushed drifts on."
        ));
    }
    lines
}

/// The part of the report on the modes of one equilibrium.
pub(super) fn modes_part(result: &Modes, frequency: Frequency) -> String {
    let mut part = String::from("<div class=\"scroll\"><table>\n<tr>");
    for head in mode_heads(frequency) {
        let _ = write!(part, "<th>{}</th>", escape(&head));
    }
    part += "</tr>\n";
    for row in mode_rows(result, frequency) {
        part += "<tr>";
        for cell in row {
            let _ = write!(part, "<td>{}</td>", escape(&cell));
        }
        part += "</tr>\n";
    }
    part += "</table></div>\n";
    for line in readings(result) {
        let _ = writeln!(part, "<p>{}</p>", escape(&line));
    }
    part
}

/// A value of the first column with its name and unit.
pub(super) fn key_value(key: &Column, value: f64) -> String {
    let unit = if key.unit == "1" {
        String::new()
    } else {
        format!(" {}", key.unit)
    };
    format!("{} = {}{unit}", key.name, digits(value, 7))
}

/// Critical values in sentences; `what` says of what.
pub(super) fn critical_lines(key: &Column, critical: &[Critical], what: &str) -> Vec<String> {
    let line = |critical: &Critical| {
        let count = critical.change.unsigned_abs();
        let directions = if count == 1 { "one direction" } else { "two directions" };
        let sense = if critical.change > 0 {
            "becomes negative"
        } else {
            "becomes positive again"
        };
        let directions = if count > 2 {
            format!("{count} directions")
        } else {
            directions.into()
        };
        format!(
            "{what} at {}: the stiffness of {directions} {sense}.",
            key_value(key, critical.value)
        )
    };
    critical.iter().map(line).collect()
}

/// What to read off a Campbell diagram, in sentences.
pub(super) fn campbell_lines(result: &Campbell, frequency: Frequency) -> Vec<String> {
    let mut lines = critical_lines(
        &result.key,
        &result.critical,
        "Critical speed (a frequency in the reference frame is zero)",
    );
    if lines.is_empty() {
        lines.push(if result.unknowns > Campbell::LARGEST {
            format!(
                "Critical speeds are not located with more than {} unknowns: read them off where a frequency reaches zero.",
                Campbell::LARGEST
            )
        } else {
            "No frequency in the reference frame reaches zero: no critical speed in this range.".into()
        });
    }
    for crossing in &result.crossings {
        lines.push(format!(
            "Mode {} crosses {}x the spin at {} ({}, reference frame).",
            crossing.track + 1,
            crossing.order,
            key_value(&result.key, crossing.key),
            frequency.shown(crossing.im),
        ));
    }
    let rows: Vec<Vec<SeenMode>> = (0..result.keys.len()).map(|row| result.row(row).collect()).collect();
    let unstable: Vec<f64> = rows
        .iter()
        .zip(&result.keys)
        .filter(|(row, _)| growth(row).is_some())
        .map(|(_, &key)| key)
        .collect();
    lines.push(match (unstable.first(), unstable.last()) {
        (Some(&first), Some(&last)) => format!(
            "The equilibrium is UNSTABLE at {} of {} values, first at {}, last at {}.",
            unstable.len(),
            result.keys.len(),
            key_value(&result.key, first),
            key_value(&result.key, last),
        ),
        _ if rows.iter().any(Vec::is_empty) => {
            "At some of the values there are no modes: nothing is said of the stability.".into()
        }
        _ => "No mode grows at any of the values.".into(),
    });
    lines
}

/// The part of the report with the Campbell diagram.
///
/// # Errors
/// A chart that cannot be drawn.
pub(super) fn campbell_part(result: &Campbell, frequency: Frequency) -> Result<String, String> {
    let mut part = String::new();
    let co_rotating = diagram(
        result,
        frequency,
        |mode, _| vec![mode.im],
        "frequency in the reference frame",
    );
    let caption = "Campbell diagram<span>in the reference frame, which turns with the system: 0 is the synchronous critical condition</span>";
    figure(&mut part, caption, &co_rotating, &legend(result, true))?;
    let of_inertial = |mode: SeenMode, spin: f64| mode.inertial(spin, result.is_round);
    if result.spins.iter().any(|&spin| spin > 0.0) {
        let chart = diagram(result, frequency, of_inertial, "frequency in the inertial frame");
        let rule = if result.is_round {
            "nu + spin forward, |nu - spin| backward; critical where a mode meets 1x"
        } else {
            "not axisymmetric: each mode appears at nu + spin and |nu - spin|"
        };
        if result.is_round {
            let caption = format!("Campbell diagram<span>in the inertial frame: {}</span>", escape(rule));
            figure(&mut part, &caption, &chart, &legend(result, true))?;
        } else {
            let _ = writeln!(part, "<p>The equilibria are {}.</p>", escape(rule));
        }
    }
    let margin = |row: usize| {
        let modes: Vec<SeenMode> = result.row(row).collect();
        let margin = modes.iter().map(|mode| mode.re).reduce(f64::max)?;
        // What is round-off would be drawn as if it were something.
        let shown = if margin.abs() > neutral(&modes) { margin } else { 0.0 };
        Some((result.keys[row], shown))
    };
    let points = (0..result.keys.len()).filter_map(margin);
    let margin = Chart {
        x: result.key.head(),
        y: "largest re [1/s]".into(),
        logarithmic: false,
        lines: vec![Line::new(points, 3)],
        marks: marks(&result.critical),
        dots: Vec::new(),
        is_tall: false,
    };
    figure(
        &mut part,
        "Stability margin<span>largest rate of growth; unstable above 0</span>",
        &margin,
        "",
    )?;
    for line in campbell_lines(result, frequency) {
        let _ = writeln!(part, "<p>{}</p>", escape(&line));
    }
    Ok(part)
}

/// Vertical lines at critical values.
pub(super) fn marks(critical: &[Critical]) -> Vec<(f64, String)> {
    let mark = |critical: &Critical| (critical.value, format!("critical {}", digits(critical.value, 5)));
    critical.iter().map(mark).collect()
}

/// Frequencies over the first column, coloured by whirl, with the multiples of the spin.
fn diagram(result: &Campbell, frequency: Frequency, seen: impl Fn(SeenMode, f64) -> Vec<f64>, axis: &str) -> Chart {
    let mut lines: Vec<Line> = Vec::new();
    for track in &result.tracks {
        lines.extend(coloured(result, frequency, &seen, track, axis.contains("inertial")));
    }
    let highest = lines
        .iter()
        .flat_map(|line| &line.points)
        .map(|point| point.1)
        .fold(0.0, f64::max);
    // The axis begins at zero, where the reference frame is critical.
    lines.push(Line::new([(result.keys[0], 0.0), (result.keys[0], 0.0)], 5));
    if highest > 0.0 && result.spins.iter().any(|&spin| spin > 0.0) {
        for (order, label) in [(1.0, "1x"), (2.0, "2x")] {
            let points = result.keys.iter().zip(&result.spins);
            let mut points: Vec<(f64, f64)> = points.map(|(&key, spin)| (key, frequency.of(order * spin))).collect();
            if points.first() > points.last() {
                points.reverse();
            }
            lines.push(Line::guide(points, label));
        }
    }
    Chart {
        x: result.key.head(),
        y: format!("{axis} [{}]", frequency.unit()),
        logarithmic: false,
        lines,
        marks: marks(&result.critical),
        dots: Vec::new(),
        is_tall: true,
    }
}

/// A track as lines of one sense each; a new one begins where the old one ends.
fn coloured(
    result: &Campbell,
    frequency: Frequency,
    seen: impl Fn(SeenMode, f64) -> Vec<f64>,
    track: &[Option<SeenMode>],
    is_inertial: bool,
) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut last: Option<(usize, SeenMode)> = None;
    for (row, mode) in track.iter().enumerate() {
        let Some(mode) = *mode else {
            last = None;
            continue;
        };
        let (key, spin) = (result.keys[row], result.spins[row]);
        let place = (key, frequency.of(seen(mode, spin)[0]));
        // At rest the sense is that of the next row.
        let next = track.get(row + 1).copied().flatten();
        let mut whirl = next.filter(|_| spin == 0.0).unwrap_or(mode).whirl;
        // Faster than critical, a whirl that falls back in the frame still goes forward in space.
        if is_inertial && whirl == Whirl::Backward && spin > mode.im {
            whirl = Whirl::Forward;
        }
        match (lines.last_mut(), last) {
            (Some(line), Some(_)) if line.color == color(whirl) => line.points.push(place),
            (Some(line), Some((earlier, before))) => {
                // A sense turns over where the frequency is zero.
                let [from, to] = [result.keys[earlier], key];
                let guess = from + before.im / (before.im + mode.im) * (to - from);
                let inside = result.critical.iter().map(|critical| critical.value);
                let inside = inside.filter(|value| (value - from) * (value - to) <= 0.0);
                let zero = inside.min_by(|a, b| (a - guess).abs().total_cmp(&(b - guess).abs()));
                let joint = zero.map_or(place, |zero| {
                    let share = (zero - from) / (to - from);
                    let spin = result.spins[earlier] + share * (spin - result.spins[earlier]);
                    (zero, frequency.of(seen(SeenMode { im: 0.0, ..before }, spin)[0]))
                });
                line.points.push(joint);
                let points = if zero.is_some() {
                    vec![joint, place]
                } else {
                    vec![place]
                };
                lines.push(Line::new(points, color(whirl)));
            }
            _ => lines.push(Line::new([place], color(whirl))),
        }
        last = Some((row, mode));
    }
    lines
}

/// The senses that occur, with their colours.
fn legend(result: &Campbell, has_guides: bool) -> String {
    let occurs = |whirl: Whirl| {
        let spinning = result.spins.iter().enumerate().filter(|(_, spin)| **spin > 0.0);
        let mut rows = spinning.map(|(row, _)| row);
        rows.any(|row| result.row(row).any(|mode| mode.whirl == whirl))
            || whirl == Whirl::None && result.spins.iter().all(|&spin| spin == 0.0)
    };
    let mut text = String::from("<p class=\"extremes\">");
    for (_, color, name) in CLASSES.iter().filter(|class| occurs(class.0)) {
        let _ = write!(text, "<i class=\"key k{color}\"></i>{name}&emsp;");
    }
    if has_guides && result.spins.iter().any(|&spin| spin > 0.0) {
        text += "<i class=\"key dashed\"></i>1x, 2x the spin";
    }
    text + "</p>\n"
}

/// The table of modes.csv, 17 significant digits.
pub(super) fn modes_csv(result: &Modes) -> String {
    let mut text = String::from("mode,re [1/s],im [rad/s]\n");
    for (index, mode) in result.modes.iter().enumerate() {
        let _ = writeln!(text, "{},{:.16e},{:.16e}", index + 1, mode.re, mode.im);
    }
    text
}
