//! Expressions of markers: what constraints and forces are functions of, counted in the order of
//! their own lists, so that joints of one kind share their functions.

use super::kernel::Kernel;
use crate::model::{Expr, Marker, MarkerId, Model, Observable};
use crate::symbolic::Id;
use crate::symbolic::Time;

/// An expression with its markers counted in a constraint's or force's own list.
pub fn localise(expr: &Expr, markers: &[MarkerId]) -> Expr {
    let Expr::Observed(Observable::Marker {
        marker,
        derivative,
        component,
    }) = expr
    else {
        let rebuilt = expr.with_parts(&mut |part| Some(localise(part, markers)));
        return rebuilt.unwrap_or_else(|| expr.clone());
    };
    let place = markers.iter().position(|other| other == marker);
    let place = place.unwrap_or_else(|| panic!("marker {} is missing in the list of an expression", marker.0));
    Expr::Observed(Observable::Marker {
        marker: MarkerId(place),
        derivative: *derivative,
        component: *component,
    })
}

/// A graph with the symbols of local markers and their derivatives.
pub struct Marked<'m> {
    /// Graph, time and parameters.
    pub time: Time<'m>,
    /// Symbols by derivative, three for each marker.
    pub symbols: Vec<Vec<Id>>,
}

impl<'m> Marked<'m> {
    /// Symbols of `count` markers; `texts` gives the text of each derivative's symbol by marker and
    /// component.
    pub fn new(model: &'m Model, count: usize, texts: &[&dyn Fn(usize, usize) -> String]) -> Self {
        let mut time = Time::new(model);
        let mut symbols = Vec::new();
        for (derivative, text) in texts.iter().enumerate() {
            let mut ids = Vec::new();
            for marker in 0..count {
                for component in 0..3 {
                    let symbol = time.graph.symbol(text(marker, component));
                    let observable = Observable::Marker {
                        marker: MarkerId(marker),
                        derivative,
                        component,
                    };
                    time.observed.push((observable, symbol));
                    ids.push(symbol);
                }
            }
            symbols.push(ids);
        }
        Self { time, symbols }
    }

    /// A kernel of the graph, with further arguments behind model and time.
    pub fn kernel(self, name: String, title: String, outputs: Vec<(String, Id)>, arguments: &[&str]) -> Kernel {
        let mut kernel = self.time.kernel(name, title, outputs);
        let arguments = arguments.iter().map(|argument| argument.to_string());
        kernel.arguments.extend(arguments);
        kernel
    }

    /// Values as `z`, rates as `velocity`.
    pub fn values_and_rates(model: &'m Model, count: usize) -> Self {
        let value = |marker: usize, component: usize| format!("z[{marker}][{component}]");
        let rate = |marker: usize, component: usize| format!("velocity[{marker}][{component}]");
        Self::new(model, count, &[&value, &rate])
    }
}

/// The last word of function names: letters, digits and underscores, and none of those taken.
pub fn function_name(name: &str, taken: &[String]) -> String {
    let wanted: String = crate::model::identifier(name)
        .chars()
        .map(|letter| if letter.is_alphanumeric() { letter } else { '_' })
        .collect();
    let mut free = wanted.clone();
    let mut count = 2;
    while taken.contains(&free) {
        free = format!("{wanted}_{count}");
        count += 1;
    }
    free
}

/// Names in backquotes, separated by commas.
pub fn list<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

/// What the vectors z are, for documentation.
pub fn describe(model: &Model, name: &str, markers: &[MarkerId]) -> String {
    let frame = |frame: &crate::model::FrameId| format!("`{}`", model.frames[frame.0].name);
    let body = |body: &crate::model::BodyId| format!("`{}`", model.bodies[body.0].name);
    let words = markers.iter().enumerate().map(|(place, marker)| {
        let what = match &model.markers[marker.0] {
            Marker::Point { frame: of, .. } => format!("a point of {}", frame(of)),
            Marker::Direction { frame: of, .. } => format!("a direction of {}", frame(of)),
            Marker::BodyPoint { body: of, .. } => format!("a place on {}", body(of)),
            Marker::SectionPoint { body: of, .. } => format!("a place beside the axis of {}", body(of)),
            Marker::BodySlope { body: of, .. } => format!("a slope of {}", body(of)),
            Marker::BodySection { body: of, axis, .. } => {
                format!("the {} axis of a section of {}", ["x", "y", "z"][*axis], body(of))
            }
            Marker::InSection { body: of, .. } => {
                format!("fixed in a section of {}, where another direction starts", body(of))
            }
            Marker::SectionTurn { body: of, .. } => format!("the turning of a section of {}", body(of)),
            Marker::Turn { frame: of } => format!("the turning of {}", frame(of)),
            Marker::Angle { frame: of } => format!("the angle of {}", frame(of)),
            Marker::Matching { frame: of, .. } => format!("fixed in {}, where another vector starts", frame(of)),
            Marker::Normal { frame: of, .. } => format!("fixed in {}, normal to a direction at the start", frame(of)),
        };
        format!("`z[{place}]` {what}")
    });
    let words: Vec<String> = words.collect();
    format!("Of `{name}`: {} (inertial axes).", words.join("; "))
}
