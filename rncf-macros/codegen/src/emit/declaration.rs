//! The generated struct and its `Model` implementation.

use std::fmt::Write;

use super::equations::Equations;
use super::expression::{inline, operator};
use super::kernel::documentation;
use super::number::number;
use super::{module_name, visibility};
use crate::elements::{Interpolant, Library, NodalVector};
use crate::lower::constraints::members;
use crate::lower::markers::list;
use crate::lower::motions::Time;
use crate::model::{Body, Fidelity, INERTIAL, Model, Motions, Space};

/// The struct, its defaults and what it says of itself.
pub fn declaration(model: &Model, library: &Library, equations: &Equations) -> String {
    let name = &model.name;
    let mut text = documentation(std::iter::once(
        if model.doc.is_empty() { name } else { &model.doc }.as_str(),
    ));
    let _ = writeln!(
        text,
        "#[derive(Clone, Debug, PartialEq)]\n#[allow(non_snake_case)]\n{}struct {name} {{",
        visibility(model)
    );
    for param in &model.params {
        let kind = if param.is_count { "usize" } else { "f64" };
        let unit = if param.is_count {
            "count".to_string()
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
    text += "}\n";
    let _ = writeln!(
        text,
        "#[allow(clippy::all)]\nimpl Default for {name} {{\nfn default() -> Self {{\nSelf {{"
    );
    for param in &model.params {
        let value = if param.is_count {
            format!("{}", param.default as usize)
        } else {
            number(param.default)
        };
        let _ = writeln!(text, "{}: {value},", param.name);
    }
    text += "}\n}\n}\n";
    text + &implementation(model, library, equations)
}

fn implementation(model: &Model, library: &Library, equations: &Equations) -> String {
    let (name, module) = (&model.name, module_name(model));
    let notes: Vec<String> = notes(model, library, equations)
        .iter()
        .map(|note| format!("{note:?}"))
        .collect();
    let mut text = format!(
        "#[allow(unused_variables, clippy::all)]\nimpl ::rncf::Model for {name} {{\n\
         const NAME: &'static str = {name:?};\n\
         const DOC: &'static str = {:?};\n\
         const SOURCE: &'static str = {};\n\
         const NOTES: &'static [&'static str] = &[{}];\n",
        model.doc,
        raw(&model.source),
        notes.join(", ")
    );
    text += "fn params() -> &'static [::rncf::Param] {\n&[\n";
    for param in &model.params {
        let _ = writeln!(
            text,
            "::rncf::Param {{ name: {:?}, kind: ::rncf::ParamKind::{}, unit: {:?}, unit_si: {}, dimension: {:?}, default: {}, doc: {:?} }},",
            param.name,
            if param.is_count { "Count" } else { "Quantity" },
            param.unit,
            number(param.unit_si),
            param.dimension,
            number(param.default),
            param.doc
        );
    }
    text += "]\n}\nfn outputs() -> &'static [::rncf::Output] {\n&[\n";
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
            "::rncf::Output {{ name: {:?}, unit: {:?}, components: &{components}, doc: {:?} }},",
            output.name, output.unit, output.doc
        );
    }
    text += "]\n}\n";
    let arms = |template: &dyn Fn(usize, &crate::model::Param) -> String| -> String {
        model
            .params
            .iter()
            .enumerate()
            .map(|(index, param)| template(index, param))
            .collect()
    };
    let get = arms(&|index, param| {
        let cast = if param.is_count { " as f64" } else { "" };
        format!("{index} => self.{}{cast},\n", param.name)
    });
    let set = arms(&|index, param| {
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
        "fn run(&self) -> ::rncf::RunDefaults {{\nlet mut run = ::rncf::RunDefaults {{ t_end: 0.0, every: 0.0 }};\n{module}::run_defaults(self, &mut run);\nrun\n}}"
    );
    let _ = writeln!(
        text,
        "fn build_as(&self, formulation: ::rncf::Formulation, joints: ::rncf::Joints, fidelity: &[(::std::string::String, ::rncf::mesh::Fidelity)]) -> ::std::result::Result<::std::boxed::Box<dyn ::rncf::Scene>, ::rncf::ModelError> {{\n\
         ::rncf::mesh::check_params(self)?;\n\
         let equations = {module}::Equations::new(self);\n\
         ::rncf::mesh::build_as(equations, formulation, joints, fidelity)\n}}\n}}"
    );
    text
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

/// What was chosen and left out, and why.
fn notes(model: &Model, library: &Library, equations: &Equations) -> Vec<String> {
    let mut notes = Vec::new();
    for (body, &variant) in model.bodies.iter().zip(&equations.variant_of) {
        let variant = &equations.variants[variant];
        notes.push(format!(
            "Body `{}` uses `{}`. {}",
            body.name, variant.name, variant.elastic.choice
        ));
        if let Space::Planar { .. } = body.space {
            notes.push(format!(
                "Body `{}` is planar: two components a vector, no motion along the normal.",
                body.name
            ));
        }
        notes.extend(section(body, &variant.variant.vectors(library)));
        notes.push(placed(model, body));
        notes.extend(described(body));
    }
    notes.extend(moving(model, equations));
    notes.push(super::conserving::note(equations));
    notes
}

/// What the nodes of a body carry beside position and slope.
fn section(body: &Body, vectors: &[&NodalVector]) -> Option<String> {
    let axes = vectors.iter().filter(|vector| vector.of != Interpolant::Position);
    let names: Vec<&str> = axes.map(|vector| vector.name).collect();
    let which = match body.space {
        Space::Planar { .. } => "the section's y axis",
        Space::Spatial => "the section's y and z axes",
    };
    (!names.is_empty()).then(|| {
        format!(
            "Body `{}` has nodal vectors for {which} ({}): sections shear, twist and have rotary inertia.",
            body.name,
            names.join(", ")
        )
    })
}

/// Where a body lives.
fn placed(model: &Model, body: &Body) -> String {
    let (name, frame) = (&body.name, &model.frames[body.frame.0]);
    if body.frame == INERTIAL {
        return format!(
            "Body `{name}` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame."
        );
    }
    if frame.free.is_none() {
        return format!(
            "Body `{name}` moves in the prescribed frame `{}`: no unknowns for the frame, its reactions are evaluated.",
            frame.name
        );
    }
    let follows = if body.mean_axes {
        ", which follows the body's mean axes"
    } else {
        ""
    };
    format!(
        "Body `{name}` moves in the free frame `{}`{follows}: force and moment of its inertia on the frame, and their \
         derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        frame.name
    )
}

/// How finely a body's deformation is described, where not by all nodal vectors.
fn described(body: &Body) -> Option<String> {
    let name = &body.name;
    match body.fidelity {
        Fidelity::Full => None,
        Fidelity::Modal(_) => Some(format!(
            "Body `{name}` deforms in its lowest modes in its frame (Eqs. 15-17)."
        )),
        Fidelity::Small(_) => Some(format!(
            "Body `{name}` deforms little, in its lowest modes in its frame (Eqs. 18-20)."
        )),
        Fidelity::Rigid => Some(format!("Body `{name}` does not deform.")),
    }
}

/// Free frames, constraints, forces and fixtures.
fn moving(model: &Model, equations: &Equations) -> Vec<String> {
    let mut notes = Vec::new();
    for frame in &model.frames {
        if let Some(free) = &frame.free {
            let what = if free.is_body { "Rigid body" } else { "Frame" };
            notes.push(format!(
                "{what} `{}` is free in {}.",
                frame.name,
                unknowns(&free.motions)
            ));
        }
    }
    for kernels in &equations.constraints {
        let names = members(model, &kernels.of);
        let form = match kernels.hessian {
            Some(_) => "gradient and second derivatives are derived",
            None => "linear in its vectors, no second derivatives",
        };
        let count = kernels.levels[0].outputs.len();
        let multipliers = if count == 1 { "multiplier" } else { "multipliers" };
        notes.push(format!("Constraint {names}: {count} {multipliers}; {form}."));
    }
    for kernels in &equations.forces {
        let names = list(kernels.of.iter().map(|&index| model.forces[index].name.as_str()));
        let potential = if kernels.energy.is_some() { "a" } else { "no" };
        notes.push(format!(
            "Force {names}: {potential} potential; its tangents are derived."
        ));
    }
    for fixture in &model.fixtures {
        let body = &model.bodies[fixture.body.0].name;
        notes.push(format!(
            "Fixture `{}` adds constants to the inertia of `{body}` and no unknowns.",
            fixture.name
        ));
    }
    notes
}

fn unknowns(motions: &Motions) -> &'static str {
    match motions {
        Motions::Spatial => "six motions: three positions and a rotation vector that begins anew every step",
        Motions::Planar { .. } => "three motions: two positions and an angle",
        Motions::Turning => "three motions: a rotation vector that begins anew every step",
        Motions::Hinged { .. } => "one motion: an angle",
        Motions::Shifting => "three motions: a point mass does not turn",
        Motions::ShiftingPlanar { .. } => "two motions: a point mass does not turn",
    }
}
