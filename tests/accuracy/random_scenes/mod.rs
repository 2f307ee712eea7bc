//! Random scenes for differential and metamorphic tests.

pub mod copies;
pub mod grow;
pub mod random;
pub mod rest;
pub mod run;
pub mod study;
pub mod texts;
pub mod tree;
pub mod write;
