//! Curved axes of elements that models declare: beside those of the library, and against Castigliano's theorem.

use crate::scenes::at_rest;

rncf::model! {
    /// Quarters of a circle in a plane, clamped at one end and drawn at the other: four elements, three of them the user's own.
    model Quarters {
        param size = 1 m;
        param pull = 1 mN;
        param n: count = 64;
        /// Times which strains are taken: 1, so that params stand there, too.
        param plain = 1;

        /// The library's centre line under another name.
        element wire(section, material) {
            domain xi in 0..1;
            vector r0 = r   at 0, shape 1 - 3*xi^2 + 2*xi^3;
            vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;
            vector r1 = r   at 1, shape 3*xi^2 - 2*xi^3;
            vector s1 = r_x at 1, shape -xi^2 + xi^3;
            field a = r_x;
            field b = r_xx;
            coefficient EA: N      = material.young * section.area;
            coefficient EI: N m^2  = material.young * section.second_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain e = 1/2*(dot(a, a) - 1);
            strain k in plane = cross(a, b);
            energy axial_strain = 1/2*EA*e^2;
            energy bending in plane = 1/2*EI*k^2;
            energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
        }
        /// The same without a strain.
        element products(section, material) {
            domain xi in 0..1;
            vector r0 = r   at 0, shape 1 - 3*xi^2 + 2*xi^3;
            vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;
            vector r1 = r   at 1, shape 3*xi^2 - 2*xi^3;
            vector s1 = r_x at 1, shape -xi^2 + xi^3;
            field a = r_x;
            field b = r_xx;
            coefficient EA: N      = material.young * section.area;
            coefficient EI: N m^2  = material.young * section.second_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            energy axial_strain = 1/8*EA*(dot(a, a) - 1)^2;
            energy bending in plane = 1/2*EI*cross(a, b)^2;
            energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
        }
        /// Position and slope at three nodes.
        element quintic(section, material) {
            domain xi in 0..1;
            vector r0 = r   at 0,   shape (1 + 6*xi)*(1 - 3*xi + 2*xi^2)^2;
            vector s0 = r_x at 0,   shape xi*(1 - 3*xi + 2*xi^2)^2;
            vector rm = r   at 1/2, shape 16*xi^2*(1 - xi)^2;
            vector sm = r_x at 1/2, shape 16*(xi - 1/2)*xi^2*(1 - xi)^2;
            vector r1 = r   at 1,   shape (7 - 6*xi)*(2*xi^2 - xi)^2;
            vector s1 = r_x at 1,   shape (xi - 1)*(2*xi^2 - xi)^2;
            field a = r_x;
            field b = r_xx;
            coefficient EA: N      = material.young * section.area;
            coefficient EI: N m^2  = material.young * section.second_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain e = plain/2*(dot(a, a) - 1);
            strain k in plane = plain*cross(a, b);
            energy axial_strain = 1/2*EA*e^2;
            energy bending in plane = 1/2*EI*k^2;
            energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
        }
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round { area = 1 cm^2; second_moment = 100 mm^4; }
        section cone = circle(radius = 6 mm * (1 - x / 4 [m]));
        body by_cable {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh n * cable(round, steel);
        }
        joint root_of_cable = clamp(by_cable.start, inertial);
        load pull_cable = force(by_cable.end, [pull, 0 N, 0]);
        output x_cable = by_cable.end.x - size;
        output moment_cable = by_cable.start.moment;
        output force_cable = by_cable.start.axial_force;
        output energy_cable = by_cable.strain_energy;
        body by_wire {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh n * wire(round, steel);
        }
        joint root_of_wire = clamp(by_wire.start, inertial);
        load pull_wire = force(by_wire.end, [pull, 0 N, 0]);
        output x_wire = by_wire.end.x - size;
        output moment_wire = by_wire.start.moment;
        output force_wire = by_wire.start.axial_force;
        output energy_wire = by_wire.strain_energy;
        body by_products {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh n * products(round, steel);
        }
        joint root_of_products = clamp(by_products.start, inertial);
        load pull_products = force(by_products.end, [pull, 0 N, 0]);
        output x_products = by_products.end.x - size;
        output moment_products = by_products.start.moment;
        output force_products = by_products.start.axial_force;
        output energy_products = by_products.strain_energy;
        body by_quintic {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh 4 * quintic(round, steel);
        }
        joint root_of_quintic = clamp(by_quintic.start, inertial);
        load pull_quintic = force(by_quintic.end, [pull, 0 N, 0]);
        output x_quintic = by_quintic.end.x - size;
        output moment_quintic = by_quintic.start.moment;
        output force_quintic = by_quintic.start.axial_force;
        output energy_quintic = by_quintic.strain_energy;
        body cone_of_wire {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh 8 * wire(cone, steel);
        }
        joint root_of_cone_of_wire = clamp(cone_of_wire.start, inertial);
        load pull_cone_of_wire = force(cone_of_wire.end, [pull, 0 N, 0]);
        output x_cone_of_wire = cone_of_wire.end.x - size;
        output moment_cone_of_wire = cone_of_wire.start.moment;
        output force_cone_of_wire = cone_of_wire.start.axial_force;
        output energy_cone_of_wire = cone_of_wire.strain_energy;
        body cone_of_products {
            planar xy;
            arc from [0, 0, 0] m direction [1, 0, 0] radius size angle 90 deg;
            mesh 8 * products(cone, steel);
        }
        joint root_of_cone_of_products = clamp(cone_of_products.start, inertial);
        load pull_cone_of_products = force(cone_of_products.end, [pull, 0 N, 0]);
        output x_cone_of_products = cone_of_products.end.x - size;
        output moment_cone_of_products = cone_of_products.start.moment;
        output force_cone_of_products = cone_of_products.start.axial_force;
        output energy_cone_of_products = cone_of_products.strain_energy;
    }
}

rncf::model! {
    /// A quarter of a ring that is drawn along its diameter: neither end turns.
    model Ring {
        param size = 1 m;
        param pull = 1 mN;
        param n: count = 64;
        element products(section, material) {
            domain xi in 0..1;
            vector r0 = r   at 0, shape 1 - 3*xi^2 + 2*xi^3;
            vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;
            vector r1 = r   at 1, shape 3*xi^2 - 2*xi^3;
            vector s1 = r_x at 1, shape -xi^2 + xi^3;
            field a = r_x;
            field b = r_xx;
            coefficient EA: N      = material.young * section.area;
            coefficient EI: N m^2  = material.young * section.second_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            energy axial_strain = 1/8*EA*(dot(a, a) - 1)^2;
            energy bending in plane = 1/2*EI*cross(a, b)^2;
            energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
        }
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round { area = 1 cm^2; second_moment = 100 mm^4; }
        body quarter {
            planar xy;
            curve [size * sin(angle), size * (1 - cos(angle)), 0] for angle from 0 to pi/2;
            mesh n * products(round, steel);
        }
        joint root = clamp(quarter.start, inertial);
        joint upright = hold(quarter.end.slope.x);
        load draw = force(quarter.end, [0 N, pull, 0]);
        output y = quarter.end.y - size;
    }
}

rncf::model! {
    /// Quarters of a circle in space, twisted, with a force across their plane.
    model Bows {
        param size = 1 m;
        param pull = 1 mN;
        param turned = 50 deg;
        param n: count = 24;

        /// The library's beam under another name, with strains of other strains, and one coefficient for both rotary inertias.
        element rod(section, material) {
            domain xi in 0..1;
            vector r0      = r   at 0,   shape 1 - 3*xi^2 + 2*xi^3;
            vector r0x     = r_x at 0,   shape xi - 2*xi^2 + xi^3;
            vector r0y     = r_y at 0,   shape 1 - 3*xi + 2*xi^2;
            vector r0z     = r_z at 0,   shape 1 - 3*xi + 2*xi^2;
            vector ry_half = r_y at 1/2, shape 4*xi - 4*xi^2;
            vector rz_half = r_z at 1/2, shape 4*xi - 4*xi^2;
            vector r1      = r   at 1,   shape 3*xi^2 - 2*xi^3;
            vector r1x     = r_x at 1,   shape -xi^2 + xi^3;
            vector r1y     = r_y at 1,   shape -xi + 2*xi^2;
            vector r1z     = r_z at 1,   shape -xi + 2*xi^2;
            field a  = r_x;
            field b  = r_y;
            field c  = r_z;
            field db = r_yx;
            field dc = r_zx;
            coefficient EA: N = material.young * section.area;
            coefficient kyGA: N = section.shear_factor_y * material.shear_modulus * section.area;
            coefficient kzGA: N = section.shear_factor_z * material.shear_modulus * section.area;
            coefficient halfEA: N = material.half_young * section.area;
            coefficient EIz: N m^2 = material.young * section.second_moment_z;
            coefficient EIy: N m^2 = material.young * section.second_moment_y;
            coefficient GJ: N m^2 = material.shear_modulus * section.torsion_constant;
            coefficient GIz: N m^2 = material.shear_modulus * section.second_moment_z;
            coefficient GIy: N m^2 = material.shear_modulus * section.second_moment_y;
            coefficient GIyz: N m^2 = material.shear_modulus * section.quarter_polar_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            coefficient rhoI: kg m = material.density * section.second_moment_z;
            inertia r = rhoA;
            inertia r_y = rhoI;
            inertia r_z = rhoI;
            strain half = 1/4*(dot(a, a) - 1);
            strain ex = half + half;
            strain ey = 1/2*(dot(b, b) - 1);
            strain ez = 1/2*(dot(c, c) - 1);
            strain gy = dot(a, b);
            strain gz = dot(a, c);
            strain gyz = dot(b, c);
            strain kz = dot(a, db);
            strain ky = dot(a, dc);
            strain first = dot(db, c);
            strain second = dot(dc, b);
            strain tau = 1/2*first - second/2;
            strain ty = dot(b, db);
            strain tz = dot(c, dc);
            strain tyz = dot(db, c) + dot(dc, b);
            energy axial_strain = 1/2*EA*ex^2, points 3;
            energy strain_along_y = 1/2*EA*ey^2, points 3;
            energy strain_along_z = 1/2*EA*ez^2, points 3;
            energy shear_along_y = 1/2*kyGA*gy^2, points 3;
            energy shear_along_z = 1/2*kzGA*gz^2, points 3;
            energy shear_of_the_section = 1/2*halfEA*gyz^2, points 3;
            energy bending_about_z = 1/2*EIz*kz^2, points 2;
            energy bending_about_y = 1/2*EIy*ky^2, points 2;
            energy torsion = 1/2*GJ*tau^2, points 2;
            energy gradient_along_y = 1/2*GIz*ty^2, points 2;
            energy gradient_along_z = 1/2*GIy*tz^2, points 2;
            energy gradient_of_the_section_s_shear = 1/2*GIyz*tyz^2, points 2;
        }
        /// The same without a strain.
        element rod_of_products(section, material) {
            domain xi in 0..1;
            vector r0      = r   at 0,   shape 1 - 3*xi^2 + 2*xi^3;
            vector r0x     = r_x at 0,   shape xi - 2*xi^2 + xi^3;
            vector r0y     = r_y at 0,   shape 1 - 3*xi + 2*xi^2;
            vector r0z     = r_z at 0,   shape 1 - 3*xi + 2*xi^2;
            vector ry_half = r_y at 1/2, shape 4*xi - 4*xi^2;
            vector rz_half = r_z at 1/2, shape 4*xi - 4*xi^2;
            vector r1      = r   at 1,   shape 3*xi^2 - 2*xi^3;
            vector r1x     = r_x at 1,   shape -xi^2 + xi^3;
            vector r1y     = r_y at 1,   shape -xi + 2*xi^2;
            vector r1z     = r_z at 1,   shape -xi + 2*xi^2;
            field a  = r_x;
            field b  = r_y;
            field c  = r_z;
            field db = r_yx;
            field dc = r_zx;
            coefficient EA: N = material.young * section.area;
            coefficient kyGA: N = section.shear_factor_y * material.shear_modulus * section.area;
            coefficient kzGA: N = section.shear_factor_z * material.shear_modulus * section.area;
            coefficient halfEA: N = material.half_young * section.area;
            coefficient EIz: N m^2 = material.young * section.second_moment_z;
            coefficient EIy: N m^2 = material.young * section.second_moment_y;
            coefficient GJ: N m^2 = material.shear_modulus * section.torsion_constant;
            coefficient GIz: N m^2 = material.shear_modulus * section.second_moment_z;
            coefficient GIy: N m^2 = material.shear_modulus * section.second_moment_y;
            coefficient GIyz: N m^2 = material.shear_modulus * section.quarter_polar_moment;
            coefficient rhoA: kg/m = material.density * section.area;
            coefficient rhoIz: kg m = material.density * section.second_moment_z;
            coefficient rhoIy: kg m = material.density * section.second_moment_y;
            inertia r = rhoA;
            inertia r_y = rhoIz;
            inertia r_z = rhoIy;
            energy axial_strain = 1/2*EA*(1/2*(dot(a, a) - 1))^2, points 3;
            energy strain_along_y = 1/2*EA*(1/2*(dot(b, b) - 1))^2, points 3;
            energy strain_along_z = 1/2*EA*(1/2*(dot(c, c) - 1))^2, points 3;
            energy shear_along_y = 1/2*kyGA*(dot(a, b))^2, points 3;
            energy shear_along_z = 1/2*kzGA*(dot(a, c))^2, points 3;
            energy shear_of_the_section = 1/2*halfEA*(dot(b, c))^2, points 3;
            energy bending_about_z = 1/2*EIz*(dot(a, db))^2, points 2;
            energy bending_about_y = 1/2*EIy*(dot(a, dc))^2, points 2;
            energy torsion = 1/2*GJ*(1/2*(dot(db, c) - dot(dc, b)))^2, points 2;
            energy gradient_along_y = 1/2*GIz*(dot(b, db))^2, points 2;
            energy gradient_along_z = 1/2*GIy*(dot(c, dc))^2, points 2;
            energy gradient_of_the_section_s_shear = 1/2*GIyz*(dot(db, c) + dot(dc, b))^2, points 2;
        }
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        body by_beam {
            spatial;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius size angle 90 deg;
            twist turned;
            mesh n * beam(round, steel);
        }
        joint root_of_beam = clamp(by_beam.start, inertial);
        load pull_beam = force(by_beam.end, [0 N, 0 N, pull], in = inertial);
        output z_beam = by_beam.end.z;
        output torque_beam = by_beam.start.torque;
        output energy_beam = by_beam.strain_energy;
        body by_rod {
            spatial;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius size angle 90 deg;
            twist turned;
            mesh n * rod(round, steel);
        }
        joint root_of_rod = clamp(by_rod.start, inertial);
        load pull_rod = force(by_rod.end, [0 N, 0 N, pull], in = inertial);
        output z_rod = by_rod.end.z;
        output torque_rod = by_rod.start.torque;
        output energy_rod = by_rod.strain_energy;
        body by_rod_of_products {
            spatial;
            arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius size angle 90 deg;
            twist turned;
            mesh n * rod_of_products(round, steel);
        }
        joint root_of_rod_of_products = clamp(by_rod_of_products.start, inertial);
        load pull_rod_of_products = force(by_rod_of_products.end, [0 N, 0 N, pull], in = inertial);
        output z_rod_of_products = by_rod_of_products.end.z;
        output torque_rod_of_products = by_rod_of_products.start.torque;
        output energy_rod_of_products = by_rod_of_products.strain_energy;
    }
}

/// Quarter of a turn, rad.
const QUARTER: f64 = std::f64::consts::FRAC_PI_2;

/// Bits of numbers, which tell 0 from -0.
fn bits(row: &[f64]) -> Vec<u64> {
    row.iter().map(|value| value.to_bits()).collect()
}

/// Rows of outputs, one for each body.
fn rows(model: &impl rncf::Model, bodies: usize) -> Vec<Vec<f64>> {
    let row = at_rest(model, 1.0);
    let each = row.len() / bodies;
    row.chunks(each).map(<[f64]>::to_vec).collect()
}

#[test]
fn a_curved_cantilever_of_an_own_element_is_that_of_the_library() {
    let model = Quarters::default();
    let [cable, wire, products, quintic, cone, cone_of_products]: [Vec<f64>; 6] = rows(&model, 6).try_into().unwrap();
    // Bending by F R cos(angle) from the root, normal force F cos(angle).
    let (young, area, second) = (210e9, 1e-4, 1e-10);
    let wanted = model.pull * QUARTER / 2.0 * (model.size.powi(3) / (young * second) + model.size / (young * area));
    let off = |row: &[f64]| row[0] / wanted - 1.0;
    println!("{:.1e} {:.1e} {:.1e}", off(&cable), off(&products), off(&quintic));
    assert_eq!(bits(&cable), bits(&wire));
    // Displacement and energy; moment and force at the root have the round-off of an axial strain of 5e-11.
    for (place, within) in [(0, 1e-9), (1, 1e-5), (2, 1e-5), (3, 1e-9)] {
        // What varies along the axis is kept beside the stress-free values.
        for (own, library) in [(&products, &cable), (&cone_of_products, &cone)] {
            let apart = (own[place] - library[place]).abs();
            assert!(apart < within * library[place].abs(), "{own:?} {library:?}");
        }
    }
    assert!(
        (cable[1].abs() / (model.pull * model.size) - 1.0).abs() < 1e-3,
        "{cable:?}"
    );
    assert!(off(&cable).abs() < 5e-5 && off(&products).abs() < 5e-5 && off(&quintic).abs() < 5e-5);
}

#[test]
fn a_ring_of_an_own_element_gives_way_as_in_closed_form() {
    let ring = Ring::default();
    let (young, area, second) = (210e9, 1e-4, 1e-10);
    let bent = ring.pull * ring.size.powi(3) / (young * second) * (QUARTER / 2.0 - 1.0 / QUARTER);
    let wanted = bent + ring.pull * ring.size * QUARTER / 2.0 / (young * area);
    let found = at_rest(&ring, 1.0)[0];
    println!("{:.1e}", found / wanted - 1.0);
    assert!((found / wanted - 1.0).abs() < 1e-4);
}

#[test]
fn a_bow_of_an_own_element_in_space_is_that_of_the_library() {
    let bows = Bows::default();
    let [beam, rod, products]: [Vec<f64>; 3] = rows(&bows, 3).try_into().unwrap();
    let (young, shear, r) = (210e9, 210e9 / 2.6, 5e-3_f64);
    let area = std::f64::consts::PI * r * r;
    let second = area * r * r / 4.0;
    let factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    // Bending F R sin(angle) and torsion F R (1 - cos(angle)), counted from the end; shear force F.
    let compliance = QUARTER / 2.0 / (young * second) + (3.0 * QUARTER / 2.0 - 2.0) / (shear * 2.0 * second);
    let wanted = bows.pull * (bows.size.powi(3) * compliance + bows.size * QUARTER / (factor * shear * area));
    println!("{:.1e}", beam[0] / wanted - 1.0);
    assert_eq!(bits(&beam), bits(&rod));
    for (own, library) in products.iter().zip(&rod) {
        assert!((own - library).abs() < 1e-9 * library.abs(), "{products:?} {rod:?}");
    }
    assert!((rod[0] / wanted - 1.0).abs() < 1e-4);
}
