//! Whether the energy of an element makes sense: without stress where nothing is deformed, and without motions that nothing
//! resists.

use std::collections::HashMap;

use super::{Draft, say};
use crate::check::{Check, fold};
use crate::elements::{
    Coefficients, Density, Element, Field, Interpolant, LARGEST, Rules, STRETCHES, Term, at_rest, field_invariants,
};
use crate::model::{ElementQuantity, Expr as Value};
use crate::parse::tree::Item;
use crate::symbolic::{Graph, Id, Invariant};

/// Strain at which an energy has its least value that still passes for zero: of a law whose kink is rounded.
const OFF_REST: f64 = 1e-5;
/// Change of that strain with time that is round-off.
const STILL: f64 = 1e-12;

/// Strains at which a written stress is compared with the derivative of its energy.
const PROBES: [f64; 4] = [-0.03, -0.002, 0.004, 0.05];

/// By how much what changes with time is more than at the start, when a law is looked at.
const LATER: [f64; 2] = [0.011, 0.3];

/// Relative difference of these that is round-off.
const ROUND_OFF: f64 = 1e-7;

impl<'a> Check<'a> {
    pub(super) fn sound(&mut self, item: &'a Item, element: &Element, draft: &Draft<'a>) {
        let before = self.errors.len();
        for one in draft
            .vectors
            .iter()
            .filter(|(_, vector)| !draft.fields.iter().any(|(_, field)| field.of == vector.of))
        {
            self.errors.at(one.0.span, say::unused_vector(&one.0.text));
        }
        self.unused_names(draft);
        self.directions(element, draft);
        let dimensions: &[usize] = if element.is_planar() { &[2] } else { &[2, 3] };
        for &dimension in dimensions {
            let size = element.vectors_in(dimension).count() * dimension;
            if size > LARGEST {
                let message = say::too_large(&LARGEST.to_string(), &size.to_string(), place(dimension));
                self.errors.at(item.name.span, message);
            }
        }
        let values = self.values_of(draft);
        for &dimension in dimensions {
            for options in choices(element) {
                if self.errors.len() != before {
                    return;
                }
                self.sound_in(item, element, draft, (dimension, &options), &values);
            }
        }
    }

    /// Whether a section has both of its directions, or none, and nothing that needs them.
    fn directions(&mut self, element: &Element, draft: &Draft<'a>) {
        let first = |of: Interpolant| draft.vectors.iter().find(|(_, vector)| vector.of == of);
        if let (Some((name, _)), None) = (first(Interpolant::SectionZ), first(Interpolant::SectionY)) {
            self.errors.at(name.span, say::Z_ALONE);
        }
        if element.has_section() {
            return;
        }
        for (name, one, _) in &draft.coefficients {
            let needs = ["second_moment_y", "second_moment_z"];
            if let Some(property) = one.factors.iter().find(|factor| needs.contains(*factor)) {
                self.errors.at(name.span, say::without_directions(one.name, property));
            }
        }
    }

    /// Coefficients and definitions that nothing reads.
    fn unused_names(&mut self, draft: &Draft<'a>) {
        let in_energy = |name: &str| {
            let is_it = |value: &Value| {
                value
                    .contains(&|part| matches!(part, Value::Element(ElementQuantity::Coefficient(own)) if *own == name))
            };
            let in_terms = draft.written.terms.iter().any(|term| {
                term.coefficient == name || is_it(&term.density) || term.stress.as_ref().is_some_and(is_it)
            });
            in_terms || draft.written.definitions.iter().any(|one| is_it(&one.value))
        };
        let is_read = |name: &str| in_energy(name) || draft.inertia.iter().any(|inertia| inertia.coefficient == name);
        for (place, one, _) in &draft.coefficients {
            if !is_read(one.name) {
                self.errors.at(place.span, say::unused(one.name));
            }
        }
        let of_inertia = |name: &str| draft.inertia.iter().any(|inertia| inertia.coefficient == name);
        for (place, one, _) in draft.coefficients.iter().filter(|(_, one, _)| of_inertia(one.name)) {
            if in_energy(one.name) {
                self.errors.at(place.span, say::both(one.name));
            }
        }
        for (number, (name, _)) in draft.names.iter().enumerate() {
            let is_it = |value: &Value| {
                value.contains(&|part| matches!(part, Value::Element(ElementQuantity::Named(own)) if *own == number))
            };
            let in_terms = draft.written.terms.iter().any(|term| is_it(&term.density));
            if !in_terms && !draft.written.definitions.iter().any(|one| is_it(&one.value)) {
                let place = draft.definitions[number];
                self.errors.at(place.span, say::unused(name));
            }
        }
    }

    /// Coefficients for a look at the energy: one where properties decide, the default where params do.
    fn values_of(&self, draft: &Draft) -> Coefficients {
        let value = |scale: &Option<Value>| match scale {
            Some(scale) => fold::with_defaults(&self.model, scale, 0.0).unwrap_or(1.0),
            None => 1.0,
        };
        let list = draft.coefficients.iter();
        list.map(|(_, one, _)| (one.name, value(&one.scale))).collect()
    }

    fn sound_in(
        &mut self,
        item: &'a Item,
        element: &Element,
        draft: &Draft<'a>,
        (dimension, options): (usize, &[usize]),
        values: &Coefficients,
    ) {
        let place = place(dimension);
        for (at, term) in draft.written.terms.iter().enumerate() {
            if term.when.applies(dimension, options)
                && let Some(message) = missing(draft, &term.density, dimension, options, place)
            {
                self.errors.at(draft.terms[at].span, message);
                return;
            }
        }
        let mut graph = Graph::new();
        let (fields, symbols) = field_invariants(&mut graph, element, dimension);
        let built = draft.written.built(&mut graph, &fields, options);
        if built.is_empty() {
            self.errors.at(item.name.span, say::no_energy(place));
            return;
        }
        for one in &built {
            if one.strains.len() > 1 {
                let names: Vec<&str> = one.strains.iter().map(|&(name, ..)| draft.names[name].0).collect();
                self.errors
                    .at(draft.terms[one.term].span, say::several_strains(&names.join("` and `")));
                return;
            }
        }
        let places: Vec<usize> = built.iter().map(|one| one.term).collect();
        let terms = draft.written.terms(&mut graph, &fields, options);
        // What changes with time has its value at the start, and others.
        let at_fields: Vec<&Field> = element.fields_in(dimension).collect();
        let mut times = vec![HashMap::new(); 1 + LATER.len()];
        for (inputs, later) in times.iter_mut().zip([0.0].into_iter().chain(LATER)) {
            for one in &element.coefficients {
                let value = values.get(one.name).copied().unwrap_or(1.0);
                let value = if one.is_timed() { value + later } else { value };
                inputs.insert(graph.input(one.name), value);
            }
            for &(one, symbol) in &symbols {
                inputs.insert(symbol, at_rest(one, &at_fields));
            }
        }
        for (&at, term) in places.iter().zip(&terms) {
            let (span, mut graph) = (draft.terms[at].span, graph.clone());
            let mut look = Look {
                element,
                dimension,
                graph: &mut graph,
                symbols: &symbols,
                term,
            };
            let active = draft.active[at];
            if let Some(message) = look.wrong(&times, active.is_some()) {
                let is_word = message == say::NOT_ACTIVE;
                let span = active.filter(|_| is_word).map_or(span, |word| word.span);
                self.errors.at(span, message);
            }
        }
        if self.errors.is_empty() {
            self.resisting(item, element, (dimension, options, place), values);
        }
    }

    /// Without motions that nothing resists.
    fn resisting(
        &mut self,
        item: &'a Item,
        element: &Element,
        (dimension, options, place): (usize, &[usize], &str),
        values: &Coefficients,
    ) {
        let size = element.vectors_in(dimension).count() * dimension;
        for stretch in STRETCHES {
            let rank = |rules: Rules| element.rank(dimension, options, stretch, rules, values);
            let declared = rank(Rules::Declared(element.default_points));
            let rich = rank(Rules::Rich);
            if declared < rich {
                let enough = (1..20).find(|&points| rank(Rules::Declared(points)) >= rich);
                let count = (rich - declared).to_string();
                let message = match enough.filter(|_| !element.own_rule) {
                    Some(points) => say::too_few(&count, place, &points.to_string()),
                    None => say::too_few_of_terms(&count, place),
                };
                self.errors.at(item.name.span, message);
                return;
            }
            // Tight, an element moves freely as a whole, and in space it turns about its axis.
            let free = if dimension == 2 { 2 } else { 4 };
            if stretch != 1.0 && size - rich > free {
                self.errors
                    .at(item.name.span, say::loose(&(size - rich - free).to_string(), place));
                return;
            }
        }
    }
}

fn place(dimension: usize) -> &'static str {
    if dimension == 2 { "in the plane" } else { "in space" }
}

/// One part of the energy where nothing is deformed.
struct Look<'l> {
    element: &'l Element,
    dimension: usize,
    graph: &'l mut Graph,
    symbols: &'l [(Invariant, Id)],
    term: &'l Term,
}

impl Look<'_> {
    /// What is wrong with it at some times, each with the values of coefficients and inner products; the first is the start.
    fn wrong(&mut self, times: &[HashMap<Id, f64>], is_active: bool) -> Option<String> {
        let (mut is_still, start) = (true, self.strain(&times[0]));
        for (at, inputs) in times.iter().enumerate() {
            let stress = match self.stress(inputs, is_active, start) {
                Ok(stress) => stress,
                // At other times a law may have no value at these numbers.
                Err(message) if at == 0 => return Some(message),
                Err(_) => continue,
            };
            if let Some(stress) = stress {
                if at == 0 && !is_active && !self.is_timed(times) {
                    return Some(say::not_stationary(&format!("{stress:.3}")));
                }
                is_still = false;
            }
        }
        match (is_still, is_active) {
            (false, false) => return Some(say::STRESSED.into()),
            (true, true) => return Some(say::NOT_ACTIVE.into()),
            _ => {}
        }
        times.iter().find_map(|inputs| self.other_stress(inputs))
    }

    /// Whether something in it changes with time.
    fn is_timed(&mut self, times: &[HashMap<Id, f64>]) -> bool {
        let [first, second, ..] = times else {
            return false;
        };
        let timed: Vec<Id> = first
            .iter()
            .filter(|(id, value)| second[*id] != **value)
            .map(|(id, _)| *id)
            .collect();
        let expressions = self.term.density.expressions();
        let own = self.graph.input(self.term.coefficient);
        timed.contains(&own) || expressions.into_iter().any(|id| self.graph.depends_on(id, &timed))
    }

    /// The strain from its least energy of a law where nothing is deformed; 0 of what is no law.
    fn strain(&mut self, inputs: &HashMap<Id, f64>) -> f64 {
        let Density::Law { change, stress, .. } = self.term.density else {
            return 0.0;
        };
        let stiffness = self.graph.partial(stress, change);
        let [stress, stiffness, _] = self.law([stress, stiffness, change], change, 0.0, inputs);
        stress / stiffness
    }

    /// Its stress where nothing is deformed, `None` where there is none; `start` is its strain at the start.
    ///
    /// # Errors
    /// No value, or a strain that nothing resists.
    fn stress(&mut self, inputs: &HashMap<Id, f64>, is_active: bool, start: f64) -> Result<Option<f64>, String> {
        match self.term.density {
            Density::Law {
                measure,
                change,
                stress,
                ..
            } => {
                let stiffness = self.graph.partial(stress, change);
                let rest = self.law([stress, stiffness, measure], change, 0.0, inputs);
                let is_soft = if is_active { rest[1] < 0.0 } else { rest[1] <= 0.0 };
                if rest.iter().any(|value| !value.is_finite()) {
                    Err(say::NOT_FINITE_AT_REST.into())
                } else if is_soft {
                    Err(say::not_stiff(&format!("{:.3}", rest[1])))
                } else {
                    let strain = self.strain(inputs);
                    let is_stressed = strain.abs() > OFF_REST || (strain - start).abs() > STILL;
                    Ok(is_stressed.then_some(rest[0]))
                }
            }
            Density::Energy(energy) => {
                // The force on each field: the sum of dW/dI times the fields that it is multiplied with.
                let symbols = self.symbols.iter();
                let slopes: Vec<Id> = symbols.map(|&(_, symbol)| self.graph.partial(energy, symbol)).collect();
                let slopes = self.graph.evaluate(&slopes, inputs);
                if slopes.iter().any(|value| !value.is_finite()) {
                    return Err(say::NOT_FINITE_AT_REST.into());
                }
                let fields = self.element.fields_in(self.dimension);
                let is_unit: Vec<bool> = fields.map(Field::is_unit).collect();
                let mut pulls = self
                    .symbols
                    .iter()
                    .zip(slopes)
                    .filter(|((one, _), slope)| slope.abs() > 1e-9 && (is_unit[one.i] || is_unit[one.j]));
                Ok(pulls.next().map(|(_, slope)| slope))
            }
            _ => Ok(None),
        }
    }

    /// A stress that is written and is not the derivative of the energy.
    fn other_stress(&mut self, inputs: &HashMap<Id, f64>) -> Option<String> {
        let Density::Law {
            change, energy, stress, ..
        } = self.term.density
        else {
            return None;
        };
        let derivative = self.graph.partial(energy, change);
        if stress == derivative {
            return None;
        }
        let stiffness = self.graph.partial(stress, change);
        let [_, _, stiff] = self.law([stress, derivative, stiffness], change, 0.0, inputs);
        PROBES.into_iter().find_map(|probe| {
            let [own, derived, _] = self.law([stress, derivative, stiffness], change, probe, inputs);
            let size = own.abs() + derived.abs() + stiff.abs() * probe.abs();
            ((own - derived).abs() > ROUND_OFF * size).then(|| say::wrong_stress(&format!("{probe}")))
        })
    }

    /// Expressions of a law at a change of its strain.
    fn law(&mut self, ids: [Id; 3], change: Id, value: f64, inputs: &HashMap<Id, f64>) -> [f64; 3] {
        let mut inputs = inputs.clone();
        inputs.insert(change, value);
        let values = self.graph.evaluate(&ids, &inputs);
        [values[0], values[1], values[2]]
    }
}

/// All values of the options.
fn choices(element: &Element) -> Vec<Vec<usize>> {
    element.options.iter().fold(vec![Vec::new()], |all, option| {
        let with = |list: Vec<usize>| {
            (0..option.values.len()).map(move |value| {
                let mut longer = list.clone();
                longer.push(value);
                longer
            })
        };
        all.into_iter().flat_map(with).collect()
    })
}

/// What a formula has not where it applies; `None`: nothing, or what the plane does not have at all.
fn missing(draft: &Draft, value: &Value, dimension: usize, options: &[usize], place: &str) -> Option<String> {
    match value {
        Value::Element(ElementQuantity::Cross(..)) if dimension == 3 => Some(say::CROSS_IN_SPACE.into()),
        Value::Element(ElementQuantity::Named(name)) => {
            let mut list = draft.written.definitions.iter().filter(|one| one.name == *name);
            match list.find(|one| one.when.applies(dimension, options)) {
                Some(one) => missing(draft, &one.value, dimension, options, place),
                None => Some(say::undefined(draft.names[*name].0, place)),
            }
        }
        _ => {
            let mut parts = value.parts().into_iter();
            parts.find_map(|part| missing(draft, part, dimension, options, place))
        }
    }
}
