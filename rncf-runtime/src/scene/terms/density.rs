//! Loads per length of bodies (THEORY 5.1, Eq. 38): generalised forces `Q^a = int s^a f dx` on nodal vectors,
//! `F = A sum c_a Q^a` and `M = sum q_a x Q^a` on a free frame, and their derivatives (THEORY 2.1, column dq and
//! the rows with Q).

use super::density_sums::{Axes, Total};
use super::force::{At, Force};
use crate::emitted::{DensitySpec, Fidelity, LANES, MAX_SIZE};
use crate::error::ModelError;
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::units::Units;
use crate::scene::pieces::batches::in_order;
use crate::scene::pieces::combined::Combined;
use crate::scene::pieces::density::{Batches, Density, ROWS};
use crate::space::{Matrix, Vector, three};
use crate::system::{Sums, Tangent};

/// Unknowns that are dealt with at a time; a frame has fewer.
const TOGETHER: usize = 8;
/// Marks an entry that belongs to no unknown.
const NOWHERE: u32 = u32::MAX;

/// Loads per length that the elements' kernels integrate.
pub(crate) struct Densities;

impl Force for Densities {
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        scene.couple_densities(entries);
    }

    fn add(&self, scene: &mut MeshScene, at: &At) {
        scene.add_density_forces(at.t, at.load_scale);
    }

    fn add_tangent(&self, scene: &mut MeshScene, at: &At, out: &mut Tangent) {
        scene.add_density_tangents(at.t, at.load_scale, out);
    }

    fn add_combined(&self, scene: &mut MeshScene, at: &At, out: &mut Combined) {
        scene.add_density_tangents(at.t, at.load_scale, out);
    }
}

impl MeshScene {
    /// Finds what densities act on.
    ///
    /// # Errors
    /// A body that is not described by all its nodal vectors, or whose pose is not known in absolute coordinates,
    /// by name.
    pub(crate) fn place_densities(&mut self) -> Result<(), ModelError> {
        for spec in self.parts.densities() {
            let Some(body) = self.bodies.get(spec.body) else {
                return Err(ModelError::new(format!(
                    "load `{}` is on a repetition of its body that there is none of",
                    spec.name
                )));
            };
            let (name, label) = (spec.name, body.spec.label());
            if body.spec.fidelity != Fidelity::Full {
                return Err(ModelError::new(format!(
                    "load `{name}` is a density on body `{label}`, which is described by modes: leave out its `modal`, `small` or `rigid`"
                )));
            }
            let frame = body.spec.frame;
            if body.frame != frame && self.is_free_or_fixed(frame) {
                return Err(ModelError::new(format!(
                    "load `{name}` has the axes of frame `{}`, which moves freely and has no axes in absolute coordinates: use the referenced formulation",
                    self.parts.frame_name(frame)
                )));
            }
            for &marker in spec.markers {
                let frame = self.marker_frame(&self.links.markers[marker]);
                if self.frames.fixed.iter().any(|fixed| fixed.spec.frame == frame) {
                    return Err(ModelError::new(format!(
                        "load `{name}` depends on frame `{}`, which follows mean axes and has no pose in absolute coordinates: use the referenced formulation",
                        self.parts.frame_name(frame)
                    )));
                }
            }
            let mut components = body.connectivity.components.clone();
            components.sort_unstable();
            components.dedup();
            let places = body.connectivity.components.iter();
            let places = places.map(|component| components.partition_point(|other| other < component));
            self.distributed.all.push(Density {
                places: places.collect(),
                components,
                factors: Vec::new(),
                doubled: Vec::new(),
                outer: Vec::new(),
                driving: 0,
                upper: Vec::new(),
                lower: Vec::new(),
                square: Vec::new(),
                spec,
            });
        }
        for index in 0..self.distributed.all.len() {
            let outer = self.outer_unknowns(&self.distributed.all[index].spec);
            (self.distributed.all[index].outer, self.distributed.all[index].driving) = outer;
        }
        self.distributed.batches = self.batches();
        Ok(())
    }

    fn is_free_or_fixed(&self, frame: usize) -> bool {
        self.frames.free_of[frame].is_some() || self.frames.fixed.iter().any(|fixed| fixed.spec.frame == frame)
    }

    /// Unknowns that the values depend on, then the others of the body's frame; and the number of the first.
    fn outer_unknowns(&self, spec: &DensitySpec) -> (Vec<usize>, usize) {
        let markers: &[usize] = if spec.values > 0 { spec.markers } else { &[] };
        let components = markers
            .iter()
            .flat_map(|&marker| self.marker_components(&self.links.markers[marker]));
        let unknowns = components.flat_map(|component| self.layout.unknowns_at(component));
        let mut outer: Vec<usize> = unknowns.map(|(unknown, _)| unknown).collect();
        outer.sort_unstable();
        outer.dedup();
        let driving = outer.len();
        for unknown in self.frame_unknowns(spec.body) {
            if !outer[..driving].contains(&unknown) {
                outer.push(unknown);
            }
        }
        (outer, driving)
    }

    /// Unknowns of the free frame that a body's vectors live in.
    fn frame_unknowns(&self, body: usize) -> std::ops::Range<usize> {
        match self.frames.free_of[self.bodies[body].frame] {
            Some(free) => {
                let first = self.layout.unknowns() - self.layout.border() + self.frames.free[free].first;
                first..first + self.frames.free[free].count()
            }
            None => 0..0,
        }
    }

    fn batches(&self) -> Vec<Batches> {
        let mut kinds: Vec<usize> = self.distributed.all.iter().map(|density| density.spec.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        let mut all = Vec::new();
        for kind in kinds {
            let of_kind = |index: &usize| self.distributed.all[*index].spec.kind == kind;
            let densities = (0..self.distributed.all.len()).filter(of_kind);
            let elements: Vec<(usize, usize)> = densities
                .flat_map(|index| {
                    let body = &self.bodies[self.distributed.all[index].spec.body];
                    (0..body.spec.count).map(move |element| (index, element))
                })
                .collect();
            let Some(&(first, _)) = elements.first() else {
                continue;
            };
            let spec = &self.distributed.all[first].spec;
            let size = self.bodies[spec.body].spec.element_size();
            let components = |(density, element): (usize, usize)| {
                let body: usize = self.distributed.all[density].spec.body;
                self.bodies[body].connectivity.element(element)
            };
            all.push(Batches {
                values: spec.values,
                units: Units::new(&elements, size, components),
            });
        }
        all
    }

    fn couple_densities(&self, entries: &mut Vec<(usize, usize)>) {
        for density in &self.distributed.all {
            let components = density.components.iter();
            let own = components.flat_map(|&component| self.layout.unknowns_at(component));
            let rows = own
                .map(|(unknown, _)| unknown)
                .chain(self.frame_unknowns(density.spec.body));
            for row in rows {
                entries.extend(density.outer.iter().flat_map(|&outer| [(row, outer), (outer, row)]));
            }
        }
    }

    /// Looks up all places on the pattern.
    pub(crate) fn tabulate_densities(&mut self) {
        let mut densities = std::mem::take(&mut self.distributed.all);
        densities.iter_mut().for_each(|density| self.tabulate_density(density));
        self.distributed.all = densities;
    }

    fn tabulate_density(&self, density: &mut Density) {
        let frame = self.frame_unknowns(density.spec.body);
        let driving = &density.outer[..density.driving];
        let find = |i: usize, j: usize| self.tabulated.pattern.find(i, j).map_or(NOWHERE, |entry| entry as u32);
        let (mut factors, mut upper, mut lower) = (Vec::new(), Vec::new(), Vec::new());
        let (dependences, doubled) = self.layout.dependences(density.components.iter().copied());
        for own in dependences {
            factors.push(own.map_or(0.0, |(_, factor)| factor));
            upper.extend(
                driving
                    .iter()
                    .map(|&outer| own.map_or(NOWHERE, |(row, _)| find(row, outer))),
            );
            // The rows of a frame stand together at the end of a column.
            lower.push(own.map_or(NOWHERE, |(column, _)| find(frame.start, column)));
        }
        let square = frame.flat_map(|row| {
            density
                .outer
                .iter()
                .map(move |&outer| self.tabulated.pattern.find(row, outer))
        });
        density.square = square.collect();
        (density.factors, density.upper, density.lower) = (factors, upper, lower);
        density.doubled = doubled;
    }

    /// Values and velocities of the markers of a density at the loaded state.
    fn density_arguments(&self, spec: &DensitySpec) -> [Vec<Vector>; 2] {
        let jets = spec.markers.iter().map(|&marker| self.jet(&self.links.markers[marker]));
        let (z, velocity) = jets.map(|jet| (jet[0], jet[1])).unzip();
        [z, velocity]
    }

    /// Values of a density at the loaded state.
    pub(crate) fn density_values(&self, index: usize, t: f64) -> Vec<f64> {
        let spec = &self.distributed.all[index].spec;
        let [z, velocity] = self.density_arguments(spec);
        let mut values = vec![0.0; spec.values];
        self.parts.density_values(index, t, &z, &velocity, &mut values);
        values
    }

    /// How the markers of a density depend on its unknowns: marker, place among the unknowns, change of the marker.
    fn driving(&self, density: &Density) -> Vec<(usize, usize, Vector)> {
        let mut changes = Vec::new();
        let driving = &density.outer[..density.driving];
        for (place, &marker) in density.spec.markers.iter().enumerate() {
            for column in self.columns(&self.links.markers[marker]) {
                for (unknown, factor) in self.layout.unknowns_at(column.component) {
                    if let Ok(at) = driving.binary_search(&unknown) {
                        changes.push((place, at, factor * column.value));
                    }
                }
            }
        }
        changes
    }

    /// Their derivatives by the unknowns that they depend on: values x unknowns, rows first.
    fn driven(&self, index: usize, t: f64, shared: &mut Shared) {
        let spec = &self.distributed.all[index].spec;
        let width = self.distributed.all[index].driving;
        shared.by_unknowns.clear();
        shared.by_unknowns.resize(spec.values * width, 0.0);
        if shared.by_unknowns.is_empty() {
            return;
        }
        if shared.markers != Some(spec.markers) {
            shared.markers = Some(spec.markers);
            shared.arguments = self.density_arguments(spec);
            shared.changes = self.driving(&self.distributed.all[index]);
        }
        let [z, velocity] = &shared.arguments;
        let gradient = &mut shared.gradient;
        gradient.clear();
        gradient.resize(spec.values * 3 * z.len(), 0.0);
        self.parts.density_values_gradient(index, t, z, velocity, gradient);
        for &(place, at, change) in &shared.changes {
            for value in 0..spec.values {
                let row = &gradient[(value * z.len() + place) * 3..][..3];
                shared.by_unknowns[value * width + at] += three(row, 0).dot(&change);
            }
        }
    }

    /// Nodal vectors of an element in the axes of its body's frame.
    pub(crate) fn in_body_axes(&self, body: &MeshBody, element: usize) -> [f64; MAX_SIZE] {
        let mut q = [0.0; MAX_SIZE];
        let size = body.spec.element_size();
        body.connectivity.gather(element, &self.buffers.q, &mut q[..size]);
        if let Some(turn) = self.axes_of(body) {
            let origin = self.buffers.frames[body.spec.frame].position;
            let vectors = q[..size].chunks_exact_mut(turn.d);
            for (vector, nodal) in vectors.zip(body.spec.nodal) {
                if nodal.is_position() {
                    let own = vector.iter_mut().zip(body.spec.axes);
                    own.for_each(|(value, &axis)| *value -= origin[axis]);
                }
                turn.vector(vector, true);
            }
        }
        q
    }

    /// Axes of a prescribed frame in absolute coordinates, where they differ from those of the nodal vectors.
    pub(crate) fn axes_of(&self, body: &MeshBody) -> Option<Axes> {
        let (axes, frame) = (body.spec.axes, &self.buffers.frames[body.spec.frame]);
        let entry = |i: usize, j: usize| match (axes.get(i), axes.get(j)) {
            (Some(&i), Some(&j)) => frame.rotation[(i, j)],
            _ => 0.0,
        };
        (body.frame != body.spec.frame).then(|| Axes {
            d: axes.len(),
            rotation: Matrix::from_fn(entry),
        })
    }

    /// Values of all densities at the loaded state.
    pub(crate) fn all_values(&self, t: f64) -> Vec<Vec<f64>> {
        let (mut of, mut arguments) = (None, [Vec::new(), Vec::new()]);
        let values = self.distributed.all.iter().enumerate().map(|(index, density)| {
            let spec = &density.spec;
            if of != Some(spec.markers) {
                of = Some(spec.markers);
                arguments = self.density_arguments(spec);
            }
            let mut values = vec![0.0; spec.values];
            let [z, velocity] = &arguments;
            self.parts.density_values(index, t, z, velocity, &mut values);
            values
        });
        values.collect()
    }

    /// Adds the densities at the loaded state (to the left side, where they are negative) to the forces of nodal
    /// vectors and free frames.
    fn add_density_forces(&mut self, t: f64, load_scale: f64) {
        if self.distributed.all.is_empty() {
            return;
        }
        let values = self.all_values(t);
        let mut on_frames = vec![[Vector::zeros(); 2]; self.frames.free.len()];
        let mut results = std::mem::take(&mut self.buffers.lanes);
        let mut forces = std::mem::take(&mut self.buffers.force);
        let scene = &*self;
        for of in &scene.distributed.batches {
            let evaluate = |unit: usize, result: &mut [[f64; LANES]]| scene.evaluate_density(of, unit, &values, result);
            let add_unit = |unit: usize, result: &[[f64; LANES]]| {
                let (result, used) = (of.evaluated(result), of.units.used(unit));
                let body = |density: usize| &scene.bodies[scene.distributed.all[density].spec.body];
                let mut turns = false;
                for (lane, &(density, _)) in used.iter().enumerate() {
                    let body = body(density);
                    turns |= scene.axes_of(body).is_some();
                    if let Some(free) = scene.frames.free_of[body.frame] {
                        for (i, rows) in on_frames[free].iter_mut().enumerate() {
                            *rows = Vector::from_fn(|j, _| rows[j] + load_scale * result.rows[3 * i + j][lane]);
                        }
                    }
                }
                if !turns {
                    let lanes = 0..used.len();
                    return of.units.add(unit, lanes, -load_scale, result.force, &mut forces);
                }
                for (lane, &(density, element)) in used.iter().enumerate() {
                    let body = body(density);
                    let Some(axes) = scene.axes_of(body) else {
                        of.units
                            .add(unit, lane..lane + 1, -load_scale, result.force, &mut forces);
                        continue;
                    };
                    let mut force: [f64; MAX_SIZE] =
                        std::array::from_fn(|i| result.force.get(i).map_or(0.0, |force| force[lane]));
                    let vectors = force[..of.units.size].chunks_exact_mut(axes.d);
                    vectors.for_each(|vector| axes.vector(vector, false));
                    for (&component, value) in body.connectivity.element(element).iter().zip(force) {
                        forces[component] -= load_scale * value;
                    }
                }
            };
            in_order(of.units.count(), of.width(false), &mut results, evaluate, add_unit);
        }
        (self.buffers.lanes, self.buffers.force) = (results, forces);
        for (free, rows) in on_frames.into_iter().enumerate() {
            self.add_to_unknowns(free, rows.map(|row| -row));
        }
    }

    /// Remembers the values of densities at the loaded state, for section forces.
    pub(crate) fn set_densities(&mut self, t: f64, load_scale: f64) {
        self.buffers.density_values = self.all_values(t);
        self.buffers.density_scale = load_scale;
    }

    /// Whether there are densities or other loads along a body.
    pub(crate) fn has_loads_along(&self, body: usize) -> bool {
        self.distributed.all.iter().any(|density| density.spec.body == body)
            || self.links.spread.iter().any(|spread| spread.body == body)
    }

    /// Generalised forces of all densities and other loads that are spread over it on the nodal vectors of one element, axes of the frame that they live in;
    /// the state's values are remembered.
    pub(crate) fn densities_on(&self, body: usize, element: usize) -> [f64; MAX_SIZE] {
        let mut sum = [0.0; MAX_SIZE];
        let scale = self.buffers.density_scale;
        let mut add = |of: [f64; MAX_SIZE]| sum.iter_mut().zip(of).for_each(|(sum, value)| *sum += scale * value);
        for (index, values) in self.buffers.density_values.iter().enumerate() {
            if self.distributed.all[index].spec.body == body {
                add(self.density_on(index, element, values));
            }
        }
        add(self.spread_on(body, element));
        sum
    }

    /// Generalised forces of one density on the nodal vectors of an element of its body, axes of the frame that they live in.
    pub(crate) fn density_on(&self, index: usize, element: usize, values: &[f64]) -> [f64; MAX_SIZE] {
        let body = self.distributed.all[index].spec.body;
        let (at, n) = (&self.bodies[body], self.bodies[body].spec.element_size());
        let of_all: Vec<[f64; LANES]> = values.iter().map(|&value| [value; LANES]).collect();
        let q = self.in_body_axes(at, element).map(|value| [value; LANES]);
        let mut force = [[0.0; LANES]; MAX_SIZE];
        let elements = [(body, element); LANES];
        self.parts
            .density_force4(index, &elements, &of_all, &q[..n], &mut force[..n]);
        let mut force = force.map(|lanes| lanes[0]);
        if let Some(axes) = self.axes_of(at) {
            force[..n]
                .chunks_exact_mut(axes.d)
                .for_each(|vector| axes.vector(vector, false));
        }
        force
    }

    /// Adds the derivatives of [`MeshScene::add_density_forces`] at the loaded state.
    fn add_density_tangents(&mut self, t: f64, load_scale: f64, out: &mut impl Sums) {
        if self.distributed.all.is_empty() {
            return;
        }
        let values = self.all_values(t);
        let mut results = std::mem::take(&mut self.buffers.lanes);
        let (scene, mut shared) = (&*self, Shared::default());
        for of in &scene.distributed.batches {
            // Elements of one density follow each other: one sum at a time.
            let (mut total, mut summed) = (Total::default(), None);
            let evaluate = |unit: usize, result: &mut [[f64; LANES]]| scene.evaluate_density(of, unit, &values, result);
            let add_unit = |unit: usize, result: &[[f64; LANES]]| {
                let result = of.evaluated(result);
                for (lane, &(density, element)) in of.units.used(unit).iter().enumerate() {
                    if summed != Some(density) {
                        if let Some(before) = summed {
                            scene.add_total(before, t, &total, &mut shared, out);
                        }
                        summed = Some(density);
                        total.clear(scene.distributed.all[density].components.len(), of.values);
                    }
                    let body = &scene.bodies[scene.distributed.all[density].spec.body];
                    let places =
                        &scene.distributed.all[density].places[element * of.units.size..(element + 1) * of.units.size];
                    if let Some(axes) = scene.axes_of(body) {
                        let own = |all: &[[f64; LANES]]| -> Vec<f64> { all.iter().map(|all| all[lane]).collect() };
                        let (mut by_q, mut by_values) = (own(result.by_q), own(result.by_values));
                        axes.matrix(&mut by_q, of.units.size);
                        axes.rows(&mut by_values, of.values);
                        total.add_values(places, load_scale, |entry| by_values[entry]);
                        let (stiffness, factor) = out.all_stiffness();
                        let factor = -factor * load_scale;
                        body.scatter.add_by(element, &by_q, |value| factor * value, stiffness);
                    } else {
                        if scene.frames.free_of[body.frame].is_some() {
                            total.add_frame(places, &result, load_scale, lane);
                        }
                        total.add_values(places, load_scale, |entry| result.by_values[entry][lane]);
                        let (stiffness, factor) = out.all_stiffness();
                        let factor = -factor * load_scale;
                        body.scatter
                            .add_by(element, result.by_q, |lanes| factor * lanes[lane], stiffness);
                    }
                }
            };
            in_order(of.units.count(), of.width(true), &mut results, evaluate, add_unit);
            if let Some(last) = summed {
                scene.add_total(last, t, &total, &mut shared, out);
            }
        }
        self.buffers.lanes = results;
    }

    /// Adds what a density does between its body, its frame, and what its values depend on.
    fn add_total(&self, index: usize, t: f64, total: &Total, shared: &mut Shared, out: &mut (impl Sums + ?Sized)) {
        let density = &self.distributed.all[index];
        let (k, width) = (density.spec.values, density.driving);
        self.driven(index, t, shared);
        let by_unknowns = &shared.by_unknowns[..];
        let (stiffness, of_all) = out.all_stiffness();
        // By several unknowns at a time.
        for from in (0..width).step_by(TOGETHER) {
            let here = TOGETHER.min(width - from);
            let block = by_unknowns.chunks_exact(width).map(|row| {
                let mut own = [0.0; TOGETHER];
                own[..here].copy_from_slice(&row[from..from + here]);
                own
            });
            let block: Vec<[f64; TOGETHER]> = block.collect();
            let components = density.factors.iter().zip(density.upper.chunks_exact(width));
            let by_values = || total.by_values.chunks_exact(k);
            let doubled = density.doubled.iter().filter_map(|&place| by_values().nth(place));
            for ((&factor, entries), values) in components.zip(by_values().chain(doubled)) {
                if factor == 0.0 {
                    continue;
                }
                let sums = weighted(values, &block);
                let factor = -of_all * factor;
                for (&entry, value) in entries[from..from + here].iter().zip(sums) {
                    if entry != NOWHERE {
                        stiffness[entry as usize] += factor * value;
                    }
                }
            }
        }
        let frame = self.bodies[density.spec.body].frame;
        let Some(free) = self.frames.free_of[frame] else { return };
        let (motion, directions) = (&self.buffers.frames[frame], &self.frames.free[free].directions);
        let first = self.frame_unknowns(density.spec.body).start;
        let seen: Vec<[Vector; 2]> = directions
            .iter()
            .map(|direction| [motion.direction_to_frame(direction.shift), direction.turn])
            .collect();
        let along = |[shift, turn]: &[Vector; 2], [fx, fy, fz, mx, my, mz]: [f64; 6]| {
            shift.dot(&Vector::new(fx, fy, fz)) + turn.dot(&Vector::new(mx, my, mz))
        };
        let mut by_rows = [[0.0; TOGETHER]; ROWS];
        for (i, seen) in seen.iter().enumerate() {
            for (row, by_row) in by_rows.iter_mut().enumerate() {
                by_row[i] = seen[row / 3][row % 3];
            }
        }
        let doubled = density.doubled.iter().map(|&place| &total.frame_by_q[place]);
        let by_q = total.frame_by_q.iter().chain(doubled);
        for ((&factor, &entry), rows) in density.factors.iter().zip(&density.lower).zip(by_q) {
            if entry != NOWHERE && factor != 0.0 {
                let sums = weighted(rows, &by_rows);
                let factor = -of_all * factor;
                let own = &mut stiffness[entry as usize..][..seen.len()];
                own.iter_mut().zip(sums).for_each(|(value, sum)| *value += factor * sum);
            }
        }
        for (i, seen_i) in seen.iter().enumerate() {
            let by_values: Vec<f64> = total.frame_by_values.iter().map(|rows| along(seen_i, *rows)).collect();
            let driven = |column: usize| -> f64 {
                let by_unknowns = by_unknowns.iter().skip(column).step_by(width.max(1));
                by_values.iter().zip(by_unknowns).map(|(value, by)| value * by).sum()
            };
            for (column, &unknown) in density.outer.iter().enumerate() {
                let mut value = if column < width { driven(column) } else { 0.0 };
                if let Some(other) = unknown.checked_sub(first).and_then(|place| directions.get(place)) {
                    // The force turns with the frame: d(A F) = A (dpi x F).
                    value += seen_i[0].dot(&other.turn.cross(&total.rows[0]));
                }
                if let Some(entry) = density.square[i * density.outer.len() + column] {
                    out.stiffness(entry, -value);
                }
            }
        }
    }
}

/// What densities with the same markers share, and memory.
#[derive(Default)]
struct Shared {
    markers: Option<&'static [usize]>,
    arguments: [Vec<Vector>; 2],
    changes: Vec<(usize, usize, Vector)>,
    gradient: Vec<f64>,
    by_unknowns: Vec<f64>,
}

/// Sum of rows with these weights.
#[inline(always)]
fn weighted(weights: &[f64], rows: &[[f64; TOGETHER]]) -> [f64; TOGETHER] {
    let mut sums = [0.0; TOGETHER];
    for (weight, row) in weights.iter().zip(rows) {
        for (sum, value) in sums.iter_mut().zip(row) {
            *sum += weight * value;
        }
    }
    sums
}
