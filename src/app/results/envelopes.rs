//! Envelopes: the largest section forces, moments and stresses of every flexible body over the rows and steps of a run or over
//! a path of equilibria, and where the material yields.

use super::history::Column;
use crate::app::writing::numbers::{digits, short, with_prefix};
use crate::app::writing::sentences::listed;
use crate::archive::{Archive, Keep};
use crate::equilibrium::Uniform;
use crate::model::{SectionBody, SectionState};
use crate::{Scene, State};

/// [`BodyEnvelope::stress_name`] where bending is left out.
pub(in crate::app) const AXIAL: &str = "stress of the axial force alone";

/// The largest magnitude of something, and where.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Value with its sign, SI.
    pub value: f64,
    /// Where in the first column of the history: time, spin or value of a param.
    pub at: f64,
    /// Arclength of the stress-free axis, m.
    pub x: f64,
}

/// Envelope of a body. `None` is what its elements do not tell, or what no state has told yet.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyEnvelope {
    /// The body.
    pub body: SectionBody,
    /// Axial force, N; tension is positive.
    pub axial_force: Option<Peak>,
    /// Magnitude of the shear force, N.
    pub shear_force: Option<Peak>,
    /// Torque, N m.
    pub torque: Option<Peak>,
    /// Magnitude of the bending moment, N m.
    pub bending_moment: Option<Peak>,
    /// Largest von Mises stress over the section, Pa; where the section does not say where its outermost
    /// fibres are ([`SectionBody::knows_stress`]), the magnitude of axial force over area.
    pub stress: Option<Peak>,
    /// Yield stress where the stress is the largest part of it, Pa: it may be another one along the body.
    pub yield_stress: Option<f64>,
    /// First row or step in which the stress passes the yield stress, where it does so by most.
    pub yielding: Option<Peak>,
    /// The largest part.
    share: f64,
    /// Part of the yield stress that bending makes at least, which [`BodyEnvelope::stress`] does not know.
    unknown: f64,
}

/// Envelopes of all flexible bodies of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelopes {
    /// What [`Peak::at`] is: the first column of the history.
    pub key: Column,
    /// One for each body of [`Scene::section_bodies`].
    pub bodies: Vec<BodyEnvelope>,
    /// Body that yields first.
    first: Option<usize>,
    states: Vec<SectionState>,
}

impl Keep for Peak {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { value, at, x } = self;
        value.keep(archive);
        at.keep(archive);
        x.keep(archive);
    }
}

impl Keep for BodyEnvelope {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            body: _,
            axial_force,
            shear_force,
            torque,
            bending_moment,
            stress,
            yield_stress,
            yielding,
            share,
            unknown,
        } = self;
        unknown.keep(archive);
        yield_stress.keep(archive);
        share.keep(archive);
        for peak in [axial_force, shear_force, torque, bending_moment, stress, yielding] {
            peak.keep(archive);
        }
    }
}

/// The peaks; the bodies are known.
impl Keep for Envelopes {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            key: _,
            bodies,
            first,
            states: _,
        } = self;
        archive.fixed(bodies);
        first.keep(archive);
        if first.is_some_and(|first| first >= bodies.len()) {
            archive.misfit();
        }
    }
}

/// Part of the yield stress that bending makes at least from which on it is told that it is not known.
const COUNTS: f64 = 0.1;
/// Most bodies in the printed text.
const MOST_LINES: usize = 4;

fn meet(peak: &mut Option<Peak>, value: f64, at: f64, x: f64) {
    let is_larger = match peak {
        Some(peak) => value.abs() > peak.value.abs(),
        None => value.is_finite(),
    };
    if is_larger {
        *peak = Some(Peak { value, at, x });
    }
}

/// The largest magnitude at a time, of states that tell.
fn largest(states: &[SectionState], at: f64, of: impl Fn(&SectionState) -> Option<f64>) -> Option<Peak> {
    let (mut size, mut peak) = (-1.0, None);
    for state in states {
        if let Some(value) = of(state)
            && value.abs() > size
            && (peak.is_some() || value.is_finite())
        {
            size = value.abs();
            peak = Some((value, state.x));
        }
    }
    peak.map(|(value, x)| Peak { value, at, x })
}

fn meet_peak(peak: &mut Option<Peak>, found: Option<Peak>) {
    if let Some(Peak { value, at, x }) = found {
        meet(peak, value, at, x);
    }
}

impl BodyEnvelope {
    fn new(body: SectionBody) -> Self {
        Self {
            body,
            axial_force: None,
            shear_force: None,
            torque: None,
            bending_moment: None,
            stress: None,
            yield_stress: None,
            yielding: None,
            share: -1.0,
            unknown: 0.0,
        }
    }

    fn meet(&mut self, at: f64, states: &[SectionState]) {
        let body = &self.body;
        let axial = largest(states, at, |state| Some(state.forces[0]));
        let bending = largest(states, at, |state| Some(state.bending_moment()));
        meet_peak(&mut self.axial_force, axial);
        meet_peak(&mut self.bending_moment, bending);
        if body.has_section {
            let shear = largest(states, at, |state| Some(state.shear_force()));
            meet_peak(&mut self.shear_force, shear);
        }
        if body.has_section && !body.is_planar {
            meet_peak(&mut self.torque, largest(states, at, |state| Some(state.moments[0])));
        }
        meet_peak(&mut self.stress, largest(states, at, |state| body.stress_of(state)));
        let has_yielded = self.yielding.is_some();
        for state in states {
            let Some(limit) = state.yield_stress else { continue };
            if !body.knows_stress {
                self.unknown = self.unknown.max(state.least_bending.unwrap_or(0.0) / limit);
            }
            let Some(value) = body.stress_of(state).filter(|_| !has_yielded) else {
                continue;
            };
            if value / limit > self.share {
                (self.share, self.yield_stress) = (value / limit, Some(limit));
                if self.share > 1.0 {
                    self.yielding = Some(Peak { value, at, x: state.x });
                }
            }
        }
    }

    /// What its stress is.
    pub(in crate::app) fn stress_name(&self) -> &'static str {
        if self.body.knows_stress {
            "largest von Mises stress"
        } else {
            AXIAL
        }
    }
}

impl Envelopes {
    /// Empty ones for the bodies of a scene; `key` is the first column of the history.
    pub(in crate::app) fn new(scene: &(impl Scene + ?Sized), key: &Column) -> Self {
        Self {
            key: key.clone(),
            bodies: scene.section_bodies().into_iter().map(BodyEnvelope::new).collect(),
            first: None,
            states: Vec::new(),
        }
    }

    /// Takes in a state of a run.
    pub(in crate::app) fn meet(&mut self, scene: &mut (impl Scene + ?Sized), at: f64, state: &State) {
        if !self.bodies.is_empty() {
            scene.section_states(state, &mut self.states);
            self.take_in(at);
        }
    }

    /// Takes in an equilibrium. The scene may have been built anew for another value of a param.
    pub(in crate::app) fn meet_uniform(
        &mut self,
        scene: &mut (impl Scene + ?Sized),
        uniform: &Uniform,
        at: f64,
        state: &State,
    ) {
        if !self.bodies.is_empty() {
            // What is known of sections may depend on the param.
            for (envelope, body) in self.bodies.iter_mut().zip(scene.section_bodies()) {
                envelope.body = body;
            }
            scene.uniform_section_states(uniform, state, &mut self.states);
            self.take_in(at);
        }
    }

    /// What all sections carry in the state that was taken in last.
    pub(in crate::app) fn states(&self) -> &[SectionState] {
        &self.states
    }

    fn take_in(&mut self, at: f64) {
        let mut states = &self.states[..];
        for envelope in &mut self.bodies {
            let Some((own, others)) = states.split_at_checked(envelope.body.states) else {
                return;
            };
            envelope.meet(at, own);
            states = others;
        }
        if self.first.is_none() {
            let yielding = (0..self.bodies.len()).filter(|&body| self.bodies[body].yielding.is_some());
            self.first = yielding.max_by(|&a, &b| self.bodies[a].share.total_cmp(&self.bodies[b].share));
        }
    }

    /// `t = 1.5 s`.
    pub(in crate::app) fn place(&self, peak: &Peak) -> String {
        let Column { name, unit } = &self.key;
        let unit = if *unit == "1" { "" } else { unit };
        format!("{name} = {} {unit}", digits(peak.at, 6)).trim_end().to_owned()
    }

    /// What is told of yielding: the body that does so first, and bodies of which it is not known.
    pub(in crate::app) fn warnings(&self) -> impl Iterator<Item = String> {
        self.warning().into_iter().chain(self.unknown())
    }

    /// Bodies whose bending counts beside the yield stress, and makes a stress that is not known.
    fn unknown(&self) -> Option<String> {
        let bodies = self.bodies.iter().filter(|body| body.unknown > COUNTS);
        let names: Vec<String> = bodies.map(|body| format!("`{}`", body.body.name)).collect();
        let listed = listed(&names, MOST_LINES)?;
        Some(format!(
            "The yield stress is compared with the stress of the axial force alone, while bending counts, in {listed}: the section does not say where its outermost fibres are. Give it `extent_y`, and in space `extent_z`."
        ))
    }

    /// The one warning that a material yields, about the body that does first.
    fn warning(&self) -> Option<String> {
        let envelope = &self.bodies[self.first?];
        let (peak, limit) = (envelope.yielding?, envelope.yield_stress?);
        Some(format!(
            "Body `{}` passes the yield stress of `{}`, {}, at {}: the {} is {} at x = {} m. From there on the results hold for an elastic material only.",
            envelope.body.name,
            envelope.body.material,
            with_prefix(limit, "Pa"),
            self.place(&peak),
            envelope.stress_name(),
            with_prefix(peak.value, "Pa"),
            digits(peak.x, 4),
        ))
    }

    /// Lines for standard output, each after a line's end: the bodies with the largest stresses.
    pub(in crate::app) fn lines(&self) -> String {
        let mut order: Vec<&BodyEnvelope> = self.bodies.iter().filter(|body| body.stress.is_some()).collect();
        let stress = |body: &BodyEnvelope| body.stress.map_or(0.0, |peak| peak.value);
        order.sort_by(|a, b| stress(b).total_cmp(&stress(a)));
        let line = |envelope: &&BodyEnvelope| {
            let peak = envelope.stress?;
            Some(format!(
                "\n{}: {} {}, {}, x = {} of {} m",
                envelope.body.name,
                envelope.stress_name(),
                with_prefix(peak.value, "Pa"),
                self.place(&peak),
                digits(peak.x, 4),
                short(envelope.body.length),
            ))
        };
        let mut text: String = order.iter().take(MOST_LINES).filter_map(line).collect();
        if order.len() > MOST_LINES {
            text += &format!("\n{} more bodies in summary.json", order.len() - MOST_LINES);
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_the_first_largest_magnitudes() {
        let mut peak = None;
        for (at, value) in [(0.0, f64::NAN), (1.0, 2.0), (2.0, -3.0), (3.0, 3.0), (4.0, f64::NAN)] {
            meet(&mut peak, value, at, 0.5);
        }
        assert_eq!(
            peak,
            Some(Peak {
                value: -3.0,
                at: 2.0,
                x: 0.5
            })
        );
    }

    #[test]
    fn values_have_fitting_prefixes() {
        let texts = [4.6123456e9, 355e6, -1250.0, 12.0, 1e-3, 0.0].map(|value| with_prefix(value, "Pa"));
        assert_eq!(
            texts,
            ["4.612 GPa", "355 MPa", "-1.25 kPa", "12 Pa", "0.001 Pa", "0 Pa"]
        );
    }
}
