//! Gauss rules against known nodes and exact integrals.

use rncf_reference::quadrature::gauss_legendre;

#[test]
fn integrates_its_degree_and_no_more() {
    for count in 1..=24 {
        let rule = gauss_legendre(count).unwrap();
        let moment = |degree: i32| rule.iter().map(|p| p.weight * p.xi.powi(degree)).sum::<f64>();
        for degree in 0..2 * count as i32 {
            let exact = 1.0 / f64::from(degree + 1);
            assert!(
                (moment(degree) - exact).abs() < 1e-14,
                "{count} points, degree {degree}: {}",
                moment(degree)
            );
        }
        if count <= 5 {
            assert!(
                (moment(2 * count as i32) - 1.0 / (2 * count + 1) as f64).abs() > 1e-8,
                "{count} points"
            );
        }
    }
}

#[test]
fn known_nodes_and_bad_counts() {
    let three = gauss_legendre(3).unwrap();
    assert!((three[2].xi - 0.5 * (1.0 + 0.6f64.sqrt())).abs() < 1e-15);
    assert!((three[1].weight - 4.0 / 9.0).abs() < 1e-15);
    assert!(gauss_legendre(0).unwrap_err().contains("count"));
}
