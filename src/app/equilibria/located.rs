//! Critical values between two equilibria of a way: bracketed, and where no equilibrium comes near them, interpolated
//! between those that do; nothing is printed or written here.

use super::continuation::{Found, Line, Looked, Measure};
use super::directions::Measured;
use crate::modes::Critical;

/// Width to which critical values are bracketed, part of the way.
const WIDTH: f64 = 1e-7;
/// Distance, part of the way, from a place where values change their sign, at which they are looked at once more; and the part of them by which they
/// have fallen from there if it is zero that they pass.
const AWAY: f64 = 1e3 * WIDTH;
const FALLEN: f64 = 0.1;
/// Distance from the expected place, part of the bracket, at which it is looked at: it then lies on one side.
const ASIDE: f64 = 0.01;
/// Of so many looks one halves the bracket whatever is expected.
const HALVING: u32 = 3;

impl Line<'_> {
    /// Where between two equilibria the number of negative directions changes, in the order of the way; `measure`
    /// tells it at an equilibrium.
    pub fn critical(
        &mut self,
        [low, high]: [&Found; 2],
        [before, after]: [Measured; 2],
        measure: &mut Measure<'_>,
    ) -> Vec<Critical> {
        let end = |found: &Found, measured| Looked {
            share: found.share,
            state: found.state.clone(),
            measured,
        };
        let ends = [low.share, high.share];
        let mut found = Vec::new();
        let mut open = vec![([end(low, before), end(high, after)], 1)];
        while let Some(([low, high], looks)) = open.pop() {
            if low.measured.negative == high.measured.negative {
                continue;
            }
            if high.share - low.share <= WIDTH {
                if self.passes_zero([&low, &high], ends, measure) {
                    found.push(self.bracketed(&low, &high));
                }
                continue;
            }
            let middle = 0.5 * (low.share + high.share);
            let place = if looks % HALVING == 0 {
                middle
            } else {
                expected(&low, &high, looks).unwrap_or(middle)
            };
            let between = self
                .looked_at(place, &low.state, false, measure)
                .or_else(|| self.looked_at(place, &high.state, false, measure));
            if let Some(between) = between {
                open.push(([between.clone(), high], looks + 1));
                open.push(([low, between], looks + 1));
                continue;
            }
            // As near as equilibria are found from either side.
            let near = self.approached(&low, place, measure);
            let beyond = self.approached(&high, place, measure);
            if near.measured.negative != beyond.measured.negative {
                let gap = [&low, &near, &beyond, &high];
                let told = self
                    .interpolated(gap, measure)
                    .unwrap_or_else(|| self.bracketed(&near, &beyond));
                let edges = [near.share, beyond.share].map(|share| self.key(share));
                let is_narrow = beyond.share - near.share <= WIDTH;
                found.push(Critical {
                    open: (!is_narrow).then_some(edges),
                    ..told
                });
            }
            open.push(([beyond, high], 1));
            open.push(([low, near], 1));
        }
        let sense = (self.key(1.0) - self.key(0.0)).signum();
        found.sort_by(|a, b| (sense * a.value).total_cmp(&(sense * b.value)));
        found
    }

    /// Whether values that change their sign between two equilibria next to each other do so at zero: two negative ones that become a vibration
    /// which grows do not, and are as large a little away from there.
    fn passes_zero(&mut self, [low, high]: [&Looked; 2], [first, last]: [f64; 2], measure: &mut Measure<'_>) -> bool {
        let counts = [low, high].map(|end| end.measured.negative);
        let changing = counts[0].min(counts[1])..counts[0].max(counts[1]);
        if [low, high].iter().any(|end| end.measured.values.len() < changing.end) {
            return true;
        }
        let (place, from) = if low.share - AWAY >= first {
            (low.share - AWAY, low)
        } else {
            ((high.share + AWAY).min(last), high)
        };
        let away = self.looked_at(place, &from.state, true, measure);
        let Some(away) = away.filter(|away| away.measured.negative == from.measured.negative) else {
            return true;
        };
        let [before, after, away] = stiff([low, high, &away]).map(|values| {
            let changing = values.get(changing.clone()).unwrap_or_default();
            changing.iter().map(|value| value.abs()).fold(0.0, f64::max)
        });
        away == 0.0 || before.max(after) <= FALLEN * away
    }

    /// The critical value between two equilibria next to each other.
    fn bracketed(&self, low: &Looked, high: &Looked) -> Critical {
        let [first, last] = [low, high].map(|end| self.key(end.share));
        singular([low, high], 0.5 * (first + last), 0.5 * (last - first).abs())
    }

    /// The last equilibrium on the way from `from` towards a part of the way at which none was found.
    fn approached(&mut self, from: &Looked, towards: f64, measure: &mut Measure<'_>) -> Looked {
        let (mut last, mut beyond) = (from.clone(), towards);
        while (beyond - last.share).abs() > WIDTH {
            let middle = 0.5 * (last.share + beyond);
            match self.looked_at(middle, &last.state, false, measure) {
                Some(found) => last = found,
                None => beyond = middle,
            }
        }
        last
    }

    /// The critical value in a gap without equilibria, from the values of the stiffness at two equilibria on either side
    /// that are as far away from it as deflections are small. Its error is the sum of what each of the four
    /// changes.
    fn interpolated(&mut self, [low, near, beyond, high]: [&Looked; 4], measure: &mut Measure<'_>) -> Option<Critical> {
        let places = [
            low.share,
            0.5 * (low.share + near.share),
            0.5 * (beyond.share + high.share),
            high.share,
        ];
        let guesses = [low, low, high, high];
        let looks = places.into_iter().zip(guesses);
        let points: Vec<Looked> = looks
            .map(|(place, guess)| self.looked_at(place, &guess.state, true, measure))
            .collect::<Option<_>>()?;
        let [left, right] = [&points[1], &points[2]];
        let [before, after] = [left, right].map(|end| end.measured.negative);
        let crossing = before.min(after)..before.max(after);
        let is_same = [low, near].map(|end| end.measured.negative) == [before; 2]
            && [beyond, high].map(|end| end.measured.negative) == [after; 2];
        if !is_same {
            return None;
        }
        let mut roots = Vec::new();
        let mut error: f64 = 0.5 * WIDTH;
        let values = stiff([&points[0], &points[1], &points[2], &points[3]]);
        for index in crossing {
            let places = points.iter().zip(&values);
            let places = places.map(|(point, values)| Some((point.share, *values.get(index)?)));
            let all: Vec<(f64, f64)> = places.collect::<Option<_>>()?;
            let zero = root(&all, [left.share, right.share])?;
            let mut change = 0.0;
            for without in 0..all.len() {
                let mut fewer = all.clone();
                fewer.remove(without);
                change += (root(&fewer, [left.share, right.share])? - zero).abs();
            }
            error = error.max(change);
            roots.push(zero);
        }
        let [least, most] = [f64::min, f64::max].map(|pick| roots.iter().copied().reduce(pick));
        let (least, most) = (least?, most?);
        let is_inside = near.share - error <= least && most <= beyond.share + error;
        let [first, last] = [least - error, most + error].map(|share| self.key(share));
        let within = 0.5 * (last - first).abs();
        is_inside.then(|| singular([left, right], self.key(0.5 * (least + most)), within))
    }
}

/// The values of the stiffness at equilibria without those of what moves without stiffness at each of them, ascending.
fn stiff<const N: usize>(looks: [&Looked; N]) -> [Vec<f64>; N] {
    let zeros = looks.map(|looked| looked.measured.values.iter().filter(|&&value| value == 0.0).count());
    let common = zeros.into_iter().min().unwrap_or(0);
    looks.map(|looked| {
        let mut values = looked.measured.values.clone();
        let first = values.partition_point(|&value| value < 0.0);
        values.drain(first..first + common);
        values
    })
}

/// What of the stiffness becomes singular between two equilibria, at a value and how far off that may be.
fn singular([low, high]: [&Looked; 2], value: f64, within: f64) -> Critical {
    let rise = high.measured.negative as isize - low.measured.negative as isize;
    let circulates = low.measured.circulates || high.measured.circulates;
    Critical {
        value,
        change: if circulates { rise.abs() } else { rise },
        circulates,
        within,
        open: None,
    }
}

/// Where the value that changes its sign between two equilibria is expected to be zero, a little aside to either side by turns.
fn expected(low: &Looked, high: &Looked, looks: u32) -> Option<f64> {
    let index = low.measured.negative.min(high.measured.negative);
    let [first, last] = stiff([low, high]).map(|values| values.get(index).copied());
    let (first, last) = (first?, last?);
    let width = high.share - low.share;
    let aside = (ASIDE * width).max(0.4 * WIDTH);
    let side = if looks.is_multiple_of(2) { aside } else { -aside };
    let place = low.share + first / (first - last) * width + side;
    let place = place.clamp(low.share + aside, high.share - aside);
    place.is_finite().then_some(place)
}

/// The zero between two places of the polynomial through points, by halving.
fn root(points: &[(f64, f64)], [mut low, mut high]: [f64; 2]) -> Option<f64> {
    let value = |x: f64| -> f64 {
        let part = |&(place, value): &(f64, f64)| {
            let others = points.iter().filter(|other| other.0 != place);
            value * others.map(|other| (x - other.0) / (place - other.0)).product::<f64>()
        };
        points.iter().map(part).sum()
    };
    let first = value(low);
    if (first > 0.0) == (value(high) > 0.0) {
        return None;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (value(middle) > 0.0) == (first > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}
