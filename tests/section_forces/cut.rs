//! Section states of a body beside what they must be for the cut part to be in equilibrium in the deformed
//! shape: the force is the dead force at the tip, the moment that of the tip and `(r_tip - r) x F`.

use rncf::Scene;
use rncf::equilibrium::{Uniform, static_load};
use rncf::model::SectionState;
use rncf::space::Vector;

/// Place and axes (x along `r_y x r_z`) of a section in the deformed shape.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    pub position: Vector,
    pub axes: [Vector; 3],
}

/// What a body is made of, for the order of its nodal vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    PlanarCable,
    PlanarBeam,
    SpatialBeam,
}

impl Kind {
    /// Vectors of a node, vectors from one node to the next, components.
    fn counts(self) -> [usize; 3] {
        match self {
            Kind::PlanarCable => [2, 2, 2],
            Kind::PlanarBeam => [3, 4, 2],
            Kind::SpatialBeam => [4, 6, 3],
        }
    }

    /// Numbers of a body.
    pub fn size(self, elements: usize) -> usize {
        let [node, stride, dimension] = self.counts();
        (elements * stride + node) * dimension
    }
}

fn unit(u: Vector) -> Vector {
    1.0 / u.norm() * u
}

/// Sections at the start, in the middle and at the end of every element, from the body's nodal vectors.
pub fn sections(kind: Kind, elements: usize, length: f64, q: &[f64]) -> Vec<Section> {
    let [_, stride, dimension] = kind.counts();
    let at = |element: usize, vector: usize| -> Vector {
        let mut found = Vector::zeros();
        let first = (element * stride + vector) * dimension;
        found.as_mut_slice()[..dimension].copy_from_slice(&q[first..first + dimension]);
        found
    };
    let h = length / elements as f64;
    let normal = Vector::z();
    let axes = |slope: Vector, y: Vector, z: Vector| match kind {
        Kind::PlanarCable => {
            let along = unit(slope);
            [along, normal.cross(&along), normal]
        }
        Kind::PlanarBeam => [unit(y.cross(&normal)), unit(y), normal],
        Kind::SpatialBeam => {
            let (along, y) = (unit(y.cross(&z)), unit(y));
            [along, y, along.cross(&y)]
        }
    };
    let mut found = Vec::new();
    for element in 0..elements {
        let next = element + 1;
        let [r0, s0, r1, s1] = [at(element, 0), at(element, 1), at(next, 0), at(next, 1)];
        // Hermite polynomials in the middle.
        let middle = 0.5 * (r0 + r1) + h / 8.0 * (s0 - s1);
        let slope = 1.5 / h * (r1 - r0) + -0.25 * (s0 + s1);
        let inside = |place: usize| match kind {
            Kind::PlanarCable => [Vector::zeros(); 2],
            Kind::PlanarBeam => [at(element, [2, 3, 6][place]), Vector::zeros()],
            Kind::SpatialBeam => [at(element, [2, 4, 8][place]), at(element, [3, 5, 9][place])],
        };
        for (place, (position, slope)) in [(r0, s0), (middle, slope), (r1, s1)].into_iter().enumerate() {
            let [y, z] = inside(place);
            let axes = axes(slope, y, z);
            found.push(Section { position, axes });
        }
    }
    found
}

/// The static equilibrium of a scene at t = 0: section states of all bodies, and all nodal vectors.
pub fn at_rest(scene: &mut dyn Scene) -> (Vec<SectionState>, Vec<f64>) {
    let found = static_load(scene, 0.0).unwrap();
    let state = found.state().unwrap();
    let mut states = Vec::new();
    scene.uniform_section_states(&Uniform::at_rest(0.0), state, &mut states);
    (states, scene.frame_state(state).q)
}

/// Largest errors of axial force, shear, torque and moments against the equilibrium of the cut part, over
/// force and moment at the root.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    pub axial: f64,
    pub shear: f64,
    pub torque: f64,
    pub moment: f64,
}

/// Compares the states of a body with a dead force and moment at its tip.
pub fn errors(kind: Kind, sections: &[Section], states: &[SectionState], [force, moment]: [Vector; 2]) -> Errors {
    // Elements have places at their ends and in their middle, and others between them.
    let pieces = states.len() / (sections.len() / 3) - 1;
    let states = states
        .iter()
        .enumerate()
        .filter(|(index, _)| (2 * (index % (pieces + 1))).is_multiple_of(pieces));
    let states: Vec<&SectionState> = states.map(|(_, state)| state).collect();
    assert_eq!(sections.len(), states.len());
    let tip = sections.last().unwrap().position;
    let of = |section: &Section| moment + (tip - section.position).cross(&force);
    let (size, lever) = (force.norm().max(1e-300), of(&sections[0]).norm());
    let mut errors = Errors::default();
    for (section, state) in sections.iter().zip(states) {
        let [n, qy, qz] = section.axes.map(|axis| axis.dot(&force));
        let [t, my, mz] = section.axes.map(|axis| axis.dot(&of(section)));
        let larger = |error: &mut f64, found: f64, wanted: f64, size: f64| {
            *error = error.max((found - wanted).abs() / size);
        };
        larger(&mut errors.axial, state.forces[0], n, size);
        if kind != Kind::PlanarCable {
            larger(&mut errors.shear, state.forces[1], qy, size);
            larger(&mut errors.shear, state.forces[2], qz, size);
        }
        larger(&mut errors.torque, state.moments[0], t, lever);
        larger(&mut errors.moment, state.moments[1], my, lever);
        larger(&mut errors.moment, state.moments[2], mz, lever);
    }
    errors
}
