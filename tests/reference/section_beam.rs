//! The ten-vector C1 beam of THEORY 5.2 (planar: seven vectors), by Gauss quadrature with run-time loops.
//!
//! Vectors `(r0, r0x, r0y, r0z, ry_half, rz_half, r1, r1x, r1y, r1z)`, planar `(r0, r0x, r0y, ry_half, r1, r1x, r1y)`;
//! stored one after the other, components inside: `q[dimension * vector + k]`. With the fields
//! `x = (a, b, c, b', c')`, `a = r_x, b = r_y, c = r_z`, every strain measure is a sum of products `x_f . x_g`;
//! `U = int 1/2 (e - e0)^T D (e - e0) dx`, damping replaces `e` by `e + c e'`.

use crate::Result;
use crate::element::{shape, shape_x};
use crate::quadrature::{Point, gauss_legendre};

/// Vectors of the spatial element, the larger of the two.
pub const VECTORS: usize = 10;

/// Axis strains `e11, e22, e33, g12, g13, g23` of the spatial element.
pub const AXIS_MEASURES: usize = 6;

/// Section gradients `kz, ky, tau, t22, t33, t23` of the spatial element.
pub const GRADIENT_MEASURES: usize = 6;

/// Fields a, b, c, b', c'.
const FIELDS: usize = 5;
const A: usize = 0;
const B: usize = 1;
const C: usize = 2;
const BX: usize = 3;
const CX: usize = 4;

/// A measure as a sum of `factor x_f . x_g`.
type Measure = &'static [(f64, usize, usize)];

const AXIS: [Measure; AXIS_MEASURES] = [
    &[(0.5, A, A)],
    &[(0.5, B, B)],
    &[(0.5, C, C)],
    &[(1.0, A, B)],
    &[(1.0, A, C)],
    &[(1.0, B, C)],
];

const GRADIENTS: [Measure; GRADIENT_MEASURES] = [
    &[(1.0, A, BX)],
    &[(1.0, A, CX)],
    &[(0.5, BX, C), (-0.5, CX, B)],
    &[(1.0, B, BX)],
    &[(1.0, C, CX)],
    &[(1.0, B, CX), (1.0, C, BX)],
];

/// Constant parts of the diagonal measures' strains: `1/2 (a.a - 1)`.
const UNITS: [f64; AXIS_MEASURES] = [0.5, 0.5, 0.5, 0.0, 0.0, 0.0];

/// A linear elastic material and a section with principal axes y and z.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Young's modulus E, Pa.
    pub young: f64,
    /// Poisson's ratio nu.
    pub poisson: f64,
    /// Density rho, kg/m^3.
    pub density: f64,
    /// Area A, m^2.
    pub area: f64,
    /// `int Y^2 dA`, m^4: bending in the plane of x and y.
    pub i_zz: f64,
    /// `int Z^2 dA`, m^4: bending in the plane of x and z.
    pub i_yy: f64,
    /// Torsion constant J, m^4.
    pub torsion: f64,
    /// Shear factor k_s.
    pub shear_factor: f64,
}

impl Section {
    /// Solid circle; `k_s = 6 (1 + nu) / (7 + 6 nu)`.
    pub fn circle(radius: f64, young: f64, poisson: f64, density: f64) -> Self {
        let area = std::f64::consts::PI * radius * radius;
        let inertia = 0.25 * area * radius * radius;
        Self {
            young,
            poisson,
            density,
            area,
            i_zz: inertia,
            i_yy: inertia,
            torsion: 2.0 * inertia,
            shear_factor: 6.0 * (1.0 + poisson) / (7.0 + 6.0 * poisson),
        }
    }

    /// Shear modulus `E / (2 (1 + nu))`, Pa.
    pub fn shear(&self) -> f64 {
        0.5 * self.young / (1.0 + self.poisson)
    }

    /// P-wave modulus `lambda + 2 mu`, Pa: what locks when it stands in the bending terms.
    pub fn confined(&self) -> f64 {
        let nu = self.poisson;
        self.young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
    }

    /// `A D_ax = A diag(E, E, E, k_s G, k_s G, E/2)`, N: with E/2 on g23 the plane of the section is isotropic, as
    /// `e22^2 + e33^2 + g23^2/2` is the square of its strain tensor (THEORY 5.2 has G).
    pub fn structural(&self) -> [[f64; AXIS_MEASURES]; AXIS_MEASURES] {
        let (e, g) = (self.young, self.shear());
        let diagonal = [e, e, e, self.shear_factor * g, self.shear_factor * g, 0.5 * e];
        let mut d = [[0.0; AXIS_MEASURES]; AXIS_MEASURES];
        for k in 0..AXIS_MEASURES {
            d[k][k] = self.area * diagonal[k];
        }
        d
    }

    /// `A D_ax` with Poisson coupling of `e11, e22, e33`, N.
    pub fn coupled(&self) -> [[f64; AXIS_MEASURES]; AXIS_MEASURES] {
        let mut d = self.structural();
        let lambda = self.confined() - 2.0 * self.shear();
        d[5][5] = self.area * self.shear();
        for i in 0..3 {
            for j in 0..3 {
                d[i][j] = self.area * if i == j { self.confined() } else { lambda };
            }
        }
        d
    }

    /// `(E I_zz, E I_yy, G J, G I_zz, G I_yy, G (I_yy + I_zz)/4)`, N m^2; the last one makes the gradients isotropic.
    pub fn gradients(&self) -> [f64; GRADIENT_MEASURES] {
        let (e, g) = (self.young, self.shear());
        [
            e * self.i_zz,
            e * self.i_yy,
            g * self.torsion,
            g * self.i_zz,
            g * self.i_yy,
            0.25 * g * (self.i_yy + self.i_zz),
        ]
    }
}

/// Data of one element.
#[derive(Clone, Copy, Debug)]
pub struct Properties {
    /// Components of a vector: 2 (planar) or 3 (spatial).
    pub dimension: usize,
    /// Length l of the stress-free axis, m.
    pub length: f64,
    /// `(rho A, rho I_zz, rho I_yy)`: kg/m, kg m.
    pub mass: [f64; 3],
    /// `A D_ax` over `e11, e22, e33, g12, g13, g23`, N. A planar element reads the rows and columns that it has.
    pub axis: [[f64; AXIS_MEASURES]; AXIS_MEASURES],
    /// Stiffnesses of `kz, ky, tau, t22, t33, t23`, N m^2.
    pub gradients: [f64; GRADIENT_MEASURES],
    /// Damping c of every measure, s.
    pub damping: f64,
    /// Gauss points of the axis strains; the theory asks for 3.
    pub axis_points: usize,
    /// Gauss points of the section gradients; the theory asks for 2.
    pub gradient_points: usize,
}

impl Properties {
    /// Undamped element with the structural `D_ax` and 3 axis and 2 gradient points.
    pub fn structural(dimension: usize, length: f64, section: &Section) -> Self {
        let rho = section.density;
        Self {
            dimension,
            length,
            mass: [rho * section.area, rho * section.i_zz, rho * section.i_yy],
            axis: section.structural(),
            gradients: section.gradients(),
            damping: 0.0,
            axis_points: 3,
            gradient_points: 2,
        }
    }

    /// The same with Poisson coupling on the axis; a planar element has no `e33` and is in plane strain then.
    pub fn coupled(dimension: usize, length: f64, section: &Section) -> Self {
        Self {
            axis: section.coupled(),
            ..Self::structural(dimension, length, section)
        }
    }

    /// Vectors of the element: 7 or 10.
    pub fn vectors(&self) -> usize {
        if self.dimension == 2 { 7 } else { VECTORS }
    }

    fn check(&self) -> Result<()> {
        if self.dimension != 2 && self.dimension != 3 {
            return Err(format!("dimension is {}, use 2 or 3", self.dimension));
        }
        let positive = [
            ("length", self.length),
            ("mass per length", self.mass[0]),
            ("axis stiffness", self.axis[0][0]),
        ];
        for (name, value) in positive {
            if !value.is_finite() || value <= 0.0 {
                return Err(format!("{name} is {value}, it must be positive"));
            }
        }
        if !self.damping.is_finite() || self.damping < 0.0 {
            return Err(format!("damping is {}, it must not be negative", self.damping));
        }
        Ok(())
    }
}

/// Places of the vectors that carry r, r_y and r_z, in the order of their shape functions.
fn carriers(dimension: usize) -> ([usize; 4], [usize; 3], Option<[usize; 3]>) {
    if dimension == 2 {
        ([0, 1, 4, 5], [2, 3, 6], None)
    } else {
        ([0, 1, 6, 7], [2, 4, 8], Some([3, 5, 9]))
    }
}

/// Quadratic shape functions of the directors: at the start, in the middle, at the end.
pub fn director(xi: f64) -> [f64; 3] {
    [
        1.0 - 3.0 * xi + 2.0 * xi * xi,
        4.0 * xi * (1.0 - xi),
        xi * (2.0 * xi - 1.0),
    ]
}

/// Their derivatives by x on an element of length `l`, 1/m.
pub fn director_x(xi: f64, l: f64) -> [f64; 3] {
    [(4.0 * xi - 3.0) / l, (4.0 - 8.0 * xi) / l, (4.0 * xi - 1.0) / l]
}

/// Shape functions of r, r_y, r_z over the vectors.
pub fn particle(dimension: usize, xi: f64, l: f64) -> [[f64; VECTORS]; 3] {
    let mut rows = [[0.0; VECTORS]; 3];
    let (r, y, z) = carriers(dimension);
    for (place, value) in r.into_iter().zip(shape(xi, l)) {
        rows[0][place] = value;
    }
    for (row, places) in [(1, Some(y)), (2, z)] {
        for (place, value) in places.into_iter().flatten().zip(director(xi)) {
            rows[row][place] = value;
        }
    }
    rows
}

/// Shape functions of the fields a, b, c, b', c' over the vectors.
fn fields(dimension: usize, xi: f64, l: f64) -> [[f64; VECTORS]; FIELDS] {
    let mut rows = [[0.0; VECTORS]; FIELDS];
    let [_, b, c] = particle(dimension, xi, l);
    (rows[B], rows[C]) = (b, c);
    let (r, y, z) = carriers(dimension);
    for (place, value) in r.into_iter().zip(shape_x(xi, l)) {
        rows[A][place] = value;
    }
    for (row, places) in [(BX, Some(y)), (CX, z)] {
        for (place, value) in places.into_iter().flatten().zip(director_x(xi, l)) {
            rows[row][place] = value;
        }
    }
    rows
}

/// What is constant at one Gauss point.
#[derive(Clone, Debug)]
struct Station {
    /// Weight times length, m.
    weight: f64,
    fields: [[f64; VECTORS]; FIELDS],
    measures: Vec<Measure>,
    /// Stiffness over the measures, row after row.
    stiffness: Vec<f64>,
    /// Measures of the stress-free state.
    initial: Vec<f64>,
}

/// A prepared element.
#[derive(Clone, Debug)]
pub struct Element {
    properties: Properties,
    stations: Vec<Station>,
}

/// Measures and their derivatives at one Gauss point.
struct Strains {
    /// Measures minus initial ones.
    values: Vec<f64>,
    /// Their rates.
    rates: Vec<f64>,
    /// Derivatives of the measures by q, one row a measure.
    by_q: Vec<Vec<f64>>,
    /// Derivatives of the rates by q.
    rates_by_q: Vec<Vec<f64>>,
}

impl Element {
    /// Straight element, free of stress at `r_x = e_x, r_y = e_y, r_z = e_z`.
    ///
    /// # Errors
    /// One sentence that names the wrong property; as [`gauss_legendre`].
    pub fn straight(properties: Properties) -> Result<Self> {
        properties.check()?;
        let spatial = properties.dimension == 3;
        let (axis, gradients): (Vec<usize>, Vec<usize>) = if spatial {
            ((0..AXIS_MEASURES).collect(), (0..GRADIENT_MEASURES).collect())
        } else {
            (vec![0, 1, 3], vec![0, 3])
        };
        let mut stations = Vec::new();
        for Point { xi, weight } in gauss_legendre(properties.axis_points)? {
            stations.push(Station {
                weight: weight * properties.length,
                fields: fields(properties.dimension, xi, properties.length),
                measures: axis.iter().map(|&k| AXIS[k]).collect(),
                stiffness: axis
                    .iter()
                    .flat_map(|&k| axis.iter().map(move |&l| properties.axis[k][l]))
                    .collect(),
                initial: axis.iter().map(|&k| UNITS[k]).collect(),
            });
        }
        for Point { xi, weight } in gauss_legendre(properties.gradient_points)? {
            let stiffness = |k: usize, l: usize| if k == l { properties.gradients[k] } else { 0.0 };
            stations.push(Station {
                weight: weight * properties.length,
                fields: fields(properties.dimension, xi, properties.length),
                measures: gradients.iter().map(|&k| GRADIENTS[k]).collect(),
                stiffness: gradients
                    .iter()
                    .flat_map(|&k| gradients.iter().map(move |&l| stiffness(k, l)))
                    .collect(),
                initial: vec![0.0; gradients.len()],
            });
        }
        Ok(Self { properties, stations })
    }

    /// Element that is free of stress at the coordinates `q0`: curved, twisted, tapered alike.
    ///
    /// # Errors
    /// As [`straight`](Self::straight).
    pub fn stress_free_at(properties: Properties, q0: &[f64]) -> Result<Self> {
        let mut element = Self::straight(properties)?;
        let rest = vec![0.0; q0.len()];
        for k in 0..element.stations.len() {
            let strains = element.strains(&element.stations[k], q0, &rest);
            for (initial, value) in element.stations[k].initial.iter_mut().zip(strains.values) {
                *initial += value;
            }
        }
        Ok(element)
    }

    /// The element's data.
    pub fn properties(&self) -> &Properties {
        &self.properties
    }

    /// Number of coordinates: 14 or 30.
    pub fn coordinates(&self) -> usize {
        self.properties.dimension * self.properties.vectors()
    }

    /// One field at one station.
    fn field(&self, row: &[f64; VECTORS], q: &[f64]) -> [f64; 3] {
        let n = self.properties.dimension;
        let mut x = [0.0; 3];
        for a in 0..self.properties.vectors() {
            for k in 0..n {
                x[k] += row[a] * q[n * a + k];
            }
        }
        x
    }

    fn strains(&self, station: &Station, q: &[f64], v: &[f64]) -> Strains {
        let (n, size) = (self.properties.dimension, self.coordinates());
        let x: Vec<[f64; 3]> = station.fields.iter().map(|row| self.field(row, q)).collect();
        let xd: Vec<[f64; 3]> = station.fields.iter().map(|row| self.field(row, v)).collect();
        let count = station.measures.len();
        let mut strains = Strains {
            values: station.initial.iter().map(|value| -value).collect(),
            rates: vec![0.0; count],
            by_q: vec![vec![0.0; size]; count],
            rates_by_q: vec![vec![0.0; size]; count],
        };
        for (m, terms) in station.measures.iter().enumerate() {
            for &(factor, f, g) in *terms {
                for k in 0..n {
                    strains.values[m] += factor * x[f][k] * x[g][k];
                    strains.rates[m] += factor * (xd[f][k] * x[g][k] + x[f][k] * xd[g][k]);
                }
                for a in 0..self.properties.vectors() {
                    let (sf, sg) = (factor * station.fields[f][a], factor * station.fields[g][a]);
                    for k in 0..n {
                        strains.by_q[m][n * a + k] += sf * x[g][k] + sg * x[f][k];
                        strains.rates_by_q[m][n * a + k] += sf * xd[g][k] + sg * xd[f][k];
                    }
                }
            }
        }
        strains
    }

    /// Stresses `D (e - e0 + c e')` at one station.
    fn stresses(&self, station: &Station, strains: &Strains) -> Vec<f64> {
        let count = station.measures.len();
        let stress = |k: usize| {
            (0..count)
                .map(|l| {
                    station.stiffness[count * k + l] * (strains.values[l] + self.properties.damping * strains.rates[l])
                })
                .sum()
        };
        (0..count).map(stress).collect()
    }

    /// Strain energy, J.
    pub fn energy(&self, q: &[f64]) -> f64 {
        let rest = vec![0.0; q.len()];
        let mut energy = 0.0;
        for station in &self.stations {
            let strains = self.strains(station, q, &rest);
            // At rest the stresses are those of the strains alone.
            for (stress, value) in self.stresses(station, &strains).iter().zip(&strains.values) {
                energy += 0.5 * station.weight * stress * value;
            }
        }
        energy
    }

    /// Adds the elastic and damping force to `force`.
    pub fn add_force(&self, q: &[f64], v: &[f64], force: &mut [f64]) {
        for station in &self.stations {
            let strains = self.strains(station, q, v);
            for (stress, row) in self.stresses(station, &strains).iter().zip(&strains.by_q) {
                for i in 0..force.len() {
                    force[i] += station.weight * stress * row[i];
                }
            }
        }
    }

    /// Second mass moments `M^ab`, exact.
    ///
    /// # Errors
    /// As [`gauss_legendre`].
    pub fn second_moments(&self) -> Result<[[f64; VECTORS]; VECTORS]> {
        let p = &self.properties;
        let mut m = [[0.0; VECTORS]; VECTORS];
        for Point { xi, weight } in gauss_legendre(4)? {
            let rows = particle(p.dimension, xi, p.length);
            for (row, mass) in rows.iter().zip(p.mass) {
                for a in 0..VECTORS {
                    for b in 0..VECTORS {
                        m[a][b] += weight * p.length * mass * row[a] * row[b];
                    }
                }
            }
        }
        Ok(m)
    }
}

/// Sets `force` to the elastic and damping force, `k` to its derivative by q and `c` to that by v (row after row).
///
/// Plain loops over run-time sizes: the yardstick of the generated kernels.
pub fn residual_and_jacobian(q: &[f64], v: &[f64], element: &Element, force: &mut [f64], k: &mut [f64], c: &mut [f64]) {
    force.fill(0.0);
    k.fill(0.0);
    c.fill(0.0);
    for station in &element.stations {
        let strains = element.strains(station, q, v);
        let stresses = element.stresses(station, &strains);
        add_material(element, station, &strains, k, c);
        for (m, stress) in stresses.iter().enumerate() {
            let stress = station.weight * stress;
            for i in 0..force.len() {
                force[i] += stress * strains.by_q[m][i];
            }
            add_geometric(element, station, station.measures[m], stress, k);
        }
    }
}

/// Adds `B^T D (B + c B')` to `k` and `c B^T D B` to `c`.
fn add_material(element: &Element, station: &Station, strains: &Strains, k: &mut [f64], c: &mut [f64]) {
    let (size, count) = (element.coordinates(), station.measures.len());
    let damping = element.properties.damping;
    for m in 0..count {
        let (mut by_q, mut by_v) = (vec![0.0; size], vec![0.0; size]);
        for l in 0..count {
            let d = station.weight * station.stiffness[count * m + l];
            for j in 0..size {
                by_q[j] += d * (strains.by_q[l][j] + damping * strains.rates_by_q[l][j]);
                by_v[j] += d * damping * strains.by_q[l][j];
            }
        }
        for i in 0..size {
            let b = strains.by_q[m][i];
            for j in 0..size {
                k[size * i + j] += b * by_q[j];
                c[size * i + j] += b * by_v[j];
            }
        }
    }
}

/// Adds `stress` times the second derivative of a measure to `k`.
fn add_geometric(element: &Element, station: &Station, measure: Measure, stress: f64, k: &mut [f64]) {
    let (n, size) = (element.properties.dimension, element.coordinates());
    for &(factor, f, g) in measure {
        for a in 0..element.properties.vectors() {
            for b in 0..element.properties.vectors() {
                let (f, g) = (&station.fields[f], &station.fields[g]);
                let value = stress * factor * (f[a] * g[b] + g[a] * f[b]);
                for i in 0..n {
                    k[size * (n * a + i) + n * b + i] += value;
                }
            }
        }
    }
}
