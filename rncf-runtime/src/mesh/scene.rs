//! The scene of a model: numbering, state, residual and tangents.

use super::assembly::{Connectivity, Scatter};
use super::conditions::{Condition, condition, joint_data};
use super::frame::FrameMotion;
use super::layout::{Layout, VectorKind};
use super::parts::{BodySpec, JointSpec, LoadKind, LoadSpec, ObservedSpec, Parts, Place};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::model::{Formulation, Joints};

/// A body with its numbering.
pub(super) struct MeshBody {
    pub spec: BodySpec,
    /// Global number of its first nodal vector.
    pub first_vector: usize,
    /// Frame that its vectors live in: the declared one, or the inertial one.
    pub frame: usize,
    pub connectivity: Connectivity,
    pub scatter: Scatter,
    /// Mass matrix of an element's vectors.
    pub mass: Vec<f64>,
}

/// A point of a body: element and weights of its nodal vectors.
pub(super) struct MeshPoint {
    pub body: usize,
    pub element: usize,
    pub values: Vec<f64>,
    pub slopes: Vec<f64>,
}

/// Buffers of the full (not reduced) state.
pub(super) struct Buffers {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    pub force: Vec<f64>,
    pub frames: Vec<FrameMotion>,
    pub results: Vec<f64>,
}

impl Buffers {
    fn new(components: usize, frames: Vec<FrameMotion>) -> Self {
        let zeros = || vec![0.0; components];
        Self {
            q: zeros(),
            v: zeros(),
            a: zeros(),
            force: zeros(),
            frames,
            results: Vec::new(),
        }
    }
}

/// How the frames are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Regime {
    /// As the motions say.
    Moving,
    /// In uniform rotation with this multiple of the spin.
    Steady(f64),
}

/// The scene of a model with emitted parts `P`.
pub struct MeshScene<P> {
    pub(super) parts: P,
    pub(super) formulation: Formulation,
    pub(super) bodies: Vec<MeshBody>,
    pub(super) joints: Vec<JointSpec>,
    pub(super) conditions: Vec<Condition>,
    pub(super) loads: Vec<LoadSpec>,
    pub(super) load_points: Vec<Option<MeshPoint>>,
    pub(super) observed: Vec<ObservedSpec>,
    pub(super) observed_points: Vec<Option<MeshPoint>>,
    pub(super) layout: Layout,
    pub(super) pattern: Pattern,
    pub(super) constraint_pattern: Pattern,
    /// For every constraint its condition and row.
    pub(super) constraint_rows: Vec<(usize, usize)>,
    pub(super) sizes: Vec<f64>,
    pub(super) mass: Vec<f64>,
    pub(super) buffers: Buffers,
}

impl<P: Parts> MeshScene<P> {
    /// Builds the scene: geometry, numbering, patterns.
    ///
    /// # Errors
    /// A count, length, material or section that makes no sense, by name.
    pub fn new(mut parts: P, formulation: Formulation, joints: Joints) -> Result<Self, ModelError> {
        let mut frames = vec![FrameMotion::INERTIAL; parts.frame_count()];
        parts.frames(0.0, &mut frames);
        let specs = parts.bodies();
        let joint_specs = parts.joints();
        let mut first_vector = 0;
        let mut firsts = Vec::new();
        for (index, spec) in specs.iter().enumerate() {
            check_body(spec)?;
            let length = spec.line.length() / spec.count as f64;
            parts.prepare(index, length, &element_shapes(spec))?;
            firsts.push(first_vector);
            first_vector += spec.vectors();
        }
        let absolute = |body: &BodySpec| formulation == Formulation::Ancf || body.frame == 0;
        let conditions: Vec<Condition> = joint_specs
            .iter()
            .enumerate()
            .map(|(index, joint)| {
                let body = &specs[joint.body];
                let data = joint_data(joint, body, &frames);
                condition(index, joint, body, firsts[joint.body], data, absolute(body), joints)
            })
            .collect();
        let layout = numbering(&specs, &conditions);
        let connectivities: Vec<Connectivity> = specs
            .iter()
            .zip(&firsts)
            .map(|(spec, &first)| connectivity(spec, first, &layout))
            .collect();
        let entries = connectivities
            .iter()
            .flat_map(|connectivity| connectivity.entries(&layout));
        let diagonal = (0..layout.unknowns()).map(|unknown| (unknown, unknown));
        let pattern = Pattern::new(layout.unknowns(), layout.unknowns(), entries.chain(diagonal));
        let bodies = specs.into_iter().zip(firsts).zip(connectivities).enumerate();
        let bodies = bodies.map(|(index, ((spec, first_vector), connectivity))| {
            let mut mass = vec![0.0; spec.orders.len().pow(2)];
            parts.mass(index, &mut mass);
            MeshBody {
                first_vector,
                frame: if absolute(&spec) { 0 } else { spec.frame },
                scatter: Scatter::new(&connectivity, &layout, &pattern),
                connectivity,
                mass,
                spec,
            }
        });
        let bodies = bodies.collect();
        let mut scene = Self {
            formulation,
            joints: joint_specs,
            loads: parts.loads(),
            load_points: Vec::new(),
            observed: parts.observed(),
            observed_points: Vec::new(),
            constraint_pattern: Pattern::new(layout.unknowns(), 0, []),
            constraint_rows: Vec::new(),
            sizes: Vec::new(),
            mass: vec![0.0; pattern.entries()],
            buffers: Buffers::new(layout.components(), frames),
            parts,
            bodies,
            conditions,
            layout,
            pattern,
        };
        scene.number_constraints();
        scene.sizes = scene.unknown_sizes();
        scene.assemble_mass();
        scene.load_points = scene
            .loads
            .iter()
            .map(|load| scene.load_point(load))
            .collect::<Result<_, _>>()?;
        scene.observed_points = scene
            .observed
            .iter()
            .map(|observed| scene.observed_point(observed))
            .collect::<Result<_, _>>()?;
        Ok(scene)
    }

    fn number_constraints(&mut self) {
        let mut entries = Vec::new();
        for (index, condition) in self.conditions.iter_mut().enumerate() {
            let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
            let layout = &self.layout;
            let of = |vector: usize| (0..dimension).map(move |component| layout.offset(vector) + component);
            condition.components = of(condition.position).chain(of(condition.slope)).collect();
            for &row in &condition.rows {
                let column = self.constraint_rows.len();
                self.constraint_rows.push((index, row));
                for &component in &condition.components {
                    if let Some((unknown, _)) = self.layout.unknown(component) {
                        entries.push((unknown, column));
                    }
                }
            }
        }
        self.constraint_pattern = Pattern::new(self.layout.unknowns(), self.constraint_rows.len(), entries);
    }

    fn unknown_sizes(&self) -> Vec<f64> {
        let origins = self.layout.origins();
        let size = |&(vector, _): &(usize, usize)| {
            let (body, _, local) = self.locate(vector);
            if body.spec.orders[local] == 0 {
                body.spec.line.length()
            } else {
                1.0
            }
        };
        origins.iter().map(size).collect()
    }

    /// Body, node and local number (of the start node) of a nodal vector.
    pub(super) fn locate(&self, vector: usize) -> (&MeshBody, usize, usize) {
        let index = self.bodies.partition_point(|body| body.first_vector <= vector) - 1;
        let body = &self.bodies[index];
        let (node, local) = body.spec.locate(vector - body.first_vector);
        (body, node, local)
    }

    fn assemble_mass(&mut self) {
        for body in &self.bodies {
            let (vectors, dimension) = (body.spec.orders.len(), body.spec.dimension());
            let size = vectors * dimension;
            let mut local = vec![0.0; size * size];
            for a in 0..vectors {
                for b in 0..vectors {
                    for c in 0..dimension {
                        local[(a * dimension + c) * size + b * dimension + c] = body.mass[a * vectors + b];
                    }
                }
            }
            for element in 0..body.spec.count {
                body.scatter.add(element, &local, &mut self.mass);
            }
        }
    }

    fn load_point(&self, load: &LoadSpec) -> Result<Option<MeshPoint>, ModelError> {
        match load.kind {
            LoadKind::Gravity => Ok(None),
            LoadKind::Force { body, at } | LoadKind::Moment { body, at } => self.point(body, at, load.name).map(Some),
        }
    }

    fn observed_point(&self, observed: &ObservedSpec) -> Result<Option<MeshPoint>, ModelError> {
        match *observed {
            ObservedSpec::Point { body, at, .. } => self.point(body, at, "an output").map(Some),
            _ => Ok(None),
        }
    }

    fn point(&self, body: usize, at: Place, user: &str) -> Result<MeshPoint, ModelError> {
        let spec = &self.bodies[body].spec;
        let length = spec.line.length();
        let (element, xi) = match at {
            Place::Start => (0, 0.0),
            Place::End => (spec.count - 1, 1.0),
            Place::At(x) if (0.0..=length).contains(&x) => {
                let place = x / length * spec.count as f64;
                let element = (place as usize).min(spec.count - 1);
                (element, place - element as f64)
            }
            Place::At(x) => {
                return Err(ModelError::new(format!(
                    "{user} is at {x} m of body `{}`, which is {length} m long: choose a place between 0 and its length",
                    spec.name
                )));
            }
        };
        let count = spec.orders.len();
        let mut point = MeshPoint {
            body,
            element,
            values: vec![0.0; count],
            slopes: vec![0.0; count],
        };
        self.parts.shapes(body, xi, &mut point.values, &mut point.slopes);
        Ok(point)
    }
}

/// Numbers the unknowns that the joints leave.
fn numbering(specs: &[BodySpec], conditions: &[Condition]) -> Layout {
    let dimensions = specs
        .iter()
        .flat_map(|spec| std::iter::repeat_n(spec.dimension(), spec.vectors()));
    let dimensions: Vec<usize> = dimensions.collect();
    let mut kinds = vec![VectorKind::Free; dimensions.len()];
    for condition in conditions {
        if condition.position_eliminated {
            kinds[condition.position] = VectorKind::Prescribed;
        }
        if condition.slope_kind != VectorKind::Free {
            kinds[condition.slope] = condition.slope_kind;
        }
    }
    Layout::new(&dimensions, kinds)
}

fn check_body(spec: &BodySpec) -> Result<(), ModelError> {
    let length = spec.line.length();
    if !(length.is_finite() && length > 0.0) {
        return Err(ModelError::new(format!(
            "body `{}` has the length {length} m: give its line two ends",
            spec.name
        )));
    }
    if spec.count == 0 {
        return Err(ModelError::new(format!(
            "body `{}` has no elements: its mesh needs at least one",
            spec.name
        )));
    }
    Ok(())
}

/// Nodal vectors of all elements in the stress-free shape, in local order and body axes.
fn element_shapes(spec: &BodySpec) -> Vec<f64> {
    let mut shapes = Vec::with_capacity(spec.count * spec.element_size());
    for element in 0..spec.count {
        for (local, &order) in spec.orders.iter().enumerate() {
            let node = element + spec.connectivity[local] / spec.vectors_per_node;
            shapes.extend(undeformed(spec, node, order));
        }
    }
    shapes
}

/// A nodal vector of the undeformed body, body axes in their order.
pub(super) fn undeformed(spec: &BodySpec, node: usize, order: usize) -> Vec<f64> {
    let (point, tangent) = spec.line.at(node as f64 / spec.count as f64);
    let vector = if order == 0 { point } else { tangent };
    spec.axes.iter().map(|&axis| vector[axis]).collect()
}

fn connectivity(spec: &BodySpec, first_vector: usize, layout: &Layout) -> Connectivity {
    let mut components = Vec::with_capacity(spec.count * spec.element_size());
    for element in 0..spec.count {
        for &place in spec.connectivity {
            let offset = layout.offset(first_vector + element * spec.vectors_per_node + place);
            components.extend(offset..offset + spec.dimension());
        }
    }
    Connectivity {
        size: spec.element_size(),
        components,
    }
}
