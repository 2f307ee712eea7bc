//! Parts of the report on modes: their table, Campbell diagrams, and what to read off, also as plain text.

use std::fmt::Write;

use super::charts::{Chart, Line, figure};
use super::critical::{EXACT, critical_lines, marks};
use crate::app::pictures::view;
use crate::app::results::campbell::{Campbell, Onset};
use crate::app::results::modes::{Inertial, Modes, SeenMode, growth, neutral};
use crate::app::writing::csv::cell;
use crate::app::writing::frequency::Frequency;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;
use crate::modes::{Composition, Motion, Whirl};

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
pub(in crate::app) fn mode_lines(result: &Modes, frequency: Frequency) -> String {
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

const COLUMNS: usize = 8;

fn mode_heads(frequency: Frequency) -> [String; COLUMNS] {
    let unit = frequency.unit();
    [
        "mode".into(),
        format!("frequency [{unit}]"),
        "damping ratio".into(),
        "log. decrement".into(),
        "whirl".into(),
        format!("in the reference frame [{unit}]"),
        "growth re [1/s]".into(),
        "what moves".into(),
    ]
}

fn mode_rows(result: &Modes, frequency: Frequency) -> Vec<[String; COLUMNS]> {
    let row = |(index, mode): (usize, &SeenMode)| {
        let spin = result.spin;
        let joined = |values: Vec<Option<f64>>, places| {
            let told = |value: Option<f64>| value.map_or("-".into(), |value| digits(value, places));
            values.into_iter().map(told).collect::<Vec<String>>().join(", ")
        };
        let clean = |values: Vec<Option<f64>>| -> Vec<Option<f64>> {
            values
                .into_iter()
                .map(|value| value.map(|value| without_noise(value, mode)))
                .collect()
        };
        let seen = mode.inertial_frequencies(spin).into_iter();
        let sense = mode.inertial_whirl(spin);
        let at_rest = mode
            .damping_ratio()
            .map_or("-".into(), |ratio| digits(without_noise(ratio, mode), 4));
        [
            (index + 1).to_string(),
            joined(seen.map(|value| Some(frequency.of(value))).collect(), 7),
            joined(clean(mode.inertial_damping_ratios(spin)), 4),
            joined(clean(mode.logarithmic_decrements(spin)), 4),
            self::sense(sense).into(),
            format!("{} (damping ratio {at_rest})", digits(frequency.of(mode.im), 7)),
            digits(without_noise(mode.re, mode), 5),
            what_moves(&result.compositions[index]),
        ]
    };
    result.modes.iter().enumerate().map(row).collect()
}

/// Parts of the kinetic energy in whole per cents, by kinds of motion and, where there are several, by bodies.
fn what_moves(composition: &Composition) -> String {
    if composition.motions.is_empty() {
        return "-".into();
    }
    let told = |(name, part): (&str, f64)| {
        let percent = (100.0 * part).round();
        (percent >= 1.0).then(|| format!("{name} {percent} %"))
    };
    let motions = composition.motions.iter().map(|&(motion, part)| (motion.name(), part));
    let motions: Vec<String> = motions.filter_map(told).collect();
    if composition.bodies.len() < 2 {
        return motions.join(", ");
    }
    let mut bodies: Vec<(&str, f64)> = composition
        .bodies
        .iter()
        .map(|(name, part)| (name.as_str(), *part))
        .collect();
    bodies.sort_by(|a, b| b.1.total_cmp(&a.1));
    let bodies: Vec<String> = bodies.into_iter().filter_map(told).take(MOST_BODIES).collect();
    format!("{}; {}", motions.join(", "), bodies.join(", "))
}

/// Bodies that are named beside a mode.
const MOST_BODIES: usize = 4;

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
        lines.push("Frequency, damping ratio, logarithmic decrement and whirl are those seen in the inertial frame; nu is the frequency in the reference frame, which turns with the system.".into());
        lines.push(if result.modes.iter().all(|mode| mode.circulation.is_none()) {
            "Nothing is felt across the axis: each mode appears at nu.".into()
        } else if !result.modes.iter().any(SeenMode::is_across) {
            "What moves across the axis does not oscillate: it turns with the spin.".into()
        } else if result.is_round {
            "The modes whirl on circles: each appears at one frequency, |spin + nu| or |spin - nu|, or nu where nothing is felt across the axis.".into()
        } else {
            "The equilibrium is not axisymmetric: a mode that moves across the axis, and not on circles, appears at spin + nu and at |spin - nu|.".to_owned()
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
        None if margin > 0.0 => format!(
            "No mode grows of these {count} by more than round-off makes of two equal frequencies: largest re {told} 1/s."
        ),
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
pub(in crate::app) fn modes_part(title: &str, result: &Modes, frequency: Frequency) -> String {
    let mut part = modes_picture(title, result, frequency).unwrap_or_default();
    part += "<div class=\"scroll\"><table>\n<tr>";
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

/// The modes as they move, where there are some.
fn modes_picture(title: &str, result: &Modes, frequency: Frequency) -> Option<String> {
    let shapes = result.pictures.as_ref().filter(|_| !result.modes.is_empty())?;
    let heads = mode_heads(frequency);
    let told: Vec<(String, Vec<[String; 2]>)> = mode_rows(result, frequency)
        .into_iter()
        .map(|row| {
            let name = format!("{}: {} {}", row[0], row[1], frequency.unit());
            let facts = heads
                .iter()
                .zip(row)
                .skip(1)
                .filter(|(_, cell)| !cell.is_empty() && cell != "-");
            (name, facts.map(|(head, cell)| [head.clone(), cell]).collect())
        })
        .collect();
    let scene = view::part(&view::of_modes(title, shapes, &told));
    Some(format!(
        "<style>\n{}</style>\n<figure>\n{scene}</figure>\n",
        view::STYLE
    ))
}

/// What a critical value is, without damping that counts and with it.
const CRITICAL: &str = "Critical speed (a frequency in the reference frame is zero)";
const UNDAMPED: &str = "Undamped critical speed (the stiffness in the reference frame is zero)";
/// The same where nothing turns.
const FREE: &str = "Critical value (a frequency is zero)";
const UNSTIFF: &str = "Critical value (the stiffness is zero)";

/// What to read off a Campbell diagram, in sentences.
pub(in crate::app) fn campbell_lines(result: &Campbell, frequency: Frequency) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (critical, &is_standing) in result.critical.iter().zip(&result.standing) {
        let what = match (result.is_turning(), is_standing) {
            (true, true) => CRITICAL,
            (true, false) => UNDAMPED,
            (false, true) => FREE,
            (false, false) => UNSTIFF,
        };
        lines.extend(critical_lines(&result.key, std::slice::from_ref(critical), what));
    }
    if result.is_turning() && result.standing.contains(&false) {
        lines.push("With damping no frequency in the reference frame is zero at an undamped critical speed: an unbalance excites most where lightly damped forward modes cross 1x the spin.".into());
    }
    if lines.is_empty() {
        lines.push(match result.is_near {
            _ if !result.is_turning() && result.is_excited() => {
                format!("Nothing turns: `{}` counts as the speed of a rotor, with which frequencies are compared.", result.key.name)
            }
            _ if !result.is_turning() => "Nothing turns: there are no critical speeds.".into(),
            true => "No frequency in the reference frame reaches zero: no critical speed in this range.".into(),
            false => "No frequency in the reference frame reaches zero on this way, which ends far from the undeformed shape: of critical speeds about the other equilibrium it says nothing.".into(),
        });
    }
    for crossing in &result.crossings {
        let excitation = match result.is_turning() {
            true => "the spin".to_string(),
            false => format!("`{}`", result.key.name),
        };
        let (frame, sense) = match crossing.whirl {
            Whirl::Mixed => ("reference frame", String::new()),
            Whirl::None => ("inertial frame", String::new()),
            whirl => ("inertial frame", format!(" ({})", whirl.name())),
        };
        let mut line = format!(
            "Mode {}{sense} crosses {}x {excitation} at {} ({}, {frame})",
            crossing.track + 1,
            crossing.order,
            result.key.at(crossing.key, 7),
            frequency.shown(crossing.im),
        );
        if crossing.within > EXACT * crossing.key.abs() {
            let _ = write!(line, ", there within {}", result.key.quantity(crossing.within, 2));
        }
        lines.push(line + ".");
    }
    for onset in &result.onsets {
        let mut line = format!(
            "{} at {} ({} in the reference frame)",
            if onset.begins {
                "A mode begins to grow".to_string()
            } else {
                format!("{} any more", none_grows(result))
            },
            result.key.at(onset.key, 7),
            frequency.shown(onset.im),
        );
        if onset.within > EXACT * onset.key.abs() {
            let _ = write!(line, ", there within {}", result.key.quantity(onset.within, 2));
        }
        lines.push(line + ".");
    }
    let known = result.compositions.iter().enumerate();
    for (index, composition) in known.filter(|(_, composition)| !composition.motions.is_empty()) {
        lines.push(format!("Mode {} is {}.", index + 1, what_moves(composition)));
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
            result.key.at(first, 7),
            result.key.at(last, 7),
        ),
        _ if rows.iter().any(Vec::is_empty) => {
            "At some of the values there are no modes: nothing is said of the stability.".into()
        }
        _ if rows.iter().any(|row| row.iter().any(|mode| mode.re > neutral(row))) => {
            format!(
                "{} at any of the values by more than round-off makes of two equal frequencies.",
                none_grows(result)
            )
        }
        _ => format!("{} at any of the values.", none_grows(result)),
    });
    lines
}

/// That no mode grows of those that were looked at.
fn none_grows(result: &Campbell) -> String {
    match result.is_all {
        true => "No mode grows".into(),
        false => format!("None of the {} lowest modes grows", result.settings.count),
    }
}

/// The part of the report with the Campbell diagram.
///
/// # Errors
/// A chart that cannot be drawn.
pub(in crate::app) fn campbell_part(result: &Campbell, frequency: Frequency) -> Result<String, String> {
    let mut part = String::new();
    let is_turning = result.is_turning();
    if is_turning && result.is_round {
        let of_inertial = |mode: SeenMode, spin: f64| mode.inertial_frequencies(spin);
        let chart = diagram(result, frequency, of_inertial, "frequency in the inertial frame");
        let caption = "Campbell diagram<span>in the inertial frame: |spin + nu| or |spin - nu|; critical where a forward mode meets 1x</span>";
        figure(&mut part, caption, &chart, &legend(result, true))?;
    }
    let co_rotating = diagram(
        result,
        frequency,
        |mode, _| vec![mode.im],
        "frequency in the reference frame",
    );
    let caption = match is_turning {
        true => {
            "Campbell diagram<span>in the reference frame, which turns with the system: 0 is the synchronous critical condition</span>"
        }
        false => "Frequencies<span>nothing turns</span>",
    };
    figure(&mut part, caption, &co_rotating, &legend(result, true))?;
    let is_across = (0..result.keys.len()).any(|row| result.row(row).any(|mode| mode.is_across()));
    if is_turning && is_across && !result.is_round {
        part += "<p>The equilibria are not axisymmetric: a mode that moves across the axis, and not on circles, appears in the inertial frame at spin + nu and |spin - nu|.</p>\n";
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
        lines: vec![Line::new(points, 3)],
        marks: marked(result),
        ..Chart::default()
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

/// Frequencies over the first column, coloured by whirl, with the multiples of the spin.
fn diagram(result: &Campbell, frequency: Frequency, seen: impl Fn(SeenMode, f64) -> Vec<f64>, axis: &str) -> Chart {
    let mut lines: Vec<Line> = Vec::new();
    for (index, track) in result.tracks.iter().enumerate() {
        let pieces = coloured(result, frequency, &seen, track);
        lines.extend(
            pieces
                .into_iter()
                .map(|piece| piece.named(format!("mode {}", index + 1))),
        );
    }
    let highest = lines
        .iter()
        .flat_map(|line| &line.points)
        .map(|point| point.1)
        .fold(0.0, f64::max);
    // The axis begins at zero, where the reference frame is critical.
    lines.push(Line::new([(result.keys[0], 0.0), (result.keys[0], 0.0)], 5));
    if highest > 0.0 && result.is_excited() {
        for (order, label) in [(1.0, "1x"), (2.0, "2x")] {
            let points = result.keys.iter().zip(&result.excitations);
            let mut points: Vec<(f64, f64)> = points.map(|(&key, speed)| (key, frequency.of(order * speed))).collect();
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
        marks: marked(result),
        is_tall: true,
    }
}

/// Vertical lines at critical values, and where modes begin or cease to grow.
fn marked(result: &Campbell) -> Vec<(f64, String)> {
    let onset = |onset: &Onset| {
        let what = if onset.begins { "grows from" } else { "grows up to" };
        (onset.key, format!("{what} {}", digits(onset.key, 5)))
    };
    marks(&result.critical)
        .into_iter()
        .chain(result.onsets.iter().map(onset))
        .collect()
}

/// A track as lines of one sense each, in the inertial frame; a new one begins where the old one ends.
fn coloured(
    result: &Campbell,
    frequency: Frequency,
    seen: impl Fn(SeenMode, f64) -> Vec<f64>,
    track: &[Option<SeenMode>],
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
        let next = track.get(row + 1).copied().flatten().filter(|_| spin == 0.0);
        let whirl = next.map_or_else(
            || mode.inertial_whirl(spin),
            |next| next.inertial_whirl(result.spins[row + 1]),
        );
        match (lines.last_mut(), last) {
            (Some(line), Some((earlier, before))) => {
                line.points.extend(
                    zero(result, [(earlier, before), (row, mode)])
                        .map(|(key, spin)| (key, frequency.of(seen(SeenMode { im: 0.0, ..before }, spin)[0]))),
                );
                line.points.push(place);
                if line.color != color(whirl) {
                    lines.push(Line::new([place], color(whirl)));
                }
            }
            _ => lines.push(Line::new([place], color(whirl))),
        }
        last = Some((row, mode));
    }
    lines
}

/// Where the frequency in the reference frame is zero between two rows, and the spin there: its sense in that frame turns over at a critical value.
fn zero(result: &Campbell, [(earlier, before), (row, mode)]: [(usize, SeenMode); 2]) -> Option<(f64, f64)> {
    if before.whirl == mode.whirl {
        return None;
    }
    let [from, to] = [earlier, row].map(|row| result.keys[row]);
    let guess = from + before.im / (before.im + mode.im) * (to - from);
    let inside = result.critical.iter().map(|critical| critical.value);
    let inside = inside.filter(|value| (value - from) * (value - to) <= 0.0);
    let value = inside.min_by(|a, b| (a - guess).abs().total_cmp(&(b - guess).abs()))?;
    let [slow, fast] = [earlier, row].map(|row| result.spins[row]);
    Some((value, slow + (value - from) / (to - from) * (fast - slow)))
}

/// The senses that occur, with their colours.
fn legend(result: &Campbell, has_guides: bool) -> String {
    let occurs = |whirl: Whirl| {
        let mut spinning = result.spins.iter().enumerate().filter(|(_, spin)| **spin > 0.0);
        spinning.any(|(row, &spin)| result.row(row).any(|mode| mode.inertial_whirl(spin) == whirl))
            || whirl == Whirl::None && !result.is_turning()
    };
    let mut text = String::from("<p class=\"extremes\">");
    for (_, color, name) in CLASSES.iter().filter(|class| occurs(class.0)) {
        let _ = write!(text, "<i class=\"key k{color}\"></i>{name}&emsp;");
    }
    if has_guides && result.is_excited() {
        let of = if result.is_turning() {
            "the spin"
        } else {
            &result.key.name
        };
        let _ = write!(text, "<i class=\"key dashed\"></i>1x, 2x {}", escape(of));
    }
    text + "</p>\n"
}

/// The table of modes.csv, 17 significant digits; what is not defined is empty.
pub(in crate::app) fn modes_csv(result: &Modes) -> String {
    let mut text = String::from("mode,re [1/s],im [rad/s],damping ratio");
    for which in ["", "second "] {
        let _ = write!(
            text,
            ",{which}inertial [rad/s],{which}damping ratio,{which}log. decrement"
        );
    }
    for motion in Motion::ALL {
        let _ = write!(text, ",{}", motion.name());
    }
    text.push('\n');
    for (index, mode) in result.modes.iter().enumerate() {
        let _ = write!(
            text,
            "{},{},{},{}",
            index + 1,
            cell(mode.re),
            cell(mode.im),
            cell(mode.damping_ratio())
        );
        let mut seen = mode.inertial_frequencies(result.spin);
        // The sign tells the sense.
        if let Inertial::Whirl(velocity) = mode.inertial(result.spin) {
            seen = vec![velocity];
        }
        let ratios = mode.inertial_damping_ratios(result.spin);
        let decrements = mode.logarithmic_decrements(result.spin);
        for which in 0..2 {
            let ratio = ratios.get(which).copied().flatten();
            let decrement = decrements.get(which).copied().flatten();
            let _ = write!(
                text,
                ",{},{},{}",
                cell(seen.get(which).copied()),
                cell(ratio),
                cell(decrement)
            );
        }
        for motion in Motion::ALL {
            let parts = &result.compositions[index].motions;
            let part = parts.iter().find(|other| other.0 == motion).map(|other| other.1);
            let _ = write!(text, ",{}", cell(part));
        }
        text.push('\n');
    }
    text
}
