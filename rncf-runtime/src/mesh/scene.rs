//! The scene of a model: numbering, state, residual and tangents.

use super::assembly::{Connectivity, Scatter, evaluate};
use super::conditions::{Condition, condition, joint_data, row_count};
use super::frame::{FrameMotion, add};
use super::layout::{Layout, VectorKind};
use super::parts::{BodySpec, JointSpec, LoadKind, LoadSpec, ObservedSpec, Parts, Place, Prescribed};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::model::{Formulation, Joints};
use crate::system::{ConstraintLevel, State, System, Tangent};

/// Letters of the components.
const AXES: [&str; 3] = ["x", "y", "z"];

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
#[derive(Default)]
pub(super) struct Buffers {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    pub force: Vec<f64>,
    pub frames: Vec<FrameMotion>,
    pub results: Vec<f64>,
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
    pattern: Pattern,
    constraint_pattern: Pattern,
    /// For every constraint its condition and row.
    constraint_rows: Vec<(usize, usize)>,
    sizes: Vec<f64>,
    mass: Vec<f64>,
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
        let dimensions: Vec<usize> = specs
            .iter()
            .flat_map(|spec| std::iter::repeat_n(spec.dimension(), spec.vectors()))
            .collect();
        let mut kinds = vec![VectorKind::Free; dimensions.len()];
        for condition in &conditions {
            if condition.position_eliminated {
                kinds[condition.position] = VectorKind::Prescribed;
            }
            if condition.slope_kind != VectorKind::Free {
                kinds[condition.slope] = condition.slope_kind;
            }
        }
        let layout = Layout::new(&dimensions, kinds);
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
        let bodies: Vec<MeshBody> = specs
            .into_iter()
            .zip(firsts)
            .zip(connectivities)
            .enumerate()
            .map(|(index, ((spec, first_vector), connectivity))| {
                let mut mass = vec![0.0; spec.orders.len().pow(2)];
                parts.mass(index, &mut mass);
                let frame = if absolute(&spec) { 0 } else { spec.frame };
                let scatter = Scatter::new(&connectivity, &layout, &pattern);
                MeshBody {
                    spec,
                    first_vector,
                    frame,
                    connectivity,
                    scatter,
                    mass,
                }
            })
            .collect();
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
            buffers: Buffers {
                q: vec![0.0; layout.components()],
                v: vec![0.0; layout.components()],
                a: vec![0.0; layout.components()],
                force: vec![0.0; layout.components()],
                frames,
                results: Vec::new(),
            },
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
        for (index, condition) in self.conditions.iter().enumerate() {
            for &row in &condition.rows {
                let column = self.constraint_rows.len();
                self.constraint_rows.push((index, row));
                for component in self.condition_components(condition) {
                    if let Some((unknown, _)) = self.layout.unknown(component) {
                        entries.push((unknown, column));
                    }
                }
            }
        }
        self.constraint_pattern = Pattern::new(self.layout.unknowns(), self.constraint_rows.len(), entries);
    }

    /// Components of the position and slope that a condition is about.
    fn condition_components(&self, condition: &Condition) -> Vec<usize> {
        let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
        let of = |vector: usize| (0..dimension).map(move |component| self.layout.offset(vector) + component);
        of(condition.position).chain(of(condition.slope)).collect()
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
    fn locate(&self, vector: usize) -> (&MeshBody, usize, usize) {
        let index = self.bodies.partition_point(|body| body.first_vector <= vector) - 1;
        let body = &self.bodies[index];
        let within = vector - body.first_vector;
        let place = within % body.spec.vectors_per_node;
        let local = body
            .spec
            .connectivity
            .iter()
            .position(|&other| other == place)
            .unwrap_or(0);
        (body, within / body.spec.vectors_per_node, local)
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
            ObservedSpec::Reaction { .. } => Ok(None),
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

    /// Fills the full state: frames, prescribed vectors, then the unknowns.
    pub(super) fn load_state(&mut self, t: f64, x: &[f64], v: &[f64], a: &[f64], regime: Regime) {
        let buffers = &mut self.buffers;
        self.parts.frames(t, &mut buffers.frames);
        if let Regime::Steady(scale) = regime {
            for frame in &mut buffers.frames {
                *frame = frame.steady(scale);
            }
        }
        for condition in &self.conditions {
            let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
            let slope_prescribed = condition.slope_kind == VectorKind::Prescribed;
            if !condition.position_eliminated && !slope_prescribed {
                continue;
            }
            let mut prescribed = Prescribed::default();
            self.parts
                .prescribed(condition.joint, condition.absolute, t, &condition.data, &mut prescribed);
            let mut set = |vector: usize, values: [[f64; 3]; 3]| {
                let place = self.layout.offset(vector);
                buffers.q[place..place + dimension].copy_from_slice(&values[0][..dimension]);
                buffers.v[place..place + dimension].copy_from_slice(&values[1][..dimension]);
                buffers.a[place..place + dimension].copy_from_slice(&values[2][..dimension]);
            };
            if condition.position_eliminated {
                set(condition.position, prescribed.position);
            }
            if slope_prescribed {
                set(condition.slope, prescribed.slope);
            }
        }
        self.layout.expand(x, &mut buffers.q);
        self.layout.expand(v, &mut buffers.v);
        self.layout.expand(a, &mut buffers.a);
    }

    /// Sum of all gravity loads, inertial axes.
    pub(super) fn gravity(&self, t: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (index, load) in self.loads.iter().enumerate() {
            if load.kind == LoadKind::Gravity {
                sum = add(
                    sum,
                    self.buffers.frames[load.frame].direction_to_inertial(self.parts.load(index, t)),
                );
            }
        }
        sum
    }

    /// `M a + f` of all components at the loaded state; loads are multiplied by `load_scale`.
    pub(super) fn full_force(&mut self, t: f64, load_scale: f64) {
        let gravity = self.gravity(t).map(|g| load_scale * g);
        let Buffers {
            q,
            v,
            a,
            force,
            frames,
            results,
        } = &mut self.buffers;
        force.fill(0.0);
        for (index, body) in self.bodies.iter().enumerate() {
            let action = frames[body.frame].action(body.spec.axes, gravity);
            let size = body.spec.element_size();
            let (q, v, a): (&[f64], &[f64], &[f64]) = (q, v, a);
            evaluate(body.spec.count, size, results, |element, result| {
                let mut local = [[0.0; MAX_SIZE]; 3];
                for (values, full) in local.iter_mut().zip([q, v, a]) {
                    body.connectivity.gather(element, full, &mut values[..size]);
                }
                let [q, v, a] = &local;
                self.parts.force(
                    index,
                    element,
                    body.frame == 0,
                    &action,
                    &q[..size],
                    &v[..size],
                    &a[..size],
                    result,
                );
            });
            for element in 0..body.spec.count {
                let local = &results[element * size..(element + 1) * size];
                for (&component, value) in body.connectivity.element(element).iter().zip(local) {
                    force[component] += value;
                }
            }
        }
        self.add_loads(t, load_scale);
    }

    /// Force or moment of a load in the axes of its body, in their order.
    fn load_in_body(&self, index: usize, t: f64, body: &MeshBody) -> [f64; 3] {
        let load = &self.loads[index];
        let mut value = self.parts.load(index, t);
        if load.frame != body.frame {
            let frames = &self.buffers.frames;
            value = frames[body.frame].direction_to_frame(frames[load.frame].direction_to_inertial(value));
        }
        match (&load.kind, body.spec.axes) {
            (LoadKind::Moment { .. }, &[first, second]) => [value[3 - first - second], 0.0, 0.0],
            (_, axes) => {
                let mut components = [0.0; 3];
                for (place, &axis) in axes.iter().enumerate() {
                    components[place] = value[axis];
                }
                components
            }
        }
    }

    fn add_loads(&mut self, t: f64, load_scale: f64) {
        for index in 0..self.loads.len() {
            let Some(point) = &self.load_points[index] else {
                continue;
            };
            let body = &self.bodies[point.body];
            let dimension = body.spec.dimension();
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let components = body.connectivity.element(point.element);
            match self.loads[index].kind {
                LoadKind::Gravity => {}
                LoadKind::Force { .. } => {
                    for (place, &component) in components.iter().enumerate() {
                        let weight = point.values[place / dimension];
                        self.buffers.force[component] -= weight * value[place % dimension];
                    }
                }
                LoadKind::Moment { .. } => {
                    let slope = weighted(&self.buffers.q, components, dimension, &point.slopes);
                    let mut force = [0.0; 3];
                    self.parts
                        .moment(dimension, &slope[..dimension], value, &mut force[..dimension]);
                    for (place, &component) in components.iter().enumerate() {
                        let weight = point.slopes[place / dimension];
                        self.buffers.force[component] -= weight * force[place % dimension];
                    }
                }
            }
        }
    }

    /// Derivatives of [`MeshScene::full_force`] at the loaded state, on the pattern.
    pub(super) fn full_tangent(&mut self, t: f64, load_scale: f64, stiffness: &mut [f64], damping: &mut [f64]) {
        stiffness.fill(0.0);
        damping.fill(0.0);
        let Buffers {
            q, v, frames, results, ..
        } = &mut self.buffers;
        for (index, body) in self.bodies.iter().enumerate() {
            let action = frames[body.frame].action(body.spec.axes, [0.0; 3]);
            let size = body.spec.element_size();
            let (q, v): (&[f64], &[f64]) = (q, v);
            let width = 2 * size * size;
            evaluate(body.spec.count, width, results, |element, result| {
                let mut local = [[0.0; MAX_SIZE]; 2];
                for (values, full) in local.iter_mut().zip([q, v]) {
                    body.connectivity.gather(element, full, &mut values[..size]);
                }
                let (k, c) = result.split_at_mut(size * size);
                let [q, v] = &local;
                self.parts
                    .tangent(index, element, body.frame == 0, &action, &q[..size], &v[..size], k, c);
            });
            for element in 0..body.spec.count {
                let (k, c) = results[element * width..(element + 1) * width].split_at(size * size);
                body.scatter.add(element, k, stiffness);
                body.scatter.add(element, c, damping);
            }
        }
        self.add_load_tangents(t, load_scale, stiffness);
    }

    fn add_load_tangents(&self, t: f64, load_scale: f64, stiffness: &mut [f64]) {
        for (index, point) in self.load_points.iter().enumerate() {
            let (Some(point), LoadKind::Moment { .. }) = (point, self.loads[index].kind) else {
                continue;
            };
            let body = &self.bodies[point.body];
            let (dimension, size) = (body.spec.dimension(), body.spec.element_size());
            let value = self.load_in_body(index, t, body).map(|x| load_scale * x);
            let slope = weighted(
                &self.buffers.q,
                body.connectivity.element(point.element),
                dimension,
                &point.slopes,
            );
            let mut block = [0.0; 9];
            self.parts.moment_tangent(
                dimension,
                &slope[..dimension],
                value,
                &mut block[..dimension * dimension],
            );
            let mut local = vec![0.0; size * size];
            for row in 0..size {
                for column in 0..size {
                    let weight = point.slopes[row / dimension] * point.slopes[column / dimension];
                    local[row * size + column] = -weight * block[row % dimension * dimension + column % dimension];
                }
            }
            body.scatter.add(point.element, &local, stiffness);
        }
    }

    /// Position and slope of a condition's node in one of the full arrays.
    fn node(&self, condition: &Condition, full: &[f64]) -> [f64; 6] {
        let mut node = [0.0; 6];
        for (place, component) in self.condition_components(condition).into_iter().enumerate() {
            node[place] = full[component];
        }
        node
    }
}

/// Degrees of freedom of the largest element.
pub(super) const MAX_SIZE: usize = 32;

/// `sum_a weight_a q_a` of an element.
pub(super) fn weighted(full: &[f64], components: &[usize], dimension: usize, weights: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (place, &component) in components.iter().enumerate() {
        sum[place % dimension] += weights[place / dimension] * full[component];
    }
    sum
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

impl<P: Parts> System for MeshScene<P> {
    fn unknowns(&self) -> usize {
        self.layout.unknowns()
    }

    fn constraints(&self) -> usize {
        self.constraint_rows.len()
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn constraint_pattern(&self) -> &Pattern {
        &self.constraint_pattern
    }

    fn mass(&mut self, values: &mut [f64]) {
        values.copy_from_slice(&self.mass);
    }

    fn residual(&mut self, t: f64, x: &[f64], v: &[f64], a: &[f64], out: &mut [f64]) {
        self.load_state(t, x, v, a, Regime::Moving);
        self.full_force(t, 1.0);
        self.layout.project(&self.buffers.force, out);
    }

    fn tangent(&mut self, state: &State, out: &mut Tangent) {
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        out.stiffness.resize(self.pattern.entries(), 0.0);
        out.damping.resize(self.pattern.entries(), 0.0);
        // The conditions are linear in the unknowns: C_x^T lambda has no derivative.
        self.full_tangent(state.t, 1.0, &mut out.stiffness, &mut out.damping);
    }

    fn constraint(&mut self, level: ConstraintLevel, state: &State, out: &mut [f64]) {
        if self.constraint_rows.is_empty() {
            return;
        }
        self.load_state(state.t, &state.x, &state.v, &state.a, Regime::Moving);
        let mut column = 0;
        for condition in &self.conditions {
            let joint = &self.joints[condition.joint];
            let count = row_count(joint.kind, self.bodies[joint.body].spec.dimension());
            let mut rows = [0.0; 6];
            let [q, v, a] = [&self.buffers.q, &self.buffers.v, &self.buffers.a].map(|full| self.node(condition, full));
            let width = 2 * self.bodies[joint.body].spec.dimension();
            self.parts.condition(
                condition.joint,
                condition.absolute,
                level,
                state.t,
                &condition.data,
                &q[..width],
                &v[..width],
                &a[..width],
                &mut rows[..count],
            );
            for &row in &condition.rows {
                out[column] = rows[row];
                column += 1;
            }
        }
    }

    fn constraint_jacobian(&mut self, t: f64, _x: &[f64], values: &mut [f64]) {
        values.fill(0.0);
        for (column, &(index, row)) in self.constraint_rows.iter().enumerate() {
            let condition = &self.conditions[index];
            let joint = &self.joints[condition.joint];
            let dimension = self.bodies[joint.body].spec.dimension();
            let count = row_count(joint.kind, dimension);
            let mut jacobian = [0.0; 36];
            let width = 2 * dimension;
            self.parts.condition_jacobian(
                condition.joint,
                condition.absolute,
                t,
                &condition.data,
                &mut jacobian[..count * width],
            );
            for (place, component) in self.condition_components(condition).into_iter().enumerate() {
                if let Some((unknown, factor)) = self.layout.unknown(component)
                    && let Some(entry) = self.constraint_pattern.find(unknown, column)
                {
                    values[entry] += factor * jacobian[row * width + place];
                }
            }
        }
    }

    fn sizes(&self) -> &[f64] {
        &self.sizes
    }

    fn describe_unknown(&self, index: usize) -> String {
        let (vector, component) = self.layout.origins()[index];
        let (body, node, local) = self.locate(vector);
        let what = match self.layout.kind(vector) {
            VectorKind::Directed(_) => "norm",
            _ => AXES[body.spec.axes[component]],
        };
        format!(
            "body `{}`, node {node}, {} {what}",
            body.spec.name, body.spec.meanings[local]
        )
    }

    fn describe_constraint(&self, index: usize) -> String {
        let (condition, row) = self.constraint_rows[index];
        let joint = &self.joints[self.conditions[condition].joint];
        let dimension = self.bodies[joint.body].spec.dimension();
        let what = if row < dimension { "position" } else { "direction" };
        format!("joint `{}`, {what}", joint.name)
    }

    fn kinks(&self) -> Vec<f64> {
        let mut kinks: Vec<f64> = self.parts.kinks().into_iter().filter(|t| t.is_finite()).collect();
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }

    fn energy(&mut self, state: &State) -> Option<f64> {
        self.total_energy(state)
    }
}
