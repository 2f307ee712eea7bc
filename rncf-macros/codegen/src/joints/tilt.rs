//! Angles of a party in another one about the axes of that, all at once.

use super::algebra::{Vector, add, angle, both, cross, divide, dot, multiply, number, observed, scale, subtract, unit};
use super::builder::Builder;
use crate::model::{Expr, MarkerId};

/// The angle of the first party in the second about one axis of the second, rad, from 0 at t = 0.
///
/// With the axes b fixed in the second party, and a fixed in the first and equal to them at t = 0, it is the angle of the
/// rotation about `b_i` that comes nearest to turning `b_j` and `b_k` into `a_j` and `a_k`. A rotation about one axis has this
/// angle, and of small ones the three are the components of the rotation vector.
pub struct Tilt {
    /// Which.
    pub axis: usize,
    /// Its value.
    pub value: Expr,
    /// Its derivative by small rotations of the first party against the second, inertial axes.
    pub arm: Vector,
}

impl Tilt {
    /// About the three axes; in a plane about its normal.
    pub fn all(joint: &mut Builder) -> Vec<Self> {
        let b = [0, 1, 2].map(|axis| joint.own_axis(1, axis)[0].clone());
        let a = [0, 1, 2].map(|axis| {
            let start = joint.direction(1, unit(axis));
            let own = joint.fixed(0, start);
            joint.value(own)
        });
        let all = (0..3).filter(|axis| joint.normal.is_none_or(|normal| normal == *axis));
        all.map(|axis| Self::about(axis, &a, &b)).collect()
    }

    fn about(axis: usize, a: &[Vector; 3], b: &[Vector; 3]) -> Self {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let of = |first: Expr, second: Expr, sum: fn(Expr, Expr) -> Expr| multiply(number(0.5), sum(first, second));
        let sine = of(dot(&a[j], &b[k]), dot(&a[k], &b[j]), subtract);
        let cosine = of(dot(&a[j], &b[j]), dot(&a[k], &b[k]), add);
        let half = |vector: Vector| scale(&number(0.5), &vector);
        let by_sine = half(both(&cross(&a[j], &b[k]), &cross(&a[k], &b[j]), subtract));
        let by_cosine = half(both(&cross(&a[j], &b[j]), &cross(&a[k], &b[k]), add));
        let square = add(
            multiply(sine.clone(), sine.clone()),
            multiply(cosine.clone(), cosine.clone()),
        );
        let arm = both(&scale(&cosine, &by_sine), &scale(&sine, &by_cosine), subtract);
        Self {
            axis,
            value: angle(sine, cosine),
            arm: arm.map(|component| divide(component, square.clone())),
        }
    }

    /// Its rate, rad/s, of what turns as the markers do.
    pub fn rate(&self, turns: [Option<MarkerId>; 2]) -> Expr {
        let still = [const { Expr::Number(0.0) }; 3];
        let [first, second] = turns.map(|turn| turn.map_or(still.clone(), |turn| observed(turn, 1, None)));
        dot(&self.arm, &both(&first, &second, subtract))
    }
}
