//! Maps: a quantity over two parameters, a coloured cell for every pair of their values.

use std::fmt::Write;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use serde_json::{Value, json};

use super::charts::{INK, LEFT, TALL, TEXT, WIDTH, hex, live};
use super::lanes::{above, height, lanes};
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;

/// Height of heading and legend.
const HEAD: u32 = 220;
/// The drawing is so many times as large as it is shown.
const SCALE: u32 = 4;
/// Side of a field of the legend.
const FIELD: u32 = 64;
/// Fields of the legend of values.
const FIELDS: usize = 9;
/// Colours of classes, in their order; negative values and decades deepen from white to the first, positive values to
/// the second.
const COLORS: [RGBColor; 6] = [
    RGBColor(0x1f, 0x5f, 0xa8),
    RGBColor(0xc2, 0x51, 0x0c),
    RGBColor(0xe6, 0xb4, 0x4c),
    RGBColor(0x2a, 0x7d, 0x46),
    RGBColor(0x8a, 0x3f, 0x9e),
    RGBColor(0x9a, 0x9a, 0x9a),
];
/// A cell without a finite value.
const NOTHING: RGBColor = RGBColor(0xdd, 0xdd, 0xdd);

/// One of the two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Its name and unit.
    pub name: String,
    /// Its values, ascending, at the middles of the cells; in the drawing's unit.
    pub values: Vec<f64>,
    /// Whether the axis is logarithmic; all values are then positive.
    pub logarithmic: bool,
}

/// What the cells show, rows of constant y one after the other, from the least y on, each from the least x on.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers: orange for positive, blue for negative ones, white for zero; grey where a number is not finite. Colours
    /// deepen with the square root of the magnitude, so that small values differ from zero. Numbers of one sign that differ by
    /// less than their magnitude deepen evenly from the one that is nearest to zero.
    Signed(Vec<f64>),
    /// Positive numbers by their decade, from white to blue; grey where a number is not positive and finite.
    Decades(Vec<f64>),
    /// Indices of classes, with the names of all classes, six at most.
    Classes(Vec<usize>, Vec<String>),
}

/// A map.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// What it shows, with its unit.
    pub heading: String,
    /// From left to right.
    pub x: Axis,
    /// From below to above.
    pub y: Axis,
    /// One for each pair.
    pub cells: Cells,
    /// Dashed vertical lines at values of x, with what they are.
    pub marks: Vec<(f64, String)>,
}

impl Axis {
    /// Values on the drawing's even scale.
    fn place(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }

    /// Edges of the cells on the even scale: between the values, and as far beyond the first and last.
    fn edges(&self) -> Result<Vec<f64>, String> {
        let places: Vec<f64> = self.values.iter().map(|&value| self.place(value)).collect();
        let fails = |reason: &str| Err(format!("axis `{}` of a map {reason}", self.name));
        if places.iter().any(|place| !place.is_finite()) {
            return fails("has a value that is not finite, or not positive on a logarithmic scale");
        }
        if places.len() < 2 || !places.is_sorted_by(|a, b| a < b) {
            return fails("needs two or more ascending values");
        }
        let between = places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let mut edges: Vec<f64> = between.collect();
        edges.insert(0, 2.0 * places[0] - edges[0]);
        edges.push(2.0 * places[places.len() - 1] - edges[edges.len() - 1]);
        Ok(edges)
    }

    /// Text of a tick on the even scale.
    fn tick(&self, place: f64, size: f64) -> String {
        if !self.logarithmic {
            return digits(if place.abs() < 1e-9 * size { 0.0 } else { place }, 6);
        }
        // Whole decades alone: what lies between them is no short number.
        let decade = place.round();
        if (place - decade).abs() < 1e-9 {
            format!("1e{decade}")
        } else {
            String::new()
        }
    }
}

/// A colour between white (0) and another one (1).
fn shade(RGBColor(red, green, blue): RGBColor, depth: f64) -> RGBColor {
    let mix = |part: u8| (255.0 - depth.clamp(0.0, 1.0) * (255.0 - f64::from(part))).round() as u8;
    RGBColor(mix(red), mix(green), mix(blue))
}

/// A field of the legend: its colour and text.
type Field = (RGBColor, String);

impl Cells {
    /// The value of a cell.
    fn told(&self, cell: usize) -> String {
        match self {
            Cells::Signed(values) | Cells::Decades(values) => digits(values[cell], 6),
            Cells::Classes(classes, names) => names[classes[cell]].clone(),
        }
    }

    /// Colours of all cells, and of the fields of the legend with their texts.
    fn colors(&self) -> Result<(Vec<RGBColor>, Vec<Field>), String> {
        match self {
            Cells::Signed(values) => {
                let finite = values.iter().filter(|value| value.is_finite());
                let [low, high] = finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
                    [low.min(value), high.max(value)]
                });
                if low < high && low * high > 0.0 && high - low < 0.5 * (low.abs() + high.abs()) {
                    let (near, far) = if low > 0.0 { (low, high) } else { (high, low) };
                    let color = |value: f64| match value {
                        value if !value.is_finite() => NOTHING,
                        value => shade(
                            COLORS[usize::from(value > 0.0)],
                            0.1 + 0.9 * (value - near) / (far - near),
                        ),
                    };
                    let fields = (0..FIELDS).map(|field| near + field as f64 / (FIELDS - 1) as f64 * (far - near));
                    return Ok((
                        values.iter().map(|&value| color(value)).collect(),
                        fields.map(|value| (color(value), digits(value, 4))).collect(),
                    ));
                }
                let largest = if low <= high { low.abs().max(high.abs()) } else { 0.0 };
                let sides = [
                    if low < 0.0 { -1.0 } else { 0.0 },
                    if high > 0.0 || low >= 0.0 { 1.0 } else { 0.0 },
                ];
                let color = |value: f64| match value {
                    value if !value.is_finite() => NOTHING,
                    value if largest == 0.0 => shade(COLORS[0], value),
                    value => shade(COLORS[usize::from(value > 0.0)], (value.abs() / largest).sqrt()),
                };
                let share = |field: usize| field as f64 / (FIELDS - 1) as f64;
                let steps = (0..FIELDS).map(|field| sides[0] + share(field) * (sides[1] - sides[0]));
                let fields = steps.map(|step| largest * step * step.abs());
                Ok((
                    values.iter().map(|&value| color(value)).collect(),
                    fields.map(|value| (color(value), digits(value, 2))).collect(),
                ))
            }
            Cells::Decades(values) => {
                let told = values.iter().filter(|value| value.is_finite() && **value > 0.0);
                let (low, high) = told.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    (low.min(value.log10().floor()), high.max(value.log10().ceil()))
                });
                let depth = |place: f64| if high > low { (place - low) / (high - low) } else { 1.0 };
                let color = |value: f64| match value {
                    value if value.is_finite() && value > 0.0 => shade(COLORS[0], depth(value.log10())),
                    _ => NOTHING,
                };
                let decades = if high >= low { (high - low) as i32 } else { -1 };
                let fields = (0..=decades).map(|step| low + f64::from(step));
                Ok((
                    values.iter().map(|&value| color(value)).collect(),
                    fields
                        .map(|place| (shade(COLORS[0], depth(place)), format!("1e{place}")))
                        .collect(),
                ))
            }
            Cells::Classes(classes, names) => {
                if names.len() > COLORS.len() || classes.iter().any(|&class| class >= names.len()) {
                    return Err("a map has six classes at most, each with a name".into());
                }
                Ok((
                    classes.iter().map(|&class| COLORS[class]).collect(),
                    names
                        .iter()
                        .cloned()
                        .enumerate()
                        .map(|(class, name)| (COLORS[class], name))
                        .collect(),
                ))
            }
        }
    }
}

impl Map {
    /// Maps one below the other as an SVG document; `title` is what it shows, for those who do not see it.
    ///
    /// # Errors
    /// An axis without ascending values, cells that are not one for each pair, a class without a name, by the map's
    /// heading.
    pub fn to_svg(title: &str, maps: &[Map]) -> Result<String, String> {
        let (mut body, mut top) = (String::new(), 0);
        for map in maps {
            let drawn = map
                .draw(&mut body, top)
                .map_err(|error| format!("map `{}`: {error}", map.heading));
            drawn?;
            top += HEAD + TALL;
        }
        Ok(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {top}\">\n\
             <title>{}</title>\n<rect width=\"{WIDTH}\" height=\"{top}\" fill=\"#FFFFFF\"/>\n{body}</svg>\n",
            WIDTH / SCALE,
            top / SCALE,
            escape(title)
        ))
    }

    /// The map as a figure of a page, with the data from which its script draws it again.
    ///
    /// # Errors
    /// As those of [`Map::to_svg`].
    pub(in crate::app) fn part(&self) -> Result<String, String> {
        let told = |error: String| format!("map `{}`: {error}", self.heading);
        let (colors, legend) = self.cells.colors().map_err(told)?;
        let svg = self.cells_to_svg(&colors).map_err(told)?;
        let edges = |axis: &Axis| -> Result<Vec<f64>, String> {
            let edges = axis.edges().map_err(told)?.into_iter();
            let value = |edge: f64| if axis.logarithmic { 10f64.powf(edge) } else { edge };
            Ok(edges.map(value).collect())
        };
        let data = json!({
            "x": self.x.name,
            "y": self.y.name,
            "logx": self.x.logarithmic,
            "log": self.y.logarithmic,
            "tall": true,
            "lines": [],
            "marks": self.marks,
            "cells": {
                "what": self.heading,
                "x": edges(&self.x)?,
                "y": edges(&self.y)?,
                "at": [self.x.values, self.y.values],
                "colors": colors.iter().map(|color| hex(*color)).collect::<Value>(),
                "told": (0..colors.len()).map(|cell| self.cells.told(cell)).collect::<Value>(),
            },
        });
        let mut below = String::from("<p class=\"extremes\">");
        for (color, text) in &legend {
            let _ = write!(
                below,
                "<span class=\"shade\"><i style=\"background: {}\"></i>{}</span> ",
                hex(*color),
                escape(text)
            );
        }
        let mut page = String::new();
        live(&mut page, &escape(&self.heading), &svg, &data, &(below + "</p>\n"));
        Ok(page)
    }

    /// Adds heading, legend and cells below `top`.
    fn draw(&self, body: &mut String, top: u32) -> Result<(), String> {
        let (colors, legend) = self.cells.colors()?;
        let drawing = self.cells_to_svg(&colors)?;
        let text = |x: u32, y: u32, inside: &str| {
            format!(
                "<text x=\"{x}\" y=\"{y}\" font-family=\"sans-serif\" font-size=\"{TEXT}\" fill=\"#333333\">{}</text>\n",
                escape(inside)
            )
        };
        *body += &text(320, top + 90, &self.heading);
        let mut left = 320;
        for (color, name) in &legend {
            let y = top + 126;
            let _ = writeln!(
                body,
                "<rect x=\"{left}\" y=\"{y}\" width=\"{FIELD}\" height=\"{FIELD}\" fill=\"{}\" stroke=\"#333333\" stroke-width=\"3\"/>",
                hex(*color)
            );
            *body += &text(left + FIELD + 20, y + 54, name);
            left += FIELD + 80 + 36 * name.chars().count() as u32;
        }
        // The drawing is an element of its own: here it is a group at its place.
        let inside = drawing.split_once('>').map_or("", |(_, inside)| inside).trim_end();
        let inside = inside.strip_suffix("</svg>").unwrap_or(inside);
        // Without smoothing no white lines show between cells.
        let _ = writeln!(
            body,
            "<g transform=\"translate(0 {})\" shape-rendering=\"crispEdges\">{inside}</g>",
            top + HEAD
        );
        Ok(())
    }

    /// The cells with their axes.
    fn cells_to_svg(&self, colors: &[RGBColor]) -> Result<String, String> {
        if colors.len() != self.x.values.len() * self.y.values.len() {
            return Err("the cells are not one for each pair of values".into());
        }
        let (across, up) = (self.x.edges()?, self.y.edges()?);
        let mut svg = String::new();
        let area = SVGBackend::with_string(&mut svg, (WIDTH, TALL)).into_drawing_area();
        let told = |error: &dyn std::fmt::Display| format!("cannot be drawn: {error}");
        let range = |edges: &[f64]| edges[0]..edges[edges.len() - 1];
        let size = |edges: &[f64]| edges[0].abs().max(edges[edges.len() - 1].abs());
        let (first, last) = (across[0], across[across.len() - 1]);
        let width = f64::from(WIDTH - 24 - LEFT - 160);
        let place = |value: f64| width * (self.x.place(value) - first) / (last - first);
        let lanes = lanes(
            self.marks.iter().map(|(value, name)| (place(*value), name.as_str())),
            TEXT,
        );
        let mut chart = ChartBuilder::on(&area)
            .margin(24)
            .margin_top(height(&lanes, TEXT))
            .margin_right(160)
            .x_label_area_size(168)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(range(&across), range(&up))
            .map_err(|error| told(&error))?;
        let style = ("sans-serif", TEXT).into_font().color(&INK);
        let columns = self.x.values.len();
        let cells = colors.iter().enumerate().map(|(cell, color)| {
            let (i, j) = (cell % columns, cell / columns);
            Rectangle::new([(across[i], up[j]), (across[i + 1], up[j + 1])], color.filled())
        });
        chart.draw_series(cells).map_err(|error| told(&error))?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc(self.x.name.as_str())
            .y_desc(self.y.name.as_str())
            .x_labels(11)
            .y_labels(9)
            .x_label_formatter(&|place| self.x.tick(*place, size(&across)))
            .y_label_formatter(&|place| self.y.tick(*place, size(&up)))
            .label_style(style.clone())
            .axis_desc_style(style.clone())
            .axis_style(INK.stroke_width(3))
            .set_all_tick_mark_size(16)
            .draw()
            .map_err(|error| told(&error))?;
        for ((value, name), lane) in self.marks.iter().zip(lanes) {
            let (place, end) = (self.x.place(*value), up[up.len() - 1]);
            let line = DashedLineSeries::new([(place, up[0]), (place, end)], 24, 24, INK.stroke_width(6));
            chart.draw_series(line).map_err(|error| told(&error))?;
            let centred = style.clone().pos(Pos::new(HPos::Center, VPos::Bottom));
            let text = Text::new(name.clone(), (0, -(above(lane, TEXT) as i32)), centred);
            chart
                .draw_series([EmptyElement::at((place, end)) + text])
                .map_err(|error| told(&error))?;
        }
        // Under the cursor a browser shows the title of what lies there.
        let mut titles = String::new();
        for cell in 0..colors.len() {
            let (i, j) = (cell % columns, cell / columns);
            let plane = chart.plotting_area();
            let [(left, bottom), (right, top)] =
                [(across[i], up[j]), (across[i + 1], up[j + 1])].map(|corner| plane.map_coordinate(&corner));
            let value = |axis: &Axis, at: usize| format!("{} = {}", axis.name, digits(axis.values[at], 6));
            let _ = writeln!(
                titles,
                "<rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"none\" pointer-events=\"all\"><title>{}: {}; {}, {}</title></rect>",
                right - left,
                bottom - top,
                escape(&self.heading),
                escape(&self.cells.told(cell)),
                escape(&value(&self.x, i)),
                escape(&value(&self.y, j)),
            );
        }
        area.present().map_err(|error| told(&error))?;
        drop(chart);
        drop(area);
        let end = svg.rfind("</svg>").unwrap_or(svg.len());
        svg.insert_str(end, &titles);
        Ok(svg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(values: &[f64], logarithmic: bool) -> Axis {
        Axis {
            name: "h [s]".into(),
            values: values.to_vec(),
            logarithmic,
        }
    }

    fn map(cells: Cells) -> Map {
        Map {
            heading: "rate <1/s>".into(),
            x: axis(&[0.0, 1.0, 3.0], false),
            y: axis(&[1e-4, 1e-2], true),
            cells,
            marks: vec![(2.0, "critical".into())],
        }
    }

    #[test]
    fn cells_lie_between_the_middles_of_their_values() {
        assert_eq!(axis(&[0.0, 1.0, 3.0], false).edges().unwrap(), [-0.5, 0.5, 2.0, 4.0]);
        assert_eq!(axis(&[1e-4, 1e-2], true).edges().unwrap(), [-5.0, -3.0, -1.0]);
        let log = axis(&[1e-4, 1e-2], true);
        assert_eq!([log.tick(-3.0, 5.0), log.tick(-2.5, 5.0)], ["1e-3", ""]);
    }

    #[test]
    fn every_cell_has_the_colour_of_its_value() {
        let cells = Cells::Signed(vec![-4.0, -1.0, 0.0, 1.0, 4.0, f64::NAN]);
        let (colors, legend) = cells.colors().unwrap();
        let svg = Map::to_svg("rates", &[map(cells.clone())]).unwrap();
        let title = "<title>rate &lt;1/s&gt;: -4; h [s] = 0, h [s] = 0.0001</title>";
        assert!(
            svg.contains(title) && svg.matches("pointer-events").count() == 6,
            "{svg}"
        );
        let (near, fields) = Cells::Signed(vec![2.0, 2.1, 2.2]).colors().unwrap();
        assert!(near[2] == COLORS[1] && near[0] != near[1] && fields[0].1 == "2" && fields[8].1 == "2.2");
        assert_eq!(colors[0], COLORS[0]);
        assert_eq!(colors[4], COLORS[1]);
        assert_eq!((colors[2], colors[5]), (RGBColor(255, 255, 255), NOTHING));
        assert_eq!(colors[3], shade(COLORS[1], 0.5));
        assert_eq!((legend[0].1.as_str(), legend[FIELDS - 1].0), ("-4", COLORS[1]));
        let (colors, legend) = Cells::Decades(vec![1e-3, 0.02, 0.1, 0.0]).colors().unwrap();
        assert_eq!(
            (colors[0], colors[2], colors[3]),
            (shade(COLORS[0], 0.0), COLORS[0], NOTHING)
        );
        assert_eq!(legend.len(), 3);
        let svg = Map::to_svg("two maps", &[map(cells.clone()), map(cells)]).unwrap();
        assert_eq!((svg.matches("<svg").count(), svg.matches("</svg>").count()), (1, 1));
        assert!(
            svg.contains("rate &lt;1/s&gt;") && svg.contains("critical") && svg.contains("1e-4"),
            "{svg}"
        );
        assert!(svg.contains("h [s]") && svg.contains(&format!("translate(0 {})", 2 * HEAD + TALL)));
    }

    #[test]
    fn values_of_one_sign_use_the_whole_scale_and_pages_hold_the_cells() {
        let white = RGBColor(255, 255, 255);
        for (values, ends, texts) in [
            (vec![1.0, 16.0], [white, COLORS[1]], ["0", "16"]),
            (vec![-16.0, 0.0], [COLORS[0], white], ["-16", "0"]),
        ] {
            let (_, legend) = Cells::Signed(values).colors().unwrap();
            assert_eq!([legend[0].0, legend[FIELDS - 1].0], ends);
            assert_eq!([legend[0].1.as_str(), legend[FIELDS - 1].1.as_str()], texts);
        }
        let page = map(Cells::Signed(vec![-4.0, -1.0, 0.0, 1.0, 4.0, f64::NAN])).part();
        let page = page.unwrap();
        for part in [
            "<figcaption>rate &lt;1/s&gt;</figcaption>",
            "\"at\":[[0.0,1.0,3.0],[0.0001,0.01]]",
            "\"log\":true",
            "\"told\":[\"-4\",\"-1\",\"0\",\"1\",\"4\",",
            "background: #1F5FA8",
        ] {
            assert!(page.contains(part), "{part}\n{page}");
        }
        let short = map(Cells::Signed(vec![1.0])).part().unwrap_err();
        assert!(short.contains("rate <1/s>"));
    }

    #[test]
    fn classes_have_names_and_cells_a_place() {
        let named = |classes: Vec<usize>| {
            Map::to_svg(
                "",
                &[map(Cells::Classes(classes, vec!["fails".into(), "holds".into()]))],
            )
        };
        let svg = named(vec![0, 1, 1, 0, 0, 1]).unwrap();
        assert!(svg.contains("fails") && svg.contains("holds") && svg.contains("#1F5FA8"));
        assert!(named(vec![0, 2, 0, 0, 0, 0]).unwrap_err().contains("rate <1/s>"));
        assert!(named(vec![0]).unwrap_err().contains("one for each pair"));
        let mut falling = map(Cells::Signed(vec![0.0; 6]));
        falling.x.values = vec![1.0, 0.0, 2.0];
        assert!(Map::to_svg("", &[falling]).unwrap_err().contains("ascending"));
        let mut zero = map(Cells::Signed(vec![0.0; 6]));
        assert!(Map::to_svg("", &[zero.clone()]).is_ok());
        zero.y.values[0] = 0.0;
        assert!(Map::to_svg("", &[zero]).unwrap_err().contains("not positive"));
    }
}
