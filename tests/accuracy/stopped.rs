//! What dry friction has stopped stays where it is, however steep the curve through zero that stands for the jump of its law.

use rncf::app::{RunSettings, run};
use rncf::{Method, Options};

rncf::model! {
    /// A disc that coasts down in air and in its bearing.
    pub model Coast {
        /// Speed at the start.
        param w0 = 300 rad/s;
        /// Of the air.
        param cw = 1e-4 N*m*s^2;
        /// Of the bearing.
        param friction = 0.5 N*m;
        /// Speed within which the friction changes its sign.
        param width = 1e-4 rad/s;
        rigid disc { plane xy; mass = 3 kg; inertia = 0.05 kg*m^2; speed = w0; }
        joint bearing = revolute(inertial, disc);
        load drag = moment(disc, [0, 0, -cw * abs(disc.speed) * disc.speed - friction * tanh(disc.speed / width)]);
        output speed = disc.speed;
        run { t_end = 12 s; every = 0.01 s; }
    }
}

/// `J w' = -cw w^2 - friction`, and rest from where w is zero.
fn exact(model: &Coast, t: f64) -> f64 {
    let scale = (model.friction / model.cw).sqrt();
    let rate = (model.friction * model.cw).sqrt() / 0.05;
    let angle = (model.w0 / scale).atan() - rate * t;
    if angle > 0.0 { scale * angle.tan() } else { 0.0 }
}

/// Newton's iteration contracts slowly where the law saturates. Taken for round-off, its remainders were speeds outside of the
/// width, which friction does not bring back at once: discs leapt up from rest, to 1 rad/s and to 35.
#[test]
fn friction_that_has_stopped_a_disc_holds_it() {
    for method in [Method::Radau, Method::Radau9] {
        for width in [1e-5, 1e-7, 1e-9] {
            let model = Coast {
                width,
                ..Coast::default()
            };
            let options = Options {
                rtol: 1e-6,
                ..Options::default()
            };
            let found = run(
                &model,
                &RunSettings {
                    method,
                    options,
                    ..RunSettings::default()
                },
            )
            .unwrap();
            for (t, speed) in found.history.keys.iter().zip(&found.history.values) {
                let error = (speed - exact(&model, *t)).abs();
                assert!(error < 1e-6 * model.w0, "{method:?}, {width}: {error} at {t} s");
            }
            assert!(
                found.statistics.steps < 2000,
                "{method:?}, {width}: {}",
                found.statistics.steps
            );
        }
    }
}
