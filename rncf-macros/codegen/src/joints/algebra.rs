//! Vectors of expressions, and markers as such vectors. Sums and products with zero and one are
//! folded, so that what vanishes in a plane is not computed.

use crate::model::{Binary, Expr, Function, Marker, MarkerId, Observable};

/// Three components, inertial axes unless said otherwise.
pub type Vector = [Expr; 3];

/// A number.
pub fn number(value: f64) -> Expr {
    Expr::Number(value)
}

/// A vector of numbers.
pub fn numbers(values: [f64; 3]) -> Vector {
    values.map(Expr::Number)
}

/// A unit vector along an axis.
pub fn unit(axis: usize) -> [f64; 3] {
    let mut unit = [0.0; 3];
    unit[axis] = 1.0;
    unit
}

fn is(expr: &Expr, value: f64) -> bool {
    matches!(expr, Expr::Number(number) if *number == value)
}

/// `a + b`
pub fn add(a: Expr, b: Expr) -> Expr {
    match (is(&a, 0.0), is(&b, 0.0)) {
        (true, _) => b,
        (_, true) => a,
        _ => Expr::Binary(Binary::Add, Box::new(a), Box::new(b)),
    }
}

/// `-a`
pub fn negate(a: Expr) -> Expr {
    match a {
        Expr::Number(value) => number(if value == 0.0 { 0.0 } else { -value }),
        Expr::Negate(inner) => *inner,
        other => Expr::Negate(Box::new(other)),
    }
}

/// `a - b`
pub fn subtract(a: Expr, b: Expr) -> Expr {
    match (is(&a, 0.0), is(&b, 0.0)) {
        (true, _) => negate(b),
        (_, true) => a,
        _ => Expr::Binary(Binary::Subtract, Box::new(a), Box::new(b)),
    }
}

/// `a b`
pub fn multiply(a: Expr, b: Expr) -> Expr {
    if is(&a, 0.0) || is(&b, 0.0) {
        return number(0.0);
    }
    match (is(&a, 1.0), is(&b, 1.0)) {
        (true, _) => b,
        (_, true) => a,
        _ if is(&a, -1.0) => negate(b),
        _ if is(&b, -1.0) => negate(a),
        _ => Expr::Binary(Binary::Multiply, Box::new(a), Box::new(b)),
    }
}

/// `a / b`
pub fn divide(a: Expr, b: Expr) -> Expr {
    if is(&a, 0.0) || is(&b, 1.0) {
        return a;
    }
    Expr::Binary(Binary::Divide, Box::new(a), Box::new(b))
}

/// A function of one argument.
pub fn call(function: Function, argument: Expr) -> Expr {
    Expr::Call(function, vec![argument])
}

/// The angle of a point (x, y), rad, in (-pi, pi].
pub fn angle(y: Expr, x: Expr) -> Expr {
    Expr::Call(Function::Atan2, vec![y, x])
}

/// Component by component.
pub fn both(a: &Vector, b: &Vector, of: impl Fn(Expr, Expr) -> Expr) -> Vector {
    std::array::from_fn(|axis| of(a[axis].clone(), b[axis].clone()))
}

/// `s a`
pub fn scale(s: &Expr, a: &Vector) -> Vector {
    a.clone().map(|component| multiply(s.clone(), component))
}

/// `a . b`
pub fn dot(a: &Vector, b: &Vector) -> Expr {
    let [x, y, z] = both(a, b, multiply);
    add(add(x, y), z)
}

/// `a x b`
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        subtract(
            multiply(a[next].clone(), b[last].clone()),
            multiply(a[last].clone(), b[next].clone()),
        )
    })
}

/// `|a|`
pub fn norm(a: &Vector) -> Expr {
    call(Function::Sqrt, dot(a, a))
}

/// `a / |a|`
pub fn normalised(a: &Vector) -> Vector {
    let length = norm(a);
    a.clone().map(|component| divide(component, length.clone()))
}

/// The force on a direction that does the work of a moment normal to it: `m x d / d.d`.
pub fn turning(moment: &Vector, direction: &Vector) -> Vector {
    let square = dot(direction, direction);
    cross(moment, direction).map(|component| divide(component, square.clone()))
}

/// A marker or a time derivative of it; in a plane without the component along its normal.
pub fn observed(marker: MarkerId, derivative: usize, normal: Option<usize>) -> Vector {
    std::array::from_fn(|component| {
        if Some(component) == normal {
            return number(0.0);
        }
        Expr::Observed(Observable::Marker {
            marker,
            derivative,
            component,
        })
    })
}

/// Index of a marker; a new one is added.
pub fn intern(markers: &mut Vec<Marker>, marker: Marker) -> MarkerId {
    let known = markers.iter().position(|other| *other == marker);
    MarkerId(known.unwrap_or_else(|| {
        markers.push(marker);
        markers.len() - 1
    }))
}

/// Adds the markers that an expression is a function of, in the order in which they stand there.
pub fn markers_of(expr: &Expr, found: &mut Vec<MarkerId>) {
    expr.each_observable(&mut |observable| {
        if let Observable::Marker { marker, .. } = observable
            && !found.contains(marker)
        {
            found.push(*marker);
        }
    });
}

/// Whether time stands in an expression.
pub fn has_time(expr: &Expr) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Time))
}
