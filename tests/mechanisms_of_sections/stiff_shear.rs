//! Beams that hardly shear: their lowest motions are soft beside a stiffness that is many orders larger.

use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// Two clamped beams by themselves, the second one hardly different and damped.
    pub model Beside {
        param elements: count = 8;
        param shear = 1e12 N;
        param apart = 1e-4;
        param damping = 0.1 ms;
        const n = 2;
        for i in 0..n {
            section bar[i] {
                EA = 56 MN; GAy = shear; GAz = shear; GJ = 2 kN*m^2;
                EIy = 7500 [N*m^2] * (1 + i * apart); EIz = 1875 [N*m^2] * (1 + i * apart);
                mass = 2 kg/m; inertia_y = 3e-4 kg*m; inertia_z = 7e-5 kg*m; damping = i * damping;
            }
            body beam[i] {
                spatial;
                line from [0 m, i * 1 m, 0 m] to [2 m, i * 1 m, 0 m];
                section_y [0, 1, 0];
                mesh elements * beam(bar[i]);
            }
            joint root[i] = clamp(beam[i].start, inertial);
        }
        output tip = beam[0].end;
        run { t_end = 0.1 s; every = 10 ms; }
    }
}

/// What is asked for is what is lowest, however few are asked for. Euler's clamped beam is the reference.
#[test]
fn none_of_the_lowest_is_lost() {
    let euler = |place: f64, stiffness: f64| (place / 2.0).powi(2) * f64::sqrt(stiffness / 2.0);
    let [first, second] = [1.875_104_068_7, 4.694_091_132_9];
    let alone = [euler(first, 1875.0), euler(first, 7500.0), euler(second, 1875.0)];
    for (shear, elements) in [(1e10, 8), (1e12, 8), (1e12, 20)] {
        let model = Beside {
            shear,
            elements,
            ..Beside::default()
        };
        for count in [1, 2, 3, 5] {
            let settings = EquilibriumSettings {
                count,
                ..EquilibriumSettings::default()
            };
            let found = modes(&model, &settings).unwrap().modes;
            assert_eq!(found.len(), count);
            for (place, mode) in found.iter().enumerate() {
                let euler = alone[place / 2] * f64::sqrt(1.0 + (place % 2) as f64 * model.apart);
                let off = mode.re.hypot(mode.im) / euler - 1.0;
                assert!(off.abs() < 2e-3, "{shear} {elements} {count}: {place} {mode:?} {euler}");
            }
            // The bar beside it differs by 5e-5, and both by that from each other.
            if let [one, other, ..] = &found[..] {
                let apart = other.re.hypot(other.im) / one.re.hypot(one.im) - 1.0;
                assert!(
                    (apart / (0.5 * model.apart) - 1.0).abs() < 0.05,
                    "{shear} {elements} {count}: {apart}"
                );
            }
        }
    }
}
