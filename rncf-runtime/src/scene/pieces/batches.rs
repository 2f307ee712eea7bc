//! Elements of one kind side by side: elastic forces and their derivatives, four elements at a time.
//!
//! Units of four are evaluated and added one after the other by the calling thread.

use pulp::Arch;

use crate::emitted::{Fidelity, LANES, Parts, elastic_force_one_by_one, elastic_tangent_one_by_one};
use crate::linalg::{Vectorised, dispatch};
use crate::scene::bodies::mesh_body::MeshBody;
use crate::scene::numbering::units::{Lanes, Units};
use crate::space::Matrix;

/// Elements with the same kernels.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    /// One of its bodies: all have its frame, axes and nodal vectors.
    pub body: usize,
    /// Number of nodal vectors of an element.
    vectors: usize,
    /// Whether rates count.
    damps: bool,
    units: Units,
    /// Mass matrices of the elements' vectors, unit by unit.
    masses: Vec<Lanes>,
}

/// Blocks by which mass matrices multiply what the derivatives start from: by q, and by q'.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Blocks {
    pub by_place: Matrix,
    pub by_rate: Matrix,
}

/// Groups the elements of all bodies, in their order.
pub(crate) fn groups(bodies: &[MeshBody]) -> Vec<Group> {
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
        let spec = &bodies[body].spec;
        let vectors = spec.nodal.len();
        let of = |(body, element): (usize, usize)| bodies[body].connectivity.element(element);
        let units = Units::new(elements, spec.element_size(), of);
        let pairs = (0..units.count()).flat_map(|unit| (0..vectors * vectors).map(move |pair| (unit, pair)));
        let masses = pairs.map(|(unit, pair)| {
            units
                .all(unit)
                .map(|(body, element)| bodies[body].mass_of(element)[pair])
        });
        Self {
            body,
            vectors,
            damps: spec.damps,
            masses: masses.collect(),
            units,
        }
    }

    /// Gathers components and, where they count, their rates to the front of a unit's results; these, and what follows them.
    fn begin_local<'a>(
        &self,
        unit: usize,
        at: [&[f64]; 2],
        result: &'a mut [Lanes],
    ) -> ([&'a [Lanes]; 2], &'a mut [Lanes]) {
        let (q, rest) = result.split_at_mut(self.units.size);
        let (v, rest) = rest.split_at_mut(self.units.size);
        self.units.gather(unit, at[0], q);
        if self.damps {
            self.units.gather(unit, at[1], v);
        } else {
            v.fill([0.0; LANES]);
        }
        ([q, v], rest)
    }

    fn unit_force(&self, parts: &dyn Parts, unit: usize, [q, v]: [&[Lanes]; 2], force: &mut [Lanes]) {
        if self.units.are_few() {
            elastic_force_one_by_one(parts, self.units.used(unit), q, v, force);
        } else {
            parts.elastic_force4(self.units.all(unit), q, v, force);
        }
    }

    fn unit_tangent(
        &self,
        parts: &dyn Parts,
        unit: usize,
        [q, v]: [&[Lanes]; 2],
        [stiffness, damping]: [&mut [Lanes]; 2],
    ) {
        if self.units.are_few() {
            elastic_tangent_one_by_one(parts, self.units.used(unit), q, v, stiffness, damping);
        } else {
            parts.elastic_tangent4(self.units.all(unit), q, v, stiffness, damping);
        }
    }

    /// Starts the matrices of a unit with `M^ab` times a block.
    fn begin(&self, unit: usize, axes: &[usize], block: &Matrix, matrix: &mut [Lanes]) {
        if *block == Matrix::zeros() {
            matrix.fill([0.0; LANES]);
            return;
        }
        let count = self.vectors;
        let masses = &self.masses[unit * count * count..(unit + 1) * count * count];
        match *axes {
            [x, y] => dispatch(Arch::new(), Begun(masses, count, sub_block(block, [x, y]), matrix)),
            [x, y, z] => dispatch(Arch::new(), Begun(masses, count, sub_block(block, [x, y, z]), matrix)),
            _ => unreachable!("bodies have two or three axes"),
        }
    }

    /// Adds the elastic forces of all elements.
    pub fn add_forces(&self, parts: &dyn Parts, at: [&[f64]; 2], results: &mut Vec<Lanes>, force: &mut [f64]) {
        let n = self.units.size;
        let evaluate = |unit: usize, result: &mut [Lanes]| {
            let (local, force) = self.begin_local(unit, at, result);
            force.fill([0.0; LANES]);
            self.unit_force(parts, unit, local, force);
        };
        let add = |unit: usize, result: &[Lanes]| {
            let used = 0..self.units.used(unit).len();
            self.units.add(unit, used, 1.0, &result[2 * n..], force);
        };
        in_order(self.units.count(), 3 * n, results, evaluate, add);
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
        let square = self.units.size * self.units.size;
        let evaluate = |unit: usize, result: &mut [Lanes]| {
            let (local, matrices) = self.begin_local(unit, at, result);
            let (stiffness, damping) = matrices.split_at_mut(square);
            self.begin(unit, axes, &blocks.by_place, stiffness);
            self.begin(unit, axes, &blocks.by_rate, damping);
            self.unit_tangent(parts, unit, local, [stiffness, damping]);
        };
        let add = |unit: usize, result: &[Lanes]| {
            let (stiffness, damping) = result[2 * self.units.size..].split_at(square);
            let damps = damping.iter().flatten().fold(false, |any, &value| any | (value != 0.0));
            for (lane, &element) in self.units.used(unit).iter().enumerate() {
                call(element, [stiffness, damping], lane, damps);
            }
        };
        in_order(
            self.units.count(),
            2 * (self.units.size + square),
            results,
            evaluate,
            add,
        );
    }
}

/// Rows and columns of a block that are along some axes.
fn sub_block<const D: usize>(block: &Matrix, axes: [usize; D]) -> [[f64; D]; D] {
    axes.map(|i| axes.map(|j| block[(i, j)]))
}

/// Masses of `count` vectors side by side, rows first, times a block, into a matrix.
struct Begun<'a, const D: usize>(&'a [Lanes], usize, [[f64; D]; D], &'a mut [Lanes]);

impl<const D: usize> Vectorised for Begun<'_, D> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        let Self(masses, count, block, matrix) = self;
        let (columns, _) = matrix.as_chunks_mut::<D>();
        for (masses, rows) in masses.chunks_exact(count).zip(columns.chunks_exact_mut(D * count)) {
            for (row, values) in block.iter().zip(rows.chunks_exact_mut(count)) {
                for (mass, values) in masses.iter().zip(values) {
                    for j in 0..D {
                        for lane in 0..LANES {
                            values[j][lane] = mass[lane] * row[j];
                        }
                    }
                }
            }
        }
    }
}

/// Evaluates `count` units into `width` lanes each, and adds each before the next one: what is evaluated by several threads must be
/// kept and read again, which takes longer than they save (docs/measurements.md).
pub(crate) fn in_order(
    count: usize,
    width: usize,
    results: &mut Vec<Lanes>,
    evaluate: impl Fn(usize, &mut [Lanes]),
    mut add: impl FnMut(usize, &[Lanes]),
) {
    results.resize(width.max(results.len()), [0.0; LANES]);
    let result = &mut results[..width];
    for unit in 0..count {
        evaluate(unit, result);
        add(unit, result);
    }
}
