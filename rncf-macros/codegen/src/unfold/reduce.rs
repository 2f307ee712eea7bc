//! Values over all repetitions, where these are items of their own.

use super::{Count, Place, Turn, Unfold};
use crate::model::{Binary, Reduction};
use crate::parse::tree::{Argument, Call, Expr, ExprKind, Name, Reduced};

impl<'t> Unfold<'t, '_> {
    /// `max(a in 0..n, value)`: of the values one by one where they look at repetitions that are items of their own.
    pub(super) fn reduced(&mut self, at: &Place, expr: &'t Expr, reduced: &'t Reduced) -> ExprKind {
        let turn = |number| Place {
            scope: at.scope,
            turns: at
                .turns
                .iter()
                .cloned()
                .chain([Turn {
                    name: reduced.index.text.clone(),
                    number,
                }])
                .collect(),
        };
        let is_of_items = self.looks_at_items(at, &reduced.value);
        if is_of_items && let Count::Known(times @ 1..) = self.count(at, &reduced.count) {
            let values = (0..times).map(|number| self.expr(&turn(Some(number)), &reduced.value));
            let values: Vec<Expr> = values.collect();
            return combined(expr, reduced, values);
        }
        let (count, value) = (self.expr(at, &reduced.count), self.expr(&turn(None), &reduced.value));
        let index = reduced.index.clone();
        ExprKind::Reduced(Box::new(Reduced {
            reduction: reduced.reduction,
            index,
            count,
            value,
        }))
    }

    /// Whether an expression looks at repetitions that are items of their own, or at parts.
    fn looks_at_items(&self, at: &Place, expr: &Expr) -> bool {
        let of_name = |name: &Name| {
            self.scope_of(at, &name.text).is_some_and(|scope| {
                let has_pieces = || self.cornered.contains_key(&self.renamed(scope, name).text);
                self.scopes[scope].unfolds(&name.text) || has_pieces()
            })
        };
        match &expr.kind {
            ExprKind::Indexed { base, .. } => of_name(base),
            ExprKind::Numbered { base, .. } => self.is_of_part(at, base) || self.looks_at_items(at, base),
            ExprKind::Reduced(inner) => self.looks_at_items(at, &inner.value),
            _ => expr.parts().into_iter().any(|part| self.looks_at_items(at, part)),
        }
    }

    /// Whether it is something in a part that is repeated at build time.
    fn is_of_part(&self, at: &Place, expr: &Expr) -> bool {
        let ExprKind::Member { base, field, .. } = &expr.kind else {
            return false;
        };
        self.part_of(at, base).is_some_and(|scope| {
            let has_pieces = || self.cornered.contains_key(&self.renamed(scope, field).text);
            self.scopes[scope].unfolds(&field.text) || has_pieces()
        })
    }

    /// The scope of a part that is named without numbers.
    fn part_of(&self, at: &Place, expr: &Expr) -> Option<usize> {
        let written = match &expr.kind {
            ExprKind::Name(name) => self.renamed(self.scope_of(at, &name.text)?, name).text,
            ExprKind::Member { base, field, .. } => self.renamed(self.part_of(at, base)?, field).text,
            _ => return None,
        };
        self.parts.get(&written).copied()
    }
}

/// All values in pairs, so that the tree stays flat.
fn combined(expr: &Expr, reduced: &Reduced, mut values: Vec<Expr>) -> ExprKind {
    let count = values.len();
    let pair = |left: Expr, right: Expr| {
        let height = 1 + left.height.max(right.height);
        let function = |word: &str| {
            let arguments = [left.clone(), right.clone()].map(|value| Argument { name: None, value });
            ExprKind::Call(Call {
                name: Name::new(word, reduced.index.span),
                arguments: arguments.into(),
                area: expr.area,
            })
        };
        let kind = match reduced.reduction {
            Reduction::Max => function("max"),
            Reduction::Min => function("min"),
            Reduction::Sum | Reduction::Mean => {
                ExprKind::Binary(Binary::Add, Box::new(left.clone()), Box::new(right.clone()))
            }
        };
        Expr {
            kind,
            area: expr.area,
            height,
        }
    };
    while values.len() > 1 {
        let mut pairs = Vec::with_capacity(values.len().div_ceil(2));
        let mut rest = values.into_iter();
        while let Some(left) = rest.next() {
            pairs.push(match rest.next() {
                Some(right) => pair(left, right),
                None => left,
            });
        }
        values = pairs;
    }
    let Some(value) = values.pop() else {
        return expr.kind.clone();
    };
    if reduced.reduction != Reduction::Mean {
        return value.kind;
    }
    let number = Expr {
        kind: ExprKind::Index(count as i64),
        area: expr.area,
        height: 1,
    };
    ExprKind::Binary(Binary::Divide, Box::new(value), Box::new(number))
}
