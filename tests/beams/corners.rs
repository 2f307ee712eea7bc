//! Bodies whose axis has corners, against a geometrically exact rod and closed forms.

use rncf::equilibrium::{Kind, Uniform};
use rncf::modes::{Wanted, modes};
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Stop};

use crate::blades::{at_rest, near};
use crate::scenes::{equilibrium, short};

rncf::model! {
    /// Two angles, one of full sections and one of a centre line, and a bent pipe that grows thinner all along.
    pub model Angles {
        /// Force at the end of the angle of full sections.
        param stiff_load = 1 MN;
        /// Force at the end of the centre line.
        param slender_load = 1 N;
        const leg = 1 m;

        table rows { x = [0, 2] m; mass = [10, 30] kg/m; turn = [0, 90] deg; }
        section bar {
            EA = 1.05e9 N; GAy = 3.43137255e8 N; GAz = 3.43137255e8 N; GJ = 1e5 N*m^2; EIy = 875000 N*m^2; EIz = 218750 N*m^2;
            mass = rows.mass; inertia_y = 0.03 kg*m; inertia_z = 0.01 kg*m;
        }
        body angle {
            spatial;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            mesh 16 * beam(bar);
        }
        joint root = clamp(angle.start, inertial);
        load push = force(angle.end, [stiff_load, 0, 0]);
        output x = angle.end.x - leg;
        output y = angle.end.y - leg;
        output mass = angle.mass;

        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 cm^2; second_moment = 1 cm^4; }
        body hook {
            planar xy;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            mesh 4 * cable(wire, steel);
        }
        joint hook_root = clamp(hook.start, inertial);
        load pull = force(hook.end, [slender_load, 0, 0]);
        output hook_x = hook.end.x - leg;
        output hook_y = hook.end.y - leg;
        output corner = hook[1].start.y;
        output moment = hook[0].end.moment;

        section round = circle(radius = 20 mm);
        body twisted {
            spatial;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            section_y [0, 0, 1];
            twist rows.turn;
            mesh 2 * beam(round, steel);
        }
        joint twisted_root = clamp(twisted.start, inertial);
        output turned = twisted[0].end.ey.z;
        output turned_on = twisted.end.ey.z;
    }
}

#[test]
fn a_body_with_corners_bends_as_one() {
    // EXUDYN's LShapeGeomExactBeam2D, converged; a geometrically exact rod.
    let found = at_rest(&Angles::default());
    near(&found[..2], &[0.8592284754, -0.9140520497], 3e-6);
    let less = Angles {
        stiff_load: 0.1e6,
        ..Default::default()
    };
    near(&at_rest(&less)[..2], &[0.4463495787, -0.2849543354], 3e-6);
    // The table runs on behind the corner, from 10 to 30 kg/m.
    near(&found[2..3], &[40.0], 1e-12);
    // Small loads: P L^3/EI (1 + 1/3) + P L/EA, P L^3/(2 EI).
    let (bending, stretch) = (1.0 / (210e9 * 1e-8), 1.0 / (210e9 * 1e-4));
    near(
        &found[3..7],
        &[bending * 4.0 / 3.0 + stretch, -bending / 2.0, -bending / 2.0, -1.0],
        3e-3,
    );
    // The twist runs on, too: 45 and 90 deg about the axis.
    near(&found[7..8], &[0.5_f64.sqrt()], 1e-9);
    assert!(found[8].abs() < 1e-9, "{}", found[8]);
}

/// Frequencies about a uniform motion, rad/s.
fn frequencies(model: &impl Model, kind: Kind, count: usize) -> Vec<f64> {
    let (mut scene, state, _) = equilibrium(model, kind, 1.0);
    let at = Uniform {
        kind,
        ..Uniform::steady(0.0)
    };
    let found = modes(scene.as_mut(), &at, &state, Wanted { count }).unwrap();
    found.iter().map(|mode| mode.re.hypot(mode.im)).collect()
}

/// Determinant by elimination with pivots.
fn determinant<const N: usize>(mut a: [[f64; N]; N]) -> f64 {
    let mut product = 1.0;
    for k in 0..N {
        let pivot = (k..N).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        if pivot != k {
            a.swap(pivot, k);
            product = -product;
        }
        product *= a[k][k];
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            for j in k..N {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
    product
}

/// The conditions of two legs of 1 m at a right angle, clamped and free, at a frequency: Euler's and Bernoulli's beam with
/// waves along it, `v = [sin, cos, sinh, cosh](b s)`, `u = [sin, cos](k s)`.
fn right_angle(w: f64) -> f64 {
    let (young, area, second, density) = (210e9, 1e-4, 1e-8, 7850.0);
    let (stiff, bend, mass) = (young * area, young * second, density * area);
    let (k, b) = (w * f64::sqrt(mass / stiff), (mass * w * w / bend).powf(0.25));
    // Deflection, slope, moment, shear force of the four waves; shift and force of the two.
    let across = |s: f64| -> [[f64; 4]; 4] {
        let (sin, cos) = (b * s).sin_cos();
        let (sinh, cosh) = ((b * s).sinh(), (b * s).cosh());
        [
            [sin, cos, sinh, cosh],
            [b * cos, -b * sin, b * cosh, b * sinh],
            [-b * b * sin, -b * b * cos, b * b * sinh, b * b * cosh].map(|x| bend * x),
            [-b.powi(3) * cos, b.powi(3) * sin, b.powi(3) * cosh, b.powi(3) * sinh].map(|x| -bend * x),
        ]
    };
    let along = |s: f64| {
        let (sin, cos) = (k * s).sin_cos();
        [[sin, cos], [stiff * k * cos, -stiff * k * sin]]
    };
    let (mut rows, mut next) = ([[0.0; 12]; 12], 0);
    // Leg 1: columns 0..4 across (+y), 4..6 along (+x); leg 2: 6..10 across (-x), 10..12 along (+y).
    let mut row = |terms: &[(usize, &[f64], f64)]| {
        for (from, values, sign) in terms {
            for (at, value) in values.iter().enumerate() {
                rows[next][from + at] += sign * value;
            }
        }
        let size = rows[next].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        rows[next] = rows[next].map(|x| x / size);
        next += 1;
    };
    let (root, tip) = (across(0.0), across(1.0));
    let (drawn_root, drawn_tip) = (along(0.0), along(1.0));
    row(&[(0, &root[0], 1.0)]);
    row(&[(0, &root[1], 1.0)]);
    row(&[(4, &drawn_root[0], 1.0)]);
    // The corner: x, y, angle; force along x, along y, moment.
    row(&[(4, &drawn_tip[0], 1.0), (6, &root[0], 1.0)]);
    row(&[(0, &tip[0], 1.0), (10, &drawn_root[0], -1.0)]);
    row(&[(0, &tip[1], 1.0), (6, &root[1], -1.0)]);
    row(&[(4, &drawn_tip[1], 1.0), (6, &root[3], 1.0)]);
    row(&[(0, &tip[3], 1.0), (10, &drawn_root[1], -1.0)]);
    row(&[(0, &tip[2], 1.0), (6, &root[2], -1.0)]);
    row(&[(6, &tip[2], 1.0)]);
    row(&[(6, &tip[3], 1.0)]);
    row(&[(10, &drawn_tip[1], 1.0)]);
    determinant(rows)
}

rncf::model! {
    /// Two legs at a right angle.
    pub model Hook {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section wire { area = 1 cm^2; second_moment = 1 cm^4; }
        body hook {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m to [1, 1, 0] m;
            mesh 12 * cable(wire, steel);
        }
        joint root = clamp(hook.start, inertial);
        output tip = hook.end;
    }
}

#[test]
fn two_legs_at_a_right_angle_have_the_frequencies_of_euler_and_bernoulli() {
    let found = frequencies(&Hook::default(), Kind::Static, 5);
    let mut wanted = Vec::new();
    let (mut from, step) = (10.0, 1.0);
    while wanted.len() < 5 {
        let (mut low, mut high) = (from, from + step);
        from = high;
        if right_angle(low) * right_angle(high) < 0.0 {
            for _ in 0..60 {
                let middle = f64::midpoint(low, high);
                if right_angle(low) * right_angle(middle) < 0.0 {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            wanted.push(low);
        }
    }
    println!("{found:?} {wanted:?}");
    near(&found, &wanted, 1e-4);
}

/// A bent arm on a turning hub with a weight on a hinge at its end and a stay at its first corner, and bent wires in loops;
/// `$items` declares the arm and the wires.
macro_rules! bent {
    ($name:ident, { $($items:tt)* }) => {
        rncf::model! {
            pub model $name {
                param leg = 1 m;
                param lift = 0.3 m;
                param speed = 3 rad/s;
                const n = 2;
                material soft { density = 7850 kg/m^3; young = 20 GPa; poisson = 0.3; }
                section flat = rectangle(y = 40 mm, z = 20 mm);
                section wire { area = 1 cm^2; second_moment = 1 cm^4; }
                frame hub = rotating(axis = z, angle = speed * t);
                rigid bob in hub { mass = 2 kg; inertia = [0.01, 0.02, 0.03] kg*m^2; origin = [leg, leg, lift + leg]; }
                body stay in hub { spatial; line from [leg, 0 m, 0 m] to [2*leg, 0 m, 0 m]; section_y [1, 1, 1]; mesh 2 * beam(flat, soft); }
                $($items)*
            }
        }
    };
}

bent!(Bent, {
    body arm in hub {
        spatial;
        line from [0.1 m, 0 m, 0 m] to [leg, 0 m, 0 m] to [leg, leg, lift] to [leg, leg, lift + leg];
        section_y [1, 1, 1];
        mesh 2 * beam(flat, soft);
    }
    joint root = clamp(arm.start, hub);
    joint hinge = revolute(arm.end, bob, axis = y);
    joint branch = weld(arm[1].start, stay.start);
    load pull = force(arm[2].at(leg / 2), [0, 3, 10] N, in = hub);
    for i in 0..n {
        for j in 0..n {
            body hook[i][j] in hub {
                planar xy;
                line from [0 m, 0 m, 0 m] to [(i + 1) * leg, 0 m, 0 m] to [(i + 1) * leg, (j + 1) * leg, 0 m];
                mesh 2 * cable(wire, soft);
            }
            joint grip[i][j] = clamp(hook[i][j].start, hub);
            output tip[i][j] = hook[i][j].end;
        }
    }
    joint foot = pin(hook[0][0].end, hub);
    output place = arm.end;
    output weight = bob.position;
    output stay_end = stay.end;
    output energy = arm.kinetic_energy + arm.strain_energy;
    output push = arm.momentum.x;
    output moment = arm[1].start.moment_y;
    output low = min(i in 0..3, arm[i].end.z);
});

bent!(Welded, {
    body arm_0 in hub { spatial; line from [0.1 m, 0 m, 0 m] to [leg, 0 m, 0 m]; section_y [1, 1, 1]; mesh 2 * beam(flat, soft); }
    body arm_1 in hub { spatial; line from [leg, 0 m, 0 m] to [leg, leg, lift]; section_y [1, 1, 1]; mesh 2 * beam(flat, soft); }
    body arm_2 in hub { spatial; line from [leg, leg, lift] to [leg, leg, lift + leg]; section_y [1, 1, 1]; mesh 2 * beam(flat, soft); }
    joint corner_1 = weld(arm_0.end, arm_1.start);
    joint corner_2 = weld(arm_1.end, arm_2.start);
    joint root = clamp(arm_0.start, hub);
    joint hinge = revolute(arm_2.end, bob, axis = y);
    joint branch = weld(arm_1.start, stay.start);
    load pull = force(arm_2.at(leg / 2), [0, 3, 10] N, in = hub);
    for i in 0..n {
        for j in 0..n {
            body near[i][j] in hub { planar xy; line from [0 m, 0 m, 0 m] to [(i + 1) * leg, 0 m, 0 m]; mesh 2 * cable(wire, soft); }
            body far[i][j] in hub { planar xy; line from [(i + 1) * leg, 0 m, 0 m] to [(i + 1) * leg, (j + 1) * leg, 0 m]; mesh 2 * cable(wire, soft); }
            joint knee[i][j] = weld(near[i][j].end, far[i][j].start);
            joint grip[i][j] = clamp(near[i][j].start, hub);
            output tip[i][j] = far[i][j].end;
        }
    }
    joint foot = pin(far[0][0].end, hub);
    output place = arm_2.end;
    output weight = bob.position;
    output stay_end = stay.end;
    output energy = arm_0.kinetic_energy + arm_1.kinetic_energy + arm_2.kinetic_energy + arm_0.strain_energy + arm_1.strain_energy
        + arm_2.strain_energy;
    output push = arm_0.momentum.x + arm_1.momentum.x + arm_2.momentum.x;
    output moment = arm_1.start.moment_y;
    output low = min(min(arm_0.end.z, arm_1.end.z), arm_2.end.z);
});

/// Outputs after a time.
fn after(model: &impl Model, formulation: Formulation, joints: Joints, method: Method, end: f64) -> Vec<f64> {
    let mut scene = model.build(formulation, joints).unwrap();
    let start = scene.rest(0.0);
    let mut integrator = Integrator::new(scene.as_mut(), start, end, method, Options::default()).unwrap();
    while integrator.step().unwrap() != Stop::End {}
    let state = integrator.state().clone();
    let mut row = vec![0.0; integrator.system().output_columns()];
    integrator.system().outputs(&state, &mut row);
    row
}

/// By hand it is several bodies and welds: runs in both formulations, in a turning hub, with other joints at its ends and
/// corners, and small vibrations about the turning equilibrium.
#[test]
fn a_body_with_corners_moves_as_the_welded_one() {
    let (bent, welded) = (
        Bent {
            leg: 1.2,
            ..Bent::default()
        },
        Welded {
            leg: 1.2,
            ..Welded::default()
        },
    );
    let alike = |a: &[f64], b: &[f64]| {
        let off: Vec<f64> = a.iter().zip(b).map(|(a, b)| (a - b).abs() / b.abs().max(0.1)).collect();
        assert!(
            a.len() == b.len() && off.iter().all(|off| *off < 1e-9),
            "{a:?}: {}",
            short(&off)
        );
    };
    let in_time = [
        (Formulation::Rncf, Joints::Eliminated, Method::Radau),
        (
            Formulation::Rncf,
            Joints::Multipliers,
            Method::GeneralizedAlpha { rho_inf: 0.8 },
        ),
        (Formulation::Ancf, Joints::Eliminated, Method::Radau),
    ];
    for (formulation, joints, method) in in_time {
        let rows = (
            after(&bent, formulation, joints, method, 0.02),
            after(&welded, formulation, joints, method, 0.02),
        );
        alike(&rows.0, &rows.1);
    }
    for kind in [Kind::Static, Kind::Steady] {
        alike(&frequencies(&bent, kind, 6), &frequencies(&welded, kind, 6));
    }
}

rncf::model! {
    /// A bent rod that nothing holds.
    pub model Thrown {
        material soft { density = 2700 kg/m^3; young = 70 MPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        frame f = free(velocity = [1, 2, -1] m/s, angular_velocity = [1, 2, 6] rad/s);
        body rod in f { spatial; line from [0, 0, 0] m to [1, 0, 0] m to [1, 0.5, 0] m; mesh 2 * beam(round, soft); mean_axes; }
        output momentum = rod.momentum;
        output angular_momentum = rod.angular_momentum;
        output energy = rod.kinetic_energy + rod.strain_energy;
        output centre = (rod[0].mass * rod[0].center_of_mass + rod[1].mass * rod[1].center_of_mass) / rod.mass;
        output bend = rod.strain_energy;
    }
}

/// Of a free body the centre of mass goes straight on, and momenta and energy stay; the frame follows the first piece.
#[test]
fn a_thrown_body_with_corners_keeps_its_momenta() {
    let at = |formulation, end| after(&Thrown::default(), formulation, Joints::Eliminated, Method::Radau, end);
    let start = at(Formulation::Rncf, 1e-6);
    let mass = 2700.0 * std::f64::consts::PI * 4e-4 * 1.5;
    // Legs of 1 and 1/2: the centre at (2/3, 1/12), and it turns with the rod at the start.
    let centre = [2.0 / 3.0, 1.0 / 12.0, 0.0];
    let velocity = [
        1.0 - 6.0 / 12.0,
        2.0 + 6.0 * 2.0 / 3.0,
        -1.0 + 1.0 / 12.0 - 2.0 * 2.0 / 3.0,
    ];
    near(&start[..3], &velocity.map(|v| mass * v), 1e-6);
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        let row = at(formulation, 0.5);
        println!("{formulation:?} {row:?}");
        near(&row[..7], &start[..7], 1e-4);
        let wanted: Vec<f64> = (0..3).map(|i| centre[i] + 0.5 * velocity[i]).collect();
        near(&row[7..10], &wanted, 1e-5);
        assert!(row[10] > 1e-3 * row[6], "it bends: {row:?}");
    }
}
