//! What is asked for and what is found: plain data, with why it may be incomplete.

pub(super) mod campbell;
pub(super) mod envelopes;
pub(super) mod equilibria;
pub(super) mod error;
pub(super) mod failure;
pub(super) mod history;
pub(super) mod incomplete;
pub(super) mod modes;
pub(super) mod run;
pub(super) mod sketch;
pub(super) mod uniform;
