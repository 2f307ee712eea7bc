//! Elements that are declared in the language: from the statements to an [`Element`].

pub(super) mod formula;
mod messages;
mod shapes;
mod sound;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use super::{Check, fold, say as common};
use crate::check::values::expr;
use crate::check::values::quantity::Typed;
use crate::check::values::scope::Scope;
use crate::check::values::vector;
use crate::elements::{
    Coefficient, Element, ElementOption, Field, Inertia, Interpolant, Library, NodalVector, Written, points_for, word,
};
use crate::errors::Errors;
use crate::model::{ElementQuantity, Expr as Value, identifier};
use crate::parse::tree::{
    ElementKind, ElementStatement, Expr, ExprKind, Item, ItemKind, Keyword, Name, Tree, UnitText,
};
use crate::suggest;
use crate::tensors::{Rational, Sampling};
use crate::units::Dimension;
use crate::vocabulary::{DERIVED, MATERIAL, PIVOTS, PIVOTS_OF_RATES, SECTION, pivot_dimension};
use messages as say;

/// The word for the nodes as points of integration.
const NODES: &str = "nodes";

/// Derivatives of the position that can be named.
const DERIVATIVES: [&str; 8] = ["r", "r_x", "r_xx", "r_xxx", "r_y", "r_yx", "r_z", "r_zx"];

/// Names that generated code has for something else.
const TAKEN: [&str; 12] = [
    "length",
    "inverse_length",
    "damping",
    "reference",
    "weight",
    "force",
    "energy",
    "stiffness",
    "row",
    "model",
    "nodes",
    "shape",
];

/// The elements of a declaration, behind those that are known; used for the texts of the library.
pub fn elements(tree: &Tree, library: &Library, errors: &mut Errors) -> Library {
    let mut check = Check::new(tree, library, errors);
    check.is_trusted = true;
    check.names();
    check.params();
    check.elements();
    Library::clone(&check.library)
}

/// What has been read of an element.
struct Draft<'a> {
    /// The element's name.
    place: &'a Name,
    /// Coordinate of the unit element.
    coordinate: Option<&'a Name>,
    vectors: Vec<(&'a Name, NodalVector)>,
    /// Whether one could not be read.
    is_vector_lost: bool,
    /// Fields that could not be read.
    lost_fields: Vec<&'a str>,
    fields: Vec<(&'a Name, Field)>,
    coefficients: Vec<(&'a Name, Coefficient, Dimension)>,
    inertia: Vec<Inertia>,
    damping: Option<&'static str>,
    options: Vec<ElementOption>,
    points: Option<usize>,
    written: Written,
    /// Where the terms of the energy stand.
    terms: Vec<&'a Name>,
    /// The word `active` of each term.
    active: Vec<Option<&'a Name>>,
    /// Factors of coefficients that change with time.
    timed: HashMap<&'static str, Value>,
    /// Whether a formula could not be read.
    is_formula_lost: bool,
    /// Names of definitions, by their numbers, with their dimensions.
    names: Vec<(&'a str, Dimension)>,
    /// Where these stand first.
    definitions: Vec<&'a Name>,
}

impl<'a> Draft<'a> {
    /// Of an element of which nothing has been read.
    fn new(place: &'a Name) -> Self {
        Self {
            place,
            coordinate: None,
            vectors: Vec::new(),
            is_vector_lost: false,
            lost_fields: Vec::new(),
            fields: Vec::new(),
            coefficients: Vec::new(),
            inertia: Vec::new(),
            damping: None,
            options: Vec::new(),
            points: None,
            written: Written::default(),
            terms: Vec::new(),
            active: Vec::new(),
            timed: HashMap::new(),
            is_formula_lost: false,
            names: Vec::new(),
            definitions: Vec::new(),
        }
    }
}

/// Order of the derivative of an interpolant: `r_xx`, `r_yx`.
fn derivative(text: &str) -> Option<(Interpolant, usize)> {
    let rest = match text.strip_prefix('r')? {
        "" => return Some((Interpolant::Position, 0)),
        rest => rest.strip_prefix('_')?,
    };
    let (of, rest) = match rest.as_bytes().first()? {
        b'y' => (Interpolant::SectionY, &rest[1..]),
        b'z' => (Interpolant::SectionZ, &rest[1..]),
        _ => (Interpolant::Position, rest),
    };
    (rest.bytes().all(|byte| byte == b'x') && rest.len() <= 3).then_some((of, rest.len()))
}

impl<'a> Check<'a> {
    /// Adds the elements of the declaration to the library.
    pub(super) fn elements(&mut self) {
        // Those of parts that say the same are one element.
        let mut written: HashMap<String, usize> = HashMap::new();
        for item in self.items(Keyword::Element) {
            let ItemKind::Element {
                of_section,
                statements,
                complete,
            } = &item.kind
            else {
                continue;
            };
            if let Some(span) = of_section.filter(|_| !self.is_trusted) {
                self.errors.at(span, say::OF_SECTION);
                continue;
            }
            let (name, plain) = (item.name.text.as_str(), item.name.word());
            let is_known = self.library.find(name).is_some();
            let of_library = self
                .library
                .find(plain)
                .filter(|&at| self.library.elements[at].is_of_library);
            if is_known || of_library.is_some() {
                self.errors.at(item.name.span, say::of_library(plain));
                continue;
            }
            let text = match name == plain {
                true => None,
                false => Some(format!("{statements:?}")),
            };
            if let Some(&first) = text.as_ref().and_then(|text| written.get(text)) {
                Arc::make_mut(&mut self.library).elements[first].names.push(word(name));
                continue;
            }
            let before = self.errors.len();
            self.is_of_section = of_section.is_some();
            let element = self.element(item, statements, *complete);
            self.locals.clear();
            self.element_fields.clear();
            self.lost_fields.clear();
            if let Some(element) = element.filter(|_| self.errors.len() == before && *complete) {
                let elements = &mut Arc::make_mut(&mut self.library).elements;
                written.extend(text.map(|text| (text, elements.len())));
                elements.push(element);
            }
        }
    }

    /// Whether an element of this name is declared, so that its mistakes have been told.
    pub(super) fn is_declared_element(&self, name: &str) -> bool {
        let is_it = |item: &Item| item.keyword == Keyword::Element && item.name.text == name;
        self.tree.items.iter().any(is_it)
    }

    fn element(&mut self, item: &'a Item, statements: &'a [ElementStatement], complete: bool) -> Option<Element> {
        let before = self.errors.len();
        let mut draft = Draft::new(&item.name);
        let mut names = vec![word(&item.name.text)];
        self.own_names(statements);
        self.said_once(statements);
        for statement in statements {
            match &statement.kind {
                ElementKind::Domain { coordinate } if draft.coordinate.is_none() => draft.coordinate = Some(coordinate),
                ElementKind::Domain { coordinate } => self.errors.at(coordinate.span, common::twice("domain")),
                ElementKind::Also(name) => names.push(word(&name.text)),
                ElementKind::Points(value) => draft.points = self.point_count(value),
                ElementKind::Option { name, values } => draft.options.push(ElementOption {
                    name: word(&name.text),
                    values: values.iter().map(|value| word(&value.text)).collect(),
                    doc: statement.doc.clone(),
                }),
                _ => {}
            }
        }
        let Some(coordinate) = draft.coordinate else {
            if complete {
                self.errors
                    .at(item.name.span, say::missing("domain", "domain xi in 0..1;"));
            }
            return None;
        };
        for statement in statements {
            self.element_part(statement, coordinate, &mut draft);
        }
        for (needed, example) in [
            ("vector", "vector r0 = r at 0, shape 1 - xi;"),
            ("field", "field a = r_x;"),
            ("inertia", "inertia r = rhoA;"),
            ("energy", "energy axial_strain = 1/2*EA*e^2;"),
        ] {
            let is_needed = needed != "inertia" || !self.is_of_section;
            if complete && is_needed && !statements.iter().any(|statement| statement.word.text == needed) {
                self.errors.at(item.name.span, say::missing(needed, example));
            }
        }
        if !complete || draft.vectors.is_empty() {
            return None;
        }
        if !draft.is_vector_lost {
            self.shapes(&draft);
            self.interpolated(statements, &draft);
        }
        self.formulas(statements, &mut draft);
        // Of what is lost others may be to blame, and have been told.
        (self.errors.len() == before && !draft.is_formula_lost).then(|| self.finished(item, names, draft))?
    }

    /// The element, once all of it is understood.
    fn finished(&mut self, item: &'a Item, names: Vec<&'static str>, draft: Draft<'a>) -> Option<Element> {
        let places = draft.written.terms.iter().filter(|term| term.points.is_some()).count();
        if places != 0 && places != draft.written.terms.len() {
            let at = draft.written.terms.iter().position(|term| term.points.is_none())?;
            self.errors.at(draft.terms[at].span, say::POINTS_OF_SOME);
            return None;
        }
        let own_rule = places != 0;
        let default_points = draft.points.unwrap_or_else(|| {
            let own = draft.written.terms.iter().filter_map(|term| match term.points {
                Some(Sampling::Gauss(points)) => Some(points),
                _ => None,
            });
            let own = own.max();
            own.unwrap_or_else(|| points_for(draft.vectors.iter().map(|(_, vector)| vector)))
        });
        let written = draft.written.clone();
        let element = Element {
            kernel: word(&identifier(names[0])),
            names,
            of_stiffness: self.is_of_section,
            doc: first_line(&item.doc),
            vectors: draft.vectors.iter().map(|(_, vector)| vector.clone()).collect(),
            fields: draft.fields.iter().map(|(_, field)| *field).collect(),
            coefficients: draft.coefficients.iter().map(|(_, one, _)| one.clone()).collect(),
            inertia: draft.inertia.clone(),
            damping: draft.damping.unwrap_or("damping"),
            options: draft.options.clone(),
            energy: Arc::new(
                move |graph: &mut crate::symbolic::Graph, fields: &_, options: &[usize]| {
                    written.terms(graph, fields, options)
                },
            ),
            default_points,
            own_rule,
            is_of_library: self.is_trusted,
        };
        if !self.is_trusted {
            self.sound(item, &element, &draft);
        }
        Some(element)
    }

    /// Names inside of the element are one name space.
    fn own_names(&mut self, statements: &'a [ElementStatement]) {
        let mut seen: Vec<(&str, bool)> = Vec::new();
        for statement in statements {
            let (name, is_definition) = match &statement.kind {
                ElementKind::Vector { name, .. }
                | ElementKind::Field { name, .. }
                | ElementKind::Coefficient { name, .. }
                | ElementKind::Option { name, .. } => (name, false),
                ElementKind::Definition { name, .. } => (name, true),
                ElementKind::Domain { coordinate } => (coordinate, false),
                _ => continue,
            };
            let text = name.text.as_str();
            let is_known = seen
                .iter()
                .any(|&(other, other_definition)| other == text && !(is_definition && other_definition));
            if is_known {
                self.errors.at(name.span, common::twice(text));
            } else if TAKEN.contains(&text)
                || text.starts_with(formula::GIVEN)
                || derivative(text).is_some()
                || self.is_word(text)
            {
                self.errors.at(name.span, say::taken(text));
            }
            seen.push((text, is_definition));
        }
    }

    /// What an element has once: a second one would be added, or ignored, without a word.
    fn said_once(&mut self, statements: &'a [ElementStatement]) {
        let mut seen: HashSet<(&str, &str)> = HashSet::new();
        for statement in statements {
            let (word, list): (&Name, &[Name]) = match &statement.kind {
                ElementKind::Inertia { of, .. } => (&statement.word, std::slice::from_ref(of)),
                ElementKind::Damping(_) | ElementKind::Points(_) => {
                    (&statement.word, std::slice::from_ref(&statement.word))
                }
                ElementKind::Option { name, values } => (name, values),
                _ => continue,
            };
            for one in list {
                if !seen.insert((&word.text, &one.text)) {
                    self.errors.at(one.span, common::twice(&one.text));
                }
            }
        }
    }

    fn is_word(&self, text: &str) -> bool {
        super::RESERVED.contains(&text) || expr::function(text).is_some() || vector::is_function(text)
    }

    fn element_part(&mut self, statement: &'a ElementStatement, coordinate: &'a Name, draft: &mut Draft<'a>) {
        match &statement.kind {
            ElementKind::Vector { name, of, place, shape } => {
                let vector = self.nodal_vector(name, of, place, shape, coordinate);
                draft.is_vector_lost |= vector.is_none();
                draft.vectors.extend(vector.map(|vector| (name, vector)));
            }
            ElementKind::Field { name, of } => {
                let field = self.element_field(name, of);
                if field.is_none() {
                    draft.lost_fields.push(&name.text);
                }
                draft.fields.extend(field.map(|field| (name, field)));
            }
            ElementKind::Coefficient { name, unit, value } => {
                let coefficient = self.coefficient(name, unit, value, draft);
                if coefficient.is_none() {
                    // What it is used for is not to blame.
                    self.unknown.insert(name.text.clone());
                }
                draft
                    .coefficients
                    .extend(coefficient.map(|(coefficient, dimension)| (name, coefficient, dimension)));
            }
            ElementKind::Inertia { of, coefficient } => {
                let inertia = self.inertia_of(of, coefficient, draft);
                draft.inertia.extend(inertia);
            }
            ElementKind::Damping(value) => draft.damping = self.damping_of(value),
            _ => {}
        }
    }

    fn known_derivative(&mut self, of: &Name) -> Option<(Interpolant, usize)> {
        let found = derivative(&of.text);
        if found.is_none() {
            let message = suggest::unknown("derivative of the position", &of.text, DERIVATIVES);
            self.errors.at(of.span, message);
        }
        found
    }

    fn element_field(&mut self, name: &'a Name, of: &'a Name) -> Option<Field> {
        let (interpolant, order) = self.known_derivative(of)?;
        if (interpolant, order) == (Interpolant::Position, 0) {
            self.errors.at(of.span, say::POSITION_AS_FIELD);
            return None;
        }
        Some(Field {
            name: word(&name.text),
            of: interpolant,
            order,
        })
    }

    /// A product of properties and of what is the same along the body.
    fn coefficient(
        &mut self,
        name: &'a Name,
        unit: &'a UnitText,
        value: &'a Expr,
        draft: &mut Draft<'a>,
    ) -> Option<(Coefficient, Dimension)> {
        let compound = self.unit(unit)?;
        self.property_names();
        let typed = self.expr(value, Scope::Prescribed);
        self.locals.clear();
        let typed = typed?;
        let wanted = Dimension::of(compound.dimension);
        if typed.dimension != wanted {
            let message = say::coefficient_unit(&name.text, &typed.describe(), &wanted.describe(false));
            self.errors.at(unit.area, message);
            return None;
        }
        if (compound.si() - 1.0).abs() > 1e-12 {
            self.errors
                .at(unit.area, say::coefficient_si(&unit.text, &wanted.symbol(false)));
            return None;
        }
        let mut factors = Vec::new();
        let mut rest = without_properties(typed.value, &mut factors);
        if fold::has_element(&rest) {
            self.errors.at(value.area, say::COEFFICIENT_PRODUCT);
            return None;
        }
        if !fold::is_free_of_time(&rest) {
            let factor = formula::given(&rest, draft);
            draft.timed.insert(word(&name.text), factor);
            rest = Value::Number(1.0);
        }
        let coefficient = Coefficient {
            name: word(&name.text),
            unit: word(&unit.text),
            factors,
            scale: (rest != Value::Number(1.0)).then_some(rest),
        };
        Some((coefficient, wanted))
    }

    /// Lets `material.young` and the like be values.
    fn property_names(&mut self) {
        if self.is_of_section {
            let pivots = PIVOTS.iter().chain(PIVOTS_OF_RATES);
            pivots.for_each(|name| self.property_name("section", name, pivot_dimension(name)));
            return;
        }
        for (owner, list) in [("material", MATERIAL), ("section", SECTION)] {
            for property in list {
                let dimension = Dimension::of(property.dimension);
                self.property_name(owner, property.name, dimension);
            }
            for derived in DERIVED {
                let first = list.iter().find(|property| property.name == derived.from[0]);
                if let Some(first) = first {
                    self.property_name(owner, derived.name, Dimension::of(first.dimension));
                }
            }
        }
    }

    fn property_name(&mut self, owner: &str, name: &'static str, dimension: Dimension) {
        let value = Value::Element(ElementQuantity::Coefficient(name));
        let key = word(&format!("{owner}.{name}"));
        self.locals.insert(key, Typed::new(value, dimension));
    }

    /// `material.young` inside of a coefficient; `None` elsewhere.
    pub(super) fn property(&mut self, expr: &Expr) -> Option<Option<Typed>> {
        if !self.locals.contains_key("material.young") && !self.locals.contains_key("section.D1") {
            return None;
        }
        let ExprKind::Member { base, field, arguments } = &expr.kind else {
            return None;
        };
        let ExprKind::Name(owner) = &base.kind else {
            return None;
        };
        if !["material", "section"].contains(&owner.text.as_str()) || arguments.is_some() {
            return None;
        }
        let prefix = format!("{}.", owner.text);
        let known = self.locals.get(format!("{prefix}{}", field.text).as_str()).cloned();
        if known.is_none() {
            let all = self.locals.keys().filter_map(|key| key.strip_prefix(prefix.as_str()));
            let mut all: Vec<&str> = all.collect();
            all.sort_unstable();
            let message = suggest::unknown(&format!("property of a {}", owner.text), &field.text, all);
            self.errors.at(field.span, message);
        }
        Some(known)
    }

    fn inertia_of(&mut self, of: &'a Name, coefficient: &'a Name, draft: &Draft) -> Option<Inertia> {
        let (interpolant, order) = self.known_derivative(of)?;
        if order != 0 {
            self.errors.at(of.span, say::INERTIA_OF);
            return None;
        }
        let text = coefficient.text.as_str();
        let Some((_, one, dimension)) = draft.coefficients.iter().find(|(name, ..)| name.text == text) else {
            if !self.unknown.contains(text) {
                let known = draft.coefficients.iter().map(|(name, ..)| name.text.as_str());
                self.errors
                    .at(coefficient.span, suggest::unknown("coefficient", text, known));
            }
            return None;
        };
        if draft.timed.contains_key(text) {
            self.errors.at(coefficient.span, say::timed_inertia(text));
            return None;
        }
        let exponent = if interpolant == Interpolant::Position { -1 } else { 1 };
        let wanted = Dimension::of([exponent, 1, 0, 0, 0, 0]);
        if *dimension != wanted {
            let message = say::inertia_unit(&of.text, &wanted.describe(false), &dimension.describe(false));
            self.errors.at(coefficient.span, message);
            return None;
        }
        Some(Inertia {
            of: interpolant,
            coefficient: one.name,
        })
    }

    fn damping_of(&mut self, value: &'a Expr) -> Option<&'static str> {
        let is_it = matches!(&value.kind, ExprKind::Member { base, field, arguments: None }
            if field.text == "damping" && matches!(&base.kind, ExprKind::Name(name) if name.text == "material"));
        if !is_it {
            self.errors.at(value.area, say::DAMPING);
        }
        is_it.then_some("damping")
    }

    /// Where a part of the energy is integrated.
    fn sampling(&mut self, value: &Expr, vectors: &[(&Name, NodalVector)]) -> Option<Sampling> {
        if matches!(&value.kind, ExprKind::Name(name) if name.text == NODES) {
            let half = Rational::new(1, 2);
            let has_middle = vectors.iter().any(|(_, vector)| vector.place == half);
            return Some(Sampling::Nodes(if has_middle { 3 } else { 2 }));
        }
        self.point_count(value).map(Sampling::Gauss)
    }

    /// A number of Gauss points.
    fn point_count(&mut self, value: &Expr) -> Option<usize> {
        let found = match &value.kind {
            ExprKind::Number { text, unit: None } => text.parse::<usize>().ok(),
            _ => None,
        };
        let found = found.filter(|points| (1..=20).contains(points));
        if found.is_none() {
            self.errors.at(value.area, say::POINTS);
        }
        found
    }
}

/// The first line of a documentation comment without its full stop.
fn first_line(doc: &str) -> String {
    let line = doc.lines().next().unwrap_or("An element of this model");
    line.trim_end_matches('.').to_string()
}

/// What is left of a product without its properties, which are collected in their order.
fn without_properties(value: Value, factors: &mut Vec<&'static str>) -> Value {
    use crate::model::Binary;
    match value {
        Value::Element(ElementQuantity::Coefficient(name)) => {
            factors.push(name);
            Value::Number(1.0)
        }
        Value::Binary(Binary::Multiply, left, right) => {
            let (left, right) = (without_properties(*left, factors), without_properties(*right, factors));
            match (left, right) {
                (Value::Number(1.0), other) | (other, Value::Number(1.0)) => other,
                (left, right) => Value::Binary(Binary::Multiply, Box::new(left), Box::new(right)),
            }
        }
        Value::Binary(Binary::Divide, left, right) => {
            let left = without_properties(*left, factors);
            Value::Binary(Binary::Divide, Box::new(left), right)
        }
        other => other,
    }
}
