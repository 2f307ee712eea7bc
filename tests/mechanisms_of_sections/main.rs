//! Models with cross-section bodies, put together from all parts of the language: each in both formulations, and
//! against closed forms or another description of the same machine.

mod blades;
mod bushings;
mod campbell;
mod carried;
mod chains;
mod circulatory;
mod discs;
mod free_spin;
mod hubs;
mod ladder;
mod lateral;
mod loose;
mod many_bodies;
mod materials;
mod measures;
mod rigid_parts;
mod rotors;
mod round;
mod running;
mod shafts;
mod stiff_shear;
mod tangents;
mod turned;
mod wheels;
