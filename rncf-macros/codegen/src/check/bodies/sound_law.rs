//! Stiffness and mass of sections that say them by themselves, where they are known when the model is built: positive definite, and
//! what some distribution of mass has. With params the program checks the same (`SectionLaw` in the runtime).

use super::along;
use crate::check::sections::known::Values;
use crate::check::values::eigen;
use crate::check::{Check, fold, say};
use crate::errors::Area;
use crate::model::{Expr as Value, Law, Table};
use crate::vocabulary::{MASS_ENTRIES, MASSES, STIFFNESS_ENTRIES};

/// Rows of both matrices, for messages.
const ROWS: [&str; 6] = [
    "1 (axial)",
    "2 (shear along y)",
    "3 (shear along z)",
    "4 (torsion)",
    "5 (bending about y)",
    "6 (bending about z)",
];

/// Least eigenvalue, scaled to a diagonal of ones, and relative size of round-off of declared entries: those of the runtime.
const LEAST: f64 = 1e-9;
const DECLARED: f64 = 1e-4;

type Matrix = [[f64; 6]; 6];

/// What is wrong, and the field that it is about.
type Wrong = (String, &'static str);

impl Check<'_> {
    /// Whether the law of a section is possible at every row of its tables; reports the first that is not.
    pub(in crate::check) fn is_sound(&mut self, name: &str, law: &Law, values: &Values, area: Area) -> bool {
        // Where the axis itself stands in a field, it is the program that knows its length.
        let has_place = |value: &Value| value.contains(&|part| matches!(part, Value::Arclength));
        if law.fields.values().any(has_place) {
            return true;
        }
        let tables = along::tables_of(&self.model, law.fields.values());
        let wrong = places(&tables).into_iter().find_map(|(x, row)| {
            let head = match row {
                Some((table, row)) => format!("section `{name}`, row {row} of table `{table}`"),
                None => format!("section `{name}`"),
            };
            self.impossible_law(&head, law, x)
        });
        let Some((message, field)) = wrong else {
            return true;
        };
        let area = values.get(field).map_or(area, |(_, area)| *area);
        self.errors.at(area, message);
        false
    }

    fn impossible_law(&self, head: &str, law: &Law, x: f64) -> Option<Wrong> {
        let at = |names: &[&'static str]| -> Option<Vec<f64>> {
            let value = |name: &&'static str| match law.fields.get(name) {
                // A length of 1: places of tables are either all parts of it or all in m.
                Some(value) => fold::fixed_along(&self.model, value, x, 1.0),
                None => Some(0.0),
            };
            names.iter().map(value).collect()
        };
        let stiffness = law.is_matrix.then(|| at(STIFFNESS_ENTRIES)).flatten();
        let indefinite = stiffness.and_then(|upper| indefinite(head, &symmetric(&upper)));
        indefinite.or_else(|| match law.has_mass_matrix {
            true => impossible_matrix(head, &symmetric(&at(MASS_ENTRIES)?)),
            false => {
                let constants = at(MASSES)?;
                let [about_y, about_z, product] = [3, 4, 5].map(|entry| constants[entry]);
                // Each for itself is in its range, or told to be out of it.
                let is_in_range = about_y > 0.0 && about_z > 0.0;
                let moments = [about_z, about_y, product];
                is_in_range.then(|| impossible_masses(head, moments, ["inertia_z", "inertia_yz"]))?
            }
        })
    }
}

/// Arclengths of an axis that is 1 long, and the rows that stand there: those of tables of one kind, or a single place.
fn places<'t>(tables: &[&'t Table]) -> Vec<(f64, Option<(&'t str, usize)>)> {
    if tables.is_empty() {
        return vec![(0.5, None)];
    }
    if tables.iter().any(|table| table.is_relative != tables[0].is_relative) {
        return Vec::new();
    }
    let of_rows = |table: &&'t Table| {
        let name = table.name.as_str();
        table.rows(1.0).map(move |(x, row)| (x, Some((name, row))))
    };
    tables.iter().flat_map(of_rows).collect()
}

fn symmetric(upper: &[f64]) -> Matrix {
    let mut matrix = [[0.0; 6]; 6];
    let mut entries = upper.iter();
    for row in 0..6 {
        for column in row..6 {
            let value = entries.next().copied().unwrap_or(0.0);
            (matrix[row][column], matrix[column][row]) = (value, value);
        }
    }
    matrix
}

/// The field of a diagonal entry.
fn diagonal(of: &'static [&'static str], row: usize) -> &'static str {
    const PLACES: [usize; 6] = [0, 6, 11, 15, 18, 20];
    of[PLACES[row]]
}

/// A strain that the stiffness does not resist.
fn indefinite(head: &str, matrix: &Matrix) -> Option<Wrong> {
    // Diagonal entries are told by their own range.
    if !(0..6).all(|row| matrix[row][row] > 0.0) {
        return None;
    }
    let scaled: Matrix =
        std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] / (matrix[i][i] * matrix[j][j]).sqrt()));
    let (values, vectors) = eigen::symmetric(scaled);
    let mode = (0..6).min_by(|&a, &b| values[a].total_cmp(&values[b]))?;
    if values[mode] > LEAST {
        return None;
    }
    let size = |row: usize| vectors[row][mode].abs();
    let row = (0..6).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
    Some((
        say::indefinite(head, values[mode], ROWS[row]),
        diagonal(STIFFNESS_ENTRIES, row),
    ))
}

/// A matrix that no distribution of mass over a section has, `M44 = M55 + M66` and so on.
fn impossible_matrix(head: &str, matrix: &Matrix) -> Option<Wrong> {
    let mass = matrix[0][0];
    if !(0..6).all(|row| matrix[row][row] > 0.0) {
        return None;
    }
    let radius = ((matrix[4][4] + matrix[5][5]).abs() / mass).sqrt();
    let [y, z] = [-matrix[0][5], matrix[0][4]];
    let mut wanted = [[0.0; 6]; 6];
    for (row, line) in wanted.iter_mut().enumerate().take(3) {
        line[row] = mass;
    }
    (wanted[0][4], wanted[0][5], wanted[1][3], wanted[2][3]) = (z, -y, -z, y);
    (wanted[4][4], wanted[5][5], wanted[4][5]) = (matrix[4][4], matrix[5][5], matrix[4][5]);
    wanted[3][3] = matrix[4][4] + matrix[5][5];
    let mut entry = 0;
    for row in 0..6 {
        for column in row..6 {
            let size = mass * radius.powi(i32::from(row > 2) + i32::from(column > 2));
            let (found, wanted) = (matrix[row][column], wanted[row][column]);
            if (found - wanted).abs() > DECLARED * size {
                return Some((
                    say::mass_entry(head, MASS_ENTRIES[entry], found, wanted, ROWS[row]),
                    MASS_ENTRIES[entry],
                ));
            }
            entry += 1;
        }
    }
    let about_centre = [
        matrix[5][5] - y * y / mass,
        matrix[4][4] - z * z / mass,
        -matrix[4][5] - y * z / mass,
    ];
    impossible_masses(head, about_centre, ["M66", "M56"])
}

/// Moments and product of inertia about the centre of mass, `int rho Y^2`, `int rho Z^2`, `int rho Y Z`, that no section has.
fn impossible_masses(head: &str, [yy, zz, yz]: [f64; 3], fields: [&'static str; 2]) -> Option<Wrong> {
    if !(yy > 0.0 && zz > 0.0) {
        return Some((say::no_inertia(head, zz, yy), fields[0]));
    }
    (yz * yz > yy * zz).then(|| (say::product_of_inertia(head, yz, zz, yy), fields[1]))
}
