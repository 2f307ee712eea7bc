//! Repetition: loops and their indices, numbers of repetitions, and values over all of them.

use super::expr;
use super::quantity::Typed;
use super::scope::Scope;
use super::vector;
use crate::check::values::words::AXES;
use crate::check::{Check, RESERVED, fold, say};
use crate::model::{self, Binary, Expr as Value, Function, Location, Observable, Repeat, RepeatId};
use crate::parse::tree::{Expr, ExprKind, Item, ItemKind, Keyword, Name, Reduced};
use crate::units::Dimension;

/// Names that mean something else inside of a loop or reduction.
const TAKEN: &[&str] = &["position", "slope", "t_end"];

/// Most repetitions whose numbers are computed one by one.
const MOST_TRIED: f64 = 10_000.0;

/// Stands for a count that has been reported.
const UNKNOWN: Value = Value::Number(f64::INFINITY);

/// The loop or reduction whose index is known.
#[derive(Clone, Copy, Debug)]
pub struct Turn<'a> {
    /// Name of the index; `None`: unreadable, reported.
    name: Option<&'a str>,
    repeat: RepeatId,
}

impl<'a> Check<'a> {
    /// The loops of the declaration.
    pub(in crate::check) fn repeats(&mut self) {
        for declared in &self.tree.loops {
            if let Some(index) = &declared.index {
                self.may_be_index(index);
            }
            let count = declared.count.as_ref().and_then(|count| self.repetitions(count));
            self.model.repeats.push(Repeat {
                index: declared
                    .index
                    .as_ref()
                    .map_or(String::new(), |index| index.text.clone()),
                count: count.unwrap_or(UNKNOWN),
            });
        }
    }

    /// Refuses an index with the name of something else.
    fn may_be_index(&mut self, index: &Name) {
        let text = index.text.as_str();
        let is_word = AXES.contains(&text)
            || TAKEN.contains(&text)
            || RESERVED.contains(&text)
            || expr::function(text).is_some()
            || vector::is_function(text);
        if is_word {
            self.errors.at(index.span, say::meaning_of_its_own(text));
        } else if let Some(item) = self.names.get(text) {
            let line = item.name.line().to_string();
            let message = say::duplicate(text, item.keyword.word(), &line);
            self.errors.at(index.span, message);
        }
    }

    /// Checks an item of a loop with the loop's index known; one outside of loops without.
    pub(in crate::check) fn in_loop<T>(&mut self, item: &'a Item, resolve: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.turn;
        self.turn = item.repeat.map(|at| Turn {
            name: self.tree.loops[at].index.as_ref().map(|index| index.text.as_str()),
            repeat: RepeatId(at),
        });
        let result = resolve(self);
        self.turn = outer;
        result
    }

    /// The index of the loop, where this is its name.
    pub(in crate::check) fn index(&mut self, name: &Name, scope: Scope) -> Option<Option<Typed>> {
        let turn = self.turn?;
        if turn.name != Some(name.text.as_str()) {
            return None;
        }
        if scope == Scope::Constant {
            self.errors.at(name.span, say::index_in_constant(&name.text));
            return Some(None);
        }
        Some(Some(Typed::new(Value::Index, Dimension::NONE)))
    }

    /// What is said of a name that is the index of some loop, or that no readable loop has.
    pub(in crate::check) fn index_elsewhere(&self, text: &str) -> Option<String> {
        let mut indices = self.tree.indices.iter();
        indices.any(|index| index == text).then(|| say::index_outside(text))
    }

    /// Whether a name is the index of the loop, or may be where that could not be read.
    pub(in crate::check) fn is_perhaps_index(&self, text: &str) -> bool {
        self.turn.is_some_and(|turn| turn.name.is_none_or(|name| name == text))
    }

    /// Whether the index of the loop could not be read, so that unknown names are no news.
    pub(in crate::check) fn has_lost_index(&self) -> bool {
        self.turn.is_some_and(|turn| turn.name.is_none())
    }

    /// Whether the number behind something of the loop `repeat` is that of the repetition that is looked at; else what is said.
    pub(in crate::check) fn own_repetition(
        &self,
        name: &str,
        repeat: usize,
        number: Option<&Expr>,
    ) -> Result<(), String> {
        let Some(turn) = self.turn.filter(|turn| turn.repeat.0 == repeat) else {
            return Err(say::elsewhere(name));
        };
        // A head that could not be read is reported.
        let Some(index) = turn.name else { return Ok(()) };
        let is_index = |number: &Expr| matches!(&number.kind, ExprKind::Name(word) if word.text == index);
        match number.is_some_and(is_index) {
            true => Ok(()),
            false => Err(say::own_repetition(name, index)),
        }
    }

    pub(in crate::check) fn say_repeated(&self, name: &Name) -> String {
        let text = name.text.as_str();
        match self.turn.and_then(|turn| turn.name) {
            Some(index) => say::repeated_inside(text, index),
            None => say::repeated(text),
        }
    }

    /// `name[..]` where no place on a body goes on behind it.
    pub(in crate::check) fn lone_indexed(&mut self, base: &Name, index: &Expr) {
        let message = match self.names.get(base.text.as_str()) {
            Some(item) if Self::is_broken(item) => return,
            Some(item) if item.repeat.is_some() && item.keyword == Keyword::Joint => {
                return self.repeated_reaction(base);
            }
            Some(item) if item.repeat.is_some() && item.keyword == Keyword::Body => {
                self.errors.at(base.span, say::lone_repetition(&base.text));
                return;
            }
            Some(item) if item.repeat.is_some() => say::not_a_value(&base.text, &say::a(item.keyword.noun())),
            Some(_) => say::not_repeated(&base.text),
            None => {
                if self.is_news(&base.text) {
                    let known = self.known(&[Keyword::Body]);
                    let message = crate::suggest::unknown("body", &base.text, known);
                    self.errors.at(base.span, message);
                }
                return;
            }
        };
        self.errors.at(index.area, message);
    }

    pub(in crate::check) fn repeated_reaction(&mut self, name: &Name) {
        self.errors.at(name.span, say::repeated_reaction(&name.text));
    }

    /// Number of a repetition of something.
    pub(in crate::check) fn repetition(&mut self, name: &Name, expr: &'a Expr, of: RepeatId) -> Option<Value> {
        let value = self.number_of(expr)?;
        let count = fold::constant(&self.model.repeats[of.0].count);
        let Some(number) = fold::constant(&value) else {
            self.runs_out(name, expr, &value, count)?;
            return Some(value);
        };
        if number < 0.0 {
            self.errors.at(expr.area, say::negative_repetition(&name.text));
            return None;
        }
        if let Some(count) = count.filter(|count| number >= *count) {
            let message = say::beyond_repetitions(&name.text, &(count - 1.0).to_string());
            self.errors.at(expr.area, message);
            return None;
        }
        Some(Value::Number(number))
    }

    /// Reports the first repetition of a loop whose number of another one is out of range, where both counts are
    /// known.
    fn runs_out(&mut self, name: &Name, expr: &Expr, value: &Value, count: Option<f64>) -> Option<()> {
        let (Some(turn), Some(count)) = (self.turn, count) else {
            return Some(());
        };
        let own = fold::constant(&self.model.repeats[turn.repeat.0].count);
        let Some(own) = own.filter(|own| *own <= MOST_TRIED) else {
            return Some(());
        };
        let numbers = (0..own as usize).map(|at| (at, fold::at_index(value, at as f64)));
        for (at, number) in numbers {
            if let Some(number) = number.filter(|number| !(0.0..count).contains(number)) {
                let index = turn.name.unwrap_or_default();
                let [at, number, last] = [at as f64, number, count - 1.0].map(|number| number.to_string());
                let message = say::runs_out(index, &at, &number, &name.text, &last);
                self.errors.at(expr.area, message);
                return None;
            }
        }
        Some(())
    }

    /// An expression of the index, whole numbers and counts with `+`, `-`, `*` and `%`.
    fn number_of(&mut self, expr: &'a Expr) -> Option<Value> {
        self.nested(expr, |check| check.number_node(expr))
    }

    fn number_node(&mut self, expr: &'a Expr) -> Option<Value> {
        let message = match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Name(_) => {
                let typed = self.expr(expr, Scope::Parameter)?;
                let is_whole = |value: f64| value.trunc() == value && value.abs() <= 1e9;
                match &typed.value {
                    Value::Index => return Some(Value::Index),
                    Value::Param(id) if self.model.params[id.0].is_count => return Some(typed.value),
                    Value::Number(value) if typed.dimension.is_none() && !typed.nature.angle && is_whole(*value) => {
                        return Some(typed.value);
                    }
                    _ => say::WHOLE_REPETITION,
                }
            }
            ExprKind::Index(number) => return Some(Value::Number(*number as f64)),
            ExprKind::Negate(inner) => return Some(Value::Negate(Box::new(self.number_of(inner)?))),
            ExprKind::Binary(operator, left, right) if *operator != Binary::Divide => {
                let (left, right) = (self.number_of(left), self.number_of(right));
                return Some(Value::Binary(*operator, Box::new(left?), Box::new(right?)));
            }
            ExprKind::Remainder(left, right) => {
                let (value, divisor) = (self.number_of(left), self.number_of(right));
                let divisor = divisor?;
                if fold::constant(&divisor) == Some(0.0) {
                    self.errors.at(right.area, say::DIVISION_BY_ZERO);
                    return None;
                }
                return Some(Value::Call(Function::Remainder, vec![value?, divisor]));
            }
            _ => say::REPETITION_EXPRESSION,
        };
        self.errors.at(expr.area, message);
        None
    }

    /// `max(a in 0..n, value)`
    pub(in crate::check) fn reduced(&mut self, expr: &Expr, reduced: &'a Reduced, scope: Scope) -> Option<Typed> {
        if scope != Scope::Output {
            self.errors.at(expr.area, say::REDUCED_OUTSIDE);
            return None;
        }
        if self.turn.is_some() {
            self.errors.at(expr.area, say::NESTED_REDUCTION);
            return None;
        }
        self.may_be_index(&reduced.index);
        let count = self.repetitions(&reduced.count);
        let repeat = self.loop_of(&reduced.index.text, count.clone().unwrap_or(UNKNOWN));
        self.turn = Some(Turn {
            name: Some(&reduced.index.text),
            repeat,
        });
        let typed = self.expr(&reduced.value, scope);
        self.turn = None;
        count?;
        let typed = typed?;
        let value = Value::Observed(Observable::Reduced {
            reduction: reduced.reduction,
            repeat,
            value: Box::new(typed.value),
        });
        Some(Typed { value, ..typed })
    }

    /// The loop that has this number of repetitions; one of its own where none has.
    fn loop_of(&mut self, index: &str, count: Value) -> RepeatId {
        let repeats = &mut self.model.repeats;
        let known = repeats.iter().position(|repeat| repeat.count == count);
        RepeatId(known.unwrap_or_else(|| {
            let index = index.to_string();
            repeats.push(Repeat { index, count });
            repeats.len() - 1
        }))
    }

    /// Refuses what is seen from elsewhere of a repetition without a number of its own: markers are single.
    pub(in crate::check) fn is_single(&mut self, expr: &Expr, at: &Location) -> Option<()> {
        if !has_index(at) {
            return Some(());
        }
        self.errors.at(expr.area, say::MOVING_REPETITION);
        None
    }

    /// Refuses loads that are not repeated.
    pub(in crate::check) fn may_repeat_load(&mut self, item: &Item) -> bool {
        let ItemKind::Load(call) = &item.kind else { return true };
        let single = ["gravity", "force", "moment", "follower"];
        if item.repeat.is_none() || !single.contains(&call.name.text.as_str()) {
            return true;
        }
        self.errors.at(call.name.span, say::load_not_repeated(&call.name.text));
        false
    }
}

/// Whether a place depends on the index of a loop.
pub fn has_index(at: &Location) -> bool {
    match at {
        Location::Start | Location::End => false,
        Location::At(x) | Location::Part(x) => fold::has_index(x),
        Location::Of { instance, place } => fold::has_index(instance) || has_index(place),
    }
}

/// A place on one repetition, or on a body that is not repeated.
pub fn place_of(instance: Option<model::Expr>, place: Location) -> Location {
    match instance {
        Some(instance) => Location::Of {
            instance: Box::new(instance),
            place: Box::new(place),
        },
        None => place,
    }
}
