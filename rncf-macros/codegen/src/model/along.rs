//! What varies along the axis of a body: tables, stations, sections that say their stiffness by themselves.

use std::collections::BTreeMap;

use super::expression::Expr;
use super::ids::{RepeatId, TableId, identifier};
use crate::import::spline;
use crate::vocabulary::DAMPINGS;

/// Part of the range of a table by which a place may lie outside, as round-off.
const ROUND_OFF: f64 = 1e-9;
/// Rows beyond which kinks of a table are so many, and so small, that they are left to the control of the error.
const ROWS: usize = 32;

/// Numbers along an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name in the declaration.
    pub name: String,
    /// The file that it stands in, beside the manifest of its crate.
    pub file: Option<String>,
    /// Places along the axis, or of another quantity, ascending; two equal ones are a step.
    pub places: Vec<f64>,
    /// Exponents of m, kg, s, K, A, angle of the places.
    pub dimension: [i8; 6],
    /// Whether places are fractions of the length, or else in m.
    pub is_relative: bool,
    /// What values between rows follow.
    pub between: Between,
    /// Columns in SI.
    pub columns: Vec<Column>,
    /// Columns that the places are made of: one, or the three coordinates of points.
    pub placed_by: Vec<usize>,
    /// Columns that say the same entry of a symmetric matrix, and those of the entries on its diagonal in their row and column.
    pub alike: Vec<[usize; 4]>,
    /// Whether its file is a parameter of the program, so that the rows of a run may be others.
    pub is_param: bool,
}

/// What the values of a table follow between its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// A line.
    Line,
    /// A monotone cubic (Fritsch and Carlson), whose slope has no steps.
    Monotone,
    /// A cubic spline, whose slope and curvature have no steps.
    Spline,
    /// The same with a slope of zero in the first and last row, beyond which it stays as it is.
    Clamped,
    /// The same of rows that repeat, so that it has a value everywhere; the last row is the first one again.
    Periodic,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Name in the header of the file, where that is another.
    pub header: Option<String>,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// Exponent of hertz in its unit.
    pub hertz: i8,
    /// One value for each row, SI.
    pub values: Vec<f64>,
    /// Slopes at the rows of a spline; of others empty.
    pub slopes: Vec<f64>,
}

impl Table {
    /// Where along an axis of this length (m, or 1) each row stands, with its number from 1 on; in front of a step just before it.
    pub fn rows(&self, length: f64) -> impl Iterator<Item = (f64, usize)> {
        self.places.iter().enumerate().map(move |(row, &place)| {
            let x = if self.is_relative { place * length } else { place };
            let is_before_step = self.places.get(row + 1) == Some(&place);
            (if is_before_step { x.next_down() } else { x }, row + 1)
        })
    }

    /// What generated code reads, where `model` is at hand.
    pub fn reference(&self) -> String {
        if self.is_param {
            format!("model.{}", self.name)
        } else {
            self.constant()
        }
    }

    /// Name in generated code.
    pub fn constant(&self) -> String {
        format!("TABLE_{}", identifier(&self.name).to_uppercase())
    }

    /// Name of what is said of its files in generated code.
    pub fn form(&self) -> String {
        format!("FILE_{}", identifier(&self.name).to_uppercase())
    }

    /// Text of a column's value at the arclength `x` of an axis with the length `length`.
    pub fn lookup(&self, column: usize) -> String {
        format!("{}.at({column}, x, length)", self.reference())
    }

    /// The points of three columns with coordinates.
    pub fn points(&self, columns: [usize; 3]) -> Vec<[f64; 3]> {
        let [x, y, z] = columns.map(|column| &self.columns[column].values);
        (0..x.len()).map(|row| [x[row], y[row], z[row]]).collect()
    }

    /// Whether its rows stand along an axis; else it is looked up.
    pub fn is_along(&self) -> bool {
        [[1, 0, 0, 0, 0, 0], [0; 6]].contains(&self.dimension)
    }

    /// Whether its slope or curvature has steps.
    pub fn slopes_step(&self) -> bool {
        matches!(self.between, Between::Line | Between::Monotone)
    }

    /// Places at which a column that is looked up changes its slope or jumps, if they are known and not many.
    pub fn kinks(&self, column: usize) -> Vec<f64> {
        let (places, values) = (&self.places, &self.columns[column].values);
        let is_known = self.between == Between::Line && !self.is_param && places.len() <= ROWS;
        // At a step it is infinite, or no number.
        let slope = |row: usize| (values[row + 1] - values[row]) / (places[row + 1] - places[row]);
        let rows = (1..places.len() - 1).filter(|&row| is_known && slope(row - 1) != slope(row));
        let mut kinks: Vec<f64> = rows.map(|row| places[row]).collect();
        kinks.dedup();
        kinks
    }

    /// Places of rows at which the third derivative of a spline steps, if they are known and not many: what it moves has a kink in its acceleration.
    pub fn kinks_of_acceleration(&self) -> Vec<f64> {
        let is_known = !self.is_param && self.places.len() <= ROWS;
        let rows = match self.between {
            // The first and last inner row are no knots.
            Between::Spline => 2..self.places.len().saturating_sub(2),
            // At its ends the acceleration jumps.
            Between::Clamped => 0..self.places.len(),
            Between::Line | Between::Monotone | Between::Periodic => 0..0,
        };
        rows.filter(|_| is_known).map(|row| self.places[row]).collect()
    }

    /// Value of a column at an arclength: what `rncf_runtime::Table::at` returns, which reads the same table when it runs.
    pub fn value(&self, column: usize, x: f64, length: f64) -> f64 {
        let (places, values) = (&self.places, &self.columns[column].values);
        let x = if self.is_relative { x / length } else { x };
        let last = places.len() - 1;
        if x.is_nan() || x >= places[last] {
            return values[last];
        }
        if x < places[0] {
            return values[0];
        }
        self.within(column, x)[0]
    }

    /// Value of a column (order 0) or its first, second or third derivative at a place: what `rncf_runtime::Table::look_up` returns.
    pub fn look_up(&self, column: usize, order: usize, place: f64) -> f64 {
        let (first, last) = (self.places[0], self.places[self.places.len() - 1]);
        if self.between == Between::Periodic {
            return self.within(column, first + (place - first).rem_euclid(last - first))[order];
        }
        if self.between == Between::Clamped && !(first..=last).contains(&place) {
            return if order == 0 {
                self.value(column, place, 1.0)
            } else {
                0.0 * place
            };
        }
        let margin = ROUND_OFF * (last - first);
        if !(first - margin..=last + margin).contains(&place) {
            return f64::NAN;
        }
        self.within(column, place)[order]
    }

    /// Value of a column within the rows and its derivatives.
    fn within(&self, column: usize, x: f64) -> [f64; 4] {
        let (places, values) = (&self.places, &self.columns[column].values);
        let row = places.partition_point(|&place| place <= x).clamp(1, places.len() - 1) - 1;
        let width = places[row + 1] - places[row];
        let (share, rise) = ((x - places[row]) / width, values[row + 1] - values[row]);
        if self.between == Between::Line {
            return [values[row] + share * rise, rise / width, 0.0, 0.0];
        }
        let slopes = [row, row + 1].map(|at| self.slope(column, at, row));
        spline::cubic(width, [values[row], values[row + 1]], slopes, share)
    }

    /// Slope of the cubic at a row, seen from the span that begins at row `span`.
    fn slope(&self, column: usize, row: usize, span: usize) -> f64 {
        let column = &self.columns[column];
        let known = column.slopes.get(row).copied();
        known.unwrap_or_else(|| spline::monotone_slope(&self.places, &column.values, row, span))
    }

    /// Whether a column says where the rows are: as arclengths, as parts of the length, under a name of its own, or as a coordinate
    /// of points.
    pub fn is_place(&self, column: usize) -> bool {
        let has = |name: &str| self.columns.iter().any(|column| column.name == name);
        match self.columns[column].name.as_str() {
            "x" | "eta" => true,
            "y" | "z" => ["x", "y", "z"].into_iter().all(has),
            _ => self.columns[column].values == self.places,
        }
    }

    /// Rows at places of their own: those of a step count once.
    pub fn stations(&self) -> usize {
        1 + self.places.windows(2).filter(|pair| pair[1] > pair[0]).count()
    }
}

/// Where a body has nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Stations {
    /// At the rows of a table.
    Rows {
        /// The table.
        table: TableId,
        /// Elements from one row to the next.
        each: Expr,
    },
    /// At places where something acts.
    Places(Vec<NodeAt>),
}

/// A place where a body has a node.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeAt {
    /// m of arclength, or part of the length.
    pub place: Expr,
    /// Which of them.
    pub is_part: bool,
    /// The loop over whose repetitions it stands on one body; `None` of a body that stands in the loop itself.
    pub over: Option<RepeatId>,
}

/// A straight piece of an axis with corners: what varies along the axis does so along all of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Arclength of the whole axis at its start, m.
    pub from: Expr,
    /// Length of the whole axis, m.
    pub whole: Expr,
}

/// What a section says of its stiffness and mass: fields by their names, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Law {
    /// Whether its stiffness is given by a matrix, or else by constants about the centres.
    pub is_matrix: bool,
    /// Whether its mass is given by a matrix.
    pub has_mass_matrix: bool,
    /// Fields by their vocabulary names.
    pub fields: BTreeMap<&'static str, Expr>,
}

impl Law {
    /// Whether each strain has a damping of its own.
    pub fn is_viscous(&self) -> bool {
        DAMPINGS.iter().any(|name| self.fields.contains_key(name))
    }
}
