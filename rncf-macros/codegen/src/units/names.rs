//! What dimensions are called in messages, as data.

/// What a dimension (without the angle) is called, and its SI symbol.
#[rustfmt::skip]
pub const NAMES: &[([i8; 5], &str, &str)] = &[
    ([0, 0, 0, 0, 0], "a plain number", "1"),
    ([1, 0, 0, 0, 0], "a length", "m"),
    ([0, 1, 0, 0, 0], "a mass", "kg"),
    ([0, 0, 1, 0, 0], "a time", "s"),
    ([0, 0, 0, 1, 0], "a temperature", "K"),
    ([0, 0, 0, 0, 1], "a current", "A"),
    ([2, 0, 0, 0, 0], "an area", "m^2"),
    ([3, 0, 0, 0, 0], "a volume", "m^3"),
    ([4, 0, 0, 0, 0], "a second moment of area", "m^4"),
    ([1, 0, -1, 0, 0], "a velocity", "m/s"),
    ([1, 0, -2, 0, 0], "an acceleration", "m/s^2"),
    ([0, 0, -1, 0, 0], "a frequency", "1/s"),
    ([0, 0, -2, 0, 0], "an inverse square time", "1/s^2"),
    ([-1, 0, 0, 0, 0], "a curvature", "1/m"),
    ([1, 1, -2, 0, 0], "a force", "N"),
    ([0, 1, -2, 0, 0], "a force per length", "N/m"),
    ([2, 1, -2, 0, 0], "a moment or energy", "N m"),
    ([3, 1, -2, 0, 0], "a bending stiffness", "N m^2"),
    ([-1, 1, -2, 0, 0], "a pressure", "Pa"),
    ([2, 1, -3, 0, 0], "a power", "W"),
    ([-3, 1, 0, 0, 0], "a density", "kg/m^3"),
    ([-1, 1, 0, 0, 0], "a mass per length", "kg/m"),
    ([2, 1, 0, 0, 0], "a moment of inertia", "kg m^2"),
    ([2, 1, -3, 0, -1], "a voltage", "V"),
];
