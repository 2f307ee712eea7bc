//! Interval arithmetic: bounds of what a function takes on over a span of its argument. Bounds are not rounded outward: they are compared with margins
//! far above round-off.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All numbers between two; unbounded sides are infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Least number.
    pub low: f64,
    /// Largest number.
    pub high: f64,
}

impl Interval {
    /// Every number.
    pub const ALL: Self = Self {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
    };

    /// One number; of what is no number, every one.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Between two numbers.
    pub fn new(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::ALL;
        }
        Self { low, high }
    }

    /// Least one that contains both.
    pub fn hull(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.max(other.high))
    }

    /// What both contain; of intervals that round-off keeps apart this one.
    pub(super) fn both(self, other: Self) -> Self {
        let (low, high) = (self.low.max(other.low), self.high.min(other.high));
        if low <= high { Self { low, high } } else { self }
    }

    /// The same with a margin on both sides.
    pub fn wider(self, margin: f64) -> Self {
        Self::new(self.low - margin, self.high + margin)
    }

    /// Largest less least number.
    pub fn width(self) -> f64 {
        self.high - self.low
    }

    /// Whether all of another is in it.
    pub fn contains(self, other: Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    pub(super) fn add(self, other: Self) -> Self {
        Self::new(self.low + other.low, self.high + other.high)
    }

    pub(super) fn negate(self) -> Self {
        Self::new(-self.high, -self.low)
    }

    pub(super) fn subtract(self, other: Self) -> Self {
        self.add(other.negate())
    }

    pub(super) fn multiply(self, other: Self) -> Self {
        // What is zero makes zero of what is unbounded: bounds are not taken on.
        let product = |a: f64, b: f64| if a == 0.0 || b == 0.0 { 0.0 } else { a * b };
        let corners = [
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ];
        Self::of(corners)
    }

    pub(super) fn divide(self, other: Self) -> Self {
        if other.low <= 0.0 && other.high >= 0.0 {
            // A divisor that touches zero from one side.
            let inverse = match (other.low == 0.0, other.high == 0.0) {
                (true, false) => Self::new(1.0 / other.high, f64::INFINITY),
                (false, true) => Self::new(f64::NEG_INFINITY, 1.0 / other.low),
                _ => return Self::ALL,
            };
            return self.multiply(inverse);
        }
        self.multiply(Self::new(1.0 / other.high, 1.0 / other.low))
    }

    pub(super) fn power(self, exponent: u32) -> Self {
        let Ok(n) = i32::try_from(exponent) else {
            return Self::ALL;
        };
        let [low, high] = [self.low.powi(n), self.high.powi(n)];
        if exponent % 2 == 1 {
            return Self::new(low, high);
        }
        let least = if self.low <= 0.0 && self.high >= 0.0 {
            0.0
        } else {
            low.min(high)
        };
        Self::new(least, low.max(high))
    }

    /// Of a function that rises.
    pub(super) fn rising(self, function: impl Fn(f64) -> f64) -> Self {
        Self::new(function(self.low), function(self.high))
    }

    /// Of a function that rises from `from` to `to`, and has no value elsewhere: of what lies in its domain.
    pub(super) fn rising_within(self, from: f64, to: f64, function: impl Fn(f64) -> f64) -> Self {
        if self.high < from || self.low > to {
            return Self::ALL;
        }
        Self::new(self.low.max(from), self.high.min(to)).rising(function)
    }

    pub(super) fn abs(self) -> Self {
        let [low, high] = [self.low.abs(), self.high.abs()];
        let least = if self.low <= 0.0 && self.high >= 0.0 {
            0.0
        } else {
            low.min(high)
        };
        Self::new(least, low.max(high))
    }

    pub(super) fn cosh(self) -> Self {
        self.abs().rising(f64::cosh)
    }

    pub(super) fn sin(self) -> Self {
        if self.width().is_nan() || self.width() >= TAU {
            return Self::new(-1.0, 1.0);
        }
        let mut bounds = Self::of([self.low.sin(), self.high.sin()]);
        // Whether a place with this phase lies between.
        let passes = |phase: f64| ((self.high - phase) / TAU).floor() > ((self.low - phase) / TAU).floor();
        if passes(FRAC_PI_2) {
            bounds.high = 1.0;
        }
        if passes(-FRAC_PI_2) {
            bounds.low = -1.0;
        }
        bounds
    }

    pub(super) fn cos(self) -> Self {
        self.add(Self::point(FRAC_PI_2)).sin()
    }

    pub(super) fn tan(self) -> Self {
        let turns = |x: f64| ((x - FRAC_PI_2) / PI).floor();
        if turns(self.low) == turns(self.high) {
            self.rising(f64::tan)
        } else {
            Self::ALL
        }
    }

    pub(super) fn min(self, other: Self) -> Self {
        Self::new(self.low.min(other.low), self.high.min(other.high))
    }

    pub(super) fn max(self, other: Self) -> Self {
        Self::new(self.low.max(other.low), self.high.max(other.high))
    }

    pub(super) fn atan2(self, over: Self) -> Self {
        let is_aside = self.low > 0.0 || self.high < 0.0;
        if over.low <= 0.0 && !is_aside {
            // Near the cut all angles are possible.
            let at_points = self.width() == 0.0 && over.width() == 0.0;
            return if at_points {
                Self::point(self.low.atan2(over.low))
            } else {
                Self::new(-PI, PI)
            };
        }
        Self::of(
            [self.low, self.high]
                .into_iter()
                .flat_map(|y| [y.atan2(over.low), y.atan2(over.high)]),
        )
    }

    pub(super) fn remainder(self, by: Self) -> Self {
        if by.width() > 0.0 {
            return Self::new(0.0, by.abs().high);
        }
        let by = by.low;
        if (self.low / by).floor() == (self.high / by).floor() {
            Self::of([self.low.rem_euclid(by), self.high.rem_euclid(by)])
        } else {
            Self::new(0.0, by.abs())
        }
    }

    fn of(values: impl IntoIterator<Item = f64>) -> Self {
        values
            .into_iter()
            .map(Self::point)
            .reduce(Self::hull)
            .unwrap_or(Self::ALL)
    }
}
