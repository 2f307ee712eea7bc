//! Parameters, constants, and the defaults of a run.

use super::quantity::{Nature, Typed, Wanted};
use super::scope::Scope;
use crate::check::{Check, fold, say};
use crate::model::{Begin, Binary, Expr as Value, Param, ParamId};
use crate::parse::tree::{Expr, ExprKind, Item, ItemKind, UnitText};
use crate::suggest;

const RUN_FIELDS: &[&str] = &["t_end", "every", "start"];
/// Words for the start of a run.
const STARTS: [(&str, Begin); 3] = [
    ("rest", Begin::Rest),
    ("moving", Begin::Moving),
    ("steady", Begin::Steady),
];

impl<'a> Check<'a> {
    /// Parameters in order, then constants.
    pub(in crate::check) fn params(&mut self) {
        for item in self.tree.params() {
            let (count, value) = match &item.kind {
                ItemKind::Param { count, value } => (count, value),
                ItemKind::FileTable { .. } => {
                    self.model.params.push(table_param(item));
                    continue;
                }
                _ => continue,
            };
            let param = value.as_ref().and_then(|value| {
                if *count {
                    self.count_param(item, value)
                } else {
                    self.quantity_param(item, value)
                }
            });
            let typed = param.map(|(param, nature)| {
                let id = ParamId(self.model.params.len());
                let typed = Self::reference(id, param.dimension, nature);
                self.model.params.push(param);
                typed
            });
            self.values.insert(item.name.text.as_str(), typed);
        }
        self.given();
        self.constants();
    }

    fn quantity_param(&mut self, item: &Item, value: &'a Expr) -> Option<(Param, Nature)> {
        let typed = self.folded(value)?;
        let Some(dimension) = typed.dimension.exponents(typed.nature.angle) else {
            self.errors.at(value.area, say::WHOLE_EXPONENTS);
            return None;
        };
        let written = literal_unit(value);
        let (unit, unit_si, dimension) = match written.and_then(|unit| Some((unit, self.unit(unit)?))) {
            Some((unit, compound)) => (unit.text.clone(), compound.si(), compound.dimension),
            None => (typed.dimension.symbol(typed.nature.angle), 1.0, dimension),
        };
        let default = fold::constant(&typed.value)?;
        let (name, doc) = (item.name.text.clone(), item.doc.clone());
        Some((
            Param {
                name,
                doc,
                unit,
                unit_si,
                dimension,
                default,
                is_count: false,
                is_table: false,
            },
            typed.nature,
        ))
    }

    fn count_param(&mut self, item: &Item, value: &'a Expr) -> Option<(Param, Nature)> {
        let typed = self.folded(value)?;
        let default = fold::constant(&typed.value)?;
        if !is_count(&typed, default) {
            self.errors.at(value.area, say::NOT_A_COUNT);
            return None;
        }
        let (name, doc) = (item.name.text.clone(), item.doc.clone());
        let unit = "1".to_string();
        Some((
            Param {
                name,
                doc,
                unit,
                unit_si: 1.0,
                dimension: [0; 6],
                default,
                is_count: true,
                is_table: false,
            },
            Nature::default(),
        ))
    }

    /// The number of elements of a mesh.
    pub(in crate::check) fn count(&mut self, expr: &'a Expr) -> Option<Value> {
        self.whole(expr, say::NOT_A_COUNT, say::quantity_as_count)
    }

    /// The number of repetitions of a loop or reduction.
    pub(in crate::check) fn repetitions(&mut self, expr: &'a Expr) -> Option<Value> {
        self.whole(expr, say::NOT_REPETITIONS, say::quantity_as_repetitions)
    }

    /// The number of modes of a body.
    pub(in crate::check) fn modes(&mut self, expr: &'a Expr) -> Option<Value> {
        self.whole(expr, say::NOT_MODES, say::quantity_as_modes)
    }

    /// A count: a whole number, a count parameter, or both with `+`, `-` and `*`; what is said of others. What is computed
    /// from parameters is known to be at least 1 when the model is built.
    fn whole(&mut self, expr: &'a Expr, not_a_count: &str, quantity: fn(&str) -> String) -> Option<Value> {
        let typed = self.expr(expr, Scope::Parameter)?;
        match &typed.value {
            Value::Param(id) if self.model.params[id.0].is_count => return Some(typed.value),
            Value::Param(id) => {
                let name = self.model.params[id.0].name.clone();
                self.errors.at(expr.area, quantity(&name));
            }
            value if fold::has_index(value) => self.errors.at(expr.area, say::INDEX_AS_COUNT),
            value if fold::constant(value).is_none() && self.is_made_of_counts(value) => return Some(typed.value),
            value if self.reads_a_count(value) => self.errors.at(expr.area, say::COUNT_OF_COUNTS),
            value => match fold::constant(value) {
                Some(value) if is_count(&typed, value) => return Some(Value::Number(value)),
                _ => self.errors.at(expr.area, not_a_count),
            },
        }
        None
    }

    /// Whether the value is a whole number whatever the count parameters are.
    fn is_made_of_counts(&self, value: &Value) -> bool {
        match value {
            Value::Number(number) => number.trunc() == *number,
            Value::Param(id) => self.model.params[id.0].is_count,
            Value::Negate(inner) => self.is_made_of_counts(inner),
            Value::Binary(operator, left, right) => {
                *operator != Binary::Divide && self.is_made_of_counts(left) && self.is_made_of_counts(right)
            }
            _ => false,
        }
    }

    fn reads_a_count(&self, value: &Value) -> bool {
        value.contains(&|value| matches!(value, Value::Param(id) if self.model.params[id.0].is_count))
    }

    /// `run { t_end = ..; every = ..; start = ..; }`
    pub(in crate::check) fn run(&mut self) {
        for (at, run) in self.tree.runs.iter().enumerate() {
            if at > 0 {
                let line = self.tree.runs[0].area.line();
                self.errors
                    .at(run.area, say::duplicate_statement("`run`", &line.to_string()));
            }
            let mut seen: Vec<&str> = Vec::new();
            for field in &run.fields {
                let name = field.name.text.as_str();
                if !RUN_FIELDS.contains(&name) {
                    let message = suggest::unknown("field of `run`", name, RUN_FIELDS.iter().copied());
                    self.errors.at(field.name.span, message);
                    continue;
                }
                if seen.contains(&name) {
                    self.errors.at(field.name.span, say::twice(name));
                }
                seen.push(name);
                if name == "start" {
                    self.start_of_run(&field.value);
                    continue;
                }
                let is_end = name == "t_end";
                let what = if is_end { "`t_end`" } else { "`every`" };
                let wanted = Wanted {
                    what,
                    dimension: [0, 0, 1, 0, 0, 0],
                    unit: "s",
                };
                let Some(value) = self.quantity(&field.value, Scope::Parameter, wanted) else {
                    continue;
                };
                if fold::constant(&value).is_some_and(|value| value.is_nan() || value <= 0.0) {
                    self.errors.at(field.value.area, say::positive(what));
                }
                if is_end {
                    self.model.run.t_end = value;
                } else {
                    self.model.run.every = value;
                }
            }
            let [every, t_end] = [&self.model.run.every, &self.model.run.t_end].map(fold::constant);
            let given = run.fields.iter().find(|field| field.name.text == "every");
            if let (Some(every), Some(t_end), Some(given)) = (every, t_end, given)
                && every > t_end
                && t_end > 0.0
            {
                self.errors.at(given.value.area, say::EVERY_BEYOND);
            }
        }
    }

    fn start_of_run(&mut self, value: &Expr) {
        let word = match &value.kind {
            ExprKind::Name(name) => name.text.as_str(),
            _ => "",
        };
        match STARTS.iter().find(|(known, _)| *known == word) {
            Some(&(_, start)) => self.model.run.start = start,
            None => self
                .errors
                .at(value.area, say::choices("start", "`rest`, `moving` or `steady`")),
        }
    }
}

/// A parameter whose value is a file.
fn table_param(item: &Item) -> Param {
    Param {
        name: item.name.text.clone(),
        doc: item.doc.clone(),
        unit: "1".to_string(),
        unit_si: 1.0,
        dimension: [0; 6],
        default: 0.0,
        is_count: false,
        is_table: true,
    }
}

fn is_count(typed: &Typed, value: f64) -> bool {
    let is_plain = typed.dimension.is_none() && !typed.nature.angle;
    is_plain && (1.0..=1e9).contains(&value) && value.trunc() == value
}

/// Unit of a whole right side that is a literal.
fn literal_unit(expr: &Expr) -> Option<&UnitText> {
    match &expr.kind {
        ExprKind::Number { unit, .. } => unit.as_ref(),
        ExprKind::Negate(inner) => literal_unit(inner),
        _ => None,
    }
}
