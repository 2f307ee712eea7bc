//! Starts in relative equilibrium: the bodies of a frame rest in it while it turns uniformly about its origin,
//! without loads, `M^ab w x (w x q_b) + F_e = 0` (THEORY 8.1) on what joints and common nodes leave free.
//!
//! This makes `U - 1/2 M^ab (w x q_a) . (w x q_b)` stationary, and strings that do not carry yet have no stiffness
//! across themselves while turning takes some away: the tangent is indefinite at a straight, unstretched start. The
//! way is that of a flow towards the equilibrium in a viscous medium, `mu M dq/ds = -R`, by implicit steps that grow
//! as the potential falls as foreseen, until they are those of Newton.

use super::assembly::{Scatter, evaluate};
use super::build::numbering;
use super::conditions::{Condition, condition, directions, joint_data};
use super::evaluate::MAX_SIZE;
use super::frame::FrameMotion;
use super::free::Motions;
use super::layout::Layout;
use super::linked::Marker;
use super::markers::When;
use super::mean_axes::MeanAxes;
use super::parts::{BodySpec, Fidelity, JointSpec};
use super::repeated::StartSpec;
use super::scene::MeshScene;
use super::shared::Shared;
use crate::error::ModelError;
use crate::linalg::{Lu, Pattern};
use crate::model::Joints;
use crate::vector::{Matrix, Vector, add, cross, multiply, norm, skew, subtract};

/// Most iterations; strings that begin straight take some 20.
const ITERATIONS: usize = 300;
/// Increment of an unknown, relative to its size, beyond which a step is shortened.
const LONGEST: f64 = 0.3;
/// Root mean square of increments, relative to the unknowns' sizes, that ends the iteration.
const CONVERGED: f64 = 1e-14;
/// The same where increments stop falling: round-off of the forces.
const STAGNANT: f64 = 1e-9;
/// Largest drag, relative to w^2, at which increments tell the distance from the equilibrium.
const LIGHT: f64 = 1e-3;
/// Least drag, relative to w^2: what turns freely about the axis has no place of its own.
const LEAST: f64 = 1e-6;
/// Part of the foreseen decrease of the potential that a step must bring.
const ENOUGH: f64 = 1e-3;
/// Round-off of a potential, relative to its parts.
const NOISE: f64 = 1e-13;
/// Imbalance, relative to the largest force, that no equilibrium has.
const UNBALANCED: f64 = 1e-6;
/// Relative size of a component across the normal, or of a motion of a joint, that counts as round-off.
const NEGLIGIBLE: f64 = 1e-9;

impl MeshScene {
    /// Finds all declared starts, at the end of building.
    ///
    /// # Errors
    /// A start that cannot be, or was not found, by name.
    pub(super) fn settle(&mut self) -> Result<(), ModelError> {
        self.settled = vec![Vec::new(); self.bodies.len()];
        for start in self.parts.starts() {
            let spin = self.settling_spin(&start)?;
            self.check_settling(&start)?;
            let mut balance = Balance::new(self, &start, spin)?;
            let q = balance.find(&start)?;
            let bodies = balance.bodies;
            for index in bodies {
                let body = &self.bodies[index];
                let first = self.layout.offset(body.first_vector);
                let count = body.spec.vectors() * body.spec.dimension();
                self.settled[index] = q[first..first + count].to_vec();
            }
        }
        Ok(())
    }

    /// Angular velocity of a start, frame axes.
    fn settling_spin(&self, start: &StartSpec) -> Result<Vector, ModelError> {
        let spin = start.spin.unwrap_or_else(|| self.motions(0.0)[start.frame].spin);
        let name = self.parts.frame_name(start.frame);
        if !spin.iter().all(|value| value.is_finite()) {
            return Err(ModelError::new(format!(
                "start `{}`: the angular velocity of frame `{name}` is not finite",
                start.name
            )));
        }
        let planes = self.bodies.iter().filter(|body| body.spec.frame == start.frame);
        let planes = planes.filter_map(|body| match *body.spec.axes {
            [first, second] => Some(3 - first - second),
            _ => None,
        });
        let free = self.free.iter().chain(&self.fixed);
        let frames = free.filter(|frame| frame.spec.frame == start.frame);
        let frames = frames.filter_map(|frame| match frame.spec.motions {
            Motions::Planar { normal } | Motions::ShiftingPlanar { normal } => Some(normal),
            _ => None,
        });
        for normal in planes.chain(frames) {
            let mut across = spin;
            across[normal] = 0.0;
            if norm(across) > NEGLIGIBLE * norm(spin) {
                return Err(ModelError::new(format!(
                    "start `{}`: what moves in a plane of frame `{name}` turns about the plane's normal only: give an angular velocity along {}",
                    start.name,
                    ["x", "y", "z"][normal]
                )));
            }
        }
        Ok(spin)
    }

    /// Refuses what holds or drives the bodies of a start in another way than joints to their frame.
    fn check_settling(&self, start: &StartSpec) -> Result<(), ModelError> {
        let refuse = |what: String| Err(ModelError::new(format!("start `{}`: {what}", start.name)));
        let lives = |body: usize| self.bodies[body].spec.frame == start.frame;
        let frame = self.parts.frame_name(start.frame);
        for body in self.bodies.iter().filter(|body| body.spec.frame == start.frame) {
            if body.spec.fidelity != Fidelity::Full {
                return refuse(format!(
                    "body `{}` is described by modes, which have no initial shape: describe it by its nodal vectors",
                    body.spec.label()
                ));
            }
        }
        let bodies_of = |markers: &[usize]| {
            let mut bodies = markers.iter().filter_map(|&marker| match &self.markers[marker] {
                Marker::Body { point, .. } => Some(point.body),
                _ => None,
            });
            bodies.find(|&body| lives(body))
        };
        let constraints = self.constraints.iter();
        let constraints = constraints.filter(|linked| linked.spec.when == When::Always);
        let constraints = constraints.map(|linked| (linked.spec.name, linked.spec.markers));
        let forces = self.forces.iter().enumerate();
        let forces = forces.filter(|&(index, _)| !self.parts.is_load(index));
        let forces = forces.map(|(_, force)| (force.name, force.markers));
        for (name, markers) in constraints.chain(forces) {
            if let Some(body) = bodies_of(markers) {
                return refuse(format!(
                    "`{name}` acts on body `{}`, and the equilibrium knows only joints that hold its ends in frame `{frame}`: use such joints, or leave the start out",
                    self.bodies[body].spec.label()
                ));
            }
        }
        Ok(())
    }

    /// A joint as one to its body's frame.
    fn joint_at_rest(
        &self,
        start: &StartSpec,
        joint: &JointSpec,
        frames: &[FrameMotion],
    ) -> Result<JointSpec, ModelError> {
        let spec = &self.bodies[joint.body].spec;
        if joint.frame == spec.frame {
            return Ok(joint.clone());
        }
        let (own, other) = (&frames[spec.frame], &frames[joint.frame]);
        let data = joint_data(joint, spec, frames);
        let point = other.point_to_inertial(data.point);
        let spins = [own, other].map(|frame| frame.direction_to_inertial(frame.spin));
        let carried = |frame: &FrameMotion, spin| add(frame.velocity, cross(spin, subtract(point, frame.position)));
        let velocities = [carried(own, spins[0]), carried(other, spins[1])];
        let differs = |[a, b]: [Vector; 2]| norm(subtract(a, b)) > NEGLIGIBLE * norm(a).max(norm(b));
        if differs(velocities) || !directions(joint.kind, spec).is_empty() && differs(spins) {
            return Err(ModelError::new(format!(
                "start `{}`: joint `{}` ties body `{}` to frame `{}`, which moves relative to frame `{}`: nothing rests there",
                start.name,
                joint.name,
                spec.label(),
                self.parts.frame_name(joint.frame),
                self.parts.frame_name(spec.frame)
            )));
        }
        Ok(JointSpec {
            frame: spec.frame,
            point: Some(own.point_to_frame(point)),
            ..joint.clone()
        })
    }

    /// Shapes of all bodies, and what is unknown of them, in their declared frames, with all joints of the start's
    /// bodies eliminated.
    fn referenced(&self, start: &StartSpec) -> Result<(Vec<f64>, Layout), ModelError> {
        let frames = self.motions(0.0);
        let mut conditions: Vec<Condition> = Vec::new();
        for (index, joint) in self.joints.iter().enumerate() {
            let body = &self.bodies[joint.body];
            if body.spec.frame != start.frame {
                continue;
            }
            let own = self.joint_at_rest(start, joint, &frames)?;
            let data = joint_data(&own, &body.spec, &frames);
            let first = body.first_vector;
            conditions.push(condition(
                index,
                &own,
                &body.spec,
                first,
                data,
                false,
                Joints::Eliminated,
            ));
        }
        let specs: Vec<BodySpec> = self.bodies.iter().map(|body| body.spec.clone()).collect();
        let firsts: Vec<usize> = self.bodies.iter().map(|body| body.first_vector).collect();
        let shared = Shared::new(&*self.parts, &specs, &firsts)?;
        let layout = numbering(&specs, &conditions, &shared, 0);
        let [mut q, _] = self.initial_shape();
        let shape = self.shape();
        for condition in &conditions {
            let axes = self.bodies[self.joints[condition.joint].body].spec.axes;
            let mut set = |vector: usize, value: Vector| {
                let first = layout.offset(vector);
                for (place, &axis) in axes.iter().enumerate() {
                    q[first + place] = value[axis];
                }
            };
            if condition.position_eliminated {
                set(condition.vectors[0], condition.data.point);
            }
            if condition.prescribes_directions() {
                let values = [condition.data.tangent, condition.data.second[0]];
                for (&vector, value) in condition.vectors[1..].iter().zip(values) {
                    set(vector, value);
                }
            }
            if let Some((vector, component)) = condition.held {
                let place = layout.offset(vector) + component;
                q[place] = shape[place];
            }
        }
        Ok((q, layout))
    }
}

/// The mass matrix of some vectors: an element, or a fixture on one.
struct Inertia {
    body: usize,
    element: usize,
    mass: Vec<f64>,
}

/// The forces on the bodies of one frame.
struct Balance<'a> {
    scene: &'a MeshScene,
    bodies: Vec<usize>,
    layout: Layout,
    /// Components of all vectors, those that are not unknown at their values.
    q: Vec<f64>,
    /// `[w]^2`, and w^2.
    turning: Matrix,
    square: f64,
    inertias: Vec<Inertia>,
    scatters: Vec<Scatter>,
    mean_axes: Vec<MeanAxes>,
    /// Of unknowns, then multipliers of mean axes.
    pattern: Pattern,
    /// On the pattern: mass, centrifugal forces' derivatives, and what else is constant.
    mass: Vec<f64>,
    constant: Vec<f64>,
    inverse_sizes: Vec<f64>,
    results: Vec<f64>,
}

impl<'a> Balance<'a> {
    fn new(scene: &'a MeshScene, start: &StartSpec, spin: Vector) -> Result<Self, ModelError> {
        let (q, layout) = scene.referenced(start)?;
        let bodies: Vec<usize> = (0..scene.bodies.len())
            .filter(|&body| scene.bodies[body].spec.frame == start.frame)
            .collect();
        let mut inertias = Vec::new();
        for &body in &bodies {
            let mass = |element| Inertia {
                body,
                element,
                mass: scene.bodies[body].mass.clone(),
            };
            inertias.extend((0..scene.bodies[body].spec.count).map(mass));
        }
        let fixtures = scene
            .fixtures
            .iter()
            .filter(|fixture| bodies.contains(&fixture.point.body));
        inertias.extend(fixtures.map(|fixture| Inertia {
            body: fixture.point.body,
            element: fixture.point.element,
            mass: fixture.mass(),
        }));
        let mut balance = Self {
            mean_axes: mean_axes(scene, &bodies, &layout),
            turning: multiply(&skew(spin), &skew(spin)),
            square: spin.iter().map(|w| w * w).sum(),
            inverse_sizes: inverse_sizes(scene, &layout),
            pattern: Pattern::new(0, 0, []),
            scatters: Vec::new(),
            mass: Vec::new(),
            constant: Vec::new(),
            results: Vec::new(),
            scene,
            bodies,
            layout,
            q,
            inertias,
        };
        balance.tabulate();
        Ok(balance)
    }

    /// The pattern, and what is constant on it.
    fn tabulate(&mut self) {
        let (scene, layout) = (self.scene, &self.layout);
        let n = layout.unknowns();
        let rows = self
            .mean_axes
            .iter()
            .flat_map(|axes| axes.rows.iter().map(move |row| (axes.first, row)));
        let mut borders = Vec::new();
        for (column, (first, row)) in rows.enumerate() {
            for (place, &value) in row.iter().enumerate() {
                if let Some((unknown, factor)) = layout.unknown(first + place) {
                    borders.push((unknown, n + column, factor * value));
                }
            }
        }
        let size = n + self.mean_axes.iter().map(|axes| axes.rows.len()).sum::<usize>();
        let mut entries: Vec<(usize, usize)> = (0..size).map(|i| (i, i)).collect();
        for &body in &self.bodies {
            entries.extend(scene.bodies[body].connectivity.entries(layout));
        }
        entries.extend(
            borders
                .iter()
                .flat_map(|&(row, column, _)| [(row, column), (column, row)]),
        );
        self.pattern = Pattern::new(size, size, entries);
        let scatters = self.bodies.iter();
        let scatters = scatters.map(|&body| Scatter::new(&scene.bodies[body].connectivity, layout, &self.pattern));
        self.scatters = scatters.collect();
        self.mass = vec![0.0; self.pattern.entries()];
        self.constant = vec![0.0; self.pattern.entries()];
        for inertia in &self.inertias {
            let place = self.place(inertia.body);
            let one = |r: usize, c: usize| if r == c { 1.0 } else { 0.0 };
            self.scatters[place].add(inertia.element, &self.spread(inertia, one), &mut self.mass);
            let turned = self.spread(inertia, |r, c| self.turning[r][c]);
            self.scatters[place].add(inertia.element, &turned, &mut self.constant);
        }
        for (row, column, value) in borders {
            for (i, j) in [(row, column), (column, row)] {
                if let Some(place) = self.pattern.find(i, j) {
                    self.constant[place] += value;
                }
            }
        }
        // Unknowns of other frames stay.
        let mut own = vec![false; n];
        for &body in &self.bodies {
            for &component in &scene.bodies[body].connectivity.components {
                if let Some((unknown, _)) = layout.unknown(component) {
                    own[unknown] = true;
                }
            }
        }
        for unknown in (0..n).filter(|&unknown| !own[unknown]) {
            if let Some(place) = self.pattern.find(unknown, unknown) {
                self.constant[place] = 1.0;
            }
        }
    }

    /// Place of a body among those of the frame.
    fn place(&self, body: usize) -> usize {
        self.bodies.partition_point(|&other| other < body)
    }

    /// A mass matrix of vectors as one of components, `M_ab A` with a matrix of frame axes.
    fn spread(&self, inertia: &Inertia, matrix: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let spec = &self.scene.bodies[inertia.body].spec;
        let (count, dimension, size) = (spec.nodal.len(), spec.dimension(), spec.element_size());
        let mut local = vec![0.0; size * size];
        for (place, entry) in local.iter_mut().enumerate() {
            let (row, column) = (place / size, place % size);
            let mass = inertia.mass[row / dimension * count + column / dimension];
            *entry = mass * matrix(spec.axes[row % dimension], spec.axes[column % dimension]);
        }
        local
    }

    /// Unknowns of the shapes.
    fn unknowns(&self) -> Vec<f64> {
        let n = self.layout.unknowns();
        let (mut x, mut weight) = (vec![0.0; n], vec![0.0; n]);
        for (component, &value) in self.q.iter().enumerate() {
            if let Some((unknown, factor)) = self.layout.unknown(component) {
                x[unknown] += factor * value;
                weight[unknown] += factor * factor;
            }
        }
        x.iter_mut().zip(weight).for_each(|(x, weight)| *x /= weight);
        x
    }

    fn load(&mut self, x: &[f64]) {
        self.layout.expand(x, &mut self.q);
    }

    /// Components of an element of the frame.
    fn local(&self, body: usize, element: usize) -> [f64; MAX_SIZE] {
        let mut local = [0.0; MAX_SIZE];
        let body = &self.scene.bodies[body];
        body.connectivity
            .gather(element, &self.q, &mut local[..body.spec.element_size()]);
        local
    }

    /// Strain energy and kinetic energy of the rotation at the loaded state, J.
    fn energies(&self) -> [f64; 2] {
        let (scene, mut energies) = (self.scene, [0.0; 2]);
        for &body in &self.bodies {
            let size = scene.bodies[body].spec.element_size();
            for element in 0..scene.bodies[body].spec.count {
                let q = self.local(body, element);
                energies[0] += scene.parts.energy(body, element, &q[..size]);
            }
        }
        for inertia in &self.inertias {
            let q = self.local(inertia.body, inertia.element);
            let force = self.centrifugal(inertia, &q);
            energies[1] += -0.5 * force.iter().zip(&q).map(|(force, q)| force * q).sum::<f64>();
        }
        energies
    }

    /// `M^ab w x (w x q_b)`.
    fn centrifugal(&self, inertia: &Inertia, q: &[f64; MAX_SIZE]) -> [f64; MAX_SIZE] {
        let spec = &self.scene.bodies[inertia.body].spec;
        let (count, dimension) = (spec.nodal.len(), spec.dimension());
        let mut accelerations = [0.0; MAX_SIZE];
        for (row, value) in accelerations[..spec.element_size()].iter_mut().enumerate() {
            let vector = &q[row / dimension * dimension..];
            let turning = &self.turning[spec.axes[row % dimension]];
            *value = (0..dimension).map(|c| turning[spec.axes[c]] * vector[c]).sum();
        }
        let mut force = [0.0; MAX_SIZE];
        for (row, value) in force[..spec.element_size()].iter_mut().enumerate() {
            let masses = &inertia.mass[row / dimension * count..];
            let sum = (0..count).map(|b| masses[b] * accelerations[b * dimension + row % dimension]);
            *value = sum.sum();
        }
        force
    }

    /// Residual at the loaded state: forces on unknowns, then mean axes; also the largest energy of the inertia
    /// over the size of an unknown.
    fn residual(&mut self, out: &mut [f64]) -> f64 {
        let (scene, n) = (self.scene, self.layout.unknowns());
        let mut full = vec![0.0; self.q.len()];
        for inertia in &self.inertias {
            let q = self.local(inertia.body, inertia.element);
            let force = self.centrifugal(inertia, &q);
            let components = scene.bodies[inertia.body].connectivity.element(inertia.element);
            components
                .iter()
                .zip(force)
                .for_each(|(&component, force)| full[component] += force);
        }
        self.layout.project(&full, &mut out[..n]);
        let acting = self.largest(&out[..n]);
        let mut results = std::mem::take(&mut self.results);
        for &body in &self.bodies {
            let own = &scene.bodies[body];
            let size = own.spec.element_size();
            let rest = [0.0; MAX_SIZE];
            evaluate(own.spec.count, size, &mut results, |element, result| {
                let q = self.local(body, element);
                scene
                    .parts
                    .elastic_force(body, element, &q[..size], &rest[..size], result);
            });
            for (&component, value) in own.connectivity.components.iter().zip(&results) {
                full[component] += value;
            }
        }
        self.results = results;
        self.layout.project(&full, &mut out[..n]);
        let mut row = n;
        for axes in &self.mean_axes {
            for (coefficients, wanted) in axes.rows.iter().zip(&axes.undeformed) {
                let values = coefficients.iter().zip(&self.q[axes.first..]);
                out[row] = values.map(|(a, q)| a * q).sum::<f64>() - wanted;
                row += 1;
            }
        }
        acting
    }

    /// Derivatives of the residual at the loaded state.
    fn tangent(&mut self, values: &mut Vec<f64>) {
        values.clone_from(&self.constant);
        let scene = self.scene;
        let mut results = std::mem::take(&mut self.results);
        for (place, &body) in self.bodies.iter().enumerate() {
            let count = scene.bodies[body].spec.count;
            let size = scene.bodies[body].spec.element_size();
            let (square, rest) = (size * size, [0.0; MAX_SIZE]);
            evaluate(count, 2 * square, &mut results, |element, result| {
                let q = self.local(body, element);
                let (stiffness, damping) = result.split_at_mut(square);
                let parts = &scene.parts;
                parts.elastic_tangent(body, element, &q[..size], &rest[..size], stiffness, damping);
            });
            for element in 0..count {
                let from = element * 2 * square;
                self.scatters[place].add(element, &results[from..from + square], values);
            }
        }
        self.results = results;
    }

    /// Largest energy of forces over the sizes of their unknowns, J.
    fn largest(&self, forces: &[f64]) -> f64 {
        let energies = forces.iter().zip(&self.inverse_sizes);
        energies.fold(0.0, |largest: f64, (force, inverse)| {
            largest.max((force / inverse).abs())
        })
    }
}

/// Where the iteration is.
struct Point {
    x: Vec<f64>,
    residual: Vec<f64>,
    energies: [f64; 2],
    /// Largest energies of residual and inertia over the sizes of unknowns, J.
    imbalance: f64,
    acting: f64,
}

impl Point {
    fn potential(&self) -> f64 {
        self.energies[0] - self.energies[1]
    }

    fn noise(&self) -> f64 {
        NOISE * (self.energies[0].abs() + self.energies[1].abs())
    }
}

impl Balance<'_> {
    fn point(&mut self, x: Vec<f64>) -> Point {
        self.load(&x);
        let n = x.len();
        let mut residual = vec![0.0; self.pattern.columns()];
        let acting = self.residual(&mut residual);
        Point {
            energies: self.energies(),
            imbalance: self.largest(&residual[..n]),
            residual,
            acting,
            x,
        }
    }

    /// Components of all vectors in the equilibrium.
    fn find(&mut self, start: &StartSpec) -> Result<Vec<f64>, ModelError> {
        let n = self.layout.unknowns();
        let mut lu = Lu::<f64>::new(&self.pattern);
        let (mut tangent, mut matrix) = (Vec::new(), vec![0.0; self.pattern.entries()]);
        let x = self.unknowns();
        let mut at = self.point(x);
        self.tangent(&mut tangent);
        let unit = if self.square > 0.0 {
            self.square
        } else {
            self.softness(&tangent)
        };
        let (mut drag, mut last) = (4.0 * unit, f64::INFINITY);
        for _ in 0..ITERATIONS {
            let all = at.residual.iter().chain(&tangent).chain(&at.energies);
            if !all.copied().all(f64::is_finite) {
                break;
            }
            let mut increments: Vec<f64> = at.residual.iter().map(|value| -value).collect();
            for ((sum, mass), value) in matrix.iter_mut().zip(&self.mass).zip(&tangent) {
                *sum = value + drag * mass;
            }
            if lu.factor(&matrix).is_err() {
                drag = 4.0 * drag.max(LEAST * unit);
                continue;
            }
            lu.solve(&mut increments);
            let (change, new) = increments.split_at(n);
            let size = self.size(change);
            let is_done = drag <= LIGHT * unit && size <= CONVERGED;
            let is_stuck = drag <= LEAST * unit && size <= STAGNANT && size > 0.3 * last;
            if is_done || is_stuck {
                return self.accept(start, &at);
            }
            let trial = self.attempt(&at, change, new, &tangent);
            let Some((next, quality)) = trial else {
                drag *= 4.0;
                continue;
            };
            drag *= if quality > 0.5 {
                0.1
            } else if quality < 0.25 {
                2.0
            } else {
                1.0
            };
            drag = drag.max(LEAST * unit);
            last = size;
            at = next;
            self.load(&at.x);
            self.tangent(&mut tangent);
        }
        Err(self.lost(start, &at))
    }

    /// The point behind an increment and how well its decrease of the potential was foreseen; `None` where the
    /// increment is too long or the potential does not fall.
    fn attempt(&mut self, at: &Point, change: &[f64], multipliers: &[f64], tangent: &[f64]) -> Option<(Point, f64)> {
        let n = change.len();
        let longest = change.iter().zip(&self.inverse_sizes);
        let longest = longest.fold(0.0, |most: f64, (change, inverse)| most.max((change * inverse).abs()));
        // Negated so that what is not a number counts as too long.
        if !(longest <= LONGEST) {
            return None;
        }
        let slope: f64 = change
            .iter()
            .zip(&at.residual)
            .map(|(change, force)| change * force)
            .sum();
        let mut whole = change.to_vec();
        whole.resize(self.pattern.columns(), 0.0);
        let mut along = vec![0.0; whole.len()];
        self.pattern.multiply_add(1.0, tangent, &whole, &mut along);
        let curvature: f64 = change.iter().zip(&along).map(|(change, force)| change * force).sum();
        let foreseen = -(slope + 0.5 * curvature);
        let x = at.x.iter().zip(change).map(|(x, change)| x + change).collect();
        let mut next = self.point(x);
        if !multipliers.is_empty() {
            // Multipliers are found anew each time; the balance is that with them.
            let mut forces = next.residual[..n].to_vec();
            self.add_multipliers(multipliers, &mut forces);
            next.imbalance = self.largest(&forces);
        }
        let violated = at.residual[n..].iter().any(|value| value.abs() > NEGLIGIBLE);
        if violated {
            return Some((next, 1.0));
        }
        if foreseen.abs() <= at.noise() {
            return (next.imbalance <= 10.0 * at.imbalance.max(NEGLIGIBLE * at.acting)).then_some((next, 1.0));
        }
        let quality = (at.potential() - next.potential()) / foreseen;
        (foreseen > 0.0 && quality > ENOUGH).then_some((next, quality))
    }

    /// `C^T lambda` of mean axes.
    fn add_multipliers(&self, multipliers: &[f64], forces: &mut [f64]) {
        let mut column = 0;
        for axes in &self.mean_axes {
            for row in &axes.rows {
                for (place, value) in row.iter().enumerate() {
                    if let Some((unknown, factor)) = self.layout.unknown(axes.first + place) {
                        forces[unknown] += factor * value * multipliers[column];
                    }
                }
                column += 1;
            }
        }
    }

    /// A rate, 1/s^2, below those of the elastic forces.
    fn softness(&self, tangent: &[f64]) -> f64 {
        let trace = |values: &[f64]| -> f64 {
            let places = (0..self.layout.unknowns()).filter_map(|i| self.pattern.find(i, i));
            places.map(|place| values[place]).sum()
        };
        let rate = trace(tangent).abs() / trace(&self.mass);
        if rate.is_finite() && rate > 0.0 {
            1e-3 * rate
        } else {
            1.0
        }
    }

    /// Root mean square of increments relative to the sizes of the unknowns.
    fn size(&self, change: &[f64]) -> f64 {
        let parts = change.iter().zip(&self.inverse_sizes);
        let sum: f64 = parts.map(|(change, inverse)| (change * inverse).powi(2)).sum();
        (sum / change.len().max(1) as f64).sqrt()
    }

    fn accept(&mut self, start: &StartSpec, at: &Point) -> Result<Vec<f64>, ModelError> {
        if at.imbalance > UNBALANCED * at.acting {
            return Err(self.lost(start, at));
        }
        self.load(&at.x);
        Ok(self.q.clone())
    }

    /// Says how far the iteration came.
    fn lost(&self, start: &StartSpec, at: &Point) -> ModelError {
        let frame = self.scene.parts.frame_name(start.frame);
        let energy = |unknown: usize| (at.residual[unknown] / self.inverse_sizes[unknown]).abs();
        let worst = (0..at.x.len()).max_by(|&i, &j| energy(i).total_cmp(&energy(j)));
        let place = worst.map_or(String::new(), |unknown| {
            let (vector, _) = self.layout.origins()[unknown];
            let (body, node, local) = self.scene.locate(vector);
            let what = body.spec.nodal[local].meaning;
            format!(", most at the {what} of node {node} of body `{}`", body.spec.label())
        });
        let part = at.imbalance / at.acting;
        ModelError::new(format!(
            "start `{}`: no equilibrium of the bodies in frame `{frame}` with its rotation was found: what is not balanced is still {part:.1e} of the inertia{place}; give the bodies an initial shape nearer to it (`initial position`), hold what can fall over, or use more elements",
            start.name
        ))
    }
}

/// Mean axes of the bodies, in absolute coordinates, too.
fn mean_axes(scene: &MeshScene, bodies: &[usize], layout: &Layout) -> Vec<MeanAxes> {
    let shape = scene.shape();
    let own = bodies.iter().filter(|&&body| scene.bodies[body].spec.mean_axes);
    let axes = own.map(|&index| {
        let body = &scene.bodies[index];
        let first = layout.offset(body.first_vector);
        let count = body.spec.vectors() * body.spec.dimension();
        MeanAxes::new(index, body, first, &shape[first..first + count])
    });
    axes.collect()
}

/// One over the sizes of the unknowns: lengths of bodies, and 1.
fn inverse_sizes(scene: &MeshScene, layout: &Layout) -> Vec<f64> {
    let size = |&(vector, _): &(usize, usize)| {
        let (body, _, local) = scene.locate(vector);
        if body.spec.nodal[local].is_position() {
            1.0 / body.spec.line.length()
        } else {
            1.0
        }
    };
    layout.origins().iter().map(size).collect()
}
