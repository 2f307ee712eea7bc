//! Forces on markers, by hand.

use crate::space::Vector;

/// What a force on markers is.
#[derive(Clone, Copy, Debug)]
pub enum Law {
    /// Between two points, by the square of their distance and their speed: stiffness, length, damping.
    Spring(f64, f64, f64),
    /// Along the second marker on the first: size.
    Along(f64),
    /// Against the velocity of one marker: damping.
    Drag(f64),
}

impl Law {
    /// Adds the forces on the markers.
    pub fn force(self, z: &[Vector], velocity: &[Vector], out: &mut [f64]) {
        match self {
            Law::Spring(k, length, c) => {
                let (d, rate) = (z[1] - z[0], velocity[1] - velocity[0]);
                let pull = k * (d.dot(&d) - length * length) * d + c * rate;
                for i in 0..3 {
                    out[i] += pull[i];
                    out[3 + i] -= pull[i];
                }
            }
            Law::Along(size) => out.iter_mut().zip(&z[1]).for_each(|(out, z)| *out += size * z),
            Law::Drag(c) => out.iter_mut().zip(&velocity[0]).for_each(|(out, v)| *out -= c * v),
        }
    }

    /// Adds their derivatives with respect to values and velocities, rows first.
    pub fn tangent(self, z: &[Vector], by_value: &mut [f64], by_velocity: &mut [f64]) {
        let width = 3 * z.len();
        match self {
            Law::Spring(k, length, c) => {
                let d = z[1] - z[0];
                let size = d.dot(&d) - length * length;
                for (m, n, sign) in [(0, 0, -1.0), (0, 1, 1.0), (1, 0, 1.0), (1, 1, -1.0)] {
                    for i in 0..3 {
                        for j in 0..3 {
                            let unit = if i == j { 1.0 } else { 0.0 };
                            let place = (3 * m + i) * width + 3 * n + j;
                            by_value[place] += sign * k * (size * unit + 2.0 * d[i] * d[j]);
                            by_velocity[place] += sign * c * unit;
                        }
                    }
                }
            }
            Law::Along(size) => (0..3).for_each(|i| by_value[i * width + 3 + i] += size),
            Law::Drag(c) => (0..3).for_each(|i| by_velocity[i * width + i] -= c),
        }
    }

    /// Potential of a spring, J.
    pub fn energy(self, z: &[Vector]) -> f64 {
        match self {
            Law::Spring(k, length, _) => {
                let d = z[1] - z[0];
                0.25 * k * (d.dot(&d) - length * length).powi(2)
            }
            Law::Along(_) | Law::Drag(_) => 0.0,
        }
    }
}
