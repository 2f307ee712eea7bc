//! Where other formulations fail (THEORY 10): the failing forms live here as test code, beside what the program does.

mod astronomical;
mod averaged_inertia;
mod buckling;
mod collapse;
mod compression;
mod drift;
mod energy_over_time;
mod failing;
mod hourglass;
mod inconsistent_start;
mod kept_matrix;
mod leaking_momentum;
mod locking;
mod order_loss;
mod pendulum;
mod remainders;
mod scenes;
mod singular_angles;
mod softening;
mod steps;
mod undamped;
mod untied_frame;
mod whirl;

/// Numbers in two digits.
fn short(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    texts.join(" ")
}

/// Fails where a number is not the printed one within a part of it: the digits that THEORY prints.
#[track_caller]
fn agrees(found: f64, printed: f64, within: f64) {
    assert!(
        (found / printed - 1.0).abs() < within,
        "{found:e} instead of {printed:e}"
    );
}
