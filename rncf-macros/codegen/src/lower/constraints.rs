//! Constraints of markers: written down as C(z, t) = 0, with every derivative derived. Constraints
//! that differ in nothing but their markers share their functions.

use std::collections::{BTreeSet, HashMap};

use super::branches;
use super::differences::of_differences;
use super::joints::LEVELS;
use super::kernel::{Kernel, derivatives, values};
use super::markers::{Marked, describe, function_name, localise};
use crate::model::{Expr, Model};
use crate::symbolic::Id;

/// The functions of one or more constraints.
#[derive(Clone, Debug)]
pub struct ConstraintKernels {
    /// Indices of the constraints.
    pub of: Vec<usize>,
    /// Those of them that depend on differences of places alone.
    pub of_differences: Vec<usize>,
    /// Rows, and their total time derivatives along z', z'', z'''.
    pub levels: [Kernel; 4],
    /// dC/dz.
    pub gradient: Kernel,
    /// d(dC/dt)/dz, where it is not zero.
    pub rate_gradient: Option<Kernel>,
    /// `sum_i lambda_i d^2 C_i/dz dz`, where it is not zero.
    pub hessian: Option<Kernel>,
    /// Where angles in it jump.
    pub branches: Option<Kernel>,
    /// Markers of the constraint's own list that it couples: two in ascending order, each pair once, ascending.
    pub coupled: Vec<[usize; 2]>,
}

/// Rows with their markers counted in the constraint's own list.
struct Rows<'m> {
    model: &'m Model,
    /// Number of markers.
    count: usize,
    rows: Vec<Expr>,
    /// Last word of the functions' names, and what they belong to.
    name: String,
    title: String,
    /// What z is.
    markers: String,
}

/// The functions of all constraints of a model, each once.
pub fn constraint_kernels(model: &Model) -> Vec<ConstraintKernels> {
    let local: Vec<(usize, Vec<Expr>)> = model
        .constraints
        .iter()
        .map(|constraint| {
            let rows = constraint
                .rows
                .iter()
                .map(|(_, row)| localise(row, &constraint.markers));
            (constraint.markers.len(), rows.collect())
        })
        .collect();
    let mut names = Vec::new();
    let mut kernels = Vec::new();
    for (index, rows) in local.iter().enumerate() {
        if local[..index].contains(rows) {
            continue;
        }
        let of: Vec<usize> = (index..local.len()).filter(|&other| local[other] == *rows).collect();
        let first = &model.constraints[index];
        let name = function_name(&first.name, &names);
        names.push(name.clone());
        let rows = Rows {
            model,
            count: rows.0,
            rows: rows.1.clone(),
            name,
            title: format!("Constraint {}", members(model, &of)),
            markers: describe(model, &first.name, &first.markers),
        };
        kernels.push(rows.kernels(of));
    }
    kernels
}

/// Names of constraints with their kinds, and where they are not always there.
pub fn members(model: &Model, of: &[usize]) -> String {
    let names = of.iter().map(|&index| {
        let constraint = &model.constraints[index];
        let place = if constraint.absolute.is_some() {
            " in absolute coordinates"
        } else {
            ""
        };
        format!("`{}` ({}{place})", constraint.name, constraint.kind)
    });
    names.collect::<Vec<_>>().join(", ")
}

impl Rows<'_> {
    fn kernels(&self, of: Vec<usize>) -> ConstraintKernels {
        let (hessian, coupled) = self.hessian();
        ConstraintKernels {
            of_differences: of_differences(self.model, &self.rows, &of, |other| {
                &self.model.constraints[other].markers
            }),
            of,
            levels: std::array::from_fn(|level| self.level(level)),
            gradient: self.gradient(),
            rate_gradient: self.rate_gradient(),
            hessian,
            branches: self.branches(),
            coupled,
        }
    }

    fn branches(&self) -> Option<Kernel> {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let outputs = branches::outputs(&mut marked, &self.rows);
        let arguments = ["z: &[::rncf::emitted::Vector]", "out: &mut [f64]"];
        (!outputs.is_empty()).then(|| self.kernel(marked, "branches", branches::TITLE, outputs, &arguments))
    }

    /// The rows in a graph whose markers are `z[marker][component]`.
    fn in_graph(&self, marked: &mut Marked) -> Vec<Id> {
        self.rows.iter().map(|row| marked.time.expression(row)).collect()
    }

    fn kernel(
        &self,
        marked: Marked,
        what: &str,
        title: &str,
        outputs: Vec<(String, Id)>,
        arguments: &[&str],
    ) -> Kernel {
        let title = format!("{}: {title}", self.title);
        let mut kernel = marked.kernel(format!("constraint_{what}_{}", self.name), title, outputs, arguments);
        kernel.bindings.push(format!("let z = &z[..{}];", self.count));
        kernel
    }

    /// Rows differentiated `level` times along the markers' derivatives.
    fn level(&self, level: usize) -> Kernel {
        let text = |derivative: usize| {
            move |marker: usize, component: usize| format!("z[{marker}][{derivative}][{component}]")
        };
        let (value, rate, acceleration, jerk) = (text(0), text(1), text(2), text(3));
        let mut marked = Marked::new(self.model, self.count, &[&value, &rate, &acceleration, &jerk]);
        let mut rows = self.in_graph(&mut marked);
        let one = marked.time.graph.one();
        let mut rates = HashMap::from([(marked.time.t, one)]);
        for derivative in 0..3 {
            let symbols = marked.symbols[derivative].iter().copied();
            rates.extend(symbols.zip(marked.symbols[derivative + 1].iter().copied()));
        }
        for _ in 0..level {
            rows = rows
                .iter()
                .map(|&row| marked.time.graph.differentiate(row, &rates))
                .collect();
        }
        let what = [
            "rows C(z, t).",
            "their rate dC/dt.",
            "their second time derivative.",
            "their third time derivative.",
        ];
        let arguments = ["z: &[[::rncf::emitted::Vector; 4]]", "rows: &mut [f64]"];
        let mut kernel = self.kernel(marked, LEVELS[level], what[level], values(&rows, "rows"), &arguments);
        if level == 0 {
            kernel.doc.push(self.markers.clone());
        }
        kernel
    }

    fn gradient(&self) -> Kernel {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let rows = self.in_graph(&mut marked);
        let z = marked.symbols[0].clone();
        let outputs = derivatives(&mut marked.time.graph, &rows, &z, "gradient");
        let title = "writes dC/dz, rows first; entries that are always zero are left alone.";
        self.kernel(
            marked,
            "gradient",
            title,
            outputs,
            &["z: &[::rncf::emitted::Vector]", "gradient: &mut [f64]"],
        )
    }

    fn rate_gradient(&self) -> Option<Kernel> {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let rows = self.in_graph(&mut marked);
        let (z, velocity) = (marked.symbols[0].clone(), marked.symbols[1].clone());
        let one = marked.time.graph.one();
        let mut rates = HashMap::from([(marked.time.t, one)]);
        rates.extend(z.iter().copied().zip(velocity));
        let rows: Vec<Id> = rows
            .iter()
            .map(|&row| marked.time.graph.differentiate(row, &rates))
            .collect();
        let outputs = derivatives(&mut marked.time.graph, &rows, &z, "gradient");
        let arguments = [
            "z: &[::rncf::emitted::Vector]",
            "velocity: &[::rncf::emitted::Vector]",
            "gradient: &mut [f64]",
        ];
        let title = "writes d(dC/dt)/dz at constant z', rows first; entries that are always zero are left alone.";
        let mut kernel = self.kernel(marked, "rate_gradient", title, outputs, &arguments);
        kernel
            .bindings
            .push(format!("let velocity = &velocity[..{}];", self.count));
        (!kernel.outputs.is_empty()).then_some(kernel)
    }

    /// Symmetric: the lower triangle is derived, the upper one is its mirror image. With the pairs of markers that it has
    /// entries of.
    fn hessian(&self) -> (Option<Kernel>, Vec<[usize; 2]>) {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let rows = self.in_graph(&mut marked);
        let z = marked.symbols[0].clone();
        let graph = &mut marked.time.graph;
        let multipliers: Vec<Id> = (0..rows.len())
            .map(|row| graph.symbol(format!("lambda[{row}]")))
            .collect();
        let sum = graph.dot(&multipliers, &rows);
        let (mut outputs, mut coupled) = (Vec::new(), BTreeSet::new());
        for (row, &first) in z.iter().enumerate() {
            let slope = graph.partial(sum, first);
            for (column, &second) in z[..=row].iter().enumerate() {
                let entry = graph.partial(slope, second);
                if graph.is_zero(entry) {
                    continue;
                }
                coupled.insert([column / 3, row / 3]);
                outputs.push((format!("hessian[{}]", row * z.len() + column), entry));
                if column != row {
                    outputs.push((format!("hessian[{}]", column * z.len() + row), entry));
                }
            }
        }
        let title = "writes sum_i lambda_i d^2 C_i/dz dz, rows first; entries that are always zero are left alone.";
        let arguments = ["z: &[::rncf::emitted::Vector]", "lambda: &[f64]", "hessian: &mut [f64]"];
        let mut kernel = self.kernel(marked, "hessian", title, outputs, &arguments);
        kernel
            .bindings
            .push(format!("let lambda = &lambda[..{}];", self.rows.len()));
        let coupled = coupled.into_iter().filter(|[first, second]| first != second);
        ((!kernel.outputs.is_empty()).then_some(kernel), coupled.collect())
    }
}
