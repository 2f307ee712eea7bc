//! Reduction and invariants of bodies from files.

use super::files::{FiniteElements, Matrices};
use super::{Imported, ImportedSpec, Wanted};
use crate::space::{Vector, three};

const BEAM: &[u8] = include_bytes!("../../../tests/reference/data/beam.npz");
const BEAM_MM: &[u8] = include_bytes!("../../../tests/reference/data/beam_mm.npz");
const BLOCK: &[u8] = include_bytes!("../../../tests/reference/data/block.npz");

fn beam(keeps_interfaces: bool) -> ImportedSpec {
    ImportedSpec {
        body: "arm",
        files: &[("beam.npz", BEAM)],
        units: [1.0; 3],
        interfaces: &[("root", &[10]), ("tip", &[90])],
        keeps_interfaces,
        damping: [0.0; 2],
    }
}

fn block() -> Imported {
    Imported::read(&ImportedSpec {
        body: "block",
        files: &[("block.npz", BLOCK)],
        units: [1.0; 3],
        interfaces: &[("left", &[1, 8, 15, 22]), ("right", &[7, 14, 21, 28])],
        keeps_interfaces: false,
        damping: [0.0; 2],
    })
    .unwrap()
}

/// The same matrices by iteration and at once.
#[test]
fn iterated_modes_are_those_found_at_once() {
    let body = block();
    let Matrices::Full { mass, stiffness } = &body.elements.matrices else {
        panic!("whole matrices");
    };
    // So many blocks side by side that they are iterated.
    let (size, copies) = (mass.size(), 6);
    let many = |matrix: &super::files::Sparse| {
        let all = (0..copies).flat_map(|copy| {
            let factor = 1.0 + 0.01 * copy as f64;
            matrix.rows.iter().enumerate().flat_map(move |(row, entries)| {
                entries
                    .iter()
                    .map(move |&(column, value)| (copy * size + row, copy * size + column, factor * value))
            })
        });
        let held = (0..copies * size).map(|at| (at, at, 0.0));
        super::files::Sparse::new(copies * size, all.chain(held))
    };
    let soft = |matrix: &super::files::Sparse| {
        let held = (0..matrix.size()).map(|at| (at, at, 1e5 * (1.0 + at as f64 / 7.0)));
        let all = matrix.rows.iter().enumerate();
        let all = all.flat_map(|(row, entries)| entries.iter().map(move |&(column, value)| (row, column, value)));
        super::files::Sparse::new(matrix.size(), all.chain(held))
    };
    let (k, m) = (soft(&many(stiffness)), many(mass));
    assert!(k.size() > 400);
    let iterated = super::lowest::lowest(&k, &m, &[], 5).unwrap();
    for (frequency, vector) in iterated.frequencies.iter().zip(&iterated.vectors) {
        let (force, momentum) = (k.times(vector), m.times(vector));
        let square = frequency * frequency;
        let left: f64 = force
            .iter()
            .zip(&momentum)
            .map(|(f, p)| (f - square * p).powi(2))
            .sum::<f64>()
            .sqrt();
        let whole: f64 = force.iter().map(|f| f * f).sum::<f64>().sqrt();
        assert!(left < 1e-5 * whole, "{frequency}: {:e}", left / whole);
        let mass: f64 = vector.iter().zip(&momentum).map(|(x, p)| x * p).sum();
        assert!((mass - 1.0).abs() < 1e-9);
    }
}

/// A block of bricks has a mass matrix that is the same in all directions, so that its invariants are exact: the inertia of the
/// displaced body is that of its field, summed over the nodes with the mass matrix.
#[test]
fn invariants_of_a_block_of_bricks_are_sums_over_its_field() {
    let body = block();
    let found = body.reduced(Wanted::Modes(4), &[[false; 6]; 2]).unwrap();
    assert!(found.notes.is_empty());
    let Matrices::Full { mass, .. } = &body.elements.matrices else {
        panic!("whole matrices");
    };
    let inertia = &found.inertia;
    let whole = 2700.0 * 1.2 * 0.01;
    assert!((inertia.mass - whole).abs() < 1e-10 * whole);
    assert!((inertia.moment - whole * Vector::new(0.6, 0.05, 0.05)).norm() < 1e-10 * whole);
    let xx = whole * 2.0 * 0.01 / 3.0;
    assert!((inertia.inertia[(0, 0)] - xx).abs() < 1e-9 * xx);
    // Kinetic energy of a displaced and moving body by the constants, and by the velocities of its nodes.
    let (spin, velocity) = (Vector::new(0.3, -0.5, 0.7), Vector::new(1.0, 2.0, -0.4));
    let shapes = shapes(&body, 4);
    let (p, rates): (Vec<f64>, Vec<f64>) = (0..4).map(|i| (0.02 * (1.0 + i as f64), 3.0 - i as f64)).unzip();
    let vector = |shape: &Vec<f64>, node: usize| three(shape, 3 * node);
    let sum = |factors: &[f64], node: usize| {
        let parts = factors.iter().zip(&shapes);
        parts
            .map(|(factor, shape)| *factor * vector(shape, node))
            .sum::<Vector>()
    };
    let moved: Vec<f64> = (0..body.elements.nodes.len())
        .flat_map(|node| {
            let place = Vector::from(body.elements.nodes[node]) + sum(&p, node);
            <[f64; 3]>::from(velocity + (spin.cross(&place) + sum(&rates, node)))
        })
        .collect();
    let by_nodes: f64 = 0.5 * moved.iter().zip(mass.times(&moved)).map(|(v, p)| v * p).sum::<f64>();
    let sums = crate::modal::kinetic_of(&found.inertia, spin, &p, &rates);
    let (momentum, kinetic) = sums;
    let by_constants = kinetic + velocity.dot(&momentum) + 0.5 * inertia.mass * velocity.dot(&velocity);
    assert!(
        (by_constants - by_nodes).abs() < 1e-10 * by_nodes,
        "{by_constants} {by_nodes}"
    );
}

/// Of a straight beam along x nothing but x stands beside its mass, so that the product of x with a mode's motion across is all of what turns about
/// the third axis (gamma_i, exact by the mass matrix), and its symmetric half is half of that. Of masses lumped at the nodes it is 12 times as far from that.
#[test]
fn a_straight_beam_is_pulled_across_by_half_of_what_turns_it() {
    let body = Imported::read(&beam(false)).unwrap();
    let is_straight = body.elements.nodes.iter().all(|node| node[1] == 0.0 && node[2] == 0.0);
    assert!(is_straight);
    let found = body.reduced(Wanted::Modes(4), &[[true; 6], [false; 6]]).unwrap();
    for (gamma, first) in found.inertia.gamma.iter().zip(&found.inertia.first) {
        for (across, half) in [(1, 0.5 * gamma[2]), (2, -0.5 * gamma[1])] {
            let symmetric = -0.5 * (first[(0, across)] + first[(across, 0)]);
            let size = gamma.norm();
            assert!((symmetric - half).abs() < 3e-3 * size, "{symmetric} {half}");
        }
    }
}

/// Shapes of the natural modes, which `reduced` keeps to itself: of all nodes as interfaces.
fn shapes(body: &Imported, count: usize) -> Vec<Vec<f64>> {
    body.shapes_of(count)
}

#[test]
fn units_change_nothing_but_the_numbers() {
    let own = Imported::read(&beam(false)).unwrap();
    let other = Imported::read(&ImportedSpec {
        files: &[("beam_mm.npz", BEAM_MM)],
        units: [1e-3, 1e3, 1.0],
        ..beam(false)
    })
    .unwrap();
    let held = [[true; 6], [false; 6]];
    let [own, other] = [own, other].map(|body| body.reduced(Wanted::Modes(12), &held).unwrap());
    for (a, b) in own.frequencies.iter().zip(&other.frequencies) {
        assert!((a - b).abs() < 1e-7 * a, "{a} {b}");
    }
    assert!((own.inertia.mass - other.inertia.mass).abs() < 1e-12);
    assert!((own.inertia.inertia[(1, 1)] - other.inertia.inertia[(1, 1)]).abs() < 1e-11);
}

/// With all normal modes those of the interfaces span everything: the free frequencies are the natural ones.
#[test]
fn craig_bampton_with_all_modes_is_the_whole_body() {
    let free = [[false; 6]; 2];
    let natural = Imported::read(&beam(false))
        .unwrap()
        .reduced(Wanted::Modes(48), &free)
        .unwrap();
    let all = Imported::read(&beam(true))
        .unwrap()
        .reduced(Wanted::Modes(42), &free)
        .unwrap();
    assert_eq!((natural.frequencies.len(), all.frequencies.len()), (48, 48));
    for (a, b) in natural.frequencies.iter().zip(&all.frequencies) {
        assert!((a - b).abs() < 1e-7 * a, "{a} {b}");
    }
    let few = Imported::read(&beam(true))
        .unwrap()
        .reduced(Wanted::Modes(6), &free)
        .unwrap();
    assert_eq!(few.frequencies.len(), 12);
    assert!((few.frequencies[0] / natural.frequencies[0] - 1.0).abs() < 1e-3);
}

#[test]
fn bodies_that_are_none_are_refused() {
    let told = |change: &dyn Fn(&mut FiniteElements), held: [[bool; 6]; 2], words: &[&str]| {
        let mut body = Imported::read(&beam(false)).unwrap();
        change(&mut body.elements);
        let message = body.reduced(Wanted::Modes(3), &held).unwrap_err();
        assert!(words.iter().all(|word| message.contains(word)), "{message}");
    };
    let parts = |body: &mut FiniteElements| match &mut body.matrices {
        Matrices::Full { mass, stiffness } => (std::mem::take(mass), std::mem::take(stiffness)),
        Matrices::Modal { .. } => panic!("whole matrices"),
    };
    let free = [[false; 6]; 2];
    let with = |change: &dyn Fn(&mut super::files::Sparse, &mut super::files::Sparse), body: &mut FiniteElements| {
        let (mut mass, mut stiffness) = parts(body);
        change(&mut mass, &mut stiffness);
        body.matrices = Matrices::Full { mass, stiffness };
    };
    let grounded = |body: &mut FiniteElements| {
        with(
            &|_, k| {
                k.rows[1]
                    .iter_mut()
                    .filter(|entry| entry.0 == 1)
                    .for_each(|entry| entry.1 *= 2.0)
            },
            body,
        );
    };
    told(&grounded, free, &["`arm`", "`K` resists", "without supports"]);
    let heavier = |body: &mut FiniteElements| {
        with(
            &|m, _| {
                m.rows
                    .iter_mut()
                    .step_by(6)
                    .for_each(|row| row.iter_mut().for_each(|entry| entry.1 *= 2.0))
            },
            body,
        );
    };
    told(&heavier, free, &["`arm`", "along x, y and z"]);
    let pinned = [[true, true, true, false, false, false], [false; 6]];
    told(&|_| {}, pinned, &["`arm`", "without stiffness", "clamp"]);
    let torn = |body: &mut FiniteElements| {
        with(
            &|_, k| {
                for (row, entries) in k.rows.iter_mut().enumerate() {
                    entries.retain(|(column, _)| (row < 30) == (*column < 30));
                }
            },
            body,
        );
    };
    told(&torn, free, &["`arm`"]);
    let many = Imported::read(&beam(false))
        .unwrap()
        .reduced(Wanted::Modes(60), &free)
        .unwrap_err();
    assert!(many.contains("48 freedoms"), "{many}");
}
