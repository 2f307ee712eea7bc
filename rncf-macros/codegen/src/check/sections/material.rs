//! Materials, and the properties that an element needs of its material and section.

use std::collections::{BTreeMap, HashMap};

use super::known::{Section, Values};
use crate::check::values::quantity::{Typed, Wanted, bare_literal, is_bare_zero};
use crate::check::values::scope::Scope;
use crate::check::{Check, fold, say};
use crate::elements::{Coefficient, Element};
use crate::errors::Area;
use crate::model::{Expr as Value, Model, SectionShape, Space};
use crate::parse::tree::{Call, Expr, ExprKind, Field, Fields, Item, ItemKind, Keyword, Name};
use crate::suggest;
use crate::symbolic::Id;
use crate::symbolic::Time;
use crate::units::Dimension;
use crate::vocabulary::{DERIVED, MATERIAL, Property, Range, SECTION};

/// What is known of a material.
#[derive(Clone, Debug, Default)]
pub struct Material {
    /// By their vocabulary names, defaults included.
    pub properties: BTreeMap<&'static str, Value>,
    /// Strain energy density, J/m^3.
    pub energy: Option<Value>,
    /// Whether all of it could be read: only then something can be missing.
    pub is_whole: bool,
}

/// What a body is made of.
pub struct Stuff {
    pub properties: BTreeMap<&'static str, Value>,
    pub energy: Option<Value>,
    pub shape: SectionShape,
}

/// A body's element as it is used.
#[derive(Clone, Copy)]
pub struct Used<'e> {
    pub element: &'e Element,
    /// The keyword as written.
    pub word: &'e str,
    pub space: Space,
    /// Values of its options.
    pub options: &'e [usize],
}

/// Components of the strain in the order of [`Value::Strain`], by their names in the language.
const STRAINS: [&str; 6] = ["E.xx", "E.yy", "E.zz", "E.xy", "E.xz", "E.yz"];

/// Relative size of a stress or energy that counts as round-off.
const ROUND_OFF: f64 = 1e-12;

const ENERGY: Wanted = Wanted {
    what: "the energy of a material",
    dimension: [-1, 1, -2, 0, 0, 0],
    unit: "J/m^3",
};

/// Damping from which on a material answers more slowly than any solid, s.
const SLOWEST_DAMPING: f64 = 3600.0;

/// Properties of linear elasticity, which an energy replaces.
const ELASTIC: [&str; 2] = ["young", "poisson"];

impl<'a> Check<'a> {
    /// Checks all materials, also those that nothing uses.
    pub(in crate::check) fn materials(&mut self) {
        for item in self.items(Keyword::Material) {
            if let ItemKind::Material(fields) = &item.kind {
                let material = self.in_loop(item, |check| check.material(item, fields));
                self.materials.insert(item.name.text.as_str(), material);
            }
        }
    }

    fn material(&mut self, item: &'a Item, fields: &'a Fields) -> Material {
        let words = MATERIAL.iter().map(|property| property.name).chain(["energy"]);
        let property = |word: &str| MATERIAL.iter().find(|property| property.name == word);
        let (values, mut is_whole) = self.property_fields(item, fields, words.collect(), property);
        if let Some((damping, area)) = values.get("damping")
            && self.default(damping) >= SLOWEST_DAMPING
        {
            self.errors.at(*area, say::DAMPING_TIME);
            is_whole = false;
        }
        let mut properties: BTreeMap<_, _> = values.into_iter().map(|(name, (value, _))| (name, value)).collect();
        let defaults = MATERIAL
            .iter()
            .filter_map(|property| Some((property.name, property.default?)));
        for (name, default) in defaults {
            properties.entry(name).or_insert(Value::Number(default));
        }
        let is_energy = |field: &&'a Field| field.name.text == "energy";
        let mut energy = None;
        if let Some(field) = fields.fields.iter().find(is_energy) {
            energy = self.energy(&item.name.text, field);
            is_whole &= energy.is_some();
            for field in &fields.fields {
                if ELASTIC.contains(&field.name.text.as_str()) {
                    self.errors.at(field.name.span, say::beside_energy(&field.name.text));
                    is_whole = false;
                }
            }
        }
        Material {
            properties,
            energy,
            is_whole,
        }
    }

    /// The fields of a block that are properties, and whether all fields are known, once there and readable.
    pub(in crate::check) fn property_fields(
        &mut self,
        item: &Item,
        fields: &'a Fields,
        words: Vec<&'static str>,
        property: impl Fn(&str) -> Option<&'static Property>,
    ) -> (Values, bool) {
        let mut values = Values::new();
        let mut seen: HashMap<&str, usize> = HashMap::new();
        let mut is_whole = fields.complete;
        for field in &fields.fields {
            let word = field.name.text.as_str();
            let Some(name) = words.iter().copied().find(|known| *known == word) else {
                let kind = format!("field of `{}`", item.keyword.word());
                let message = suggest::unknown(&kind, word, words.iter().copied());
                self.errors.at(field.name.span, message);
                is_whole = false;
                continue;
            };
            let line = field.name.line();
            if let Some(line) = seen.insert(word, line) {
                let message = say::duplicate_statement(&format!("`{word}`"), &line.to_string());
                self.errors.at(field.name.span, message);
                is_whole = false;
                continue;
            }
            let Some(property) = property(name) else { continue };
            let area = field.value.area;
            let value = self.along_axis(|check| check.field_value(name, &field.value, property));
            if name == "damping" && value.as_ref().is_some_and(fold::has_arclength) {
                self.errors.at(area, say::DAMPING_ALONG);
                is_whole = false;
            }
            match value {
                Some(value) => drop(values.insert(name, (value, area))),
                None => is_whole = false,
            }
        }
        (values, is_whole)
    }

    /// The value of a property, in its range where it is constant.
    pub(in crate::check) fn field_value(
        &mut self,
        what: &'static str,
        value: &'a Expr,
        property: &Property,
    ) -> Option<Value> {
        let wanted = Wanted {
            what,
            dimension: property.dimension,
            unit: property.unit,
        };
        if what.starts_with("damping")
            && let Some(text) = bare_literal(value)
        {
            self.errors.at(value.area, say::bare_damping(&text));
            return None;
        }
        let found = match property.is_angle() && !is_bare_zero(value) {
            true => self.angle(value, Scope::Parameter, what),
            false => self.quantity(value, Scope::Parameter, wanted),
        };
        if let Some(constant) = found.as_ref().and_then(fold::constant) {
            self.range(what, property.range, constant, value.area);
        }
        found
    }

    /// Whether a constant is in its range; reports where it is not.
    pub(in crate::check) fn range(&mut self, what: &str, range: Range, value: f64, area: Area) -> bool {
        if range.has(value) {
            return true;
        }
        let message = match range {
            Range::Positive => say::positive(what),
            Range::Part => say::part(what),
            Range::NonNegative => say::not_negative(what),
            Range::Poisson => say::POISSON.into(),
            Range::Any => say::NOT_FINITE.into(),
        };
        self.errors.at(area, message);
        false
    }

    /// `energy = EXPR;`: a smooth function of the strain, without energy and stress where there is none.
    fn energy(&mut self, name: &str, field: &'a Field) -> Option<Value> {
        for (at, strain) in STRAINS.iter().enumerate() {
            self.locals
                .insert(strain, Typed::new(Value::Strain(at), Dimension::NONE));
        }
        let value = self.quantity(&field.value, Scope::Parameter, ENERGY);
        self.locals.clear();
        let value = value?;
        let area = field.value.area;
        if fold::has_motion(&value) {
            self.errors.at(area, say::ENERGY_WITHOUT_TIME);
            return None;
        }
        if fold::has_index(&value) {
            self.errors.at(area, say::ENERGY_OF_REPETITION);
            return None;
        }
        let [energy, stress, stiffness] = at_rest(&self.model, &value);
        let largest = stiffness
            .iter()
            .fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        let is_finite = |values: &[f64; 6]| values.iter().all(|value| value.is_finite());
        let message = if ![energy, stress, stiffness].iter().all(is_finite) {
            Some(say::energy_not_finite(name))
        } else if energy[0].abs() > ROUND_OFF * largest {
            Some(say::energy_at_rest(name, &format!("{:.3e}", energy[0])))
        } else {
            let loaded = (0..6).find(|&at| stress[at].abs() > ROUND_OFF * largest);
            loaded.map(|at| say::stress_at_rest(name, STRAINS[at], &format!("{:.3e}", stress[at])))
        };
        if let Some(message) = message {
            self.errors.at(area, message);
            return None;
        }
        Some(value)
    }

    /// A component of the strain, `E.xx`, inside of an energy; `None` elsewhere.
    pub(in crate::check) fn strain(&mut self, expr: &Expr) -> Option<Option<Typed>> {
        if !self.locals.contains_key(STRAINS[0]) {
            return None;
        }
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            return None;
        };
        if !matches!(&base.kind, ExprKind::Name(name) if name.text == "E") {
            return None;
        }
        let name = format!("E.{}", field.text);
        let known = self.locals.get(name.as_str()).filter(|_| arguments.is_none()).cloned();
        if known.is_none() {
            let message = match STRAINS
                .iter()
                .find(|strain| strain[2..].chars().rev().eq(field.text.chars()))
            {
                Some(strain) if arguments.is_none() => say::symmetric_strain(&name, strain),
                _ => say::no_strain(&name),
            };
            self.errors.at(expr.area, message);
        }
        Some(known)
    }

    /// What a body is made of: all that its element needs must be there.
    pub(in crate::check) fn stuff(
        &mut self,
        used: Used,
        call: &Call,
        section: &Name,
        material: &Name,
    ) -> Option<Stuff> {
        let section_item = self.item(section, Keyword::Section);
        let material_item = self.item(material, Keyword::Material);
        let section_known = self.sections.get(section_item?.name.text.as_str()).cloned()?;
        let material_known = self.materials.get(material_item?.name.text.as_str()).cloned()?;
        let before = self.errors.len();
        let mut properties = material_known.properties.clone();
        let poisson = material_known.properties.get("poisson");
        if used.element.has_section() {
            let names = SECTION.iter().map(|property| property.name);
            let known = names.filter_map(|name| Some((name, section_known.property(name, poisson)?)));
            properties.extend(known);
        } else {
            let is_same = |name: &&str| !["second_moment_y", "second_moment_z", "torsion_constant"].contains(name);
            let same = section_known.properties.iter().filter(|(name, _)| is_same(name));
            properties.extend(same.map(|(name, value)| (*name, value.clone())));
        }
        let coefficients = used.element.coefficients.iter();
        let mut factors = coefficients.flat_map(|coefficient| &coefficient.factors);
        if !used.element.has_section() || factors.any(|name| *name == "second_moment") {
            let names = (section.text.as_str(), used.word);
            let is_planar = used.space != Space::Spatial;
            if let Some(moment) = self.one_moment(&section_known, names, is_planar, section.span.into()) {
                properties.insert("second_moment", moment);
            }
        }
        if material_known.energy.is_some() && properties.values().any(fold::has_arclength) {
            self.errors.at(material.span, say::VARYING_ENERGY);
        }
        if material_known.energy.is_some() {
            self.integrated(used, call, (section, &section_known), material);
        }
        let missing = missing(used, &properties, &section_known, material_known.energy.is_some());
        if section_known.is_whole {
            self.missing_of_section(&missing, used.word, section);
        }
        if material_known.is_whole {
            self.missing_of_material(&missing, used.word, material);
        }
        if let Some(energy) = material_known.energy.as_ref().filter(|_| used.element.has_section()) {
            self.stiff(energy, material);
        }
        let is_whole = section_known.is_whole && material_known.is_whole && missing.is_empty();
        (is_whole && self.errors.len() == before).then_some(Stuff {
            properties,
            energy: material_known.energy,
            shape: section_known.shape,
        })
    }

    /// Whether the energy of a material can be integrated over the section.
    fn integrated(&mut self, used: Used, call: &Call, (name, section): (&Name, &Section), material: &Name) {
        if !used.element.has_section() {
            let message = say::energy_of_line(&material.text, used.word);
            self.errors.at(material.span, message);
            return;
        }
        if !used.element.is_of_library {
            let message = say::energy_of_own_element(&material.text, used.word);
            self.errors.at(material.span, message);
            return;
        }
        if matches!(section.shape, SectionShape::General { .. }) && section.is_whole {
            let message = say::energy_of_block(&name.text, &material.text);
            self.errors.at(name.span, message);
        }
        let is_option = |word: &str| used.element.options.iter().any(|option| option.name == word);
        for argument in &call.arguments {
            if let Some(option) = argument.name.as_ref().filter(|name| is_option(&name.text)) {
                let message = say::option_beside_energy(&option.text, &material.text);
                self.errors.at(option.span, message);
            }
        }
    }

    fn missing_of_section(&mut self, missing: &[Need], element: &str, section: &Name) {
        let is_own = |need: &&Need| SECTION.iter().any(|property| property.name == need.property);
        let words: Vec<String> = missing.iter().filter(is_own).map(Need::words).collect();
        let Some((last, rest)) = words.split_last() else {
            return;
        };
        let (list, them) = match rest {
            [] => (last.clone(), "it"),
            rest => (format!("{} and {last}", rest.join(", ")), "them"),
        };
        let message = say::missing_of_section(&section.text, &list, element, them);
        self.errors.at(section.span, message);
    }

    fn missing_of_material(&mut self, missing: &[Need], element: &str, material: &Name) {
        for need in missing {
            if MATERIAL.iter().any(|property| property.name == need.property) {
                let (kind, why) = ("material", need.why());
                let message = say::missing_property(kind, &material.text, need.property, element, &why);
                self.errors.at(material.span, message);
            }
        }
    }

    /// An energy that does not resist a strain would leave it loose: the strains of the body, or those that are free to
    /// follow them.
    fn stiff(&mut self, energy: &Value, material: &Name) {
        if let Some(at) = loose(stiffness_at_rest(&self.model, energy)) {
            self.errors
                .at(material.span, say::energy_is_loose(&material.text, STRAINS[at]));
        }
    }
}

/// A property that an element needs, and the coefficient that it needs it for.
struct Need {
    property: &'static str,
    coefficient: Coefficient,
}

impl Need {
    /// `EA = young * area`
    fn why(&self) -> String {
        format!("{} = {}", self.coefficient.name, self.coefficient.factors.join(" * "))
    }

    fn words(&self) -> String {
        format!("`{}` ({})", self.property, self.why())
    }
}

/// What an element needs and is not known, each once.
fn missing(used: Used, known: &BTreeMap<&'static str, Value>, section: &Section, has_energy: bool) -> Vec<Need> {
    let mut missing: Vec<Need> = Vec::new();
    for coefficient in used.element.coefficients_in(used.space.dimension(), used.options) {
        let bases = || coefficient.factors.iter().flat_map(|&factor| bases(factor));
        if has_energy && bases().any(|base| ELASTIC.contains(&base)) {
            continue;
        }
        for property in bases() {
            // The shear factor of a shape is not known for want of Poisson's ratio.
            let is_shear = section.needs_poisson() && property.starts_with("shear_factor");
            let property = if is_shear { "poisson" } else { property };
            let is_new = missing.iter().all(|need| need.property != property);
            if is_new && !known.contains_key(property) {
                missing.push(Need {
                    property,
                    coefficient: coefficient.clone(),
                });
            }
        }
    }
    missing
}

/// The properties that a factor of a coefficient is, or is derived from.
fn bases(factor: &'static str) -> Vec<&'static str> {
    let derived = DERIVED.iter().find(|derived| derived.name == factor);
    derived.map_or_else(|| vec![factor], |derived| derived.from.to_vec())
}

/// A graph with an energy and the strains in it, and their values without strain, with the defaults.
fn unstrained<'m>(model: &'m Model, energy: &Value) -> (Time<'m>, Id, [Id; 6], HashMap<Id, f64>) {
    let mut time = Time::new(model);
    let root = time.expression(energy);
    let strains: [Id; 6] = std::array::from_fn(|at| time.strain(at));
    let mut inputs: HashMap<Id, f64> = strains.map(|strain| (strain, 0.0)).into();
    for (at, param) in model.params.iter().enumerate() {
        inputs.insert(time.param(at), param.default);
    }
    (time, root, strains, inputs)
}

/// Energy (six times), stresses and the diagonal of the stiffness without strain, with the defaults.
fn at_rest(model: &Model, energy: &Value) -> [[f64; 6]; 3] {
    let (mut time, root, strains, inputs) = unstrained(model, energy);
    let stress = strains.map(|strain| time.graph.partial(root, strain));
    let stiffness: [Id; 6] = std::array::from_fn(|at| time.graph.partial(stress[at], strains[at]));
    [[root; 6], stress, stiffness].map(|ids| {
        let values = time.graph.evaluate(&ids, &inputs);
        std::array::from_fn(|at| values[at])
    })
}

/// Second derivatives without strain, with the defaults.
fn stiffness_at_rest(model: &Model, energy: &Value) -> [[f64; 6]; 6] {
    let (mut time, root, strains, inputs) = unstrained(model, energy);
    strains.map(|row| {
        let stress = time.graph.partial(root, row);
        let entries = strains.map(|column| time.graph.partial(stress, column));
        let values = time.graph.evaluate(&entries, &inputs);
        std::array::from_fn(|at| values[at])
    })
}

/// The first strain that a stiffness does not resist, by the pivots of an elimination.
fn loose(mut stiffness: [[f64; 6]; 6]) -> Option<usize> {
    let own: [f64; 6] = std::array::from_fn(|at| stiffness[at][at]);
    for at in 0..6 {
        let pivot = stiffness[at][at];
        // What is left of a diagonal entry is round-off, or nothing, or less.
        if !(own[at] > 0.0 && pivot > 1e-9 * own[at]) {
            return Some(at);
        }
        for row in at + 1..6 {
            let factor = stiffness[row][at] / pivot;
            for column in at..6 {
                stiffness[row][column] -= factor * stiffness[at][column];
            }
        }
    }
    None
}
