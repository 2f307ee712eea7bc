//! The program that reads a line.

use std::path::PathBuf;

use super::command::Command;

/// What a program says of itself: its name, what it does by default, and the choice of its models.
#[derive(Clone, Debug)]
pub(in crate::app) struct Program<'p> {
    /// The example's name, for the usage.
    pub name: &'p str,
    pub default: Command,
    /// More help at the end; empty: none.
    pub more: &'p str,
    /// Folder of the files.
    pub out: PathBuf,
}
