//! Modes as they move: displacements of all that is drawn, about an equilibrium.

use super::limits::{FAR, MOST_BYTES};
use crate::model::{Configuration, Curve, Sign, SignPlace};
use crate::modes::Mode;
use crate::space::Vector;
use crate::{Scene, State};

/// Part of the shape by which the unknowns are moved to see what the points do: far above round-off, and small enough to be linear.
const MOVED: f64 = 1e-4;

/// The shapes of modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Shapes {
    /// The lines; behind those of the scene the points of its signs and frames, one each.
    pub curves: Vec<Curve>,
    /// Number of lines of the scene itself.
    pub(super) visible: usize,
    /// Place among the curves of the first frame's origin.
    pub(super) origins: usize,
    pub(super) frames: Vec<String>,
    pub(super) signs: Vec<Sign>,
    /// The equilibrium; points of all curves in the axes of their frames.
    pub(super) at: Configuration,
    /// For every mode the displacement of each point, real and imaginary part, inertial axes; the largest one is 1.
    pub moved: Vec<Vec<[Vector; 2]>>,
}

impl Shapes {
    /// Of the modes about an equilibrium, as many as a page holds; nothing where the scene does not draw itself.
    pub(in crate::app) fn new(scene: &mut dyn Scene, state: &State, modes: &[Mode]) -> Option<Self> {
        let mut curves = scene.curves();
        if curves.is_empty() {
            return None;
        }
        let visible = curves.len();
        let (frames, mut signs) = (scene.frame_names(), scene.signs());
        let mut extra: Vec<(usize, Vector)> = Vec::new();
        for sign in &mut signs {
            if let Some(SignPlace::Frame { frame, at }) = sign.place {
                sign.place = Some(SignPlace::Curve {
                    curve: visible + extra.len(),
                    point: 0.0,
                });
                extra.push((frame, at));
            }
        }
        let origins = visible + extra.len();
        extra.extend((0..frames.len()).map(|frame| (frame, Vector::zeros())));
        curves.extend(extra.iter().map(|&(frame, _)| Curve {
            name: String::new(),
            frame,
            points: 1,
            is_flexible: false,
        }));
        let turns = scene.turns().to_vec();
        let mut drawn = |state: &State| {
            let mut at = Configuration::default();
            scene.configuration(state, &mut at);
            at.points.extend(extra.iter().map(|&(_, place)| place));
            at
        };
        let at = drawn(state);
        let most = MOST_BYTES as usize / (24 * at.points.len().max(1));
        let mut places = |state: &State| -> Vec<Vector> {
            let shot = drawn(state);
            let frames = curves
                .iter()
                .flat_map(|curve| std::iter::repeat_n(curve.frame, curve.points));
            let place = |(frame, &point): (usize, &Vector)| {
                let (origin, rotation) = &shot.poses[frame];
                origin + rotation * point
            };
            frames.zip(&shot.points).map(place).collect()
        };
        let mut of_part = |mode: &Mode, part: usize| -> Vec<Vector> {
            let [up, down] = [MOVED, -MOVED].map(|by| {
                let mut moved = state.clone();
                moved.rebase(&turns);
                for (x, shape) in moved.x.iter_mut().zip(&mode.shape) {
                    *x += by * shape[part];
                }
                places(&moved)
            });
            up.into_iter().zip(down).map(|(up, down)| up - down).collect()
        };
        let of_mode = |mode: &Mode| -> Vec<[Vector; 2]> {
            let [real, imaginary] = [0, 1].map(|part| of_part(mode, part));
            let size = |(re, im): (&Vector, &Vector)| (re.norm_squared() + im.norm_squared()).sqrt();
            let largest = real.iter().zip(&imaginary).map(size).fold(0.0, f64::max);
            let factor = if largest > 0.0 { 1.0 / largest } else { 0.0 };
            let both = real.into_iter().zip(imaginary);
            both.map(|(re, im)| [factor * re, factor * im]).collect()
        };
        let moved = modes.iter().take(most).map(of_mode).collect();
        Some(Self {
            curves,
            visible,
            origins,
            frames,
            signs,
            at,
            moved,
        })
    }

    /// The frame whose origin is in the middle: one that is far away from the inertial origin, beside the size of the scene, or none.
    pub(super) fn followed(&self) -> usize {
        let size = self.at.points.iter().map(Vector::norm).fold(0.0, f64::max);
        let is_far = |&frame: &usize| self.at.poses[frame].0.norm() > FAR * size;
        (1..self.frames.len()).find(is_far).unwrap_or(0)
    }
}
