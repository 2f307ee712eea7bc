//! Arguments that can be meant, but hardly are: told before the work begins, and beside its results.

use crate::AnyModel;
use crate::app::writing::numbers::short;

/// Ratio of a param to its default beyond which it is hardly meant.
const FAR: f64 = 1e10;
/// Tolerance near the round-off of numbers.
const FINE: f64 = 1e-12;

/// One sentence for each param that is far from its default, and for a tolerance near round-off.
pub(in crate::app) fn doubts(model: &dyn AnyModel, rtol: f64) -> Vec<String> {
    let mut doubts = Vec::new();
    for (index, param) in model.params().iter().enumerate() {
        let ratio = (model.get(index) / param.default).abs();
        if ratio.is_finite() && ratio > 0.0 && !(1.0 / FAR..=FAR).contains(&ratio) {
            doubts.push(format!(
                "`{}` is {} {}, {ratio:.0e} times its default: is that its unit?",
                param.name,
                short(model.get(index) / param.unit_si),
                param.unit
            ));
        }
    }
    if rtol < FINE {
        doubts.push(format!(
            "the tolerance {rtol:e} is near the round-off of numbers, 2e-16, which steps cannot get below: expect many short ones"
        ));
    }
    doubts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    #[test]
    fn what_is_hardly_meant_is_told() {
        let mut rotor = Rotor::default();
        assert!(doubts(&rotor, 1e-6).is_empty() && doubts(&rotor, 1e-12).is_empty());
        assert!(doubts(&rotor, 1e-13)[0].contains("near the round-off"));
        rotor.stiffness *= 1e12;
        let told = doubts(&rotor, 1e-6);
        assert!(told.len() == 1 && told[0].starts_with("`stiffness` is "), "{told:?}");
        assert!(told[0].contains("1e12 times its default"), "{told:?}");
    }
}
