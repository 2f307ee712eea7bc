//! Integrals of products of shape functions over the unit element, as constant tensors.

use crate::symbolic::Array;
use crate::tensors::Polynomial;

/// Integrals over the unit element; the last row has 1 in place of a shape function.
pub(super) struct Integrals {
    /// Of the shape functions.
    pub(super) constant: Vec<f64>,
    /// Of their products with h_j'.
    pub(super) linear: Vec<Vec<f64>>,
    /// Of their products with h_j' h_m', by [`pairs`].
    pub(super) quadratic: Vec<Vec<f64>>,
    /// Number of relative vectors.
    pub(super) count: usize,
}

impl Integrals {
    /// Of shape functions of relative vectors; zero for what is not on the axis.
    pub fn of(shapes: &[Polynomial]) -> Self {
        let one = Polynomial::whole(&[1]);
        let rows = || shapes.iter().chain([&one]);
        let slopes: Vec<Polynomial> = shapes.iter().map(|shape| shape.derivative(1)).collect();
        let count = shapes.len();
        let integral = |row: &Polynomial, of: &Polynomial| row.product(of).integral().to_f64();
        Self {
            constant: rows().map(|row| row.integral().to_f64()).collect(),
            linear: rows()
                .map(|row| slopes.iter().map(|slope| integral(row, slope)).collect())
                .collect(),
            quadratic: rows()
                .map(|row| {
                    pairs(count)
                        .map(|(j, m)| integral(row, &slopes[j].product(&slopes[m])))
                        .collect()
                })
                .collect(),
            count,
        }
    }

    pub(super) fn quadratic(&self, row: usize, j: usize, m: usize) -> f64 {
        let wanted = (j.min(m), j.max(m));
        let place = pairs(self.count).position(|pair| pair == wanted);
        place.map_or(0.0, |place| self.quadratic[row][place])
    }

    /// The tensors as they stand in generated code, for an element's variant and its relative vectors.
    pub fn arrays(&self, variant: &str, vectors: &[&str]) -> Vec<Array> {
        let name = |what: &str| format!("{variant}_density_{what}").to_uppercase();
        let rows = format!(
            "Rows: {}, and 1 in place of a shape function (zeta).",
            vectors.join(", ")
        );
        let columns: Vec<String> = pairs(self.count)
            .map(|(j, m)| format!("{} {}", vectors[j], vectors[m]))
            .collect();
        vec![
            Array {
                name: name("iota"),
                doc: vec![
                    "Tensor iota of the unit element for loads per length: the integrals of s_a h_j' h_m' over xi from 0 to 1.".to_string(),
                    format!("{rows} Columns: {}.", columns.join(", ")),
                ],
                rows: self.quadratic.clone(),
            },
            Array {
                name: name("linear"),
                doc: vec![
                    "Integrals of s_a h_j' over the unit element, for loads per length.".to_string(),
                    format!("{rows} Columns: {}.", vectors.join(", ")),
                ],
                rows: self.linear.clone(),
            },
        ]
    }
}

/// Pairs of relative vectors, the first one not behind the second.
pub(super) fn pairs(count: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..count).flat_map(move |j| (j..count).map(move |m| (j, m)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tensors of the cable's thrust, docs/theory.md Eq. 38: `iota^{1,jm}` and `zeta` on nodal vectors, l = 1; with r0 as the
    /// base the row and column of d are those of r1.
    #[test]
    fn the_tensors_are_the_closed_forms() {
        let shapes = [&[0, 1, -2, 1][..], &[0, 0, 3, -2], &[0, 0, -1, 1]].map(Polynomial::whole);
        let integrals = Integrals::of(&shapes);
        // zeta: d d 6/5, s0 d 1/10, s0 s0 2/15, s0 s1 -1/30.
        let whole = 3;
        for ((j, m), closed) in [
            ((1, 1), 1.2),
            ((0, 1), -0.1),
            ((0, 0), 2.0 / 15.0),
            ((0, 2), -1.0 / 30.0),
        ] {
            assert_eq!(integrals.quadratic(whole, j, m), closed, "{j} {m}");
        }
        // iota of r1: d d 3/5, and of s0: d d 9/70.
        for ((j, m), closed) in [
            ((1, 1), 0.6),
            ((0, 1), -4.0 / 35.0),
            ((0, 0), 13.0 / 420.0),
            ((0, 2), -1.0 / 60.0),
        ] {
            assert_eq!(integrals.quadratic(1, j, m), closed, "{j} {m}");
        }
        assert_eq!(integrals.quadratic(0, 1, 1), 9.0 / 70.0);
        assert_eq!(integrals.constant, [1.0 / 12.0, 0.5, -1.0 / 12.0, 1.0]);
    }
}
