//! Frequencies in rad/s, Hz or rpm, as the line asks for them.

use super::numbers::digits;

/// Unit in which frequencies are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(in crate::app) enum Frequency {
    #[default]
    RadPerSecond,
    Hertz,
    Rpm,
}

impl Frequency {
    /// All names, as they are typed.
    pub const NAMES: [&'static str; 3] = ["rad/s", "Hz", "rpm"];

    pub fn named(name: &str) -> Frequency {
        match name {
            "Hz" => Frequency::Hertz,
            "rpm" => Frequency::Rpm,
            _ => Frequency::RadPerSecond,
        }
    }

    pub fn unit(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The value in this unit of a frequency in rad/s.
    pub fn of(self, frequency: f64) -> f64 {
        match self {
            Frequency::RadPerSecond => frequency,
            Frequency::Hertz => frequency / std::f64::consts::TAU,
            Frequency::Rpm => frequency * (30.0 / std::f64::consts::PI),
        }
    }

    /// The value with seven digits and the unit.
    pub fn shown(self, frequency: f64) -> String {
        format!("{} {}", digits(self.of(frequency), 7), self.unit())
    }
}
