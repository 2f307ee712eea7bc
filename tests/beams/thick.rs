//! Bodies that are too thick for their elements.

use rncf::app::{EquilibriumSettings, modes};

rncf::model! {
    /// A short bar between two bearings, by an element that knows no shear.
    pub model Short {
        param radius = 50 mm;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round = circle(radius = radius);
        body bar { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 8 * cable(round, steel); }
        joint left = pin(bar.start, inertial);
        joint right = hold(bar.end.y);
        output middle = bar.at(0.5 m).y;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// What a thick `cable` leaves out is told with the part of the lowest frequency of Timoshenko's beam on two bearings, and its square by the number.
#[test]
fn short_cables_are_told_to_lack_shear() {
    for radius in [0.01, 0.05, 0.08f64] {
        let settings = EquilibriumSettings::default();
        let found = modes(&Short { radius }, &settings).unwrap();
        let told = found.warnings.iter().find_map(|note| {
            let part = note.split("are too high by about ").nth(1)?;
            part.split(' ').next()?.parse::<f64>().ok()
        });
        // Of E / (k G) = 3: a^2 w^4 - (1 + a + 3 a) w^2 + .. with the squares of slenderness, in units of the frequency without either.
        let a = (0.5 * radius * std::f64::consts::PI).powi(2);
        let [square, linear] = [3.0 * a * a, 1.0 + 4.0 * a];
        let least = (linear - (linear * linear - 4.0 * square).sqrt()) / (2.0 * square);
        let more = 1.0 / least.sqrt() - 1.0;
        println!("{radius}: {more} {told:?}");
        match told {
            Some(percent) => assert!((percent / 100.0 / more - 1.0).abs() < 0.1, "{percent} % for {more}"),
            None => assert!(more < 0.01, "{more}"),
        }
        assert_eq!(told.is_some(), radius > 0.02);
    }
}
