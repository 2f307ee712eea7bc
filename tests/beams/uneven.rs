//! Warnings of thick sections where these change along the axis: what counts is where the body bends, and in which direction.

use rncf::AnyModel;
use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// A rod on two supports whose first 20 mm have a radius of their own.
    pub model Stub {
        param first = 100 mm;
        param rest = 5 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        table part { x = [0, 0.02, 0.02, 1] m; of_first = [1, 1, 0, 0]; }
        section rod = circle(radius = first * part.of_first + rest * (1 - part.of_first));
        body b { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 at part * cable(rod, steel); }
        joint root = clamp(b.start, inertial);
        output y = b.end.y;
    }
}

rncf::model! {
    /// A thick shaft with a cone at one of its bearings.
    pub model Cone {
        param tip = 5 mm;
        param radius = 100 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        table part { x = [0, 0.1, 1] m; of_shaft = [0, 1, 1]; }
        section round = circle(radius = tip + (radius - tip) * part.of_shaft);
        body b { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 20 * cable(round, steel); }
        joint left = pin(b.start, inertial);
        joint right = hold(b.end.y);
        output y = b.end.y;
    }
}

rncf::model! {
    /// Half a ring of sheet metal, thin where it bends and wide across, in a plane and in space; and one that is deepest in its middle.
    pub model Sheet {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section strip = rectangle(y = 1 mm, z = 100 mm);
        table depth { eta = [0, 0.3, 0.7, 1]; h = [4, 40, 40, 4] mm; }
        section deep = rectangle(y = depth.h, z = 20 mm);
        body flat { planar xy; arc from [0, 0, 0] m direction [1, 0, 0] radius 50 mm angle 180 deg; mesh 12 * beam(strip, steel); }
        body spatial_one { spatial; arc from [1, 0, 0] m direction [1, 0, 0] normal [0, 0, 1] radius 50 mm angle 180 deg; section_y [0, 1, 0]; mesh 12 * beam(strip, steel); }
        body hook { planar xy; arc from [2, 0, 0] m direction [1, 0, 0] radius 50 mm angle 180 deg; mesh 12 * beam(deep, steel); }
        joint a = clamp(flat.start, inertial);
        joint b = clamp(spatial_one.start, inertial);
        joint c = clamp(hook.start, inertial);
        output y = flat.end.y; output z = spatial_one.end.y; output w = hook.end.y;
    }
}

fn told(model: &dyn AnyModel) -> Vec<String> {
    let settings = EquilibriumSettings {
        count: 1,
        ..EquilibriumSettings::default()
    };
    modes(model, &settings).unwrap().warnings
}

/// A beam with sections has the first frequency of the cone 17 % lower, and that of the rod on a thin neck 23 %; where 2 % of the length are thick, at the
/// clamp, both agree to 1e-4.
#[test]
fn shear_counts_where_the_body_bends() {
    let parts = |model: &dyn AnyModel| -> Option<f64> {
        let told = told(model)
            .into_iter()
            .find(|text| text.contains("shear and rotary inertia count"))?;
        told.split("by about ").nth(1)?.split(' ').next()?.parse().ok()
    };
    let cone = parts(&Cone::default()).expect("a warning");
    assert!((10.0..30.0).contains(&cone), "{cone}");
    let neck = Stub { first: 5e-3, rest: 0.1 };
    let neck = parts(&neck).expect("a warning");
    assert!((5.0..40.0).contains(&neck), "{neck}");
    assert_eq!(parts(&Stub::default()), None);
}

#[test]
fn what_is_wide_across_its_curve_is_thin() {
    let told = told(&Sheet {});
    assert!(
        !told.iter().any(|text| text.contains("are these the units")),
        "{told:?}"
    );
    let about = |name: &str, what: &str| told.iter().any(|text| text.contains(name) && text.contains(what));
    for name in ["`flat`", "`spatial_one`"] {
        assert!(!about(name, "turns it too far"), "{told:?}");
    }
    // h / 2R is 0.4 in the middle: three quarters of it.
    assert!(about("`hook`", "larger at the inner side by about 30 %"), "{told:?}");
    assert!(about("`hook`", "turns it too far"), "{told:?}");
}
