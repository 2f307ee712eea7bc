//! The kinds of force and constraint that there are: both lists are closed, and a new kind is a file and a row.

use super::conditions::Conditions;
use super::constraint::Constraint;
use super::dead_loads::DeadLoads;
use super::density::Densities;
use super::elastic::Elasticity;
use super::fixtures::Fixtures;
use super::force::Force;
use super::inertia::Inertia;
use super::linked::constraints::Links;
use super::linked::forces::Pushes;
use super::rigid_sections::RigidSections;
use super::ties::Ties;
use crate::scene::pieces::rows::KINDS;

/// All kinds of force, in the order in which they are added: sums have the same bits in every run.
pub(crate) const FORCES: [&dyn Force; 6] = [&Inertia, &Elasticity, &Fixtures, &DeadLoads, &Pushes, &Densities];

/// All kinds of constraint, in the order of their rows, which [`KINDS`] tells.
pub(crate) const CONSTRAINTS: [&dyn Constraint; KINDS] = [&Conditions, &Ties, &RigidSections, &Links];
