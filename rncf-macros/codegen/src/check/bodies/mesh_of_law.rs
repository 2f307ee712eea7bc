//! Meshes of sections that say their stiffness and mass by themselves: `beam(section)`, whose strains are those of a rod with a full matrix, and
//! `cable(section)` or an element of the model's own, whose coefficients are numbers of the section in place of products of properties.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::mesh::{Mesh, named};
use crate::check::sections::law::{lacking, law_property};
use crate::check::sections::material::Stuff;
use crate::check::{Check, fold, say};
use crate::elements::Element;
use crate::errors::Area;
use crate::model::{ElementId, Evaluation, Expr as Value, Law, Quadrature, SectionShape, Space, Table};
use crate::parse::tree::{Call, Expr, Keyword, Name, Statement};
use crate::vocabulary::{CENTRES, DAMPINGS, MASS_ENTRIES, MASSES, STIFFNESS_ENTRIES, fields_of_product};

/// Constants that a `beam` needs in a plane.
const IN_PLANE: [&str; 5] = ["EA", "GAy", "EIz", "mass", "inertia_z"];
/// Those that nothing feels there, and which of the others they get the value of where they are not given: a section has all of them.
const BESIDE_PLANE: [(&str, &str); 4] = [
    ("GAz", "GAy"),
    ("EIy", "EIz"),
    ("GJ", "EIz"),
    ("inertia_y", "inertia_z"),
];

impl<'a> Check<'a> {
    /// The first argument, where it is a section that says its stiffness by itself.
    pub(super) fn lawful_section(&mut self, call: &'a Call) -> Option<&'a Name> {
        let first = call.arguments.iter().find(|argument| argument.name.is_none())?;
        let name = named(&first.value)?;
        let has_law = self.sections.get(name.text.as_str())?.law.is_some();
        (has_law && self.own(&first.value, Keyword::Section).is_some()).then_some(name)
    }

    /// `beam(section)`, `cable(section, bending = exact)` of such a section.
    pub(super) fn mesh_of_law(
        &mut self,
        (call, element): (&'a Call, usize),
        section: &Name,
        statements: &[Statement],
        space: Space,
    ) -> Option<Mesh> {
        let (word, name) = (call.name.text.as_str(), section.text.as_str());
        let law = self.sections.get(name).filter(|section| section.is_whole);
        let law = law.and_then(|section| section.law.clone());
        let is_viscous = law.as_ref().is_some_and(Law::is_viscous);
        let material = |expr: &&Expr| named(expr).is_none_or(|word| word.text != name);
        let unnamed = call.arguments.iter().filter(|argument| argument.name.is_none());
        if let Some(other) = unnamed.map(|argument| &argument.value).find(material) {
            self.errors.at(other.area, say::material_of_law(name, word));
            return None;
        }
        let Some(id) = self.library.find_of_stiffness(word, is_viscous) else {
            return self.mesh_of_numbers((call, element), section, &law?, statements, space);
        };
        if let Some((option, area)) = call
            .arguments
            .iter()
            .find_map(|argument| Some((argument.name.as_ref()?, argument.value.area)))
        {
            self.errors.at(area, say::no_options(&option.text, word, name));
            return None;
        }
        let law = self.law_in(space, (section, word), law?)?;
        // With dampings of strains that of all is read by what holds the section alone.
        let damping = match law.fields.get("damping") {
            Some(damping) => damping.clone(),
            None if is_viscous => law.fields[DAMPINGS.iter().find(|own| law.fields.contains_key(**own))?].clone(),
            None => Value::Number(0.0),
        };
        Some(Mesh {
            law: Some(law),
            ..without_material(id, section, [("damping", damping)].into())
        })
    }

    /// The law with all that a `beam` reads in a space; `None`: reported.
    fn law_in(&mut self, space: Space, (section, element): (&Name, &str), mut law: Law) -> Option<Law> {
        let constants = [(law.is_matrix, CENTRES), (law.has_mass_matrix, MASSES)];
        let read = constants
            .into_iter()
            .filter(|(is_matrix, _)| !is_matrix)
            .flat_map(|(_, fields)| fields);
        let in_plane = |field: &&&str| space == Space::Spatial || IN_PLANE.contains(*field);
        let missing = lacking(&law, read.filter(in_plane));
        if !missing.is_empty() {
            let message = say::lacks_numbers(&section.text, &missing, element, space == Space::Spatial);
            self.errors.at(section.span, message);
            return None;
        }
        if space == Space::Spatial {
            return Some(law);
        }
        let leaves = |field: &&&'static str| leaves_plane(field) && !self.vanishes(&law.fields[**field]);
        if let Some(field) = law.fields.keys().find(leaves) {
            let message = say::leaves_plane(&section.text, field);
            self.errors.at(self.area_of_field(section, field), message);
            return None;
        }
        law.fields.retain(|field, _| !leaves_plane(field));
        for (field, like) in BESIDE_PLANE {
            // Of a matrix neither is there.
            if let Some(like) = law.fields.get(like).cloned() {
                law.fields.entry(field).or_insert(like);
            }
        }
        Some(law)
    }

    /// Whether a field is zero along the whole axis, by constants and rows of tables; of a file that a run names nobody knows.
    fn vanishes(&self, value: &Value) -> bool {
        let tables = fold::tables(value).into_iter().map(|table| &self.model.tables[table.0]);
        let tables: Vec<&Table> = tables.collect();
        if tables.is_empty() {
            return fold::constant(value) == Some(0.0);
        }
        let is_zero = |(x, _)| fold::fixed_along(&self.model, value, x, 1.0) == Some(0.0);
        tables
            .iter()
            .all(|table| !table.is_param && table.rows(1.0).all(is_zero))
    }

    /// Where a field of a section stands; else the section's name in the mesh.
    fn area_of_field(&self, section: &Name, field: &str) -> Area {
        let item = self.names.get(section.text.as_str()).copied();
        let found = item.and_then(|item| super::along::area_in(item, field));
        found.unwrap_or_else(|| section.span.into())
    }

    /// `cable(section)`, or an element of the model's own: its coefficients are products of properties, which such a section says as numbers.
    fn mesh_of_numbers(
        &mut self,
        (call, id): (&'a Call, usize),
        section: &Name,
        law: &Law,
        statements: &[Statement],
        space: Space,
    ) -> Option<Mesh> {
        let library = Arc::clone(&self.library);
        let element = &library.elements[id];
        let (word, name) = (call.name.text.as_str(), section.text.as_str());
        if element.is_planar() && space == Space::Spatial {
            self.errors.at(call.name.span, say::element_of_plane(word));
            return None;
        }
        let elsewhere = |field: &&&'static str| {
            let is_entry = STIFFNESS_ENTRIES.contains(*field) || MASS_ENTRIES.contains(*field);
            let is_beside = law_property(field).is_some_and(|property| property.default == Some(0.0));
            (is_entry || is_beside && **field != "damping") && !self.vanishes(&law.fields[**field])
        };
        if let Some(field) = law.fields.keys().find(elsewhere) {
            let message = say::number_elsewhere(name, field, word);
            self.errors.at(self.area_of_field(section, field), message);
            return None;
        }
        let (options, quadrature, evaluation) = self.options(element, Some(space), call);
        let options = options?;
        self.curved(element, &options, statements, Some(space));
        let properties = self.numbers(element, (section, word), law, &options, space)?;
        Some(Mesh {
            options,
            quadrature: quadrature?,
            evaluation: evaluation?,
            ..without_material(id, section, properties)
        })
    }

    /// The numbers that an element's coefficients are; `None`: reported.
    fn numbers(
        &mut self,
        element: &Element,
        (section, word): (&Name, &str),
        law: &Law,
        options: &[usize],
        space: Space,
    ) -> Option<BTreeMap<&'static str, Value>> {
        let zero = Value::Number(0.0);
        let damping = law.fields.get("damping").cloned().unwrap_or(zero);
        let mut properties = BTreeMap::from([("damping", damping)]);
        let mut missing: Vec<&'static str> = Vec::new();
        let coefficients = element.coefficients_in(space.dimension(), options).into_iter();
        for coefficient in coefficients.filter(|coefficient| !coefficient.factors.is_empty()) {
            let Some(about) = fields_of_product(&coefficient.factors, space == Space::Spatial) else {
                let product = format!("{} = {}", coefficient.name, coefficient.factors.join(" * "));
                self.errors
                    .at(section.span, say::no_number(&section.text, &product, word));
                return None;
            };
            missing.extend(lacking(law, &about));
            let mut values = about.iter().filter_map(|about| law.fields.get(about));
            let Some(value) = values.next() else { continue };
            if values.any(|other| other != value) {
                self.errors
                    .at(section.span, say::unequal_stiffness(&section.text, word));
                return None;
            }
            properties.insert(about[0], value.clone());
        }
        if !missing.is_empty() {
            missing.dedup();
            let message = say::lacks_numbers(&section.text, &missing, word, space == Space::Spatial);
            self.errors.at(section.span, message);
            return None;
        }
        Some(properties)
    }
}

/// A mesh of one element, without options, of a section that names no material.
fn without_material(element: usize, section: &Name, properties: BTreeMap<&'static str, Value>) -> Mesh {
    Mesh {
        count: Value::Number(1.0),
        stations: None,
        element: ElementId(element),
        options: Vec::new(),
        material_name: String::new(),
        section_name: section.text.clone(),
        stuff: Stuff {
            properties,
            energy: None,
            shape: SectionShape::default(),
        },
        law: None,
        quadrature: Quadrature::Exact,
        evaluation: Evaluation::Automatic,
    }
}

/// Whether what a field couples, or moves, is beside the plane xy of a body that lies in it: shear along z, torsion, bending about y.
fn leaves_plane(field: &str) -> bool {
    const CONSTANTS: [&str; 6] = ["tension_z", "shear_y", "shear_z", "principal", "mass_z", "inertia_yz"];
    let is_entry = STIFFNESS_ENTRIES.contains(&field) || MASS_ENTRIES.contains(&field);
    let stays = |digit: &u8| [b'1', b'2', b'6'].contains(digit);
    let digits = &field.as_bytes()[1..];
    CONSTANTS.contains(&field) || is_entry && stays(&digits[0]) != stays(&digits[1])
}
