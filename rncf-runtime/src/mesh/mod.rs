//! Meshed bodies: from emitted element kernels to a [`crate::System`].
//!
//! The generator emits a [`Parts`]: kernels, frames, conditions and outputs of one model. Everything
//! here is the same for all models: numbering, assembly, elimination, initial states.

mod assembly;
mod balance;
mod batches;
mod body_spec;
mod build;
mod carried;
mod checks;
mod compression;
mod conditions;
mod configuration;
mod conserving;
mod curve;
mod density;
mod density_lanes;
mod density_sums;
mod evaluate;
mod fidelity;
mod fields;
mod fixtures;
mod followed;
mod frame;
mod frames;
mod free;
mod gauss;
mod inertia;
mod inertia_tangent;
mod initial;
mod jumps;
mod law;
mod layout;
mod lean;
mod levers;
mod line;
mod linked;
mod markers;
mod modal;
mod moments;
mod neutral;
mod observed;
mod one_by_one;
mod outputs;
mod overstretch;
mod parts;
mod point_forces;
mod points;
mod relaxed;
mod repeated;
mod rigid_sections;
mod sampled;
mod sampling;
mod scene;
mod section;
mod section_energy;
mod section_spec;
mod settle;
mod shared;
mod sizes;
mod sound;
mod states;
mod steady;
mod stress;
mod symmetry;
mod system;
mod table;
mod thick;
mod ties;
mod undeformed;
mod uniform;
mod units;
mod view;
mod whirl;

pub use checks::{array, array_mut, check_params, finite, inertia, non_negative, part, poisson, positive, section};
pub use configuration::{Configuration, Curve};
pub use curve::Spline;
pub use density_sums::{add_lane, declared, lane};
pub use fidelity::DescribedBody;
pub use frame::FrameMotion;
pub use free::{FreeSpec, Motions, RigidSpec};
pub use inertia::mass_along;
pub use law::{Mass, SectionLaw, Stiffness};
pub use layout::{Layout, VectorKind};
pub use line::{Line, Twist};
pub use markers::{ConstraintSpec, FixtureSpec, ForceSpec, MarkerSpec, When};
pub use modal::{build, build_as};
pub use one_by_one::{elastic_force_one_by_one, elastic_tangent_one_by_one};
pub use parts::{
    About, BalanceQuantity, BodySpec, Fidelity, FrameTie, Interpolant, JointData, JointKind, JointSpec, LoadKind,
    LoadSpec, NodalSpec, ObservedSpec, Owner, Parts, Place, PointQuantity, Prescribed,
};
pub use points::{Blocks, Relative, Rule, Tile, Vectors, rectangle_particles, round_particles};
pub use relaxed::{StrainEnergy, resisting};
pub use repeated::{DensitySpec, LANES, Reduction, ShareSpec, StartSpec, firsts, instance, reduce, repetitions};
pub use sampling::SectionBody;
pub use scene::MeshScene;
pub use section::SectionState;
pub use section_energy::{Section, SectionPoint};
pub use section_spec::{SectionQuantity, SectionShape, SectionSpec};
pub use table::Table;

#[cfg(test)]
mod tests;
