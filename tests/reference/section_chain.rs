//! A chain of ten-vector elements (THEORY 5.2): assembly, stress-free shapes, supports, fixtures.
//!
//! Vectors of the chain: node, middle directors, node, ..; an element has its own ten (planar: seven) in a row.

use crate::Result;
use crate::banded::Banded;
use crate::section_beam::{Element, Properties, residual_and_jacobian};

/// The stress-free beam at one place: r, r_x, r_y, r_z.
pub type Shape = [[f64; 3]; 4];

/// One of a node's vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// Position r.
    Position = 0,
    /// Slope r_x.
    Slope = 1,
    /// Director r_y.
    Y = 2,
    /// Director r_z; spatial only.
    Z = 3,
}

/// Straight shape along +x with the axes of the frame.
pub fn straight(x: f64) -> Shape {
    [[x, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
}

/// A chain of elements of equal length.
#[derive(Clone, Debug)]
pub struct Chain {
    dimension: usize,
    elements: Vec<Element>,
    stress_free: Vec<f64>,
    /// Second mass moments of fixtures: two vectors and a value, both orders.
    fixtures: Vec<(usize, usize, f64)>,
}

/// What is derived from the elastic forces in the unknowns of [`Supports`].
#[derive(Clone, Debug)]
pub struct Forces {
    /// Elastic force.
    pub force: Vec<f64>,
    /// Its derivative by the positions.
    pub tangent: Banded,
    /// That of the damping force by the velocities.
    pub damping: Banded,
}

impl Chain {
    /// `count` elements along the curve `shape(x)`, `x` from 0 to `properties.length` (of the whole chain), where they
    /// are free of stress.
    ///
    /// # Errors
    /// If there are no elements; as [`Element::straight`].
    pub fn along(properties: Properties, count: usize, shape: impl Fn(f64) -> Shape) -> Result<Self> {
        if count == 0 {
            return Err("the beam has no elements: ask for 1 or more".into());
        }
        let n = properties.dimension;
        let length = properties.length / count as f64;
        let mut stress_free = Vec::new();
        let nodes = if n == 2 { 3 } else { 4 };
        for half in 0..=2 * count {
            let here = shape(0.5 * length * half as f64);
            let from = if half % 2 == 0 { 0 } else { 2 };
            here[from..nodes]
                .iter()
                .for_each(|vector| stress_free.extend(&vector[..n]));
        }
        let data = Properties { length, ..properties };
        let (size, stride) = (n * data.vectors(), n * (data.vectors() - nodes));
        let elements = (0..count).map(|e| Element::stress_free_at(data, &stress_free[e * stride..][..size]));
        Ok(Self {
            dimension: n,
            elements: elements.collect::<Result<_>>()?,
            stress_free,
            fixtures: Vec::new(),
        })
    }

    /// Components of a vector.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.elements.len()
    }

    /// Coordinates of the stress-free shape.
    pub fn stress_free(&self) -> &[f64] {
        &self.stress_free
    }

    /// Coordinates from one element's first to the next one's.
    fn stride(&self) -> usize {
        if self.dimension == 2 { 8 } else { 18 }
    }

    /// Place of a vector of a node among the vectors.
    pub fn vector(&self, node: usize, slot: Slot) -> usize {
        node * self.stride() / self.dimension + slot as usize
    }

    /// A vector out of coordinates; planar ones have 0 along z.
    pub fn read(&self, q: &[f64], vector: usize) -> [f64; 3] {
        let mut value = [0.0; 3];
        value[..self.dimension].copy_from_slice(&q[self.dimension * vector..][..self.dimension]);
        value
    }

    /// Adds a rigid part (THEORY 5.4): particles `r + X_i r_i` of a node with mass `mass`, centre `center` along
    /// r_x, r_y, r_z (m) and second moments `int X_i X_j` about the node (kg m^2, diagonal).
    pub fn attach(&mut self, node: usize, mass: f64, center: [f64; 3], second: [f64; 3]) {
        let r = self.vector(node, Slot::Position);
        self.fixtures.push((r, r, mass));
        for i in 0..self.dimension {
            self.fixtures.push((r, r + 1 + i, mass * center[i]));
            self.fixtures.push((r + 1 + i, r, mass * center[i]));
            self.fixtures.push((r + 1 + i, r + 1 + i, second[i]));
        }
    }

    /// Second mass moments over the vectors, each pair that is not zero, repeated ones add up.
    ///
    /// # Errors
    /// As [`Element::second_moments`].
    pub fn second_moments(&self) -> Result<Vec<(usize, usize, f64)>> {
        let mut moments = self.fixtures.clone();
        for (e, element) in self.elements.iter().enumerate() {
            let (first, m) = (e * self.stride() / self.dimension, element.second_moments()?);
            for a in 0..element.properties().vectors() {
                for b in 0..element.properties().vectors() {
                    moments.push((first + a, first + b, m[a][b]));
                }
            }
        }
        Ok(moments)
    }

    /// Strain energy, J.
    pub fn energy(&self, q: &[f64]) -> f64 {
        let part = |(e, element): (usize, &Element)| element.energy(&q[e * self.stride()..][..element.coordinates()]);
        self.elements.iter().enumerate().map(part).sum()
    }

    /// Elastic force, tangent and damping matrix at rest, in the unknowns.
    pub fn forces(&self, q: &[f64], supports: &Supports) -> Forces {
        let mut sum = Forces {
            force: vec![0.0; supports.unknowns()],
            tangent: supports.matrix(),
            damping: supports.matrix(),
        };
        for (e, element) in self.elements.iter().enumerate() {
            let (first, size) = (e * self.stride(), element.coordinates());
            let (mut force, mut k, mut c) = (vec![0.0; size], vec![0.0; size * size], vec![0.0; size * size]);
            let (q, rest) = (&q[first..first + size], vec![0.0; size]);
            residual_and_jacobian(q, &rest, element, &mut force, &mut k, &mut c);
            for i in 0..size {
                supports.add(first + i, force[i], &mut sum.force);
                for j in 0..size {
                    supports.add_pair(first + i, first + j, k[size * i + j], &mut sum.tangent);
                    supports.add_pair(first + i, first + j, c[size * i + j], &mut sum.damping);
                }
            }
        }
        sum
    }
}

/// Which coordinates move: `q = q_0 + E x`, each coordinate by at most one unknown.
#[derive(Clone, Debug)]
pub struct Supports {
    /// Unknown and factor of every coordinate.
    places: Vec<Option<(usize, f64)>>,
    unknowns: usize,
    half: usize,
}

/// How a vector is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// It stays as it is.
    Fixed,
    /// It keeps its direction; its norm is free. Both axes of a section in space, which are along coordinate axes, keep
    /// their rotation: their norms and the shear between them are free.
    Direction,
}

impl Supports {
    /// Supports of a chain by the vectors that are held.
    pub fn new(chain: &Chain, held: &[(usize, Hold)]) -> Self {
        let n = chain.dimension;
        let (mut places, mut unknowns) = (Vec::new(), 0);
        for vector in 0..chain.stress_free.len() / n {
            match held.iter().find(|(place, _)| *place == vector).map(|(_, hold)| hold) {
                None => {
                    places.extend((0..n).map(|k| Some((unknowns + k, 1.0))));
                    unknowns += n;
                }
                Some(Hold::Fixed) => places.extend(vec![None; n]),
                Some(Hold::Direction) => {
                    let direction = &chain.stress_free[n * vector..][..n];
                    let norm = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
                    places.extend(direction.iter().map(|x| Some((unknowns, x / norm))));
                    unknowns += 1;
                    let axis = |vector: usize| {
                        let axis = &chain.stress_free[n * vector..][..n];
                        axis.iter().position(|x| x.abs() == 1.0)
                    };
                    let is_pair = n == 3 && vector > 0 && held.contains(&(vector - 1, Hold::Direction));
                    if let (true, Some(first), Some(second)) = (is_pair, axis(vector - 1), axis(vector)) {
                        places[n * (vector - 1) + second] = Some((unknowns, 1.0));
                        places[n * vector + first] = Some((unknowns, 1.0));
                        unknowns += 1;
                    }
                }
            }
        }
        let size = chain.elements.first().map_or(0, Element::coordinates);
        Self {
            places,
            unknowns,
            half: size - 1,
        }
    }

    /// A clamp at the start (THEORY 5.2): r fixed, both directors held, r_x free.
    pub fn clamp(chain: &Chain, directors: Hold) -> Self {
        Self::new(chain, &clamp(chain, directors))
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// Zero matrix over the unknowns.
    pub fn matrix(&self) -> Banded {
        Banded::zero(self.unknowns, self.half)
    }

    /// Adds a coordinate's entry of a vector: `E^T`.
    pub fn add(&self, coordinate: usize, value: f64, out: &mut [f64]) {
        if let Some((unknown, factor)) = self.places[coordinate] {
            out[unknown] += factor * value;
        }
    }

    /// Adds a pair's entry of a matrix: `E^T .. E`.
    pub fn add_pair(&self, i: usize, j: usize, value: f64, out: &mut Banded) {
        if let (Some((row, left)), Some((column, right))) = (self.places[i], self.places[j])
            && value != 0.0
        {
            out.add(row, column, left * value * right);
        }
    }

    /// Adds `E x` to coordinates.
    pub fn move_by(&self, x: &[f64], q: &mut [f64]) {
        for (value, place) in q.iter_mut().zip(&self.places) {
            if let Some((unknown, factor)) = place {
                *value += factor * x[*unknown];
            }
        }
    }
}

/// What a clamp at the start holds.
pub fn clamp(chain: &Chain, directors: Hold) -> Vec<(usize, Hold)> {
    let mut held = vec![
        (chain.vector(0, Slot::Position), Hold::Fixed),
        (chain.vector(0, Slot::Y), directors),
    ];
    if chain.dimension == 3 {
        held.push((chain.vector(0, Slot::Z), directors));
    }
    held
}
