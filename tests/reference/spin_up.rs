//! The prescribed rotation of the spin-up manoeuvre (THEORY 9.1, Eq. 22), differentiated by hand.

use crate::Result;
use std::f64::consts::PI;

/// Smooth run-up from rest to a constant spin.
#[derive(Clone, Copy, Debug)]
pub struct SpinUp {
    spin: f64,
    duration: f64,
}

/// Rotation about z at one time.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// Angle theta, rad.
    pub angle: f64,
    /// theta', rad/s.
    pub rate: f64,
    /// theta'', rad/s^2.
    pub acceleration: f64,
}

/// A prescribed rotation about z.
pub trait Motion: Send + Sync {
    /// Angle, rate and acceleration at time `t >= 0` (s).
    fn at(&self, t: f64) -> Rotation;
}

impl SpinUp {
    /// Run-up to `spin` (rad/s) within `duration` (s; 15 in THEORY 9.1).
    ///
    /// # Errors
    /// If `spin` is not finite or `duration` is not positive.
    pub fn new(spin: f64, duration: f64) -> Result<Self> {
        if !spin.is_finite() || !duration.is_finite() || duration <= 0.0 {
            return Err(format!(
                "spin-up needs a finite spin and a duration > 0 s, got {spin} rad/s and {duration} s"
            ));
        }
        Ok(Self { spin, duration })
    }

    /// End of the run-up, s: theta''' has a kink there, so that integrators should step onto it.
    pub fn duration(&self) -> f64 {
        self.duration
    }
}

impl Motion for SpinUp {
    fn at(&self, t: f64) -> Rotation {
        let Self { spin, duration } = *self;
        if t > duration {
            return Rotation {
                angle: spin * (t - 0.5 * duration),
                rate: spin,
                acceleration: 0.0,
            };
        }
        let (phase, unit) = (2.0 * PI * t / duration, duration / (2.0 * PI));
        Rotation {
            angle: spin / duration * (0.5 * t * t + unit * unit * (phase.cos() - 1.0)),
            rate: spin / duration * (t - unit * phase.sin()),
            acceleration: spin / duration * (1.0 - phase.cos()),
        }
    }
}
