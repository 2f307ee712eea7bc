//! What the generator derived for a model, to be told: constants and functions with their operations.

/// A constant array of the generated code: a tensor of the unit element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConstantArray {
    /// Name in the generated code, e.g. `CABLE_PLANAR_MASS_MATRIX`.
    pub name: &'static str,
    /// Rows and columns.
    pub size: [usize; 2],
    /// What it is, one sentence.
    pub doc: &'static str,
}

/// A function of the generated code that does arithmetic, with the operations of one evaluation, loops multiplied out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KernelCount {
    /// Name in the generated code, e.g. `cable_planar_elastic_force`.
    pub name: &'static str,
    /// Additions, subtractions and comparisons.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Calls of functions, square roots included.
    pub functions: usize,
    /// All of them by what they cost, as the generator weighs them.
    pub weighted: usize,
}
