//! Charts with their headings and the names of their lines as one picture, for documents.

use std::fmt::Write;

use super::charts::{Chart, HEIGHT, INK, LINES, TALL, TEXT, WIDTH, hex};
use crate::app::writing::html::escape;

/// Height of the line of a heading.
const HEAD: u32 = 130;
/// The drawing is so many times as large as it is shown.
const SCALE: u32 = 4;

/// Charts one below the other.
///
/// ```
/// use rncf::app::Figure;
/// use rncf::app::charts::{Chart, Line};
///
/// let wave = Line::new((0..100).map(|k| 0.1 * f64::from(k)).map(|t| (t, t.sin())), 0);
/// let measured = Line::dots([(1.57, 1.0), (4.71, -1.0)], 1);
/// let chart = Chart { x: "t [s]".into(), y: "z [m]".into(), lines: vec![wave, measured], ..Chart::default() };
/// let mut figure = Figure::default();
/// figure.add("A wave", &["computed", "measured"], chart);
/// assert!(figure.to_svg("A wave and two measurements")?.starts_with("<svg"));
/// # Ok::<(), String>(())
/// ```
#[derive(Default)]
pub struct Figure {
    panels: Vec<Panel>,
}

struct Panel {
    heading: String,
    names: Vec<String>,
    chart: Chart,
}

impl Figure {
    /// Adds a chart below the others; `names` are those of its colours, in their order, or none.
    pub fn add(&mut self, heading: &str, names: &[&str], chart: Chart) {
        let names = names.iter().map(|name| name.to_string()).collect();
        self.panels.push(Panel {
            heading: heading.into(),
            names,
            chart,
        });
    }

    /// The picture as an SVG document; `title` is what it shows, for those who do not see it.
    ///
    /// # Errors
    /// A chart that cannot be drawn.
    pub fn to_svg(&self, title: &str) -> Result<String, String> {
        let (mut body, mut top) = (String::new(), 0);
        for panel in &self.panels {
            panel.head(&mut body, top);
            let chart = panel.chart.to_svg()?;
            // The chart is an element of its own: here it is a group at its place.
            let inside = chart.split_once('>').map_or("", |(_, inside)| inside).trim_end();
            let inside = inside.strip_suffix("</svg>").unwrap_or(inside);
            let _ = writeln!(body, "<g transform=\"translate(0 {})\">{inside}</g>", top + HEAD);
            top += HEAD + if panel.chart.is_tall { TALL } else { HEIGHT };
        }
        Ok(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {WIDTH} {top}\">\n\
             <title>{}</title>\n<rect width=\"{WIDTH}\" height=\"{top}\" fill=\"#FFFFFF\"/>\n{body}</svg>\n",
            WIDTH / SCALE,
            top / SCALE,
            escape(title)
        ))
    }
}

impl Panel {
    /// Heading at the left, names in the colours of their lines at the right.
    fn head(&self, body: &mut String, top: u32) {
        let text = |x: u32, anchor: &str, inside: &str| {
            format!(
                "<text x=\"{x}\" y=\"{}\" text-anchor=\"{anchor}\" font-family=\"sans-serif\" font-size=\"{TEXT}\" fill=\"{}\">{inside}</text>\n",
                top + HEAD - 24,
                hex(INK),
            )
        };
        *body += &text(320, "start", &escape(&self.heading));
        let names: Vec<String> = (self.names.iter().zip(LINES))
            .map(|(name, line)| format!("<tspan fill=\"{}\">\u{2014} {}</tspan>", hex(line), escape(name)))
            .collect();
        if !names.is_empty() {
            *body += &text(WIDTH - 120, "end", &names.join("<tspan> \u{2003}</tspan>"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::page::charts::Line;

    #[test]
    fn panels_stand_one_below_the_other() {
        let chart = |is_tall| Chart {
            x: "t [s]".into(),
            y: "v [m]".into(),
            logarithmic: false,
            lines: vec![
                Line::new([(0.0, 0.0), (1.0, 2.0)], 0),
                Line::new([(0.0, 1.0), (1.0, 1.0)], 1),
            ],
            marks: Vec::new(),
            is_tall,
        };
        let mut figure = Figure::default();
        figure.add("first <one>", &["a", "b"], chart(true));
        figure.add("second", &[], chart(false));
        let svg = figure.to_svg("two charts").unwrap();
        assert_eq!((svg.matches("<svg").count(), svg.matches("</svg>").count()), (1, 1));
        assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count());
        assert!(svg.contains(&format!("translate(0 {})", 2 * HEAD + TALL)), "{svg}");
        assert!(svg.contains("first &lt;one&gt;") && svg.contains("<tspan fill=\"#C2510C\">\u{2014} b</tspan>"));
    }
}
