//! Relative coordinates of joints: angles and slides, of the second party in the first.

use super::algebra::{self, Vector, angle, both, dot, multiply, observed, scale, subtract, unit};
use super::builder::{Builder, Party};
use super::kinds::behind;
use crate::model::{Expr, Marker, MarkerId};

/// An angle and what moves with it.
#[derive(Clone, Debug)]
pub enum Angle {
    /// Of frames that turn in a plane or about a hinge: the second minus the first; it counts beyond
    /// 2 pi.
    Counted {
        /// First party.
        first: Turned,
        /// Second party.
        second: Turned,
    },
    /// About an axis, from 0 at t = 0, in (-pi, pi].
    Between {
        /// The axis, fixed in the first party; in a plane along its normal.
        axis: Box<Vector>,
        /// Directions fixed in the first party that are a right-handed triad with the axis.
        first: [MarkerId; 2],
        /// Fixed in the second party, the first of them at t = 0.
        second: MarkerId,
        /// Turning of both.
        turns: [Option<MarkerId>; 2],
        /// Normal of the plane that both are in.
        normal: Option<usize>,
    },
}

/// How far a frame has turned about an axis.
#[derive(Clone, Debug)]
pub enum Turned {
    /// A [`Marker::Angle`].
    Free {
        /// Which.
        marker: MarkerId,
        /// -1 where it counts about the opposite axis.
        sign: f64,
        /// Angle, rad, of the axes that it counts from: those of its parent at t = 0.
        from: Box<Expr>,
    },
    /// The inertial frame.
    Still,
    /// A prescribed frame.
    Prescribed {
        /// Its angle, rad.
        angle: Box<Expr>,
        /// Its turning.
        turn: MarkerId,
        /// The inertial axis that it turns about.
        normal: usize,
    },
}

impl Turned {
    fn value(&self) -> Expr {
        match self {
            Turned::Free { marker, sign, from } => {
                let own = signed(*sign, observed(*marker, 0, None)[0].clone());
                algebra::add((**from).clone(), own)
            }
            Turned::Still => Expr::Number(0.0),
            Turned::Prescribed { angle, .. } => (**angle).clone(),
        }
    }

    fn rate(&self) -> Expr {
        match self {
            Turned::Free { marker, sign, .. } => signed(*sign, observed(*marker, 1, None)[0].clone()),
            Turned::Still => Expr::Number(0.0),
            Turned::Prescribed { angle, .. } if !algebra::has_time(angle) => Expr::Number(0.0),
            Turned::Prescribed { turn, normal, .. } => observed(*turn, 1, None)[*normal].clone(),
        }
    }

    fn marker(&self) -> Option<(MarkerId, f64)> {
        match self {
            Turned::Free { marker, sign, .. } => Some((*marker, *sign)),
            Turned::Still | Turned::Prescribed { .. } => None,
        }
    }
}

/// The way of the second party's point from the first one's along an axis of the first party.
#[derive(Clone, Debug)]
pub struct Slide {
    axis: MarkerId,
    points: [MarkerId; 2],
    normal: Option<usize>,
}

impl Angle {
    /// Of the second party in the first about an axis, first party's axes; in a plane about its normal.
    pub fn between(markers: &mut Vec<Marker>, parties: [Party; 2], normal: Option<usize>, axis: [f64; 3]) -> Self {
        let mut joint = Builder::new(markers, parties, normal);
        let (axis, first, second) = if let Some(normal) = normal {
            let [x, y] = [0, 1].map(|at| joint.direction(0, unit(joint.axes()[at])));
            let first = [joint.fixed(0, x), joint.fixed(0, y)];
            (algebra::numbers(unit(normal)), first, joint.fixed(1, x))
        } else {
            let start = joint.direction(0, axis);
            let axis = joint.fixed(0, start);
            let axis = joint.value(axis);
            let first = [0, 1].map(|which| joint.normal_to(0, start, which));
            (axis, first, joint.normal_to(1, start, 0))
        };
        let turns = [0, 1].map(|party| joint.turn(party));
        let axis = Box::new(axis);
        Angle::Between {
            axis,
            first,
            second,
            turns,
            normal,
        }
    }

    fn sine_and_cosine([x, y]: [MarkerId; 2], second: MarkerId, normal: Option<usize>) -> [Expr; 2] {
        let other = observed(second, 0, normal);
        [y, x].map(|own| dot(&other, &observed(own, 0, normal)))
    }

    /// Its value, rad.
    pub fn value(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.value(), first.value()),
            Angle::Between {
                first, second, normal, ..
            } => {
                let [sine, cosine] = Self::sine_and_cosine(*first, *second, *normal);
                angle(sine, cosine)
            }
        }
    }

    /// Its rate, rad/s: that of the turning about the axis.
    pub fn rate(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.rate(), first.rate()),
            Angle::Between { axis, turns, .. } => {
                let [first, second] = turns.map(|turn| match turn {
                    Some(turn) => observed(turn, 1, None),
                    None => algebra::numbers([0.0; 3]),
                });
                dot(axis, &both(&second, &first, subtract))
            }
        }
    }

    /// What vanishes where the angle is f(t): the difference, or of one that is not counted the sine of
    /// it, so that the angle follows f beyond pi. The sine vanishes half a turn away, too: the start
    /// decides.
    pub fn drive(&self, f: &Expr) -> Expr {
        match self {
            Angle::Counted { .. } => subtract(self.value(), f.clone()),
            Angle::Between {
                first, second, normal, ..
            } => {
                let [sine, cosine] = Self::sine_and_cosine(*first, *second, *normal);
                behind(sine, cosine, f)
            }
        }
    }

    /// Markers of the first and of the second party in a drive.
    pub fn parties(&self) -> [Vec<MarkerId>; 2] {
        match self {
            Angle::Counted { first, second } => {
                [first, second].map(|party| party.marker().into_iter().map(|(marker, _)| marker).collect())
            }
            Angle::Between { first, second, .. } => [first.to_vec(), vec![*second]],
        }
    }

    /// Forces of a moment that acts on the second party against growing angle, and on the first
    /// party along it.
    pub fn forces(&self, moment: &Expr) -> Vec<(MarkerId, Vector)> {
        let zero = || Expr::Number(0.0);
        let against = algebra::negate(moment.clone());
        match self {
            Angle::Counted { first, second } => {
                let of = |party: &Turned, moment: &Expr| {
                    let (marker, sign) = party.marker()?;
                    Some((marker, [signed(sign, moment.clone()), zero(), zero()]))
                };
                of(first, moment).into_iter().chain(of(second, &against)).collect()
            }
            Angle::Between { axis, turns, .. } => {
                let sides = turns.iter().zip([moment, &against]);
                sides
                    .filter_map(|(turn, moment)| Some((turn.as_ref().copied()?, scale(moment, axis))))
                    .collect()
            }
        }
    }
}

fn signed(sign: f64, value: Expr) -> Expr {
    multiply(Expr::Number(sign), value)
}

impl Slide {
    /// Of two parties along an axis of the first one.
    pub fn new(markers: &mut Vec<Marker>, parties: [Party; 2], normal: Option<usize>, axis: [f64; 3]) -> Self {
        let mut joint = Builder::new(markers, parties, normal);
        let (points, start) = (joint.points(), joint.direction(0, axis));
        let axis = joint.fixed(0, start);
        Self { axis, points, normal }
    }

    /// Its value, m: `a . (P_2 - P_1)`.
    pub fn value(&self) -> Expr {
        let [first, second] = self.points.map(|point| observed(point, 0, self.normal));
        dot(&observed(self.axis, 0, self.normal), &both(&second, &first, subtract))
    }

    /// Its rate, m/s.
    pub fn rate(&self) -> Expr {
        let apart = |derivative: usize| {
            let [first, second] = self.points.map(|point| observed(point, derivative, self.normal));
            both(&second, &first, subtract)
        };
        let axis = |derivative: usize| observed(self.axis, derivative, self.normal);
        algebra::add(dot(&axis(1), &apart(0)), dot(&axis(0), &apart(1)))
    }

    /// Markers of the first and of the second party.
    pub fn parties(&self) -> [Vec<MarkerId>; 2] {
        let first = vec![self.axis, self.points[0]];
        [first, vec![self.points[1]]]
    }
}
