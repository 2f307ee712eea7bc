//! Elements of one kind side by side: elastic forces and their derivatives, four elements at a time.
//!
//! Units of four are evaluated in parallel where there are many, into places of their own, and added in a fixed
//! order: results do not depend on the number of threads.

use rayon::prelude::*;

use super::assembly::PARALLEL_FROM;
use super::evaluate::MAX_SIZE;
use super::parts::{Fidelity, Parts};
use super::repeated::LANES;
use super::scene::MeshBody;
use crate::vector::Matrix;

/// Numbers side by side, one of each element.
pub(super) type Lanes = [f64; LANES];

/// Units that are evaluated before their results are added.
const BLOCK: usize = 64;

/// Elements with the same kernels.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// One of its bodies: all have its frame, axes and nodal vectors.
    pub body: usize,
    /// Degrees of freedom of an element.
    size: usize,
    /// Nodal vectors of an element.
    vectors: usize,
    /// Number of elements.
    elements: usize,
    /// Body and element in every lane; the last unit repeats an element in lanes that it does not need.
    units: Vec<[(usize, usize); LANES]>,
    /// Components in the full arrays, unit by unit.
    components: Vec<[u32; LANES]>,
    /// Mass matrices of the elements' vectors, unit by unit.
    masses: Vec<Lanes>,
}

/// Blocks by which mass matrices multiply what the derivatives start from: by q, and by q'.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Blocks {
    pub by_place: Matrix,
    pub by_rate: Matrix,
}

/// Groups the elements of all bodies, in their order.
pub(super) fn groups(bodies: &[MeshBody]) -> Vec<Group> {
    let mut groups: Vec<(usize, Vec<(usize, usize)>)> = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let elements = (0..body.spec.count).map(|element| (index, element));
        let same = groups.iter_mut().rev().find(|(other, _)| alike(&bodies[*other], body));
        match same {
            Some((_, all)) => all.extend(elements),
            None => groups.push((index, elements.collect())),
        }
    }
    let of = |(body, elements): (usize, Vec<(usize, usize)>)| Group::new(bodies, body, &elements);
    groups.into_iter().map(of).collect()
}

/// Whether elements of two bodies may stand side by side. Bodies with modes stand alone, as they may be left out.
fn alike(one: &MeshBody, other: &MeshBody) -> bool {
    let (a, b) = (&one.spec, &other.spec);
    a.kind == b.kind
        && one.frame == other.frame
        && a.axes == b.axes
        && a.nodal == b.nodal
        && [a, b].iter().all(|spec| spec.fidelity == Fidelity::Full)
}

impl Group {
    fn new(bodies: &[MeshBody], body: usize, elements: &[(usize, usize)]) -> Self {
        let units: Vec<[(usize, usize); LANES]> = elements
            .chunks(LANES)
            .map(|chunk| std::array::from_fn(|lane| chunk[lane.min(chunk.len() - 1)]))
            .collect();
        let spec = &bodies[body].spec;
        let (size, vectors) = (spec.element_size(), spec.nodal.len());
        let places = units.iter().flat_map(|unit| (0..size).map(move |place| (unit, place)));
        let components = places
            .map(|(unit, place)| unit.map(|(body, element)| bodies[body].connectivity.element(element)[place] as u32));
        let pairs = units
            .iter()
            .flat_map(|unit| (0..vectors * vectors).map(move |pair| (unit, pair)));
        let masses = pairs.map(|(unit, pair)| unit.map(|(body, _)| bodies[body].mass[pair]));
        Self {
            body,
            size,
            vectors,
            elements: elements.len(),
            components: components.collect(),
            masses: masses.collect(),
            units,
        }
    }

    /// Number of lanes of a unit whose results count.
    fn used(&self, unit: usize) -> usize {
        (self.elements - unit * LANES).min(LANES)
    }

    fn gather(&self, unit: usize, full: &[f64], local: &mut [Lanes]) {
        let own = &self.components[unit * self.size..(unit + 1) * self.size];
        for (values, components) in local.iter_mut().zip(own) {
            *values = components.map(|component| full[component as usize]);
        }
    }

    /// Gathers components and their rates to the front of a unit's results; these, and what follows them.
    fn begin_local<'a>(
        &self,
        unit: usize,
        at: [&[f64]; 2],
        result: &'a mut [Lanes],
    ) -> ([&'a [Lanes]; 2], &'a mut [Lanes]) {
        let (q, rest) = result.split_at_mut(self.size);
        let (v, rest) = rest.split_at_mut(self.size);
        self.gather(unit, at[0], q);
        self.gather(unit, at[1], v);
        ([q, v], rest)
    }

    /// Lane by lane where there are too few elements to fill a unit.
    fn lone(&self) -> bool {
        self.elements < LANES
    }

    fn unit_force(&self, parts: &dyn Parts, unit: usize, [q, v]: [&[Lanes]; 2], force: &mut [Lanes]) {
        let n = self.size;
        if !self.lone() {
            parts.elastic_force4(&self.units[unit], q, v, force);
            return;
        }
        for lane in 0..self.used(unit) {
            let (body, element) = self.units[unit][lane];
            let [q, v] = [q, v].map(|all| lane_of(all, lane));
            let mut own = [0.0; MAX_SIZE];
            parts.elastic_force(body, element, &q[..n], &v[..n], &mut own[..n]);
            force.iter_mut().zip(own).for_each(|(sum, value)| sum[lane] += value);
        }
    }

    fn unit_tangent(
        &self,
        parts: &dyn Parts,
        unit: usize,
        [q, v]: [&[Lanes]; 2],
        [stiffness, damping]: [&mut [Lanes]; 2],
    ) {
        let n = self.size;
        if !self.lone() {
            parts.elastic_tangent4(&self.units[unit], q, v, stiffness, damping);
            return;
        }
        for lane in 0..self.used(unit) {
            let (body, element) = self.units[unit][lane];
            let [q, v] = [q, v].map(|all| lane_of(all, lane));
            let [mut k, mut c] = [vec![0.0; n * n], vec![0.0; n * n]];
            parts.elastic_tangent(body, element, &q[..n], &v[..n], &mut k, &mut c);
            for (sums, values) in [(&mut *stiffness, k), (&mut *damping, c)] {
                sums.iter_mut().zip(values).for_each(|(sum, value)| sum[lane] += value);
            }
        }
    }

    /// Starts the matrices of a unit with `M^ab` times a block.
    fn begin(&self, unit: usize, axes: &[usize], block: &Matrix, matrix: &mut [Lanes]) {
        if *block == [[0.0; 3]; 3] {
            matrix.fill([0.0; LANES]);
            return;
        }
        let (count, d, n) = (self.vectors, axes.len(), self.size);
        let masses = &self.masses[unit * count * count..(unit + 1) * count * count];
        for (row, values) in matrix.chunks_exact_mut(n).enumerate() {
            let (a, i) = (row / d, axes[row % d]);
            let masses = &masses[a * count..(a + 1) * count];
            for (mass, values) in masses.iter().zip(values.chunks_exact_mut(d)) {
                for (value, &j) in values.iter_mut().zip(axes) {
                    *value = mass.map(|mass| mass * block[i][j]);
                }
            }
        }
    }

    /// Adds the elastic forces of all elements.
    pub fn add_forces(&self, parts: &dyn Parts, at: [&[f64]; 2], results: &mut Vec<Lanes>, force: &mut [f64]) {
        let n = self.size;
        let evaluate = |unit: usize, result: &mut [Lanes]| {
            let (local, force) = self.begin_local(unit, at, result);
            force.fill([0.0; LANES]);
            self.unit_force(parts, unit, local, force);
        };
        let add = |unit: usize, result: &[Lanes]| {
            let own = &self.components[unit * n..(unit + 1) * n];
            for lane in 0..self.used(unit) {
                for (components, values) in own.iter().zip(&result[2 * n..]) {
                    force[components[lane] as usize] += values[lane];
                }
            }
        };
        in_order(self.units.len(), 3 * n, results, evaluate, add);
    }

    /// Evaluates the derivatives of elastic forces by q and by q' of all elements, which start from
    /// `M^ab` times blocks, and calls for one element after the other with both matrices, rows first, the number
    /// of its lane, and whether there is anything in the second.
    pub fn each_tangent(
        &self,
        parts: &dyn Parts,
        axes: &[usize],
        at: [&[f64]; 2],
        blocks: &Blocks,
        results: &mut Vec<Lanes>,
        mut call: impl FnMut((usize, usize), [&[Lanes]; 2], usize, bool),
    ) {
        let square = self.size * self.size;
        let evaluate = |unit: usize, result: &mut [Lanes]| {
            let (local, matrices) = self.begin_local(unit, at, result);
            let (stiffness, damping) = matrices.split_at_mut(square);
            self.begin(unit, axes, &blocks.by_place, stiffness);
            self.begin(unit, axes, &blocks.by_rate, damping);
            self.unit_tangent(parts, unit, local, [stiffness, damping]);
        };
        let add = |unit: usize, result: &[Lanes]| {
            let (stiffness, damping) = result[2 * self.size..].split_at(square);
            let damps = damping.iter().flatten().fold(false, |any, &value| any | (value != 0.0));
            for lane in 0..self.used(unit) {
                call(self.units[unit][lane], [stiffness, damping], lane, damps);
            }
        };
        in_order(self.units.len(), 2 * (self.size + square), results, evaluate, add);
    }
}

/// Evaluates `count` units into `width` lanes each and adds them one after the other, by blocks in parallel where
/// there are many.
pub(super) fn in_order(
    count: usize,
    width: usize,
    results: &mut Vec<Lanes>,
    evaluate: impl Fn(usize, &mut [Lanes]) + Sync,
    mut add: impl FnMut(usize, &[Lanes]),
) {
    if count * LANES < PARALLEL_FROM || rayon::current_num_threads() == 1 {
        results.resize(width.max(results.len()), [0.0; LANES]);
        let result = &mut results[..width];
        for unit in 0..count {
            evaluate(unit, result);
            add(unit, result);
        }
        return;
    }
    results.resize((BLOCK * width).max(results.len()), [0.0; LANES]);
    for first in (0..count).step_by(BLOCK) {
        let own = &mut results[..BLOCK.min(count - first) * width];
        own.par_chunks_exact_mut(width)
            .enumerate()
            .for_each(|(unit, result)| evaluate(first + unit, result));
        for (unit, result) in own.chunks_exact(width).enumerate() {
            add(first + unit, result);
        }
    }
}

/// One lane.
fn lane_of(all: &[Lanes], lane: usize) -> [f64; MAX_SIZE] {
    let mut own = [0.0; MAX_SIZE];
    for (value, lanes) in own.iter_mut().zip(all) {
        *value = lanes[lane];
    }
    own
}
