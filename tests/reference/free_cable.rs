//! A cable with a mass at its end that flies freely, in inertial nodal vectors (THEORY 9.6): `M q'' = -F_e(q)`, and what
//! stays of it: energy, momentum and angular momentum.

use crate::Result;
use crate::beam::{Beam, Chain, Root};
use crate::dense::{Cholesky, Matrix};
use crate::element::{Data, Weights};
use crate::inertia::{Frame, State};
use crate::system::System;

/// States `(q, q')`, node after node, position then slope, components inside.
#[derive(Clone, Debug)]
pub struct FreeCable {
    chain: Chain,
    mass: Matrix,
    factor: Cholesky,
}

/// What no force and moment can change.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    /// Kinetic and strain energy, J.
    pub energy: f64,
    /// Momentum, N s.
    pub momentum: [f64; 3],
    /// Angular momentum about the inertial origin, N m s.
    pub spin: [f64; 3],
}

impl FreeCable {
    /// The cable of THEORY 9.6: 2 m, EA = 400 N, EI = 2 N m^2, 1.5 kg/m, in so many elements.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn new(elements: usize, tip_mass: f64) -> Result<Self> {
        let element = Data {
            dimension: 3,
            length: 2.0,
            mass_per_length: 1.5,
            axial_stiffness: 400.0,
            bending_stiffness: 2.0,
            exponent: 0,
            damping: 0.0,
            points: 5,
        };
        let chain = Chain::new(Beam {
            elements,
            length: 2.0,
            hub_radius: 0.0,
            root: Root::Pinned,
            element,
        })?;
        let mut mass = chain.mass();
        let tip = chain.coordinates() - 6;
        (tip..tip + 3).for_each(|place| mass.add(place, place, tip_mass));
        let factor = Cholesky::new(&mass)?;
        Ok(Self { chain, mass, factor })
    }

    /// Energy, momentum and angular momentum of inertial nodal vectors and their rates.
    pub fn kept(&self, q: &[f64], qd: &[f64]) -> Kept {
        let mut impulse = vec![0.0; q.len()];
        self.mass.add_product(qd, &mut impulse);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut kept = Kept {
            energy: 0.5 * dot(qd, &impulse) + self.chain.strain_energy(q),
            momentum: [0.0; 3],
            spin: [0.0; 3],
        };
        for (vector, (q, p)) in q.chunks_exact(3).zip(impulse.chunks_exact(3)).enumerate() {
            for k in 0..3 {
                let (l, m) = ((k + 1) % 3, (k + 2) % 3);
                kept.spin[k] += q[l] * p[m] - q[m] * p[l];
                // A shift moves positions and no slopes.
                if vector % 2 == 0 {
                    kept.momentum[k] += p[k];
                }
            }
        }
        kept
    }

    fn half(&self) -> usize {
        self.chain.coordinates()
    }
}

impl System for FreeCable {
    fn size(&self) -> usize {
        2 * self.half()
    }

    fn rate(&self, _t: f64, y: &[f64], rate: &mut [f64]) {
        let (q, qd) = y.split_at(self.half());
        let still = vec![0.0; q.len()];
        let state = State { q, qd, qdd: &still };
        let (first, second) = rate.split_at_mut(self.half());
        first.copy_from_slice(qd);
        self.chain.residual(state, &Frame::default(), second);
        second.iter_mut().for_each(|force| *force = -*force);
        self.factor.solve(second);
    }

    fn load_jacobian(&self, _t: f64, y: &[f64], jacobian: &mut Matrix) {
        let n = self.half();
        let (q, qd) = y.split_at(n);
        let still = vec![0.0; n];
        let state = State { q, qd, qdd: &still };
        let mut stiffness = Matrix::zero(n);
        self.chain
            .tangent(state, &Frame::default(), Weights::POSITION, &mut stiffness);
        jacobian.clear();
        for k in 0..n {
            jacobian.set(k, n + k, 1.0);
            let mut column: Vec<f64> = (0..n).map(|i| -stiffness.get(i, k)).collect();
            self.factor.solve(&mut column);
            (0..n).for_each(|i| jacobian.set(n + i, k, column[i]));
        }
    }
}
