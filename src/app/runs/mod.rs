//! Runs in time.

pub(super) mod begin;
pub(super) mod course;
pub(super) mod recorder;
pub(super) mod run;
