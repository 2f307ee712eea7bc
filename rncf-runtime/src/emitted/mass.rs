//! Mass matrices of elements whose section varies along the axis.

use super::body_spec::Interpolant;
use super::gauss::EIGHT;
use crate::error::ModelError;

/// Mass matrix of the `count` vectors of an element with a length (m), rows first, from masses per length that move with r r,
/// r r_y, r r_z, r_y r_y, r_z r_z, r_y r_z at places in [0, 1], and the weights of the vectors there.
///
/// # Errors
/// Those of the masses.
pub fn mass_along(
    count: usize,
    length: f64,
    masses: impl Fn(f64) -> Result<[f64; 6], ModelError>,
    weights: impl Fn(Interpolant, f64, &mut [f64]),
) -> Result<Vec<f64>, ModelError> {
    let mut sums = vec![0.0; count * count];
    let of = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ];
    let pairs = [(0, 0), (0, 1), (0, 2), (1, 1), (2, 2), (1, 2)];
    let mirrored = EIGHT.iter().rev().map(|&(place, weight)| (1.0 - place, weight));
    for (xi, weight) in EIGHT.into_iter().chain(mirrored) {
        let shapes = of.map(|of| {
            let mut shapes = vec![0.0; count];
            weights(of, xi, &mut shapes);
            shapes
        });
        for (&(i, j), mass) in pairs.iter().zip(masses(xi)?) {
            let factor = weight * length * mass;
            for (a, b) in (0..count).flat_map(|a| (0..count).map(move |b| (a, b))) {
                sums[a * count + b] += factor * shapes[i][a] * shapes[j][b];
                if i != j {
                    sums[a * count + b] += factor * shapes[j][a] * shapes[i][b];
                }
            }
        }
    }
    Ok(sums)
}
