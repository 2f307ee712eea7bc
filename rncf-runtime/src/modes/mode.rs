//! A mode of small motions.

use crate::linalg::c64;

/// A mode of small motions: `x(t) = Re(shape exp((re + i im) t))`.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Rate of growth, 1/s: positive where the equilibrium is unstable.
    pub re: f64,
    /// Angular frequency in the co-rotating axes, rad/s, not negative: one mode stands for two conjugate
    /// ones. 0 where the mode does not oscillate.
    pub im: f64,
    /// Real and imaginary parts of the unknowns (increments of orientations, co-rotating). The first of the
    /// entries that are largest relative to [`sizes`](crate::system::System::sizes) is its size times 1.
    pub shape: Vec<[f64; 2]>,
}

impl Mode {
    /// The conjugate one, which stands for the same motion.
    pub fn conjugate(&self) -> Self {
        let mut mode = self.clone();
        mode.shape.iter_mut().for_each(|value| value[1] = -value[1]);
        mode
    }
}

/// A vector relative to the sizes of the unknowns as the shape of a mode.
pub(super) fn shape(x: &[c64], sizes: &[f64]) -> Vec<[f64; 2]> {
    let parts = x.iter().zip(sizes);
    parts.map(|(value, size)| [value.re * size, value.im * size]).collect()
}

/// Part of the largest |s| below which a rate is round-off.
const NEUTRAL: f64 = 1e-9;

/// Puts modes, of which `value` tells rate of growth (1/s) and angular frequency (rad/s), into the order in which they are numbered: by frequency, and those
/// that creep back without one behind, so that damping does not renumber what vibrates.
pub fn number<M>(modes: &mut [M], value: impl Fn(&M) -> [f64; 2]) {
    let size = |[re, im]: [f64; 2]| re.hypot(im);
    let largest = modes.iter().map(|mode| size(value(mode))).fold(0.0, f64::max);
    let creeps = |[re, im]: [f64; 2]| im == 0.0 && re < -NEUTRAL * largest;
    modes.sort_by(|a, b| {
        let (a, b) = (value(a), value(b));
        let key = |of: [f64; 2]| if creeps(of) { -of[0] } else { of[1] };
        creeps(a)
            .cmp(&creeps(b))
            .then(key(a).total_cmp(&key(b)))
            .then(a[0].total_cmp(&b[0]))
    });
}
