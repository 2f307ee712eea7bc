//! Units behind numbers.

use crate::check::{Check, say};
use crate::errors::Area;
use crate::parse::ascii;
use crate::parse::tree::{Keyword, Name, UnitText};
use crate::suggest;
use crate::units::{self, Compound, ScaleError};

impl Check<'_> {
    /// Resolves a unit; every unknown symbol is reported.
    pub(in crate::check) fn unit(&mut self, text: &UnitText) -> Option<Compound> {
        let mut compound = Some(Compound::ONE);
        for (at, (name, exponent)) in text.factors.iter().enumerate() {
            let Some(unit) = self.symbol(name, at, text) else {
                compound = None;
                continue;
            };
            if let Some(so_far) = compound {
                compound = so_far.times(unit, *exponent);
                if compound.is_none() {
                    self.errors.at(text.area, say::EXPONENT_RANGE);
                }
            }
        }
        if compound.is_some_and(|compound| !(compound.si().is_finite() && compound.si() > 0.0)) {
            self.errors.at(text.area, say::EXPONENT_RANGE);
            return None;
        }
        compound
    }

    fn symbol(&mut self, name: &Name, at: usize, text: &UnitText) -> Option<&'static units::Unit> {
        let word = name.text.as_str();
        // A name that never is a number cannot be meant behind one.
        let is_declared = self.names.get(word).is_some_and(|item| is_number(item.keyword));
        let found = units::find(word);
        let message = match found {
            // Behind the first symbol a declared name could be meant as a value.
            Some(_) if is_declared && at > 0 && !text.is_delimited => {
                let first = self.clashes.entry(word.to_string()).or_insert_with(|| text.clone());
                if text.area.line() < first.area.line() {
                    *first = text.clone();
                }
                return None;
            }
            Some(_) if word == "t" && text.factors.len() == 1 && !text.is_delimited => say::LONE_T.into(),
            Some(unit) => return Some(unit),
            None if is_declared && at == 0 => say::missing_star(word),
            None if is_declared || at > 0 && self.is_told(word) => {
                let sign = if text.factors[at].1 < 0 { "/" } else { "*" };
                say::name_in_unit(word, &text.factors[0].0.text, sign)
            }
            None => match ascii::suggestion(word) {
                Some(plain) => say::not_ascii(word, &plain),
                None => unknown(word),
            },
        };
        self.errors.at(name.span, message);
        None
    }

    /// Whether a part is told a value of this name.
    fn is_told(&self, word: &str) -> bool {
        let is_it = |name: &str| name.rsplit_once('.').is_some_and(|(_, own)| own == word);
        self.tree.given.iter().any(|given| is_it(&given.name))
    }

    /// Names that could be units as well, each told once, where it is declared.
    pub(in crate::check) fn names_as_units(&mut self) {
        let mut clashes: Vec<_> = std::mem::take(&mut self.clashes).into_iter().collect();
        clashes.sort_by_key(|(name, unit)| (unit.area.line(), name.clone()));
        for (name, unit) in clashes {
            let message = say::unit_or_name(&name, &unit.text, &unit.area.line().to_string());
            let declared = self.names.get(name.as_str()).map(|item| Area::from(item.name.span));
            self.errors.at(declared.unwrap_or(unit.area), message);
        }
    }

    /// Value in SI of a literal.
    pub(in crate::check) fn number(&mut self, text: &str, unit: Compound, area: Area) -> Option<f64> {
        match units::scale(text, unit) {
            Ok(value) => Some(value),
            Err(ScaleError::NotDecimal) => {
                self.errors.at(area, say::not_a_number(text));
                None
            }
            Err(ScaleError::Range) => {
                self.errors.at(area, say::number_range(text));
                None
            }
        }
    }
}

/// Whether the name of an item stands for a number.
fn is_number(keyword: Keyword) -> bool {
    matches!(
        keyword,
        Keyword::Param | Keyword::Const | Keyword::Let | Keyword::Motion
    )
}

/// The unit that was meant, or some that there are.
fn unknown(word: &str) -> String {
    let symbols: Vec<&str> = units::UNITS.iter().map(|unit| unit.symbol).collect();
    // Of three letters one other one is another unit.
    let is_alike = |near: &&str| word.len() > 3 || near.eq_ignore_ascii_case(word);
    let near = || {
        suggest::nearest(word, &symbols)
            .filter(is_alike)
            .map(ToString::to_string)
    };
    match units::meant(word).or_else(near) {
        Some(near) => say::unknown_unit_near(word, &near),
        None => say::unknown_unit(word),
    }
}
