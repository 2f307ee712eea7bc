//! The two texts of a seed, as a file of Rust.

use super::copies::copy_of;
use super::grow::grow;
use super::write::{Copy, text};

/// The models `A`, the scene as it is, and `B`, its copy. They serve all draws of the seed.
pub fn models(seed: u64) -> [String; 2] {
    let tree = grow(seed, 0);
    let pair = [("A", Copy::AS_IS), ("B", copy_of(&tree))];
    pair.map(|(name, copy)| format!("pub {}", text(&tree, &copy, name).source))
}

/// One or both as a file of Rust.
pub fn texts(seed: u64, has_copy: bool) -> String {
    let models = models(seed);
    let models = &models[..if has_copy { 2 } else { 1 }];
    let texts: Vec<String> = models
        .iter()
        .map(|model| format!("rncf::model! {{\n    {model}}}\n"))
        .collect();
    texts.concat()
}
