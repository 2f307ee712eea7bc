//! That meshes are too coarse, in sentences that name them.

use super::marks::MORE;
use crate::app::writing::numbers::digits;
use crate::model::{DescribedBody, Fidelity};

/// Most bodies in the sentence.
const MOST: usize = 3;

/// The meshes of a scene in a sentence on finer ones.
pub(in crate::app) struct Meshes {
    /// Bodies that deform or are loaded along their axes, with their elements.
    pub names: String,
    /// What else may be too little, how else the finer ones differ, and what else helps, where some are described by modes.
    pub too: &'static str,
    pub how: &'static str,
    pub more: &'static str,
}

impl Meshes {
    /// Of the bodies of a scene.
    pub fn of(bodies: &[DescribedBody]) -> Self {
        let mut in_modes = false;
        let mut meshes: Vec<String> = Vec::new();
        for body in bodies {
            let deforms = !matches!(body.fidelity, Fidelity::Rigid | Fidelity::Point);
            if !deforms && !body.is_loaded {
                continue;
            }
            meshes.push(if body.fidelity == Fidelity::Full {
                format!("`{}` ({})", body.name, body.elements)
            } else {
                in_modes |= deforms;
                format!("`{}` ({}, {})", body.name, body.elements, body.fidelity)
            });
        }
        let others = meshes.len().saturating_sub(MOST);
        if others > 0 {
            meshes.truncate(MOST);
            meshes.push(format!("{others} more"));
        }
        let [too, how, more] = if in_modes {
            [
                ", or the modes are too few",
                " and without modes",
                ", or leave `modal` or `small` out",
            ]
        } else {
            [""; 3]
        };
        Self {
            names: meshes.join(", "),
            too,
            how,
            more,
        }
    }
}

/// That the meshes of bodies are too coarse for `what`, as far as it was compared.
pub(in crate::app) fn on_meshes(bodies: &[DescribedBody], (what, until): (&str, Option<f64>), outputs: &str) -> String {
    let Meshes { names, too, how, more } = Meshes::of(bodies);
    let until = until.map_or(String::new(), |t| format!(" until {} s", time(t)));
    format!(
        "The mesh is too coarse for {what}{too}: with twice as many elements{how} in {names} outputs differ{until} by parts of their largest change or value, {outputs}. {MORE}{more}."
    )
}

/// A time in s: three decimals, or where these tell little, as many digits.
pub(super) fn time(t: f64) -> String {
    if t.abs() < 0.1 { digits(t, 3) } else { format!("{t:.3}") }
}
