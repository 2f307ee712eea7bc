//! Compiled elastic kernels against the element written by hand from THEORY 5.1.

use rncf_models::{spin_up_equations as planar, spin_up_spatial_equations as spatial};
use rncf_reference::element::{Data, ElasticForce, GaussElement, Weights};

use crate::jacobians::Random;
use crate::models::{curved_damped_equations as curved, curved_exact_equations as curved_exact};
use crate::models::{spatial_exact_equations as exact, spatial_tensor_equations as tensor};

const LENGTH: f64 = 0.7;

fn data(dimension: usize, exponent: u32, points: usize, damping: f64) -> Data {
    Data {
        dimension,
        length: LENGTH,
        mass_per_length: 0.44,
        axial_stiffness: 4000.0,
        bending_stiffness: 130.0,
        exponent,
        damping,
        points,
    }
}

/// Nodal vectors near a straight element, and rates.
fn state<const N: usize>(random: &mut Random) -> [[f64; N]; 2] {
    let dimension = N / 4;
    let straight = |place: usize| match (place / dimension, place % dimension) {
        (2, 0) => LENGTH,
        (1 | 3, 0) => 1.0,
        _ => 0.0,
    };
    [
        std::array::from_fn(|place| straight(place) + 0.3 * random.next()),
        std::array::from_fn(|_| random.next()),
    ]
}

fn assert_equal(what: &str, compiled: &[f64], by_hand: &[f64]) {
    let scale = by_hand.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    assert!(scale > 0.0, "{what}: the reference is zero");
    for (place, (a, b)) in compiled.iter().zip(by_hand).enumerate() {
        assert!(
            (a - b).abs() <= 1e-12 * scale,
            "{what}: entry {place} is {a}, by hand {b}"
        );
    }
}

/// Force and tangents of `$kernels` against `$element`.
macro_rules! compare {
    ($what:literal, $element:expr, $q:ident, $v:ident, $size:literal, $force:expr, $tangent:expr) => {{
        let element = $element.unwrap();
        let (mut force, mut stiffness, mut damping) = ([0.0; $size], [0.0; $size * $size], [0.0; $size * $size]);
        #[allow(clippy::redundant_closure_call)]
        {
            $force(&mut force);
            $tangent(&mut stiffness, &mut damping);
        }
        for (weights, compiled) in [(Weights::POSITION, &stiffness), (Weights::VELOCITY, &damping)] {
            let (mut by_hand, mut tangent) = (vec![0.0; $size], vec![0.0; $size * $size]);
            element.add_force_and_tangent(&$q, &$v, weights, &mut by_hand, &mut tangent);
            assert_equal(concat!($what, ", force"), &force, &by_hand);
            if tangent.iter().any(|&value| value != 0.0) {
                assert_equal(concat!($what, ", tangent"), compiled, &tangent);
            }
        }
    }};
}

#[test]
fn straight_planar() {
    let row = planar::CablePlanar {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
    };
    let mut random = Random(1);
    for _ in 0..20 {
        let [q, v] = state::<8>(&mut random);
        compare!(
            "planar",
            GaussElement::straight(data(2, 0, 5, 0.0)),
            q,
            v,
            8,
            |f: &mut _| planar::cable_planar_elastic_force(&row, &q, f),
            |k: &mut _, _: &mut _| planar::cable_planar_elastic_tangent(&row, &q, k)
        );
    }
}

#[test]
fn straight_spatial() {
    let row = spatial::CableSpatial {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
    };
    let mut random = Random(2);
    for _ in 0..20 {
        let [q, v] = state::<12>(&mut random);
        compare!(
            "spatial",
            GaussElement::straight(data(3, 0, 5, 0.0)),
            q,
            v,
            12,
            |f: &mut _| spatial::cable_spatial_elastic_force(&row, &q, f),
            |k: &mut _, _: &mut _| spatial::cable_spatial_elastic_tangent(&row, &q, k)
        );
    }
}

#[test]
fn spatial_exact_and_reduced() {
    let row = exact::CableSpatialExactGauss3Damped {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
        damping: 2e-3,
    };
    let other = tensor::CableSpatialGauss3TensorDamped {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
        damping: 2e-3,
    };
    let mut random = Random(3);
    for _ in 0..20 {
        let [q, v] = state::<12>(&mut random);
        compare!(
            "spatial, exact bending",
            GaussElement::straight(data(3, 2, 3, 2e-3)),
            q,
            v,
            12,
            |f: &mut _| exact::cable_spatial_exact_gauss3_damped_elastic_force(&row, &q, &v, f),
            |k: &mut _, c: &mut _| exact::cable_spatial_exact_gauss3_damped_elastic_tangent(&row, &q, &v, k, c)
        );
        compare!(
            "spatial, tensor of three points",
            GaussElement::straight(data(3, 0, 3, 2e-3)),
            q,
            v,
            12,
            |f: &mut _| tensor::cable_spatial_gauss3_tensor_damped_elastic_force(&other, &q, &v, f),
            |k: &mut _, c: &mut _| tensor::cable_spatial_gauss3_tensor_damped_elastic_tangent(&other, &q, &v, k, c)
        );
    }
}

#[test]
fn curved_and_damped() {
    let row = curved::CablePlanarCurvedDamped {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
        damping: 2e-3,
    };
    let exact_row = curved_exact::CablePlanarExactCurvedDamped {
        length: LENGTH,
        EA: 4000.0,
        EI: 130.0,
        rhoA: 0.44,
        damping: 2e-3,
    };
    let mut random = Random(4);
    for _ in 0..20 {
        let [shape, _] = state::<8>(&mut random);
        let [q, v] = state::<8>(&mut random);
        let (mut reference, mut exact_reference) = ([0.0; 9], [0.0; 10]);
        curved::cable_planar_curved_damped_reference(&row, &shape, &mut reference);
        curved_exact::cable_planar_exact_curved_damped_reference(&exact_row, &shape, &mut exact_reference);
        compare!(
            "curved",
            GaussElement::curved(data(2, 0, 5, 2e-3), &shape),
            q,
            v,
            8,
            |f: &mut _| curved::cable_planar_curved_damped_elastic_force(&row, &reference, &q, &v, f),
            |k: &mut _, c: &mut _| curved::cable_planar_curved_damped_elastic_tangent(&row, &reference, &q, &v, k, c)
        );
        compare!(
            "curved, exact bending",
            GaussElement::curved(data(2, 2, 5, 2e-3), &shape),
            q,
            v,
            8,
            |f: &mut _| curved_exact::cable_planar_exact_curved_damped_elastic_force(
                &exact_row,
                &exact_reference,
                &q,
                &v,
                f
            ),
            |k: &mut _, c: &mut _| {
                curved_exact::cable_planar_exact_curved_damped_elastic_tangent(
                    &exact_row,
                    &exact_reference,
                    &q,
                    &v,
                    k,
                    c,
                );
            }
        );
    }
}
