//! Coefficients of the alpha family (THEORY 7.1).

/// Coefficients of a method of the family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coefficients {
    pub(super) alpha_m: f64,
    pub(super) alpha_f: f64,
    pub(super) beta: f64,
    pub(super) gamma: f64,
}

impl Coefficients {
    /// HHT with dissipation `alpha` in [-1/3, 0].
    pub(super) fn hht(alpha: f64) -> Self {
        Self::averaging(0.0, -alpha)
    }

    /// Generalized-alpha with spectral radius `rho` at infinite frequency in [0, 1].
    pub(super) fn generalized_alpha(rho: f64) -> Self {
        Self::averaging((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0))
    }

    fn averaging(alpha_m: f64, alpha_f: f64) -> Self {
        let gamma = 0.5 + alpha_f - alpha_m;
        let beta = (gamma + 0.5) * (gamma + 0.5) / 4.0;
        Self {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        }
    }

    /// `a_n` approximates the acceleration at `t_n + shift h`.
    pub(super) fn shift(&self) -> f64 {
        self.alpha_m - self.alpha_f
    }

    /// Constant of the local position error, and of the velocity bias.
    pub(super) fn kappa(&self) -> f64 {
        self.beta + self.shift() / 2.0 - 1.0 / 6.0
    }

    pub(super) fn factors(&self) -> Factors {
        Factors {
            gamma: self.gamma,
            beta: self.beta,
            mass: (1.0 - self.alpha_m) / (1.0 - self.alpha_f),
            remembers: self.alpha_m != 0.0,
        }
    }
}

/// How the increments of velocity and accelerations follow from those of the position.
#[derive(Clone, Copy, Debug)]
pub(super) struct Factors {
    /// dv = gamma / (beta h) dx.
    pub(super) gamma: f64,
    /// d(algorithmic acceleration) = dx / (beta h^2).
    pub(super) beta: f64,
    /// d(true acceleration) = mass * d(algorithmic acceleration); the factor of M in the matrix.
    pub(super) mass: f64,
    /// Whether the algorithmic acceleration depends on that of the step before.
    pub(super) remembers: bool,
}
