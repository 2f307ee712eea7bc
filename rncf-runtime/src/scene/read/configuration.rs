//! Pictures of a scene: the lines of its bodies in their frames, and where the frames are.

use crate::model::{Configuration, Curve};
use crate::scene::bodies::place::{PlaceVector, point_of, weighted};
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::marker::Marker;
use crate::space::{Vector, from_matrix};

/// Straight pieces that a body is drawn with at least, where it has fewer elements.
const PIECES: usize = 16;
/// Most straight pieces of one element.
const MOST: usize = 8;
/// Part of the scene's length that a point is drawn with.
const SMALL: f64 = 0.02;

/// Pieces of an element of a body with so many of them.
pub(super) fn pieces(elements: usize) -> usize {
    PIECES.div_ceil(elements).min(MOST)
}

impl MeshScene {
    /// The lines of this scene.
    pub(crate) fn drawn(&self) -> Vec<Curve> {
        let flexible = self.bodies.iter().map(|body| Curve {
            name: body.spec.label(),
            frame: body.frame,
            points: body.spec.count * pieces(body.spec.count) + 1,
            is_flexible: true,
        });
        let fixed = (0..self.frames.free.len()).map(|free| Curve {
            name: self.parts.frame_name(self.frames.free[free].spec.frame).to_string(),
            frame: self.frames.free[free].spec.frame,
            points: self.attached(free).len(),
            is_flexible: false,
        });
        flexible.chain(fixed.filter(|curve| curve.points > 0)).collect()
    }

    /// Places that joints, springs and outputs use of a free frame, and its centre of mass, each with the origin before and behind it;
    /// of a rigid body without any a cross.
    fn attached(&self, free: usize) -> Vec<Vector> {
        let frame = self.frames.free[free].spec.frame;
        let mut places: Vec<Vector> = Vec::new();
        for marker in &self.links.markers {
            match *marker {
                Marker::Fixed {
                    frame: of,
                    at,
                    is_point: true,
                } if of == frame && at.norm() > 0.0 && !places.contains(&at) => places.push(at),
                _ => {}
            }
        }
        let rigid = &self.frames.free[free].spec.rigid;
        if rigid.moment.norm() > 0.0 {
            places.push(rigid.moment / rigid.mass);
        }
        if places.is_empty() && self.frames.free[free].spec.is_body {
            places = self.cross(free);
        }
        places
            .iter()
            .flat_map(|&place| [Vector::zeros(), place, Vector::zeros()])
            .collect()
    }

    /// Ends of a cross along the axes of a rigid body, as long as its radii of gyration; a point has a small one.
    fn cross(&self, free: usize) -> Vec<Vector> {
        let (frame, border) = (&self.frames.free[free], self.layout.unknowns() - self.layout.border());
        let (mass, inertia) = (frame.spec.rigid.mass, &frame.spec.rigid.inertia);
        let half_trace = 0.5 * inertia.trace();
        let radii = Vector::from_fn(|axis, _| ((half_trace - inertia[(axis, axis)]).max(0.0) / mass).sqrt());
        let radii = match radii.norm() {
            radius if radius > 0.0 && radius.is_finite() => radii,
            _ => Vector::repeat(SMALL * self.tabulated.sizes[border + frame.first]),
        };
        let ends = (0..3).flat_map(|axis| [radii[axis], -radii[axis]].map(|end| end * Vector::ith(axis, 1.0)));
        ends.filter(|end| end.norm() > 0.0).collect()
    }

    /// Number of frames that have a place: states stand behind them.
    pub(crate) fn drawn_frames(&self) -> usize {
        self.parts.frame_count() - self.frames.states.len()
    }

    /// The picture at the loaded state.
    pub(crate) fn draw(&self, out: &mut Configuration) {
        out.points.clear();
        for (index, body) in self.bodies.iter().enumerate() {
            let count = body.spec.count;
            let pieces = pieces(count);
            let places: Vec<_> = (0..=pieces)
                .map(|piece| point_of(&*self.parts, &body.spec, index, 0, piece as f64 / pieces as f64))
                .collect();
            for element in 0..count {
                let last = usize::from(element + 1 == count);
                for place in &places[..pieces + last] {
                    let components = body.connectivity.element(element);
                    let weights = place.weights(PlaceVector::Position);
                    let place = weighted(&self.buffers.q, components, body.spec.dimension(), weights);
                    out.points.push(body.offset + body.spread(place));
                }
            }
        }
        for free in 0..self.frames.free.len() {
            out.points.extend(self.attached(free));
        }
        out.poses.clear();
        let poses = self.buffers.frames[..self.drawn_frames()].iter();
        out.poses
            .extend(poses.map(|frame| (frame.position, from_matrix(&frame.rotation))));
        self.acting(&mut out.acting);
    }
}
