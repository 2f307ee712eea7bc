//! What each command does: the work, its files, and the words at the end.

pub(super) mod advise;
pub(super) mod chart;
pub(super) mod checkpoint;
pub(super) mod execute;
pub(super) mod explain;
pub(super) mod export;
pub(super) mod on_disk;
pub(super) mod parallel;
pub(super) mod plan;
pub(super) mod progress;
pub(super) mod written;
