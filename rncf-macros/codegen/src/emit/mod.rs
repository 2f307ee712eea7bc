//! From a model and its kernels to Rust: one function for each kind of thing, text first, tokens at
//! the end.

mod along;
mod bodies;
mod conserving;
mod courses;
pub mod declaration;
mod density;
mod distributed;
mod elements;
mod equations;
pub mod expression;
pub mod kernel;
mod moving;
mod notes;
pub mod number;
pub mod parts;
pub mod points;
mod repeated;
mod section;
mod start;

pub use bodies::included;

use crate::elements::Library;
use crate::import::hash::{hash, hash_on};
use crate::lower::Equations;
use crate::model::{Line, Model};

/// The whole expansion of a model as Rust text: the struct, its [`Model`] implementation and the
/// module with its equations.
pub fn model(model: &Model, library: &Library, mut equations: Equations) -> String {
    let constraints = equations.constraints.iter_mut();
    constraints.for_each(|kernels| moving::document_rows(kernels, model));
    let mut inside = declaration::structure(model, library, &equations);
    inside += &along::tables(model);
    inside += &equations.functions(library);
    inside += &parts::parts(model, library, &equations);
    let mut text = declaration::declaration(model, library, &equations, hash_of(model, &inside));
    text += &format!(
        "/// Equations of [`{0}`]: derived, checked and written by the generator.\n\
         #[allow(missing_docs, non_snake_case, unused_variables, unused_mut, unused_parens, clippy::all)]\n\
         {1}mod {2} {{\n",
        model.name,
        visibility(model),
        module_name(model),
    );
    text + &inside + "}\n"
}

/// Hash of the equations as they are written, and of the files that they name.
fn hash_of(model: &Model, equations: &str) -> u64 {
    let files = model.bodies.iter().filter_map(|body| match &body.line {
        Line::Imported(imported) => Some(imported.hash),
        _ => None,
    });
    files.fold(hash(equations), |hash, file| hash_on(hash, &file.to_le_bytes()))
}

fn visibility(model: &Model) -> String {
    if model.visibility.is_empty() {
        String::new()
    } else {
        format!("{} ", model.visibility)
    }
}

/// What the emitted text takes from Rust, or from this library, by one word.
const TAKEN: [&str; 6] = ["Default", "bool", "f64", "rncf", "str", "usize"];

/// Whether something that is written for the model, or that stands in it, has its name.
pub fn is_ambiguous(model: &Model, text: &str) -> bool {
    if TAKEN.contains(&model.name.as_str()) {
        return true;
    }
    let declared = format!("struct {}", model.name);
    let ends = |at: usize| !text[at..].starts_with(|c: char| c.is_alphanumeric() || c == '_');
    let places = text
        .match_indices(&declared)
        .filter(|(at, found)| ends(at + found.len()));
    places.count() > 1
}

/// The visibility of the model, written in the module of its equations.
fn visibility_inside(model: &Model) -> String {
    let outside = model.visibility.replace(' ', "");
    let path = outside.strip_prefix("pub(").and_then(|rest| rest.strip_suffix(')'));
    match (outside.as_str(), path) {
        ("" | "pub(self)", _) => "pub(super)".to_string(),
        (_, Some("super")) => "pub(in super::super)".to_string(),
        (_, Some(path)) if path.starts_with("insuper") => format!("pub(in super::{})", &path[2..]),
        _ => model.visibility.clone(),
    }
}

/// Module of the equations: `SpinUp` to `spin_up_equations`.
pub fn module_name(model: &Model) -> String {
    let mut name = String::new();
    for (index, letter) in model.name.chars().enumerate() {
        if letter.is_uppercase() && index > 0 && !name.ends_with('_') {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name + "_equations"
}
