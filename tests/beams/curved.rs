//! Curved beams in steady rotation against THEORY 9.2 and the hand-written chain.

use rncf::Model;
use rncf::app::{EquilibriumSettings, static_equilibria};
use rncf::equilibrium::{Uniform, steady};
use rncf_models::{CurvedDownwind, CurvedOutOfPlane, CurvedUpwind};
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Shape, Slot, Supports};
use rncf_reference::section_statics::Problem;

use crate::scenes::{at_rest, distance, outputs, referenced, short};

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

rncf::model! {
    /// A helical spring under a force along its axis, on a plate that may turn and tilt.
    model Coil {
        param radius = 20 mm;
        param pitch = 8 mm;
        param turns = 8;
        param thickness = 1 mm;
        param force = 1 mN;
        param n: count = 96;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire = circle(radius = thickness);
        body coil {
            spatial;
            curve [radius * cos(phi), radius * sin(phi), pitch * phi / (2*pi)] for phi from 0 to 2*pi*turns;
            section_y [0, 0, 1];
            mesh n * beam(wire, steel);
        }
        rigid plate { mass = 1 g; inertia = [1, 1, 1] g*mm^2; origin = [0 m, 0 m, pitch * turns]; }
        joint seat = clamp(coil.start, inertial);
        joint head = weld(coil.end, plate);
        load pull = force(plate, [0 N, 0 N, force]);
        output stretch = plate.z - pitch * turns;
    }
}

/// A force along the axis twists and bends the wire by the same moments everywhere: Castigliano's theorem with the torsion
/// F R cos a, the bending F R sin a, the normal force F sin a and the shear force F cos a.
#[test]
fn a_helical_spring_has_the_stiffness_of_its_wire() {
    // What the formula leaves out of a curved wire is of the order of the square of its thickness over the coil's radius.
    for (thickness, pitch, turns, n, allowed) in [
        (1e-3, 0.008, 8.0, 192, 1e-5),
        (1e-3, 0.06, 3.0, 72, 2e-4),
        (2e-4, 0.06, 3.0, 144, 1e-5),
    ] {
        let coil = Coil {
            thickness,
            pitch,
            turns,
            n,
            force: 1e-4 * (1e3 * thickness).powi(4),
            ..Coil::default()
        };
        let radius = coil.radius;
        let round = 2.0 * std::f64::consts::PI * radius;
        let length = turns * round.hypot(pitch);
        let (sine, cosine) = (turns * pitch / length, turns * round / length);
        let (young, shear) = (210e9, 210e9 / 2.6);
        let area = std::f64::consts::PI * thickness * thickness;
        let second = area * thickness * thickness / 4.0;
        // Cowper's factor of a full circle.
        let factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
        let turned = (radius * cosine).powi(2) / (shear * 2.0 * second) + (radius * sine).powi(2) / (young * second);
        let moved = cosine * cosine / (factor * shear * area) + sine * sine / (young * area);
        let wanted = coil.force * length * (turned + moved);
        let found = at_rest(&coil, 1.0)[0];
        println!("{thickness} {pitch} {turns} {n}: {:.2e}", found / wanted - 1.0);
        assert!((found / wanted - 1.0).abs() < allowed);
    }
}

/// One element that follows a whole winding would see a straight line between its ends.
#[test]
fn an_element_that_spans_a_winding_is_refused() {
    let coil = Coil {
        n: 8,
        ..Coil::default()
    };
    let refused = coil
        .build(rncf::Formulation::Rncf, rncf::Joints::Eliminated)
        .err()
        .map(|error| error.to_string());
    assert!(
        refused.is_some_and(
            |text| text.contains("each of its 8 elements is bent by 3") && text.contains("take at least 3")
        )
    );
}

rncf::model! {
    /// A quarter of a ring with a moment on its end: of a material and a shape, and of the same numbers.
    pub model Hook {
        param r = 20 mm;
        const R = 0.2 m;
        const EI = 210 GPa * pi / 4;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section rod = circle(radius = r);
        section numbers {
            EA = 660 MN * (r / 20 [mm])^2; GAy = 230 MN; GAz = 230 MN; GJ = 60 kN*m^2;
            EIy = EI * r^4; EIz = EI * r^4;
            mass = 10 kg/m; inertia_y = 1 g*m; inertia_z = 1 g*m;
        }
        body shaped { spatial; arc from [0, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius R angle 90 deg; section_y [0, 1, 0]; mesh 16 * beam(rod, steel); }
        body numbered { spatial; arc from [1, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius R angle 90 deg; section_y [0, 1, 0]; mesh 16 * beam(numbers); }
        joint a = clamp(shaped.start, inertial);
        joint b = clamp(numbered.start, inertial);
        load on_shaped = moment(shaped.end, [0, 0, 1] N*m);
        load on_numbered = moment(numbered.end, [0, 0, 1] N*m);
        output of_shaped = atan2(dot(shaped.end.ey, [0, -1, 0]), dot(shaped.end.ey, [-1, 0, 0]));
        output of_numbers = atan2(dot(numbered.end.ey, [0, -1, 0]), dot(numbered.end.ey, [-1, 0, 0]));
    }
}

/// The end of a thin arc turns by `M L / (E I)`. Bending strains of a `beam` of a shape are those of its axes, `r_x . r_y'`: on a curved axis a moment stretches axis and
/// section with them, so that it turns by the part `(r / R)^2 / 2` more. Of a section in numbers it does not.
#[test]
fn a_shape_on_a_curved_axis_is_softer_by_the_square_of_its_curvature() {
    for r in [5e-3, 20e-3, 60e-3] {
        let found = at_rest(&Hook { r }, 1.0);
        let thin = 0.5 * std::f64::consts::PI * 0.2 / (210e9 * std::f64::consts::PI / 4.0 * f64::powi(r, 4));
        let [shaped, numbered] = [found[0], found[1]].map(|turn| turn / thin - 1.0);
        let part = 0.5 * (r / 0.2_f64).powi(2);
        println!("{r}: {shaped:.2e} of {part:.2e}, {numbered:.2e}");
        assert!((shaped - part).abs() < 0.1 * part, "{r}: {shaped} for {part}");
        assert!(numbered.abs() < 1e-4, "{r}: {numbered}");
        let found = static_equilibria(&Hook { r }, &EquilibriumSettings::default()).unwrap();
        let told = found
            .warnings
            .iter()
            .filter(|note| note.contains("turns it too far by"));
        let told: Vec<&String> = told.collect();
        match r > 30e-3 {
            true => assert!(
                told.len() == 1 && told[0].contains("body `shaped`") && told[0].contains("4.5 %"),
                "{told:?}"
            ),
            false => assert!(told.is_empty(), "{told:?}"),
        }
        // Winkler: the neutral fibre of a circle lies at (R + sqrt(R^2 - r^2)) / 2 from the centre, where the stress changes its sign.
        let neutral = 0.5 * (0.2 + (0.04 - r * r).sqrt());
        let inner = (neutral - 0.2 + r) / (std::f64::consts::PI * r * r * (0.2 - neutral) * (0.2 - r));
        let straight = 4.0 / (std::f64::consts::PI * f64::powi(r, 3));
        let more = inner / straight - 1.0;
        let told = found.warnings.iter().find_map(|note| {
            let part = note.split("larger at the inner side by about ").nth(1)?;
            part.split(' ').next()?.parse::<f64>().ok()
        });
        match told {
            Some(percent) => assert!(
                (percent / 100.0 / more - 1.0).abs() < 0.3,
                "{r}: {percent} % for {more}"
            ),
            None => assert!(more < 0.025, "{r}: {more}"),
        }
    }
}

rncf::model! {
    /// Three quarters of a ring with a moment on its end, with both measures of bending of a cable.
    pub model Ring {
        param r = 10 mm;
        const R = 100 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section wire { area = pi * r^2; second_moment = pi * r^4 / 4; }
        body rough { planar xy; arc from [0, 0, 0] m direction [1, 0, 0] radius R angle 270 deg; mesh 64 * cable(wire, steel); }
        body exact { planar xy; arc from [0, 0, 0] m direction [1, 0, 0] radius R angle 270 deg; mesh 64 * cable(wire, steel, bending = exact); }
        joint a = clamp(rough.start, inertial);
        joint b = clamp(exact.start, inertial);
        load on_rough = moment(rough.end, [0, 0, 1] N*m);
        load on_exact = moment(exact.end, [0, 0, 1] N*m);
        output of_rough = atan2(rough.end.slope.x, -rough.end.slope.y);
        output of_exact = atan2(exact.end.slope.x, -exact.end.slope.y);
    }
}

/// The polynomial of bending of a `cable` grows with the square of the stretch: a moment turns it by the part `(r / R)^2` more.
#[test]
fn a_cable_on_a_curved_axis_is_softer_by_its_polynomial() {
    for r in [5e-3, 10e-3, 20e-3] {
        let found = at_rest(&Ring { r }, 1.0);
        let thin = 1.5 * std::f64::consts::PI * 0.1 / (210e9 * 0.25 * std::f64::consts::PI * f64::powi(r, 4));
        let [rough, exact] = [found[0], found[1]].map(|turn| turn / thin - 1.0);
        let part = (r / 0.1_f64).powi(2);
        assert!(
            (rough - part).abs() < 0.05 * part && exact.abs() < 1e-4,
            "{r}: {rough} {exact} for {part}"
        );
        let found = static_equilibria(&Ring { r }, &EquilibriumSettings::default()).unwrap();
        let told: Vec<&String> = found
            .warnings
            .iter()
            .filter(|note| note.contains("turns it too far by"))
            .collect();
        match r > 15e-3 {
            true => assert!(
                told.len() == 1 && told[0].contains("body `rough`") && told[0].contains("4.0 %"),
                "{told:?}"
            ),
            false => assert!(told.is_empty(), "{told:?}"),
        }
    }
}

rncf::model! {
    /// Quarters of a circle through five points, one of which says where its ends lead.
    pub model Quarters {
        param pull = 1 mN;
        table points {
            x = [0, 0.382683432365090, 0.707106781186548, 0.923879532511287, 1] m;
            y = [0, 0.076120467488713, 0.292893218813452, 0.617316567634910, 1] m;
            z = [0, 0, 0, 0, 0] m;
        }
        section wall {
            EA = 1 MN; GAy = 1 MN; GAz = 1 MN; GJ = 90 N*m^2; EIy = 100 N*m^2; EIz = 100 N*m^2;
            mass = 2 kg/m; inertia_y = 0.1 kg*m; inertia_z = 0.1 kg*m;
        }
        body led { spatial; curve through points from direction x to direction y; section_y [0, 0, 1]; mesh 16 * beam(wall); }
        body natural { spatial; curve through points; section_y [0, 0, 1]; mesh 16 * beam(wall); }
        joint foot = clamp(led.start, inertial);
        joint other_foot = clamp(natural.start, inertial);
        load along = force(led.end, [pull, 0 N, 0 N]);
        load same = force(natural.end, [pull, 0 N, 0 N]);
        output led_tip = led.end.position;
        output natural_tip = natural.end.position;
    }
}

/// Castigliano: `pi/4 F R (R^2/EI + 1/EA + 1/GA)` along the force.
#[test]
fn an_axis_through_few_points_follows_the_directions_of_its_ends() {
    let row = at_rest(&Quarters::default(), 1.0);
    let exact = 0.25e-3 * std::f64::consts::PI * (1.0 / 100.0 + 2.0 / 1e6);
    let [led, natural] = [0, 3].map(|at| (row[at] - 1.0) / exact - 1.0);
    println!("{led:.2e} {natural:.2e}");
    assert!(led.abs() < 5e-4 && natural.abs() > 5e-3);
}
