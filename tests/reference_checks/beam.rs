//! The spin-up beam: derivatives, both frames against each other, and against the table of THEORY 9.1.

use crate::differences::{Random, jacobian, largest, relative};
use rncf_reference::beam::{Beam, Root};
use rncf_reference::dense::{Cholesky, Matrix};
use rncf_reference::element::Data;
use rncf_reference::inertial_beam::InertialBeam;
use rncf_reference::integrate::{Method, agreed, states};
use rncf_reference::rotating_beam::RotatingBeam;
use rncf_reference::spin_up::SpinUp;
use rncf_reference::system::System;
use rncf_reference::table::{EXTREMES, Record, STEADY_ELONGATIONS};

const ROOTS: [Root; 3] = [Root::Pinned, Root::Clamped, Root::ClampedFully];

/// A soft, damped beam off the axis, so that every term counts.
fn soft(dimension: usize, root: Root) -> Beam {
    let data = Beam::spin_up(dimension, 2, 2);
    let element = Data {
        axial_stiffness: 30.0,
        bending_stiffness: 20.0,
        damping: 0.05,
        ..data.element
    };
    Beam {
        length: 2.0,
        hub_radius: 0.7,
        root,
        element,
        ..data
    }
}

/// A state near rest.
fn shaken(rest: Vec<f64>, size: f64, random: &mut Random) -> Vec<f64> {
    rest.into_iter().map(|y| y + size * random.next()).collect()
}

/// Largest relative error of a system's Jacobian, and that the pattern leaves nothing out.
fn jacobian_error(system: &impl System, t: f64, y: &[f64]) -> f64 {
    let load = |y: &[f64]| {
        let mut load = vec![0.0; y.len()];
        system.load(t, y, &mut load);
        load
    };
    let columns = jacobian(load, y, 1e-3);
    let mut exact = Matrix::zero(y.len());
    system.load_jacobian(t, y, &mut exact);
    let mut inside = Matrix::zero(y.len());
    system.pattern().iter().for_each(|&(i, j)| inside.add(i, j, 1.0));
    for i in 0..y.len() {
        for j in 0..y.len() {
            assert!(inside.get(i, j) <= 1.0, "({i}, {j}) is listed twice");
            assert!(
                inside.get(i, j) == 1.0 || exact.get(i, j) == 0.0,
                "({i}, {j}) is missing in the pattern"
            );
        }
    }
    let exact: Vec<f64> = (0..y.len() * y.len())
        .map(|k| exact.get(k % y.len(), k / y.len()))
        .collect();
    relative(&exact, &columns.concat())
}

#[test]
fn jacobians_of_both_frames() {
    let (mut random, motion) = (Random(31), SpinUp::new(3.0, 2.0).unwrap());
    for dimension in [2, 3] {
        for root in ROOTS {
            let rotating = RotatingBeam::new(soft(dimension, root), motion).unwrap();
            let inertial = InertialBeam::new(soft(dimension, root), motion).unwrap();
            let (y, z) = (
                shaken(rotating.rest(), 0.2, &mut random),
                shaken(inertial.rest(), 0.2, &mut random),
            );
            let errors = [jacobian_error(&rotating, 1.2, &y), jacobian_error(&inertial, 1.2, &z)];
            println!(
                "dimension {dimension}, {root:?}: Jacobian errors {:.1e} rotating, {:.1e} inertial",
                errors[0], errors[1]
            );
            assert!(
                errors.iter().all(|error| *error < 1e-8),
                "{dimension} {root:?} {errors:?}"
            );
        }
    }
}

#[test]
fn both_frames_give_one_motion() {
    let motion = SpinUp::new(3.0, 2.0).unwrap();
    for dimension in [2, 3] {
        for root in ROOTS {
            let rotating = RotatingBeam::new(soft(dimension, root), motion).unwrap();
            let inertial = InertialBeam::new(soft(dimension, root), motion).unwrap();
            let mut start = rotating.rest();
            let mut turned = inertial.rest();
            if dimension == 3 {
                // A push of the tip out of the plane: x' of the last node's z, in both systems.
                let (a, b) = (start.len(), turned.len());
                start[a - 4] = 0.3;
                turned[b - 4] = 0.3;
            }
            let times = [0.0, 0.7, 1.4, 2.0, 2.5];
            let run = |system: &dyn Fn() -> rncf_reference::integrate::Agreed| system().states;
            let a = run(&|| agreed(&rotating, Method::DoPri8, 1e-11, &start, &times, 1e-7).unwrap());
            let b = run(&|| agreed(&inertial, Method::DoPri8, 1e-11, &turned, &times, 1e-7).unwrap());
            let mut worst = 0.0;
            for (k, &t) in times.iter().enumerate() {
                let (tip, other) = (rotating.tip(&a[k]), inertial.tip(t, &b[k]));
                worst = f64::max(worst, largest((0..3).map(|i| tip[i] - other[i])));
            }
            let moved = largest(rotating.tip(a.last().unwrap()));
            println!("dimension {dimension}, {root:?}: tips differ by {worst:.1e} m, moved by {moved:.2} m");
            assert!(
                worst < 1e-11 && moved > 0.05,
                "{dimension} {root:?}: {worst} of {moved}"
            );
        }
    }
}

#[test]
fn steady_elongations_of_the_table() {
    for (spin, expected) in STEADY_ELONGATIONS {
        for (dimension, elements) in [(2, 1), (2, 6), (3, 4)] {
            let beam = Beam::spin_up(dimension, elements, 0);
            let rotating = RotatingBeam::new(beam, SpinUp::new(spin, 15.0).unwrap()).unwrap();
            let [u, v, w] = rotating.tip(&rotating.equilibrium().unwrap());
            println!("{spin} rad/s, {elements} elements: u = {u:.9e}, table {expected:.9e}");
            assert!(
                (u / expected - 1.0).abs() < 2e-6 && v == 0.0 && w == 0.0,
                "{spin} rad/s, {elements}: {u}"
            );
        }
    }
}

#[test]
fn spin_up_at_4_rad_per_s_meets_the_table() {
    let rotating = RotatingBeam::new(Beam::spin_up(2, 6, 0), SpinUp::new(4.0, 15.0).unwrap()).unwrap();
    let times: Vec<f64> = (0..=70).map(|k| f64::from(k) / 10.0).collect();
    let run = agreed(&rotating, Method::Radau5, 1e-12, &rotating.rest(), &times, 1e-7).unwrap();
    let tips: Vec<[f64; 3]> = run.states.iter().map(|y| rotating.tip(y)).collect();
    let looser = largest(tips.iter().zip(&run.loose).flat_map(|(tip, y)| {
        let other = rotating.tip(y);
        (0..2).map(move |k| tip[k] - other[k])
    }));
    let record = Record::Spin4Elements6.history().unwrap();
    let worst = largest(tips.iter().zip(&record.v).map(|(tip, v)| tip[1] - v));
    let worst_u = largest(tips.iter().zip(&record.u).map(|(tip, u)| tip[0] - u));
    let (k, least) = tips
        .iter()
        .enumerate()
        .min_by(|a, b| a.1[1].total_cmp(&b.1[1]))
        .unwrap();
    println!(
        "spin-up 4 rad/s: least v = {:.8} at {} s, record differs by {worst:.1e} (v) and {worst_u:.1e} (u); \
         tolerances differ by {:.1e} in any state, {looser:.1e} m at the tip; {} steps",
        least[1], times[k], run.difference, run.steps
    );
    // The table's own step error at h = 0.0025 s is below 1e-6 at the extreme.
    assert!((least[1] - EXTREMES[2].v).abs() < 2e-6 && times[k] == EXTREMES[2].time);
    assert!(worst < 2e-6 && worst_u < 2e-7, "{worst} {worst_u}");
}

/// Largest difference of tip positions from a record up to `end` (s).
fn record_difference(record: Record, spin: f64, elements: usize, exponent: u32, end: f64) -> f64 {
    let beam = Beam::spin_up(2, elements, exponent);
    let rotating = RotatingBeam::new(beam, SpinUp::new(spin, 15.0).unwrap()).unwrap();
    let record = record.history().unwrap();
    let times: Vec<f64> = record.t.iter().copied().take_while(|&t| t < end + 0.05).collect();
    let (run, steps) = states(&rotating, Method::Radau5, 1e-11, &rotating.rest(), &times).unwrap();
    let worst = largest(run.iter().enumerate().flat_map(|(k, y)| {
        let tip = rotating.tip(y);
        [tip[0] - record.u[k], tip[1] - record.v[k]]
    }));
    println!(
        "{spin} rad/s, {elements} elements, p = {exponent}, {end} s: record differs by {worst:.1e} m, {steps} steps"
    );
    worst
}

#[test]
fn faster_and_exact_spin_ups_meet_their_records() {
    // The records' own step errors: their differences between two steps are of this size.
    assert!(record_difference(Record::Spin10Elements16, 10.0, 16, 0, 7.0) < 3e-6);
    assert!(record_difference(Record::Spin10Elements16Exact, 10.0, 16, 2, 7.0) < 1e-5);
    assert!(record_difference(Record::Spin100Elements24, 100.0, 24, 0, 3.5) < 1e-5);
}

#[test]
fn explicit_and_implicit_methods_agree() {
    let rotating = RotatingBeam::new(Beam::spin_up(2, 2, 2), SpinUp::new(40.0, 15.0).unwrap()).unwrap();
    let times = [0.0, 0.5, 1.0];
    let (implicit, _) = states(&rotating, Method::Radau5, 1e-12, &rotating.rest(), &times).unwrap();
    let (explicit, steps) = states(&rotating, Method::DoPri8, 1e-10, &rotating.rest(), &times).unwrap();
    let difference = largest((0..3).flat_map(|k| {
        let (a, b) = (rotating.tip(&implicit[k]), rotating.tip(&explicit[k]));
        [a[0] - b[0], a[1] - b[1]]
    }));
    println!("Radau5 and DoPri8 ({steps} steps) differ by {difference:.1e} m");
    assert!(difference < 1e-9);
}

#[test]
fn inertial_spin_up_agrees_with_the_rotating_one() {
    let motion = SpinUp::new(4.0, 15.0).unwrap();
    let (beam, times) = (Beam::spin_up(2, 3, 0), [0.0, 1.0, 2.0, 3.0]);
    let (rotating, inertial) = (
        RotatingBeam::new(beam, motion).unwrap(),
        InertialBeam::new(beam, motion).unwrap(),
    );
    let a = agreed(&rotating, Method::Radau5, 1e-12, &rotating.rest(), &times, 1e-7).unwrap();
    let b = agreed(&inertial, Method::Radau5, 1e-12, &inertial.rest(), &times, 1e-6).unwrap();
    for (k, &t) in times.iter().enumerate() {
        let (tip, other) = (rotating.tip(&a.states[k]), inertial.tip(t, &b.states[k]));
        let difference = largest((0..2).map(|i| tip[i] - other[i]));
        println!(
            "t = {t} s: v = {:.9}, frames differ by {difference:.1e} ({} and {} steps)",
            tip[1], a.steps, b.steps
        );
        assert!(difference < 1e-9);
    }
}

#[test]
fn exact_curvature_and_spatial_start() {
    // Out of the plane nothing happens, and with p = 2 little does: the same motion for two seconds.
    let motion = SpinUp::new(10.0, 15.0).unwrap();
    let times = [0.0, 1.0, 2.0];
    let tip = |dimension, exponent| {
        let rotating = RotatingBeam::new(Beam::spin_up(dimension, 4, exponent), motion).unwrap();
        let run = agreed(&rotating, Method::Radau5, 1e-12, &rotating.rest(), &times, 1e-6).unwrap();
        rotating.tip(&run.states[2])
    };
    let (planar, spatial, exact) = (tip(2, 0), tip(3, 0), tip(2, 2));
    println!(
        "v planar {:.9}, spatial {:.9}, p = 2 {:.9}",
        planar[1], spatial[1], exact[1]
    );
    assert!((planar[1] - spatial[1]).abs() < 1e-7 && spatial[2] == 0.0);
    let change = (planar[1] - exact[1]).abs();
    assert!(change > 1e-9 && change < 5e-5, "{change}");
}

#[test]
fn free_motion_keeps_its_energy() {
    // A pinned, undamped beam at constant speed in the inertial frame: root on the axis, nothing drives it.
    let beam = Beam {
        hub_radius: 0.0,
        element: Data {
            damping: 0.0,
            ..soft(2, Root::Pinned).element
        },
        ..soft(2, Root::Pinned)
    };
    let inertial = InertialBeam::new(beam, SpinUp::new(0.0, 1.0).unwrap()).unwrap();
    let start = shaken(inertial.rest(), 0.05, &mut Random(32));
    let run = agreed(&inertial, Method::DoPri8, 1e-12, &start, &[0.0, 0.5, 1.0], 1e-6).unwrap();
    let mass = inertial.chain().mass();
    let energy = |t: f64, y: &[f64]| {
        let (q, qd) = inertial.coordinates(t, y);
        let mut momentum = vec![0.0; q.len()];
        mass.add_product(&qd, &mut momentum);
        let kinetic: f64 = 0.5 * qd.iter().zip(&momentum).map(|(v, p)| v * p).sum::<f64>();
        kinetic + inertial.chain().strain_energy(&q)
    };
    let (first, last) = (energy(0.0, &start), energy(1.0, &run.states[2]));
    println!(
        "free beam: energy {first:.6} J, relative drift {:.1e}",
        last / first - 1.0
    );
    assert!((last / first - 1.0).abs() < 1e-9);
}

#[test]
fn wrong_beams_are_named() {
    let motion = SpinUp::new(4.0, 15.0).unwrap();
    let wrong = |beam: Beam| RotatingBeam::new(beam, motion).unwrap_err();
    assert!(wrong(Beam::spin_up(2, 0, 0)).contains("elements"));
    assert!(
        wrong(Beam {
            length: -1.0,
            ..Beam::spin_up(2, 2, 0)
        })
        .contains("length")
    );
    assert!(
        wrong(Beam {
            hub_radius: f64::NAN,
            ..Beam::spin_up(2, 2, 0)
        })
        .contains("hub_radius")
    );
}

#[test]
fn dense_solvers() {
    let mut matrix = Matrix::zero(3);
    for (k, entry) in [4.0, 1.0, 0.0, 1.0, 3.0, 1.0, 0.0, 1.0, 2.0].into_iter().enumerate() {
        matrix.set(k / 3, k % 3, entry);
    }
    let right = [6.0, 10.0, 8.0];
    let mut x = right;
    Cholesky::new(&matrix).unwrap().solve(&mut x);
    let y = matrix.solve(&right).unwrap();
    for k in 0..3 {
        assert!((x[k] - (k + 1) as f64).abs() < 1e-15 && (y[k] - (k + 1) as f64).abs() < 1e-15);
    }
    assert!(Cholesky::new(&Matrix::zero(2)).unwrap_err().contains("row 0"));
    assert!(Matrix::zero(2).solve(&[1.0, 1.0]).unwrap_err().contains("singular"));
}
