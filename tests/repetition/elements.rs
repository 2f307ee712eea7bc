//! Elements and sections of their own in a loop, against the same ones written out and against their law.

use super::at_rest;

/// Strings that hang side by side, each with a law, a section and a weight of its own; `$items` declares them.
macro_rules! strings {
    ($name:ident, { $($items:tt)* }) => {
        rncf::model! {
            pub model $name {
                param stiffness = 200 N;
                param weight = 3 N;
                material light { density = 1 g/m^3; }
                $($items)*
            }
        }
    };
}

strings!(Looped, {
    const n = 3;
    for i in 0..n {
        element string[i](section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = stiffness*(l^2/2 + i*l^4/4);
        }
        section round[i] = circle(radius = (1 + i) * 1 mm);
        body cord[i] { spatial; line from [i * 1 m, 0 m, 0 m] to [i * 1 m, 0 m, -1 m]; mesh 2 * string[i](round[i], light); }
        joint top[i] = pin(cord[i].start, inertial);
        load pull[i] = force(cord[i].end, [0 N, 0 N, -(i + 1) * weight]);
        output z[i] = cord[i].end.z;
        output mass[i] = cord[i].mass;
    }
});

strings!(WrittenOut, {
    element string_0(section, material) {
        domain xi in 0..1;
        vector r0 = r at 0, shape 1 - xi;
        vector r1 = r at 1, shape xi;
        field a = r_x;
        coefficient rhoA: kg/m = material.density * section.area;
        inertia r = rhoA;
        strain l = norm(a) - 1;
        energy stretching = stiffness*(l^2/2 + 0*l^4/4);
    }
    element string_1(section, material) {
        domain xi in 0..1;
        vector r0 = r at 0, shape 1 - xi;
        vector r1 = r at 1, shape xi;
        field a = r_x;
        coefficient rhoA: kg/m = material.density * section.area;
        inertia r = rhoA;
        strain l = norm(a) - 1;
        energy stretching = stiffness*(l^2/2 + 1*l^4/4);
    }
    element string_2(section, material) {
        domain xi in 0..1;
        vector r0 = r at 0, shape 1 - xi;
        vector r1 = r at 1, shape xi;
        field a = r_x;
        coefficient rhoA: kg/m = material.density * section.area;
        inertia r = rhoA;
        strain l = norm(a) - 1;
        energy stretching = stiffness*(l^2/2 + 2*l^4/4);
    }
    section round_0 = circle(radius = 1 mm);
    section round_1 = circle(radius = 2 mm);
    section round_2 = circle(radius = 3 mm);
    body cord_0 { spatial; line from [0, 0, 0] m to [0, 0, -1] m; mesh 2 * string_0(round_0, light); }
    body cord_1 { spatial; line from [1, 0, 0] m to [1, 0, -1] m; mesh 2 * string_1(round_1, light); }
    body cord_2 { spatial; line from [2, 0, 0] m to [2, 0, -1] m; mesh 2 * string_2(round_2, light); }
    joint top_0 = pin(cord_0.start, inertial);
    joint top_1 = pin(cord_1.start, inertial);
    joint top_2 = pin(cord_2.start, inertial);
    load pull_0 = force(cord_0.end, [0 N, 0 N, -1 * weight]);
    load pull_1 = force(cord_1.end, [0 N, 0 N, -2 * weight]);
    load pull_2 = force(cord_2.end, [0 N, 0 N, -3 * weight]);
    output z_0 = cord_0.end.z;
    output mass_0 = cord_0.mass;
    output z_1 = cord_1.end.z;
    output mass_1 = cord_1.mass;
    output z_2 = cord_2.end.z;
    output mass_2 = cord_2.mass;
});

#[test]
fn each_repetition_has_its_own_element_and_section() {
    let (looped, single) = (at_rest(&Looped::default()), at_rest(&WrittenOut::default()));
    assert_eq!(looped, single);
    for (i, values) in looped.chunks(2).enumerate() {
        let (number, l) = (i as f64, -values[0] - 1.0);
        let force = 200.0 * (l + number * l.powi(3));
        assert!((force / (3.0 * (number + 1.0)) - 1.0).abs() < 1e-6, "{i}: {l} {force}");
        let mass = std::f64::consts::PI * (1e-3 * (number + 1.0)).powi(2) * 1e-3;
        assert!((values[1] / mass - 1.0).abs() < 1e-9, "{i}: {}", values[1]);
    }
}
