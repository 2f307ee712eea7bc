//! Loads per length: what is the same along a body (values, once for each body) and the polynomial of position and
//! slope, integrated to generalised forces `Q^a = int s^a f dx` (docs/theory.md, Eq. 38) by the Gauss rule that is exact for its
//! degree, or by constant tensors, whichever takes fewer operations; gravity fields as functions of markers.

mod element;
mod integrals;
mod law;
mod tensor;

use super::kernel::{Kernel, block, derivatives, values};
use super::markers::{Marked, describe, function_name, localise};
use super::quadratic::relative_shapes;
use super::variant::Variant;
use crate::elements::{Interpolant, Library};
use crate::model::{Binary, Density, Expr, LoadKind, Model, fold};
use crate::symbolic::{Array, Graph, Id, Node, linear::Vector};
use crate::tensors::{Polynomial, gauss_rule};
use element::{Element, Point, Rule};
use integrals::Integrals;
use law::{Law, Split};
use tensor::is_quadratic;

/// The functions of one density.
#[derive(Clone, Debug)]
pub struct DensityKernels {
    /// Number of values.
    pub values: usize,
    /// Values, where there are any.
    pub value: Option<Kernel>,
    /// Their derivatives with respect to the markers, where not zero.
    pub gradient: Option<Kernel>,
    /// Generalised forces of one element.
    pub force: Kernel,
    /// Their derivatives with respect to nodal vectors and values.
    pub tangent: Kernel,
}

/// The functions of a gravity field.
#[derive(Clone, Debug)]
pub struct FieldKernels {
    /// Index of the load.
    pub load: usize,
    /// Its value.
    pub value: Kernel,
    /// Its derivatives with respect to the markers, where not zero.
    pub gradient: Option<Kernel>,
}

/// Arguments that give the markers.
const MARKERS: [&str; 2] = ["z: &[::rncf::emitted::Vector]", "velocity: &[::rncf::emitted::Vector]"];

/// The functions of all densities of a model.
pub fn density_kernels(model: &Model, library: &Library) -> Vec<DensityKernels> {
    let mut names = Vec::new();
    let kernels = model.densities.iter().map(|density| {
        let name = function_name(&density.name, &names);
        names.push(name.clone());
        Law::new(model, library, density, name).kernels()
    });
    kernels.collect()
}

/// The functions of all gravity fields of a model.
pub fn field_kernels(model: &Model) -> Vec<FieldKernels> {
    let mut names = Vec::new();
    let loads = model.loads.iter().enumerate();
    let fields = loads.filter_map(|(index, load)| {
        let LoadKind::Field {
            markers, components, ..
        } = &load.kind
        else {
            return None;
        };
        let name = function_name(&load.name, &names);
        names.push(name.clone());
        let in_graph = || {
            let mut marked = Marked::new(model, markers.len(), &[&|m, c| format!("z[{m}][{c}]")]);
            let field: Vector = components
                .iter()
                .map(|component| marked.time.expression(&localise(component, markers)))
                .collect();
            (marked, field)
        };
        let kernel = |marked: Marked, name: String, title: &str, outputs, out: &str| {
            let title = format!("Gravity field `{}`: {title}", load.name);
            marked.kernel(name, title, outputs, &[MARKERS[0], out])
        };
        let (marked, field) = in_graph();
        let outputs = values(&field, "gravity");
        let title = "g(z, t), m/s^2, inertial axes.";
        let mut value = kernel(
            marked,
            format!("field_{name}"),
            title,
            outputs,
            "gravity: &mut [f64; 3]",
        );
        value.doc.push(describe(model, &load.name, markers));
        let (mut marked, field) = in_graph();
        let z = marked.symbols[0].clone();
        let outputs = derivatives(&mut marked.time.graph, &field, &z, "gradient");
        let title = "writes dg/dz, rows first; entries that are always zero are left alone.";
        let gradient = (!outputs.is_empty()).then(|| {
            kernel(
                marked,
                format!("field_gradient_{name}"),
                title,
                outputs,
                "gradient: &mut [f64]",
            )
        });
        Some(FieldKernels {
            load: index,
            value,
            gradient,
        })
    });
    fields.collect()
}

impl<'m> Law<'m> {
    fn new(model: &'m Model, library: &'m Library, density: &'m Density, name: String) -> Self {
        let body = &model.bodies[density.body.0];
        let variant = Variant::of(model, body, library);
        let axes = body.space.axes();
        Self {
            model,
            density,
            name,
            vectors: variant.vectors(library),
            variant,
            axes,
            components: axes
                .iter()
                .map(|&axis| localise(&density.components[axis], &density.markers))
                .collect(),
            library,
        }
    }

    fn kernels(&self) -> DensityKernels {
        let mut split = self.split();
        let count = split.values.len();
        let (force, tangent) = self.of_elements(is_quadratic(&mut split));
        DensityKernels {
            values: count,
            value: (count > 0).then(|| self.value()),
            gradient: self.gradient(),
            force,
            tangent,
        }
    }

    /// Force and tangent in the form that takes fewer operations, with the counts of both.
    fn of_elements(&self, quadratic: bool) -> (Kernel, Kernel) {
        let build = |rule: &Rule| (self.force(rule), self.tangent(rule));
        let points = build(&Rule::Points(self.points()));
        if !quadratic {
            return points;
        }
        let tensors = build(&Rule::Tensors(self.integrals()));
        let cost = |(force, tangent): &(Kernel, Kernel)| (force.cost() + tangent.cost()).weighted();
        let (by_points, by_tensors) = (cost(&points), cost(&tensors));
        let mut chosen = if by_tensors < by_points { tensors } else { points };
        let told = format!(
            "The form is the cheaper one; weighted operations of force and tangent together: constant tensors {by_tensors}, points {by_points}."
        );
        for kernel in [&mut chosen.0, &mut chosen.1] {
            kernel.doc.push(told.clone());
        }
        chosen
    }

    /// Integrals of products of the relative vectors' shape functions on the axis.
    fn integrals(&self) -> Integrals {
        let shapes = relative_shapes(&self.vectors).into_iter();
        let on_axis = shapes.map(|(index, shape)| match self.vectors[index].of {
            Interpolant::Position => shape,
            _ => Polynomial::zero(),
        });
        Integrals::of(&on_axis.collect::<Vec<_>>())
    }

    /// How a rule integrates, in a sentence, and the arrays that it reads.
    fn told(&self, rule: &Rule) -> (String, Vec<Array>) {
        match rule {
            Rule::Points(points) => (
                format!("Integrated exactly by {} Gauss points.", points.len()),
                Vec::new(),
            ),
            Rule::Tensors(integrals) => {
                let shapes = relative_shapes(&self.vectors);
                let names: Vec<&str> = shapes.iter().map(|&(index, _)| self.vectors[index].name).collect();
                (
                    "Integrated exactly by constant tensors.".to_string(),
                    integrals.arrays(&self.variant.name(self.library), &names),
                )
            }
        }
    }

    /// Splits the density into what is the same along the body and a polynomial.
    fn split(&self) -> Split<'m> {
        let mut marked = Marked::values_and_rates(self.model, self.density.markers.len());
        let locals =
            [0, 1].map(|order| -> Vector { self.axes.iter().map(|&axis| marked.time.local(order, axis)).collect() });
        let whole: Vector = self
            .components
            .iter()
            .map(|component| marked.time.expression(component))
            .collect();
        let graph = &mut marked.time.graph;
        let all = locals.concat();
        let mut varies = vec![false; graph.len()];
        let nodes = graph.reachable(&whole);
        for &id in &nodes {
            varies[id.0 as usize] =
                all.contains(&id) || graph.children(id).iter().any(|child| varies[child.0 as usize]);
        }
        let mut same: Vec<Id> = Vec::new();
        let mut note = |graph: &Graph, id: Id| {
            if !varies[id.0 as usize] && graph.value(id).is_none() && !same.contains(&id) {
                same.push(id);
            }
        };
        whole.iter().for_each(|&id| note(graph, id));
        for &id in nodes.iter().filter(|id| varies[id.0 as usize]) {
            graph.children(id).into_iter().for_each(|child| note(graph, child));
        }
        let symbols: Vec<Id> = (0..same.len())
            .map(|place| graph.symbol(format!("values[{place}]")))
            .collect();
        let replaced = same.iter().copied().zip(symbols.iter().copied()).collect();
        let mut force: Vector = whole.iter().map(|&id| graph.substitute(id, &replaced)).collect();
        let factor = common_factor(graph, &mut force, &all);
        Split {
            factor,
            marked,
            values: same,
            symbols,
            force,
            locals,
        }
    }

    fn of_markers(&self, marked: Marked, what: &str, title: &str, outputs: Vec<(String, Id)>, out: &str) -> Kernel {
        let title = format!("Load per length `{}`: {title}", self.density.name);
        let name = format!("density_{what}_{}", self.name);
        let mut kernel = marked.kernel(name, title, outputs, &[MARKERS[0], MARKERS[1], out]);
        if self.is_repeated() {
            kernel.arguments.insert(2, "index: f64".to_string());
        }
        kernel
    }

    fn is_repeated(&self) -> bool {
        self.model.bodies[self.density.body.0].repeat.is_some()
    }

    fn value(&self) -> Kernel {
        let split = self.split();
        let outputs = values(&split.values, "values");
        let title = "writes what it depends on along the whole body.";
        let mut kernel = self.of_markers(split.marked, "values", title, outputs, "values: &mut [f64]");
        if !self.density.markers.is_empty() {
            kernel
                .doc
                .push(describe(self.model, &self.density.name, &self.density.markers));
        }
        kernel
    }

    fn gradient(&self) -> Option<Kernel> {
        let mut split = self.split();
        let z = split.marked.symbols[0].clone();
        let outputs = derivatives(&mut split.marked.time.graph, &split.values, &z, "gradient");
        let title = "writes the derivatives of its values with respect to z, rows first; entries that are always zero are left alone.";
        (!outputs.is_empty()).then(|| self.of_markers(split.marked, "gradient", title, outputs, "gradient: &mut [f64]"))
    }

    /// Points of the rule that integrates the product with a shape function exactly.
    fn points(&self) -> Vec<Point> {
        let shapes: Vec<(usize, Polynomial)> = relative_shapes(&self.vectors);
        let is_axis = |index: &usize| self.vectors[*index].of == Interpolant::Position;
        let highest = shapes
            .iter()
            .filter(|(index, _)| is_axis(index))
            .map(|(_, shape)| shape.degree())
            .max()
            .unwrap_or(0);
        let degree = self
            .components
            .iter()
            .map(|component| degree(component, highest))
            .max()
            .unwrap_or(0);
        let rule = gauss_rule((degree + highest) / 2 + 1);
        let points = rule.points.iter().zip(&rule.weights);
        points
            .map(|(&xi, &weight)| Point {
                weight,
                shapes: [0, 1].map(|order| {
                    let at = |(index, shape): &(usize, Polynomial)| {
                        if is_axis(index) {
                            shape.derivative(order).at(xi)
                        } else {
                            0.0
                        }
                    };
                    shapes.iter().map(at).collect()
                }),
            })
            .collect()
    }

    /// The kernel of an element from its outputs.
    fn of_element(
        &self,
        mut split: Split,
        rule: &Rule,
        what: &str,
        title: &str,
        outputs: Vec<(String, Id)>,
        results: &[String],
    ) -> Kernel {
        let (size, count) = (self.variant.size(self.library), split.values.len());
        let mut arguments = vec![
            "length: &[f64; 1]".to_string(),
            format!("values: &[f64; {count}]"),
            format!("q: &[f64; {size}]"),
        ];
        arguments.extend(results.iter().cloned());
        let names = self.variant.component_names(self.library, "").concat();
        let (integrated, arrays) = self.told(rule);
        let roots = outputs.iter().map(|&(_, id)| id);
        split.marked.time.graph.read_from(roots, arrays, &[]);
        Kernel {
            name: format!("density_{what}_{}", self.name),
            doc: vec![format!("Load per length `{}`: {title}", self.density.name), integrated],
            arguments,
            bindings: vec![
                "let [length] = *length;".to_string(),
                format!("let [{}] = *q;", names.join(", ")),
            ],
            graph: split.marked.time.graph,
            points: None,
            outputs,
            assign: false,
        }
    }

    fn force(&self, rule: &Rule) -> Kernel {
        let mut split = self.split();
        let element = Element::new(self, &mut split.marked.time.graph, rule);
        let outputs = values(&element.forces(self, &mut split), "force");
        let size = self.variant.size(self.library);
        let title =
            "adds the generalised forces on the nodal vectors of one element, int s_a f dx, axes of the body's frame.";
        self.of_element(
            split,
            rule,
            "force",
            title,
            outputs,
            &[format!("force: &mut [f64; {size}]")],
        )
    }

    fn tangent(&self, rule: &Rule) -> Kernel {
        let mut split = self.split();
        let element = Element::new(self, &mut split.marked.time.graph, rule);
        let (size, count) = (self.variant.size(self.library), split.values.len());
        let mut outputs = element.by_q(self, &mut split);
        let force = element.forces(self, &mut split);
        let symbols = split.symbols.clone();
        outputs.extend(block(
            &mut split.marked.time.graph,
            &force,
            &symbols,
            "by_values",
            (count, 0),
        ));
        let title = "adds the derivatives of the generalised forces with respect to q and to the values, rows first.";
        let results = [
            format!("by_q: &mut [f64; {}]", size * size),
            format!("by_values: &mut [f64; {}]", size * count),
        ];
        self.of_element(split, rule, "tangent", title, outputs, &results)
    }
}

/// Takes what all components are multiplied with, and what does not depend on `locals`, out of them; one where there is nothing.
fn common_factor(graph: &mut Graph, force: &mut Vector, locals: &[Id]) -> Id {
    let factors = |graph: &Graph, id: Id| match graph.node(id) {
        Node::Multiply(a, b) => vec![(a, b), (b, a)],
        _ => Vec::new(),
    };
    let there: Vec<Id> = force.iter().copied().filter(|&id| !graph.is_zero(id)).collect();
    let candidates = there.first().map_or(Vec::new(), |&first| factors(graph, first));
    let is_common = |candidate: Id| {
        !graph.depends_on(candidate, locals)
            && there
                .iter()
                .all(|&id| factors(graph, id).iter().any(|&(factor, _)| factor == candidate))
    };
    let Some(&(common, _)) = candidates.iter().find(|&&(candidate, _)| is_common(candidate)) else {
        return graph.one();
    };
    for component in force.iter_mut() {
        if let Some(&(_, rest)) = factors(graph, *component).iter().find(|&&(factor, _)| factor == common) {
            *component = rest;
        }
    }
    common
}

/// Degree in xi of a density whose position has the given degree; all that is checked to be polynomial.
fn degree(expr: &Expr, highest: usize) -> usize {
    let of = |expr: &Expr| degree(expr, highest);
    match expr {
        Expr::Local { order, .. } => highest.saturating_sub(*order),
        Expr::Negate(inner) => of(inner),
        Expr::Binary(Binary::Multiply, a, b) => of(a) + of(b),
        Expr::Binary(Binary::Divide, a, _) => of(a),
        Expr::Binary(_, a, b) => of(a).max(of(b)),
        Expr::Power(base, exponent) => of(base) * fold::constant(exponent).map_or(0, |n| n as usize),
        Expr::If(.., then, otherwise) => of(then).max(of(otherwise)),
        _ => 0,
    }
}
