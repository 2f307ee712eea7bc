//! The two texts of a seed, as a file of Rust.

use super::copies::copy_of;
use super::grow::grow;
use super::write::{Copy, text};

/// The models `A`, the scene as it is, and `B`, its copy. They serve all draws of the seed.
pub fn texts(seed: u64) -> String {
    let tree = grow(seed, 0);
    let pair = [("A", Copy::AS_IS), ("B", copy_of(&tree))];
    pair.map(|(name, copy)| format!("rncf::model! {{\n    pub {}}}\n", text(&tree, &copy, name).source))
        .concat()
}
