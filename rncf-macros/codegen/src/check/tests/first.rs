//! The model that first attempts change.

/// A rod that is held at one end.
pub const FIRST: &str = "model Rod {
    param length = 2 m;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section bar = circle(radius = 5 mm);
    body beam { planar xy; line from [0, 0, 0] m to [length, 0, 0]; mesh 2 * cable(bar, steel); }
    joint root = clamp(beam.start, inertial);
    output v = beam.end.y;
}";
