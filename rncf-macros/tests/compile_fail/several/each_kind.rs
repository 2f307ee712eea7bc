//! One wrong model of each kind, built at once: the macro passes on all mistakes of all models.

#[path = "../drives/angle_in_space.rs"]
mod drives;
#[path = "../elements/curved_in_space.rs"]
mod elements;
#[path = "../frames/carries_nothing.rs"]
mod frames;
#[path = "../joints/between_prescribed.rs"]
mod joints;
#[path = "../motions/defined_by_itself.rs"]
mod motions;
#[path = "../names/declared_twice.rs"]
mod names;
#[path = "../planes/gravity_out_of_plane.rs"]
mod planes;
#[path = "../rigid/fixture_on_prescribed.rs"]
mod rigid;
#[path = "../sections/arc_without_normal.rs"]
mod sections;
#[path = "../springs/follower_on_frame.rs"]
mod springs;
#[path = "../syntax/incomplete_joint.rs"]
mod syntax;
#[path = "../topology/floating_body.rs"]
mod topology;
#[path = "../units/bare_angle.rs"]
mod units;

fn main() {}
