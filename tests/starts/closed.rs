//! What is closed to a ring, and free.

use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// A ring in space that nothing holds and nothing acts on.
    pub model Ring {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round = circle(radius = 5 mm);
        frame f = free(plane = xy);
        body ring in f {
            planar xy;
            arc from [500, 0, 0] mm direction [0, 1, 0] radius 500 mm angle 360 deg;
            mesh 32 * cable(round, steel, axial = engineering, bending = exact);
            mean_axes;
        }
        joint close = weld(ring.start, ring.end);
        output c = ring.at(eta = 0.5);
    }
}

/// The weld is open by round-off, and its force has a lever of round-off: no force that is not balanced. `w^2 = EI n^2 (n^2 - 1)^2 / (m R^4 (n^2 + 1))`.
#[test]
fn a_free_ring_that_is_welded_has_its_modes() {
    let found = modes(&Ring {}, &EquilibriumSettings::default()).unwrap();
    let own: Vec<f64> = found.modes.iter().map(|mode| mode.im).collect();
    let radius: f64 = 5e-3;
    let (area, second) = (
        std::f64::consts::PI * radius.powi(2),
        std::f64::consts::PI * radius.powi(4) / 4.0,
    );
    let right = |n: f64| {
        let square = 210e9 * second * (n * (n * n - 1.0)).powi(2) / (7850.0 * area * 0.5f64.powi(4) * (n * n + 1.0));
        square.sqrt()
    };
    println!("{own:?} {} {}", right(2.0), right(3.0));
    assert_eq!(own[..3], [0.0; 3]);
    for (index, n) in [(3, 2.0), (4, 2.0), (5, 3.0), (6, 3.0)] {
        assert!(
            (own[index] / right(n) - 1.0).abs() < 5e-3,
            "{n}: {} {}",
            own[index],
            right(n)
        );
    }
}
