//! A straight beam as a chain of equal elements, and the ways its root is held; whatever frame it is written in.

use crate::Result;
use crate::dense::Matrix;
use crate::element::{Data, ElasticForce, GaussElement, MAX_COORDINATES, Weights};
use crate::inertia::{Frame, Inertia, State, residual, residual_and_jacobian};

/// Data of the whole beam, along +x of its frame from the root.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Number of elements.
    pub elements: usize,
    /// Length of the beam, m.
    pub length: f64,
    /// Distance of the root from the axis of rotation, m.
    pub hub_radius: f64,
    /// How the root is held.
    pub root: Root,
    /// Data of each element but for its length, which is overwritten by `length / elements`.
    pub element: Data,
}

/// What is prescribed at the root; its position always is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Root {
    /// Position alone.
    Pinned,
    /// Position and the direction of the slope, whose norm is one unknown (THEORY 5.1, remark iv).
    Clamped,
    /// Position and the whole slope.
    ClampedFully,
}

impl Beam {
    /// The beam of THEORY 9.1: 8 m of aluminium, undamped, five Gauss points, root clamped on the axis of rotation.
    pub fn spin_up(dimension: usize, elements: usize, exponent: u32) -> Self {
        let (young, area, inertia, density) = (68.95e9, 0.7299e-4, 0.8215e-8, 2766.67);
        let element = Data {
            dimension,
            length: 8.0,
            mass_per_length: density * area,
            axial_stiffness: young * area,
            bending_stiffness: young * inertia,
            exponent,
            damping: 0.0,
            points: 5,
        };
        Self {
            elements,
            length: 8.0,
            hub_radius: 0.0,
            root: Root::Clamped,
            element,
        }
    }
}

/// The assembled chain in all its coordinates: node after node, position then slope, components inside.
#[derive(Clone, Debug)]
pub struct Chain {
    beam: Beam,
    elastic: GaussElement,
    inertia: Inertia,
}

impl Chain {
    /// Prepares the element that all share.
    ///
    /// # Errors
    /// If there are no elements, the hub radius is not finite, or as [`Data::check`].
    pub fn new(beam: Beam) -> Result<Self> {
        if beam.elements == 0 {
            return Err("the beam has no elements: set elements to 1 or more".into());
        }
        if !beam.hub_radius.is_finite() {
            return Err(format!("hub_radius is {}, it must be finite", beam.hub_radius));
        }
        let data = Data {
            length: beam.length / beam.elements as f64,
            ..beam.element
        };
        Ok(Self {
            beam,
            elastic: GaussElement::straight(data)?,
            inertia: Inertia::new(&data)?,
        })
    }

    /// The beam's data.
    pub fn beam(&self) -> &Beam {
        &self.beam
    }

    /// Components of a vector.
    pub fn dimension(&self) -> usize {
        self.beam.element.dimension
    }

    /// Number of coordinates, `2 dimension (elements + 1)`.
    pub fn coordinates(&self) -> usize {
        2 * self.dimension() * (self.beam.elements + 1)
    }

    /// First coordinate of an element; it has the `4 dimension` from there on.
    fn first(&self, element: usize) -> usize {
        2 * self.dimension() * element
    }

    /// Coordinates of the straight, unstressed beam along +x from the origin.
    pub fn straight(&self) -> Vec<f64> {
        let n = self.dimension();
        let mut q = vec![0.0; self.coordinates()];
        for node in 0..=self.beam.elements {
            q[2 * n * node] = self.beam.length * node as f64 / self.beam.elements as f64;
            q[2 * n * node + n] = 1.0;
        }
        q
    }

    /// Strain energy, J.
    pub fn strain_energy(&self, q: &[f64]) -> f64 {
        let size = self.elastic.coordinates();
        (0..self.beam.elements)
            .map(|e| self.elastic.energy(&q[self.first(e)..][..size]))
            .sum()
    }

    /// Mass matrix.
    pub fn mass(&self) -> Matrix {
        let size = self.elastic.coordinates();
        let mut block = vec![0.0; size * size];
        // In a frame that does not move the acceleration tangent is all there is.
        self.inertia
            .add_tangent(&Frame::default(), Weights::ACCELERATION, &mut block);
        let mut mass = Matrix::zero(self.coordinates());
        for e in 0..self.beam.elements {
            let first = self.first(e);
            for i in 0..size {
                for j in 0..size {
                    mass.add(first + i, first + j, block[size * i + j]);
                }
            }
        }
        mass
    }

    /// Sets `out` to the sum of the elements' residuals, without loads and constraints.
    pub fn residual(&self, state: State, frame: &Frame, out: &mut [f64]) {
        let size = self.elastic.coordinates();
        let mut local = [0.0; MAX_COORDINATES];
        out.fill(0.0);
        for e in 0..self.beam.elements {
            let first = self.first(e);
            residual(
                &self.elastic,
                &self.inertia,
                slice(state, first, size),
                frame,
                &mut local[..size],
            );
            for i in 0..size {
                out[first + i] += local[i];
            }
        }
    }

    /// Sets `out` to the weighted sum of the tangents.
    pub fn tangent(&self, state: State, frame: &Frame, weights: Weights, out: &mut Matrix) {
        let size = self.elastic.coordinates();
        let (mut local, mut block) = ([0.0; MAX_COORDINATES], [0.0; MAX_COORDINATES * MAX_COORDINATES]);
        out.clear();
        for e in 0..self.beam.elements {
            let first = self.first(e);
            let part = slice(state, first, size);
            let (local, block) = (&mut local[..size], &mut block[..size * size]);
            residual_and_jacobian(&self.elastic, &self.inertia, part, frame, weights, local, block);
            for i in 0..size {
                for j in 0..size {
                    out.add(first + i, first + j, block[size * i + j]);
                }
            }
        }
    }

    /// Whether two coordinates share an element.
    pub fn coupled(&self, i: usize, j: usize) -> bool {
        let node = |k: usize| k / (2 * self.dimension());
        node(i).abs_diff(node(j)) <= 1
    }
}

/// The part of a state that belongs to one element.
fn slice(state: State<'_>, first: usize, size: usize) -> State<'_> {
    let part = first..first + size;
    State {
        q: &state.q[part.clone()],
        qd: &state.qd[part.clone()],
        qdd: &state.qdd[part],
    }
}
