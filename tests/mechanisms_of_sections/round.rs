//! A section that is alike in all directions bends and twists alike, wherever its y axis points.

use crate::running::{WAYS, apart, at_rest, build, rows, run};

rncf::model! {
    /// The same soft rod under the same load three times, with its section turned about its axis; for three laws.
    pub model Round {
        param pull = 8 N;
        param turn = 0.4 N*m;
        param angle = 20 deg;
        const mu = 8 MPa;
        material rubber { density = 1000 kg/m^3; young = 20 MPa; poisson = 0.3; }
        material hooke { density = 1000 kg/m^3; energy = mu * (E.xx^2 + E.yy^2 + E.zz^2 + 2 * (E.xy^2 + E.xz^2 + E.yz^2)) + mu / 2 * (E.xx + E.yy + E.zz)^2; }
        section round = circle(radius = 20 mm);
        section square = rectangle(y = 35 mm, z = 35 mm);
        body plain_0 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, 1, 0]; mesh 2 * beam(round, rubber); }
        joint root_plain_0 = clamp(plain_0.start, inertial);
        load pull_plain_0 = force(plain_0.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_plain_0 = moment(plain_0.end, [turn, -turn, 2 * turn]);
        output end_plain_0 = plain_0.end;
        output force_plain_0 = plain_0.at(0.1 m).axial_force;
        output moment_plain_0 = root_plain_0.moment;
        body plain_1 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, cos(angle), sin(angle)]; mesh 2 * beam(round, rubber); }
        joint root_plain_1 = clamp(plain_1.start, inertial);
        load pull_plain_1 = force(plain_1.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_plain_1 = moment(plain_1.end, [turn, -turn, 2 * turn]);
        output end_plain_1 = plain_1.end;
        output force_plain_1 = plain_1.at(0.1 m).axial_force;
        output moment_plain_1 = root_plain_1.moment;
        body plain_2 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, 1, 0]; mesh 2 * beam(square, rubber); }
        joint root_plain_2 = clamp(plain_2.start, inertial);
        load pull_plain_2 = force(plain_2.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_plain_2 = moment(plain_2.end, [turn, -turn, 2 * turn]);
        output end_plain_2 = plain_2.end;
        output force_plain_2 = plain_2.at(0.1 m).axial_force;
        output moment_plain_2 = root_plain_2.moment;
        body plain_3 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, cos(angle), sin(angle)]; mesh 2 * beam(square, rubber); }
        joint root_plain_3 = clamp(plain_3.start, inertial);
        load pull_plain_3 = force(plain_3.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_plain_3 = moment(plain_3.end, [turn, -turn, 2 * turn]);
        output end_plain_3 = plain_3.end;
        output force_plain_3 = plain_3.at(0.1 m).axial_force;
        output moment_plain_3 = root_plain_3.moment;
        body lateral_0 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, 1, 0]; mesh 2 * beam(round, rubber, coupling = poisson); }
        joint root_lateral_0 = clamp(lateral_0.start, inertial);
        load pull_lateral_0 = force(lateral_0.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_lateral_0 = moment(lateral_0.end, [turn, -turn, 2 * turn]);
        output end_lateral_0 = lateral_0.end;
        output force_lateral_0 = lateral_0.at(0.1 m).axial_force;
        output moment_lateral_0 = root_lateral_0.moment;
        body lateral_1 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, cos(angle), sin(angle)]; mesh 2 * beam(round, rubber, coupling = poisson); }
        joint root_lateral_1 = clamp(lateral_1.start, inertial);
        load pull_lateral_1 = force(lateral_1.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_lateral_1 = moment(lateral_1.end, [turn, -turn, 2 * turn]);
        output end_lateral_1 = lateral_1.end;
        output force_lateral_1 = lateral_1.at(0.1 m).axial_force;
        output moment_lateral_1 = root_lateral_1.moment;
        body energy_0 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, 1, 0]; mesh 2 * beam(round, hooke); }
        joint root_energy_0 = clamp(energy_0.start, inertial);
        load pull_energy_0 = force(energy_0.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_energy_0 = moment(energy_0.end, [turn, -turn, 2 * turn]);
        output end_energy_0 = energy_0.end;
        output force_energy_0 = energy_0.at(0.1 m).axial_force;
        output moment_energy_0 = root_energy_0.moment;
        body energy_1 { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; section_y [0, cos(angle), sin(angle)]; mesh 2 * beam(round, hooke); }
        joint root_energy_1 = clamp(energy_1.start, inertial);
        load pull_energy_1 = force(energy_1.end, [pull, 2 * pull, -1.5 * pull]);
        load turn_energy_1 = moment(energy_1.end, [turn, -turn, 2 * turn]);
        output end_energy_1 = energy_1.end;
        output force_energy_1 = energy_1.at(0.1 m).axial_force;
        output moment_energy_1 = root_energy_1.moment;
    }
}

/// Columns of one rod: place of its end, axial force, moment at its root.
const COLUMNS: usize = 7;

#[test]
fn sections_that_are_turned_about_their_axis_are_equal() {
    for way in [WAYS[0], WAYS[1]] {
        let row = at_rest(&Round::default(), way);
        for pair in row.chunks(2 * COLUMNS) {
            let (straight, turned) = pair.split_at(COLUMNS);
            // Far beyond the linear range.
            assert!(straight[1].hypot(straight[2]) > 0.05);
            for (a, b) in straight.iter().zip(turned) {
                assert!(
                    (a - b).abs() < 1e-10 * (1.0 + a.abs()),
                    "{way:?}: {straight:?} {turned:?}"
                );
            }
        }
    }
}

rncf::model! {
    /// The same rod clamped, and in a free frame that is tied to the end at which it is welded.
    pub model Welded {
        material rubber { density = 1000 kg/m^3; young = 20 MPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        frame own = free(origin = [0, 0, 0]);
        fixture core on own { mass = 1 kg; inertia = [1, 1, 1] g*m^2; }
        body clamped { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh 2 * beam(round, rubber); }
        body welded in own { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh 2 * beam(round, rubber); }
        joint root = clamp(clamped.start, inertial);
        joint tie = clamp(welded.start, own);
        joint seam = weld(inertial.at([0, 0, 0] m), welded.start);
        load first = force(clamped.end, [8, 16, -12] N);
        load second = force(welded.end, [8, 16, -12] N);
        output one = clamped.end;
        output other = welded.end;
        output one_force = root.moment;
        output other_force = seam.moment;
    }
}

/// A tie of a frame holds no shape: the section below it strains and shears as at a clamp.
#[test]
fn a_section_may_be_welded_and_its_own_frame_follow_it() {
    for way in [WAYS[0], WAYS[1]] {
        let row = at_rest(&Welded::default(), way);
        let off = |a: usize, b: usize, sign: f64| (0..3).all(|k| (row[a + k] - sign * row[b + k]).abs() < 1e-9);
        assert!(row[1] > 0.04 && off(0, 3, 1.0), "{way:?}: {row:?}");
        assert!(off(6, 9, 1.0) || off(6, 9, -1.0), "{way:?}: {row:?}");
    }
}

rncf::model! {
    /// A rod that is clamped in the rigid body in whose frame it is declared.
    pub model Carried {
        rigid hub { mass = 2 kg; inertia = [0.1, 0.2, 0.15] kg*m^2; origin = [0.3, 0.1, 0] m; axis = [1, 2, 3]; angle = 0.4 rad; }
        material rubber { density = 1100 kg/m^3; young = 1 GPa; poisson = 0.3; damping = 1 ms; }
        section strip = rectangle(y = 30 mm, z = 20 mm);
        body rod in hub { spatial; line from [0.2, 0.1, 0] m to [0.7, 0.4, 0.2] m; section_y [0, 1, 1]; mesh 1 * beam(strip, rubber); }
        joint hinge = revolute(inertial.at([0.3, 0.1, 0] m), hub, axis = [0, 0, 1]);
        joint root = clamp(rod.start, hub);
        load push = force(rod.end, [3, 5, -4] N, in = inertial);
        output force = root.force;
        output moment = root.moment;
        output bending = sqrt(rod.start.torque^2 + rod.start.moment_y^2 + rod.start.moment_z^2);
    }
}

/// In absolute coordinates rows of markers stand for the clamp; directions of the frame in which the body is declared belong
/// to the other party there.
#[test]
fn a_clamp_in_a_moving_frame_has_one_moment_in_both_formulations() {
    let [referenced, absolute] = [WAYS[0], WAYS[2]].map(|way| {
        let mut scene = build(&Carried::default(), way);
        let states = run(scene.as_mut(), 0.2, 4, 1e-7);
        rows(scene.as_mut(), &states)
    });
    let last = &referenced[4];
    let moment = last[3..6].iter().map(|m| m * m).sum::<f64>().sqrt();
    assert!(
        moment > 1.0 && (moment / last[6] - 1.0).abs() < 1e-6,
        "{moment} {}",
        last[6]
    );
    assert!(
        apart(&referenced, &absolute, 0..7) < 1e-3,
        "{referenced:?} {absolute:?}"
    );
}
