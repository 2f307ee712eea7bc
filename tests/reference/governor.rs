//! Stiff flyball governor (THEORY 9.7) in three coordinates: the arms' angle below the horizontal, the height of the
//! slider, and the turn of the shaft, whose angular momentum is kept.
//!
//! States: alpha (rad), s (m), alpha', s'. Rods and shaft are square, 10 mm wide.

use crate::dense::Matrix;
use crate::system::System;

/// Spin at the start, rad/s.
pub const SPIN: f64 = 2.0 * std::f64::consts::PI * 0.16;
/// States at t = 0.
pub const START: [f64; 4] = [std::f64::consts::PI / 6.0, 0.5, 0.0, 0.0];

const BALL: f64 = 5.0;
const ROD: f64 = 0.3;
const SLIDER: f64 = 3.0;
/// Of slider and shaft about the shaft's axis, kg m^2.
const HUB: f64 = 0.005 + ALONG;
/// Of a rod about its axis and, beyond that of a slender one, across it, kg m^2.
const ALONG: f64 = ROD * 2e-4 / 12.0;
const THICKNESS: f64 = ROD * 1e-4 / 12.0;
/// Distance of the pins from the axis, m. The rods are 1 m long.
const PIN: f64 = 0.05;
const GRAVITY: f64 = 9.81;
const STIFFNESS: f64 = 8e5;
const DAMPING: f64 = 4e4;
const REST: f64 = 0.5;

/// The governor with this spin at the start.
#[derive(Clone, Copy, Debug)]
pub struct Governor {
    /// Angular momentum about the shaft, kg m^2/s.
    momentum: f64,
}

impl Governor {
    /// Starts at [`START`] with the given spin, rad/s.
    pub fn new(spin: f64) -> Self {
        Self {
            momentum: inertia(START[0]) * spin,
        }
    }

    /// Spin of the shaft, rad/s.
    pub fn spin(&self, y: &[f64]) -> f64 {
        self.momentum / inertia(y[0])
    }
}

/// Inertia about the shaft's axis with the arms at `alpha`, kg m^2.
fn inertia(alpha: f64) -> f64 {
    let (sin, cos) = alpha.sin_cos();
    let ball = BALL * (PIN + cos).powi(2);
    let rod = ROD * (PIN * PIN + PIN * cos + cos * cos / 3.0) + THICKNESS * cos * cos + ALONG * sin * sin;
    HUB + 2.0 * (ball + rod)
}

/// Its derivative, kg m^2/rad.
fn inertia_slope(alpha: f64) -> f64 {
    let (sin, cos) = alpha.sin_cos();
    let ball = -2.0 * BALL * (PIN + cos) * sin;
    let rod = -ROD * (PIN * sin + 2.0 / 3.0 * cos * sin) + 2.0 * (ALONG - THICKNESS) * cos * sin;
    2.0 * (ball + rod)
}

impl System for Governor {
    fn size(&self) -> usize {
        4
    }

    fn rate(&self, _t: f64, y: &[f64], rate: &mut [f64]) {
        let &[alpha, s, alpha_rate, s_rate] = y else { return };
        let (sin, cos) = alpha.sin_cos();
        // Strut from (PIN, s) to the rod's middle (PIN + cos/2, 1 - sin/2).
        let (across, along) = (0.5 * cos, 1.0 - 0.5 * sin - s);
        let length = across.hypot(along);
        let by_alpha = -0.5 * (across * sin + along * cos) / length;
        let by_s = -along / length;
        let pull = STIFFNESS * (length - REST) + DAMPING * (by_alpha * alpha_rate + by_s * s_rate);
        let spin = self.spin(y);
        let weight = 2.0 * GRAVITY * (BALL + 0.5 * ROD) * cos;
        let turning = 2.0 * (BALL + ROD / 3.0 + THICKNESS);
        rate[0] = alpha_rate;
        rate[1] = s_rate;
        rate[2] = (weight + 0.5 * inertia_slope(alpha) * spin * spin - 2.0 * pull * by_alpha) / turning;
        rate[3] = -GRAVITY - 2.0 * pull * by_s / SLIDER;
    }

    /// By central differences; good enough for an implicit method's iteration.
    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix) {
        let (mut ahead, mut behind) = ([0.0; 4], [0.0; 4]);
        for j in 0..4 {
            let h = 1e-7;
            let mut moved = y.to_vec();
            moved[j] = y[j] + h;
            self.rate(t, &moved, &mut ahead);
            moved[j] = y[j] - h;
            self.rate(t, &moved, &mut behind);
            for i in 0..4 {
                jacobian.set(i, j, (ahead[i] - behind[i]) / (2.0 * h));
            }
        }
    }
}
