//! The ten-vector beam: compiled kernels against the plain loops of the reference, and its tangents
//! against complex steps through another form of its energy.

use std::collections::HashMap;

use rncf_codegen::elements::Library;
use rncf_codegen::lower::Variant;
use rncf_codegen::lower::elastic::kernel;
use rncf_codegen::lower::form::{Form, Quantity};
use rncf_codegen::model::{Evaluation, Quadrature};
use rncf_reference::section_beam::{Element, Properties, Section, residual_and_jacobian};

use crate::jacobians::{Random, assert_close, jacobian};
use crate::materials::rank;

rncf::model! {
    /// Damped, straight, in space, each strain for itself.
    pub model DampedBeam {
        material rubber { density = 1100 kg/m^3; young = 10 MPa; poisson = 0.45; damping = 2 ms; }
        section bar = rectangle(y = 40 mm, z = 20 mm);
        body strip in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0.5, 0.2] m;
            mesh 3 * beam(bar, rubber);
        }
        joint root = clamp(strip.start, inertial);
        output tip = strip.end;
    }
}

rncf::model! {
    /// Damped, twisted, in space, with lateral contraction.
    pub model TwistedBeam {
        material rubber { density = 1100 kg/m^3; young = 10 MPa; poisson = 0.45; damping = 2 ms; }
        section bar = rectangle(y = 40 mm, z = 20 mm);
        body strip in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0.5, 0.2] m;
            twist 30 deg;
            mesh 3 * beam(bar, rubber, coupling = poisson);
        }
        joint root = clamp(strip.start, inertial);
        output tip = strip.end;
    }
}

rncf::model! {
    /// Undamped, straight, in space and in the plane.
    pub model Beams {
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        body shaft in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 2 * beam(round, steel);
        }
        body strip in inertial {
            planar xy;
            line from [0, 1, 0] m to [1, 1, 0] m;
            mesh 2 * beam(round, steel);
        }
        joint root = clamp(shaft.start, inertial);
        joint base = clamp(strip.start, inertial);
        output tip = shaft.end;
        output strip_tip = strip.end;
    }
}

/// Bulky enough that no term is small beside the others.
const SECTION: Section = Section {
    young: 2.1e4,
    poisson: 0.3,
    density: 7.8,
    area: 0.3,
    i_zz: 0.02,
    i_yy: 0.01,
    torsion: 0.025,
    shear_factor: 0.86,
};
const LENGTH: f64 = 0.7;
const DAMPING: f64 = 0.02;

/// A straight element along x.
fn straight(dimension: usize) -> Vec<f64> {
    let (e, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let far = [LENGTH, 0.0, 0.0];
    let vectors = if dimension == 3 {
        vec![[0.0; 3], e, y, z, y, z, far, e, y, z]
    } else {
        vec![[0.0; 3], e, y, y, far, e, y]
    };
    vectors.iter().flat_map(|vector| vector[..dimension].to_vec()).collect()
}

fn bent(dimension: usize, by: f64, random: &mut Random) -> Vec<f64> {
    straight(dimension).iter().map(|x| x + by * random.next()).collect()
}

/// Value of a coefficient of the element.
fn value(name: &str) -> f64 {
    let (s, e, g) = (SECTION, SECTION.young, SECTION.shear());
    match name {
        "EA" => e * s.area,
        "lambdaA" => (s.confined() - 2.0 * g) * s.area,
        "twoGA" => 2.0 * g * s.area,
        "kyGA" | "kzGA" => s.shear_factor * g * s.area,
        "GA" => g * s.area,
        "EIz" => e * s.i_zz,
        "EIy" => e * s.i_yy,
        "GJ" => g * s.torsion,
        "GIz" => g * s.i_zz,
        "GIy" => g * s.i_yy,
        "GIyz" => 0.25 * g * (s.i_yy + s.i_zz),
        "halfEA" => 0.5 * e * s.area,
        "length" => LENGTH,
        _ => panic!("{name}"),
    }
}

/// Force, stiffness and damping matrix of one element.
type Response = [Vec<f64>; 3];

#[track_caller]
fn assert_equal(what: &str, found: &[f64], wanted: &[f64]) {
    let scale = wanted.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (index, (&found, &wanted)) in found.iter().zip(wanted).enumerate() {
        assert!(
            (found - wanted).abs() <= 1e-13 * scale,
            "{what} {index}: {found} instead of {wanted}"
        );
    }
}

/// Against the reference: the derivatives there are other formulas.
fn against_loops(properties: Properties, shape: Option<&[f64]>, q: &[f64], v: &[f64], found: &Response) {
    let element = match shape {
        Some(shape) => Element::stress_free_at(properties, shape).unwrap(),
        None => Element::straight(properties).unwrap(),
    };
    let size = q.len();
    let mut wanted: Response = [vec![0.0; size], vec![0.0; size * size], vec![0.0; size * size]];
    let [force, k, c] = &mut wanted;
    residual_and_jacobian(q, v, &element, force, k, c);
    for (place, what) in ["force", "stiffness", "damping"].into_iter().enumerate() {
        assert_equal(what, &found[place], &wanted[place]);
    }
}

/// Against complex steps through the residual by unrolled points.
fn against_steps(variant: &Variant, reference: &[f64], q: &[f64], v: &[f64], found: &Response) {
    let library = Library::standard();
    let mut inputs: HashMap<String, f64> = HashMap::from([("damping".to_string(), DAMPING)]);
    let element = variant.declaration(&library);
    for coefficient in element.coefficients_in(variant.dimension, &variant.options) {
        if !coefficient.name.starts_with("rho") {
            inputs.insert(coefficient.name.to_string(), value(coefficient.name));
        }
    }
    inputs.insert("length".to_string(), LENGTH);
    for (index, &value) in reference.iter().enumerate() {
        inputs.insert(format!("reference[{index}]"), value);
    }
    let names = ["", "v_"].map(|prefix| variant.component_names(&library, prefix).concat());
    inputs.extend(names[0].iter().cloned().zip(q.iter().copied()));
    inputs.extend(names[1].iter().cloned().zip(v.iter().copied()));
    let force = kernel(variant, &library, Form::Points, Quantity::Force).unwrap();
    assert_close("stiffness", &found[1], &jacobian(&force, &inputs, &names[0]));
    if variant.damped {
        assert_close("damping", &found[2], &jacobian(&force, &inputs, &names[1]));
    }
}

fn variant(dimension: usize, coupling: usize, damped: bool, curved: bool) -> Variant {
    Variant {
        element: Library::standard()
            .find("beam")
            .map(rncf_codegen::model::ElementId)
            .unwrap(),
        dimension,
        options: vec![coupling],
        quadrature: Quadrature::Exact,
        evaluation: Evaluation::Automatic,
        damped,
        curved,
        varying: false,
        material: None,
    }
}

#[test]
fn damped_in_space() {
    use damped_beam_equations as kernels;
    let row = kernels::BeamSpatialDamped {
        length: LENGTH,
        EA: value("EA"),
        kyGA: value("kyGA"),
        kzGA: value("kzGA"),
        halfEA: value("halfEA"),
        EIz: value("EIz"),
        EIy: value("EIy"),
        GJ: value("GJ"),
        GIz: value("GIz"),
        GIy: value("GIy"),
        GIyz: value("GIyz"),
        damping: DAMPING,
        ..Default::default()
    };
    let mut random = Random(5);
    let q: [f64; 30] = bent(3, 0.2, &mut random).try_into().unwrap();
    let v: [f64; 30] = std::array::from_fn(|_| random.next());
    let (mut force, mut k, mut c) = ([0.0; 30], [0.0; 900], [0.0; 900]);
    kernels::beam_spatial_damped_elastic_force(&row, &q, &v, &mut force);
    kernels::beam_spatial_damped_elastic_tangent(&row, &q, &v, &mut k, &mut c);
    let found = [force.to_vec(), k.to_vec(), c.to_vec()];
    let properties = Properties {
        damping: DAMPING,
        ..Properties::structural(3, LENGTH, &SECTION)
    };
    against_loops(properties, None, &q, &v, &found);
    against_steps(&variant(3, 0, true, false), &[], &q, &v, &found);
    let mut energy = 0.0;
    kernels::beam_spatial_damped_strain_energy(&row, &q, &mut energy);
    let wanted = Element::straight(properties).unwrap().energy(&q);
    assert!((energy / wanted - 1.0).abs() < 1e-13, "{energy} {wanted}");
}

#[test]
fn twisted_with_lateral_contraction() {
    use twisted_beam_equations as kernels;
    let row = kernels::BeamSpatialPoissonCurvedDamped {
        length: LENGTH,
        lambdaA: value("lambdaA"),
        twoGA: value("twoGA"),
        kyGA: value("kyGA"),
        kzGA: value("kzGA"),
        GA: value("GA"),
        EIz: value("EIz"),
        EIy: value("EIy"),
        GJ: value("GJ"),
        GIz: value("GIz"),
        GIy: value("GIy"),
        GIyz: value("GIyz"),
        damping: DAMPING,
        ..Default::default()
    };
    let mut random = Random(6);
    let shape: [f64; 30] = bent(3, 0.1, &mut random).try_into().unwrap();
    let q: [f64; 30] = bent(3, 0.2, &mut random).try_into().unwrap();
    let v: [f64; 30] = std::array::from_fn(|_| random.next());
    let mut reference = [0.0; 33];
    kernels::beam_spatial_poisson_curved_damped_reference(&row, &shape, &mut reference);
    let (mut force, mut k, mut c) = ([0.0; 30], [0.0; 900], [0.0; 900]);
    kernels::beam_spatial_poisson_curved_damped_elastic_force(&row, &reference, &q, &v, &mut force);
    kernels::beam_spatial_poisson_curved_damped_elastic_tangent(&row, &reference, &q, &v, &mut k, &mut c);
    let found = [force.to_vec(), k.to_vec(), c.to_vec()];
    let properties = Properties {
        damping: DAMPING,
        ..Properties::coupled(3, LENGTH, &SECTION)
    };
    against_loops(properties, Some(&shape), &q, &v, &found);
    against_steps(&variant(3, 1, true, true), &reference, &q, &v, &found);
    // Where nothing is deformed there is neither force nor energy.
    let (mut rest, mut energy) = ([0.0; 30], 0.0);
    kernels::beam_spatial_poisson_curved_damped_elastic_force(&row, &reference, &shape, &[0.0; 30], &mut rest);
    kernels::beam_spatial_poisson_curved_damped_strain_energy(&row, &reference, &shape, &mut energy);
    assert!(
        rest.iter().all(|x| x.abs() < 1e-9) && energy.abs() < 1e-20,
        "{rest:?} {energy}"
    );
}

/// The undamped kernels write only what is on and above the diagonal of pairs of groups.
#[test]
fn undamped_in_space_and_in_the_plane() {
    use beams_equations as kernels;
    let mut random = Random(7);
    let row = kernels::BeamSpatial {
        length: LENGTH,
        EA: value("EA"),
        kyGA: value("kyGA"),
        kzGA: value("kzGA"),
        halfEA: value("halfEA"),
        EIz: value("EIz"),
        EIy: value("EIy"),
        GJ: value("GJ"),
        GIz: value("GIz"),
        GIy: value("GIy"),
        GIyz: value("GIyz"),
        ..Default::default()
    };
    let q: [f64; 30] = bent(3, 0.2, &mut random).try_into().unwrap();
    let (mut force, mut k) = ([0.0; 30], [0.0; 900]);
    kernels::beam_spatial_elastic_force(&row, &q, &mut force);
    kernels::beam_spatial_elastic_tangent(&row, &q, &mut k);
    let found = [force.to_vec(), k.to_vec(), vec![0.0; 900]];
    against_loops(
        Properties::structural(3, LENGTH, &SECTION),
        None,
        &q,
        &[0.0; 30],
        &found,
    );
    against_steps(&variant(3, 0, false, false), &[], &q, &[0.0; 30], &found);

    // The rigid motions alone leave it free.
    let mut k = [0.0; 900];
    kernels::beam_spatial_elastic_tangent(&row, rncf::emitted::array(&straight(3)), &mut k);
    assert_eq!(30 - rank(k.to_vec(), 30), 6);

    let row = kernels::BeamPlanar {
        length: LENGTH,
        EA: value("EA"),
        kyGA: value("kyGA"),
        EIz: value("EIz"),
        GIz: value("GIz"),
        ..Default::default()
    };
    let q: [f64; 14] = bent(2, 0.2, &mut random).try_into().unwrap();
    let (mut force, mut k) = ([0.0; 14], [0.0; 196]);
    kernels::beam_planar_elastic_force(&row, &q, &mut force);
    kernels::beam_planar_elastic_tangent(&row, &q, &mut k);
    let found = [force.to_vec(), k.to_vec(), vec![0.0; 196]];
    against_loops(
        Properties::structural(2, LENGTH, &SECTION),
        None,
        &q,
        &[0.0; 14],
        &found,
    );
    against_steps(&variant(2, 0, false, false), &[], &q, &[0.0; 14], &found);
    let mut k = [0.0; 196];
    kernels::beam_planar_elastic_tangent(&row, rncf::emitted::array(&straight(2)), &mut k);
    assert_eq!(14 - rank(k.to_vec(), 14), 3);
}
