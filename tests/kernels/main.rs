//! Compiled kernels against the expression graphs that they were written from, and the checked-in
//! expansion against the generator.

mod beams;
mod by_hand;
mod complex;
mod elements;
mod generated;
mod jacobians;
mod lanes;
mod masses;
mod materials;
mod models;
mod objectivity;
mod scenes;
mod tables;
