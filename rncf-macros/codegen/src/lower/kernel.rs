//! A kernel: a function of numbers that is emitted as straight-line code, with at most one loop over
//! integration points in the middle.

use crate::symbolic::{Cost, Graph, Id};

/// A function to emit.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Name of the function.
    pub name: String,
    /// Documentation: mathematics, shapes, choices; one paragraph each.
    pub doc: Vec<String>,
    /// Arguments as Rust text, e.g. `q: &[f64; 8]`.
    pub arguments: Vec<String>,
    /// Statements that bind the symbols' texts, e.g. `let [r0_x, r0_y] = *q;`.
    pub bindings: Vec<String>,
    /// The graph that holds all expressions.
    pub graph: Graph,
    /// Loop over integration points, if any.
    pub points: Option<PointLoop>,
    /// Output places and what is added to (or, with `assign`, stored in) them.
    pub outputs: Vec<(String, Id)>,
    /// Whether outputs are overwritten instead of added to.
    pub assign: bool,
}

/// A loop over integration points: expressions that depend on a table are inside it, expressions
/// that depend on a sum come after it.
#[derive(Clone, Debug)]
pub struct PointLoop {
    /// Number of points.
    pub count: usize,
    /// What a column of the table is, for documentation.
    pub columns: Vec<String>,
    /// Table, one row for each point; columns are read by the symbols `table[k]`.
    pub table: Vec<Vec<f64>>,
    /// Symbols that change from point to point (table columns and reference values).
    pub varying: Vec<Id>,
    /// Sums over the points: the symbol that stands for the sum after the loop, and the summand.
    pub sums: Vec<(Id, Id)>,
}

/// Where a node is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Before the loop.
    Before,
    /// Inside the loop.
    Inside,
    /// After the loop.
    After,
}

impl Kernel {
    /// All nodes that the kernel evaluates, in topological order, with their stage.
    pub fn schedule(&self) -> Vec<(Id, Stage)> {
        let mut roots: Vec<Id> = self.outputs.iter().map(|&(_, id)| id).collect();
        let mut stages = vec![Stage::Before; self.graph.len()];
        if let Some(points) = &self.points {
            roots.extend(points.sums.iter().map(|&(_, summand)| summand));
            points
                .varying
                .iter()
                .for_each(|id| stages[id.0 as usize] = Stage::Inside);
            points
                .sums
                .iter()
                .for_each(|(sum, _)| stages[sum.0 as usize] = Stage::After);
        }
        let mut schedule = Vec::new();
        for id in self.graph.reachable(&roots) {
            let children = self.graph.children(id);
            let own = stages[id.0 as usize];
            let stage = children
                .iter()
                .map(|child| stages[child.0 as usize])
                .fold(own, Stage::max);
            stages[id.0 as usize] = stage;
            schedule.push((id, stage));
        }
        schedule
    }

    /// Nodes of a schedule that belong to one stage.
    pub fn at_stage(schedule: &[(Id, Stage)], stage: Stage) -> Vec<Id> {
        schedule
            .iter()
            .filter(|&&(_, place)| place == stage)
            .map(|&(id, _)| id)
            .collect()
    }

    /// Counted operations of one evaluation, loops multiplied out, sums and outputs included.
    pub fn cost(&self) -> Cost {
        let schedule = self.schedule();
        let at = |stage: Stage| Self::at_stage(&schedule, stage);
        let additions = |count: usize| Cost {
            additions: count,
            ..Cost::default()
        };
        let stored = if self.assign { 0 } else { self.outputs.len() };
        let mut cost = self.graph.cost(&at(Stage::Before)) + self.graph.cost(&at(Stage::After)) + additions(stored);
        if let Some(points) = &self.points {
            cost = cost + (self.graph.cost(&at(Stage::Inside)) + additions(points.sums.len())) * points.count;
        }
        cost
    }

    /// Number of operations written in the source: the size of the emitted function.
    pub fn size(&self) -> usize {
        self.schedule()
            .iter()
            .filter(|&&(id, _)| self.graph.node_cost(id).weighted() > 0)
            .count()
            + self.outputs.len()
    }
}

/// Derivatives that are not zero, rows first.
pub(super) fn derivatives(graph: &mut Graph, rows: &[Id], with: &[Id], name: &str) -> Vec<(String, Id)> {
    block(graph, rows, with, name, (with.len(), 0))
}

/// The same in a matrix of a given width, from a given column on.
pub(super) fn block(
    graph: &mut Graph,
    rows: &[Id],
    with: &[Id],
    name: &str,
    (width, from): (usize, usize),
) -> Vec<(String, Id)> {
    let mut outputs = Vec::new();
    for (row, &of) in rows.iter().enumerate() {
        for (column, &symbol) in with.iter().enumerate() {
            let derivative = graph.partial(of, symbol);
            if !graph.is_zero(derivative) {
                outputs.push((format!("{name}[{}]", row * width + from + column), derivative));
            }
        }
    }
    outputs
}

/// Values in order.
pub(super) fn values(rows: &[Id], name: &str) -> Vec<(String, Id)> {
    let place = |(row, &id)| (format!("{name}[{row}]"), id);
    rows.iter().enumerate().map(place).collect()
}
