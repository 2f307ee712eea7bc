//! Radau IIA with five and with seven stages: orders of index 3, tolerances, and what they save where tolerances are tight.

use super::radau::{adaptive, errors_of_pendulum, orders, run_by};
use super::systems::Pendulum;
use crate::integrate::Method;

/// Positions converge with the order of the method, velocities with the stages, multipliers with one less (Hairer, Lubich & Roche
/// 1989, VII.4).
#[test]
fn orders_of_index_3_rise_with_the_stages() {
    for (method, steps, least) in [
        (Method::Radau9, [8.0, 16.0, 32.0], [8.5, 4.5, 3.5]),
        (Method::Radau13, [6.0, 12.0, 24.0], [10.0, 6.0, 5.0]),
    ] {
        let errors = errors_of_pendulum(method, &steps);
        for (errors, least) in errors.iter().zip(least) {
            println!("{method:?} {errors:?} {:?}", orders(errors));
            // Round-off ends it: with seven stages six steps find positions to ten digits.
            let above: Vec<f64> = errors.iter().copied().filter(|error| *error > 1e-11).collect();
            assert!(above.len() >= 2 || errors[0] < 1e-9, "{method:?}: {errors:?}");
            assert!(
                orders(&above).iter().all(|order| *order > least),
                "{method:?}: {errors:?} {:?}",
                orders(&above)
            );
        }
    }
}

#[test]
fn tolerances_are_met_with_fewer_evaluations() {
    let exact = Pendulum::at_rest().advance([0.0, -3.0], 0.0, 5.0);
    let errors_and_work = |method| {
        [1e-5, 1e-6, 1e-8, 1e-10].map(|rtol| {
            let mut pendulum = Pendulum::at_rest();
            let begin = pendulum.state(0.0, 0.0, -3.0);
            let (state, statistics) = run_by(method, &mut pendulum, begin, 5.0, adaptive(rtol), |_| {});
            let error = (state.x[0] - exact[0].cos()).hypot(state.x[1] - exact[0].sin());
            println!(
                "{method:?} {rtol:e}: {error:e}, {} residuals",
                statistics.residual_evaluations
            );
            assert!(error < 50.0 * rtol, "{method:?} {rtol:e}: {error:e}");
            (error, statistics.residual_evaluations)
        })
    };
    let [three, five, seven] = [Method::Radau, Method::Radau9, Method::Radau13].map(errors_and_work);
    for more in [five, seven] {
        assert!(3 * more[3].1 < three[3].1, "{more:?} {three:?}");
    }
}
