//! The motor of THEORY 9.3 by hand: shaft with a disc at its middle node, clamped and pinned.

use crate::section_beam::{Properties, Section};
use crate::section_chain::{Chain, Hold, Slot, Supports, clamp, straight};
use crate::section_statics::Problem;
use std::f64::consts::PI;

/// One revolution per minute, rad/s.
const RPM: f64 = PI / 30.0;

/// The motor of `elements` elements that turns with `rpm`, its disc `offset` off the axis (m), strains damped with
/// c = 1e-6 s; `gradient_points` Gauss points for the section's gradients (THEORY's values were made with 3).
pub fn motor(elements: usize, offset: f64, rpm: f64, gradient_points: usize) -> Problem {
    let section = Section::circle(0.05, 210e9, 0.3, 7800.0);
    let properties = Properties {
        gradient_points,
        damping: 1e-6,
        ..Properties::structural(3, 1.02, &section)
    };
    let mut chain = Chain::along(properties, elements, straight).unwrap();
    let (mass, radius, thickness) = (7800.0 * PI * 0.01 * 0.01, 0.1_f64, 0.01_f64);
    let across = 0.25 * mass * radius * radius;
    let second = [mass * thickness.powi(2) / 12.0, across + mass * offset * offset, across];
    chain.attach(elements / 2, mass, [0.0, offset, 0.0], second);
    let mut held = clamp(&chain, Hold::Direction);
    held.push((chain.vector(elements, Slot::Position), Hold::Fixed));
    Problem {
        supports: Supports::new(&chain, &held),
        chain,
        loads: vec![],
        spin: [rpm * RPM, 0.0, 0.0],
    }
}

/// Its relative equilibria with the disc 50 mm off the axis at ascending speeds (rpm), reached in steps of 500 rpm.
pub fn equilibria(elements: usize, speeds: &[f64], gradient_points: usize) -> Vec<(Problem, Vec<f64>)> {
    let at = |rpm: f64| motor(elements, 0.05, rpm, gradient_points);
    let mut q = at(0.0).chain.stress_free().to_vec();
    let (mut rpm, mut found) = (0.0, Vec::new());
    for &speed in speeds {
        while rpm < speed {
            rpm += 500.0;
            at(rpm).newton(1.0, &mut q).unwrap();
        }
        found.push((at(rpm), q.clone()));
    }
    found
}
