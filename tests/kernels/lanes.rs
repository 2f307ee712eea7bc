//! Four elements side by side have the same bits as one by one, in every form of the kernels, with the vector
//! instructions of the processor and without.

use rncf::emitted::lanes::{self, LANES};
use rncf::emitted::{Parts, elastic_force_one_by_one, elastic_tangent_one_by_one};
use rncf_models::spin_up_spatial_equations::{
    CableSpatial, CableSpatialElasticForce, CableSpatialElasticTangent, cable_spatial_elastic_force,
    cable_spatial_elastic_tangent,
};
use rncf_models::{SpinUp, spin_up_equations as planar};
use rncf_models::{SpinUpSpatial, spin_up_spatial_equations as spatial};

use crate::jacobians::Random;
use crate::models::{CurvedDamped, curved_damped_equations as curved};
use crate::models::{CurvedExact, curved_exact_equations as curved_exact};
use crate::models::{SpatialExact, spatial_exact_equations as exact};
use crate::models::{SpatialTensor, spatial_tensor_equations as tensor};

const LENGTH: f64 = 0.7;

/// Components of an element near a straight one.
fn shape(size: usize, random: &mut Random) -> Vec<f64> {
    let dimension = size / 4;
    let straight = |place: usize| match (place / dimension, place % dimension) {
        (2, 0) => LENGTH,
        (1 | 3, 0) => 1.0,
        _ => 0.0,
    };
    (0..size).map(|place| straight(place) + 0.3 * random.next()).collect()
}

fn lanes_of(values: &[Vec<f64>]) -> Vec<[f64; LANES]> {
    let size = values[0].len();
    (0..size)
        .map(|place| std::array::from_fn(|lane| values[lane][place]))
        .collect()
}

fn assert_same_bits(what: &str, four: &[[f64; LANES]], lane: usize, one: &[f64]) {
    for (place, (four, one)) in four.iter().zip(one).enumerate() {
        let four = four[lane];
        assert!(
            four.to_bits() == one.to_bits(),
            "{what}: entry {place} of lane {lane} is {four}, of one element {one}"
        );
    }
}

/// Compares the functions of four elements with those of one, for the body of a model.
fn compare(what: &str, mut parts: impl Parts, size: usize, damped: bool) {
    let mut random = Random(5);
    let undeformed: Vec<f64> = (0..3).flat_map(|_| shape(size, &mut random)).collect();
    parts
        .prepare(0, &[0.0, LENGTH, 2.0 * LENGTH, 3.0 * LENGTH], &undeformed)
        .unwrap();
    let elements = [(0, 2), (0, 0), (0, 1), (0, 2)];
    for _ in 0..20 {
        let q: Vec<Vec<f64>> = elements.iter().map(|_| shape(size, &mut random)).collect();
        let v: Vec<Vec<f64>> = elements.iter().map(|_| shape(size, &mut random)).collect();
        let (q4, v4) = (lanes_of(&q), lanes_of(&v));
        let zeros = [0.0; LANES];
        let (mut force, mut plain_force) = (vec![zeros; size], vec![zeros; size]);
        parts.elastic_force4(&elements, &q4, &v4, &mut force);
        elastic_force_one_by_one(&parts, &elements, &q4, &v4, &mut plain_force);
        let matrix = vec![zeros; size * size];
        let [mut stiffness, mut damping, mut plain_stiffness, mut plain_damping] = [(); 4].map(|()| matrix.clone());
        parts.elastic_tangent4(&elements, &q4, &v4, &mut stiffness, &mut damping);
        elastic_tangent_one_by_one(&parts, &elements, &q4, &v4, &mut plain_stiffness, &mut plain_damping);
        for (lane, &(body, element)) in elements.iter().enumerate() {
            let (mut one, mut k, mut c) = (vec![0.0; size], vec![0.0; size * size], vec![0.0; size * size]);
            parts.elastic_force(body, element, &q[lane], &v[lane], &mut one);
            parts.elastic_tangent(body, element, &q[lane], &v[lane], &mut k, &mut c);
            assert!(
                one.iter().chain(&k).any(|value| value.abs() > 1.0),
                "{what}: nothing was added"
            );
            assert_eq!(c.iter().any(|&value| value != 0.0), damped, "{what}: damping");
            for (four, plain, one) in [
                (&force, &plain_force, &one),
                (&stiffness, &plain_stiffness, &k),
                (&damping, &plain_damping, &c),
            ] {
                assert_same_bits(what, four, lane, one);
                assert_same_bits(what, plain, lane, one);
            }
        }
    }
}

#[test]
fn lanes_have_the_bits_of_one_element_in_every_form() {
    compare("planar", planar::Equations::new(&SpinUp::default()), 8, false);
    compare("spatial", spatial::Equations::new(&SpinUpSpatial::default()), 12, false);
    compare("curved", curved::Equations::new(&CurvedDamped::default()), 8, true);
    compare(
        "curved, exact",
        curved_exact::Equations::new(&CurvedExact::default()),
        8,
        true,
    );
    compare("loop", exact::Equations::new(&SpatialExact::default()), 12, true);
    compare("tensor", tensor::Equations::new(&SpatialTensor::default()), 12, true);
}

/// Constants and results of one lane do not reach another one.
#[test]
fn lanes_have_constants_of_their_own() {
    let mut random = Random(7);
    let rows: [CableSpatial; LANES] = std::array::from_fn(|_| CableSpatial {
        length: LENGTH + 0.1 * random.next(),
        EA: 4000.0 + 100.0 * random.next(),
        EI: 130.0 + 10.0 * random.next(),
        rhoA: 0.44,
    });
    let q: [[f64; 12]; LANES] = std::array::from_fn(|_| *rncf::emitted::array(&shape(12, &mut random)));
    let q4 = std::array::from_fn(|place| std::array::from_fn(|lane| q[lane][place]));
    let (mut force, mut stiffness) = ([[0.5; LANES]; 12], [[0.25; LANES]; 144]);
    let rows_of = rows.each_ref();
    let vectors = lanes::run(CableSpatialElasticForce {
        rows: rows_of,
        q: &q4,
        force: &mut force,
    });
    #[cfg(target_arch = "x86_64")]
    assert_eq!(
        vectors,
        std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma")
    );
    if !vectors {
        assert_eq!(
            force, [[0.5; LANES]; 12],
            "nothing is evaluated without vector instructions"
        );
        return;
    }
    lanes::run(CableSpatialElasticTangent {
        rows: rows_of,
        q: &q4,
        stiffness: &mut stiffness,
    });
    for lane in 0..LANES {
        let (mut one, mut matrix) = ([0.5; 12], [0.25; 144]);
        cable_spatial_elastic_force(&rows[lane], &q[lane], &mut one);
        cable_spatial_elastic_tangent(&rows[lane], &q[lane], &mut matrix);
        assert_same_bits("force", &force, lane, &one);
        assert_same_bits("stiffness", &stiffness, lane, &matrix);
    }
}
