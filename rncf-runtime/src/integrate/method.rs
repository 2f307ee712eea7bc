//! The methods of integration: the table that command line, charts, summaries and the integrator itself read.

use std::ops::RangeInclusive;

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Radau IIA with three stages, order 5 (THEORY 7.5).
    Radau,
    /// Radau IIA with five stages, order 9: for tight tolerances.
    Radau9,
    /// Radau IIA with seven stages, order 13: for the tightest.
    Radau13,
    /// HHT-alpha for index 3, order 2 (THEORY 7.1).
    Hht {
        /// Numerical dissipation, [-1/3, 0].
        alpha: f64,
    },
    /// Generalized-alpha, order 2 (THEORY 7.2).
    GeneralizedAlpha {
        /// Spectral radius at infinite frequency, [0, 1].
        rho_inf: f64,
    },
    /// Energy and momentum exactly, order 2: elastic forces between the two ends of a step that do the work of the
    /// change of energy. For models that conserve energy and have a constant mass, see [`crate::System::conserving`].
    EnergyMomentum,
}

/// The number that a method has: its numerical dissipation.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its name, `rho_inf`.
    pub name: &'static str,
    /// What it is called in sentences.
    pub meaning: &'static str,
    /// Its value.
    pub value: f64,
    /// Values that it may have.
    pub range: RangeInclusive<f64>,
    /// The value that damps nothing.
    pub undamped: f64,
}

impl Method {
    /// All methods with their usual numbers; the first one is that of a run that names none.
    pub const ALL: [Self; 6] = [
        Self::Radau,
        Self::Hht { alpha: -0.05 },
        Self::GeneralizedAlpha { rho_inf: 0.8 },
        Self::EnergyMomentum,
        Self::Radau9,
        Self::Radau13,
    ];

    /// The word for it on the command line and in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Radau => "radau",
            Self::Radau9 => "radau9",
            Self::Radau13 => "radau13",
            Self::Hht { .. } => "hht",
            Self::GeneralizedAlpha { .. } => "generalized-alpha",
            Self::EnergyMomentum => "energy",
        }
    }

    /// The method of a name, with its usual number.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// The number that it has.
    pub fn parameter(self) -> Option<Parameter> {
        match self {
            Self::Radau | Self::Radau9 | Self::Radau13 | Self::EnergyMomentum => None,
            Self::Hht { alpha } => Some(Parameter {
                name: "alpha",
                meaning: "alpha",
                value: alpha,
                range: -1.0 / 3.0..=0.0,
                undamped: 0.0,
            }),
            Self::GeneralizedAlpha { rho_inf } => Some(Parameter {
                name: "rho_inf",
                meaning: "the spectral radius",
                value: rho_inf,
                range: 0.0..=1.0,
                undamped: 1.0,
            }),
        }
    }

    /// The same method with another number, where it has one.
    pub fn with(self, value: f64) -> Self {
        match self {
            Self::Radau | Self::Radau9 | Self::Radau13 | Self::EnergyMomentum => self,
            Self::Hht { .. } => Self::Hht { alpha: value },
            Self::GeneralizedAlpha { .. } => Self::GeneralizedAlpha { rho_inf: value },
        }
    }

    /// Whether it is Radau IIA, of whatever order: its error test is of lower order than the solution.
    pub const fn is_radau(self) -> bool {
        matches!(self, Self::Radau | Self::Radau9 | Self::Radau13)
    }

    /// The loosest relative tolerance of free steps. With a looser one steps of a high order become so long that their error test, which takes
    /// the motion for a polynomial, says nothing: Andrews' squeezer was 1.4 rad off at 1e-3 with order 13.
    pub const fn loosest(self) -> f64 {
        match self {
            Self::Radau13 => 1e-5,
            Self::Radau9 => 1e-4,
            Self::Radau | Self::Hht { .. } | Self::GeneralizedAlpha { .. } | Self::EnergyMomentum => f64::INFINITY,
        }
    }

    /// Whether it is of order 2 and controls its local errors, of order 3: the error of the result then follows the power 2/3 of
    /// the tolerance.
    pub const fn adds_up(self) -> bool {
        matches!(self, Self::Hht { .. } | Self::GeneralizedAlpha { .. })
    }
}

impl Parameter {
    /// Whether it may have a value; what stands for -1/3 in decimals may be a little beyond.
    pub fn allows(&self, value: f64) -> bool {
        value >= self.range.start() - 1e-12 && value <= *self.range.end()
    }

    /// Both ends of its range as one writes them.
    pub fn bounds(&self) -> [String; 2] {
        [self.range.start(), self.range.end()].map(|&end| match end {
            end if end == -1.0 / 3.0 => "-1/3".to_string(),
            end => end.to_string(),
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::integrate::method::*;

    #[test]
    fn methods_are_found_by_their_names_and_take_their_numbers() {
        for method in Method::ALL {
            assert_eq!(Method::named(method.name()), Some(method));
            let Some(parameter) = method.parameter() else {
                assert_eq!(method.with(0.3), method);
                continue;
            };
            assert!(parameter.allows(parameter.value) && parameter.allows(parameter.undamped));
            let undamped = method.with(parameter.undamped).parameter().map(|own| own.value);
            assert_eq!(undamped, Some(parameter.undamped));
        }
        assert_eq!(Method::named("euler"), None);
        let bounds = Method::ALL[1].parameter().map(|parameter| parameter.bounds());
        assert_eq!(bounds, Some(["-1/3".to_string(), "0".to_string()]));
    }
}
