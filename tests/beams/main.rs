//! Scenes of beams with cross-sections against references that were written by hand from THEORY.

mod blades;
mod buckling;
mod cantilever;
mod corners;
mod curved;
mod elements;
mod fibres;
mod motor;
mod motor_runs;
mod narrow_properties;
mod nodes;
mod numbers;
mod own_curves;
mod partial_loads;
mod roll_up;
mod runs;
mod scenes;
mod sections_along_curves;
mod statics;
mod stepped;
mod table_curves;
mod table_files;
mod thick;
mod timed_elements;
mod uneven;
