//! Limits that pictures of runs and of modes share.

/// Most bytes of all pictures in a page, before they become text that is longer by a third.
pub(super) const MOST_BYTES: u64 = 6_000_000;
/// A frame that goes farther than so many sizes of the scene is followed.
pub(super) const FAR: f64 = 3.0;
