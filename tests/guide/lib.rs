//! The models of the guide's pages, as they stand there. `build.rs` takes them out of the pages.

pub mod drawing;
pub mod entries;
pub mod labels;

/// A module for each model of a page, or for a change of it.
macro_rules! pages {
    ($($(#[$allowed:meta])? $page:ident),* $(,)?) => {
        $(
            #[allow(missing_docs)]
            $(#[$allowed])?
            pub mod $page {
                include!(concat!(env!("OUT_DIR"), "/", stringify!($page), ".rs"));
            }
        )*
    };
}

// A change may leave items of its page's model without use, of which the macro warns.
pages!(
    first_rope,
    frames,
    #[allow(deprecated)]
    flight,
    joints,
    #[allow(deprecated)]
    flexible,
    beams,
    #[allow(deprecated)]
    coil,
    blades,
    filed,
    own_element,
    imported,
    #[allow(deprecated)]
    craft,
    equilibria,
    #[allow(deprecated)]
    leaning,
    rotors,
    sail,
    trust,
    python,
);
