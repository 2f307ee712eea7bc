//! Meshes that are too coarse for what their bodies do: the energy of the error of their elements, as the scene estimates it.

use super::marks::{MORE, percent};
use crate::archive::{Archive, Keep};
use crate::equilibrium::Uniform;
use crate::model::{MeshError, SectionBody};
use crate::{Scene, State};

/// Part of a body's energy from which on its error is told.
const TOLD: f64 = 0.01;
/// Part of the energy of all bodies below which a body does not count.
const COUNTS: f64 = 0.01;
/// Part of its largest energy above which the energy of a body at a moment is much.
const MUCH: f64 = 0.1;
/// Looks at a run, and moments of it that are judged.
const LOOKS: f64 = 50.0;
const KEPT: usize = 4;
/// Newton iterations of the run for each of them.
const SHARE: u64 = 100;
/// Most bodies in the sentence.
const MOST: usize = 3;

/// The moments of a run at which its bodies hold most energy: their meshes are judged when it has ended.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct Coarseness {
    kept: Vec<(f64, State)>,
    /// When the next look is due, s.
    due: f64,
}

impl Coarseness {
    /// Writes or reads it; states are those of the system of another one.
    pub fn keep(&mut self, of: &State, archive: &mut Archive<'_>) {
        let mut count = self.kept.len();
        count.keep(archive);
        if archive.is_reading() {
            self.kept = vec![(0.0, of.clone()); count.min(KEPT)];
        }
        for (energy, state) in &mut self.kept {
            energy.keep(archive);
            state.keep(archive);
        }
        self.due.keep(archive);
    }

    /// Looks at a row of a run of `t_end`, s, from time to time.
    pub fn meet(&mut self, scene: &mut dyn Scene, state: &State, t_end: f64) {
        if state.t < self.due {
            return;
        }
        self.due = state.t + t_end / LOOKS * (1.0 - 1e-9);
        let energy = scene.elastic_energy(state);
        if self.kept.len() < KEPT {
            self.kept.push((energy, state.clone()));
        } else if let Some(least) = self.kept.iter_mut().min_by(|a, b| a.0.total_cmp(&b.0))
            && energy > least.0
        {
            least.0 = energy;
            least.1.clone_from(state);
        }
    }

    /// One sentence where meshes are too coarse, after so many Newton iterations of the run.
    pub fn warning(&self, scene: &mut dyn Scene, iterations: u64) -> Option<String> {
        // To judge a moment costs as much as two iterations.
        let most = (iterations / SHARE).clamp(1, KEPT as u64) as usize;
        let mut kept: Vec<&(f64, State)> = self.kept.iter().collect();
        kept.sort_by(|a, b| b.0.total_cmp(&a.0));
        let looks = kept.into_iter().take(most).map(|(_, state)| {
            let mut found = Vec::new();
            scene.mesh_errors(state, &mut found);
            found
        });
        let looks: Vec<Vec<MeshError>> = looks.collect();
        told(scene, &looks)
    }
}

/// One sentence where meshes are too coarse in an equilibrium.
pub(in crate::app) fn of_equilibrium(scene: &mut dyn Scene, at: &Uniform, state: &State) -> Option<String> {
    let mut found = Vec::new();
    scene.uniform_mesh_errors(at, state, &mut found);
    told(scene, &[found])
}

/// Largest energy of a body, J, and the largest part of it that is error, of moments at which it has much energy.
fn worst(looks: &[Vec<MeshError>], body: usize) -> (f64, f64) {
    let seen = || looks.iter().filter_map(|look| look.get(body));
    let energy = seen().map(|of| of.energy).fold(0.0, f64::max);
    let counts = seen().filter(|of| of.energy > MUCH * energy);
    (energy, counts.map(|of| of.error / of.energy).fold(0.0, f64::max))
}

fn told(scene: &dyn Scene, looks: &[Vec<MeshError>]) -> Option<String> {
    let bodies = scene.section_bodies();
    let worst: Vec<(f64, f64)> = (0..bodies.len()).map(|body| worst(looks, body)).collect();
    let all: f64 = worst.iter().map(|of| of.0).sum();
    let mut told: Vec<(f64, &SectionBody)> = bodies
        .iter()
        .zip(&worst)
        .filter(|&(_, &(energy, part))| part > TOLD && energy > COUNTS * all)
        .map(|(body, &(_, part))| (part, body))
        .collect();
    told.sort_by(|a, b| b.0.total_cmp(&a.0));
    let names: Vec<String> = told
        .iter()
        .map(|(part, body)| format!("{} of {}", percent(*part), named(body)))
        .collect();
    Some(format!(
        "The mesh is too coarse for how it deforms: {} is not deformation but error of the elements (parts of the strain energy). Deflections under given loads are too small by up to such a part and frequencies too high by half of it, forces of given deflections too large. {MORE}.",
        listed(names, "more bodies")?
    ))
}

/// One sentence where the meshes of bodies make frequencies too high, by these parts for every mode and body.
pub(in crate::app) fn of_modes(scene: &dyn Scene, errors: &[Vec<f64>]) -> Option<String> {
    let bodies = scene.section_bodies();
    let told = errors.iter().enumerate().filter_map(|(mode, errors)| {
        let all: f64 = errors.iter().sum();
        let (body, _) = bodies.iter().zip(errors).max_by(|a, b| a.1.total_cmp(b.1))?;
        (all > 0.5 * TOLD).then_some((mode, all, body))
    });
    let told: Vec<(usize, f64, &SectionBody)> = told.collect();
    let sentence = |&(mode, part, _): &(usize, f64, &SectionBody)| format!("of mode {} by {}", mode + 1, percent(part));
    let frequencies = listed(told.iter().map(sentence).collect(), "more modes")?;
    let mut names: Vec<String> = Vec::new();
    for name in told.iter().map(|(_, _, body)| named(body)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    Some(format!(
        "The mesh is too coarse for these modes: the frequency {frequencies} is too high, for {}. {MORE}.",
        listed(names, "more bodies")?
    ))
}

fn named(body: &SectionBody) -> String {
    let elements = body.elements;
    format!(
        "`{}` ({elements} element{})",
        body.name,
        if elements == 1 { "" } else { "s" }
    )
}

/// The first of some parts of a sentence, and how many more there are; `None` without any.
fn listed(mut parts: Vec<String>, more: &str) -> Option<String> {
    let others = parts.len().saturating_sub(MOST);
    if others > 1 {
        parts.truncate(MOST);
        parts.push(format!("{others} {more}"));
    }
    let last = parts.pop()?;
    Some(if parts.is_empty() {
        last
    } else {
        format!("{} and {last}", parts.join(", "))
    })
}
