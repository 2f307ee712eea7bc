//! Notches and lumps along an axis: what no point of an element sees is told.

use rncf::app::{EquilibriumSettings, static_equilibria};

rncf::model! {
    /// A cantilever of 2 m whose stiffness has a notch of some millimetres in its middle, and one whose mass has a lump between rows of a table.
    pub model Notched {
        param n: count = 8;
        param depth = 0.999;
        param width = 3 mm;
        param force = 1 N;
        const EI = 1 kN*m^2;
        table lumps { x = [0, 0.998, 1, 1.002, 2] m; m = [3, 3, 2000, 3, 3] kg/m; interpolation = linear; }
        section notched { EA = 50 MN; GAy = 20 MN; GAz = 10 MN; GJ = 3 kN*m^2; EIy = EI * (1 - depth * exp(-((x - 1 m) / width)^2)); EIz = 18 kN*m^2; mass = 3 kg/m; inertia_y = 0.002 kg*m; inertia_z = 0.01 kg*m; }
        section lumped { EA = 50 MN; GAy = 20 MN; GAz = 10 MN; GJ = 3 kN*m^2; EIy = EI; EIz = 18 kN*m^2; mass = lumps.m; inertia_y = 0.002 kg*m; inertia_z = 0.01 kg*m; }
        section tapered { EA = 50 MN; GAy = 20 MN; GAz = 10 MN; GJ = 3 kN*m^2; EIy = EI * (1 - 0.45 * x / (1 m))^3; EIz = 18 kN*m^2; mass = 3 [kg/m] * (1 - 0.45 * x / (1 m)); inertia_y = 0.002 kg*m; inertia_z = 0.01 kg*m; }
        body a { spatial; line from [0, 0, 0] m to [2, 0, 0] m; section_y [0, 1, 0]; mesh n * beam(notched); }
        body b { spatial; line from [0, 1, 0] m to [2, 1, 0] m; section_y [0, 1, 0]; mesh n * beam(lumped); }
        body c { spatial; line from [0, 2, 0] m to [2, 2, 0] m; section_y [0, 1, 0]; mesh n * beam(tapered); }
        joint foot_a = clamp(a.start, inertial);
        joint foot_b = clamp(b.start, inertial);
        joint foot_c = clamp(c.start, inertial);
        load push = force(a.end, [0, 0, force]);
        output bend: mm = a.end.z;
        output mass = b.mass;
        output other = c.mass;
    }
}

/// A notch that no point saw bent by 0.889 mm for 0.986 mm, and "outputs differ by at most 2.4e-10" stood under it.
#[test]
fn what_lies_between_points_is_told() {
    let of = |model: Notched| {
        let found = static_equilibria(
            &model,
            &EquilibriumSettings {
                steps: 1,
                ..EquilibriumSettings::default()
            },
        )
        .unwrap();
        let told = |body: &str| {
            let start = format!("body `{body}`: its section or material changes between the points");
            found.warnings.iter().find(|note| note.starts_with(&start)).cloned()
        };
        (
            [told("a"), told("b"), told("c")],
            found.history.column(0).last().unwrap(),
        )
    };
    for n in [8, 16, 32] {
        let ([a, b, c], _) = of(Notched {
            n,
            ..Notched::default()
        });
        let (a, b) = (a.unwrap(), b.unwrap());
        assert!(a.contains("near x = 1.0") || a.contains("near x = 0.99"), "{a}");
        assert!(b.contains("near x = 1.0000 m of 2.0000 m"), "{b}");
        assert_eq!(c, None);
    }
    // A notch that the points see well.
    let wide = Notched {
        n: 64,
        width: 0.1,
        depth: 0.5,
        ..Notched::default()
    };
    let ([a, _, c], bend) = of(wide);
    assert_eq!([a, c], [None, None]);
    // F int (2 - x)^2 / EI dx by Simpson's rule, and F L / GA.
    let rigidity = |x: f64| 1e3 * (1.0 - 0.5 * (-((x - 1.0) / 0.1_f64).powi(2)).exp());
    let value = |x: f64| (2.0 - x).powi(2) / rigidity(x);
    let count = 20_000;
    let step = 2.0 / f64::from(count);
    let sum: f64 = (0..=count)
        .map(|place| {
            let weight = if place == 0 || place == count {
                1.0
            } else if place % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * value(step * f64::from(place)) * step / 3.0
        })
        .sum();
    let exact = 1e3 * (sum + 2.0 / 10e6);
    assert!((bend / exact - 1.0).abs() < 1e-4, "{bend} {exact}");
}

rncf::model! {
    /// A blade whose centre of mass lies on its axis at the root, and beside it from there on.
    pub model Leaving {
        param n: count = 8;
        section s { EA = 1 MN; GAy = 1 MN; GAz = 1 MN; GJ = 1 kN*m^2; EIy = 1 kN*m^2; EIz = 2 kN*m^2; mass = 2 kg/m; mass_y = 15 mm * x / 1 [m]; inertia_y = 0.001 kg*m; inertia_z = 0.02 kg*m; }
        body b { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh n * beam(s); }
        joint root = clamp(b.start, inertial);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output z = b.end.z;
        output turned = b.start.torque;
    }
}

/// Nothing yields by the inverse of an offset, of which "100 % are missed" where it begins at zero.
#[test]
fn an_offset_that_begins_at_zero_is_no_gap() {
    let found = static_equilibria(&Leaving::default(), &EquilibriumSettings::default()).unwrap();
    assert_eq!(found.warnings, Vec::<String>::new());
    // The weight turns about the axis: m g y (L^2 / 2), but for how far the section turns.
    let torque = found.history.column(1).last().unwrap();
    let exact: f64 = 2.0 * 9.81 * 0.015 * 2.0;
    assert!((torque.abs() / exact - 1.0).abs() < 1e-3, "{torque} {exact}");
}
