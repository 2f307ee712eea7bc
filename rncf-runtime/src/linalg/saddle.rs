//! Saddle-point systems `[[K, B], [C, 0]]`: by the Schur complement of a few, or as a whole where it is sparse.

use super::complement::Complement;
use super::pattern::Pattern;
use super::scalar::Scalar;
use super::singular::Singular;
use super::whole::Whole;

/// Factorization of `[[K, B], [C, 0]]` in the field `T` (`f64` or `c64`); the patterns are analysed
/// once.
///
/// K is sparse on a fixed pattern. Its leading part is regular by itself, its border (the last
/// unknowns, free frames and rigid bodies) may be full and need not make K regular: then the
/// constraints must. B (forces of the multipliers) and `C^T` (derivatives of the constraints) are
/// real and have one pattern; they are equal where unknowns are varied as they are forced.
///
/// A small border is eliminated with the multipliers, with complete pivoting. Where border and constraints are many and each
/// touches few, as of a chain of rigid bodies, the whole is factored; what that finds doubtful the other decides.
#[derive(Debug)]
pub struct Saddle<T: Scalar> {
    patterns: [Pattern; 2],
    border: usize,
    sizes: Vec<f64>,
    whole: Option<Box<Whole<T>>>,
    /// Made when it is first needed.
    complement: Option<Box<Complement<T>>>,
    /// Whether the whole holds the factors of the last values.
    is_whole: bool,
}

impl<T: Scalar> Saddle<T> {
    /// Analyses the pattern of K (n x n), whose last `border` unknowns form the border, and that of
    /// B and `C^T` (n x m).
    ///
    /// # Panics
    /// If the shapes do not fit: a defect of the caller.
    pub fn new(block: &Pattern, border: usize, constraint_transposed: &Pattern) -> Self {
        assert_eq!(block.rows(), constraint_transposed.rows(), "K and C^T have equal rows");
        assert!(border <= block.rows(), "the border is a part of K");
        let whole = Whole::new(block, border, constraint_transposed).map(Box::new);
        let mut saddle = Self {
            patterns: [block.clone(), constraint_transposed.clone()],
            border,
            sizes: Vec::new(),
            is_whole: whole.is_some(),
            whole,
            complement: None,
        };
        if !saddle.is_whole {
            saddle.complement();
        }
        saddle
    }

    /// With the sizes of the unknowns, in which a matrix may be regular that is not in other units.
    pub fn sized(mut self, sizes: &[f64]) -> Self {
        self.sizes = sizes.to_vec();
        if let Some(complement) = &mut self.complement {
            complement.set_sizes(sizes);
        }
        self
    }

    /// Whether the last values were factored as a whole.
    #[cfg(test)]
    pub(super) fn is_whole(&self) -> bool {
        self.is_whole
    }

    fn complement(&mut self) -> &mut Complement<T> {
        let [block, constraints] = &self.patterns;
        self.complement.get_or_insert_with(|| {
            let mut complement = Complement::new(block, self.border, constraints);
            complement.set_sizes(&self.sizes);
            Box::new(complement)
        })
    }

    /// Factors `[[K, C^T], [C, 0]]`: as [`Saddle::factor`] with B = `C^T`.
    ///
    /// # Errors
    /// As of [`Saddle::factor`].
    pub fn factor_symmetric(&mut self, block: &[T], constraint_transposed: &[f64]) -> Result<(), Singular> {
        self.factor(block, constraint_transposed, constraint_transposed)
    }

    /// Factors `[[K, B], [C, 0]]` by the values of K, B and `C^T` on their patterns.
    ///
    /// # Errors
    /// The unknown around which K is singular (and not fixed by constraints), or the constraint that
    /// is redundant or empty: the last one of those that are found to depend on each other.
    pub fn factor(&mut self, block: &[T], forces: &[f64], constraint_transposed: &[f64]) -> Result<(), Singular> {
        let whole = self.whole.as_mut();
        self.is_whole = whole.is_some_and(|whole| whole.factor(block, forces, constraint_transposed));
        if self.is_whole {
            return Ok(());
        }
        self.complement().factor(block, forces, constraint_transposed)
    }

    /// Solves in place: on entry the right sides of the dynamic and of the constraint rows, on
    /// return the unknowns and the multipliers.
    pub fn solve(&mut self, dynamics: &mut [T], constraints: &mut [T]) {
        match &mut self.whole {
            Some(whole) if self.is_whole => whole.solve(dynamics, constraints),
            _ => self.complement().solve(dynamics, constraints),
        }
    }
}

#[cfg(test)]
#[path = "saddle_tests.rs"]
mod tests;
