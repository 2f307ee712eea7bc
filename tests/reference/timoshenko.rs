//! Natural frequencies of Timoshenko's beam, uniform and in a plane.

/// A uniform beam that bends in a plane.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// m
    pub length: f64,
    /// kg/m
    pub mass: f64,
    /// Rotary inertia per length, kg m.
    pub rotary: f64,
    /// E I, N m^2
    pub bending: f64,
    /// k G A, N
    pub shear: f64,
}

impl Beam {
    /// The lowest `count` natural frequencies above 5 rad/s (rad/s), of a cantilever or a free beam: sign changes of the
    /// determinant of the conditions at the ends, looked for in steps of 2 rad/s.
    pub fn frequencies(&self, is_free: bool, count: usize) -> Vec<f64> {
        // Deflection, turning, moment, shear force along the beam, by the series of exp(A).
        let transfer = |w: f64| -> [[f64; 4]; 4] {
            let a = [
                [0.0, 1.0, 0.0, 1.0 / self.shear],
                [0.0, 0.0, 1.0 / self.bending, 0.0],
                [0.0, -self.rotary * w * w, 0.0, -1.0],
                [-self.mass * w * w, 0.0, 0.0, 0.0],
            ];
            let product = |x: &[[f64; 4]; 4], y: &[[f64; 4]; 4]| -> [[f64; 4]; 4] {
                std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| x[i][k] * y[k][j]).sum()))
            };
            let identity: [[f64; 4]; 4] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
            let (mut sum, mut term) = (identity, identity);
            for k in 1..120 {
                term = product(&term, &a).map(|row| row.map(|x| x * self.length / f64::from(k)));
                for i in 0..4 {
                    for j in 0..4 {
                        sum[i][j] += term[i][j];
                    }
                }
            }
            sum
        };
        let condition = |w: f64| {
            let t = transfer(w);
            // What is zero at the end, and what is free at the start.
            let from = if is_free { [0, 1] } else { [2, 3] };
            t[2][from[0]] * t[3][from[1]] - t[2][from[1]] * t[3][from[0]]
        };
        let mut found = Vec::new();
        let (step, mut low) = (2.0, 5.0);
        while found.len() < count {
            let (mut a, mut b) = (low, low + step);
            if condition(a) * condition(b) < 0.0 {
                for _ in 0..100 {
                    let middle = 0.5 * (a + b);
                    if condition(a) * condition(middle) <= 0.0 {
                        b = middle
                    } else {
                        a = middle
                    }
                }
                found.push(0.5 * (a + b));
            }
            low += step;
        }
        found
    }
}
