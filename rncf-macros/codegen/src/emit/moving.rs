//! The methods of `Parts` for what moves freely: free frames, markers with their constraints and
//! forces, and fixtures. A model without any of these gets
//! none of them.

use std::fmt::Write;

use super::courses;
use super::expression::inline;
use super::parts::Parts;
use crate::lower::Kernel;
use crate::lower::branches;
use crate::lower::camel_case;
use crate::lower::constraints::ConstraintKernels;
use crate::lower::joints::LEVELS;
use crate::model::fold;
use crate::model::{Expr, ForceKind, Marker, Model, Motions};

const VECTORS: &str = "&[::rncf::emitted::Vector]";

/// The last arm, and all of a function that need not be written.
const NOTHING: &str = "_ => {}\n";

/// Formulas longer than this are not repeated in the documentation.
const LONGEST_FORMULA: usize = 250;

/// Adds to the documentation what each row of a constraint fixes, and by which formula.
pub(super) fn document_rows(kernels: &mut ConstraintKernels, model: &Model) {
    let kernel = &mut kernels.levels[0];
    let rows = model.constraints[kernels.of[0]].rows.iter().zip(&kernel.outputs);
    let lines = rows.map(|((what, _), &(_, id))| {
        let formula = inline(&kernel.graph, id);
        if formula.len() > LONGEST_FORMULA {
            format!("* {what}")
        } else {
            format!("* {what}: `{formula}`")
        }
    });
    let lines: Vec<String> = lines.collect();
    kernel.doc.push(lines.join("\n"));
}

/// `0 | 2 | 5` for the indices that share a function.
fn pattern(of: &[usize]) -> String {
    of.iter().map(usize::to_string).collect::<Vec<_>>().join(" | ")
}

/// Arms that call one kernel each, and a last one that does nothing.
fn arms<'k>(kernels: impl Iterator<Item = (&'k [usize], &'k Kernel)>, arguments: &str) -> String {
    let arm = |(of, kernel): (&[usize], &Kernel)| format!("{} => {}({arguments}),\n", pattern(of), kernel.name);
    kernels.map(arm).collect::<String>() + NOTHING
}

/// A choice among arms; nothing where they do nothing.
fn dispatch(of: &str, arms: &str) -> String {
    if arms == NOTHING {
        return String::new();
    }
    format!("match {of} {{\n{arms}}}\n")
}

impl Parts<'_> {
    /// Checks of rigid parts that depend on parameters; constants are checked already.
    pub fn check(&self) -> String {
        let mut checks = self.loop_checks();
        checks += &self.section_checks();
        for frame in &self.model.frames {
            let Some(free) = &frame.free else { continue };
            if let Some(size) = &free.size {
                checks += &self.number_check("positive", &format!("state `{}`", frame.name), "size", size, "");
            }
            for (place, part) in free.parts.iter().enumerate() {
                let owner = if free.is_body && place == 0 {
                    "rigid body"
                } else {
                    "fixture"
                };
                let owner = format!("{owner} `{}`", part.name);
                let mass = if place == 0 && free.is_body {
                    "positive"
                } else {
                    "non_negative"
                };
                checks += &self.number_check(mass, &owner, "mass", &part.mass, "kg");
                match free.motions {
                    Motions::Planar { normal } => {
                        checks +=
                            &self.number_check("non_negative", &owner, "inertia", &part.inertia[normal], "kg*m^2");
                    }
                    Motions::Shifting | Motions::ShiftingPlanar { .. } => {}
                    _ if part.inertia.iter().all(|expr| fold::constant(expr).is_some()) => {}
                    _ => {
                        let entries = part.inertia.each_ref().map(|expr| self.expr(expr)).join(", ");
                        let _ = writeln!(checks, "::rncf::emitted::inertia({owner:?}, [{entries}])?;");
                    }
                }
            }
        }
        for fixture in &self.model.fixtures {
            let owner = format!("fixture `{}`", fixture.name);
            let check = self.number_check("non_negative", &owner, "mass", &fixture.constants[0], "kg");
            checks += &self.in_loop(fixture.repeat.filter(|_| !check.is_empty()), &check);
        }
        format!(
            "fn check(&self) -> ::std::result::Result<(), ::rncf::ModelError> {{\nlet model = &self.model;\n{checks}Ok(())\n}}\n"
        )
    }

    fn number_check(&self, function: &str, owner: &str, name: &str, value: &Expr, unit: &str) -> String {
        if fold::constant(value).is_some() {
            return String::new();
        }
        let value = self.expr(value);
        format!("::rncf::emitted::{function}({owner:?}, {name:?}, {value}, {unit:?})?;\n")
    }

    /// Free frames.
    pub fn free(&self) -> String {
        if self.equations.free.is_empty() {
            return self.list("free", "FreeSpec", &[]);
        }
        let mut text = "fn free(&self) -> ::std::vec::Vec<::rncf::emitted::FreeSpec> {\nlet still = ::rncf::emitted::FreeSpec { frame: 0, parent: 0, is_body: false, motions: ::rncf::emitted::Motions::Spatial, position: ::rncf::emitted::Vector::zeros(), axis: ::rncf::emitted::Vector::zeros(), angle: 0.0, velocity: ::rncf::emitted::Vector::zeros(), spin: ::rncf::emitted::Vector::zeros(), rigid: ::rncf::emitted::RigidSpec::default(), size: 1.0 };\nlet mut specs = ::std::vec::Vec::from([\n".to_string();
        for &(index, _) in &self.equations.free {
            let frame = &self.model.frames[index];
            if let Some(free) = &frame.free {
                let _ = writeln!(
                    text,
                    "::rncf::emitted::FreeSpec {{ frame: {index}, parent: {}, is_body: {}, motions: ::rncf::emitted::Motions::{}, ..still.clone() }},",
                    frame.parent.0,
                    free.is_body,
                    motions(&free.motions)
                );
            }
        }
        text += "]);\n";
        for (place, (_, kernel)) in self.equations.free.iter().enumerate() {
            let _ = writeln!(text, "{}(&self.model, &mut specs[{place}]);", kernel.name);
        }
        text + "specs\n}\n"
    }

    /// Initial shapes and rates.
    pub fn initial(&self) -> String {
        if self.equations.initial.is_empty() {
            return "fn initial(&self, body: usize, x: f64) -> [::std::option::Option<[[f64; 3]; 2]>; 2] { [None, None] }\n".to_string();
        }
        let mut arms = String::new();
        for (index, kernel) in &self.equations.initial {
            let body = &self.model.bodies[*index];
            let initial = &body.initial;
            let given = |is_given: bool, name: &str| {
                if is_given {
                    format!("Some({name})")
                } else {
                    "None".to_string()
                }
            };
            let _ = writeln!(
                arms,
                "{index} => {{\n{}(&self.model, x, {}&mut position, &mut velocity);\n[{}, {}]\n}}",
                kernel.name,
                if body.repeat.is_some() { "instance as f64, " } else { "" },
                given(initial.position.is_some(), "position"),
                given(initial.velocity.is_some(), "velocity"),
            );
        }
        let kind = self.kind();
        format!(
            "fn initial(&self, body: usize, x: f64) -> [::std::option::Option<[[f64; 3]; 2]>; 2] {{\n{kind}let mut position = [[0.0; 3]; 2];\nlet mut velocity = [[0.0; 3]; 2];\nmatch body {{\n{arms}_ => [None, None],\n}}\n}}\n"
        )
    }

    /// Markers.
    pub fn markers(&self) -> String {
        let marker = |marker: &Marker| match marker {
            Marker::Point { frame, at } => format!("Point {{ frame: {}, at: {} }}", frame.0, self.vector(at)),
            Marker::Direction { frame, along } => {
                format!("Direction {{ frame: {}, along: {} }}", frame.0, self.vector(along))
            }
            Marker::BodyPoint { body, at } => format!(
                "BodyPoint {{ body: {}, at: {} }}",
                self.body_at(*body, at),
                self.place(at)
            ),
            Marker::SectionPoint { body, at, beside } => format!(
                "SectionPoint {{ body: {}, at: {}, beside: {} }}",
                self.body_at(*body, at),
                self.place(at),
                self.array(beside)
            ),
            Marker::BodySlope { body, at } => format!(
                "BodySlope {{ body: {}, at: {} }}",
                self.body_at(*body, at),
                self.place(at)
            ),
            Marker::BodySection { body, at, axis } => {
                format!(
                    "BodySection {{ body: {}, at: {}, axis: {axis} }}",
                    self.body_at(*body, at),
                    self.place(at)
                )
            }
            Marker::InSection { body, at, marker } => {
                format!(
                    "InSection {{ body: {}, at: {}, marker: {} }}",
                    self.body_at(*body, at),
                    self.place(at),
                    marker.0
                )
            }
            Marker::SectionTurn { body, at } => format!(
                "SectionTurn {{ body: {}, at: {} }}",
                self.body_at(*body, at),
                self.place(at)
            ),
            Marker::Turn { frame } => format!("Turn {{ frame: {} }}", frame.0),
            Marker::Angle { frame } => format!("Angle {{ frame: {} }}", frame.0),
            Marker::Matching { frame, marker } => {
                format!("Matching {{ frame: {}, marker: {} }}", frame.0, marker.0)
            }
            Marker::Normal { frame, marker, which } => {
                format!("Normal {{ frame: {}, marker: {}, which: {which} }}", frame.0, marker.0)
            }
        };
        let entries = self
            .model
            .markers
            .iter()
            .map(|entry| (None, format!("::rncf::emitted::MarkerSpec::{}", marker(entry))));
        self.list("markers", "MarkerSpec", &entries.collect::<Vec<_>>())
    }

    /// Constraints and their functions.
    pub fn constraints(&self) -> String {
        if self.model.constraints.is_empty() {
            return String::new();
        }
        let entries = self.model.constraints.iter().enumerate().map(|(index, constraint)| {
            let kernels = self.equations.constraints.iter().find(|kernels| kernels.of.contains(&index));
            let coupled = kernels.map_or(&[][..], |kernels| &kernels.coupled);
            let is_of_differences = kernels.is_some_and(|kernels| kernels.of_differences.contains(&index));
            let rows: Vec<&String> = constraint.rows.iter().map(|(what, _)| what).collect();
            let markers: Vec<usize> = constraint.markers.iter().map(|marker| marker.0).collect();
            let when = match constraint.absolute {
                None => "Always".to_string(),
                Some(body) => format!("Absolute({})", self.first_of(body)),
            };
            let entry = format!(
                "::rncf::emitted::ConstraintSpec {{ name: {:?}, kind: {:?}, rows: &{rows:?}, markers: &{markers:?}, coupled: &{coupled:?}, of_differences: {is_of_differences}, first_party: {}, branches: {}, when: ::rncf::emitted::When::{when} }}",
                constraint.name, constraint.kind, constraint.first_party, branches::count(kernels.and_then(|kernels| kernels.branches.as_ref()))
            );
            (None, entry)
        });
        let mut text = self.list("constraints", "ConstraintSpec", &entries.collect::<Vec<_>>());
        let kernels = &self.equations.constraints;
        let levels = kernels.iter().map(|constraint| {
            let levels = constraint.levels.iter().zip(LEVELS).map(|(kernel, level)| {
                format!(
                    "::rncf::emitted::ConstraintLevel::{} => {}(&self.model, t, z, rows),\n",
                    camel_case(level),
                    kernel.name
                )
            });
            format!(
                "{} => match level {{\n{}}},\n",
                pattern(&constraint.of),
                levels.collect::<String>()
            )
        });
        let _ = writeln!(
            text,
            "fn marker_constraint(&self, constraint: usize, level: ::rncf::emitted::ConstraintLevel, t: f64, z: &[[::rncf::emitted::Vector; 4]], rows: &mut [f64]) {{\nmatch constraint {{\n{}_ => {{}}\n}}\n}}",
            levels.collect::<String>()
        );
        let gradient = arms(
            kernels.iter().map(|k| (&k.of[..], &k.gradient)),
            "&self.model, t, z, gradient",
        );
        let _ = writeln!(
            text,
            "fn marker_constraint_gradient(&self, constraint: usize, t: f64, z: {VECTORS}, gradient: &mut [f64]) {{\ngradient.fill(0.0);\nmatch constraint {{\n{gradient}}}\n}}"
        );
        let rate = kernels
            .iter()
            .filter_map(|k| Some((&k.of[..], k.rate_gradient.as_ref()?)));
        let rate = arms(rate, "&self.model, t, z, velocity, gradient");
        let _ = writeln!(
            text,
            "fn marker_constraint_rate_gradient(&self, constraint: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, gradient: &mut [f64]) {{\ngradient.fill(0.0);\n{}}}",
            dispatch("constraint", &rate)
        );
        let angles = kernels.iter().filter_map(|k| Some((&k.of[..], k.branches.as_ref()?)));
        let angles = arms(angles, "&self.model, t, z, out");
        let _ = writeln!(
            text,
            "fn marker_constraint_branches(&self, constraint: usize, t: f64, z: {VECTORS}, out: &mut [f64]) {{\n{}}}",
            dispatch("constraint", &angles)
        );
        let hessian = kernels.iter().filter_map(|k| Some((&k.of[..], k.hessian.as_ref()?)));
        let hessian = arms(hessian, "&self.model, t, z, lambda, hessian");
        let _ = writeln!(
            text,
            "fn marker_constraint_hessian(&self, constraint: usize, t: f64, z: {VECTORS}, lambda: &[f64], hessian: &mut [f64]) {{\nhessian.fill(0.0);\n{}}}",
            dispatch("constraint", &hessian)
        );
        text
    }

    /// Forces on markers and their functions.
    pub fn forces(&self) -> String {
        if self.model.forces.is_empty() {
            return String::new();
        }
        let entries = self.model.forces.iter().enumerate().map(|(index, force)| {
            let kernels = self.equations.forces.iter().find(|kernels| kernels.of.contains(&index));
            let markers: Vec<usize> = force.markers.iter().map(|marker| marker.0).collect();
            let entry = format!(
                "::rncf::emitted::ForceSpec {{ name: {:?}, markers: &{markers:?}, conservative: {}, of_differences: {}, branches: {} }}",
                force.name,
                force.energy.is_some(),
                kernels.is_some_and(|kernels| kernels.of_differences.contains(&index)),
                branches::count(kernels.and_then(|kernels| kernels.branches.as_ref()))
            );
            (None, entry)
        });
        let mut text = self.list("forces", "ForceSpec", &entries.collect::<Vec<_>>());
        let loads = self
            .model
            .forces
            .iter()
            .enumerate()
            .filter(|(_, force)| force.kind == ForceKind::Load);
        let loads: Vec<String> = loads.map(|(index, _)| index.to_string()).collect();
        let is_load = match loads.is_empty() {
            true => "false".to_string(),
            false => format!("matches!(force, {})", loads.join(" | ")),
        };
        let _ = writeln!(text, "fn is_load(&self, force: usize) -> bool {{ {is_load} }}");
        let kernels = &self.equations.forces;
        let force = arms(
            kernels.iter().map(|k| (&k.of[..], &k.force)),
            "&self.model, t, z, velocity, out",
        );
        let _ = writeln!(
            text,
            "fn marker_force(&self, force: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, out: &mut [f64]) {{\nout.fill(0.0);\nmatch force {{\n{force}}}\n}}"
        );
        let tangent = kernels.iter().filter_map(|k| Some((&k.of[..], k.tangent.as_ref()?)));
        let tangent = arms(tangent, "&self.model, t, z, velocity, by_value, by_velocity");
        let _ = writeln!(
            text,
            "fn marker_force_tangent(&self, force: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, by_value: &mut [f64], by_velocity: &mut [f64]) {{\nby_value.fill(0.0);\nby_velocity.fill(0.0);\n{}}}",
            dispatch("force", &tangent)
        );
        let angles = kernels.iter().filter_map(|k| Some((&k.of[..], k.branches.as_ref()?)));
        let angles = arms(angles, "&self.model, t, z, velocity, out");
        let _ = writeln!(
            text,
            "fn marker_force_branches(&self, force: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, out: &mut [f64]) {{\n{}}}",
            dispatch("force", &angles)
        );
        text += &courses::of_forces(self.model, kernels);
        let energy = kernels.iter().filter_map(|k| Some((&k.of[..], k.energy.as_ref()?)));
        let energy = arms(energy, "&self.model, t, z, &mut energy");
        let energy = match energy == NOTHING {
            true => "0.0\n".to_string(),
            false => format!("let mut energy = 0.0;\nmatch force {{\n{energy}}}\nenergy\n"),
        };
        let _ = writeln!(
            text,
            "fn marker_energy(&self, force: usize, t: f64, z: {VECTORS}) -> f64 {{\n{energy}}}"
        );
        text
    }

    /// Fixtures of flexible bodies.
    pub fn fixtures(&self) -> String {
        let entries = self.model.fixtures.iter().map(|fixture| {
            let entry = format!(
                "::rncf::emitted::FixtureSpec {{ name: {:?}, body: {}, at: {}, constants: {}, elastic: {} }}",
                fixture.name,
                self.body_at(fixture.body, &fixture.at),
                self.place(&fixture.at),
                self.array(&fixture.constants),
                fixture.elastic
            );
            (fixture.repeat, entry)
        });
        self.list("fixtures", "FixtureSpec", &entries.collect::<Vec<_>>())
    }
}

fn motions(motions: &Motions) -> String {
    match motions {
        Motions::Spatial => "Spatial".to_string(),
        Motions::Planar { normal } => format!("Planar {{ normal: {normal} }}"),
        Motions::Turning => "Turning".to_string(),
        Motions::Hinged { axis } => {
            let size = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            let [x, y, z] = axis.map(|x| x / size);
            format!("Hinged {{ axis: ::rncf::emitted::Vector::new({x:?}, {y:?}, {z:?}) }}")
        }
        Motions::Shifting => "Shifting".to_string(),
        Motions::ShiftingPlanar { normal } => format!("ShiftingPlanar {{ normal: {normal} }}"),
        Motions::State => "State".to_string(),
    }
}
