//! Vectors at places of bodies.

use crate::emitted::{BodySpec, Interpolant, Line, Parts, Place, PointQuantity};
use crate::error::ModelError;

/// A vector at a place of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaceVector {
    /// Position.
    Position,
    /// Slope dp/dx.
    Slope,
    /// Derivative of the position along the section's y axis.
    SectionY,
    /// Derivative of the position along the section's z axis.
    SectionZ,
}

impl PlaceVector {
    /// The axes of a section of a body with vectors of this dimension.
    pub fn section(dimension: usize) -> &'static [Self] {
        &[Self::SectionY, Self::SectionZ][..dimension - 1]
    }

    /// What it interpolates, and the order of its derivative by x.
    pub fn interpolates(self) -> (Interpolant, usize) {
        match self {
            Self::Position => (Interpolant::Position, 0),
            Self::Slope => (Interpolant::Position, 1),
            Self::SectionY => (Interpolant::SectionY, 0),
            Self::SectionZ => (Interpolant::SectionZ, 0),
        }
    }
}

impl From<PointQuantity> for PlaceVector {
    fn from(what: PointQuantity) -> Self {
        match what {
            PointQuantity::Position | PointQuantity::Velocity => Self::Position,
            PointQuantity::Slope => Self::Slope,
            PointQuantity::SectionY => Self::SectionY,
            PointQuantity::SectionZ => Self::SectionZ,
        }
    }
}

/// A point of a body: its element, and weights of the nodal vectors there.
#[derive(Clone, Debug)]
pub(crate) struct MeshPoint {
    pub body: usize,
    pub element: usize,
    /// Place on the element, in [0, 1].
    pub xi: f64,
    /// Of position, slope and, with a section, its axes; all of the same length, zeros where the body
    /// does not carry the vector.
    pub weights: [Vec<f64>; 4],
    /// Of a place beside the axis, what its position is made of.
    pub beside: Option<Beside>,
}

/// A place beside the axis: the point of the axis, and its distance along slope and section's axes.
#[derive(Clone, Debug)]
pub(crate) struct Beside {
    /// Weights of the element's nodal vectors in the point of the axis.
    pub axis: Vec<f64>,
    /// Distances, m.
    pub factors: [f64; 3],
}

impl MeshPoint {
    /// The place beside it that is a sum of its vectors with these factors.
    pub fn combined(&self, factors: [f64; 4]) -> Self {
        let mut point = self.clone();
        let [_, along, y, z] = factors;
        point.beside = Some(Beside {
            axis: self.weights[0].clone(),
            factors: [along, y, z],
        });
        for (place, weight) in point.weights[0].iter_mut().enumerate() {
            let parts = factors.iter().zip(&self.weights);
            *weight = parts.map(|(factor, of)| factor * of[place]).sum();
        }
        point
    }

    /// What a force on a vector of the place acts on: on positions of the axis or not, weights, and its factor there.
    /// Beside the axis it is a force on the axis and moments on the section.
    pub fn shares(&self, of: PlaceVector) -> impl Iterator<Item = (bool, &[f64], f64)> {
        let beside = self.beside.as_ref().filter(|_| of == PlaceVector::Position);
        let own = beside.map_or(self.weights(of), |beside| &beside.axis);
        let factors = beside.map_or([0.0; 3], |beside| beside.factors);
        let moments = self.weights[1..]
            .iter()
            .zip(factors)
            .filter(|(_, factor)| *factor != 0.0);
        let moments = moments.map(|(weights, factor)| (false, &weights[..], factor));
        std::iter::once((of == PlaceVector::Position, own, 1.0)).chain(moments)
    }

    /// Weights of the element's nodal vectors in a vector.
    pub fn weights(&self, of: PlaceVector) -> &[f64] {
        &self.weights[of as usize]
    }
}

/// The place of a marker on a body.
pub(crate) fn mesh_point(
    parts: &dyn Parts,
    bodies: &[BodySpec],
    body: usize,
    at: Place,
    user: &str,
) -> Result<MeshPoint, ModelError> {
    place_on(parts, &bodies[body], body, at, user)
}

/// Part of the length of an axis by which a place beyond its ends is at them.
const ROUND_OFF: f64 = 1e-12;

/// Element and weights of a place on a body.
pub(crate) fn place_on(
    parts: &dyn Parts,
    spec: &BodySpec,
    body: usize,
    at: Place,
    user: &str,
) -> Result<MeshPoint, ModelError> {
    let (element, xi) = element_at(spec, at, user)?;
    Ok(point_of(parts, spec, body, element, xi))
}

/// Element of a place on a body, and where on the element it is, in [0, 1].
///
/// # Errors
/// A place beyond the ends, by the name of its user.
pub(crate) fn element_at(spec: &BodySpec, at: Place, user: &str) -> Result<(usize, f64), ModelError> {
    let length = spec.line.length();
    if let (Line::Nodes(nodes), Place::At(x)) = (&spec.line, at) {
        // Places are numbers of interfaces.
        let node = nodes.node(x as usize).min(spec.count);
        let element = node.min(spec.count - 1);
        return Ok((element, (node - element) as f64));
    }
    Ok(match at {
        Place::Start => (0, 0.0),
        Place::End => (spec.count - 1, 1.0),
        // Three times 0.1 is more than 0.3.
        Place::At(x) if (x - x.clamp(0.0, length)).abs() <= ROUND_OFF * length => {
            spec.find((x / length).clamp(0.0, 1.0))
        }
        Place::Part(part) if (part - part.clamp(0.0, 1.0)).abs() <= ROUND_OFF => spec.find(part.clamp(0.0, 1.0)),
        Place::Part(part) => {
            return Err(ModelError::new(format!(
                "{user} is at {part} of the length of body `{}`: choose a part between 0 and 1",
                spec.label()
            )));
        }
        Place::At(x) => {
            return Err(ModelError::new(format!(
                "{user} is at {x} m of body `{}`, which is {length} m long: choose a place between 0 and its length",
                spec.label()
            )));
        }
    })
}

/// The point of an element at `xi` in [0, 1].
pub(crate) fn point_of(parts: &dyn Parts, spec: &BodySpec, body: usize, element: usize, xi: f64) -> MeshPoint {
    let vectors = [
        PlaceVector::Position,
        PlaceVector::Slope,
        PlaceVector::SectionY,
        PlaceVector::SectionZ,
    ];
    let weights = vectors.map(|vector| {
        let mut weights = vec![0.0; spec.nodal.len()];
        let (of, order) = vector.interpolates();
        if spec.interpolates(of) {
            parts.shapes(body, element, of, order, xi, &mut weights);
        }
        weights
    });
    MeshPoint {
        body,
        element,
        xi,
        weights,
        beside: None,
    }
}

/// `sum_a weight_a q_a` of an element.
pub(crate) fn weighted(full: &[f64], components: &[usize], dimension: usize, weights: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (weight, components) in weights.iter().zip(components.chunks_exact(dimension)) {
        for (sum, &component) in sum.iter_mut().zip(components) {
            *sum += weight * full[component];
        }
    }
    sum
}
