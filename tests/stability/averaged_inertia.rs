//! HHT with the velocity-dependent inertia put beside `M a` instead of beside the forces (THEORY 7.1): it converges, and
//! looks right, but only an order test shows that it is of first order for alpha != 0.

use rncf::{Formulation, Integrator, Joints, Method, Model, Options, StepSize, Stop};

use crate::failing::euler_angles;
use crate::singular_angles::{INERTIA, Tumbling};

const START: [f64; 3] = [0.3, 1.0, 0.3];
const END: f64 = 5.0;
const ALPHA: f64 = -0.2;

/// `J a_1 + w_1 x J w_1 = 0` with the update of HHT, whose `a_1` belongs to a time alpha h later; w at the end, rad/s.
fn averaged_wrongly(h: f64) -> [f64; 3] {
    let gamma = 0.5 - ALPHA;
    let [a, b, c] = INERTIA;
    let acceleration = |[p, q, r]: [f64; 3]| [(b - c) / a * q * r, (c - a) / b * r * p, (a - b) / c * p * q];
    let mut w = START;
    let mut before = acceleration(w);
    for _ in 0..(END / h).round() as usize {
        let mut next = w;
        for _ in 0..50 {
            let now = acceleration(next);
            next = std::array::from_fn(|i| w[i] + h * ((1.0 - gamma) * before[i] + gamma * now[i]));
        }
        (w, before) = (next, acceleration(next));
    }
    w
}

/// The runtime's w at the end, rad/s.
fn ours(method: Method, h: f64) -> [f64; 3] {
    let model = Tumbling {
        aside: START[0],
        ..Tumbling::default()
    };
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let rest = scene.rest(0.0);
    let options = Options {
        rtol: 1e-13,
        step: StepSize::Fixed(h),
        ..Options::default()
    };
    let mut integrator = Integrator::new(scene.as_mut(), rest, END, method, options).unwrap();
    while integrator.step().unwrap() != Stop::End {}
    let v = &integrator.state().v;
    [v[3], v[4], v[5]]
}

#[test]
fn inertia_beside_the_acceleration_costs_an_order() {
    let exact = euler_angles::run(INERTIA, [0.0, 0.0, 0.0, START[0], START[1], START[2]], END, 1e-12).state;
    let far = |w: [f64; 3]| (0..3).fold(0.0_f64, |most, i| most.max((w[i] - exact[3 + i]).abs()));
    let steps = [0.02, 0.01, 0.005];
    let wrong = steps.map(|h| far(averaged_wrongly(h)));
    let right = steps.map(|h| far(ours(Method::Hht { alpha: ALPHA }, h)));
    println!(
        "HHT {ALPHA}: wrongly averaged {}, ours {}",
        crate::short(&wrong),
        crate::short(&right)
    );
    for pair in 0..2 {
        assert!((1.9..2.1).contains(&(wrong[pair] / wrong[pair + 1])));
        assert!((3.8..4.2).contains(&(right[pair] / right[pair + 1])));
    }
    assert!(wrong[2] > 30.0 * right[2]);
}
