//! Where compression makes an axis softer (THEORY 10, T15): the axial force `EA (L^2 - 1)/2 L` of the St.
//! Venant-Kirchhoff law has its minimum at the stretch `L = 1/sqrt 3`; further on it falls to nothing, and a bar
//! under a dead load collapses. The equations stay solvable, and a run alone does not tell.

use std::fmt;

use crate::emitted::{Interpolant, MAX_SIZE};
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::scene::bodies::place::weighted;
use crate::space::Vector;

/// Points of integration in [0, 1], at which strains are most accurate.
pub(super) const THREE: [f64; 3] = [0.112_701_665_379_258_31, 0.5, 0.887_298_334_620_741_7];
/// `1/sqrt 3`.
pub(super) const LEAST_STRETCH: f64 = 0.577_350_269_189_625_8;
/// Relative change of the slope for the derivative of the axial force.
const CHANGE: f64 = 1e-6;

/// A body whose axis gives way.
#[derive(Clone, Debug, PartialEq)]
struct GivesWay {
    body: String,
    /// Least stretch of its axis, and at which arclength, m.
    stretch: f64,
    x: f64,
}

impl fmt::Display for GivesWay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, stretch, x } = self;
        write!(
            f,
            "body `{body}`: its axis is compressed to {stretch:.3} of its length at x = {x:.4} m, below 1/sqrt 3 = 0.577, where the axial force of its material law grows weaker with further compression: what follows is the law's, not a material's; lower the load or give the body a greater `area` or `young`"
        )
    }
}

/// Weights of the nodal vectors in every field at a place of an element, one field after the other.
fn weights(scene: &MeshScene, (body, element): (usize, usize), of: &[(Interpolant, usize)], xi: f64) -> Vec<f64> {
    let count = scene.bodies[body].spec.nodal.len();
    let mut weights = vec![0.0; of.len() * count];
    for (&(of, order), weights) in of.iter().zip(weights.chunks_exact_mut(count)) {
        scene.parts.shapes(body, element, of, order, xi, weights);
    }
    weights
}

impl MeshScene {
    /// Those of some bodies whose axes give way at the loaded state.
    pub(crate) fn giving_way(&self, bodies: &[usize]) -> Vec<Warning> {
        let found = bodies.iter().filter_map(|&body| self.most_compressed(body));
        let warning = |found: GivesWay| Warning {
            text: found.to_string(),
            weight: 1.0 - found.stretch,
        };
        found.map(warning).collect()
    }

    /// The least stretch of a body at points of integration where it softens.
    fn most_compressed(&self, body: usize) -> Option<GivesWay> {
        let (spec, connectivity) = (&self.bodies[body].spec, &self.bodies[body].connectivity);
        let mut slope = vec![0.0; spec.nodal.len()];
        let mut worst: Option<GivesWay> = None;
        for xi in THREE {
            for element in 0..spec.count {
                if element == 0 || !spec.stations.is_empty() {
                    self.parts
                        .shapes(body, element, Interpolant::Position, 1, xi, &mut slope);
                }
                let components = connectivity.element(element);
                let stretch = Vector::from(weighted(&self.buffers.q, components, spec.dimension(), &slope)).norm();
                let limit = worst.as_ref().map_or(LEAST_STRETCH, |worst| worst.stretch);
                if stretch < limit && self.softens(body, element, xi) {
                    worst = Some(GivesWay {
                        body: spec.label(),
                        stretch,
                        x: spec.arclength(element, xi),
                    });
                }
            }
        }
        worst
    }

    /// Whether the axis is in compression and its axial force grows with shortening no more: not so in slack strings and
    /// with other laws.
    fn softens(&self, body: usize, element: usize, xi: f64) -> bool {
        let (spec, of) = (&self.bodies[body].spec, self.parts.fields(body));
        let (dimension, count) = (spec.dimension(), spec.nodal.len());
        let Some(axial) = of.iter().position(|&field| field == (Interpolant::Position, 1)) else {
            return false;
        };
        let at = [spec.arclength(element, xi), spec.line.length()];
        let weights = weights(self, (body, element), of, xi);
        let fields = |local: &[f64]| -> Vec<f64> {
            let vectors = weights.chunks_exact(count).flat_map(|weights| {
                (0..dimension).map(move |k| (0..count).map(|a| weights[a] * local[a * dimension + k]).sum())
            });
            vectors.collect()
        };
        let undeformed: Vec<f64> = (0..count).flat_map(|local| spec.undeformed(element, local)).collect();
        let mut local = [0.0; MAX_SIZE];
        self.bodies[body]
            .connectivity
            .gather(element, &self.buffers.q, &mut local);
        let (free, mut present) = (fields(&undeformed), fields(&local));
        let (rates, mut forces) = (vec![0.0; present.len()], vec![0.0; present.len()]);
        let own = axial * dimension..(axial + 1) * dimension;
        let slope = present[own.clone()].to_vec();
        let [force, further] = [0.0, CHANGE].map(|change| {
            for (value, slope) in present[own.clone()].iter_mut().zip(&slope) {
                *value = (1.0 + change) * slope;
            }
            forces.fill(0.0);
            self.parts.field_forces(body, at, &free, &present, &rates, &mut forces);
            forces[own.clone()].iter().zip(&slope).map(|(f, a)| f * a).sum::<f64>()
        });
        force < 0.0 && further < force
    }
}
