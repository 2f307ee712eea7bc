//! Free frames that follow the mean axes of a body (THEORY 6, Buckens): linear conditions on its
//! nodal vectors, `d^a (q_a - q0_a) = 0` and `M^ab q0_a x q_b = 0`, kept with multipliers.

use super::line::Line;
use super::parts::BodySpec;
use super::scene::{MeshBody, MeshScene};
use crate::error::ModelError;
use crate::system::ConstraintLevel;
use crate::vector::{Vector, cross};

/// The conditions of one body; divided by its mass, the turning ones by its length, too.
pub(super) struct MeanAxes {
    pub body: usize,
    /// First component of the body.
    pub first: usize,
    /// Coefficients of the body's components, row after row.
    pub rows: Vec<Vec<f64>>,
    /// Values of the rows in the undeformed shape.
    pub undeformed: Vec<f64>,
}

impl MeanAxes {
    /// The conditions from the undeformed shape: `shape` has the body's components.
    pub fn new(index: usize, body: &MeshBody, first: usize, shape: &[f64]) -> Self {
        let spec = &body.spec;
        let (dimension, count) = (spec.dimension(), spec.nodal.len());
        let turns: Vec<Vector> = (0..3)
            .map(|axis| std::array::from_fn(|i| if i == axis { 1.0 } else { 0.0 }))
            .filter(|&turn| dimension == 3 || is_normal(spec, turn))
            .collect();
        let mut rows = vec![vec![0.0; shape.len()]; dimension + turns.len()];
        let mut total = 0.0;
        for element in 0..spec.count {
            let components = body.connectivity.element(element);
            for a in 0..count {
                let mut from = [0.0; 3];
                for c in 0..dimension {
                    from[spec.axes[c]] = shape[components[a * dimension + c] - first];
                }
                for b in 0..count {
                    let mass = body.mass[a * count + b];
                    for c in 0..dimension {
                        let place = components[b * dimension + c] - first;
                        if spec.nodal[a].is_position() {
                            rows[c][place] += mass;
                        }
                        for (row, &turn) in turns.iter().enumerate() {
                            rows[dimension + row][place] += mass * cross(turn, from)[spec.axes[c]];
                        }
                    }
                    if spec.nodal[a].is_position() && spec.nodal[b].is_position() {
                        total += mass;
                    }
                }
            }
        }
        for (place, row) in rows.iter_mut().enumerate() {
            let size = match place.checked_sub(dimension) {
                None => total,
                // The turning about a straight axis has only the inertia of the sections.
                Some(turn) if spec.has_section() => (total * turned(spec, turns[turn], shape, row)).sqrt(),
                Some(_) => total * spec.line.length(),
            };
            row.iter_mut().for_each(|value| *value /= size);
        }
        let undeformed = rows.iter().map(|row| product(row, shape)).collect();
        Self {
            body: index,
            first,
            rows,
            undeformed,
        }
    }

    /// Values of the rows for one of the full arrays.
    fn values<'a>(&'a self, full: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        self.rows
            .iter()
            .map(|row| product(row, &full[self.first..self.first + row.len()]))
    }
}

/// Value of a row when the undeformed body turns about an axis by one: its moment of inertia, kg m^2.
fn turned(spec: &BodySpec, turn: Vector, shape: &[f64], row: &[f64]) -> f64 {
    let vectors = shape.chunks_exact(spec.dimension());
    let moved = vectors.flat_map(|vector| {
        let mut from = [0.0; 3];
        for (value, &axis) in vector.iter().zip(spec.axes) {
            from[axis] = *value;
        }
        let moved = cross(turn, from);
        spec.axes.iter().map(move |&axis| moved[axis])
    });
    row.iter().zip(moved).map(|(row, moved)| row * moved).sum()
}

fn is_normal(spec: &BodySpec, turn: Vector) -> bool {
    spec.axes.iter().all(|&axis| turn[axis] == 0.0)
}

fn product(row: &[f64], values: &[f64]) -> f64 {
    row.iter().zip(values).map(|(a, b)| a * b).sum()
}

/// Refuses mean axes of a body whose frame cannot follow them, or that do not tie its frame.
pub(super) fn check(spec: &BodySpec, frame: &str, unknowns: usize) -> Result<(), ModelError> {
    if spec.dimension() == 3 && !spec.has_section() && matches!(spec.line, Line::Straight { .. }) {
        return Err(ModelError::new(format!(
            "body `{}` is straight: its mean axes do not tie the turning of frame `{frame}` about its line: use joints to the frame, or a curved line",
            spec.label()
        )));
    }
    let needed = if spec.dimension() == 2 { 3 } else { 6 };
    if unknowns == needed {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "body `{}` ties frame `{frame}` to its mean axes, which needs {needed} free motions, and the frame has {unknowns}: free it along and about all axes",
        spec.label()
    )))
}

impl MeshScene {
    /// Rows of all mean axes at the loaded state.
    pub(super) fn mean_axes_rows(&self, level: ConstraintLevel, out: &mut [f64]) {
        let buffers = &self.buffers;
        let full = match level {
            ConstraintLevel::Position => &buffers.q,
            ConstraintLevel::Velocity => &buffers.v,
            ConstraintLevel::Acceleration => &buffers.a,
            ConstraintLevel::Jerk => &buffers.jerks,
        };
        let mut place = 0;
        for axes in &self.mean_axes {
            for (value, undeformed) in axes.values(full).zip(&axes.undeformed) {
                out[place] = if level == ConstraintLevel::Position {
                    value - undeformed
                } else {
                    value
                };
                place += 1;
            }
        }
    }

    /// Adds the Jacobians of all mean axes from column `column` on.
    pub(super) fn mean_axes_jacobian(&self, mut column: usize, values: &mut [f64]) {
        for axes in &self.mean_axes {
            for row in &axes.rows {
                for (place, value) in row.iter().enumerate() {
                    if let Some((unknown, factor)) = self.layout.unknown(axes.first + place)
                        && let Some(entry) = self.constraint_pattern.find(unknown, column)
                    {
                        values[entry] += factor * value;
                    }
                }
                column += 1;
            }
        }
    }
}
