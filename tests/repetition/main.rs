//! Loops and shared nodes: models with them against the same models written out.

// Models from one template do not use all of its params.
#![allow(deprecated)]

mod counts;
mod elements;
mod sections;
mod unfolded;

use rncf::equilibrium::{Kind, Uniform, follow};
use rncf::prelude::*;
use rncf::system::State;

/// Three pendulums on a spinning free core, and wires of a net in a prescribed frame; `$items` declares the pendulums.
macro_rules! pendulums {
    ($name:ident, { $($items:tt)* }) => {
        rncf::model! {
            pub model $name {
                param count: count = 3;
                param speed = 1.5 rad/s;
                material rubber { density = 1000 kg/m^3; young = 20 MPa; poisson = 0.3; }
                section round = circle(radius = 8 mm);
                frame core = free(origin = [0.5, 0, 0] m, angular_velocity = [0.3 [rad/s], 0.2 [rad/s], speed]);
                rigid weight { mass = 3 kg; inertia = [0.2, 0.3, 0.4] kg*m^2; origin = [0, 0, 2] m; }
                fixture hub on core { mass = 2 kg; inertia = [0.1, 0.1, 0.2] kg*m^2; }
                load gravity = gravity([0, 0, -9.81] m/s^2);
                $($items)*
            }
        }
    };
}

pendulums!(Repeated, {
    for a in 0..count {
        body arm[a] in core {
            spatial;
            line from [0.1 m, 0.2 m * a, 0 m] to [0.4 m + 0.1 m * a, 0.2 m * a, 0 m];
            mesh 2 * cable(round, rubber);
            initial position [0.1 m + x, 0.2 m * a + 0.1 * (a + 1) * x^2 / (1 m), 0 m];
        }
        joint root[a] = pin(arm[a].start, core);
        fixture ball[a] on arm[a].end { mass = 0.1 kg + 0.05 kg * a; }
    }
    output first = arm[0].end;
    output last = arm[count - 1].end;
    output highest = max(a in 0..count, arm[a].end.y);
    output lowest = min(k in 0..count, arm[k].end.z);
    output all = sum(a in 0..count, (a + 1) * arm[a].end.x);
    output tension = mean(a in 0..count, arm[a].start.axial_force);
});

pendulums!(Single, {
    body arm_0 in core {
        spatial;
        line from [0.1 m, 0.2 m * 0, 0 m] to [0.4 m + 0.1 m * 0, 0.2 m * 0, 0 m];
        mesh 2 * cable(round, rubber);
        initial position [0.1 m + x, 0.2 m * 0 + 0.1 * (0 + 1) * x^2 / (1 m), 0 m];
    }
    body arm_1 in core {
        spatial;
        line from [0.1 m, 0.2 m * 1, 0 m] to [0.4 m + 0.1 m * 1, 0.2 m * 1, 0 m];
        mesh 2 * cable(round, rubber);
        initial position [0.1 m + x, 0.2 m * 1 + 0.1 * (1 + 1) * x^2 / (1 m), 0 m];
    }
    body arm_2 in core {
        spatial;
        line from [0.1 m, 0.2 m * 2, 0 m] to [0.4 m + 0.1 m * 2, 0.2 m * 2, 0 m];
        mesh 2 * cable(round, rubber);
        initial position [0.1 m + x, 0.2 m * 2 + 0.1 * (2 + 1) * x^2 / (1 m), 0 m];
    }
    joint root_0 = pin(arm_0.start, core);
    joint root_1 = pin(arm_1.start, core);
    joint root_2 = pin(arm_2.start, core);
    fixture ball_0 on arm_0.end { mass = 0.1 kg + 0.05 kg * 0; }
    fixture ball_1 on arm_1.end { mass = 0.1 kg + 0.05 kg * 1; }
    fixture ball_2 on arm_2.end { mass = 0.1 kg + 0.05 kg * 2; }
    output first = arm_0.end;
    output last = arm_2.end;
    output highest = max(max(arm_0.end.y, arm_1.end.y), arm_2.end.y);
    output lowest = min(min(arm_0.end.z, arm_1.end.z), arm_2.end.z);
    output all = arm_0.end.x + 2 * arm_1.end.x + 3 * arm_2.end.x;
    output tension = (arm_0.start.axial_force + arm_1.start.axial_force + arm_2.start.axial_force) / 3;
});

/// Outputs of a run, step by step.
fn run(scene: &mut dyn Scene, end: f64, rtol: f64, step: StepSize) -> Vec<Vec<f64>> {
    let start = scene.rest(0.0);
    let options = Options {
        rtol,
        step,
        ..Options::default()
    };
    let mut rows = Vec::new();
    let mut row = vec![0.0; scene.output_columns()];
    let mut integrator = Integrator::new(scene, start, end, Method::Radau, options).unwrap();
    while integrator.state().t < end {
        integrator.step().unwrap();
        let state: State = integrator.state().clone();
        integrator.system().outputs(&state, &mut row);
        rows.push(row.clone());
    }
    rows
}

/// Outputs of the equilibrium at rest.
fn at_rest(model: &impl Model) -> Vec<f64> {
    let mut scene = scene(model);
    let at = Uniform {
        kind: Kind::Static,
        ..Uniform::steady(0.0)
    };
    let found = follow(scene.as_mut(), &at, 1.0, |_, _| ()).unwrap();
    let mut row = vec![0.0; scene.output_columns()];
    let state = found.state().unwrap().clone();
    scene.uniform_outputs(&at, &state, &mut row);
    row
}

fn scene(model: &impl Model) -> Box<dyn Scene> {
    model.build(Formulation::Rncf, Joints::Eliminated).unwrap()
}

#[test]
fn repeated_bodies_move_bit_by_bit_as_single_ones() {
    let (mut repeated, mut single) = (scene(&Repeated::default()), scene(&Single::default()));
    let (found, wanted): (Vec<_>, Vec<_>) = [&mut repeated, &mut single]
        .map(|scene| run(&mut **scene, 0.3, 1e-7, StepSize::Adaptive))
        .into();
    assert_eq!(found, wanted);
    assert!(found.len() > 10);
    assert_eq!(repeated.describe_unknown(17), "body `arm[1]`, node 0, slope z");
}

rncf::model! {
    /// Wires in a row in a turning frame, their ends in common.
    pub model Row {
        param parts: count = 3;
        material rubber { density = 1000 kg/m^3; young = 20 MPa; }
        section round = circle(radius = 8 mm);
        motion phi(t) = 2 [rad/s^2] * t^2;
        frame hub = rotating(axis = z, angle = phi(t));
        load gravity = gravity([0, 0, -9.81] m/s^2);
        body first in hub { spatial; line from [0, 0, 0] m to [0.25, 0, 0] m; mesh 1 * cable(round, rubber); }
        for a in 0..parts {
            body wire[a] in hub {
                spatial; line from [0.25 m + 0.25 m * a, 0 m, 0 m] to [0.5 m + 0.25 m * a, 0 m, 0 m]; mesh 1 * cable(round, rubber);
            }
        }
        joint root = clamp(first.start, hub);
        joint begin = merge(first.end, wire[0].start);
        joint knot_0 = merge(wire[0].end, wire[1].start);
        joint knot_1 = merge(wire[2].start, wire[1].end);
        fixture ball on wire[2].end { mass = 0.05 kg; }
        output tip = wire[parts - 1].end;
    }
}

rncf::model! {
    /// The same as one wire.
    pub model Whole {
        material rubber { density = 1000 kg/m^3; young = 20 MPa; }
        section round = circle(radius = 8 mm);
        motion phi(t) = 2 [rad/s^2] * t^2;
        frame hub = rotating(axis = z, angle = phi(t));
        load gravity = gravity([0, 0, -9.81] m/s^2);
        body wire in hub { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(round, rubber); }
        joint root = clamp(wire.start, hub);
        fixture ball on wire.end { mass = 0.05 kg; }
        output tip = wire.end;
    }
}

#[test]
fn wires_with_merged_ends_move_as_one_wire() {
    for formulation in [Formulation::Rncf, Formulation::Ancf] {
        for joints in [Joints::Eliminated, Joints::Multipliers] {
            let mut row = Row::default().build(formulation, joints).unwrap();
            let mut whole = Whole::default().build(formulation, joints).unwrap();
            assert_eq!(row.unknowns(), whole.unknowns());
            // Tolerances are relative to the lengths of bodies, which differ: steps of one length.
            let (found, wanted): (Vec<_>, Vec<_>) = [&mut row, &mut whole]
                .map(|scene| run(&mut **scene, 0.3, 1e-11, StepSize::Fixed(2e-3)))
                .into();
            assert_eq!(found.len(), wanted.len());
            let pairs = found.iter().flatten().zip(wanted.iter().flatten());
            let apart = pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(apart < 1e-10, "{apart}");
            // It did move.
            assert!(wanted.last().unwrap()[2] < -0.05);
        }
    }
}

rncf::model! {
    /// A net: spokes on a free core, and a ring of chords whose ends are those of the spokes.
    pub model Net {
        param spokes: count = 3;
        param rim = 0.5 m;
        param near_at: count = 1;
        param far_at: count = 1;
        material rubber { density = 1000 kg/m^3; young = 20 MPa; }
        section round = circle(radius = 8 mm);
        frame core = free(angular_velocity = [0, 0, 3] rad/s);
        fixture hub on core { mass = 2 kg; inertia = [0.1, 0.1, 0.2] kg*m^2; }
        for a in 0..spokes {
            body spoke[a] in core {
                spatial;
                line from [0, 0, 0] m to [rim * cos(2*pi*a/spokes), rim * sin(2*pi*a/spokes), 0 m];
                mesh 2 * cable(round, rubber);
            }
            body chord[a] in core {
                spatial;
                line from [rim * cos(2*pi*a/spokes), rim * sin(2*pi*a/spokes), 0 m]
                    to [rim * cos(2*pi*(a + 1)/spokes), rim * sin(2*pi*(a + 1)/spokes), 0 m];
                mesh 1 * cable(round, rubber);
            }
            joint root[a] = clamp(spoke[a].start, core);
            joint near[a] = share(chord[a].start, spoke[a + near_at - 1].end);
            joint far[a] = share(chord[a].end, spoke[(a + far_at) % spokes].end);
            fixture ball[a] on spoke[a].end { mass = 0.1 kg; }
        }
        output least = min(a in 0..spokes, spoke[a].start.axial_force);
        output most = max(a in 0..spokes, spoke[a].start.axial_force);
        output chord = mean(a in 0..spokes, chord[a].start.axial_force);
    }
}

#[test]
fn a_net_of_any_number_of_spokes_stays_symmetric() {
    for spokes in [3, 5, 8] {
        let net = Net {
            spokes,
            ..Net::default()
        };
        let mut scene = scene(&net);
        // A spoke: norm of the root, two nodes; a chord: two slopes.
        assert_eq!(scene.unknowns(), spokes * (1 + 12 + 6) + 6);
        let rows = run(&mut *scene, 0.2, 1e-7, StepSize::Adaptive);
        let [least, most, chord] = rows.last().unwrap()[..] else {
            panic!("three outputs")
        };
        // The ring rings: at this time the spokes may be pushed or pulled, but all alike.
        assert!(least.abs() > 1e-2 && (most - least).abs() < 1e-6, "{least} {most}");
        assert!(chord.abs() > 1e-3, "{chord}");
    }
}

#[test]
fn what_does_not_fit_together_is_told_by_name() {
    let refused = |net: Net, formulation| net.build(formulation, Joints::Eliminated).err().unwrap().message;
    let message = refused(
        Net {
            near_at: 2,
            ..Net::default()
        },
        Formulation::Rncf,
    );
    for word in ["joint `near`", "`spoke`", "from 0 to 2", "`%`"] {
        assert!(message.contains(word), "{message}");
    }
    let message = refused(
        Net {
            far_at: 2,
            ..Net::default()
        },
        Formulation::Rncf,
    );
    for word in ["`far[0]`", "the end of `chord[0]`", "the end of `spoke[2]`", "m apart"] {
        assert!(message.contains(word), "{message}");
    }
    let message = refused(Net::default(), Formulation::Ancf);
    for word in ["`root`", "repeated body `spoke`", "referenced formulation"] {
        assert!(message.contains(word), "{message}");
    }
}
