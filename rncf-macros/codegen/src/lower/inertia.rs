//! Mass matrices of elements: exact integrals of their shape functions. Inertia forces and their derivatives are
//! sums with constant coefficients over nodal vectors (THEORY 2, 2.1), the same for all models: the runtime has them.

use super::kernel::Kernel;
use super::signature::Signature;
use super::variant::Variant;
use crate::elements::{Interpolant, Library, NodalVector};
use crate::symbolic::{Array, Graph, Id};

/// Exact mass matrix of the unit element, `int s_a s_b dxi`, rounded once; zero between vectors of
/// different interpolants.
pub fn unit_mass(variant: &Variant, library: &Library) -> Vec<Vec<f64>> {
    let vectors = variant.vectors(library);
    let entry = |a: usize, b: usize| {
        if vectors[a].of != vectors[b].of {
            return 0.0;
        }
        vectors[a].shape.product(&vectors[b].shape).integral().to_f64()
    };
    (0..vectors.len())
        .map(|a| (0..vectors.len()).map(|b| entry(a, b)).collect())
        .collect()
}

/// The mass matrix of the nodal vectors (scalars).
pub fn mass_kernel(variant: &Variant, library: &Library) -> Kernel {
    let signature = Signature {
        variant,
        library,
        references: 0,
    };
    let unit = unit_mass(variant, library);
    let mut inertia = Inertia::new(variant, library);
    let outputs = inertia.mass(&unit);
    let names: Vec<&str> = inertia.vectors.iter().map(|vector| vector.name).collect();
    let array = Array {
        name: format!("{}_MASS_MATRIX", variant.name(library).to_uppercase()),
        doc: vec![
            "Mass matrix M_ab of the unit element, the integrals of s_a s_b over xi from 0 to 1.".to_string(),
            format!(
                "Rows and columns: {}; slopes are multiplied by the length. The sum of a row's columns of positions is the \
                 first moment d_a.",
                names.join(", ")
            ),
        ],
        rows: unit,
    };
    let roots = outputs.iter().map(|&(_, id)| id);
    inertia.graph.read_from(roots, vec![array], &[]);
    signature.mass(inertia.graph, outputs)
}

/// A graph with the constants of an element.
struct Inertia<'l> {
    graph: Graph,
    length: Id,
    vectors: Vec<&'l NodalVector>,
    /// Mass of the element that moves with each interpolant, kg or kg m^2.
    masses: Vec<(Interpolant, Id)>,
}

impl<'l> Inertia<'l> {
    fn new(variant: &Variant, library: &'l Library) -> Self {
        let mut graph = Graph::new();
        let length = graph.symbol("length");
        let vectors = variant.vectors(library);
        let list = variant.declaration(library).inertia.iter();
        let masses = list.filter(|inertia| vectors.iter().any(|vector| vector.of == inertia.of));
        let masses = masses.map(|inertia| {
            let density = graph.symbol(inertia.coefficient);
            let mass = graph.multiply(density, length);
            let name = match inertia.of {
                Interpolant::Position => "element_mass",
                Interpolant::SectionY => "section_y_mass",
                Interpolant::SectionZ => "section_z_mass",
            };
            (inertia.of, graph.name(mass, name))
        });
        let masses = masses.collect();
        Self {
            vectors,
            masses,
            graph,
            length,
        }
    }

    /// Mass that moves with an interpolant; zero where none is declared.
    fn mass_of(&mut self, of: Interpolant) -> Id {
        let found = self.masses.iter().find(|(other, _)| *other == of);
        found.map_or_else(|| self.graph.zero(), |&(_, mass)| mass)
    }

    /// `l^order` of two nodal vectors times the mass of what they interpolate, one entry of the mass
    /// matrix; zero between different interpolants.
    fn entry(&mut self, unit: &[Vec<f64>], a: usize, b: usize) -> Id {
        let (left, right) = (self.vectors[a], self.vectors[b]);
        if left.of != right.of {
            return self.graph.zero();
        }
        let power = self.graph.power(self.length, (left.order + right.order) as i32);
        let mass = self.mass_of(left.of);
        let scale = self.graph.multiply(mass, power);
        let number = self.graph.number(unit[a][b]);
        let entry = self.graph.multiply(number, scale);
        let (first, second) = (a.min(b), a.max(b));
        self.graph.name(
            entry,
            format!("mass_{}_{}", self.vectors[first].name, self.vectors[second].name),
        )
    }

    fn mass(&mut self, unit: &[Vec<f64>]) -> Vec<(String, Id)> {
        let count = unit.len();
        let mut outputs = Vec::new();
        for a in 0..count {
            for b in 0..count {
                outputs.push((format!("mass[{}]", a * count + b), self.entry(unit, a, b)));
            }
        }
        outputs
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::Library;
    use crate::model::{ElementId, Evaluation, Quadrature};

    /// THEORY 5.1, the printed mass matrix at l = 1, to the last bit; its rows of positions add up to
    /// the printed first moments.
    #[test]
    fn the_mass_matrix_is_the_closed_form() {
        let variant = Variant {
            element: ElementId(0),
            dimension: 3,
            options: vec![0],
            quadrature: Quadrature::Exact,
            evaluation: Evaluation::Automatic,
            damped: false,
            curved: false,
            varying: false,
            material: None,
        };
        let closed = [
            [13.0 / 35.0, 11.0 / 210.0, 9.0 / 70.0, -13.0 / 420.0],
            [11.0 / 210.0, 1.0 / 105.0, 13.0 / 420.0, -1.0 / 140.0],
            [9.0 / 70.0, 13.0 / 420.0, 13.0 / 35.0, -11.0 / 210.0],
            [-13.0 / 420.0, -1.0 / 140.0, -11.0 / 210.0, 1.0 / 105.0],
        ];
        let mass = unit_mass(&variant, &Library::standard());
        for (row, closed) in mass.iter().zip(closed) {
            assert_eq!(row[..], closed[..]);
        }
        for (row, moment) in mass.iter().zip([0.5, 1.0 / 12.0, 0.5, -1.0 / 12.0]) {
            assert!((row[0] + row[2] - moment).abs() < 1e-16);
        }
    }
}
