//! What joints do does not depend on how the scene lies in space, and what is zero for that reason stays a zero.

use std::ops::ControlFlow;

use rncf::app::{EquilibriumSettings, Judging, equilibria};
use rncf::equilibrium::Kind;

use crate::running::{WAYS, at_rest};

rncf::model! {
    /// Soft rods, each joined in its own way to what springs hold, all in a frame that is turned by `tilt`.
    pub model Turned {
        param tilt = 0 rad;
        param elements: count = 1;
        /// Of every force.
        const pull = 60 N;
        material rubber { density = 1000 kg/m^3; young = 20 MPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        frame place = rotating(axis = [1, -2, 3], angle = tilt);
        body weld_rod in place { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh elements * beam(round, rubber); }
        joint weld_root = clamp(weld_rod.start, place);
        rigid weld_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 0, 0] m; }
        joint weld = weld(weld_rod.end, weld_part);
        spring weld_one = bushing(weld_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 0.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring weld_two = bushing(weld_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 0.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load weld_pull = force(weld_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        output weld_force = weld.force.in(place);
        output weld_moment = weld.moment.in(place);
        output weld_root_force = weld_root.force;
        output weld_root_moment = weld_root.moment;
        output weld_torque = weld_rod.start.torque;
        output weld_at = weld_rod.end;
        body turn_rod in place { spatial; line from [0, 1, 0] m to [0.3, 1, 0] m; mesh elements * beam(round, rubber); }
        joint turn_root = clamp(turn_rod.start, place);
        rigid turn_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 1, 0] m; }
        joint turn = revolute(turn_rod.end, turn_part, axis = [1, 2, 2]);
        spring turn_one = bushing(turn_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 1.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring turn_two = bushing(turn_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 1.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load turn_pull = force(turn_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        spring turn_coil = torsional(turn, stiffness = 30 N*m/rad, angle = 0.3 rad);
        output turn_angle = turn.angle;
        output turn_force = turn.force.in(place);
        output turn_moment = turn.moment.in(place);
        output turn_root_force = turn_root.force;
        output turn_root_moment = turn_root.moment;
        output turn_torque = turn_rod.start.torque;
        output turn_at = turn_rod.end;
        body cross_over_rod in place { spatial; line from [0, 2, 0] m to [0.3, 2, 0] m; mesh elements * beam(round, rubber); }
        joint cross_over_root = clamp(cross_over_rod.start, place);
        rigid cross_over_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 2, 0] m; }
        joint cross_over = universal(cross_over_rod.end, cross_over_part, axis = y, cross = z);
        spring cross_over_one = bushing(cross_over_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 2.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring cross_over_two = bushing(cross_over_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 2.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load cross_over_pull = force(cross_over_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        output cross_over_force = cross_over.force.in(place);
        output cross_over_moment = cross_over.moment.in(place);
        output cross_over_root_force = cross_over_root.force;
        output cross_over_root_moment = cross_over_root.moment;
        output cross_over_torque = cross_over_rod.start.torque;
        output cross_over_at = cross_over_rod.end;
        body sleeve_rod in place { spatial; line from [0, 3, 0] m to [0.3, 3, 0] m; mesh elements * beam(round, rubber); }
        joint sleeve_root = clamp(sleeve_rod.start, place);
        rigid sleeve_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 3, 0] m; }
        joint sleeve = cylindrical(sleeve_rod.end, sleeve_part, axis = x);
        spring sleeve_one = bushing(sleeve_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 3.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring sleeve_two = bushing(sleeve_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 3.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load sleeve_pull = force(sleeve_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        output sleeve_force = sleeve.force.in(place);
        output sleeve_moment = sleeve.moment.in(place);
        output sleeve_root_force = sleeve_root.force;
        output sleeve_root_moment = sleeve_root.moment;
        output sleeve_torque = sleeve_rod.start.torque;
        output sleeve_at = sleeve_rod.end;
        body guide_rod in place { spatial; line from [0, 4, 0] m to [0.3, 4, 0] m; mesh elements * beam(round, rubber); }
        joint guide_root = clamp(guide_rod.start, place);
        rigid guide_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 4, 0] m; }
        joint guide = prismatic(guide_rod.end, guide_part, axis = [2, 1, 0]);
        spring guide_one = bushing(guide_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 4.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring guide_two = bushing(guide_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 4.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load guide_pull = force(guide_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        output guide_force = guide.force.in(place);
        output guide_moment = guide.moment.in(place);
        output guide_root_force = guide_root.force;
        output guide_root_moment = guide_root.moment;
        output guide_torque = guide_rod.start.torque;
        output guide_at = guide_rod.end;
        body plate_rod in place { spatial; line from [0, 5, 0] m to [0.3, 5, 0] m; mesh elements * beam(round, rubber); }
        joint plate_root = clamp(plate_rod.start, place);
        rigid plate_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 5, 0] m; }
        joint plate = planar(plate_rod.end, plate_part, axis = z);
        spring plate_one = bushing(plate_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 5.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring plate_two = bushing(plate_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 5.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load plate_pull = force(plate_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        output plate_force = plate.force.in(place);
        output plate_moment = plate.moment.in(place);
        output plate_root_force = plate_root.force;
        output plate_root_moment = plate_root.moment;
        output plate_torque = plate_rod.start.torque;
        output plate_at = plate_rod.end;
        body screw_rod in place { spatial; line from [0, 6, 0] m to [0.3, 6, 0] m; mesh elements * beam(round, rubber); }
        joint screw_root = clamp(screw_rod.start, place);
        rigid screw_part in place { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [0.3, 6, 0] m; }
        joint screw = revolute(screw_part, screw_rod.at(0.2 m), axis = [0, 1, 1]);
        spring screw_one = bushing(screw_part.at([0.1, 0.05, 0.02] m), place.at([0.4, 6.05, 0.02] m), stiffness = [1, 2, 1.5] kN/m);
        spring screw_two = bushing(screw_part.at([-0.02, 0.03, 0.1] m), place.at([0.28, 6.03, 0.1] m), stiffness = [2, 1, 1.2] kN/m);
        load screw_pull = force(screw_part.at([0.1, 0.05, 0.02] m), [pull, 0.7 * pull, -0.5 * pull], in = place);
        spring screw_coil = torsional(screw, stiffness = 30 N*m/rad, angle = 0.3 rad);
        output screw_angle = screw.angle;
        output screw_force = screw.force.in(place);
        output screw_moment = screw.moment.in(place);
        output screw_root_force = screw_root.force;
        output screw_root_moment = screw_root.moment;
        output screw_torque = screw_rod.start.torque;
        output screw_at = screw_rod.end;
        body pair_rod in place { spatial; line from [0, 7, 0] m to [0.3, 7, 0] m; mesh elements * beam(round, rubber); }
        joint pair_root = clamp(pair_rod.start, place);
        body pair_tail in place { spatial; line from [0.3, 7, 0] m to [0.6, 7, 0] m; mesh elements * beam(round, rubber); }
        joint pair = cylindrical(pair_rod.end, pair_tail.start, axis = [1, 1, 0]);
        spring pair_one = bushing(pair_tail.end, place.at([0.6, 7, 0] m), stiffness = [1, 2, 1.5] kN/m);
        spring pair_two = bushing(pair_tail.at(0.2 m), place.at([0.5, 7, 0] m), stiffness = [2, 1, 1.2] kN/m);
        load pair_pull = force(pair_tail.end, [pull, 0.7 * pull, -0.5 * pull], in = place);
        output pair_force = pair.force.in(place);
        output pair_moment = pair.moment.in(place);
        output pair_root_force = pair_root.force;
        output pair_root_moment = pair_root.moment;
        output pair_torque = pair_rod.start.torque;
        output pair_at = pair_rod.end;
    }
}

/// Turned copies of the scene have the same forces, moments and angles in their own axes.
#[test]
fn turned_copies_are_equal() {
    for way in [WAYS[0], WAYS[1]] {
        let first = at_rest(&Turned::default(), way);
        assert!(first.iter().any(|value| value.abs() > 1.0));
        for tilt in [0.4, 1.3, 2.9] {
            let model = Turned {
                tilt,
                ..Turned::default()
            };
            let row = at_rest(&model, way);
            for (column, (a, b)) in first.iter().zip(&row).enumerate() {
                assert!(
                    (a - b).abs() < 1e-9 * 60.0,
                    "{way:?}, turned by {tilt}: column {column} {a} {b}"
                );
            }
        }
    }
}

rncf::model! {
    /// A twisted blade with all its centres beside the axis; nothing pulls it across the plane in which it turns.
    pub model Turning {
        param elements: count = 12;
        param speed = 25 rad/s;
        frame hub = rotating(axis = z, angle = speed * t);
        section s {
            EA = 1 [MN] * (1 - 0.2 [1/m] * x); GAy = 400 [kN] * (1 - 0.2 [1/m] * x); GAz = 300 [kN] * (1 - 0.2 [1/m] * x)^2; GJ = 800 [N*m^2] * (1 - 0.2 [1/m] * x)^3; EIy = 1.2 [kN*m^2] * (1 - 0.2 [1/m] * x)^3; EIz = 2.5 [kN*m^2] * (1 - 0.2 [1/m] * x)^3;
            tension_y = 30 [mm] * (1 - 0.2 [1/m] * x); tension_z = -20 mm; shear_y = -40 [mm] * (1 - 0.2 [1/m] * x); shear_z = 50 mm; principal = 0.3 [rad] + 0.2 [rad/m] * x;
            mass = 3 [kg/m] * (1 - 0.2 [1/m] * x); mass_y = 50 [mm] * (1 - 0.2 [1/m] * x); mass_z = -30 mm; inertia_y = 0.003 kg*m; inertia_z = 0.005 kg*m; inertia_yz = 0.001 kg*m;
        }
        body blade in hub { spatial; line from [0.5, 0, 0] m to [2.5, 0, 0] m; section_y [0, 1, 0]; twist 0.4 [rad/m] * x - 0.15 [rad/m^2] * x^2; mesh elements * beam(s); }
        joint root = clamp(blade.start, hub);
        output across = blade.start.shear_z;
        output along = blade.start.axial_force;
    }
}

/// What is zero stays one of each mesh: 1e-5 N that differ by a quarter, beside 4 kN, blame no mesh.
#[test]
fn a_zero_blames_no_mesh() {
    let settings = EquilibriumSettings {
        judged: Judging::Affordable,
        ..EquilibriumSettings::default()
    };
    let found = equilibria(&Turning::default(), Kind::Steady, &settings, |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let [across, along] = [0, 1].map(|column| found.history.column(column).last().unwrap());
    assert!(across.abs() < 1e-7 * along && across != 0.0, "{across} {along}");
    assert_eq!(found.warnings, Vec::<String>::new());
}
