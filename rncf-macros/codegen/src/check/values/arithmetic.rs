//! Vectors and matrices of numbers.

pub type Vector = [f64; 3];

/// Rotation matrix, rows first.
pub type Matrix = [[f64; 3]; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn subtract(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale(factor: f64, a: Vector) -> Vector {
    a.map(|x| factor * x)
}

pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// Unit vector; `None` where there is no direction.
pub fn unit(a: Vector) -> Option<Vector> {
    let size = norm(a);
    (size > 0.0 && size.is_finite()).then(|| scale(1.0 / size, a))
}
