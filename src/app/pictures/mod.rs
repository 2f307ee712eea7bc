//! Pictures of a run: where the bodies are in some of its rows, for an animation and for ParaView.

mod animation;
mod base64;
mod colours;
mod limits;
mod paraview;
mod shapes;
pub(in crate::app) mod view;

use std::path::Path;

use colours::Colours;
pub use colours::Scale;
use limits::{FAR, MOST_BYTES};
pub use shapes::Shapes;

use crate::app::machine::files;
use crate::archive::{Archive, Keep};
use crate::model::{Configuration, Curve, SectionState, Sign};
use crate::space::Vector;
use crate::{Scene, State};

/// Most pictures of a run: what an eye follows.
const MOST: u64 = 400;
/// Pictures of a scene however large it is.
const LEAST: u64 = 2;

/// Where the bodies are in some rows of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictures {
    /// The lines.
    pub curves: Vec<Curve>,
    /// Names of the frames.
    pub frames: Vec<String>,
    /// Joints and loads.
    pub signs: Vec<Sign>,
    /// Times, s.
    pub times: Vec<f64>,
    /// Points and poses at these times.
    pub shots: Vec<Configuration>,
    /// Points of the undeformed bodies, axes of their frames, as in [`Configuration::points`].
    rest: Vec<Vector>,
    /// Whether the frames carry the undeformed shapes along.
    is_referenced: bool,
    colours: Colours,
    /// What colours the bodies in each picture.
    values: Vec<Vec<f64>>,
    /// Rows of the run.
    rows: u64,
    /// Every so many rows there is a picture.
    stride: u64,
    /// Whether there are less than could be, for the size of the page.
    is_short: bool,
}

/// The pictures; what is drawn is known.
impl Keep for Pictures {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            curves: _,
            frames: _,
            signs: _,
            times,
            shots,
            rest: _,
            is_referenced: _,
            colours,
            values,
            rows: _,
            stride: _,
            is_short: _,
        } = self;
        times.keep(archive);
        shots.keep(archive);
        colours.keep(archive);
        values.keep(archive);
        if times.len() != shots.len() || times.len() != values.len() {
            archive.misfit();
        }
    }
}

impl Pictures {
    /// No pictures yet of a run with so many rows; nothing where the scene does not draw itself.
    pub(in crate::app) fn new(scene: &mut dyn Scene, rows: u64) -> Option<Self> {
        let curves = scene.curves();
        if curves.is_empty() {
            return None;
        }
        let mut rest = Configuration::default();
        scene.configuration(&scene.rest(0.0), &mut rest);
        let colours = Colours::new(scene, &curves);
        // Components of two bytes, doubles of poses and single precision of what acts.
        let size = 6 * rest.points.len() + 2 * colours.len() + 96 * rest.poses.len() + 12 * rest.acting.len();
        let most = (MOST_BYTES / size.max(1) as u64).clamp(LEAST, MOST);
        Some(Self {
            frames: scene.frame_names(),
            signs: scene.signs(),
            times: Vec::new(),
            shots: Vec::new(),
            rest: rest.points,
            is_referenced: scene.is_referenced(),
            colours,
            values: Vec::new(),
            curves,
            rows,
            stride: rows.div_ceil(most).max(1),
            is_short: most < MOST.min(rows),
        })
    }

    /// Lets the scale of the colours reach what the sections carry at a time.
    pub(in crate::app) fn meet(&mut self, t: f64, sections: &[SectionState]) {
        self.colours.meet(t, sections);
    }

    /// Takes in a row with what its sections carry, and the picture of one that is kept.
    pub(in crate::app) fn take(
        &mut self,
        row: u64,
        scene: &mut dyn Scene,
        t: f64,
        state: &State,
        sections: &[SectionState],
    ) {
        self.meet(t, sections);
        if row.is_multiple_of(self.stride) {
            let mut shot = Configuration::default();
            scene.configuration(state, &mut shot);
            self.times.push(t);
            self.shots.push(shot);
            self.values.push(self.colours.values(sections));
        }
    }

    /// What colours the bodies, with what it is over all of the run; not those of which nothing is known.
    pub fn scales(&self) -> Vec<Scale> {
        self.colours.scales()
    }

    /// How many rows are drawn, and why not all.
    fn told_of_rows(&self) -> String {
        let (drawn, rows) = (self.shots.len(), self.rows);
        if self.stride == 1 {
            return format!("All {drawn} rows of the run are drawn.");
        }
        let why = if self.is_short {
            ", so that the page stays small"
        } else {
            ""
        };
        format!(
            "{drawn} of the {rows} rows of the run are drawn, one in {}{why}; a shorter run, or `--every`, shows more of its part.",
            self.stride
        )
    }

    /// Writes the animation, and the files for ParaView, where they are asked for; the lines that name the files.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub(in crate::app) fn write(&self, out: &Path, title: &str, [animate, vtu]: [bool; 2]) -> Result<String, String> {
        let mut lines = String::new();
        let mut named = |name: &str| lines += &format!("\n  {}", out.join(name).display());
        if animate {
            files::write(out, animation::NAME, &animation::page(title, self))?;
            named(animation::NAME);
        }
        if vtu {
            let folder = out.join(paraview::FOLDER);
            files::create_folder(&folder)?;
            for picture in 0..self.shots.len() {
                files::write(&folder, &paraview::name(picture), &paraview::picture(self, picture))?;
            }
            files::write(out, paraview::LIST, &paraview::list(self))?;
            named(paraview::LIST);
        }
        Ok(lines)
    }

    /// The frame whose origin a picture follows: the inertial one, or the first that flies far away.
    pub(in crate::app) fn followed(&self) -> usize {
        let extent = self.shots.iter().flat_map(|shot| &shot.points);
        let size = extent.map(|&point| point.norm()).fold(0.0, f64::max);
        let (Some(first), Some(last)) = (self.shots.first(), self.shots.last()) else {
            return 0;
        };
        let goes_far = |&frame: &usize| {
            let (start, end) = (first.poses[frame].0, last.poses[frame].0);
            start.norm().max((end - start).norm()) > FAR * size
        };
        (1..self.frames.len()).find(goes_far).unwrap_or(0)
    }

    /// Points of a picture relative to the origin of a frame, inertial axes, curve after curve.
    pub(in crate::app) fn places<'p>(
        &'p self,
        shot: &'p Configuration,
        followed: usize,
    ) -> impl Iterator<Item = Vector> + 'p {
        let origin = shot.poses[followed].0;
        let frames = self
            .curves
            .iter()
            .flat_map(|curve| std::iter::repeat_n(curve.frame, curve.points));
        frames.zip(&shot.points).map(move |(frame, &point)| {
            let (place, rotation) = &shot.poses[frame];
            *place - origin + rotation * point
        })
    }
}

#[cfg(test)]
mod tests;
