//! A kernel as a Rust function.

use std::collections::HashSet;
use std::fmt::Write;

use super::expression::Writer;
use super::number::number;
use crate::lower::Kernel;
use crate::lower::kernel::{PointLoop, Stage};
use crate::model::Function;
use crate::symbolic::{Array, Id, Node};

/// The function's text, documentation with operation counts included.
pub fn function(kernel: &Kernel) -> String {
    let mut text = documentation(kernel.doc.iter().map(String::as_str));
    if !kernel.outputs.is_empty() {
        let _ = writeln!(text, "///\n/// Operations: {}.", kernel.cost());
    }
    let _ = writeln!(text, "pub fn {}({}) {{", kernel.name, kernel.arguments.join(", "));
    finished(text, kernel, false)
}

/// The function's text, generic over its numbers: one element, or four side by side.
pub fn function_of_lanes(kernel: &Kernel) -> String {
    let mut text = documentation(kernel.doc.iter().map(String::as_str));
    let _ = writeln!(text, "///\n/// Operations: {}.\n#[inline(always)]", kernel.cost());
    let arguments: Vec<String> = kernel
        .arguments
        .iter()
        .map(|argument| argument_of_lanes(argument))
        .collect();
    let _ = writeln!(
        text,
        "pub fn {}<T: ::rncf::emitted::lanes::Real>({}) {{",
        kernel.name,
        arguments.join(", ")
    );
    finished(text, kernel, true)
}

fn finished(mut text: String, kernel: &Kernel, lanes: bool) -> String {
    for statement in body(kernel, lanes) {
        let _ = writeln!(text, "    {statement}");
    }
    text + "}\n"
}

/// An argument with `T` for its numbers, and what these are added to for its results.
fn argument_of_lanes(argument: &str) -> String {
    match argument.strip_prefix("row: ") {
        Some(row) => format!("row: {row}<T>"),
        None => argument.replace("&mut [f64;", "&mut [T::Cell;").replace("[f64;", "[T;"),
    }
}

/// Whether a function can be written for numbers of lanes: straight-line code of what these can do.
pub fn fits_lanes(kernel: &Kernel) -> bool {
    let graph = &kernel.graph;
    let outputs: Vec<Id> = kernel.outputs.iter().map(|&(_, id)| id).collect();
    let is_literal = |id: Id| graph.value(id).is_some();
    kernel.points.is_none()
        && !kernel.assign
        && outputs.iter().all(|&id| !is_literal(id) || graph.is_zero(id))
        && graph.reachable(&outputs).into_iter().all(|id| match graph.node(id) {
            Node::Call(function, of) => function == Function::Sqrt && !is_literal(of),
            Node::Call2(..) | Node::Select(..) | Node::Lookup(..) => false,
            Node::Negate(of) => !is_literal(of),
            Node::Power(of, _) => !is_literal(of),
            Node::Add(a, b) | Node::Subtract(a, b) | Node::Multiply(a, b) | Node::Divide(a, b) => {
                !(is_literal(a) && is_literal(b))
            }
            Node::Number(_) | Node::Symbol(_) => true,
        })
}

/// The arrays that kernels read, each once.
pub fn distinct_arrays<'a>(kernels: impl Iterator<Item = &'a Kernel>) -> Vec<&'a Array> {
    let mut distinct: Vec<&Array> = Vec::new();
    for array in kernels.flat_map(|kernel| kernel.graph.arrays()) {
        if distinct.iter().all(|known| known.name != array.name) {
            distinct.push(array);
        }
    }
    distinct
}

/// The same as text.
pub fn arrays<'a>(kernels: impl Iterator<Item = &'a Kernel>) -> String {
    let mut text = String::new();
    for array in distinct_arrays(kernels) {
        let rows = array.rows.iter().map(|row| {
            let row: Vec<String> = row.iter().map(|&value| number(value)).collect();
            format!("[{}],\n", row.join(", "))
        });
        let (height, width) = (array.rows.len(), array.rows.first().map_or(0, Vec::len));
        text += &documentation(array.doc.iter().map(String::as_str));
        text += &format!(
            "pub const {}: [[f64; {width}]; {height}] = [\n{}];\n",
            array.name,
            rows.collect::<String>()
        );
    }
    text
}

/// Paragraphs as documentation lines.
pub fn documentation<'a>(paragraphs: impl Iterator<Item = &'a str>) -> String {
    let blocks: Vec<String> = paragraphs
        .map(|paragraph| paragraph.lines().map(|line| format!("/// {line}\n")).collect())
        .collect();
    blocks.join("///\n")
}

/// Statements of the function.
fn body(kernel: &Kernel, lanes: bool) -> Vec<String> {
    let graph = &kernel.graph;
    let schedule = kernel.schedule();
    let at = |stage: Stage| Kernel::at_stage(&schedule, stage);
    let (before, inside, after) = (at(Stage::Before), at(Stage::Inside), at(Stage::After));
    let all: Vec<Id> = schedule.iter().map(|&(id, _)| id).collect();
    let summands = kernel
        .points
        .iter()
        .flat_map(|points| points.sums.iter().map(|&(_, summand)| summand));
    let roots = kernel.outputs.iter().map(|&(_, id)| id).chain(summands);
    let mut writer = Writer::new(graph, &all, roots);
    if lanes {
        writer.for_lanes();
    }
    for word in [
        "q",
        "v",
        "a",
        "row",
        "frame",
        "force",
        "stiffness",
        "damping_matrix",
        "energy",
        "reference",
        "table",
        "point",
    ] {
        writer.reserve(word);
    }
    for argument in &kernel.arguments {
        writer.forbid(argument.split(':').next().unwrap_or_default());
    }
    let mut out = kernel.bindings.clone();
    // What the loop or the outputs read again must have a name, or would be evaluated repeatedly.
    let needed_inside: HashSet<Id> = inside.iter().flat_map(|&id| graph.children(id)).collect();
    writer.statements(&before, &needed_inside, &mut out);
    if let Some(points) = &kernel.points {
        for &(sum, _) in &points.sums {
            out.push(format!("let mut {} = 0.0;", graph.symbol_text(sum)));
        }
        out.push(table(points));
        out.push("for (point, table) in TABLE.iter().enumerate() {".to_string());
        writer.statements(&inside, &HashSet::new(), &mut out);
        for &(sum, summand) in &points.sums {
            out.push(format!("{} += {};", graph.symbol_text(sum), writer.text(summand)));
        }
        out.push("}".to_string());
    }
    writer.statements(&after, &HashSet::new(), &mut out);
    for (place, id) in &kernel.outputs {
        if !kernel.assign && graph.is_zero(*id) {
            continue;
        }
        let value = writer.text(*id);
        out.push(match value.strip_prefix('-') {
            Some(positive) if !kernel.assign && !positive.contains([' ', '-']) => format!("{place} -= {positive};"),
            _ => format!("{place} {} {value};", if kernel.assign { "=" } else { "+=" }),
        });
    }
    out
}

/// The table of integration points, one row a point.
fn table(points: &PointLoop) -> String {
    let width = points.columns.len();
    let mut text = format!(
        "/// Columns: {}.\nconst TABLE: [[f64; {width}]; {}] = [\n",
        points.columns.join(", "),
        points.count
    );
    for row in &points.table {
        let row: Vec<String> = row.iter().map(|&value| number(value)).collect();
        let _ = writeln!(text, "[{}],", row.join(", "));
    }
    text + "];"
}
