//! Bodies from files of finite-element programs: what of them can be checked at the word.

use std::collections::BTreeMap;

use super::body::{Known, is_imported};
use crate::check::values::scope::Scope;
use crate::check::values::table::PATHS_BEGIN;
use crate::check::values::words::balance_words;
use crate::check::{Check, fold, say};
use crate::elements::BETWEEN_INTERFACES;
use crate::errors::Area;
use crate::import::hash::hash_on;
use crate::import::{File, FiniteElements, bytes};
use crate::model::{
    Body, BodyId, ElementId, Evaluation, Expr as Value, Fidelity, FrameTie, Imported, Initial, Line, Location,
    Quadrature, SectionShape,
};
use crate::parse::tree::{Item, ItemKind, Keyword, Name, Statement};
use crate::suggest;
use crate::units;

/// Words of the units that a file may have, length, mass and time, and their dimensions.
const UNITS: [(&str, [i8; 6]); 3] = [
    ("length", [1, 0, 0, 0, 0, 0]),
    ("mass", [0, 1, 0, 0, 0, 0]),
    ("time", [0, 0, 1, 0, 0, 0]),
];

/// A property of what has none: products of these numbers vanish beside all others.
const NOTHING: f64 = 1e-100;

/// Files that have been read.
struct Source {
    files: Vec<String>,
    /// Of all bytes of the files.
    hash: u64,
    /// Of length, mass and time in SI.
    units: [f64; 3],
    /// Of the interfaces, m.
    places: Vec<[f64; 3]>,
}

impl<'a> Check<'a> {
    pub(in crate::check) fn imported(&mut self, item: &'a Item, statements: &'a [Statement], known: Known) {
        self.bodies.insert(item.name.text.as_str(), known);
        let before = self.errors.len();
        self.read_import(item, statements, known);
        if self.errors.len() > before {
            // That nothing holds it, too, is no help.
            self.note_held(known.id);
        }
    }

    fn read_import(&mut self, item: &'a Item, statements: &'a [Statement], known: Known) {
        if item.repeat.is_some() {
            self.errors.at(item.name.span, say::IMPORT_REPEATED);
            return;
        }
        let before = self.errors.len();
        for statement in statements {
            let (area, word) = match statement {
                Statement::Space { plane: None, .. }
                | Statement::Import { .. }
                | Statement::Interface { .. }
                | Statement::InterfaceModes { .. }
                | Statement::Damping { .. }
                | Statement::Piece { .. }
                | Statement::Fidelity { .. } => continue,
                Statement::Space { area, .. } => (*area, "planar"),
                Statement::Line { area, .. } => (*area, "line"),
                Statement::Arc { area, .. } => (*area, "arc"),
                Statement::Curve { area, .. } | Statement::Path { area, .. } => (*area, "curve"),
                Statement::SectionY { area, .. } => (*area, "section_y"),
                Statement::Twist { area, .. } => (*area, "twist"),
                Statement::Mesh { area, .. } => (*area, "mesh"),
                Statement::Initial { area, .. } => (*area, "initial"),
                Statement::FrameTie { word } => (Area::from(word.span), word.text.as_str()),
            };
            self.errors.at(area, say::not_imported(word, &item.name.text));
        }
        let fidelity = match self.fidelity(statements) {
            Some(Fidelity::Full) => {
                self.errors
                    .at(item.name.span, say::import_without_modes(&item.name.text));
                return;
            }
            other => other,
        };
        let damping = self.import_damping(statements);
        let interfaces = self.interfaces(item, statements);
        let files = self.import_files(item, statements, interfaces.as_deref().unwrap_or(&[]));
        let (Some(frame), Some(fidelity), Some(damping), Some(interfaces), Some(source)) =
            (known.frame, fidelity, damping, interfaces, files)
        else {
            return;
        };
        if self.errors.len() > before {
            return;
        }
        let Some(element) = self.library.find(BETWEEN_INTERFACES) else {
            return;
        };
        let number = |value| Value::Number(value);
        // No mass and no stiffness in any sum, and yet the positive numbers that an element must have.
        let mut properties = BTreeMap::from(["young", "density", "area"].map(|name| (name, number(NOTHING))));
        properties.insert("damping", number(0.0));
        self.model.bodies.push(Body {
            repeat: None,
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            frame,
            space: crate::model::Space::Spatial,
            line: Line::Imported(Imported {
                files: source.files,
                hash: source.hash,
                units: source.units,
                places: source.places,
                interfaces: interfaces
                    .into_iter()
                    .map(|(name, nodes)| (name.text.clone(), nodes.iter().map(|(id, _)| *id).collect()))
                    .collect(),
                keeps_interfaces: statements
                    .iter()
                    .any(|one| matches!(one, Statement::InterfaceModes { .. })),
                damping,
            }),
            count: number(1.0),
            element: ElementId(element),
            options: Vec::new(),
            material_name: String::new(),
            section_name: String::new(),
            properties,
            law: None,
            stations: None,
            piece: None,
            quadrature: Quadrature::Exact,
            evaluation: Evaluation::Automatic,
            fidelity,
            strain_energy: None,
            shape: SectionShape::default(),
            section_y: None,
            twist: number(0.0),
            tie: FrameTie::Joints,
            initial: Initial::default(),
        });
    }

    /// Part of critical damping, or a time.
    fn import_damping(&mut self, statements: &'a [Statement]) -> Option<[Value; 2]> {
        let none = || Value::Number(0.0);
        let mut found: Option<([Value; 2], usize)> = None;
        for statement in statements {
            let Statement::Damping { area, value } = statement else {
                continue;
            };
            if let Some((_, line)) = found {
                self.errors
                    .at(*area, say::duplicate_statement("`damping`", &line.to_string()));
                return None;
            }
            let typed = self.expr(value, Scope::Parameter)?;
            let both = match typed.dimension.exponents(false) {
                Some([0, 0, 0, 0, 0, 0]) => [typed.value, none()],
                Some([0, 0, 1, 0, 0, 0]) => [none(), typed.value],
                _ => {
                    self.errors.at(value.area, say::import_damping(&typed.describe()));
                    return None;
                }
            };
            if both
                .iter()
                .filter_map(fold::constant)
                .any(|value| value.is_nan() || value < 0.0)
            {
                self.errors.at(value.area, say::NEGATIVE_DAMPING);
                return None;
            }
            found = Some((both, area.line()));
        }
        Some(found.map_or([none(), none()], |(both, _)| both))
    }

    #[allow(clippy::type_complexity)] // a list of names with their nodes
    fn interfaces(&mut self, item: &Item, statements: &'a [Statement]) -> Option<Vec<(&'a Name, &'a [(u64, Area)])>> {
        let before = self.errors.len();
        let mut found: Vec<(&Name, &[(u64, Area)])> = Vec::new();
        let mut seen: Vec<u64> = Vec::new();
        for statement in statements {
            let Statement::Interface { name, nodes } = statement else {
                continue;
            };
            let text = name.text.as_str();
            if balance_words().any(|word| word == text) {
                self.errors.at(name.span, say::meaning_of_its_own(text));
            }
            if let Some((first, _)) = found.iter().find(|(other, _)| other.text == text) {
                let line = first.line().to_string();
                self.errors.at(
                    name.span,
                    say::duplicate_statement(&format!("interface `{text}`"), &line),
                );
            }
            for (id, area) in nodes {
                if seen.contains(id) {
                    self.errors.at(*area, say::node_twice(&id.to_string()));
                }
                seen.push(*id);
            }
            found.push((name, nodes));
        }
        if found.is_empty() {
            let missing = "its interfaces: `interface root = node 1;`";
            self.errors
                .at(item.name.span, say::missing_statement(&item.name.text, missing));
        }
        (self.errors.len() == before).then_some(found)
    }

    /// Paths and units of the files, which have been read: they are whole, and have the nodes of the interfaces.
    fn import_files(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        interfaces: &[(&'a Name, &'a [(u64, Area)])],
    ) -> Option<Source> {
        let mut all = statements.iter().filter_map(|statement| match statement {
            Statement::Import { area, files, units } => Some((*area, files, units)),
            _ => None,
        });
        let Some((area, files, units)) = all.next() else {
            let missing = "its file: `import \"panel.npz\";`";
            self.errors
                .at(item.name.span, say::missing_statement(&item.name.text, missing));
            return None;
        };
        for (other, ..) in all {
            self.errors
                .at(other, say::duplicate_statement("`import`", &area.line().to_string()));
        }
        let units = match units {
            Some((names, area)) => self.import_units(names, *area)?,
            None => [1.0; 3],
        };
        let mut contents = Vec::new();
        for (path, area) in files {
            match bytes(&self.tree.folder.join(path), PATHS_BEGIN) {
                Ok(bytes) => contents.push(bytes),
                Err(error) => {
                    self.errors.at(*area, say::unreadable_file(path, &error));
                    return None;
                }
            }
        }
        let whole: Vec<File> = files
            .iter()
            .zip(&contents)
            .map(|((path, _), bytes)| File { path, bytes })
            .collect();
        let elements = match FiniteElements::read(&whole) {
            Ok(elements) => elements,
            Err(what) => {
                self.errors.at(files[0].1, say::import_wrong(&what));
                return None;
            }
        };
        let mut is_whole = true;
        for (id, area) in interfaces.iter().flat_map(|(_, nodes)| *nodes) {
            if elements.find(*id).is_none() {
                let near = elements.ids.iter().min_by_key(|other| other.abs_diff(*id));
                let near = near.map_or(String::new(), u64::to_string);
                let count = elements.ids.len().to_string();
                self.errors
                    .at(*area, say::no_node(&id.to_string(), &files[0].0, &count, &near));
                is_whole = false;
            }
        }
        if !is_whole {
            return None;
        }
        let middle = |(_, nodes): &(&Name, &'a [(u64, Area)])| -> [f64; 3] {
            let places = || {
                nodes
                    .iter()
                    .filter_map(|(id, _)| Some(elements.nodes[elements.find(*id)?]))
            };
            [0, 1, 2].map(|axis| units[0] * places().map(|place| place[axis]).sum::<f64>() / nodes.len() as f64)
        };
        Some(Source {
            files: files.iter().map(|(path, _)| path.clone()).collect(),
            hash: contents.iter().fold(0, |hash, bytes| hash_on(hash, bytes)),
            units,
            places: interfaces.iter().map(middle).collect(),
        })
    }

    fn import_units(&mut self, names: &[Name], area: Area) -> Option<[f64; 3]> {
        if names.len() != UNITS.len() {
            self.errors.at(area, say::usage("units", "units(mm, t, s)"));
            return None;
        }
        let mut factors = [1.0; 3];
        for ((name, (word, dimension)), factor) in names.iter().zip(UNITS).zip(&mut factors) {
            let Some(unit) = units::find(&name.text) else {
                let known = units::UNITS
                    .iter()
                    .filter(|unit| unit.dimension == dimension)
                    .map(|unit| unit.symbol);
                self.errors.at(name.span, suggest::unknown("unit", &name.text, known));
                return None;
            };
            if unit.dimension != dimension {
                self.errors.at(name.span, say::unit_of_file(&name.text, word));
                return None;
            }
            *factor = units::Compound::ONE.times(unit, 1)?.si();
        }
        Some(factors)
    }

    /// The interface of a body that comes from a file, by its name; `None`: another body.
    pub(in crate::check) fn interface_of(&mut self, id: BodyId, field: &Name) -> Option<Option<Location>> {
        let item = self.items(Keyword::Body).into_iter().nth(id.0)?;
        let ItemKind::Body { statements, .. } = &item.kind else {
            return None;
        };
        let statements: &'a [Statement] = statements;
        if !is_imported(statements) {
            return None;
        }
        let names = statements.iter().filter_map(|statement| match statement {
            Statement::Interface { name, .. } => Some(name.text.as_str()),
            _ => None,
        });
        let names: Vec<&str> = names.collect();
        let found = names.iter().position(|name| *name == field.text);
        let Some(at) = found else {
            let mut known = names;
            balance_words().for_each(|word| known.push(word));
            self.errors.at(
                field.span,
                suggest::unknown("interface of the body", &field.text, known),
            );
            return Some(None);
        };
        Some(Some(match at {
            0 => Location::Start,
            at if at + 1 == names.len() => Location::End,
            at => Location::At(Box::new(Value::Number(at as f64))),
        }))
    }
}
