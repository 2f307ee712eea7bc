//! Constraints differentiated twice and integrated with the classical Runge-Kutta method: nothing brings the positions
//! back.

use rncf::linalg::Saddle;
use rncf::system::ConstraintLevel;
use rncf::{State, System};

/// Accelerations and multipliers of a state: `[[M, C_x^T], [C_x, 0]] (a, lambda) = (-f, -d^2C/dt^2)`.
pub fn accelerate<S: System + ?Sized>(system: &mut S, state: &mut State) {
    let (pattern, borders) = (system.pattern().clone(), system.constraint_pattern().clone());
    let (mut mass, mut border) = (vec![0.0; pattern.entries()], vec![0.0; borders.entries()]);
    state.a.fill(0.0);
    let (mut force, mut value) = (vec![0.0; system.unknowns()], vec![0.0; system.constraints()]);
    system.residual(state, &mut force);
    system.constraint(ConstraintLevel::Acceleration, state, &mut value);
    system.mass(state, &mut mass);
    system.constraint_jacobian(state, &mut border);
    force.iter_mut().chain(&mut value).for_each(|value| *value = -*value);
    let mut saddle = Saddle::new(&pattern, system.border(), &borders);
    saddle
        .factor_symmetric(&mass, &border)
        .expect("independent constraints");
    saddle.solve(&mut force, &mut value);
    (state.a, state.lambda) = (force, value);
}

/// A step of size `h`, s, of a system without orientations.
pub fn step<S: System + ?Sized>(system: &mut S, state: &mut State, h: f64) {
    let start = state.clone();
    let (mut x, mut v) = (vec![0.0; start.x.len()], vec![0.0; start.x.len()]);
    for (node, weight) in [(0.5, 1.0), (0.5, 2.0), (1.0, 2.0), (0.0, 1.0)] {
        accelerate(system, state);
        for i in 0..x.len() {
            x[i] += weight / 6.0 * h * state.v[i];
            v[i] += weight / 6.0 * h * state.a[i];
        }
        let (rate, acceleration) = (state.v.clone(), state.a.clone());
        state.t = start.t + node * h;
        for i in 0..x.len() {
            state.x[i] = start.x[i] + node * h * rate[i];
            state.v[i] = start.v[i] + node * h * acceleration[i];
        }
    }
    state.t = start.t + h;
    for i in 0..x.len() {
        state.x[i] = start.x[i] + x[i];
        state.v[i] = start.v[i] + v[i];
    }
}
