//! The Hermite centre-line element (tether, cable, thin beam) of THEORY 5.1, by Gauss quadrature with run-time loops.
//!
//! Nodal vectors `q_1 = r(0), q_2 = r_x(0), q_3 = r(l), q_4 = r_x(l)`; stored node after node, components inside:
//! `q[dim * i + k]`. Strain energy
//!
//! ```text
//! U = int 1/2 EA (eps - eps0)^2 + 1/2 EI D (a.a)^-p dx,    a = r_x, b = r_xx, eps = 1/2 (a.a - 1), D = |a x b|^2
//! ```
//!
//! and in the plane, where the curvature `k = (a x b) (a.a)^(-p/2)` has a sign, `1/2 EI (k - k0)^2`.

use crate::Result;
use crate::quadrature::{Point, gauss_legendre};

/// Nodal vectors of the element.
pub const VECTORS: usize = 4;

/// Largest number of coordinates of an element, reached in space.
pub const MAX_COORDINATES: usize = 3 * VECTORS;

/// Data of one element.
#[derive(Clone, Copy, Debug)]
pub struct Data {
    /// Components of a vector: 2 (planar) or 3 (spatial).
    pub dimension: usize,
    /// Length l of the stress-free axis, m.
    pub length: f64,
    /// Mass per length rho A, kg/m.
    pub mass_per_length: f64,
    /// Axial stiffness EA, N.
    pub axial_stiffness: f64,
    /// Bending stiffness EI, N m^2.
    pub bending_stiffness: f64,
    /// Exponent p of the bending energy: 0 is polynomial, 2 the exact curvature (THEORY 5.1, remark i).
    pub exponent: u32,
    /// Damping c, s: of the axial strain, and in the plane of the curvature too.
    pub damping: f64,
    /// Number of Gauss points; 5 integrates p = 0 exactly.
    pub points: usize,
}

/// Weights of the three tangents in a Jacobian: `acceleration M + velocity C + position K`.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    /// Weight of the derivative with respect to q''.
    pub acceleration: f64,
    /// Weight of the derivative with respect to q'.
    pub velocity: f64,
    /// Weight of the derivative with respect to q.
    pub position: f64,
}

impl Weights {
    /// The position tangent alone.
    pub const POSITION: Self = Self {
        acceleration: 0.0,
        velocity: 0.0,
        position: 1.0,
    };
    /// The velocity tangent alone.
    pub const VELOCITY: Self = Self {
        acceleration: 0.0,
        velocity: 1.0,
        position: 0.0,
    };
    /// The acceleration tangent alone.
    pub const ACCELERATION: Self = Self {
        acceleration: 1.0,
        velocity: 0.0,
        position: 0.0,
    };
}

/// Elastic (and damping) forces of an element, whichever way they are evaluated.
pub trait ElasticForce {
    /// Number of coordinates, `4 dimension`.
    fn coordinates(&self) -> usize;

    /// Strain energy at `q`, J.
    fn energy(&self, q: &[f64]) -> f64;

    /// Adds the elastic force `F_e(q, q')` (N on positions, N m on slopes) to `force`.
    fn add_force(&self, q: &[f64], qd: &[f64], force: &mut [f64]);

    /// Adds the force as [`add_force`](Self::add_force) does, and `position K_T + velocity C_T` to `tangent`
    /// (`coordinates^2` entries, row after row).
    fn add_force_and_tangent(&self, q: &[f64], qd: &[f64], weights: Weights, force: &mut [f64], tangent: &mut [f64]);
}

/// Shape functions `s` at `xi` in `[0, 1]` of an element of length `l` (1 on positions, m on slopes).
pub fn shape(xi: f64, l: f64) -> [f64; VECTORS] {
    let (x2, x3) = (xi * xi, xi * xi * xi);
    [
        1.0 - 3.0 * x2 + 2.0 * x3,
        l * (xi - 2.0 * x2 + x3),
        3.0 * x2 - 2.0 * x3,
        l * (x3 - x2),
    ]
}

/// First derivatives `ds/dx` of [`shape`].
pub fn shape_x(xi: f64, l: f64) -> [f64; VECTORS] {
    let bump = 6.0 * (xi - xi * xi) / l;
    [-bump, 1.0 - 4.0 * xi + 3.0 * xi * xi, bump, 3.0 * xi * xi - 2.0 * xi]
}

/// Second derivatives `d^2 s/dx^2` of [`shape`].
pub fn shape_xx(xi: f64, l: f64) -> [f64; VECTORS] {
    let ramp = (6.0 - 12.0 * xi) / (l * l);
    [-ramp, (6.0 * xi - 4.0) / l, ramp, (6.0 * xi - 2.0) / l]
}

impl Data {
    /// Checks the data.
    ///
    /// # Errors
    /// One sentence that names the first wrong value.
    pub fn check(&self) -> Result<()> {
        if self.dimension != 2 && self.dimension != 3 {
            return Err(format!(
                "dimension is {}, use 2 (planar) or 3 (spatial)",
                self.dimension
            ));
        }
        let positive = [
            ("length", self.length),
            ("mass_per_length", self.mass_per_length),
            ("axial_stiffness", self.axial_stiffness),
        ];
        for (name, value) in positive {
            if !value.is_finite() || value <= 0.0 {
                return Err(format!("{name} is {value}, it must be positive"));
            }
        }
        for (name, value) in [("bending_stiffness", self.bending_stiffness), ("damping", self.damping)] {
            if !value.is_finite() || value < 0.0 {
                return Err(format!("{name} is {value}, it must not be negative"));
            }
        }
        Ok(())
    }

    /// First mass moments `d^i = int rho A s_i dx`: kg on positions, kg m on slopes. By quadrature, exact.
    pub fn first_moments(&self) -> Result<[f64; VECTORS]> {
        let mut d = [0.0; VECTORS];
        for Point { xi, weight } in gauss_legendre(2)? {
            let s = shape(xi, self.length);
            for i in 0..VECTORS {
                d[i] += weight * self.length * self.mass_per_length * s[i];
            }
        }
        Ok(d)
    }

    /// Second mass moments `M^ij = int rho A s_i s_j dx`: kg to kg m^2. By quadrature, exact.
    pub fn second_moments(&self) -> Result<[[f64; VECTORS]; VECTORS]> {
        let mut m = [[0.0; VECTORS]; VECTORS];
        for Point { xi, weight } in gauss_legendre(4)? {
            let s = shape(xi, self.length);
            for i in 0..VECTORS {
                for j in 0..VECTORS {
                    m[i][j] += weight * self.length * self.mass_per_length * s[i] * s[j];
                }
            }
        }
        Ok(m)
    }
}

/// What is constant at one Gauss point.
#[derive(Clone, Debug)]
struct Station {
    /// Weight times length, m.
    weight: f64,
    s_x: [f64; VECTORS],
    s_xx: [f64; VECTORS],
    /// Initial axial strain.
    strain0: f64,
    /// Initial curvature, 1/m; planar only.
    curvature0: f64,
}

/// The element with its elastic force summed over Gauss points.
#[derive(Clone, Debug)]
pub struct GaussElement {
    data: Data,
    stations: Vec<Station>,
}

/// Derivatives of the energy density at one point: gradients by a and b, and the four blocks of the tangent.
#[derive(Default)]
pub(crate) struct Density {
    pub(crate) by_a: [f64; 3],
    pub(crate) by_b: [f64; 3],
    pub(crate) aa: [[f64; 3]; 3],
    pub(crate) ab: [[f64; 3]; 3],
    pub(crate) ba: [[f64; 3]; 3],
    pub(crate) bb: [[f64; 3]; 3],
}

/// The axis at one point: a = r_x, b = r_xx and their rates.
struct Axis {
    a: [f64; 3],
    b: [f64; 3],
    a_rate: [f64; 3],
    b_rate: [f64; 3],
}

/// Product of the first `n` components.
fn dot(u: &[f64; 3], v: &[f64; 3], n: usize) -> f64 {
    (0..n).map(|k| u[k] * v[k]).sum()
}

/// `x^-p` and its first two derivatives.
fn inverse_power(x: f64, p: f64) -> [f64; 3] {
    if p == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let value = if p == 1.0 { 1.0 / x } else { x.powf(-p) };
    [value, -p * value / x, p * (p + 1.0) * value / (x * x)]
}

impl GaussElement {
    /// Straight, stress-free element.
    ///
    /// # Errors
    /// As [`Data::check`] and [`gauss_legendre`].
    pub fn straight(data: Data) -> Result<Self> {
        data.check()?;
        let station = |Point { xi, weight }| Station {
            weight: weight * data.length,
            s_x: shape_x(xi, data.length),
            s_xx: shape_xx(xi, data.length),
            strain0: 0.0,
            curvature0: 0.0,
        };
        Ok(Self {
            data,
            stations: gauss_legendre(data.points)?.into_iter().map(station).collect(),
        })
    }

    /// Planar element that is free of stress at the coordinates `q0` (8 of them): the initial strain and curvature
    /// of `q0` are subtracted, so that a rigid rotation stays free of force.
    ///
    /// # Errors
    /// As [`straight`](Self::straight); if the element is spatial, where the sign of the curvature is not defined; if
    /// `q0` has not 8 entries.
    pub fn curved(data: Data, q0: &[f64]) -> Result<Self> {
        let mut element = Self::straight(data)?;
        if data.dimension != 2 {
            return Err("an initially curved centre-line element must be planar: set dimension to 2".into());
        }
        if q0.len() != element.coordinates() {
            return Err(format!("q0 has {} entries, a planar element needs 8", q0.len()));
        }
        for k in 0..element.stations.len() {
            let Axis { a, b, .. } = element.axis(&element.stations[k], q0, &[]);
            let aa = dot(&a, &a, 2);
            element.stations[k].strain0 = 0.5 * (aa - 1.0);
            element.stations[k].curvature0 =
                (a[0] * b[1] - a[1] * b[0]) * inverse_power(aa, 0.5 * data.exponent as f64)[0];
        }
        Ok(element)
    }

    /// The element's data.
    pub fn data(&self) -> &Data {
        &self.data
    }

    /// Interpolates the axis; rates only where `qd` is given.
    fn axis(&self, station: &Station, q: &[f64], qd: &[f64]) -> Axis {
        let n = self.data.dimension;
        let mut axis = Axis {
            a: [0.0; 3],
            b: [0.0; 3],
            a_rate: [0.0; 3],
            b_rate: [0.0; 3],
        };
        for i in 0..VECTORS {
            for k in 0..n {
                axis.a[k] += station.s_x[i] * q[n * i + k];
                axis.b[k] += station.s_xx[i] * q[n * i + k];
            }
        }
        if !qd.is_empty() {
            for i in 0..VECTORS {
                for k in 0..n {
                    axis.a_rate[k] += station.s_x[i] * qd[n * i + k];
                    axis.b_rate[k] += station.s_xx[i] * qd[n * i + k];
                }
            }
        }
        axis
    }

    /// Rates matter only with damping.
    fn rates<'q>(&self, qd: &'q [f64]) -> &'q [f64] {
        if self.data.damping == 0.0 { &[] } else { qd }
    }

    /// Axial part: `N a` with `N = EA (eps + c eps')`, and its tangents.
    fn axial(&self, station: &Station, axis: &Axis, weights: Option<Weights>, density: &mut Density) {
        let Data {
            dimension: n,
            axial_stiffness: ea,
            damping: c,
            ..
        } = self.data;
        let Axis { a, a_rate, .. } = axis;
        let strain = 0.5 * (dot(a, a, n) - 1.0) - station.strain0;
        let tension = ea * (strain + c * dot(a, a_rate, n));
        for k in 0..n {
            density.by_a[k] += tension * a[k];
        }
        let Some(w) = weights else { return };
        for k in 0..n {
            density.aa[k][k] += w.position * tension;
            for m in 0..n {
                density.aa[k][m] += ea * a[k] * (w.position * (a[m] + c * a_rate[m]) + w.velocity * c * a[m]);
            }
        }
    }

    /// Spatial bending `1/2 EI D (a.a)^-p`, undamped (THEORY 5.1, remark ii).
    fn bending_in_space(&self, axis: &Axis, weights: Option<Weights>, density: &mut Density) {
        let Data {
            dimension: n,
            bending_stiffness: ei,
            exponent,
            ..
        } = self.data;
        let Axis { a, b, .. } = axis;
        let (aa, ab, bb) = (dot(a, a, n), dot(a, b, n), dot(b, b, n));
        let d = aa * bb - ab * ab;
        let [f, f1, f2] = inverse_power(aa, exponent as f64);
        // Halves of dD/da and dD/db.
        let (mut g, mut h) = ([0.0; 3], [0.0; 3]);
        for k in 0..n {
            g[k] = bb * a[k] - ab * b[k];
            h[k] = aa * b[k] - ab * a[k];
            density.by_a[k] += ei * (f * g[k] + d * f1 * a[k]);
            density.by_b[k] += ei * f * h[k];
        }
        let Some(w) = weights else { return };
        let ei = ei * w.position;
        for k in 0..n {
            density.aa[k][k] += ei * (f * bb + d * f1);
            density.bb[k][k] += ei * f * aa;
            density.ab[k][k] -= ei * f * ab;
            density.ba[k][k] -= ei * f * ab;
            for m in 0..n {
                density.aa[k][m] +=
                    ei * (-f * b[k] * b[m] + 2.0 * f1 * (g[k] * a[m] + a[k] * g[m]) + 2.0 * d * f2 * a[k] * a[m]);
                density.bb[k][m] -= ei * f * a[k] * a[m];
                let cross = ei * (f * (2.0 * a[k] * b[m] - b[k] * a[m]) + 2.0 * f1 * a[k] * h[m]);
                density.ab[k][m] += cross;
                density.ba[m][k] += cross;
            }
        }
    }

    /// Planar bending `1/2 EI (k - k0)^2` with the signed curvature, damped by `c k'`.
    fn bending_in_plane(&self, station: &Station, axis: &Axis, weights: Option<Weights>, density: &mut Density) {
        let Data {
            bending_stiffness: ei,
            exponent,
            damping: c,
            ..
        } = self.data;
        let Axis { a, b, a_rate, b_rate } = axis;
        let chi = a[0] * b[1] - a[1] * b[0];
        let (chi_a, chi_b) = ([b[1], -b[0]], [-a[1], a[0]]);
        let [f, f1, f2] = inverse_power(a[0] * a[0] + a[1] * a[1], 0.5 * exponent as f64);
        let k_a: [f64; 2] = std::array::from_fn(|k| f * chi_a[k] + 2.0 * chi * f1 * a[k]);
        let k_b: [f64; 2] = std::array::from_fn(|k| f * chi_b[k]);
        let rate: f64 = (0..2).map(|k| k_a[k] * a_rate[k] + k_b[k] * b_rate[k]).sum();
        let moment = ei * (chi * f - station.curvature0 + c * rate);
        for k in 0..2 {
            density.by_a[k] += moment * k_a[k];
            density.by_b[k] += moment * k_b[k];
        }
        let Some(w) = weights else { return };
        // Second derivatives of the curvature; d^2k/db^2 vanishes.
        const TURN: [[f64; 2]; 2] = [[0.0, 1.0], [-1.0, 0.0]];
        let (mut k_aa, mut k_ab) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
        for k in 0..2 {
            k_aa[k][k] += 2.0 * chi * f1;
            for m in 0..2 {
                k_aa[k][m] += 2.0 * f1 * (chi_a[k] * a[m] + a[k] * chi_a[m]) + 4.0 * chi * f2 * a[k] * a[m];
                k_ab[k][m] += f * TURN[k][m] + 2.0 * f1 * a[k] * chi_b[m];
            }
        }
        let rate_a: [f64; 2] =
            std::array::from_fn(|m| (0..2).map(|k| k_aa[k][m] * a_rate[k] + k_ab[m][k] * b_rate[k]).sum());
        let rate_b: [f64; 2] = std::array::from_fn(|m| (0..2).map(|k| k_ab[k][m] * a_rate[k]).sum());
        for k in 0..2 {
            for m in 0..2 {
                // Derivative of the moment in the weighted direction.
                let m_a = ei * (w.position * (k_a[m] + c * rate_a[m]) + w.velocity * c * k_a[m]);
                let m_b = ei * (w.position * (k_b[m] + c * rate_b[m]) + w.velocity * c * k_b[m]);
                density.aa[k][m] += k_a[k] * m_a + w.position * moment * k_aa[k][m];
                density.ab[k][m] += k_a[k] * m_b + w.position * moment * k_ab[k][m];
                density.ba[k][m] += k_b[k] * m_a + w.position * moment * k_ab[m][k];
                density.bb[k][m] += k_b[k] * m_b;
            }
        }
    }

    /// Gradients, and with weights the tangent blocks, of the energy density at one station.
    fn density(&self, station: &Station, q: &[f64], qd: &[f64], weights: Option<Weights>) -> Density {
        let axis = self.axis(station, q, self.rates(qd));
        let mut density = Density::default();
        self.axial(station, &axis, weights, &mut density);
        if self.data.dimension == 2 {
            self.bending_in_plane(station, &axis, weights, &mut density);
        } else {
            self.bending_in_space(&axis, weights, &mut density);
        }
        density
    }

    /// Adds the gradient of one station, spread over the nodal vectors.
    fn spread_force(&self, station: &Station, density: &Density, force: &mut [f64]) {
        let n = self.data.dimension;
        for i in 0..VECTORS {
            let (s_x, s_xx) = (station.weight * station.s_x[i], station.weight * station.s_xx[i]);
            for k in 0..n {
                force[n * i + k] += s_x * density.by_a[k] + s_xx * density.by_b[k];
            }
        }
    }

    /// Adds the tangent of one station, spread over the pairs of nodal vectors.
    fn spread_tangent(&self, station: &Station, density: &Density, tangent: &mut [f64]) {
        let n = self.data.dimension;
        let size = n * VECTORS;
        let Density { aa, ab, ba, bb, .. } = density;
        for j in 0..VECTORS {
            let (s_x, s_xx) = (station.weight * station.s_x[j], station.weight * station.s_xx[j]);
            let (mut by_a, mut by_b) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
            for k in 0..n {
                for m in 0..n {
                    by_a[k][m] = aa[k][m] * s_x + ab[k][m] * s_xx;
                    by_b[k][m] = ba[k][m] * s_x + bb[k][m] * s_xx;
                }
            }
            for i in 0..VECTORS {
                for k in 0..n {
                    let row = (n * i + k) * size + n * j;
                    for m in 0..n {
                        tangent[row + m] += station.s_x[i] * by_a[k][m] + station.s_xx[i] * by_b[k][m];
                    }
                }
            }
        }
    }
}

impl ElasticForce for GaussElement {
    fn coordinates(&self) -> usize {
        VECTORS * self.data.dimension
    }

    fn energy(&self, q: &[f64]) -> f64 {
        let Data {
            dimension: n,
            axial_stiffness: ea,
            bending_stiffness: ei,
            exponent,
            ..
        } = self.data;
        let mut energy = 0.0;
        for station in &self.stations {
            let Axis { a, b, .. } = self.axis(station, q, &[]);
            let (aa, ab, bb) = (dot(&a, &a, n), dot(&a, &b, n), dot(&b, &b, n));
            let strain = 0.5 * (aa - 1.0) - station.strain0;
            let curvature_squared = if n == 2 {
                let curvature = (a[0] * b[1] - a[1] * b[0]) * aa.powf(-0.5 * exponent as f64);
                (curvature - station.curvature0).powi(2)
            } else {
                (aa * bb - ab * ab) * aa.powf(-(exponent as f64))
            };
            energy += station.weight * 0.5 * (ea * strain * strain + ei * curvature_squared);
        }
        energy
    }

    fn add_force(&self, q: &[f64], qd: &[f64], force: &mut [f64]) {
        for station in &self.stations {
            self.spread_force(station, &self.density(station, q, qd, None), force);
        }
    }

    fn add_force_and_tangent(&self, q: &[f64], qd: &[f64], weights: Weights, force: &mut [f64], tangent: &mut [f64]) {
        for station in &self.stations {
            let density = self.density(station, q, qd, Some(weights));
            self.spread_force(station, &density, force);
            self.spread_tangent(station, &density, tangent);
        }
    }
}
