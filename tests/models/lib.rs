//! Models that tests compute with at length: compiled with all optimisation, which the tests themselves are not.

mod descriptions;
mod hanging;
mod materials;
mod rotating;
mod struck;

pub use descriptions::{Flying, Ladder};
pub use hanging::{Level, Rope};
pub use materials::{Lateral, Materials};
pub use rotating::{Flapping, SpinUpExact, Uniform};
pub use struck::Struck;
