//! What is known of a section.

use std::collections::BTreeMap;

use crate::errors::Area;
use crate::model::{Expr as Value, Law, SectionShape};

/// Values of a block's fields by their names, with the places where they stand.
pub type Values = BTreeMap<&'static str, (Value, Area)>;

/// What is known of a section.
#[derive(Clone, Debug, Default)]
pub struct Section {
    pub shape: SectionShape,
    /// By their vocabulary names; of a circle or tube without shear factors, which depend on the material.
    pub properties: BTreeMap<&'static str, Value>,
    /// Stiffness and mass, where it says them by itself.
    pub law: Option<Law>,
    /// Whether all of it could be read: only then something can be missing.
    pub is_whole: bool,
}
