//! Stress-free axes of bodies, and how their sections turn about them.

use std::fmt;
use std::sync::Arc;

use super::curve::Curve;
use super::nodes::{Held, Nodes};
use crate::space::Vector;

/// Stress-free twist of a section: angle about the tangent (rad) as a function of the fraction of the axis in [0, 1].
#[derive(Clone)]
pub struct Twist(Arc<dyn Fn(f64) -> f64 + Send + Sync>);

impl Twist {
    /// From nothing at the start to an angle (rad) at the end, evenly.
    pub fn even(angle: f64) -> Self {
        Self(Arc::new(move |u| angle * u))
    }

    /// A function of the fraction of the axis.
    pub fn along(angle: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self(Arc::new(angle))
    }

    /// Angle at a fraction of the axis, rad.
    pub fn at(&self, u: f64) -> f64 {
        self.0(u)
    }
}

impl fmt::Debug for Twist {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Twist({} .. {} rad)", self.at(0.0), self.at(1.0))
    }
}

/// Stress-free axis of a body, in its declared frame.
#[derive(Clone, Debug)]
pub enum Line {
    /// From a point to a point, m.
    Straight {
        /// Start.
        from: [f64; 3],
        /// End.
        to: [f64; 3],
    },
    /// A circular arc.
    Arc {
        /// Start, m.
        from: [f64; 3],
        /// Tangent at the start; its norm does not matter.
        direction: [f64; 3],
        /// Normal of the plane, made normal to the direction; a positive angle turns counter-clockwise about
        /// it.
        normal: [f64; 3],
        /// Radius, m.
        radius: f64,
        /// Subtended angle, rad.
        angle: f64,
    },
    /// A smooth curve through points, or along a function.
    Curve(Curve),
    /// The interfaces of a body from elsewhere: no line, places of nodes alone.
    Nodes(Nodes),
}

impl Line {
    /// Arclength, m.
    pub fn length(&self) -> f64 {
        match *self {
            Line::Straight { from, to } => (Vector::from(to) - Vector::from(from)).norm(),
            Line::Arc { radius, angle, .. } => radius * angle.abs(),
            Line::Curve(ref curve) => curve.length(),
            Line::Nodes(ref nodes) => nodes.body().map_or(f64::NAN, |body| body.extent()),
        }
    }

    /// Position (m) and unit tangent at the fraction `u` in [0, 1] of the arclength.
    pub fn at(&self, u: f64) -> (Vector, Vector) {
        match *self {
            Line::Straight { from, to } => {
                let (from, to) = (Vector::from(from), Vector::from(to));
                let whole = to - from;
                let length = whole.norm();
                // Both ends exactly as declared.
                let point = if u < 0.5 {
                    from + u * whole
                } else {
                    to - (1.0 - u) * whole
                };
                (point, whole / length)
            }
            Line::Arc {
                from,
                direction,
                normal,
                radius,
                angle,
            } => {
                let (tangent, normal) = directions(direction, normal);
                // Centre to the left of the tangent for a positive angle.
                let side = angle.signum() * normal.cross(&tangent);
                let turn = (angle * u).abs();
                let (sine, cosine) = turn.sin_cos();
                let along = radius * sine * tangent;
                // 1 - cos without cancellation
                let across = radius * 2.0 * (0.5 * turn).sin().powi(2) * side;
                let here = cosine * tangent + sine * side;
                (Vector::from(from) + (along + across), here)
            }
            Line::Curve(ref curve) => curve.at(u),
            Line::Nodes(ref nodes) => {
                let node = (u * (nodes.count() - 1) as f64).round() as usize;
                let interface = match nodes.at(node) {
                    Held::Interface(interface) => interface,
                    Held::Coordinates(_) => 0,
                };
                let place = nodes
                    .body()
                    .map_or(Vector::repeat(f64::NAN), |body| body.place(interface));
                (place, Vector::x())
            }
        }
    }

    /// Rotation vector (rad) of the tangent from the start to the fraction `u` of the arclength; `None` of a curve, whose
    /// sections are oriented at every place by themselves.
    pub fn turned(&self, u: f64) -> Option<Vector> {
        Some(match *self {
            Line::Straight { .. } | Line::Nodes(_) => Vector::zeros(),
            Line::Curve(_) => return None,
            Line::Arc {
                direction,
                normal,
                angle,
                ..
            } => angle * u * directions(direction, normal).1,
        })
    }

    /// Whether an arc's direction and normal span a plane; straight lines need a length alone.
    pub fn has_plane(&self) -> bool {
        match *self {
            Line::Straight { .. } | Line::Curve(_) | Line::Nodes(_) => true,
            Line::Arc { direction, normal, .. } => {
                let (direction, normal) = (Vector::from(direction), Vector::from(normal));
                let size = direction.norm() * normal.norm();
                size.is_finite() && direction.cross(&normal).norm() > PARALLEL * size
            }
        }
    }
}

/// Sine of the angle below which two directions count as parallel.
pub(crate) const PARALLEL: f64 = 1e-6;

/// Unit tangent at the start of an arc, and its unit normal normal to it.
fn directions(direction: [f64; 3], normal: [f64; 3]) -> (Vector, Vector) {
    let (direction, normal) = (Vector::from(direction), Vector::from(normal));
    let size = direction.norm();
    let tangent = direction / size;
    let across = normal - normal.dot(&tangent) * tangent;
    let size = across.norm();
    (tangent, across / size)
}

#[cfg(test)]
mod tests {
    use crate::emitted::line::*;

    #[test]
    fn an_arc_ends_where_trigonometry_says() {
        let arc = Line::Arc {
            from: [0.0; 3],
            direction: [2.0, 0.0, 0.0],
            normal: [0.0, 0.0, 1.0],
            radius: 16.0,
            angle: -0.5,
        };
        let (tip, tangent) = arc.at(1.0);
        assert!(
            (tip[0] - 7.67081).abs() < 1e-5 && (tip[1] + 1.95868).abs() < 1e-5,
            "{tip:?}"
        );
        assert!((tangent[1] + 0.5f64.sin()).abs() < 1e-15);
        assert_eq!(arc.length(), 8.0);
    }
}
