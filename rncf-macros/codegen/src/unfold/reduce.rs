//! Values over all repetitions, where these are items of their own.

use super::{Place, Turn, Unfold, count::Count};
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
            let text = name.text.as_str();
            let mut scopes = [at.scope, 0].into_iter().map(|scope| &self.scopes[scope]);
            let found = scopes.find_map(|scope| Some((scope, scope.names.get(text)?)));
            found.is_some_and(|(scope, declared)| declared.loops.iter().any(|id| !scope.kept.contains(id)))
        };
        match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Index(_) | ExprKind::Name(_) => false,
            ExprKind::Indexed { base, .. } => of_name(base),
            ExprKind::Numbered { base, .. } => self.is_of_part(at, base) || self.looks_at_items(at, base),
            ExprKind::Negate(base) => self.looks_at_items(at, base),
            ExprKind::Member { base, arguments, .. } => {
                self.looks_at_items(at, base) || arguments.iter().any(|list| self.any_looks(at, list))
            }
            ExprKind::Applied { base, arguments } => self.looks_at_items(at, base) || self.any_looks(at, arguments),
            ExprKind::Call(call) => self.any_looks(at, &call.arguments),
            ExprKind::Binary(_, left, right) | ExprKind::Remainder(left, right) | ExprKind::Power(left, right) => {
                self.looks_at_items(at, left) || self.looks_at_items(at, right)
            }
            ExprKind::Reduced(inner) => self.looks_at_items(at, &inner.value),
            ExprKind::If(choice) => [&choice.left, &choice.right, &choice.then, &choice.otherwise]
                .into_iter()
                .any(|part| self.looks_at_items(at, part)),
            ExprKind::Vector { components, .. } => components.iter().any(|part| self.looks_at_items(at, part)),
        }
    }

    /// Whether it is something in a part that is repeated at build time.
    fn is_of_part(&self, at: &Place, expr: &Expr) -> bool {
        let ExprKind::Member { base, field, .. } = &expr.kind else {
            return false;
        };
        let scope = self.part_of(at, base).map(|scope| &self.scopes[scope]);
        let found = scope.and_then(|scope| Some((scope, scope.names.get(field.text.as_str())?)));
        found.is_some_and(|(scope, declared)| declared.loops.iter().any(|id| !scope.kept.contains(id)))
    }

    /// The scope of a part that is named without numbers.
    fn part_of(&self, at: &Place, expr: &Expr) -> Option<usize> {
        let written = match &expr.kind {
            ExprKind::Name(name) => {
                let mut scopes = [at.scope, 0].into_iter().map(|scope| &self.scopes[scope]);
                let scope = scopes.find(|scope| scope.names.contains_key(name.text.as_str()))?;
                format!("{}{}", scope.prefix, name.text)
            }
            ExprKind::Member { base, field, .. } => {
                let scope = self.part_of(at, base)?;
                format!("{}{}", self.scopes[scope].prefix, field.text)
            }
            _ => return None,
        };
        self.parts.get(&written).copied()
    }

    fn any_looks(&self, at: &Place, arguments: &[Argument]) -> bool {
        arguments
            .iter()
            .any(|argument| self.looks_at_items(at, &argument.value))
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
