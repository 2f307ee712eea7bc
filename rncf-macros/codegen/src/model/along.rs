//! What varies along the axis of a body: tables, stations, sections that say their stiffness by themselves.

use std::collections::BTreeMap;

use super::{Body, Expr, TableId, fold};
use crate::vocabulary::DAMPINGS;

/// Numbers along an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name in the declaration.
    pub name: String,
    /// The file that it stands in, beside the manifest of its crate.
    pub file: Option<String>,
    /// Places along the axis, ascending; two equal ones are a step.
    pub places: Vec<f64>,
    /// Whether places are fractions of the length, or else in m.
    pub is_relative: bool,
    /// Whether values between rows follow a monotone cubic, or else a line.
    pub is_smooth: bool,
    /// Columns in SI.
    pub columns: Vec<Column>,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Exponents of m, kg, s, K, A, angle.
    pub dimension: [i8; 6],
    /// One value for each row, SI.
    pub values: Vec<f64>,
}

impl Table {
    /// Name in generated code.
    pub fn constant(&self) -> String {
        format!("TABLE_{}", self.name.to_uppercase())
    }

    /// Text of a column's value at the arclength `x` of an axis with the length `length`.
    pub fn lookup(&self, column: usize) -> String {
        format!("{}.at({column}, x, length)", self.constant())
    }

    /// Value of a column at an arclength, between rows on a line.
    pub fn value(&self, column: usize, x: f64, length: f64) -> f64 {
        let (places, values) = (&self.places, &self.columns[column].values);
        let x = if self.is_relative { x / length } else { x };
        let row = places.partition_point(|&place| place <= x).clamp(1, places.len() - 1) - 1;
        let share = (x - places[row]) / (places[row + 1] - places[row]);
        values[row] + share.clamp(0.0, 1.0) * (values[row + 1] - values[row])
    }

    /// Rows at places of their own: those of a step count once.
    pub fn stations(&self) -> usize {
        1 + self.places.windows(2).filter(|pair| pair[1] > pair[0]).count()
    }
}

/// Nodes of a body at the rows of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Stations {
    /// The table.
    pub table: TableId,
    /// Elements from one row to the next.
    pub each: Expr,
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

impl Body {
    /// Whether its elements differ, or have coefficients at every point.
    pub fn varies(&self) -> bool {
        self.law.is_some() || self.stations.is_some() || self.properties.values().any(fold::has_arclength)
    }
}
