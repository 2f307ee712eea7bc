//! Angles of a party in another one about the axes of that, all at once.

use super::algebra::{
    Vector, add, angle, both, call, cross, divide, dot, multiply, negate, number, numbers, observed, scale, subtract,
    unit,
};
use super::builder::Builder;
use crate::model::{Expr, Function, MarkerId};

/// Of `t = sqrt(2 x) (1 + x / 12 + ..)` with `x = 1 - cos t` the factors of the powers of x, `(2 n)! / (n!^2 8^n (2 n + 1))`.
const ARC: [f64; 10] = [
    1.0,
    1.0 / 12.0,
    3.0 / 160.0,
    5.0 / 896.0,
    35.0 / 18432.0,
    63.0 / 90112.0,
    231.0 / 851_968.0,
    143.0 / 1_310_720.0,
    6435.0 / 142_606_336.0,
    12155.0 / 637_534_208.0,
];

/// Part of an angle that is taken about its axis alone. That angle jumps beyond half a turn, and is seen to; a component of a rotation vector only turns back.
const JUMPING: f64 = 1e-7;

/// The angle of the first party in the second about one axis of the second, rad, from 0 at t = 0.
///
/// With the axes b fixed in the second party, and a fixed in the first and equal to them at t = 0, the three are the components along b of the rotation
/// vector that turns b into a: `t / sin t` times those of `1/2 sum b_i x a_i`, with `1 + 2 cos t = sum a_i . b_i`.
///
/// Where the first party may turn far about a free axis, as a shaft does in its bearing, the angles about the other two are those by which that axis leans:
/// components of the rotation vector that turns `b_i` into `a_i` the shortest way, whatever the turn about it.
pub struct Tilt {
    /// Which.
    pub axis: usize,
    /// Its value.
    pub value: Expr,
    /// Its derivative by small rotations of the first party against the second, inertial axes.
    pub arm: Vector,
}

impl Tilt {
    /// About the three axes, one of which may be free; in a plane about its normal.
    pub fn all(joint: &mut Builder, free: Option<usize>) -> Vec<Self> {
        let b = [0, 1, 2].map(|axis| joint.own_axis(1, axis)[0].clone());
        let a = [0, 1, 2].map(|axis| {
            let start = joint.direction(1, unit(axis));
            let own = joint.fixed(0, start);
            joint.value(own)
        });
        match (joint.normal, free) {
            (Some(normal), _) => vec![Self::about(normal, &a, &b)],
            (None, None) => Self::turning(&a, &b),
            (None, Some(free)) => (0..3)
                .map(|axis| match axis == free {
                    true => Self::about(axis, &a, &b),
                    false => Self::leaning(axis, free, &a[free], &b),
                })
                .collect(),
        }
    }

    /// Without angles, the directions of the axes, about which moments by rates alone act.
    pub fn rates_alone(joint: &mut Builder) -> Vec<Self> {
        let all = (0..3).filter(|axis| joint.normal.is_none_or(|normal| normal == *axis));
        let axes: Vec<usize> = all.collect();
        axes.into_iter()
            .map(|axis| Self {
                axis,
                value: number(0.0),
                arm: joint.own_axis(1, axis)[0].clone(),
            })
            .collect()
    }

    /// `t / sin t (b_i x a_i) . b` with the angle t between `b_i` and `a_i`.
    fn leaning(axis: usize, free: usize, a: &Vector, b: &[Vector; 3]) -> Self {
        // Of `b_i x a_i` the component along one of the other two is that of `a_i` along the third, but for the sign.
        let (other, is_next) = (3 - axis - free, axis == (free + 1) % 3);
        let sign = |value: Expr| if is_next { negate(value) } else { value };
        let along = dot(a, &b[other]);
        let [factor, slope] = arc_by_sine(dot(a, &b[free]));
        let lean = scale(&factor, &cross(a, &b[other]));
        let change = scale(&multiply(along.clone(), slope), &cross(a, &b[free]));
        Self {
            axis,
            value: sign(multiply(factor, along)),
            arm: both(&lean, &change, add).map(sign),
        }
    }

    /// Components of the rotation vector.
    fn turning(a: &[Vector; 3], b: &[Vector; 3]) -> Vec<Self> {
        let sum = (0..3).fold(number(-1.0), |sum, i| add(sum, dot(&a[i], &b[i])));
        let change = (0..3).fold(numbers([0.0; 3]), |sum, i| both(&sum, &cross(&a[i], &b[i]), add));
        let change = change.map(halved);
        let [factor, slope] = arc_by_sine(halved(sum));
        let component = |axis: usize| {
            let (sine, by_sine) = sine(axis, a, b);
            let turn = multiply(factor.clone(), sine.clone());
            let by_factor = scale(&multiply(sine, slope.clone()), &change);
            let arm = both(&scale(&factor, &by_sine), &by_factor, add);
            let about = Self::about(axis, a, b);
            let mixed =
                |own: Expr, other: Expr| add(multiply(number(1.0 - JUMPING), own), multiply(number(JUMPING), other));
            Self {
                axis,
                value: mixed(turn, about.value),
                arm: both(&arm, &about.arm, mixed),
            }
        };
        (0..3).map(component).collect()
    }

    /// The angle of the rotation about `b_i` that comes nearest to turning `b_j` and `b_k` into `a_j` and `a_k`.
    fn about(axis: usize, a: &[Vector; 3], b: &[Vector; 3]) -> Self {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let (sine, by_sine) = sine(axis, a, b);
        let cosine = halved(add(dot(&a[j], &b[j]), dot(&a[k], &b[k])));
        let by_cosine = both(&cross(&a[j], &b[j]), &cross(&a[k], &b[k]), add).map(halved);
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

/// `1/2 (a_j . b_k - a_k . b_j)`, the component of `1/2 sum b_i x a_i` along an axis of b, and its derivative by small rotations of a.
fn sine(axis: usize, a: &[Vector; 3], b: &[Vector; 3]) -> (Expr, Vector) {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let value = halved(subtract(dot(&a[j], &b[k]), dot(&a[k], &b[j])));
    let arm = both(&cross(&a[j], &b[k]), &cross(&a[k], &b[j]), subtract);
    (value, arm.map(halved))
}

fn halved(value: Expr) -> Expr {
    multiply(number(0.5), value)
}

/// `t / sin t` of an angle with this cosine, and its derivative by the cosine, smooth at t = 0: by series of a quarter of the angle, right to 1e-12 up to 140
/// degrees and to 1e-10 up to 180.
fn arc_by_sine(cosine: Expr) -> [Expr; 2] {
    let half = |cosine: &Expr| {
        let square = multiply(number(0.5), add(number(1.0), cosine.clone()));
        call(Function::Sqrt, square)
    };
    // The derivative of a halved cosine by the cosine.
    let quarter_of = |slope: Expr, halved: &Expr| divide(multiply(number(0.25), slope), halved.clone());
    let first = half(&cosine);
    let second = half(&first);
    let third = half(&second);
    let first_slope = quarter_of(number(1.0), &first);
    let second_slope = quarter_of(first_slope.clone(), &second);
    let third_slope = quarter_of(second_slope.clone(), &third);
    let x = subtract(number(1.0), second.clone());
    let horner = |factors: &[f64]| {
        let last = number(factors[factors.len() - 1]);
        let rest = factors[..factors.len() - 1].iter().rev();
        rest.fold(last, |sum, factor| add(number(*factor), multiply(x.clone(), sum)))
    };
    let rates: Vec<f64> = ARC
        .iter()
        .zip(0..)
        .skip(1)
        .map(|(factor, power)| factor * f64::from(power))
        .collect();
    let product = multiply(multiply(first.clone(), second.clone()), third.clone());
    let value = divide(horner(&ARC), product.clone());
    let lost = add(
        add(divide(first_slope, first), divide(second_slope.clone(), second)),
        divide(third_slope, third),
    );
    let slope = add(
        divide(multiply(horner(&rates), second_slope), product),
        multiply(value.clone(), lost),
    );
    [value, negate(slope)]
}
