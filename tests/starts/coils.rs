//! Bodies that start bent by more than half a turn: their sections are carried along the shape.

use rncf::app::{RunSettings, run};

rncf::model! {
    /// A straight rod in space and one in a plane that start as arcs of a circle, and one that starts as a coil.
    pub model Coiled {
        param turns = 1;
        const length = 1 m;
        let radius = length / (2 * pi * turns);
        const rise = 0.3;
        let around = radius * (1 - rise^2) ^ (1/2);
        material spring { density = 1000 kg/m^3; young = 100 GPa; poisson = 0.3; }
        section wire = circle(radius = 1 mm);
        body arc {
            spatial; line from [0, 0, 0] m to [length, 0 m, 0 m]; mesh 24 * beam(wire, spring);
            initial position [radius * sin(x / radius), radius * (1 - cos(x / radius)), 0 m];
        }
        body flat {
            planar zx; line from [0, 0, 0] m to [length, 0 m, 0 m]; mesh 24 * beam(wire, spring);
            initial position [radius * sin(x / radius), 0 m, radius * (1 - cos(x / radius))];
        }
        body coil {
            spatial; line from [0, 0, 0] m to [length, 0 m, 0 m]; mesh 48 * beam(wire, spring);
            initial position [around * sin(x / radius), around * (1 - cos(x / radius)), rise * x];
        }
        joint arc_root = clamp(arc.start, inertial);
        joint flat_root = clamp(flat.start, inertial);
        joint coil_root = pin(coil.start, inertial);
        output in_space = arc.strain_energy;
        output in_a_plane = flat.strain_energy;
        output of_coil = coil.strain_energy;
        output torque = coil.at(0.7 m).torque;
        output bending: N*m = (coil.at(0.7 m).moment_y^2 + coil.at(0.7 m).moment_z^2)^(1/2);
        run { t_end = 1e-3 us; every = 1e-3 us; }
    }
}

/// The energy of bending alone, `E I curvature^2 L / 2`: the smallest rotation from the line turned the section over where the shape stands opposite to it, and
/// a coil was twisted.
#[test]
fn sections_follow_shapes_of_more_than_half_a_turn() {
    let stiffness = 100e9 * std::f64::consts::PI * 1e-12 / 4.0;
    for turns in [0.5, 1.0, 1.6] {
        let found = run(&Coiled { turns }, &RunSettings::default()).unwrap();
        let first = |column: usize| found.history.column(column).next().unwrap();
        let curvature = std::f64::consts::TAU * turns;
        let energy = 0.5 * stiffness * curvature.powi(2);
        for column in [0, 1] {
            assert!(
                (first(column) / energy - 1.0).abs() < 1e-3,
                "{turns}: {} for {energy}",
                first(column)
            );
        }
        // The curvature of a helix, without its torsion: sections that are carried along do not turn about the axis.
        let curvature = curvature * (1.0f64 - 0.09).sqrt();
        let energy = 0.5 * stiffness * curvature.powi(2);
        println!("{turns}: {:?} {energy}", [2, 3, 4].map(first));
        assert!(
            (first(2) / energy - 1.0).abs() < 2e-3,
            "{turns}: {} for {energy}",
            first(2)
        );
        assert!(
            first(3).abs() < 1e-3 * first(4),
            "{turns}: a torque of {} beside {}",
            first(3),
            first(4)
        );
    }
}
