//! The section below rigid fixtures.

use crate::scene::bodies::place::MeshPoint;
use crate::space::Vector;

/// The axes r_y and r_z and the normal of a section, frame axes.
pub(crate) type Axes = [Vector; 3];

/// Places among the [`Axes`] of the two whose inner product a row keeps; of an axis with itself half of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kept(pub [usize; 2]);

impl Kept {
    pub const NORMAL: usize = 2;

    /// Whether it is a row of the normal.
    pub fn is_of_normal(self) -> bool {
        self.0[1] == Self::NORMAL
    }

    /// Its gradient, linear in the axes: with another one in their place their bilinear form.
    pub fn gradient(self, at: &Axes) -> Axes {
        let mut gradient = [Vector::zeros(); 3];
        let Self([first, second]) = self;
        gradient[first] = at[second];
        gradient[second] = at[first];
        gradient
    }

    pub fn value(self, at: &Axes) -> f64 {
        0.5 * inner(&self.gradient(at), at)
    }
}

pub(crate) fn inner(a: &Axes, b: &Axes) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

/// What a component of the full arrays does to the axes of a section.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Column {
    pub component: usize,
    /// Number among the [`Axes`], and frame axis.
    pub vector: usize,
    pub axis: usize,
    pub weight: f64,
}

/// The section below one or several rigid fixtures.
pub(crate) struct RigidSection {
    /// Name of the first of them.
    pub name: &'static str,
    pub point: MeshPoint,
    pub rows: Vec<Kept>,
    /// What they start with.
    pub references: Vec<f64>,
    pub columns: Vec<Column>,
    /// N m: makes the leading block of matrices regular where the normal has no stiffness. It stands before squares of the rows'
    /// gradients and changes nothing but multipliers, by what the rows are off.
    pub stiffness: f64,
}

impl RigidSection {
    /// Number of its constraints.
    pub fn rows(&self) -> usize {
        self.rows.len()
    }

    /// What a row keeps, in words.
    pub fn describe(&self, row: usize) -> &'static str {
        match self.rows[row].0 {
            [0, 0] => "length of the section's y axis",
            [1, 1] => "length of the section's z axis",
            [0, 1] => "angle between the section's axes",
            _ => "normal of the section",
        }
    }

    /// Components that a row depends on.
    pub fn components(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        let Kept(axes) = self.rows[row];
        let own = self.columns.iter().filter(move |column| axes.contains(&column.vector));
        own.map(|column| column.component)
    }

    /// The axes, or their rates, from the full arrays.
    pub fn axes(&self, full: &[f64]) -> Axes {
        let mut axes = [Vector::zeros(); 3];
        for column in &self.columns {
            axes[column.vector][column.axis] += column.weight * full[column.component];
        }
        axes
    }

    /// Calls with every component and what a gradient by the axes is by it.
    pub fn each(&self, gradient: &Axes, mut call: impl FnMut(usize, f64)) {
        for column in &self.columns {
            call(column.component, column.weight * gradient[column.vector][column.axis]);
        }
    }

    /// Sum of the rows' gradients with multipliers.
    pub fn pull(&self, at: &Axes, lambda: &[f64]) -> Axes {
        let mut sum = [Vector::zeros(); 3];
        for (kept, multiplier) in self.rows.iter().zip(lambda) {
            let gradient = kept.gradient(at);
            for (sum, value) in sum.iter_mut().flatten().zip(gradient.iter().flatten()) {
                *sum += multiplier * value;
            }
        }
        sum
    }
}
