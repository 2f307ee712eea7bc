//! The motions: their derivatives, and the join at the end of the run-up.

use crate::differences::jacobian;
use rncf_reference::spin_up::{Motion, SpinUp};
use rncf_reference::swing::Swing;

/// Rate and acceleration against differences.
fn check(motion: &impl Motion, times: &[f64]) {
    for &t in times {
        let rates = jacobian(|t| vec![motion.at(t[0]).angle, motion.at(t[0]).rate], &[t], 1e-2).concat();
        let at = motion.at(t);
        assert!(
            (rates[0] - at.rate).abs() < 1e-10 && (rates[1] - at.acceleration).abs() < 1e-10,
            "t = {t}"
        );
    }
}

#[test]
fn derivatives_are_derivatives() {
    check(&SpinUp::new(4.0, 15.0).unwrap(), &[0.5, 3.0, 11.0, 14.5, 16.0]);
    check(&Swing::new(1.5, 0.05, 1.1).unwrap(), &[0.5, 3.0, 11.0]);
}

#[test]
fn joins_the_constant_spin() {
    let motion = SpinUp::new(4.0, 15.0).unwrap();
    let (before, after) = (motion.at(15.0), motion.at(15.0 + 1e-9));
    assert!((before.angle - 30.0).abs() < 1e-13 && (after.angle - 30.0).abs() < 1e-8);
    assert!((before.rate - 4.0).abs() < 1e-14 && after.rate == 4.0);
    assert!(before.acceleration.abs() < 1e-14 && after.acceleration == 0.0);
    assert!(motion.at(0.0).angle == 0.0 && motion.at(0.0).rate == 0.0 && motion.at(0.0).acceleration == 0.0);
    assert!(SpinUp::new(4.0, 0.0).unwrap_err().contains("duration"));
}
