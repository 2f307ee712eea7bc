//! Charts as SVG for the report. Colours are fixed names here; the page's style sheet turns them
//! into those of a light or dark page.

use std::fmt::{Display, Write};

use plotters::coord::Shift;
use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use serde_json::{Value, json};

use super::lanes::{above, height, lanes};
use crate::app::writing::numbers::digits;

/// A chart of lines over a common axis; the default has none.
#[derive(Default)]
pub struct Chart {
    /// Name and unit of the horizontal axis.
    pub x: String,
    /// Name and unit of the vertical axis.
    pub y: String,
    /// Whether the vertical axis is logarithmic; all values are then positive.
    pub logarithmic: bool,
    /// The lines, later ones above earlier ones. In the page lines of one name are hidden together.
    pub lines: Vec<Line>,
    /// Vertical lines at values of x, with what they are.
    pub marks: Vec<(f64, String)>,
    /// Whether it is taller than others, for many lines.
    pub is_tall: bool,
}

/// A line of a chart.
pub struct Line {
    /// Ascending or descending in x, all finite.
    pub points: Vec<(f64, f64)>,
    /// Number of the colour: blue, orange, green, purple, ochre, grey, and again from the start.
    pub color: usize,
    /// What its colour stands for; empty where it is the only one.
    pub name: String,
    /// What is written at its end of a dashed, grey line, which does not count in the vertical range.
    pub guide: Option<String>,
    /// How it is drawn.
    pub stroke: Stroke,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A continuous line.
    Solid,
    /// What lies below it shows.
    Dashed,
    /// Its points alone, in any order.
    Dots,
}

impl Line {
    /// A line through points in one of the colours.
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>, color: usize) -> Self {
        Self {
            points: points.into_iter().collect(),
            color,
            name: String::new(),
            guide: None,
            stroke: Stroke::Solid,
        }
    }

    /// The same with dashes.
    pub fn dashed(self) -> Self {
        Self {
            stroke: Stroke::Dashed,
            ..self
        }
    }

    /// Single points in one of the colours.
    pub fn dots(points: impl IntoIterator<Item = (f64, f64)>, color: usize) -> Self {
        Self {
            stroke: Stroke::Dots,
            ..Self::new(points, color)
        }
    }

    /// The same with a name.
    pub fn named(self, name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            ..self
        }
    }

    /// A dashed, grey line with its name at the end.
    pub fn guide(points: impl IntoIterator<Item = (f64, f64)>, label: &str) -> Self {
        Self {
            guide: Some(label.into()),
            ..Self::new(points, 0)
        }
    }

    /// Its points, of a line no more than are told apart in as many parts of the axis.
    fn seen(&self, buckets: usize) -> Vec<(f64, f64)> {
        match self.stroke {
            Stroke::Dots => self.points.clone(),
            Stroke::Solid | Stroke::Dashed => thinned(&self.points, buckets),
        }
    }
}

/// Colours of the lines on a light page, in their order.
pub(in crate::app) const LINES: [RGBColor; 6] = [
    RGBColor(0x1f, 0x5f, 0xa8),
    RGBColor(0xc2, 0x51, 0x0c),
    RGBColor(0x2a, 0x7d, 0x46),
    RGBColor(0x8a, 0x3f, 0x9e),
    RGBColor(0xa0, 0x7a, 0x00),
    RGBColor(0x5b, 0x5b, 0x5b),
];
/// Colour of axes and their text.
pub(in crate::app) const INK: RGBColor = RGBColor(0x33, 0x33, 0x33);
/// Colour of the grid.
pub(in crate::app) const GRID: RGBColor = RGBColor(0xdd, 0xdd, 0xdd);

// The backend rounds to whole units: a drawing four times as large as shown keeps curves smooth.
pub(in crate::app) const WIDTH: u32 = 3840;
pub(in crate::app) const HEIGHT: u32 = 1280;
pub(in crate::app) const TALL: u32 = 2200;
pub(in crate::app) const TEXT: u32 = 64;
/// Room for the vertical axis and its labels.
pub(in crate::app) const LEFT: u32 = 320;
const STROKE: u32 = 7;
// More points than this are not told apart in the drawing.
const BUCKETS: usize = 1500;

/// `#1F5FA8`.
pub(in crate::app) fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Interval = std::ops::Range<f64>;

impl Chart {
    /// The chart as an `svg` element.
    ///
    /// # Errors
    /// The drawing library's reason, which names no place in the data: the lines are finite.
    pub fn to_svg(&self) -> Result<String, String> {
        let mut text = String::new();
        let area =
            SVGBackend::with_string(&mut text, (WIDTH, if self.is_tall { TALL } else { HEIGHT })).into_drawing_area();
        let (x, y) = (self.range(|point| point.0), self.range(|point| point.1));
        let x = padded(x, 0.0);
        let drawn = if self.logarithmic {
            self.draw(&area, x, decades(y), |range| range.log_scale(), 6)
        } else {
            self.draw(&area, x, padded(y, 0.06), |range| range, 7)
        };
        drawn.map_err(|error| format!("a chart cannot be drawn: {error}"))?;
        drop(area);
        Ok(text)
    }

    /// The same as data, for the script of the page: seven digits, no more points than a drawing shows.
    pub(in crate::app) fn to_json(&self) -> Value {
        let number = |value: f64| match digits(value, 7).parse::<f64>() {
            Ok(short) => json!(short),
            Err(_) => json!(value),
        };
        let line = |line: &Line| {
            let points = line.seen(BUCKETS / 4);
            json!({
                "name": line.name,
                "color": line.color,
                "guide": line.guide,
                "dashed": line.stroke == Stroke::Dashed,
                "dots": (line.stroke == Stroke::Dots).then_some("circle"),
                "joined": line.stroke != Stroke::Dots,
                "p": points.iter().flat_map(|&(x, y)| [number(x), number(y)]).collect::<Value>(),
            })
        };
        json!({
            "x": self.x,
            "y": self.y,
            "log": self.logarithmic,
            "tall": self.is_tall,
            "lines": self.lines.iter().map(line).collect::<Value>(),
            "marks": self.marks.iter().map(|(place, text)| json!([number(*place), text])).collect::<Value>(),
        })
    }

    fn draw<Y>(
        &self,
        area: &Area<'_>,
        x: Interval,
        y: Interval,
        scaled: impl Fn(Interval) -> Y,
        ticks: usize,
    ) -> Result<(), String>
    where
        Y: plotters::coord::ranged1d::AsRangedCoord<Value = f64>,
        Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        let told = |error: &dyn Display| error.to_string();
        let right = if self.lines.iter().any(|line| line.guide.is_some()) {
            160
        } else {
            120
        };
        let width = f64::from(WIDTH - 24 - LEFT - right);
        let place = |value: f64| width * (value - x.start) / (x.end - x.start);
        let lanes = lanes(
            self.marks.iter().map(|(value, name)| (place(*value), name.as_str())),
            TEXT,
        );
        let mut chart = ChartBuilder::on(area)
            .margin(24)
            .margin_top(height(&lanes, TEXT))
            .margin_right(right)
            .x_label_area_size(168)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(x.clone(), scaled(y.clone()))
            .map_err(|error| told(&error))?;
        self.draw_mesh(&mut chart, ticks).map_err(|error| told(&error))?;
        let style = ("sans-serif", TEXT).into_font().color(&INK);
        let centred = style.pos(Pos::new(HPos::Center, VPos::Bottom));
        for ((place, label), lane) in self.marks.iter().zip(lanes) {
            let ends = [(*place, y.start), (*place, y.end)];
            let line = DashedLineSeries::new(ends, 12, 20, INK.stroke_width(4));
            chart.draw_series(line).map_err(|error| told(&error))?;
            let text = Text::new(label.clone(), (0, -(above(lane, TEXT) as i32)), centred.clone());
            chart
                .draw_series([EmptyElement::at((*place, y.end)) + text])
                .map_err(|error| told(&error))?;
        }
        for line in &self.lines {
            let points = line.seen(BUCKETS);
            let Some(label) = &line.guide else {
                let color = LINES[line.color % LINES.len()];
                let style = color.stroke_width(STROKE);
                let drawn = match line.stroke {
                    Stroke::Solid => chart.draw_series(LineSeries::new(points, style)).map(drop),
                    Stroke::Dashed => chart
                        .draw_series(DashedLineSeries::new(points, 28, 24, style))
                        .map(drop),
                    Stroke::Dots => {
                        let dots = points.into_iter().map(|place| Circle::new(place, 18, color.filled()));
                        chart.draw_series(dots).map(drop)
                    }
                };
                drawn.map_err(|error| told(&error))?;
                continue;
            };
            let points = below(&points, y.end);
            let Some(&end) = points.last() else { continue };
            let series = DashedLineSeries::new(points, 36, 24, INK.stroke_width(5));
            chart.draw_series(series).map_err(|error| told(&error))?;
            // At the side where the line leaves it, else under the upper edge.
            let position = if end.0 >= x.end {
                Pos::new(HPos::Left, VPos::Center)
            } else {
                Pos::new(HPos::Left, VPos::Top)
            };
            let text = Text::new(format!(" {label}"), end, style.pos(position));
            chart.draw_series([text]).map_err(|error| told(&error))?;
        }
        area.present().map_err(|error| told(&error))
    }

    fn draw_mesh<'a, Y: Ranged<ValueType = f64> + ValueFormatter<f64>>(
        &self,
        chart: &mut ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, Y>>,
        ticks: usize,
    ) -> Result<(), impl Display + use<'a, Y>> {
        let style = ("sans-serif", TEXT).into_font().color(&INK);
        let size = |(low, high): (f64, f64)| if low <= high { low.abs().max(high.abs()) } else { 0.0 };
        let x_size = size(self.range(|point| point.0));
        let y_size = if self.logarithmic {
            0.0
        } else {
            size(self.range(|point| point.1))
        };
        chart
            .configure_mesh()
            .x_desc(self.x.as_str())
            .y_desc(self.y.as_str())
            .x_labels(11)
            .y_labels(ticks)
            .x_label_formatter(&|value| tick(*value, x_size))
            .y_label_formatter(&|value| tick(*value, y_size))
            .label_style(style.clone())
            .axis_desc_style(style)
            .axis_style(INK.stroke_width(3))
            .bold_line_style(GRID.stroke_width(3))
            .light_line_style(TRANSPARENT)
            .set_all_tick_mark_size(16)
            .draw()
    }

    fn range(&self, of: impl Fn(&(f64, f64)) -> f64) -> (f64, f64) {
        let fitted = self.lines.iter().filter(|line| line.guide.is_none());
        let values = fitted.flat_map(|line| &line.points).map(of);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        })
    }
}

/// The range with a share of its length added at both ends; never empty.
fn padded((low, high): (f64, f64), share: f64) -> Interval {
    if low > high {
        return 0.0..1.0;
    }
    let middle = low.abs().max(high.abs());
    let length = high - low;
    // A range of round-off would show noise as motion.
    let pad = if length > 1e-9 * middle {
        share * length
    } else if middle > 0.0 {
        0.1 * middle
    } else {
        1.0
    };
    low - pad..high + pad
}

/// The whole decades that hold the range.
fn decades((low, high): (f64, f64)) -> Interval {
    if low > high || low <= 0.0 {
        return 0.1..1.0;
    }
    let first = low.log10().floor();
    let last = high.log10().ceil().max(first + 1.0);
    // A little more, or round-off takes the first tick away.
    0.999 * 10f64.powf(first)..10f64.powf(last)
}

/// Short text of a tick's value on an axis with values up to `size`.
fn tick(value: f64, size: f64) -> String {
    // Ticks are short decimals up to the round-off of their computation, which shows at zero.
    let value = if value.abs() < 1e-9 * size { 0.0 } else { value };
    digits(value, 6)
}

/// The part of an ascending line up to a height.
fn below(points: &[(f64, f64)], height: f64) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for &(x, y) in points {
        if y <= height {
            kept.push((x, y));
            continue;
        }
        if let Some(&(before, low)) = kept.last() {
            kept.push((before + (x - before) * (height - low) / (y - low), height));
        }
        break;
    }
    kept
}

/// At most four points for each of `buckets` equal parts of the axis: the first, the lowest, the
/// highest and the last, so that no peak is lost.
fn thinned(points: &[(f64, f64)], buckets: usize) -> Vec<(f64, f64)> {
    if points.len() <= 4 * buckets {
        return points.to_vec();
    }
    let (first, last) = (points[0].0, points[points.len() - 1].0);
    let bucket = |x: f64| ((x - first) / (last - first) * buckets as f64) as usize;
    let mut kept = Vec::with_capacity(4 * buckets);
    let parts = points.chunk_by(|a, b| bucket(a.0) == bucket(b.0));
    for part in parts {
        let by_height = |&a: &usize, &b: &usize| part[a].1.total_cmp(&part[b].1);
        let low = (0..part.len()).min_by(by_height).unwrap_or(0);
        let high = (0..part.len()).max_by(by_height).unwrap_or(0);
        let mut indices = [0, low, high, part.len() - 1];
        indices.sort_unstable();
        let mut previous = None;
        for index in indices {
            if previous != Some(index) {
                kept.push(part[index]);
            }
            previous = Some(index);
        }
    }
    kept
}

/// A chart with its caption; `below` stands under it.
///
/// # Errors
/// A chart that cannot be drawn.
pub(in crate::app) fn figure(page: &mut String, caption: &str, chart: &Chart, below: &str) -> Result<(), String> {
    live(page, caption, &chart.to_svg()?, &chart.to_json(), below);
    Ok(())
}

/// A drawing with its caption and the data from which the page's script draws it again.
pub(in crate::app) fn live(page: &mut String, caption: &str, svg: &str, data: &Value, below: &str) {
    // Nothing in the data ends the element that holds it.
    let data = data.to_string().replace('<', "\\u003c");
    let _ = write!(
        page,
        "<figure>\n<figcaption>{caption}</figcaption>\n{svg}\n\
         <script type=\"application/json\" class=\"data\">{data}</script>\n{below}</figure>\n"
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(lines: Vec<Vec<(f64, f64)>>, logarithmic: bool) -> String {
        let (x, y) = ("t [s]".into(), "v [m]".into());
        let chart = Chart {
            x,
            y,
            logarithmic,
            lines: lines.into_iter().map(|points| Line::new(points, 0)).collect(),
            ..Chart::default()
        };
        chart.to_svg().unwrap()
    }

    #[test]
    fn axes_carry_names_and_units() {
        let svg = chart(vec![vec![(0.0, 0.0), (1.0, 2.0)]], false);
        assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("t [s]") && svg.contains("v [m]"));
        assert!(svg.contains(r##"stroke="#1F5FA8""##), "{svg}");
    }

    #[test]
    fn constant_empty_and_logarithmic_data_are_drawn() {
        for lines in [
            vec![],
            vec![vec![]],
            vec![vec![(0.0, 0.0)]],
            vec![vec![(0.0, 3.0), (1.0, 3.0)]],
        ] {
            assert!(chart(lines, false).contains("</svg>"));
        }
        let svg = chart(vec![vec![(0.0, 1e-3), (1.0, 0.2)]], true);
        for label in ["0.001", "0.01", "0.1"] {
            assert!(svg.contains(label), "{label}");
        }
    }

    #[test]
    fn zero_is_labelled_without_round_off() {
        let svg = chart(vec![vec![(0.0, 0.0), (10.0, -0.533), (20.0, 0.008)]], false);
        assert_eq!(svg.matches("\n0\n").count(), 2, "{svg}");
    }

    #[test]
    fn guides_are_cut_at_the_upper_edge_and_marks_carry_their_names() {
        assert_eq!(below(&[(0.0, 0.0), (4.0, 8.0)], 2.0), [(0.0, 0.0), (1.0, 2.0)]);
        assert_eq!(below(&[(0.0, 3.0)], 2.0), []);
        let chart = Chart {
            x: "speed [rpm]".into(),
            y: "frequency [Hz]".into(),
            logarithmic: false,
            lines: vec![
                Line::new([(0.0, 1.0), (1.0, 2.0)], 1),
                Line::guide([(0.0, 0.0), (1.0, 50.0)], "1x"),
                Line::dots([(1.0, 2.0)], 1),
            ],
            marks: vec![(0.5, "critical".into())],
            is_tall: true,
        };
        let svg = chart.to_svg().unwrap();
        assert!(
            svg.contains("1x") && svg.contains("critical") && svg.contains("<circle"),
            "{svg}"
        );
        // The guide does not stretch the axis.
        assert!(!svg.contains("\n50\n") && svg.contains("\n2\n"), "{svg}");
    }

    #[test]
    fn thinning_keeps_peaks_and_ends() {
        let mut points: Vec<_> = (0..100_000)
            .map(|i| (f64::from(i), (f64::from(i) * 0.01).sin()))
            .collect();
        points[31_415].1 = 7.0;
        let kept = thinned(&points, 100);
        assert!(kept.len() <= 4 * 101);
        assert!(kept.contains(&(31_415.0, 7.0)));
        assert_eq!((kept[0], kept[kept.len() - 1]), (points[0], points[99_999]));
        assert!(kept.is_sorted_by(|a, b| a.0 < b.0));
    }
}
