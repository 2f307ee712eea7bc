//! Sections that say their stiffness and mass by themselves: constants about centres, or full matrices.

use crate::error::ModelError;
use crate::linalg::symmetric_eigen;

/// Rows of both matrices, for messages: strains and rates in the section's own axes.
const ROWS: [&str; 6] = [
    "1 (axial)",
    "2 (shear along y)",
    "3 (shear along z)",
    "4 (torsion)",
    "5 (bending about y)",
    "6 (bending about z)",
];

/// Relative size of what counts as round-off of declared entries, which mostly have five digits.
const DECLARED: f64 = 1e-4;

/// Least eigenvalue of a stiffness that is scaled to a diagonal of ones.
const LEAST: f64 = 1e-9;

/// Part of a motion that may be the section's own strain, of waves as short as [`SHORTEST`] says.
const STRAINED: f64 = 5e-3;
/// One over wave number times the larger radius of gyration of bending: shorter waves are no motions of a rod.
const SHORTEST: f64 = 2.0;

/// A symmetric matrix, rows first.
type Matrix6 = [[f64; 6]; 6];

/// How the stiffness of a section is given.
#[derive(Clone, Copy, Debug)]
pub enum Stiffness {
    /// EA, GAy, GAz (N), GJ, EIy, EIz (N m^2), tension centre y, z, shear centre y, z (m), angle from the section's axes to the
    /// principal ones (rad), in which GAy, GAz, EIy and EIz are given.
    Centres([f64; 11]),
    /// Upper triangle, row by row: axial, shear along y and z, torsion, bending about y and z.
    Matrix([f64; 21]),
}

/// How the mass of a section is given.
#[derive(Clone, Copy, Debug)]
pub enum Mass {
    /// Mass per length (kg/m), place y, z of its centre (m), and `int rho Z^2`, `int rho Y^2`, `int rho Y Z` about it (kg m).
    Centre([f64; 6]),
    /// Upper triangle in the order of the stiffness, about the axis.
    Matrix([f64; 21]),
}

/// Stiffness and mass of a section about its axis, checked.
#[derive(Clone, Copy, Debug)]
pub struct SectionLaw {
    stiffness: Matrix6,
    masses: [f64; 6],
}

fn symmetric(upper: &[f64; 21]) -> Matrix6 {
    let mut matrix = [[0.0; 6]; 6];
    let mut entries = upper.iter();
    for row in 0..6 {
        for column in row..6 {
            let value = entries.next().copied().unwrap_or(0.0);
            matrix[row][column] = value;
            matrix[column][row] = value;
        }
    }
    matrix
}

impl SectionLaw {
    /// Of a section with this name.
    ///
    /// # Errors
    /// A stiffness that is not positive definite, with its least eigenvalue and row; a mass that no section has.
    pub fn new(section: &str, stiffness: Stiffness, mass: Mass) -> Result<Self, ModelError> {
        let stiffness = match stiffness {
            Stiffness::Centres(constants) => about_axis(&constants),
            Stiffness::Matrix(upper) => symmetric(&upper),
        };
        check_definite(section, &stiffness)?;
        let masses = match mass {
            Mass::Centre(constants) => about_centre(&constants),
            Mass::Matrix(upper) => of_matrix(section, &symmetric(&upper))?,
        };
        check_masses(section, &masses)?;
        Ok(Self { stiffness, masses })
    }

    /// Masses per length that move with r r, r r_y, r r_z, r_y r_y, r_z r_z, r_y r_z: kg/m, kg, kg m.
    pub fn masses(&self) -> [f64; 6] {
        self.masses
    }

    /// Coefficients of the energy: pivots and factors of `L D L^T` in the order torsion, bending about y and z, axial, shear
    /// along y and z, the factors row by row; then what holds the section in its plane (N), and half of it.
    pub fn coefficients(&self) -> [f64; 23] {
        const ORDER: [usize; 6] = [3, 4, 5, 0, 1, 2];
        let mut matrix: Matrix6 = std::array::from_fn(|i| std::array::from_fn(|j| self.stiffness[ORDER[i]][ORDER[j]]));
        let mut out = [0.0; 23];
        let place = |row: usize, column: usize| 6 + row * (row - 1) / 2 + column;
        for pivot in 0..6 {
            out[pivot] = matrix[pivot][pivot];
            for row in pivot + 1..6 {
                let factor = matrix[row][pivot] / matrix[pivot][pivot];
                out[place(row, pivot)] = factor;
                for column in pivot + 1..6 {
                    matrix[row][column] -= factor * matrix[pivot][column];
                }
            }
        }
        let held = self.held();
        out[21..].copy_from_slice(&[held, 0.5 * held]);
        out
    }

    /// Stiffness (N) of the section in its own plane, where a rod is rigid: its inertia must not strain it. Motions of frequency w
    /// strain it by the part w^2 I/held, I the inertia that a motion of the axis, or a twist, couples with the section's shape:
    /// first moments, and unlike second ones. That part is [`STRAINED`] for waves as short as [`SHORTEST`] says, and falls with the
    /// square or the fourth power of longer ones. More than that costs iterations where sections turn far.
    fn held(&self) -> f64 {
        let k = &self.stiffness;
        let [mass, y, z, yy, zz, yz] = self.masses;
        let axial = k[0][0];
        // About the tension centre.
        let [about_y, about_z] = [4, 5].map(|row| k[row][row] - k[0][row] * k[0][row] / axial);
        let wave = axial / (SHORTEST * SHORTEST * about_y.max(about_z));
        let bending = axial / (SHORTEST * SHORTEST * mass) * wave;
        let torsion = k[3][3] / (yy + zz) * wave;
        let shapes = ((y * y + z * z) / mass).max(((yy - zz).powi(2) + 4.0 * yz * yz) / (yy + zz));
        axial.max(bending.max(torsion) * shapes / STRAINED)
    }

    /// The same, followed by the square roots of the dampings (s) of the strains (in the order of the matrix: axial, shear along y
    /// and z, torsion, bending about y and z) and the factors times them, in the order of the factors.
    pub fn viscous_coefficients(&self, damping: [f64; 6]) -> [f64; 44] {
        const ORDER: [usize; 6] = [3, 4, 5, 0, 1, 2];
        let roots = ORDER.map(|strain| damping[strain].sqrt());
        let mut out = [0.0; 44];
        out[..23].copy_from_slice(&self.coefficients());
        out[23..29].copy_from_slice(&roots);
        let mut place = 6;
        for row in 1..6 {
            for _ in 0..row {
                out[23 + place] = roots[row] * out[place];
                place += 1;
            }
        }
        out
    }
}

/// The matrix about the axis from constants about the centres: axial force and bending act at the tension centre, shear and torsion
/// at the shear centre.
fn about_axis(constants: &[f64; 11]) -> Matrix6 {
    let [ea, gay, gaz, gj, eiy, eiz, ty, tz, sy, sz, angle] = *constants;
    let (sine, cosine) = angle.sin_cos();
    let turned = |y: f64, z: f64| {
        [
            cosine * cosine * y + sine * sine * z,
            cosine * sine * (y - z),
            sine * sine * y + cosine * cosine * z,
        ]
    };
    let [shear_y, shear_yz, shear_z] = turned(gay, gaz);
    let [bend_y, bend_yz, bend_z] = turned(eiy, eiz);
    let mut matrix = [[0.0; 6]; 6];
    // N = EA (g1 + tz k2 - ty k3), the strain at the tension centre.
    let axial = [1.0, 0.0, 0.0, 0.0, tz, -ty];
    // Q = GA (g2 - sz k1, g3 + sy k1), the shear at the shear centre.
    let along_y = [0.0, 1.0, 0.0, -sz, 0.0, 0.0];
    let along_z = [0.0, 0.0, 1.0, sy, 0.0, 0.0];
    for i in 0..6 {
        for j in 0..6 {
            matrix[i][j] = ea * axial[i] * axial[j]
                + shear_y * along_y[i] * along_y[j]
                + shear_z * along_z[i] * along_z[j]
                + shear_yz * (along_y[i] * along_z[j] + along_z[i] * along_y[j]);
        }
    }
    matrix[3][3] += gj;
    matrix[4][4] += bend_y;
    matrix[5][5] += bend_z;
    matrix[4][5] += bend_yz;
    matrix[5][4] += bend_yz;
    matrix
}

fn about_centre(constants: &[f64; 6]) -> [f64; 6] {
    let [mass, y, z, about_y, about_z, product] = *constants;
    [
        mass,
        mass * y,
        mass * z,
        about_z + mass * y * y,
        about_y + mass * z * z,
        product + mass * y * z,
    ]
}

/// Masses of a matrix that a distribution of mass over a section has:
/// `M11 = M22 = M33 = m, M15 = m z, M16 = -m y, M24 = -m z, M34 = m y, M44 = M55 + M66, M56 = -int rho Y Z`, zeros elsewhere.
fn of_matrix(section: &str, matrix: &Matrix6) -> Result<[f64; 6], ModelError> {
    let mass = matrix[0][0];
    let radius = ((matrix[4][4] + matrix[5][5]).abs() / mass).sqrt();
    let mut wanted = [[0.0; 6]; 6];
    for (row, line) in wanted.iter_mut().enumerate().take(3) {
        line[row] = mass;
    }
    let [y, z] = [-matrix[0][5], matrix[0][4]];
    (wanted[0][4], wanted[0][5], wanted[1][3], wanted[2][3]) = (z, -y, -z, y);
    (wanted[4][4], wanted[5][5], wanted[4][5]) = (matrix[4][4], matrix[5][5], matrix[4][5]);
    wanted[3][3] = matrix[4][4] + matrix[5][5];
    for row in 0..6 {
        for column in row..6 {
            let size = mass * radius.powi(i32::from(row > 2) + i32::from(column > 2));
            let (found, wanted) = (matrix[row][column], wanted[row][column]);
            if (found - wanted).abs() > DECLARED * size {
                return Err(ModelError::new(format!(
                    "section `{section}`: M{}{} is {found} where a distribution of mass over a section has {wanted}, from the other entries: row {}",
                    row + 1,
                    column + 1,
                    ROWS[row]
                )));
            }
        }
    }
    Ok([mass, y, z, matrix[5][5], matrix[4][4], -matrix[4][5]])
}

/// Refuses a stiffness that some strain does not meet.
fn check_definite(section: &str, matrix: &Matrix6) -> Result<(), ModelError> {
    for (row, line) in matrix.iter().enumerate() {
        if !(line[row] > 0.0 && line.iter().all(|entry| entry.is_finite())) {
            return Err(ModelError::new(format!(
                "section `{section}`: row {} of its stiffness is {line:?}: its diagonal entry must be greater than zero, and all be finite",
                ROWS[row]
            )));
        }
    }
    let scaled: Matrix6 =
        std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] / (matrix[i][i] * matrix[j][j]).sqrt()));
    // A section is asked for at every row of a run, and eigenvalues cost ten times as much as all else of it.
    if is_above(scaled, LEAST) {
        return Ok(());
    }
    let (values, vectors) = symmetric_eigen(6, scaled.as_flattened()).map_err(|_| {
        ModelError::new(format!(
            "section `{section}`: its matrix of stiffness has no eigenvalues"
        ))
    })?;
    let (least, mode) = (values[0], &vectors[0]);
    if least > LEAST {
        return Ok(());
    }
    let row = (0..6)
        .max_by(|&a, &b| mode[a].abs().total_cmp(&mode[b].abs()))
        .unwrap_or(0);
    Err(ModelError::new(format!(
        "section `{section}`: its matrix of stiffness is not positive definite: scaled to a diagonal of ones its least eigenvalue is {least:.3e}, mostly in row {}: look at the entries that couple it",
        ROWS[row]
    )))
}

/// Whether all eigenvalues of a symmetric matrix are greater than a bound: what is left of it behind that has positive pivots.
fn is_above(mut matrix: Matrix6, bound: f64) -> bool {
    for (row, line) in matrix.iter_mut().enumerate() {
        line[row] -= bound;
    }
    for pivot in 0..6 {
        let line = matrix[pivot];
        if line[pivot].is_nan() || line[pivot] <= 0.0 {
            return false;
        }
        for below in &mut matrix[pivot + 1..] {
            let factor = below[pivot] / line[pivot];
            for (entry, above) in below.iter_mut().zip(line).skip(pivot) {
                *entry -= factor * above;
            }
        }
    }
    true
}

/// Refuses masses that no distribution over a section has.
fn check_masses(section: &str, masses: &[f64; 6]) -> Result<(), ModelError> {
    let [mass, y, z, yy, zz, yz] = *masses;
    let wrong = |what: String| Err(ModelError::new(format!("section `{section}`: {what}")));
    if !(mass > 0.0 && masses.iter().all(|value| value.is_finite())) {
        return wrong(format!(
            "its mass per length is {mass} kg/m: it must be greater than zero"
        ));
    }
    // About the centre of mass.
    let [yy, zz, yz] = [yy - y * y / mass, zz - z * z / mass, yz - y * z / mass];
    if !(yy > 0.0 && zz > 0.0) {
        return wrong(format!(
            "its rotary inertia about the centre of mass is {zz} kg m about y and {yy} kg m about z: both must be greater than zero"
        ));
    }
    if yz * yz > yy * zz {
        return wrong(format!(
            "its product of inertia about the centre of mass, {yz} kg m, is larger than the moments {zz} and {yy} kg m allow"
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::emitted::law::*;

    const ROD: [f64; 11] = [1e4, 4e3, 5e3, 30.0, 60.0, 80.0, 0.01, -0.02, 0.03, 0.005, 0.4];
    const BAR: Mass = Mass::Centre([2.0, 0.01, -0.005, 3e-3, 5e-3, 1e-3]);

    #[test]
    fn the_factors_give_the_matrix_again() {
        let law = SectionLaw::new("rod", Stiffness::Centres(ROD), BAR).unwrap();
        let found = law.coefficients();
        let factor = |row: usize, column: usize| match row.cmp(&column) {
            std::cmp::Ordering::Less => 0.0,
            std::cmp::Ordering::Equal => 1.0,
            std::cmp::Ordering::Greater => found[6 + row * (row - 1) / 2 + column],
        };
        let order = [3, 4, 5, 0, 1, 2];
        for i in 0..6 {
            for j in 0..6 {
                let product: f64 = (0..6).map(|k| factor(i, k) * found[k] * factor(j, k)).sum();
                let wanted = law.stiffness[order[i]][order[j]];
                assert!((product - wanted).abs() < 1e-9 * 1e4, "{i} {j}: {product} {wanted}");
            }
        }
    }

    #[test]
    fn centres_are_where_forces_do_not_couple() {
        let law = SectionLaw::new("rod", Stiffness::Centres(ROD), BAR).unwrap();
        let k = &law.stiffness;
        // A force at the tension centre strains without bending: its moments about the axis are (z N, -y N).
        let pull: Vec<f64> = (0..6).map(|row| k[row][0]).collect();
        assert!(
            (pull[4] + 0.02 * 1e4).abs() < 1e-9 && (pull[5] + 0.01 * 1e4).abs() < 1e-9,
            "{pull:?}"
        );
    }

    /// Two strains with a coupling c, scaled to a diagonal of ones, have the eigenvalues 1 - c and 1 + c.
    #[test]
    fn a_stiffness_is_refused_by_its_least_eigenvalue() {
        let law = |least: f64| {
            let mut upper = [0.0; 21];
            for (entry, value) in [(0, 1e4), (6, 4e3), (11, 5e3), (15, 30.0), (18, 64.0), (20, 81.0)] {
                upper[entry] = value;
            }
            upper[19] = 72.0 * (1.0 - least);
            SectionLaw::new("odd", Stiffness::Matrix(upper), BAR)
        };
        assert!(law(2e-9).is_ok() && law(0.5).is_ok() && law(1.5).is_ok());
        for least in [5e-10, 0.0, -1e-6, -3.0] {
            let text = law(least).unwrap_err().to_string();
            assert!(
                text.contains("not positive definite") && text.contains("bending about"),
                "{text}"
            );
        }
    }

    #[test]
    fn what_no_section_has_is_refused_by_row() {
        let refused = |stiffness, mass| SectionLaw::new("odd", stiffness, mass).unwrap_err().to_string();
        let mut upper = [0.0; 21];
        for (entry, value) in [
            (0, 1e4),
            (6, 4e3),
            (11, 5e3),
            (15, 30.0),
            (18, 60.0),
            (20, 80.0),
            (16, 50.0),
        ] {
            upper[entry] = value;
        }
        let text = refused(Stiffness::Matrix(upper), BAR);
        assert!(
            text.contains("bending about y") && text.contains("eigenvalue"),
            "{text}"
        );
        upper[16] = 10.0;
        assert!(SectionLaw::new("odd", Stiffness::Matrix(upper), BAR).is_ok());
        let mut mass = [0.0; 21];
        for (entry, value) in [(0, 2.0), (6, 2.0), (11, 2.0), (15, 0.5), (18, 0.1), (20, 0.2)] {
            mass[entry] = value;
        }
        assert!(refused(Stiffness::Matrix(upper), Mass::Matrix(mass)).contains("M44 is 0.5"));
        assert!(refused(Stiffness::Matrix(upper), Mass::Centre([1.0, 0.0, 0.0, 1.0, 1.0, 2.0])).contains("product"));
    }
}
