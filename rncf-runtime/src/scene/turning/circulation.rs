//! In which sense the points of a mode circulate about the axis of the spin, and what masses beside it do to it.

use crate::model::{Beside, Circulating};
use crate::space::{Vector, perpendicular};

/// Real and imaginary part of a displacement or a force, inertial axes.
type Complex = [Vector; 2];

/// What circulates about an axis, of displacements one by one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Whirling {
    /// The axis, a unit vector, and two directions across it, right-handed; `None` where nothing turns.
    axes: Option<[Vector; 3]>,
    sums: Circulating,
    /// Force and moment about a point of the axis of what moves beside it, over the square of the frequency.
    beside: [Complex; 2],
    /// Sum of the sizes of the forces.
    gross: f64,
    /// The farthest of their points.
    reach: f64,
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
    pub fn add(&mut self, displaced: &Complex, image: &Complex) {
        let Some([_, first, second]) = self.axes else { return };
        let [turning, across] = circling(displaced, image, [first, second]);
        self.sums.turning += turning;
        self.sums.across += across;
    }

    /// Adds to the energy of all motions, those across among them.
    pub fn add_whole(&mut self, energy: f64) {
        self.sums.whole += energy;
    }

    /// Adds what a mass beside the axis does to it: its product with the displacement, at a place (from a point of the axis).
    pub fn add_force(&mut self, place: Vector, image: &Complex) {
        add(&mut self.beside[0], *image);
        self.add_moment(image.map(|image| place.cross(&image)));
        self.gross += image.iter().map(Vector::norm_squared).sum::<f64>().sqrt();
        self.reach = self.reach.max(place.norm());
    }

    /// Adds a moment beside the axis, of inertia without a force.
    pub fn add_moment(&mut self, moment: Complex) {
        add(&mut self.beside[1], moment);
    }

    /// Adds to the energy of what moves beside the axis.
    pub fn add_beside(&mut self, energy: f64) {
        self.sums.beside.energy += energy;
    }

    /// The sums; `None` where nothing turns.
    pub fn sums(&self) -> Option<Circulating> {
        let [axis, first, second] = self.axes?;
        let mut beside = Beside {
            gross: self.gross * self.gross,
            ..self.sums.beside
        };
        for (felt, length) in self.beside.iter().zip([1.0, self.reach]) {
            let felt = felt.map(|part| {
                if length > 0.0 {
                    1.0 / length * part
                } else {
                    Vector::zeros()
                }
            });
            let [turning, across] = circling(&felt, &felt, [first, second]);
            beside.forward += 0.5 * (across + turning);
            beside.backward += 0.5 * (across - turning);
            beside.along += felt.iter().map(|part| part.dot(&axis).powi(2)).sum::<f64>();
        }
        Some(Circulating { beside, ..self.sums })
    }
}

fn add(sum: &mut Complex, value: Complex) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
}

/// What goes round, and all that moves across: `2 Im(u_1 conj(v_2))` and `Re(u_1 conj(v_1) + u_2 conj(v_2))`.
fn circling([re, im]: &Complex, [image_re, image_im]: &Complex, across: [Vector; 2]) -> [f64; 2] {
    let [first, second] = across;
    let turning = 2.0 * (im.dot(&first) * image_re.dot(&second) - re.dot(&first) * image_im.dot(&second));
    let parts = across.map(|way| re.dot(&way) * image_re.dot(&way) + im.dot(&way) * image_im.dot(&way));
    [turning, parts[0] + parts[1]]
}
