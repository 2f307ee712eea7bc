//! Generated models, integrated, against references that were written by hand from THEORY.

mod agreement;
mod closed_forms;
mod coarse_meshes;
mod dense;
mod determinism;
mod divergence;
mod energy;
mod equilibria;
mod esail;
mod free_flight;
mod free_frames;
mod gravity;
mod hanging;
mod heavy_top;
mod judged_forces;
mod judged_steps;
mod kinks;
mod looked_up;
mod machines;
mod mechanisms;
mod modal;
mod models;
mod moved_by_tables;
mod moving_loads;
mod multibody;
mod narrow_curves;
mod orbit;
mod orders;
mod peaks;
mod pendulum;
mod pictures;
// The study uses the rest.
#[allow(dead_code)]
mod random_scenes;
mod reference;
mod resumed;
mod runs;
mod sampled_scenes;
mod scales;
mod slider_crank;
mod spin_up;
mod steady;
mod step_control;
mod ties;
mod tilted_sail;
mod tumbling;
