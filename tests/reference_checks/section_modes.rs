//! The motor of THEORY 9.3, critical and above, and the rotor on a hub with ten-vector elements.

use rncf_reference::galerkin_rotor::Rotor;
use rncf_reference::motor::{equilibria, motor};
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Slot, Supports, straight};
use rncf_reference::section_modes::Damping;
use rncf_reference::section_statics::Problem;
use std::f64::consts::PI;

const RPM: f64 = PI / 30.0;

#[test]
fn motor_bends_as_published() {
    // THEORY 9.3: mid-shaft v in mm for 4, 8, 16 elements.
    const TABLE: [(f64, [f64; 3]); 4] = [
        (7500.0, [0.91332, 0.91440, 0.91495]),
        (10000.0, [1.96891, 1.97115, 1.97222]),
        (15000.0, [10.6882, 10.7091, 10.7138]),
        (20000.0, [46.0136, 46.0640, 46.0751]),
    ];
    for (column, elements) in [4, 8, 16].into_iter().enumerate() {
        let states = equilibria(elements, &TABLE.map(|row| row.0), 3);
        for ((problem, q), (rpm, row)) in states.iter().zip(TABLE) {
            let v = 1e3
                * problem
                    .chain
                    .read(q, problem.chain.vector(elements / 2, Slot::Position))[1];
            let half_digit = if rpm < 12000.0 { 5.1e-6 } else { 5.1e-5 };
            assert!(
                (v - row[column]).abs() < half_digit,
                "{rpm} rpm, {elements} elements: {v}"
            );
        }
    }
}

#[test]
fn motor_frequencies_and_decay() {
    // THEORY 9.3: lowest frequency (rad/s) and largest real part with damping c K_T; the real part with the measures'
    // own damping (4 elements), which differs where the shaft is stressed.
    const TABLE: [(f64, f64, f64, f64); 6] = [
        (10000.0, 761.0, -0.69, -0.684),
        (12500.0, 506.0, -0.46, -0.455),
        (15000.0, 282.0, -0.26, -0.254),
        (16000.0, 230.0, -0.22, -0.210),
        // THEORY has 214, by an energy that depends on where the section's y axis points.
        (17500.0, 214.5, -0.25, -0.216),
        (20000.0, 235.0, -0.41, -0.288),
    ];
    let states = equilibria(4, &TABLE.map(|row| row.0), 3);
    for ((problem, q), (rpm, frequency, stiffness, measures)) in states.iter().zip(TABLE) {
        let lowest = problem.frequencies(q).unwrap()[0];
        assert!((lowest - frequency).abs() < 0.51, "{rpm} rpm: {lowest} rad/s");
        for (damping, expected, digit) in [
            (Damping::Stiffness(1e-6), stiffness, 5.1e-3),
            (Damping::Measures, measures, 5.1e-4),
        ] {
            let s = problem.eigenvalue_near(q, damping, [0.0, lowest]).unwrap();
            println!("{rpm} rpm, {damping:?}: {s:?}");
            assert!(
                (s[0] - expected).abs() < digit && (s[1] - lowest).abs() < 1e-2,
                "{rpm} rpm: {s:?}"
            );
        }
    }
}

#[test]
fn balanced_shaft_is_unstable_above_its_critical_speed() {
    for (elements, expected) in [(4, 17246.0), (8, 17238.0)] {
        let critical = motor(elements, 0.0, 1.0, 3).critical_speeds().unwrap()[0] / RPM;
        assert!(
            (critical - expected).abs() < 0.51,
            "{elements} elements: {critical} rpm"
        );
    }
    // THEORY 9.3, about the turning straight shaft with damping c K_T; 8 elements.
    for (rpm, expected) in [(15000.0, -0.22), (17500.0, 0.020), (20000.0, 0.26), (25000.0, 0.73)] {
        let problem = motor(8, 0.0, rpm, 3);
        let mut q = problem.chain.stress_free().to_vec();
        problem.newton(1.0, &mut q).unwrap();
        let guess = [0.0, (17238.0 - rpm) * RPM];
        let [stiffness, measures] = [Damping::Stiffness(1e-6), Damping::Measures]
            .map(|damping| problem.eigenvalue_near(&q, damping, guess).unwrap());
        println!("balanced, {rpm} rpm: {stiffness:?}, {measures:?}");
        let digit = if rpm == 17500.0 { 5.1e-4 } else { 5.1e-3 };
        assert!((stiffness[0] - expected).abs() < digit, "{rpm} rpm: {stiffness:?}");
        assert!(measures[0] * expected > 0.0, "the sign is that of both laws");
    }
}

/// A blade of unit length, `rho A = EI = 1`, that begins at the hub's radius and turns about z.
fn blade(dimension: usize, elements: usize, eta: f64, hub: f64) -> Problem {
    // r/L = 2e-3: EI / (EA L^2) is 1e-6.
    let radius = 2e-3_f64;
    let area = PI * radius * radius;
    let section = Section::circle(radius, 4.0 / (area * radius * radius), 0.3, 1.0 / area);
    let shape = |x: f64| {
        let mut shape = straight(x);
        shape[0][0] += hub;
        shape
    };
    let chain = Chain::along(Properties::structural(dimension, 1.0, &section), elements, shape).unwrap();
    Problem {
        supports: Supports::clamp(&chain, Hold::Direction),
        chain,
        loads: vec![],
        spin: [0.0, 0.0, eta],
    }
}

#[test]
fn blade_on_a_hub_agrees_with_galerkin() {
    for (eta, hub) in [(2.0, 0.5), (6.0, 1.0), (12.0, 2.0)] {
        let rotor = Rotor { eta, hub, terms: 22 };
        for (dimension, expected) in [(3, rotor.flap().unwrap()[0]), (2, rotor.lag().unwrap()[0])] {
            let problem = blade(dimension, 6, eta, hub);
            let q = problem.solve(2).unwrap();
            let s = problem.eigenvalue_near(&q, Damping::Measures, [0.0, expected]).unwrap();
            let error = s[1] / expected - 1.0;
            println!(
                "eta {eta}, hub {hub}, dimension {dimension}: {} {expected} {error:.1e}",
                s[1]
            );
            assert!(error.abs() < 2e-3 && s[0].abs() < 1e-6 * s[1]);
        }
    }
}
