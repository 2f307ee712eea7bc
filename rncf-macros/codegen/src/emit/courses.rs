//! Motions and loads over time, as operations that the runtime bounds.

use super::parts::Parts;
use crate::lower::courses::CourseKernel;
use crate::lower::forces::ForceKernels;
use crate::model::Model;

impl Parts<'_> {
    /// The method that returns them.
    pub(super) fn courses(&self) -> String {
        let all = &self.equations.courses;
        if all.is_empty() {
            return "fn courses(&self) -> ::std::vec::Vec<::rncf::emitted::Courses> {\n::std::vec::Vec::new()\n}\n"
                .to_string();
        }
        let each: String = all.iter().map(one).collect();
        format!(
            "fn courses(&self) -> ::std::vec::Vec<::rncf::emitted::Courses> {{\nuse ::rncf::emitted::Operation as Of;\nlet model = &self.model;\nlet mut all = ::std::vec::Vec::new();\n{each}all\n}}\n"
        )
    }
}

/// The method that returns what a force on markers does over its vectors.
pub(super) fn of_forces(model: &Model, kernels: &[ForceKernels]) -> String {
    let each = kernels.iter().flat_map(|kernels| {
        let course = kernels.course.iter();
        course.flat_map(|course| kernels.of.iter().map(move |&index| (course, index)))
    });
    let each = each.map(|(course, index)| {
        let mut course = course.clone();
        let of = model.forces[index].in_words();
        course.functions.iter_mut().for_each(|(name, _)| name.clone_from(&of));
        let made = made(&course, "0.0", "");
        format!("{index} => ::std::option::Option::Some({made}),\n")
    });
    format!(
        "fn force_course(&self, force: usize) -> ::std::option::Option<::rncf::emitted::Courses> {{\n{}}}\n",
        looked_up("force", &each.collect::<String>())
    )
}

/// What a method returns that looks a course up, `{index} => {course},` each.
pub(super) fn looked_up(of: &str, each: &str) -> String {
    if each.is_empty() {
        return "::std::option::Option::None\n".to_string();
    }
    format!(
        "use ::rncf::emitted::Operation as Of;\nlet model = &self.model;\nmatch {of} {{\n{each}_ => ::std::option::Option::None,\n}}\n"
    )
}

fn one(course: &CourseKernel) -> String {
    let body = format!("all.push({});\n", made(course, "0.0", ""));
    match course.repeat {
        None => body,
        Some(repeat) => format!("for instance in 0..self.counts[{}] {{\n{body}}}\n", repeat.0),
    }
}

/// An expression that makes courses for a place, where `model` is the struct of the params; in a loop `instance` is the number of its repetition.
/// Arguments of the kernel of numbers end with a comma.
pub(super) fn made(course: &CourseKernel, place: &str, arguments: &str) -> String {
    let (kernel, count) = &course.numbers;
    let index = course.repeat.map_or("", |_| "instance as f64, ");
    let numbers = match count {
        0 => String::new(),
        _ => format!("{}(model, {arguments}{index}&mut numbers);\n", kernel.name),
    };
    let mutable = if *count > 0 { "mut " } else { "" };
    let operations: Vec<String> = course.operations.iter().map(|one| format!("Of::{one}")).collect();
    let operations = operations.join(", ");
    let tables: Vec<String> = course.tables.iter().map(|table| format!("{table} as _")).collect();
    let tables = tables.join(", ");
    let functions: Vec<String> = course
        .functions
        .iter()
        .map(|(of, at)| format!("({of:?}, {at})"))
        .collect();
    let functions = functions.join(", ");
    let mut rest = String::new();
    if course.are_positions {
        rest += "are_positions: true,\n";
    }
    if !course.markers.is_empty() {
        let markers: Vec<String> = course.markers.iter().map(|marker| marker.0.to_string()).collect();
        rest += &format!("markers: ::std::vec![{}],\n", markers.join(", "));
    }
    format!(
        "{{\nlet {mutable}numbers = [0.0; {count}];\n{numbers}::rncf::emitted::Courses {{\noperations: &[{operations}],\nnumbers: numbers.to_vec(),\ntables: ::std::vec![{tables}],\nfunctions: &[{functions}],\nplace: {place},\n{rest}..::std::default::Default::default()\n}}\n}}"
    )
}
