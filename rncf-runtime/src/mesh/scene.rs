//! The scene of a model: numbering, state, residual and tangents.

use super::assembly::{Connectivity, Scatter};
use super::carried::Border;
use super::conditions::{Condition, condition, joint_data, vector_kinds};
use super::evaluate::weighted;
use super::fixtures::Fixture;
use super::frame::FrameMotion;
use super::frames::{Frames, FreeFrame, declared_free};
use super::layout::Layout;
use super::linked::{Linked, MarkedLoad, Marker, markers};
use super::markers::{ForceSpec, When};
use super::mean_axes::MeanAxes;
use super::modal::ModalBody;
use super::parts::{BodySpec, Fidelity, JointSpec, LoadKind, LoadSpec, ObservedSpec, Parts, Place};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::model::{Formulation, Joints};
use crate::vector::{Vector, norm};

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
    /// Its modes, where modal coordinates describe it.
    pub modes: Option<ModalBody>,
}

impl MeshBody {
    /// Components in the body's order to three frame axes.
    pub fn spread(&self, components: [f64; 3]) -> Vector {
        let mut vector = [0.0; 3];
        for (place, &axis) in self.spec.axes.iter().enumerate() {
            vector[axis] = components[place];
        }
        vector
    }
}

/// A point of a body: element and weights of its nodal vectors.
#[derive(Clone, Debug)]
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
    /// Jerks of prescribed vectors, else zero.
    pub jerks: Vec<f64>,
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
            jerks: zeros(),
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
    /// Free frames whose poses are unknown, ascending.
    pub(super) free: Vec<FreeFrame>,
    /// For every frame its index among the free ones.
    pub(super) free_of: Vec<Option<usize>>,
    /// Frames that stay at their start: those of mean axes where the bodies are absolute.
    pub(super) fixed: Vec<(usize, FrameMotion)>,
    /// First unknowns of orientations.
    pub(super) turns: Vec<usize>,
    pub(super) markers: Vec<Marker>,
    pub(super) constraints: Vec<Linked>,
    pub(super) forces: Vec<ForceSpec>,
    pub(super) marked_loads: Vec<MarkedLoad>,
    pub(super) fixtures: Vec<Fixture>,
    pub(super) mean_axes: Vec<MeanAxes>,
    /// For every body the places beside its free frame.
    pub(super) borders: Vec<Border>,
    pub(super) layout: Layout,
    pub(super) pattern: Pattern,
    pub(super) constraint_pattern: Pattern,
    /// What every constraint is.
    pub(super) constraint_rows: Vec<Row>,
    pub(super) sizes: Vec<f64>,
    /// Mass matrix of the nodal vectors.
    pub(super) mass: Vec<f64>,
    /// Whether inertia and elasticity of bodies with modes are left to the modes.
    pub(super) in_modes: bool,
    pub(super) buffers: Buffers,
}

/// A row of the constraints.
#[derive(Clone, Copy, Debug)]
pub(super) enum Row {
    /// Of a joint's conditions on a node.
    Condition { condition: usize, row: usize },
    /// Of the mean axes of a body.
    MeanAxes { axes: usize },
    /// Of a constraint on markers.
    Linked { linked: usize, row: usize },
}

impl<P: Parts> MeshScene<P> {
    /// Builds the scene: geometry, numbering, patterns.
    ///
    /// In absolute coordinates a frame that follows the mean axes of its bodies is no unknown: it
    /// stays at its start, and what refers to it reads that pose.
    ///
    /// # Errors
    /// A count, length, material or section that makes no sense, a frame whose parent or plane does
    /// not fit its motions, or something that acts where it cannot, by name.
    pub fn new(mut parts: P, formulation: Formulation, joints: Joints) -> Result<Self, ModelError> {
        let specs = parts.bodies();
        let Frames {
            free,
            free_of,
            fixed,
            motions,
        } = Frames::new(&parts, &specs, formulation)?;
        let declared_free: Vec<bool> = declared_free(&parts);
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
        let mut conditions = Vec::new();
        for (index, joint) in joint_specs.iter().enumerate() {
            let body = &specs[joint.body];
            check_joint(&parts, joint, body, &declared_free)?;
            // In absolute coordinates constraints on markers stand for a joint to the body's own free frame.
            if declared_free[body.frame] && absolute(body) {
                continue;
            }
            let data = joint_data(joint, body, &motions);
            conditions.push(condition(
                index,
                joint,
                body,
                firsts[joint.body],
                data,
                absolute(body),
                // Modes are those of the body as its frame holds it.
                if body.fidelity == Fidelity::Full {
                    joints
                } else {
                    Joints::Eliminated
                },
            ));
        }
        let border = free.iter().map(FreeFrame::count).sum();
        let layout = numbering(&specs, &conditions, border);
        let markers = markers(&parts, &specs, &free_of)?;
        let constraints = parts.constraints().into_iter().enumerate();
        let constraints = constraints.filter(|(_, spec)| match spec.when {
            When::Always => true,
            When::Absolute(body) => absolute(&specs[body]),
        });
        let constraints = constraints.map(|(index, spec)| Linked { index, spec }).collect();
        let connectivities = specs.iter().zip(&firsts);
        let bodies = connectivities.map(|(spec, &first)| MeshBody {
            first_vector: first,
            frame: if absolute(spec) { 0 } else { spec.frame },
            connectivity: connectivity(spec, first, &layout),
            scatter: Scatter::default(),
            mass: Vec::new(),
            modes: None,
            spec: spec.clone(),
        });
        let first_turn = layout.unknowns() - border;
        let turns = free.iter().filter(|frame| frame.turn.is_some());
        let turns = turns.map(|frame| first_turn + frame.first + frame.shifts()).collect();
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
            mass: Vec::new(),
            in_modes: false,
            buffers: Buffers::new(layout.components(), motions),
            bodies: bodies.collect(),
            free,
            free_of,
            fixed,
            turns,
            markers,
            constraints,
            forces: parts.forces(),
            marked_loads: Vec::new(),
            fixtures: Vec::new(),
            mean_axes: Vec::new(),
            borders: Vec::new(),
            pattern: Pattern::new(0, 0, []),
            parts,
            conditions,
            layout,
        };
        scene.place()?;
        scene.tabulate();
        scene.load_rest();
        scene.resolve_markers()?;
        scene.sizes = scene.unknown_sizes();
        Ok(scene)
    }

    /// Finds the places of loads, fixtures and outputs.
    fn place(&mut self) -> Result<(), ModelError> {
        self.load_points = self
            .loads
            .iter()
            .map(|load| self.load_point(load))
            .collect::<Result<_, _>>()?;
        let observed = self.observed.iter().map(|observed| self.observed_point(observed));
        self.observed_points = observed.collect::<Result<_, _>>()?;
        for (index, load) in self.loads.iter().enumerate() {
            let turned = self.free_of[load.frame].is_some();
            match (load.kind, &self.load_points[index]) {
                (LoadKind::Gravity, _) if turned => {
                    return Err(ModelError::new(format!(
                        "gravity `{}` is along the axes of frame `{}`, which is free: give it in the inertial frame",
                        load.name,
                        self.parts.frame_name(load.frame)
                    )));
                }
                (kind, Some(point)) if turned || self.free_of[self.bodies[point.body].frame].is_some() => {
                    let marker = Marker::Body {
                        point: point.clone(),
                        is_point: matches!(kind, LoadKind::Force { .. }),
                    };
                    self.marked_loads.push(MarkedLoad { load: index, marker });
                }
                _ => {}
            }
        }
        for spec in self.parts.fixtures() {
            let point = self.point(spec.body, spec.at, spec.name)?;
            self.fixtures.push(Fixture { spec, point });
        }
        self.check_fixed()
    }

    /// Refuses constraints and forces on frames that stay at their start.
    fn check_fixed(&self) -> Result<(), ModelError> {
        let users = self
            .constraints
            .iter()
            .map(|linked| (linked.spec.name, linked.spec.markers));
        let users = users.chain(self.forces.iter().map(|force| (force.name, force.markers)));
        for (name, markers) in users {
            for &marker in markers {
                let frame = self.marker_frame(&self.markers[marker]);
                if self.fixed.iter().any(|&(fixed, _)| fixed == frame) {
                    let frame = self.parts.frame_name(frame);
                    return Err(ModelError::new(format!(
                        "`{name}` acts on frame `{frame}`, which follows mean axes and has no pose in absolute coordinates: use the referenced formulation, or let `{name}` act on the body"
                    )));
                }
            }
        }
        Ok(())
    }

    /// Patterns, places on them, and constant matrices.
    fn tabulate(&mut self) {
        self.pattern = Pattern::new(self.layout.unknowns(), self.layout.unknowns(), self.entries());
        for index in 0..self.bodies.len() {
            let body = &mut self.bodies[index];
            body.scatter = Scatter::new(&body.connectivity, &self.layout, &self.pattern);
            body.mass = vec![0.0; body.spec.orders.len().pow(2)];
            self.parts.mass(index, &mut body.mass);
        }
        self.borders = (0..self.bodies.len()).map(|body| self.border_of(body)).collect();
        self.set_undeformed();
        self.find_mean_axes();
        self.number_constraints();
        self.assemble_mass();
    }

    /// Entries of the pattern: elements, the diagonal, what constraints and forces couple, frames.
    fn entries(&self) -> Vec<(usize, usize)> {
        let layout = &self.layout;
        let mut entries: Vec<(usize, usize)> = (0..layout.unknowns()).map(|unknown| (unknown, unknown)).collect();
        for body in &self.bodies {
            entries.extend(body.connectivity.entries(layout));
        }
        let of_markers = |markers: &[usize]| {
            let components = markers
                .iter()
                .flat_map(|&marker| self.marker_components(&self.markers[marker]));
            self.unknowns_of(components)
        };
        let mut groups: Vec<Vec<usize>> = self
            .constraints
            .iter()
            .map(|linked| of_markers(linked.spec.markers))
            .collect();
        groups.extend(self.forces.iter().map(|force| of_markers(force.markers)));
        for marked in &self.marked_loads {
            let turn = Marker::Turn {
                frame: self.loads[marked.load].frame,
            };
            let components = [&marked.marker, &turn]
                .into_iter()
                .flat_map(|marker| self.marker_components(marker));
            groups.push(self.unknowns_of(components));
        }
        groups.push((layout.unknowns() - layout.border()..layout.unknowns()).collect());
        for group in groups {
            entries.extend(group.iter().flat_map(|&i| group.iter().map(move |&j| (i, j))));
        }
        for body in &self.bodies {
            if let Some(free) = self.free_of[body.frame] {
                let first = layout.unknowns() - layout.border() + self.free[free].first;
                let unknowns = self.unknowns_of(body.connectivity.components.iter().copied());
                for unknown in unknowns {
                    let frame = first..first + self.free[free].count();
                    entries.extend(frame.flat_map(|border| [(unknown, border), (border, unknown)]));
                }
            }
        }
        entries
    }

    /// Unknowns of components, ascending, each once.
    fn unknowns_of(&self, components: impl Iterator<Item = usize>) -> Vec<usize> {
        let mut unknowns: Vec<usize> = components
            .filter_map(|component| self.layout.unknown(component).map(|(unknown, _)| unknown))
            .collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        unknowns
    }

    /// Held components keep the values that are set here.
    fn set_undeformed(&mut self) {
        let shape = self.shape();
        self.buffers.q[..shape.len()].copy_from_slice(&shape);
    }

    /// Components of all nodal vectors of the undeformed bodies, in their declared frames.
    pub(super) fn shape(&self) -> Vec<f64> {
        let mut shape = Vec::with_capacity(self.layout.vector_components());
        for body in &self.bodies {
            for within in 0..body.spec.vectors() {
                let (node, local) = body.spec.locate(within);
                shape.extend(undeformed(&body.spec, node, body.spec.orders[local]));
            }
        }
        shape
    }

    fn find_mean_axes(&mut self) {
        for (index, body) in self.bodies.iter().enumerate() {
            if body.spec.mean_axes && self.free_of[body.frame].is_some() {
                let first = self.layout.offset(body.first_vector);
                let count = body.spec.vectors() * body.spec.dimension();
                let shape = &self.buffers.q[first..first + count];
                self.mean_axes.push(MeanAxes::new(index, body, first, shape));
            }
        }
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
                self.constraint_rows.push(Row::Condition { condition: index, row });
                for &component in &condition.components {
                    if let Some((unknown, _)) = self.layout.unknown(component) {
                        entries.push((unknown, column));
                    }
                }
            }
        }
        for (index, axes) in self.mean_axes.iter().enumerate() {
            for row in &axes.rows {
                let unknowns = self.unknowns_of(axes.first..axes.first + row.len());
                let column = self.constraint_rows.len();
                entries.extend(unknowns.into_iter().map(|unknown| (unknown, column)));
                self.constraint_rows.push(Row::MeanAxes { axes: index });
            }
        }
        for (index, linked) in self.constraints.iter().enumerate() {
            let markers = linked.spec.markers.iter();
            let components = markers.flat_map(|&marker| self.marker_components(&self.markers[marker]));
            let unknowns = self.unknowns_of(components);
            for row in 0..linked.spec.rows.len() {
                let column = self.constraint_rows.len();
                entries.extend(unknowns.iter().map(|&unknown| (unknown, column)));
                self.constraint_rows.push(Row::Linked { linked: index, row });
            }
        }
        self.constraint_pattern = Pattern::new(self.layout.unknowns(), self.constraint_rows.len(), entries);
    }

    /// Place of the first row of the constraints on markers.
    pub(super) fn first_linked(&self) -> usize {
        let linked = |row: &Row| matches!(row, Row::Linked { .. });
        self.constraint_rows
            .iter()
            .position(linked)
            .unwrap_or(self.constraint_rows.len())
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
        let mut sizes: Vec<f64> = origins.iter().map(size).collect();
        let lengths: Vec<f64> = (0..self.free.len()).map(|free| self.length_at(free)).collect();
        let bodies = self.bodies.iter().map(|body| body.spec.line.length());
        let scene = lengths.iter().copied().chain(bodies).fold(0.0, f64::max);
        for (frame, &own) in self.free.iter().zip(&lengths) {
            let length = [own, scene].into_iter().find(|&length| length > 0.0).unwrap_or(1.0);
            let turns = frame.count() - frame.shifts();
            sizes.extend(std::iter::repeat_n(length, frame.shifts()));
            sizes.extend(std::iter::repeat_n(1.0, turns));
        }
        sizes
    }

    /// Largest length in a free frame: its bodies' lines, distances of its points from the origin.
    fn length_at(&self, free: usize) -> f64 {
        let frame = self.free[free].spec.frame;
        let bodies = self.bodies.iter().filter(|body| body.spec.frame == frame);
        let bodies = bodies.map(|body| body.spec.line.length());
        let points = self.markers.iter().map(|marker| match marker {
            Marker::Fixed {
                frame: other,
                at,
                is_point: true,
            } if *other == frame => norm(*at),
            _ => 0.0,
        });
        bodies.chain(points).fold(0.0, f64::max)
    }

    /// Body, node and local number (of the start node) of a nodal vector.
    pub(super) fn locate(&self, vector: usize) -> (&MeshBody, usize, usize) {
        let index = self.bodies.partition_point(|body| body.first_vector <= vector) - 1;
        let body = &self.bodies[index];
        let (node, local) = body.spec.locate(vector - body.first_vector);
        (body, node, local)
    }

    pub(super) fn assemble_mass(&mut self) {
        self.mass = vec![0.0; self.pattern.entries()];
        let in_modes = self.in_modes;
        for body in self.bodies.iter().filter(|body| !in_modes || body.modes.is_none()) {
            let local = spread_mass(&body.mass, &body.spec);
            for element in 0..body.spec.count {
                body.scatter.add(element, &local, &mut self.mass);
            }
        }
        for fixture in &self.fixtures {
            let body = &self.bodies[fixture.point.body];
            let local = spread_mass(&fixture.mass(), &body.spec);
            body.scatter.add(fixture.point.element, &local, &mut self.mass);
        }
    }

    /// Whether the elements of a body are left out at present.
    pub(super) fn is_left_to_modes(&self, body: &MeshBody) -> bool {
        self.in_modes && body.modes.is_some()
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
        place_on(&self.parts, &self.bodies[body].spec, body, at, user)
    }

    /// `sum_a weight_a q_a` at a point in one of the full arrays, frame axes.
    pub(super) fn at_point(&self, point: &MeshPoint, weights: &[f64], full: &[f64]) -> Vector {
        let body = &self.bodies[point.body];
        let components = body.connectivity.element(point.element);
        self.bodies[point.body].spread(weighted(full, components, body.spec.dimension(), weights))
    }
}

/// The place of a marker on a body.
pub(super) fn mesh_point<P: Parts>(
    parts: &P,
    bodies: &[BodySpec],
    body: usize,
    at: Place,
    user: &str,
) -> Result<MeshPoint, ModelError> {
    place_on(parts, &bodies[body], body, at, user)
}

/// Element and weights of a place on a body.
fn place_on<P: Parts>(parts: &P, spec: &BodySpec, body: usize, at: Place, user: &str) -> Result<MeshPoint, ModelError> {
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
    parts.shapes(body, xi, &mut point.values, &mut point.slopes);
    Ok(point)
}

/// Mass of an element's components from that of its vectors.
fn spread_mass(mass: &[f64], spec: &BodySpec) -> Vec<f64> {
    let (vectors, dimension) = (spec.orders.len(), spec.dimension());
    let size = vectors * dimension;
    let mut local = vec![0.0; size * size];
    for a in 0..vectors {
        for b in 0..vectors {
            for c in 0..dimension {
                local[(a * dimension + c) * size + b * dimension + c] = mass[a * vectors + b];
            }
        }
    }
    local
}

/// Numbers the unknowns that the joints leave, and those of free frames.
fn numbering(specs: &[BodySpec], conditions: &[Condition], border: usize) -> Layout {
    let dimensions = specs
        .iter()
        .flat_map(|spec| std::iter::repeat_n(spec.dimension(), spec.vectors()));
    let dimensions: Vec<usize> = dimensions.collect();
    let kinds = vector_kinds(dimensions.len(), conditions);
    Layout::new(&dimensions, kinds, border)
}

/// A joint may tie a body to its own free frame; everything else between free frames is a constraint.
fn check_joint<P: Parts>(parts: &P, joint: &JointSpec, body: &BodySpec, free: &[bool]) -> Result<(), ModelError> {
    if joint.frame == body.frame || !free[joint.frame] && !free[body.frame] {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "joint `{}` ties body `{}` to frame `{}`, and one of them moves freely: give it as a constraint",
        joint.name,
        body.name,
        parts.frame_name(joint.frame)
    )))
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
