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
    /// Whether it is not the other number, as far as both are known.
    pub fn differs(self, other: Self) -> bool {
        match (self, other) {
            (Self::Counted(one), Self::Counted(other)) => one != other,
            _ => self.is_odd() != other.is_odd(),
        }
    }

    fn is_odd(self) -> bool {
        match self {
            Self::Counted(count) => count % 2 == 1,
            Self::Even => false,
            Self::Odd => true,
        }
    }

    /// Whether there is one for certain.
    pub(super) fn is_any(self) -> bool {
        !matches!(self, Negative::Counted(0) | Negative::Even)
    }
}
