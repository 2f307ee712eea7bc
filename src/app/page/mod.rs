//! What a reader sees of results: the summary, tables, charts and the report.

pub(super) mod card;
pub(super) mod cautions;
pub mod charts;
pub(super) mod compare;
pub(super) mod critical;
pub(super) mod diagrams;
pub(super) mod figure;
mod lanes;
pub(super) mod map;
pub(super) mod mass_table;
pub(super) mod report;
pub(super) mod section_table;
pub(super) mod summary;
