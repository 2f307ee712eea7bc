//! Sections and materials of their own in a loop over a param, against the same ones written out and against closed forms.

use rncf::prelude::*;

use super::{at_rest, run, scene};

/// Three rows of arms, each arm with a section and a material of its own: the same along it, in a table, by its stiffness.
macro_rules! arms {
    ($name:ident, $($head:tt)*) => {
        rncf::model! {
            pub model $name {
                $($head)*
                param force = 1 N;
                table rows { eta = [0, 1]; radius = [12, 6] mm; EI = [90, 40] N*m^2; }
                for i in 0..n {
                    material metal[i] { density = (1 + i) * 2000 [kg/m^3]; young = 70 GPa / (1 + i); poisson = 0.3; damping = i * 1e-5 s; }
                    section block[i] { area = (1 + i) * 1 [cm^2]; second_moment = (2 + i) * 0.1 [cm^4]; extent_y = (2 + i) * 1 cm; extent_z = (2 + i) * 1 cm;
                        torsion_constant = 0.1 cm^4; shear_factor = 0.8; }
                    section cone[i] = circle(radius = (1 + i / 2) * rows.radius);
                    section layup[i] { EA = 4 MN; GAy = 1 MN; GAz = 1 MN; GJ = 90 N*m^2; EIy = (1 + i) * rows.EI; EIz = 300 N*m^2; shear_y = i * 1 mm;
                        mass = 1 [kg/m] * (1 + i); inertia_y = 1e-4 kg*m; inertia_z = 2e-4 kg*m; }
                    body plain[i] { spatial; line from [0 m, i * 1 m, 0 m] to [1 m, i * 1 m, 0 m]; mesh 2 * beam(block[i], metal[i]); }
                    body taper[i] { spatial; line from [0 m, i * 1 m, 1 m] to [1 m, i * 1 m, 1 m]; mesh 4 * beam(cone[i], metal[i]); }
                    body shell[i] { spatial; line from [0 m, i * 1 m, 2 m] to [1 m, i * 1 m, 2 m]; mesh 4 * beam(layup[i]); }
                    joint plain_root[i] = clamp(plain[i].start, inertial);
                    joint taper_root[i] = clamp(taper[i].start, inertial);
                    joint shell_root[i] = clamp(shell[i].start, inertial);
                    load plain_load[i] = distributed(plain[i], [0 [N/m], 0 [N/m], -1 * force / 1 [m]]);
                    load taper_load[i] = distributed(taper[i], [0 [N/m], 0 [N/m], -1 * force / 1 [m]]);
                    load shell_load[i] = distributed(shell[i], [0 [N/m], 0 [N/m], -1 * force / 1 [m]]);
                }
                output plain_0 = plain[0].end.z; output plain_1 = plain[1].end.z; output plain_2 = plain[2].end.z;
                output taper_0 = taper[0].end.z - 1 m; output taper_1 = taper[1].end.z - 1 m; output taper_2 = taper[2].end.z - 1 m;
                output shell_0 = shell[0].end.z - 2 m; output shell_1 = shell[1].end.z - 2 m; output shell_2 = shell[2].end.z - 2 m;
                output stress_1 = plain[1].start.stress; output stress_2 = taper[2].start.stress;
                output moment = shell[2].at(0.5 m).moment_y;
                output mass = total.mass;
            }
        }
    };
}

arms!(OfParam, param n: count = 3;);
arms!(WrittenOut, const n = 3;);

#[test]
fn each_repetition_over_a_param_has_its_own_section_and_material() {
    let found = at_rest(&OfParam::default());
    let wanted = at_rest(&WrittenOut::default());
    for (value, wanted) in found.iter().zip(&wanted) {
        assert!((value - wanted).abs() <= 1e-12 * wanted.abs(), "{found:?} {wanted:?}");
    }
    // q L^4/(8 E I) + q L^2/(2 k G A).
    for (i, &deflection) in found[..3].iter().enumerate() {
        let i = i as f64;
        let young = 70e9 / (1.0 + i);
        let (second, area) = ((2.0 + i) * 1e-9, (1.0 + i) * 1e-4);
        let wanted = 1.0 / (8.0 * young * second) + 1.0 / (2.0 * 0.8 * young / 2.6 * area);
        assert!((-deflection / wanted - 1.0).abs() < 1e-3, "{i}: {deflection} {wanted}");
    }
    // A linear EI(x) = b (1 - c x): int q (1 - x)^3/(2 E I) dx.
    let integral = |value: &dyn Fn(f64) -> f64| {
        (0..2000)
            .map(|at| value((at as f64 + 0.5) / 2000.0) / 2000.0)
            .sum::<f64>()
    };
    for (i, &deflection) in found[6..9].iter().enumerate() {
        let bending = integral(&|x| (1.0 - x).powi(3) / (2.0 * (1.0 + i as f64) * (90.0 - 50.0 * x)));
        let wanted = bending + 1.0 / (2.0 * 1e6);
        assert!((-deflection / wanted - 1.0).abs() < 1e-3, "{i}: {deflection} {wanted}");
    }
}

#[test]
fn sections_of_repetitions_move_and_damp_as_those_written_out() {
    let end = 2e-3;
    let [found, wanted] = [scene(&OfParam::default()), scene(&WrittenOut::default())]
        .map(|mut scene| run(&mut *scene, end, 1e-6, StepSize::Fixed(end / 4.0)));
    for (row, wanted) in found.iter().zip(&wanted) {
        for (value, wanted) in row.iter().zip(wanted) {
            assert!((value - wanted).abs() <= 1e-9 * wanted.abs().max(1e-6), "{row:?}");
        }
    }
    assert_eq!(found.len(), 4);
}

#[test]
fn a_section_that_does_not_exist_is_told_of_a_repetition() {
    rncf::model! {
        pub model Thin {
            param n: count = 3;
            material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
            for i in 0..n {
                section wall[i] = tube(radius = 10 mm, thickness = 4 mm * (1 + i));
                body pipe[i] { spatial; line from [0 m, i * 1 m, 0 m] to [1 m, i * 1 m, 0 m]; mesh 2 * beam(wall[i], steel); }
                joint root[i] = clamp(pipe[i].start, inertial);
            }
            output z = pipe[0].end.z;
        }
    }
    let message = Thin::default()
        .build(Formulation::Rncf, Joints::Eliminated)
        .err()
        .unwrap()
        .message;
    assert!(
        message.contains("section `wall`") && message.contains("inner_radius"),
        "{message}"
    );
    assert!(Thin { n: 2 }.build(Formulation::Rncf, Joints::Eliminated).is_ok());
}
