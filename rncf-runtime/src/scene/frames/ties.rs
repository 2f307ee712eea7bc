//! Free frames that follow a body: its mean axes (THEORY 6, Buckens) or its chord. The conditions are linear in the
//! body's nodal vectors with constant coefficients: `d^a (q_a - q0_a) = 0` and `M^ab q0_a x q_b = 0` for mean axes; for a
//! chord the start stays, the end stays on the line through both, and in space the moment about this line vanishes. Those
//! on one node are eliminated where that is free, the others are kept with multipliers.

use crate::emitted::{BodySpec, FrameTie, Interpolant, Parts};
use crate::error::ModelError;
use crate::linalg::{solve_full, symmetric_eigen};
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::numbering::layout::{Layout, VectorKind};
use crate::space::{Vector, perpendicular};

/// Radius of gyration about an axis, in lengths of the body, below which nothing ties the turning about it.
const SLENDER: f64 = 1e-7;
/// Distance of the ends, in lengths of the body, below which they have no direction.
const CLOSED: f64 = 1e-6;

/// The conditions of one body that are kept; divided by its mass, the turning ones by its length, too.
pub(crate) struct Tie {
    pub body: usize,
    /// First component of the body.
    pub first: usize,
    /// Coefficients of the body's components, row after row.
    pub rows: Vec<Vec<f64>>,
    /// Values of the rows in the shape that they refer to.
    pub reference: Vec<f64>,
}

impl Tie {
    /// The conditions of a body that refer to a shape (the components of all bodies), but those that are eliminated at its
    /// start and end.
    ///
    /// # Errors
    /// A shape that does not tie the turning, by the names of body and frame.
    pub fn new(
        index: usize,
        body: &MeshBody,
        layout: &Layout,
        shape: &[f64],
        eliminated: [bool; 2],
        frame: &str,
    ) -> Result<Self, ModelError> {
        let first = layout.offset(body.first_vector);
        let shape = &shape[first..first + body.spec.vectors() * body.spec.dimension()];
        let rows = match body.spec.tie {
            FrameTie::Joints => Vec::new(),
            FrameTie::MeanAxes => mean_axes(body, first, shape, frame)?,
            FrameTie::Chord => chord(body, first, shape, eliminated, frame)?,
        };
        let reference = rows.iter().map(|row| product(row, shape)).collect();
        Ok(Self {
            body: index,
            first,
            rows,
            reference,
        })
    }

    /// Values of the rows for the components of the body.
    pub fn products(&self, own: &[f64]) -> Vec<f64> {
        self.rows.iter().map(|row| product(row, own)).collect()
    }

    /// Values of the rows for one of the full arrays.
    pub fn values<'a>(&'a self, full: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        self.rows
            .iter()
            .map(|row| product(row, &full[self.first..self.first + row.len()]))
    }

    /// The components that a row reads, by their places in the full arrays, with their coefficients.
    pub fn entries<'a>(&self, row: &'a [f64]) -> impl Iterator<Item = (usize, f64)> + use<'a> {
        let first = self.first;
        let entries = row.iter().enumerate().filter(|(_, value)| **value != 0.0);
        entries.map(move |(place, &value)| (first + place, value))
    }
}

/// The velocity of the origin and the angular velocity (frame axes) with which a frame takes the rates of the conditions
/// away: `None` where there are none. The tie has all its rows.
pub(crate) fn taken(tie: &Tie, body: &MeshBody, shape: &[f64], rates: &[f64]) -> Option<[Vector; 2]> {
    let spec = &body.spec;
    let own = tie.first..tie.first + spec.vectors() * spec.dimension();
    let wanted = tie.products(&rates[own.clone()]);
    if wanted.iter().all(|rate| *rate == 0.0) {
        return None;
    }
    let shifts = spec.axes.iter().map(|&axis| [axis_vector(axis), Vector::zeros()]);
    let turns = (0..3)
        .map(axis_vector)
        .filter(|&turn| spec.dimension() == 3 || is_normal(spec, turn));
    let motions: Vec<[Vector; 2]> = shifts.chain(turns.map(|turn| [Vector::zeros(), turn])).collect();
    let size = motions.len();
    let (mut matrix, mut right) = (vec![0.0; size * size], vec![0.0; size * size]);
    for (column, &motion) in motions.iter().enumerate() {
        let mut field = vec![0.0; own.len()];
        add_rigid(spec, &shape[own.clone()], motion, 1.0, &mut field);
        for (row, value) in tie.products(&field).into_iter().enumerate() {
            matrix[row * size + column] = value;
        }
    }
    wanted
        .iter()
        .enumerate()
        .for_each(|(row, rate)| right[row * size] = *rate);
    let [found, _] = solve_full(size, &matrix, [&right, &vec![0.0; size * size]])?;
    let sum = |part: usize| {
        let parts = motions.iter().enumerate();
        parts.fold(Vector::zeros(), |sum, (row, motion)| {
            sum + found[row * size] * motion[part]
        })
    };
    Some([sum(0), sum(1)])
}

/// Adds the rates of a body's vectors in a rigid motion: velocity of the origin, angular velocity.
pub(crate) fn add_rigid(spec: &BodySpec, shape: &[f64], [shift, turn]: [Vector; 2], factor: f64, rates: &mut [f64]) {
    let dimension = spec.dimension();
    for vector in 0..spec.vectors() {
        let place = vector * dimension;
        let mut rate = turn.cross(&spread(spec, &shape[place..place + dimension]));
        if spec.nodal[spec.locate(vector).1].is_position() {
            rate += shift;
        }
        for (component, &axis) in spec.axes.iter().enumerate() {
            rates[place + component] += factor * rate[axis];
        }
    }
}

/// Shifts along the axes, turns about the axes or the normal.
fn mean_axes(body: &MeshBody, first: usize, shape: &[f64], frame: &str) -> Result<Vec<Vec<f64>>, ModelError> {
    let (spec, total) = (&body.spec, mass(body));
    let dimension = spec.dimension();
    let mut rows = shifts(body, first, shape.len());
    rows.iter_mut().flatten().for_each(|value| *value /= total);
    let turns: Vec<Vector> = (0..3)
        .map(axis_vector)
        .filter(|&turn| dimension == 3 || is_normal(spec, turn))
        .collect();
    let centre: Vector = spec
        .axes
        .iter()
        .zip(&rows)
        .fold(Vector::zeros(), |mut centre, (&axis, row)| {
            centre[axis] = product(row, shape);
            centre
        });
    let about = moved(spec, shape, centre);
    let moments: Vec<Vec<f64>> = turns.iter().map(|&turn| moment(body, first, shape, turn)).collect();
    let central: Vec<Vec<f64>> = turns.iter().map(|&turn| moment(body, first, &about, turn)).collect();
    let inertia: Vec<f64> = central
        .iter()
        .flat_map(|row| turns.iter().map(|&turn| turned(spec, turn, &about, row)))
        .collect();
    let least =
        symmetric_eigen(turns.len(), &inertia).map_or(0.0, |(values, _)| values.into_iter().fold(f64::MAX, f64::min));
    check_turning(body, least, "mean axes do", "its line", frame)?;
    for (row, &turn) in moments.into_iter().zip(&turns) {
        // The turning about a straight axis has only the inertia of the sections.
        let size = if spec.has_section() {
            (total * turned(spec, turn, shape, &row)).sqrt()
        } else {
            total * spec.line.length()
        };
        rows.push(row.into_iter().map(|value| value / size).collect());
    }
    Ok(rows)
}

/// The start stays, the end stays on its line, the moment about it vanishes.
fn chord(
    body: &MeshBody,
    first: usize,
    shape: &[f64],
    [start, end]: [bool; 2],
    frame: &str,
) -> Result<Vec<Vec<f64>>, ModelError> {
    let (spec, length) = (&body.spec, body.spec.line.length());
    let dimension = spec.dimension();
    let [from, to] = ends(spec).map(|vector| vector * dimension);
    let vector = |place: usize| spread(spec, &shape[place..place + dimension]);
    let along = direction(spec, vector(from), vector(to))?;
    let mut rows = Vec::new();
    let mut push = |place: usize, direction: Vector| {
        let mut row = vec![0.0; shape.len()];
        for (component, &axis) in spec.axes.iter().enumerate() {
            row[place + component] = direction[axis] / length;
        }
        rows.push(row);
    };
    if !start {
        spec.axes.iter().for_each(|&axis| push(from, axis_vector(axis)));
    }
    if !end {
        across(spec, along).into_iter().for_each(|normal| push(to, normal));
    }
    if dimension == 3 {
        let about = moved(spec, shape, vector(from));
        let row = moment(body, first, &about, along);
        let inertia = turned(spec, along, &about, &row);
        check_turning(body, inertia, "chord does", "this line", frame)?;
        let size = (mass(body) * inertia).sqrt();
        rows.push(row.into_iter().map(|value| value / size).collect());
    }
    Ok(rows)
}

/// Refuses a body without inertia against a turning.
fn check_turning(body: &MeshBody, inertia: f64, what: &str, line: &str, frame: &str) -> Result<(), ModelError> {
    let spec = &body.spec;
    let least = mass(body) * (SLENDER * spec.line.length()).powi(2);
    if spec.dimension() == 2 || inertia > least {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "body `{}` is straight: its {what} not tie the turning of frame `{frame}` about {line}: use joints to the frame with a constraint that turns it, or a curved line",
        spec.label()
    )))
}

/// Directions across a chord: two, or the one in the plane.
fn across(spec: &BodySpec, along: Vector) -> Vec<Vector> {
    match spec.plane_normal() {
        Some(normal) => vec![normal.cross(&along)],
        None => {
            let first = perpendicular(along);
            vec![first, along.cross(&first)]
        }
    }
}

/// Numbers of the positions at start and end among the vectors of a body.
pub(crate) fn ends(spec: &BodySpec) -> [usize; 2] {
    [false, true].map(|at_end| spec.end_vector(at_end, Interpolant::Position, 0).unwrap_or_default())
}

/// Unit vector from the start to the end.
fn direction(spec: &BodySpec, start: Vector, end: Vector) -> Result<Vector, ModelError> {
    let way = end - start;
    let distance = way.norm();
    if distance > CLOSED * spec.line.length() {
        return Ok(1.0 / distance * way);
    }
    Err(ModelError::new(format!(
        "the ends of body `{}` start {distance:.3e} m apart, which is no chord: let its frame follow its mean axes, `mean_axes;`",
        spec.label()
    )))
}

/// What a chord leaves unknown of the positions at start and end.
pub(crate) struct ChordEnds {
    vectors: [usize; 2],
    /// `None`: no elimination of this one.
    kinds: [Option<VectorKind>; 2],
}

impl ChordEnds {
    /// Of a body whose first vector has the number `first`. An end whose line passes the origin and is along no axis keeps
    /// constraints, for what depends on one unknown has no constant part.
    ///
    /// # Errors
    /// Ends at one place, by name.
    pub fn new(parts: &dyn Parts, index: usize, spec: &BodySpec, first: usize) -> Result<Self, ModelError> {
        let length = spec.line.length();
        let at =
            |u: f64| parts.initial(index, u * length)[0].map_or_else(|| spec.line.at(u).0, |[place, _]| place.into());
        let (start, end) = (at(0.0), at(1.0));
        let along = direction(spec, start, end)?;
        let mut components = [0.0; 3];
        for (component, &axis) in spec.axes.iter().enumerate() {
            components[component] = along[axis];
        }
        let is_along = |component: f64| component.abs() == 1.0;
        let kind = if components.into_iter().any(is_along) {
            Some(VectorKind::Held(components.map(|component| !is_along(component))))
        } else {
            (start == Vector::zeros()).then_some(VectorKind::Directed(components.into()))
        };
        Ok(Self {
            vectors: ends(spec).map(|vector| first + vector),
            kinds: [Some(VectorKind::Held([true; 3])), kind],
        })
    }

    /// Eliminates what is eliminated of vectors that nothing else holds and that `may` be; whether start and end are.
    pub fn eliminate(self, kinds: &mut [VectorKind], may: impl Fn(usize) -> bool) -> [bool; 2] {
        std::array::from_fn(|end| {
            let vector = self.vectors[end];
            let Some(kind) = self.kinds[end].filter(|_| kinds[vector] == VectorKind::Free && may(vector)) else {
                return false;
            };
            kinds[vector] = kind;
            true
        })
    }
}

/// Mass of the elements, kg.
fn mass(body: &MeshBody) -> f64 {
    let nodal = body.spec.nodal;
    let positions = |at: &usize| nodal[*at].is_position();
    let pairs = (0..nodal.len())
        .filter(positions)
        .flat_map(|a| (0..nodal.len()).filter(positions).map(move |b| (a, b)));
    let of = |element: usize| {
        let masses = body.mass_of(element);
        pairs.clone().map(|(a, b)| masses[a * nodal.len() + b]).sum::<f64>()
    };
    if body.is_even() {
        return body.spec.count as f64 * of(0);
    }
    (0..body.spec.count).map(of).sum()
}

/// Calls back with every entry of the mass matrices of all elements: components of both vectors from the body's first
/// on, whether they are positions, and the mass.
pub(crate) fn each_mass(body: &MeshBody, first: usize, mut each: impl FnMut(usize, usize, [bool; 2], f64)) {
    let (dimension, count) = (body.spec.dimension(), body.spec.nodal.len());
    for element in 0..body.spec.count {
        let (components, masses) = (body.connectivity.element(element), body.mass_of(element));
        for a in 0..count {
            for b in 0..count {
                let [from, to] = [a, b].map(|vector| components[vector * dimension] - first);
                let are_positions = [a, b].map(|vector| body.spec.nodal[vector].is_position());
                each(from, to, are_positions, masses[a * count + b]);
            }
        }
    }
}

/// Rows of the first moments, kg: one for every component.
fn shifts(body: &MeshBody, first: usize, size: usize) -> Vec<Vec<f64>> {
    let dimension = body.spec.dimension();
    let mut rows = vec![vec![0.0; size]; dimension];
    each_mass(body, first, |_, to, [is_position, _], mass| {
        if is_position {
            rows.iter_mut().enumerate().for_each(|(c, row)| row[to + c] += mass);
        }
    });
    rows
}

/// Row of the moment about an axis through the origin, `turn . (M^ab q0_a x q_b)`.
fn moment(body: &MeshBody, first: usize, shape: &[f64], turn: Vector) -> Vec<f64> {
    let spec = &body.spec;
    let dimension = spec.dimension();
    let mut row = vec![0.0; shape.len()];
    each_mass(body, first, |from, to, _, mass| {
        let arm = turn.cross(&spread(spec, &shape[from..from + dimension]));
        for (component, &axis) in spec.axes.iter().enumerate() {
            row[to + component] += mass * arm[axis];
        }
    });
    row
}

/// Components of a vector to three axes.
fn spread(spec: &BodySpec, components: &[f64]) -> Vector {
    let mut vector = Vector::zeros();
    for (value, &axis) in components.iter().zip(spec.axes) {
        vector[axis] = *value;
    }
    vector
}

/// The shape with positions from another origin.
fn moved(spec: &BodySpec, shape: &[f64], origin: Vector) -> Vec<f64> {
    let vectors = shape.chunks_exact(spec.dimension()).enumerate();
    let moved = vectors.flat_map(|(vector, components)| {
        let (_, local) = spec.locate(vector);
        let is_position = spec.nodal[local].is_position();
        let from = if is_position { origin } else { Vector::zeros() };
        components
            .iter()
            .zip(spec.axes)
            .map(move |(value, &axis)| value - from[axis])
    });
    moved.collect()
}

/// Value of a row when the shape turns about an axis by one: its moment of inertia, kg m^2.
fn turned(spec: &BodySpec, turn: Vector, shape: &[f64], row: &[f64]) -> f64 {
    let vectors = shape.chunks_exact(spec.dimension());
    let moved = vectors.flat_map(|vector| {
        let moved = turn.cross(&spread(spec, vector));
        spec.axes.iter().map(move |&axis| moved[axis])
    });
    row.iter().zip(moved).map(|(row, moved)| row * moved).sum()
}

fn axis_vector(axis: usize) -> Vector {
    Vector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 })
}

fn is_normal(spec: &BodySpec, turn: Vector) -> bool {
    spec.axes.iter().all(|&axis| turn[axis] == 0.0)
}

fn product(row: &[f64], values: &[f64]) -> f64 {
    row.iter().zip(values).map(|(a, b)| a * b).sum()
}

/// Refuses a tie to a frame that has not the motions which it needs.
pub(crate) fn check(spec: &BodySpec, frame: &str, unknowns: usize) -> Result<(), ModelError> {
    let needed = if spec.dimension() == 2 { 3 } else { 6 };
    if unknowns == needed {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "body `{}` ties frame `{frame}` to its {}, which needs {needed} free motions, and the frame has {unknowns}: free it along and about all axes",
        spec.label(),
        spec.tie.describe()
    )))
}
