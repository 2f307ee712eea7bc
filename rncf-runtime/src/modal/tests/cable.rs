//! A cantilever of cables by hand.

use crate::modal::body::Nodal;
use crate::scene::bodies::described::Elements;
use crate::scene::numbering::assembly::Connectivity;
use crate::space::Vector;

/// Hermite cable elements (THEORY 5.1) of equal length, three Gauss points.
#[derive(Clone, Copy)]
pub(in crate::modal) struct Cable {
    pub dimension: usize,
    pub length: f64,
    pub axial: f64,
    pub bending: f64,
    pub damping: f64,
}

const GAUSS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_3, 5.0 / 18.0),
    (0.5, 4.0 / 9.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

impl Cable {
    /// First and second derivatives of the shape functions.
    pub fn slopes(&self, x: f64) -> [[f64; 4]; 2] {
        let l = self.length;
        [
            [
                (6.0 * x * x - 6.0 * x) / l,
                1.0 - 4.0 * x + 3.0 * x * x,
                (6.0 * x - 6.0 * x * x) / l,
                3.0 * x * x - 2.0 * x,
            ],
            [
                (12.0 * x - 6.0) / l / l,
                (6.0 * x - 4.0) / l,
                (6.0 - 12.0 * x) / l / l,
                (6.0 * x - 2.0) / l,
            ],
        ]
    }

    fn sum(&self, weights: &[f64; 4], q: &[f64]) -> Vector {
        let mut sum = [0.0; 3];
        for (place, value) in q.iter().enumerate() {
            sum[place % self.dimension] += weights[place / self.dimension] * value;
        }
        sum.into()
    }
}

impl Elements for Cable {
    fn force(&self, _element: usize, q: &[f64], v: &[f64], force: &mut [f64]) {
        for (x, weight) in GAUSS {
            let [first, second] = self.slopes(x);
            let (a, b, rate) = (self.sum(&first, q), self.sum(&second, q), self.sum(&first, v));
            let tension = self.axial * (0.5 * (a.dot(&a) - 1.0) + self.damping * a.dot(&rate));
            let by_a = (tension + self.bending * b.dot(&b)) * a - self.bending * a.dot(&b) * b;
            let by_b = self.bending * a.dot(&a) * b - self.bending * a.dot(&b) * a;
            for (place, value) in force.iter_mut().enumerate() {
                let (n, c) = (place / self.dimension, place % self.dimension);
                *value += weight * self.length * (first[n] * by_a[c] + second[n] * by_b[c]);
            }
        }
    }

    fn tangent(&self, _element: usize, q: &[f64], v: &[f64], stiffness: &mut [f64], damping: &mut [f64]) {
        let (d, size) = (self.dimension, 4 * self.dimension);
        for (x, weight) in GAUSS {
            let [first, second] = self.slopes(x);
            let (a, b, rate) = (self.sum(&first, q), self.sum(&second, q), self.sum(&first, v));
            let tension = self.axial * (0.5 * (a.dot(&a) - 1.0) + self.damping * a.dot(&rate));
            let (ea, ei, w) = (self.axial, self.bending, weight * self.length);
            for row in 0..size {
                for column in 0..size {
                    let (m, i, n, j) = (row / d, row % d, column / d, column % d);
                    let unit = if i == j { 1.0 } else { 0.0 };
                    let aa = tension * unit
                        + ea * a[i] * (a[j] + self.damping * rate[j])
                        + ei * (b.dot(&b) * unit - b[i] * b[j]);
                    let bb = ei * (a.dot(&a) * unit - a[i] * a[j]);
                    let ab = ei * (2.0 * a[i] * b[j] - a.dot(&b) * unit - b[i] * a[j]);
                    let ba = ei * (2.0 * b[i] * a[j] - a.dot(&b) * unit - a[i] * b[j]);
                    stiffness[row * size + column] += w
                        * (first[m] * first[n] * aa
                            + second[m] * second[n] * bb
                            + first[m] * second[n] * ab
                            + second[m] * first[n] * ba);
                    damping[row * size + column] += w * first[m] * first[n] * ea * self.damping * a[i] * a[j];
                }
            }
        }
    }
}

/// Mass matrix of the vectors of an element of unit line density (THEORY 5.1).
pub(in crate::modal) fn element_mass(l: f64) -> [[f64; 4]; 4] {
    let unit = [
        [13.0 / 35.0, 11.0 * l / 210.0, 9.0 / 70.0, -13.0 * l / 420.0],
        [11.0 * l / 210.0, l * l / 105.0, 13.0 * l / 420.0, -l * l / 140.0],
        [9.0 / 70.0, 13.0 * l / 420.0, 13.0 / 35.0, -11.0 * l / 210.0],
        [-13.0 * l / 420.0, -l * l / 140.0, -11.0 * l / 210.0, l * l / 105.0],
    ];
    unit.map(|row| row.map(|entry| l * entry))
}

/// A cantilever along the first axis of unit length, EI and line density, starting at `hub`; the slope
/// at its root keeps its direction.
pub(in crate::modal) fn cantilever(
    dimension: usize,
    count: usize,
    slenderness: f64,
    hub: f64,
    damping: f64,
) -> (Nodal, Cable) {
    let l = 1.0 / count as f64;
    let (vectors, d) = (2 * (count + 1), dimension);
    let element = element_mass(l);
    let mut mass = vec![0.0; vectors * vectors];
    let mut components = Vec::new();
    for first in (0..count).map(|e| 2 * e) {
        for a in 0..4 {
            for b in 0..4 {
                mass[(first + a) * vectors + first + b] += element[a][b];
            }
        }
        components.extend(first * d..(first + 4) * d);
    }
    let mut shape = vec![0.0; vectors * d];
    for node in 0..=count {
        shape[2 * node * d] = hub + node as f64 * l;
        shape[(2 * node + 1) * d] = 1.0;
    }
    let mut map = vec![Vec::new(); vectors * d];
    map[d] = vec![(0, 1.0)];
    for component in 2 * d..vectors * d {
        map[component] = vec![(component - 2 * d + 1, 1.0)];
    }
    let nodal = Nodal {
        name: "arm".into(),
        dimension,
        connectivity: Connectivity {
            size: 4 * d,
            components,
        },
        shape,
        fixtures: vec![0.0; vectors * vectors],
        mass,
        whole: (0..vectors).map(|a| if a % 2 == 0 { 1.0 } else { 0.0 }).collect(),
        freedoms: (vectors - 2) * d + 1,
        map,
    };
    let cable = Cable {
        dimension,
        length: l,
        axial: slenderness,
        bending: 1.0,
        damping,
    };
    (nodal, cable)
}
