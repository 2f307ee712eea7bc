//! The stiffness of what has inertia where states have come to rest: a state is no direction in which anything bends.

use std::collections::BTreeSet;

use crate::linalg::{Pattern, solve_full};
use crate::model::Scene;
use crate::system::Tangent;

/// The largest stiffness, of that for which an integral stands: it holds what it integrates.
const HELD: f64 = 1e-6;
/// Part of their terms that is left of the rates of states which depend on each other.
const DEPENDENT: f64 = 1e-9;

/// The matrices with states at rest, on their own pattern. States z with `z' = g(x, z)` follow what moves slowly, `dz = -(dg/dz)^-1 dg/dx dx`, and the
/// forces that read them have that much more of stiffness. What is left of a state is an unknown by itself, as heavy and as stiff as the largest of the others.
pub(super) fn settled(scene: &dyn Scene, tangent: Tangent) -> (Pattern, Tangent) {
    let (pattern, states, sizes) = (scene.pattern(), scene.states(), scene.sizes());
    if states.is_empty() {
        return (pattern.clone(), tangent);
    }
    let count = states.len();
    let mut number = vec![None; sizes.len()];
    states
        .iter()
        .enumerate()
        .for_each(|(own, &state)| number[state] = Some(own));
    // In sizes of the states, 1/s.
    let mut own = vec![0.0; count * count];
    let (mut acting, mut driving) = (Vec::new(), Vec::new());
    let (mut kept, mut largest) = (Vec::new(), 0.0_f64);
    for ((row, column), &value) in pattern.places().zip(&tangent.stiffness) {
        match (number[row], number[column]) {
            _ if value == 0.0 => {}
            (Some(i), Some(j)) => own[i * count + j] = value * sizes[column] / sizes[row],
            (None, Some(state)) => acting.push((row, state, value * sizes[column])),
            (Some(state), None) => driving.push((state, column, value / sizes[row])),
            (None, None) => {
                kept.push(((row, column), value));
                largest = largest.max((value * sizes[row] * sizes[column]).abs());
            }
        }
    }
    let leaks = (0..count).map(|state| {
        let most = |parts: &mut dyn Iterator<Item = f64>| parts.fold(0.0, |most: f64, part| most.max(part.abs()));
        let push = most(
            &mut acting
                .iter()
                .filter(|(_, own, _)| *own == state)
                .map(|(row, _, force)| force * sizes[*row]),
        );
        let drive = most(
            &mut driving
                .iter()
                .filter(|(own, ..)| *own == state)
                .map(|(_, column, rate)| rate * sizes[*column]),
        );
        let leak = HELD * push * drive / largest;
        if leak > 0.0 && leak.is_finite() { leak } else { 1.0 }
    });
    let shown = at_rest(&own, count, leaks);
    for &(row, state, force) in &acting {
        for &(other, column, rate) in &driving {
            let value = -force * shown[state * count + other] * rate;
            kept.extend((value != 0.0).then_some(((row, column), value)));
        }
    }
    let with_fill = |&((row, column), _): &((usize, usize), f64)| [(row, column), (column, row)];
    let places: BTreeSet<(usize, usize)> = pattern.places().chain(kept.iter().flat_map(with_fill)).collect();
    let all = Pattern::new(sizes.len(), sizes.len(), places);
    let place = |row, column| all.find(row, column).expect("the pattern holds these places");
    let mut of = Tangent {
        mass: vec![0.0; all.entries()],
        stiffness: vec![0.0; all.entries()],
        damping: vec![0.0; all.entries()],
    };
    for (values, old) in [(&mut of.mass, &tangent.mass), (&mut of.damping, &tangent.damping)] {
        for ((row, column), &value) in pattern.places().zip(old) {
            if number[row].is_none() && number[column].is_none() {
                values[place(row, column)] = value;
            }
        }
    }
    for ((row, column), value) in kept {
        of.stiffness[place(row, column)] += value;
    }
    let weights = (0..sizes.len()).map(|row| of.mass[place(row, row)] * sizes[row].powi(2));
    let heaviest = weights.fold(0.0, f64::max);
    for &state in states {
        let unit = sizes[state].powi(2);
        of.mass[place(state, state)] = heaviest / unit;
        of.stiffness[place(state, state)] = if largest > 0.0 { largest } else { 1.0 } / unit;
    }
    (all, of)
}

/// The inverse of the states' own rates. Where there is none, as of integrals, they forget slowly: each with the rate of `leaks`.
fn at_rest(own: &[f64], count: usize, leaks: impl Iterator<Item = f64>) -> Vec<f64> {
    let unit: Vec<f64> = (0..count * count)
        .map(|place| f64::from(u8::from(place / count == place % count)))
        .collect();
    // In no units: what cancels in each row of the inverse times the rates.
    let cancels = |inverse: &[f64], state: usize| -> f64 {
        let terms = (0..count).map(|other| (inverse[state * count + other] * own[other * count + state]).abs());
        terms.sum()
    };
    let is_regular = |inverse: &[f64]| (0..count).all(|state| cancels(inverse, state) < 1.0 / DEPENDENT);
    if let Some([inverse]) = solve_full(count, own, [&unit]).filter(|[inverse]| is_regular(inverse)) {
        return inverse;
    }
    let mut leaking = own.to_vec();
    for (state, leak) in leaks.enumerate() {
        leaking[state * count + state] += leak;
    }
    solve_full(count, &leaking, [&unit]).map_or_else(|| vec![0.0; count * count], |[inverse]| inverse)
}
