//! Roll-up to a circle against THEORY 5.2.1 and the hand-written chain.

use std::f64::consts::PI;

use rncf_models::RollUp;
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Slot, Supports, straight};
use rncf_reference::section_statics::{Load, Problem};

use crate::scenes::{at_rest, distance};

/// Place of the tip in the exact solution of the quartic model (THEORY 5.2.1), unit length.
fn rolled_up(radius: f64) -> [f64; 2] {
    let ratio = 0.25 * radius * radius;
    let (mut a, mut b) = (1.0_f64, 1.0_f64);
    for _ in 0..100 {
        let angle = 2.0 * PI / (a * a * b * b);
        let strained = |other: f64| (1.0 - 2.0 * ratio * (other * angle).powi(2)).sqrt();
        (a, b) = (strained(b), strained(a));
    }
    let angle = 2.0 * PI / (a * a * b * b);
    [a / angle * angle.sin(), a / angle * (1.0 - angle.cos())]
}

/// Tip of the hand-written chain with whole directors held.
fn by_hand(radius: f64, elements: usize) -> [f64; 3] {
    let section = Section::circle(radius, 210e9, 0.3, 7850.0);
    let chain = Chain::along(Properties::structural(2, 1.0, &section), elements, straight).unwrap();
    let problem = Problem {
        supports: Supports::clamp(&chain, Hold::Fixed),
        chain,
        loads: vec![Load::Moment(elements, 2.0 * PI * section.young * section.i_zz)],
        spin: [0.0; 3],
    };
    let q = problem.solve(20).unwrap();
    problem.chain.read(&q, problem.chain.vector(elements, Slot::Position))
}

#[test]
fn rolls_up_as_tabulated() {
    // THEORY 5.2.1, rows with 3 and 2 Gauss points: error of the tip over the length for 4, 6, 8, 12, 16 elements.
    const TABLE: [(f64, [f64; 5]); 2] = [
        (0.02, [2.2e-3, 3.4e-4, 1.6e-4, 3.4e-5, 3.8e-6]),
        (0.005, [4.0e-3, 6.1e-4, 1.4e-4, 7.4e-6, 8.5e-6]),
    ];
    for (radius, errors) in TABLE {
        let exact = rolled_up(radius);
        for (elements, expected) in [4, 6, 8, 12, 16].into_iter().zip(errors) {
            let model = RollUp {
                turns: 1.0,
                slenderness: radius,
                elements,
            };
            let tip = at_rest(&model, 0.125);
            let error = distance(&tip[..2], &exact);
            let apart = distance(&tip[..2], &by_hand(radius, elements)[..2]);
            println!(
                "r/L {radius}, {elements} elements: error {error:.3e}, table {expected:.1e}, from the chain {apart:.1e}"
            );
            assert!(apart < 1e-9);
            assert!((error / expected - 1.0).abs() < 0.03, "{error} instead of {expected}");
        }
    }
}
