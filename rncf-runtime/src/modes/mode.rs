//! A mode of small motions.

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
