//! What colours the bodies of an animation: what their sections carry, from place to place and over the run.

use crate::Scene;
use crate::app::writing::numbers::{digits, with_prefix};
use crate::archive::{Archive, Keep};
use crate::model::{Curve, SectionBody, SectionState};

/// A number of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// N, tension is positive.
    AxialForce,
    /// Magnitude, N.
    ShearForce,
    /// N m.
    Torque,
    /// Magnitude, N m.
    BendingMoment,
    /// Of the axis, by the section's flexibility.
    Strain,
    /// The largest of the section, Pa.
    Stress,
}

impl Quantity {
    const ALL: [Self; 6] = [
        Self::AxialForce,
        Self::Strain,
        Self::Stress,
        Self::BendingMoment,
        Self::ShearForce,
        Self::Torque,
    ];

    /// Name and unit.
    pub fn told(self) -> (&'static str, &'static str) {
        match self {
            Self::AxialForce => ("axial force", "N"),
            Self::ShearForce => ("shear force", "N"),
            Self::Torque => ("torque", "N m"),
            Self::BendingMoment => ("bending moment", "N m"),
            Self::Strain => ("axial strain", "1"),
            Self::Stress => ("stress", "Pa"),
        }
    }

    fn is_known(self, body: &SectionBody, compliances: &[[f64; 6]]) -> bool {
        match self {
            Self::AxialForce | Self::BendingMoment => true,
            Self::ShearForce => body.has_section,
            Self::Torque => body.has_section && !body.is_planar,
            Self::Strain => compliances.iter().any(|row| *row != [0.0; 6]),
            Self::Stress => body.knows_stress || body.knows_area,
        }
    }

    fn value(self, body: &SectionBody, state: &SectionState, compliance: &[f64; 6]) -> Option<f64> {
        match self {
            Self::AxialForce => Some(state.forces[0]),
            Self::ShearForce => Some(state.shear_force()),
            Self::Torque => Some(state.moments[0]),
            Self::BendingMoment => Some(state.bending_moment()),
            Self::Strain => {
                let carried = state.forces.iter().chain(&state.moments);
                Some(carried.zip(compliance).map(|(force, by)| force * by).sum())
            }
            Self::Stress => body.stress_of(state),
        }
    }
}

/// Where a value was met.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Met {
    value: f64,
    t: f64,
    x: f64,
    body: usize,
}

impl Keep for Met {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { value, t, x, body } = self;
        value.keep(archive);
        t.keep(archive);
        x.keep(archive);
        body.keep(archive);
    }
}

/// A body with colours.
#[derive(Clone, Debug, PartialEq)]
struct Coloured {
    body: SectionBody,
    /// Its place among the curves.
    curve: usize,
    /// Number of the curve's points.
    points: usize,
    /// First row of its compliances.
    first: usize,
}

/// What colours the bodies.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Colours {
    bodies: Vec<Coloured>,
    compliances: Vec<[f64; 6]>,
    quantities: Vec<Quantity>,
    /// Least and greatest value of each quantity over rows and steps.
    ranges: Vec<[Option<Met>; 2]>,
}

/// The ranges; what is coloured is known.
impl Keep for Colours {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            bodies: _,
            compliances: _,
            quantities: _,
            ranges,
        } = self;
        archive.fixed(ranges);
    }
}

impl Colours {
    pub fn new(scene: &dyn Scene, curves: &[Curve]) -> Self {
        Self::of_bodies(scene.section_bodies(), scene.axial_compliances(), curves)
    }

    /// Of bodies with the compliances of all their section states.
    pub fn of_bodies(all: Vec<SectionBody>, mut compliances: Vec<[f64; 6]>, curves: &[Curve]) -> Self {
        let mut bodies = Vec::new();
        let mut first = 0;
        for body in all {
            let states = body.states;
            let curve = curves
                .iter()
                .position(|curve| curve.is_flexible && curve.name == body.name);
            if let Some(curve) =
                curve.filter(|_| body.elements > 0 && states.is_multiple_of(body.elements) && states > body.elements)
            {
                bodies.push(Coloured {
                    points: curves[curve].points,
                    body,
                    curve,
                    first,
                });
            }
            first += states;
        }
        compliances.resize(first, [0.0; 6]);
        let is_known = |quantity: &Quantity| {
            let own = |coloured: &Coloured| &compliances[coloured.first..][..coloured.body.states];
            bodies
                .iter()
                .any(|coloured| quantity.is_known(&coloured.body, own(coloured)))
        };
        let quantities: Vec<Quantity> = Quantity::ALL.into_iter().filter(is_known).collect();
        Self {
            ranges: vec![[None; 2]; quantities.len()],
            quantities,
            compliances,
            bodies,
        }
    }

    #[cfg(test)]
    pub fn bodies(&self) -> impl Iterator<Item = &SectionBody> {
        self.bodies.iter().map(|coloured| &coloured.body)
    }

    /// The coloured curves.
    pub fn curves(&self) -> impl Iterator<Item = usize> + '_ {
        self.bodies.iter().map(|coloured| coloured.curve)
    }

    /// Numbers of one picture.
    pub fn len(&self) -> usize {
        let points: usize = self.bodies.iter().map(|coloured| coloured.points).sum();
        points * self.quantities.len()
    }

    /// Takes in a row; the states are those of all bodies of [`Scene::section_states`].
    pub fn meet(&mut self, t: f64, states: &[SectionState]) {
        for (quantity, range) in self.quantities.iter().zip(&mut self.ranges) {
            for (number, coloured) in self.bodies.iter().enumerate() {
                let rows = coloured.first..coloured.first + coloured.body.states;
                let (Some(states), compliances) = (states.get(rows.clone()), &self.compliances[rows]) else {
                    return;
                };
                if !quantity.is_known(&coloured.body, compliances) {
                    continue;
                }
                for (state, compliance) in states.iter().zip(compliances) {
                    let Some(value) = quantity
                        .value(&coloured.body, state, compliance)
                        .filter(|x| x.is_finite())
                    else {
                        continue;
                    };
                    let (x, body) = (state.x, number);
                    for (side, met) in range.iter_mut().enumerate() {
                        if met.is_none_or(|met| {
                            if side == 0 {
                                value < met.value
                            } else {
                                value > met.value
                            }
                        }) {
                            *met = Some(Met { value, t, x, body });
                        }
                    }
                }
            }
        }
    }

    /// Values at the points of all coloured curves, quantity by quantity; NaN where one is not known.
    pub fn values(&self, states: &[SectionState]) -> Vec<f64> {
        let mut all = Vec::with_capacity(self.len());
        for quantity in &self.quantities {
            for coloured in &self.bodies {
                let rows = coloured.first..coloured.first + coloured.body.states;
                let compliances = &self.compliances[rows.clone()];
                let is_known = quantity.is_known(&coloured.body, compliances);
                let [pieces, places] =
                    [coloured.points - 1, coloured.body.states].map(|all| all / coloured.body.elements);
                for point in 0..coloured.points {
                    let element = (point / pieces).min(coloured.body.elements - 1);
                    let at = |place: usize| {
                        let row = places * element + place;
                        let state = states.get(rows.start + row).filter(|_| is_known)?;
                        quantity.value(&coloured.body, state, &compliances[row])
                    };
                    // Between places that are equally far from each other.
                    let place = (places - 1) as f64 * (point - element * pieces) as f64 / pieces as f64;
                    let (below, part) = (place.floor() as usize, place.fract());
                    let value = if part == 0.0 {
                        at(below)
                    } else {
                        at(below).zip(at(below + 1)).map(|(a, b)| a + part * (b - a))
                    };
                    all.push(value.unwrap_or(f64::NAN));
                }
            }
        }
        all
    }

    /// The quantities with their least and greatest values over rows and steps, and a sentence about the largest magnitude; not those
    /// of which no value is known.
    pub fn scales(&self) -> Vec<Scale> {
        let told = |(quantity, range): (&Quantity, &[Option<Met>; 2])| {
            let [low, high] = *range;
            let (low, high) = (low?, high?);
            let (name, unit) = quantity.told();
            let most = if low.value.abs() > high.value.abs() { low } else { high };
            let value = if unit == "1" {
                digits(most.value, 4)
            } else {
                with_prefix(most.value, unit)
            };
            let body = &self.bodies[most.body].body.name;
            Some(Scale {
                name,
                unit,
                range: [low.value, high.value],
                largest: format!(
                    "largest {value} in {body} at x = {} m, t = {} s",
                    digits(most.x, 4),
                    digits(most.t, 6)
                ),
            })
        };
        self.quantities.iter().zip(&self.ranges).filter_map(told).collect()
    }

    /// What stress and strain are, in sentences.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.quantities.contains(&Quantity::Strain) {
            notes.push(
                "Axial strain is that of the section forces and moments by the flexibility of the undeformed section."
                    .into(),
            );
        }
        let axial = self
            .bodies
            .iter()
            .filter(|coloured| !coloured.body.knows_stress)
            .count();
        if self.quantities.contains(&Quantity::Stress) {
            notes.push(match axial {
                0 => "Stress is the largest von Mises stress over the section.".into(),
                all if all == self.bodies.len() => "Stress is that of the axial force alone.".into(),
                _ => "Stress is the largest von Mises stress over the section; that of the axial force alone where the section does not say where its outermost fibres are.".to_owned(),
            });
        }
        notes
    }

    /// Whether a quantity has a range.
    pub fn is_met(&self) -> impl Iterator<Item = bool> + '_ {
        self.ranges.iter().map(|range| range[0].is_some())
    }
}

/// The scale of a quantity that colours the bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Least and greatest value over rows and steps, SI.
    pub range: [f64; 2],
    /// The largest magnitude and where it is, in words.
    pub largest: String,
}
