//! The ten-vector beam: generated code against the reference's plain loops over run-time sizes.

use std::hint::black_box;

use rncf_models::motor_equations as motor;
use rncf_models::{princeton_beam_equations as straight, roll_up_equations as planar};
use rncf_reference::element::Weights;
use rncf_reference::inertia::{Frame, State};
use rncf_reference::section_beam::{Element, Properties, Section, residual_and_jacobian};
use rncf_reference::section_inertia::MovingElement;

use super::{scene, time};

const LENGTH: f64 = 0.255;
const DAMPING: f64 = 1e-6;

/// The shaft of the motor.
fn section() -> Section {
    Section::circle(0.05, 210e9, 0.3, 7800.0)
}

/// A bent, stretched and sheared element, its velocities and accelerations.
fn shape<const N: usize>() -> [[f64; N]; 3] {
    let straight: &[f64] = if N == 14 {
        &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, LENGTH, 0.0, 1.0, 0.0, 0.0, 1.0]
    } else {
        &[
            0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, LENGTH, 0.0, 0.0,
            1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0,
        ]
    };
    let q: [f64; N] = std::array::from_fn(|i| straight[i] + 0.01 * (i as f64).sin());
    [q, q.map(|x| 0.1 * x), q.map(|x| -0.3 * x)]
}

/// What, nanoseconds of the generated code and of the loops: elastic forces and tangents alone, and in a scene with inertia
/// against loops with it.
pub fn rows() -> Vec<(&'static str, [f64; 2])> {
    vec![
        ("ten vectors, elastic", [spatial(), elastic_loops::<30>(0.0)]),
        ("ten vectors, in a scene", [scene::strip(), loops::<30>(0.0)]),
        ("ten vectors, damped, elastic", [damped(), elastic_loops::<30>(DAMPING)]),
        (
            "ten vectors, damped, in a scene",
            [scene::shaft(), loops::<30>(DAMPING)],
        ),
        ("seven vectors, elastic", [plane(), elastic_loops::<14>(0.0)]),
        ("seven vectors, in a scene", [scene::plane(), loops::<14>(0.0)]),
    ]
}

/// The motor's shaft.
fn damped_row() -> motor::BeamSpatialDamped {
    let section = section();
    let axis = section.structural();
    let [bending_z, bending_y, torsion, shear_z, shear_y, shear_yz] = section.gradients();
    motor::BeamSpatialDamped {
        length: LENGTH,
        EA: axis[0][0],
        kyGA: axis[3][3],
        kzGA: axis[4][4],
        halfEA: axis[5][5],
        EIz: bending_z,
        EIy: bending_y,
        GJ: torsion,
        GIz: shear_z,
        GIy: shear_y,
        GIyz: shear_yz,
        rhoA: section.density * section.area,
        rhoIz: section.density * section.i_zz,
        rhoIy: section.density * section.i_yy,
        damping: DAMPING,
    }
}

fn spatial() -> f64 {
    let shaft = damped_row();
    let row = straight::BeamSpatial {
        length: LENGTH,
        EA: shaft.EA,
        kyGA: shaft.kyGA,
        kzGA: shaft.kzGA,
        halfEA: shaft.halfEA,
        EIz: shaft.EIz,
        EIy: shaft.EIy,
        GJ: shaft.GJ,
        GIz: shaft.GIz,
        GIy: shaft.GIy,
        GIyz: shaft.GIyz,
        rhoA: shaft.rhoA,
        rhoIz: shaft.rhoIz,
        rhoIy: shaft.rhoIy,
    };
    let [q, ..] = shape::<30>();
    let (mut force, mut stiffness) = ([0.0; 30], [0.0; 900]);
    time(|| {
        force.fill(0.0);
        stiffness.fill(0.0);
        let (row, q) = (black_box(&row), black_box(&q));
        straight::beam_spatial_elastic_force(row, q, &mut force);
        straight::beam_spatial_elastic_tangent(row, q, &mut stiffness);
        black_box((&force, &stiffness));
    })
}

fn damped() -> f64 {
    let row = damped_row();
    let [q, v, _] = shape::<30>();
    let (mut force, mut stiffness, mut damping) = ([0.0; 30], [0.0; 900], [0.0; 900]);
    time(|| {
        force.fill(0.0);
        stiffness.fill(0.0);
        damping.fill(0.0);
        let (row, q, v) = (black_box(&row), black_box(&q), black_box(&v));
        motor::beam_spatial_damped_elastic_force(row, q, v, &mut force);
        motor::beam_spatial_damped_elastic_tangent(row, q, v, &mut stiffness, &mut damping);
        black_box((&force, &stiffness, &damping));
    })
}

fn plane() -> f64 {
    let shaft = damped_row();
    let row = planar::BeamPlanar {
        length: LENGTH,
        EA: shaft.EA,
        kyGA: shaft.kyGA,
        EIz: shaft.EIz,
        GIz: shaft.GIz,
        rhoA: shaft.rhoA,
        rhoIz: shaft.rhoIz,
    };
    let [q, ..] = shape::<14>();
    let (mut force, mut stiffness) = ([0.0; 14], [0.0; 196]);
    time(|| {
        force.fill(0.0);
        stiffness.fill(0.0);
        let (row, q) = (black_box(&row), black_box(&q));
        planar::beam_planar_elastic_force(row, q, &mut force);
        planar::beam_planar_elastic_tangent(row, q, &mut stiffness);
        black_box((&force, &stiffness));
    })
}

/// The same element in the reference; the compiler does not know its sizes.
fn reference<const N: usize>(damping: f64) -> Element {
    let dimension = if N == 14 { 2 } else { 3 };
    let properties = Properties {
        damping,
        ..Properties::structural(black_box(dimension), LENGTH, &section())
    };
    Element::straight(properties).unwrap()
}

fn elastic_loops<const N: usize>(damping: f64) -> f64 {
    let (element, [q, v, _]) = (reference::<N>(damping), shape::<N>());
    let (mut force, mut k, mut c) = (vec![0.0; N], vec![0.0; N * N], vec![0.0; N * N]);
    time(|| {
        residual_and_jacobian(black_box(&q), black_box(&v), &element, &mut force, &mut k, &mut c);
        black_box((&force, &k, &c));
    })
}

fn loops<const N: usize>(damping: f64) -> f64 {
    let mut element = MovingElement::new(reference::<N>(damping)).unwrap();
    let [q, qd, qdd] = shape::<N>();
    let frame = Frame {
        spin: [4.0, 0.0, 0.0],
        spin_rate: [0.5, 0.0, 0.0],
        origin_acceleration: [0.1, 0.2, 0.3],
    };
    let (mut residual, mut jacobian) = (vec![0.0; N], vec![0.0; N * N]);
    time(|| {
        let state = State {
            q: black_box(&q),
            qd: black_box(&qd),
            qdd: black_box(&qdd),
        };
        element.residual_and_jacobian(
            state,
            black_box(&frame),
            Weights::POSITION,
            &mut residual,
            &mut jacobian,
        );
        black_box((&residual, &jacobian));
    })
}
