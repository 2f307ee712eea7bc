//! Bodies whose properties vary along the axis, and sections that say their stiffness by themselves, against closed forms, a
//! composite box, and two blades of wind turbines computed by others.

use rncf::equilibrium::{Kind, Uniform};
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Stop};
use rncf_models::{Iea15mwBlade, Nrel5mwBlade};

use crate::scenes::{equilibrium, short};

rncf::model! {
    /// A bar of 2 m, whose centre lies beside its axis.
    pub model Stout {
        param off = 0 m;
        section s {
            EA = 30 MN; GAy = 10 MN; GAz = 10 MN; GJ = 20 kN*m^2; EIy = 40 kN*m^2; EIz = 60 kN*m^2;
            tension_z = off; shear_z = off;
            mass = 12 kg/m; mass_z = off; inertia_y = 0.016 kg*m; inertia_z = 0.024 kg*m;
        }
        body bar { spatial; line from [0 m, 0 m, -off] to [2 m, 0 m, -off]; section_y [0, 1, 0]; mesh 24 * beam(s); }
        joint root = clamp(bar.start, inertial);
        output tip = bar.end;
    }
}

rncf::model! {
    /// A bar by its constants, with its axis anywhere beside its centres.
    pub model Bar {
        param off = 0 m;
        param turned = 0 deg;
        param moment = 0 [N*m];
        param speed = 0 rad/s;
        param elements: count = 4;
        frame spinner = rotating(axis = y, angle = speed * t);
        section bar {
            EA = 10 kN; GAy = 10 kN; GAz = 10 kN; GJ = 200 N*m^2; EIy = 100 N*m^2; EIz = 50 N*m^2;
            mass = 1 kg/m; inertia_y = 1 kg*m; inertia_z = 0.8 kg*m;
            tension_y = off; shear_y = off; mass_y = off;
            tension_z = -0.5*off; shear_z = -0.5*off; mass_z = -0.5*off;
            principal = turned;
        }
        body beam in spinner {
            spatial;
            line from [0 m, -off, 0.5*off] to [10 m, -off, 0.5*off];
            mesh elements * beam(bar);
        }
        joint root = clamp(beam.start, spinner);
        load turn = moment(beam.end, [0 [N*m], -moment, 0 [N*m]], in = inertial);
        output tip = beam.end.position;
        output moments = [beam.at(3 m).torque, beam.at(3 m).moment_y, beam.at(3 m).moment_z];
    }
}

rncf::model! {
    /// A composite box with coupled bending and twist (Yu et al. 2002), in inches and pounds.
    pub model BoxBeam {
        param load = 150 lbf;
        param elements: count = 16;
        table rows = file("../models/data/box_beam_section.csv");
        section box_ = columns(rows);
        body beam { spatial; line from [0, 0, 0] m to [10, 0, 0] inch; mesh elements * beam(box_); }
        joint root = clamp(beam.start, inertial);
        load pull = force(beam.end, [0 N, 0 N, load], in = inertial);
        output tip = beam.end.position;
    }
}

rncf::model! {
    /// A tapered round cantilever, by the radius as a function of the place.
    pub model Taper {
        param pull = 1 N;
        param elements: count = 8;
        const length = 2 m;
        const radius = 50 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section cone = circle(radius = radius * (1 - 0.5 * x / length));
        body beam { spatial; line from [0, 0, 0] m to [length, 0 m, 0 m]; mesh elements * beam(cone, steel); }
        joint root = clamp(beam.start, inertial);
        load down = force(beam.end, [0 N, pull, 0 N], in = inertial);
        output tip = beam.end.position;
        output mass = beam.mass;
        output centre = beam.center_of_mass;
        output stress = beam.at(1 m).stress;
    }
}

rncf::model! {
    /// Hanging ropes: one in steps of a table, one that grows thinner as an exponential does.
    pub model Ropes {
        param elements: count = 4;
        const length = 100 m;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        table steps { x = [0, 40, 40, 100] m; area = [8, 8, 2, 2] cm^2; }
        section stepped { area = steps.area; second_moment = 1e-12 m^4; }
        section thinner { area = 8 [cm^2] * exp(-x / length); second_moment = 1e-12 m^4; }
        body a { planar xy; line from [0, 0, 0] m to [0, -100, 0] m; mesh elements at steps * cable(stepped, steel); }
        body b { planar xy; line from [5, 0, 0] m to [5, -100, 0] m; mesh elements * cable(thinner, steel); }
        joint top_a = pin(a.start, inertial);
        joint top_b = pin(b.start, inertial);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output longer = [-100 m - a.end.y, -100 m - b.end.y, 0 m];
        output mass = [a.mass, b.mass, 0 kg];
        output force = [a.at(50 m).axial_force, a.at(40 m).axial_force, b.at(50 m).axial_force];
    }
}

rncf::model! {
    /// The NREL 5-MW blade by the columns of another program, field by field: slender, without shear.
    pub model Slender {
        param speed = 0 rpm;
        /// Axial stiffness over that of the table.
        param stiffer = 1;
        param each: count = 1;
        table rows = file("../models/data/nrel5mw_elastodyn.csv", at = BlFract);
        section layup {
            EA = stiffer * rows.EAStff; GAy = 100 * rows.EAStff; GAz = 100 * rows.EAStff; GJ = rows.GJStff; EIy = rows.EdgStff; EIz = rows.FlpStff;
            mass = rows.BMassDen; inertia_y = 1e-4 * rows.EdgIner; inertia_z = 1e-4 * rows.FlpIner;
        }
        frame rotor = rotating(axis = x, angle = speed * t);
        body blade in rotor {
            spatial;
            line from [0, 0, 1.5] m to [0, 0, 63] m;
            section_y [1, 0, 0];
            twist -rows.StrcTwst;
            mesh each at rows * beam(layup);
        }
        joint hub = clamp(blade.start, rotor);
        output tip = blade.end.position;
    }
}

fn frequencies(model: &impl Model, kind: Kind, count: usize) -> Vec<f64> {
    let (mut scene, state, _) = equilibrium(model, kind, 1.0);
    let at = Uniform {
        kind,
        ..Uniform::steady(0.0)
    };
    let found = modes(scene.as_mut(), &at, &state, Wanted { count }).unwrap();
    // Undamped.
    found
        .iter()
        .map(|mode| mode.re.hypot(mode.im) / std::f64::consts::TAU)
        .collect()
}

pub(super) fn at_rest(model: &impl Model) -> Vec<f64> {
    equilibrium(model, Kind::Static, 1.0).2
}

#[track_caller]
pub(super) fn near(found: &[f64], wanted: &[f64], relative: f64) {
    let off: Vec<f64> = found.iter().zip(wanted).map(|(a, b)| a / b - 1.0).collect();
    assert!(off.iter().all(|off| off.abs() < relative), "{found:?}: {}", short(&off));
}

/// README of the data: 6x6 with shear, 48 cubic elements, and a geometrically exact rod.
#[test]
fn the_nrel_5mw_blade_has_the_modes_and_the_deflection_of_others() {
    let still = |each| Nrel5mwBlade {
        gravity: 0.0,
        each,
        ..Nrel5mwBlade::default()
    };
    let wanted = [0.685819, 1.080571, 1.946795, 3.73930, 4.38512, 5.57591, 7.47955];
    near(&frequencies(&still(1), Kind::Static, 7), &wanted, 5e-5);
    let heavy = Nrel5mwBlade {
        gravity: 9.8,
        ..Nrel5mwBlade::default()
    };
    let row = at_rest(&heavy);
    near(&[row[0], row[1]], &[0.083240, -0.435944], 3e-5);
    near(&row[2..3], &[16844.752], 1e-7);
}

/// By the columns of a slender beam, without shear and rotary inertia, at rest and at 12.1 rpm: `bench/blade_bending.py`, Hermite
/// elements in scipy that do not stretch, the same in six digits with 2 and 4 elements between stations.
#[test]
fn the_slender_blade_grows_stiffer_as_it_turns() {
    let of = |rpm: f64, stiffer: f64, kind: Kind| {
        let blade = Slender {
            speed: rpm * std::f64::consts::PI / 30.0,
            stiffer,
            ..Slender::default()
        };
        frequencies(&blade, kind, 3)
    };
    near(&of(0.0, 1.0, Kind::Static), &[0.692900, 1.110805, 1.998157], 1e-4);
    let turning = [0.743576, 1.119349, 2.056212];
    near(&of(12.1, 1e3, Kind::Steady), &turning, 1e-4);
    // A blade that stretches takes part in what Coriolis forces of its swing do along it: its squares fall by about 4 speed^2 over
    // that of its axial vibration, 75 rad/s.
    let found = of(12.1, 1.0, Kind::Steady);
    println!("{found:?}");
    near(&found, &turning, 1e-3);
    assert!(found[1] / turning[1] - 1.0 < -3e-4, "{found:?}");
}

rncf::model! {
    /// The NREL 5-MW blade under gravity from rest, with a damping of its own for each strain.
    pub model Falling {
        param each: count = 1;
        table sections = file("../models/data/nrel5mw_section.csv");
        table points = file("../models/data/nrel5mw_keypoints.csv");
        section layup = beamdyn(sections, damping1 = 1 ms, damping2 = 1 ms, damping3 = 1 ms, damping4 = 2.2 ms, damping5 = 1.4 ms, damping6 = 2.2 ms);
        body blade {
            spatial;
            line from [0, 0, 0] m to [0, 0, 61.5] m;
            section_y [1, 0, 0];
            twist -points.twist;
            mesh each at sections * beam(layup);
        }
        joint hub = clamp(blade.start, inertial);
        load weight = gravity([0, -9.8, 0] m/s^2);
        output tip = blade.end.position;
    }
}

/// Columns `own_ux`, `own_uy` of bd_5MW_dynamic_gravity_Az00_reference.csv: a linear solution, converged, good to 1e-3 of the
/// deflection of 0.9 m.
#[test]
fn the_nrel_5mw_blade_falls_as_others_have_it() {
    let mut scene = Falling::default().build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let wanted = [
        (0.25, -0.01878, -0.50659),
        (0.5, 0.09043, -0.89151),
        (1.0, 0.22902, -0.06046),
        (1.5, -0.13668, -0.71203),
        (2.0, 0.24885, -0.20803),
    ];
    let options = Options {
        rtol: 1e-5,
        ..Options::default()
    };
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), start, 2.0, Method::Radau, options).unwrap();
    let mut states = Vec::new();
    while states.len() < wanted.len() {
        integrator.step().unwrap();
        while let Some(&(t, ..)) = wanted.get(states.len())
            && t <= integrator.state().t + 1e-12
        {
            let mut state = integrator.state().clone();
            if t < state.t - 1e-12 {
                integrator.interpolate(t, &mut state);
            }
            states.push(state);
        }
    }
    drop(integrator);
    let mut row = vec![0.0; scene.output_columns()];
    for ((t, x, y), state) in wanted.into_iter().zip(&states) {
        scene.outputs(state, &mut row);
        println!("{t}: {:.5} {:.5}", row[0] - x, row[1] - y);
        assert!((row[0] - x).abs() < 9e-4 && (row[1] - y).abs() < 9e-4, "{t}: {row:?}");
    }
}

/// README of the data: 66.997 t, modes of finite elements, tip of a geometrically exact rod under 100 kN.
#[test]
fn the_iea_15mw_blade_has_the_modes_and_the_deflection_of_others() {
    let blade = |downwind, edgewise| Iea15mwBlade {
        downwind,
        edgewise,
        each: 2,
    };
    let found = frequencies(&blade(0.0, 0.0), Kind::Static, 5);
    near(&found, &[0.50652, 0.69293, 1.48005, 2.13885, 2.93140], 1e-4);
    let straight = at_rest(&blade(0.0, 0.0));
    near(&straight[3..4], &[66996.88], 1e-6);
    for (load, wanted) in [
        ((-1e5, 0.0), [-7.7597, 0.0713, -1.2853]),
        ((0.0, 1e5), [-0.3039, 3.4345, -0.1168]),
    ] {
        let row = at_rest(&blade(load.0, load.1));
        for axis in 0..3 {
            let off = row[axis] - straight[axis] - wanted[axis];
            assert!(off.abs() < 2e-3, "{load:?}: {axis}: {off}");
        }
    }
}

/// Yu et al. 2002 as kynema has it: the linear law.
#[test]
fn a_composite_box_twists_as_it_bends() {
    let row = at_rest(&BoxBeam::default());
    let tip = [row[0] / 0.0254 - 10.0, row[1] / 0.0254, row[2] / 0.0254];
    near(&tip, &[-0.0902727, -0.0647488, 1.2297365], 3e-5);
}

/// The bar rolls up to a circular arc, `M L / EI` round; its error falls with the fourth power of the elements' length.
#[test]
fn a_bar_rolls_up_to_an_arc() {
    let off = |elements| {
        let row = at_rest(&Bar {
            moment: 12.5664,
            elements,
            ..Bar::default()
        });
        let angle: f64 = 1.25664;
        near(&row[3 + 1..3 + 2], &[-12.5664], 1e-9);
        (row[0] - 10.0 * angle.sin() / angle).hypot(row[2] - 10.0 * (1.0 - angle.cos()) / angle)
    };
    let [coarse, fine] = [off(8), off(16)];
    println!("{coarse:.1e} {fine:.1e}");
    assert!(fine < 3e-6 && coarse > 10.0 * fine);
}

rncf::model! {
    /// Two cases of BeamDyn's regression tests: a bar that droops under its weight, and the 45-degree bend under a dead force.
    pub model BeamDynCases {
        param elements: count = 48;
        section bar {
            EA = 10 kN; GAy = 10 kN; GAz = 10 kN; GJ = 200 N*m^2; EIy = 100 N*m^2; EIz = 100 N*m^2;
            mass = 1 kg/m; inertia_y = 1 kg*m; inertia_z = 1 kg*m;
        }
        section square {
            EA = 1e7 N; GAy = 4166670 N; GAz = 4166670 N; GJ = 833300 N*m^2; EIy = 833300 N*m^2; EIz = 833300 N*m^2;
            mass = 1e-9 kg/m; inertia_y = 1e-9 kg*m; inertia_z = 1e-9 kg*m;
        }
        body drooping { spatial; line from [0, 0, 0] m to [0, 0, 10] m; mesh elements * beam(bar); }
        body bend {
            spatial;
            arc from [0, 0, 0] m direction [0, 0, 1] normal [0, 1, 0] radius 100 m angle 45 deg;
            mesh elements * beam(square);
        }
        joint root = clamp(drooping.start, inertial);
        joint other = clamp(bend.start, inertial);
        load weight = gravity([9.806, 0, 0] m/s^2);
        load pull = force(bend.end, [0, 600, 0] N, in = inertial);
        output droop = drooping.end.position - [0, 0, 10] m;
        output bent = bend.end.position - [100 m * (1 - cos(45 deg)), 0 m, 100 m * sin(45 deg)];
        output root_moment = root.moment;
    }
}

/// Own rows of the data: a geometrically exact rod, converged; the root's moment is the weight times the lever.
#[test]
fn a_drooping_bar_and_a_bend_are_those_of_an_exact_rod() {
    let row = at_rest(&BeamDynCases::default());
    println!("{row:?}");
    for (found, wanted) in row
        .iter()
        .zip([9.4176150, 0.0, -8.3891515, -13.605023, 53.476108, -23.561297])
    {
        assert!((found - wanted).abs() < 1e-3, "{row:?}");
    }
    let coarse = at_rest(&BeamDynCases { elements: 24 });
    // The droop turns by 1.6 rad within the first metre: its error is the larger one, and falls with the fourth power.
    let off = |row: &[f64]| (row[0] - 9.4176150).hypot(row[2] + 8.3891515);
    println!("{:.1e} {:.1e}", off(&coarse), off(&row));
    assert!(off(&row) < 1e-4 && off(&coarse) > 8.0 * off(&row));
}

/// A bar is one bar wherever its axis is.
#[test]
fn the_axis_may_lie_anywhere_in_the_section() {
    let of = |off| {
        let bar = Bar {
            off,
            turned: 0.3,
            elements: 24,
            ..Bar::default()
        };
        frequencies(&bar, Kind::Static, 6)
    };
    let middle = of(0.0);
    for off in [0.1, -0.3] {
        near(&of(off), &middle, 5e-5);
    }
}

/// Frequencies that an independent shooting method for geometrically exact rods gives, wherever the axis is; and torsion in closed
/// form, of unlike moments of inertia. Nothing strains the section in its own plane.
#[test]
fn the_axis_of_a_stout_bar_may_lie_beside_it() {
    let of = |off| {
        let bar = Stout { off };
        let hertz = frequencies(&bar, Kind::Static, 12);
        hertz.into_iter().map(|f| f * std::f64::consts::TAU).collect::<Vec<_>>()
    };
    let middle = of(0.0);
    let beside = of(0.3);
    near(
        &[beside[2], beside[3], beside[5]],
        &[311.3956, 377.5087, 848.3337],
        3e-5,
    );
    near(&beside[..10], &middle, 8e-5);
    for (found, count) in [(middle[4], 1.0), (middle[9], 2.0)] {
        let wanted = (2.0 * count - 1.0) * std::f64::consts::PI / 4.0 * (20e3_f64 / 0.04).sqrt();
        near(&[found], &[wanted], 5e-5);
    }
}

/// `int F (L - x)^2 / E I + F / k G A dx`, and volume and centre of a frustum.
#[test]
fn a_cone_bends_as_the_integral_says() {
    let (length, young, radius) = (2.0_f64, 210e9, 0.05_f64);
    let shear = 6.0 * 1.3 / (7.0 + 6.0 * 0.3) * young / 2.6;
    let steps = 20_000;
    let wanted: f64 = (0..steps)
        .map(|step| length * (f64::from(step) + 0.5) / f64::from(steps))
        .map(|x| {
            let area = std::f64::consts::PI * (radius * (1.0 - 0.5 * x / length)).powi(2);
            let bending = area * area / (4.0 * std::f64::consts::PI);
            ((length - x).powi(2) / (young * bending) + 1.0 / (shear * area)) * length / f64::from(steps)
        })
        .sum();
    let of = |elements| {
        at_rest(&Taper {
            elements,
            ..Taper::default()
        })
    };
    let row = of(16);
    near(&row[1..2], &[wanted], 5e-6);
    let volume = std::f64::consts::PI * radius * radius * length * 7.0 / 12.0;
    near(&row[3..5], &[7850.0 * volume, 11.0 / 14.0], 1e-10);
    // In the middle the moment is 1 N m, the radius 37.5 mm, and the shear force counts less.
    near(&row[7..8], &[4.0 / (std::f64::consts::PI * 0.0375_f64.powi(3))], 1e-6);
    let frequencies = frequencies(
        &Taper {
            elements: 16,
            ..Taper::default()
        },
        Kind::Static,
        2,
    );
    assert!((frequencies[0] / frequencies[1] - 1.0).abs() < 1e-9, "{frequencies:?}");
}

/// Weights below a place, and lengthening of both ropes; at a step the strain jumps and the slope does not, so that the
/// rope of two parts converges with the first power of its elements.
#[test]
fn ropes_carry_what_hangs_below() {
    let of = |elements| at_rest(&Ropes { elements });
    let (weight, young) = (7850.0 * 9.81, 210e9);
    let lower = weight * 60.0 * 60.0 / 2.0 / young;
    let upper = weight * 40.0 * 40.0 / 2.0 / young + weight * 2e-4 * 60.0 * 40.0 / (young * 8e-4);
    let [coarse, fine] = [8, 16].map(of);
    let off = |row: &[f64]| 1.0 - row[0] / (lower + upper);
    assert!(
        off(&fine) > 0.0 && (off(&coarse) / off(&fine) - 2.0).abs() < 0.1,
        "{} {}",
        off(&coarse),
        off(&fine)
    );
    // int rho g L (1 - e^(-(L-x)/L)) / E dx
    let thin = weight * 100.0 * 100.0 * (-1.0_f64).exp() / young;
    // The strain is Green's.
    near(&fine[1..2], &[thin], 5e-5);
    let area = |to: f64| 8e-4 * 100.0 * (1.0 - (-to / 100.0_f64).exp());
    near(
        &fine[3..5],
        &[7850.0 * (8e-4 * 40.0 + 2e-4 * 60.0), 7850.0 * area(100.0)],
        1e-9,
    );
    let below = weight * (area(100.0) - area(50.0));
    near(&fine[6..9], &[weight * 2e-4 * 50.0, weight * 2e-4 * 60.0, below], 1e-6);
}

/// Rows between nodes are told.
#[test]
fn a_mesh_that_is_coarser_than_its_table_is_told() {
    let warnings = |elements| {
        let model = Stepped { elements };
        let mut scene = model.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        let start = scene.rest(0.0);
        let texts: Vec<String> = scene.warnings(&start).into_iter().map(|warning| warning.text).collect();
        texts.join("; ")
    };
    assert_eq!(warnings(5), "");
    assert!(
        warnings(4).contains("a step of table `rows` at x = 4.000000 m lies inside"),
        "{}",
        warnings(4)
    );
    assert!(warnings(1).contains("step"));
}

rncf::model! {
    /// A mast in two steps on elements of equal length.
    pub model Stepped {
        param elements: count = 5;
        table rows { x = [0, 4, 4, 10] m; EI = [3, 2, 1, 1] kN*m^2; }
        section pole {
            EA = 1 MN; GAy = 1 MN; GAz = 1 MN; GJ = 1 kN*m^2; EIy = rows.EI; EIz = rows.EI;
            mass = 2 kg/m; inertia_y = 0.1 kg*m; inertia_z = 0.1 kg*m;
        }
        body mast { spatial; line from [0, 0, 0] m to [10, 0, 0] m; mesh elements * beam(pole); }
        joint foot = clamp(mast.start, inertial);
        output top = mast.end.position;
    }
}

/// Both formulations and both ways of joints are one bar, far bent and turning.
#[test]
fn a_bar_in_its_turning_frame_is_the_bar_in_absolute_coordinates() {
    let bar = Bar {
        off: 0.1,
        turned: 0.3,
        moment: 6.0,
        speed: 2.0,
        elements: 3,
    };
    let run = |formulation, joints| {
        let mut scene = bar.build(formulation, joints).unwrap();
        let options = Options {
            rtol: 1e-7,
            ..Options::default()
        };
        let start = scene.rest(0.0);
        let mut integrator = Integrator::new(scene.as_mut(), start, 1.0, Method::Radau, options).unwrap();
        while integrator.step().unwrap() != Stop::End {}
        let state = integrator.state().clone();
        drop(integrator);
        let mut row = vec![0.0; scene.output_columns()];
        scene.outputs(&state, &mut row);
        row
    };
    let first = run(Formulation::Rncf, Joints::Eliminated);
    for (formulation, joints) in [
        (Formulation::Rncf, Joints::Multipliers),
        (Formulation::Ancf, Joints::Eliminated),
        (Formulation::Ancf, Joints::Multipliers),
    ] {
        let other = run(formulation, joints);
        let off: Vec<f64> = first.iter().zip(&other).map(|(a, b)| a - b).collect();
        println!("{} {}", short(&first), short(&off));
        assert!(off[..3].iter().all(|off| off.abs() < 2e-6 * 10.0), "{off:?}");
        assert!(off[3..].iter().all(|off| off.abs() < 1e-2), "{off:?}");
    }
}
