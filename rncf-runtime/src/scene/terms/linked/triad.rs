//! The rotation of a section that deforms: the polar one of its axes b = r_y and c = r_z,
//!
//! ```text
//! n = b x c / v,  d_y = (b + c x n) / m,  d_z = n x d_y = (c + n x b) / m,   v = |b x c|,  m = b . d_y + c . d_z
//! dphi = [b (n . dc) - c (n . db)] / v + n (d_z . db - d_y . dc) / m
//! ```
//!
//! Both axes have the same part in it, so that what acts on the rotation does not shear the section in its plane, and
//! the slope has none, which shears against it. In a plane `d_y = b / |b|`.

use std::iter::Sum;
use std::ops::Mul;

use crate::space::Vector;

/// Values of both axes, or a change of them; in a plane the second one is zero.
pub(super) type Axes = [Vector; 2];

/// The rotation of a section at a state.
pub(super) struct Triad {
    /// n, d_y and d_z.
    pub axes: [Vector; 3],
    section: Axes,
    /// v and m; in a plane `b . b` and nothing.
    sizes: [f64; 2],
    is_planar: bool,
}

const ZERO: Vector = Vector::new(0.0, 0.0, 0.0);

impl Triad {
    /// Of the axes b and c; in a plane with this normal of b alone.
    pub fn new(section: Axes, plane: Option<Vector>) -> Self {
        let [b, c] = section;
        if let Some(normal) = plane {
            let y = 1.0 / b.norm() * b;
            return Self {
                axes: [y.cross(&normal), y, normal],
                section,
                sizes: [b.dot(&b), 0.0],
                is_planar: true,
            };
        }
        let across = b.cross(&c);
        let area = across.norm();
        let n = 1.0 / area * across;
        let along = b + c.cross(&n);
        let size = along.norm();
        let y = 1.0 / size * along;
        Self {
            axes: [n, y, n.cross(&y)],
            section,
            sizes: [area, size],
            is_planar: false,
        }
    }

    /// The direction with these components in the triad.
    pub fn direction(&self, along: Vector) -> Vector {
        let [n, y, z] = self.axes;
        along[0] * n + along[1] * y + along[2] * z
    }

    /// Components of a direction in the triad.
    pub fn components(&self, direction: Vector) -> Vector {
        self.axes.map(|axis| axis.dot(&direction)).into()
    }

    /// Bending and twisting part of a rotation, without the divisors.
    fn parts(&self, [db, dc]: Axes) -> (Vector, f64) {
        let ([n, y, z], [b, c]) = (self.axes, self.section);
        if self.is_planar {
            return (ZERO, z.dot(&b.cross(&db)));
        }
        let bending = n.dot(&dc) * b - n.dot(&db) * c;
        (bending, z.dot(&db) - y.dot(&dc))
    }

    /// The small rotation dphi that a change of the axes is.
    pub fn turn(&self, change: Axes) -> Vector {
        let ([n, _, z], [v, m]) = (self.axes, self.sizes);
        let (bending, twist) = self.parts(change);
        if self.is_planar {
            return twist / v * z;
        }
        1.0 / v * bending + twist / m * n
    }

    /// Derivative of [`turn`](Self::turn) of a constant change along another one.
    pub fn second(&self, first: Axes, other: Axes) -> Vector {
        let ([n, y, z], [b, c], [v, m]) = (self.axes, self.section, self.sizes);
        let ([b1, c1], [b2, c2]) = (first, other);
        let (bending, twist) = self.parts(first);
        if self.is_planar {
            let change = z.dot(&b2.cross(&b1)) / v - 2.0 * twist * b.dot(&b2) / (v * v);
            return change * z;
        }
        let turn = self.turn(other);
        let [n2, y2, z2] = [n, y, z].map(|axis| turn.cross(&axis));
        let v2 = n.dot(&(b2.cross(&c) + b.cross(&c2)));
        let m2 = y.dot(&b2) + z.dot(&c2);
        let bent = n.dot(&c1) * b2 - n.dot(&b1) * c2 + (n2.dot(&c1) * b - n2.dot(&b1) * c);
        let twisted = z2.dot(&b1) - y2.dot(&c1);
        let bent = 1.0 / v * bent - v2 / (v * v) * bending;
        let twisted = twist / m * n2 + (twisted / m - twist * m2 / (m * m)) * n;
        bent + twisted
    }

    /// Angular velocity of the section and its first two derivatives, from those of its axes up to the third.
    pub fn spins(&self, jets: [[Vector; 4]; 2]) -> [Vector; 3] {
        let [b, c] = jets;
        if self.is_planar {
            return self.planar_spins(&b);
        }
        let [n, y, z] = self.axes;
        let mut axes = [[ZERO; 3]; 3];
        for (axis, value) in axes.iter_mut().zip([n, y, z]) {
            axis[0] = value;
        }
        let mut sizes = [[0.0; 3]; 2];
        (sizes[0][0], sizes[1][0]) = (self.sizes[0], self.sizes[1]);
        let (mut bending, mut twist, mut spins) = ([ZERO; 3], [0.0; 3], [ZERO; 3]);
        for order in 0..3 {
            if order > 0 {
                for axis in &mut axes {
                    axis[order] = product(order - 1, |i, j| spins[i].cross(&axis[j]));
                }
                let [n, y, z] = &axes;
                let area = |i: usize, j: usize| {
                    let turned = product(j, |k, l| b[k + 1].cross(&c[l]) + b[k].cross(&c[l + 1]));
                    n[i].dot(&turned)
                };
                sizes[0][order] = product(order - 1, area);
                let size = |i: usize, j: usize| y[i].dot(&b[j + 1]) + z[i].dot(&c[j + 1]);
                sizes[1][order] = product(order - 1, size);
            }
            let [n, y, z] = &axes;
            let bent = product(order, |i, j| {
                let [by_c, by_b] = [&c, &b].map(|axis| product(j, |k, l| n[k].dot(&axis[l + 1])));
                by_c * b[i] - by_b * c[i]
            });
            let twisted = product(order, |i, j| z[i].dot(&b[j + 1]) - y[i].dot(&c[j + 1]));
            let rest = bent - known(order, &sizes[0], |at| bending[at]);
            bending[order] = 1.0 / sizes[0][0] * rest;
            let rest = twisted - known(order, &sizes[1], |at| twist[at]);
            twist[order] = rest / sizes[1][0];
            spins[order] = bending[order] + product(order, |i, j| twist[j] * n[i]);
        }
        spins
    }

    fn planar_spins(&self, b: &[Vector; 4]) -> [Vector; 3] {
        let normal = self.axes[2];
        let mut rates = [0.0; 3];
        for order in 0..3 {
            let turned = product(order, |i, j| normal.dot(&b[i].cross(&b[j + 1])));
            let square = |order: usize| product(order, |i, j| b[i].dot(&b[j]));
            let known: f64 = (1..=order)
                .map(|i| BINOMIAL[order][i] * square(i) * rates[order - i])
                .sum();
            rates[order] = (turned - known) / square(0);
        }
        rates.map(|rate| rate * normal)
    }
}

const BINOMIAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 2.0, 1.0]];

/// Derivative of a product: `sum_i (order over i) term(i, order - i)`.
fn product<T: Mul<f64, Output = T> + Sum>(order: usize, term: impl Fn(usize, usize) -> T) -> T {
    (0..=order).map(|i| term(i, order - i) * BINOMIAL[order][i]).sum()
}

/// What is known of the derivative of `size * quotient = value` before that of the quotient itself.
fn known<T: Mul<f64, Output = T> + Sum>(order: usize, size: &[f64; 3], quotient: impl Fn(usize) -> T) -> T {
    (1..=order)
        .map(|i| quotient(order - i) * (BINOMIAL[order][i] * size[i]))
        .sum()
}

/// Value, velocity, acceleration and jerk of a direction that turns with these spins.
pub(super) fn turning(direction: Vector, spins: &[Vector; 3]) -> [Vector; 4] {
    let mut jet = [direction, ZERO, ZERO, ZERO];
    for order in 0..3 {
        jet[order + 1] = product(order, |i, j| spins[i].cross(&jet[j]));
    }
    jet
}

#[cfg(test)]
mod tests {
    use crate::scene::terms::linked::triad::*;

    /// Axes that move and deform, with their derivatives.
    fn moving(t: f64) -> [[Vector; 4]; 2] {
        let polynomial = |k: [[f64; 4]; 3]| -> [Vector; 4] {
            let at = |[a, b, c, d]: [f64; 4]| {
                [
                    a + t * (b + t * (c + t * d)),
                    b + t * (2.0 * c + 3.0 * t * d),
                    2.0 * c + 6.0 * t * d,
                    6.0 * d,
                ]
            };
            let parts = k.map(at);
            std::array::from_fn(|order| parts.map(|part| part[order]).into())
        };
        [
            polynomial([[0.1, 0.4, -0.2, 0.3], [1.1, 0.2, 0.5, -0.1], [0.2, -0.7, 0.1, 0.2]]),
            polynomial([[-0.3, 0.1, 0.6, 0.2], [0.15, 0.5, -0.3, 0.4], [0.9, 0.3, 0.2, -0.5]]),
        ]
    }

    fn at(t: f64, plane: Option<Vector>) -> Triad {
        let mut section = moving(t).map(|jet| jet[0]);
        if plane.is_some() {
            (section[0][2], section[1]) = (0.0, ZERO);
        }
        Triad::new(section, plane)
    }

    fn jets(t: f64, plane: Option<Vector>) -> [[Vector; 4]; 2] {
        let mut jets = moving(t);
        if plane.is_some() {
            jets[0].iter_mut().for_each(|value| value[2] = 0.0);
            jets[1] = [ZERO; 4];
        }
        jets
    }

    fn near(a: Vector, b: Vector, tolerance: f64) {
        let apart = (a - b).norm();
        assert!(apart < tolerance, "{a:?} is not {b:?}: {apart:.1e}");
    }

    const PLANES: [Option<Vector>; 2] = [None, Some(Vector::new(0.0, 0.0, 1.0))];

    /// The triad is right-handed, and the stretch in it symmetric: the definition of the polar rotation.
    #[test]
    fn is_the_polar_rotation() {
        let triad = at(0.3, None);
        let ([n, y, z], [b, c]) = (triad.axes, triad.section);
        near(y.cross(&z), n, 1e-15);
        near(Vector::new(n.dot(&b), n.dot(&c), y.dot(&c) - z.dot(&b)), ZERO, 1e-15);
        assert!(y.dot(&b) > 0.0 && z.dot(&c) > 0.0);
    }

    /// All time derivatives against differences of the ones before.
    #[test]
    fn derivatives_by_time() {
        const STEP: f64 = 1e-5;
        for plane in PLANES {
            let jet = |t: f64| {
                let triad = at(t, plane);
                let spins = triad.spins(jets(t, plane));
                (turning(triad.direction(Vector::new(0.3, -0.5, 0.8)), &spins), spins)
            };
            let (now, spins) = jet(0.3);
            let ((after, spins_after), (before, spins_before)) = (jet(0.3 + STEP), jet(0.3 - STEP));
            let change = |after, before| 0.5 / STEP * (after - before);
            for order in 0..3 {
                near(change(after[order], before[order]), now[order + 1], 1e-8);
            }
            for order in 0..2 {
                near(change(spins_after[order], spins_before[order]), spins[order + 1], 1e-8);
            }
        }
    }

    /// The small rotation and its derivative against differences.
    #[test]
    fn derivatives_by_the_axes() {
        const STEP: f64 = 1e-5;
        for plane in PLANES {
            let (first, other) = (jets(0.9, plane).map(|jet| jet[1]), jets(0.4, plane).map(|jet| jet[2]));
            let moved = |by: f64, along: Axes| {
                let section = jets(0.3, plane).map(|jet| jet[0]);
                let section = [0, 1].map(|k| section[k] + by * along[k]);
                Triad::new(section, plane)
            };
            let now = moved(0.0, first);
            let direction = |triad: &Triad| triad.direction(Vector::new(0.3, -0.5, 0.8));
            let change = |after, before| 0.5 / STEP * (after - before);
            let turned = change(direction(&moved(STEP, first)), direction(&moved(-STEP, first)));
            near(turned, now.turn(first).cross(&direction(&now)), 1e-8);
            let second = change(moved(STEP, other).turn(first), moved(-STEP, other).turn(first));
            near(second, now.second(first, other), 1e-8);
        }
    }
}
