//! What acts, as emitted.

use super::distributed::DistributedSpec;
use super::lanes::LANES;
use super::loads::LoadSpec;
use super::markers::ForceSpec;
use super::repeated::DensitySpec;
use crate::course::Courses;
use crate::space::Vector;

/// Loads.
pub trait Loads {
    /// Loads.
    fn loads(&self) -> Vec<LoadSpec>;
    /// Whether a load's components depend on time.
    fn load_varies(&self, load: usize) -> bool;
    /// Components of a load at `t`, in its frame's axes.
    fn load(&self, load: usize, t: f64) -> [f64; 3];
}

/// Of a model without loads.
pub trait WithoutLoads {}

impl<T: WithoutLoads> Loads for T {
    fn loads(&self) -> Vec<LoadSpec> {
        Vec::new()
    }
    fn load_varies(&self, _load: usize) -> bool {
        false
    }
    fn load(&self, _load: usize, _t: f64) -> [f64; 3] {
        [0.0; 3]
    }
}

/// What moments do to slopes.
pub trait SlopeMoments {
    /// Adds the generalised force of a moment (N m, body axes; planar: first component) on a slope.
    fn moment(&self, dimension: usize, slope: &[f64], moment: [f64; 3], force: &mut [f64]);
    /// Adds its derivative with respect to the slope, rows first.
    fn moment_tangent(&self, dimension: usize, slope: &[f64], moment: [f64; 3], tangent: &mut [f64]);
}

/// Of a model without moments on slopes.
pub trait WithoutSlopeMoments {}

impl<T: WithoutSlopeMoments> SlopeMoments for T {
    fn moment(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _force: &mut [f64]) {}
    fn moment_tangent(&self, _dimension: usize, _slope: &[f64], _moment: [f64; 3], _tangent: &mut [f64]) {}
}

/// What moments do to the axes of sections.
pub trait SectionMoments {
    /// Adds the generalised force of a moment (N m, body axes) on the axes r_y, r_z of a section in space
    /// (six numbers each): exact virtual work, `r_y x Q_y + r_z x Q_z = M`.
    fn section_moment(&self, axes: &[f64; 6], moment: [f64; 3], force: &mut [f64; 6]);
    /// Adds its derivative with respect to the axes, rows first.
    fn section_moment_tangent(&self, axes: &[f64; 6], moment: [f64; 3], tangent: &mut [f64; 36]);
}

/// Of a model without moments on sections.
pub trait WithoutSectionMoments {}

impl<T: WithoutSectionMoments> SectionMoments for T {
    fn section_moment(&self, _axes: &[f64; 6], _moment: [f64; 3], _force: &mut [f64; 6]) {}
    fn section_moment_tangent(&self, _axes: &[f64; 6], _moment: [f64; 3], _tangent: &mut [f64; 36]) {}
}

/// Forces on markers, and their functions.
pub trait MarkerForces {
    /// Forces on markers.
    fn forces(&self) -> Vec<ForceSpec>;
    /// Whether a force on markers was declared as a load, which equilibria apply in parts.
    fn is_load(&self, force: usize) -> bool;
    /// Forces on the markers of a force: 3 k numbers, inertial axes; positive ones act along z.
    fn marker_force(&self, force: usize, t: f64, z: &[Vector], velocity: &[Vector], out: &mut [f64]);
    /// Their derivatives with respect to z and z': 3 k x 3 k each.
    fn marker_force_tangent(
        &self,
        force: usize,
        t: f64,
        z: &[Vector],
        velocity: &[Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    );
    /// For each angle that a force reads by its sine and cosine: both, by how much the force jumps where the angle goes from pi to -pi, and its
    /// size there.
    fn marker_force_branches(&self, force: usize, t: f64, z: &[Vector], velocity: &[Vector], out: &mut [f64]);
    /// What a force does over its vectors that steps could jump over.
    fn force_course(&self, force: usize) -> Option<Courses>;
    /// Potential of a conservative force, J.
    fn marker_energy(&self, force: usize, t: f64, z: &[Vector]) -> f64;
}

/// Of a model without forces on markers.
pub trait WithoutMarkerForces {}

impl<T: WithoutMarkerForces> MarkerForces for T {
    fn forces(&self) -> Vec<ForceSpec> {
        Vec::new()
    }
    fn is_load(&self, _force: usize) -> bool {
        false
    }
    fn marker_force(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    fn marker_force_tangent(
        &self,
        _force: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    ) {
        by_value.fill(0.0);
        by_velocity.fill(0.0);
    }
    fn marker_force_branches(&self, _force: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    fn force_course(&self, _force: usize) -> Option<Courses> {
        None
    }
    fn marker_energy(&self, _force: usize, _t: f64, _z: &[Vector]) -> f64 {
        0.0
    }
}

/// Loads per length, and their functions.
pub trait Densities {
    /// Loads per length.
    fn densities(&self) -> Vec<DensitySpec>;
    /// Values that a density depends on along the whole body, from its markers' values and velocities
    /// (inertial axes); `out` has [`DensitySpec::values`] entries.
    fn density_values(&self, density: usize, t: f64, z: &[Vector], velocity: &[Vector], out: &mut [f64]);
    /// Their derivatives with respect to the markers' values: values x 3 k, rows first.
    fn density_values_gradient(&self, density: usize, t: f64, z: &[Vector], velocity: &[Vector], gradient: &mut [f64]);
    /// Adds the generalised forces of a density on the nodal vectors of four elements of its kind of body, one in
    /// each lane; values lane by lane.
    fn density_force4(
        &self,
        density: usize,
        elements: &[(usize, usize); LANES],
        values: &[[f64; LANES]],
        q: &[[f64; LANES]],
        force: &mut [[f64; LANES]],
    );
    /// Adds their derivatives with respect to q (n x n, rows first) and with respect to the values (n x values).
    #[allow(clippy::too_many_arguments)]
    fn density_tangent4(
        &self,
        density: usize,
        elements: &[(usize, usize); LANES],
        values: &[[f64; LANES]],
        q: &[[f64; LANES]],
        by_q: &mut [[f64; LANES]],
        by_values: &mut [[f64; LANES]],
    );
}

/// Of a model without loads per length.
pub trait WithoutDensities {}

impl<T: WithoutDensities> Densities for T {
    fn densities(&self) -> Vec<DensitySpec> {
        Vec::new()
    }
    fn density_values(&self, _density: usize, _t: f64, _z: &[Vector], _velocity: &[Vector], _out: &mut [f64]) {}
    fn density_values_gradient(
        &self,
        _density: usize,
        _t: f64,
        _z: &[Vector],
        _velocity: &[Vector],
        _gradient: &mut [f64],
    ) {
    }
    fn density_force4(
        &self,
        _density: usize,
        _elements: &[(usize, usize); LANES],
        _values: &[[f64; LANES]],
        _q: &[[f64; LANES]],
        _force: &mut [[f64; LANES]],
    ) {
    }
    fn density_tangent4(
        &self,
        _density: usize,
        _elements: &[(usize, usize); LANES],
        _values: &[[f64; LANES]],
        _q: &[[f64; LANES]],
        _by_q: &mut [[f64; LANES]],
        _by_values: &mut [[f64; LANES]],
    ) {
    }
}

/// Gravity fields, loads of the kind [`LoadKind::Field`](super::LoadKind::Field): functions of markers.
pub trait GravityFields {
    /// Gravity of a field load at its markers' values (inertial axes), m/s^2.
    fn field(&self, load: usize, t: f64, z: &[Vector]) -> [f64; 3];
    /// Its derivatives with respect to the markers: 3 x 3 k, rows first.
    fn field_gradient(&self, load: usize, t: f64, z: &[Vector], gradient: &mut [f64]);
}

/// Of a model without gravity fields.
pub trait WithoutGravityFields {}

impl<T: WithoutGravityFields> GravityFields for T {
    fn field(&self, _load: usize, _t: f64, _z: &[Vector]) -> [f64; 3] {
        [0.0; 3]
    }
    fn field_gradient(&self, _load: usize, _t: f64, _z: &[Vector], _gradient: &mut [f64]) {}
}

/// Loads per length that are functions of vectors of a particle.
pub trait DistributedLoads {
    /// Such loads.
    fn distributed(&self) -> Vec<DistributedSpec>;
    /// Force per length of such a load on the vectors of a particle, 3 k numbers, inertial axes, at an arclength of an axis with a
    /// length (m), from their values and velocities.
    fn distributed_force(&self, load: usize, t: f64, at: [f64; 2], z: &[Vector], velocity: &[Vector], out: &mut [f64]);
    /// Its derivatives with respect to both: 3 k x 3 k each, rows first.
    #[allow(clippy::too_many_arguments)]
    fn distributed_tangent(
        &self,
        load: usize,
        t: f64,
        at: [f64; 2],
        z: &[Vector],
        velocity: &[Vector],
        by_value: &mut [f64],
        by_velocity: &mut [f64],
    );
    /// Appends what changes its sign at each kink of such a load, at a particle.
    fn distributed_gaps(
        &self,
        load: usize,
        t: f64,
        at: [f64; 2],
        z: &[Vector],
        velocity: &[Vector],
        out: &mut Vec<f64>,
    );
    /// What such a load does along the axis and over time that points and steps could jump over, at an arclength of an axis with a length (m).
    fn distributed_course(&self, load: usize, at: [f64; 2]) -> Option<Courses>;
}

/// Of a model without such loads.
pub trait WithoutDistributedLoads {}

impl<T: WithoutDistributedLoads> DistributedLoads for T {
    fn distributed(&self) -> Vec<DistributedSpec> {
        Vec::new()
    }
    fn distributed_force(
        &self,
        _load: usize,
        _t: f64,
        _at: [f64; 2],
        _z: &[Vector],
        _velocity: &[Vector],
        _out: &mut [f64],
    ) {
    }
    fn distributed_tangent(
        &self,
        _load: usize,
        _t: f64,
        _at: [f64; 2],
        _z: &[Vector],
        _velocity: &[Vector],
        _by_value: &mut [f64],
        _by_velocity: &mut [f64],
    ) {
    }
    fn distributed_gaps(
        &self,
        _load: usize,
        _t: f64,
        _at: [f64; 2],
        _z: &[Vector],
        _velocity: &[Vector],
        _out: &mut Vec<f64>,
    ) {
    }
    fn distributed_course(&self, _load: usize, _at: [f64; 2]) -> Option<Courses> {
        None
    }
}

/// Gravity that changes from place to place.
pub trait PlacedGravity {
    /// Gravity of a load at a place, m/s^2, inertial axes.
    fn around(&self, load: usize, t: f64, place: Vector) -> [f64; 3];
    /// Its derivatives by the place, rows first.
    fn around_gradient(&self, load: usize, t: f64, place: Vector, gradient: &mut [f64; 9]);
    /// Appends what changes its sign at each kink of it, at a place.
    fn around_gaps(&self, load: usize, t: f64, place: Vector, out: &mut Vec<f64>);
    /// What it does over the place that steps could jump over.
    fn around_course(&self, load: usize) -> Option<Courses>;
}

/// Of a model whose gravity is the same everywhere.
pub trait WithoutPlacedGravity {}

impl<T: WithoutPlacedGravity> PlacedGravity for T {
    fn around(&self, _load: usize, _t: f64, _place: Vector) -> [f64; 3] {
        [0.0; 3]
    }
    fn around_gradient(&self, _load: usize, _t: f64, _place: Vector, _gradient: &mut [f64; 9]) {}
    fn around_gaps(&self, _load: usize, _t: f64, _place: Vector, _out: &mut Vec<f64>) {}
    fn around_course(&self, _load: usize) -> Option<Courses> {
        None
    }
}
