//! Vectors and matrices of space.

/// Three components.
pub type Vector = [f64; 3];
/// Three rows.
pub type Matrix = [[f64; 3]; 3];

/// `a + b`
pub fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

/// `a - b`
pub fn subtract(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

/// `s a`
pub fn scale(s: f64, a: Vector) -> Vector {
    a.map(|component| s * component)
}

/// `a x b`
pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// `a . b`
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `|a|`
pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The matrix of `u x`, THEORY 0.
pub fn skew([x, y, z]: Vector) -> Matrix {
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

/// The unit matrix.
pub fn identity() -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }))
}

/// `A u`
pub fn apply(a: &Matrix, u: Vector) -> Vector {
    a.map(|row| dot(row, u))
}

/// `A^T u`
pub fn apply_transposed(a: &Matrix, u: Vector) -> Vector {
    std::array::from_fn(|i| a[0][i] * u[0] + a[1][i] * u[1] + a[2][i] * u[2])
}

/// `A B`
pub fn multiply(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]))
}

/// `A^T`
pub fn transpose(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// Determinant: the triple product of the rows.
pub fn determinant(a: &Matrix) -> f64 {
    dot(a[0], cross(a[1], a[2]))
}

/// Inverse of a regular matrix.
pub fn inverse(a: &Matrix) -> Matrix {
    let columns = [cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])];
    let determinant = determinant(a);
    std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i] / determinant))
}

/// `sum_a u_a x v_a`
pub(crate) fn crossed(u: &[Vector], v: &[Vector]) -> Vector {
    u.iter().zip(v).fold([0.0; 3], |sum, (&u, &v)| add(sum, cross(u, v)))
}

/// `sum_a [u_a]^T [v_a]`, `[u]^T [v] = (u . v) 1 - v u^T`
pub(crate) fn second_moment(u: &[Vector], v: &[Vector]) -> Matrix {
    let mut sum = [[0.0; 3]; 3];
    for (&u, &v) in u.iter().zip(v) {
        let trace = dot(u, v);
        for i in 0..3 {
            sum[i][i] += trace;
            for j in 0..3 {
                sum[i][j] -= v[i] * u[j];
            }
        }
    }
    sum
}

/// A unit vector normal to the unit vector `t`.
pub fn perpendicular(t: Vector) -> Vector {
    let smallest = (0..3).min_by(|&i, &j| t[i].abs().total_cmp(&t[j].abs())).unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[smallest] = 1.0;
    let normal = cross(t, axis);
    scale(1.0 / norm(normal), normal)
}
