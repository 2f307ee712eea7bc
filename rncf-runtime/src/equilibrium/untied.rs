//! Motions that nothing ties and that no force resists at a state: the spin of a rod that hangs on a ball joint. They are found
//! as the null space of the stiffness on what the constraints leave free, by inverse iteration, and count where they
//! move every body as a whole.

use super::newton::{Newton, Untied};
use crate::linalg::{norm, normalise, reduce};
use crate::model::{Kind, Scene, Uniform};
use crate::system::State;

/// Shift of the inverse iteration, in parts of the stiffness of the rows: above round-off, below what is soft.
const SHIFT: f64 = 1e-13;
/// Part of the amplification by the shift alone from which on a direction has no stiffness.
const NULL: f64 = 0.1;
/// How far a direction of unit size is moved that has stiffness, and the part of the stiffness of the rows by which it is held that drifts along what is
/// known as neutral.
const MOVED: f64 = 1e3;
const HELD: f64 = 1e-6;
/// Amplification of a load from which on the stiffness is looked at.
const DOUBTFUL: f64 = 1e11;
const ITERATIONS: usize = 6;
/// Directions that are looked at together first.
const BLOCK: usize = 8;
/// Entries of a direction below this, relative to the largest one, are round-off.
const NEGLIGIBLE: f64 = 1e-9;

impl Newton {
    /// Whether the matrix that was factored last may be singular.
    pub(super) fn is_doubtful(&mut self) -> bool {
        let mut image = vec![0.0; self.lu.pattern().columns()];
        for (row, stiffness) in self.stiffnesses().into_iter().enumerate() {
            image[row] = sign(row, 0) * stiffness / self.inverse_sizes[row];
        }
        self.solve_with(&mut image);
        let parts = image.iter().zip(&self.inverse_sizes);
        let largest = parts.fold(0.0, |largest: f64, (x, inverse)| largest.max((x * inverse).abs()));
        largest.is_nan() || largest > DOUBTFUL
    }

    /// What nothing ties or resists at the state, beside what the scene knows as neutral; without `is_alone` also what drifts along that, for Newton's
    /// iteration holds both.
    pub(super) fn untied(scene: &mut dyn Scene, at: &Uniform, state: &State, is_alone: bool) -> Vec<Untied> {
        let mut newton = Newton::new(scene);
        let mut state = state.clone();
        state.rebase(scene.turns());
        newton.hold(scene, at, &state);
        newton.linearize(scene, at, &mut state);
        let metric = newton.stiffnesses();
        for (row, stiffness) in metric.iter().enumerate() {
            if let Some(place) = newton.lu.pattern().find(row, row) {
                newton.values[place] += SHIFT * stiffness;
            }
        }
        if !newton.values.iter().all(|value| value.is_finite()) || newton.factor().is_err() {
            return Vec::new();
        }
        let n = metric.len();
        let mut count = BLOCK.min(n);
        loop {
            let (found, is_all) = newton.null_space(&metric, count, is_alone);
            if is_all {
                let found = apart(found, &newton.inverse_sizes).into_iter();
                let told = |direction: Vec<f64>| {
                    let told = scene.untied_motion(at, &state, &direction)?;
                    Some(Untied { direction, told })
                };
                return found.filter_map(told).collect();
            }
            count = (2 * count).min(n);
        }
    }

    /// Among `count` directions those without stiffness, and whether there are no others.
    fn null_space(&mut self, metric: &[f64], count: usize, is_alone: bool) -> (Vec<Vec<f64>>, bool) {
        let (n, rows) = (metric.len(), self.lu.pattern().columns());
        let roots: Vec<f64> = metric.iter().map(|weight| weight.sqrt()).collect();
        let weighted = |x: &[f64]| -> Vec<f64> { x.iter().zip(&roots).map(|(x, root)| x * root).collect() };
        // In coordinates in which the metric is the identity.
        let mut directions: Vec<Vec<f64>> = (0..count).map(|k| (0..n).map(|row| sign(row, k)).collect()).collect();
        let mut amplified = vec![0.0; count];
        let amplify = |newton: &mut Self, direction: &[f64]| {
            let mut image = weighted(direction);
            image.resize(rows, 0.0);
            newton.solve_with(&mut image);
            image
        };
        for _ in 0..ITERATIONS {
            for direction in &mut directions {
                *direction = weighted(&amplify(self, direction)[..n]);
            }
            for k in 0..count {
                let (known, rest) = directions.split_at_mut(k);
                amplified[k] = reduce(&mut rest[0], known);
                normalise(&mut rest[0]);
            }
        }
        let is_null = amplified.iter().map(|factor| factor * SHIFT > NULL);
        let found = directions.iter().zip(is_null).filter(|(_, is_null)| *is_null);
        let found: Vec<Vec<f64>> = found.map(|(direction, _)| direction.clone()).collect();
        let is_all = found.len() < count || count == n;
        // What is moved, and what holds it: of a direction without stiffness nothing.
        let pushed = |direction: &Vec<f64>| {
            let image = amplify(self, direction);
            let held = self.phases.iter().zip(&image[rows - self.phases.len()..]);
            let mut forces = vec![0.0; n];
            for (phase, held) in held {
                let parts = forces.iter_mut().zip(phase);
                parts.for_each(|(force, part)| *force += held * part);
            }
            let moved = weighted(&image[..n]).into_iter().zip(direction);
            let moved = moved.map(|(image, x)| (SHIFT * image - x) / MOVED);
            let forces = forces.iter().zip(&roots);
            moved
                .chain(forces.map(|(force, root)| SHIFT * force / root / HELD))
                .collect()
        };
        let found = if is_alone {
            let images = found.iter().map(pushed).collect();
            unmoved(found, images)
        } else {
            found
        };
        let unscaled = |direction: Vec<f64>| direction.iter().zip(&roots).map(|(x, root)| x / root).collect();
        (found.into_iter().map(unscaled).collect(), is_all)
    }

    /// Stiffness of every row relative to the sizes of the unknowns, at least a small part of the largest one.
    fn stiffnesses(&self) -> Vec<f64> {
        let inverse = &self.inverse_sizes;
        let mut energies = vec![0.0_f64; inverse.len()];
        for (&(row, column), value) in self.columns.iter().zip(&self.tangent.stiffness) {
            energies[row] = energies[row].max((value / (inverse[row] * inverse[column])).abs());
        }
        let floored = energies.iter().zip(inverse).zip(&self.is_state);
        // Where nothing is stiff any scale will do. Rates of states are no stiffnesses, and each has a unit of its own.
        let moving = floored.clone().filter(|(_, is_state)| !**is_state);
        let largest = moving.fold(0.0, |largest: f64, ((&energy, _), _)| largest.max(energy));
        let least = if largest > 0.0 { 1e-6 * largest } else { 1.0 };
        floored
            .map(|((&energy, inverse), is_state)| match is_state {
                false => energy.max(least) * inverse * inverse,
                true if energy > 0.0 => energy * inverse * inverse,
                true => 1.0,
            })
            .collect()
    }
}

/// The directions of a space that have no image to speak of: what bends under forces that follow it drifts along a motion without stiffness, and is
/// amplified with it.
fn unmoved(mut directions: Vec<Vec<f64>>, mut images: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    loop {
        let sizes = images.iter().map(|image| norm(image)).enumerate();
        let Some((farthest, size)) = sizes.max_by(|a, b| a.1.total_cmp(&b.1)) else {
            return directions;
        };
        if size <= 1.0 {
            return directions;
        }
        let (moved, image) = (directions.remove(farthest), images.remove(farthest));
        for (direction, own) in directions.iter_mut().zip(&mut images) {
            let part = own.iter().zip(&image).map(|(a, b)| a * b).sum::<f64>() / (size * size);
            let without = |x: &mut Vec<f64>, y: &[f64]| x.iter_mut().zip(y).for_each(|(x, y)| *x -= part * y);
            without(direction, &moved);
            without(own, &image);
        }
    }
}

/// The motions at the state that nothing ties, one sentence each; at rest also those that the scene knows as neutral. What
/// turns is expected to have its phase free.
pub fn untied(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Vec<String> {
    let neutral = match at.kind {
        Kind::Static => scene.neutral_motions(at, state),
        Kind::Steady => Vec::new(),
    };
    let mut told: Vec<String> = neutral
        .iter()
        .filter_map(|motion| scene.untied_motion(at, state, motion))
        .collect();
    told.extend(
        Newton::untied(scene, at, state, true)
            .into_iter()
            .map(|motion| motion.told),
    );
    let sentence =
        |told| format!("{told}: it stays where it was at the start, and outputs that see it are as arbitrary");
    told.into_iter().map(sentence).collect()
}

/// The motions at the state that nothing ties: of each the velocities of all unknowns, in their units and in the frames in which these stand, the
/// largest over the size of its unknown being 1.
pub fn untied_directions(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Vec<Vec<f64>> {
    let found = Newton::untied(scene, at, state, true).into_iter();
    found.map(|motion| motion.direction).collect()
}

/// 1 or -1, the same on every machine, without a pattern in the row.
fn sign(row: usize, k: usize) -> f64 {
    let mut bits =
        (row as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ (k as u64 + 1).wrapping_mul(0xD1B5_4A32_D192_ED03);
    bits = (bits ^ (bits >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    if (bits >> 40) & 1 == 0 { 1.0 } else { -1.0 }
}

/// The same space in directions of as few unknowns as can be: what moves independently stands in one each.
fn apart(mut directions: Vec<Vec<f64>>, inverse_sizes: &[f64]) -> Vec<Vec<f64>> {
    let count = directions.len();
    for k in 0..count {
        let weighted =
            |directions: &[Vec<f64>], row: usize, place: usize| (directions[row][place] * inverse_sizes[place]).abs();
        let entries = (k..count).flat_map(|row| (0..inverse_sizes.len()).map(move |place| (row, place)));
        let largest =
            entries.max_by(|&(i, a), &(j, b)| weighted(&directions, i, a).total_cmp(&weighted(&directions, j, b)));
        let Some((row, pivot)) = largest else { break };
        directions.swap(k, row);
        let own = directions[k].clone();
        for (other, direction) in directions.iter_mut().enumerate() {
            if other != k && own[pivot] != 0.0 {
                let part = direction[pivot] / own[pivot];
                direction.iter_mut().zip(&own).for_each(|(x, own)| *x -= part * own);
            }
        }
    }
    for direction in &mut directions {
        let size = |x: f64, inverse: f64| (x * inverse).abs();
        let largest = direction
            .iter()
            .zip(inverse_sizes)
            .fold(0.0, |largest: f64, (&x, &inverse)| largest.max(size(x, inverse)));
        for (x, &inverse) in direction.iter_mut().zip(inverse_sizes) {
            *x = if size(*x, inverse) <= NEGLIGIBLE * largest {
                0.0
            } else {
                *x / largest
            };
        }
    }
    directions
}
