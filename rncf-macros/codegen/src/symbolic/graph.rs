//! The graph itself: nodes, and the constructors that simplify.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use crate::model::{Comparison, Function, Table};

/// A node of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(pub(crate) u32);

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A finite number, by its bits.
    Number(u64),
    /// An input, index into the symbols' names.
    Symbol(u32),
    /// Sum; operands in ascending order.
    Add(Id, Id),
    /// Difference.
    Subtract(Id, Id),
    /// Product; operands in ascending order.
    Multiply(Id, Id),
    /// Quotient.
    Divide(Id, Id),
    /// Negation.
    Negate(Id),
    /// Integer power, exponent at least 2.
    Power(Id, u32),
    /// Function of one argument.
    Call(Function, Id),
    /// Function of two arguments.
    Call2(Function, Id, Id),
    /// `if left < right { then } else { otherwise }` (or another comparison).
    Select(Comparison, [Id; 4]),
    /// A column of a table (index into the graph's tables) at a place among its rows, or its derivative.
    Lookup(Column, Id),
}

/// A column that is looked up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Column {
    /// Index into the tables of the graph.
    pub table: usize,
    /// Number of the column.
    pub column: usize,
    /// 0 its value, 1 the derivative by the place.
    pub order: usize,
}

/// Which derivatives at zero are taken as zero: right where they are multiplied with what vanishes, as in `abs(v) v`.
#[derive(Clone, Debug, Default)]
pub enum Guards {
    /// None of them.
    #[default]
    None,
    /// Those of roots and logarithms that nothing is divided by.
    Roots {
        /// What the expressions are divided by.
        divisors: HashSet<Id>,
    },
    /// Those of all roots, logarithms and angles.
    Zeros,
}

impl Guards {
    /// Whether the derivative of a root or logarithm is taken as zero where this value is.
    pub fn of_root(&self, value: Id) -> bool {
        match self {
            Guards::None => false,
            Guards::Roots { divisors } => !divisors.contains(&value),
            Guards::Zeros => true,
        }
    }

    /// Whether that of an angle is where both its sides are zero.
    pub fn of_angle(&self) -> bool {
        matches!(self, Guards::Zeros)
    }
}

/// An array of constants, e.g. the mass matrix of the unit element.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Its name in generated code.
    pub name: String,
    /// Meaning, rows and columns; one paragraph each.
    pub doc: Vec<String>,
    /// Its numbers.
    pub rows: Vec<Vec<f64>>,
}

/// A hash-consed expression graph.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    pub(super) nodes: Vec<Node>,
    pub(super) places: HashMap<Node, Id>,
    pub(super) symbols: Vec<String>,
    pub(super) names: HashMap<Id, String>,
    /// Tables that are looked up.
    pub(super) tables: Vec<Arc<Table>>,
    /// Arrays of constants that generated code reads, and where it reads a number.
    pub(super) arrays: Vec<Array>,
    pub(super) places_of_numbers: HashMap<Id, String>,
    pub(super) guards: Guards,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// What a node is.
    pub fn node(&self, id: Id) -> Node {
        self.nodes[id.0 as usize]
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether the graph has no node.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    pub(super) fn intern(&mut self, node: Node) -> Id {
        let next = Id(self.nodes.len() as u32);
        let id = *self.places.entry(node).or_insert(next);
        if id == next {
            self.nodes.push(node);
        }
        id
    }

    /// Suggests a name for the variable that holds `id` in generated code; the first suggestion stays.
    pub fn name(&mut self, id: Id, name: impl Into<String>) -> Id {
        if !matches!(self.node(id), Node::Number(_) | Node::Symbol(_)) {
            self.names.entry(id).or_insert_with(|| name.into());
        }
        id
    }

    /// The suggested name of a node.
    pub fn name_of(&self, id: Id) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// The input with this text, a new one where there is none.
    pub fn input(&mut self, text: impl Into<String>) -> Id {
        let text = text.into();
        match self.symbols.iter().position(|symbol| *symbol == text) {
            Some(at) => self.intern(Node::Symbol(at as u32)),
            None => self.symbol(text),
        }
    }

    /// A new input; its text is what generated code reads, e.g. `q[3]` or `length`.
    pub fn symbol(&mut self, text: impl Into<String>) -> Id {
        self.symbols.push(text.into());
        self.intern(Node::Symbol(self.symbols.len() as u32 - 1))
    }

    /// Whether a node is the input with this text.
    pub fn is_input(&self, id: Id, text: &str) -> bool {
        matches!(self.node(id), Node::Symbol(index) if self.symbols[index as usize] == text)
    }

    /// Text of a symbol.
    ///
    /// # Panics
    /// If `id` is no symbol.
    pub fn symbol_text(&self, id: Id) -> &str {
        match self.node(id) {
            Node::Symbol(index) => &self.symbols[index as usize],
            other => panic!("{other:?} is not a symbol"),
        }
    }

    /// A number. What is beyond the range of numbers stays a quotient by zero, which the checks of a scene find by name.
    pub fn number(&mut self, value: f64) -> Id {
        if !value.is_finite() {
            let zero = self.zero();
            let above = self.number(if value.is_nan() { 0.0 } else { value.signum() });
            return self.intern(Node::Divide(above, zero));
        }
        // -0.0 and 0.0 are one number here: no formula of this field tells them apart.
        self.intern(Node::Number(if value == 0.0 { 0 } else { value.to_bits() }))
    }

    /// The value of a number node.
    pub fn value(&self, id: Id) -> Option<f64> {
        match self.node(id) {
            Node::Number(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Zero.
    pub fn zero(&mut self) -> Id {
        self.number(0.0)
    }

    /// One.
    pub fn one(&mut self) -> Id {
        self.number(1.0)
    }

    /// Whether `id` is the number zero.
    pub fn is_zero(&self, id: Id) -> bool {
        self.value(id) == Some(0.0)
    }

    /// `value` as a node, if it is finite; else `None`, and the operation stays symbolic.
    fn fold(&mut self, value: f64) -> Option<Id> {
        value.is_finite().then(|| self.number(value))
    }

    /// `a + b`
    pub fn add(&mut self, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b))
            && let Some(sum) = self.fold(x + y)
        {
            return sum;
        }
        match (self.node(a), self.node(b)) {
            _ if self.is_zero(a) => b,
            _ if self.is_zero(b) => a,
            (Node::Negate(x), Node::Negate(y)) => {
                let sum = self.add(x, y);
                self.negate(sum)
            }
            (_, Node::Negate(y)) => self.subtract(a, y),
            (Node::Negate(x), _) => self.subtract(b, x),
            _ => self.intern(Node::Add(a.min(b), a.max(b))),
        }
    }

    /// `a - b`
    pub fn subtract(&mut self, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b))
            && let Some(difference) = self.fold(x - y)
        {
            return difference;
        }
        match self.node(b) {
            _ if a == b => self.zero(),
            _ if self.is_zero(b) => a,
            _ if self.is_zero(a) => self.negate(b),
            Node::Negate(y) => self.add(a, y),
            _ => match self.node(a) {
                Node::Negate(x) => {
                    let sum = self.add(x, b);
                    self.negate(sum)
                }
                _ => self.intern(Node::Subtract(a, b)),
            },
        }
    }

    /// `-a`
    pub fn negate(&mut self, a: Id) -> Id {
        match self.node(a) {
            Node::Number(bits) => self.number(-f64::from_bits(bits)),
            Node::Negate(x) => x,
            Node::Subtract(x, y) => self.subtract(y, x),
            _ => self.intern(Node::Negate(a)),
        }
    }

    /// `a * b`
    pub fn multiply(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => {
                if let Some(product) = self.fold(x * y) {
                    return product;
                }
            }
            (Some(0.0), _) => return a,
            (_, Some(0.0)) => return b,
            (Some(1.0), _) => return b,
            (_, Some(1.0)) => return a,
            (Some(-1.0), _) => return self.negate(b),
            (_, Some(-1.0)) => return self.negate(a),
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(x), Node::Negate(y)) => self.multiply(x, y),
            (Node::Negate(x), _) => {
                let product = self.multiply(x, b);
                self.negate(product)
            }
            (_, Node::Negate(y)) => {
                let product = self.multiply(a, y);
                self.negate(product)
            }
            _ if a == b => self.power(a, 2),
            _ => self.intern(Node::Multiply(a.min(b), a.max(b))),
        }
    }

    /// `a / b`
    pub fn divide(&mut self, a: Id, b: Id) -> Id {
        if let (Some(x), Some(y)) = (self.value(a), self.value(b))
            && let Some(quotient) = self.fold(x / y)
        {
            return quotient;
        }
        match (self.node(a), self.node(b)) {
            _ if self.is_zero(a) => a,
            _ if self.value(b) == Some(1.0) => a,
            // (x b)/b: the derivative of x^2/2
            (Node::Multiply(x, y), Node::Number(_)) if x == b => y,
            (Node::Multiply(x, y), Node::Number(_)) if y == b => x,
            (Node::Negate(x), Node::Negate(y)) => self.divide(x, y),
            (Node::Negate(x), _) => {
                let quotient = self.divide(x, b);
                self.negate(quotient)
            }
            (_, Node::Negate(y)) => {
                let quotient = self.divide(a, y);
                self.negate(quotient)
            }
            _ => self.intern(Node::Divide(a, b)),
        }
    }

    /// `a^exponent` for an integer exponent.
    pub fn power(&mut self, a: Id, exponent: i32) -> Id {
        match exponent {
            0 => self.one(),
            1 => a,
            ..=-1 => {
                let positive = self.power(a, -exponent);
                let one = self.one();
                self.divide(one, positive)
            }
            _ => {
                if let Some(folded) = self.value(a).and_then(|x| self.fold(x.powi(exponent))) {
                    return folded;
                }
                match self.node(a) {
                    Node::Power(base, inner) => self.intern(Node::Power(base, inner * exponent as u32)),
                    Node::Negate(x) => {
                        let power = self.power(x, exponent);
                        if exponent % 2 == 0 { power } else { self.negate(power) }
                    }
                    _ => self.intern(Node::Power(a, exponent as u32)),
                }
            }
        }
    }

    /// `base^exponent`; integer exponents become products, halves square roots, others `exp(e ln b)`.
    pub fn general_power(&mut self, base: Id, exponent: Id) -> Id {
        if let Some(number) = self.value(exponent) {
            let doubled = 2.0 * number;
            if number == number.trunc() && number.abs() <= 64.0 {
                return self.power(base, number as i32);
            }
            if doubled == doubled.trunc() && number.abs() <= 32.0 {
                let root = self.call(Function::Sqrt, base);
                return self.power(root, doubled as i32);
            }
        }
        let logarithm = self.call(Function::Ln, base);
        let product = self.multiply(exponent, logarithm);
        self.call(Function::Exp, product)
    }

    /// A function of one argument.
    pub fn call(&mut self, function: Function, a: Id) -> Id {
        if let Some(folded) = self.value(a).and_then(|x| function.of(x)).and_then(|x| self.fold(x)) {
            return folded;
        }
        self.intern(Node::Call(function, a))
    }

    /// A function of two arguments.
    pub fn call2(&mut self, function: Function, a: Id, b: Id) -> Id {
        self.intern(Node::Call2(function, a, b))
    }

    /// `if left (comparison) right { then } else { otherwise }`
    pub fn select(&mut self, comparison: Comparison, left: Id, right: Id, then: Id, otherwise: Id) -> Id {
        if then == otherwise {
            return then;
        }
        if let (Some(x), Some(y)) = (self.value(left), self.value(right)) {
            return if compare(comparison, x, y) { then } else { otherwise };
        }
        self.intern(Node::Select(comparison, [left, right, then, otherwise]))
    }

    /// A column of a table at a place among its rows.
    pub fn look_up(&mut self, table: &Table, column: usize, at: Id) -> Id {
        let known = self.tables.iter().position(|known| known.name == table.name);
        let table = known.unwrap_or_else(|| {
            self.tables.push(Arc::new(table.clone()));
            self.tables.len() - 1
        });
        let column = Column {
            table,
            column,
            order: 0,
        };
        self.intern(Node::Lookup(column, at))
    }

    /// A table that is looked up.
    pub fn table(&self, column: Column) -> &Table {
        &self.tables[column.table]
    }

    /// Children of a node.
    pub fn children(&self, id: Id) -> Vec<Id> {
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => Vec::new(),
            Node::Add(a, b)
            | Node::Subtract(a, b)
            | Node::Multiply(a, b)
            | Node::Divide(a, b)
            | Node::Call2(_, a, b) => {
                vec![a, b]
            }
            Node::Negate(a) | Node::Power(a, _) | Node::Call(_, a) | Node::Lookup(_, a) => vec![a],
            Node::Select(_, operands) => operands.to_vec(),
        }
    }

    /// All nodes that the roots depend on, themselves included, in ascending (topological) order.
    pub fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        let mut seen = vec![false; self.nodes.len()];
        let mut stack = roots.to_vec();
        while let Some(id) = stack.pop() {
            if !std::mem::replace(&mut seen[id.0 as usize], true) {
                stack.extend(self.children(id));
            }
        }
        (0..self.nodes.len() as u32)
            .map(Id)
            .filter(|id| seen[id.0 as usize])
            .collect()
    }

    /// Whether `id` depends on one of the symbols.
    pub fn depends_on(&self, id: Id, symbols: &[Id]) -> bool {
        self.reachable(&[id]).iter().any(|node| symbols.contains(node))
    }

    /// A sum of products: `sum_i a_i b_i`.
    pub fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        let mut sum = self.zero();
        for (&x, &y) in a.iter().zip(b) {
            let product = self.multiply(x, y);
            sum = self.add(sum, product);
        }
        sum
    }

    /// A sum of terms.
    pub fn sum(&mut self, terms: &[Id]) -> Id {
        let mut sum = self.zero();
        for &term in terms {
            sum = self.add(sum, term);
        }
        sum
    }
}

/// Comparison in f64.
pub(super) fn compare(comparison: Comparison, x: f64, y: f64) -> bool {
    match comparison {
        Comparison::Less => x < y,
        Comparison::LessEqual => x <= y,
        Comparison::Greater => x > y,
        Comparison::GreaterEqual => x >= y,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_expressions_are_one_node() {
        let mut g = Graph::new();
        let (x, y) = (g.symbol("x"), g.symbol("y"));
        assert_eq!(g.add(x, y), g.add(y, x));
        let (a, b) = (g.subtract(x, y), g.subtract(y, x));
        assert_eq!(g.negate(a), b);
        let product = g.multiply(x, y);
        let negative = g.negate(y);
        let other = g.multiply(x, negative);
        assert_eq!(g.negate(other), product);
        assert_eq!(g.subtract(x, x), g.zero());
    }

    #[test]
    fn general_powers_use_products_and_roots() {
        let mut g = Graph::new();
        let x = g.symbol("x");
        let (two, half) = (g.number(2.0), g.number(0.5));
        let square = g.general_power(x, two);
        assert_eq!(g.node(square), Node::Power(x, 2));
        let root = g.general_power(x, half);
        assert_eq!(g.node(root), Node::Call(Function::Sqrt, x));
    }
}
