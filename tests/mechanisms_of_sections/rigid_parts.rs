//! Rigid parts wherever they can be: in all ways to write a model its motion is the same, and momenta are kept.

use rncf::Model;
use rncf_reference::tangents::compare_tangents;

use crate::running::{WAYS, apart, build, rows, run};

rncf::model! {
    /// On clamped sections, two inside one element, on a bent and twisted body between nodes, beside a weld; nothing acts from outside.
    pub model Everywhere {
        param elements: count = 2;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        frame hub = free(velocity = [1, 2, 3] m/s, angular_velocity = [3, -2, 4] rad/s);
        fixture core on hub { mass = 5 kg; inertia = [0.1, 0.2, 0.25] kg*m^2; }
        body full in hub { spatial; line from [0, 0, 0] m to [0.6, 0, 0] m; mesh elements * beam(bar, alloy); }
        joint full_root = clamp_full(full.start, hub);
        fixture full_base on full.start { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        fixture full_tip on full.end { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        body half in hub { spatial; line from [0, 0, 0] m to [0, 0.6, 0] m; mesh elements * beam(bar, alloy); }
        joint half_root = clamp(half.start, hub);
        fixture half_base on half.start { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        fixture half_first on half.at(0.2 m) { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        fixture half_second on half.at(0.25 m) { mass = 0.5 kg; center = [-10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        body bow in hub { spatial; arc from [0, 0, 0] m direction [0, 0, 1] normal [0, 1, 0] radius 0.5 m angle 80 deg; twist 40 deg; mesh elements * beam(bar, alloy); }
        joint bow_root = clamp(bow.start, hub);
        fixture bow_first on bow.at(0.13 m) { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        body on in hub { spatial; line from [0, 0, 0] m to [0, 0, -0.5] m; mesh elements * beam(bar, alloy); }
        joint on_root = clamp(on.start, hub);
        rigid tool { mass = 1 kg; inertia = [1, 2, 2.5] g*m^2; origin = [0, 0, -0.5] m; velocity = [2, 3.5, 3] m/s; angular_velocity = [3, -2, 4] rad/s; }
        joint held = weld(on.end, tool);
        fixture on_tip on on.end { mass = 1 kg; center = [10, 20, 30] mm; inertia = [1, 2, 2.5] g*m^2; }
        output a = full.end.in(inertial);
        output b = half.end.in(inertial);
        output c = bow.end.in(inertial);
        output d = on.end.in(inertial);
        output l = total.angular_momentum;
        output p = total.momentum;
    }
}

rncf::model! {
    /// Between nodes of an arc, and on its end, in a plane.
    pub model Flat {
        param elements: count = 2;
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section bar = rectangle(y = 30 mm, z = 20 mm);
        frame hub = free(plane = xy, velocity = [1, 2, 0] m/s, speed = 4 rad/s);
        body bow in hub { planar xy; mean_axes; arc from [0, 0, 0] m direction [0, 1, 0] radius 0.5 m angle 80 deg; mesh elements * beam(bar, alloy); }
        fixture first on bow.at(0.13 m) { mass = 1 kg; center = [10, 20, 0] mm; inertia = 2 g*m^2; }
        fixture second on bow.end { mass = 1 kg; center = [0, 20, 0] mm; inertia = 2 g*m^2; }
        output c = bow.end.in(inertial);
        output l = total.angular_momentum.z;
        output p = total.momentum;
    }
}

/// Outputs are `places` coordinates, then momenta (to 1e-6 of the largest).
fn alike<M: Model>(model: &M, places: usize, end: f64) {
    let mut first: Option<Vec<Vec<f64>>> = None;
    for way in WAYS {
        let mut scene = build(model, way);
        let states = run(scene.as_mut(), end, 5, 1e-7);
        let rows = rows(scene.as_mut(), &states);
        let first = first.get_or_insert_with(|| rows.clone());
        let largest = rows[0][places..]
            .iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        let change = apart(&[rows[0].clone()], &[rows[5].clone()], places..rows[0].len());
        let far = apart(first, &rows, 0..places);
        println!("{way:?}: {far:.1e} m apart, momenta change by {change:.1e} of {largest:.1}");
        assert!(far < 2e-8 && change < 1e-6 * largest, "{far} {change}");
        // An arc of 30 mm has more stress at its inner side.
        let mut warnings = scene.warnings(&states[5]).into_iter();
        assert!(warnings.all(|warning| warning.text.contains("larger at the inner side by")));
    }
    for (formulation, joints) in [WAYS[0], WAYS[2]] {
        compare_tangents(model, formulation, joints);
    }
}

#[test]
fn in_space() {
    alike(&Everywhere::default(), 12, 0.02);
}

#[test]
fn in_a_plane() {
    alike(&Flat::default(), 2, 0.05);
}
