//! Runs in time.

pub(super) mod course;
pub(super) mod frame_state;
pub(super) mod recorder;
pub(super) mod run;
