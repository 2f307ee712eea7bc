//! Compiled mass matrices against integrals of the compiled shape functions.

use rncf_models::{motor_equations as shaft, roll_up_equations as strip};
use rncf_models::{spin_up_equations as planar, spin_up_spatial_equations as spatial};

/// Gauss points and weights on [0, 1], exact for polynomials of degree seven.
const RULE: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// Weights of an element's nodal vectors in an interpolant: length, xi, weights.
type Shapes<const N: usize> = fn(f64, f64, &mut [f64; N]);

/// `M_ab = l sum_i m_i int s_a s_b dxi` over interpolants with their masses per length.
#[track_caller]
fn check<const N: usize>(length: f64, mass: &[f64], interpolants: &[(f64, Shapes<N>)]) {
    let mut expected = vec![0.0; N * N];
    for &(density, shapes) in interpolants {
        for (xi, weight) in RULE {
            let mut values = [0.0; N];
            shapes(length, xi, &mut values);
            for (place, sum) in expected.iter_mut().enumerate() {
                *sum += density * length * weight * values[place / N] * values[place % N];
            }
        }
    }
    let size = expected.iter().fold(0.0, |size: f64, value| size.max(value.abs()));
    assert!(size > 0.0);
    for (place, (found, expected)) in mass.iter().zip(&expected).enumerate() {
        assert!(
            (found - expected).abs() < 1e-14 * size,
            "({}, {}): {found} instead of {expected}",
            place / N,
            place % N
        );
    }
}

const LENGTH: f64 = 0.7;

#[test]
fn of_centre_lines() {
    let row = planar::CablePlanar {
        length: LENGTH,
        rhoA: 0.44,
        ..Default::default()
    };
    let mut mass = [0.0; 16];
    planar::cable_planar_mass(&row, &mut mass);
    check(LENGTH, &mass, &[(row.rhoA, planar::cable_planar_shapes_position_0)]);
    let row = spatial::CableSpatial {
        length: LENGTH,
        rhoA: 0.44,
        ..Default::default()
    };
    spatial::cable_spatial_mass(&row, &mut mass);
    check(LENGTH, &mass, &[(row.rhoA, spatial::cable_spatial_shapes_position_0)]);
}

#[test]
fn of_beams_with_sections() {
    let row = strip::BeamPlanar {
        length: LENGTH,
        rhoA: 0.44,
        rhoIz: 0.03,
        ..Default::default()
    };
    let mut mass = [0.0; 49];
    strip::beam_planar_mass(&row, &mut mass);
    let interpolants: [(f64, Shapes<7>); 2] = [
        (row.rhoA, strip::beam_planar_shapes_position_0),
        (row.rhoIz, strip::beam_planar_shapes_section_y_0),
    ];
    check(LENGTH, &mass, &interpolants);
    let row = shaft::BeamSpatialDamped {
        length: LENGTH,
        rhoA: 0.44,
        rhoIz: 0.03,
        rhoIy: 0.02,
        ..Default::default()
    };
    let mut mass = [0.0; 100];
    shaft::beam_spatial_damped_mass(&row, &mut mass);
    let interpolants: [(f64, Shapes<10>); 3] = [
        (row.rhoA, shaft::beam_spatial_damped_shapes_position_0),
        (row.rhoIz, shaft::beam_spatial_damped_shapes_section_y_0),
        (row.rhoIy, shaft::beam_spatial_damped_shapes_section_z_0),
    ];
    check(LENGTH, &mass, &interpolants);
}
