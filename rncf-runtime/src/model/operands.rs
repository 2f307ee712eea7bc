//! What outputs are made of.

use crate::archive::{Archive, Keep};

/// Sizes of what an output is made of, in its unit: a difference of two ways has that of the ways. It is known as well as these are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Operands {
    /// Of all that stands in its expression.
    pub size: f64,
    /// Of the reactions of joints and of what sections carry alone, with the largest ones that they balance.
    pub balanced: f64,
}

impl Operands {
    /// The larger of both.
    pub fn max(self, other: Self) -> Self {
        Self {
            size: self.size.max(other.size),
            balanced: self.balanced.max(other.balanced),
        }
    }
}

impl Keep for Operands {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { size, balanced } = self;
        size.keep(archive);
        balanced.keep(archive);
    }
}
