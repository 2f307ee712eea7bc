//! The functions of the elements in the `Parts` implementation: mass, forces, tangents, energy, shapes; kernels that
//! can be evaluated for four elements side by side are dispatched to the processor's instructions.

use std::fmt::Write;

use super::kernel::documentation;
use super::parts::Parts;
use crate::lower::{Kernel, camel_case, motions};
use crate::model::Body;

/// Arguments of the functions of four elements.
const FOUR: &str = "elements: &[(usize, usize); 4], q: &[[f64; 4]], v: &[[f64; 4]]";

/// How the constants of four elements become one row of numbers of lanes.
pub(super) fn rows_side_by_side(row: &str, fields: &[&str]) -> String {
    let fields: String = fields
        .iter()
        .map(|field| format!("{field}: lanes.of_each(rows, |row| row.{field}),\n"))
        .collect();
    format!(
        "impl {row} {{\n/// The constants of four elements side by side.\n#[inline(always)]\n\
         pub fn side_by_side<L: ::rncf::emitted::lanes::Lanes>(rows: [&Self; 4], lanes: L) -> {row}<L::Real> {{\n\
         {row} {{\n{fields}}}\n}}\n}}\n"
    )
}

/// A kernel with the arguments for four elements, which `::rncf::emitted::lanes::run` takes.
pub(super) fn side_by_side(kernel: &Kernel) -> String {
    let name = camel_case(&kernel.name);
    let row = kernel.arguments[0].trim_start_matches("row: &");
    let (mut names, mut fields, mut loads, mut arguments) = (Vec::new(), String::new(), String::new(), Vec::new());
    for argument in &kernel.arguments {
        let Some((argument, kind)) = argument.split_once(": ") else {
            continue;
        };
        let (field, kind, load) = match (argument, kind.strip_prefix("&mut [f64; ")) {
            ("row", _) => (
                "rows",
                format!("[&'a {row}; 4]"),
                Some(format!("{row}::side_by_side(rows, lanes)")),
            ),
            ("reference", _) => {
                let kind = format!("[&'a {}; 4]", kind.trim_start_matches('&'));
                ("references", kind, Some("lanes.gather(references)".to_string()))
            }
            (_, Some(count)) => (argument, format!("&'a mut [[f64; 4]; {count}"), None),
            (_, None) => {
                let kind = kind.replace("&[f64; ", "&'a [[f64; 4]; ");
                (argument, kind, Some(format!("lanes.load_all({argument})")))
            }
        };
        let _ = writeln!(fields, "pub {field}: {kind},");
        names.push(field);
        arguments.push(match load {
            Some(load) => {
                let _ = writeln!(loads, "let {argument} = {load};");
                format!("&{argument}")
            }
            None => argument.to_string(),
        });
    }
    let doc = documentation([format!("[`{}`] of four elements side by side.", kernel.name).as_str()].into_iter());
    format!(
        "{doc}pub struct {name}<'a> {{\n{fields}}}\nimpl ::rncf::emitted::lanes::Kernel for {name}<'_> {{\n#[inline(always)]\n\
         fn run<L: ::rncf::emitted::lanes::Lanes>(self, lanes: L) {{\nlet Self {{ {} }} = self;\n{loads}{}({});\n}}\n}}\n",
        names.join(", "),
        kernel.name,
        arguments.join(", ")
    )
}

impl Parts<'_> {
    /// Constants of a body's elements, where `instance` is in scope if it is repeated.
    pub(super) fn row(&self, body: &Body) -> String {
        let element = if body.varies() { "[element]" } else { "" };
        match body.repeat {
            Some(_) => format!("self.row_{}[instance]{element}", body.identifier()),
            None => format!("self.row_{}{element}", body.identifier()),
        }
    }

    /// Values of one element in the stress-free shape, as the argument of a kernel.
    pub(super) fn reference(&self, index: usize, body: &Body) -> String {
        match self.variant(index).elastic.kept {
            0 => String::new(),
            _ if body.repeat.is_some() => format!("&self.reference_{}[instance][element], ", body.identifier()),
            _ => format!("&self.reference_{}[element], ", body.identifier()),
        }
    }

    /// Makes of a global number of a body its declaration, and the number of the repetition.
    pub(super) fn kind(&self) -> &'static str {
        if self.has_loops() {
            "let (body, instance) = self.kind(body);\n"
        } else {
            ""
        }
    }

    /// The index of the loop, where `instance` is in scope and the section or material of a body depends on it.
    pub(super) fn index(&self, body: &Body) -> &'static str {
        if body.differs() {
            "let index = instance as f64;\n"
        } else {
            ""
        }
    }

    /// The time that coefficients have before a scene has one.
    pub(super) fn at_start(&self, body: &Body) -> &'static str {
        match motions::timed_coefficients(body, self.library).is_empty() {
            true => "",
            false => "let t = 0.0_f64;\n",
        }
    }

    /// The functions that bring coefficients to a time; nothing where none changes.
    pub(super) fn timed_energies(&self) -> String {
        let timed = |body: &Body| motions::timed_coefficients(body, self.library);
        let mut statements = String::new();
        for body in &self.model.bodies {
            for one in timed(body) {
                let (row, name) = (format!("self.row_{}", body.identifier()), one.name);
                let value = self.coefficient(body, one);
                let _ = match (body.repeat.is_some(), body.varies()) {
                    (false, false) => writeln!(statements, "{row}.{name} = {value};"),
                    (true, true) => writeln!(
                        statements,
                        "let value = {value};\n{row}.iter_mut().flatten().for_each(|row| row.{name} = value);"
                    ),
                    _ => writeln!(
                        statements,
                        "let value = {value};\n{row}.iter_mut().for_each(|row| row.{name} = value);"
                    ),
                };
            }
        }
        let Some(first) = self.model.bodies.iter().find(|body| !timed(body).is_empty()) else {
            return String::new();
        };
        format!(
            "fn set_time(&mut self, t: f64) {{\nlet model = &self.model;\n{statements}}}\n\
             fn timed_energy(&self) -> ::std::option::Option<&'static str> {{ Some({:?}) }}\n",
            first.name
        )
    }

    /// The functions of one element, and of four.
    pub(super) fn element_functions(&self) -> String {
        let kind = self.kind();
        let mass = self.by_body(|index, body| {
            if body.varies() {
                let instance = if body.repeat.is_some() { "[instance]" } else { "" };
                return format!(
                    "mass.copy_from_slice(&self.mass_{}{instance}[element]);",
                    body.identifier()
                );
            }
            format!(
                "{}_mass(&{}, ::rncf::emitted::array_mut(mass));",
                self.variant(index).name,
                self.row(body)
            )
        });
        let energy = self.by_body(|index, body| {
            format!(
                "{}_strain_energy(&{}, {}::rncf::emitted::array(q), &mut energy);",
                self.variant(index).name,
                self.row(body),
                self.reference(index, body)
            )
        });
        let shapes = self.by_body(|index, body| {
            let all = self.variant(index).shapes.iter();
            let all = all.flat_map(|(of, orders)| orders.iter().enumerate().map(move |(order, kernel)| (of, order, kernel)));
            let arms = all.map(|(of, order, kernel)| {
                format!(
                    "(::rncf::emitted::Interpolant::{of:?}, {order}) => {}({}.length, xi, ::rncf::emitted::array_mut(weights)),\n",
                    kernel.name,
                    self.row(body)
                )
            });
            format!("match (of, order) {{\n{}_ => {{}}\n}}", arms.collect::<String>())
        });
        let mut text = format!("fn mass(&self, body: usize, element: usize, mass: &mut [f64]) {{\n{kind}{mass}}}\n");
        text += &self.elastic();
        text += &self.elastic_of_four();
        text + &format!(
            "fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64 {{\n{kind}let mut energy = 0.0;\n{energy}energy\n}}\n\
             fn shapes(&self, body: usize, element: usize, of: ::rncf::emitted::Interpolant, order: usize, xi: f64, weights: &mut [f64]) {{\n{kind}weights.fill(0.0);\n{shapes}}}\n"
        )
    }

    fn elastic(&self) -> String {
        let kind = self.kind();
        let call = |index: usize, body: &Body, quantity: &str, results: &str| {
            let rates = if self.variant(index).variant.damped {
                "::rncf::emitted::array(v), "
            } else {
                ""
            };
            format!(
                "{}_elastic_{quantity}(&{}, {}::rncf::emitted::array(q), {rates}{results});",
                self.variant(index).name,
                self.row(body),
                self.reference(index, body),
            )
        };
        let force = self.by_body(|index, body| call(index, body, "force", "::rncf::emitted::array_mut(force)"));
        let tangent = self.by_body(|index, body| {
            let results = if self.variant(index).variant.damped {
                "::rncf::emitted::array_mut(stiffness), ::rncf::emitted::array_mut(damping)"
            } else {
                "::rncf::emitted::array_mut(stiffness)"
            };
            call(index, body, "tangent", results)
        });
        format!(
            "fn elastic_force(&self, body: usize, element: usize, q: &[f64], v: &[f64], force: &mut [f64]) {{\n{kind}{force}}}\n\
             fn elastic_tangent(&self, body: usize, element: usize, q: &[f64], v: &[f64], stiffness: &mut [f64], damping: &mut [f64]) {{\n{kind}{tangent}}}\n"
        )
    }

    /// The functions of four elements; one by one where there are no kernels for them.
    fn elastic_of_four(&self) -> String {
        if !(0..self.model.bodies.len()).any(|index| self.variant(index).side_by_side()) {
            return format!(
                "fn elastic_force4(&self, {FOUR}, force: &mut [[f64; 4]]) {{\n::rncf::emitted::elastic_force_one_by_one(self, elements, q, v, force);\n}}\n\
                 fn elastic_tangent4(&self, {FOUR}, stiffness: &mut [[f64; 4]], damping: &mut [[f64; 4]]) {{\n::rncf::emitted::elastic_tangent_one_by_one(self, elements, q, v, stiffness, damping);\n}}\n"
            );
        }
        let body = match (self.model.bodies.len(), self.kind()) {
            (1, _) => "",
            (_, "") => "let body = elements[0].0;\n",
            _ => "let (body, _) = self.kind(elements[0].0);\n",
        };
        let call = |index: usize, body: &Body, quantity: &str, results: &[&str]| {
            let variant = self.variant(index);
            let all = results.join(", ");
            let one_by_one = format!("::rncf::emitted::elastic_{quantity}_one_by_one(self, elements, q, v, {all});");
            if !variant.side_by_side() {
                return one_by_one;
            }
            let rows = match body.repeat {
                Some(_) if body.varies() => {
                    format!(
                        "elements.map(|(body, element)| &self.row_{}[self.kind(body).1][element])",
                        body.identifier()
                    )
                }
                Some(_) => format!(
                    "elements.map(|(body, _)| &self.row_{}[self.kind(body).1])",
                    body.identifier()
                ),
                None if body.varies() => {
                    format!("elements.map(|(_, element)| &self.row_{}[element])", body.identifier())
                }
                None => format!("[&self.row_{}; 4]", body.identifier()),
            };
            let mut fields = vec![format!("rows: {rows}")];
            if variant.elastic.kept > 0 {
                let reference = self.reference(index, body);
                let reference = reference.trim_end_matches(", ");
                fields.push(match body.repeat {
                    Some(_) => {
                        let reference = reference.replace("[instance]", "[self.kind(body).1]");
                        format!("references: elements.map(|(body, element)| {reference})")
                    }
                    None => format!("references: elements.map(|(_, element)| {reference})"),
                });
            }
            fields.push("q: ::rncf::emitted::array(q)".to_string());
            if variant.variant.damped {
                fields.push("v: ::rncf::emitted::array(v)".to_string());
            }
            let results = &results[..if variant.variant.damped { results.len() } else { 1 }];
            for result in results {
                let field = if *result == "damping" { "damping_matrix" } else { result };
                fields.push(format!("{field}: ::rncf::emitted::array_mut({result})"));
            }
            let kernel = camel_case(&format!("{}_elastic_{quantity}", variant.name));
            format!(
                "let four = {kernel} {{ {} }};\nif !::rncf::emitted::lanes::run(four) {{ {one_by_one} }}",
                fields.join(", ")
            )
        };
        let force = self.by_body(|index, body| call(index, body, "force", &["force"]));
        let tangent = self.by_body(|index, body| call(index, body, "tangent", &["stiffness", "damping"]));
        format!(
            "fn elastic_force4(&self, {FOUR}, force: &mut [[f64; 4]]) {{\n{body}{force}}}\n\
             fn elastic_tangent4(&self, {FOUR}, stiffness: &mut [[f64; 4]], damping: &mut [[f64; 4]]) {{\n{body}{tangent}}}\n"
        )
    }
}
