//! The generated struct and its `Model` implementation.

use std::fmt::Write;

use super::expression::{inline, operator};
use super::kernel::{distinct_arrays, documentation};
use super::notes::notes;
use super::number::number;
use super::{module_name, visibility, visibility_inside};
use crate::elements::Library;
use crate::lower::Equations;
use crate::model::{Model, Param, Table};
use crate::symbolic::Time;

/// The struct, visible one module farther out than it stands.
pub fn structure(model: &Model, library: &Library, equations: &Equations) -> String {
    let name = &model.name;
    let notes = notes(model, library, equations);
    let list: Vec<String> = notes.iter().map(|note| format!("* {note}")).collect();
    let doc = if model.doc.is_empty() { name } else { &model.doc };
    let mut text = documentation([doc.as_str(), "# Chosen and left out", &list.join("\n")].into_iter());
    let _ = writeln!(
        text,
        "#[derive(Clone, Debug, PartialEq)]\n#[allow(non_snake_case)]\n{} struct {name} {{",
        visibility_inside(model)
    );
    for param in &model.params {
        let kind = match param {
            Param { is_table: true, .. } => "::rncf::TableFile",
            Param { is_count: true, .. } => "usize",
            _ => "f64",
        };
        let unit = if param.is_count {
            "count".to_string()
        } else if param.is_table {
            "a file with this table".to_string()
        } else {
            format!("SI; declared in {}", param.unit)
        };
        let doc = if param.doc.is_empty() {
            format!("`{}`, {unit}.", param.name)
        } else {
            format!("{} ({unit})", param.doc)
        };
        let _ = writeln!(
            text,
            "{}pub {}: {kind},",
            documentation(std::iter::once(doc.as_str())),
            param.name
        );
    }
    text + "}\n"
}

/// The defaults of the struct and what it says of itself. The struct stands in the module of the equations, which sees it
/// there also where the declaration stands in a function.
pub fn declaration(model: &Model, library: &Library, equations: &Equations, hash: u64) -> String {
    let (name, module) = (&model.name, module_name(model));
    let notes = notes(model, library, equations);
    let mut text = format!(
        "#[doc(inline)]\n#[allow(unused_imports)]\n{}use {module}::{name};\n",
        visibility(model)
    );
    let _ = writeln!(
        text,
        "#[allow(clippy::all)]\nimpl Default for {name} {{\nfn default() -> Self {{\nSelf {{"
    );
    for param in &model.params {
        let value = if param.is_table {
            format!("::rncf::TableFile::declared(&{module}::{})", form_of(model, param))
        } else if param.is_count {
            format!("{}", param.default as usize)
        } else {
            number(param.default)
        };
        let _ = writeln!(text, "{}: {value},", param.name);
    }
    text += "}\n}\n}\n";
    text + &implementation(model, &notes, equations, hash)
}

/// What is said of the files of a parameter.
fn form_of(model: &Model, param: &Param) -> String {
    let table = model.tables.iter().find(|table| table.name == param.name);
    table.map_or_else(String::new, Table::form)
}

fn implementation(model: &Model, notes: &[String], equations: &Equations, hash: u64) -> String {
    let (name, module) = (&model.name, module_name(model));
    let notes: Vec<String> = notes.iter().map(|note| format!("{note:?}")).collect();
    let mut text = format!(
        "#[allow(unused_variables, clippy::all)]\nimpl ::rncf::Model for {name} {{\n\
         const NAME: &'static str = {name:?};\n\
         const DOC: &'static str = {:?};\n\
         const SOURCE: &'static str = {};\n\
         const EQUATIONS_HASH: u64 = {hash:#018x};\n\
         const NOTES: &'static [&'static str] = &[{}];\n",
        model.doc,
        raw(&model.source),
        notes.join(", ")
    );
    text += &derived(equations);
    // An expression of its own may not name the statics of tables.
    let is_static = model.params.iter().any(|param| param.is_table);
    text += "fn params() -> &'static [::rncf::Param] {\n";
    text += if is_static {
        "static PARAMS: &[::rncf::Param] = &[\n"
    } else {
        "&[\n"
    };
    for param in &model.params {
        let _ = writeln!(
            text,
            "::rncf::Param {{ name: {:?}, kind: ::rncf::ParamKind::{}, unit: {:?}, unit_si: {}, dimension: {:?}, default: {}, doc: {:?} }},",
            param.name,
            match param {
                Param { is_table: true, .. } => format!("Table(&{module}::{})", form_of(model, param)),
                Param { is_count: true, .. } => "Count".to_string(),
                _ => "Quantity".to_string(),
            },
            param.unit,
            number(param.unit_si),
            param.dimension,
            number(param.default),
            param.doc
        );
    }
    text += if is_static { "];\nPARAMS" } else { "]" };
    text += "\n}\nfn outputs() -> &'static [::rncf::Output] {\n&[\n";
    for output in &model.outputs {
        let scalar = output.components.len() == 1 && output.components[0].0.is_empty();
        let components: Vec<&String> = output.components.iter().map(|(suffix, _)| suffix).collect();
        let components = if scalar {
            "[]".to_string()
        } else {
            format!("{components:?}")
        };
        let _ = writeln!(
            text,
            "::rncf::Output {{ name: {:?}, unit: {:?}, time_exponent: {}, components: &{components}, doc: {:?} }},",
            output.name,
            output.unit,
            number(output.time_exponent),
            output.doc
        );
    }
    text += "]\n}\n";
    let arms = |template: &dyn Fn(usize, &Param) -> String| -> String {
        model
            .params
            .iter()
            .enumerate()
            .map(|(index, param)| template(index, param))
            .collect()
    };
    let get = arms(&|index, param| {
        let cast = match param {
            Param { is_table: true, .. } => ".number()",
            Param { is_count: true, .. } => " as f64",
            _ => "",
        };
        format!("{index} => self.{}{cast},\n", param.name)
    });
    let set = arms(&|index, param| {
        if param.is_table {
            return format!("{index} => self.{0} = self.{0}.numbered(value),\n", param.name);
        }
        let cast = if param.is_count { " as usize" } else { "" };
        format!("{index} => self.{} = value{cast},\n", param.name)
    });
    text += &cautions(model);
    let count = model.params.len();
    let _ = writeln!(
        text,
        "fn get(&self, index: usize) -> f64 {{\nmatch index {{\n{get}_ => panic!(\"{name} has {count} parameters, not {{index}}\"),\n}}\n}}"
    );
    let _ = writeln!(
        text,
        "fn set(&mut self, index: usize, value: f64) {{\nmatch index {{\n{set}_ => panic!(\"{name} has {count} parameters, not {{index}}\"),\n}}\n}}"
    );
    let _ = writeln!(
        text,
        "fn run(&self) -> ::rncf::RunDefaults {{\nlet mut run = ::rncf::RunDefaults {{ t_end: 0.0, every: 0.0, start: ::rncf::Start::{:?} }};\n{module}::run_defaults(self, &mut run);\nrun\n}}",
        model.run.start
    );
    let _ = writeln!(
        text,
        "fn build_as(&self, formulation: ::rncf::Formulation, joints: ::rncf::Joints, fidelity: &[(::std::string::String, ::rncf::emitted::Fidelity)]) -> ::std::result::Result<::std::boxed::Box<dyn ::rncf::Scene>, ::rncf::ModelError> {{\n\
         ::rncf::model::check_params(self)?;\n\
         let equations = {module}::Equations::new(self);\n\
         ::rncf::build_as(equations, formulation, joints, fidelity)\n}}\n}}"
    );
    text
}

/// What was derived: constants and functions.
fn derived(equations: &Equations) -> String {
    let mut text = "const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[\n".to_string();
    for array in distinct_arrays(equations.of_elements()) {
        let _ = writeln!(
            text,
            "::rncf::model::ConstantArray {{ name: {:?}, size: [{}, {}], doc: {:?} }},",
            array.name,
            array.rows.len(),
            array.rows.first().map_or(0, Vec::len),
            array.doc.first().map_or("", String::as_str),
        );
    }
    text += "];\nconst KERNELS: &'static [::rncf::model::KernelCount] = &[\n";
    // What only copies, or calls others, has no operations of its own.
    let costs = equations
        .kernels()
        .into_iter()
        .map(|(kernel, _)| (kernel, kernel.cost()));
    for (kernel, cost) in costs.filter(|(kernel, cost)| !kernel.outputs.is_empty() && cost.weighted() > 0) {
        let _ = writeln!(
            text,
            "::rncf::model::KernelCount {{ name: {:?}, additions: {}, multiplications: {}, divisions: {}, functions: {}, weighted: {} }},",
            kernel.name,
            cost.additions,
            cost.multiplications,
            cost.divisions,
            cost.functions,
            cost.weighted()
        );
    }
    text + "];\n"
}

/// The sentences whose conditions hold.
fn cautions(model: &Model) -> String {
    if model.cautions.is_empty() {
        return String::new();
    }
    let mut text = "fn cautions(&self, end_time: f64) -> ::std::vec::Vec<::rncf::Caution> {\n\
                    let model = self;\nlet mut cautions = ::std::vec::Vec::new();\n"
        .to_string();
    for caution in &model.cautions {
        let (comparison, left, right) = &caution.condition;
        let [left, right] = [left, right].map(|side| {
            let mut time = Time::new(model);
            let id = time.expression(side);
            inline(&time.graph, id)
        });
        let _ = writeln!(
            text,
            "if ({left}) {} ({right}) {{\ncautions.push(::rncf::Caution {{ name: {:?}, text: {:?}, outputs: &{:?} }});\n}}",
            operator(*comparison),
            caution.name,
            caution.text,
            caution.outputs
        );
    }
    text + "cautions\n}\n"
}

/// A text over several lines as a raw string literal.
fn raw(text: &str) -> String {
    let mut fence = "#".to_string();
    while text.contains(&format!("\"{fence}")) {
        fence.push('#');
    }
    format!("r{fence}\"{text}\"{fence}")
}
