//! What an evaluation and a run cost in modes, beside the whole body of the same mesh.

use std::hint::black_box;
use std::time::Instant;

use rncf::system::Tangent;
use rncf::{Method, Model, Scene};
use rncf_models::SpinUp;

use super::models::SpinUpModal;
use crate::runs::{WAYS, adaptive, grid, states_at};

/// Microseconds of a residual, of a tangent, and of a run of the spin-up, the least of several.
fn microseconds(model: &impl Model) -> [f64; 3] {
    let build = || model.build(WAYS[0].0, WAYS[0].1).unwrap();
    let mut scene = build();
    let times = grid(1.0, 5.0);
    let start = scene.rest(0.0);
    let (states, _) = states_at(scene.as_mut(), start.clone(), Method::Radau, adaptive(1e-6), &times);
    let state = &states[states.len() - 1];
    let (mut out, mut tangent) = (vec![0.0; state.x.len()], Tangent::default());
    let mut least = [f64::INFINITY; 3];
    let mut measure = |which: usize, repeats: u32, scene: &mut dyn Scene, call: &mut dyn FnMut(&mut dyn Scene)| {
        for _ in 0..5 {
            let clock = Instant::now();
            (0..repeats).for_each(|_| call(scene));
            least[which] = least[which].min(1e6 * clock.elapsed().as_secs_f64() / f64::from(repeats));
        }
    };
    measure(0, 1000, scene.as_mut(), &mut |scene| {
        scene.residual(black_box(state), &mut out)
    });
    measure(1, 1000, scene.as_mut(), &mut |scene| {
        scene.tangent(black_box(state), &mut tangent)
    });
    measure(2, 1, scene.as_mut(), &mut |scene| {
        black_box(states_at(scene, start.clone(), Method::Radau, adaptive(1e-6), &[18.0]));
    });
    least
}

#[test]
#[ignore = "measurement: cargo test --release -p rncf-tests --test accuracy timing -- --ignored --nocapture"]
fn four_modes_are_cheaper_than_sixteen_elements() {
    let elements = 16;
    let whole = microseconds(&SpinUp {
        elements,
        ..SpinUp::default()
    });
    for modes in [4, 12] {
        let modal = microseconds(&SpinUpModal {
            elements,
            modes,
            ..SpinUpModal::default()
        });
        for (which, name) in ["residual", "tangent", "run"].iter().enumerate() {
            let [a, b] = [whole[which], modal[which]];
            println!(
                "{name}: {elements} elements {a:.1} us, {modes} modes {b:.1} us, ratio {:.1}",
                a / b
            );
        }
        assert!(modes > 4 || modal[2] < 0.5 * whole[2]);
    }
}
