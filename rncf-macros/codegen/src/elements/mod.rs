//! The element library: each element is one file of declarations, and nothing outside its file
//! names it, its strains or its stiffnesses.

mod beam;
mod cable;
mod full_beam;

use std::collections::HashMap;

use crate::model::Function;
use crate::symbolic::{Graph, Id, Invariant, Product, invariants};
use crate::tensors::Polynomial;

pub use beam::BEAM;
pub use cable::{Axial, CABLE, thin_beam};
pub use full_beam::{FULL_BEAM, VISCOUS_FULL_BEAM};

/// Where a nodal vector of an element lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node {
    /// At the first node, shared with the element before.
    Start,
    /// In the middle of the element, not shared.
    Middle,
    /// At the last node, shared with the element after.
    End,
}

/// What a nodal vector interpolates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interpolant {
    /// Position r of the axis.
    Position,
    /// Derivative of the position along the section's y axis, r_y; in a plane the only one.
    SectionY,
    /// Derivative of the position along the section's z axis, r_z; not in a plane.
    SectionZ,
}

/// A nodal vector of an element.
#[derive(Clone, Copy, Debug)]
pub struct NodalVector {
    /// Name in generated code, e.g. `r0`.
    pub name: &'static str,
    /// What it is, for documentation and messages: `position`, `slope`.
    pub meaning: &'static str,
    /// Node it belongs to.
    pub node: Node,
    /// What it interpolates.
    pub of: Interpolant,
    /// 0 for a value (position, r_y, r_z), 1 for a slope d/dx.
    pub order: usize,
    /// Shape function on the unit element, xi in [0, 1]; the real one is l^order times it.
    pub shape: fn() -> Polynomial,
}

/// A field at a point of the axis: a derivative of an interpolant, e.g. `a = r_x`.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Name in generated code.
    pub name: &'static str,
    /// What is differentiated.
    pub of: Interpolant,
    /// Order of the derivative with respect to x; at least 1 of the position.
    pub order: usize,
}

/// Mass per unit length that moves with an interpolant, e.g. `rho I_zz` with r_y.
#[derive(Clone, Copy, Debug)]
pub struct Inertia {
    /// What moves.
    pub of: Interpolant,
    /// Coefficient of the element, kg/m or kg m.
    pub coefficient: &'static str,
}

/// A coefficient of the element: a product of properties, e.g. `EA = young * area`.
#[derive(Clone, Copy, Debug)]
pub struct Coefficient {
    /// Name in generated code.
    pub name: &'static str,
    /// SI unit for documentation.
    pub unit: &'static str,
    /// Properties (vocabulary names) that are multiplied.
    pub factors: &'static [&'static str],
}

/// An option of the element that the user chooses in the mesh statement, `name = value`.
#[derive(Clone, Copy, Debug)]
pub struct ElementOption {
    /// Keyword.
    pub name: &'static str,
    /// Values; the first is the default.
    pub values: &'static [&'static str],
    /// What it means, for messages and documentation.
    pub doc: &'static str,
}

/// How the strain of an axis is measured; elements list it among their options.
const AXIAL: ElementOption = ElementOption {
    name: "axial",
    values: &["green", "engineering"],
    doc: "strain of the axis: Green's (|r_x|^2 - 1)/2, or engineering strain |r_x| - 1",
};

/// Whether the option [`AXIAL`] at this place asks for engineering strain.
fn is_engineering(options: &[usize], place: usize) -> bool {
    options.get(place) == Some(&1)
}

/// Strain of an axis with the square of the stretch `r_x . r_x`: `1/2 (r_x . r_x - 1)`, or `|r_x| - 1`.
pub fn axial_strain(graph: &mut Graph, square: Id, engineering: bool) -> Id {
    let (half, one) = (graph.number(0.5), graph.one());
    if engineering {
        let stretch = graph.call(Function::Sqrt, square);
        return graph.subtract(stretch, one);
    }
    let change = graph.subtract(square, one);
    graph.multiply(half, change)
}

/// One term of the strain energy density per unit length.
#[derive(Clone, Debug)]
pub struct Term {
    /// Name for documentation, e.g. `axial strain`.
    pub name: &'static str,
    /// Coefficient of the element that multiplies it.
    pub coefficient: &'static str,
    /// What is multiplied.
    pub density: Density,
    /// Number of Gauss points of this term; `None`: the rule that the body asks for.
    pub points: Option<usize>,
}

/// Density of a term, as an expression of the invariants of the fields.
#[derive(Clone, Copy, Debug)]
pub enum Density {
    /// `1/2 (s - s0)^2` of a scalar measure s whose value in the stress-free shape is s0; with
    /// damping c the stress is `s - s0 + c s'`, so that the dissipation `c s'^2` is never negative.
    Measure(Id),
    /// The same of a scalar measure with another law than a proportional one: with `e = s - s0` and damping c
    /// the stress is `S(e) + c S'(e) e'`, so that the dissipation is never negative where S never falls.
    Law {
        /// The measure s.
        measure: Id,
        /// Energy W and stress S = dW/de as expressions of e.
        law: fn(&mut Graph, Id) -> [Id; 2],
    },
    /// `1/2 (s - s0)^2` without damping.
    Undamped(Id),
    /// No energy: the stress is the rate s' of a measure, the dissipation `s'^2`; where the body is damped.
    Viscous(Id),
    /// The expression itself; zero in the stress-free shape, not damped.
    Energy(Id),
}

impl Density {
    /// The measure whose value in the stress-free shape is subtracted.
    pub fn measure(self) -> Option<Id> {
        match self {
            Density::Measure(measure) | Density::Undamped(measure) | Density::Law { measure, .. } => Some(measure),
            Density::Energy(_) | Density::Viscous(_) => None,
        }
    }

    /// Stress at a change of the measure, damped where a rate of the change and a damping (s) are given.
    pub fn stress(self, graph: &mut Graph, change: Id, damped: Option<[Id; 2]>) -> Id {
        let (stress, stiffness) = match self {
            Density::Law { law, .. } => {
                let symbol = graph.symbol("change");
                let [_, stress] = law(graph, symbol);
                let stiffness = graph.partial(stress, symbol);
                let real = HashMap::from([(symbol, change)]);
                (graph.substitute(stress, &real), graph.substitute(stiffness, &real))
            }
            _ => (change, graph.one()),
        };
        let Some([rate, damping]) = damped.filter(|_| !matches!(self, Density::Undamped(_))) else {
            return stress;
        };
        let viscosity = graph.multiply(damping, stiffness);
        let viscous = graph.multiply(viscosity, rate);
        graph.add(stress, viscous)
    }

    /// Energy of a change of the measure, times a factor.
    pub fn energy(self, graph: &mut Graph, change: Id, factor: Id) -> Id {
        if let Density::Law { law, .. } = self {
            let [energy, _] = law(graph, change);
            return graph.multiply(factor, energy);
        }
        let (half, square) = (graph.number(0.5), graph.power(change, 2));
        let half_factor = graph.multiply(half, factor);
        graph.multiply(half_factor, square)
    }
}

/// The invariants of the fields at a point, as symbols of the graph.
#[derive(Clone, Debug)]
pub struct Invariants {
    /// Number of components of a vector: 2 or 3.
    pub dimension: usize,
    /// `dots[i][j]` is field i . field j (symmetric).
    pub dots: Vec<Vec<Id>>,
    /// `crosses[i][j]` is field i x field j (planar only, antisymmetric; the diagonal is zero).
    pub crosses: Vec<Vec<Id>>,
}

/// An element: shape functions, inertia and strain energy. Everything else is derived.
#[derive(Clone, Copy)]
pub struct Element {
    /// Keywords of the language that mean this element.
    pub names: &'static [&'static str],
    /// Its name in generated code.
    pub kernel: &'static str,
    /// Whether its section says stiffness and mass by itself, so that the mesh names no material.
    pub of_stiffness: bool,
    /// What it is, for documentation.
    pub doc: &'static str,
    /// Nodal vectors in space; in a plane those of r_z are left out.
    pub vectors: &'static [NodalVector],
    /// Fields that the strain energy depends on, in space; in a plane those of r_z are left out.
    pub fields: &'static [Field],
    /// Coefficients.
    pub coefficients: &'static [Coefficient],
    /// Masses per unit length; interpolants do not couple (principal centroidal axes).
    pub inertia: &'static [Inertia],
    /// Vocabulary name of the property that damps the measures (s).
    pub damping: &'static str,
    /// Options.
    pub options: &'static [ElementOption],
    /// The strain energy density in the plane or in space (`Invariants::dimension`), for the chosen
    /// values of the options.
    pub energy: fn(&mut Graph, &Invariants, options: &[usize]) -> Vec<Term>,
    /// Gauss points where the energy is not polynomial and the user asks for no rule.
    pub default_points: usize,
    /// Least number of Gauss points that leaves no spurious zero mode.
    pub least_points: usize,
    /// Why an initially curved axis is refused in space; `None` where it is not.
    pub curved_in_space: Option<&'static str>,
    /// Whether every term has its own number of points, so that the body cannot ask for a rule.
    pub own_rule: bool,
}

impl Element {
    /// Whether its nodes carry the section's directions.
    pub fn has_section(&self) -> bool {
        self.vectors.iter().any(|vector| vector.of != Interpolant::Position)
    }

    /// Nodal vectors in the plane or in space.
    pub fn vectors_in(&self, dimension: usize) -> impl Iterator<Item = &'static NodalVector> {
        let vectors = self.vectors.iter();
        vectors.filter(move |vector| dimension == 3 || vector.of != Interpolant::SectionZ)
    }

    /// Fields in the plane or in space.
    pub fn fields_in(&self, dimension: usize) -> impl Iterator<Item = &'static Field> {
        let fields = self.fields.iter();
        fields.filter(move |field| dimension == 3 || field.of != Interpolant::SectionZ)
    }

    /// Masses in the plane or in space.
    pub fn inertia_in(&self, dimension: usize) -> impl Iterator<Item = &'static Inertia> {
        let inertia = self.inertia.iter();
        inertia.filter(move |inertia| dimension == 3 || inertia.of != Interpolant::SectionZ)
    }

    /// Terms of the strain energy, with the graph that their densities are in.
    pub fn terms_in(&self, dimension: usize, options: &[usize]) -> (Graph, Vec<Term>) {
        let mut graph = Graph::new();
        let (fields, _) = field_invariants(&mut graph, self, dimension);
        let terms = (self.energy)(&mut graph, &fields, options);
        (graph, terms)
    }

    /// Coefficients of the strain energy, for the chosen values of the options.
    pub fn elastic_coefficients(&self, dimension: usize, options: &[usize]) -> Vec<&'static Coefficient> {
        if self.of_stiffness {
            return self.coefficients.iter().collect();
        }
        let mut list = self.coefficients_in(dimension, options);
        list.retain(|one| self.inertia.iter().all(|inertia| inertia.coefficient != one.name));
        list
    }

    /// Coefficients that the strain energy or the inertia uses, for the chosen values of the options.
    pub fn coefficients_in(&self, dimension: usize, options: &[usize]) -> Vec<&'static Coefficient> {
        let (_, terms) = self.terms_in(dimension, options);
        let elastic = terms.iter().map(|term| term.coefficient);
        let inertial = self.inertia_in(dimension).map(|inertia| inertia.coefficient);
        let used: Vec<&str> = elastic.chain(inertial).collect();
        let all = self.coefficients.iter();
        all.filter(|coefficient| used.contains(&coefficient.name)).collect()
    }
}

/// Symbols for the invariants of the fields, as the energy's declaration takes them.
pub fn field_invariants(graph: &mut Graph, element: &Element, dimension: usize) -> (Invariants, Vec<(Invariant, Id)>) {
    let names: Vec<String> = element
        .fields_in(dimension)
        .map(|field| field.name.to_string())
        .collect();
    let count = names.len();
    let zero = graph.zero();
    let mut fields = Invariants {
        dimension,
        dots: vec![vec![zero; count]; count],
        crosses: vec![vec![zero; count]; count],
    };
    let mut symbols = Vec::new();
    for invariant in invariants(count, dimension) {
        let symbol = graph.symbol(invariant.name(&names));
        let (i, j) = (invariant.i, invariant.j);
        match invariant.product {
            Product::Dot => (fields.dots[i][j], fields.dots[j][i]) = (symbol, symbol),
            Product::Cross => (fields.crosses[i][j], fields.crosses[j][i]) = (symbol, graph.negate(symbol)),
        }
        symbols.push((invariant, symbol));
    }
    (fields, symbols)
}

/// The elements that the language knows.
#[derive(Clone)]
pub struct Library {
    /// All elements.
    pub elements: Vec<Element>,
}

impl Library {
    /// The elements of this crate.
    pub fn standard() -> Self {
        Self {
            elements: vec![CABLE, BEAM, FULL_BEAM, VISCOUS_FULL_BEAM],
        }
    }

    /// With one more element, e.g. a variant declared by a test.
    #[must_use]
    pub fn with(mut self, element: Element) -> Self {
        self.elements.push(element);
        self
    }

    /// Index of the element with this keyword, of a section that says its stiffness by itself, and whether each strain has a
    /// damping of its own.
    pub fn find_of_stiffness(&self, name: &str, is_viscous: bool) -> Option<usize> {
        let is_it = |element: &Element| {
            let is_alike = (element.kernel == VISCOUS_FULL_BEAM.kernel) == is_viscous;
            element.of_stiffness && is_alike && element.names.contains(&name)
        };
        self.elements.iter().position(is_it)
    }

    /// Index of the element with this keyword.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.elements.iter().position(|element| element.names.contains(&name))
    }
}
