//! What distinguishes one emitted element from another: one set of kernels serves every body that
//! agrees in all of this, whatever its lengths, stiffnesses and densities.

use super::material::Material;
use crate::elements::{Coefficient, Element, Library, NodalVector};
use crate::model::{Body, ElementId, Evaluation, Expr, Line, Model, Quadrature};
use crate::tensors::Rational;

/// A specialised element.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// Element of the library.
    pub element: ElementId,
    /// Components of a nodal vector: 2 or 3.
    pub dimension: usize,
    /// Chosen values of the element's options.
    pub options: Vec<usize>,
    /// Integration rule of the strain energy.
    pub quadrature: Quadrature,
    /// Wanted form of the elastic kernels.
    pub evaluation: Evaluation,
    /// Whether the material has damping that may differ from zero.
    pub damped: bool,
    /// Whether the stress-free axis is curved, or its section twisted.
    pub curved: bool,
    /// Whether coefficients or lengths differ from element to element: coefficients are then numbers at every point of
    /// integration, beside the values in the stress-free shape.
    pub varying: bool,
    /// Material that is given by its energy, integrated over the section; `None`: by the element's terms.
    pub material: Option<Material>,
}

/// Words for the components of a vector in generated code.
const COMPONENTS: [&str; 3] = ["x", "y", "z"];

impl Variant {
    /// The variant that a body needs.
    pub fn of(model: &Model, body: &Body, library: &Library) -> Self {
        let damping = body.properties.get(library.elements[body.element.0].damping);
        Self {
            element: body.element,
            dimension: body.space.dimension(),
            options: body.options.clone(),
            quadrature: body.quadrature,
            evaluation: body.evaluation,
            damped: damping.is_some_and(|value| *value != Expr::Number(0.0)),
            curved: !matches!(body.line, Line::Straight { .. } | Line::Imported(_)) || body.twist != Expr::Number(0.0),
            varying: body.varies(),
            material: Material::of(model, body),
        }
    }

    /// The element's declaration.
    pub fn declaration<'l>(&self, library: &'l Library) -> &'l Element {
        &library.elements[self.element.0]
    }

    /// Coefficients of the element that its kernels use.
    pub fn coefficients<'l>(&self, library: &'l Library) -> Vec<&'l Coefficient> {
        let element = self.declaration(library);
        let mut list = element.coefficients_in(self.dimension, &self.options);
        if self.varying {
            // What changes with time is the same at all points.
            list.retain(|one| one.is_timed());
        }
        if self.material.is_some() {
            list.retain(|one| element.inertia.iter().any(|inertia| inertia.coefficient == one.name));
        }
        list
    }

    /// Nodal vectors of one element.
    pub fn vectors<'l>(&self, library: &'l Library) -> Vec<&'l NodalVector> {
        self.declaration(library).vectors_in(self.dimension).collect()
    }

    /// Name in generated code, e.g. `cable_planar_exact_damped`.
    pub fn name(&self, library: &Library) -> String {
        let element = self.declaration(library);
        let mut name = format!(
            "{}_{}",
            element.kernel,
            if self.dimension == 2 { "planar" } else { "spatial" }
        );
        for (option, &choice) in element.options.iter().zip(&self.options) {
            match option.values[choice] {
                _ if choice == 0 => {}
                "true" => name += &format!("_{}", option.name),
                value => name += &format!("_{value}"),
            }
        }
        if let Quadrature::Gauss(points) = self.quadrature {
            name += &format!("_gauss{points}");
        }
        name += match self.evaluation {
            Evaluation::Automatic => "",
            Evaluation::Tensor => "_tensor",
            Evaluation::Points => "_points",
            Evaluation::Loop => "_loop",
        };
        if let Some(material) = &self.material {
            name += &material.suffix();
        }
        if self.curved {
            name += "_curved";
        }
        if self.varying && !element.of_stiffness {
            name += "_varying";
        }
        if self.damped {
            name += "_damped";
        }
        name
    }

    /// Coefficients that are numbers at every point of integration.
    pub fn varying_coefficients<'l>(&self, library: &'l Library) -> Vec<&'l Coefficient> {
        if !self.varying {
            return Vec::new();
        }
        let mut list = self
            .declaration(library)
            .elastic_coefficients(self.dimension, &self.options);
        list.retain(|one| !one.is_timed());
        list
    }

    /// Whether elements have numbers of their own.
    pub fn has_references(&self) -> bool {
        self.curved || self.varying
    }

    /// Degrees of freedom of one element.
    pub fn size(&self, library: &Library) -> usize {
        self.vectors(library).len() * self.dimension
    }

    /// Names of all components of the nodal vectors with a prefix, e.g. `r0_x, r0_y, s0_x, ..`.
    pub fn component_names(&self, library: &Library, prefix: &str) -> Vec<Vec<String>> {
        let component = |name: &str, c: usize| format!("{prefix}{name}_{}", COMPONENTS[c]);
        let vectors = self.vectors(library).into_iter();
        vectors
            .map(|vector| (0..self.dimension).map(|c| component(vector.name, c)).collect())
            .collect()
    }

    /// Where an element's vectors are among those of its body.
    pub fn connectivity(&self, library: &Library) -> Connectivity {
        let vectors = self.vectors(library);
        let which = |vector: &NodalVector| match vector.place {
            Rational::ZERO => 0,
            Rational::ONE => 2,
            _ => 1,
        };
        let count = |node: usize| vectors.iter().filter(|vector| which(vector) == node).count();
        let (per_node, inside) = (count(0), count(1));
        let mut next = [0, per_node, per_node + inside];
        let places = vectors.iter().map(|vector| {
            let place = &mut next[which(vector)];
            *place += 1;
            *place - 1
        });
        Connectivity {
            places: places.collect(),
            per_node,
            stride: per_node + inside,
        }
    }
}

/// Where the vectors of an element are: nodes and insides of elements follow each other, `node, inside,
/// node, inside, .., node`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Connectivity {
    /// Place of each local vector relative to the first vector of the element's first node.
    pub places: Vec<usize>,
    /// Vectors of a node.
    pub per_node: usize,
    /// Vectors from one node to the next.
    pub stride: usize,
}
