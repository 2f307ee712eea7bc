//! Vectors and 3x3 matrices of graph nodes.

use super::graph::{Graph, Id};

/// A vector of nodes.
pub type Vector = Vec<Id>;

/// A 3x3 matrix of nodes, rows first.
pub type Matrix3 = [[Id; 3]; 3];

impl Graph {
    /// `a + b`, component by component.
    pub fn add_vectors(&mut self, a: &[Id], b: &[Id]) -> Vector {
        a.iter().zip(b).map(|(&x, &y)| self.add(x, y)).collect()
    }

    /// `a - b`, component by component.
    pub fn subtract_vectors(&mut self, a: &[Id], b: &[Id]) -> Vector {
        a.iter().zip(b).map(|(&x, &y)| self.subtract(x, y)).collect()
    }

    /// `factor * a`.
    pub fn scale(&mut self, factor: Id, a: &[Id]) -> Vector {
        a.iter().map(|&x| self.multiply(factor, x)).collect()
    }

    /// `a x b` in three dimensions.
    pub fn cross(&mut self, a: &[Id], b: &[Id]) -> Vector {
        (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let (left, right) = (self.multiply(a[j], b[k]), self.multiply(a[k], b[j]));
                self.subtract(left, right)
            })
            .collect()
    }

    /// `A b`.
    pub fn apply(&mut self, a: &Matrix3, b: &[Id]) -> Vector {
        a.iter().map(|row| self.dot(row, b)).collect()
    }

    /// `A^T b`.
    pub fn apply_transposed(&mut self, a: &Matrix3, b: &[Id]) -> Vector {
        let transposed = transpose(a);
        self.apply(&transposed, b)
    }

    /// `A B`.
    pub fn multiply_matrices(&mut self, a: &Matrix3, b: &Matrix3) -> Matrix3 {
        let columns = transpose(b);
        std::array::from_fn(|i| std::array::from_fn(|j| self.dot(&a[i], &columns[j])))
    }

    /// The identity.
    pub fn identity(&mut self) -> Matrix3 {
        let (zero, one) = (self.zero(), self.one());
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { one } else { zero }))
    }

    /// Rotation by `angle` about a constant unit axis (Rodrigues).
    pub fn rotation(&mut self, axis: [f64; 3], angle: Id) -> Matrix3 {
        let cosine = self.call(crate::model::Function::Cos, angle);
        let sine = self.call(crate::model::Function::Sin, angle);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                // a a^T + cos (1 - a a^T) + sin [a]
                let along = axis[i] * axis[j];
                let across = f64::from(u8::from(i == j)) - along;
                let skew = match (3 + j - i) % 3 {
                    1 => -axis[3 - i - j],
                    2 => axis[3 - i - j],
                    _ => 0.0,
                };
                let (along, across, skew) = (self.number(along), self.number(across), self.number(skew));
                let terms = [along, self.multiply(across, cosine), self.multiply(skew, sine)];
                self.sum(&terms)
            })
        })
    }
}

/// The transpose.
pub fn transpose(a: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}
