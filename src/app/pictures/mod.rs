//! Pictures of a run: where the bodies are in some of its rows, for an animation and for ParaView.

pub(super) mod animation;
mod base64;
pub(super) mod paraview;

use crate::archive::{Archive, Keep};
use crate::model::{Configuration, Curve};
use crate::vector::{Vector, add, apply, norm, subtract};
use crate::{Scene, State};

/// Most pictures of a run: what a page can hold, and an eye follow.
const MOST: u64 = 400;

/// A frame that goes farther than so many sizes of the scene is followed.
const FAR: f64 = 3.0;

/// Where the bodies are in some rows of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// The lines.
    pub curves: Vec<Curve>,
    /// Names of the frames.
    pub frames: Vec<String>,
    /// Times, s.
    pub times: Vec<f64>,
    /// Points and poses at these times.
    pub shots: Vec<Configuration>,
    /// Every so many rows there is a picture.
    stride: u64,
}

/// The pictures; what is drawn is known.
impl Keep for Pictures {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            curves: _,
            frames: _,
            times,
            shots,
            stride: _,
        } = self;
        times.keep(archive);
        shots.keep(archive);
        if times.len() != shots.len() {
            archive.misfit();
        }
    }
}

impl Pictures {
    /// No pictures yet of a run with so many rows; nothing where the scene does not draw itself.
    pub(super) fn new(scene: &dyn Scene, rows: u64) -> Option<Self> {
        let curves = scene.curves();
        (!curves.is_empty()).then(|| Self {
            curves,
            frames: scene.frame_names(),
            times: Vec::new(),
            shots: Vec::new(),
            stride: rows.div_ceil(MOST).max(1),
        })
    }

    /// Takes the picture of a row where it is one that is kept.
    pub(super) fn take(&mut self, row: u64, scene: &mut dyn Scene, t: f64, state: &State) {
        if row.is_multiple_of(self.stride) {
            let mut shot = Configuration::default();
            scene.configuration(state, &mut shot);
            self.times.push(t);
            self.shots.push(shot);
        }
    }

    /// The frame whose origin a picture follows: the inertial one, or the first that flies far away.
    pub(super) fn followed(&self) -> usize {
        let extent = self.shots.iter().flat_map(|shot| &shot.points);
        let size = extent.map(|&point| norm(point)).fold(0.0, f64::max);
        let (Some(first), Some(last)) = (self.shots.first(), self.shots.last()) else {
            return 0;
        };
        let goes_far = |&frame: &usize| {
            let (start, end) = (first.poses[frame].0, last.poses[frame].0);
            norm(start).max(norm(subtract(end, start))) > FAR * size
        };
        (1..self.frames.len()).find(goes_far).unwrap_or(0)
    }

    /// Points of a picture relative to the origin of a frame, inertial axes, curve after curve.
    pub(super) fn places<'p>(&'p self, shot: &'p Configuration, followed: usize) -> impl Iterator<Item = Vector> + 'p {
        let origin = shot.poses[followed].0;
        let frames = self
            .curves
            .iter()
            .flat_map(|curve| std::iter::repeat_n(curve.frame, curve.points));
        frames.zip(&shot.points).map(move |(frame, &point)| {
            let (place, rotation) = &shot.poses[frame];
            add(subtract(*place, origin), apply(&rotation.matrix(), point))
        })
    }
}
