use super::*;
use crate::vector::subtract;

const NU: Vector = [0.7, -1.1, 0.4];
const RATE: Vector = [-0.3, 0.2, 0.9];
const STEP: f64 = 1e-5;

fn moved(y: Vector, d: Vector, by: f64) -> Vector {
    add(y, scale(by, d))
}

/// Central difference of a function of the step.
fn difference(of: impl Fn(f64) -> Vector) -> Vector {
    scale(0.5 / STEP, subtract(of(STEP), of(-STEP)))
}

fn close(a: Vector, b: Vector, what: &str) {
    assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-8), "{what}: {a:?} {b:?}");
}

#[test]
fn velocities_and_accelerations_are_those_of_the_rotation() {
    // Both sides of the series, and a large angle.
    for size in [0.0, 1e-3, 0.3, 0.999, 1.001, 2.5] {
        let xi = scale(size, [0.48, -0.6, 0.64]);
        let point = Point::new(xi);
        close(point.map(NU), apply(&tangent_map(xi), NU), "velocity");
        let velocity = |t: f64| {
            let xi = add(xi, add(scale(t, NU), scale(0.5 * t * t, RATE)));
            Point::new(xi).map(moved(NU, RATE, t))
        };
        let acceleration = add(point.map(RATE), point.turning(NU));
        close(acceleration, difference(velocity), "acceleration");
    }
}

#[test]
fn changes_are_derivatives() {
    for size in [0.0, 1e-3, 0.3, 0.999, 1.001, 2.5] {
        let xi = scale(size, [0.48, -0.6, 0.64]);
        let point = Point::new(xi);
        for d in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.2, -0.3, 1.0]] {
            let near = |t: f64| Point::new(moved(xi, d, t));
            close(point.map_change(NU, d), difference(|t| near(t).map(NU)), "T by xi");
            close(
                point.turning_change(NU, d),
                difference(|t| near(t).turning(NU)),
                "W by xi",
            );
            let by_rate = difference(|t| point.turning(moved(NU, d, t)));
            close(point.turning_change_by_rate(NU, d), by_rate, "W by nu");
        }
    }
}
