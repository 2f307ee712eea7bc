//! The `Parts` implementation: specifications, and one dispatch for each kind of kernel.

use std::fmt::Write;

use super::expression::inline;
use crate::elements::Library;
use crate::lower::joints::LEVELS;
use crate::lower::{Equations, camel_case};
use crate::model::{
    About, BalanceQuantity, Body, Expr, Held, INERTIAL, JointKind, LoadKind, Location, Model, Observable, Owner,
    PointQuantity,
};
use crate::symbolic::Time;

/// The struct with the constants of all bodies and its implementation.
pub fn parts(model: &Model, library: &Library, equations: &Equations) -> String {
    let writer = Parts {
        model,
        library,
        equations,
    };
    let mut text = writer.along();
    text += "/// Constants of all bodies.\n#[derive(Clone, Debug)]\npub struct Equations {\n";
    let _ = writeln!(text, "pub model: {},", model.name);
    text += &writer.numbering_fields();
    // Of a repeated body one for each repetition.
    let each = |body: &Body, kind: String| match body.repeat {
        Some(_) => format!("::std::vec::Vec<{kind}>"),
        None => kind,
    };
    for (body, &variant) in model.bodies.iter().zip(&equations.variant_of) {
        let variant = &equations.variants[variant];
        let of_elements = |kind: String| match variant.variant.varying {
            true => format!("::std::vec::Vec<{kind}>"),
            false => kind,
        };
        let row = each(body, of_elements(camel_case(&variant.name)));
        let _ = writeln!(text, "pub row_{}: {row},", body.identifier());
        if variant.elastic.kept > 0 {
            let reference = each(body, format!("::std::vec::Vec<[f64; {}]>", variant.elastic.kept));
            let _ = writeln!(text, "pub reference_{}: {reference},", body.identifier());
        }
        if variant.variant.varying {
            let mass = each(body, "::std::vec::Vec<::std::vec::Vec<f64>>".to_string());
            let _ = writeln!(text, "pub mass_{}: {mass},", body.identifier());
        }
    }
    let [statements, values] = writer.numbering_values();
    let _ = writeln!(
        text,
        "}}\nimpl Equations {{\n/// Constants for the given parameters; filled in when the bodies are meshed.\npub fn new(model: &{}) -> Self {{\n{statements}Self {{ model: model.clone(),\n{values}",
        model.name
    );
    for (body, &variant) in model.bodies.iter().zip(&equations.variant_of) {
        let _ = writeln!(text, "row_{}: Default::default(),", body.identifier());
        let variant = &equations.variants[variant];
        if variant.elastic.kept > 0 {
            let _ = writeln!(text, "reference_{}: ::std::vec::Vec::new(),", body.identifier());
        }
        if variant.variant.varying {
            let _ = writeln!(text, "mass_{}: ::std::vec::Vec::new(),", body.identifier());
        }
    }
    let _ = write!(
        text,
        "}}\n}}\n{}}}\nimpl ::rncf::emitted::Parts for Equations {{\n",
        writer.numbering_methods()
    );
    text += &writer.observed();
    text += &writer.facts();
    text += &writer.time_functions();
    text += &writer.conserving_obstacle();
    text += &writer.check();
    text += &writer.free();
    text += &writer.markers();
    text += "}\n";
    let [slopes, sections] = writer.moments();
    for (name, methods) in [
        ("Bodies", writer.meshed()),
        ("ConservingForces", writer.conserving_forces()),
        ("TimedEnergies", writer.timed_energies()),
        ("JointConditions", writer.joints()),
        ("Loads", writer.loads()),
        ("SlopeMoments", slopes),
        ("SectionMoments", sections),
        ("MarkerConstraints", writer.constraints()),
        ("MarkerForces", writer.forces()),
        ("Densities", writer.densities()),
        ("DistributedLoads", writer.distributed()),
        ("PlacedGravity", writer.around()),
        ("GravityFields", writer.fields()),
    ] {
        // What the model has nothing of it says so: all methods of a trait are written, or none.
        let _ = match methods.is_empty() {
            true => writeln!(text, "impl ::rncf::emitted::Without{name} for Equations {{}}"),
            false => writeln!(text, "impl ::rncf::emitted::{name} for Equations {{\n{methods}}}"),
        };
    }
    text
}

/// Writes the methods of one implementation; those of what moves freely are in [`super::moving`].
pub(super) struct Parts<'a> {
    pub model: &'a Model,
    pub library: &'a Library,
    pub equations: &'a Equations,
}

impl Parts<'_> {
    /// Text of an expression of the parameters, with `model` in scope.
    pub fn expr(&self, expr: &Expr) -> String {
        let mut time = Time::new(self.model);
        let id = time.expression(expr);
        inline(&time.graph, id)
    }

    /// Text of three expressions as an array.
    pub fn vector(&self, exprs: &[Expr; 3]) -> String {
        self.array(exprs)
    }

    /// Text of expressions as an array.
    pub fn array(&self, exprs: &[Expr]) -> String {
        format!(
            "[{}]",
            exprs.iter().map(|expr| self.expr(expr)).collect::<Vec<_>>().join(", ")
        )
    }

    /// Text of a place on a body.
    pub fn place(&self, location: &Location) -> String {
        match location {
            Location::Start => "::rncf::emitted::Place::Start".to_string(),
            Location::End => "::rncf::emitted::Place::End".to_string(),
            Location::At(expr) => format!("::rncf::emitted::Place::At({})", self.expr(expr)),
            Location::Part(expr) => format!("::rncf::emitted::Place::Part({})", self.expr(expr)),
            Location::Of { place, .. } => self.place(place),
        }
    }

    /// Meshed bodies and the functions of their elements.
    fn meshed(&self) -> String {
        if self.model.bodies.is_empty() {
            return String::new();
        }
        [
            self.bodies(),
            self.prepare(),
            self.initial(),
            self.shares(),
            self.starts(),
            self.fixtures(),
            self.varies(),
            self.read_tables(),
            self.properties_along(),
            self.element_functions(),
            self.sections(),
        ]
        .concat()
    }

    /// Joints and their conditions.
    fn joints(&self) -> String {
        if self.model.joints.is_empty() {
            return String::new();
        }
        let mut entries = Vec::new();
        for joint in &self.model.joints {
            let kind = match joint.kind {
                JointKind::Clamp => "Clamp".to_string(),
                JointKind::ClampFull => "ClampFull".to_string(),
                JointKind::Pin => "Pin".to_string(),
                JointKind::Hold { of, axis } => {
                    let (interpolant, order) = match of {
                        Held::Position => ("Position", 0),
                        Held::Slope => ("Position", 1),
                        Held::SectionY => ("SectionY", 0),
                        Held::SectionZ => ("SectionZ", 0),
                    };
                    format!("Hold {{ of: ::rncf::emitted::Interpolant::{interpolant}, order: {order}, axis: {axis} }}")
                }
            };
            let point = match &joint.point {
                Some(point) => format!("Some({})", self.vector(point)),
                None => "None".to_string(),
            };
            let entry = format!(
                "::rncf::emitted::JointSpec {{ name: {:?}, kind: ::rncf::emitted::JointKind::{kind}, body: {}, at_end: {}, frame: {}, point: {point} }}",
                joint.name,
                self.body_at(joint.body, &joint.at),
                *joint.at.place() == Location::End,
                joint.frame.0
            );
            entries.push((joint.repeat, entry));
        }
        self.list("joints", "JointSpec", &entries) + &self.conditions()
    }

    fn loads(&self) -> String {
        if self.model.loads.is_empty() {
            return String::new();
        }
        let mut text = "fn loads(&self) -> ::std::vec::Vec<::rncf::emitted::LoadSpec> {\nlet model = &self.model;\n::std::vec::Vec::from([\n".to_string();
        for load in &self.model.loads {
            let (kind, frame) = match &load.kind {
                LoadKind::Gravity(_) => ("Gravity".to_string(), 0),
                LoadKind::Around(_) => ("Around".to_string(), 0),
                LoadKind::Field { frame, markers, .. } => {
                    let markers: Vec<usize> = markers.iter().map(|marker| marker.0).collect();
                    (format!("Field {{ markers: &{markers:?} }}"), frame.0)
                }
                LoadKind::Force { body, at, frame, .. } => (
                    format!("Force {{ body: {}, at: {} }}", self.body_at(*body, at), self.place(at)),
                    frame.0,
                ),
                LoadKind::Moment { body, at, frame, .. } => (
                    format!("Moment {{ body: {}, at: {} }}", self.body_at(*body, at), self.place(at)),
                    frame.0,
                ),
            };
            let _ = writeln!(
                text,
                "::rncf::emitted::LoadSpec {{ name: {:?}, kind: ::rncf::emitted::LoadKind::{kind}, frame: {frame} }},",
                load.name
            );
        }
        let varies: Vec<bool> = self
            .model
            .loads
            .iter()
            .map(|load| crate::lower::motions::varies(self.model, load.kind.components()))
            .collect();
        let _ = writeln!(
            text,
            "])\n}}\nfn load_varies(&self, load: usize) -> bool {{ const VARIES: [bool; {}] = {varies:?};\nVARIES[load] }}",
            varies.len()
        );
        text += "fn load(&self, load: usize, t: f64) -> [f64; 3] {\nlet mut value = [0.0; 3];\nmatch load {\n";
        for (index, kernel) in &self.equations.loads {
            let _ = writeln!(text, "{index} => {}(&self.model, t, &mut value),", kernel.name);
        }
        text + "_ => {}\n}\nvalue\n}\n"
    }

    /// What the scene is asked for; `None` for reductions, which ask for several.
    pub(super) fn observed_spec(&self, observable: &Observable) -> Option<String> {
        let spec = match observable {
            Observable::Reduced { .. } => return None,
            Observable::Point {
                body,
                at,
                what,
                component,
            } => {
                let what = match what {
                    PointQuantity::Position => "Position",
                    PointQuantity::Velocity => "Velocity",
                    PointQuantity::Slope => "Slope",
                    PointQuantity::SectionY => "SectionY",
                    PointQuantity::SectionZ => "SectionZ",
                };
                format!(
                    "Point {{ body: {}, at: {}, what: ::rncf::emitted::PointQuantity::{what}, component: {component} }}",
                    self.body_at(*body, at),
                    self.place(at)
                )
            }
            Observable::Marker {
                marker,
                derivative,
                component,
            } => {
                format!(
                    "Marker {{ marker: {}, derivative: {derivative}, component: {component} }}",
                    marker.0
                )
            }
            Observable::ConstraintReaction {
                constraint,
                moment,
                component,
            } => {
                format!(
                    "ConstraintReaction {{ constraint: {}, moment: {moment}, component: {component} }}",
                    constraint.0
                )
            }
            Observable::Balance { of, what, component } => {
                let what = match what {
                    BalanceQuantity::AngularMomentum(about) => {
                        let about = match about {
                            About::Origin => "Origin".to_string(),
                            About::Marker(marker) => format!("Marker({})", marker.0),
                            About::CenterOf(of) => format!("CenterOf({})", self.owner(*of)),
                        };
                        format!("AngularMomentum(::rncf::emitted::About::{about})")
                    }
                    what => format!("{what:?}"),
                };
                let of = self.owner(*of);
                format!(
                    "Balance {{ of: {of}, what: ::rncf::emitted::BalanceQuantity::{what}, component: {component} }}"
                )
            }
            Observable::Multiplier { constraint, row } => {
                format!("Multiplier {{ constraint: {}, row: {row} }}", constraint.0)
            }
            Observable::Section { body, at, what } => {
                format!(
                    "Section {{ body: {}, at: {}, what: ::rncf::emitted::SectionQuantity::{what:?} }}",
                    self.body_at(*body, at),
                    self.place(at)
                )
            }
            Observable::Reaction {
                joint,
                moment,
                component,
            } => {
                format!(
                    "Reaction {{ joint: {}, moment: {moment}, component: {component} }}",
                    self.first_of_joint(*joint)
                )
            }
        };
        Some(format!("::rncf::emitted::ObservedSpec::{spec}"))
    }

    fn owner(&self, of: Owner) -> String {
        let of = match of {
            Owner::All => "All".to_string(),
            Owner::Body(body) => format!("Body({})", self.first_of(body)),
            Owner::Frame(frame) => format!("Frame({})", frame.0),
        };
        format!("::rncf::emitted::Owner::{of}")
    }

    fn facts(&self) -> String {
        let names: Vec<&String> = self.model.frames.iter().map(|frame| &frame.name).collect();
        let columns: usize = self.model.outputs.iter().map(|output| output.components.len()).sum();
        let kinks = self.kinks();
        format!(
            "fn output_columns(&self) -> usize {{ {columns} }}\n\
             fn frame_count(&self) -> usize {{ {} }}\n\
             fn frame_name(&self, frame: usize) -> &'static str {{ {names:?}[frame] }}\n\
             fn conservative(&self) -> bool {{ {} }}\n{kinks}{}{}",
            names.len(),
            self.equations.conservative,
            self.gaps(),
            self.courses()
        )
    }

    /// The method that tells times of switches and rows of tables.
    fn kinks(&self) -> String {
        let switches = &self.equations.switches;
        let mut lists = switches.rows.clone();
        let mut times = String::new();
        if lists.iter().any(|list| list.starts_with("model.")) {
            times += "let model = &self.model;\n";
        }
        if switches.kinks.1 > 0 {
            let _ = writeln!(
                times,
                "let mut times = [0.0; {}];\nkinks(&self.model, &mut times);",
                switches.kinks.1
            );
            lists.insert(0, "times.to_vec()".to_string());
        }
        times += &match &lists[..] {
            [] => "::std::vec::Vec::new()".to_string(),
            [list] => list.clone(),
            _ => format!("[{}].concat()", lists.join(", ")),
        };
        format!("fn kinks(&self) -> ::std::vec::Vec<f64> {{\n{times}\n}}\n")
    }

    /// The method that adds up conditions whose switches are no times known beforehand.
    fn gaps(&self) -> String {
        let switches = &self.equations.switches;
        let mut body = String::new();
        let count = switches.gaps.1;
        if count > 0 {
            body += &format!(
                "let mut found = [[0.0; 2]; {count}];\ngaps(&self.model, t, &mut found);\nout.extend(found);\n"
            );
        }
        for (repeat, kernel, count) in &switches.repeated {
            body += &format!(
                "for instance in 0..self.counts[{}] {{\nlet mut found = [[0.0; 2]; {count}];\n{}(&self.model, t, instance as f64, &mut found);\nout.extend(found);\n}}\n",
                repeat.0, kernel.name
            );
        }
        format!("fn gaps(&self, t: f64, out: &mut ::std::vec::Vec<[f64; 2]>) {{\n{body}}}\n")
    }

    /// One arm for each body; the last one takes the rest.
    pub fn by_body(&self, arm: impl Fn(usize, &Body) -> String) -> String {
        let last = match &self.model.bodies[..] {
            [] => return String::new(),
            [body] => return arm(0, body) + "\n",
            bodies => bodies.len() - 1,
        };
        let arms = self.model.bodies.iter().enumerate().map(|(index, body)| {
            let pattern = if index == last {
                "_".to_string()
            } else {
                index.to_string()
            };
            format!("{pattern} => {{\n{}\n}}\n", arm(index, body))
        });
        format!("match body {{\n{}}}\n", arms.collect::<String>())
    }

    /// The element variant of a body.
    pub fn variant(&self, body: usize) -> &crate::lower::VariantKernels {
        &self.equations.variants[self.equations.variant_of[body]]
    }

    fn prepare(&self) -> String {
        let arms = self.by_body(|index, body| {
            let variant = self.variant(index);
            if variant.variant.varying {
                return self.prepare_varying(index, body);
            }
            let element = variant.variant.declaration(self.library);
            let mut text = "let length = nodes[1] - nodes[0];\n".to_string();
            text += self.index(body);
            text += &self.properties(body);
            text += self.at_start(body);
            let mut fields = vec!["length".to_string()];
            for coefficient in variant.variant.coefficients(self.library) {
                fields.push(format!("{}: {}", coefficient.name, self.coefficient(body, coefficient)));
            }
            if variant.variant.damped {
                fields.push(format!("damping: {}", element.damping));
            }
            if let Some(material) = &variant.variant.material {
                text += &super::points::material_constants(&variant.name, material);
                fields.extend(super::points::material_values(material, body, |expr| self.expr(expr)));
            }
            let row = format!("{} {{ {} }}", camel_case(&variant.name), fields.join(", "));
            text += &self.keep(body, "row", &row);
            if let Some(kernel) = &variant.elastic.reference {
                let size = variant.variant.size(self.library);
                let reference = format!(
                    "shape.chunks_exact({size}).map(|shape| {{\nlet mut reference = [0.0; {}];\n{}(&{}, ::rncf::emitted::array(shape), &mut reference);\nreference\n}}).collect()",
                    variant.elastic.kept,
                    kernel.name,
                    self.row(body)
                );
                text += &self.keep(body, "reference", &reference);
            }
            text
        });
        let kind = self.kind();
        format!(
            "fn prepare(&mut self, body: usize, nodes: &[f64], shape: &[f64]) -> ::std::result::Result<(), ::rncf::ModelError> {{\n{kind}let model = &self.model;\n{arms}Ok(())\n}}\n"
        )
    }

    /// Keeps constants of a body; bodies are prepared one repetition after the other.
    pub(super) fn keep(&self, body: &Body, what: &str, value: &str) -> String {
        let place = format!("self.{what}_{}", body.identifier());
        match body.repeat {
            Some(_) => format!("let {what} = {value};\n{place}.truncate(instance);\n{place}.push({what});\n"),
            None => format!("{place} = {value};\n"),
        }
    }

    fn time_functions(&self) -> String {
        let mut text = "fn frames(&self, t: f64, motions: &mut [::rncf::emitted::FrameMotion]) {\nmotions[0] = ::rncf::emitted::FrameMotion::INERTIAL;\n".to_string();
        for (index, kernel) in &self.equations.frames {
            let _ = writeln!(text, "{}(&self.model, t, &mut motions[{index}]);", kernel.name);
        }
        text += "}\n";
        text + &self.outputs()
    }

    /// What moments do to slopes, and to the axes of sections.
    fn moments(&self) -> [String; 2] {
        let mut slopes = String::new();
        let on_slopes = [(0, "moment", "force"), (1, "moment_tangent", "tangent")].into_iter();
        for (which, name, argument) in on_slopes.filter(|_| !self.equations.moments.is_empty()) {
            let arms: String = self
                .equations
                .moments
                .iter()
                .map(|(dimension, kernels)| {
                    format!("{dimension} => {}(slope, moment, {argument}),\n", kernels[which].name)
                })
                .collect();
            let _ = writeln!(
                slopes,
                "fn {name}(&self, dimension: usize, slope: &[f64], moment: [f64; 3], {argument}: &mut [f64]) {{\nmatch dimension {{\n{arms}_ => {{}}\n}}\n}}"
            );
        }
        let sections = self.equations.section_moments.as_ref().map(|[force, tangent]| {
            format!(
                "fn section_moment(&self, axes: &[f64; 6], moment: [f64; 3], force: &mut [f64; 6]) {{\n{}(axes, moment, force);\n}}\n\
                 fn section_moment_tangent(&self, axes: &[f64; 6], moment: [f64; 3], tangent: &mut [f64; 36]) {{\n{}(axes, moment, tangent);\n}}\n",
                force.name, tangent.name
            )
        });
        [slopes, sections.unwrap_or_default()]
    }

    /// Dispatch over joints and formulations.
    fn by_joint(&self, call: impl Fn(&crate::lower::joints::JointKernels) -> String) -> String {
        let mut arms = String::new();
        for (index, (referenced, absolute)) in self.equations.joints.iter().enumerate() {
            if let Some(kernels) = referenced {
                let _ = writeln!(arms, "({index}, false) => {{ {} }}", call(kernels));
            }
            if let Some(kernels) = absolute {
                // Where the body's frame moves freely, nothing is known in it of a prescribed one.
                let body = self.model.joints[index].body;
                let unknown = referenced.is_none() && self.model.bodies[body.0].frame != INERTIAL;
                let absolute = if unknown { "true" } else { "_" };
                let _ = writeln!(arms, "({index}, {absolute}) => {{ {} }}", call(kernels));
            }
        }
        format!("match (joint, absolute) {{\n{arms}_ => {{}}\n}}\n")
    }

    fn conditions(&self) -> String {
        let condition = self.by_joint(|kernels| {
            let levels = kernels.levels.iter().zip(LEVELS).filter_map(|(kernel, level)| {
                let name = &kernel.as_ref()?.name;
                let level = camel_case(level);
                Some(format!(
                    "::rncf::emitted::ConstraintLevel::{level} => {name}(&self.model, t, data, q, v, a, rows),\n"
                ))
            });
            let rest = if kernels.levels.iter().all(Option::is_some) {
                ""
            } else {
                "_ => {}\n"
            };
            format!("match level {{\n{}{rest}}}", levels.collect::<String>())
        });
        let jacobian = self.by_joint(|kernels| format!("{}(&self.model, t, data, jacobian);", kernels.jacobian.name));
        let prescribed =
            self.by_joint(|kernels| format!("{}(&self.model, t, data, prescribed);", kernels.prescribed.name));
        let of = self.of_joint();
        format!(
            "fn condition(&self, joint: usize, absolute: bool, level: ::rncf::emitted::ConstraintLevel, t: f64, data: &::rncf::emitted::JointData, q: &[f64], v: &[f64], a: &[f64], rows: &mut [f64]) {{\n{of}{condition}}}\n\
             fn condition_jacobian(&self, joint: usize, absolute: bool, t: f64, data: &::rncf::emitted::JointData, jacobian: &mut [f64]) {{\n{of}{jacobian}}}\n\
             fn prescribed(&self, joint: usize, absolute: bool, t: f64, data: &::rncf::emitted::JointData, prescribed: &mut ::rncf::emitted::Prescribed) {{\n{of}{prescribed}}}\n"
        )
    }
}
