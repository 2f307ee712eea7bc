//! What is asked of the machine: files and the clock.

pub(super) mod clock;
pub(super) mod files;
pub(super) mod journal;
