//! Graph nodes as Rust statements: a node that is used once and has no name becomes part of the
//! expression that uses it, every other one a `let`.

use std::collections::{HashMap, HashSet};

use super::number::number;
use crate::model::{Comparison, Function};
use crate::symbolic::{Graph, Id, Node};

/// Operations in one expression beyond which a part gets a name: a line should be readable.
const LONGEST_EXPRESSION: usize = 9;

/// How tightly the outermost operation of a text binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

#[derive(Clone)]
struct Text {
    text: String,
    binding: Binding,
    operations: usize,
}

/// Writes statements for parts of one graph in one function.
pub struct Writer<'g> {
    graph: &'g Graph,
    uses: HashMap<Id, usize>,
    texts: HashMap<Id, Text>,
    taken: HashSet<String>,
    /// Names that no variable gets, which do not count in the numbering of variables.
    forbidden: HashSet<String>,
    /// Whether values may be numbers of lanes: literals then stand to the right of an operator.
    lanes: bool,
}

impl<'g> Writer<'g> {
    /// A writer for a function that evaluates `nodes` (topological order) and reads `roots` at the end.
    pub fn new(graph: &'g Graph, nodes: &[Id], roots: impl IntoIterator<Item = Id>) -> Self {
        let mut uses: HashMap<Id, usize> = HashMap::new();
        let mut taken = HashSet::new();
        for &id in nodes {
            for child in graph.children(id) {
                *uses.entry(child).or_default() += 1;
            }
            if let Node::Symbol(_) = graph.node(id) {
                taken.insert(graph.symbol_text(id).to_string());
            }
        }
        for root in roots {
            *uses.entry(root).or_default() += 1;
        }
        Self {
            graph,
            uses,
            texts: HashMap::new(),
            taken,
            forbidden: HashSet::new(),
            lanes: false,
        }
    }

    /// Writes for numbers of lanes.
    pub fn for_lanes(&mut self) {
        self.lanes = true;
    }

    /// Forbids a name, e.g. of an argument: a motion may be called anything.
    pub fn forbid(&mut self, name: &str) {
        self.forbidden.insert(name.to_string());
    }

    /// Takes a name so that no variable gets it.
    pub fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_string());
    }

    /// Statements that evaluate the given nodes; nodes that become parts of others write nothing.
    /// `bind` forces a name for nodes that are read outside of this block.
    pub fn statements(&mut self, nodes: &[Id], bind: &HashSet<Id>, out: &mut Vec<String>) {
        for &id in nodes {
            let text = self.build(id);
            let is_atom = matches!(self.graph.node(id), Node::Number(_) | Node::Symbol(_));
            let shared = self.uses.get(&id).copied().unwrap_or(0) > 1 && text.operations > 0;
            let named = self.graph.name_of(id).is_some() && text.operations > 0;
            let long = text.operations >= LONGEST_EXPRESSION;
            if !is_atom && (shared || named || long || (bind.contains(&id) && text.operations > 0)) {
                let name = self.fresh(id);
                out.push(format!("let {name} = {};", text.text));
                self.texts.insert(
                    id,
                    Text {
                        text: name,
                        binding: Binding::Atom,
                        operations: 0,
                    },
                );
            } else {
                self.texts.insert(id, text);
            }
        }
    }

    /// Text of an evaluated node.
    pub fn text(&self, id: Id) -> &str {
        &self.texts[&id].text
    }

    fn fresh(&mut self, id: Id) -> String {
        let wanted = match self.graph.name_of(id) {
            Some(name) => name.to_string(),
            None => format!("t{}", self.taken.len()),
        };
        let mut name = wanted.clone();
        let mut count = 2;
        while self.forbidden.contains(&name) || !self.taken.insert(name.clone()) {
            name = format!("{wanted}_{count}");
            count += 1;
        }
        name
    }

    fn operand(&self, id: Id, least: Binding) -> (String, usize) {
        let part = &self.texts[&id];
        let text = if part.binding < least {
            format!("({})", part.text)
        } else {
            part.text.clone()
        };
        (text, part.operations)
    }

    /// What a method is called of: a number needs its type there, and its sign inside the brackets.
    fn receiver(&self, id: Id) -> (String, usize) {
        match self.graph.value(id) {
            Some(_) => (format!("({}_f64)", self.texts[&id].text), 0),
            None => self.operand(id, Binding::Atom),
        }
    }

    fn infix(&self, a: Id, operator: &str, b: Id, binding: Binding) -> Text {
        // The left operand may bind as loosely, the right one must bind more tightly: the text then
        // means the same order of rounding as the graph.
        let right_least = if binding == Binding::Sum {
            Binding::Product
        } else {
            Binding::Sign
        };
        let (left, m) = self.operand(a, binding);
        let (right, n) = self.operand(b, right_least);
        let right = if right.starts_with('-') {
            format!("({right})")
        } else {
            right
        };
        Text {
            text: format!("{left} {operator} {right}"),
            binding,
            operations: m + n + 1,
        }
    }

    /// An operation on a literal, which stands to the right; the result has the same bits.
    fn on_literal(&self, node: Node) -> Option<Text> {
        let is_literal = |id: Id| self.graph.value(id).is_some();
        match node {
            Node::Add(a, b) if is_literal(a) => Some(self.infix(b, "+", a, Binding::Sum)),
            Node::Multiply(a, b) if is_literal(a) => Some(self.infix(b, "*", a, Binding::Product)),
            Node::Subtract(a, b) if is_literal(a) => {
                let (left, m) = self.operand(b, Binding::Product);
                let (right, n) = self.operand(a, Binding::Product);
                Some(Text {
                    text: format!("-{left} + {right}"),
                    binding: Binding::Sum,
                    operations: m + n + 1,
                })
            }
            Node::Divide(a, b) if is_literal(a) => {
                let (divisor, operations) = self.operand(b, Binding::Atom);
                let text = match self.graph.value(a) {
                    Some(1.0) => format!("{divisor}.recip()"),
                    _ => format!("{divisor}.dividing({})", self.texts[&a].text),
                };
                Some(Text {
                    text,
                    binding: Binding::Atom,
                    operations: operations + 1,
                })
            }
            _ => None,
        }
    }

    fn build(&self, id: Id) -> Text {
        if let Some(text) = self.lanes.then(|| self.on_literal(self.graph.node(id))).flatten() {
            return text;
        }
        let atom = |text: String| Text {
            text,
            binding: Binding::Atom,
            operations: 0,
        };
        match self.graph.node(id) {
            Node::Number(bits) => {
                if let Some(place) = self.graph.place_of(id) {
                    return atom(place.to_string());
                }
                let value = f64::from_bits(bits);
                let binding = if value < 0.0 { Binding::Sign } else { Binding::Atom };
                Text {
                    text: number(value),
                    binding,
                    operations: 0,
                }
            }
            Node::Symbol(_) => atom(self.graph.symbol_text(id).to_string()),
            Node::Add(a, b) => self.infix(a, "+", b, Binding::Sum),
            Node::Subtract(a, b) => self.infix(a, "-", b, Binding::Sum),
            Node::Multiply(a, b) => self.infix(a, "*", b, Binding::Product),
            Node::Divide(a, b) => self.infix(a, "/", b, Binding::Product),
            Node::Negate(a) => {
                let (text, operations) = self.operand(a, Binding::Product);
                Text {
                    text: format!("-{text}"),
                    binding: Binding::Sign,
                    operations,
                }
            }
            Node::Power(a, n) => {
                let (base, operations) = self.operand(a, Binding::Atom);
                let repeatable = operations == 0 && !base.contains('(') && n <= 3;
                if repeatable {
                    let text = vec![base; n as usize].join(" * ");
                    return Text {
                        text,
                        binding: Binding::Product,
                        operations: n as usize - 1,
                    };
                }
                Text {
                    text: format!("{base}.powi({n})"),
                    binding: Binding::Atom,
                    operations: operations + 1,
                }
            }
            Node::Call(function, a) => {
                let (argument, operations) = self.receiver(a);
                Text {
                    text: format!("{argument}.{}()", method(function)),
                    binding: Binding::Atom,
                    operations: operations + 1,
                }
            }
            Node::Call2(function, a, b) => {
                let (right, n) = self.operand(b, Binding::Sum);
                let (text, m) = match function {
                    Function::Max | Function::Min => {
                        let (left, m) = self.operand(a, Binding::Sum);
                        let text = format!("::rncf::emitted::extremes::{}({left}, {right})", method(function));
                        (text, m)
                    }
                    _ => {
                        let (left, m) = self.receiver(a);
                        (format!("{left}.{}({right})", method(function)), m)
                    }
                };
                Text {
                    text,
                    binding: Binding::Atom,
                    operations: m + n + 1,
                }
            }
            Node::Lookup(column, a) => {
                let (argument, operations) = self.operand(a, Binding::Sum);
                let table = self.graph.table(column).reference();
                Text {
                    text: format!("{table}.look_up({}, {}, {argument})", column.column, column.order),
                    binding: Binding::Atom,
                    operations: operations + 1,
                }
            }
            Node::Select(comparison, operands) => {
                let parts = operands.map(|operand| self.operand(operand, Binding::Sum));
                let [(left, a), (right, b), (then, c), (otherwise, d)] = parts;
                let text = format!(
                    "if {left} {} {right} {{ {then} }} else {{ {otherwise} }}",
                    operator(comparison)
                );
                Text {
                    text: format!("({text})"),
                    binding: Binding::Atom,
                    operations: a + b + c + d + 1,
                }
            }
        }
    }
}

/// The operator in Rust.
pub fn operator(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Less => "<",
        Comparison::LessEqual => "<=",
        Comparison::Greater => ">",
        Comparison::GreaterEqual => ">=",
    }
}

fn method(function: Function) -> &'static str {
    match function {
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::Asin => "asin",
        Function::Acos => "acos",
        Function::Atan => "atan",
        Function::Sinh => "sinh",
        Function::Cosh => "cosh",
        Function::Tanh => "tanh",
        Function::Exp => "exp",
        Function::Ln => "ln",
        Function::Sqrt => "sqrt",
        Function::Abs => "abs",
        Function::Min => "min",
        Function::Max => "max",
        Function::Atan2 => "atan2",
        Function::Remainder => "rem_euclid",
    }
}

/// An expression in one piece, without variables.
pub fn inline(graph: &Graph, id: Id) -> String {
    let nodes = graph.reachable(&[id]);
    let mut writer = Writer::new(graph, &[], []);
    for node in nodes {
        let text = writer.build(node);
        writer.texts.insert(node, text);
    }
    writer.text(id).to_string()
}
