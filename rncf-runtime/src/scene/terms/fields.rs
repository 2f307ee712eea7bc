//! Gravity fields on what free frames carry, and whether loads that depend on markers change with a rigid
//! displacement.

use crate::emitted::LoadKind;
use crate::error::ModelError;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::pieces::displacement::Displacement;
use crate::space::Vector;

/// Relative change that counts as round-off.
const ROUND_OFF: f64 = 1e-8;

/// Time in which what depends on time changes, s.
const A_WHILE: f64 = 1e-3;

impl MeshScene {
    /// Refuses fields where bodies do not live in the frame.
    ///
    /// # Errors
    /// A field on a frame that carries bodies in absolute coordinates, by name.
    pub(crate) fn check_fields(&self) -> Result<(), ModelError> {
        for load in &self.dead_loads.specs {
            let LoadKind::Field { .. } = load.kind else { continue };
            let is_absolute = |body: &&MeshBody| body.spec.frame == load.frame && body.frame != load.frame;
            if let Some(body) = self.bodies.iter().find(is_absolute) {
                return Err(ModelError::new(format!(
                    "load `{}` acts on what frame `{}` carries, and body `{}` has absolute coordinates: use the referenced formulation",
                    load.name,
                    self.parts.frame_name(load.frame),
                    body.spec.label()
                )));
            }
        }
        Ok(())
    }

    fn field_arguments(&self, markers: &[usize]) -> Vec<Vector> {
        markers
            .iter()
            .map(|&marker| self.jet(&self.links.markers[marker])[0])
            .collect()
    }

    /// Gravity of a field load at the loaded state, m/s^2, inertial axes.
    fn field(&self, load: usize, t: f64) -> Option<Vector> {
        let LoadKind::Field { markers } = self.dead_loads.specs[load].kind else {
            return None;
        };
        Some(self.parts.field(load, t, &self.field_arguments(markers)).into())
    }

    /// Sets the fields of all frames at the loaded state.
    pub(crate) fn set_fields(&mut self, t: f64, load_scale: f64) {
        for frame in &mut self.buffers.frames {
            frame.field = Vector::zeros();
        }
        for load in 0..self.dead_loads.specs.len() {
            if let Some(field) = self.field(load, t) {
                let frame = &mut self.buffers.frames[self.dead_loads.specs[load].frame];
                frame.field += load_scale * field;
            }
        }
        let changes = (0..self.frames.free.len()).map(|free| self.field_changes(free, t, load_scale));
        self.buffers.field_changes = changes.collect();
    }

    /// How the field on a free frame changes with each of the frame's unknowns at the loaded state, inertial axes.
    fn field_changes(&self, free: usize, t: f64, load_scale: f64) -> Vec<Vector> {
        let frame = &self.frames.free[free];
        let mut changes = vec![Vector::zeros(); frame.count()];
        let first = self.layout.vector_components() + frame.first;
        for (index, load) in self.dead_loads.specs.iter().enumerate() {
            let LoadKind::Field { markers } = load.kind else {
                continue;
            };
            if load.frame != frame.spec.frame {
                continue;
            }
            let z = self.field_arguments(markers);
            let width = 3 * z.len();
            let mut gradient = vec![0.0; 3 * width];
            self.parts.field_gradient(index, t, &z, &mut gradient);
            for (place, &marker) in markers.iter().enumerate() {
                for column in self.columns(&self.links.markers[marker]) {
                    let Some(change) = column.component.checked_sub(first).and_then(|own| changes.get_mut(own)) else {
                        continue;
                    };
                    for (i, value) in change.iter_mut().enumerate() {
                        let row = &gradient[i * width + 3 * place..][..3];
                        *value += load_scale * Vector::from_column_slice(row).dot(&column.value);
                    }
                }
            }
        }
        changes
    }

    /// Names and values, at the loaded state, of the loads that depend on markers: those of densities, and fields in
    /// the axes of their frames.
    pub(crate) fn marked_values(&self, t: f64) -> Vec<(&'static str, Vec<f64>)> {
        let densities = self.distributed.all.iter().enumerate();
        let densities = densities.map(|(index, density)| (density.spec.name, self.density_values(index, t)));
        let fields = (0..self.dead_loads.specs.len()).filter_map(|load| {
            let frame = &self.buffers.frames[self.dead_loads.specs[load].frame];
            let field = frame.direction_to_frame(self.field(load, t)?);
            Some((self.dead_loads.specs[load].name, field.as_slice().to_vec()))
        });
        densities.chain(fields).collect()
    }

    /// Frames that the loads of [`MeshScene::marked_values`] belong to or depend on.
    fn marked_frames(&self) -> Vec<Vec<usize>> {
        let of = |own: usize, markers: &[usize]| {
            let frame = |marker: &usize| self.marker_frame(&self.links.markers[*marker]);
            markers.iter().map(frame).chain([own]).collect()
        };
        let densities = self.distributed.all.iter().map(|density| {
            let own = self.bodies[density.spec.body].spec.frame;
            of(own, density.spec.markers)
        });
        let fields = self.dead_loads.specs.iter().filter_map(|load| match load.kind {
            LoadKind::Field { markers } => Some(of(load.frame, markers)),
            _ => None,
        });
        densities.chain(fields).collect()
    }

    /// Whether a density depends on frames that move otherwise than its body's.
    pub(crate) fn is_marked_elsewhere(&self) -> bool {
        let frames = self.marked_frames().into_iter();
        frames
            .into_iter()
            .any(|frames| frames.iter().any(|&frame| frame != frames[0]))
    }

    /// For each of [`MeshScene::marked_values`] whether it depends on time itself.
    pub(crate) fn timed_values(&self, t: f64) -> Vec<bool> {
        let [now, later] = [t, t + A_WHILE].map(|t| self.marked_values(t));
        now.iter().zip(&later).map(|(now, later)| now.1 != later.1).collect()
    }

    /// A load that depends on markers and on time.
    pub(crate) fn timed_load(&self, t: f64) -> Option<&'static str> {
        let timed = self.timed_values(t).into_iter();
        let mut names = self.marked_values(t).into_iter().zip(timed);
        names.find(|(_, timed)| *timed).map(|((name, _), _)| name)
    }

    /// The loads of [`MeshScene::marked_values`] that a displacement, already made, has changed; `timed` is as before.
    pub(crate) fn changed_loads(
        &self,
        t: f64,
        by: &Displacement,
        before: &[(&'static str, Vec<f64>)],
        timed: &[bool],
    ) -> Vec<String> {
        let after = self.marked_values(t + by.later.unwrap_or(0.0));
        let mut names = Vec::new();
        for (place, frames) in self.marked_frames().into_iter().enumerate() {
            let is_looked_at = by.later.is_none_or(|later| (later != 0.0) == timed[place]);
            let ((name, before), (_, after)) = (&before[place], &after[place]);
            let size = before.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
            let mut pairs = before.iter().zip(after);
            let differs = pairs.any(|(a, b)| (a - b).abs() > ROUND_OFF * size || (a - b).is_nan());
            if is_looked_at && differs && frames.iter().any(|&frame| by.moved[frame]) {
                names.push(format!("load `{name}`"));
            }
        }
        names
    }
}
