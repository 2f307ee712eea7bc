//! What names, numbers behind them and dots between them refer to.

use super::messages as say;
use super::{Declared, Place, Unfold, part};
use crate::errors::Area;
use crate::parse::tree::{Expr, ExprKind, Keyword, Name, ParameterKind};
use crate::suggest;

/// What a name with its numbers and dots leads to.
pub enum Reached<'t> {
    /// An item, by its name as it is written.
    Item(Name),
    /// One repetition of an item of a loop that stays: its name, and the number.
    Kept(Name, Expr),
    /// A part, by its scope.
    Part(usize),
    /// One of several, of which not all numbers have been read.
    Several(Several<'t>),
    /// Something else: an expression that stands in the place of a name.
    Value(Expr),
    /// Nothing; reported.
    Nothing,
}

/// Repetitions of something, and the numbers so far.
pub struct Several<'t> {
    scope: usize,
    declared: Declared<'t>,
    span: proc_macro2::Span,
    numbers: Vec<i64>,
}

impl<'t> Unfold<'t, '_> {
    /// Follows names, numbers and dots; `None` where these are no names of items.
    pub(super) fn reach(&mut self, at: &Place, expr: &'t Expr) -> Option<Reached<'t>> {
        match &expr.kind {
            ExprKind::Name(name) => self.reach_name(at, name),
            ExprKind::Indexed { base, index } => {
                let reached = self.reach_name(at, base)?;
                Some(self.numbered(at, reached, index))
            }
            ExprKind::Numbered { base, index } => {
                let reached = self.reach(at, base)?;
                Some(self.numbered(at, reached, index))
            }
            ExprKind::Member {
                base,
                field,
                arguments: None,
            } => match self.reach(at, base)? {
                Reached::Part(scope) => Some(self.inside(scope, field)),
                Reached::Nothing => Some(Reached::Nothing),
                Reached::Several(several) if several.declared.item.keyword == Keyword::Part => {
                    self.lacks_number(&several);
                    Some(Reached::Nothing)
                }
                _ => None,
            },
            _ => None,
        }
    }

    /// The scope that declares a name which is known at a place: its own, or the model.
    pub(super) fn scope_of(&self, at: &Place, text: &str) -> Option<usize> {
        [at.scope, 0]
            .into_iter()
            .find(|&scope| self.scopes[scope].names.contains_key(text))
    }

    /// What a single word refers to.
    pub(super) fn reach_name(&mut self, at: &Place, name: &'t Name) -> Option<Reached<'t>> {
        let text = name.text.as_str();
        if self.local.contains(&text) || at.turns.iter().any(|turn| turn.name == text) {
            return None;
        }
        if let Some(told) = self.scopes[at.scope].told.get(text).cloned() {
            if part::is_quantity(told.parameter) {
                return Some(Reached::Item(self.renamed(at.scope, name)));
            }
            let value = self.deeper(told.value.height, expr_area(name), |unfold| unfold.told(&told));
            return Some(value.map_or(Reached::Nothing, |value| match value.kind {
                ExprKind::Name(found) => Reached::Item(Name {
                    span: name.span,
                    ..found
                }),
                kind => Reached::Value(Expr { kind, ..value }),
            }));
        }
        let Some(scope) = self.scope_of(at, text) else {
            let is_lost = self.scopes[at.scope].tree.lost.iter().any(|lost| lost == text);
            return is_lost.then(|| Reached::Item(self.renamed(at.scope, name)));
        };
        let declared = self.scopes[scope].names[text].clone();
        let (span, numbers) = (name.span, Vec::new());
        let several = Several {
            scope,
            declared,
            span,
            numbers,
        };
        Some(self.complete(several))
    }

    /// What a part was told in the place of a name.
    fn told(&mut self, told: &super::Told<'t>) -> Option<Expr> {
        let before = self.errors.len();
        let value = self.expr(&told.at, told.value);
        if self.errors.len() > before {
            return None;
        }
        let ParameterKind::Item(wanted) = &told.parameter.kind else {
            return Some(value);
        };
        let message = match &value.kind {
            ExprKind::Name(name) => match self.keyword_of(&name.text) {
                Some(found) if wanted.contains(&found) => return Some(value),
                Some(found) => say::wrong_item(&name.text, &say::a(found.noun()), &say::a(part::noun(wanted))),
                None if name.text == "inertial" || self.lost.contains(&name.text) => return Some(value),
                None if self.root.lost.contains(&name.text) => return Some(value),
                None => {
                    let items = self.root.items.iter().filter(|item| wanted.contains(&item.keyword));
                    let known = items.map(|item| item.name.text.as_str());
                    suggest::unknown(part::noun(wanted), &name.text, known)
                }
            },
            _ => say::name_wanted(&say::a(part::noun(wanted))),
        };
        self.errors.at(value.area, message);
        None
    }

    /// Keyword of an item by its name as it is written.
    fn keyword_of(&self, written: &str) -> Option<Keyword> {
        let (scope, word) = match written.rsplit_once('.') {
            Some((part, word)) => (*self.parts.get(part)?, word),
            None => (0, written),
        };
        let word = word.split('[').next().unwrap_or_default();
        let declared = self.scopes[scope].names.get(word)?;
        Some(declared.item.keyword)
    }

    /// A name of a scope as it is written outside.
    pub(super) fn renamed(&self, scope: usize, name: &Name) -> Name {
        Name::new(format!("{}{}", self.scopes[scope].prefix, name.text), name.span)
    }

    /// What stands behind the dot of a part.
    pub(super) fn inside(&mut self, scope: usize, field: &'t Name) -> Reached<'t> {
        let text = field.text.as_str();
        let tree = self.scopes[scope].tree;
        if let Some(declared) = self.scopes[scope].names.get(text).cloned() {
            let (span, numbers) = (field.span, Vec::new());
            return self.complete(Several {
                scope,
                declared,
                span,
                numbers,
            });
        }
        let is_quantity = self.scopes[scope]
            .told
            .get(text)
            .is_some_and(|told| part::is_quantity(told.parameter));
        if is_quantity || tree.lost.iter().any(|lost| lost == text) {
            return Reached::Item(self.renamed(scope, field));
        }
        let name = self.scopes[scope].prefix.trim_end_matches('.').to_string();
        let known: Vec<&str> = self.scopes[scope].names.keys().copied().collect();
        let message = match suggest::nearest(text, &known) {
            Some(nearest) => format!("{}: did you mean `{nearest}`?", say::not_in_part(text, &name)),
            None => say::not_in_part(text, &name),
        };
        self.errors.at(field.span, message);
        Reached::Nothing
    }

    /// A number behind something.
    fn numbered(&mut self, at: &Place, reached: Reached<'t>, index: &'t Expr) -> Reached<'t> {
        let mut several = match reached {
            Reached::Several(several) => several,
            Reached::Nothing => return Reached::Nothing,
            Reached::Item(name) if !self.existing.contains(&name.text) => {
                return Reached::Kept(name, self.expr(at, index));
            }
            Reached::Item(name) if self.cornered.contains_key(&name.text) => return self.one_piece(at, &name, index),
            Reached::Item(name) => {
                self.errors.at(index.area, say::not_repeated(&name.text));
                return Reached::Nothing;
            }
            _ => {
                self.errors.at(index.area, say::NOT_NUMBERED);
                return Reached::Nothing;
            }
        };
        let text = several.declared.item.name.text.as_str();
        let next = several.declared.loops[several.numbers.len()];
        if self.scopes[several.scope].kept.contains(&next) {
            let is_next = |kept: &super::Kept| {
                kept.is_wrong && kept.of.count.is_some() && kept.at.scope == several.scope && kept.id == next
            };
            if self.kept.iter().any(is_next) {
                self.is_hidden = true;
                return Reached::Nothing;
            }
            let name = self.name_of(&several);
            let name = Name::new(name, several.span);
            return Reached::Kept(name, self.expr(at, index));
        }
        let Some(value) = self.value(at, index, 0) else {
            match self.stranger(at, index) {
                _ if self.is_of_wrong_loop(at, index) => self.is_hidden = true,
                Some(name) => {
                    let message = self.say_stranger(at, &name.text);
                    self.errors.at(name.span, message);
                }
                None => self.errors.at(index.area, say::number_unknown(text)),
            }
            return Reached::Nothing;
        };
        if value.trunc() != value || value.abs() > 1e9 {
            self.errors.at(index.area, say::whole_number(text));
            return Reached::Nothing;
        }
        several.numbers.push(value as i64);
        let written = self.name_of(&several);
        if !self.existing.contains(&written) {
            let message = self.out_of_range(at, index, value, &written);
            self.errors.at(index.area, message);
            return Reached::Nothing;
        }
        self.complete(several)
    }

    /// Whether the number is that of a loop whose head has been refused.
    fn is_of_wrong_loop(&self, at: &Place, index: &Expr) -> bool {
        let mut wrong = self.kept.iter().filter(|kept| kept.is_wrong);
        wrong.any(|kept| {
            let name = kept.of.index.as_ref().map_or("", |index| index.text.as_str());
            let is_around = at.turns.iter().any(|turn| turn.name == name && turn.number.is_none());
            kept.at.scope == at.scope && is_around && mentions(index, name)
        })
    }

    /// The first name in the number of a repetition that nothing has.
    fn stranger(&self, at: &Place, index: &'t Expr) -> Option<&'t Name> {
        match &index.kind {
            ExprKind::Name(name) => {
                let text = name.text.as_str();
                let is_known = at.turns.iter().any(|turn| turn.name == text)
                    || [at.scope, 0].iter().any(|&scope| {
                        let scope = &self.scopes[scope];
                        scope.names.contains_key(text) || scope.told.contains_key(text)
                    });
                (!is_known).then_some(name)
            }
            ExprKind::Negate(inner) => self.stranger(at, inner),
            ExprKind::Binary(_, left, right) | ExprKind::Remainder(left, right) | ExprKind::Power(left, right) => {
                self.stranger(at, left).or_else(|| self.stranger(at, right))
            }
            _ => None,
        }
    }

    fn say_stranger(&self, at: &Place, text: &str) -> String {
        let mut loops = self.scopes[at.scope].tree.loops.iter();
        if loops.any(|one| one.index.as_ref().is_some_and(|index| index.text == text)) {
            return crate::messages::index_outside(text);
        }
        if at.turns.is_empty() {
            return say::no_index(text);
        }
        let known = at.turns.iter().map(|turn| turn.name.as_str());
        suggest::unknown("index", text, known)
    }

    /// What is said of a number that no repetition has.
    pub(super) fn out_of_range(&self, at: &Place, index: &Expr, value: f64, written: &str) -> String {
        let stem = written.rsplit_once('[').map_or(written, |(stem, _)| stem);
        let count = (0..)
            .take_while(|at| self.existing.contains(&format!("{stem}[{at}]")))
            .count();
        if count == 0 {
            return say::none_exist(stem);
        }
        let (value, last) = (value.to_string(), (count - 1).to_string());
        let turn = at.turns.iter().rev().find(|turn| mentions(index, &turn.name));
        match turn.and_then(|turn| Some((&turn.name, turn.number?))) {
            Some((name, number)) => say::runs_out(name, &number.to_string(), &value, stem, &last),
            None if value.starts_with('-') => say::negative_repetition(stem),
            None => say::beyond_repetitions(stem, &last),
        }
    }

    fn name_of(&self, several: &Several) -> String {
        let numbers: String = several.numbers.iter().map(|number| format!("[{number}]")).collect();
        let prefix = &self.scopes[several.scope].prefix;
        format!("{prefix}{}{numbers}", several.declared.item.name.text)
    }

    /// The item or part, where all numbers are known.
    fn complete(&mut self, several: Several<'t>) -> Reached<'t> {
        if several.numbers.len() < several.declared.loops.len() {
            return Reached::Several(several);
        }
        let text = self.name_of(&several);
        if several.declared.item.keyword != Keyword::Part {
            return Reached::Item(Name::new(text, several.span));
        }
        match self.parts.get(&text) {
            Some(&scope) => Reached::Part(scope),
            // It could not be placed, which is told there.
            None => {
                self.is_hidden = true;
                Reached::Nothing
            }
        }
    }

    /// What a name leads to that needs no more numbers; else it is reported, unless a loop stays.
    pub(super) fn settled(&mut self, reached: Reached<'t>, area: Area) -> Option<ExprKind> {
        match reached {
            Reached::Item(name) => Some(ExprKind::Name(name)),
            Reached::Kept(base, index) => Some(ExprKind::Indexed {
                base,
                index: Box::new(index),
            }),
            Reached::Value(value) => Some(value.kind),
            Reached::Part(_) => {
                self.errors.at(area, say::PART_AS_VALUE);
                None
            }
            Reached::Several(several) => {
                let next = several.declared.loops[several.numbers.len()];
                if self.scopes[several.scope].kept.contains(&next) {
                    return Some(ExprKind::Name(Name::new(self.name_of(&several), several.span)));
                }
                self.lacks_number(&several);
                None
            }
            Reached::Nothing => None,
        }
    }

    fn lacks_number(&mut self, several: &Several) {
        let indices = several.declared.loops[several.numbers.len()..].iter().map(|&id| {
            let index = self.scopes[several.scope].tree.loops[id].index.as_ref();
            format!("[{}]", index.map_or("0", |index| index.text.as_str()))
        });
        let indices: String = indices.collect();
        let message = say::repeated(&self.name_of(several), &indices);
        self.errors.at(several.span, message);
    }
}

fn expr_area(name: &Name) -> Area {
    name.span.into()
}

/// Whether an index stands in the expression of a number.
fn mentions(expr: &Expr, index: &str) -> bool {
    match &expr.kind {
        ExprKind::Name(name) => name.text == index,
        ExprKind::Negate(inner) => mentions(inner, index),
        ExprKind::Binary(_, left, right) | ExprKind::Remainder(left, right) | ExprKind::Power(left, right) => {
            mentions(left, index) || mentions(right, index)
        }
        _ => false,
    }
}
