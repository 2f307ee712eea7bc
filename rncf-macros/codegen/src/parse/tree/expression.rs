//! Expressions as they are written.

use proc_macro2::Span;

use crate::errors::Area;

/// A word of the user.
#[derive(Clone, Debug)]
pub struct Name {
    /// The word.
    pub text: String,
    /// Where it is.
    pub span: Span,
    /// All of it, where it goes on behind the first word: `rod[2]`, `blade[1].rod`.
    pub path: Option<Box<Expr>>,
}

impl Name {
    /// A single word.
    pub fn new(text: impl Into<String>, span: Span) -> Self {
        let text = text.into();
        Self { text, span, path: None }
    }

    /// Line of the text, counted from 1 (0 where unknown).
    pub fn line(&self) -> usize {
        self.span.start().line
    }

    /// The word as it stands in its declaration, without the numbers of repetitions and the part that it belongs to.
    pub fn word(&self) -> &str {
        let last = self.text.rsplit('.').next().unwrap_or_default();
        last.split('[').next().unwrap_or_default()
    }
}

/// `name(arguments)`
#[derive(Clone, Debug)]
pub struct Call {
    /// What is called.
    pub name: Name,
    /// Arguments.
    pub arguments: Vec<Argument>,
    /// All of it.
    pub area: Area,
}

/// `value` or `name = value`
#[derive(Clone, Debug)]
pub struct Argument {
    /// Name, where given.
    pub name: Option<Name>,
    /// Value.
    pub value: Expr,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// All of it, parentheses included.
    pub area: Area,
    /// Height of the tree, bounded by the parser so that recursion over it is safe.
    pub height: usize,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number with its unit.
    Number {
        /// As written.
        text: String,
        /// Unit behind it.
        unit: Option<UnitText>,
    },
    /// A name: parameter, constant, `t`, `pi`, ...
    Name(Name),
    /// The number that an index stands for; `unfold` writes it.
    Index(i64),
    /// `base.field` or `base.field(arguments)`
    Member {
        /// What stands before the dot.
        base: Box<Expr>,
        /// The word behind it.
        field: Name,
        /// Arguments, where there are parentheses.
        arguments: Option<Vec<Argument>>,
    },
    /// `name(arguments)`
    Call(Call),
    /// `-a`
    Negate(Box<Expr>),
    /// `a + b`, `a - b`, `a * b`, `a / b`
    Binary(crate::model::Binary, Box<Expr>, Box<Expr>),
    /// `a % b`
    Remainder(Box<Expr>, Box<Expr>),
    /// `name[index]`
    Indexed {
        /// Name of what is repeated.
        base: Name,
        /// Number of the repetition.
        index: Box<Expr>,
    },
    /// `rod[i][j]`, `blade[1].rod[2]`: a number behind more than a name; `unfold` resolves it.
    Numbered {
        /// What stands before the brackets.
        base: Box<Expr>,
        /// Number of the repetition.
        index: Box<Expr>,
    },
    /// `pitch[b](t)`: a repeated motion at a time; `unfold` resolves it.
    Applied {
        /// What stands before the parentheses.
        base: Box<Expr>,
        /// Arguments.
        arguments: Vec<Argument>,
    },
    /// `max(index in 0..count, value)`
    Reduced(Box<Reduced>),
    /// `a ^ b`
    Power(Box<Expr>, Box<Expr>),
    /// `if left < right { a } else { b }`
    If(Box<If>),
    /// `[a, b, c] unit`
    Vector {
        /// Components.
        components: Vec<Expr>,
        /// Unit of all literal components.
        unit: Option<UnitText>,
    },
}

impl Expr {
    /// Whether a vector is written out in what it is the sum, product or opposite of.
    pub fn has_vector(&self) -> bool {
        match &self.kind {
            ExprKind::Vector { .. } => true,
            ExprKind::Negate(inner) => inner.has_vector(),
            ExprKind::Binary(_, left, right) => left.has_vector() || right.has_vector(),
            _ => false,
        }
    }

    /// The expressions that it is made of, in the order of the text.
    pub fn parts(&self) -> Vec<&Expr> {
        fn of(arguments: &[Argument]) -> impl Iterator<Item = &Expr> {
            arguments.iter().map(|argument| &argument.value)
        }
        match &self.kind {
            ExprKind::Number { .. } | ExprKind::Name(_) | ExprKind::Index(_) => Vec::new(),
            ExprKind::Member { base, arguments, .. } => {
                let arguments = arguments.iter().flat_map(|arguments| of(arguments));
                std::iter::once(&**base).chain(arguments).collect()
            }
            ExprKind::Call(call) => of(&call.arguments).collect(),
            ExprKind::Negate(inner) => vec![inner],
            ExprKind::Binary(_, left, right) | ExprKind::Remainder(left, right) | ExprKind::Power(left, right) => {
                vec![left, right]
            }
            ExprKind::Indexed { index, .. } => vec![index],
            ExprKind::Numbered { base, index } => vec![base, index],
            ExprKind::Applied { base, arguments } => std::iter::once(&**base).chain(of(arguments)).collect(),
            ExprKind::Reduced(reduced) => vec![&reduced.count, &reduced.value],
            ExprKind::If(choice) => vec![&choice.left, &choice.right, &choice.then, &choice.otherwise],
            ExprKind::Vector { components, .. } => components.iter().collect(),
        }
    }
}

/// `max(index in 0..count, value)`, or `min`, `sum`, `mean`
#[derive(Clone, Debug)]
pub struct Reduced {
    /// What is told.
    pub reduction: crate::model::Reduction,
    /// Name of the index.
    pub index: Name,
    /// How many values.
    pub count: Expr,
    /// The value of each.
    pub value: Expr,
}

/// `if left < right { then } else { otherwise }`
#[derive(Clone, Debug)]
pub struct If {
    /// The comparison.
    pub comparison: crate::model::Comparison,
    /// Its left side.
    pub left: Expr,
    /// Its right side.
    pub right: Expr,
    /// Value where it holds.
    pub then: Expr,
    /// Value where it does not.
    pub otherwise: Expr,
}

/// A product of powers of unit symbols.
#[derive(Clone, Debug)]
pub struct UnitText {
    /// Symbols with their exponents.
    pub factors: Vec<(Name, i32)>,
    /// As written, in a uniform spacing.
    pub text: String,
    /// Whether it could not be a quotient or product with something that has a name.
    pub is_delimited: bool,
    /// All of it.
    pub area: Area,
}
