//! What an element is, whoever declares it: data for all phases behind `check`. Nothing outside its declaration names an
//! element, its strains or its stiffnesses.

mod curved;
mod element;
mod full_beam;
mod rank;
mod word;
mod written;

pub use curved::at_rest;
pub use element::{
    BETWEEN_INTERFACES, Coefficient, Density, Element, ElementOption, Energy, Field, Inertia, Interpolant, Invariants,
    LARGEST, Library, NodalVector, Place, Term, VISCOUS, axial_strain, field_invariants,
};
pub use full_beam::full_beam;
pub use rank::{Coefficients, Rules, STRETCHES, points_for};
pub use word::word;
pub use written::{Definition, Nature, When, Written, WrittenTerm};
