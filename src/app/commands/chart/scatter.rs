//! Error over cost, both axes logarithmic: series of points with markers, the front, and one legend for all panels. Colours
//! are the fixed names of the other charts, which the page's style sheet turns into those of a dark page.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::app::page::charts::{GRID, INK, LINES, hex};
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;

/// Panels one below the other beside their legend.
pub(super) struct Scatter {
    /// What it shows, for the heading and for those who do not see it.
    pub title: String,
    pub panels: Vec<Panel>,
    pub legend: Vec<Entry>,
}

/// One pair of axes.
pub(super) struct Panel {
    pub x: Axis,
    /// Name of the vertical axis.
    pub y: String,
    pub series: Vec<Series>,
    /// Points on the front, the cheapest first.
    pub front: Vec<(f64, f64)>,
    /// Below this error the reference is not exact enough.
    pub floor: Option<f64>,
}

/// What is on the horizontal axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Axis {
    /// Processor time, s.
    Time,
    /// A number of something.
    Count(&'static str),
}

/// Points that belong together, joined by a line.
pub(super) struct Series {
    pub name: String,
    pub look: Look,
    pub dots: Vec<Dot>,
}

/// How a series looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Look {
    /// Index of the colour.
    pub color: usize,
    pub marker: Marker,
    /// From 0, nearly white, to 1, full colour.
    pub shade: f64,
}

/// Markers; each has its own kind of line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marker {
    Circle,
    Triangle,
    Diamond,
    Square,
}

/// A point.
pub(super) struct Dot {
    pub x: f64,
    pub y: f64,
    /// Not known well enough to compete.
    pub is_hollow: bool,
    /// What it is, told where the pointer rests on it.
    pub name: String,
}

impl Dot {
    /// What it is, and whether it competes.
    fn told(&self) -> String {
        match self.is_hollow {
            true => format!("{}, below the uncertainty of the reference", self.name),
            false => self.name.clone(),
        }
    }
}

/// A line of the legend.
pub(super) enum Entry {
    Heading(&'static str),
    Look(Look, String),
    /// A hollow marker.
    Hollow(String),
    /// The line of the front.
    Front(String),
    /// More of the entry above.
    Text(String),
}

const WIDTH: f64 = 960.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 716.0;
const HEAD: f64 = 44.0;
const PLOT: f64 = 420.0;
const FOOT: f64 = 62.0;
const LINE: f64 = 22.0;
const FRONT: &str = "#BBBBBB";
const FLOOR: &str = "3 x uncertainty of the reference";
/// Larger errors say only that a run has nothing to do with the reference; they are not drawn.
pub(super) const LARGEST: f64 = 10.0;

impl Scatter {
    /// The picture as an `svg` element; `alone`: with a white ground and a heading, for documents.
    pub fn to_svg(&self, alone: bool) -> String {
        let height = HEAD + self.panels.len() as f64 * (PLOT + FOOT);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n<title>{}</title>\n",
            escape(&self.title)
        );
        if alone {
            let _ = writeln!(svg, "<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#FFFFFF\"/>");
            text(&mut svg, (LEFT, 26.0), "start", &self.title);
        }
        for (index, panel) in self.panels.iter().enumerate() {
            panel.draw(&mut svg, HEAD + index as f64 * (PLOT + FOOT));
        }
        self.draw_legend(&mut svg);
        svg + "</svg>\n"
    }

    fn draw_legend(&self, svg: &mut String) {
        let (x, mut y) = (RIGHT + 24.0, HEAD + 8.0);
        for entry in &self.legend {
            let place = (x + 42.0, y + 5.0);
            match entry {
                Entry::Heading(name) => {
                    y += 6.0;
                    let _ = writeln!(
                        svg,
                        "<text x=\"{x:.1}\" y=\"{:.1}\" font-weight=\"bold\" fill=\"{}\">{}</text>",
                        y + 5.0,
                        hex(INK),
                        escape(name)
                    );
                }
                Entry::Look(look, name) => {
                    look.line(svg, &[(x, y), (x + 32.0, y)]);
                    look.mark(svg, (x + 16.0, y), false, "");
                    text(svg, place, "start", name);
                }
                Entry::Hollow(name) => {
                    let look = Look {
                        color: 5,
                        marker: Marker::Circle,
                        shade: 1.0,
                    };
                    look.mark(svg, (x + 16.0, y), true, "");
                    text(svg, place, "start", name);
                }
                Entry::Text(name) => text(svg, place, "start", name),
                Entry::Front(name) => {
                    polyline(svg, &[(x, y), (x + 32.0, y)], FRONT, 5.0, "", 1.0);
                    ring(svg, (x + 16.0, y));
                    text(svg, place, "start", name);
                }
            }
            y += LINE;
        }
    }
}

impl Panel {
    /// The same as data, for the script of the page.
    pub fn to_json(&self) -> Value {
        let line = |series: &Series| {
            let dots: Vec<&Dot> = series.dots.iter().filter(|dot| is_drawn(dot)).collect();
            json!({
                "name": series.name,
                "color": series.look.color,
                "shade": series.look.shade,
                "dashed": series.look.marker != Marker::Circle,
                "dots": series.look.marker.name(),
                "joined": true,
                "p": dots.iter().flat_map(|dot| [dot.x, dot.y]).collect::<Value>(),
                "hollow": dots.iter().map(|dot| dot.is_hollow).collect::<Value>(),
                "told": dots.iter().map(|dot| dot.told()).collect::<Value>(),
            })
        };
        let guide = |points: Vec<(f64, f64)>, name: &str| {
            let points = points.into_iter().flat_map(|(x, y)| [x, y]);
            json!({ "name": "", "guide": name, "p": points.collect::<Value>() })
        };
        // Guides leave the chart at its edges: the script cuts them there.
        let far = 1e9;
        let mut lines: Vec<Value> = self.series.iter().map(line).collect();
        if let (Some(&first), Some(&last)) = (self.front.first(), self.front.last()) {
            let stairs = self.front.windows(2).flat_map(|pair| [pair[0], (pair[1].0, pair[0].1)]);
            let ends = [last, (far, last.1)];
            lines.push(guide(
                [(first.0, far)].into_iter().chain(stairs).chain(ends).collect(),
                "Pareto front",
            ));
        }
        if let Some(floor) = self.floor {
            lines.push(guide(vec![(1.0 / far, floor), (far, floor)], FLOOR));
        }
        json!({
            "x": self.x.head(),
            "y": format!("{} [1]", self.y),
            "of": "error",
            "logx": true,
            "log": true,
            "tall": true,
            "lines": lines,
            "marks": [],
        })
    }

    fn draw(&self, svg: &mut String, top: f64) {
        let seen: Vec<&Dot> = self
            .series
            .iter()
            .flat_map(|series| &series.dots)
            .filter(|dot| is_drawn(dot))
            .collect();
        let x = Scale::over(seen.iter().map(|dot| dot.x), LEFT, RIGHT, 0.06);
        let floor = self.floor.filter(|floor| seen.iter().any(|dot| dot.y < 3.0 * floor));
        let heights = seen.iter().map(|dot| dot.y).chain(floor);
        let y = Scale::over(heights, top + PLOT, top, 0.12);
        self.draw_axes(svg, (&x, &y), top);
        let at = |(cost, error): (f64, f64)| (x.at(cost), y.at(error));
        if let Some(floor) = floor {
            let height = y.at(floor);
            polyline(svg, &[(LEFT, height), (RIGHT, height)], &hex(INK), 1.0, "2 4", 1.0);
            text(svg, (LEFT + 6.0, height + 16.0), "start", FLOOR);
        }
        if let (Some(&first), Some(&last)) = (self.front.first(), self.front.last()) {
            let mut stairs = vec![(x.at(first.0), top)];
            for (index, &point) in self.front.iter().enumerate() {
                if index > 0 {
                    stairs.push(at((point.0, self.front[index - 1].1)));
                }
                stairs.push(at(point));
            }
            stairs.push((RIGHT, y.at(last.1)));
            polyline(svg, &stairs, FRONT, 5.0, "", 1.0);
        }
        for series in &self.series {
            let dots: Vec<&Dot> = series.dots.iter().filter(|dot| is_drawn(dot)).collect();
            let _ = writeln!(svg, "<g><title>{}</title>", escape(&series.name));
            let line: Vec<(f64, f64)> = dots.iter().map(|dot| at((dot.x, dot.y))).collect();
            series.look.line(svg, &line);
            for (dot, &place) in dots.iter().zip(&line) {
                series.look.mark(svg, place, dot.is_hollow, &dot.name);
            }
            *svg += "</g>\n";
        }
        for &point in &self.front {
            ring(svg, at(point));
        }
    }

    fn draw_axes(&self, svg: &mut String, (x, y): (&Scale, &Scale), top: f64) {
        let (bottom, grid) = (top + PLOT, hex(GRID));
        for (value, is_named) in x.ticks() {
            let place = x.at(value);
            polyline(
                svg,
                &[(place, top), (place, bottom)],
                &grid,
                if is_named { 1.0 } else { 0.5 },
                "",
                1.0,
            );
            if is_named {
                text(svg, (place, bottom + 20.0), "middle", &self.x.tick(value));
            }
        }
        for (value, is_named) in y.ticks() {
            let place = y.at(value);
            polyline(
                svg,
                &[(LEFT, place), (RIGHT, place)],
                &grid,
                if is_named { 1.0 } else { 0.5 },
                "",
                1.0,
            );
            if is_named {
                text(svg, (LEFT - 8.0, place + 5.0), "end", &power(value));
            }
        }
        let frame = [(LEFT, top), (LEFT, bottom), (RIGHT, bottom)];
        polyline(svg, &frame, &hex(INK), 1.0, "", 1.0);
        text(svg, (0.5 * (LEFT + RIGHT), bottom + 44.0), "middle", self.x.name());
        let middle = top + 0.5 * PLOT;
        let _ = writeln!(
            svg,
            "<text transform=\"translate(18 {middle:.1}) rotate(-90)\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
            hex(INK),
            escape(&self.y)
        );
    }
}

/// Whether a point has a place on logarithmic axes.
fn is_drawn(dot: &Dot) -> bool {
    dot.x > 0.0 && dot.x.is_finite() && dot.y > 0.0 && dot.y <= LARGEST
}

impl Axis {
    fn name(self) -> &'static str {
        match self {
            Axis::Time => "processor time",
            Axis::Count(name) => name,
        }
    }

    /// Name and unit.
    fn head(self) -> String {
        let unit = if self == Axis::Time { "s" } else { "1" };
        format!("{} [{unit}]", self.name())
    }

    fn tick(self, value: f64) -> String {
        let exponent = value.log10().floor();
        match self {
            Axis::Count(_) if value < 99_999.0 => digits(value, 3),
            Axis::Count(_) => power(value),
            Axis::Time if exponent < -3.0 => format!("{} \u{b5}s", digits(1e6 * value, 3)),
            Axis::Time if exponent < 0.0 => format!("{} ms", digits(1e3 * value, 3)),
            Axis::Time => format!("{} s", digits(value, 3)),
        }
    }
}

/// `1e-3`, as tolerances are typed.
fn power(value: f64) -> String {
    let exponent = (value.log10() + 1e-9).floor();
    let digit = digits(value / 10f64.powf(exponent), 3);
    format!("{digit}e{exponent}")
}

/// A logarithmic scale on the page.
struct Scale {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Scale {
    /// Over positive values, with a share of the length left free at both ends; at least a factor of ten is shown.
    fn over(values: impl Iterator<Item = f64>, from: f64, to: f64, share: f64) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value.log10()), high.max(value.log10()))
        });
        let (low, high) = if low <= high { (low, high) } else { (-1.0, 0.0) };
        let pad = (share * (high - low)).max(0.5 * (1.0 - (high - low)));
        Self {
            low: low - pad,
            high: high + pad,
            from,
            to,
        }
    }

    fn at(&self, value: f64) -> f64 {
        self.from + (value.log10() - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Powers of ten; over few of them also twice and five times these. Whether each is named: of many every second or
    /// third.
    fn ticks(&self) -> Vec<(f64, bool)> {
        let (first, last) = (self.low.floor() as i32, self.high.ceil() as i32);
        let is_short = self.high - self.low < 2.2;
        let every = 1 + (last - first) / 12;
        let mut ticks = Vec::new();
        for exponent in first..=last {
            for factor in [1.0, 2.0, 5.0] {
                let value: f64 = format!("{factor}e{exponent}").parse().unwrap_or(1.0);
                let is_power = factor == 1.0;
                if (is_power || is_short) && (self.low..=self.high).contains(&value.log10()) {
                    ticks.push((value, is_short || exponent.rem_euclid(every) == 0));
                }
            }
        }
        ticks
    }
}

impl Marker {
    fn name(self) -> &'static str {
        match self {
            Marker::Circle => "circle",
            Marker::Triangle => "triangle",
            Marker::Diamond => "diamond",
            Marker::Square => "square",
        }
    }
}

impl Look {
    fn line(self, svg: &mut String, points: &[(f64, f64)]) {
        let dashes = match self.marker {
            Marker::Circle => "",
            Marker::Triangle => "7 5",
            Marker::Diamond | Marker::Square => "2 4",
        };
        polyline(
            svg,
            points,
            &hex(LINES[self.color % LINES.len()]),
            1.8,
            dashes,
            self.shade,
        );
    }

    fn mark(self, svg: &mut String, (x, y): (f64, f64), is_hollow: bool, name: &str) {
        let color = hex(LINES[self.color % LINES.len()]);
        let fill = if is_hollow { "none" } else { color.as_str() };
        let style = format!(
            "fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.5\" opacity=\"{}\"",
            self.shade
        );
        let corners = |corners: &[(f64, f64)]| {
            let places = corners.iter().map(|(dx, dy)| format!("{:.1},{:.1}", x + dx, y + dy));
            places.collect::<Vec<_>>().join(" ")
        };
        let title = if name.is_empty() {
            String::new()
        } else {
            format!("<title>{}</title>", escape(name))
        };
        let _ = match self.marker {
            Marker::Circle => writeln!(
                svg,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.2\" {style}>{title}</circle>"
            ),
            Marker::Triangle => {
                let places = corners(&[(0.0, -5.6), (5.2, 3.8), (-5.2, 3.8)]);
                writeln!(svg, "<polygon points=\"{places}\" {style}>{title}</polygon>")
            }
            Marker::Diamond => {
                let places = corners(&[(0.0, -5.8), (5.8, 0.0), (0.0, 5.8), (-5.8, 0.0)]);
                writeln!(svg, "<polygon points=\"{places}\" {style}>{title}</polygon>")
            }
            Marker::Square => {
                let places = corners(&[(-4.2, -4.2), (4.2, -4.2), (4.2, 4.2), (-4.2, 4.2)]);
                writeln!(svg, "<polygon points=\"{places}\" {style}>{title}</polygon>")
            }
        };
    }
}

fn ring(svg: &mut String, (x, y): (f64, f64)) {
    let ink = hex(INK);
    let _ = writeln!(
        svg,
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"1.2\"/>"
    );
}

fn text(svg: &mut String, (x, y): (f64, f64), anchor: &str, inside: &str) {
    let _ = writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{}\">{}</text>",
        hex(INK),
        escape(inside)
    );
}

fn polyline(svg: &mut String, points: &[(f64, f64)], color: &str, width: f64, dashes: &str, opacity: f64) {
    let places: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    let dashes = if dashes.is_empty() {
        String::new()
    } else {
        format!(" stroke-dasharray=\"{dashes}\"")
    };
    let _ = writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes} opacity=\"{opacity}\"/>",
        places.join(" ")
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scatter(dots: &[(f64, f64)]) -> String {
        let look = Look {
            color: 1,
            marker: Marker::Triangle,
            shade: 1.0,
        };
        let dots = dots
            .iter()
            .map(|&(x, y)| Dot {
                x,
                y,
                is_hollow: false,
                name: "rtol <1e-3>".into(),
            })
            .collect();
        let panel = Panel {
            x: Axis::Time,
            y: "error of v".into(),
            series: vec![Series {
                name: "hht".into(),
                look,
                dots,
            }],
            front: vec![],
            floor: None,
        };
        let (title, legend) = ("a & b".into(), vec![Entry::Look(look, "HHT".into())]);
        Scatter {
            title,
            panels: vec![panel],
            legend,
        }
        .to_svg(true)
    }

    #[test]
    fn points_are_marked_and_axes_carry_names() {
        let svg = scatter(&[(2e-3, 1e-2), (0.3, 1e-6), (0.5, 1e9), (1.0, 0.0)]);
        for part in [
            "a &amp; b",
            "processor time",
            "error of v",
            "HHT",
            ">10 ms<",
            ">1e-4<",
            "rtol &lt;1e-3&gt;",
        ] {
            assert!(svg.contains(part), "{part}\n{svg}");
        }
        // Two points and the legend's marker: what has nothing to do with the reference, or is exact, has no place.
        assert_eq!(svg.matches("<polygon").count(), 3);
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn no_points_and_equal_points_are_drawn() {
        for dots in [&[][..], &[(1.0, 1.0)], &[(1.0, 1.0), (1.0, 1.0)]] {
            let svg = scatter(dots);
            assert!(
                svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"),
                "{svg}"
            );
        }
    }

    #[test]
    fn ticks_are_short_and_not_too_many() {
        let ticks = |low: f64, high: f64| Scale::over([low, high].into_iter(), 0.0, 1.0, 0.0).ticks();
        let values: Vec<f64> = ticks(1.0, 20.0).into_iter().map(|tick| tick.0).collect();
        assert_eq!(values, [1.0, 2.0, 5.0, 10.0, 20.0]);
        let named = ticks(1e-15, 1e3).iter().filter(|tick| tick.1).count();
        assert!((5..=12).contains(&named), "{named}");
        assert_eq!(Axis::Time.tick(2e-4), "200 \u{b5}s");
        assert_eq!(
            (Axis::Count("steps").tick(2000.0), Axis::Count("steps").tick(2e5)),
            ("2000".into(), "2e5".into())
        );
    }
}
