//! What generated code is written against: the trait [`Parts`] with the specifications that it returns, and what kernels
//! call. Of this crate generated code names this folder, and what a model says of itself: the trait `Model` with its types.

mod body_spec;
mod checks;
mod conditions;
mod curve;
mod distributed;
mod elements;
pub mod extremes;
mod forces;
mod frame;
mod free;
mod gauss;
mod joints;
pub mod lanes;
mod law;
mod line;
mod loads;
mod markers;
mod mass;
mod nodes;
mod observed;
mod parts;
mod points;
mod relaxed;
mod repeated;
mod section_energy;
mod section_spec;
mod spline;
mod stations;
mod table;
mod table_file;

pub use crate::course::{Courses, Operation};
pub use crate::import::{Imported, ImportedSpec};
pub use crate::space::{Matrix, Vector};
pub use crate::system::ConstraintLevel;
pub use body_spec::{BodySpec, Fidelity, FrameTie, Interpolant, NodalSpec, Place};
pub use checks::{array, array_mut, finite, inertia, non_negative, part, poisson, positive, section};
pub use conditions::{JointConditions, MarkerConstraints, WithoutJointConditions, WithoutMarkerConstraints};
pub use curve::Curve;
pub use distributed::DistributedSpec;
pub use elements::{
    Bodies, ConservingForces, TimedEnergies, WithoutBodies, WithoutConservingForces, WithoutTimedEnergies,
    elastic_force_one_by_one, elastic_tangent_one_by_one,
};
pub use forces::{
    Densities, DistributedLoads, GravityFields, Loads, MarkerForces, PlacedGravity, SectionMoments, SlopeMoments,
    WithoutDensities, WithoutDistributedLoads, WithoutGravityFields, WithoutLoads, WithoutMarkerForces,
    WithoutPlacedGravity, WithoutSectionMoments, WithoutSlopeMoments,
};
pub use frame::FrameMotion;
pub use free::{FreeSpec, Motions, RigidSpec};
pub use joints::{JointData, JointKind, JointSpec, Prescribed};
pub use lanes::{LANES, add_lane, lane};
pub use law::{Mass, SectionLaw, Stiffness};
pub use line::{Line, Twist};
pub use loads::{LoadKind, LoadSpec};
pub use markers::{ConstraintSpec, FixtureSpec, ForceSpec, MarkerSpec, When};
pub use mass::mass_along;
pub use nodes::Nodes;
pub use observed::{About, BalanceQuantity, ObservedSpec, Owner, PointQuantity};
pub use parts::Parts;
pub use points::{Blocks, Relative, Rule, Tile, Vectors, rectangle_particles, round_particles};
pub use relaxed::{StrainEnergy, resisting};
pub use repeated::{DensitySpec, Reduction, ShareSpec, StartSpec, declared, firsts, instance, reduce, repetitions};
pub use section_energy::{Section, SectionPoint};
pub use section_spec::{SectionQuantity, SectionShape, SectionSpec};
pub use stations::stations_at;
pub use table::{Between, Table};
pub use table_file::{FileColumn, TableFile, TableForm};

pub(crate) use body_spec::MAX_SIZE;
pub(crate) use gauss::{FIVE, legendre};
pub(crate) use line::PARALLEL;
pub(crate) use nodes::Held;
pub(crate) use repeated::label;
