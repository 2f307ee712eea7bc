//! Rotors of several equal blades: every frequency is there as often as there are blades.

use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// Blades on flap hinges beside the axis of a hub.
    pub model Blades {
        param speed = 30 rad/s;
        param beside = 0.3 m;
        param tip = 6 m;
        const count = 6;
        section spar { EA = 1e9 N; GAy = 3e8 N; GAz = 3e8 N; GJ = 1 MN*m^2; EIy = 30 kN*m^2; EIz = 900 kN*m^2; mass = 8 kg/m; inertia_y = 1e-4 kg*m; inertia_z = 1e-3 kg*m; }
        frame hub = rotating(axis = z, angle = speed * t);
        for i in 0..count {
            body blade[i] in hub {
                spatial;
                line from beside * [cos(2*pi*i/count), sin(2*pi*i/count), 0] to tip * [cos(2*pi*i/count), sin(2*pi*i/count), 0];
                mesh 4 * beam(spar);
            }
            joint flap[i] = revolute(blade[i].start, hub, axis = [-sin(2*pi*i/count), cos(2*pi*i/count), 0]);
        }
        output reach = blade[0].end;
        run { t_end = 0.1 s; every = 10 ms; }
    }
}

/// Where one start of an iteration sees what is equal once.
#[test]
fn every_frequency_is_there_as_often_as_there_are_blades() {
    let model = Blades::default();
    let settings = EquilibriumSettings {
        count: 24,
        ..EquilibriumSettings::default()
    };
    let found = modes(&model, &settings).unwrap().modes;
    assert_eq!(found.len(), 24);
    let own: Vec<f64> = found.chunks(6).map(|equal| equal[0].im).collect();
    for (place, mode) in found.iter().enumerate() {
        let off = mode.im / own[place / 6] - 1.0;
        assert!(off.abs() < 1e-9 && mode.re.abs() < 1e-9 * mode.im, "{place}: {mode:?}");
    }
    assert!(own.windows(2).all(|pair| pair[1] > 1.1 * pair[0]), "{own:?}");
    // A stiff blade on a hinge beside the axis.
    let length = model.tip - model.beside;
    let flap = model.speed * (1.0 + 1.5 * model.beside / length).sqrt();
    assert!((own[0] / flap - 1.0).abs() < 5e-4, "{own:?} {flap}");
}
