//! Elements of the spatial tether one by one and four side by side: nanoseconds of one element.

use std::hint::black_box;

use rncf::emitted::lanes::{self, LANES};
use rncf_models::spin_up_spatial_equations::{
    CableSpatial, CableSpatialElasticForce, CableSpatialElasticTangent, cable_spatial_elastic_force,
    cable_spatial_elastic_tangent,
};

use super::{shape, time};

/// Elements of one evaluation: a tether of the sail.
const ELEMENTS: usize = 16;

struct Data {
    /// Constants of each element: of one body, or of four.
    rows: [CableSpatial; LANES],
    q: [[f64; 12]; ELEMENTS],
}

impl Data {
    fn new() -> Self {
        let q = <[f64; 12]>::try_from(shape(3)[0].clone()).unwrap();
        let row = CableSpatial {
            length: 4.0 / 3.0,
            EA: 5.03e6,
            EI: 566.0,
            rhoA: 0.2,
        };
        Self {
            rows: [row; LANES],
            q: std::array::from_fn(|element| q.map(|x| x + 1e-3 * element as f64)),
        }
    }

    /// One by one; with the tangent or without.
    fn one(&self, with_tangent: bool) -> f64 {
        let mut force = [[0.0; 12]; ELEMENTS];
        let mut stiffness = [[0.0; 144]; ELEMENTS];
        let all = time(|| {
            for element in 0..ELEMENTS {
                let (row, q) = (black_box(&self.rows[element % LANES]), black_box(&self.q[element]));
                let (force, stiffness) = (&mut force[element], &mut stiffness[element]);
                force.fill(0.0);
                cable_spatial_elastic_force(row, q, force);
                if with_tangent {
                    stiffness.fill(0.0);
                    cable_spatial_elastic_tangent(row, q, stiffness);
                }
                black_box((force, stiffness));
            }
        });
        all / ELEMENTS as f64
    }

    /// Four by four, with constants that differ between the lanes or are those of one body.
    fn four(&self, with_tangent: bool, one_body: bool) -> f64 {
        let mut force = [[[0.0; LANES]; 12]; ELEMENTS / LANES];
        let mut stiffness = [[[0.0; LANES]; 144]; ELEMENTS / LANES];
        let q: [[[f64; LANES]; 12]; ELEMENTS / LANES] = std::array::from_fn(|group| {
            std::array::from_fn(|place| std::array::from_fn(|lane| self.q[LANES * group + lane][place]))
        });
        let mut vectors = true;
        let all = time(|| {
            for group in 0..ELEMENTS / LANES {
                let (rows, q) = (black_box(&self.rows), black_box(&q[group]));
                let rows = std::array::from_fn(|lane| &rows[if one_body { 0 } else { lane }]);
                let (force, stiffness) = (&mut force[group], &mut stiffness[group]);
                force.fill([0.0; LANES]);
                vectors &= lanes::run(CableSpatialElasticForce { rows, q, force });
                if with_tangent {
                    stiffness.fill([0.0; LANES]);
                    vectors &= lanes::run(CableSpatialElasticTangent { rows, q, stiffness });
                }
                black_box((force, stiffness));
            }
        });
        // Without vector instructions nothing was evaluated.
        if vectors { all / ELEMENTS as f64 } else { f64::NAN }
    }
}

/// What is evaluated, nanoseconds one by one and of four lanes.
pub fn rows() -> [(&'static str, [f64; 2]); 4] {
    let data = Data::new();
    [
        (
            "force, constants of one body",
            [data.one(false), data.four(false, true)],
        ),
        (
            "force, constants of four bodies",
            [data.one(false), data.four(false, false)],
        ),
        (
            "force and tangent, constants of one body",
            [data.one(true), data.four(true, true)],
        ),
        (
            "force and tangent, constants of four bodies",
            [data.one(true), data.four(true, false)],
        ),
    ]
}
