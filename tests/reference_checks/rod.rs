//! The geometrically exact rod against THEORY 9.7.

use rncf_reference::rod::{Rod, Tip};
use std::f64::consts::PI;

/// Inextensible, rigid in shear, unit length and bending stiffness.
const ELASTICA: Rod = Rod {
    length: 1.0,
    force_compliance: [0.0; 3],
    moment_compliance: [1.0; 3],
    curvature: [0.0; 3],
    steps: 400,
};

fn close(actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() < tolerance, "{actual} instead of {expected}");
}

/// Angle of the tip's tangent in the x-y plane.
fn slope(tip: &Tip) -> f64 {
    tip.axes[0][1].atan2(tip.axes[0][0])
}

#[test]
fn elastica_under_a_dead_force() {
    // THEORY 9.7: load P L^2 / EI, axial shortening, deflection, slope.
    const TABLE: [[f64; 4]; 7] = [
        [0.2, 0.002646548341, 0.06636448214, 0.09963616304],
        [0.6, 0.02248766798, 0.1923502797, 0.2907377668],
        [1.0, 0.05643323628, 0.3017207738, 0.4613519497],
        [2.0, 0.1606417208, 0.4934574804, 0.7817498316],
        [4.0, 0.3289412422, 0.6699641813, 1.121239347],
        [6.0, 0.4345888287, 0.7445711489, 1.283697286],
        [10.0, 0.5549955978, 0.8106090249, 1.430285539],
    ];
    for [load, u, w, angle] in TABLE {
        let tip = ELASTICA.tip([0.0, load, 0.0], [0.0; 3], 5).unwrap();
        // Half a unit of the table's last digit, and what 400 steps leave.
        close(1.0 - tip.position[0], u, 1e-10);
        close(tip.position[1], w, 1e-10);
        close(slope(&tip), angle, 6e-10);
        // The same in the other plane of bending.
        let other = ELASTICA.tip([0.0, 0.0, load], [0.0; 3], 5).unwrap();
        close(other.position[2], w, 1e-10);
    }
}

#[test]
fn end_moment_closes_the_circle() {
    for part in [0.1, 0.25, 0.5, 1.0] {
        let t = 2.0 * PI * part;
        let tip = ELASTICA.tip([0.0; 3], [0.0, 0.0, t], 4).unwrap();
        close(tip.position[0], t.sin() / t, 1e-10);
        close(tip.position[1], (1.0 - t.cos()) / t, 1e-10);
    }
}

#[test]
fn princeton_beam() {
    let (young, width, thickness, poisson) = (71.7e9, 0.0123777_f64, 0.0032024_f64, 0.31);
    let (area, shear) = (width * thickness, 0.5 * young / (1.0 + poisson));
    let soft = young * width * thickness.powi(3) / 12.0;
    let stiff = young * thickness * width.powi(3) / 12.0;
    close(soft, 2.428872, 5e-7);
    close(stiff, 36.2855, 5e-5);
    let across = 1.2 / (shear * area);
    let rod = Rod {
        length: 0.508,
        force_compliance: [1.0 / (young * area), across, across],
        moment_compliance: [1.0 / 3.103548, 1.0 / soft, 1.0 / stiff],
        curvature: [0.0; 3],
        steps: 200,
    };
    // THEORY 9.7: displacement of the tip at 8.896 N, angle of the load in degrees.
    let table = [
        (30.0_f64, [-7.659933e-3_f64, 1.014554e-2, 7.945169e-2]),
        (60.0, [-2.047109e-2, 6.653287e-3, 1.299171e-1]),
    ];
    for (degrees, expected) in table {
        let (s, c) = degrees.to_radians().sin_cos();
        let tip = rod.tip([0.0, 8.896 * c, 8.896 * s], [0.0; 3], 3).unwrap();
        for k in 0..3 {
            let start = if k == 0 { 0.508 } else { 0.0 };
            // Half of the seventh digit.
            let digit = 10.0_f64.powf(expected[k].abs().log10().floor() - 6.0);
            close(tip.position[k] - start, expected[k], 0.51 * digit);
        }
    }
}

#[test]
fn bend_of_45_degrees() {
    let (young, shear) = (1e7, 5e6);
    let bend = |torsion: f64, shear_factor: f64| Rod {
        length: 25.0 * PI,
        force_compliance: [1.0 / young, 1.0 / (shear_factor * shear), 1.0 / (shear_factor * shear)],
        moment_compliance: [1.0 / (shear * torsion), 12.0 / young, 12.0 / young],
        curvature: [0.0, 0.0, 0.01],
        steps: 400,
    };
    let unloaded = bend(0.140577, 5.0 / 6.0).tip([0.0; 3], [0.0; 3], 1).unwrap();
    close(unloaded.position[0], 70.7107, 5e-5);
    close(unloaded.position[1], 29.2893, 5e-5);
    // THEORY 9.7, and the usual other section constants.
    let table = [
        (0.140577, 5.0 / 6.0, [46.89159, 15.55768, 53.60799], 6e-6),
        (1.0 / 6.0, 1.0, [47.150, 15.685, 53.475], 6e-4),
    ];
    for (torsion, shear_factor, expected, tolerance) in table {
        let tip = bend(torsion, shear_factor).tip([0.0, 0.0, 600.0], [0.0; 3], 6).unwrap();
        for k in 0..3 {
            close(tip.position[k], expected[k], tolerance);
        }
    }
}

#[test]
fn too_large_a_step_is_refused() {
    let error = ELASTICA.tip([0.0, f64::NAN, 0.0], [0.0; 3], 1).unwrap_err();
    assert!(error.contains("load step 1 of 1"), "{error}");
}
