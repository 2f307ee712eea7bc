//! The references checked against themselves, closed forms and the published table, before anything relies on them.

mod beam;
mod differences;
mod element;
mod governor;
mod heavy_top;
mod inertia;
mod pendulum;
mod quadrature;
mod spin_up;
mod table;
mod tensor;
