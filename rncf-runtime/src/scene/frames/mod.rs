//! Free frames: their motion, what they follow, and what bodies in modes do to them.

pub(crate) mod carried;
pub(crate) mod followed;
pub(crate) mod free_frames;
pub(crate) mod lean;
pub(crate) mod levers;
pub(crate) mod ties;
