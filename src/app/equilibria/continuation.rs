//! Equilibria one after the other along a parameter, along the spin or along the load: the way that
//! `steady`, `static` and `campbell` share; nothing is printed or written here.

use std::cell::OnceCell;

use super::balanced::is_balanced;
use super::directions::{self, Measured};
use super::way::{Unplaced, between, check, placed, uniform};
use crate::app::results::equilibria::{EquilibriumSettings, Range};
use crate::app::results::error::RunError;
use crate::app::results::history::Column;
use crate::app::writing::numbers::in_unit;
use crate::equilibrium::{
    Continued, Equilibrium, Kind, Negative, Uniform, assembled, continue_from, continue_holding, follow, sagged,
    settle, unloaded, untied_directions,
};
use crate::error::SolveErrorKind;
use crate::{AnyModel, Scene, SolveError, State};

mod leaps;

/// How far a continuation is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EquilibriumProgress {
    /// Part of the way, 0 to 1.
    pub share: f64,
    /// Value of the first column.
    pub key: f64,
}

/// A step may be halved until there are this many in one.
const PARTS: u64 = 2048;
/// Part of a step at which a gap is tried to be leapt over.
const SHORT: u64 = 128;
/// Why a step is shortened.
const LEAPT: &str = "no equilibrium next to those before is found: the bodies may buckle or snap through there";

/// The way and where on it the last equilibrium is.
pub(in crate::app) struct Line<'m> {
    model: &'m dyn AnyModel,
    kind: Kind,
    settings: EquilibriumSettings,
    /// Spin at the end of the way, rad/s, where it grows.
    full_spin: f64,
    place: u64,
    increment: u64,
    scene: Box<dyn Scene>,
    at: Uniform,
    /// Scenes that are used again where no parameter changes.
    spare: Vec<Box<dyn Scene>>,
    /// The last equilibrium, in the scene.
    state: State,
    /// The last equilibria, at most two.
    last: Found,
    before: Option<Found>,
    /// Parts of the way before and behind gaps that were leapt over.
    leaps: Vec<[f64; 2]>,
    /// The first part of the way at which the negative directions were looked for and not found, and why.
    unmeasured: Option<(f64, String)>,
    /// Newton iterations so far.
    pub iterations: u64,
    /// Whether the first state is an equilibrium: a declared initial shape may be none without spin and loads.
    pub begins_balanced: bool,
}

/// An equilibrium on the way.
#[derive(Clone, Debug)]
pub(in crate::app) struct Found {
    /// Part of the way, 0 to 1.
    pub share: f64,
    /// Carried back to t = 0 ([`Scene::carried`]).
    pub state: State,
    /// What the way to it knows of the negative directions of the stiffness.
    negative: Option<Negative>,
    /// Of a static equilibrium their number, where it is known.
    pub measured: Option<Measured>,
    /// Motions that nothing ties there, once they were asked for: directions of the unknowns.
    untied: OnceCell<Vec<Vec<f64>>>,
}

impl Found {
    fn placed(&self) -> (f64, State) {
        (self.share, self.state.clone())
    }
}

/// What is asked at an equilibrium; whether with the values.
pub(in crate::app) type Measure<'a> = dyn FnMut(&mut dyn Scene, &Uniform, &Continued, bool) -> Option<Measured> + 'a;

/// An equilibrium beside the steps of the way.
#[derive(Clone, Debug)]
pub(in crate::app) struct Looked {
    pub share: f64,
    /// As [`Found::state`].
    pub state: State,
    pub measured: Measured,
}

/// The last equilibrium, to look at.
pub(in crate::app) struct Station<'l> {
    /// Value of the first column.
    pub key: f64,
    pub scene: &'l mut dyn Scene,
    pub at: Uniform,
    pub state: &'l State,
    /// Angular velocity, rad/s, and that of what excites.
    pub spin: f64,
    pub excitation: f64,
}

/// An equilibrium that is found from the start, with its scene.
type Fresh = (Box<dyn Scene>, Uniform, Equilibrium);

/// The first of the steps of a range at which an equilibrium is found from the start, where there are some from there on.
fn first_of(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Option<(u32, Fresh)> {
    let found = |step: u32| {
        let share = f64::from(step) / f64::from(settings.steps);
        let (mut scene, at) = placed(model, Kind::Steady, settings, share).ok()?;
        let found = follow(scene.as_mut(), &at, 1.0, |_, _| ()).ok()?;
        Some((scene, at, found))
    };
    let leaps = std::iter::successors(Some(1_u32), |step| step.checked_mul(2));
    let mut leaps = leaps.take_while(|&step| step <= settings.steps);
    let (mut last, mut first) = leaps.find_map(|step| Some((step, found(step)?)))?;
    // There is none at half of it.
    let mut none = last / 2;
    while last - none > 1 {
        let step = none + (last - none) / 2;
        match found(step) {
            Some(earlier) => (last, first) = (step, earlier),
            None => none = step,
        }
    }
    Some((last, first))
}

impl<'m> Line<'m> {
    /// The first equilibrium: at the first value of the parameter, or without spin and loads.
    ///
    /// # Errors
    /// Settings out of range, a model that cannot be built, and the reason why there is no equilibrium.
    pub fn start(model: &'m dyn AnyModel, kind: Kind, settings: &EquilibriumSettings) -> Result<Self, RunError> {
        check(model, settings)?;
        let (mut scene, mut at) = placed(model, kind, settings, 0.0).map_err(|failure| match failure {
            Unplaced::Model(error) => RunError::Model(error),
            Unplaced::Time(text) => RunError::Settings(text),
        })?;
        let mut leaps = Vec::new();
        let mut iterations = 0;
        let mut place = 0;
        let mut unmeasured = None;
        let mut ask = |scene: &mut dyn Scene, at: &Uniform, found: &Continued| {
            directions::at_rest(scene, at, found).unwrap_or_else(|error| {
                unmeasured.get_or_insert((0.0, error.to_string()));
                None
            })
        };
        let mut rest = assembled(scene.as_mut(), &at);
        let is_along_spin = settings.range.is_none() && kind == Kind::Steady;
        let mut begins_balanced = settings.range.is_some() || is_balanced(scene.as_mut(), &at, &rest);
        // Loads move what is undeformed at rest; a declared initial shape is none of theirs.
        let is_loaded = is_along_spin && !begins_balanced && is_balanced(scene.as_mut(), &at.scaled(0.0), &rest);
        let is_followed = settings.range.is_some() || is_loaded;
        begins_balanced |= is_loaded;
        let (state, negative, measured) = if is_followed {
            let mut found = follow(scene.as_mut(), &at, 1.0, |_, _| ());
            // Where there is no equilibrium at the first value, as of hinged blades at rest, it begins at a later one; not where nothing could be one.
            let may_begin_later = kind == Kind::Steady && scene.uniform_obstacle(&at, &rest).is_none();
            if found.is_err()
                && may_begin_later
                && let Some((step, (other, there, later))) = first_of(model, settings)
            {
                leaps.push([0.0, f64::from(step) / f64::from(settings.steps)]);
                place = u64::from(step) * PARTS;
                (scene, at, found) = (other, there, Ok(later));
            }
            let found = found.map_err(|error| {
                let why = reason(&error, true);
                RunError::Equilibrium(match settings.range {
                    Some(range) => format!("at {}: {why}", value_of(model, range.param, range.from)),
                    None => why,
                })
            })?;
            iterations = u64::from(found.iterations());
            match found.path.last() {
                Some(step) => (step.state.clone(), Some(step.negative), ask(scene.as_mut(), &at, step)),
                None => (rest, None, None),
            }
        } else {
            scene.uniform_state(&at, &mut rest);
            let near = begins_balanced.then(|| unloaded(scene.as_mut(), &at));
            let near = near.flatten();
            let measured = near
                .as_ref()
                .and_then(|near| ask(scene.as_mut(), &at.scaled(near.scale), near));
            (rest, near.map(|near| near.negative), measured)
        };
        let full_spin = scene.spin_in(&at.whole());
        Ok(Self {
            model,
            kind,
            settings: *settings,
            full_spin,
            place,
            increment: PARTS,
            last: Found {
                share: place as f64 / (u64::from(settings.steps) * PARTS) as f64,
                state: scene.carried(&at, &state, true),
                negative,
                measured,
                untied: OnceCell::new(),
            },
            unmeasured,
            scene,
            at,
            spare: Vec::new(),
            state,
            before: None,
            leaps,
            iterations,
            begins_balanced,
        })
    }

    /// Head of the first column: the parameter in its declared unit, the spin, or the load factor.
    pub fn column(&self) -> Column {
        match (self.settings.range, self.kind) {
            (Some(range), _) => {
                let param = &self.model.params()[range.param];
                Column {
                    name: param.name.into(),
                    unit: if param.unit.is_empty() { "1" } else { param.unit },
                }
            }
            (None, Kind::Steady) => Column {
                name: "spin".into(),
                unit: "rad/s",
            },
            (None, Kind::Static) => Column {
                name: "load_factor".into(),
                unit: "1",
            },
        }
    }

    /// Value of the first column at a part of the way.
    pub fn key(&self, share: f64) -> f64 {
        match (self.settings.range, self.kind) {
            (Some(range), _) => between(range, share) / self.model.params()[range.param].unit_si,
            (None, Kind::Steady) => share * self.full_spin,
            (None, Kind::Static) => share,
        }
    }

    /// Angular velocity of what excites at a part of the way, rad/s: the spin. Where nothing turns, a parameter that is one counts as that of a rotor.
    pub fn excitation(&self, share: f64, spin: f64) -> f64 {
        let angular_velocity = |range: &Range| self.model.params()[range.param].dimension == [0, 0, -1, 0, 0, 1];
        match self.settings.range.filter(angular_velocity) {
            Some(range) if spin == 0.0 => between(range, share).abs(),
            _ => spin,
        }
    }

    /// The last equilibrium.
    pub fn station(&mut self) -> Station<'_> {
        let spin = self.scene.spin_in(&self.at);
        Station {
            key: self.key(self.last.share),
            spin,
            excitation: self.excitation(self.last.share, spin),
            scene: self.scene.as_mut(),
            at: self.at,
            state: &self.state,
        }
    }

    /// The last equilibrium and the one before it.
    pub fn last_two(&self) -> (Option<&Found>, &Found) {
        (self.before.as_ref(), &self.last)
    }

    /// Whether the end of the way is reached.
    pub fn is_done(&self) -> bool {
        self.place == self.total()
    }

    /// How far it is.
    pub fn progress(&self) -> EquilibriumProgress {
        EquilibriumProgress {
            share: self.last.share,
            key: self.key(self.last.share),
        }
    }

    /// The next equilibrium; the step is halved where Newton's iteration fails. Where short steps lead nowhere, relative
    /// equilibria may go on behind a gap, as those of an unbalanced shaft do behind its critical speed.
    ///
    /// # Errors
    /// Why there is none, with the value beyond which.
    pub fn advance(&mut self) -> Result<(), String> {
        loop {
            let target = (self.place + self.increment).min(self.total());
            match self.attempt(target as f64 / self.total() as f64) {
                Ok(()) => {
                    self.place = target;
                    if self.increment < PARTS && target.is_multiple_of(2 * self.increment) {
                        self.increment *= 2;
                    }
                    return Ok(());
                }
                Err(_) if self.increment == 1 && (self.leap_far() || self.sags()) => return Ok(()),
                Err(text) if self.increment == 1 => {
                    let last = self.column().at(self.key(self.last.share), 7);
                    return Err(format!("beyond {last}: {text}"));
                }
                Err(_) => self.increment /= 2,
            }
            if self.increment == SHORT && self.leap() {
                return Ok(());
            }
        }
    }

    /// [`placed`], in a scene that is there already where it is the same one.
    fn placed(&mut self, share: f64) -> Result<(Box<dyn Scene>, Uniform), Unplaced> {
        match self.spare.pop() {
            Some(scene) => Ok((scene, uniform(self.model, self.kind, &self.settings, share)?)),
            None => placed(self.model, self.kind, &self.settings, share),
        }
    }

    /// Takes a scene back.
    fn give_back(&mut self, scene: Box<dyn Scene>) {
        if self.settings.range.is_none() {
            self.spare.push(scene);
        }
    }

    /// Whether no load acts at the last equilibrium.
    fn is_unloaded(&mut self) -> bool {
        let scene = self.scene.as_mut();
        let [mut loaded, mut unloaded] = [vec![0.0; scene.unknowns()], vec![0.0; scene.unknowns()]];
        scene.uniform_residual(&self.at, &self.state, &mut loaded);
        scene.uniform_residual(&self.at.scaled(0.0), &self.state, &mut unloaded);
        loaded == unloaded
    }

    /// The equilibrium at the next full step, found from the start of the scene.
    fn leap(&mut self) -> bool {
        let target = ((self.place / PARTS + 1) * PARTS).min(self.total());
        let share = target as f64 / self.total() as f64;
        if self.kind == Kind::Static {
            return false;
        }
        let Ok((mut scene, at)) = self.placed(share) else {
            return false;
        };
        let guess = assembled(scene.as_mut(), &at);
        let Ok(found) = continue_from(scene.as_mut(), &at, &guess) else {
            self.give_back(scene);
            return false;
        };
        self.land(scene, at, target, found);
        true
    }

    /// The equilibrium at a later step, found from rest or by a flow.
    fn leap_far(&mut self) -> bool {
        let mut steps = 1;
        while self.kind == Kind::Steady && self.place < self.total() {
            let target = (self.place / PARTS + steps) * PARTS;
            if target > self.total() {
                return false;
            }
            let share = target as f64 / self.total() as f64;
            if let Ok((mut scene, at)) = self.placed(share) {
                let found = follow(scene.as_mut(), &at, 1.0, |_, _| ());
                if let Some(last) = found.ok().and_then(|found| found.path.last().cloned()) {
                    self.land(scene, at, target, last);
                    return true;
                }
                self.give_back(scene);
            }
            steps *= 2;
        }
        false
    }

    /// Whether the first static equilibrium, to which no step is short enough, is found from greater loads.
    fn sags(&mut self) -> bool {
        if self.kind != Kind::Static || self.place > 0 || self.settings.range.is_some() {
            return false;
        }
        let share = PARTS as f64 / self.total() as f64;
        let Ok((mut scene, at)) = self.placed(share) else {
            return false;
        };
        match sagged(scene.as_mut(), &at) {
            Some(found) => {
                self.keep(scene, at, share, found);
                (self.place, self.increment) = (PARTS, PARTS);
                true
            }
            None => {
                self.give_back(scene);
                false
            }
        }
    }

    fn land(&mut self, scene: Box<dyn Scene>, at: Uniform, target: u64, found: Continued) {
        let share = target as f64 / self.total() as f64;
        self.leaps.push([self.last.share, share]);
        self.keep(scene, at, share, found);
        (self.place, self.increment) = (target, PARTS);
    }

    /// What is said of the leaps, and of what is not known.
    pub fn warnings(&self) -> Vec<String> {
        let key = self.column();
        let told = |leap: &[f64; 2]| {
            let [from, to] = leap.map(|share| self.key(share));
            format!(
                "no equilibrium continues those up to {}: the one at {} is found from the undeformed start",
                key.at(from, 7),
                key.quantity(to, 7)
            )
        };
        let unmeasured = self.unmeasured.iter().map(|(share, why)| {
            let at = key.at(self.key(*share), 7);
            format!("whether the stiffness is negative in some direction is not known at {at}, so that critical values next to it are not found: {why}")
        });
        // Where nothing turns the spin grows from nothing to nothing.
        let is_way = self.key(0.0) != self.key(1.0);
        let leaps = self.leaps.iter().filter(|_| is_way);
        leaps.map(told).chain(unmeasured).collect()
    }

    fn total(&self) -> u64 {
        u64::from(self.settings.steps) * PARTS
    }

    fn attempt(&mut self, share: f64) -> Result<(), String> {
        let (mut scene, at) = self.placed(share).map_err(|failure| failure.to_string())?;
        match self.next(scene.as_mut(), &at, share) {
            Ok(found) => {
                self.keep(scene, at, share, found);
                Ok(())
            }
            Err(why) => {
                self.give_back(scene);
                Err(why)
            }
        }
    }

    /// The equilibrium at a part of the way that is next to the last one.
    fn next(&mut self, scene: &mut dyn Scene, at: &Uniform, share: f64) -> Result<Continued, String> {
        let guess = self.predicted(scene, share)?;
        let mut found = self.continued(scene, at, &guess);
        if found.is_err() && guess.x != self.last.state.x {
            let last = self.last.state.clone();
            found = self.continued(scene, at, &last);
        }
        let leapt = match &found {
            Ok(found) if self.kind == Kind::Static => self.leaps(scene, at, share, found),
            Ok(found) => self.leaps_turning(scene, at, share, found),
            Err(_) => false,
        };
        let is_first = self.kind == Kind::Static && self.place == 0;
        if (leapt || found.is_err()) && is_first && (self.settings.range.is_none() || self.is_unloaded()) {
            found = match settle(scene, at) {
                Err(_) if leapt => return Err(LEAPT.into()),
                Err(_) => found,
                settled => settled,
            };
        } else if leapt {
            return Err(LEAPT.into());
        }
        found.map_err(|error| reason(&error, self.settings.range.is_some() || self.kind == Kind::Steady))
    }

    fn keep(&mut self, mut scene: Box<dyn Scene>, at: Uniform, share: f64, found: Continued) {
        self.iterations += u64::from(found.iterations);
        let measured = directions::at_rest(scene.as_mut(), &at, &found).unwrap_or_else(|error| {
            self.unmeasured.get_or_insert((share, error.to_string()));
            None
        });
        let last = Found {
            share,
            state: scene.carried(&at, &found.state, true),
            negative: Some(found.negative),
            measured,
            untied: OnceCell::new(),
        };
        self.before = Some(std::mem::replace(&mut self.last, last));
        let old = std::mem::replace(&mut self.scene, scene);
        self.give_back(old);
        (self.at, self.state) = (at, found.state);
    }

    /// The equilibrium near a guess that is carried back to t = 0. Of what turns, motions that nothing ties at the last equilibrium are held where it is
    /// not found without.
    fn continued(&mut self, scene: &mut dyn Scene, at: &Uniform, guess: &State) -> Result<Continued, SolveError> {
        let mut guess = guess.clone();
        guess.t = at.t;
        let guess = scene.carried(at, &guess, false);
        let found = continue_from(scene, at, &guess);
        if found.is_ok() || self.kind == Kind::Static {
            return found;
        }
        let directions = || untied_directions(self.scene.as_mut(), &self.at, &self.state);
        let untied = self.last.untied.get_or_init(directions);
        if untied.is_empty() {
            return found;
        }
        continue_holding(scene, at, &guess, untied.clone())
    }

    /// On the secant through the last two equilibria; orientations as in the last one.
    fn predicted(&self, scene: &dyn Scene, share: f64) -> Result<State, String> {
        let mut guess = self.last.state.clone();
        if guess.x.len() != scene.unknowns() || guess.lambda.len() != scene.constraints() {
            return Err("the number of unknowns changes: the equilibria do not continue each other".into());
        }
        if let Some(before) = &self.before {
            guess = secant(scene, [&before.placed(), &self.last.placed()], share);
        }
        Ok(guess)
    }

    /// The scene and the equilibrium near a guess at a part of the way; the last state is carried back, as the guess is.
    pub fn between(&mut self, share: f64, guess: &State) -> Option<(Box<dyn Scene>, Uniform, State, State)> {
        let (mut scene, at) = self.placed(share).ok()?;
        let found = self.continued(scene.as_mut(), &at, guess).ok()?;
        self.iterations += u64::from(found.iterations);
        let back = scene.carried(&at, &found.state, true);
        Some((scene, at, found.state, back))
    }

    /// The equilibrium near a guess at a part of the way, and what is measured of it.
    pub fn looked_at(
        &mut self,
        share: f64,
        guess: &State,
        with_values: bool,
        measure: &mut Measure<'_>,
    ) -> Option<Looked> {
        let (mut scene, at) = self.placed(share).ok()?;
        let looked = self.continued(scene.as_mut(), &at, guess).ok().and_then(|found| {
            self.iterations += u64::from(found.iterations);
            let measured = measure(scene.as_mut(), &at, &found, with_values)?;
            Some(Looked {
                share,
                state: scene.carried(&at, &found.state, true),
                measured,
            })
        });
        self.give_back(scene);
        looked
    }
}

/// The state at a part of the way on the secant through two, each with its part; orientations as in the second one.
fn secant(scene: &dyn Scene, [before, last]: [&(f64, State); 2], share: f64) -> State {
    let mut guess = last.1.clone();
    let ratio = (share - last.0) / (last.0 - before.0);
    let carried = |to: &mut [f64], from: &[f64]| {
        for (value, earlier) in to.iter_mut().zip(from) {
            *value += ratio * (*value - earlier);
        }
    };
    carried(&mut guess.x, &before.1.x);
    carried(&mut guess.lambda, &before.1.lambda);
    for &turn in scene.turns() {
        guess.x[turn..turn + 3].copy_from_slice(&last.1.x[turn..turn + 3]);
    }
    guess
}

/// A parameter and its value in the declared unit.
pub(in crate::app) fn value_of(model: &dyn AnyModel, param: usize, value: f64) -> String {
    let param = &model.params()[param];
    format!("{} = {}", param.name, in_unit(param, value))
}

/// Why there is no equilibrium; with `whole`, the scale is always 1 and says nothing.
pub(in crate::app) fn reason(error: &SolveError, whole: bool) -> String {
    let mut text = error.to_string();
    if let (true, SolveErrorKind::NoEquilibrium(_)) = (whole, &error.kind) {
        for scale in [" beyond 1 of the angular velocity", " beyond 1 of the load"] {
            text = text.replace(scale, "");
        }
    }
    text
}
