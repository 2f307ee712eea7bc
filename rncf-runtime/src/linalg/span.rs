//! Vectors and what orthonormal ones span.

/// Euclidean length.
pub(crate) fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

/// The sum of the products of two vectors' components, in four lanes, of which one does not wait for the other.
#[inline(always)]
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut lanes = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..4 {
            lanes[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    total(lanes) + rest
}

/// Sum of four lanes. Not inlined: the order of this sum would make the compiler exchange lanes in every round of the loops before it.
#[inline(never)]
pub(crate) fn total(lanes: [f64; 4]) -> f64 {
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3])
}

/// Makes a vector one of length 1.
pub(crate) fn normalise(vector: &mut [f64]) {
    let length = norm(vector);
    vector.iter_mut().for_each(|value| *value /= length);
}

/// Removes the parts along orthonormal vectors, and adds them up in `parts` as far as it goes; twice, since the first time leaves
/// round-off of what was large.
pub(crate) fn clear(vector: &mut [f64], basis: &[Vec<f64>], parts: &mut [f64]) {
    for _ in 0..2 {
        for (index, other) in basis.iter().enumerate() {
            let part = dot(other, vector);
            vector.iter_mut().zip(other).for_each(|(value, of)| *value -= part * of);
            if let Some(sum) = parts.get_mut(index) {
                *sum += part;
            }
        }
    }
}

/// Removes the parts along orthonormal vectors; returns the length of the rest.
pub(crate) fn reduce(vector: &mut [f64], basis: &[Vec<f64>]) -> f64 {
    clear(vector, basis, &mut []);
    norm(vector)
}

/// The power of two next to a size; 1 for what is no size.
pub(crate) fn power_of_two(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() {
        size.log2().round().exp2()
    } else {
        1.0
    }
}
