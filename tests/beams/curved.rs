//! Curved beams in steady rotation against THEORY 9.2 and the hand-written chain.

use rncf::Model;
use rncf::equilibrium::{Uniform, steady};
use rncf_models::{CurvedDownwind, CurvedOutOfPlane, CurvedUpwind};
use rncf_tests::section_beam::{Properties, Section};
use rncf_tests::section_chain::{Chain, Hold, Shape, Slot, Supports};
use rncf_tests::section_statics::Problem;

use crate::scenes::{distance, outputs, referenced, short};

/// When the hub has reached its speed, s.
const LATE: f64 = 20.0;

/// Deflections u, v, w of the tip in the relative equilibrium.
fn deflections(model: &impl Model) -> [f64; 3] {
    let mut scene = referenced(model);
    let found = steady(scene.as_mut(), LATE).unwrap();
    let row = outputs(scene.as_mut(), &Uniform::steady(LATE), found.state().unwrap());
    [row[0], row[1], row[2]]
}

/// The same of the hand-written chain on an arc of 16 m in the plane of x and `axis`.
fn by_hand(elements: usize, axis: usize) -> [f64; 3] {
    let section = Section {
        young: 68.95e9,
        poisson: 0.3,
        density: 2766.67,
        area: 0.7299e-4,
        i_zz: 0.8215e-8,
        i_yy: 0.8215e-8,
        torsion: 2.0 * 0.8215e-8,
        shear_factor: 0.53,
    };
    let arc = |x: f64| -> Shape {
        let (s, c) = (x / 16.0).sin_cos();
        let mut shape = [[0.0; 3]; 4];
        (shape[0][0], shape[0][axis]) = (16.0 * s, 16.0 * (1.0 - c));
        (shape[1][0], shape[1][axis]) = (c, s);
        // The director in the plane of the arc, and the other one.
        (shape[1 + axis][0], shape[1 + axis][axis]) = (-s, c);
        shape[4 - axis][3 - axis] = 1.0;
        shape
    };
    let chain = Chain::along(Properties::structural(3, 8.0, &section), elements, arc).unwrap();
    let problem = Problem {
        supports: Supports::clamp(&chain, Hold::Direction),
        chain,
        loads: vec![],
        spin: [0.0, 0.0, 4.0],
    };
    let q = problem.solve(2).unwrap();
    let tip = problem.chain.vector(elements, Slot::Position);
    let (to, from) = (
        problem.chain.read(&q, tip),
        problem.chain.read(problem.chain.stress_free(), tip),
    );
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

#[test]
fn steady_deflections() {
    // THEORY 9.2, made with 3 gradient points and directors held whole.
    for (elements, in_plane, out_of_plane, limit) in [
        (4, [0.16735, -0.57282, 0.0], [0.27903, 0.0, -1.27361], 2e-2),
        (16, [0.16629, -0.56493, 0.0], [0.27903, 0.0, -1.27419], 2e-4),
    ] {
        let up = deflections(&CurvedUpwind {
            elements,
            ..CurvedUpwind::default()
        });
        let down = deflections(&CurvedDownwind {
            elements,
            ..CurvedDownwind::default()
        });
        let out = deflections(&CurvedOutOfPlane {
            elements,
            ..CurvedOutOfPlane::default()
        });
        let from_chain = [
            distance(&up, &by_hand(elements, 1)),
            distance(&out, &by_hand(elements, 2)),
        ];
        let from_table = [distance(&up, &in_plane), distance(&out, &out_of_plane)];
        println!(
            "{elements} elements: upwind {up:.7?}, out {out:.7?}; from the table {} m, from the chain {} m",
            short(&from_table),
            short(&from_chain)
        );
        assert!(from_chain.iter().all(|&apart| apart < 1e-8));
        assert!(from_table.iter().all(|&apart| apart < limit));
        // In the plane one is the mirror image of the other; out of it nothing bends within it.
        assert!(distance(&down, &[up[0], -up[1], 0.0]) < 1e-10 && up[2] == 0.0);
        assert!(out[1].abs() < 1e-10, "{out:?}");
    }
}
