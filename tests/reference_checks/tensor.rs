//! The constant tensors: symmetries, closed forms, and the same forces as the Gauss points.

use crate::differences::{Random, relative};
use crate::element::{bent, data, errors, force};
use rncf_reference::element::{Data, ElasticForce, GaussElement};
use rncf_reference::tensor::TensorElement;

#[test]
fn same_energy_force_and_derivatives_as_gauss_points() {
    let mut random = Random(11);
    for dimension in [2, 3] {
        // Damping of the planar curvature is the Gauss form's alone.
        let gauss = GaussElement::straight(Data {
            damping: 0.0,
            ..data(dimension, 0)
        })
        .unwrap();
        let undamped = TensorElement::straight(Data {
            damping: 0.0,
            ..data(dimension, 0)
        })
        .unwrap();
        let q = bent(dimension, &mut random);
        let qd = random.list(4 * dimension, 1.0);
        assert!((undamped.energy(&q) / gauss.energy(&q) - 1.0).abs() < 1e-13);
        let difference = relative(&force(&undamped, &q, &qd), &force(&gauss, &q, &qd));
        println!("dimension {dimension}: tensor and Gauss forces differ by {difference:.1e}");
        assert!(difference < 1e-13);
        let damped = TensorElement::straight(data(dimension, 0)).unwrap();
        let found = errors(&damped, &q, &qd);
        assert!(found.iter().all(|error| *error < 1e-9), "{dimension}: {found:?}");
    }
    let (damped, gauss) = (
        TensorElement::straight(data(3, 0)).unwrap(),
        GaussElement::straight(data(3, 0)).unwrap(),
    );
    let (q, qd) = (bent(3, &mut random), random.list(12, 1.0));
    assert!(relative(&force(&damped, &q, &qd), &force(&gauss, &q, &qd)) < 1e-13);
}

#[test]
fn symmetries() {
    let element = TensorElement::straight(data(2, 0)).unwrap();
    let close = |a: f64, b: f64| (a - b).abs() < 1e-13;
    for at in 0..256 {
        let [i, j, m, n] = [at / 64, at / 16 % 4, at / 4 % 4, at % 4];
        let (kappa, upsilon) = (element.kappa(i, j, m, n), element.upsilon(i, j, m, n));
        for [a, b, c, d] in [[j, i, m, n], [i, j, n, m], [m, n, i, j], [m, j, i, n]] {
            assert!(close(kappa, element.kappa(a, b, c, d)));
        }
        for [a, b, c, d] in [[j, i, m, n], [i, j, n, m], [m, n, i, j]] {
            assert!(close(upsilon, element.upsilon(a, b, c, d)));
        }
    }
}

#[test]
fn one_entry_by_hand() {
    // kappa^1111 = EA int (6 (xi^2 - xi)/l)^4 dx = EA 6^4 B(5, 5) / l^3, B(5, 5) = 1/630.
    let data = data(2, 0);
    let element = TensorElement::straight(data).unwrap();
    let exact = data.axial_stiffness * 1296.0 / 630.0 / data.length.powi(3);
    assert!((element.kappa(0, 0, 0, 0) / exact - 1.0).abs() < 1e-14);
    // ups^iiii cancels: one vector alone does not bend.
    for i in 0..4 {
        assert!(element.upsilon(i, i, i, i).abs() < 1e-13);
    }
}

#[test]
fn exact_curvature_is_refused() {
    assert!(TensorElement::straight(data(2, 2)).unwrap_err().contains("exponent"));
}
