//! The flyball governor in three coordinates against THEORY 9.7.

use rncf_reference::governor::{Governor, SPIN, START};
use rncf_reference::integrate::{Method, agreed};

#[test]
fn published_numbers() {
    let governor = Governor::new(SPIN);
    let run = agreed(&governor, Method::Radau5, 1e-13, &START, &[0.0, 1.0, 5.0], 1e-7).unwrap();
    println!("governor: tolerances agree to {:.1e}", run.difference);
    let expected = [
        [0.5269333016, 0.4970948185, 1.0089854758],
        [0.6065952598, 0.4298990897, 1.1102833655],
    ];
    for (y, [alpha, s, spin]) in run.states[1..].iter().zip(expected) {
        let errors = [y[0] - alpha, y[1] - s, governor.spin(y) - spin].map(f64::abs);
        println!("governor: errors {errors:?}");
        assert!(errors.iter().all(|&error| error < 2e-9), "{errors:?}");
    }
}
