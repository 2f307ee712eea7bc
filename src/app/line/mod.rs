//! The command line: its words, flags and params, and scenario files.

pub(super) mod advise;
pub(super) mod arguments;
pub(super) mod chart;
pub(super) mod command;
pub(super) mod flags;
pub(super) mod goal;
pub(super) mod help;
pub(super) mod parameters;
pub(super) mod plan;
pub(super) mod program;
pub(super) mod scenario;
pub(super) mod words;
