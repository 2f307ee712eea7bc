//! What emitted code needs to check parameters and to pass slices as arrays.

use crate::error::ModelError;
use crate::model::{Model, ParamKind};

/// Checks that every quantity is a number and every count at least one.
///
/// # Errors
/// The parameter by name.
pub fn check_params<M: Model>(model: &M) -> Result<(), ModelError> {
    for (index, param) in M::params().iter().enumerate() {
        let value = model.get(index);
        if !value.is_finite() {
            return Err(ModelError::new(format!(
                "parameter `{}` is {value}: give it a finite value",
                param.name
            )));
        }
        if param.kind == ParamKind::Count && value < 1.0 {
            return Err(ModelError::new(format!(
                "parameter `{}` is {value}: it counts things and must be at least 1",
                param.name
            )));
        }
    }
    Ok(())
}

fn check(holds: bool, owner: &str, name: &str, value: f64, unit: &str, range: &str) -> Result<f64, ModelError> {
    if holds {
        return Ok(value);
    }
    Err(ModelError::new(format!(
        "{owner}: {name} is {value} {unit}, it must be {range}"
    )))
}

/// `value`, if it is greater than zero.
///
/// # Errors
/// The property by name.
pub fn positive(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value.is_finite() && value > 0.0,
        owner,
        name,
        value,
        unit,
        "greater than zero",
    )
}

/// `value`, if it is not negative.
///
/// # Errors
/// The property by name.
pub fn non_negative(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value.is_finite() && value >= 0.0,
        owner,
        name,
        value,
        unit,
        "zero or greater",
    )
}

/// `value`, if it is a Poisson's ratio.
///
/// # Errors
/// The property by name.
pub fn poisson(owner: &str, name: &str, value: f64, unit: &str) -> Result<f64, ModelError> {
    check(
        value > -1.0 && value < 0.5,
        owner,
        name,
        value,
        unit,
        "between -1 and 0.5",
    )
}

/// A slice as an array.
///
/// # Panics
/// If the length differs: a defect of generated code.
pub fn array<const N: usize>(slice: &[f64]) -> &[f64; N] {
    slice
        .try_into()
        .expect("generated code passes slices of the element's size")
}

/// A mutable slice as an array.
///
/// # Panics
/// If the length differs: a defect of generated code.
pub fn array_mut<const N: usize>(slice: &mut [f64]) -> &mut [f64; N] {
    slice
        .try_into()
        .expect("generated code passes slices of the element's size")
}
