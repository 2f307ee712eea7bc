//! Relative coordinates of joints: angles and slides, of the second party in the first.

use super::algebra::{self, Vector, add, angle, both, dot, multiply, observed, scale, subtract};
use super::builder::{Builder, Party};
use super::fixed::Fixed;
use super::kinds::{behind, unit};
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
        axis: Vector,
        /// Directions fixed in the first party that are a right-handed triad with the axis.
        first: Box<[Fixed; 2]>,
        /// Fixed in the second party, the first of them at t = 0.
        second: Fixed,
        /// Turning of both; none of a section.
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
            Turned::Prescribed { angle, .. } if !algebra::has_time(angle) => Expr::Number(0.0),
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
    axis: Fixed,
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
            let axis = joint.fixed(0, start).value(None);
            let first = [0, 1].map(|which| joint.normal_to(0, start, which));
            (axis, first, joint.normal_to(1, start, 0))
        };
        let turns = [0, 1].map(|party| {
            let frame = joint.frame(party)?;
            Some(joint.marker(party, Marker::Turn { frame }))
        });
        let first = Box::new(first);
        Angle::Between {
            axis,
            first,
            second,
            turns,
            normal,
        }
    }

    fn sine_and_cosine([x, y]: &[Fixed; 2], second: &Fixed, normal: Option<usize>) -> [Expr; 2] {
        let other = second.value(normal);
        [y, x].map(|own| dot(&other, &own.value(normal)))
    }

    /// Its value, rad.
    pub fn value(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.value(), first.value()),
            Angle::Between {
                first, second, normal, ..
            } => {
                let [sine, cosine] = Self::sine_and_cosine(first, second, *normal);
                angle(sine, cosine)
            }
        }
    }

    /// Its rate, rad/s: between frames in space that of the turning about the axis, else the derivative
    /// `(c s' - s c') / (s^2 + c^2)`.
    pub fn rate(&self) -> Expr {
        match self {
            Angle::Counted { first, second } => subtract(second.rate(), first.rate()),
            Angle::Between {
                axis,
                turns: [Some(first), Some(second)],
                ..
            } => {
                let [first, second] = [first, second].map(|turn| observed(*turn, 1, None));
                dot(axis, &both(&second, &first, subtract))
            }
            Angle::Between {
                first, second, normal, ..
            } => {
                let [sine, cosine] = Self::sine_and_cosine(first, second, *normal);
                let (other, other_rate) = (second.value(*normal), second.rate(*normal));
                let [sine_rate, cosine_rate] = [&first[1], &first[0]].map(|own| {
                    let turning = dot(&other_rate, &own.value(*normal));
                    add(turning, dot(&other, &own.rate(*normal)))
                });
                let change = subtract(multiply(cosine.clone(), sine_rate), multiply(sine.clone(), cosine_rate));
                algebra::divide(change, square_sum(sine, cosine))
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
                let [sine, cosine] = Self::sine_and_cosine(first, second, *normal);
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
            Angle::Between {
                first, second, normal, ..
            } => {
                let [x, y] = &**first;
                let mut own = x.markers(*normal);
                let others = y.markers(*normal);
                own.extend(others.into_iter().filter(|marker| !x.markers(*normal).contains(marker)));
                [own, second.markers(*normal)]
            }
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
                let turning = |turn: &MarkerId, moment: &Expr| vec![(*turn, scale(moment, axis))];
                let mut forces = match &turns[0] {
                    Some(turn) => turning(turn, moment),
                    None => self.on_sections(&against, 0),
                };
                forces.extend(match &turns[1] {
                    Some(turn) => turning(turn, &against),
                    None => self.on_sections(&against, 1),
                });
                forces
            }
        }
    }

    /// `M d(angle)` on the directions of one party, with `d(angle) = (c ds - s dc) / (s^2 + c^2)`.
    fn on_sections(&self, moment: &Expr, party: usize) -> Vec<(MarkerId, Vector)> {
        let Angle::Between {
            first, second, normal, ..
        } = self
        else {
            return Vec::new();
        };
        let [sine, cosine] = Self::sine_and_cosine(first, second, *normal);
        let share = algebra::divide(moment.clone(), square_sum(sine.clone(), cosine.clone()));
        let by_sine = multiply(share.clone(), cosine);
        let by_cosine = algebra::negate(multiply(share, sine));
        let [x, y] = &**first;
        if party == 1 {
            let along = [(by_sine, y), (by_cosine, x)].map(|(part, own)| scale(&part, &own.value(*normal)));
            return second.forces(&both(&along[0], &along[1], add), *normal);
        }
        let other = second.value(*normal);
        let mut forces = y.forces(&scale(&by_sine, &other), *normal);
        forces.extend(x.forces(&scale(&by_cosine, &other), *normal));
        forces
    }
}

/// `s^2 + c^2`
fn square_sum(sine: Expr, cosine: Expr) -> Expr {
    add(multiply(sine.clone(), sine), multiply(cosine.clone(), cosine))
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
        dot(&self.axis.value(self.normal), &both(&second, &first, subtract))
    }

    /// Markers of the first and of the second party.
    pub fn parties(&self) -> [Vec<MarkerId>; 2] {
        let mut first = self.axis.markers(self.normal);
        first.push(self.points[0]);
        [first, vec![self.points[1]]]
    }
}
