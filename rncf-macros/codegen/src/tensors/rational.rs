//! Exact rational numbers, large enough for the tensors of low-order elements.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// A fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i128,
    denominator: i128,
}

impl Rational {
    /// Zero.
    pub const ZERO: Rational = Rational {
        numerator: 0,
        denominator: 1,
    };
    /// One.
    pub const ONE: Rational = Rational {
        numerator: 1,
        denominator: 1,
    };

    /// `numerator / denominator`.
    ///
    /// # Panics
    /// If the denominator is zero: a defect of an element's declaration.
    pub fn new(numerator: i128, denominator: i128) -> Self {
        assert!(denominator != 0, "a fraction with denominator zero");
        let divisor = gcd(numerator.unsigned_abs(), denominator.unsigned_abs()) as i128 * denominator.signum();
        Self {
            numerator: numerator / divisor,
            denominator: denominator / divisor,
        }
    }

    /// The whole number.
    pub fn whole(value: i128) -> Self {
        Self {
            numerator: value,
            denominator: 1,
        }
    }

    /// The exact value of a moderate f64 (a dyadic fraction), `None` if it does not fit.
    pub fn from_f64(value: f64) -> Option<Self> {
        let mut scaled = value;
        for exponent in 0..100 {
            if scaled == scaled.trunc() && scaled.abs() < 9e15 {
                return Some(Self::new(scaled as i128, 1 << exponent));
            }
            scaled *= 2.0;
        }
        None
    }

    /// Numerator and denominator, in lowest terms.
    pub fn parts(self) -> (i128, i128) {
        (self.numerator, self.denominator)
    }

    /// Whether products of several such numbers have room.
    pub fn is_small(self) -> bool {
        const LARGEST: i128 = 1_000_000_000;
        self.numerator.abs() <= LARGEST && self.denominator <= LARGEST
    }

    /// Whether the value is zero.
    pub fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// The quotient.
    ///
    /// # Panics
    /// If `other` is zero.
    pub fn divide(self, other: Self) -> Self {
        self * Self::new(other.denominator, other.numerator)
    }

    /// The nearest f64, rounded once.
    ///
    /// # Panics
    /// If the fraction is too large for exact rounding: a defect of an element's declaration.
    pub fn to_f64(self) -> f64 {
        const EXACT: i128 = 1 << 53;
        if self.numerator.abs() <= EXACT && self.denominator <= EXACT {
            return self.numerator as f64 / self.denominator as f64;
        }
        // Long division to 64 significant bits, the rest as a sticky bit: one rounding at the end.
        let (mut remainder, denominator) = (self.numerator.unsigned_abs(), self.denominator.unsigned_abs());
        assert!(
            denominator < 1 << 120 && remainder < 1 << 120,
            "a tensor entry is too large to round exactly"
        );
        assert!(
            remainder / denominator < 1 << 62,
            "a tensor entry is too large to round exactly"
        );
        let mut exponent = 0;
        let mut quotient = remainder / denominator;
        remainder %= denominator;
        while quotient < 1 << 62 && (remainder != 0 || quotient == 0) {
            remainder <<= 1;
            quotient = (quotient << 1) | u128::from(remainder >= denominator);
            if remainder >= denominator {
                remainder -= denominator;
            }
            exponent -= 1;
        }
        let sticky = u64::from(remainder != 0);
        let magnitude = ((quotient as u64) | sticky) as f64 * 2f64.powi(exponent);
        if self.numerator < 0 { -magnitude } else { magnitude }
    }
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

impl Add for Rational {
    type Output = Rational;
    fn add(self, other: Rational) -> Rational {
        let divisor = gcd(self.denominator as u128, other.denominator as u128) as i128;
        Rational::new(
            self.numerator * (other.denominator / divisor) + other.numerator * (self.denominator / divisor),
            self.denominator / divisor * other.denominator,
        )
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational {
            numerator: -self.numerator,
            denominator: self.denominator,
        }
    }
}

impl Sub for Rational {
    type Output = Rational;
    fn sub(self, other: Rational) -> Rational {
        self + -other
    }
}

impl Mul for Rational {
    type Output = Rational;
    fn mul(self, other: Rational) -> Rational {
        let left = gcd(self.numerator.unsigned_abs(), other.denominator as u128) as i128;
        let right = gcd(other.numerator.unsigned_abs(), self.denominator as u128) as i128;
        Rational {
            numerator: (self.numerator / left) * (other.numerator / right),
            denominator: (self.denominator / right) * (other.denominator / left),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some((*self - *other).numerator.cmp(&0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_once() {
        assert_eq!(Rational::new(1, 3).to_f64(), 1.0 / 3.0);
        assert_eq!(Rational::new(-13, 420).to_f64(), -13.0 / 420.0);
        // 1 + 2^-53 + 2^-80 lies just above the middle between 1 and its successor.
        let middle = Rational::ONE + Rational::new(1, 1 << 53) + Rational::new(1, 1 << 80);
        assert_eq!(middle.to_f64(), 1.0 + f64::EPSILON);
        assert_eq!(Rational::from_f64(0.75), Some(Rational::new(3, 4)));
        assert_eq!(Rational::new(4, -6), Rational::new(-2, 3));
    }
}
