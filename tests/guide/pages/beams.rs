//! A pipe in a wall: deflection, twist and stress of the textbook, and a spring.

use std::f64::consts::PI;

use rncf::app::charts::Line;
use rncf::app::{EquilibriumSettings, Figure, static_equilibria};
use rncf_guide::beams::Shelf;
use rncf_guide::coil::Example as Coil;
use rncf_guide::drawing::{Drawing, View};

use crate::{at_rest, chart, column, over, says, shows};

/// Second moment of the tube of 20 mm and 2 mm, m^4.
fn second_moment() -> f64 {
    PI / 4.0 * (0.02_f64.powi(4) - 0.018_f64.powi(4))
}

#[test]
fn the_pipe_is_that_of_the_textbook() {
    let shelf = Shelf {
        lever: 0.1,
        ..Shelf::default()
    };
    let found = static_equilibria(&shelf, &EquilibriumSettings::default()).unwrap();
    let last = |name: &str| *column(&found.history, name).last().unwrap();
    // Its outputs are in mm, deg and MPa.
    let (sag, turn, stress) = (1e-3 * last("sag"), last("turn").to_radians(), 1e6 * last("stress"));
    let (force, young) = (200.0, 210e9);
    let bending = force / (3.0 * young * second_moment());
    let shear_modulus = young / 2.6;
    let twist = force * 0.1 / (shear_modulus * 2.0 * second_moment());
    // Of bending alone; torsion adds its shear stress, F lever r/J.
    let normal = force * 0.02 / second_moment();
    let shear = force * 0.1 * 0.02 / (2.0 * second_moment());
    let mises = (normal * normal + 3.0 * shear * shear).sqrt();
    assert!((-sag / bending - 1.0).abs() < 3e-3, "{sag} m, {bending} m");
    assert!((turn / -twist - 1.0).abs() < 1e-3, "{turn} {twist}");
    assert!((stress / mises - 1.0).abs() < 0.02, "{stress} Pa, {mises} Pa");
    says("beams", &format!("{:.3} mm", -1e3 * sag));
    says("beams", &format!("= {:.3} mm for bending", 1e3 * bending));
    says("beams", &format!("turns by {:.3} deg", twist.to_degrees()));
    says("beams", &format!("{:.1} MPa", stress / 1e6));
    says("beams", &format!("{:.1} MPa of the formula", mises / 1e6));
    let far = static_equilibria(&shelf, &over(&shelf, "load", 0.0, 4000.0, 40)).unwrap();
    let mut figure = Figure::default();
    let sag = Line::new(
        far.history
            .keys
            .iter()
            .copied()
            .zip(column(&far.history, "sag").iter().map(|z| -z)),
        0,
    );
    let straight = Line::new([(0.0, 0.0), (4000.0, 4000.0 * bending / force * 1e3)], 5).dashed();
    figure.add(
        "How far the end hangs down, and F L^3/(3 EI)",
        &["pipe"],
        chart("load [N]", "-sag [mm]", vec![sag, straight]),
    );
    let shots = at_rest(&shelf);
    let drawing = Drawing {
        magnified: 20.0,
        arrow: 0.15,
        ..Drawing::new(
            &shots,
            View::XZ,
            vec![shots.count() - 1],
            "The pipe without load (grey), and under 200 N, its deflection 20 times as large",
        )
    };
    shows(
        "beams",
        Some(&drawing),
        &figure,
        "A pipe in a wall, and its deflection over the load",
    );
}

/// The axis of the spring is as long as three turns are.
#[test]
fn the_spring_has_the_length_of_its_turns() {
    use rncf::Model;
    let coil = Coil::default();
    let scene = coil.build(rncf::Formulation::Rncf, rncf::Joints::Eliminated).unwrap();
    let bodies = scene.section_bodies();
    let length = 3.0 * (2.0 * PI * 0.02).hypot(0.008);
    assert!(
        (bodies[0].length / length - 1.0).abs() < 1e-6,
        "{} m, {length} m",
        bodies[0].length
    );
}
