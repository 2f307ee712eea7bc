//! Designs: which values the parameters have at every point of a plan.

use super::random::{Random, normal_quantile};
use crate::AnyModel;
use crate::app::line::parameters::{Values, Varied};
use crate::app::line::plan::Design;
use crate::hash::hash;

/// Most points of a plan.
const MOST: usize = 1_000_000;

/// Values of the varied parameters, SI, one row for each point.
///
/// # Errors
/// A parameter whose values the design cannot lay out, and what would be right.
pub(super) fn points(
    model: &dyn AnyModel,
    varied: &[Varied],
    design: Design,
    seed: u64,
) -> Result<Vec<Vec<f64>>, String> {
    if varied.is_empty() {
        return Err("no parameter has several values: write `name=a,b,c`, `name=from..to in 9` or `name=normal(mean, deviation)`".into());
    }
    let name = |one: &Varied| model.params()[one.param].name;
    let count = match design {
        Design::Grid => {
            let mut count = 1_usize;
            for one in varied {
                count = count.saturating_mul(listed(one, name(one))?.len());
            }
            count
        }
        Design::Latin(count) | Design::Random(count) => count,
    };
    if count > MOST {
        return Err(format!(
            "the plan has {count} points, more than {MOST}: take fewer values"
        ));
    }
    let columns: Result<Vec<Vec<f64>>, String> = match design {
        Design::Grid => {
            let mut repeats = count;
            let column = |one: &Varied| {
                let values = listed(one, name(one))?;
                repeats /= values.len();
                Ok((0..count).map(|point| values[point / repeats % values.len()]).collect())
            };
            varied.iter().map(column).collect()
        }
        Design::Latin(_) | Design::Random(_) => {
            let column = |one: &Varied| {
                // A stream of its own: the values of a parameter do not depend on the others.
                let mut random = Random::new(seed ^ hash(name(one)));
                let strata = matches!(design, Design::Latin(_)).then(|| random.order(count));
                let place = |point: usize| match &strata {
                    Some(order) => (order[point] as f64 + random.unit()) / count as f64,
                    None => random.unit(),
                };
                Ok((0..count).map(place).map(|u| at(&one.values, u)).collect())
            };
            varied.iter().map(column).collect()
        }
    };
    let columns = columns?;
    Ok((0..count)
        .map(|point| columns.iter().map(|column| column[point]).collect())
        .collect())
}

/// The values of a parameter on a grid.
fn listed(one: &Varied, name: &str) -> Result<Vec<f64>, String> {
    match one.values {
        Values::List(ref values) => Ok(values.clone()),
        Values::Range(from, to, Some(parts)) => Ok((0..parts).map(|k| between(from, to, k, parts)).collect()),
        Values::Range(_, _, None) => Err(format!(
            "`{name}`: a grid needs the number of values, `{name}=from..to in 9`; `--samples 100` takes points of the whole range"
        )),
        Values::Normal(..) => Err(format!(
            "`{name}`: a grid has no distributions; say with `--samples 100` how many points are drawn"
        )),
    }
}

/// The `k`th of `parts` evenly spaced values, both ends among them.
fn between(from: f64, to: f64, k: u32, parts: u32) -> f64 {
    if k + 1 == parts {
        return to;
    }
    from + (to - from) * (f64::from(k) / f64::from(parts - 1))
}

/// The value below which a part `u` of the parameter's values lies.
fn at(values: &Values, u: f64) -> f64 {
    let pick = |count: usize| ((u * count as f64) as usize).min(count - 1);
    match *values {
        Values::List(ref values) => values[pick(values.len())],
        Values::Range(from, to, Some(parts)) => between(from, to, pick(parts as usize) as u32, parts),
        Values::Range(from, to, None) => from + (to - from) * u,
        Values::Normal(mean, deviation) => mean + deviation * normal_quantile(u),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    fn varied() -> Vec<Varied> {
        let one = |param, values| Varied { param, values };
        vec![
            one(1, Values::List(vec![2.0, 5.0])),
            one(0, Values::Range(1.0, 4.0, Some(4))),
        ]
    }

    #[test]
    fn a_grid_has_every_pair_and_both_ends() {
        let found = points(&Rotor::default(), &varied(), Design::Grid, 0).unwrap();
        let expected: Vec<Vec<f64>> = [2.0, 5.0]
            .iter()
            .flat_map(|a| [1.0, 2.0, 3.0, 4.0].map(|b| vec![*a, b]))
            .collect();
        assert_eq!(found, expected);
        let mut open = varied();
        open[1].values = Values::Range(1.0, 4.0, None);
        let error = points(&Rotor::default(), &open, Design::Grid, 0).unwrap_err();
        assert!(
            error.starts_with("`omega`: a grid needs the number of values"),
            "{error}"
        );
        let many = Values::Range(0.0, 1.0, Some(2_000_000));
        let many = [Varied { param: 0, values: many }];
        let error = points(&Rotor::default(), &many, Design::Grid, 0).unwrap_err();
        assert!(error.contains("2000000 points"), "{error}");
        assert!(points(&Rotor::default(), &[], Design::Grid, 0).is_err());
    }

    #[test]
    fn a_latin_hypercube_has_one_point_in_every_part() {
        let rotor = Rotor::default();
        let whole = [Varied {
            param: 0,
            values: Values::Range(10.0, 20.0, None),
        }];
        let found = points(&rotor, &whole, Design::Latin(40), 3).unwrap();
        let mut parts: Vec<usize> = found.iter().map(|point| ((point[0] - 10.0) * 4.0) as usize).collect();
        assert_ne!(parts, (0..40).collect::<Vec<_>>());
        parts.sort_unstable();
        assert_eq!(parts, (0..40).collect::<Vec<_>>());
        assert_eq!(found, points(&rotor, &whole, Design::Latin(40), 3).unwrap());
        assert_ne!(found, points(&rotor, &whole, Design::Latin(40), 4).unwrap());
        // One parameter more changes nothing for the first.
        let mut two = whole.to_vec();
        two.push(varied()[0].clone());
        let both = points(&rotor, &two, Design::Latin(40), 3).unwrap();
        assert!(found.iter().zip(&both).all(|(one, both)| one[0] == both[0]));
        assert_eq!(both.iter().filter(|point| point[1] == 2.0).count(), 20);
    }

    #[test]
    fn random_points_have_the_mean_and_deviation_asked_for() {
        let normal = [Varied {
            param: 2,
            values: Values::Normal(100.0, 5.0),
        }];
        for (design, within) in [(Design::Latin(4000), 0.01), (Design::Random(4000), 0.3)] {
            let found = points(&Rotor::default(), &normal, design, 1).unwrap();
            let mean = found.iter().map(|point| point[0]).sum::<f64>() / 4000.0;
            let square = found.iter().map(|point| (point[0] - mean).powi(2)).sum::<f64>() / 3999.0;
            assert!(
                (mean - 100.0).abs() < within && (square.sqrt() - 5.0).abs() < within,
                "{mean} {square}"
            );
        }
    }
}
