//! Largest von Mises stress over a section from the forces and moments on it: `sqrt(s^2 + 3 t^2)` at the
//! points of its rim where it can be largest. Normal stresses are `N/A + M_y Z/I_yy - M_z Y/I_zz`, shear stresses those
//! of Saint-Venant's torsion and, at the neutral axis, of the shear forces.

use crate::emitted::SectionShape;
use crate::scene::bodies::section::{PLACES, Section, place};
use crate::space::magnitude;

/// Forces (N, Q_y, Q_z) and moments (T, M_y, M_z) on a section with its constants.
struct Loaded<'a> {
    section: &'a Section,
    forces: [f64; 3],
    moments: [f64; 3],
}

/// The largest von Mises stress, Pa; `None` where what is needed of the section is not known: an extent,
/// in a plane that along y alone, or a constant. That of a general section is an upper bound for solid
/// ones, and for those of which a web carries the shear force: all that bends at one corner of its extents, the torsion of a strip as thick as its
/// lesser extent, and in the web the shear force over `k A`, beside all that bends.
pub fn largest_stress(section: &Section, is_planar: bool, forces: [f64; 3], moments: [f64; 3]) -> Option<f64> {
    let loaded = Loaded {
        section,
        forces,
        moments,
    };
    let stress = match section.spec.shape {
        SectionShape::Circle { radius } => loaded.round(radius, 4.0 / 3.0),
        // Thin: twice the mean shear stress.
        SectionShape::Tube { radius, .. } => loaded.round(radius, 2.0),
        SectionShape::Rectangle { sizes } => loaded.rectangle(sizes),
        SectionShape::General {
            extent: [y, z],
            shear_factors,
        } => {
            let z = if is_planar { Some(z.unwrap_or(0.0)) } else { z };
            loaded.general([y?, z?], shear_factors)
        }
        SectionShape::Numbers { .. } => return None,
    };
    stress.filter(|stress| stress.is_finite())
}

fn von_mises(normal: f64, shear: f64) -> f64 {
    magnitude(normal, 3.0f64.sqrt() * shear)
}

/// Places around the rim of a circle at which normal and shear stresses are looked at together.
const AROUND: usize = 32;
/// Part by which the largest normal and shear stresses, were they in one place, must pass what single places have.
const MORE: f64 = 1e-3;
/// Largest shear stress of a solid section over the mean one.
const SOLID: f64 = 1.5;

impl Loaded<'_> {
    /// `load / constant`; `None` where the constant is not known.
    fn over(load: f64, constant: f64) -> Option<f64> {
        if load == 0.0 {
            return Some(0.0);
        }
        (constant > 0.0).then(|| load / constant)
    }

    /// Normal stress on the axis; its derivatives along y and z; and T/J.
    fn gradients(&self) -> Option<[f64; 4]> {
        let [torque, moment_y, moment_z] = self.moments;
        let [about_y, about_z] = self.section.spec.second_moments;
        Some([
            Self::over(self.forces[0], self.section.spec.area)?,
            -Self::over(moment_z, about_z)?,
            Self::over(moment_y, about_y)?,
            Self::over(torque, self.section.spec.torsion_constant)?,
        ])
    }

    /// Mean shear stresses along y and z.
    fn mean_shears(&self) -> Option<[f64; 2]> {
        let [_, y, z] = self.forces;
        Some([
            Self::over(y, self.section.spec.area)?,
            Self::over(z, self.section.spec.area)?,
        ])
    }

    /// A circle or tube: the rim where it bends most, and where the shear force acts most; `factor` is the
    /// shear stress there over the mean one.
    fn round(&self, radius: f64, factor: f64) -> Option<f64> {
        let [axial, by_y, by_z, twist] = self.gradients()?;
        let torsion = radius * twist;
        let outermost = von_mises(axial.abs() + radius * magnitude(by_y, by_z), torsion);
        let [y, z] = self.mean_shears()?;
        let shear = magnitude(y, z);
        if shear == 0.0 {
            return Some(outermost);
        }
        // Along the rim the shear force has its part across the radius. At both ends of the diameter normal to it that is all of it; torsion adds
        // at one and subtracts at the other.
        let at = |cosine: f64, sine: f64| {
            let normal = axial + radius * (by_y * cosine + by_z * sine);
            von_mises(normal, torsion + factor * (z * cosine - y * sine))
        };
        let [cosine, sine] = [z / shear, -y / shear];
        let found = outermost.max(at(cosine, sine)).max(at(-cosine, -sine));
        let bound = von_mises(
            axial.abs() + radius * magnitude(by_y, by_z),
            torsion.abs() + factor * shear,
        );
        if bound <= found * (1.0 + MORE) {
            return Some(found);
        }
        let angles = (0..AROUND).map(|place| std::f64::consts::TAU * place as f64 / AROUND as f64);
        Some(angles.fold(found, |found, angle| found.max(at(angle.cos(), angle.sin()))))
    }

    /// A rectangle: its middle, corners, and places along its sides.
    fn rectangle(&self, [height, width]: [f64; 2]) -> Option<f64> {
        let [axial, by_y, by_z, twist] = self.gradients()?;
        let [y, z] = self.mean_shears()?.map(|shear| SOLID * shear);
        let [at_y, at_z] = if twist == 0.0 {
            [[0.0; PLACES]; 2]
        } else {
            self.section
                .torsion_along_sides()
                .map(|along| along.map(|factor| factor * twist))
        };
        let (up, aside) = (0.5 * height * by_y, 0.5 * width * by_z);
        let corner = axial.abs() + up.abs() + aside.abs();
        // At a place of two sides, on the way to one of their corners; the shear force along a side acts as a parabola.
        let at = |index: usize, side: f64, way: f64| {
            let place = place(index);
            let parabola = 1.0 - place * place;
            let of_y = von_mises(
                axial + side * up + way * place * aside,
                parabola * z + side * at_y[index],
            );
            let of_z = von_mises(
                axial + side * aside + way * place * up,
                parabola * y - side * at_z[index],
            );
            of_y.max(of_z)
        };
        let middle = corner.max(von_mises(axial, magnitude(y, z)));
        let found = middle.max(at(0, 1.0, 1.0)).max(at(0, -1.0, 1.0));
        let shear = (y.abs() + at_z[0].abs()).max(z.abs() + at_y[0].abs());
        if von_mises(corner, shear) <= found * (1.0 + MORE) {
            return Some(found);
        }
        let ways = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let along = (1..PLACES).flat_map(|index| ways.map(|[side, way]| at(index, side, way)));
        Some(along.fold(found, f64::max))
    }

    fn general(&self, [y, z]: [f64; 2], shear_factors: [f64; 2]) -> Option<f64> {
        let [axial, by_y, by_z, twist] = self.gradients()?;
        let [mean_y, mean_z] = self.mean_shears()?;
        let webs = shear_factors.map(|factor| if factor > 0.0 { 1.0 / factor } else { 0.0 });
        let [shear_y, shear_z] = [SOLID.max(webs[0]) * mean_y, SOLID.max(webs[1]) * mean_z];
        let torsion = (2.0 * y.min(z) * twist).abs();
        let outermost = axial.abs() + y * by_y.abs() + z * by_z.abs();
        let middle = von_mises(axial, magnitude(shear_y, shear_z) + torsion);
        // A web goes up to where it bends most.
        let [web_y, web_z] = [0, 1].map(|axis| {
            let is_thin = webs[axis] > SOLID;
            if is_thin { [shear_y, shear_z][axis] } else { 0.0 }
        });
        Some(von_mises(outermost, magnitude(web_y, web_z) + torsion).max(middle))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use crate::emitted::SectionSpec;
    use crate::scene::read::stress::*;

    fn section(shape: SectionShape, area: f64, second_moments: [f64; 2], torsion_constant: f64) -> Section {
        Section::new(SectionSpec {
            shape,
            area,
            second_moments,
            torsion_constant,
            young_over_shear: 0.0,
            softness_of_curves: 0.0,
            yield_stress: None,
            material: "steel",
        })
    }

    fn circle(radius: f64) -> Section {
        let fourth = 0.25 * PI * radius.powi(4);
        section(
            SectionShape::Circle { radius },
            PI * radius * radius,
            [fourth; 2],
            2.0 * fourth,
        )
    }

    fn rectangle(h: f64, w: f64, torsion_constant: f64) -> Section {
        let sizes = [h, w];
        let moments = [h * w.powi(3) / 12.0, w * h.powi(3) / 12.0];
        section(SectionShape::Rectangle { sizes }, h * w, moments, torsion_constant)
    }

    fn stress(section: &Section, forces: [f64; 3], moments: [f64; 3]) -> f64 {
        largest_stress(section, false, forces, moments).expect("all is known")
    }

    fn near(found: f64, wanted: f64, relative: f64) {
        assert!((found / wanted - 1.0).abs() < relative, "{found} instead of {wanted}");
    }

    #[test]
    fn a_shaft_under_bending_and_torsion_has_the_stress_of_handbooks() {
        // d = 40 mm: s = 32 M/(pi d^3), t = 16 T/(pi d^3).
        let d: f64 = 0.04;
        let (m, t) = (300.0, 400.0);
        let (normal, shear) = (32.0 * m / (PI * d.powi(3)), 16.0 * t / (PI * d.powi(3)));
        let wanted = (normal * normal + 3.0 * shear * shear).sqrt();
        near(stress(&circle(0.02), [0.0; 3], [t, 0.0, m]), wanted, 1e-14);
        near(stress(&circle(0.02), [0.0; 3], [-t, 0.6 * m, -0.8 * m]), wanted, 1e-14);
        // Tension adds on one side, compression on the other.
        let area = PI * d * d / 4.0;
        for pull in [5e3, -5e3] {
            near(
                stress(&circle(0.02), [pull, 0.0, 0.0], [0.0, m, 0.0]),
                normal + 5e3 / area,
                1e-14,
            );
        }
    }

    #[test]
    fn shear_counts_at_the_neutral_axis_and_adds_to_torsion() {
        let r: f64 = 0.01;
        let (q, area) = (2e3, PI * 1e-4);
        near(
            stress(&circle(r), [0.0, q, 0.0], [0.0; 3]),
            3.0f64.sqrt() * 4.0 / 3.0 * q / area,
            1e-14,
        );
        let torsion = 2.0 * 5.0 / (PI * r.powi(3));
        for torque in [5.0, -5.0] {
            let wanted = 3.0f64.sqrt() * (4.0 / 3.0 * q / area + torsion);
            near(
                stress(&circle(r), [0.0, 0.6 * q, -0.8 * q], [torque, 0.0, 0.0]),
                wanted,
                1e-14,
            );
        }
        let tube = SectionShape::Tube {
            radius: 0.05,
            thickness: 1e-3,
        };
        let tube = section(tube, 3.1e-4, [3.8e-7; 2], 7.6e-7);
        near(
            stress(&tube, [0.0, 0.0, 100.0], [0.0; 3]),
            3.0f64.sqrt() * 200.0 / 3.1e-4,
            1e-14,
        );
    }

    #[test]
    fn a_rectangle_bends_at_its_corners_and_twists_at_its_longer_sides() {
        let (h, w) = (0.03, 0.02);
        let strip = rectangle(h, w, 1.0);
        let wanted = 6.0 * 10.0 / (w * h * h) + 6.0 * 7.0 / (h * w * w) + 100.0 / (h * w);
        near(stress(&strip, [-100.0, 0.0, 0.0], [0.0, -7.0, 10.0]), wanted, 1e-14);
        near(
            stress(&strip, [0.0, 0.0, 90.0], [0.0; 3]),
            3.0f64.sqrt() * 1.5 * 90.0 / (h * w),
            1e-14,
        );
        // Handbook: t = T/(c1 a b^2), J = c2 a b^3, a/b = 1.5: c1 = 0.2310, c2 = 0.1958; short sides 0.859 of it.
        let strip = rectangle(h, w, 0.1958 * h * w.powi(3));
        let on_long = 5.0 / (0.2310 * h * w * w);
        near(stress(&strip, [0.0; 3], [5.0, 0.0, 0.0]), 3.0f64.sqrt() * on_long, 1e-3);
    }

    #[test]
    fn bending_at_the_side_of_a_rectangle_combines_with_torsion_there() {
        // Wider than high: torsion is largest at +-h/2, where M_z bends.
        let (h, w) = (0.01, 0.04);
        let strip = rectangle(h, w, 0.2808 * w * h.powi(3));
        let normal = 6.0 * 3.0 / (w * h * h);
        let shear = 4.0 / (0.282 * w * h * h);
        let wanted = normal.hypot(3.0f64.sqrt() * shear);
        near(stress(&strip, [0.0; 3], [4.0, 0.0, 3.0]), wanted, 2e-3);
    }

    /// Solutions of Prandtl's equation by finite differences (1200 by 80 pieces of the strip, 300 by 300 of the square), with the bending
    /// stresses.
    #[test]
    fn torsion_and_bending_of_a_rectangle_are_largest_between_its_corners_and_middles() {
        let strip = rectangle(0.06, 0.004, 1.22600e-9);
        near(stress(&strip, [0.0; 3], [6.0, 1.626, 56.9]), 44.893e6, 3e-3);
        let square = rectangle(0.02, 0.02, 2.24915e-8);
        near(stress(&square, [0.0; 3], [20.0, 15.0, -15.0]), 24.4675e6, 3e-3);
        near(stress(&square, [3e3, 0.0, 0.0], [40.0, 12.0, 25.0]), 49.467e6, 3e-3);
    }

    /// `(a + b c)^2 + 3 (t + s c')^2` around the rim, with c and c' the cosines of angles that are a quarter apart.
    #[test]
    fn tension_shear_and_torsion_of_a_shaft_meet_between_its_axes() {
        let (r, area) = (0.01, PI * 1e-4);
        let (pull, shear, torque, moment) = (2e4, 4e3, 60.0, 20.0);
        let [a, s] = [pull / area, 4.0 / 3.0 * shear / area];
        let [b, t] = [4.0 * moment, 2.0 * torque].map(|of| of / (PI * r * r * r));
        let around = |place: u32| {
            let angle = 2.0 * PI * f64::from(place) / 1e4;
            ((a + b * angle.cos()).powi(2) + 3.0 * (t + s * angle.sin()).powi(2)).sqrt()
        };
        let exact = (0..10_000).map(around).fold(0.0, f64::max);
        let ends = (a + b).hypot(3f64.sqrt() * t).max(a.hypot(3f64.sqrt() * (t + s)));
        assert!(exact > 1.02 * ends);
        // M_y bends along z, and a force along z shears most beside it.
        near(
            stress(&circle(r), [pull, 0.0, shear], [torque, moment, 0.0]),
            exact,
            3e-3,
        );
    }

    #[test]
    fn what_is_not_known_of_a_section_is_not_guessed() {
        let odd = |y, z| {
            section(
                SectionShape::General {
                    extent: [y, z],
                    shear_factors: [0.0; 2],
                },
                2e-4,
                [1e-9, 3e-9],
                0.0,
            )
        };
        let bent = |of: &Section, is_planar| largest_stress(of, is_planar, [10.0, 0.0, 0.0], [0.0, 0.0, 6.0]);
        assert_eq!(bent(&odd(None, Some(0.01)), false), None);
        assert_eq!(bent(&odd(Some(0.01), None), false), None);
        near(
            bent(&odd(Some(0.01), None), true).unwrap(),
            10.0 / 2e-4 + 6.0 * 0.01 / 3e-9,
            1e-14,
        );
        // A torque without a torsion constant.
        assert_eq!(
            largest_stress(&odd(Some(0.01), Some(0.01)), false, [0.0; 3], [1.0, 0.0, 0.0]),
            None
        );
        assert_eq!(
            largest_stress(&circle(0.01), false, [f64::NAN, 0.0, 0.0], [0.0; 3]),
            None
        );
    }

    /// IPE 200: a web of 200 by 5.6 mm carries most of the shear force, and at its ends most of the bending.
    #[test]
    fn the_web_of_a_beam_of_steel_carries_its_shear_force() {
        let (area, about_z, web) = (28.48e-4, 1943e-8, 0.2 * 5.6e-3);
        let shape = SectionShape::General {
            extent: [Some(0.1), Some(0.05)],
            shear_factors: [web / area, 0.6],
        };
        let ipe = section(shape, area, [142e-8, about_z], 6.98e-8);
        let (force, moment) = (150e3, 37.5e3);
        near(
            stress(&ipe, [0.0, force, 0.0], [0.0; 3]),
            3f64.sqrt() * force / web,
            1e-12,
        );
        let wanted = (moment * 0.1 / about_z).hypot(3f64.sqrt() * force / web);
        near(stress(&ipe, [0.0, force, 0.0], [0.0, 0.0, moment]), wanted, 1e-12);
    }

    #[test]
    fn the_bound_of_a_general_section_is_above_a_circle_and_a_square() {
        for (exact, extent) in [
            (circle(0.01), 0.01),
            (rectangle(0.02, 0.02, 0.1406 * 0.02f64.powi(4)), 0.01),
        ] {
            let shape = SectionShape::General {
                extent: [Some(extent); 2],
                shear_factors: [0.85; 2],
            };
            let general = Section::new(SectionSpec { shape, ..exact.spec });
            for (forces, moments) in [
                ([10.0, 0.0, 0.0], [3.0, 0.0, 0.0]),
                ([0.0, 500.0, 300.0], [0.0, 1.0, -2.0]),
                ([5.0, 50.0, 0.0], [2.0, 1.0, 2.0]),
            ] {
                assert!(stress(&general, forces, moments) >= 0.999 * stress(&exact, forces, moments));
            }
        }
    }
}
