//! Loads per length: what is the same along a body (values, once for each body) and the polynomial of position and
//! slope, integrated to generalised forces `Q^a = int s^a f dx` (THEORY 5.1, Eq. 38) by the Gauss rule that is
//! exact for its degree; gravity fields as functions of markers.
//!
//! The constant tensors of Eq. (38) are the same numbers: for the thrust the sums over inner products of d, s0, s1
//! take about as many operations (four nodal vectors, six inner products each) as four points, and the machinery of
//! `quadratic` derives forces from an energy, which a density has not.

use std::collections::HashMap;

use super::kernel::{Kernel, block, derivatives, values};
use super::markers::{Marked, describe, function_name, localise};
use super::quadratic::{base_vector, is_position, relative_shapes};
use super::variant::Variant;
use crate::elements::{Interpolant, Library, NodalVector};
use crate::model::fold;
use crate::model::{Binary, Density, Expr, LoadKind, Model};
use crate::symbolic::{Graph, Id, linear::Vector};
use crate::tensors::{Polynomial, gauss_rule};

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
const MARKERS: [&str; 2] = ["z: &[[f64; 3]]", "velocity: &[[f64; 3]]"];

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

/// A density on its way to functions.
struct Law<'m> {
    model: &'m Model,
    density: &'m Density,
    name: String,
    variant: Variant,
    vectors: Vec<&'m NodalVector>,
    /// Frame axes of the components of a nodal vector.
    axes: &'static [usize],
    /// Components along those, with markers counted in the density's own list.
    components: Vec<Expr>,
    library: &'m Library,
}

/// The polynomial with symbols.
struct Split<'m> {
    marked: Marked<'m>,
    /// What is the same along the body.
    values: Vec<Id>,
    /// Their symbols.
    symbols: Vec<Id>,
    /// Components of the density as polynomials of [`Split::locals`] and [`Split::symbols`].
    force: Vector,
    /// Symbols of position and slope.
    locals: [Vector; 2],
}

/// Position and slope at a point, and what they depend on.
struct Point {
    weight: f64,
    /// Shape functions of the relative vectors and their derivatives d/dxi.
    shapes: [Vec<f64>; 2],
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
        let split = self.split();
        let count = split.values.len();
        DensityKernels {
            values: count,
            value: (count > 0).then(|| self.value()),
            gradient: self.gradient(),
            force: self.force(),
            tangent: self.tangent(),
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
        let force = whole.iter().map(|&id| graph.substitute(id, &replaced)).collect();
        Split {
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
        split: Split,
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
        let points = self.points().len();
        Kernel {
            name: format!("density_{what}_{}", self.name),
            doc: vec![
                format!("Load per length `{}`: {title}", self.density.name),
                format!("Integrated exactly by {points} Gauss points."),
            ],
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

    fn force(&self) -> Kernel {
        let mut split = self.split();
        let element = Element::new(self, &mut split.marked.time.graph);
        let outputs = values(&element.forces(self, &mut split), "force");
        let size = self.variant.size(self.library);
        let title =
            "adds the generalised forces on the nodal vectors of one element, int s_a f dx, axes of the body's frame.";
        self.of_element(split, "force", title, outputs, &[format!("force: &mut [f64; {size}]")])
    }

    fn tangent(&self) -> Kernel {
        let mut split = self.split();
        let element = Element::new(self, &mut split.marked.time.graph);
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
        self.of_element(split, "tangent", title, outputs, &results)
    }
}

/// Symbols of an element.
struct Element {
    length: Id,
    /// Nodal vectors.
    q: Vec<Vector>,
    /// Vectors relative to the base, positions divided by the length; index and components.
    relative: Vec<(usize, Vector)>,
    base: usize,
    points: Vec<Point>,
}

impl Element {
    fn new(of: &Law, graph: &mut Graph) -> Self {
        let length = graph.symbol("length");
        let names = of.variant.component_names(of.library, "");
        let q: Vec<Vector> = names
            .into_iter()
            .map(|names| names.into_iter().map(|name| graph.symbol(name)).collect())
            .collect();
        let base = base_vector(&of.vectors);
        let shapes = relative_shapes(&of.vectors);
        let relative = shapes.iter().map(|&(index, _)| {
            if !is_position(of.vectors[index]) {
                return (index, q[index].clone());
            }
            let apart = graph.subtract_vectors(&q[index], &q[base]);
            (index, apart.into_iter().map(|x| graph.divide(x, length)).collect())
        });
        let relative = relative.collect();
        Self {
            length,
            q,
            relative,
            base,
            points: of.points(),
        }
    }

    /// What stands for position and slope at a point.
    fn locals(&self, split: &mut Split, point: &Point) -> HashMap<Id, Id> {
        let [position, slope] = split.locals.clone();
        let graph = &mut split.marked.time.graph;
        let mut at = HashMap::new();
        for c in 0..slope.len() {
            let sum = |graph: &mut Graph, weights: &[f64]| {
                let mut sum = graph.zero();
                for ((_, vector), &weight) in self.relative.iter().zip(weights) {
                    let weight = graph.number(weight);
                    let product = graph.multiply(weight, vector[c]);
                    sum = graph.add(sum, product);
                }
                sum
            };
            let within = sum(graph, &point.shapes[0]);
            let scaled = graph.multiply(self.length, within);
            at.insert(position[c], graph.add(self.q[self.base][c], scaled));
            at.insert(slope[c], sum(graph, &point.shapes[1]));
        }
        at
    }

    /// Generalised forces: those of positions add up to the whole, `Q_base = F - sum Q_position`.
    fn forces(&self, of: &Law, split: &mut Split) -> Vector {
        let d = of.axes.len();
        let zero = split.marked.time.graph.zero();
        let mut whole = vec![zero; d];
        let mut sums = vec![vec![zero; d]; self.relative.len()];
        for point in &self.points {
            let at = self.locals(split, point);
            let graph = &mut split.marked.time.graph;
            let weight = graph.number(point.weight);
            for c in 0..d {
                let force = graph.substitute(split.force[c], &at);
                let force = graph.multiply(weight, force);
                whole[c] = graph.add(whole[c], force);
                for (sum, &shape) in sums.iter_mut().zip(&point.shapes[0]) {
                    let shape = graph.number(shape);
                    let product = graph.multiply(shape, force);
                    sum[c] = graph.add(sum[c], product);
                }
            }
        }
        self.completed(of, &mut split.marked.time.graph, whole, sums, 1)
            .concat()
    }

    /// Rows of all nodal vectors from the whole and those of the relative ones, times their lengths and a power of
    /// the element's.
    fn completed(&self, of: &Law, graph: &mut Graph, whole: Vector, sums: Vec<Vector>, power: i32) -> Vec<Vector> {
        let mut rows = vec![Vec::new(); self.q.len()];
        let mut base = whole;
        for ((index, _), sum) in self.relative.iter().zip(sums) {
            let vector = of.vectors[*index];
            if is_position(vector) {
                base = graph.subtract_vectors(&base, &sum);
            }
            let scale = graph.power(self.length, power + vector.order as i32);
            rows[*index] = graph.scale(scale, &sum);
        }
        let scale = graph.power(self.length, power);
        rows[self.base] = graph.scale(scale, &base);
        rows
    }

    /// dQ/dq from the derivatives of the density by slope and position at each point; columns of positions are
    /// differences, the base takes what is left.
    fn by_q(&self, of: &Law, split: &mut Split) -> Vec<(String, Id)> {
        let (d, count) = (of.axes.len(), self.q.len());
        let size = d * count;
        let zero = split.marked.time.graph.zero();
        // By relative vectors, then by a shift of the whole element.
        let columns = self.relative.len() + 1;
        let mut whole = vec![vec![zero; d]; columns * d];
        let mut sums = vec![vec![vec![zero; d]; self.relative.len()]; columns * d];
        let partials = [0, 1].map(|order| -> Vec<Vector> {
            let locals = split.locals[order].clone();
            let graph = &mut split.marked.time.graph;
            let of_component = |&force: &Id| locals.iter().map(|&local| graph.partial(force, local)).collect();
            split.force.iter().map(of_component).collect()
        });
        for point in &self.points {
            let at = self.locals(split, point);
            let graph = &mut split.marked.time.graph;
            let weight = graph.number(point.weight);
            for row in 0..d {
                for by in 0..d {
                    let [position, slope] = [0, 1].map(|order| {
                        let partial = graph.substitute(partials[order][row][by], &at);
                        graph.multiply(weight, partial)
                    });
                    let carried = graph.multiply(self.length, position);
                    for column in 0..columns {
                        let change = match (point.shapes[0].get(column), point.shapes[1].get(column)) {
                            (Some(&shape), Some(&derivative)) => {
                                let (shape, derivative) = (graph.number(shape), graph.number(derivative));
                                let (a, b) = (graph.multiply(shape, carried), graph.multiply(derivative, slope));
                                graph.add(a, b)
                            }
                            _ => position,
                        };
                        let to = column * d + by;
                        whole[to][row] = graph.add(whole[to][row], change);
                        for (sum, &shape) in sums[to].iter_mut().zip(&point.shapes[0]) {
                            let shape = graph.number(shape);
                            let product = graph.multiply(shape, change);
                            sum[row] = graph.add(sum[row], product);
                        }
                    }
                }
            }
        }
        let graph = &mut split.marked.time.graph;
        let mut entries = vec![vec![zero; size]; size];
        for (to, (whole, sums)) in whole.into_iter().zip(sums).enumerate() {
            let (column, by) = (to / d, to % d);
            // Relative positions are divided by the length.
            let index = self.relative.get(column).map(|&(index, _)| index);
            let is_position = index.is_some_and(|index| is_position(of.vectors[index]));
            let rows = self.completed(of, graph, whole, sums, i32::from(!is_position)).concat();
            for (row, entry) in rows.into_iter().enumerate() {
                let base = self.base * d + by;
                let Some(index) = index else {
                    entries[row][base] = graph.add(entries[row][base], entry);
                    continue;
                };
                entries[row][index * d + by] = entry;
                if is_position {
                    entries[row][base] = graph.subtract(entries[row][base], entry);
                }
            }
        }
        let mut outputs = Vec::new();
        for (row, entries) in entries.into_iter().enumerate() {
            let places = entries.into_iter().enumerate();
            let there = places.filter(|&(_, entry)| !graph.is_zero(entry));
            outputs.extend(there.map(|(column, entry)| (format!("by_q[{}]", row * size + column), entry)));
        }
        outputs
    }
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
