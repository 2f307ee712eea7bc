//! Loads per length of bodies (THEORY 5.1, Eq. 38): generalised forces `Q^a = int s^a f dx` on nodal vectors,
//! `F = A sum c_a Q^a` and `M = sum q_a x Q^a` on a free frame, and their derivatives (THEORY 2.1, column dq and
//! the rows with Q).

use super::assembly::evaluate;
use super::density_sums::{Axes, ROWS, Total, on_frame};
use super::evaluate::MAX_SIZE;
use super::parts::Fidelity;
use super::repeated::{DensitySpec, LANES};
use super::scene::{MeshBody, MeshScene};
use crate::error::ModelError;
use crate::system::Sums;
use crate::vector::{Vector, add, cross, dot};

/// Marks an entry that belongs to no unknown.
const NOWHERE: u32 = u32::MAX;

/// A load per length with its places on the pattern.
pub(super) struct Density {
    pub spec: DensitySpec,
    /// Components of the body's nodal vectors, ascending, each once.
    components: Vec<usize>,
    /// Places among them, one element after the other.
    places: Vec<usize>,
    /// Entries and factors of the elements' matrices, rows first.
    own: Vec<(u32, f64)>,
    /// Unknowns that its values depend on, then those of the body's free frame that are not among them.
    outer: Vec<usize>,
    /// Number of unknowns that its values depend on.
    driving: usize,
    /// For every component its factor and the entry of (component, outer unknown), components first.
    upper: Vec<Option<(f64, usize)>>,
    /// For every unknown of the frame factor and entry of (frame, component), unknowns first.
    lower: Vec<Option<(f64, usize)>>,
    /// For every unknown of the frame the entry of (frame, outer unknown), unknowns first.
    square: Vec<Option<usize>>,
}

/// Elements of one kind of density, four by four.
pub(super) struct Batches {
    /// Degrees of freedom of an element.
    size: usize,
    /// Number of values.
    values: usize,
    batches: Vec<Batch>,
}

/// Elements side by side: density and element; the last batch is filled up with its last one.
struct Batch {
    lanes: [(usize, usize); LANES],
    count: usize,
}

impl MeshScene {
    /// Finds what densities act on.
    ///
    /// # Errors
    /// A body that is not described by all its nodal vectors, or whose pose is not known in absolute coordinates,
    /// by name.
    pub(super) fn place_densities(&mut self) -> Result<(), ModelError> {
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
                let frame = self.marker_frame(&self.markers[marker]);
                if self.fixed.iter().any(|fixed| fixed.spec.frame == frame) {
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
            self.densities.push(Density {
                places: places.collect(),
                components,
                own: Vec::new(),
                outer: Vec::new(),
                driving: 0,
                upper: Vec::new(),
                lower: Vec::new(),
                square: Vec::new(),
                spec,
            });
        }
        for index in 0..self.densities.len() {
            let outer = self.outer_unknowns(&self.densities[index].spec);
            (self.densities[index].outer, self.densities[index].driving) = outer;
        }
        self.density_batches = self.batches();
        Ok(())
    }

    fn is_free_or_fixed(&self, frame: usize) -> bool {
        self.free_of[frame].is_some() || self.fixed.iter().any(|fixed| fixed.spec.frame == frame)
    }

    /// Unknowns that the values depend on, then the others of the body's frame; and the number of the first.
    fn outer_unknowns(&self, spec: &DensitySpec) -> (Vec<usize>, usize) {
        let markers: &[usize] = if spec.values > 0 { spec.markers } else { &[] };
        let components = markers
            .iter()
            .flat_map(|&marker| self.marker_components(&self.markers[marker]));
        let unknowns = components.filter_map(|component| self.layout.unknown(component));
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
        match self.free_of[self.bodies[body].frame] {
            Some(free) => {
                let first = self.layout.unknowns() - self.layout.border() + self.free[free].first;
                first..first + self.free[free].count()
            }
            None => 0..0,
        }
    }

    fn batches(&self) -> Vec<Batches> {
        let mut kinds: Vec<usize> = self.densities.iter().map(|density| density.spec.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        let mut all = Vec::new();
        for kind in kinds {
            let of_kind = |index: &usize| self.densities[*index].spec.kind == kind;
            let densities = (0..self.densities.len()).filter(of_kind);
            let elements: Vec<(usize, usize)> = densities
                .flat_map(|index| {
                    let body = &self.bodies[self.densities[index].spec.body];
                    (0..body.spec.count).map(move |element| (index, element))
                })
                .collect();
            let Some(&(first, _)) = elements.first() else {
                continue;
            };
            let spec = &self.densities[first].spec;
            all.push(Batches {
                size: self.bodies[spec.body].spec.element_size(),
                values: spec.values,
                batches: elements
                    .chunks(LANES)
                    .map(|chunk| Batch {
                        lanes: std::array::from_fn(|lane| chunk[lane.min(chunk.len() - 1)]),
                        count: chunk.len(),
                    })
                    .collect(),
            });
        }
        all
    }

    /// Entries of the pattern that densities need.
    pub(super) fn density_entries(&self) -> Vec<(usize, usize)> {
        let mut entries = Vec::new();
        for density in &self.densities {
            let components = density.components.iter();
            let own = components.filter_map(|&component| self.layout.unknown(component));
            let rows = own
                .map(|(unknown, _)| unknown)
                .chain(self.frame_unknowns(density.spec.body));
            for row in rows {
                entries.extend(density.outer.iter().flat_map(|&outer| [(row, outer), (outer, row)]));
            }
        }
        entries
    }

    /// Looks up all places on the pattern.
    pub(super) fn tabulate_densities(&mut self) {
        let mut densities = std::mem::take(&mut self.densities);
        densities.iter_mut().for_each(|density| self.tabulate_density(density));
        self.densities = densities;
    }

    fn tabulate_density(&self, density: &mut Density) {
        let frame = self.frame_unknowns(density.spec.body);
        let (components, outer) = (&density.components, &density.outer);
        let (own, find) = (
            |component| self.layout.unknown(component),
            |i, j| self.pattern.find(i, j),
        );
        let elements = &self.bodies[density.spec.body].connectivity;
        let both = |row: usize, column: usize| {
            let ((i, a), (j, b)) = (own(row)?, own(column)?);
            Some((find(i, j)? as u32, a * b))
        };
        let entries = (0..elements.count()).flat_map(|element| {
            let components = elements.element(element);
            let row = move |row: usize| components.iter().map(move |&column| (row, column));
            components.iter().flat_map(move |&component| row(component))
        });
        let entries = entries.map(|(row, column)| both(row, column).unwrap_or((NOWHERE, 0.0)));
        let upper = components.iter().flat_map(|&component| {
            let driving = outer[..density.driving].iter();
            driving.map(move |&outer| {
                let (row, factor) = own(component)?;
                Some((factor, find(row, outer)?))
            })
        });
        let lower = frame.clone().flat_map(|row| {
            components.iter().map(move |&component| {
                let (column, factor) = own(component)?;
                Some((factor, find(row, column)?))
            })
        });
        let square = frame
            .clone()
            .flat_map(|row| outer.iter().map(move |&outer| find(row, outer)));
        let (upper, lower, square) = (upper.collect(), lower.collect(), square.collect());
        let entries = entries.collect();
        (density.own, density.upper, density.lower, density.square) = (entries, upper, lower, square);
    }

    /// Values and velocities of the markers of a density at the loaded state.
    fn density_arguments(&self, spec: &DensitySpec) -> [Vec<Vector>; 2] {
        let jets = spec.markers.iter().map(|&marker| self.jet(&self.markers[marker]));
        let (z, velocity) = jets.map(|jet| (jet[0], jet[1])).unzip();
        [z, velocity]
    }

    /// Values of a density at the loaded state.
    pub(super) fn density_values(&self, index: usize, t: f64) -> Vec<f64> {
        let spec = &self.densities[index].spec;
        let [z, velocity] = self.density_arguments(spec);
        let mut values = vec![0.0; spec.values];
        self.parts.density_values(index, t, &z, &velocity, &mut values);
        values
    }

    /// Their derivatives by the unknowns that they depend on: values x unknowns, rows first.
    fn driven(&self, index: usize, t: f64) -> Vec<f64> {
        let density = &self.densities[index];
        let (spec, width) = (&density.spec, density.driving);
        let mut by_unknowns = vec![0.0; spec.values * width];
        if by_unknowns.is_empty() {
            return by_unknowns;
        }
        let [z, velocity] = self.density_arguments(spec);
        let mut gradient = vec![0.0; spec.values * 3 * z.len()];
        self.parts
            .density_values_gradient(index, t, &z, &velocity, &mut gradient);
        for (place, &marker) in spec.markers.iter().enumerate() {
            for column in self.columns(&self.markers[marker]) {
                let Some((unknown, factor)) = self.layout.unknown(column.component) else {
                    continue;
                };
                let driving = &density.outer[..width];
                let Ok(at) = driving.binary_search(&unknown) else {
                    continue;
                };
                for value in 0..spec.values {
                    let row = &gradient[(value * z.len() + place) * 3..][..3];
                    by_unknowns[value * width + at] += factor * dot([row[0], row[1], row[2]], column.value);
                }
            }
        }
        by_unknowns
    }

    /// Nodal vectors of an element in the axes of its body's frame.
    fn in_body_axes(&self, body: &MeshBody, element: usize) -> [f64; MAX_SIZE] {
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
    fn axes_of(&self, body: &MeshBody) -> Option<Axes> {
        let (axes, frame) = (body.spec.axes, &self.buffers.frames[body.spec.frame]);
        let entry = |i: usize, j: usize| match (axes.get(i), axes.get(j)) {
            (Some(&i), Some(&j)) => frame.rotation[i][j],
            _ => 0.0,
        };
        (body.frame != body.spec.frame).then(|| Axes {
            d: axes.len(),
            rotation: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
        })
    }

    /// Bodies, elements, values and nodal vectors of a batch, lane by lane.
    fn lanes(&self, of: &Batches, batch: &Batch, values: &[Vec<f64>]) -> Lanes {
        let mut lanes = Lanes {
            elements: [(0, 0); LANES],
            values: vec![[0.0; LANES]; of.values],
            q: [[0.0; LANES]; MAX_SIZE],
        };
        for (lane, &(density, element)) in batch.lanes.iter().enumerate() {
            let body = self.densities[density].spec.body;
            lanes.elements[lane] = (body, element);
            for (to, from) in lanes.values.iter_mut().zip(&values[density]) {
                to[lane] = *from;
            }
            for (to, from) in lanes.q.iter_mut().zip(self.in_body_axes(&self.bodies[body], element)) {
                to[lane] = from;
            }
        }
        lanes
    }

    fn all_values(&self, t: f64) -> Vec<Vec<f64>> {
        (0..self.densities.len())
            .map(|index| self.density_values(index, t))
            .collect()
    }

    /// Adds the densities at the loaded state (to the left side, where they are negative) to the forces of nodal
    /// vectors and free frames.
    pub(super) fn add_density_forces(&mut self, t: f64, load_scale: f64) {
        if self.densities.is_empty() {
            return;
        }
        let values = self.all_values(t);
        let mut on_frames = vec![[[0.0; 3]; 2]; self.densities.len()];
        let mut results = std::mem::take(&mut self.buffers.densities);
        let kinds = std::mem::take(&mut self.density_batches);
        for of in &kinds {
            let (scene, size) = (&*self, of.size);
            evaluate(of.batches.len(), size * LANES, &mut results, |place, result| {
                let batch = &of.batches[place];
                let lanes = scene.lanes(of, batch, &values);
                let force = result.as_chunks_mut::<LANES>().0;
                scene.density_force(batch, &lanes, size, force);
            });
            for (batch, result) in of.batches.iter().zip(results.chunks_exact(size * LANES)) {
                for lane in 0..batch.count {
                    let (density, element) = batch.lanes[lane];
                    let body = &self.bodies[self.densities[density].spec.body];
                    let mut force: [f64; MAX_SIZE] = std::array::from_fn(|i| {
                        let value = result.get(i * LANES + lane);
                        value.map_or(0.0, |value| load_scale * value)
                    });
                    let q = self.in_body_axes(body, element);
                    let rows = on_frame(body, &q, &force);
                    on_frames[density] = std::array::from_fn(|i| add(on_frames[density][i], rows[i]));
                    if let Some(axes) = self.axes_of(body) {
                        let vectors = force[..size].chunks_exact_mut(axes.d);
                        vectors.for_each(|vector| axes.vector(vector, false));
                    }
                    for (&component, value) in body.connectivity.element(element).iter().zip(force) {
                        self.buffers.force[component] -= value;
                    }
                }
            }
        }
        (self.buffers.densities, self.density_batches) = (results, kinds);
        for (density, [force, moment]) in on_frames.into_iter().enumerate() {
            let frame = self.bodies[self.densities[density].spec.body].frame;
            let Some(free) = self.free_of[frame] else { continue };
            let frame = &self.free[free];
            let force = self.buffers.frames[frame.spec.frame].direction_to_inertial(force);
            let first = self.layout.vector_components() + frame.first;
            for (place, direction) in frame.directions.iter().enumerate() {
                self.buffers.force[first + place] -= dot(direction.shift, force) + dot(direction.turn, moment);
            }
        }
    }

    /// Remembers the values of densities at the loaded state, for section forces.
    pub(super) fn set_densities(&mut self, t: f64, load_scale: f64) {
        self.buffers.density_values = self.all_values(t);
        self.buffers.density_scale = load_scale;
    }

    /// Whole force of all densities on one element, axes of the frame that its vectors live in; the state's values
    /// are remembered.
    pub(super) fn density_on(&self, body: usize, element: usize) -> Vector {
        let (at, n) = (&self.bodies[body], self.bodies[body].spec.element_size());
        let mut sum = [0.0; 3];
        for (index, values) in self.buffers.density_values.iter().enumerate() {
            if self.densities[index].spec.body != body {
                continue;
            }
            let batch = Batch {
                lanes: [(index, element); LANES],
                count: 1,
            };
            let mut lanes = Lanes {
                elements: [(body, element); LANES],
                values: values.iter().map(|&value| [value; LANES]).collect(),
                q: [[0.0; LANES]; MAX_SIZE],
            };
            let q = self.in_body_axes(at, element);
            lanes.q.iter_mut().zip(q).for_each(|(to, from)| *to = [from; LANES]);
            let mut force = [[0.0; LANES]; MAX_SIZE];
            self.density_force(&batch, &lanes, n, &mut force[..n]);
            let mut force = force.map(|lanes| self.buffers.density_scale * lanes[0]);
            if let Some(axes) = self.axes_of(at) {
                force[..n]
                    .chunks_exact_mut(axes.d)
                    .for_each(|vector| axes.vector(vector, false));
            }
            sum = add(sum, on_frame(at, &q, &force[..n])[0]);
        }
        sum
    }

    fn density_force(&self, batch: &Batch, lanes: &Lanes, size: usize, force: &mut [[f64; LANES]]) {
        self.parts.density_force4(
            batch.lanes[0].0,
            &lanes.elements,
            &lanes.values,
            &lanes.q[..size],
            force,
        );
    }

    /// Adds the derivatives of [`MeshScene::add_density_forces`] at the loaded state.
    pub(super) fn add_density_tangents(&mut self, t: f64, load_scale: f64, out: &mut (impl Sums + ?Sized)) {
        if self.densities.is_empty() {
            return;
        }
        let values = self.all_values(t);
        let mut totals: Vec<Total> = self.densities.iter().map(Density::total).collect();
        let mut results = std::mem::take(&mut self.buffers.densities);
        for of in &self.density_batches {
            let (n, k) = (of.size, of.values);
            let width = (n + n * n + n * k) * LANES;
            evaluate(of.batches.len(), width, &mut results, |place, result| {
                let batch = &of.batches[place];
                let lanes = self.lanes(of, batch, &values);
                let (force, rest) = result.as_chunks_mut::<LANES>().0.split_at_mut(n);
                let (by_q, by_values) = rest.split_at_mut(n * n);
                self.density_force(batch, &lanes, n, force);
                let density = batch.lanes[0].0;
                let (elements, values, q) = (&lanes.elements, &lanes.values, &lanes.q[..n]);
                self.parts
                    .density_tangent4(density, elements, values, q, by_q, by_values);
            });
            let mut local = vec![0.0; width / LANES];
            for (batch, result) in of.batches.iter().zip(results.chunks_exact(width)) {
                for lane in 0..batch.count {
                    let all = result.iter().skip(lane).step_by(LANES);
                    local.iter_mut().zip(all).for_each(|(to, from)| *to = load_scale * from);
                    let (density, element) = batch.lanes[lane];
                    self.add_element(density, element, &mut local, &mut totals[density], out);
                }
            }
        }
        self.buffers.densities = results;
        for (index, total) in totals.iter().enumerate() {
            self.add_total(index, t, total, out);
        }
    }

    /// Adds the block of one element, and to the sums of its density; `local` are its force and both derivatives.
    fn add_element(
        &self,
        index: usize,
        element: usize,
        local: &mut [f64],
        total: &mut Total,
        out: &mut (impl Sums + ?Sized),
    ) {
        let density = &self.densities[index];
        let body = &self.bodies[density.spec.body];
        let (n, k) = (body.spec.element_size(), density.spec.values);
        let (force, rest) = local.split_at_mut(n);
        let (by_q, by_values) = rest.split_at_mut(n * n);
        let places = &density.places[element * n..(element + 1) * n];
        if self.free_of[body.frame].is_some() {
            let q = self.in_body_axes(body, element);
            total.add_frame(body, &q, places, [force, by_q, by_values]);
        }
        if let Some(axes) = self.axes_of(body) {
            axes.matrix(by_q, n);
            axes.rows(by_values, k);
        }
        for (row, &place) in places.iter().enumerate() {
            let own = &by_values[row * k..(row + 1) * k];
            let sums = total.by_values[place * k..(place + 1) * k].iter_mut();
            sums.zip(own).for_each(|(sum, value)| *sum += value);
        }
        let entries = &density.own[element * n * n..(element + 1) * n * n];
        for (&(entry, factor), value) in entries.iter().zip(by_q) {
            if entry != NOWHERE {
                out.stiffness(entry as usize, -factor * *value);
            }
        }
    }

    /// Adds what a density does between its body, its frame, and what its values depend on.
    fn add_total(&self, index: usize, t: f64, total: &Total, out: &mut (impl Sums + ?Sized)) {
        let density = &self.densities[index];
        let (k, width, count) = (density.spec.values, density.driving, density.components.len());
        let by_unknowns = self.driven(index, t);
        let driven = |row: &[f64], column: usize| -> f64 {
            let values = row.iter().enumerate();
            values.map(|(value, by)| by * by_unknowns[value * width + column]).sum()
        };
        for (place, entry) in density.upper.iter().enumerate() {
            if let Some((factor, entry)) = entry {
                let (component, column) = (place / width, place % width);
                let row = &total.by_values[component * k..(component + 1) * k];
                out.stiffness(*entry, -factor * driven(row, column));
            }
        }
        let frame = self.bodies[density.spec.body].frame;
        let Some(free) = self.free_of[frame] else { return };
        let (motion, directions) = (&self.buffers.frames[frame], &self.free[free].directions);
        let first = self.frame_unknowns(density.spec.body).start;
        for (i, direction) in directions.iter().enumerate() {
            let shift = motion.direction_to_frame(direction.shift);
            let weights = [shift, direction.turn].concat();
            let weighted = |matrix: &[f64], columns: usize| -> Vec<f64> {
                let column = |c: usize| (0..ROWS).map(|row| weights[row] * matrix[row * columns + c]).sum();
                (0..columns).map(column).collect()
            };
            let by_q = weighted(&total.frame_by_q, count);
            for (entry, value) in density.lower[i * count..(i + 1) * count].iter().zip(by_q) {
                if let Some((factor, entry)) = entry {
                    out.stiffness(*entry, -factor * value);
                }
            }
            let by_values = weighted(&total.frame_by_values, k);
            for (column, &unknown) in density.outer.iter().enumerate() {
                let mut value = if column < width {
                    driven(&by_values, column)
                } else {
                    0.0
                };
                if let Some(other) = unknown.checked_sub(first).and_then(|place| directions.get(place)) {
                    // The force turns with the frame: d(A F) = A (dpi x F).
                    value += dot(shift, cross(other.turn, total.rows[0]));
                }
                if let Some(entry) = density.square[i * density.outer.len() + column] {
                    out.stiffness(entry, -value);
                }
            }
        }
    }
}

/// Four elements side by side.
struct Lanes {
    elements: [(usize, usize); LANES],
    values: Vec<[f64; LANES]>,
    q: [[f64; LANES]; MAX_SIZE],
}

impl Density {
    fn total(&self) -> Total {
        Total::new(self.components.len(), self.spec.values)
    }
}
