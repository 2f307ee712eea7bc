//! Constant values, and what an expression depends on: time, place, repetition.

use super::Model;
use super::body::Body;
use super::expression::{Binary, Comparison, Expr, Function};
use super::ids::TableId;

/// Value of an expression of numbers only.
pub fn constant(expr: &Expr) -> Option<f64> {
    value(expr, &|_| None)
}

/// Value of an expression of numbers and the index of a loop.
pub fn at_index(expr: &Expr, index: f64) -> Option<f64> {
    value(expr, &|leaf| matches!(leaf, Expr::Index).then_some(index))
}

/// Value at a time with the parameters' defaults, in the first repetition; nothing is observed.
pub fn with_defaults(model: &Model, expr: &Expr, t: f64) -> Option<f64> {
    of_repetition(model, expr, t, 0.0)
}

/// Value at a time with the parameters' defaults, in a repetition; nothing is observed.
pub fn of_repetition(model: &Model, expr: &Expr, t: f64, index: f64) -> Option<f64> {
    value(expr, &|leaf| match leaf {
        Expr::Param(id) => model.params.get(id.0).map(|param| param.default),
        Expr::Time => Some(t),
        Expr::Index => Some(index),
        Expr::Motion(id, at) => {
            let at = of_repetition(model, at, t, index)?;
            with_defaults(model, &model.motions[id.0].value, at)
        }
        Expr::Lookup { table, column, at } => {
            let place = of_repetition(model, at, t, index)?;
            Some(model.tables[table.0].look_up(*column, 0, place))
        }
        _ => None,
    })
}

/// Value at the arclength `x` of an axis with a length, with the parameters' defaults; not a number where it has none.
pub fn along(model: &Model, expr: &Expr, x: f64, length: f64) -> f64 {
    let found = value(expr, &|leaf| match leaf {
        Expr::Param(id) => model.params.get(id.0).map(|param| param.default),
        Expr::Arclength => Some(x),
        Expr::Table { table, column } => Some(model.tables[table.0].value(*column, x, length)),
        _ => None,
    });
    found.unwrap_or(f64::NAN)
}

/// Value at the arclength `x` of an axis with a length; `None` where it depends on params, time or repetition.
pub fn fixed_along(model: &Model, expr: &Expr, x: f64, length: f64) -> Option<f64> {
    value(expr, &|leaf| match leaf {
        Expr::Arclength => Some(x),
        Expr::Table { table, column } => Some(model.tables[table.0].value(*column, x, length)),
        _ => None,
    })
}

/// How many times [`sampled`] is asked.
pub const SAMPLES: usize = 3;

/// Value where every param, motion, index and the time have some number of their own, another one for each sample: what
/// holds for all samples holds whatever the params are. Nothing is observed.
pub fn sampled(expr: &Expr, sample: usize) -> Option<f64> {
    // Multiples of the golden ratio: between 1/2 and 3/2, no two alike.
    let some = |name: usize| 0.5 + ((1 + name * SAMPLES + sample) as f64 * 0.618_033_988_749_894_9).fract();
    value(expr, &|leaf| match leaf {
        Expr::Time => Some(some(0)),
        Expr::Index => Some(some(1)),
        Expr::Param(id) => Some(some(2 + 2 * id.0)),
        Expr::Motion(id, _) => Some(some(3 + 2 * id.0)),
        _ => None,
    })
}

/// Value of an expression, what is no number being asked for.
fn value(expr: &Expr, leaf: &dyn Fn(&Expr) -> Option<f64>) -> Option<f64> {
    let constant = |expr| value(expr, leaf);
    Some(match expr {
        Expr::Number(value) => *value,
        Expr::Param(_)
        | Expr::Time
        | Expr::Arclength
        | Expr::Table { .. }
        | Expr::Index
        | Expr::Local { .. }
        | Expr::EndTime
        | Expr::Strain(_)
        | Expr::Element(_)
        | Expr::Motion(..)
        | Expr::Lookup { .. }
        | Expr::Slope(..)
        | Expr::Rate(_)
        | Expr::Observed(_) => {
            return leaf(expr);
        }
        Expr::Negate(inner) => -constant(inner)?,
        Expr::Binary(operator, left, right) => {
            let (left, right) = (constant(left)?, constant(right)?);
            match operator {
                Binary::Add => left + right,
                Binary::Subtract => left - right,
                Binary::Multiply => left * right,
                Binary::Divide => left / right,
            }
        }
        Expr::Power(base, exponent) => power(constant(base)?, constant(exponent)?),
        Expr::Call(function, arguments) => {
            let values = arguments.iter().map(&constant).collect::<Option<Vec<_>>>()?;
            call(*function, &values)?
        }
        Expr::If(comparison, left, right, then, otherwise) => {
            let (left, right) = (constant(left)?, constant(right)?);
            if left.is_nan() || right.is_nan() {
                return Some(f64::NAN);
            }
            let holds = match comparison {
                Comparison::Less => left < right,
                Comparison::LessEqual => left <= right,
                Comparison::Greater => left > right,
                Comparison::GreaterEqual => left >= right,
            };
            constant(if holds { then } else { otherwise })?
        }
    })
}

fn power(base: f64, exponent: f64) -> f64 {
    if exponent == exponent.trunc() && exponent.abs() <= 64.0 {
        base.powi(exponent as i32)
    } else {
        base.powf(exponent)
    }
}

fn call(function: Function, values: &[f64]) -> Option<f64> {
    match *values {
        [x] => function.of(x),
        [x, y] => function.of_two(x, y),
        _ => None,
    }
}

/// Whether nothing in the expression depends on time.
pub fn is_free_of_time(expr: &Expr) -> bool {
    !expr.contains(&|expr| matches!(expr, Expr::Time | Expr::Observed(_)))
}

/// Whether the arclength of an axis stands in the expression.
pub fn has_arclength(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Arclength | Expr::Table { .. }))
}

/// The tables that stand in an expression.
pub fn tables(expr: &Expr) -> Vec<TableId> {
    match expr {
        Expr::Table { table, .. } => vec![*table],
        _ => expr.parts().into_iter().flat_map(tables).collect(),
    }
}

/// Whether the index of a loop stands in the expression.
pub fn has_index(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Index))
}

/// Whether position or slope of a particle stands in the expression.
pub fn has_local(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Local { .. }))
}

/// Whether the expression may have no value, as beyond the rows of a table or at the root of a negative number.
pub fn may_lack_value(expr: &Expr) -> bool {
    expr.contains(&|expr| match expr {
        Expr::Lookup { .. } => true,
        Expr::Call(function, _) => matches!(
            function,
            Function::Sqrt | Function::Ln | Function::Asin | Function::Acos
        ),
        Expr::Binary(Binary::Divide, _, by) => has_state(by) || !is_free_of_time(by),
        Expr::Power(_, exponent) => !matches!(**exponent, Expr::Number(number) if number.fract() == 0.0),
        _ => false,
    })
}

/// Whether something that only the state tells stands in the expression.
pub fn has_state(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Observed(_) | Expr::Local { .. }))
}

/// Whether a component of the strain stands in the expression.
pub fn has_strain(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Strain(_)))
}

/// Whether something that has a meaning inside of an element alone stands in the expression.
pub fn has_element(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Element(_)))
}

/// Whether a motion stands in the expression.
pub fn has_motion(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Motion(..)))
}

impl Body {
    /// Whether its section or material depends on the repetition of its loop.
    pub fn differs(&self) -> bool {
        let fields = self.law.iter().flat_map(|law| law.fields.values());
        self.properties.values().chain(fields).any(has_index)
    }

    /// Whether its elements differ, or have coefficients at every point.
    pub fn varies(&self) -> bool {
        self.law.is_some() || self.stations.is_some() || self.properties.values().any(has_arclength)
    }
}
