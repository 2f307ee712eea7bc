//! Numbers of THEORY 9.1 and recorded histories of the spin-up beam.

use crate::Result;

/// Extreme tip deflections of a run, sampled every 0.1 s (THEORY 9.1): p = 0, exact quadrature, generalised-alpha
/// with rho = 0.9.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Final spin, rad/s.
    pub spin: f64,
    /// Number of elements.
    pub elements: usize,
    /// Step of the integrator, s: its error is part of the values.
    pub step: f64,
    /// Least transverse deflection v, m.
    pub v: f64,
    /// Time of the least v, s.
    pub time: f64,
    /// Least axial displacement u, m.
    pub u: f64,
}

/// One row of [`EXTREMES`].
const fn extreme(spin: f64, elements: usize, step: f64, v: f64, time: f64, u: f64) -> Extreme {
    Extreme {
        spin,
        elements,
        step,
        v,
        time,
        u,
    }
}

/// The table of extremes of THEORY 9.1, in its order.
pub const EXTREMES: [Extreme; 12] = [
    extreme(4.0, 6, 0.01, -0.533659, 6.8, -0.020469),
    extreme(4.0, 6, 0.005, -0.533653, 6.8, -0.020469),
    extreme(4.0, 6, 0.0025, -0.533652, 6.8, -0.020469),
    extreme(4.0, 16, 0.005, -0.533988, 6.8, -0.020490),
    extreme(4.0, 32, 0.005, -0.533990, 6.8, -0.020491),
    extreme(10.0, 8, 0.005, -1.082718, 6.2, -0.083322),
    extreme(10.0, 16, 0.005, -1.083562, 6.2, -0.083422),
    extreme(100.0, 12, 0.005, -3.330824, 2.9, -0.822854),
    extreme(100.0, 24, 0.005, -3.333733, 2.9, -0.824082),
    extreme(100.0, 24, 0.0025, -3.333723, 2.9, -0.824077),
    extreme(100.0, 48, 0.005, -3.333797, 2.9, -0.824108),
    extreme(10.0, 16, 0.0025, -1.083564, 6.2, -0.083422),
];

/// Steady tip elongation (spin in rad/s, u in m) of THEORY 9.1: the relative equilibrium, the same for every number of
/// elements with the norm of the root's slope free.
pub const STEADY_ELONGATIONS: [(f64, f64); 4] = [
    (4.0, 1.09569e-4),
    (10.0, 6.847775e-4),
    (40.0, 1.0948018e-2),
    (100.0, 6.8134176e-2),
];

/// A recorded tip history of the spin-up beam; its first line in `data/` says where it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Record {
    /// 4 rad/s, 6 elements, p = 0, step 0.0025 s, 20 s.
    Spin4Elements6,
    /// 4 rad/s, 16 elements, p = 0, step 0.005 s, 20 s.
    Spin4Elements16,
    /// 10 rad/s, 16 elements, p = 0, step 0.0025 s, 18 s.
    Spin10Elements16,
    /// 10 rad/s, 16 elements, p = 2, step 0.005 s, 18 s.
    Spin10Elements16Exact,
    /// 100 rad/s, 24 elements, p = 0, step 0.0025 s, 18 s.
    Spin100Elements24,
}

impl Record {
    /// Every record.
    pub const ALL: [Self; 5] = [
        Self::Spin4Elements6,
        Self::Spin4Elements16,
        Self::Spin10Elements16,
        Self::Spin10Elements16Exact,
        Self::Spin100Elements24,
    ];

    /// The recorded history.
    ///
    /// # Errors
    /// As [`History::parse`].
    pub fn history(self) -> Result<History> {
        History::parse(match self {
            Self::Spin4Elements6 => include_str!("data/spin_up_4_n6_p0.csv"),
            Self::Spin4Elements16 => include_str!("data/spin_up_4_n16_p0.csv"),
            Self::Spin10Elements16 => include_str!("data/spin_up_10_n16_p0.csv"),
            Self::Spin10Elements16Exact => include_str!("data/spin_up_10_n16_p2.csv"),
            Self::Spin100Elements24 => include_str!("data/spin_up_100_n24_p0.csv"),
        })
    }
}

/// Tip history on an even grid of times.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Times, s.
    pub t: Vec<f64>,
    /// Axial displacement of the tip in the frame, m.
    pub u: Vec<f64>,
    /// Transverse displacement of the tip in the frame, m.
    pub v: Vec<f64>,
}

impl History {
    /// Reads comma-separated text: comment lines begin with `#`, then the heading `t [s],u [m],v [m]`, then numbers.
    ///
    /// # Errors
    /// If the heading is another one, a line has not three finite numbers (named by its number), or the times do not
    /// increase.
    pub fn parse(text: &str) -> Result<Self> {
        const HEADING: &str = "t [s],u [m],v [m]";
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.starts_with('#'));
        match lines.next() {
            Some((_, HEADING)) => {}
            Some((k, other)) => {
                return Err(format!(
                    "line {}: the heading is '{other}', expected '{HEADING}'",
                    k + 1
                ));
            }
            None => return Err(format!("the text is empty, expected the heading '{HEADING}'")),
        }
        let mut history = Self::default();
        for (k, line) in lines {
            let numbers: Vec<f64> = line.split(',').filter_map(|field| field.trim().parse().ok()).collect();
            let (&[t, u, v], 3) = (numbers.as_slice(), line.split(',').count()) else {
                return Err(format!("line {}: '{line}' is not three numbers", k + 1));
            };
            if !(t.is_finite() && u.is_finite() && v.is_finite()) {
                return Err(format!("line {}: '{line}' holds a number that is not finite", k + 1));
            }
            if history.t.last().is_some_and(|&last| t <= last) {
                return Err(format!("line {}: time {t} does not increase", k + 1));
            }
            history.t.push(t);
            history.u.push(u);
            history.v.push(v);
        }
        Ok(history)
    }

    /// Time and value of the least v.
    ///
    /// # Errors
    /// If the history is empty.
    pub fn least_v(&self) -> Result<(f64, f64)> {
        let pairs = self.t.iter().copied().zip(self.v.iter().copied());
        pairs
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .ok_or_else(|| "the history is empty".into())
    }
}
