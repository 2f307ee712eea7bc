//! Free frames: their motion and what they follow.

pub(crate) mod all;
pub(crate) mod directions;
pub(crate) mod free_frames;
pub(crate) mod lean;
pub(crate) mod ties;
