//! Drawings of scenes: bodies, joints and loads where a run has them, as SVG for the pages of the guide.

use std::fmt::Write;

use rncf::app::{Figure, Pictures};
use rncf::model::{Configuration, Curve, Sign, SignKind, SignPlace};
use rncf::nalgebra::Vector3;
use rncf::{Scene, State};

use crate::labels::{ABOVE_RIGHT, BELOW_LEFT, Point, RIGHT, Sheet, TEXT};

type Vector = Vector3<f64>;

/// Width of a picture; it is shown as a quarter of it. Whole units keep its text the same where a last digit is not.
const WIDTH: f64 = 3840.0;
/// Space around a drawing.
const MARGIN: f64 = 330.0;
/// Where along a body its name may stand, as parts of it, the first one that has room.
const ALONG: [f64; 7] = [0.5, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875];
/// Colours of bodies as they are, and as they begin; of joints and of loads.
const LINE: &str = "#1F5FA8";
const GREY: &str = "#9A9A9A";
const JOINT: &str = "#333333";
const LOAD: &str = "#C2510C";

/// From where a scene is seen: the directions to the right and up on the paper.
#[derive(Clone, Copy)]
pub struct View {
    /// To the right.
    pub right: [f64; 3],
    /// Up.
    pub up: [f64; 3],
}

impl View {
    /// Onto the plane of x and y.
    pub const XY: Self = Self {
        right: [1.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
    };
    /// Onto the plane of x and z.
    pub const XZ: Self = Self {
        right: [1.0, 0.0, 0.0],
        up: [0.0, 0.0, 1.0],
    };
    /// From above the corner between x and -y.
    pub const CORNER: Self = Self {
        right: [0.866, 0.5, 0.0],
        up: [-0.25, 0.433, 0.866],
    };

    fn of(&self, point: &Vector) -> [f64; 2] {
        [self.right, self.up].map(|axis| (0..3).map(|i| axis[i] * point[i]).sum())
    }
}

/// A scene and where it is at some times, the undeformed one first.
pub struct Shots {
    curves: Vec<Curve>,
    signs: Vec<Sign>,
    shots: Vec<Configuration>,
}

impl Shots {
    /// Those that a run has taken.
    pub fn of_run(pictures: &Pictures) -> Self {
        Self {
            curves: pictures.curves.clone(),
            signs: pictures.signs.clone(),
            shots: pictures.shots.clone(),
        }
    }

    /// The scene at rest, and in some states.
    pub fn of_states(scene: &mut dyn Scene, states: &[State]) -> Self {
        let rest = scene.rest(0.0);
        let shot = |state: &State| {
            let mut shot = Configuration::default();
            scene.configuration(state, &mut shot);
            shot
        };
        let shots = [&rest].into_iter().chain(states).map(shot).collect();
        Self {
            curves: scene.curves(),
            signs: scene.signs(),
            shots,
        }
    }

    /// Number of pictures.
    pub fn count(&self) -> usize {
        self.shots.len()
    }
}

/// A scene at some of its times.
pub struct Drawing<'p> {
    /// The scene.
    pub pictures: &'p Shots,
    /// Where it is seen from.
    pub view: View,
    /// The pictures that are drawn, the last one with its loads; the first of the run is drawn in grey.
    pub shots: Vec<usize>,
    /// Factor of what moves beside the undeformed shape.
    pub magnified: f64,
    /// How far its forces are drawn at most, m; none where it is zero.
    pub arrow: f64,
    /// What it shows.
    pub heading: String,
    /// Names that are not written, e.g. of the many that are alike.
    pub silent: Vec<String>,
}

impl<'p> Drawing<'p> {
    /// A scene as it is, without its forces, and with all names.
    pub fn new(pictures: &'p Shots, view: View, shots: Vec<usize>, heading: &str) -> Self {
        Self {
            pictures,
            view,
            shots,
            magnified: 1.0,
            arrow: 0.0,
            heading: heading.into(),
            silent: Vec::new(),
        }
    }

    /// Points of a curve in space.
    fn curve(&self, shot: &Configuration, number: usize) -> Vec<Vector> {
        let curves = &self.pictures.curves;
        let first: usize = curves[..number].iter().map(|curve| curve.points).sum();
        let Curve {
            frame,
            points,
            is_flexible,
            ..
        } = curves[number];
        let rest = &self.pictures.shots[0].points;
        let (origin, turn) = &shot.poses[frame];
        let place = |at: usize| {
            let (rest, now) = (rest[at], shot.points[at]);
            origin + turn * (rest + self.magnified * (now - rest))
        };
        let mut line: Vec<Vector> = (first..first + points).map(place).collect();
        if !is_flexible {
            // Places that are fixed to a frame are each reached from its origin.
            line = line.into_iter().flat_map(|place| [*origin, place]).collect();
        }
        line
    }

    /// Where a joint or a load is.
    fn place(&self, shot: &Configuration, sign: &Sign) -> Option<Vector> {
        match sign.place? {
            SignPlace::Frame { frame, at } => {
                let (origin, turn) = &shot.poses[frame];
                Some(origin + turn * at)
            }
            SignPlace::Curve { curve, point } => {
                let line = self.curve(shot, curve);
                let low = (point.floor() as usize).min(line.len() - 1);
                let high = (low + 1).min(line.len() - 1);
                Some(line[low] + (point - low as f64) * (line[high] - line[low]))
            }
        }
    }

    /// Names of the forces, where they act and how far they are drawn.
    fn arrows(&self, shot: &Configuration) -> Vec<(&str, [Vector; 2])> {
        let acts = |sign: &&Sign| !matches!(sign.kind, SignKind::Joint | SignKind::Spread);
        let acting = self.pictures.signs.iter().filter(acts).zip(&shot.acting);
        let forces: Vec<(&Sign, &Vector)> = acting
            .filter(|(sign, force)| sign.kind == SignKind::Force && force.norm() > 0.0 && self.arrow > 0.0)
            .collect();
        let largest = forces.iter().map(|(_, force)| force.norm()).fold(0.0, f64::max);
        let mut arrows = Vec::new();
        for (sign, force) in forces {
            if let Some(from) = self.place(shot, sign) {
                arrows.push((sign.name.as_str(), [from, from + force * (self.arrow / largest)]));
            }
        }
        arrows
    }

    /// The drawing as SVG with its height.
    fn to_svg(&self) -> (String, f64) {
        let shots: Vec<&Configuration> = self.shots.iter().map(|&shot| &self.pictures.shots[shot]).collect();
        let first = &self.pictures.shots[0];
        let last = *shots.last().unwrap_or(&first);
        let numbers = 0..self.pictures.curves.len();
        let lines = |shot: &Configuration| -> Vec<Vec<[f64; 2]>> {
            let of = |number| {
                self.curve(shot, number)
                    .iter()
                    .map(|point| self.view.of(point))
                    .collect()
            };
            numbers.clone().map(of).collect()
        };
        let mut all: Vec<[f64; 2]> = shots
            .iter()
            .chain([&first])
            .flat_map(|shot| lines(shot))
            .flatten()
            .collect();
        let arrows = self.arrows(last);
        all.extend(
            arrows
                .iter()
                .flat_map(|(_, ends)| ends.iter().map(|end| self.view.of(end))),
        );
        let range = |axis: usize| {
            let values = all.iter().map(|point| point[axis]);
            let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                [low.min(value), high.max(value)]
            });
            (ends[0], ends[1] - ends[0])
        };
        let ((left, wide), (low, tall)) = (range(0), range(1));
        let scale = ((WIDTH - 4.0 * MARGIN) / wide.max(1e-9)).min(1500.0 / tall.max(1e-9));
        let height = scale * tall + 2.0 * MARGIN + 130.0;
        let indent = (WIDTH - scale * wide) / 2.0;
        let to_paper = |point: [f64; 2]| {
            [
                indent + scale * (point[0] - left),
                height - MARGIN - scale * (point[1] - low),
            ]
            .map(f64::round)
        };
        let mut svg = String::new();
        let text = |svg: &mut String, x: f64, y: f64, anchor: &str, color: &str, inside: &str| {
            let _ = writeln!(
                svg,
                "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" font-family=\"sans-serif\" font-size=\"{TEXT}\" fill=\"{color}\">{inside}</text>"
            );
        };
        text(&mut svg, 320.0, 106.0, "start", "#333333", &self.heading);
        let mut sheet = Sheet::new([WIDTH, height]);
        sheet.text([320.0, 106.0], &self.heading);
        // Names are written when all is drawn that they keep off.
        let mut names: Vec<(&str, Vec<Point>, &[Point], &str)> = Vec::new();
        let draw = |svg: &mut String, sheet: &mut Sheet, line: &[Point], color: &str, dashes: &str, opacity: f64| {
            let line: Vec<Point> = line.iter().map(|&point| to_paper(point)).collect();
            sheet.line(&line);
            let points: Vec<String> = (line.iter())
                .map(|point| point.map(|value| value.to_string()).join(","))
                .collect();
            let _ = writeln!(
                svg,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"12\" stroke-linejoin=\"round\" opacity=\"{opacity:.2}\"{dashes}/>",
                points.join(" ")
            );
        };
        for line in lines(first) {
            draw(&mut svg, &mut sheet, &line, GREY, " stroke-dasharray=\"30 24\"", 1.0);
        }
        for (number, shot) in shots.iter().enumerate() {
            let opacity = 0.25 + 0.75 * (number + 1) as f64 / shots.len() as f64;
            for line in lines(shot) {
                draw(&mut svg, &mut sheet, &line, LINE, "", opacity);
            }
        }
        for (curve, line) in self.pictures.curves.iter().zip(lines(last)) {
            if curve.name.is_empty() || self.silent.contains(&curve.name) {
                continue;
            }
            let places = ALONG.map(|part| to_paper(along(&line, part)));
            names.push((&curve.name, places.to_vec(), &ABOVE_RIGHT, LINE));
        }
        let mut written: Vec<(&str, [f64; 2])> = Vec::new();
        for sign in self.pictures.signs.iter().filter(|sign| sign.kind == SignKind::Joint) {
            let Some(place) = self.place(last, sign) else { continue };
            let [x, y] = to_paper(self.view.of(&place));
            let _ = writeln!(
                svg,
                "<circle cx=\"{x}\" cy=\"{y}\" r=\"24\" fill=\"#FFFFFF\" stroke=\"{JOINT}\" stroke-width=\"9\"/>"
            );
            sheet.spot([x, y], 28.0);
            // The name of several joints at one place is written once.
            let near = (written.iter()).any(|(name, at)| *name == sign.name && (at[0] - x).hypot(at[1] - y) < 120.0);
            if !self.silent.contains(&sign.name) && !near {
                names.push((&sign.name, vec![[x, y]], &BELOW_LEFT, JOINT));
                written.push((&sign.name, [x, y]));
            }
        }
        for (name, [from, to]) in arrows {
            let ([x, y], [tip_x, tip_y]) = (to_paper(self.view.of(&from)), to_paper(self.view.of(&to)));
            let length = (tip_x - x).hypot(tip_y - y);
            if length < 60.0 {
                continue; // too short to be seen beside the others
            }
            let (cos, sin) = ((tip_x - x) / length, (tip_y - y) / length);
            let corner = |along: f64, across: f64| {
                [tip_x + along * cos - across * sin, tip_y + along * sin + across * cos]
                    .map(|value| value.round().to_string())
                    .join(" ")
            };
            let _ = writeln!(
                svg,
                "<line x1=\"{x}\" y1=\"{y}\" x2=\"{tip_x}\" y2=\"{tip_y}\" stroke=\"{LOAD}\" stroke-width=\"12\"/>\n<path d=\"M{}L{}L{}Z\" fill=\"{LOAD}\"/>",
                corner(50.0, 0.0),
                corner(-30.0, 34.0),
                corner(-30.0, -34.0)
            );
            sheet.line(&[[x, y], [tip_x, tip_y]]);
            sheet.spot([tip_x, tip_y], 50.0);
            if !self.silent.iter().any(|silent| silent == name) {
                names.push((name, vec![[tip_x + 50.0 * cos, tip_y + 50.0 * sin]], &RIGHT, LOAD));
            }
        }
        for (name, places, sides, color) in names {
            let placed = sheet.place(name, &places, sides);
            assert!(
                placed.covers == 0.0,
                "{}: no room for `{name}`, make it silent",
                self.heading
            );
            text(&mut svg, placed.at[0], placed.at[1], placed.anchor, color, name);
        }
        (svg, height.round())
    }
}

/// The point at a part of the way along a line, counted by its length.
fn along(line: &[Point], part: f64) -> Point {
    let lengths: Vec<f64> = line
        .windows(2)
        .map(|ends| (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1]))
        .collect();
    let mut left = part * lengths.iter().sum::<f64>();
    for (ends, length) in line.windows(2).zip(lengths) {
        if left <= length && length > 0.0 {
            return [0, 1].map(|axis| ends[0][axis] + left / length * (ends[1][axis] - ends[0][axis]));
        }
        left -= length;
    }
    line.last().copied().unwrap_or_default()
}

/// A drawing above its charts, as an SVG document; `title` is what it shows, for those who do not see it.
///
/// # Panics
/// A chart that cannot be drawn, or a name that would stand on a line or on another name.
pub fn picture(drawing: Option<&Drawing<'_>>, figure: &Figure, title: &str) -> String {
    let charts = figure.to_svg(title).unwrap_or_else(|error| panic!("{title}: {error}"));
    let Some(drawing) = drawing else { return charts };
    let (body, top) = drawing.to_svg();
    let box_of = charts
        .split_once("viewBox=\"0 0 3840 ")
        .and_then(|(_, rest)| rest.split_once('"'));
    let height: f64 = box_of
        .and_then(|(height, _)| height.parse().ok())
        .expect("a figure has a box");
    let inside = charts.split_once("/>\n").map_or("", |(_, inside)| inside).trim_end();
    let inside = inside.strip_suffix("</svg>").unwrap_or(inside);
    let whole = top + height;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"960\" height=\"{}\" viewBox=\"0 0 {WIDTH} {whole}\">\n<title>{title}</title>\n\
         <rect width=\"{WIDTH}\" height=\"{whole}\" fill=\"#FFFFFF\"/>\n{body}<g transform=\"translate(0 {top})\">\n{inside}</g>\n</svg>\n",
        (whole / 4.0).round()
    )
}
