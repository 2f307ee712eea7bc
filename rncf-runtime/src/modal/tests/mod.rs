//! Bodies in modes against the projected equations of motion of a cantilever.

pub(super) mod cable;

use cable::{Cable, cantilever};

use crate::emitted::Fidelity;
use crate::modal::action::{CarriedTangent, FrameAction};
use crate::modal::body::*;
use crate::modal::expansion::Elastic;
use crate::modal::invariants::Action;
use crate::scene::bodies::described::{Described, Elements};
use crate::space::{Matrix, Vector, from_rows};

fn modal(dimension: usize, count: usize, slenderness: f64, fidelity: Fidelity) -> (ModalBody, Cable) {
    let (nodal, cable) = cantilever(dimension, count, slenderness, 0.3, 1e-3);
    (ModalBody::new(nodal, fidelity, &cable).unwrap(), cable)
}

/// Numbers between -1 and 1.
pub(super) fn numbers(count: usize, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..count).map(|_| next()).collect()
}

/// Modal coordinates of moderate size, rates and accelerations.
fn motion(body: &ModalBody, part: f64) -> [Vec<f64>; 3] {
    [1, 2, 3].map(|seed| {
        let numbers = numbers(body.modes(), seed);
        numbers
            .iter()
            .zip(body.sizes())
            .map(|(x, size)| part * x * size)
            .collect()
    })
}

fn frame(dimension: usize) -> FrameAction {
    let mut action = FrameAction {
        acceleration: Vector::new(0.7, -1.1, 0.4),
        spin: Vector::new(0.9, -0.5, 1.3),
        spin_rate: Vector::new(-0.6, 0.8, 0.35),
    };
    if dimension == 2 {
        action.acceleration[2] = 0.0;
        (action.spin, action.spin_rate) = (Vector::new(1.3, 0.0, 0.0), Vector::new(0.35, 0.0, 0.0));
    }
    action
}

/// Inertia forces on all nodal vectors, then force and moment on the frame: (11)-(13) as they stand.
fn direct(body: &ModalBody, frame: &FrameAction, at: [&[f64]; 3]) -> (Vec<f64>, [Vector; 2]) {
    let (nodal, action) = (&body.nodal, Action::new(frame, body.nodal.dimension));
    let mut full = [0, 1, 2].map(|_| vec![0.0; nodal.shape.len()]);
    body.expand(at[0], &mut full[0]);
    body.expand_rate(at[1], &mut full[1]);
    body.expand_rate(at[2], &mut full[2]);
    let [q, v, a] = full.map(|values| nodal.vectors(&mut values.iter().copied()));
    let w = action.spin;
    let acceleration = |b: usize| {
        let steady = w.cross(&w.cross(&q[b]));
        let moving = 2.0 * w.cross(&v[b]) + action.spin_rate.cross(&q[b]);
        a[b] + (steady + moving)
    };
    let count = nodal.whole.len();
    let (mut forces, mut total, mut moment) = (Vec::new(), Vector::zeros(), Vector::zeros());
    for row in 0..count {
        let mut force = Vector::zeros();
        for b in 0..count {
            let whole = nodal.whole[b] * action.acceleration;
            force += nodal.mass[row * count + b] * (acceleration(b) + whole);
        }
        total += nodal.whole[row] * force;
        moment += q[row].cross(&force);
        forces.extend(&force.as_slice()[..nodal.dimension]);
    }
    (forces, [total, moment])
}

fn largest(values: &[f64]) -> f64 {
    values.iter().map(|x| x.abs()).fold(0.0, f64::max)
}

pub(super) fn close(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    let size = largest(b).max(1e-9);
    for (i, (x, y)) in a.iter().zip(b).enumerate() {
        assert!((x - y).abs() <= tolerance * size, "{i}: {x} against {y}, size {size}");
    }
}

#[test]
fn invariants_are_the_projected_equations_of_motion() {
    for dimension in [2, 3] {
        let (body, _) = modal(dimension, 4, 1e4, Fidelity::Modal(7));
        let at = motion(&body, 0.4);
        let at = [&at[0][..], &at[1], &at[2]];
        let action = frame(dimension);
        let (nodal, [force, moment]) = direct(&body, &action, at);
        let mut projected = vec![0.0; 7];
        for (component, value) in nodal.iter().enumerate() {
            let row = body.mode_row(component);
            projected
                .iter_mut()
                .zip(row)
                .for_each(|(sum, mode)| *sum += mode * value);
        }
        let mut inertia = vec![0.0; 7];
        let three = Action::new(&action, dimension);
        body.with_motion(at, |motion| body.invariants.modal_force(&three, motion, &mut inertia));
        close(&inertia, &projected, 3e-14);
        let mut carried = vec![0.0; body.rows().len()];
        body.carried(&action, at, &mut carried);
        let expected: Vec<f64> = body
            .rows()
            .iter()
            .map(|&i| if i < 3 { force[i] } else { moment[i - 3] })
            .collect();
        close(&carried, &expected, 3e-14);
    }
}

#[test]
fn all_modes_are_the_whole_body() {
    for dimension in [2, 3] {
        let count = 2 * dimension * 2 + 1;
        let (body, cable) = modal(dimension, 2, 1e3, Fidelity::Modal(count));
        let at = motion(&body, 0.2);
        let at = [&at[0][..], &at[1], &at[2]];
        let action = frame(dimension);
        let nodal = &body.nodal;
        let (mut whole, _) = direct(&body, &action, at);
        let [q, v] = body.full(at[0], at[1]);
        for element in 0..nodal.connectivity.count() {
            let mut force = vec![0.0; nodal.connectivity.size];
            let (q, v) = (body.gathered(element, &q), body.gathered(element, &v));
            cable.force(element, &q, &v, &mut force);
            for (&component, value) in nodal.connectivity.element(element).iter().zip(&force) {
                whole[component] += value;
            }
        }
        // Forces on freedoms from those on modes: X^-T = M X.
        let mut force = vec![0.0; count];
        body.force(&cable, &action, at, &mut force);
        let mut freedoms = vec![0.0; nodal.freedoms];
        for (component, entry) in nodal.map.iter().enumerate() {
            for (unknown, factor) in entry {
                let momentum = &body.momenta[component * count..(component + 1) * count];
                freedoms[*unknown] += factor * momentum.iter().zip(&force).map(|(a, b)| a * b).sum::<f64>();
            }
        }
        close(&freedoms, &nodal.reduced(&whole), 1e-9);
        // And back: the coordinates of what the modes describe.
        close(&body.coordinates(&q), at[0], 1e-11);
    }
}

/// Central differences, exact for cubic polynomials, of a function of all of (e, w, w', p, p', p'').
fn differences(values: &[Vec<f64>], call: impl Fn(&[Vec<f64>]) -> Vec<f64>, which: usize) -> Vec<Vec<f64>> {
    let step = 1e-3;
    (0..values[which].len())
        .map(|place| {
            let at = |sign: f64| {
                let mut moved = values.to_vec();
                moved[which][place] += sign * step;
                call(&moved)
            };
            let near = at(1.0).into_iter().zip(at(-1.0)).map(|(a, b)| a - b);
            let far = at(2.0).into_iter().zip(at(-2.0)).map(|(a, b)| a - b);
            near.zip(far).map(|(a, b)| (8.0 * a - b) / (12.0 * step)).collect()
        })
        .collect()
}

#[test]
fn tangents_are_derivatives() {
    for fidelity in [
        Fidelity::Modal(4),
        Fidelity::Small(4),
        Fidelity::Modal(10),
        Fidelity::Rigid,
        Fidelity::Point,
    ] {
        for dimension in [2, 3] {
            let (body, cable) = modal(dimension, 4, 30.0, fidelity);
            let (k, d) = (body.modes(), dimension);
            let s = if d == 2 { 1 } else { 3 };
            let b = d + s;
            let action = frame(dimension);
            let [p, v, a] = motion(&body, 0.3);
            let values = [
                action.acceleration.as_slice()[..d].to_vec(),
                action.spin.as_slice()[..s].to_vec(),
                action.spin_rate.as_slice()[..s].to_vec(),
                p,
                v,
                a,
            ];
            let made = |values: &[Vec<f64>]| {
                let three = |part: &Vec<f64>| Vector::from_fn(|i, _| part.get(i).copied().unwrap_or(0.0));
                FrameAction {
                    acceleration: three(&values[0]),
                    spin: three(&values[1]),
                    spin_rate: three(&values[2]),
                }
            };
            let call = |values: &[Vec<f64>]| {
                let mut out = vec![0.0; b + k];
                let at = [&values[3][..], &values[4], &values[5]];
                body.carried(&made(values), at, &mut out[..b]);
                body.force(&cable, &made(values), at, &mut out[b..]);
                out
            };
            let mut carried = CarriedTangent::default();
            let at = [&values[3][..], &values[4], &values[5]];
            body.carried_tangent(&made(&values), at, &mut carried);
            let (mut stiffness, mut damping) = (vec![0.0; k * k], vec![0.0; k * k]);
            body.tangent(&cable, &made(&values), [at[0], at[1]], &mut stiffness, &mut damping);
            let column = |matrix: &[f64], width: usize, place: usize| -> Vec<f64> {
                matrix.iter().skip(place).step_by(width.max(1)).copied().collect()
            };
            let check = |which: usize, expected: &dyn Fn(usize) -> Vec<f64>| {
                for (place, found) in differences(&values, call, which).iter().enumerate() {
                    let expected = expected(place);
                    let size = largest(&expected).max(1.0);
                    for (row, (x, y)) in found.iter().zip(&expected).enumerate() {
                        let difference = (x - y).abs() / size;
                        assert!(difference < 1e-9, "{fidelity:?} {d} {which} {place} row {row}: {x} {y}");
                    }
                }
            };
            let with_modes = |mass_row: usize, frame: Vec<f64>| {
                let transposed = (0..k).map(|i| carried.mass[mass_row * (b + k) + b + i]);
                frame.into_iter().chain(transposed).collect::<Vec<f64>>()
            };
            check(0, &|place| with_modes(place, column(&carried.mass, b + k, place)));
            check(2, &|place| {
                with_modes(d + place, column(&carried.mass, b + k, d + place))
            });
            check(1, &|place| {
                [column(&carried.damping, s + k, place), column(&carried.spin, s, place)].concat()
            });
            check(3, &|place| {
                [column(&carried.stiffness, k, place), column(&stiffness, k, place)].concat()
            });
            check(4, &|place| {
                [column(&carried.damping, s + k, s + place), column(&damping, k, place)].concat()
            });
            check(5, &|place| {
                [column(&carried.mass, b + k, b + place), column(body.mass(), k, place)].concat()
            });
        }
    }
}

#[test]
fn constants_and_elements_give_the_same_elastic_force() {
    let (body, cable) = modal(3, 6, 1e4, Fidelity::Modal(6));
    assert!(matches!(body.elastic, Elastic::Expanded { damping: Some(_), .. }));
    let [p, v, _] = motion(&body, 0.3);
    let [mut force, mut projected] = [vec![0.0; 6], vec![0.0; 6]];
    body.elastic_force(&cable, &p, &v, &mut force);
    body.projected_force(&cable, &p, &v, &mut projected);
    close(&force, &projected, 1e-11);
    let mut matrices = [(); 4].map(|()| vec![0.0; 36]);
    let [k, c, other_k, other_c] = &mut matrices;
    body.elastic_tangent(&cable, &p, &v, k, c);
    body.projected_tangent(&cable, &p, &v, other_k, other_c);
    close(k, other_k, 1e-11);
    close(c, other_c, 1e-11);
}

/// An energy that is no polynomial: the exponent of the bending term does not matter here.
struct Stiffening(Cable);

impl Elements for Stiffening {
    fn force(&self, element: usize, q: &[f64], v: &[f64], force: &mut [f64]) {
        let mut plain = vec![0.0; force.len()];
        self.0.force(element, q, v, &mut plain);
        let factor = q[q.len() - 1].cosh();
        force
            .iter_mut()
            .zip(&plain)
            .for_each(|(sum, value)| *sum += factor * value);
    }
    fn tangent(&self, element: usize, q: &[f64], v: &[f64], stiffness: &mut [f64], damping: &mut [f64]) {
        self.0.tangent(element, q, v, stiffness, damping);
    }
}

#[test]
fn what_is_no_polynomial_is_projected() {
    let (nodal, cable) = cantilever(3, 4, 1e4, 0.0, 0.0);
    let body = ModalBody::new(nodal, Fidelity::Modal(3), &Stiffening(cable)).unwrap();
    assert!(matches!(body.elastic, Elastic::Elements));
}

#[test]
fn a_cantilever_has_its_natural_frequencies() {
    let exact = [3.516_02, 22.034_49, 61.697_21];
    let (body, _) = modal(2, 16, 1e8, Fidelity::Modal(3));
    for (frequency, exact) in body.frequencies.iter().zip(exact) {
        assert!((frequency / exact - 1.0).abs() < 1e-4, "{frequency} {exact}");
    }
    // THEORY 8: the third mode of this mesh.
    assert!((body.frequencies[2] - 61.699_67).abs() < 2e-3, "{:?}", body.frequencies);
    let (body, _) = modal(3, 16, 1e8, Fidelity::Modal(4));
    let [a, b, c, d] = body.frequencies[..] else {
        panic!("four modes");
    };
    assert!((a / b - 1.0).abs() < 1e-9 && (c / d - 1.0).abs() < 1e-9 && (a / exact[0] - 1.0).abs() < 1e-4);
    // Of equal modes the first moves the tip along the second axis alone, upwards.
    let tip = body.nodal.shape.len() - 6;
    let part = |axis: usize, mode: usize| body.mode_row(tip + axis)[mode];
    assert!(part(1, 0) > 1.9 && part(2, 0).abs() < 1e-8 && part(2, 1) > 1.9 && part(1, 1).abs() < 1e-8);
}

#[test]
fn small_deformations_agree_to_first_order() {
    let [small, modal_body] = [Fidelity::Small(6), Fidelity::Modal(6)].map(|fidelity| modal(3, 6, 1e3, fidelity));
    let rest = FrameAction::default();
    let difference = |part: f64| {
        let [p, v, a] = motion(&modal_body.0, part);
        let [mut linear, mut whole] = [vec![0.0; 6], vec![0.0; 6]];
        small.0.force(&small.1, &rest, [&p, &v, &a], &mut linear);
        modal_body.0.force(&modal_body.1, &rest, [&p, &v, &a], &mut whole);
        let gap: Vec<f64> = linear.iter().zip(&whole).map(|(a, b)| a - b).collect();
        largest(&gap) / largest(&whole)
    };
    let (coarse, fine) = (difference(1e-4), difference(1e-5));
    assert!(coarse > 0.0 && fine < 0.12 * coarse && fine < 1e-3, "{coarse} {fine}");
    // Force and moment on a turning frame at the undeformed shape are the same.
    let still = vec![0.0; 6];
    let v = motion(&small.0, 1.0)[1].clone();
    let [mut first, mut second] = [vec![0.0; 6], vec![0.0; 6]];
    small.0.carried(&frame(3), [&still, &v, &v], &mut first);
    modal_body.0.carried(&frame(3), [&still, &v, &v], &mut second);
    close(&first, &second, 1e-14);
}

fn spinning(eta: f64) -> FrameAction {
    FrameAction {
        spin: Vector::new(eta, 0.0, 0.0),
        ..FrameAction::default()
    }
}

#[test]
fn a_rotor_of_too_few_modes_is_reported() {
    let loss = |fidelity: Fidelity, eta: f64| {
        let (nodal, cable) = cantilever(2, 6, 1e5, 0.0, 0.0);
        let body = ModalBody::new(nodal, fidelity, &cable).unwrap();
        let p = vec![0.0; body.modes()];
        body.loss_of_stiffness(&cable, &spinning(eta), &p)
    };
    for fidelity in [Fidelity::Modal(3), Fidelity::Small(3)] {
        let found = loss(fidelity, 3.5).unwrap();
        // 1 - eta^2 / 3.51602^2, and the lag frequency 3.817 of THEORY 8 between eta = 3 and 4.
        assert!((found.remaining - 0.009_09).abs() < 2e-4, "{found}");
        assert!((found.whole - (3.817f64 / 3.516_02).powi(2)).abs() < 0.06, "{found}");
        let message = found.to_string();
        assert!(message.contains("body `arm`") && message.contains("3.5000 rad/s") && message.contains("leave"));
        assert_eq!(loss(fidelity, 1.0), None);
        assert!(loss(fidelity, 12.0).is_some());
    }
    // With all modes the body stretches and stiffens as it does in truth.
    for eta in [3.5, 12.0] {
        assert_eq!(loss(Fidelity::Modal(25), eta), None);
    }
}

/// Flap of a rotor without hub radius stiffens with 1.193 eta^2 (Southwell), and nothing softens it; lag has the same tension.
#[test]
fn flap_without_tension_is_reported() {
    let (nodal, cable) = cantilever(3, 6, 1e5, 0.0, 0.0);
    for fidelity in [Fidelity::Modal(4), Fidelity::Small(4)] {
        let body = ModalBody::new(nodal.clone(), fidelity, &cable).unwrap();
        let lack = |eta: f64| {
            let action = FrameAction {
                spin: Vector::new(0.0, 0.0, eta),
                ..FrameAction::default()
            };
            body.lack_of_tension(&cable, &action)
        };
        let found = lack(3.0).unwrap();
        let tension = found.whole - found.remaining;
        assert!((tension - 1.193 * 9.0 / 3.516_02f64.powi(2)).abs() < 0.02, "{found}");
        assert_eq!(lack(1.0), None);
    }
    // Those of a shaft carry no tension.
    let body = ModalBody::new(nodal, Fidelity::Modal(4), &cable).unwrap();
    assert_eq!(body.lack_of_tension(&cable, &spinning(3.0)), None);
}

#[test]
fn a_shaft_that_truly_softens_is_not_reported() {
    let (nodal, cable) = cantilever(3, 6, 1e5, 0.0, 0.0);
    let body = ModalBody::new(nodal, Fidelity::Modal(4), &cable).unwrap();
    let action = FrameAction {
        spin: Vector::new(3.4, 0.0, 0.0),
        ..FrameAction::default()
    };
    assert_eq!(body.loss_of_stiffness(&cable, &action, &[0.0; 4]), None);
}

#[test]
fn joints_carry_all_of_a_load() {
    for (dimension, bend) in [(3, 0.0), (2, 0.0), (2, 0.3)] {
        let (body, cable) = modal(dimension, 5, 1e4, Fidelity::Modal(2));
        let nodal = &body.nodal;
        let mut q = vec![0.0; nodal.shape.len()];
        body.expand(&[bend * body.sizes()[0], -bend * body.sizes()[1]], &mut q);
        let load: Vec<f64> = numbers(q.len(), 5);
        let places = nodal.vectors(&mut q.iter().copied());
        let total = |force: &[f64]| {
            let force = nodal.vectors(&mut force.iter().copied());
            let sum = force
                .iter()
                .zip(&nodal.whole)
                .fold(Vector::zeros(), |sum, (&f, &c)| sum + c * f);
            let moment = force
                .iter()
                .zip(&places)
                .fold(Vector::zeros(), |sum, (&f, &q)| sum + q.cross(&f));
            [sum, moment].map(<[f64; 3]>::from).concat()
        };
        let mut force = load.clone();
        let carried = body.held(&cable, &q, &mut force);
        // Round-off comes with the bending stiffness of one element.
        close(&total(&force), &total(&load), 1e-9);
        assert!(largest(&nodal.reduced(&force)) < 1e-8);
        // The elements carry it.
        for (&component, value) in nodal.connectivity.components.iter().zip(carried) {
            force[component] -= value;
        }
        close(&force, &load, 1e-9);
    }
}

#[test]
fn bad_requests_are_refused_by_name() {
    let (nodal, cable) = cantilever(2, 2, 1e3, 0.0, 0.0);
    let error = ModalBody::new(nodal.clone(), Fidelity::Modal(10), &cable).unwrap_err();
    assert!(
        error.message.contains("`arm`") && error.message.contains("9 freedoms"),
        "{error}"
    );
    let mut loose = nodal;
    loose.map[3] = vec![(9, 1.0)];
    loose.freedoms = 10;
    let error = ModalBody::new(loose.clone(), Fidelity::Small(2), &cable).unwrap_err();
    assert!(
        error.message.contains("`arm`") && error.message.contains("without stiffness"),
        "{error}"
    );
    let rigid = ModalBody::new(loose, Fidelity::Rigid, &cable).unwrap();
    assert_eq!(rigid.modes(), 0);
}

#[test]
fn a_rigid_rod_has_its_moment_of_inertia() {
    let (nodal, cable) = cantilever(3, 3, 1e3, 0.0, 0.0);
    let body = ModalBody::new(nodal, Fidelity::Rigid, &cable).unwrap();
    let action = FrameAction {
        spin_rate: Vector::new(2.0, 0.0, 3.0),
        ..FrameAction::default()
    };
    let mut carried = [0.0; 6];
    body.carried(&action, [&[], &[], &[]], &mut carried);
    let inertia: Matrix = from_rows(&[[0.0; 3], [0.0, 1.0 / 3.0, 0.0], [0.0, 0.0, 1.0 / 3.0]]);
    let moment = inertia * action.spin_rate;
    close(&carried, &[0.0, 1.5, 0.0, moment[0], moment[1], moment[2]], 1e-14);
}
