//! Buckling loads: right-angle frame (THEORY 9.7) and cantilever strip on edge (THEORY 9.7).

use std::f64::consts::PI;

use rncf::equilibrium::critical_factor;
use rncf_models::{LateralBuckling, RightAngleFrame};

use crate::scenes::{at_rest, referenced};

#[test]
fn right_angle_frame() {
    for (load, exact) in [(1.3, 1.08409), (-0.9, -0.67893)] {
        for elements in [2, 4] {
            let model = RightAngleFrame {
                load,
                elements,
                ..RightAngleFrame::default()
            };
            let mut scene = referenced(&model);
            let found = critical_factor(scene.as_mut(), 0.0).unwrap().unwrap();
            let error = found.factor * load / exact - 1.0;
            println!(
                "right-angle frame, {elements} elements a leg: {:.6} N of {exact} N, {error:.1e}",
                found.factor * load
            );
            assert!(!found.is_limit);
            assert!(error.abs() < 1e-2);
        }
    }
}

/// Torsion constant of a rectangle `b x t`, by Saint-Venant's series.
fn torsion(b: f64, t: f64) -> f64 {
    let sum: f64 = (0..40)
        .map(|k| f64::from(2 * k + 1))
        .map(|n| (0.5 * n * PI * b / t).tanh() / n.powi(5))
        .sum();
    b * t.powi(3) / 3.0 * (1.0 - 192.0 / PI.powi(5) * t / b * sum)
}

#[test]
fn strip_on_edge() {
    let (young, b, t) = (210e9, 0.03_f64, 0.001_f64);
    let (weak, strong) = (young * b * t.powi(3) / 12.0, young * t * b.powi(3) / 12.0);
    let twist = young / 2.6 * torsion(b, t);
    let classical = 4.0126 * (weak * twist).sqrt();
    // The bending before it, which the classical load neglects, stiffens.
    let bent = classical / ((1.0 - weak / strong) * (1.0 - twist / strong)).sqrt();
    for elements in [4, 8] {
        let model = LateralBuckling {
            load: 4.0,
            elements,
            ..LateralBuckling::default()
        };
        let mut scene = referenced(&model);
        let found = critical_factor(scene.as_mut(), 0.0).unwrap().unwrap();
        let load = 4.0 * found.factor;
        println!(
            "strip on edge, {elements} elements: {load:.6} N, classical {:.2e}, bent before {:.2e}",
            load / classical - 1.0,
            load / bent - 1.0
        );
        assert!(!found.is_limit && (load / classical - 1.0).abs() < 5e-3);
        if elements == 8 {
            assert!((load / bent - 1.0).abs() < 1e-3);
        }
    }
    // Beyond it a small disturbance tilts the strip; in front of it hardly.
    let tilted = |part: f64, disturbance: f64| {
        let model = LateralBuckling {
            load: part * classical,
            disturbance: disturbance * classical,
            elements: 4,
        };
        at_rest(&model, 0.125)
    };
    let (before, beyond) = (tilted(0.8, 1e-2), tilted(1.1, 1e-2));
    println!("strip on edge: y, z, twist {before:.4?} and {beyond:.4?}");
    assert!(before[2].abs() < 0.1 && beyond[2].abs() > 0.3);
    // A hundredth of the disturbance leads to nearly the same shape, farther beyond it too.
    let least = tilted(1.1, 1e-4);
    let far = [1e-2, 1e-4].map(|disturbance| tilted(1.7, disturbance)[0]);
    println!("strip on edge, least disturbance: {least:.4?}; far beyond y {far:.4?}");
    assert!(least[2].abs() > 0.3 && (far[1] / far[0] - 1.0).abs() < 0.05);
}
