//! Syntax tree to [`Model`]: names resolved, units in SI, every rule of the language checked. All
//! mistakes are reported at once; what depends on something already reported stays silent.

mod bodies;
mod dropped;
pub mod element;
mod frames;
pub mod influence;
mod joints;
mod loads;
mod messages;
mod messages_along;
mod observed;
mod places;
mod sections;
mod starts;
mod values;

#[cfg(test)]
mod tests;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use proc_macro2::Span;

use crate::elements::Library;
use crate::errors::{Area, Errors};
use crate::model::{BodyId, Frame, FrameId, MarkerId, Model, MotionId, TableId, fold};
use crate::parse::tree::{Argument, Call, Expr, Item, ItemKind, Keyword, Name, Tree, UnitText};
use crate::suggest;
use messages as say;

/// Where the user wrote the names that generated code uses, for spans of identifiers.
#[derive(Clone, Debug)]
pub struct Spans {
    /// Of the model's name.
    pub name: Span,
    /// Of each parameter, in the order of [`Model::params`].
    pub params: Vec<Span>,
}

impl Spans {
    /// Of a tree that has passed [`check`].
    pub fn of(tree: &Tree) -> Self {
        let params = tree.params();
        Self {
            name: tree.name.span,
            params: params.map(|item| item.name.span).collect(),
        }
    }
}

/// Checks a declaration against the element library. All mistakes go to `errors`; a model comes
/// back only where there are none (those of reading included).
pub fn check(tree: &Tree, library: &Library, errors: &mut Errors) -> Option<Model> {
    check_with_elements(tree, library, errors).map(|(model, _)| model)
}

/// The same, with the library that the model's elements are of: the given one and those of the declaration.
pub fn check_with_elements(tree: &Tree, library: &Library, errors: &mut Errors) -> Option<(Model, Arc<Library>)> {
    let before = errors.len();
    let mut check = Check::new(tree, library, errors);
    check.names();
    check.params();
    check.repeats();
    check.tables();
    check.quantities();
    check.motions();
    check.frames();
    check.states();
    check.materials();
    check.sections();
    check.elements();
    check.bodies();
    check.constants_along();
    check.fixtures();
    check.joints();
    check.constraints();
    check.springs();
    check.rates_of_states();
    check.floating();
    check.loads();
    check.starts();
    check.outputs();
    check.cautions();
    check.run();
    check.unread_columns();
    check.names_as_units();
    if tree.complete && check.errors.len() == before {
        check.ties();
    }
    if tree.complete && check.errors.len() == before {
        check.dropped();
    }
    let mut model = std::mem::take(&mut check.model);
    starts::nodes::stand_where_something_acts(&mut model);
    let library = Arc::clone(&check.library);
    (tree.complete && errors.len() == before).then_some((model, library))
}

/// What the checks know so far.
struct Check<'a> {
    tree: &'a Tree,
    /// Elements that are known, those of the declaration included.
    library: Arc<Library>,
    /// Whether the elements of the declaration are known to make sense: those of this crate.
    is_trusted: bool,
    /// Whether the element that is being checked is of a section alone, which says its stiffness by itself.
    is_of_section: bool,
    errors: &'a mut Errors,
    /// Everything with a name, outputs apart.
    names: HashMap<&'a str, &'a Item>,
    /// Resolved values of constants and parameters; `None`: reported.
    values: HashMap<&'a str, Option<values::quantity::Typed>>,
    motions: HashMap<&'a str, Option<(MotionId, values::quantity::Typed)>>,
    frames: HashMap<&'a str, Option<FrameId>>,
    /// What states are, with the markers that they are read of; `None`: reported.
    states: HashMap<&'a str, Option<(MarkerId, values::quantity::Typed)>>,
    /// Tables; `None`: reported.
    tables: HashMap<&'a str, Option<TableId>>,
    /// Columns that are read by their names.
    read_columns: HashSet<(TableId, usize)>,
    /// Columns of tables of sections that are no field of a section, and the word that took the table.
    spare_columns: Vec<(TableId, usize, &'a Call)>,
    /// Declared names that are units, too, with the first unit in which they could be either.
    clashes: HashMap<String, UnitText>,
    /// Readable sections and materials.
    sections: HashMap<&'a str, sections::known::Section>,
    materials: HashMap<&'a str, sections::material::Material>,
    bodies: HashMap<&'a str, bodies::body::Known>,
    joints: HashMap<&'a str, joints::known::Known>,
    constraints: HashMap<&'a str, joints::constraint::Known>,
    /// Bodies that something holds; `None`: something unreadable may hold any.
    tied: Option<Vec<BodyId>>,
    /// Straight pieces of a body that a corner joins: what holds one holds the other.
    corners: Vec<[BodyId; 2]>,
    /// Names of a law, such as `length` and `rate`.
    locals: HashMap<&'a str, values::quantity::Typed>,
    /// What springs show, by their names; `None`: reported.
    shown: HashMap<String, Option<observed::shown::Shown>>,
    /// Fields of the element that is being checked.
    element_fields: Vec<element::formula::FieldOfElement>,
    /// Those of it that could not be read.
    lost_fields: Vec<String>,
    /// Whether a density or a field is being checked.
    is_distributed: bool,
    /// Whether what varies along an axis is being checked.
    is_along: bool,
    /// Whether a force, moment or law of a spring is being checked, in which tables are looked up.
    looks_up: bool,
    /// Vectors of the particle that a density is checked for.
    particle: HashMap<&'a str, values::vector::Vectorial>,
    /// The loop or reduction that is being checked.
    turn: Option<values::repeat::Turn<'a>>,
    /// Unknown names that have been reported.
    unknown: HashSet<String>,
    /// Frames that have been reported for leaving the plane with this normal.
    out_of_plane: HashSet<(FrameId, usize)>,
    /// Names that are being resolved, against recursion.
    stack: Vec<&'a str>,
    /// Expressions that are being resolved inside each other.
    depth: usize,
    model: Model,
}

/// Names with a meaning of their own.
const RESERVED: &[&str] = &["t", "pi", "inertial", values::words::TOTAL];

/// Longest chain of names that are defined by each other.
const LONGEST_CHAIN: usize = 64;

impl<'a> Check<'a> {
    fn new(tree: &'a Tree, library: &Library, errors: &'a mut Errors) -> Self {
        let model = Model {
            name: tree.name.text.clone(),
            visibility: tree.visibility_text(),
            doc: tree.doc.clone(),
            source: tree.source.clone(),
            frames: vec![inertial()],
            ..Model::default()
        };
        Self {
            tree,
            library: Arc::new(library.clone()),
            is_trusted: false,
            is_of_section: false,
            errors,
            names: HashMap::new(),
            values: HashMap::new(),
            motions: HashMap::new(),
            frames: HashMap::new(),
            states: HashMap::new(),
            tables: HashMap::new(),
            read_columns: HashSet::new(),
            spare_columns: Vec::new(),
            clashes: HashMap::new(),
            sections: HashMap::new(),
            materials: HashMap::new(),
            bodies: HashMap::new(),
            joints: HashMap::new(),
            constraints: HashMap::new(),
            tied: Some(Vec::new()),
            corners: Vec::new(),
            locals: HashMap::new(),
            shown: HashMap::new(),
            element_fields: Vec::new(),
            lost_fields: Vec::new(),
            is_distributed: false,
            is_along: false,
            looks_up: false,
            particle: HashMap::new(),
            turn: None,
            unknown: HashSet::new(),
            out_of_plane: HashSet::new(),
            stack: Vec::new(),
            depth: 0,
            model,
        }
    }

    /// Collects the names; outputs have a name space of their own.
    fn names(&mut self) {
        let mut outputs: HashMap<&str, &Item> = HashMap::new();
        for item in &self.tree.items {
            let (name, word) = (item.name.text.as_str(), item.name.word());
            // Each motion becomes a function of Rust.
            let is_of_rust = item.keyword == Keyword::Motion && matches!(word, "Some" | "Ok" | "Err");
            if is_of_rust
                || RESERVED.contains(&word)
                || values::expr::function(word).is_some()
                || values::vector::is_function(word)
            {
                self.errors.at(item.name.span, say::meaning_of_its_own(word));
            }
            let names = if item.keyword == Keyword::Output {
                &mut outputs
            } else {
                &mut self.names
            };
            if let Some(first) = names.get(name) {
                let (kind, line) = (first.keyword.word(), first.name.line());
                self.errors
                    .at(item.name.span, say::duplicate(name, kind, &line.to_string()));
            } else {
                names.insert(name, item);
            }
        }
    }

    /// Items with a keyword, in order; of two with the same name the first.
    fn items(&self, keyword: Keyword) -> Vec<&'a Item> {
        let is_first = |item: &&Item| {
            keyword == Keyword::Output
                || self
                    .names
                    .get(item.name.text.as_str())
                    .is_some_and(|first| std::ptr::eq(*first, *item))
        };
        self.tree
            .items
            .iter()
            .filter(|item| item.keyword == keyword)
            .filter(is_first)
            .collect()
    }

    /// The declared names of some kinds.
    fn known(&self, keywords: &[Keyword]) -> Vec<&'a str> {
        let items = self.tree.items.iter().filter(|item| keywords.contains(&item.keyword));
        // What stands there more than once is known by the word of its declaration.
        let mut words: Vec<&str> = Vec::new();
        for word in items.map(|item| item.name.word()) {
            if !words.contains(&word) {
                words.push(word);
            }
        }
        words
    }

    /// The item that a name refers to, of the kind that is expected here.
    fn item(&mut self, name: &Name, keyword: Keyword) -> Option<&'a Item> {
        match self.names.get(name.text.as_str()) {
            Some(item) if item.keyword == keyword => Some(item),
            Some(item) => {
                let message = say::wrong_kind(&name.text, &say::a(item.keyword.noun()), &say::a(keyword.noun()));
                self.errors.at(name.span, message);
                None
            }
            None => {
                if self.is_news(&name.text) {
                    let message = suggest::unknown(keyword.noun(), &name.text, self.known(&[keyword]));
                    self.errors.at(name.span, message);
                }
                None
            }
        }
    }

    /// Whether nothing has been said yet about this unknown name.
    fn is_news(&mut self, name: &str) -> bool {
        !self.tree.lost.iter().any(|lost| lost == name) && self.unknown.insert(name.to_string())
    }

    /// Marks a name as being resolved; refuses recursion.
    fn enter(&mut self, name: &'a str, area: Area) -> bool {
        if let Some(at) = self.stack.iter().position(|other| *other == name) {
            let chain = self.stack[at..]
                .iter()
                .chain([&name])
                .copied()
                .collect::<Vec<_>>()
                .join(" -> ");
            self.errors.at(area, say::recursion(name, &chain));
            return false;
        }
        if self.stack.len() >= LONGEST_CHAIN {
            self.errors.at(area, say::LONG_CHAIN);
            return false;
        }
        self.stack.push(name);
        true
    }

    fn leave(&mut self) {
        self.stack.pop();
    }

    /// Sorts the arguments of a call into the positional and the named ones that it takes.
    fn arguments(&mut self, call: &'a Call, shape: &Shape) -> Option<Arguments<'a>> {
        let before = self.errors.len();
        let mut found = Arguments {
            positional: Vec::new(),
            named: HashMap::new(),
        };
        let mut is_surplus = false;
        for Argument { name, value } in &call.arguments {
            match name {
                None if found.positional.len() < shape.positional => found.positional.push(value),
                // The usage shows all of them at once.
                None if is_surplus => {}
                None => {
                    is_surplus = true;
                    let message = match shape.required.is_empty() {
                        true => say::surplus(&call.name.text, shape.usage),
                        false => say::without_name(&call.name.text, shape.usage),
                    };
                    self.errors.at(value.area, message);
                }
                Some(name) => {
                    let text = name.text.as_str();
                    if !shape.named.contains(&text) {
                        let kind = format!("argument of `{}`", call.name.text);
                        self.errors
                            .at(name.span, suggest::unknown(&kind, text, shape.named.iter().copied()));
                    } else if found.named.insert(text, value).is_some() {
                        self.errors.at(name.span, say::twice(text));
                    }
                }
            }
        }
        let is_missing = found.positional.len() < shape.positional
            || shape.required.iter().any(|name| !found.named.contains_key(name));
        if is_missing && self.errors.len() == before {
            self.errors.at(call.area, say::usage(&call.name.text, shape.usage));
        }
        (self.errors.len() == before).then_some(found)
    }

    /// Value at t = 0 with the defaults of the parameters; of a repeated item that of the first repetition.
    fn default(&self, value: &crate::model::Expr) -> f64 {
        fold::with_defaults(&self.model, value, 0.0).unwrap_or(f64::NAN)
    }

    fn is_broken(item: &Item) -> bool {
        matches!(item.kind, ItemKind::Broken)
    }
}

/// The arguments that a call takes.
struct Shape {
    positional: usize,
    named: &'static [&'static str],
    required: &'static [&'static str],
    usage: &'static str,
}

/// The arguments that a call has.
struct Arguments<'a> {
    positional: Vec<&'a Expr>,
    named: HashMap<&'a str, &'a Expr>,
}

fn inertial() -> Frame {
    let zero = || crate::model::Expr::Number(0.0);
    Frame {
        name: "inertial".into(),
        doc: String::new(),
        parent: crate::model::INERTIAL,
        origin: [zero(), zero(), zero()],
        rotation: None,
        free: None,
    }
}
