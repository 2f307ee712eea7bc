//! Errors: what went wrong, where, and what to do about it.

use std::fmt;

/// A model that cannot be built from its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelError {
    /// What is wrong and what would be right, naming the parameter, body or joint.
    pub message: String,
}

impl ModelError {
    /// An error with the given message.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for ModelError {}

/// Whether the words for a row are those of what a drive prescribes.
pub(crate) fn is_of_drive(row: &str) -> bool {
    row.contains("(drive)")
}

/// A number with six digits, as it is read best.
pub(crate) struct Short(pub(crate) f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded: f64 = format!("{:.5e}", self.0).parse().unwrap_or(self.0);
        if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) {
            write!(f, "{rounded}")
        } else {
            write!(f, "{rounded:e}")
        }
    }
}

/// Why an integration or an equilibrium stopped without reaching its end.
#[derive(Clone, Debug, PartialEq)]
pub struct SolveError {
    /// What failed.
    pub kind: SolveErrorKind,
    /// Time of the last good state, s.
    pub t: f64,
    /// Step size that was tried last, s.
    pub h: f64,
    /// The worst equation or constraint in the user's words, where one can be named.
    pub worst: Option<String>,
}

/// What failed.
#[derive(Clone, Debug, PartialEq)]
pub enum SolveErrorKind {
    /// A parameter of the method is out of its range; the text says which and the range.
    Setting(String),
    /// The matrix has no unique solution.
    Singular,
    /// Newton's iteration did not converge at the smallest step.
    NoConvergence,
    /// The same where a frame follows what has hardly any inertia; the text names the joint that ties it.
    LooseTie(String),
    /// The error test failed at the smallest step.
    StepTooSmall,
    /// The tolerance asks for more than round-off of a constraint allows; the text names it and what to do.
    BelowRoundOff(String),
    /// Newton's iteration failed where constraints become dependent, so that motions branch; the text names
    /// the constraints.
    SingularConfiguration(String),
    /// A value became infinite or not a number.
    NotFinite,
    /// A prescribed position or angle jumps; the text says which and by how much.
    Discontinuous(String),
    /// An angle passes half a turn and jumps, and a law that reads it jumps with it; the text names the law.
    HalfTurn(String),
    /// The run will not come to its end; the text says what grows or how many steps are left.
    Endless(String),
    /// A force, constraint, load or motion has no finite value; the text names it.
    Undefined(String),
    /// The initial state violates its constraints by more than is corrected; the violation of the
    /// worst one in its unit.
    Inconsistent(f64),
    /// Constraints depend on each other at the initial state; the text names them and what to weaken.
    Redundant(String),
    /// A motion has neither inertia nor a tie at the initial state; the text names what moves.
    Untied(String),
    /// An equilibrium does not exist or was not found; the text says why.
    NoEquilibrium(String),
    /// Modes of small motions were not found; the text says why.
    NoModes(String),
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (t, h) = (Short(self.t), Short(self.h));
        match &self.kind {
            SolveErrorKind::Setting(text) => return f.write_str(text),
            SolveErrorKind::Singular => write!(
                f,
                "the system matrix is singular at t = {t} s: a motion is neither tied nor carries mass or stiffness, or a constraint has nothing to hold"
            )?,
            SolveErrorKind::NoConvergence => write!(
                f,
                "Newton's iteration does not converge at t = {t} s with h = {h} s: take a shorter step if it is fixed, look for a jump in a motion or load, or relax the tolerance"
            )?,
            SolveErrorKind::LooseTie(text) => write!(
                f,
                "Newton's iteration does not converge at t = {t} s with h = {h} s: {text}"
            )?,
            SolveErrorKind::SingularConfiguration(text) => write!(
                f,
                "at t = {:e} s the motion comes to a singular configuration, where its branch cannot be told: {text}; relax the tolerance to step across, or change a length or the start to stay away from it",
                self.t
            )?,
            SolveErrorKind::StepTooSmall => write!(
                f,
                "the error test fails at t = {t} s even with h = {h} s: the solution is not smooth there, or the tolerance is below round-off"
            )?,
            SolveErrorKind::BelowRoundOff(text) => {
                return write!(f, "no step is found at t = {t} s with h = {h} s: {text}");
            }
            SolveErrorKind::NotFinite if self.h == 0.0 => write!(
                f,
                "a value is not finite at t = {t} s: a parameter is unphysical or out of the range of numbers"
            )?,
            SolveErrorKind::NotFinite => write!(
                f,
                "a value is not finite after t = {t} s with h = {h} s: the solution diverges, a parameter is unphysical, or something is divided by what is zero there"
            )?,
            SolveErrorKind::Inconsistent(size) => {
                let worst = self.worst.as_deref().unwrap_or_default();
                let cure = match (is_of_drive(worst), worst.starts_with("the rate")) {
                    // No position cures this: coordinates of joints in space count from where the bodies start.
                    (true, false) => {
                        "let what the drive prescribes begin with the coordinate of the start, which is 0 in space"
                    }
                    (true, true) => {
                        "what the drive prescribes begins with a speed: `start = moving` in `run` gives all bodies the velocities that joints and drives ask for; or let it begin at rest, as a table with `interpolation = clamped` does"
                    }
                    (false, false) => "correct the initial positions",
                    (false, true) => {
                        "correct the initial velocities, or let `start = moving` in `run` find the nearest that joints and drives allow"
                    }
                };
                write!(
                    f,
                    "the initial state violates its constraints by {} at t = {t} s: {cure}; only small errors are corrected by themselves",
                    Short(*size)
                )?;
            }
            SolveErrorKind::Redundant(text)
            | SolveErrorKind::Undefined(text)
            | SolveErrorKind::Untied(text)
            | SolveErrorKind::Endless(text) => write!(f, "at t = {t} s {text}")?,
            SolveErrorKind::Discontinuous(text) => write!(
                f,
                "at t = {t} s {text}, which no body can follow: let each case of its motion begin with the value at which the one before ends"
            )?,
            SolveErrorKind::HalfTurn(text) => {
                return write!(
                    f,
                    "at t = {t} s the angle in {text} passes half a turn, where it jumps from 180 to -180 deg: let what it lies between move in a plane (`plane`) or about a `hinged` frame, where angles count on, or make the law periodic"
                );
            }
            SolveErrorKind::NoModes(text) => write!(f, "no modes at t = {t} s: {text}")?,
            SolveErrorKind::NoEquilibrium(text) => write!(f, "no relative equilibrium at t = {t} s: {text}")?,
        }
        match &self.worst {
            Some(worst) => write!(f, " (worst: {worst})"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for SolveError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let text = |value: f64| Short(value).to_string();
        let found = [0.0, 1.0, 0.25, 1.234_567_8, -2e-3, 1.425_212_5e-8, 2e6, 99_999.96].map(text);
        assert_eq!(
            found,
            ["0", "1", "0.25", "1.23457", "-0.002", "1.42521e-8", "2e6", "1e5"]
        );
    }
}
