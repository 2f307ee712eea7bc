//! A kernel while it is built: its graph, relative vectors, and what it gives.

use std::collections::HashMap;

use crate::elements::{Element, Field, Library, NodalVector, Term};
use crate::lower::form::{Form, Quantity};
use crate::lower::invariants::Blocks;
use crate::lower::kernel::{Kernel, PointLoop};
use crate::lower::quadratic::{base_vector, is_position};
use crate::lower::signature::Signature;
use crate::lower::variant::Variant;
use crate::symbolic::{Array, Graph, Id, Invariant, linear::Vector};
use crate::tensors::Sampling;

/// A stress state: on which invariants, of which vectors, and what it adds up to.
pub(super) struct State {
    pub(super) invariants: Vec<Invariant>,
    pub(super) stress: Vec<Id>,
    pub(super) stiffness: Vec<Vec<Id>>,
    pub(super) viscosity: Vec<Vec<Id>>,
    pub(super) energy: Id,
}

pub(super) struct Builder<'a> {
    pub(super) variant: &'a Variant,
    pub(super) library: &'a Library,
    pub(super) element: &'a Element,
    /// Nodal vectors and fields in the plane or in space.
    pub(super) nodal: Vec<&'a NodalVector>,
    pub(super) declared: Vec<&'a Field>,
    pub(super) form: Form,
    pub(super) quantity: Quantity,
    pub(super) graph: Graph,
    pub(super) inverse_length: Id,
    pub(super) length: Id,
    pub(super) damping: Id,
    pub(super) coefficients: HashMap<&'static str, Id>,
    /// Relative vectors and their rates.
    pub(super) vectors: Vec<Vector>,
    pub(super) rates: Vec<Vector>,
    /// The same vectors at both ends of a step, of a force between two states; `vectors` are then their mean.
    pub(super) ends: Option<[Vec<Vector>; 2]>,
    /// What the averaged invariants are of: those vectors, or the fields at a point.
    pub(super) averaged: Option<[Vec<Vector>; 2]>,
    pub(super) force: Vec<Vector>,
    pub(super) stiffness: Blocks,
    pub(super) viscosity: Option<Blocks>,
    pub(super) energy: Id,
    pub(super) references: Vec<Id>,
    /// Constant tensors that the kernel reads.
    pub(super) arrays: Vec<Array>,
    /// The rule whose terms are integrated.
    pub(super) rule: Sampling,
    /// Measures at the points before.
    pub(super) passed: usize,
    pub(super) points: Option<PointLoop>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(variant: &'a Variant, library: &'a Library, form: Form, quantity: Quantity) -> Self {
        let element = variant.declaration(library);
        let mut graph = Graph::new();
        let length = graph.symbol("length");
        let one = graph.one();
        let inverse_length = graph.divide(one, length);
        graph.name(inverse_length, "inverse_length");
        let damping = graph.symbol("damping");
        let coefficients = element
            .coefficients
            .iter()
            .map(|c| (c.name, graph.input(c.name)))
            .chain([("", one)])
            .collect();
        let mut builder = Self {
            variant,
            library,
            element,
            nodal: variant.vectors(library),
            declared: element.fields_in(variant.dimension).collect(),
            form,
            quantity,
            inverse_length,
            length,
            damping,
            coefficients,
            vectors: Vec::new(),
            rates: Vec::new(),
            ends: None,
            averaged: None,
            force: Vec::new(),
            stiffness: Vec::new(),
            viscosity: None,
            energy: graph.zero(),
            references: Vec::new(),
            arrays: Vec::new(),
            rule: Sampling::Gauss(0),
            passed: 0,
            points: None,
            graph,
        };
        builder.vectors = builder.relative_vectors("");
        if variant.damped && matches!(quantity, Quantity::Force | Quantity::Tangent) {
            builder.rates = builder.relative_vectors("v_");
        }
        builder
    }

    /// Relative vectors from nodal ones: differences of positions over the length, slopes.
    pub(super) fn relative_vectors(&mut self, prefix: &str) -> Vec<Vector> {
        let names = self.variant.component_names(self.library, prefix);
        let nodal: Vec<Vector> = names
            .iter()
            .map(|list| list.iter().map(|name| self.graph.symbol(name.clone())).collect())
            .collect();
        let base = base_vector(&self.nodal);
        let mut relative = Vec::new();
        for (index, vector) in self.nodal.iter().enumerate() {
            if index == base {
                continue;
            }
            if is_position(vector) {
                let difference = self.graph.subtract_vectors(&nodal[index], &nodal[base]);
                let scaled = self.graph.scale(self.inverse_length, &difference);
                let difference = self.difference(vector);
                for (c, &id) in scaled.iter().enumerate() {
                    self.graph
                        .name(id, format!("{prefix}{difference}_{}", ["x", "y", "z"][c]));
                }
                relative.push(scaled);
            } else {
                relative.push(nodal[index].clone());
            }
        }
        relative
    }

    /// Name of the position of a node relative to that of the base, over the length: `d`, of several `d_r1`.
    pub(super) fn difference(&self, vector: &NodalVector) -> String {
        match self.nodal.iter().filter(|vector| is_position(vector)).count() {
            0..=2 => "d".to_string(),
            _ => format!("d_{}", vector.name),
        }
    }

    /// Lengths of the relative vectors in a straight, unstretched element.
    pub(super) fn relative_lengths(&self) -> Vec<f64> {
        let base = base_vector(&self.nodal);
        let start = self.nodal[base].place.to_f64();
        let vectors = self.nodal.iter().enumerate().filter(|&(index, _)| index != base);
        vectors
            .map(|(_, vector)| {
                if is_position(vector) {
                    vector.place.to_f64() - start
                } else {
                    1.0
                }
            })
            .collect()
    }

    /// Names of the relative vectors for documentation and variables.
    pub(super) fn relative_names(&self) -> Vec<String> {
        let base = base_vector(&self.nodal);
        let vectors = self.nodal.iter().enumerate().filter(|&(index, _)| index != base);
        vectors
            .map(|(_, vector)| {
                if is_position(vector) {
                    self.difference(vector)
                } else {
                    vector.name.to_string()
                }
            })
            .collect()
    }

    pub(super) fn length_power(&mut self, power: i32) -> Id {
        if power >= 0 {
            self.graph.power(self.length, power)
        } else {
            self.graph.power(self.inverse_length, -power)
        }
    }

    pub(super) fn reference_symbol(&mut self, index: usize) -> Id {
        while self.references.len() <= index {
            let next = self.references.len();
            let symbol = self.graph.symbol(format!("reference[{next}]"));
            self.references.push(symbol);
        }
        self.references[index]
    }

    /// Has the numbers of the tensors read from their arrays; the lengths of vectors are no such numbers.
    pub(super) fn read_arrays(&mut self, outputs: &[(String, Id)]) {
        let lengths = self.relative_lengths();
        let products = lengths.iter().flat_map(|a| lengths.iter().map(move |b| a * b));
        let arrays = std::mem::take(&mut self.arrays);
        let roots = outputs.iter().map(|&(_, id)| id);
        self.graph.read_from(roots, arrays, &products.collect::<Vec<f64>>());
    }

    /// Back to nodal vectors, and the function around it.
    pub(super) fn finish(mut self) -> Kernel {
        let outputs = match self.quantity {
            Quantity::Energy => vec![("*energy".to_string(), self.energy)],
            Quantity::Reference => self
                .references
                .iter()
                .enumerate()
                .map(|(index, &id)| (format!("reference[{index}]"), id))
                .filter(|(name, id)| !self.graph.is_input(*id, name))
                .collect(),
            Quantity::Force => self.nodal_force(),
            Quantity::Tangent => {
                let stiffness = std::mem::take(&mut self.stiffness);
                let mut outputs = self.nodal_blocks(&stiffness, "stiffness");
                if let Some(viscosity) = self.viscosity.take() {
                    outputs.extend(self.nodal_blocks(&viscosity, "damping_matrix"));
                }
                outputs
            }
        };
        self.read_arrays(&outputs);
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references: self.references.len(),
        };
        signature.elastic(self.form, self.quantity, self.graph, self.points, outputs)
    }
}

/// Numbers that every element keeps for one of its points: what counts from the stress-free shape, which stands first, and
/// coefficients that vary. The terms are of a graph with these inner products.
pub(super) fn kept_at_point(
    (variant, library): (&Variant, &Library),
    terms: &[Term],
    graph: &Graph,
    products: &[Id],
) -> [usize; 2] {
    let counted = terms.iter().map(|term| term.density.counted(graph, products).len());
    let measures = if variant.curved { counted.sum() } else { 0 };
    [measures, variant.varying_coefficients(library).len()]
}
