//! A stepped shaft as one body: diameters from a table, an element from step to step.

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
