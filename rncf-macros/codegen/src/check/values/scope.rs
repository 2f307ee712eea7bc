//! What an expression may refer to, by where it stands.

/// What an expression may refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Scope {
    /// Known at build time: constants.
    Constant,
    /// Known when a model is built: parameters, too.
    Parameter,
    /// Prescribed: time and motions, too; smooth.
    Prescribed,
    /// Positions and directions, too; smooth.
    Constraint,
    /// Velocities, too; smooth.
    Force,
    /// Everything, bodies and joints included.
    Output,
}
