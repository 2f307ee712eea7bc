//! Integration of a [`System`] by russell_ode to tight tolerances, with a check that two tolerances agree.

use crate::Result;
use crate::dense::Matrix;
use crate::system::System;
use russell_lab::Vector;
use russell_ode::{NoArgs, OdeSolver, Params};
use russell_sparse::{CooMatrix, Sym};

pub use russell_ode::Method;

/// States at the asked times, and how well two tolerances agree on them.
#[derive(Clone, Debug)]
pub struct Agreed {
    /// States at each time, by the tighter tolerance.
    pub states: Vec<Vec<f64>>,
    /// The same by ten times the tolerance: compare outputs of both to know an output's own error.
    pub loose: Vec<Vec<f64>>,
    /// Largest difference of any state at any time between the two tolerances.
    pub difference: f64,
    /// Steps accepted at the tighter tolerance.
    pub steps: usize,
}

/// Integrates with `tolerance` and ten times that, and returns the tighter result.
///
/// `times[0]` belongs to `start`; the integrator stops exactly at every further time (no interpolation), so that kinks
/// of a motion belong in the list. `tolerance` is both the absolute and the relative one of every state.
/// Use [`Method::Radau5`] for beams, [`Method::DoPri8`] where no state is stiff. russell_ode's Radau5 works with
/// `0.1 tolerance^(2/3)` inside, as its third-order error estimate wants; for the spin-up beam 1e-11 and 1e-12 are
/// right, while from 1e-13 on it resolves axial vibrations at the level of round-off in hundreds of times the steps.
///
/// # Errors
/// If the two results differ by more than `allowed` anywhere; as [`states`].
pub fn agreed(
    system: &impl System,
    method: Method,
    tolerance: f64,
    start: &[f64],
    times: &[f64],
    allowed: f64,
) -> Result<Agreed> {
    let (loose, _) = states(system, method, 10.0 * tolerance, start, times)?;
    let (tight, steps) = states(system, method, tolerance, start, times)?;
    let pairs = tight.iter().flatten().zip(loose.iter().flatten());
    let difference = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if difference > allowed {
        let text = format!("tolerances {tolerance:e} and ten times that differ by {difference:e}, allowed {allowed:e}");
        return Err(format!("{text}: tighten the tolerance or allow more"));
    }
    Ok(Agreed {
        states: tight,
        loose,
        difference,
        steps,
    })
}

/// States at `times` by one integration, and the number of accepted steps.
///
/// # Errors
/// If `start` has not one entry per state, `times` do not increase, the tolerance is refused, or the integrator fails.
pub fn states(
    system: &impl System,
    method: Method,
    tolerance: f64,
    start: &[f64],
    times: &[f64],
) -> Result<(Vec<Vec<f64>>, usize)> {
    if start.len() != system.size() {
        return Err(format!(
            "start has {} entries, the system has {} states",
            start.len(),
            system.size()
        ));
    }
    if times.is_empty() || times.windows(2).any(|pair| pair[1].is_nan() || pair[1] <= pair[0]) {
        return Err("times must hold the start and then increase".into());
    }
    let mut params = Params::new(method);
    params.set_tolerances(tolerance, tolerance, None)?;
    params.step.n_step_max = 10_000_000;
    // One thread: small systems, and the same result on every machine.
    params.radau5.concurrent = false;
    let mut solver = OdeSolver::new(params, adapter(system, method)?)?;
    let (mut y, mut states, mut steps) = (Vector::from(&start), vec![start.to_vec()], 0);
    for pair in times.windows(2) {
        solver
            .solve(&mut y, pair[0], pair[1], None, &mut 0, None)
            .map_err(|reason| format!("the integration from {} to {} s failed: {reason}", pair[0], pair[1]))?;
        states.push(y.as_data().to_vec());
        steps += solver.stats().n_accepted;
        // The last step of an interval may be a short rest, which is no measure for the next one.
        params.step.h_ini = solver.stats().h_accepted.max(0.5 * params.step.h_ini);
        solver.update_params(params)?;
    }
    Ok((states, steps))
}

/// The system in russell_ode's terms; the implicit method gets the mass matrix and the exact Jacobian.
fn adapter<'s, S: System>(system: &'s S, method: Method) -> Result<russell_ode::System<'s, NoArgs>> {
    let n = system.size();
    if method != Method::Radau5 {
        return Ok(russell_ode::System::new(n, move |f: &mut Vector, t, y: &Vector, _| {
            system.rate(t, y.as_data(), f.as_mut_data());
            Ok(())
        }));
    }
    let mut adapter = russell_ode::System::new(n, move |f: &mut Vector, t, y: &Vector, _: &mut NoArgs| {
        system.load(t, y.as_data(), f.as_mut_data());
        Ok(())
    });
    let pattern = system.pattern();
    adapter.set_jacobian(
        Some(pattern.len()),
        Sym::No,
        move |out: &mut CooMatrix, scale, t, y: &Vector, _| {
            let mut jacobian = Matrix::zero(n);
            system.load_jacobian(t, y.as_data(), &mut jacobian);
            out.reset();
            pattern
                .iter()
                .try_for_each(|&(i, j)| out.put(i, j, scale * jacobian.get(i, j)))
        },
    )?;
    if let Some(mass) = system.mass() {
        let places = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let places: Vec<_> = places.filter(|&(i, j)| mass.get(i, j) != 0.0).collect();
        adapter.set_mass(Some(places.len()), Sym::No, move |out: &mut CooMatrix| {
            for &(i, j) in &places {
                // In range and counted above, so that it cannot be refused.
                let _ = out.put(i, j, mass.get(i, j));
            }
        })?;
    }
    Ok(adapter)
}
