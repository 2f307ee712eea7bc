//! Whether a direction of the unknowns moves every body as a whole, and how that is told.

use crate::linalg::symmetric_eigen;
use crate::model::Uniform;
use crate::scene::MeshScene;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::space::Vector;
use crate::system::{State, System};

/// Part of the velocities of a body that may deform it.
const ROUND_OFF: f64 = 1e-6;
/// Part of the largest stiffness of the fit below which a motion is not seen, as the spin of a straight line.
const UNSEEN: f64 = 1e-12;
/// Part of the largest motion below which a body rests.
const RESTING: f64 = 1e-3;

/// Velocity field of a rigid body, in the axes of a frame.
struct Screw {
    /// Angular velocity, and velocity of the centre of the nodes.
    turn: Vector,
    shift: Vector,
    center: Vector,
    /// Largest distance of a node from the centre, m.
    reach: f64,
    /// Largest velocity of a node.
    size: f64,
}

impl MeshScene {
    /// What a direction of the unknowns moves, in the user's words; `None` where it deforms a body.
    pub(crate) fn moved_as_wholes(&mut self, at: &Uniform, state: &State, motion: &[f64]) -> Option<String> {
        self.load_uniform(at, state);
        let mut rates = vec![0.0; self.layout.components()];
        self.layout.expand(motion, &mut rates);
        let mut screws = Vec::new();
        for body in &self.bodies {
            screws.push((body, self.screw(body, &rates)?));
        }
        let largest = screws
            .iter()
            .fold(0.0, |largest: f64, (_, screw)| largest.max(screw.size));
        screws.retain(|(_, screw)| screw.size > RESTING * largest);
        screws.sort_by(|(_, a), (_, b)| b.size.total_cmp(&a.size));
        let Some((body, screw)) = screws.first() else {
            let weighted = |unknown: usize| (motion[unknown] / self.tabulated.sizes[unknown]).abs();
            let moved = (0..motion.len()).max_by(|&a, &b| weighted(a).total_cmp(&weighted(b)))?;
            return Some(format!("nothing holds {}", System::describe_unknown(self, moved)));
        };
        let with = match screws.len() {
            1 => String::new(),
            2 => format!(" with `{}`", screws[1].0.spec.label()),
            more => format!(" with `{}` and {} more", screws[1].0.spec.label(), more - 2),
        };
        let rounded = |vector: Vector| vector.map(|x| (1e3 * x).round() / 1e3 + 0.0);
        let told = |vector: Vector| {
            let [x, y, z]: [f64; 3] = rounded(vector).into();
            format!("[{x}, {y}, {z}]")
        };
        let how = if screw.turn.norm() * screw.reach > RESTING * screw.size {
            let axis = screw.turn / screw.turn.norm();
            let through = screw.center + screw.turn.cross(&screw.shift) / screw.turn.norm_squared();
            format!("turning about {} through {} m", told(signed(axis)), told(through))
        } else {
            format!("shifting along {}", told(signed(screw.shift / screw.shift.norm())))
        };
        Some(format!(
            "nothing holds body `{}`{with} against {how}",
            body.spec.label()
        ))
    }

    /// The rigid motion of a body's nodal vectors with the given rates; `None` where they deform it.
    fn screw(&self, body: &MeshBody, rates: &[f64]) -> Option<Screw> {
        let vectors = body.spec.vectors();
        let place = |vector: usize| self.layout.offset(body.first_vector + vector);
        let at = |full: &[f64], vector: usize| self.vector_at(body, full, place(vector));
        let is_position = |vector: usize| body.whole_mass.is_position(vector);
        let positions = || (0..vectors).filter(|&vector| is_position(vector));
        let q = &self.buffers.q;
        let center = positions().map(|vector| at(q, vector)).sum::<Vector>() / positions().count().max(1) as f64;
        let reach = positions().fold(0.0, |reach: f64, vector| reach.max((at(q, vector) - center).norm()));
        if reach == 0.0 {
            return None;
        }
        // Rows of `rate = shift + turn x arm`, lengths in parts of the reach.
        let rows: Vec<([f64; 6], f64)> = (0..vectors)
            .flat_map(|vector| {
                let (value, rate) = (at(q, vector), at(rates, vector));
                let (arm, rate, shifts) = if is_position(vector) {
                    ((value - center) / reach, rate / reach, 1.0)
                } else {
                    (value, rate, 0.0)
                };
                (0..3).map(move |axis| {
                    let unit = Vector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
                    let turns = arm.cross(&unit);
                    let shift = shifts * unit;
                    ([shift.x, shift.y, shift.z, turns.x, turns.y, turns.z], rate[axis])
                })
            })
            .collect();
        let mut normal = vec![0.0; 36];
        let mut right = [0.0; 6];
        for (row, rate) in &rows {
            for i in 0..6 {
                right[i] += row[i] * rate;
                for j in 0..6 {
                    normal[6 * i + j] += row[i] * row[j];
                }
            }
        }
        let (values, modes) = symmetric_eigen(6, &normal).ok()?;
        let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(*value));
        let mut fit = [0.0; 6];
        for (value, mode) in values.iter().zip(&modes) {
            if *value > UNSEEN * largest {
                let part: f64 = mode.iter().zip(&right).map(|(a, b)| a * b).sum();
                fit.iter_mut()
                    .zip(mode)
                    .for_each(|(sum, entry)| *sum += part / value * entry);
            }
        }
        let (mut left, mut whole) = (0.0, 0.0);
        for (row, rate) in &rows {
            let fitted: f64 = row.iter().zip(&fit).map(|(a, b)| a * b).sum();
            left += (rate - fitted).powi(2);
            whole += rate.powi(2);
        }
        let size = (0..vectors).fold(0.0, |size: f64, vector| size.max(at(rates, vector).norm()));
        (left <= ROUND_OFF * ROUND_OFF * whole).then(|| Screw {
            turn: Vector::new(fit[3], fit[4], fit[5]),
            shift: reach * Vector::new(fit[0], fit[1], fit[2]),
            center,
            reach,
            size,
        })
    }
}

/// The direction or its opposite: the largest component is positive.
fn signed(direction: Vector) -> Vector {
    let largest = direction.iamax();
    if direction[largest] < 0.0 {
        -direction
    } else {
        direction
    }
}
