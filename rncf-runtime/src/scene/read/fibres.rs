//! Torsion and the force along an axis: fibres of a twisted section are longer than its axis, `e + r^2 (tau^2 - tau_0^2) / 2`, so that tension makes
//! torsion stiffer, untwists what is pretwisted, and pressure buckles open sections in torsion (the effects of Wagner and of a trapeze). A `beam` of
//! a shape and a material in `young` has the two apart; a material by its `energy` has them together.

use crate::emitted::{Interpolant, SectionShape, SectionSpec};
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::scene::bodies::place::weighted;
use crate::space::Vector;

/// Part of the stiffness of torsion from which on it is told that it is left out.
const TOLD: f64 = 0.02;

/// Elements of a body that are looked at, about: the first one in any case, where most pulls.
const LOOKS: usize = 8;

/// What fibres add to the stiffness of torsion.
struct Added {
    /// Of the stiffness; negative under pressure.
    part: f64,
    /// m
    x: f64,
}

impl MeshScene {
    /// Bodies whose torsion feels much of the force along them at the loaded state, one of each name.
    pub(crate) fn apart_from_fibres(&self) -> Vec<Warning> {
        let mut warnings: Vec<(&str, Warning)> = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let spec = &body.spec;
            if spec.dimension() == 2 || !spec.has_section() {
                continue;
            }
            let Some(added) = self.added_by_fibres(index).filter(|added| added.part.abs() > TOLD) else {
                continue;
            };
            let weight = added.part.abs();
            let (more, what) = match added.part > 0.0 {
                true => ("more", "torsional frequencies are too low and twists too large"),
                false => (
                    "less",
                    "torsional frequencies are too high, twists too small, and it may buckle in torsion",
                ),
            };
            let text = format!(
                "body `{}`: by the force along it, or its twist, its section is {more} stiff in torsion by {:.1} % at x = {:.4} m, which a `beam` of a shape and `young` leaves out: {what}, and a pretwist stays that untwists. Give its material by `energy`, which has it",
                spec.label(),
                100.0 * weight,
                added.x
            );
            let warning = Warning { text, weight };
            match warnings.iter_mut().find(|(name, _)| *name == spec.name) {
                Some((_, other)) if other.weight < weight => *other = warning,
                Some(_) => {}
                None => warnings.push((spec.name, warning)),
            }
        }
        warnings.into_iter().map(|(_, warning)| warning).collect()
    }

    /// What the fibres of a body add most, in the middle of one of its elements; nothing where its material or torsion is not known.
    fn added_by_fibres(&self, index: usize) -> Option<Added> {
        let (spec, connectivity) = (&self.bodies[index].spec, &self.bodies[index].connectivity);
        let length = spec.line.length();
        let is_even = !self.parts.varies(index);
        let mut section = self.section_of(index).spec;
        if section.young_over_shear == 0.0 {
            return None;
        }
        let mut weights = vec![0.0; spec.nodal.len()];
        let mut most: Option<Added> = None;
        for element in (0..spec.count).step_by((spec.count / LOOKS).max(1)) {
            let x = spec.arclength_of(length, element, 0.5);
            if !is_even {
                section = self.parts.section(index, x, length);
            }
            if !(section.young_over_shear > 0.0 && section.torsion_constant > 0.0) {
                return None;
            }
            let components = connectivity.element(element);
            let mut fields = |of: Interpolant, order: usize| {
                weights.fill(0.0);
                self.parts.shapes(index, element, of, order, 0.5, &mut weights);
                let free = weights.iter().enumerate();
                let free = free.fold(Vector::zeros(), |sum, (local, &weight)| {
                    sum + weight * spec.undeformed_vector(element, local)
                });
                [Vector::from(weighted(&self.buffers.q, components, 3, &weights)), free]
            };
            let slope = fields(Interpolant::Position, 1);
            let strain = slope[0].norm() / slope[1].norm() - 1.0;
            let mut twist = [0.0; 2];
            if let SectionShape::Rectangle { .. } = section.shape {
                let [y, z] =
                    [Interpolant::SectionY, Interpolant::SectionZ].map(|axis| [0, 1].map(|order| fields(axis, order)));
                // Of the state and of the stress-free shape.
                twist = [0, 1].map(|which| 0.5 * (y[1][which].dot(&z[0][which]) - z[1][which].dot(&y[0][which])));
            }
            let part = added(&section, strain, twist);
            if most.as_ref().is_none_or(|most| part.abs() > most.part.abs()) {
                most = Some(Added { part, x });
            }
        }
        most
    }
}

/// Part of the stiffness G J that the fibres add at a strain of the axis and twists, 1/m, of now and of the stress-free shape:
/// `(E / G) (I_p e + (I_4 - I_p^2 / A) (tau^2 - tau_0^2) / 2) / J` with `I_4 = int r^4 dA`.
fn added(section: &SectionSpec, strain: f64, [twist, free]: [f64; 2]) -> f64 {
    let polar: f64 = section.second_moments.iter().sum();
    let beyond = match section.shape {
        // Of a shape that is not known, at least nothing; of what is round, next to nothing.
        SectionShape::General { .. }
        | SectionShape::Numbers { .. }
        | SectionShape::Circle { .. }
        | SectionShape::Tube { .. } => 0.0,
        SectionShape::Rectangle { sizes: [b, t] } => section.area * (b.powi(4) + t.powi(4)) / 180.0,
    };
    let fibres = polar * strain + 0.5 * beyond * (twist * twist - free * free);
    section.young_over_shear * fibres / section.torsion_constant
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_is_stiffened_by_tension_as_by_two_threads() {
        let (b, t) = (0.1, 0.002);
        let section = SectionSpec {
            shape: SectionShape::Rectangle { sizes: [b, t] },
            area: b * t,
            second_moments: [b * t * t * t / 12.0, t * b * b * b / 12.0],
            torsion_constant: b * t * t * t / 3.0 * (1.0 - 0.63 * t / b),
            young_over_shear: 2.6,
            ..SectionSpec::NONE
        };
        // sigma = 200 MPa of 210 GPa: N I_p / (A G J).
        let polar: f64 = section.second_moments.iter().sum();
        let exact = 200e6 * polar / (210e9 / 2.6 * section.torsion_constant);
        assert!((added(&section, 200.0 / 210e3, [0.0; 2]) / exact - 1.0).abs() < 1e-12);
        // int r^4 dA - I_p^2 / A by sums.
        let count = 200;
        let step = [b / f64::from(count), t / f64::from(count)];
        let place = |size: f64, at: i32| size * ((f64::from(at) + 0.5) / f64::from(count) - 0.5);
        let mut fourth = 0.0;
        for i in 0..count {
            for j in 0..count {
                fourth += (place(b, i).powi(2) + place(t, j).powi(2)).powi(2) * step[0] * step[1];
            }
        }
        let twist: f64 = 0.5;
        let exact = 2.6 * 0.5 * (fourth - polar * polar / (b * t)) * twist.powi(2) / section.torsion_constant;
        assert!((added(&section, 0.0, [twist, 0.0]) / exact - 1.0).abs() < 1e-3);
    }
}
