//! Straight and curved beams under dead loads: exact with one element where displacements are small,
//! elastica, 45-degree bend, Princeton beam (THEORY 5.2, 9.7).

use rncf::equilibrium::{Uniform, follow};
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Joints, Model, Scene};
use rncf_models::{Bend45, Elastica, PrincetonBeam, RollUp};
use rncf_reference::rod::Rod;

use crate::scenes::{at_rest, distance, referenced, short};

rncf::model! {
    /// A round cantilever in space with loads in all directions, relative to those that bend or twist it by about 1.
    pub model Cantilever {
        param radius = 1 mm;
        param across = 0;
        param down = 0;
        param twist = 0;
        param elements: count = 1;

        const length = 1 m;
        const young = 210 [GPa];

        material steel { density = 7850 kg/m^3; young = young; poisson = 0.3; }
        section round = circle(radius = radius);
        body beam {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * beam(round, steel);
        }
        joint root = clamp(beam.start, inertial);
        load pull = force(beam.end, [0 N, across * young * pi / 4 * radius^4 / length^2, down * young * pi / 4 * radius^4 / length^2], in = inertial);
        load turn = moment(beam.end, [twist * young * pi / 4 * radius^4 / (1.3 * length), 0 [N m], 0 [N m]], in = inertial);

        output tip = beam.end.position;
        output angle = atan2(beam.end.ey.z, beam.end.ey.y);
    }
}

rncf::model! {
    /// The same on a spherical pin: three rigid rotations are left.
    pub model Pinned {
        param elements: count = 1;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        body beam {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * beam(round, steel);
        }
        joint root = pin(beam.start, inertial);
        output tip = beam.end.position;
    }
}

rncf::model! {
    /// The same on a small free body: six rigid motions.
    pub model Free {
        param elements: count = 1;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        rigid hub { mass = 1 g; inertia = [1e-6, 1e-6, 1e-6] kg*m^2; }
        body beam in hub {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * beam(round, steel);
        }
        joint root = clamp(beam.start, hub);
        output tip = beam.end.position;
    }
}

/// Small parts of the loads: displacements are linear in them to 1e-10.
const SMALL: f64 = 1e-5;

/// Tip deflection of Timoshenko's beam under `alpha = 1`, unit length: `1/3 + EI / (k_s G A)`.
fn timoshenko(radius: f64) -> f64 {
    let shear_factor = 6.0 * 1.3 / (7.0 + 6.0 * 0.3);
    1.0 / 3.0 + 0.25 * radius * radius * 2.6 / shear_factor
}

#[test]
fn bending_shear_and_torsion_are_exact_with_one_element() {
    for radius in [0.05, 0.005, 0.0005] {
        for elements in [1, 4] {
            let planar = Elastica {
                alpha: SMALL,
                slenderness: radius,
                elements,
            };
            let spatial = Cantilever {
                radius,
                across: 0.6 * SMALL,
                down: 0.8 * SMALL,
                elements,
                ..Cantilever::default()
            };
            let twisted = Cantilever {
                radius,
                twist: SMALL,
                elements,
                ..Cantilever::default()
            };
            let exact = SMALL * timoshenko(radius);
            let tip = at_rest(&spatial, 1.0);
            let factors = [
                at_rest(&planar, 1.0)[1] / exact,
                tip[1] / (0.6 * exact),
                tip[2] / (0.8 * exact),
                // 1 / (1.3 E I) of the load over 1 / (G J), which is that.
                at_rest(&twisted, 1.0)[3] / SMALL,
            ];
            println!("r/L {radius}, {elements} elements: {factors:?}");
            for factor in factors {
                assert!(
                    (factor - 1.0).abs() < 1e-6,
                    "r/L {radius}, {elements} elements: {factors:?}"
                );
            }
        }
    }
}

/// Frequencies at rest, `count` of them.
fn frequencies(model: &impl Model, joints: Joints, count: usize) -> Vec<f64> {
    let mut scene = model.build(Formulation::Rncf, joints).unwrap();
    let state = scene.rest(0.0);
    let found = modes(scene.as_mut(), &Uniform::at_rest(0.0), &state, Wanted { count }).unwrap();
    found.iter().map(|mode| mode.im).collect()
}

#[test]
fn only_rigid_motions_have_no_stiffness() {
    // Slender beams: 15.418 (pinned and free) and 22.373 (free) sqrt(EI / (rhoA L^4)); shear lowers both.
    let unit = (210e9 * 0.25 * 0.02_f64.powi(2) / 7850.0).sqrt();
    for joints in [Joints::Eliminated, Joints::Multipliers] {
        // Small ones with full matrices, large ones by iteration.
        for elements in [1, 2, 4, 8, 16] {
            let pinned = frequencies(&Pinned { elements }, joints, 6);
            let free = frequencies(&Free { elements }, joints, 9);
            let bending = [pinned[3] / (15.4182 * unit), free[6] / (22.3733 * unit)];
            println!("{elements} elements, {joints:?}: bending over slender beams {bending:.4?}");
            assert_eq!(pinned.iter().filter(|&&frequency| frequency == 0.0).count(), 3);
            assert_eq!(free.iter().filter(|&&frequency| frequency == 0.0).count(), 6);
            // Round: the same in both directions.
            assert!((pinned[4] / pinned[3] - 1.0).abs() < 1e-10 && (free[7] / free[6] - 1.0).abs() < 1e-10);
            assert!(elements < 4 || bending.iter().all(|ratio| (ratio - 1.0).abs() < 0.01));
        }
    }
}

#[test]
fn slender_beams_bend_far_in_few_steps() {
    let planar = Elastica {
        alpha: 10.0,
        slenderness: 1e-3,
        elements: 32,
    };
    let rolled = RollUp {
        turns: 1.0,
        slenderness: 0.005,
        elements: 8,
    };
    let bend = Bend45 {
        load: 600.0,
        elements: 8,
    };
    let few = |scene: &mut dyn Scene, largest: f64, most: usize| {
        let found = follow(scene, &Uniform::at_rest(0.0), largest, |_, _| ()).unwrap();
        println!("{} steps, {} iterations", found.path.len(), found.iterations());
        assert!(found.path.len() <= most, "{} steps", found.path.len());
    };
    // The first steps are short: no limit point lies within.
    few(referenced(&planar).as_mut(), 0.25, 12);
    few(referenced(&rolled).as_mut(), 0.125, 14);
    few(referenced(&bend).as_mut(), 0.25, 10);
}

#[test]
fn elastica_in_the_plane_and_in_space() {
    for (alpha, elements, u, w) in [
        (1.0, 16, 0.05643323628, 0.3017207738),
        (10.0, 32, 0.5549955978, 0.8106090249),
    ] {
        let planar = at_rest(
            &Elastica {
                alpha,
                slenderness: 1e-3,
                elements,
            },
            0.25,
        );
        let spatial = at_rest(
            &Cantilever {
                across: 0.6 * alpha,
                down: 0.8 * alpha,
                elements,
                ..Cantilever::default()
            },
            0.25,
        );
        let errors = [
            distance(&planar[..2], &[u, w]),
            distance(&spatial[..3], &[1.0 - u, 0.6 * w, 0.8 * w]),
        ];
        println!("elastica, alpha {alpha}, {elements} elements: {}", short(&errors));
        assert!(errors.iter().all(|&error| error < 1e-4), "{errors:?}");
    }
}

/// Errors at 8, 16, 32 elements, relative to the displacement.
fn relative(exact: [f64; 3], start: [f64; 3], tip: impl Fn(usize) -> Vec<f64>) -> [f64; 3] {
    [8, 16, 32].map(|elements| distance(&tip(elements)[..3], &exact) / distance(&exact, &start))
}

#[test]
fn bend_of_45_degrees() {
    // THEORY 9.7.
    let (exact, start) = ([46.89159, 15.55768, 53.60799], [70.7107, 29.2893, 0.0]);
    let errors = relative(exact, start, |elements| {
        let model = Bend45 { load: 600.0, elements };
        at_rest(&model, 0.25)
    });
    println!("45-degree bend, 8, 16, 32 elements: {}", short(&errors));
    assert!(errors.iter().all(|&error| error < 3e-3));
}

#[test]
fn princeton_beam() {
    // THEORY 9.7.
    for (angle, exact) in [
        (30.0_f64, [-7.659933e-3, 1.014554e-2, 7.945169e-2]),
        (60.0, [-2.047109e-2, 6.653287e-3, 1.299171e-1]),
    ] {
        let model = |elements| PrincetonBeam {
            load: 8.896,
            angle: angle.to_radians(),
            elements,
        };
        let errors = relative(exact, [0.0; 3], |elements| at_rest(&model(elements), 0.25));
        let tip = at_rest(&model(16), 0.25);
        let each: Vec<f64> = (0..3).map(|k| tip[k] / exact[k] - 1.0).collect();
        println!(
            "Princeton beam, {angle} degrees, 8, 16, 32 elements: {}; 16, each component {}",
            short(&errors),
            short(&each)
        );
        assert!(errors.iter().all(|&error| error < 3e-3));
        assert!(each.iter().all(|error| error.abs() < 3e-3));
    }
}

#[test]
fn loads_in_all_directions_at_once_bend_as_the_exact_rod() {
    let radius = 1e-2_f64;
    let (young, area) = (210e9, std::f64::consts::PI * radius * radius);
    let (stiffness, shear) = (0.25 * young * area * radius * radius, young / 2.6);
    let sheared = (7.0 + 6.0 * 0.3) / (6.0 * 1.3 * shear * area);
    let rod = Rod {
        length: 1.0,
        force_compliance: [1.0 / (young * area), sheared, sheared],
        moment_compliance: [1.3 / stiffness, 1.0 / stiffness, 1.0 / stiffness],
        curvature: [0.0; 3],
        steps: 200,
    };
    let force = [0.0, 1.5 * stiffness, -stiffness];
    let exact = rod.tip(force, [0.5 * stiffness / 1.3, 0.0, 0.0], 6).unwrap().position;
    let tip = at_rest(
        &Cantilever {
            radius,
            across: 1.5,
            down: -1.0,
            twist: 0.5,
            elements: 16,
        },
        0.25,
    );
    let error = distance(&tip[..3], &exact);
    println!("bent and twisted at once: {tip:?}, {exact:?}, {error:.2e}");
    assert!(error < 2e-4);
}
