//! Planar pendulum (THEORY 10, T1) in its angle, with the exact multiplier of the constraint.
//!
//! `x = l cos phi, y = l sin phi`, gravity along -y. Sign convention `M a + f + C_x^T lam = 0` with `f = (0, m g)`, so
//! that `m x'' + x lam = 0` and `m y'' + m g + y lam = 0` for `C = 1/2 (x^2 + y^2 - l^2)`: positive where the rod pulls.

use crate::Result;
use crate::dense::Matrix;
use crate::system::System;

/// A point mass on a massless rod; states `(phi, phi')`.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    mass: f64,
    length: f64,
    gravity: f64,
}

/// The motion in Cartesian coordinates at one instant.
#[derive(Clone, Copy, Debug)]
pub struct Cartesian {
    /// (x, y), m.
    pub position: [f64; 2],
    /// (x', y'), m/s.
    pub velocity: [f64; 2],
    /// (x'', y''), m/s^2.
    pub acceleration: [f64; 2],
}

impl Pendulum {
    /// Pendulum of the given mass (kg), length (m) and gravity (m/s^2; 0 is allowed).
    ///
    /// # Errors
    /// If mass or length is not positive, or gravity is not finite.
    pub fn new(mass: f64, length: f64, gravity: f64) -> Result<Self> {
        for (name, value) in [("mass", mass), ("length", length)] {
            if !value.is_finite() || value <= 0.0 {
                return Err(format!("{name} of the pendulum is {value}, it must be positive"));
            }
        }
        if !gravity.is_finite() {
            return Err(format!("gravity of the pendulum is {gravity}, it must be finite"));
        }
        Ok(Self { mass, length, gravity })
    }

    /// The pendulum of THEORY 10, T1: 1 kg, 1 m, 9.81 m/s^2. T1 does not print its gravity; with 9.81 the undamped
    /// scheme's multiplier error at t = 1 s is the 213 that it does print (10 gives 218).
    pub fn published() -> Self {
        Self {
            mass: 1.0,
            length: 1.0,
            gravity: 9.81,
        }
    }

    /// States of the horizontal start at `(l, 0)` with velocity `(0, speed)`, m/s (-3 in T1).
    pub fn horizontal_start(&self, speed: f64) -> [f64; 2] {
        [0.0, speed / self.length]
    }

    /// Cartesian motion of the states `(phi, phi')`.
    pub fn cartesian(&self, y: &[f64]) -> Cartesian {
        let Self {
            length: l, gravity: g, ..
        } = *self;
        let (sin, cos) = y[0].sin_cos();
        let rate = y[1];
        let angular = -g / l * cos;
        Cartesian {
            position: [l * cos, l * sin],
            velocity: [-l * rate * sin, l * rate * cos],
            acceleration: [
                -l * (angular * sin + rate * rate * cos),
                l * (angular * cos - rate * rate * sin),
            ],
        }
    }

    /// Multiplier of `C = 1/2 (x^2 + y^2 - l^2)`, N/m.
    pub fn multiplier(&self, y: &[f64]) -> f64 {
        self.mass * (y[1] * y[1] - self.gravity / self.length * y[0].sin())
    }

    /// Multiplier of `C = x^2 + y^2 - l^2`: half of [`multiplier`](Self::multiplier), N/m.
    pub fn multiplier_of_square(&self, y: &[f64]) -> f64 {
        0.5 * self.multiplier(y)
    }

    /// Multiplier of `C = sqrt(x^2 + y^2) - l`: the rod's pull, N.
    pub fn multiplier_of_distance(&self, y: &[f64]) -> f64 {
        self.length * self.multiplier(y)
    }

    /// Total energy, J; potential zero at y = 0.
    pub fn energy(&self, y: &[f64]) -> f64 {
        let Self { mass, length, gravity } = *self;
        mass * length * (0.5 * length * y[1] * y[1] + gravity * y[0].sin())
    }
}

impl System for Pendulum {
    fn size(&self) -> usize {
        2
    }

    fn rate(&self, _t: f64, y: &[f64], rate: &mut [f64]) {
        rate[0] = y[1];
        rate[1] = -self.gravity / self.length * y[0].cos();
    }

    fn load_jacobian(&self, _t: f64, y: &[f64], jacobian: &mut Matrix) {
        jacobian.clear();
        jacobian.set(0, 1, 1.0);
        jacobian.set(1, 0, self.gravity / self.length * y[0].sin());
    }
}
