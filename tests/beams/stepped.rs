//! A stepped shaft as one body: diameters from a table, an element from step to step.

use rncf::equilibrium::Uniform;
use rncf::modes::{self, Wanted};
use rncf::{Formulation, Joints, Model};

use super::blades::{at_rest, near};

/// Ends (m) and diameters (m) of the pieces.
const PIECES: [(f64, f64, f64); 5] = [
    (0.0, 0.3, 0.06),
    (0.3, 0.5, 0.04),
    (0.5, 0.9, 0.08),
    (0.9, 1.0, 0.03),
    (1.0, 1.3, 0.05),
];

rncf::model! {
    /// Steel, 1.3 m, held at one end.
    pub model SteppedShaft {
        param each: count = 1;
        param push = 0 N;
        param torque = 0 N*m;
        table rows {
            x = [0, 300, 300, 500, 500, 900, 900, 1000, 1000, 1300] mm;
            d = [60, 60, 40, 40, 80, 80, 30, 30, 50, 50] mm;
        }
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = rows.d / 2);
        body shaft { spatial; line from [0, 0, 0] m to [1.3, 0, 0] m; mesh each at rows * beam(round, steel); }
        joint root = clamp(shaft.start, inertial);
        load across = force(shaft.end, [0 N, push, 0 N]);
        load turn = moment(shaft.end, [torque, 0 [N*m], 0 [N*m]]);
        output place = shaft.end.y;
        output angle = shaft.end.ey.z;
        output mass = shaft.mass;
    }
}

/// `int ((L - x)^2/E I + 1/k G A) dx` and `int dx/G J`, and nothing is said of a mesh that has its nodes at the steps.
#[test]
fn a_stepped_shaft_is_one_body() {
    let (length, young, shear) = (1.3_f64, 210e9, 210e9 / 2.6);
    let factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    let sums = PIECES.map(|(from, to, d)| {
        let area = std::f64::consts::PI * d * d / 4.0;
        let bending = area * d * d / 16.0;
        let levers = ((length - from).powi(3) - (length - to).powi(3)) / 3.0;
        let bent = levers / (young * bending) + (to - from) / (factor * shear * area);
        [bent, (to - from) / (shear * 2.0 * bending), 7850.0 * area * (to - from)]
    });
    let [bent, turned, mass] = [0, 1, 2].map(|which| sums.iter().map(|sum| sum[which]).sum::<f64>());
    let (push, torque) = (1e-6 / bent, 1e-6 / turned);
    for each in [1, 2] {
        let model = SteppedShaft { each, push, torque };
        let row = at_rest(&model);
        // The slope is one on both sides of a step, where shear strains jump.
        near(&row[..1], &[1e-6], 5e-5);
        near(&row[1..3], &[1e-6, mass], 1e-9);
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let start = scene.rest(0.0);
        let told: Vec<String> = scene.warnings(&start).into_iter().map(|warning| warning.text).collect();
        assert!(told.is_empty(), "{told:?}");
    }
}

rncf::model! {
    /// A bar of two parts, the outer one of a fifth of the stiffness and mass. Its axis lies by `off` below its centre.
    pub model SteppedBar {
        param each: count = 8;
        param off = 300 mm;
        table rows { x = [0, 1, 1, 2] m; part = [1, 1, 0.2, 0.2]; }
        section bar {
            EA = 30 MN * rows.part; GAy = 10 MN * rows.part; GAz = 10 MN * rows.part;
            GJ = 20 [kN*m^2] * rows.part; EIy = 40 [kN*m^2] * rows.part; EIz = 60 [kN*m^2] * rows.part;
            tension_z = off; shear_z = off;
            mass = 12 [kg/m] * rows.part; mass_z = off;
            inertia_y = 0.016 [kg*m] * rows.part; inertia_z = 0.024 [kg*m] * rows.part;
        }
        body spar { spatial; line from [0 m, 0 m, -off] to [2 m, 0 m, -off]; section_y [0, 1, 0]; mesh each at rows * beam(bar); }
        joint root = clamp(spar.start, inertial);
        output place = spar.end.position;
    }
}

/// Frequencies (rad/s) by an independent shooting method for geometrically exact rods. With the axis beside the middle they converge
/// with the first order at a step, whose two sides share one slope; they are as far off as is told.
#[test]
fn a_stepped_bar_is_judged_by_what_its_element_feels() {
    let exact = [95.846_494, 117.080_512, 302.023_098, 366.658_430];
    for off in [0.15, 0.3] {
        for each in [4, 8, 16] {
            let bar = SteppedBar { each, off };
            let mut scene = bar.build(Formulation::Rncf, Joints::Eliminated).unwrap();
            let (at, state) = (Uniform::at_rest(0.0), scene.rest(0.0));
            let found = modes::modes(scene.as_mut(), &at, &state, Wanted { count: 4 }).unwrap();
            let estimates = modes::mesh_errors(scene.as_mut(), &at, &state, &found);
            for ((mode, exact), estimate) in found.iter().zip(exact).zip(estimates) {
                let error = mode.im / exact - 1.0;
                println!(
                    "{off} m, {each} elements: {:.3} rad/s, {error:.2e} off, {:.2e} told",
                    mode.im, estimate[0]
                );
                assert!(estimate[0] < 3e-4 || (0.95..1.05).contains(&(estimate[0] / error)));
                assert!(error.abs() < 1e-4 || estimate[0] > 0.95 * error);
            }
        }
    }
}
