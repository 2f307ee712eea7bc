//! Energy per volume integrated over the section of a beam: from fields at a point of the axis to forces and tangents on
//! them.
//!
//! A particle (Y, Z) is at `r + Y r_y + Z r_z`, and its fibre points along `g = r_x + Y r_y' + Z r_z'`. Lateral strains and
//! warping vary over the section in a way that its axes do not know; they are relaxed at every particle
//! ([`super::relaxed`]), W -> W_r. The axes themselves carry their mean: what they add is what the particle on the axis
//! would need to be strained as they are,
//!
//! ```text
//! U = int W_r dA + A (W(axis) - W_r(axis)),
//! ```
//!
//! which is never negative and vanishes where they are strained as a free section. So bending meets the modulus of
//! tension, and in tension the axes contract as the body does.
//!
//! Saint-Venant's warping and the shear of a section enter by factors of the strains: shear is `sqrt(k)` times that of the
//! axis, and the shear of torsion `sqrt(J / I_p)` times that of a section that does not warp, so that the energy of small
//! strains is that of `k G A` and `G J`.

use super::relaxed::{Free, GIVEN, Response, StrainEnergy, respond};

/// Inner products of the five fields r_x, r_y, r_z, r_y', r_z', row by row of the upper half.
const PAIRS: [(usize, usize); 15] = [
    (0, 0),
    (0, 1),
    (0, 2),
    (0, 3),
    (0, 4),
    (1, 1),
    (1, 2),
    (1, 3),
    (1, 4),
    (2, 2),
    (2, 3),
    (2, 4),
    (3, 3),
    (3, 4),
    (4, 4),
];
const COUNT: usize = PAIRS.len();

/// Those that say how the section's axes are strained.
const AXES: [usize; 3] = [5, 6, 9];

/// Fields at a point in space.
type Fields = [[f64; 3]; 5];

/// How the strains of a particle depend on the products: strain, product, factor.
type Forms = [(usize, usize, f64); 17];

/// A section over which an energy per volume is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section<const P: usize> {
    /// Particles: y, z (m) and weight (m^2).
    pub particles: [[f64; 3]; P],
    /// Square roots of the shear factors along y and z.
    pub shear: [f64; 2],
    /// Square root of the torsion constant over the polar second moment.
    pub torsion: f64,
    /// `sqrt(I_z / I_y)` and its inverse, I_y about the y axis: weights of the shear in the plane of the section, with which
    /// it does no work on torsion.
    pub distortion: [f64; 2],
}

impl<const P: usize> Default for Section<P> {
    fn default() -> Self {
        Self {
            particles: [[0.0; 3]; P],
            shear: [1.0; 2],
            torsion: 1.0,
            distortion: [1.0; 2],
        }
    }
}

/// Poisson's ratio of small strains: how a fibre along x contracts along y. Zero where nothing is free to contract.
fn contraction(law: &impl StrainEnergy) -> f64 {
    let (mut energy, mut stress, mut d) = (0.0, [0.0; 6], [[0.0; 6]; 6]);
    law.response(&[0.0; 6], &mut energy, &mut stress, &mut d);
    // sigma_yy = sigma_zz = 0 with E_xx = 1.
    let determinant = d[1][1] * d[2][2] - d[1][2] * d[1][2];
    let ratio = (d[0][1] * d[2][2] - d[0][2] * d[1][2]) / determinant;
    if ratio.is_finite() { ratio } else { 0.0 }
}

/// Cowper's shear factor of a circular tube with the square of the ratio of its radii; 0 of a full circle.
fn shear_factor(poisson: f64, squared_ratio: f64) -> f64 {
    let whole = (1.0 + squared_ratio).powi(2);
    let below = (7.0 + 6.0 * poisson) * whole + (20.0 + 12.0 * poisson) * squared_ratio;
    6.0 * (1.0 + poisson) * whole / below
}

impl Section<12> {
    /// Circle and tube of an outer radius, m.
    pub fn round(radius: f64, thickness: f64, law: &impl StrainEnergy) -> Self {
        let squared_ratio = ((radius - thickness) / radius).powi(2);
        Self {
            particles: super::points::round_particles(radius, thickness),
            shear: [shear_factor(contraction(law), squared_ratio).sqrt(); 2],
            torsion: 1.0,
            distortion: [1.0; 2],
        }
    }
}

impl Section<9> {
    /// Rectangle with sizes along y and z, m, and a torsion constant, m^4.
    pub fn rectangle(sizes: [f64; 2], torsion_constant: f64) -> Self {
        let [y, z] = sizes;
        let polar = y * z * (y * y + z * z) / 12.0;
        Self {
            particles: super::points::rectangle_particles(sizes),
            shear: [(5.0_f64 / 6.0).sqrt(); 2],
            torsion: (torsion_constant / polar).sqrt(),
            distortion: [y / z, z / y],
        }
    }
}

/// What a section answers, per length of the axis, on the inner products of the fields.
struct Resultants {
    energy: f64,
    stress: [f64; COUNT],
    stiffness: [[f64; COUNT]; COUNT],
    /// Derivative of the stress with respect to the rates of the products, where damped.
    viscosity: [[f64; COUNT]; COUNT],
}

/// State of a point: fields, the same without stress, and their rates; derivatives along the axis, m.
#[derive(Clone, Copy, Debug)]
pub struct SectionPoint<'a, const D: usize, const F: usize> {
    /// Length of the element, m.
    pub length: f64,
    /// Fields on the unit element.
    pub fields: &'a [[f64; D]; F],
    /// Their values in the stress-free shape where it is curved or twisted, field by field.
    pub before: Option<&'a [f64]>,
    /// Their rates and the damping (s), where damped.
    pub rates: Option<(&'a [[f64; D]; F], f64)>,
}

/// Where a field of `F` is among the five: in a plane there are r_x, r_y and r_y'.
const fn place(of: usize, field: usize) -> usize {
    if of == 3 && field == 2 { 3 } else { field }
}

impl<const D: usize, const F: usize> SectionPoint<'_, D, F> {
    fn is_planar(&self) -> bool {
        F == 3
    }

    /// Power of the length that a field has on the unit element.
    fn scale(&self, place: usize) -> f64 {
        if place < 3 { 1.0 } else { 1.0 / self.length }
    }

    fn in_space(&self, value: impl Fn(usize, usize) -> f64) -> Fields {
        let mut fields = [[0.0; 3]; 5];
        for field in 0..F {
            let place = place(F, field);
            for c in 0..D {
                fields[place][c] = self.scale(place) * value(field, c);
            }
        }
        fields
    }

    /// Fields in space, the normal of a plane being the section's z axis.
    fn fields(&self) -> Fields {
        let mut fields = self.in_space(|field, c| self.fields[field][c]);
        if self.is_planar() {
            fields[2] = [0.0, 0.0, 1.0];
        }
        fields
    }

    fn rates(&self) -> Option<(Fields, f64)> {
        let (rates, damping) = self.rates?;
        Some((self.in_space(|field, c| rates[field][c]), damping))
    }

    /// Inner products less those of the stress-free shape.
    fn changes(&self, fields: &Fields) -> [f64; COUNT] {
        let mut changes = PAIRS.map(|(i, j)| dot(&fields[i], &fields[j]));
        match self.before {
            Some(before) => {
                let mut free = self.in_space(|field, c| before.get(field * D + c).copied().unwrap_or(0.0));
                if self.is_planar() {
                    free[2] = [0.0, 0.0, 1.0];
                }
                for (change, (i, j)) in changes.iter_mut().zip(PAIRS) {
                    *change -= dot(&free[i], &free[j]);
                }
            }
            None => [0, 5, 9].into_iter().for_each(|unit| changes[unit] -= 1.0),
        }
        changes
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl<const P: usize> Section<P> {
    /// Strains of the particle (y, z) by the products: e, gamma_y and gamma_z of its fibre, and those of the axes.
    fn forms(&self, y: f64, z: f64) -> Forms {
        let [shear_y, shear_z] = self.shear;
        // The part of r_y . r_z' - r_z . r_y' is torsion, its counterpart a shear of the section that varies along the axis.
        let [same_y, same_z] = self.distortion.map(|distortion| 0.5 * (distortion + self.torsion));
        let [other_y, other_z] = self.distortion.map(|distortion| 0.5 * (distortion - self.torsion));
        [
            (0, 0, 0.5),
            (0, 3, y),
            (0, 4, z),
            (0, 12, 0.5 * y * y),
            (0, 13, y * z),
            (0, 14, 0.5 * z * z),
            (1, 1, shear_y),
            (1, 7, y),
            (1, 8, same_y * z),
            (1, 10, other_y * z),
            (2, 2, shear_z),
            (2, 11, z),
            (2, 10, same_z * y),
            (2, 8, other_z * y),
            (3, AXES[0], 1.0),
            (4, AXES[1], 1.0),
            (5, AXES[2], 1.0),
        ]
    }

    /// Sums over the section; `None` where the material has no answer.
    fn resultants<const D: usize, const F: usize>(
        &self,
        law: &impl StrainEnergy,
        point: &SectionPoint<D, F>,
        fields: &Fields,
    ) -> Option<Resultants> {
        let changes = point.changes(fields);
        let rates = point.rates().map(|(rates, damping)| {
            let products = PAIRS.map(|(i, j)| dot(&rates[i], &fields[j]) + dot(&fields[i], &rates[j]));
            (products, damping)
        });
        let mut sums = Resultants {
            energy: 0.0,
            stress: [0.0; COUNT],
            stiffness: [[0.0; COUNT]; COUNT],
            viscosity: [[0.0; COUNT]; COUNT],
        };
        let mut add = |[y, z, weight]: [f64; 3], free: Free| {
            let forms = self.forms(y, z);
            let strains = |products: &[f64; COUNT]| {
                let mut strains = [0.0; GIVEN];
                for &(strain, product, factor) in &forms {
                    strains[strain] += factor * products[product];
                }
                strains
            };
            let damped = rates.as_ref().map(|(products, damping)| (strains(products), *damping));
            let response = respond(law, &strains(&changes), damped.as_ref().map(|(rates, _)| rates), free)?;
            sums.add(&forms, weight, &response, damped.as_ref());
            Some(())
        };
        for &particle in &self.particles {
            add(particle, Free::Lateral)?;
        }
        let area: f64 = self.particles.iter().map(|particle| particle[2]).sum();
        let axes = if point.is_planar() {
            Free::OutOfPlane
        } else {
            Free::Nothing
        };
        add([0.0, 0.0, area], axes)?;
        add([0.0, 0.0, -area], Free::Lateral)?;
        Some(sums)
    }

    /// Adds the strain energy at a point of weight one on the unit element; not a number where the material has none.
    pub fn energy<const D: usize, const F: usize>(
        &self,
        law: &impl StrainEnergy,
        point: &SectionPoint<D, F>,
        energy: &mut f64,
    ) {
        let sums = self.resultants(law, point, &point.fields());
        *energy += point.length * sums.map_or(f64::NAN, |sums| sums.energy);
    }

    /// Writes the forces on the fields.
    pub fn force<const D: usize, const F: usize>(
        &self,
        law: &impl StrainEnergy,
        point: &SectionPoint<D, F>,
        forces: &mut [[f64; D]; F],
    ) {
        let fields = point.fields();
        let Some(sums) = self.resultants(law, point, &fields) else {
            *forces = [[f64::NAN; D]; F];
            return;
        };
        let mut on_fields = [[0.0; 3]; 5];
        for (&stress, (i, j)) in sums.stress.iter().zip(PAIRS) {
            for c in 0..3 {
                on_fields[i][c] += stress * fields[j][c];
                on_fields[j][c] += stress * fields[i][c];
            }
        }
        for (field, force) in forces.iter_mut().enumerate() {
            let place = place(F, field);
            for (c, entry) in force.iter_mut().enumerate() {
                *entry = point.length * point.scale(place) * on_fields[place][c];
            }
        }
    }

    /// Writes the blocks of the tangent on pairs of fields.
    pub fn tangent<const D: usize, const DD: usize, const F: usize, const B: usize>(
        &self,
        law: &impl StrainEnergy,
        point: &SectionPoint<D, F>,
        pairs: &[(usize, usize); B],
        stiffness: &mut [[f64; DD]; B],
    ) {
        self.damped_tangent(law, point, (pairs, stiffness), (&[], &mut []));
    }

    /// Writes the blocks of the tangent, and of the damping matrix, on pairs of fields.
    pub fn damped_tangent<const D: usize, const DD: usize, const F: usize, const B: usize, const C: usize>(
        &self,
        law: &impl StrainEnergy,
        point: &SectionPoint<D, F>,
        (pairs, stiffness): (&[(usize, usize); B], &mut [[f64; DD]; B]),
        (damped_pairs, damping_matrix): (&[(usize, usize); C], &mut [[f64; DD]; C]),
    ) {
        let fields = point.fields();
        let Some(sums) = self.resultants(law, point, &fields) else {
            *stiffness = [[f64::NAN; DD]; B];
            *damping_matrix = [[f64::NAN; DD]; C];
            return;
        };
        let gradients = Gradients(&fields);
        let mut along = gradients.along(&sums.stiffness);
        if let Some((rates, _)) = point.rates() {
            let viscous = Gradients(&rates).along(&sums.viscosity);
            for (sum, part) in along
                .iter_mut()
                .flatten()
                .flatten()
                .zip(viscous.iter().flatten().flatten())
            {
                *sum += part;
            }
        }
        let write = |blocks: &[[Block; 5]; 5], pairs: &[(usize, usize)], out: &mut [[f64; DD]]| {
            for (&(f, g), out) in pairs.iter().zip(out) {
                let (f, g) = (place(F, f), place(F, g));
                let factor = point.length * point.scale(f) * point.scale(g);
                for (at, entry) in out.iter_mut().enumerate() {
                    *entry = factor * blocks[f][g][at / D][at % D];
                }
            }
        };
        let mut blocks = gradients.blocks(&along);
        for (&stress, (i, j)) in sums.stress.iter().zip(PAIRS) {
            for c in 0..3 {
                blocks[i][j][c][c] += stress;
                blocks[j][i][c][c] += stress;
            }
        }
        write(&blocks, pairs, stiffness);
        if C > 0 {
            let along = gradients.along(&sums.viscosity);
            write(&gradients.blocks(&along), damped_pairs, damping_matrix);
        }
    }
}

impl Resultants {
    /// Adds a particle.
    fn add(&mut self, forms: &Forms, weight: f64, response: &Response, damped: Option<&([f64; GIVEN], f64)>) {
        self.energy += weight * response.energy;
        let (mut stress, mut stiffness) = (response.stress, response.stiffness);
        if let Some((rates, damping)) = damped {
            for (stress, row) in stress.iter_mut().zip(&response.stiffness) {
                let rate: f64 = row.iter().zip(rates).map(|(entry, rate)| entry * rate).sum();
                *stress += damping * rate;
            }
            let more = response.stiffness_rate.iter().flatten();
            stiffness
                .iter_mut()
                .flatten()
                .zip(more)
                .for_each(|(sum, part)| *sum += damping * part);
        }
        for &(k, a, left) in forms {
            let left = weight * left;
            self.stress[a] += left * stress[k];
            for &(l, b, right) in forms {
                self.stiffness[a][b] += left * right * stiffness[k][l];
            }
            if let Some((_, damping)) = damped {
                for &(l, b, right) in forms {
                    self.viscosity[a][b] += damping * left * right * response.stiffness[k][l];
                }
            }
        }
    }
}

type Block = [[f64; 3]; 3];

/// Derivatives of the inner products with respect to the fields.
struct Gradients<'a>(&'a Fields);

impl Gradients<'_> {
    /// `[A][j]`: `sum_B M_AB dI_B/dj`.
    fn along(&self, matrix: &[[f64; COUNT]; COUNT]) -> [[[f64; 3]; 5]; COUNT] {
        matrix.map(|row| {
            let mut sum = [[0.0; 3]; 5];
            for (&entry, (i, j)) in row.iter().zip(PAIRS) {
                for c in 0..3 {
                    sum[i][c] += entry * self.0[j][c];
                    sum[j][c] += entry * self.0[i][c];
                }
            }
            sum
        })
    }

    /// `sum_A dI_A/di along_Aj^T`.
    fn blocks(&self, along: &[[[f64; 3]; 5]; COUNT]) -> [[Block; 5]; 5] {
        let mut blocks = [[[[0.0; 3]; 3]; 5]; 5];
        for (along, (i, j)) in along.iter().zip(PAIRS) {
            for (at, by) in [(i, j), (j, i)] {
                for (block, along) in blocks[at].iter_mut().zip(along) {
                    for (row, factor) in block.iter_mut().zip(&self.0[by]) {
                        for (entry, value) in row.iter_mut().zip(along) {
                            *entry += factor * value;
                        }
                    }
                }
            }
        }
        blocks
    }
}
