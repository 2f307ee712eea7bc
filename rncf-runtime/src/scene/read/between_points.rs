//! Loads per length that are narrower than the distance of the points at which elements look at them. Between points they leave no trace: a run, its copy with
//! other steps and often that with twice as many elements agree on what is missing. Bounds over an element tell of it.

use crate::course::{Courses, Interval};
use crate::emitted::legendre;
use crate::model::Warning;
use crate::scene::MeshScene;

/// A load may leave what it is at the points of an element and its neighbours by so many times the width of that: then its points feel it, and other meshes
/// tell how well;
const BEYOND: f64 = 10.0;
/// and by this part of all that it is on the axis: the foot of what comes over an end is none of its peaks.
const LEAST: f64 = 0.05;
/// Halvings of an element in search of what its points miss.
const DEEPEST: u32 = 40;
const EVALUATIONS: u32 = 1000;

impl MeshScene {
    /// Loads per length that points miss at a time, s.
    pub(crate) fn between_points(&self, t: f64) -> Vec<Warning> {
        let mut warnings = Vec::new();
        for (load, spec) in self.parts.distributed().iter().enumerate() {
            let (body, length) = (&self.bodies[spec.body].spec, self.bodies[spec.body].spec.line.length());
            let course = |x: f64| self.parts.distributed_course(load, [x, length]);
            let rule = legendre(spec.points);
            let elements = (0..body.count).map(|element| {
                let [from, middle, to] = [0.0, 0.5, 1.0].map(|xi| body.arclength(element, xi));
                let points = rule.iter().map(|(xi, _)| body.arclength(element, *xi));
                let points = points.filter_map(course).collect();
                Some(Element {
                    places: Interval::new(from, to),
                    points,
                    course: course(middle)?,
                })
            });
            let Some(elements) = elements.collect::<Option<Vec<Element>>>() else {
                continue;
            };
            if let Some(missed) = missed(&elements, t) {
                warnings.push(Warning {
                    text: format!(
                        "load `{}` is narrower than the distance of the points at which elements of body `{}` look at it: near x = {:.4} m of {length:.4} m it has values that none of them sees. \
                         Take more elements in `mesh` or more `points`, a wider load, or a `force` where it acts at one place",
                        spec.name,
                        body.label(),
                        missed.place,
                    ),
                    weight: missed.part,
                });
            }
        }
        warnings
    }
}

/// What a load is on an element.
struct Element {
    /// m
    places: Interval,
    points: Vec<Courses>,
    course: Courses,
}

/// What no point sees.
#[derive(Clone, Copy, Debug)]
struct Missed {
    /// m
    place: f64,
    /// Of all that the load is.
    part: f64,
}

/// The largest part of a load that its points miss.
fn missed(elements: &[Element], t: f64) -> Option<Missed> {
    let count = elements.first()?.course.functions.len();
    let mut found = (0..count).filter_map(|function| {
        Look {
            t,
            function,
            left: EVALUATIONS,
        }
        .missed(elements)
    });
    let first = found.next()?;
    Some(found.fold(first, |most, other| if other.part > most.part { other } else { most }))
}

/// One function of a load at a time.
struct Look {
    /// s
    t: f64,
    function: usize,
    /// Bounds that may still be found.
    left: u32,
}

impl Look {
    fn bounds(&self, course: &Courses, places: Interval) -> Interval {
        self.bounds_at(Interval::point(self.t), course, places)
    }

    fn bounds_at(&self, times: Interval, course: &Courses, places: Interval) -> Interval {
        let mut all = Vec::new();
        course.bounds_along(times, places, &mut all);
        all[course.functions[self.function].1]
    }

    /// Width of all that the load is, at any time where that has bounds.
    fn width(&self, elements: &[Element]) -> f64 {
        let width = |times: Interval| {
            let whole = elements
                .iter()
                .map(|one| self.bounds_at(times, &one.course, one.places));
            whole.reduce(Interval::hull).map_or(0.0, Interval::width)
        };
        let ever = width(Interval::new(0.0, f64::INFINITY));
        if ever.is_finite() {
            ever
        } else {
            width(Interval::point(self.t))
        }
    }

    fn missed(mut self, elements: &[Element]) -> Option<Missed> {
        let seen = |element: &Element| {
            let values = element.points.iter();
            values
                .map(|course| self.bounds(course, Interval::point(course.place)))
                .reduce(Interval::hull)
        };
        let seen: Vec<Interval> = elements.iter().map(seen).collect::<Option<_>>()?;
        let all = self.width(elements);
        if all == 0.0 || !all.is_finite() {
            return None;
        }
        let mut most: Option<Missed> = None;
        for (index, element) in elements.iter().enumerate() {
            let near = &seen[index.saturating_sub(1)..(index + 2).min(seen.len())];
            let near = near.iter().copied().reduce(Interval::hull)?;
            let margin = BEYOND * near.width() + LEAST * all;
            let allowed = Interval::new(near.low - margin, near.high + margin);
            let Some(place) = self.outside(&element.course, element.places, allowed, 0) else {
                continue;
            };
            let value = self.bounds(&element.course, Interval::point(place));
            let part = (value.low - near.high).max(near.low - value.low) / all;
            if most.is_none_or(|most| part > most.part) {
                most = Some(Missed { place, part });
            }
        }
        most
    }

    /// A place where a value is outside of what is allowed.
    fn outside(&mut self, course: &Courses, places: Interval, allowed: Interval, depth: u32) -> Option<f64> {
        if self.left == 0 || allowed.contains(self.bounds(course, places)) {
            return None;
        }
        self.left -= 1;
        let middle = 0.5 * (places.low + places.high);
        if !allowed.contains(self.bounds(course, Interval::point(middle))) {
            return Some(middle);
        }
        if depth == DEEPEST || middle <= places.low || middle >= places.high {
            return None;
        }
        self.outside(course, Interval::new(places.low, middle), allowed, depth + 1)
            .or_else(|| self.outside(course, Interval::new(middle, places.high), allowed, depth + 1))
    }
}
