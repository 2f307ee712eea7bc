//! The spin-up of THEORY 9.1 with the beam in modes, against the whole beam.

use rncf::{Method, Model};
use rncf_models::SpinUp;

use super::models::{SpinUpModal, SpinUpSmall};
use crate::runs::{WAYS, adaptive, apart, far, grid, history, short};

/// Freedoms of the beam in 6 elements.
const ALL: usize = 25;

fn modal(modes: usize, rtol: f64, times: &[f64]) -> Vec<Vec<f64>> {
    let model = SpinUpModal { modes, ..SpinUpModal::default() };
    history(&model, WAYS[0], Method::Radau, adaptive(rtol), times).0
}

#[test]
fn more_modes_come_closer_to_the_whole_beam() {
    let times = grid(0.25, 18.0);
    let (whole, _) = history(&SpinUp::default(), WAYS[0], Method::Radau, adaptive(1e-9), &times);
    let counts = [14, 18, 22, ALL];
    let errors = counts.map(|modes| apart(&modal(modes, 1e-9, &times), &whole));
    println!("modes {counts:?}: {} m", short(&errors));
    assert!(errors[3] < 1e-7);
}
