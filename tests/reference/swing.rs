//! A rotation that gathers speed and trembles, differentiated by hand; it starts at rest, and has no kink.

use crate::Result;
use crate::spin_up::{Motion, Rotation};

/// `theta = g t^2/2 + a (1 - cos(nu t))`
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    gain: f64,
    amplitude: f64,
    frequency: f64,
}

impl Swing {
    /// Mean acceleration (rad/s^2), amplitude (rad) and angular frequency (rad/s) of the trembling.
    ///
    /// # Errors
    /// If a value is not finite.
    pub fn new(gain: f64, amplitude: f64, frequency: f64) -> Result<Self> {
        if ![gain, amplitude, frequency].iter().all(|value| value.is_finite()) {
            return Err(format!(
                "a swing needs finite values, got {gain} rad/s^2, {amplitude} rad and {frequency} rad/s"
            ));
        }
        Ok(Self {
            gain,
            amplitude,
            frequency,
        })
    }
}

impl Motion for Swing {
    fn at(&self, t: f64) -> Rotation {
        let Self {
            gain,
            amplitude,
            frequency,
        } = *self;
        let (sin, cos) = (frequency * t).sin_cos();
        Rotation {
            angle: 0.5 * gain * t * t + amplitude * (1.0 - cos),
            rate: gain * t + amplitude * frequency * sin,
            acceleration: gain + amplitude * frequency * frequency * cos,
        }
    }
}
