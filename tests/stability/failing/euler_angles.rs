//! A torque-free body in Euler angles (yaw, pitch, roll), by Dormand and Prince's pair with error control.

/// Why a run stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stopped {
    End,
    StepTooSmall,
    NotFinite,
}

/// What a run did.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    pub stopped: Stopped,
    pub steps: usize,
    pub smallest_step: f64,
    /// Yaw, pitch, roll (rad), angular velocity (rad/s, body axes).
    pub state: [f64; 6],
}

/// Rates of angles and angular velocity; `inertia` in the principal axes, kg m^2.
fn rates(inertia: [f64; 3], [_, pitch, roll, p, q, r]: [f64; 6]) -> [f64; 6] {
    let [a, b, c] = inertia;
    let yawing = (q * roll.sin() + r * roll.cos()) / pitch.cos();
    [
        yawing,
        q * roll.cos() - r * roll.sin(),
        p + yawing * pitch.sin(),
        (b - c) / a * q * r,
        (c - a) / b * r * p,
        (a - b) / c * p * q,
    ]
}

/// Stages of the pair: each from those before it; the last one is the solution of order 5.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
    ],
    &[
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
/// The solution of order 5 less that of order 4.
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Integrates to `end` (s) with the absolute and relative tolerance `tolerance`.
pub fn run(inertia: [f64; 3], start: [f64; 6], end: f64, tolerance: f64) -> Run {
    let (mut t, mut h, mut y) = (0.0, 1e-3_f64, start);
    let mut run = Run {
        stopped: Stopped::End,
        steps: 0,
        smallest_step: f64::INFINITY,
        state: y,
    };
    while t < end {
        h = h.min(end - t);
        let mut k = vec![rates(inertia, y)];
        let mut next = y;
        for stage in STAGES {
            let change = |i: usize| h * stage.iter().zip(&k).map(|(a, k)| a * k[i]).sum::<f64>();
            next = std::array::from_fn(|i| y[i] + change(i));
            k.push(rates(inertia, next));
        }
        let off = |i: usize| h * ERROR.iter().zip(&k).map(|(e, k)| e * k[i]).sum::<f64>();
        let error = (0..6)
            .map(|i| (off(i) / (tolerance * (1.0 + y[i].abs()))).abs())
            .fold(0.0, f64::max);
        if !next.iter().all(|value| value.is_finite()) {
            run.stopped = Stopped::NotFinite;
            return run;
        }
        if error <= 1.0 {
            (t, y) = (t + h, next);
            run.steps += 1;
            run.state = y;
            if t < end {
                run.smallest_step = run.smallest_step.min(h);
            }
        }
        h *= (0.9 * error.powf(-0.2)).clamp(0.2, 5.0);
        if h < 1e-13 * end {
            run.stopped = Stopped::StepTooSmall;
            return run;
        }
    }
    run
}
