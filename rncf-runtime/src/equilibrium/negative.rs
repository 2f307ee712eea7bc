//! What is known of the directions in which the stiffness at an equilibrium is negative.

/// Negative eigenvalues of the stiffness on what constraints and phase conditions leave free.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Negative {
    /// Their number.
    Counted(usize),
    /// That their number is even, or odd: no more is known where the stiffness is large or not symmetric.
    Even,
    /// As [`Negative::Even`].
    Odd,
}

impl Negative {
    /// Whether there is one for certain.
    pub(super) fn is_any(self) -> bool {
        !matches!(self, Negative::Counted(0) | Negative::Even)
    }
}
