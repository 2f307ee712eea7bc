//! The references checked against themselves, closed forms and the published table, before anything relies on them.

mod algebra;
mod beam;
mod differences;
mod element;
mod galerkin_rotor;
mod governor;
mod heavy_top;
mod inertia;
mod pendulum;
mod quadrature;
mod rod;
mod section_beam;
mod section_modes;
mod section_statics;
mod spin_up;
mod table;
mod tensor;
