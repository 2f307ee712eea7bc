//! Torsion of strips that are pulled: what a `beam` of `young` leaves out is told, and a material by its `energy` has it.

use rncf::app::{EquilibriumSettings, modes, static_equilibria};

rncf::model! {
    /// One strip of 100 x 2 mm by `young`, and by the energy of the same material.
    pub model Strip {
        param pull = 40 kN;
        param torque = 0 N*m;
        param turned = 0 deg;
        const mu = 210 [GPa] / 2.6;
        const la = 2 * 0.3 / 0.4 * 210 [GPa] / 2.6;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        material same { density = 7850 kg/m^3; energy = la / 2 * (E.xx + E.yy + E.zz)^2 + mu * (E.xx^2 + E.yy^2 + E.zz^2 + 2*E.xy^2 + 2*E.xz^2 + 2*E.yz^2); }
        section flat = rectangle(y = 100 mm, z = 2 mm);
        body plain { spatial; line from [0, 0, 0] m to [1, 0, 0] m; section_y [0, 1, 0]; twist turned * x / (1 m); mesh 8 * beam(flat, steel); }
        body whole { spatial; line from [0, 1, 0] m to [1, 1, 0] m; section_y [0, 1, 0]; twist turned * x / (1 m); mesh 8 * beam(flat, same); }
        joint root = clamp(plain.start, inertial);
        joint other = clamp(whole.start, inertial);
        load pull_plain = force(plain.end, [pull, 0, 0]);
        load pull_whole = force(whole.end, [pull, 0, 0]);
        load turn_plain = moment(plain.end, [torque, 0, 0]);
        load turn_whole = moment(whole.end, [torque, 0, 0]);
        output plain_turn: deg = atan2(plain.end.ey.z, plain.end.ey.y);
        output whole_turn: deg = atan2(whole.end.ey.z, whole.end.ey.y);
    }
}

/// A strip under 200 MPa had the torsional frequency of the unloaded one, 200 rad/s for 321, without a word.
#[test]
fn torsion_under_tension_is_told_or_there() {
    let settings = EquilibriumSettings::default();
    let note = |warnings: &[String]| {
        let mut notes = warnings.iter().filter(|note| note.contains("stiff in torsion by"));
        let first = notes.next().cloned();
        assert_eq!(notes.next(), None);
        first
    };
    let found = modes(&Strip::default(), &EquilibriumSettings { count: 12, ..settings }).unwrap();
    let told = note(&found.warnings).unwrap();
    // N I_p / (A G J) by closed form.
    let (b, t) = (0.1_f64, 0.002_f64);
    let torsion = b * t.powi(3) / 3.0 * (1.0 - 0.63 * t / b);
    let part = 200e6 * (b * t) * (b * b + t * t) / 12.0 / (210e9 / 2.6 * torsion);
    let percent: f64 = told
        .split("in torsion by ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    assert!(
        told.starts_with("body `plain`") && (percent / 100.0 / part - 1.0).abs() < 3e-3,
        "{told} {part}"
    );
    // Of the other body the frequency is that of the closed form.
    let polar = b * t * (b * b + t * t) / 12.0;
    let torsional = |added: f64| {
        let speed = (210e9 / 2.6 * torsion * (1.0 + added) / (7850.0 * polar)).sqrt();
        0.5 * std::f64::consts::PI * speed
    };
    for exact in [torsional(0.0), torsional(part)] {
        let nearest = found
            .modes
            .iter()
            .map(|mode| (mode.im / exact - 1.0).abs())
            .fold(1.0, f64::min);
        assert!(nearest < 4e-3, "{exact} {nearest}");
    }
    for (pull, is_told) in [(0.0, false), (500.0, false), (2e3, true), (-2e3, true)] {
        let found = modes(
            &Strip {
                pull,
                ..Strip::default()
            },
            &settings,
        )
        .unwrap();
        assert_eq!(note(&found.warnings).is_some(), is_told, "{pull}: {:?}", found.warnings);
    }
    // By itself a twist stiffens, too: int r^4 dA tau^2 / 2.
    let found = static_equilibria(
        &Strip {
            pull: 0.0,
            torque: 10.0,
            ..Strip::default()
        },
        &EquilibriumSettings { steps: 4, ..settings },
    )
    .unwrap();
    assert!(note(&found.warnings).unwrap().contains("more stiff"));
    let [plain, whole] = [0, 1].map(|column| found.history.column(column).last().unwrap());
    assert!(
        (plain - 26.94).abs() < 0.05 && (whole - 24.49).abs() < 0.05,
        "{plain} {whole}"
    );
}
