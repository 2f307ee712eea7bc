//! Elements as all phases see them: nodal vectors, fields, inertia, energy.

use std::collections::HashMap;
use std::sync::Arc;

use crate::model::{Expr, Function, fold};
use crate::symbolic::{Graph, Id, Invariant, Product, invariants};
use crate::tensors::{Polynomial, Rational, Sampling};

/// Name in generated code of the one that damps each strain by itself.
pub const VISCOUS: &str = "full_beam_viscous";

/// Coordinates of the largest element, for which the runtime has memory: its `MAX_SIZE`.
pub const LARGEST: usize = 32;

/// Name of what stands between the interfaces of a body from a file, which no text can name.
pub const BETWEEN_INTERFACES: &str = "(interfaces)";

/// Where a nodal vector of an element sits: xi in [0, 1] of the unit element. Those at 0 and 1 are shared with the
/// elements before and after.
pub type Place = Rational;

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
#[derive(Clone, Debug)]
pub struct NodalVector {
    /// Name in generated code, e.g. `r0`.
    pub name: &'static str,
    /// What it is, for documentation and messages: `position`, `slope`.
    pub meaning: &'static str,
    /// Where it sits.
    pub place: Place,
    /// What it interpolates.
    pub of: Interpolant,
    /// 0 for a value (position, r_y, r_z), 1 for a slope d/dx.
    pub order: usize,
    /// Shape function on the unit element, xi in [0, 1]; the real one is l^order times it.
    pub shape: Polynomial,
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

/// A coefficient of the element: a product of properties, e.g. `EA = young * area`, and of a value that params give.
#[derive(Clone, Debug)]
pub struct Coefficient {
    /// Name in generated code.
    pub name: &'static str,
    /// SI unit for documentation.
    pub unit: &'static str,
    /// Properties (vocabulary names) that are multiplied.
    pub factors: Vec<&'static str>,
    /// A further factor in SI, which is the same along the body; `None`: one.
    pub scale: Option<Expr>,
}

impl Coefficient {
    /// Whether it changes with time.
    pub fn is_timed(&self) -> bool {
        self.scale.as_ref().is_some_and(|scale| !fold::is_free_of_time(scale))
    }
}

/// An option of the element that the user chooses in the mesh statement, `name = value`.
#[derive(Clone, Debug)]
pub struct ElementOption {
    /// Keyword.
    pub name: &'static str,
    /// Values; the first is the default.
    pub values: Vec<&'static str>,
    /// What it means, for messages and documentation.
    pub doc: String,
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
    /// Coefficient of the element that multiplies it; empty: none does.
    pub coefficient: &'static str,
    /// What is multiplied.
    pub density: Density,
    /// Where this term is integrated; `None`: by the rule that the body asks for.
    pub points: Option<Sampling>,
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
        /// The symbol that stands for e.
        change: Id,
        /// Energy W, an expression of e.
        energy: Id,
        /// Stress S = dW/de.
        stress: Id,
    },
    /// `1/2 (s - s0)^2` without damping.
    Undamped(Id),
    /// No energy: the stress is the rate s' of a measure, the dissipation `s'^2`; where the body is damped.
    Viscous(Id),
    /// The expression itself, not damped; of an axis that is curved without stress it is of inner products that count from
    /// their values there.
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

    /// Its expressions.
    pub fn expressions(self) -> Vec<Id> {
        match self {
            Density::Measure(id) | Density::Undamped(id) | Density::Viscous(id) | Density::Energy(id) => vec![id],
            Density::Law {
                measure,
                energy,
                stress,
                ..
            } => vec![measure, energy, stress],
        }
    }

    /// Stress at a change of the measure, damped where a rate of the change and a damping (s) are given.
    pub fn stress(self, graph: &mut Graph, change: Id, damped: Option<[Id; 2]>) -> Id {
        let (stress, stiffness) = match self {
            Density::Law {
                change: symbol, stress, ..
            } => {
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
        if let Density::Law {
            change: symbol, energy, ..
        } = self
        {
            let energy = graph.substitute(energy, &HashMap::from([(symbol, change)]));
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

/// The strain energy density in the plane or in space (`Invariants::dimension`), for the chosen values of the options.
pub type Energy = Arc<dyn Fn(&mut Graph, &Invariants, &[usize]) -> Vec<Term> + Send + Sync>;

/// An element: shape functions, inertia and strain energy. Everything else is derived.
#[derive(Clone)]
pub struct Element {
    /// Keywords of the language that mean this element.
    pub names: Vec<&'static str>,
    /// Its name in generated code.
    pub kernel: &'static str,
    /// Whether its section says stiffness and mass by itself, so that the mesh names no material.
    pub of_stiffness: bool,
    /// What it is, for documentation.
    pub doc: String,
    /// Nodal vectors in space; in a plane those of r_z are left out.
    pub vectors: Vec<NodalVector>,
    /// Fields that the strain energy depends on, in space; in a plane those of r_z are left out.
    pub fields: Vec<Field>,
    /// Coefficients.
    pub coefficients: Vec<Coefficient>,
    /// Masses per unit length; interpolants do not couple (principal centroidal axes).
    pub inertia: Vec<Inertia>,
    /// Vocabulary name of the property that damps the measures (s).
    pub damping: &'static str,
    /// Options.
    pub options: Vec<ElementOption>,
    /// The strain energy density.
    pub energy: Energy,
    /// Gauss points where the energy is not polynomial and the user asks for no rule.
    pub default_points: usize,
    /// Whether every term has its own number of points, so that the body cannot ask for a rule.
    pub own_rule: bool,
    /// Whether it is one of this crate's.
    pub is_of_library: bool,
}

impl Element {
    /// Whether its nodes carry the section's directions.
    pub fn has_section(&self) -> bool {
        self.vectors.iter().any(|vector| vector.of != Interpolant::Position)
    }

    /// Whether its sections have one direction alone, so that they lie in a plane.
    pub fn is_planar(&self) -> bool {
        self.has_section() && !self.vectors.iter().any(|vector| vector.of == Interpolant::SectionZ)
    }

    /// Whether its nodes carry the slope of the axis.
    pub fn has_slope(&self) -> bool {
        let is_slope = |vector: &NodalVector| (vector.of, vector.order) == (Interpolant::Position, 1);
        self.vectors
            .iter()
            .any(|vector| vector.place == Rational::ZERO && is_slope(vector))
    }

    /// Nodal vectors in the plane or in space.
    pub fn vectors_in(&self, dimension: usize) -> impl Iterator<Item = &NodalVector> {
        let vectors = self.vectors.iter();
        vectors.filter(move |vector| dimension == 3 || vector.of != Interpolant::SectionZ)
    }

    /// Fields in the plane or in space.
    pub fn fields_in(&self, dimension: usize) -> impl Iterator<Item = &Field> {
        let fields = self.fields.iter();
        fields.filter(move |field| dimension == 3 || field.of != Interpolant::SectionZ)
    }

    /// Masses in the plane or in space.
    pub fn inertia_in(&self, dimension: usize) -> impl Iterator<Item = &Inertia> {
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
    pub fn elastic_coefficients(&self, dimension: usize, options: &[usize]) -> Vec<&Coefficient> {
        if self.of_stiffness {
            return self.coefficients.iter().collect();
        }
        let mut list = self.coefficients_in(dimension, options);
        list.retain(|one| self.inertia.iter().all(|inertia| inertia.coefficient != one.name));
        list
    }

    /// Coefficients that the strain energy or the inertia uses, for the chosen values of the options.
    pub fn coefficients_in(&self, dimension: usize, options: &[usize]) -> Vec<&Coefficient> {
        let (graph, terms) = self.terms_in(dimension, options);
        let roots: Vec<Id> = terms.iter().flat_map(|term| term.density.expressions()).collect();
        let reached = graph.reachable(&roots);
        let inputs = |name: &str| reached.iter().any(|&id| graph.is_input(id, name));
        let is_used = |one: &&Coefficient| {
            terms.iter().any(|term| term.coefficient == one.name)
                || self
                    .inertia_in(dimension)
                    .any(|inertia| inertia.coefficient == one.name)
                || inputs(one.name)
        };
        self.coefficients.iter().filter(is_used).collect()
    }

    /// Whether its strain energy changes with time, for the chosen values of the options.
    pub fn is_timed(&self, dimension: usize, options: &[usize]) -> bool {
        self.coefficients_in(dimension, options)
            .into_iter()
            .any(Coefficient::is_timed)
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
#[derive(Clone, Default)]
pub struct Library {
    /// All elements.
    pub elements: Vec<Element>,
}

impl Library {
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
            let is_alike = (element.kernel == VISCOUS) == is_viscous;
            element.of_stiffness && is_alike && element.names.contains(&name)
        };
        self.elements.iter().position(is_it)
    }

    /// Index of the element with this keyword.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.elements.iter().position(|element| element.names.contains(&name))
    }
}
