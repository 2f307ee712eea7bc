//! Static and relative equilibria of the ten-vector beam against THEORY 5.2, 5.2.1, 9.2, 9.3 and the exact rod.

use rncf_reference::rod::Rod;
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Shape, Slot, Supports, straight};
use rncf_reference::section_statics::{Load, Problem};
use std::f64::consts::PI;

/// Arc in the plane of x and y.
fn arc_y(curvature: f64) -> impl Fn(f64) -> Shape {
    move |x| {
        let (s, c) = (curvature * x).sin_cos();
        let at = [s / curvature, (1.0 - c) / curvature, 0.0];
        [at, [c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]
    }
}

/// Arc in the plane of x and z.
fn arc_z(curvature: f64) -> impl Fn(f64) -> Shape {
    move |x| {
        let (s, c) = (curvature * x).sin_cos();
        let at = [s / curvature, 0.0, (1.0 - c) / curvature];
        [at, [c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]
    }
}

/// A clamped beam with one load at its tip.
fn cantilever(properties: Properties, elements: usize, directors: Hold, load: Load) -> Problem {
    let chain = Chain::along(properties, elements, straight).unwrap();
    Problem {
        supports: Supports::clamp(&chain, directors),
        chain,
        loads: vec![load],
        spin: [0.0; 3],
    }
}

/// Small displacement of a vector of the last node.
fn linear(problem: &Problem, slot: Slot) -> [f64; 3] {
    let rest = problem.chain.stress_free();
    let (residual, tangent) = problem.residual(1.0, rest).unwrap();
    let step: Vec<f64> = tangent.solve(&residual).unwrap().iter().map(|x| -x).collect();
    let mut moved = vec![0.0; rest.len()];
    problem.supports.move_by(&step, &mut moved);
    problem
        .chain
        .read(&moved, problem.chain.vector(problem.chain.count(), slot))
}

/// Place of the last node.
fn tip(problem: &Problem, q: &[f64]) -> [f64; 3] {
    problem
        .chain
        .read(q, problem.chain.vector(problem.chain.count(), Slot::Position))
}

#[test]
fn bending_shear_and_torsion_are_exact_with_one_element() {
    for radius in [0.05, 0.005, 0.0005] {
        let s = Section::circle(radius, 2.1e11, 0.3, 7800.0);
        let timoshenko = 1.0 / (3.0 * s.young * s.i_zz) + 1.0 / (s.shear_factor * s.shear() * s.area);
        for properties in [
            Properties::structural(2, 1.0, &s),
            Properties::structural(3, 1.0, &s),
            Properties::coupled(3, 1.0, &s),
        ] {
            for (elements, directors) in [(1, Hold::Fixed), (1, Hold::Direction), (4, Hold::Direction)] {
                let bent = cantilever(properties, elements, directors, Load::Force(elements, [0.0, 1.0, 0.0]));
                let factor = linear(&bent, Slot::Position)[1] / timoshenko;
                assert!((factor - 1.0).abs() < 1e-6, "bending {factor}");
                if properties.dimension == 3 {
                    // Small, so that the torque's own tangent does not count.
                    let stiffness = s.shear() * s.torsion;
                    let load = Load::Torque(elements, 1e-9 * stiffness);
                    let twisted = cantilever(properties, elements, directors, load);
                    let factor = 1e9 * linear(&twisted, Slot::Y)[2];
                    assert!((factor - 1.0).abs() < 1e-6, "torsion {factor}");
                }
            }
        }
    }
}

#[test]
fn the_full_modulus_in_bending_locks() {
    let s = Section::circle(0.0005, 2.1e11, 0.3, 7800.0);
    let mut locking = Properties::coupled(3, 1.0, &s);
    for stiffness in &mut locking.gradients[..2] {
        *stiffness *= s.confined() / s.young;
    }
    let timoshenko = 1.0 / (3.0 * s.young * s.i_zz);
    for elements in [1, 8] {
        let load = Load::Force(elements, [0.0, 1.0, 0.0]);
        let factor = linear(&cantilever(locking, elements, Hold::Direction, load), Slot::Position)[1] / timoshenko;
        assert!((factor - 1.3 * 0.4 / 0.7).abs() < 1e-5, "{factor}");
    }
}

#[test]
fn a_clamp_of_whole_directors_keeps_the_root_from_contracting() {
    let s = Section::circle(0.005, 2.1e11, 0.3, 7800.0);
    let stretch = |properties, elements, directors| {
        let load = Load::Force(elements, [1.0, 0.0, 0.0]);
        linear(&cantilever(properties, elements, directors, load), Slot::Position)[0] * s.young * s.area
    };
    // THEORY 5.2, clamp.
    for (elements, expected) in [(1, 0.971), (2, 0.985), (4, 0.992), (8, 0.996)] {
        let fixed = stretch(Properties::coupled(3, 1.0, &s), elements, Hold::Fixed);
        assert!((fixed - expected).abs() < 5.1e-4, "{elements}: {fixed}");
        let free = stretch(Properties::coupled(3, 1.0, &s), elements, Hold::Direction);
        let structural = stretch(Properties::structural(3, 1.0, &s), elements, Hold::Fixed);
        assert!((free - 1.0).abs() < 1e-9 && (structural - 1.0).abs() < 1e-9);
    }
}

/// Angle of the whole roll and place of its tip in the exact solution of the quartic model (THEORY 5.2.1), unit length.
fn rolled_up(s: &Section) -> (f64, [f64; 2]) {
    let ratio = s.i_zz / s.area;
    let (mut a, mut b) = (1.0_f64, 1.0_f64);
    for _ in 0..100 {
        let angle = 2.0 * PI / (a * a * b * b);
        let strained = |other: f64| (1.0 - 2.0 * ratio * (other * angle).powi(2)).sqrt();
        (a, b) = (strained(b), strained(a));
    }
    let angle = 2.0 * PI / (a * a * b * b);
    (angle, [a / angle * angle.sin(), a / angle * (1.0 - angle.cos())])
}

#[test]
fn roll_up_table() {
    // THEORY 5.2.1 and circle_rollup.json: radius, axis and gradient points, error of the tip for 4, 8, 16 elements.
    const TABLE: [(f64, usize, usize, [f64; 3]); 6] = [
        (0.02, 5, 5, [3.4958338584e-2, 1.67041360498e-3, 1.04685455527e-4]),
        (0.02, 3, 3, [1.88889461191e-2, 1.60254823725e-3, 1.04955676667e-4]),
        (0.02, 3, 2, [2.20308294067e-3, 1.57652509194e-4, 3.83154400889e-6]),
        (0.005, 5, 5, [1.51956643221e-1, 2.93800347081e-3, 1.05784587666e-4]),
        (0.005, 3, 3, [1.50158142899e-2, 1.45834214815e-3, 9.98523463918e-5]),
        (0.005, 3, 2, [4.01465168283e-3, 1.43344876551e-4, 8.53192973116e-6]),
    ];
    for (radius, more) in [(0.02, 0.10292), (0.005, 0.006215)] {
        let angle = rolled_up(&Section::circle(radius, 1.0, 0.3, 1.0)).0;
        assert!((angle - 2.0 * PI - more).abs() < 6e-6, "{angle}");
    }
    for (radius, axis_points, gradient_points, errors) in TABLE {
        let s = Section::circle(radius, 1.0, 0.3, 1.0);
        let (_, exact) = rolled_up(&s);
        for (elements, expected) in [4, 8, 16].into_iter().zip(errors) {
            let properties = Properties {
                axis_points,
                gradient_points,
                ..Properties::structural(2, 1.0, &s)
            };
            let load = Load::Moment(elements, 2.0 * PI * s.young * s.i_zz);
            let problem = cantilever(properties, elements, Hold::Fixed, load);
            let place = tip(&problem, &problem.solve(20).unwrap());
            let error = (place[0] - exact[0]).hypot(place[1] - exact[1]);
            assert!(
                (error - expected).abs() < 1e-8,
                "{radius} {axis_points} {elements}: {error}"
            );
        }
    }
}

#[test]
fn curved_beams_turn_steadily() {
    let s = Section {
        young: 68.95e9,
        poisson: 0.3,
        density: 2766.67,
        area: 0.7299e-4,
        i_zz: 0.8215e-8,
        i_yy: 0.8215e-8,
        torsion: 2.0 * 0.8215e-8,
        shear_factor: 0.53,
    };
    let steady = |dimension, elements, shape: &dyn Fn(f64) -> Shape| {
        let properties = Properties {
            gradient_points: 3,
            ..Properties::structural(dimension, 8.0, &s)
        };
        let chain = Chain::along(properties, elements, shape).unwrap();
        let problem = Problem {
            supports: Supports::clamp(&chain, Hold::Fixed),
            chain,
            loads: vec![],
            spin: [0.0, 0.0, 4.0],
        };
        let q = problem.solve(2).unwrap();
        let (to, from) = (tip(&problem, &q), tip(&problem, problem.chain.stress_free()));
        [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
    };
    // THEORY 9.2, curved_steady.json: 3 axis and 3 gradient points, directors fixed whole.
    let in_plane = [
        (4, [0.167350990635, -0.572821680176]),
        (8, [0.166360119475, -0.565382678152]),
        (16, [0.166292618858, -0.56493172417]),
    ];
    let out_of_plane = [
        (4, [0.279029558408, -1.27361061102]),
        (8, [0.279027672068, -1.2741871987]),
        (16, [0.279025522405, -1.27419220342]),
    ];
    let close = |actual: [f64; 3], expected: [f64; 3]| {
        for k in 0..3 {
            assert!((actual[k] - expected[k]).abs() < 1e-9, "{actual:?} {expected:?}");
        }
    };
    for (elements, [u, v]) in in_plane {
        close(steady(3, elements, &arc_y(1.0 / 16.0)), [u, v, 0.0]);
        close(steady(2, elements, &arc_y(1.0 / 16.0)), [u, v, 0.0]);
        close(steady(3, elements, &arc_y(-1.0 / 16.0)), [u, -v, 0.0]);
    }
    for (elements, [u, w]) in out_of_plane {
        close(steady(3, elements, &arc_z(1.0 / 16.0)), [u, 0.0, w]);
    }
}

/// Rectangle with sides along y and z.
fn rectangle(y: f64, z: f64, young: f64, poisson: f64, torsion: f64) -> Section {
    Section {
        young,
        poisson,
        density: 1.0,
        area: y * z,
        i_zz: y.powi(3) * z / 12.0,
        i_yy: y * z.powi(3) / 12.0,
        torsion,
        shear_factor: 5.0 / 6.0,
    }
}

/// The rod with the same stiffnesses.
fn rod(s: &Section, length: f64, curvature: f64) -> Rod {
    let across = 1.0 / (s.shear_factor * s.shear() * s.area);
    let torsion = 1.0 / (s.shear() * s.torsion);
    Rod {
        length,
        force_compliance: [1.0 / (s.young * s.area), across, across],
        moment_compliance: [torsion, 1.0 / (s.young * s.i_yy), 1.0 / (s.young * s.i_zz)],
        curvature: [0.0, 0.0, curvature],
        steps: 200,
    }
}

/// Tip of a beam under a dead force, and its distance from the exact rod's over the length.
fn distance(s: &Section, length: f64, curvature: f64, elements: usize, force: [f64; 3]) -> f64 {
    let properties = Properties::structural(3, length, s);
    let chain = if curvature == 0.0 {
        Chain::along(properties, elements, straight)
    } else {
        Chain::along(properties, elements, arc_y(curvature))
    }
    .unwrap();
    let problem = Problem {
        supports: Supports::clamp(&chain, Hold::Direction),
        chain,
        loads: vec![Load::Force(elements, force)],
        spin: [0.0; 3],
    };
    let place = tip(&problem, &problem.solve(8).unwrap());
    let exact = rod(s, length, curvature).tip(force, [0.0; 3], 6).unwrap().position;
    (0..3).map(|k| (place[k] - exact[k]).powi(2)).sum::<f64>().sqrt() / length
}

#[test]
fn large_displacements_in_space_are_those_of_the_exact_rod() {
    let bend = rectangle(1.0, 1.0, 1e7, 0.0, 0.140577);
    let princeton = rectangle(0.0123777, 0.0032024, 71.7e9, 0.31, 3.103548 / (0.5 * 71.7e9 / 1.31));
    let (s, c) = (PI / 3.0).sin_cos();
    let last = [
        [4, 8, 16].map(|elements| distance(&bend, 25.0 * PI, 0.01, elements, [0.0, 0.0, 600.0])),
        [4, 8, 16].map(|elements| distance(&princeton, 0.508, 0.0, elements, [0.0, 8.896 * c, 8.896 * s])),
    ];
    println!("bend and Princeton beam, 4, 8, 16 elements: {last:?}");
    for errors in last {
        assert!(errors[1] < 0.2 * errors[0] && errors[2] < 0.2 * errors[1], "{errors:?}");
        assert!(errors[2] < 1e-4, "{errors:?}");
    }
}

#[test]
fn elastica_of_a_slender_beam() {
    // THEORY 9.7 at P L^2 / EI = 1 and r/L = 1e-3; the circle's EI is 1.
    let s = Section::circle(1e-3, 4e12 / PI, 0.3, 1.0);
    let error = |elements: usize| {
        let load = Load::Force(elements, [0.0, 1.0, 0.0]);
        let problem = cantilever(Properties::structural(2, 1.0, &s), elements, Hold::Direction, load);
        let place = tip(&problem, &problem.solve(4).unwrap());
        (1.0 - place[0] - 0.05643323628).hypot(place[1] - 0.3017207738)
    };
    let errors = [8, 16, 32].map(error);
    println!("elastica, 8, 16, 32 elements: {errors:?}");
    assert!(errors[1] < 5e-5 && errors[2] < 5e-6);
}

#[test]
fn what_is_not_held_or_loaded_too_fast_is_refused() {
    let s = Section::circle(0.005, 1.0, 0.3, 1.0);
    let load = Load::Moment(4, 2.0 * PI * s.young * s.i_zz);
    let mut problem = cantilever(Properties::structural(2, 1.0, &s), 4, Hold::Fixed, load);
    problem.loads = vec![Load::Force(4, [f64::NAN, 0.0, 0.0])];
    assert!(problem.solve(1).unwrap_err().contains("load step 1 of 1"));
}
