//! How numbers, units, dates and sentences are written.

pub(super) mod csv;
pub(super) mod date;
pub(super) mod entries;
pub(super) mod frequency;
pub(super) mod html;
pub(super) mod numbers;
pub(super) mod sentences;
