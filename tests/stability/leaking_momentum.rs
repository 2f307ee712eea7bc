//! T16: an iteration whose remainder is measured by the step leaks momentum into motions that nothing brings back.
//!
//! A rigid body in a plane that turns freely, described by a point beside its centre of mass, so that its momentum is not linear
//! in the unknowns. Implicit midpoint rule with modified Newton increments.

/// Distance from the centre of mass, m, mass, kg, and inertia about it, kg m^2.
const LEVER: f64 = 0.5;
const MASS: f64 = 2.0;
const INERTIA: f64 = 0.3;
const RTOL: f64 = 1e-6;
const H: f64 = 0.01;
/// Turned since it was made, a matrix is made anew from this angle on, rad.
const TURNED: f64 = 0.2;

/// Position of the point and angle, their rates.
type Triple = [f64; 3];

fn residual(x: Triple, v: Triple, a: Triple) -> Triple {
    let (sin, cos) = x[2].sin_cos();
    let centre = [
        a[0] - LEVER * (sin * a[2] + cos * v[2] * v[2]),
        a[1] + LEVER * (cos * a[2] - sin * v[2] * v[2]),
    ];
    let turning = INERTIA * a[2] + MASS * LEVER * (cos * centre[1] - sin * centre[0]);
    [MASS * centre[0], MASS * centre[1], turning]
}

/// Solves with the mass matrix at an angle.
fn solve(angle: f64, r: Triple) -> Triple {
    let (sin, cos) = angle.sin_cos();
    let turning = (r[2] - LEVER * (cos * r[1] - sin * r[0])) / INERTIA;
    [
        r[0] / MASS + LEVER * sin * turning,
        r[1] / MASS - LEVER * cos * turning,
        turning,
    ]
}

/// Position and angle after `span` seconds; an iteration ends where `remainder(largest change of the acceleration)` is at most 1.
fn run(span: f64, remainder: impl Fn(f64) -> f64) -> (Triple, u32) {
    let (mut x, mut v, mut a): (Triple, Triple, Triple) = ([0.0; 3], [1.0, 0.5, 3.0], [0.0; 3]);
    let (mut made_at, mut iterations) = (0.0, 0);
    for _ in 0..(span / H).round() as usize {
        if f64::abs(x[2] - made_at) > TURNED {
            made_at = x[2];
        }
        // The last step's acceleration predicts this one's.
        for _ in 0..50 {
            let rate: Triple = std::array::from_fn(|i| v[i] + 0.5 * H * a[i]);
            let middle = std::array::from_fn(|i| x[i] + 0.5 * H * rate[i]);
            let change = solve(made_at, residual(middle, rate, a));
            a = std::array::from_fn(|i| a[i] - change[i]);
            iterations += 1;
            if remainder(change.iter().fold(0.0, |most, change| f64::max(most, change.abs()))) <= 1.0 {
                break;
            }
        }
        for i in 0..3 {
            x[i] += H * (v[i] + 0.5 * H * a[i]);
            v[i] += H * a[i];
        }
    }
    (x, iterations)
}

#[test]
fn a_remainder_measured_by_the_step_is_a_wrong_velocity() {
    let error = |span: f64, remainder: &dyn Fn(f64) -> f64| {
        let (exact, _) = run(span, |change| change / 1e-14);
        let (found, iterations) = run(span, remainder);
        let far = exact.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        (far, iterations)
    };
    for span in [10.0, 40.0, 160.0] {
        // A thousandth of the tolerance of a step, as customary.
        let (by_step, few) = error(span, &|change| H * H * change / (1e-3 * RTOL));
        // What the remainder moves until the end of the run.
        let (by_run, more) = error(span, &|change| 0.5 * span * span * change / RTOL);
        println!("{span} s: by the step {by_step:.1e} ({few} iterations), by the run {by_run:.1e} ({more} iterations)");
        // It grows with the square of the time, as by a constant force.
        let law = 1.1e-5 * (span / 10.0).powi(2);
        assert!((by_step / law - 1.0).abs() < 0.1, "{by_step:e} instead of {law:e}");
        assert!(by_run < RTOL, "{by_run:e}");
        assert!(more < 3 * few);
    }
}
