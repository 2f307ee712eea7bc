//! Properties along an axis that elements do not see: a notch or a lump between their points of integration leaves no trace, and a copy with
//! twice as many elements misses it, too. Places between the points tell of it.

use crate::emitted::legendre;
use crate::model::Warning;
use crate::scene::MeshScene;

/// Points of an element.
const POINTS: usize = 5;
/// Places of a body that are looked at, and of an element at least; those of the rows of its tables beside them.
const PLACES: usize = 512;
const LEAST: usize = 8;
/// Distance from a step at which its two values are read, as a part of an element.
const STEP: f64 = 1e-9;
/// Part of a property, or of its inverse, summed along the axis, from which on it is told that points miss it.
const TOLD: f64 = 0.01;
/// Properties by whose inverse a body yields.
const RESIST: [&str; 24] = [
    "young",
    "area",
    "second_moment",
    "second_moment_y",
    "second_moment_z",
    "torsion_constant",
    "shear_factor_y",
    "shear_factor_z",
    "radius",
    "thickness",
    "size_y",
    "size_z",
    "EA",
    "GAy",
    "GAz",
    "GJ",
    "EIy",
    "EIz",
    "K11",
    "K22",
    "K33",
    "K44",
    "K55",
    "K66",
];

impl MeshScene {
    /// Bodies whose elements miss some of their properties.
    pub(crate) fn missed_within_elements(&self) -> Vec<Warning> {
        self.one_of_each_name(|body| {
            let missed = self.missed_of(body)?;
            let spec = &self.bodies[body].spec;
            Some(Warning {
                text: format!(
                    "body `{}`: its section or material changes between the points at which elements look at it: near x = {:.4} m of {:.4} m, and {:.1} % of {}, summed along the axis, are missed. \
                     Take more elements in `mesh`, nodes where it changes (`mesh at`), or a `fixture` or body of its own for what is narrow",
                    spec.label(),
                    missed.place,
                    spec.line.length(),
                    100.0 * missed.part,
                    missed.what,
                ),
                weight: missed.part,
            })
        })
    }

    /// The property of a body of which most is missed.
    fn missed_of(&self, body: usize) -> Option<Missed> {
        let spec = &self.bodies[body].spec;
        let length = spec.line.length();
        let at = |x: f64| -> Vec<f64> {
            let properties = self.parts.properties(body, x, length).into_iter();
            properties.map(|(_, value)| value).collect()
        };
        let properties = self.parts.properties(body, 0.0, length).into_iter();
        let names: Vec<&str> = properties.map(|(name, _)| name).collect();
        if names.is_empty() {
            return None;
        }
        let rows = self.parts.tables(body).into_iter().flat_map(|table| {
            let unit = if table.is_relative { length } else { 1.0 };
            table.places.iter().map(move |place| place * unit)
        });
        let mut rows: Vec<f64> = rows.collect();
        rows.sort_by(f64::total_cmp);
        let rule = legendre(POINTS);
        let places = (PLACES / spec.count.max(1)).max(LEAST);
        let elements: Vec<Element> = (0..spec.count)
            .map(|element| {
                let [from, to] = [0.0, 1.0].map(|xi| spec.arclength_of(length, element, xi));
                let points = rule.iter().map(|&(xi, weight)| (at(from + xi * (to - from)), weight));
                // At a step the value behind it is that of another element, or of another part of this one.
                let beside = STEP * (to - from);
                let inside = rows.iter().flat_map(|row| [row - beside, row + beside]);
                let even = (0..=places).map(|place| from + (to - from) * place as f64 / places as f64);
                let all = even.map(|x| x.clamp(from + beside, to - beside)).chain(inside);
                let mut seen: Vec<f64> = all.filter(|x| (from..to).contains(x)).collect();
                seen.sort_by(f64::total_cmp);
                Element {
                    width: to - from,
                    points: points.collect(),
                    seen: seen.into_iter().map(|x| (x, at(x))).collect(),
                }
            })
            .collect();
        let found = names.iter().enumerate().flat_map(|(property, name)| {
            let itself = missed(&elements, property, |value| value).map(|missed| (missed, format!("`{name}`")));
            let inverse = RESIST.contains(name).then(|| missed(&elements, property, f64::recip));
            let inverse = inverse
                .flatten()
                .map(|missed| (missed, format!("the inverse of `{name}`")));
            [itself, inverse]
        });
        found
            .flatten()
            .map(|((place, part), what)| Missed { place, part, what })
            .reduce(|most, other| if other.part > most.part { other } else { most })
            .filter(|missed| missed.part > TOLD)
    }
}

/// What an element has.
struct Element {
    /// m
    width: f64,
    /// Properties at the points, with their weights.
    points: Vec<(Vec<f64>, f64)>,
    /// Places, m, ascending, and the properties there.
    seen: Vec<(f64, Vec<f64>)>,
}

/// What points miss.
struct Missed {
    /// Where the property is farthest from what they see, m.
    place: f64,
    /// Of its sum along the axis.
    part: f64,
    /// Of what.
    what: String,
}

/// What the points of all elements miss of a function of a property that is positive everywhere: where most, m, and the part of its sum along the axis.
fn missed(elements: &[Element], property: usize, of: fn(f64) -> f64) -> Option<(f64, f64)> {
    let (mut sum, mut off, mut most, mut place) = (0.0, 0.0, 0.0, 0.0);
    for element in elements {
        if element
            .seen
            .iter()
            .any(|(_, values)| values[property].is_nan() || values[property] <= 0.0)
        {
            return None;
        }
        let points = element
            .points
            .iter()
            .map(|(values, weight)| weight * of(values[property]));
        let mean: f64 = points.sum();
        let spans = element.seen.windows(2).map(|ends| {
            let [(x, before), (next, after)] = [&ends[0], &ends[1]];
            0.5 * (next - x) * (of(before[property]) + of(after[property]))
        });
        let whole: f64 = spans.sum();
        let error = (whole - element.width * mean).abs();
        sum += whole;
        off += error;
        if error > most {
            most = error;
            let far = |values: &[f64]| (of(values[property]) - mean).abs();
            let farthest = element.seen.iter().max_by(|a, b| far(&a.1).total_cmp(&far(&b.1)))?;
            place = farthest.0;
        }
    }
    let part = off / sum;
    part.is_finite().then_some((place, part))
}
