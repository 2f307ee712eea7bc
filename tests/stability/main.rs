//! Where other formulations fail (THEORY 10): the failing forms live here as test code, beside what the program does.

mod astronomical;
mod averaged_inertia;
mod drift;
mod energy_over_time;
mod failing;
mod inconsistent_start;
mod kept_matrix;
mod order_loss;
mod pendulum;
mod singular_angles;
mod steps;
mod undamped;
mod untied_frame;

/// Numbers in two digits.
fn short(values: &[f64]) -> String {
    let texts: Vec<String> = values.iter().map(|value| format!("{value:.1e}")).collect();
    texts.join(" ")
}
