//! Syntax tree to syntax tree: what stands in loops whose number of repetitions is known at build time, and in parts,
//! becomes items of its own, `rod[2]` and `blade[1].rod`, so that all that can be declared can be repeated. Loops over a
//! count param stay: their bodies, joints, fixtures and loads stand once in what is generated.
//!
//! First all names are found (here), then every item is written with the names and numbers that it refers to
//! ([`write`]). Places of the user's text stay: a mistake in a loop or component points there.

mod corners;
mod count;
mod messages;
mod names;
mod part;
mod reduce;
mod statement;
mod write;

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use crate::errors::Errors;
use crate::parse::component::TAKEN;
use crate::parse::tree::{Expr, Item, ItemKind, Keyword, Loop, Name, Parameter, Tree};
use messages as say;

/// Most items that a declaration becomes.
const MOST_ITEMS: usize = 20_000;

/// Unfolds a declaration; what cannot be is reported and left out.
pub fn unfold(tree: Tree, errors: &mut Errors) -> Tree {
    let before = errors.len();
    let mut unfold = Unfold::new(&tree, errors);
    unfold.declare(0);
    unfold.walk(0, None, 0..tree.items.len(), &[], None);
    unfold.clashes();
    let mut out = unfold.written();
    let is_right = errors.len() == before;
    if out.is_copied {
        errors.at_each_place_once();
    }
    let Tree {
        doc,
        visibility,
        name,
        runs,
        source,
        complete,
        folder,
        ..
    } = tree;
    out.lost.extend(tree.lost);
    out.complete = complete && is_right;
    Tree {
        doc,
        visibility,
        name,
        runs,
        source,
        folder,
        ..out
    }
}

/// An index and its number; none in a loop that stays.
#[derive(Clone, Debug)]
struct Turn {
    name: String,
    number: Option<i64>,
}

/// Where something stands: in the model or a part of it, and in which repetitions.
#[derive(Clone, Debug)]
struct Place {
    scope: usize,
    turns: Vec<Turn>,
}

/// What a part was told: the expression, and where it is written.
#[derive(Clone, Debug)]
struct Told<'t> {
    parameter: &'t Parameter,
    value: &'t Expr,
    at: Place,
}

/// A name and the loops around it.
#[derive(Clone, Debug)]
struct Declared<'t> {
    item: &'t Item,
    loops: Vec<usize>,
}

/// The model, or a part of it.
struct Scope<'t> {
    tree: &'t Tree,
    /// What its names begin with outside: nothing, or `blade[1].`
    prefix: String,
    names: HashMap<&'t str, Declared<'t>>,
    told: HashMap<&'t str, Told<'t>>,
    /// Loops over a count that is known at run time only.
    kept: HashSet<usize>,
}

/// An item that is to be written.
struct Planned<'t> {
    at: Place,
    item: &'t Item,
    name: String,
    /// The loop that stays.
    repeat: Option<usize>,
    is_broken: bool,
}

/// How often a loop is gone through.
enum Count {
    /// So often.
    Known(i64),
    /// As often as a param says.
    Kept,
    /// What is refused where loops are checked.
    Wrong,
}

/// What is to be written.
enum Step<'t> {
    Item(Planned<'t>),
    /// A quantity that a part was told.
    Told {
        scope: usize,
        parameter: &'t Parameter,
    },
}

/// A loop that stays.
struct Kept<'t> {
    at: Place,
    id: usize,
    of: &'t Loop,
    /// Whether its head is refused, so that what stands in it is no news.
    is_wrong: bool,
}

struct Unfold<'t, 'e> {
    root: &'t Tree,
    errors: &'e mut Errors,
    scopes: Vec<Scope<'t>>,
    steps: Vec<Step<'t>>,
    kept: Vec<Kept<'t>>,
    /// Names of items as they are written.
    existing: HashSet<String>,
    /// Scopes of parts by their names.
    parts: HashMap<String, usize>,
    /// Components that are being placed, against recursion.
    placing: Vec<&'t str>,
    /// Values of constants, by scope and name.
    constants: HashMap<(usize, &'t str), Option<f64>>,
    /// Bodies with corners by their names, and how many pieces they have.
    cornered: HashMap<String, usize>,
    /// The piece that a load is written for.
    piece: Option<usize>,
    /// Names of constants that numbers of repetitions were computed from.
    counted: HashSet<String>,
    /// Names of constants as they are written.
    fixed: HashSet<String>,
    /// Names that could not be read, or whose parts could not be placed.
    lost: Vec<String>,
    /// Names that have a meaning of their own in the expression that is being written.
    local: Vec<&'t str>,
    /// Height of what stands for names in the expression that is being written.
    depth: usize,
    is_copied: bool,
    is_full: bool,
    /// Whether the item that is being written depends on something that has been reported.
    is_hidden: bool,
}

impl<'t, 'e> Unfold<'t, 'e> {
    fn new(root: &'t Tree, errors: &'e mut Errors) -> Self {
        Self {
            root,
            errors,
            scopes: vec![Scope::new(root, String::new())],
            steps: Vec::new(),
            kept: Vec::new(),
            existing: HashSet::new(),
            parts: HashMap::new(),
            placing: Vec::new(),
            constants: HashMap::new(),
            cornered: HashMap::new(),
            piece: None,
            counted: HashSet::new(),
            fixed: HashSet::new(),
            lost: Vec::new(),
            local: Vec::new(),
            depth: 0,
            is_copied: false,
            is_full: false,
            is_hidden: false,
        }
    }

    /// Collects the names of a scope. Names that are equal outside, too, are told when these are checked.
    fn declare(&mut self, scope: usize) {
        let tree = self.scopes[scope].tree;
        for item in &tree.items {
            let (text, span) = (item.name.text.as_str(), item.name.span);
            let loops = tree.around(item.repeat);
            if let Some(told) = self.scopes[scope].told.get(text) {
                let line = told.parameter.name.line().to_string();
                self.errors.at(span, say::told_already(text, &line));
                continue;
            }
            if item.keyword == Keyword::Output {
                continue;
            }
            match self.scopes[scope].names.get(text) {
                None => {
                    self.scopes[scope].names.insert(text, Declared { item, loops });
                }
                Some(first) if first.loops.len() != loops.len() || item.keyword == Keyword::Part || is_part(first) => {
                    let line = first.item.name.line().to_string();
                    let message = crate::messages::duplicate(text, first.item.keyword.word(), &line);
                    self.errors.at(span, message);
                }
                Some(_) => {}
            }
        }
        for lost in &tree.lost {
            let name = format!("{}{lost}", self.scopes[scope].prefix);
            self.lost.push(name);
        }
    }

    /// Plans items of a scope and of the loops among them; `kept` is the loop that stays around them.
    fn walk(&mut self, scope: usize, outer: Option<usize>, items: Range<usize>, turns: &[Turn], kept: Option<usize>) {
        let tree = self.scopes[scope].tree;
        let mut next = items.start;
        let inner = tree.loops.iter().enumerate().filter(|(_, inner)| inner.outer == outer);
        for (id, inner) in inner {
            for item in &tree.items[next..inner.items.start] {
                self.plan(scope, item, turns, kept);
            }
            self.repeat(scope, id, turns, kept);
            next = inner.items.end;
        }
        for item in &tree.items[next..items.end] {
            self.plan(scope, item, turns, kept);
        }
    }

    /// Goes through a loop, or keeps it.
    fn repeat(&mut self, scope: usize, id: usize, turns: &[Turn], kept: Option<usize>) {
        let of = &self.scopes[scope].tree.loops[id];
        let at = Place {
            scope,
            turns: turns.to_vec(),
        };
        let index = of.index.as_ref();
        let name = index.map_or(String::new(), |index| index.text.clone());
        if let Some(index) = index
            && turns.iter().any(|turn| turn.name == index.text)
        {
            self.errors.at(index.span, say::index_twice(&index.text));
        }
        let count = match &of.count {
            Some(count) if index.is_some() => self.count(&at, count),
            _ => Count::Wrong,
        };
        let around = |number: Option<i64>| {
            let name = name.clone();
            turns
                .iter()
                .cloned()
                .chain([Turn { name, number }])
                .collect::<Vec<Turn>>()
        };
        if let Some(around_it) = kept {
            let span = index.map_or_else(|| self.root.name.span, |index| index.span);
            if !self.kept[around_it].is_wrong {
                self.errors.at(span, say::IN_KEPT);
            }
            self.scopes[scope].kept.insert(id);
            return self.walk(scope, Some(id), of.items.clone(), &around(None), kept);
        }
        // That of a loop that stays in the model is looked at with the loop.
        if let Some(index) = index
            && (scope != 0 || matches!(count, Count::Known(_)))
        {
            self.may_be_index(scope, index);
        }
        match count {
            Count::Known(times) => {
                self.is_copied = true;
                for number in 0..times {
                    self.walk(scope, Some(id), of.items.clone(), &around(Some(number)), None);
                }
            }
            Count::Kept | Count::Wrong => {
                self.scopes[scope].kept.insert(id);
                let is_wrong = matches!(count, Count::Wrong);
                self.kept.push(Kept { at, id, of, is_wrong });
                let kept = Some(self.kept.len() - 1);
                self.walk(scope, Some(id), of.items.clone(), &around(None), kept);
            }
        }
    }

    /// Plans an item.
    fn plan(&mut self, scope: usize, item: &'t Item, turns: &[Turn], kept: Option<usize>) {
        if self.steps.len() >= MOST_ITEMS {
            if !std::mem::replace(&mut self.is_full, true) {
                self.errors.at(item.name.span, say::too_many(&MOST_ITEMS.to_string()));
            }
            return;
        }
        let numbers = turns.iter().filter_map(|turn| turn.number);
        let numbers: String = numbers.map(|number| format!("[{number}]")).collect();
        let name = format!("{}{}{numbers}", self.scopes[scope].prefix, item.name.text);
        let at = Place {
            scope,
            turns: turns.to_vec(),
        };
        self.existing.insert(name.clone());
        // `ball[1]` where there is `ball[1][0]`.
        let partial = name.match_indices("][").map(|(at, _)| name[..=at].to_string());
        self.existing.extend(partial);
        if item.keyword == Keyword::Const {
            self.fixed.insert(name.clone());
        }
        self.note_corners(item, &name);
        let mut is_broken = false;
        if let Some(kept) = kept
            && !stays(item.keyword)
        {
            let message = match item.keyword {
                Keyword::Output => say::OUTPUT_IN_KEPT.to_string(),
                keyword => say::not_kept(&say::a(&format!("`{}`", keyword.word()))),
            };
            // A param has been reported.
            if !item.is_param() && !self.kept[kept].is_wrong {
                self.errors.at(item.name.span, message);
            }
            is_broken = true;
        }
        if kept.is_some_and(|kept| self.kept[kept].is_wrong && self.kept[kept].of.count.is_some()) {
            is_broken = true;
            self.lost.push(item.name.text.clone());
        }
        if let ItemKind::Part(call) = &item.kind {
            if is_broken || self.place(&name, call, &at).is_none() {
                self.lost.push(name);
            }
            return;
        }
        if item.keyword == Keyword::Part {
            self.lost.push(name);
            return;
        }
        self.steps.push(Step::Item(Planned {
            at,
            item,
            name,
            repeat: kept,
            is_broken: is_broken && !item.is_param(),
        }));
    }

    /// Refuses an index with the name of something that is known there.
    fn may_be_index(&mut self, scope: usize, index: &Name) {
        let text = index.text.as_str();
        if TAKEN.contains(&text) {
            self.errors.at(index.span, say::meaning_of_its_own(text));
        } else if let Some(first) = self.scopes[scope].names.get(text) {
            let line = first.item.name.line().to_string();
            let message = say::duplicate(text, first.item.keyword.word(), &line);
            self.errors.at(index.span, message);
        } else if let Some(told) = self.scopes[scope].told.get(text) {
            let line = told.parameter.name.line().to_string();
            self.errors.at(index.span, say::told_already(text, &line));
        }
    }

    /// Refuses names that are those of others in generated code: `rod_1` beside `rod[1]`.
    fn clashes(&mut self) {
        if !self.is_copied {
            return;
        }
        let mut written: HashMap<String, &str> = HashMap::new();
        for step in &self.steps {
            let Step::Item(Planned { item, name, .. }) = step else {
                continue;
            };
            if item.keyword == Keyword::Output {
                continue;
            }
            let first = written.entry(crate::model::identifier(name)).or_insert(name);
            if *first != name {
                let message = say::written_alike(name, first);
                self.errors.at(item.name.span, message);
            }
        }
    }
}

impl<'t> Scope<'t> {
    fn new(tree: &'t Tree, prefix: String) -> Self {
        Self {
            tree,
            prefix,
            names: HashMap::new(),
            told: HashMap::new(),
            kept: HashSet::new(),
        }
    }

    /// Whether it declares a name whose repetitions become items of their own.
    fn unfolds(&self, text: &str) -> bool {
        let declared = self.names.get(text);
        declared.is_some_and(|declared| declared.loops.iter().any(|id| !self.kept.contains(id)))
    }
}

fn is_part(declared: &Declared) -> bool {
    declared.item.keyword == Keyword::Part
}

/// Whether loops over a count param repeat it.
fn stays(keyword: Keyword) -> bool {
    matches!(
        keyword,
        Keyword::Body | Keyword::Fixture | Keyword::Joint | Keyword::Load | Keyword::Material | Keyword::Section
    )
}
