//! In which sense the points of a mode circulate about the axis of the spin.

use crate::model::Circulating;
use crate::space::{Vector, perpendicular};

/// What circulates about an axis, of displacements one by one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Whirling {
    /// Two directions across the axis, right-handed with it; `None` where nothing turns.
    across: Option<[Vector; 2]>,
    sums: Circulating,
}

impl Whirling {
    /// About an axis (a unit vector).
    pub fn about(axis: Option<Vector>) -> Self {
        Self {
            across: axis.map(|axis| {
                let first = perpendicular(axis);
                [first, axis.cross(&first)]
            }),
            ..Self::default()
        }
    }

    /// Adds a displacement, real and imaginary part, and its product with the mass.
    pub fn add(&mut self, displaced: &[Vector; 2], image: &[Vector; 2]) {
        let Some([first, second]) = self.across else { return };
        let [re, im] = displaced;
        let [image_re, image_im] = image;
        self.sums.turning += 2.0 * (im.dot(&first) * image_re.dot(&second) - re.dot(&first) * image_im.dot(&second));
        for across in [first, second] {
            self.sums.across += re.dot(&across) * image_re.dot(&across) + im.dot(&across) * image_im.dot(&across);
        }
    }

    /// Adds to the energy of all motions, those across among them.
    pub fn add_whole(&mut self, energy: f64) {
        self.sums.whole += energy;
    }

    /// The sums; `None` where nothing turns.
    pub fn sums(&self) -> Option<Circulating> {
        self.across.map(|_| self.sums)
    }
}
