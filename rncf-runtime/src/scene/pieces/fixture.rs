//! A fixture at its place.

use crate::emitted::{BodySpec, Fidelity, FixtureSpec, Parts};
use crate::error::ModelError;
use crate::scene::bodies::place::{MeshPoint, PlaceVector, element_at};

/// A fixture at its place.
pub(crate) struct Fixture {
    pub spec: FixtureSpec,
    pub point: MeshPoint,
    pub vectors: &'static [PlaceVector],
    /// Whether its section is rigid.
    pub is_rigid: bool,
    /// Vector, counted in the body, that is the normal of its section, where that stands for the slope.
    pub normal: Option<usize>,
    /// Mass of an element's vectors that the fixture adds, rows first.
    pub mass: Vec<f64>,
}

/// Most components of the vectors of a place.
pub(crate) const MOST: usize = 12;

/// The vectors of a place that a fixture acts on, in the order of its constants.
pub(crate) fn vectors_of(spec: &BodySpec) -> &'static [PlaceVector] {
    const ALL: &[PlaceVector] = &[
        PlaceVector::Position,
        PlaceVector::Slope,
        PlaceVector::SectionY,
        PlaceVector::SectionZ,
    ];
    &ALL[..1 + spec.interpolants()]
}

impl Fixture {
    /// A fixture at its place on a body.
    pub fn new(spec: FixtureSpec, point: MeshPoint, body: &BodySpec) -> Self {
        let is_rigid = makes_rigid(&spec, body);
        let own = (point.element, point.xi);
        let normal = body.normals.iter().position(|&normal| normal == own);
        let normal = normal.filter(|_| is_rigid && needs_normal(&spec, body));
        let mut fixture = Self {
            spec,
            point,
            vectors: vectors_of(body),
            is_rigid,
            normal: normal.map(|normal| body.meshed_vectors() + normal),
            mass: Vec::new(),
        };
        fixture.mass = fixture.element_mass();
        fixture
    }

    /// Masses of the vectors of the place (THEORY 5.4): mass, first and second moments. Of a rigid section all that is along
    /// its normal belongs to the normal; where it has none, it is round-off or, in a plane, as much along the section's axis.
    pub fn block(&self) -> [[f64; 4]; 4] {
        let [mass, x, y, z, xx, yy, zz, xy, xz, yz] = self.spec.constants;
        if self.is_rigid && self.normal.is_none() {
            let all = if self.vectors.len() == 3 { xx + yy } else { yy };
            return [[mass, 0.0, y, z], [0.0; 4], [y, 0.0, all, yz], [z, 0.0, yz, zz]];
        }
        [[mass, x, y, z], [x, xx, xy, xz], [y, xy, yy, yz], [z, xz, yz, zz]]
    }

    /// The vectors of the place that are interpolated, with their places among the constants, and weights of the
    /// element's vectors in them.
    pub fn weights(&self) -> impl Iterator<Item = (usize, &[f64])> {
        let vectors = self.vectors.iter().enumerate();
        let own = vectors.filter(|(place, _)| *place != 1 || self.normal.is_none());
        own.map(|(place, &of)| (place, self.point.weights(of)))
    }

    /// Masses in the rows and columns of the section's normal, where that is a vector of its own: vectors, counted in the
    /// body.
    pub fn entries_of_normal(&self, spec: &BodySpec) -> Vec<([usize; 2], f64)> {
        let Some(normal) = self.normal else {
            return Vec::new();
        };
        let row = self.block()[1];
        let mut entries = vec![([normal, normal], row[1])];
        for (place, weights) in self.weights() {
            for (local, weight) in weights.iter().enumerate() {
                let (other, value) = (
                    self.point.element * spec.stride + spec.connectivity[local],
                    row[place] * weight,
                );
                if value != 0.0 {
                    entries.extend([([normal, other], value), ([other, normal], value)]);
                }
            }
        }
        entries
    }

    /// Number of vectors of the element.
    pub fn count(&self) -> usize {
        self.point.weights(PlaceVector::Position).len()
    }

    /// Mass of an element's vectors that the fixture adds, rows first.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    pub fn element_mass(&self) -> Vec<f64> {
        let (count, block) = (self.count(), self.block());
        let mut result = vec![0.0; count * count];
        for (i, rows) in self.weights() {
            for (j, columns) in self.weights() {
                for (place, sum) in result.iter_mut().enumerate() {
                    *sum += rows[place / count] * block[i][j] * columns[place % count];
                }
            }
        }
        result
    }
}

/// Part of the second moments across the axis below which one along it is the round-off of their difference: that of a
/// lamina.
pub(crate) const LAMINA: f64 = 1e-12;

/// Whether a fixture makes its section rigid: not a mass on the axis alone, and not where modes describe the body.
pub(crate) fn makes_rigid(fixture: &FixtureSpec, body: &BodySpec) -> bool {
    let is_spread = fixture.constants[1..].iter().any(|moment| *moment != 0.0);
    body.has_section() && body.fidelity == Fidelity::Full && !fixture.elastic && is_spread
}

/// Whether a rigid fixture has moments along the normal. In a plane a second moment there is as good as one across.
pub(crate) fn needs_normal(fixture: &FixtureSpec, body: &BodySpec) -> bool {
    let [_, x, _, _, xx, yy, zz, xy, xz, _] = fixture.constants;
    let is_thick = xx.abs() > LAMINA * (yy + zz) || xy != 0.0 || xz != 0.0;
    x != 0.0 || body.dimension() == 3 && is_thick
}

/// Adds the normals that fixtures need to the vectors of their bodies.
///
/// # Errors
/// A fixture beyond the ends of its body, by name.
pub(crate) fn declare_normals(parts: &dyn Parts, specs: &mut [BodySpec]) -> Result<(), ModelError> {
    for fixture in parts.fixtures() {
        let spec = &mut specs[fixture.body];
        if makes_rigid(&fixture, spec) && needs_normal(&fixture, spec) {
            let place = element_at(spec, fixture.at, fixture.name)?;
            if !spec.normals.contains(&place) {
                spec.normals.push(place);
            }
        }
    }
    Ok(())
}
