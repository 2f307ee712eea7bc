//! What acts between frames and bodies: constraints and forces on markers (THEORY 2.2, 6).

mod branches;
pub(crate) mod constraints;
pub(in crate::scene) mod courses;
pub(crate) mod forces;
mod jets;
mod noise;
mod pushes;
mod reach;
mod resolve;
mod triad;
mod undefined;

pub(crate) use resolve::markers;
