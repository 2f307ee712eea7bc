//! In which sense the points of a mode circulate about the axis of the spin.

use crate::space::{Vector, perpendicular};

/// Part of the kinetic energy below which what goes across the axis tells no sense of whirl: the round-off of a torsion
/// does, and what an unbalance couples to it.
const ALONG: f64 = 1e-3;

/// Sums over what moves, weighted with masses, of the circulation about an axis:
/// `sum 2 Im(u_1 conj(u_2)) / sum (|u_1|^2 + |u_2|^2)` of displacements u across it: 1 where all points go about it on
/// circles in its sense, -1 against it, 0 on straight lines.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Whirling {
    /// The axis and two directions across it, right-handed; `None` where nothing turns.
    axes: Option<[Vector; 3]>,
    turning: f64,
    size: f64,
    whole: f64,
}

impl Whirling {
    /// About an axis (a unit vector).
    pub fn about(axis: Option<Vector>) -> Self {
        Self {
            axes: axis.map(|axis| {
                let first = perpendicular(axis);
                [axis, first, axis.cross(&first)]
            }),
            ..Self::default()
        }
    }

    /// Adds a displacement, real and imaginary part, and its product with the mass.
    pub fn add(&mut self, displaced: &[Vector; 2], image: &[Vector; 2]) {
        let Some([_, first, second]) = self.axes else { return };
        let [re, im] = displaced;
        let [image_re, image_im] = image;
        self.turning += 2.0 * (im.dot(&first) * image_re.dot(&second) - re.dot(&first) * image_im.dot(&second));
        for across in [first, second] {
            self.size += re.dot(&across) * image_re.dot(&across) + im.dot(&across) * image_im.dot(&across);
        }
    }

    /// Adds to the energy of all motions, those across among them.
    pub fn add_whole(&mut self, energy: f64) {
        self.whole += energy;
    }

    /// `None` where hardly anything moves across the axis, or nothing turns.
    pub fn circulation(&self) -> Option<f64> {
        let across = self.axes.is_some() && self.size > ALONG * self.whole;
        (across && self.turning.is_finite()).then(|| (self.turning / self.size).clamp(-1.0, 1.0))
    }
}
