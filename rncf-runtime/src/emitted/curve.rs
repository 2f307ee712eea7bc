//! Smooth space curves by arclength: through points, or along a function.

use std::fmt;
use std::sync::Arc;

use super::gauss::FIVE;
use super::spline::Spline;
use crate::space::Vector;

/// Pieces of one span of a spline in the table of its arclength.
const PIECES: usize = 16;
/// Pieces of a function's parameter in that table: the fewest and the most.
const OF_FUNCTION: [usize; 2] = [256, 1 << 16];
/// Slope of a spline by the sum of its chords, about one everywhere, below which it has no direction.
const CUSP: f64 = 1e-6;
/// Relative difference of the lengths by one number of pieces and by half of it, below which the length is known.
const KNOWN: f64 = 1e-13;

/// A smooth curve in space, m.
#[derive(Clone)]
pub struct Curve {
    /// Position (m) and its derivative by the parameter.
    path: Arc<dyn Fn(f64) -> [Vector; 2] + Send + Sync>,
    /// Parameters that divide the curve into pieces.
    places: Vec<f64>,
    /// Arclength (m) at each of them.
    lengths: Vec<f64>,
    /// Why there is no such curve.
    mistake: Option<String>,
}

impl Curve {
    /// The cubic spline through points (m), at least two, no two neighbours at one place: [`Curve::mistake`] tells where they are
    /// not. An end has the direction of its unit vector; without one it is natural, and its curvature vanishes.
    pub fn through(points: &[[f64; 3]], directions: [Option<[f64; 3]>; 2]) -> Self {
        let spline = match Spline::through(points, directions.map(|direction| direction.map(Vector::from))) {
            Ok(spline) => spline,
            Err(mistake) => return Self::none(mistake),
        };
        if let Some(cusp) = spline.knots().iter().position(|&at| spline.at(at)[1].norm() < CUSP) {
            return Self::none(format!(
                "turns back at point {}, where it has no direction: leave out what goes back, or end the body there",
                cusp + 1
            ));
        }
        let pieces = spline.knots().windows(2).flat_map(|ends| {
            let width = (ends[1] - ends[0]) / PIECES as f64;
            let start = ends[0];
            (0..PIECES).map(move |piece| start + piece as f64 * width)
        });
        let places = pieces.chain(spline.knots().last().copied()).collect();
        Self::divided(Arc::new(move |at| spline.at(at)), places)
    }

    /// Along a function: position (m) and its derivative at a parameter that goes from one number to another.
    /// [`Curve::mistake`] tells where the curve has no direction, no finite place, or no length that can be measured.
    pub fn along(from: f64, to: f64, path: impl Fn(f64) -> [[f64; 3]; 2] + Send + Sync + 'static) -> Self {
        let range = to - from;
        if !(range != 0.0 && range.is_finite()) {
            return Self::none(format!("has no length: its parameter goes from {from} to {to}"));
        }
        // By the part of the range, so that the curve runs forwards where the parameter goes down.
        let whole = move |part: f64| {
            let [position, slope] = path(from + part * range);
            [Vector::from(position), range * Vector::from(slope)]
        };
        for at in 0..=OF_FUNCTION[0] {
            let part = at as f64 / OF_FUNCTION[0] as f64;
            let [position, slope] = whole(part);
            let place = from + part * range;
            if !(position.iter().chain(&slope).all(|value| value.is_finite())) {
                return Self::none(format!(
                    "has no finite place, or no tangent there, where its parameter is {place}"
                ));
            }
            if slope.norm() <= f64::EPSILON * position.norm() {
                return Self::none(format!(
                    "has no direction where its parameter is {place}: its derivative vanishes there"
                ));
            }
        }
        let path: Arc<dyn Fn(f64) -> [Vector; 2] + Send + Sync> = Arc::new(whole);
        let evenly = |count: usize| (0..=count).map(|at| at as f64 / count as f64).collect();
        let mut count = OF_FUNCTION[0];
        let mut curve = Self::divided(path.clone(), evenly(count));
        while count < OF_FUNCTION[1] {
            count *= 2;
            let finer = Self::divided(path.clone(), evenly(count));
            let change = (finer.length() - curve.length()).abs();
            if change <= KNOWN * finer.length() {
                return curve;
            }
            curve = finer;
        }
        Self::none(
            "is not smooth: its length cannot be measured; take pieces that are, as bodies that share nodes".into(),
        )
    }

    /// No curve, and why: a straight line of one metre stands for it.
    pub(super) fn none(mistake: String) -> Self {
        let straight = |at: f64| [at * Vector::x(), Vector::x()];
        Self {
            mistake: Some(mistake),
            ..Self::divided(Arc::new(straight), vec![0.0, 1.0])
        }
    }

    fn divided(path: Arc<dyn Fn(f64) -> [Vector; 2] + Send + Sync>, places: Vec<f64>) -> Self {
        let mut curve = Self {
            path,
            places,
            lengths: vec![0.0],
            mistake: None,
        };
        for piece in 0..curve.places.len() - 1 {
            let length = curve.length_between(curve.places[piece], curve.places[piece + 1]);
            curve.lengths.push(curve.lengths[piece] + length);
        }
        curve
    }

    /// The same with more said of why it is none.
    pub(super) fn told(mut self, more: impl FnOnce(String) -> String) -> Self {
        self.mistake = self.mistake.map(more);
        self
    }

    /// Why there is no such curve, a sentence without its subject.
    pub fn mistake(&self) -> Option<&str> {
        self.mistake.as_deref()
    }

    /// Arclength, m.
    pub fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Position (m) and unit tangent at the fraction `u` in [0, 1] of the arclength.
    pub fn at(&self, u: f64) -> (Vector, Vector) {
        let [place, slope] = (self.path)(self.parameter(u));
        (place, 1.0 / slope.norm() * slope)
    }

    /// The parameter where the arclength is a fraction of the whole: Newton's iteration in the piece of the table.
    fn parameter(&self, u: f64) -> f64 {
        let wanted = u.clamp(0.0, 1.0) * self.length();
        let piece = self
            .lengths
            .partition_point(|&length| length <= wanted)
            .clamp(1, self.lengths.len() - 1)
            - 1;
        let [start, end] = [self.places[piece], self.places[piece + 1]];
        let share = (wanted - self.lengths[piece]) / (self.lengths[piece + 1] - self.lengths[piece]);
        let mut at = start + share * (end - start);
        for _ in 0..8 {
            let missing = wanted - self.lengths[piece] - self.length_between(start, at);
            let change = missing / (self.path)(at)[1].norm();
            at = (at + change).clamp(start, end);
            if change.abs() <= 1e-15 * end.abs() {
                break;
            }
        }
        at
    }

    fn length_between(&self, from: f64, to: f64) -> f64 {
        let speed = |(place, weight): (f64, f64)| weight * (self.path)(from + place * (to - from))[1].norm();
        (to - from) * FIVE.map(speed).iter().sum::<f64>()
    }
}

impl fmt::Debug for Curve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [start, end] = [0.0, 1.0].map(|u| self.at(u).0);
        write!(
            f,
            "Curve({:?} .. {:?}, {} m)",
            start.as_slice(),
            end.as_slice(),
            self.length()
        )
    }
}

#[cfg(test)]
mod tests {
    use crate::emitted::curve::*;

    #[test]
    fn a_spline_through_points_of_a_circle_has_its_length_and_tangent() {
        let count = 40;
        let point = |at: usize| {
            let angle = at as f64 / count as f64;
            [10.0 * angle.sin(), 10.0 * (1.0 - angle.cos()), 0.0]
        };
        let points: Vec<[f64; 3]> = (0..=count).map(point).collect();
        let spline = Curve::through(&points, [None; 2]);
        assert!((spline.length() - 10.0).abs() < 1e-5, "{}", spline.length());
        let (place, tangent) = spline.at(0.5);
        let wanted = Vector::new(10.0 * 0.5_f64.sin(), 10.0 * (1.0 - 0.5_f64.cos()), 0.0);
        assert!((place - wanted).norm() < 1e-5, "{place:?}");
        assert!((tangent[0] - 0.5_f64.cos()).abs() < 1e-5, "{tangent:?}");
        let turn = (spline.at(0.51).1 - spline.at(0.49).1).norm() / (0.02 * spline.length());
        assert!((turn - 0.1).abs() < 1e-5, "{turn}");
    }

    /// The length is that of scipy's `CubicSpline` with the same slopes; without directions it is 2.2e-3 short.
    #[test]
    fn a_spline_with_directions_is_near_a_circle_with_few_points() {
        let points: Vec<[f64; 3]> = (0..5)
            .map(|at| (f64::from(at) * std::f64::consts::FRAC_PI_8).sin_cos())
            .map(|(sine, cosine)| [sine, 1.0 - cosine, 0.0])
            .collect();
        let directions = [Some([1.0, 0.0, 0.0]), Some([0.0, 1.0, 0.0])];
        let spline = Curve::through(&points, directions);
        let short = spline.length() - std::f64::consts::FRAC_PI_2;
        assert!((short + 6.849_096e-5).abs() < 1e-8, "{short:e}");
        assert!((spline.at(0.0).1 - Vector::x()).norm() < 1e-14 && (spline.at(1.0).1 - Vector::y()).norm() < 1e-14);
        for at in 0..=40 {
            let off = (spline.at(f64::from(at) / 40.0).0 - Vector::y()).norm() - 1.0;
            assert!(off.abs() < 1.4e-4, "{off:e}");
        }
        let backwards = Curve::through(&points, [None, Some([0.0, -1.0, 0.0])]);
        assert!(
            backwards
                .mistake()
                .unwrap()
                .starts_with("leads away from its point 4 at point 5")
        );
    }

    #[test]
    fn a_spline_through_points_of_a_line_is_the_line() {
        let points = [[0.0; 3], [1.0, 2.0, 0.0], [3.0, 6.0, 0.0], [3.5, 7.0, 0.0]];
        let spline = Curve::through(&points, [None; 2]);
        let end = Vector::from(points[3]);
        let whole = end.norm();
        assert!((spline.length() - whole).abs() < 1e-14 * whole);
        for u in [0.0, 0.1, 0.37, 0.999, 1.0] {
            let (place, tangent) = spline.at(u);
            assert!((place - u * end).norm() < 1e-14 * whole);
            assert!((tangent - 1.0 / whole * end).norm() < 1e-14);
        }
    }

    #[test]
    fn points_at_one_place_are_refused_by_their_number() {
        let back = Curve::through(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0; 3]], [None; 2]);
        assert!(back.mistake().unwrap().starts_with("turns back at point 2"));
        let refused = Curve::through(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], [None; 2]);
        assert!(refused.mistake().is_some_and(|text| text.contains("points 2 and 3")));
    }

    #[test]
    fn a_parabola_has_the_length_of_its_closed_form_in_both_directions() {
        let parabola = |s: f64| [[s, s * s, 0.0], [1.0, 2.0 * s, 0.0]];
        let wanted = 5.0_f64.sqrt() / 2.0 + 2.0_f64.asinh() / 4.0;
        for (from, to, way) in [(0.0, 1.0, 1.0), (1.0, 0.0, -1.0)] {
            let curve = Curve::along(from, to, parabola);
            assert_eq!(curve.mistake(), None);
            assert!((curve.length() - wanted).abs() < 1e-14);
            let (place, tangent) = curve.at(0.3);
            assert!((place[1] - place[0] * place[0]).abs() < 1e-15);
            assert!((tangent[1] / tangent[0] - 2.0 * place[0]).abs() < 1e-14);
            assert_eq!(tangent[0].signum(), way);
        }
    }

    #[test]
    fn functions_without_direction_place_or_length_are_refused() {
        let cusp = Curve::along(-1.0, 1.0, |s| [[s * s, s * s * s, 0.0], [2.0 * s, 3.0 * s * s, 0.0]]);
        assert!(
            cusp.mistake()
                .is_some_and(|text| text.contains("no direction where its parameter is 0"))
        );
        let pole = Curve::along(0.0, 1.0, |s| [[s, 1.0 / s, 0.0], [1.0, -1.0 / (s * s), 0.0]]);
        assert!(pole.mistake().is_some_and(|text| text.contains("no finite place")));
        let jump = Curve::along(0.0, 1.0, |s| {
            [[s, 0.0, 0.0], [if s < 1.0 / 3.0 { 1.0 } else { 2.0 }, 0.0, 0.0]]
        });
        assert!(jump.mistake().is_some_and(|text| text.contains("not smooth")));
        assert!(
            Curve::along(1.0, 1.0, |_| [[0.0; 3]; 2])
                .mistake()
                .is_some_and(|text| text.contains("no length"))
        );
    }
}
