//! The animation: one page that needs nothing but itself.

use super::{Pictures, view};
use crate::app::writing::html::escape;

/// Name of the file.
pub const NAME: &str = "animation.html";

const PAGE: &str = include_str!("animation.html");

/// The page.
pub fn page(title: &str, pictures: &Pictures) -> String {
    PAGE.replace("{title}", &escape(title))
        .replace("{style}", view::STYLE)
        .replace("{scene}", &view::part(&view::of_run(title, pictures)))
}
