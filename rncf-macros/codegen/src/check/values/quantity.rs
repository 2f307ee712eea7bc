//! Values of expressions with their dimensions, and fields that ask for a certain one.

use super::scope::Scope;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::model;
use crate::parse::tree::{Expr, ExprKind, ItemKind, UnitText};
use crate::units::{Compound, Dimension};

/// A resolved expression and what it is.
#[derive(Clone, Debug)]
pub struct Typed {
    /// Value in SI.
    pub value: model::Expr,
    /// Dimension; an angle is a plain number.
    pub dimension: Dimension,
    /// How it was written.
    pub nature: Nature,
}

/// How a quantity was written. An angle is a plain number in the algebra; that it *is* one must
/// show in the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nature {
    /// A unit of angle, pi or an inverse trigonometric function is a factor.
    pub angle: bool,
    /// Exponent of units of angle.
    pub turns: i8,
    /// Exponent of hertz.
    pub hertz: i8,
    /// Exponent of pi.
    pub pi: i8,
}

impl Nature {
    /// That of an angle.
    pub fn angular() -> Nature {
        Nature::of_unit(1)
    }

    /// That of a unit with so many factors that are angles.
    pub fn of_unit(turns: i8) -> Nature {
        Nature {
            angle: turns != 0,
            turns,
            ..Nature::default()
        }
    }

    /// Of a sum, or of one of two cases.
    #[must_use]
    pub fn plus(self, other: Nature) -> Nature {
        // What counts cycles, or has made angles of them, says which; a phase beside it does not.
        let (hertz, pi) = match (self.hertz, other.hertz) {
            (0, 0) | (1.., 1..) | (..0, ..0) if self.pi != other.pi => (self.hertz, 0),
            (0, _) => (other.hertz, other.pi),
            _ => (self.hertz, self.pi),
        };
        Nature {
            angle: self.angle || other.angle,
            turns: if self.turns == 0 { other.turns } else { self.turns },
            hertz,
            pi,
        }
    }

    /// Of a product.
    #[must_use]
    pub fn times(self, other: Nature) -> Nature {
        let [turns, hertz, pi] = [
            [self.turns, other.turns],
            [self.hertz, other.hertz],
            [self.pi, other.pi],
        ]
        .map(|[a, b]| a.saturating_add(b));
        // A ratio of two speeds of rotation is a number.
        let is_ratio = self.turns != 0 && turns == 0 && pi == 0;
        Nature {
            angle: (self.angle || other.angle) && !is_ratio,
            turns,
            hertz,
            pi,
        }
    }

    /// Of a quotient.
    #[must_use]
    pub fn over(self, other: Nature) -> Nature {
        let below = Nature {
            turns: other.turns.saturating_neg(),
            hertz: other.hertz.saturating_neg(),
            pi: other.pi.saturating_neg(),
            ..other
        };
        self.times(below)
    }

    /// Whether it counts cycles: hertz is a factor, and no `2*pi` makes angles of them.
    pub fn counts_cycles(self) -> bool {
        self.hertz > 0 && self.pi <= 0
    }

    /// Whether it is told as an angle where a `2*pi` below the line has made cycles of it, or counts cycles by itself.
    pub fn is_no_angle(self) -> bool {
        self.counts_cycles() || self.angle && self.pi < 0
    }

    /// Whether it is an angle, or an angular velocity, which hertz does not measure.
    pub fn is_no_cycle(self) -> bool {
        self.angle && self.pi >= 0 && !self.counts_cycles()
    }

    /// What is wrong with telling it in a unit that counts cycles or angles.
    pub fn misread_in(self, unit: &UnitText, compound: Compound) -> Option<&'static str> {
        if hertz(unit) != 0 {
            return self.is_no_cycle().then_some(say::ANGLE_IN_HERTZ);
        }
        (compound.dimension[5] != 0 && self.is_no_angle()).then_some(say::CYCLES_AS_ANGLE)
    }

    /// Whether one of two terms counts cycles and the other one angles.
    pub fn clashes(self, other: Nature) -> bool {
        let clash = |cycles: Nature, angle: Nature| cycles.counts_cycles() && angle.is_no_cycle();
        clash(self, other) || clash(other, self)
    }
}

impl Typed {
    pub fn new(value: model::Expr, dimension: Dimension) -> Self {
        Self {
            value,
            dimension,
            nature: Nature::default(),
        }
    }

    pub fn describe(&self) -> String {
        self.dimension.describe(self.nature.angle)
    }

    /// Whether it is a time.
    pub fn is_time(&self) -> bool {
        self.dimension == Dimension::of([0, 0, 1, 0, 0, 0])
    }
}

/// What a field asks for.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// The field in a sentence: `the radius`.
    pub what: &'static str,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// A unit to suggest.
    pub unit: &'static str,
}

impl Wanted {
    /// A field of this dimension.
    pub const fn new(what: &'static str, dimension: [i8; 6], unit: &'static str) -> Self {
        Self { what, dimension, unit }
    }
}

/// A vector and where its components stand.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Components in SI.
    pub values: [model::Expr; 3],
    /// Their places.
    pub areas: [Area; 3],
    /// All of it.
    pub area: Area,
}

impl Vector {
    /// Value with some numbers for the params, see [`fold::sampled`].
    pub fn sampled(&self, sample: usize) -> Option<[f64; 3]> {
        let [x, y, z] = self.values.each_ref().map(|value| fold::sampled(value, sample));
        Some([x?, y?, z?])
    }

    /// Constant value, where it is one.
    pub fn constant(&self) -> Option<[f64; 3]> {
        let [x, y, z] = self.values.each_ref().map(fold::constant);
        Some([x?, y?, z?])
    }
}

/// The text of a literal without unit, its sign included.
pub fn bare_literal(expr: &Expr) -> Option<String> {
    match &expr.kind {
        ExprKind::Number { text, unit: None } => Some(text.clone()),
        ExprKind::Negate(inner) => bare_literal(inner).map(|text| format!("-{text}")),
        _ => None,
    }
}

/// A unit as it stands behind a number in an expression: compound ones in brackets.
pub fn behind_number(unit: &str) -> String {
    let is_single = unit.chars().all(|c| c.is_ascii_alphabetic());
    if is_single { unit.into() } else { format!("[{unit}]") }
}

/// Exponent of hertz in a unit; `1/min` is one, by which many trades tell turns.
pub fn hertz(unit: &UnitText) -> i8 {
    if let [(name, -1)] = &unit.factors[..]
        && name.text == "min"
    {
        return 1;
    }
    let of = |exponent: i32| i8::try_from(exponent).unwrap_or_default();
    let factors = unit.factors.iter().filter(|(name, _)| name.text.ends_with("Hz"));
    factors.fold(0, |sum, (_, exponent)| sum.saturating_add(of(*exponent)))
}

/// Whether it is a zero without unit, which fits any dimension.
pub fn is_bare_zero(expr: &Expr) -> bool {
    bare_literal(expr).is_some_and(|text| text.parse::<f64>().is_ok_and(|value| value == 0.0))
}

impl<'a> Check<'a> {
    /// An expression of the dimension that a field asks for.
    pub(in crate::check) fn quantity(&mut self, expr: &'a Expr, scope: Scope, wanted: Wanted) -> Option<model::Expr> {
        let typed = self.expr(expr, scope)?;
        if !self.is_wanted(expr, &typed, wanted) {
            return None;
        }
        self.is_finite(&typed.value, expr.area)?;
        Some(typed.value)
    }

    /// Whether the dimension is what the field asks for; reports where it is not.
    pub(in crate::check) fn is_wanted(&mut self, expr: &Expr, typed: &Typed, wanted: Wanted) -> bool {
        let dimension = Dimension::of(wanted.dimension);
        if typed.dimension == dimension {
            return true;
        }
        let kind = dimension.describe(wanted.dimension[5] != 0);
        let is_angle = dimension.is_none() && wanted.dimension[5] != 0;
        let message = match (bare_literal(expr), self.bare_declaration(expr)) {
            (Some(text), _) => say::no_unit(wanted.what, &kind, &text, wanted.unit),
            (None, Some((name, text))) => say::bare_declaration(wanted.what, &kind, name, &text, wanted.unit),
            _ if is_angle && typed.is_time() => say::angle_of_time(wanted.what, &kind),
            _ => say::wrong_dimension(wanted.what, &kind, &typed.describe()),
        };
        self.errors.at(expr.area, message);
        false
    }

    /// The name of a param or constant that is declared as a number without unit, and this number.
    fn bare_declaration<'b>(&self, expr: &'b Expr) -> Option<(&'b str, String)> {
        let ExprKind::Name(name) = &expr.kind else {
            return None;
        };
        let value = match &self.names.get(name.text.as_str())?.kind {
            ItemKind::Param { count: false, value } => value.as_ref()?,
            ItemKind::Const(value) => value,
            _ => return None,
        };
        Some((&name.text, bare_literal(value)?))
    }

    /// An angle: a plain number that is written as an angle.
    pub(in crate::check) fn angle(&mut self, expr: &'a Expr, scope: Scope, what: &'static str) -> Option<model::Expr> {
        let typed = self.expr(expr, scope)?;
        if let Some(term) = bare_term(expr) {
            let text = bare_literal(term).unwrap_or_default();
            self.errors.at(term.area, say::bare_angle(what, &text));
            return None;
        }
        let wanted = Wanted {
            what,
            dimension: [0, 0, 0, 0, 0, 1],
            unit: "rad",
        };
        if !self.is_wanted(expr, &typed, wanted) {
            return None;
        }
        if typed.nature.counts_cycles() {
            self.errors.at(expr.area, say::HERTZ);
            return None;
        }
        if !typed.nature.angle {
            self.errors.at(expr.area, say::plain_angle(what));
            return None;
        }
        Some(typed.value)
    }

    /// Refuses a number without unit that is added to an angle or compared with one, where both stand by themselves: `angle - 45`. In a
    /// product an angle is a number like others.
    pub(super) fn no_number_beside(&mut self, (angle, nature): (&Expr, Nature), other: &Expr) -> Option<()> {
        let stands_alone = match &angle.kind {
            ExprKind::Negate(inner) => is_single(inner),
            _ => is_single(angle),
        };
        match nature.is_no_cycle() && stands_alone {
            true => self.no_bare_number("what stands beside an angle", other),
            false => Some(()),
        }
    }

    /// Refuses a number without unit where an angle is meant.
    pub(super) fn no_bare_number(&mut self, what: &'static str, other: &Expr) -> Option<()> {
        if is_bare_zero(other) {
            return Some(());
        }
        let message = match (bare_literal(other), self.bare_declaration(other)) {
            (Some(text), _) => say::bare_angle(what, &text),
            (None, Some((name, text))) => say::bare_declaration(what, "an angle", name, &text, "rad"),
            (None, None) => return Some(()),
        };
        self.errors.at(other.area, message);
        None
    }

    /// A vector of the dimension that a field asks for.
    pub(in crate::check) fn vector(&mut self, expr: &'a Expr, scope: Scope, wanted: Wanted) -> Option<Vector> {
        let (values, areas) = self.components(expr, scope, wanted)?;
        Some(Vector {
            values: values.try_into().ok()?,
            areas: areas.try_into().ok()?,
            area: expr.area,
        })
    }

    /// The components of a vector of any length, and their places.
    pub(in crate::check) fn components(
        &mut self,
        expr: &'a Expr,
        scope: Scope,
        wanted: Wanted,
    ) -> Option<(Vec<model::Expr>, Vec<Area>)> {
        let ExprKind::Vector { components, unit } = &expr.kind else {
            if !expr.has_vector() {
                self.errors.at(expr.area, say::vector_wanted(wanted.what, wanted.unit));
                return None;
            }
            let vector = self.wanted_vector(expr, scope, wanted)?;
            return Some((vector.values.into(), vec![expr.area; 3]));
        };
        if self.split_vector(expr) {
            return None;
        }
        let unit = self.unit_behind(unit.as_ref(), wanted)?;
        let values = self.in_unit(components, unit, scope, wanted)?;
        let areas = components.iter().map(|component| component.area).collect();
        Some((values, areas))
    }

    /// The unit behind a vector or matrix, where there is one: that of the field.
    pub(in crate::check) fn unit_behind(
        &mut self,
        unit: Option<&UnitText>,
        wanted: Wanted,
    ) -> Option<Option<Compound>> {
        let Some(unit) = unit else { return Some(None) };
        let compound = self.unit(unit)?;
        if Dimension::of(compound.dimension) != Dimension::of(wanted.dimension) {
            let kind = Dimension::of(wanted.dimension).describe(wanted.dimension[5] != 0);
            let found = Dimension::of(compound.dimension).describe(compound.dimension[5] != 0);
            self.errors
                .at(unit.area, say::wrong_dimension(wanted.what, &kind, &found));
            return None;
        }
        Some(Some(compound))
    }

    /// Components with a unit behind them, or with units of their own.
    pub(in crate::check) fn in_unit(
        &mut self,
        components: &'a [Expr],
        unit: Option<Compound>,
        scope: Scope,
        wanted: Wanted,
    ) -> Option<Vec<model::Expr>> {
        let values = components.iter().map(|component| match unit {
            None => self.component(component, scope, wanted),
            Some(unit) => {
                let typed = self.with_unit(component, (unit, 0), scope)?;
                self.is_finite(&typed.value, component.area)?;
                Some(typed.value)
            }
        });
        // All mistakes are told at once.
        values.collect::<Vec<_>>().into_iter().collect()
    }

    /// An angular velocity: hertz is refused.
    pub(in crate::check) fn rate(&mut self, expr: &'a Expr, scope: Scope, wanted: Wanted) -> Option<model::Expr> {
        let value = self.quantity(expr, scope, wanted)?;
        self.is_no_frequency(expr, scope).then_some(value)
    }

    /// Whether hertz is no factor of an expression that has been resolved before.
    pub(super) fn is_no_frequency(&mut self, expr: &'a Expr, scope: Scope) -> bool {
        let is_hertz = self.expr(expr, scope).is_some_and(|typed| typed.nature.counts_cycles());
        self.is_told_in_angles(expr.area, is_hertz)
    }

    /// Reports what counts cycles where angles are asked for.
    pub(super) fn is_told_in_angles(&mut self, area: Area, is_hertz: bool) -> bool {
        if is_hertz {
            self.errors.at(area, say::HERTZ);
        }
        !is_hertz
    }

    /// A component with its own unit; zero needs none.
    fn component(&mut self, expr: &'a Expr, scope: Scope, wanted: Wanted) -> Option<model::Expr> {
        if is_bare_zero(expr) {
            return Some(model::Expr::Number(0.0));
        }
        if let Some(text) = bare_literal(expr) {
            let kind = Dimension::of(wanted.dimension).describe(wanted.dimension[5] != 0);
            if !Dimension::of(wanted.dimension).is_none() {
                self.errors.at(
                    expr.area,
                    say::no_unit(wanted.what, &kind, &text, &behind_number(wanted.unit)),
                );
                return None;
            }
        }
        self.quantity(expr, scope, wanted)
    }

    /// A component of brackets with a unit behind them: numbers are multiplied by it, values of its dimension stay.
    pub(in crate::check) fn with_unit(&mut self, expr: &'a Expr, unit: (Compound, i8), scope: Scope) -> Option<Typed> {
        let (compound, hertz) = unit;
        let is_angle = compound.dimension[5] != 0;
        let in_unit = |value| Typed {
            value,
            dimension: Dimension::of(compound.dimension),
            nature: Nature {
                hertz,
                ..Nature::of_unit(compound.dimension[5])
            },
        };
        match &expr.kind {
            ExprKind::Number { text, unit: None } => {
                let value = self.number(text, compound, expr.area)?;
                return Some(in_unit(model::Expr::Number(value)));
            }
            ExprKind::Negate(inner) if bare_literal(inner).is_some() => {
                let value = match self.with_unit(inner, unit, scope)?.value {
                    model::Expr::Number(value) => model::Expr::Number(-value),
                    other => model::Expr::Negate(Box::new(other)),
                };
                return Some(in_unit(value));
            }
            _ => {}
        }
        let typed = self.expr(expr, scope)?;
        let is_number = typed.dimension.is_none() && !typed.nature.angle;
        if is_number {
            let one = self.number("1", compound, expr.area)?;
            let both = (Box::new(typed.value), Box::new(model::Expr::Number(one)));
            return Some(in_unit(model::Expr::Binary(model::Binary::Multiply, both.0, both.1)));
        }
        let wanted = Dimension::of(compound.dimension);
        if typed.dimension != wanted || wanted.is_none() && !is_angle {
            let kind = wanted.describe(is_angle);
            self.errors
                .at(expr.area, say::unit_of_expression(&typed.describe(), &kind));
            return None;
        }
        Some(typed)
    }
}

/// Whether it is one number, name or call.
fn is_single(expr: &Expr) -> bool {
    matches!(
        expr.kind,
        ExprKind::Number { .. } | ExprKind::Name(_) | ExprKind::Member { .. } | ExprKind::Call(_)
    )
}

/// The first literal without unit that is a term of a sum.
fn bare_term(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Number { unit: None, .. } if !is_bare_zero(expr) => Some(expr),
        ExprKind::Negate(inner) => bare_term(inner),
        ExprKind::Binary(model::Binary::Add | model::Binary::Subtract, left, right) => {
            bare_term(left).or_else(|| bare_term(right))
        }
        ExprKind::If(inner) => bare_term(&inner.then).or_else(|| bare_term(&inner.otherwise)),
        _ => None,
    }
}
