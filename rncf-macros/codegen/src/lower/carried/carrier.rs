//! What moves with nodal vectors in a frame: residual, force and moment on the frame, derivatives.

use super::{FrameSymbols, fixture, turns};
use crate::elements::{Interpolant, Library};
use crate::lower::inertia::{Inertia, cross, unit_mass};
use crate::lower::kernel::{block, derivatives};
use crate::lower::variant::Variant;
use crate::symbolic::{Graph, Id, linear::Vector};

/// Moment of a vector at a place: a number in the plane.
fn moment(graph: &mut Graph, place: &[Id], vector: &[Id]) -> Vector {
    if let [x, y] = *place {
        let (left, right) = (graph.multiply(x, vector[1]), graph.multiply(y, vector[0]));
        return vec![graph.subtract(left, right)];
    }
    graph.cross(place, vector)
}

/// Something with constant mass matrix that moves with nodal vectors in a frame.
pub(super) struct Carrier {
    /// The graph.
    pub graph: Graph,
    /// m, kg.
    total: Id,
    /// d_a.
    moments: Vec<Id>,
    /// M_ab.
    mass: Vec<Vec<Id>>,
    /// Whether each nodal vector is a position, on which forces add up.
    is_place: Vec<bool>,
    /// q, q', q''.
    pub states: [Vec<Vector>; 3],
    frame: FrameSymbols,
}

impl Carrier {
    /// An element.
    pub fn element(variant: &Variant, library: &Library) -> Self {
        let mut inertia = Inertia::new(variant, library);
        let vectors = variant.vectors(library);
        let unit = unit_mass(variant, library);
        let count = unit.len();
        let mass = (0..count).map(|a| (0..count).map(|b| inertia.entry(&unit, a, b)).collect());
        let mass = mass.collect();
        let moments = inertia.moments();
        let states = ["", "v_", "a_"].map(|prefix| inertia.symbols(prefix));
        let frame = FrameSymbols::new(&mut inertia.graph, variant.dimension);
        Self {
            total: inertia.mass_of(Interpolant::Position),
            graph: inertia.graph,
            moments,
            mass,
            is_place: vectors
                .iter()
                .map(|vector| vector.of == Interpolant::Position && vector.order == 0)
                .collect(),
            states,
            frame,
        }
    }

    /// Position, slope and, with a section, its axes, with mass, first and second moments (THEORY 5.4).
    pub fn fixture(dimension: usize, vectors: usize) -> Self {
        let mut graph = Graph::new();
        let mass: Vec<Vec<Id>> = (0..vectors)
            .map(|a| (0..vectors).map(|b| graph.symbol(fixture::constant(a, b))).collect())
            .collect();
        let states = ["", "v_", "a_"].map(|prefix| {
            fixture::names(dimension, vectors, prefix)
                .chunks(dimension)
                .map(|names| names.iter().map(|name| graph.symbol(name.as_str())).collect())
                .collect()
        });
        let frame = FrameSymbols::new(&mut graph, dimension);
        Self {
            graph,
            total: mass[0][0],
            moments: mass[0].clone(),
            mass,
            is_place: (0..vectors).map(|vector| vector == 0).collect(),
            states,
            frame,
        }
    }

    /// Components of a nodal vector.
    pub fn dimension(&self) -> usize {
        self.frame.origin.len()
    }

    /// Components of all nodal vectors.
    pub fn size(&self) -> usize {
        self.is_place.len() * self.dimension()
    }

    /// Relative, Coriolis, Euler and centrifugal acceleration of every nodal vector.
    fn accelerations(&mut self, moving: bool) -> Vec<Vector> {
        let [positions, velocities, accelerations] = self.states.clone();
        if !moving {
            return accelerations;
        }
        let graph = &mut self.graph;
        let two = graph.number(2.0);
        let mut total = Vec::new();
        for ((position, velocity), acceleration) in positions.iter().zip(&velocities).zip(accelerations) {
            let relative = cross(graph, &self.frame.spin, velocity);
            let coriolis = graph.scale(two, &relative);
            let euler = cross(graph, &self.frame.spin_rate, position);
            let inner = cross(graph, &self.frame.spin, position);
            let centrifugal = cross(graph, &self.frame.spin, &inner);
            let mut sum = acceleration;
            for term in [coriolis, euler, centrifugal] {
                sum = graph.add_vectors(&sum, &term);
            }
            total.push(sum);
        }
        total
    }

    /// `sum_b weights_b vectors_b`
    fn weighted(&mut self, weights: &[Id], vectors: &[Vector]) -> Vector {
        (0..self.dimension())
            .map(|c| {
                let column: Vec<Id> = vectors.iter().map(|vector| vector[c]).collect();
                self.graph.dot(weights, &column)
            })
            .collect()
    }

    /// R_a.
    pub fn residual(&mut self, moving: bool) -> Vec<Id> {
        let accelerations = self.accelerations(moving);
        let mut rows = Vec::new();
        for a in 0..self.moments.len() {
            let weights = self.mass[a].clone();
            let sum = self.weighted(&weights, &accelerations);
            let origin = self.graph.scale(self.moments[a], &self.frame.origin);
            rows.extend(self.graph.add_vectors(&sum, &origin));
        }
        rows
    }

    /// F and T.
    pub fn force(&mut self) -> Vec<Id> {
        let accelerations = self.accelerations(true);
        let (moments, positions) = (self.moments.clone(), self.states[0].clone());
        let inertia = self.weighted(&moments, &accelerations);
        let origin = self.graph.scale(self.total, &self.frame.origin);
        let mut rows = self.graph.add_vectors(&origin, &inertia);
        let first = self.weighted(&moments, &positions);
        let mut turning = moment(&mut self.graph, &first, &self.frame.origin);
        for (b, acceleration) in accelerations.iter().enumerate() {
            let weights: Vec<Id> = self.mass.iter().map(|row| row[b]).collect();
            let place = self.weighted(&weights, &positions);
            let part = moment(&mut self.graph, &place, acceleration);
            turning = self.graph.add_vectors(&turning, &part);
        }
        rows.extend(turning);
        rows
    }

    /// R_a with the sums over b taken first, `M_ab q_b` and `M_ab q'_b`, and F and T as sums over a:
    /// the same numbers, with cheaper derivatives with respect to w.
    fn summed(&mut self) -> (Vec<Id>, Vec<Id>) {
        let [positions, velocities, accelerations] = self.states.clone();
        let zero = self.graph.zero();
        let (mut residual, mut force) = (Vec::new(), vec![zero; self.dimension()]);
        let mut turning = vec![zero; turns(self.dimension())];
        let two = self.graph.number(2.0);
        for (a, place) in positions.iter().enumerate() {
            let weights = self.mass[a].clone();
            let [position, velocity, relative] =
                [&positions, &velocities, &accelerations].map(|vectors| self.weighted(&weights, vectors));
            let graph = &mut self.graph;
            let rate = cross(graph, &self.frame.spin, &velocity);
            let inner = cross(graph, &self.frame.spin, &position);
            let terms = [
                graph.scale(self.moments[a], &self.frame.origin),
                graph.scale(two, &rate),
                cross(graph, &self.frame.spin_rate, &position),
                cross(graph, &self.frame.spin, &inner),
            ];
            let row = terms.iter().fold(relative, |sum, term| graph.add_vectors(&sum, term));
            if self.is_place[a] {
                force = graph.add_vectors(&force, &row);
            }
            let part = moment(graph, place, &row);
            turning = graph.add_vectors(&turning, &part);
            residual.extend(row);
        }
        force.extend(turning);
        (residual, force)
    }

    /// The blocks of the tangent.
    pub fn tangent(&mut self) -> Vec<(String, Id)> {
        let force = self.force();
        let (residual, summed) = self.summed();
        let [q, v, a] = self.states.clone().map(|vectors| vectors.concat());
        let [e, w, dw] = [&self.frame.origin, &self.frame.spin, &self.frame.spin_rate].map(Vec::clone);
        let graph = &mut self.graph;
        let mut outputs = derivatives(graph, &force, &[e, dw, a].concat(), "mass");
        let width = w.len() + v.len();
        outputs.extend(block(graph, &summed, &w, "damping", (width, 0)));
        outputs.extend(block(graph, &force, &v, "damping", (width, w.len())));
        outputs.extend(derivatives(graph, &residual, &w, "spin"));
        outputs.extend(derivatives(graph, &force, &q, "stiffness"));
        outputs
    }
}
