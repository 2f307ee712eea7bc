//! T10 of THEORY 10: a floating frame with linear elastic forces loses the stiffness of a rotor as it spins up.

use rncf_models::RotatingCantilever;
use rncf_reference::beam::{Beam, Chain, Root};
use rncf_reference::dense::Matrix;
use rncf_reference::element::{Data, Weights};
use rncf_reference::inertia::{Frame, State};
use rncf_reference::symmetric::generalised;

use crate::scenes::{equilibrium, referenced};

/// eta, and the lowest frequency in the plane of rotation of THEORY 8.2.
const TABLE: [(f64, f64); 7] = [
    (0.0, 3.51602),
    (2.0, 3.62180),
    (3.0, 3.74351),
    (4.0, 3.89772),
    (6.0, 4.26323),
    (8.0, 4.65715),
    (12.0, 5.42705),
];

rncf::model! {
    /// The rotor of THEORY 8.2 in modes of small deformations.
    pub model Small {
        param eta = 0 rad/s;
        param modes: count = 4;
        material stiff { density = 1000 kg/m^3; young = 100 GPa; }
        section wire { area = 10 cm^2; second_moment = 10 mm^4; }
        frame hub = rotating(axis = z, angle = eta * t);
        body blade in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 8 * tether(wire, stiff);
            small(modes);
        }
        joint root = clamp(blade.start, hub);
        output tip = blade.end.y;
    }
}

/// Square of the lowest frequency of the same rotor in the plane with the elastic forces of the shape at rest,
/// `M x'' + (K_0 - eta^2 M) x = 0`: no tension, no stiffness from it. (Coriolis terms couple to stretching alone.)
fn linear(eta: f64) -> f64 {
    let element = Data {
        dimension: 2,
        length: 1.0,
        mass_per_length: 1.0,
        axial_stiffness: 1e8,
        bending_stiffness: 1.0,
        exponent: 0,
        damping: 0.0,
        points: 5,
    };
    let beam = Beam {
        elements: 8,
        length: 1.0,
        hub_radius: 0.0,
        root: Root::Clamped,
        element,
    };
    let chain = Chain::new(beam).unwrap();
    let (q, rest) = (chain.straight(), vec![0.0; chain.coordinates()]);
    let at_rest = State {
        q: &q,
        qd: &rest,
        qdd: &rest,
    };
    let mut stiffness = Matrix::zero(chain.coordinates());
    chain.tangent(at_rest, &Frame::default(), Weights::POSITION, &mut stiffness);
    let mass = chain.mass();
    // The root's position and the direction of its slope are held.
    let free: Vec<usize> = (0..chain.coordinates()).filter(|&k| k == 2 || k > 3).collect();
    let [mut k, mut m] = [Matrix::zero(free.len()), Matrix::zero(free.len())];
    for (i, &row) in free.iter().enumerate() {
        for (j, &column) in free.iter().enumerate() {
            m.set(i, j, mass.get(row, column));
            k.set(i, j, stiffness.get(row, column) - eta * eta * mass.get(row, column));
        }
    }
    generalised(&k, &m).unwrap()[0]
}

/// Lowest frequency in the plane of rotation of the whole body: what moves out of it does not come first.
fn whole(eta: f64) -> f64 {
    let model = RotatingCantilever {
        eta,
        elements: 8,
        ..RotatingCantilever::default()
    };
    let (_, modes) = equilibrium(referenced(&model).as_mut(), 0.0, 2);
    modes[0].im
}

#[test]
fn linear_elastic_forces_diverge_where_the_rotor_stiffens() {
    for (eta, expected) in TABLE {
        let (square, found) = (linear(eta), whole(eta));
        let lost = 3.51602f64.powi(2) - eta * eta;
        let mut small = referenced(&Small {
            eta,
            ..Small::default()
        });
        let (state, modes) = equilibrium(small.as_mut(), 0.0, 1);
        let warnings: Vec<String> = small.warnings(&state).into_iter().map(|warning| warning.text).collect();
        println!(
            "eta {eta}: linear frame {} {:.4}, small(4) {:.4}, ours {found:.5}, table {expected}; {warnings:?}",
            if square < 0.0 { "grows with" } else { "oscillates with" },
            square.abs().sqrt(),
            modes[0].im,
        );
        assert!((square - lost).abs() < 1e-3 * (1.0 + lost.abs()), "{square} {lost}");
        assert_eq!(square < 0.0, eta > 3.516);
        assert!((found / expected - 1.0).abs() < 5e-4, "{found}");
        // Small deformations know no spin at all, and say so.
        assert!((modes[0].im - 3.516).abs() < 1e-3);
        assert_eq!(warnings.len(), usize::from(eta >= 3.0), "{warnings:?}");
        assert!(warnings.iter().all(|text| text.contains("`blade`")));
    }
}
