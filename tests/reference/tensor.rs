//! The same element with its elastic force from constant tensors (THEORY 5.1, Eq. 37), contracted by run-time loops.
//!
//! ```text
//! F_e^i = [ kappa^ijmn (Q_mn + c Q'_mn) + ups^ijmn P_mn ] q_j,   P = 1/2 q_m.q_n,   Q = P - P0
//! ```
//!
//! Polynomial bending (p = 0), straight and stress-free at the start; c damps the axial strain alone, since damping of
//! this bending term is not sign definite (remark ii).

use crate::Result;
use crate::element::{Data, ElasticForce, VECTORS, Weights, shape_x, shape_xx};
use crate::quadrature::gauss_legendre;

/// Number of pairs of nodal vectors, without using symmetry.
const PAIRS: usize = VECTORS * VECTORS;

/// The element with full tensors `kappa` and `ups`.
#[derive(Clone, Debug)]
pub struct TensorElement {
    data: Data,
    /// `kappa[pair(i, j)][pair(m, n)]`.
    kappa: Vec<[f64; PAIRS]>,
    /// `ups[pair(i, j)][pair(m, n)]`.
    upsilon: Vec<[f64; PAIRS]>,
    /// `P0_mn` of the straight reference.
    reference: [f64; PAIRS],
}

/// Place of the pair (i, j).
fn pair(i: usize, j: usize) -> usize {
    VECTORS * i + j
}

/// Half inner products `1/2 u_i.v_j` of all pairs.
fn half_products(u: &[f64], v: &[f64], dimension: usize) -> [f64; PAIRS] {
    let mut products = [0.0; PAIRS];
    for i in 0..VECTORS {
        for j in 0..VECTORS {
            for k in 0..dimension {
                products[pair(i, j)] += 0.5 * u[dimension * i + k] * v[dimension * j + k];
            }
        }
    }
    products
}

impl TensorElement {
    /// Straight, stress-free element; the tensors by the quadrature of `data.points` points.
    ///
    /// # Errors
    /// As [`Data::check`] and [`gauss_legendre`]; if `data.exponent` is not 0, where no constant tensor exists.
    pub fn straight(data: Data) -> Result<Self> {
        data.check()?;
        if data.exponent != 0 {
            return Err(format!(
                "exponent is {}, constant tensors need the polynomial bending energy 0",
                data.exponent
            ));
        }
        let mut straight = vec![0.0; VECTORS * data.dimension];
        straight[data.dimension] = 1.0;
        straight[2 * data.dimension] = data.length;
        straight[3 * data.dimension] = 1.0;
        let mut element = Self {
            data,
            kappa: vec![[0.0; PAIRS]; PAIRS],
            upsilon: vec![[0.0; PAIRS]; PAIRS],
            reference: half_products(&straight, &straight, data.dimension),
        };
        for point in gauss_legendre(data.points)? {
            element.add_station(point.weight * data.length, point.xi);
        }
        Ok(element)
    }

    /// `kappa^ijmn`, indices from 0.
    pub fn kappa(&self, i: usize, j: usize, m: usize, n: usize) -> f64 {
        self.kappa[pair(i, j)][pair(m, n)]
    }

    /// `ups^ijmn`, indices from 0.
    pub fn upsilon(&self, i: usize, j: usize, m: usize, n: usize) -> f64 {
        self.upsilon[pair(i, j)][pair(m, n)]
    }

    /// Adds one Gauss point's share to both tensors.
    fn add_station(&mut self, weight: f64, xi: f64) {
        let (s, z) = (shape_x(xi, self.data.length), shape_xx(xi, self.data.length));
        let (ea, ei) = (weight * self.data.axial_stiffness, weight * self.data.bending_stiffness);
        for i in 0..VECTORS {
            for j in 0..VECTORS {
                for m in 0..VECTORS {
                    for n in 0..VECTORS {
                        self.kappa[pair(i, j)][pair(m, n)] += ea * s[i] * s[j] * s[m] * s[n];
                        self.upsilon[pair(i, j)][pair(m, n)] += ei
                            * (2.0 * (s[i] * s[j] * z[m] * z[n] + z[i] * z[j] * s[m] * s[n])
                                - z[i] * s[j] * z[m] * s[n]
                                - s[i] * z[j] * z[m] * s[n]
                                - z[i] * s[j] * s[m] * z[n]
                                - s[i] * z[j] * s[m] * z[n]);
                    }
                }
            }
        }
    }

    /// `T^ij = kappa^ijmn (Q_mn + c Q'_mn) + ups^ijmn P_mn`.
    fn tension(&self, q: &[f64], qd: &[f64]) -> [f64; PAIRS] {
        let Data { dimension, damping, .. } = self.data;
        let p = half_products(q, q, dimension);
        let mut strain: [f64; PAIRS] = std::array::from_fn(|mn| p[mn] - self.reference[mn]);
        if damping != 0.0 {
            let rate = half_products(qd, q, dimension);
            for m in 0..VECTORS {
                for n in 0..VECTORS {
                    strain[pair(m, n)] += damping * (rate[pair(m, n)] + rate[pair(n, m)]);
                }
            }
        }
        let mut tension = [0.0; PAIRS];
        for ij in 0..PAIRS {
            for mn in 0..PAIRS {
                tension[ij] += self.kappa[ij][mn] * strain[mn] + self.upsilon[ij][mn] * p[mn];
            }
        }
        tension
    }

    /// Adds `T^ij q_j`.
    fn add_product(&self, tension: &[f64; PAIRS], q: &[f64], force: &mut [f64]) {
        let dimension = self.data.dimension;
        for i in 0..VECTORS {
            for j in 0..VECTORS {
                for k in 0..dimension {
                    force[dimension * i + k] += tension[pair(i, j)] * q[dimension * j + k];
                }
            }
        }
    }
}

impl ElasticForce for TensorElement {
    fn coordinates(&self) -> usize {
        VECTORS * self.data.dimension
    }

    fn energy(&self, q: &[f64]) -> f64 {
        let p = half_products(q, q, self.data.dimension);
        let mut energy = 0.0;
        for ij in 0..PAIRS {
            for mn in 0..PAIRS {
                let (q_ij, q_mn) = (p[ij] - self.reference[ij], p[mn] - self.reference[mn]);
                energy += 0.5 * (self.kappa[ij][mn] * q_ij * q_mn + self.upsilon[ij][mn] * p[ij] * p[mn]);
            }
        }
        energy
    }

    fn add_force(&self, q: &[f64], qd: &[f64], force: &mut [f64]) {
        self.add_product(&self.tension(q, qd), q, force);
    }

    /// `K^in = T^in I + (kappa^ijmn (q_m + c q'_m) + ups^ijmn q_m) q_j`, `C^in = c kappa^ijmn q_j q_m^T`.
    fn add_force_and_tangent(&self, q: &[f64], qd: &[f64], weights: Weights, force: &mut [f64], tangent: &mut [f64]) {
        let Data {
            dimension, damping: c, ..
        } = self.data;
        let size = self.coordinates();
        let tension = self.tension(q, qd);
        self.add_product(&tension, q, force);
        let rates: &[f64] = if c == 0.0 { &[] } else { qd };
        for i in 0..VECTORS {
            for n in 0..VECTORS {
                for k in 0..dimension {
                    tangent[(dimension * i + k) * size + dimension * n + k] += weights.position * tension[pair(i, n)];
                }
                for j in 0..VECTORS {
                    let mut row = [0.0; 3];
                    for m in 0..VECTORS {
                        let (kappa, upsilon) =
                            (self.kappa[pair(i, j)][pair(m, n)], self.upsilon[pair(i, j)][pair(m, n)]);
                        let by_q = weights.position * (kappa + upsilon) + weights.velocity * c * kappa;
                        for k in 0..dimension {
                            row[k] += by_q * q[dimension * m + k];
                        }
                        if !rates.is_empty() {
                            for k in 0..dimension {
                                row[k] += weights.position * c * kappa * rates[dimension * m + k];
                            }
                        }
                    }
                    for k in 0..dimension {
                        let at = (dimension * i + k) * size + dimension * n;
                        for m in 0..dimension {
                            tangent[at + m] += q[dimension * j + k] * row[m];
                        }
                    }
                }
            }
        }
    }
}
