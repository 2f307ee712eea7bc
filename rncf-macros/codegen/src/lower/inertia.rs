//! Inertia kernels: the virtual work of the acceleration (Eq. 5, 13) in a frame that moves in a
//! prescribed way, `R_a = M_ab (q'' + 2 w x q' + w' x q + w x (w x q))_b + d_a e`, where e is the
//! acceleration of the frame's origin minus gravity, in frame axes.

use super::kernel::Kernel;
use super::signature::Signature;
use super::variant::Variant;
use crate::elements::{Interpolant, Library, NodalVector};
use crate::symbolic::{Graph, Id, linear::Vector};

/// The inertia kernels of a variant.
#[derive(Clone, Debug)]
pub struct InertiaKernels {
    /// Mass matrix of the nodal vectors (scalars).
    pub mass: Kernel,
    /// Residual in a moving frame.
    pub referenced: Kernel,
    /// Its derivatives.
    pub referenced_tangent: Kernel,
    /// Residual in the inertial frame.
    pub absolute: Kernel,
}

/// Exact mass matrix of the unit element, `int s_a s_b dxi`, rounded once; zero between vectors of
/// different interpolants.
pub fn unit_mass(variant: &Variant, library: &Library) -> Vec<Vec<f64>> {
    let vectors = variant.vectors(library);
    let entry = |a: usize, b: usize| {
        if vectors[a].of != vectors[b].of {
            return 0.0;
        }
        (vectors[a].shape)().product(&(vectors[b].shape)()).integral().to_f64()
    };
    (0..vectors.len())
        .map(|a| (0..vectors.len()).map(|b| entry(a, b)).collect())
        .collect()
}

/// Derives the inertia kernels.
pub fn inertia_kernels(variant: &Variant, library: &Library) -> InertiaKernels {
    let signature = Signature {
        variant,
        library,
        references: 0,
    };
    let what = |text: &str| vec![text.to_string(), "Mass tensors integrated exactly.".to_string()];
    let mass = {
        let mut inertia = Inertia::new(variant, library);
        let outputs = inertia.mass();
        signature.inertia(
            "mass",
            what("Mass matrix of the nodal vectors, rows first (kg, kg m, kg m^2)."),
            inertia.graph,
            outputs,
        )
    };
    let referenced = {
        let mut inertia = Inertia::new(variant, library);
        let (residual, _) = inertia.residual(true);
        let text = "Adds the inertia forces of one element in a moving frame (Eq. 13): relative, Coriolis, Euler and \
                    centrifugal acceleration, the frame's acceleration and gravity.";
        signature.inertia("inertia_force", what(text), inertia.graph, name_force(&residual))
    };
    let referenced_tangent = {
        let mut inertia = Inertia::new(variant, library);
        let outputs = inertia.tangent();
        let text =
            "Adds the derivatives of the inertia forces with respect to q (Euler and centrifugal) and q' (gyroscopic).";
        signature.inertia("inertia_tangent", what(text), inertia.graph, outputs)
    };
    let absolute = {
        let mut inertia = Inertia::new(variant, library);
        let (residual, _) = inertia.residual(false);
        let text = "Adds the inertia forces of one element in the inertial frame; e is minus gravity.";
        signature.inertia(
            "absolute_inertia_force",
            what(text),
            inertia.graph,
            name_force(&residual),
        )
    };
    InertiaKernels {
        mass,
        referenced,
        referenced_tangent,
        absolute,
    }
}

fn name_force(residual: &[Id]) -> Vec<(String, Id)> {
    residual
        .iter()
        .enumerate()
        .map(|(place, &id)| (format!("force[{place}]"), id))
        .collect()
}

/// A graph with the mass matrix of an element.
pub(super) struct Inertia<'a> {
    variant: &'a Variant,
    library: &'a Library,
    /// The graph.
    pub graph: Graph,
    length: Id,
    vectors: Vec<&'static NodalVector>,
    /// Mass of the element that moves with each interpolant, kg or kg m^2.
    masses: Vec<(Interpolant, Id)>,
}

impl<'a> Inertia<'a> {
    /// A graph with the constants of an element.
    pub fn new(variant: &'a Variant, library: &'a Library) -> Self {
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
            variant,
            library,
            vectors,
            masses,
            graph,
            length,
        }
    }

    /// Mass that moves with an interpolant; zero where none is declared.
    pub fn mass_of(&mut self, of: Interpolant) -> Id {
        let found = self.masses.iter().find(|(other, _)| *other == of);
        found.map_or_else(|| self.graph.zero(), |&(_, mass)| mass)
    }

    /// `l^order` of two nodal vectors times the mass of what they interpolate, one entry of the mass
    /// matrix; zero between different interpolants.
    pub fn entry(&mut self, unit: &[Vec<f64>], a: usize, b: usize) -> Id {
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

    fn mass(&mut self) -> Vec<(String, Id)> {
        let unit = unit_mass(self.variant, self.library);
        let count = unit.len();
        let mut outputs = Vec::new();
        for a in 0..count {
            for b in 0..count {
                outputs.push((format!("mass[{}]", a * count + b), self.entry(&unit, a, b)));
            }
        }
        outputs
    }

    /// `d^a = int rhoA s_a dx`: first moments of the shape functions of the position, with the exact
    /// integral; the section's axes have none.
    pub fn moments(&mut self) -> Vec<Id> {
        let mass = self.mass_of(Interpolant::Position);
        let vectors = self.vectors.clone();
        let moments = vectors.iter().map(|vector| {
            if vector.of != Interpolant::Position {
                return self.graph.zero();
            }
            let power = self.graph.power(self.length, vector.order as i32);
            let scale = self.graph.multiply(mass, power);
            let number = self.graph.number((vector.shape)().integral().to_f64());
            let moment = self.graph.multiply(number, scale);
            self.graph.name(moment, format!("moment_{}", vector.name))
        });
        moments.collect()
    }

    /// Symbols of the nodal vectors' components with a prefix.
    pub fn symbols(&mut self, prefix: &str) -> Vec<Vector> {
        let names = self.variant.component_names(self.library, prefix);
        names
            .into_iter()
            .map(|list| list.into_iter().map(|name| self.graph.symbol(name)).collect())
            .collect()
    }

    /// Residual, and the symbols of q and v.
    fn residual(&mut self, moving: bool) -> (Vec<Id>, [Vec<Vector>; 2]) {
        let (positions, velocities, accelerations) = (self.symbols(""), self.symbols("v_"), self.symbols("a_"));
        let dimension = self.variant.dimension;
        let frame: Vector = ["e_x", "e_y", "e_z"][..dimension]
            .iter()
            .map(|&name| self.graph.symbol(name))
            .collect();
        let words = |graph: &mut Graph, word: &str| -> Vector {
            if dimension == 2 {
                return vec![graph.symbol(word)];
            }
            ["x", "y", "z"]
                .iter()
                .map(|axis| graph.symbol(format!("{word}_{axis}")))
                .collect()
        };
        let (spin, spin_rate) = (words(&mut self.graph, "w"), words(&mut self.graph, "dw"));
        let vectors = self.vectors.clone();
        let mut total = Vec::new();
        for (index, vector) in vectors.iter().enumerate() {
            let mut sum = accelerations[index].clone();
            if moving {
                let coriolis = cross(&mut self.graph, &spin, &velocities[index]);
                let two = self.graph.number(2.0);
                let coriolis = self.graph.scale(two, &coriolis);
                let euler = cross(&mut self.graph, &spin_rate, &positions[index]);
                let inner = cross(&mut self.graph, &spin, &positions[index]);
                let centrifugal = cross(&mut self.graph, &spin, &inner);
                for term in [coriolis, euler, centrifugal] {
                    sum = self.graph.add_vectors(&sum, &term);
                }
            }
            if vector.of == Interpolant::Position && vector.order == 0 {
                // The shape functions of positions add up to one, so that d_a e = sum_b M_ab e.
                sum = self.graph.add_vectors(&sum, &frame);
            }
            for (c, &id) in sum.iter().enumerate() {
                self.graph
                    .name(id, format!("total_{}_{}", vector.name, ["x", "y", "z"][c]));
            }
            total.push(sum);
        }
        let unit = unit_mass(self.variant, self.library);
        let mut residual = Vec::new();
        for a in 0..vectors.len() {
            let entries: Vec<Id> = (0..vectors.len()).map(|b| self.entry(&unit, a, b)).collect();
            for c in 0..dimension {
                let column: Vec<Id> = total.iter().map(|vector| vector[c]).collect();
                residual.push(self.graph.dot(&entries, &column));
            }
        }
        (residual, [positions, velocities])
    }

    fn tangent(&mut self) -> Vec<(String, Id)> {
        let (residual, [positions, velocities]) = self.residual(true);
        let size = residual.len();
        let mut outputs = Vec::new();
        for (name, symbols) in [
            ("stiffness", positions.concat()),
            ("damping_matrix", velocities.concat()),
        ] {
            for (row, &force) in residual.iter().enumerate() {
                for (column, &symbol) in symbols.iter().enumerate() {
                    let derivative = self.graph.partial(force, symbol);
                    outputs.push((format!("{name}[{}]", row * size + column), derivative));
                }
            }
        }
        outputs
    }
}

/// `w x u`: in the plane w is the component along the normal.
pub(super) fn cross(graph: &mut Graph, w: &[Id], u: &[Id]) -> Vector {
    if let [w] = w {
        let (x, y) = (graph.multiply(*w, u[0]), graph.multiply(*w, u[1]));
        return vec![graph.negate(y), x];
    }
    graph.cross(w, u)
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
