//! Building a scene: checks, numbering, patterns, constant matrices.

use std::sync::OnceLock;

use super::mesh_scene::MeshScene;
use super::sound::{check_absolute, check_body, check_instances, check_joint, check_twists};
use crate::emitted::{BodySpec, ConstraintSpec, Fidelity, FrameMotion, FrameTie, Line, LoadKind, Parts, When};
use crate::error::ModelError;
use crate::linalg::Pattern;
use crate::model::{Formulation, Joints};
use crate::scene::bodies::fidelity::describe;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::bodies::nodal_mass::NodalMass;
use crate::scene::bodies::place::PlaceVector;
use crate::scene::frames::all::SceneFrames;
use crate::scene::frames::free_frames::{Frames, FreeFrame, declared_free};
use crate::scene::frames::lean::References;
use crate::scene::frames::ties::{self, ChordEnds, Tie, ends};
use crate::scene::numbering::assembly::{Connectivity, Scatter};
use crate::scene::numbering::conditions::{condition, joint_data, vector_kinds};
use crate::scene::numbering::layout::Layout;
use crate::scene::numbering::shared::{Shared, numbering};
use crate::scene::numbering::turned::TurnedColumns;
use crate::scene::pieces::batches::groups;
use crate::scene::pieces::buffers::Buffers;
use crate::scene::pieces::density::Densities;
use crate::scene::pieces::fixture::{Fixture, declare_normals};
use crate::scene::pieces::links::Links;
use crate::scene::pieces::marker::{Linked, MarkedLoad, Marker};
use crate::scene::pieces::push::Push;
use crate::scene::pieces::rows::Rows;
use crate::scene::pieces::tabulated::Tabulated;
use crate::scene::terms::kinds::{CONSTRAINTS, FORCES};
use crate::scene::terms::linked::markers;
use crate::scene::terms::moments::turned_by_moments;
use crate::space::{Vector, matrix};

/// Part of its length that an element has which stands for nothing.
const NOTHING: f64 = 1e-9;

impl MeshScene {
    /// Builds the scene: geometry, numbering, patterns; with bodies, by their names, described otherwise than they are
    /// declared.
    ///
    /// In absolute coordinates a frame that follows a body is no unknown: outputs find its pose from the body. Nor is one
    /// that nothing needs.
    ///
    /// # Errors
    /// A count, length, material or section that makes no sense, a frame whose parent or plane does
    /// not fit its motions, something that acts where it cannot, or a body that is not there or cannot be described so,
    /// by name.
    pub fn new(
        parts: Box<dyn Parts>,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Self, ModelError> {
        Self::described(parts, formulation, joints, |specs| describe(specs, fidelity))
    }

    /// As [`Scene::with_finer_meshes`](crate::model::Scene::with_finer_meshes).
    ///
    /// # Errors
    /// What elements of this length do not allow.
    pub(crate) fn with_finer_meshes(self, times: usize) -> Option<Result<Self, ModelError>> {
        let loaded = self.loaded_bodies();
        let mut finer: Vec<BodySpec> = self.bodies.into_iter().map(|body| body.spec).collect();
        let mut changes = false;
        for (body, spec) in finer.iter_mut().enumerate() {
            // Normals of sections are declared with the mesh.
            spec.normals.clear();
            changes |= spec.refine(times, loaded.contains(&body));
        }
        changes.then(|| {
            Self::described(self.parts, self.formulation, self.declared, |specs| {
                specs.clone_from_slice(&finer);
                Ok(())
            })
        })
    }

    fn described(
        mut parts: Box<dyn Parts>,
        formulation: Formulation,
        joints: Joints,
        describe: impl FnOnce(&mut [BodySpec]) -> Result<(), ModelError>,
    ) -> Result<Self, ModelError> {
        parts.check()?;
        let mut specs = parts.bodies();
        describe(&mut specs)?;
        check_instances(&*parts, &specs)?;
        specs.iter().try_for_each(check_body)?;
        check_twists(&*parts, &specs)?;
        declare_normals(&*parts, &mut specs)?;
        let specs = specs;
        let Frames {
            free,
            free_of,
            fixed,
            motions,
        } = Frames::new(&*parts, &specs, formulation)?;
        let declared_free: Vec<bool> = declared_free(&*parts);
        let joint_specs = parts.joints();
        let firsts = prepare(&mut *parts, &specs)?;
        let absolute = |body: &BodySpec| formulation == Formulation::Ancf || body.frame == 0;
        let mut conditions = Vec::new();
        for (index, joint) in joint_specs.iter().enumerate() {
            let body = &specs[joint.body];
            check_joint(&*parts, joint, body, &declared_free)?;
            // In absolute coordinates constraints on markers stand for a joint to the body's own free frame.
            if declared_free[body.frame] && absolute(body) {
                check_absolute(&*parts, joint, body)?;
                continue;
            }
            let (first, data) = (firsts[joint.body], joint_data(joint, body, &motions));
            // Modes are those of the body as its frame holds it.
            let joints = if body.fidelity == Fidelity::Full {
                joints
            } else {
                Joints::Eliminated
            };
            conditions.push(condition(index, joint, body, first, data, absolute(body), joints));
        }
        let border = free.iter().map(FreeFrame::count).sum();
        let shared = Shared::new(&*parts, &specs, &firsts)?;
        shared.check_held(&conditions, &joint_specs, &specs, &firsts)?;
        let vectors = specs.iter().map(BodySpec::vectors).sum();
        let mut kinds = vector_kinds(vectors, &conditions);
        let mut chords = Vec::new();
        for (index, spec) in specs.iter().enumerate().filter(|(_, spec)| spec.tie == FrameTie::Chord) {
            let ends = ChordEnds::new(&*parts, index, spec, firsts[index])?;
            let is_node = joints == Joints::Eliminated && !absolute(spec);
            chords.push((
                index,
                ends.eliminate(&mut kinds, |vector| is_node && !shared.is_shared(vector)),
            ));
        }
        let layout = numbering(&specs, kinds, &shared, border);
        let bodies = specs.iter().zip(&firsts).map(|(spec, &first)| MeshBody {
            first_vector: first,
            frame: if absolute(spec) { 0 } else { spec.frame },
            offset: plane_offset(spec, absolute(spec), &motions[spec.frame]),
            connectivity: connectivity(spec, first, &layout),
            scatter: Scatter::default(),
            mass: Vec::new(),
            whole_mass: NodalMass::default(),
            fixed_mass: NodalMass::default(),
            section: OnceLock::new(),
            modes: None,
            spec: spec.clone(),
        });
        let bodies = bodies.collect();
        let first_turn = layout.unknowns() - border;
        let turns = free.iter().filter(|frame| frame.turn.is_some());
        let turns = turns.map(|frame| first_turn + frame.first + frame.shifts()).collect();
        let states = free.iter().filter(|frame| frame.is_state());
        let states = states.map(|frame| first_turn + frame.first).collect();
        let markers = markers(&*parts, &specs, &free_of)?;
        let constraints = linked(&*parts, &specs, absolute, &fixed);
        let frames = SceneFrames {
            free,
            free_of,
            fixed,
            turns,
            states,
            ..SceneFrames::default()
        };
        let links = Links {
            markers,
            constraints,
            forces: parts.forces().into_iter().enumerate().map(Push::from).collect(),
            ..Links::default()
        };
        let mut scene = Self {
            formulation,
            declared: joints,
            bodies,
            frames,
            joints: joint_specs,
            conditions,
            links,
            dead_loads: parts.loads().into(),
            distributed: Densities::default(),
            fixtures: Vec::new(),
            rigid_sections: Vec::new(),
            observed: parts.observed().into(),
            settled: Vec::new(),
            remarks: Vec::new(),
            missed: OnceLock::new(),
            in_modes: false,
            buffers: Buffers::new(layout.components(), motions),
            layout,
            tabulated: Tabulated::default(),
            parts,
        };
        scene.remarks = scene.check_initial()?;
        scene.remarks.extend(scene.thick_sections());
        scene.remarks.extend(scene.spread_alike());
        scene.remarks.extend(scene.coarse_meshes());
        scene.check_shared(&shared)?;
        scene.place()?;
        scene.find_rigid_sections();
        scene.tabulate(&chords)?;
        scene.settle()?;
        scene.load_rest();
        scene.resolve_markers()?;
        scene.refer_rigid_sections();
        (scene.tabulated.sizes, scene.tabulated.distance) = scene.unknown_sizes();
        scene.measure_distance();
        scene.follow_far_starts();
        scene.find_anchors();
        Ok(scene)
    }

    /// Finds the places of loads, fixtures and outputs.
    fn place(&mut self) -> Result<(), ModelError> {
        self.dead_loads.points = self
            .dead_loads
            .specs
            .iter()
            .map(|load| self.load_point(load))
            .collect::<Result<_, _>>()?;
        let observed = self.observed.specs.iter().map(|observed| self.observed_point(observed));
        self.observed.points = observed.collect::<Result<_, _>>()?;
        for (index, load) in self.dead_loads.specs.iter().enumerate() {
            let turned = self.frames.free_of[load.frame].is_some();
            match (load.kind, &self.dead_loads.points[index]) {
                (LoadKind::Gravity, _) if turned => {
                    return Err(ModelError::new(format!(
                        "gravity `{}` is along the axes of frame `{}`, which is free: give it in the inertial frame",
                        load.name,
                        self.parts.frame_name(load.frame)
                    )));
                }
                (kind, Some(point)) if turned || self.frames.free_of[self.bodies[point.body].frame].is_some() => {
                    let vectors = match kind {
                        LoadKind::Moment { .. } => turned_by_moments(&self.bodies[point.body].spec),
                        _ => &[PlaceVector::Position],
                    };
                    let marker = |&of: &PlaceVector| Marker::Body {
                        point: point.clone(),
                        of,
                    };
                    self.links.marked_loads.push(MarkedLoad {
                        load: index,
                        markers: vectors.iter().map(marker).collect(),
                    });
                }
                _ => {}
            }
        }
        for spec in self.parts.fixtures() {
            let (point, spec_body) = (self.point(spec.body, spec.at, spec.name)?, spec.body);
            let fixture = Fixture::new(spec, point, &self.bodies[spec_body].spec);
            self.fixtures.push(fixture);
        }
        self.place_densities()?;
        self.place_points()?;
        self.check_fields()?;
        self.check_fixed()
    }

    /// Refuses constraints and forces on frames that stay at their start.
    fn check_fixed(&self) -> Result<(), ModelError> {
        let users = self
            .links
            .constraints
            .iter()
            .map(|linked| (linked.spec.name, linked.spec.markers));
        let users = users.chain(self.links.forces.iter().map(|force| (force.name, &force.markers[..])));
        for (name, markers) in users {
            for &marker in markers {
                let frame = self.marker_frame(&self.links.markers[marker]);
                if self.frames.fixed.iter().any(|fixed| fixed.spec.frame == frame) {
                    let frame = self.parts.frame_name(frame);
                    return Err(ModelError::new(format!(
                        "`{name}` acts on frame `{frame}`, which follows a body and has no unknown pose in absolute coordinates: use the referenced formulation, or let `{name}` act on the body"
                    )));
                }
            }
        }
        Ok(())
    }

    /// Patterns, places on them, and constant matrices.
    fn tabulate(&mut self, chords: &[(usize, [bool; 2])]) -> Result<(), ModelError> {
        self.tabulated.pattern = Pattern::new(self.layout.unknowns(), self.layout.unknowns(), self.entries());
        for index in 0..self.bodies.len() {
            let body = &mut self.bodies[index];
            body.scatter = Scatter::new(&body.connectivity, &self.layout, &self.tabulated.pattern);
            let (size, several) = (body.spec.nodal.len().pow(2), self.parts.varies(index));
            body.mass = vec![0.0; size * if several { body.spec.count } else { 1 }];
            for (element, mass) in body.mass.chunks_exact_mut(size).enumerate() {
                self.parts.mass(index, element, mass);
            }
            let [whole, fixed] = self.nodal_masses(index);
            (self.bodies[index].whole_mass, self.bodies[index].fixed_mass) = (whole, fixed);
        }
        self.tabulate_densities();
        self.tabulated.groups = groups(&self.bodies);
        self.frames.turned = self
            .frames
            .turns
            .iter()
            .map(|&turn| TurnedColumns::new(turn, &self.tabulated.pattern))
            .collect();
        self.tabulated.borders = (0..self.bodies.len()).map(|body| self.border_of(body)).collect();
        self.set_held(chords);
        self.find_ties(chords)?;
        self.number_constraints();
        self.assemble_mass();
        Ok(())
    }

    /// Entries of the pattern: the diagonal, and what forces and constraints couple.
    fn entries(&self) -> Vec<(usize, usize)> {
        let mut entries: Vec<(usize, usize)> = (0..self.layout.unknowns()).map(|unknown| (unknown, unknown)).collect();
        FORCES.iter().for_each(|force| force.couple(self, &mut entries));
        CONSTRAINTS
            .iter()
            .for_each(|constraint| constraint.couple(self, &mut entries));
        entries
    }

    /// Held components keep the values that are set here: those of joints the undeformed ones, those of chords that they
    /// start with.
    fn set_held(&mut self, chords: &[(usize, [bool; 2])]) {
        let shape = self.shape();
        self.buffers.q[..shape.len()].copy_from_slice(&shape);
        let [initial, _] = self.initial_shape();
        for &(index, _) in chords {
            let body = &self.bodies[index];
            for vector in ends(&body.spec) {
                let first = self.layout.offset(body.first_vector + vector);
                let own = first..first + body.spec.dimension();
                self.buffers.q[own.clone()].copy_from_slice(&initial[own]);
            }
        }
    }

    /// Free frames follow bodies as they start.
    fn find_ties(&mut self, chords: &[(usize, [bool; 2])]) -> Result<(), ModelError> {
        let [initial, rates] = self.initial_shape();
        for (index, body) in self.bodies.iter().enumerate() {
            if body.spec.tie == FrameTie::Joints {
                continue;
            }
            if let Some(free) = self.frames.free_of[body.frame] {
                let eliminated = chords.iter().find(|(chord, _)| *chord == index);
                let eliminated = eliminated.map_or([false; 2], |&(_, ends)| ends);
                let frame = self.parts.frame_name(body.frame);
                let tie = Tie::new(index, body, &self.layout, &initial, eliminated, frame)?;
                self.frames.ties.push(tie);
                let whole = Tie::new(index, body, &self.layout, &initial, [false; 2], frame)?;
                if let Some([velocity, spin]) = ties::taken(&whole, body, &initial, &rates) {
                    let start = &mut self.frames.free[free].start;
                    let moved = matrix(&start.rotation) * velocity;
                    (start.velocity, start.spin) = (start.velocity + moved, start.spin + spin);
                    self.frames.taken.push((body.frame, [velocity, spin]));
                }
            } else if self
                .frames
                .fixed
                .iter()
                .any(|frame| frame.spec.frame == body.spec.frame)
            {
                let frame = self.parts.frame_name(body.spec.frame);
                let tie = Tie::new(index, body, &self.layout, &initial, [false; 2], frame)?;
                self.frames.followed.push(tie);
            }
        }
        self.frames.followed_shape = initial;
        Ok(())
    }

    fn number_constraints(&mut self) {
        for condition in &mut self.conditions {
            let dimension = self.bodies[self.joints[condition.joint].body].spec.dimension();
            let layout = &self.layout;
            let of = |vector: usize| (0..dimension).map(move |component| layout.offset(vector) + component);
            condition.components = condition.vectors.iter().flat_map(|&vector| of(vector)).collect();
        }
        let rows = CONSTRAINTS.map(|constraint| constraint.rows(self));
        self.tabulated.rows = Rows::new(std::array::from_fn(|kind| rows[kind].len()));
        let columns = rows.into_iter().flatten().enumerate();
        let entries = columns.flat_map(|(column, row)| row.into_iter().map(move |unknown| (unknown, column)));
        self.tabulated.constraint_pattern = Pattern::new(self.layout.unknowns(), self.tabulated.rows.count(), entries);
    }

    pub(crate) fn assemble_mass(&mut self) {
        self.tabulated.mass = vec![0.0; self.tabulated.pattern.entries()];
        for body in self
            .bodies
            .iter()
            .filter(|body| !(self.in_modes && body.modes.is_some()))
        {
            let mut local = spread_mass(body.mass_of(0), &body.spec);
            for element in 0..body.spec.count {
                if !body.is_even() {
                    local = spread_mass(body.mass_of(element), &body.spec);
                }
                body.scatter.add(element, &local, &mut self.tabulated.mass);
            }
        }
        for fixture in &self.fixtures {
            let body = &self.bodies[fixture.point.body];
            let local = spread_mass(fixture.mass(), &body.spec);
            body.scatter
                .add(fixture.point.element, &local, &mut self.tabulated.mass);
        }
        for (body, [row, column], value) in self.masses_of_normals() {
            for component in 0..self.bodies[body].spec.dimension() {
                let entries: Vec<_> = self.entries_of(row + component, column + component).collect();
                entries
                    .into_iter()
                    .for_each(|(entry, factor)| self.tabulated.mass[entry] += factor * value);
            }
        }
    }
}

/// Prepares the elements of all bodies; the first nodal vector of each.
fn prepare(parts: &mut dyn Parts, specs: &[BodySpec]) -> Result<Vec<usize>, ModelError> {
    let mut next = 0;
    let mut firsts = Vec::new();
    for (index, spec) in specs.iter().enumerate() {
        let nodes: Vec<f64> = (0..=spec.count)
            .map(|node| spec.arclength(node.min(spec.count - 1), f64::from(u8::from(node == spec.count))))
            // Between nodes of a body from elsewhere there is nothing: pictures draw straight lines.
            .map(|x| {
                if matches!(spec.line, Line::Nodes(_)) {
                    NOTHING * x
                } else {
                    x
                }
            })
            .collect();
        parts.prepare(index, &nodes, &element_shapes(spec))?;
        firsts.push(next);
        next += spec.vectors();
    }
    Ok(firsts)
}

/// Planar bodies have no component along the normal: in absolute coordinates it is that of their frame.
fn plane_offset(spec: &BodySpec, absolute: bool, frame: &FrameMotion) -> Vector {
    let mut offset = Vector::zeros();
    if let ([first, second], true) = (spec.axes, absolute) {
        let normal = 3 - first - second;
        offset[normal] = frame.position[normal];
    }
    offset
}

/// The constraints on markers that are there.
fn linked(
    parts: &dyn Parts,
    specs: &[BodySpec],
    absolute: impl Fn(&BodySpec) -> bool,
    fixed: &[FreeFrame],
) -> Vec<Linked> {
    let references = (!fixed.is_empty()).then(|| References::new(parts, specs));
    // Of frames that follow bodies they are refused.
    let follows = |frame: usize| {
        specs
            .iter()
            .any(|spec| spec.frame == frame && spec.tie != FrameTie::Joints)
    };
    let is_left_out = |spec: &ConstraintSpec| {
        let mut frames = fixed
            .iter()
            .map(|frame| frame.spec.frame)
            .filter(|&frame| !follows(frame));
        frames.any(|frame| {
            references
                .as_ref()
                .is_some_and(|references| references.touches(spec, frame))
        })
    };
    let constraints = parts.constraints().into_iter().enumerate();
    let constraints = constraints.filter(|(_, spec)| !is_left_out(spec));
    let there = constraints.filter(|(_, spec)| match spec.when {
        When::Always => true,
        When::Absolute(body) => absolute(&specs[body]),
    });
    let linked = |(index, spec)| Linked {
        index,
        spec,
        anchor: None,
    };
    there.map(linked).collect()
}

/// Mass of an element's components from that of its vectors.
fn spread_mass(mass: &[f64], spec: &BodySpec) -> Vec<f64> {
    let (vectors, dimension) = (spec.nodal.len(), spec.dimension());
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

/// Nodal vectors of all elements in the stress-free shape, in local order and body axes.
fn element_shapes(spec: &BodySpec) -> Vec<f64> {
    let mut shapes = Vec::with_capacity(spec.count * spec.element_size());
    for element in 0..spec.count {
        for local in 0..spec.nodal.len() {
            shapes.extend(spec.undeformed(element, local));
        }
    }
    shapes
}

fn connectivity(spec: &BodySpec, first_vector: usize, layout: &Layout) -> Connectivity {
    let mut components = Vec::with_capacity(spec.count * spec.element_size());
    for element in 0..spec.count {
        for &place in spec.connectivity {
            let offset = layout.offset(first_vector + element * spec.stride + place);
            components.extend(offset..offset + spec.dimension());
        }
    }
    Connectivity {
        size: spec.element_size(),
        components,
    }
}
