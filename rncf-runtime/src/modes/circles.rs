//! Modes of one frequency, turned to those that go on circles.
//!
//! Of modes that have the same eigenvalue every combination is a mode. Of a round rotor some meet at certain speeds, and of a thin
//! disc the two tilts at every one: what comes out of an eigenvalue problem is any two combinations of forward and backward.
//! An observer who does not turn sees these at different frequencies, so each has to stand by itself.

use super::mode::{Mode, shape};
use super::pair::normalise;
use crate::linalg::{c64, natural_modes};
use crate::model::{Scene, Uniform};
use crate::system::State;

/// Distance of eigenvalues, as part of them, that is none.
const EQUAL: f64 = 1e-8;
/// What two modes share of the circulation, as part of their energies, that is nothing.
const APART: f64 = 1e-6;
/// More than any circulation, in kinetic energies: that of a tilt has twice the energy of a thin disc.
const MOST: f64 = 10.0;
/// Part of a vector that is its own beside others: the rest is round-off.
const OWN: f64 = 1e-3;

/// Turns every group of modes of one eigenvalue; they stand in the order of their numbers.
pub(super) fn turn_to_circles(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    (modes, sizes): (&mut [Mode], &[f64]),
) {
    let mut first = 0;
    while first < modes.len() {
        let is_same = |pair: &[Mode]| {
            let (a, b) = (c64::new(pair[0].re, pair[0].im), c64::new(pair[1].re, pair[1].im));
            pair[0].im > 0.0 && (a - b).norm() <= EQUAL * a.norm()
        };
        let count = 1 + modes[first..].windows(2).take_while(|pair| is_same(pair)).count();
        if count > 1 {
            turn(scene, at, state, (&mut modes[first..first + count], sizes));
        }
        first += count;
    }
}

/// Turns modes of one eigenvalue: those in which most goes round with the spin first.
fn turn(scene: &mut dyn Scene, at: &Uniform, state: &State, (modes, sizes): (&mut [Mode], &[f64])) {
    let count = modes.len();
    let shapes: Vec<Vec<c64>> = modes.iter().map(|mode| relative(&mode.shape, sizes)).collect();
    let Some([turning, whole]) = forms(scene, at, state, &shapes, sizes) else {
        return;
    };
    let shares = |row: usize, column: usize| {
        let energies = whole[row * count + row].re * whole[column * count + column].re;
        turning[row * count + column].norm() > APART * energies.max(0.0).sqrt()
    };
    if !(0..count).any(|row| (0..row).any(|column| shares(row, column))) {
        return;
    }
    // Of ascending circulation, each vector twice: with a real factor, and with an imaginary one.
    let shifted: Vec<c64> = turning
        .iter()
        .zip(&whole)
        .map(|(turning, whole)| MOST * *whole - *turning)
        .collect();
    let Ok(found) = natural_modes(2 * count, &real(count, &shifted), &real(count, &whole), 2 * count) else {
        return;
    };
    let mut chosen: Vec<Vec<c64>> = Vec::with_capacity(count);
    for vector in found.vectors {
        let mut own: Vec<c64> = (0..count).map(|at| c64::new(vector[at], vector[count + at])).collect();
        for other in &chosen {
            let part = product(&whole, other, &own);
            own.iter_mut().zip(other).for_each(|(own, other)| *own -= part * *other);
        }
        let size = product(&whole, &own, &own).re.max(0.0).sqrt();
        if chosen.len() < count && size > OWN {
            own.iter_mut().for_each(|own| *own /= size);
            chosen.push(own);
        }
    }
    if chosen.len() < count {
        return;
    }
    for (mode, parts) in modes.iter_mut().zip(&chosen) {
        let mut x = combined(&shapes, parts);
        normalise(&mut x, &mut []);
        mode.shape = shape(&x, sizes);
    }
}

/// The forms of the circulation and of the energy between all pairs of shapes, row by row, from those of their sums; `None` where nothing spins.
fn forms(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    shapes: &[Vec<c64>],
    sizes: &[f64],
) -> Option<[Vec<c64>; 2]> {
    let count = shapes.len();
    let mut of = |parts: &[c64]| {
        let sums = scene.circulating(at, state, &shape(&combined(shapes, parts), sizes))?;
        Some([sums.turning, sums.whole])
    };
    let unit = |row: usize, column: usize, factor: c64| {
        let mut parts = vec![c64::default(); count];
        parts[row] = c64::new(1.0, 0.0);
        parts[column] += factor;
        parts
    };
    let mut forms = [(); 2].map(|()| vec![c64::default(); count * count]);
    for row in 0..count {
        let own = of(&unit(row, row, c64::default()))?;
        for (form, own) in forms.iter_mut().zip(own) {
            form[row * count + row] = c64::new(own, 0.0);
        }
    }
    for row in 0..count {
        for column in 0..row {
            let re = of(&unit(row, column, c64::new(1.0, 0.0)))?;
            let im = of(&unit(row, column, c64::new(0.0, 1.0)))?;
            for (at, form) in forms.iter_mut().enumerate() {
                let own = form[row * count + row].re + form[column * count + column].re;
                let value = c64::new(0.5 * (re[at] - own), 0.5 * (own - im[at]));
                form[row * count + column] = value;
                form[column * count + row] = value.conj();
            }
        }
    }
    Some(forms)
}

/// A Hermitian matrix as one of real numbers, of twice the size.
fn real(count: usize, form: &[c64]) -> Vec<f64> {
    let mut all = vec![0.0; 4 * count * count];
    for row in 0..count {
        for column in 0..count {
            let value = form[row * count + column];
            let mut put = |row: usize, column: usize, value: f64| all[row * 2 * count + column] = value;
            put(row, column, value.re);
            put(count + row, count + column, value.re);
            put(count + row, column, value.im);
            put(row, count + column, -value.im);
        }
    }
    all
}

/// `conj(a) . A b`.
fn product(form: &[c64], a: &[c64], b: &[c64]) -> c64 {
    let count = a.len();
    let mut sum = c64::default();
    for row in 0..count {
        for column in 0..count {
            sum += a[row].conj() * form[row * count + column] * b[column];
        }
    }
    sum
}

fn combined(shapes: &[Vec<c64>], parts: &[c64]) -> Vec<c64> {
    let mut sum = vec![c64::default(); shapes[0].len()];
    for (shape, &part) in shapes.iter().zip(parts) {
        sum.iter_mut().zip(shape).for_each(|(sum, value)| *sum += part * *value);
    }
    sum
}

/// A shape in sizes of the unknowns.
fn relative(shape: &[[f64; 2]], sizes: &[f64]) -> Vec<c64> {
    let parts = shape.iter().zip(sizes);
    parts.map(|([re, im], size)| c64::new(re / size, im / size)).collect()
}
