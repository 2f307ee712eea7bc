//! Bodies in modes that come from elsewhere.

use crate::space::Vector;

/// What is known of a body from elsewhere beside its modes.
#[derive(Clone, Debug)]
pub(super) struct Elsewhere {
    /// Of every mode the rotation of each interface.
    pub turns: Vec<Vec<Vector>>,
    /// Names of the interfaces.
    pub names: Vec<&'static str>,
    /// What is to be told of it.
    pub notes: Vec<String>,
}
