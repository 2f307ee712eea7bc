//! A whole scene: elastic kernels in lanes, inertia at the level of nodal vectors, assembly and elimination.

use std::hint::black_box;

use rncf::{Formulation, Joints, Model};
use rncf_models::{Motor, PrincetonBeam, RollUp, SpinUp, SpinUpSpatial};

use super::time;

/// Elements of a scene.
const ELEMENTS: usize = 64;

/// Nanoseconds of residual and matrix of the iteration for one of the elements.
fn element(model: &impl Model) -> f64 {
    let mut scene = model
        .build(Formulation::Rncf, Joints::Eliminated)
        .expect("the model is right");
    let state = scene.rest(7.0);
    let mut out = vec![0.0; scene.unknowns()];
    let mut matrix = vec![0.0; scene.pattern().entries()];
    let all = time(|| {
        scene.residual(black_box(&state), &mut out);
        scene.iteration_matrix(black_box(&state), [1.0, 1e-2, 1e-4], &mut matrix);
        black_box((&out, &matrix));
    });
    all / ELEMENTS as f64
}

/// Of the spin-up's beam.
pub fn centre_line(dimension: usize) -> f64 {
    let elements = ELEMENTS;
    if dimension == 2 {
        element(&SpinUp {
            elements,
            ..SpinUp::default()
        })
    } else {
        element(&SpinUpSpatial {
            elements,
            ..SpinUpSpatial::default()
        })
    }
}

/// Of a strip, ten vectors.
pub fn strip() -> f64 {
    element(&PrincetonBeam {
        elements: ELEMENTS,
        ..PrincetonBeam::default()
    })
}

/// Of the motor's shaft, ten vectors, damped.
pub fn shaft() -> f64 {
    element(&Motor {
        elements: ELEMENTS,
        ..Motor::default()
    })
}

/// Of a beam in a plane, seven vectors.
pub fn plane() -> f64 {
    element(&RollUp {
        elements: ELEMENTS,
        ..RollUp::default()
    })
}
