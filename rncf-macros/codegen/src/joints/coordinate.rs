//! Relative coordinates of joints: angles and slides, of the second party in the first.

use super::algebra::{Vector, angle, both, dot, intern, observed, subtract};
use super::builder::{Builder, Party};
use super::kinds::behind;
use crate::model::{Expr, FrameId, Marker, MarkerId};

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
    /// About an axis in space, from 0 at t = 0, in (-pi, pi].
    Spatial {
        /// The axis, fixed in the first party.
        axis: MarkerId,
        /// Directions fixed in the first party that are a right-handed triad with the axis.
        first: [MarkerId; 2],
        /// Fixed in the second party, the first of them at t = 0.
        second: MarkerId,
        /// Turning of both.
        turns: [MarkerId; 2],
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
            Turned::Free { marker, sign } => signed(*sign, observed(*marker, 0, None)[0].clone()),
            Turned::Still => Expr::Number(0.0),
            Turned::Prescribed { angle, .. } => (**angle).clone(),
        }
    }

    fn rate(&self) -> Expr {
        match self {
            Turned::Free { marker, sign } => signed(*sign, observed(*marker, 1, None)[0].clone()),
            Turned::Still => Expr::Number(0.0),
            Turned::Prescribed { angle, .. } if !super::algebra::has_time(angle) => Expr::Number(0.0),
            Turned::Prescribed { turn, normal, .. } => observed(*turn, 1, None)[*normal].clone(),
        }
    }

    fn marker(&self) -> Option<(MarkerId, f64)> {
        match self {
            Turned::Free { marker, sign } => Some((*marker, *sign)),
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
    /// Of the second party in the first about an axis.
    pub fn spatial(markers: &mut Vec<Marker>, first: FrameId, second: FrameId, axis: MarkerId) -> Self {
        let mut normal = |frame, which| {
            let marker = Marker::Normal {
                frame,
                marker: axis,
                which,
            };
            intern(markers, marker)
        };
        let (x, y, other) = (normal(first, 0), normal(first, 1), normal(second, 0));
        Angle::Spatial {
            axis,
            first: [x, y],
            second: other,
            turns: [first, second].map(|frame| intern(markers, Marker::Turn { frame })),
        }
    }

    fn sine_and_cosine(first: [MarkerId; 2], second: MarkerId) -> (Expr, Expr) {
        let [x, y, other] = [first[0], first[1], second].map(|marker| observed(marker, 0, None));
        (dot(&other, &y), dot(&other, &x))
    }

    /// Its value, rad.
    pub fn value(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.value(), first.value()),
            Angle::Spatial { first, second, .. } => {
                let (sine, cosine) = Self::sine_and_cosine(*first, *second);
                angle(sine, cosine)
            }
        }
    }

    /// Its rate, rad/s; in space that of the turning about the axis.
    pub fn rate(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.rate(), first.rate()),
            Angle::Spatial { axis, turns, .. } => {
                let [first, second] = turns.map(|turn| observed(turn, 1, None));
                dot(&observed(*axis, 0, None), &both(&second, &first, subtract))
            }
        }
    }

    /// What vanishes where the angle is f(t): the difference, or in space the sine of it, so that
    /// the angle follows f beyond pi. The sine vanishes half a turn away, too: the start decides.
    pub fn drive(&self, f: &Expr) -> Expr {
        match self {
            Angle::Counted { .. } => subtract(self.value(), f.clone()),
            Angle::Spatial { first, second, .. } => {
                let (sine, cosine) = Self::sine_and_cosine(*first, *second);
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
            Angle::Spatial { first, second, .. } => [first.to_vec(), vec![*second]],
        }
    }

    /// Forces of a moment that acts on the second party against growing angle, and on the first
    /// party along it.
    pub fn forces(&self, moment: &Expr) -> Vec<(MarkerId, Vector)> {
        let zero = || Expr::Number(0.0);
        let against = super::algebra::negate(moment.clone());
        match self {
            Angle::Counted { first, second } => {
                let of = |party: &Turned, moment: &Expr| {
                    let (marker, sign) = party.marker()?;
                    Some((marker, [signed(sign, moment.clone()), zero(), zero()]))
                };
                of(first, moment).into_iter().chain(of(second, &against)).collect()
            }
            Angle::Spatial { axis, turns, .. } => {
                let axis = observed(*axis, 0, None);
                let scale = super::algebra::scale;
                vec![(turns[0], scale(moment, &axis)), (turns[1], scale(&against, &axis))]
            }
        }
    }
}

fn signed(sign: f64, value: Expr) -> Expr {
    super::algebra::multiply(Expr::Number(sign), value)
}

impl Slide {
    /// Of two parties along an axis of the first one.
    pub fn new(markers: &mut Vec<Marker>, parties: [Party; 2], normal: Option<usize>, axis: [f64; 3]) -> Self {
        let mut joint = Builder::new(markers, parties, normal);
        let (points, axis) = (joint.points(), joint.direction(0, axis));
        Self { axis, points, normal }
    }

    /// Its value, m: `a . (P_2 - P_1)`.
    pub fn value(&self) -> Expr {
        let [first, second] = self.points.map(|point| observed(point, 0, self.normal));
        dot(&observed(self.axis, 0, self.normal), &both(&second, &first, subtract))
    }

    /// Markers of the first and of the second party.
    pub fn parties(&self) -> [Vec<MarkerId>; 2] {
        [vec![self.axis, self.points[0]], vec![self.points[1]]]
    }
}
