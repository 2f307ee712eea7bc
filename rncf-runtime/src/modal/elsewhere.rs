//! Bodies in modes that come from elsewhere.

use crate::model::Warning;
use crate::space::Vector;

/// Part of the motion of an interface that modes may lack without a word.
const LACKING: f64 = 0.02;

/// What is known of a body from elsewhere beside its modes.
#[derive(Clone, Debug)]
pub(super) struct Elsewhere {
    /// Of every mode the displacement and the rotation of each interface.
    pub motions: Vec<Vec<[Vector; 2]>>,
    /// What the modes lack of these by forces and moments at the interfaces, rows first.
    pub lacking: Option<Vec<f64>>,
    /// Names of the interfaces.
    pub names: Vec<&'static str>,
    /// What is to be told of it.
    pub notes: Vec<String>,
}

impl Elsewhere {
    /// How far the interfaces move with modal coordinates: displacement and rotation.
    pub fn moved(&self, p: &[f64]) -> Vec<[Vector; 2]> {
        let mut moved = vec![[Vector::zeros(); 2]; self.names.len()];
        for (mode, p) in self.motions.iter().zip(p) {
            for (moved, motion) in moved.iter_mut().zip(mode) {
                (0..2).for_each(|kind| moved[kind] += *p * motion[kind]);
            }
        }
        moved
    }

    /// That the modes of a body are too few for the forces and moments at its interfaces, where they are.
    pub fn told_of_modes(&self, body: &str, p: &[f64], acting: &[[Vector; 2]]) -> Option<Warning> {
        let lacking = self.lacking.as_ref()?;
        let acting: Vec<f64> = acting
            .iter()
            .flatten()
            .flat_map(|vector| vector.iter().copied())
            .collect();
        let n = acting.len();
        let lost = |row: usize| {
            (0..n)
                .map(|column| lacking[row * n + column] * acting[column])
                .sum::<f64>()
        };
        let lost: Vec<[Vector; 2]> = (0..self.names.len())
            .map(|interface| [0, 3].map(|first| Vector::from_fn(|axis, _| lost(6 * interface + first + axis))))
            .collect();
        let moved = self.moved(p);
        let parts = [0, 1].map(|kind| {
            let whole = moved
                .iter()
                .zip(&lost)
                .map(|(moved, lost)| (moved[kind] + lost[kind]).norm());
            let whole = whole.fold(0.0, f64::max);
            let most = lost.iter().map(|lost| lost[kind].norm()).enumerate();
            let (interface, most) = most.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
            (most / whole, most, interface, kind)
        });
        let (part, size, interface, kind) = parts
            .into_iter()
            .filter(|part| part.0 > LACKING)
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        let size = match kind {
            0 => format!("moves by {size:.2e} m"),
            _ => format!("turns by {:.2e} deg", size.to_degrees()),
        };
        Some(Warning {
            text: format!(
                "body `{body}`: its modes are too few for the forces at its interfaces, of which `{}` {size} less than with the matrices of its file, {:.0} % of how far interfaces do: take more, or `interface_modes;`, which know such forces",
                self.names[interface],
                100.0 * part
            ),
            weight: part,
        })
    }
}
