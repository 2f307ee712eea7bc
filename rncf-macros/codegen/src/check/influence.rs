//! What of a declaration nothing reads: no mistake, but a warning at its word.
//!
//! Outputs, cautions, starts and the defaults of the run see what they name. What is seen makes all seen that it
//! names itself; what moves (a body, rigid body or free frame) or is held together (a joint, a constraint) makes all
//! seen that acts on it: joints, springs, loads, fixtures, bodies in a free frame. A prescribed frame passes nothing
//! on, for nothing acts on it. Of what is not seen the first cause is told: a name that nobody uses, or the bodies
//! that hang together; what is used by these alone stays silent.

use std::collections::{HashMap, HashSet};

use super::messages as say;
use crate::check::joints::loose::loose_ties;
use crate::check::loads::weight::{added_weights, is_everywhere};
use crate::check::sections::undamped::undamped_parts;
use crate::check::starts::distant::distant_axes;
use crate::check::values::read::{self, mentioned};
use crate::check::values::words::TOTAL;
use crate::elements::{Coefficient, Element, Library};
use crate::errors::Mistake;
use crate::model::{Body, Model, SectionShape, Space};
use crate::parse::tree::{Call, Expr, Field, Fields, Item, ItemKind, Keyword, Tree};
use crate::vocabulary::{BOTH_AXES, DERIVED, LAW, fields_of_product};

/// Warnings about a model without mistakes: items in the order of the declaration, then properties of materials and
/// sections. A leading underscore silences them.
pub fn influence(tree: &Tree, model: &Model, library: &Library) -> Vec<Mistake> {
    let mut warnings = Graph::new(tree).warnings();
    warnings.extend(unread_properties(tree, model, library));
    warnings.extend(loose_ties(tree, model, library));
    warnings.extend(undamped_parts(tree, model, library));
    warnings.extend(distant_axes(tree, model));
    warnings.extend(added_weights(tree));
    if tree.is_copied {
        warnings = crate::errors::at_each_place_once(warnings);
    }
    warnings
}

/// Whether an item was marked as meant to be without use, or is there for other models, too.
fn is_meant(item: &Item) -> bool {
    item.is_shared || item.name.word().starts_with('_')
}

/// Frames that move in a prescribed way.
const PRESCRIBED: [&str; 2] = ["rotating", "moving"];

/// Who names and who acts on whom, by indices of items.
struct Graph<'a> {
    items: Vec<&'a Item>,
    reads: Vec<Vec<usize>>,
    acts_on: Vec<Vec<usize>>,
    /// Named by the run.
    roots: HashSet<usize>,
}

impl<'a> Graph<'a> {
    fn new(tree: &'a Tree) -> Self {
        let items: Vec<&Item> = tree.items.iter().collect();
        // Outputs have names of their own, which cautions alone use.
        let named = items
            .iter()
            .enumerate()
            .filter(|(_, item)| item.keyword != Keyword::Output);
        let places: HashMap<&str, usize> = named.map(|(at, item)| (item.name.text.as_str(), at)).collect();
        let find = |names: Vec<&str>| -> Vec<usize> {
            let found = names.into_iter().filter_map(|name| places.get(name).copied());
            let found: HashSet<usize> = found.collect();
            let mut found: Vec<usize> = found.into_iter().collect();
            found.sort_unstable();
            found
        };
        // What is asked of all is asked of each that moves.
        let all = || (0..items.len()).filter(|&at| moves(items[at]));
        let reads = items.iter().map(|item| {
            let names = mentioned(tree, item);
            let is_total = names.contains(&TOTAL);
            let mut found = find(names);
            found.extend(all().filter(|_| is_total));
            found
        });
        let reads = reads.collect();
        let mut acts_on: Vec<Vec<usize>> = items.iter().map(|item| find(targets(tree, item))).collect();
        for targets in &mut acts_on {
            targets.retain(|&at| passes_on(items[at]));
        }
        // Gravity without a frame acts on all that moves.
        for (at, item) in items.iter().enumerate() {
            if matches!(&item.kind, ItemKind::Load(call) if is_everywhere(call)) {
                acts_on[at] = (0..items.len()).filter(|&at| moves(items[at])).collect();
            }
        }
        let mut run = Vec::new();
        for field in tree.runs.iter().flat_map(|fields| &fields.fields) {
            read::names(&field.value, &mut run);
        }
        run.extend(tree.counted.iter().map(String::as_str));
        Self {
            roots: find(run).into_iter().collect(),
            items,
            reads,
            acts_on,
        }
    }

    /// All that outputs, cautions, starts and the run see.
    fn seen(&self) -> Vec<bool> {
        let mut seen = vec![false; self.items.len()];
        let is_root = |at: &usize| {
            let keyword = self.items[*at].keyword;
            matches!(keyword, Keyword::Output | Keyword::Caution | Keyword::Start) || self.roots.contains(at)
        };
        let mut open: Vec<usize> = (0..self.items.len()).filter(is_root).collect();
        while let Some(at) = open.pop() {
            if std::mem::replace(&mut seen[at], true) {
                continue;
            }
            open.extend(&self.reads[at]);
            if passes_on(self.items[at]) {
                let actors = (0..self.items.len()).filter(|&other| self.acts_on[other].contains(&at));
                open.extend(actors);
            }
        }
        seen
    }

    /// Of what stands there more than once, in loops and parts, one that is seen or named is enough.
    fn see_copies(&self, seen: &mut [bool]) {
        let written = |at: usize| format!("{:?}", self.items[at].name.span);
        let named: HashSet<usize> = self.reads.iter().flatten().copied().collect();
        let is_used = |at: &usize| seen[*at] || named.contains(at);
        let is_copy = |at: &usize| self.items[*at].name.text != self.items[*at].name.word();
        let used: HashSet<String> = (0..seen.len()).filter(is_copy).filter(is_used).map(written).collect();
        for at in (0..seen.len()).filter(is_copy) {
            seen[at] |= used.contains(&written(at));
        }
    }

    fn warnings(&self) -> Vec<Mistake> {
        let mut seen = self.seen();
        self.see_copies(&mut seen);
        let mut warnings = Vec::new();
        let mut told: HashSet<usize> = HashSet::new();
        for (at, item) in self.items.iter().enumerate().filter(|(at, _)| !seen[*at]) {
            let name = item.name.text.as_str();
            let message = if moves(item) {
                let group = self.group(at, &seen);
                // One warning for all that hang together, at the first body.
                let is_told = group.iter().any(|member| told.contains(member));
                let carries = |other: &usize| self.acts_on[*other].contains(&at) && moves(self.items[*other]);
                if is_told || item.keyword == Keyword::Frame && group.iter().any(carries) {
                    continue;
                }
                told.extend(&group);
                told.insert(at);
                self.unseen(at, &group)
            } else if self.acts_on[at].is_empty() && !self.reads.iter().any(|reads| reads.contains(&at)) {
                say::unused(item.keyword.noun(), name)
            } else {
                continue;
            };
            if !is_meant(item) {
                warnings.push(Mistake::new(item.name.span, message));
            }
        }
        warnings
    }

    /// What moves and hangs together with something that is not seen, by what acts between them.
    fn group(&self, first: usize, seen: &[bool]) -> Vec<usize> {
        let mut group = HashSet::from([first]);
        let mut open = vec![first];
        while let Some(at) = open.pop() {
            for (actor, targets) in self.acts_on.iter().enumerate() {
                // Gravity alone holds nothing together.
                let is_alone = matches!(&self.items[actor].kind, ItemKind::Load(call) if is_everywhere(call));
                if seen[actor] || is_alone || !(actor == at || targets.contains(&at)) {
                    continue;
                }
                let all = targets
                    .iter()
                    .copied()
                    .chain([actor])
                    .filter(|&at| passes_on(self.items[at]));
                open.extend(all.filter(|&other| group.insert(other)));
            }
        }
        group.remove(&first);
        let mut group: Vec<usize> = group.into_iter().collect();
        group.sort_unstable();
        group
    }

    fn unseen(&self, at: usize, group: &[usize]) -> String {
        let item = self.items[at];
        let name = &item.name.text;
        let others = group.iter().map(|&at| self.items[at]).filter(|other| moves(other));
        let others: Vec<String> = others.map(|other| format!("`{}`", other.name.text)).collect();
        let others = match others.split_last() {
            None => String::new(),
            Some((last, [])) => format!(", nor {last}, which hangs together with it"),
            Some((last, rest)) => format!(", nor {} and {last}, which hang together with it", rest.join(", ")),
        };
        let place = match (item.keyword, item.repeat) {
            (Keyword::Body, Some(_)) => format!("{name}[0].end"),
            (Keyword::Body, None) => format!("{name}.end"),
            _ => name.clone(),
        };
        say::unseen(name, &others, &place)
    }
}

/// What moves in a way that is to be found.
fn moves(item: &Item) -> bool {
    match &item.kind {
        ItemKind::Frame { call, .. } => !PRESCRIBED.contains(&call.name.text.as_str()),
        _ => matches!(item.keyword, Keyword::Body | Keyword::Rigid),
    }
}

/// Whether what acts on an item has an influence on more than itself.
fn passes_on(item: &Item) -> bool {
    moves(item) || matches!(item.keyword, Keyword::Joint | Keyword::Constraint)
}

/// Names of what an item acts on.
fn targets<'a>(tree: &'a Tree, item: &'a Item) -> Vec<&'a str> {
    let mut found = Vec::new();
    let mut add = |expr: &'a Expr| read::names(expr, &mut found);
    let positional = |call: &'a Call| {
        let arguments = call.arguments.iter().filter(|argument| argument.name.is_none());
        arguments.map(|argument| &argument.value)
    };
    match &item.kind {
        ItemKind::Body { frame, .. } => found.extend(frame.as_ref().map(|frame| frame.text.as_str())),
        ItemKind::Fixture { place, .. } => add(place),
        // The second argument of a drive says where to, not what.
        ItemKind::Joint(call) if call.name.text == "drive" => positional(call).take(1).for_each(add),
        ItemKind::Joint(call) | ItemKind::Corner(call) | ItemKind::Spring(call) => positional(call).for_each(add),
        ItemKind::Constraint(_) => found = mentioned(tree, item),
        ItemKind::Load(call) if call.name.text == "gravity" => {
            let frame = call.arguments.iter().filter(|argument| argument.name.is_some());
            frame.for_each(|argument| add(&argument.value));
        }
        ItemKind::Load(call) => positional(call).take(1).for_each(add),
        _ => {}
    }
    found
}

/// Properties that no body reads of its section, and damping that nothing feels. The constants of a material are a data
/// sheet: they may stand there unread. Materials and sections without bodies are told already.
fn unread_properties(tree: &Tree, model: &Model, library: &Library) -> Vec<Mistake> {
    let mut warnings = Vec::new();
    for item in tree.items.iter().filter(|item| !is_meant(item)) {
        let (ItemKind::Material(fields) | ItemKind::Section(fields)) = &item.kind else {
            continue;
        };
        let is_material = item.keyword == Keyword::Material;
        let of = |body: &&Body| {
            let name = if is_material {
                &body.material_name
            } else {
                &body.section_name
            };
            *name == item.name.text
        };
        let bodies: Vec<&Body> = model.bodies.iter().filter(of).collect();
        if bodies.is_empty() {
            continue;
        }
        for field in unread(fields, &bodies, library) {
            let words = &field.name.text;
            if is_material && words != "damping" {
                continue;
            }
            let message = say::unread_property(
                words,
                item.keyword.word(),
                &item.name.text,
                &why(words, &bodies, library),
            );
            warnings.push(Mistake::new(field.name.span, message));
        }
    }
    warnings
}

fn unread<'a>(fields: &'a Fields, bodies: &[&Body], library: &Library) -> Vec<&'a Field> {
    let read: HashSet<&str> = (bodies.iter())
        .flat_map(|body| reads(body, body.space, library))
        .collect();
    let is_unread = |field: &&Field| !is_among(&read, &field.name.text);
    fields.fields.iter().filter(is_unread).collect()
}

/// Whether a field, or one of those for which it stands, is among what is read.
fn is_among(read: &HashSet<&str>, field: &str) -> bool {
    let both = BOTH_AXES.iter().find(|(both, _)| *both == field);
    read.contains(field) || both.is_some_and(|(_, axes)| axes.iter().any(|axis| read.contains(axis)))
}

/// Fields of material and section that a body reads, or would read in a space.
fn reads(body: &Body, space: Space, library: &Library) -> Vec<&'static str> {
    if body.law.is_some() {
        return LAW.iter().map(|property| property.name).collect();
    }
    let element = &library.elements[body.element.0];
    let coefficients = element.coefficients_in(space.dimension(), &body.options);
    if body.has_own_stiffness() {
        let fields = |one: &&Coefficient| fields_of_product(&one.factors, space == Space::Spatial);
        let mut read: Vec<&str> = coefficients.iter().filter_map(fields).flatten().collect();
        read.extend(body.fidelity.deforms().then_some(element.damping));
        return read;
    }
    let is_planar = space != Space::Spatial;
    // `yield` and the extents are read by reports of stresses.
    let mut read = vec!["density", "area", "yield", "energy", "extent_y"];
    if !is_planar {
        read.push("extent_z");
    }
    if body.fidelity.deforms() {
        read.push(element.damping);
    }
    for coefficient in coefficients {
        for factor in &coefficient.factors {
            let derived = DERIVED.iter().find(|derived| derived.name == *factor);
            read.extend(derived.map_or(vec![*factor], |derived| derived.from.to_vec()));
        }
    }
    // One second moment is that about z, and in space, where it is the same, about y.
    if read.contains(&"second_moment") {
        read.push("second_moment_z");
        read.extend((!is_planar).then_some("second_moment_y"));
    }
    // Shear factors of these shapes depend on Poisson's ratio.
    let round = matches!(body.shape, SectionShape::Circle { .. } | SectionShape::Tube { .. });
    if round && element.has_section() {
        read.push("poisson");
    }
    read
}

/// Why nothing reads a property.
fn why(property: &str, bodies: &[&Body], library: &Library) -> String {
    let mut elements: Vec<&Element> = bodies.iter().map(|body| &library.elements[body.element.0]).collect();
    elements.dedup_by_key(|element| element.names[0]);
    let names: Vec<String> = elements
        .iter()
        .map(|element| format!("`{}`", element.names[0]))
        .collect();
    let is_line = !elements.iter().any(|element| element.has_section());
    match property {
        "damping" => "its bodies do not deform".to_string(),
        "torsion_constant" if is_line => format!("{} has no torsion", names.join(" and ")),
        "poisson" | "shear_factor" | "shear_factor_y" | "shear_factor_z" if is_line => {
            format!("{} has no shear", names.join(" and "))
        }
        "poisson" => "its bodies have no shear".to_string(),
        _ => {
            let in_space = |body: &&Body| reads(body, Space::Spatial, library);
            let in_space: HashSet<&str> = bodies.iter().flat_map(in_space).collect();
            let is_planar = bodies.iter().any(|body| body.space != Space::Spatial);
            if is_planar && is_among(&in_space, property) {
                "its bodies stay in a plane".to_string()
            } else {
                format!("no coefficient of {} is made of it here", names.join(" and "))
            }
        }
    }
}
