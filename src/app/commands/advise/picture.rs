//! Error over processor time of the rungs, both axes logarithmic, each rung with its name. Colours are the fixed names of
//! the other charts, which the page's style sheet turns into those of a dark page.

use std::fmt::Write;

use crate::app::writing::html::escape;
use crate::app::writing::numbers::time;

/// A rung in the chart.
pub(super) struct Dot {
    /// Processor time, s.
    pub cost: f64,
    /// Relative error.
    pub error: f64,
    pub label: String,
    pub look: Look,
    /// Whether the scene warns of it.
    pub is_warned: bool,
}

/// What a rung is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Look {
    /// The simplest that suffices.
    Named,
    Suffices,
    Fails,
}

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 930.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 424.0;
const INK: &str = "#333333";
const GRID: &str = "#DDDDDD";
const BLUE: &str = "#1F5FA8";
const ORANGE: &str = "#C2510C";
const GREY: &str = "#5B5B5B";
/// Height and mean width of a letter.
const LETTER: [f64; 2] = [14.0, 6.9];
/// Differences below this are round-off; they are drawn there.
const LEAST: f64 = 1e-13;

/// A logarithmic axis from whole decade to whole decade.
struct Axis {
    first: i32,
    last: i32,
    from: f64,
    to: f64,
}

impl Axis {
    fn over(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let (low, high) = if low <= high { (low, high) } else { (0.1, 1.0) };
        let first = (low.log10() + 1e-9).floor() as i32;
        let last = ((high.log10() - 1e-9).ceil() as i32).max(first + 1);
        Self { first, last, from, to }
    }

    fn at(&self, value: f64) -> f64 {
        let share = (value.log10() - f64::from(self.first)) / f64::from(self.last - self.first);
        self.from + share * (self.to - self.from)
    }

    /// Powers of ten, and of few decades twice and five times these; whether each is named.
    fn ticks(&self) -> Vec<(f64, bool)> {
        let is_short = self.last - self.first <= 2;
        let every = 1 + (self.last - self.first) / 12;
        let mut ticks = Vec::new();
        for exponent in self.first..=self.last {
            ticks.push((10f64.powi(exponent), (exponent - self.first) % every == 0));
            if is_short && exponent < self.last {
                ticks.extend([2.0, 5.0].map(|factor| (factor * 10f64.powi(exponent), true)));
            }
        }
        ticks
    }
}

/// The chart as an `svg` element.
pub(super) fn svg(dots: &[Dot], wanted: f64) -> String {
    let error = |dot: &Dot| dot.error.max(LEAST);
    let x = Axis::over(dots.iter().map(|dot| dot.cost), LEFT, RIGHT);
    let y = Axis::over(dots.iter().map(error).chain([wanted]), BOTTOM, TOP);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"13\">\n"
    );
    axes(&mut svg, &x, &y);
    let height = y.at(wanted);
    let _ = writeln!(
        svg,
        "<path d=\"M{LEFT} {height:.1}H{RIGHT}\" stroke=\"{ORANGE}\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"/>"
    );
    let mut taken: Vec<[f64; 4]> = Vec::new();
    let places: Vec<(f64, f64)> = dots.iter().map(|dot| (x.at(dot.cost), y.at(error(dot)))).collect();
    taken.extend(places.iter().map(|(x, y)| [x - 6.0, y - 6.0, x + 6.0, y + 6.0]));
    for (dot, &(x, y)) in dots.iter().zip(&places) {
        let (color, radius) = match dot.look {
            Look::Named => (ORANGE, 7.0),
            Look::Suffices => (BLUE, 5.0),
            Look::Fails => (GREY, 5.0),
        };
        let fill = if dot.is_warned { "none" } else { color };
        let _ = writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"2\"><title>{}: {}</title></circle>",
            escape(&dot.label),
            time(dot.cost)
        );
        label(&mut svg, &dot.label, (x, y), color, &mut taken);
    }
    svg + "</svg>"
}

fn axes(svg: &mut String, x: &Axis, y: &Axis) {
    for (value, is_named) in x.ticks() {
        let place = x.at(value);
        let _ = writeln!(svg, "<path d=\"M{place:.1} {TOP}V{BOTTOM}\" stroke=\"{GRID}\"/>");
        if is_named {
            text(svg, (place, BOTTOM + 20.0), "middle", INK, &time(value));
        }
    }
    for (value, is_named) in y.ticks() {
        let place = y.at(value);
        let _ = writeln!(svg, "<path d=\"M{LEFT} {place:.1}H{RIGHT}\" stroke=\"{GRID}\"/>");
        if is_named {
            text(svg, (LEFT - 8.0, place + 4.0), "end", INK, &format!("{value:e}"));
        }
    }
    let _ = writeln!(
        svg,
        "<path d=\"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}\" fill=\"none\" stroke=\"{INK}\" stroke-width=\"1.5\"/>"
    );
    text(
        svg,
        (0.5 * (LEFT + RIGHT), HEIGHT - 14.0),
        "middle",
        INK,
        "processor time",
    );
    let middle = 0.5 * (TOP + BOTTOM);
    let _ = writeln!(
        svg,
        "<text transform=\"translate(20 {middle}) rotate(-90)\" text-anchor=\"middle\" fill=\"{INK}\">relative error</text>"
    );
}

/// Writes a name beside its point, where no other name or point is, as far as there is such a place.
fn label(svg: &mut String, name: &str, (x, y): (f64, f64), color: &str, taken: &mut Vec<[f64; 4]>) {
    let width = LETTER[1] * name.chars().count() as f64;
    let place = |(dx, dy): (f64, f64)| {
        let left = if dx < 0.0 { x + dx - width } else { x + dx };
        [left, y + dy - 0.75 * LETTER[0], left + width, y + dy + 0.25 * LETTER[0]]
    };
    let is_inside = |b: &[f64; 4]| b[0] > LEFT && b[2] < WIDTH && b[1] > 0.0 && b[3] < BOTTOM;
    let is_free = |b: &[f64; 4]| {
        let misses = |o: &[f64; 4]| b[2] < o[0] || o[2] < b[0] || b[3] < o[1] || o[3] < b[1];
        is_inside(b) && taken.iter().all(misses)
    };
    let heights =
        (0..12).map(|step| 0.6 * LETTER[0] * f64::from((step + 1) / 2) * if step % 2 == 0 { 1.0 } else { -1.0 });
    let all = heights.flat_map(|dy| [(11.0, dy + 4.0), (-11.0, dy + 4.0)]);
    let mut places = all.map(place);
    let found = places.clone().find(is_free).or_else(|| places.find(is_inside));
    let Some(found) = found else { return };
    taken.push(found);
    let _ = writeln!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" fill=\"{color}\">{}</text>",
        found[0],
        found[3] - 0.25 * LETTER[0],
        escape(name)
    );
}

fn text(svg: &mut String, (x, y): (f64, f64), anchor: &str, color: &str, inside: &str) {
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{color}\">{}</text>",
        escape(inside)
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_one_place_have_names_on_different_ones() {
        let dot = |label: &str, look| Dot {
            cost: 2e-3,
            error: 1e-5,
            label: label.into(),
            look,
            is_warned: false,
        };
        let svg = svg(&[dot("rigid", Look::Named), dot("<point>", Look::Suffices)], 1e-3);
        let place = |name: &str| {
            let line = svg
                .lines()
                .find(|line| line.ends_with(&format!(">{name}</text>")))
                .unwrap();
            line.split('"').take(4).map(String::from).collect::<Vec<_>>()
        };
        assert_ne!(place("rigid"), place("&lt;point&gt;"));
        assert!(svg.contains("relative error") && svg.contains("1e-3") && svg.contains("2 ms"));
    }

    #[test]
    fn errors_of_zero_and_no_rungs_are_drawn() {
        let dot = Dot {
            cost: 1.0,
            error: 0.0,
            label: "full".into(),
            look: Look::Suffices,
            is_warned: true,
        };
        assert!(!svg(&[dot], 1e-3).contains("NaN"));
        assert!(!svg(&[], 1e-3).contains("NaN"));
    }
}
