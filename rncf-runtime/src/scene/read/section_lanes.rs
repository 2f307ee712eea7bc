//! What sections carry in four elements of a body side by side. The operations are those of [`Reader`], which takes one element
//! after the other, in their order: so are the bits.

use super::section::{Reader, acting_inside, axis_weights, described};
use crate::emitted::lanes::{self, Kernel, Lanes, Real};
use crate::emitted::{Fidelity, LANES, NodalSpec};
use crate::model::SectionState;
use crate::scene::bodies::nodal_mass::{Columns, Total};
use crate::scene::pieces::buffers::Buffers;
use crate::scene::pieces::reach::Reach;
use crate::space::Vector;

/// Numbers, and vectors in the axes of the frame, of four elements.
type Four = [f64; LANES];
type Vectors = [Four; 3];

const NONE: Vectors = [[0.0; LANES]; 3];

/// What the sections at the starts of four elements carry, what acts between there and their ends, and what that follows from: on
/// nodal vectors, except for the last.
struct Elements<'a> {
    levers: &'a mut [Vectors],
    rates: &'a mut [Vectors],
    accelerations: &'a mut [Vectors],
    /// Accelerations in space.
    in_space: &'a mut [Vectors],
    elastic: &'a mut [Vectors],
    loads: &'a mut [Vectors],
    /// Inertia less loads.
    acting: &'a mut [Vectors],
    start: [Vectors; 2],
    /// Components: places, rates, elastic forces.
    local: [&'a mut [Four]; 3],
}

impl Reader<'_> {
    /// What the sections at places in [0, 1] of all elements carry, from start to end.
    pub fn all<const N: usize>(&mut self, places: &[f64; N], out: &mut Vec<SectionState>) {
        let (scene, index) = (self.scene, self.body);
        let body = &scene.bodies[index];
        let count = body.spec.count;
        if count < LANES || body.spec.fidelity != Fidelity::Full || body.modes.is_some() {
            (0..count).for_each(|element| self.element(element, places, out));
            return;
        }
        let is_loaded = scene.has_loads_along(index);
        let (vectors, size) = (body.spec.nodal.len(), body.spec.element_size());
        let mut memory = std::mem::take(&mut self.reaches.four);
        memory.resize(7 * 3 * vectors + 3 * size, [0.0; LANES]);
        let (of_vectors, of_components) = memory.split_at_mut(7 * 3 * vectors);
        let (of_vectors, _) = of_vectors.as_chunks_mut::<3>();
        let (mut of_vectors, mut of_components) = (
            of_vectors.chunks_exact_mut(vectors),
            of_components.chunks_exact_mut(size),
        );
        let mut next = || of_vectors.next().unwrap_or_default();
        let mut found = Elements {
            levers: next(),
            rates: next(),
            accelerations: next(),
            in_space: next(),
            elastic: next(),
            loads: next(),
            acting: next(),
            start: [NONE; 2],
            local: std::array::from_fn(|_| of_components.next().unwrap_or_default()),
        };
        let mut carried = [[NONE; 2]; N];
        out.reserve(count * N);
        for first in (0..count).step_by(LANES) {
            let last = count.min(first + LANES) - 1;
            // The last four repeat an element where there are too few.
            let elements = std::array::from_fn(|lane| last.min(first + lane));
            if !self.begin_four(elements, is_loaded, &mut found) {
                (first..=last).for_each(|element| self.element(element, places, out));
                continue;
            }
            for (&xi, out) in places.iter().zip(&mut carried) {
                self.carried_by_four(xi, &found, out);
            }
            for lane in 0..=last - first {
                let of = |all: &Vectors| [all[0][lane], all[1][lane], all[2][lane]];
                out.extend(
                    places
                        .iter()
                        .zip(&carried)
                        .map(|(&xi, [forces, moments])| self.stressed(first + lane, xi, [of(forces), of(moments)])),
                );
            }
        }
        self.reaches.four = memory;
    }

    /// As [`Reader::begin`], of four elements; `false` where they are not of one length, forces act inside of them, or the processor
    /// cannot.
    fn begin_four(&mut self, elements: [usize; LANES], is_loaded: bool, found: &mut Elements<'_>) -> bool {
        let (scene, index) = (self.scene, self.body);
        let body = &scene.bodies[index];
        let (spec, buffers) = (&body.spec, &scene.buffers);
        let differ = |element: usize| spec.element_length(element) != spec.element_length(elements[0]);
        if !spec.stations.is_empty() && elements.into_iter().any(differ) {
            return false;
        }
        if elements
            .into_iter()
            .any(|element| acting_inside(scene, index, element).next().is_some())
        {
            return false;
        }
        self.reaches.begin(described(scene, index), elements[0]);
        let components = elements.map(|element| body.connectivity.element(element));
        match *spec.axes {
            [x, y] => gather(buffers, components, [x, y], found),
            [x, y, z] => gather(buffers, components, [x, y, z], found),
            _ => return false,
        }
        let [q, v, force] = &mut found.local;
        force.fill([0.0; LANES]);
        let both = [0, 1, 2, 3].map(|lane: usize| (index, elements[lane]));
        scene.parts.elastic_force4(&both, q, v, force);
        // What acts on the section at the start alone is read.
        for (vector, force) in force.chunks_exact(spec.axes.len()).enumerate() {
            if spec.nodal[vector].xi == 0.0 {
                for (&axis, &force) in spec.axes.iter().zip(force) {
                    found.elastic[vector][axis] = force;
                }
            }
        }
        if is_loaded {
            for (lane, element) in elements.into_iter().enumerate() {
                let loads = scene.densities_on(index, element);
                for (loads, load) in found.loads.iter_mut().zip(loads.chunks_exact(spec.axes.len())) {
                    for (&axis, &load) in spec.axes.iter().zip(load) {
                        loads[axis][lane] = load;
                    }
                }
            }
        }
        lanes::run(Begin {
            nodal: spec.nodal,
            total: &self.total,
            masses: elements.map(|element| body.mass_of(element)),
            found,
        })
    }

    /// Forces and moments on the sections at one place in [0, 1] of the elements begun last, in the sections' own axes.
    fn carried_by_four(&mut self, xi: f64, found: &Elements<'_>, out: &mut [Vectors; 2]) {
        let (first, is_line, normal) = (self.first, self.is_line, self.normal);
        let reach = self.reaches.to(described(self.scene, self.body), xi);
        lanes::run(To {
            first,
            is_line,
            normal,
            reach,
            axes: axis_weights(is_line, reach),
            found,
            out,
        });
    }
}

/// Copies places, rates and accelerations of four elements' vectors with `D` components along these axes.
fn gather<const D: usize>(
    buffers: &Buffers,
    components: [&[usize]; LANES],
    axes: [usize; D],
    found: &mut Elements<'_>,
) {
    let [a, b, c, d] = components.map(|components| components.as_chunks::<D>().0);
    let [q, v, _] = &mut found.local;
    let local = q.as_chunks_mut::<D>().0.iter_mut().zip(v.as_chunks_mut::<D>().0);
    let vectors = found
        .levers
        .iter_mut()
        .zip(&mut *found.rates)
        .zip(&mut *found.accelerations);
    let of = a.iter().zip(b).zip(c).zip(d);
    for (((q, v), ((lever, rate), acceleration)), (((a, b), c), d)) in local.zip(vectors).zip(of) {
        for place in 0..D {
            let own = [a[place], b[place], c[place], d[place]];
            for lane in 0..LANES {
                q[place][lane] = buffers.q[own[lane]];
                v[place][lane] = buffers.v[own[lane]];
                acceleration[axes[place]][lane] = buffers.a[own[lane]];
            }
            lever[axes[place]] = q[place];
            rate[axes[place]] = v[place];
        }
    }
}

/// Vectors of four elements in the registers of the processor.
type Wide<L> = [<L as Lanes>::Real; 3];

#[inline(always)]
fn load<L: Lanes>(lanes: L, [x, y, z]: &Vectors) -> Wide<L> {
    // Closures of arrays are not compiled for the processor.
    [lanes.load(*x), lanes.load(*y), lanes.load(*z)]
}

/// The same vector of all four.
#[inline(always)]
fn even<L: Lanes>(lanes: L, vector: Vector) -> Wide<L> {
    let [x, y, z] = vector.into();
    [lanes.load([x; LANES]), lanes.load([y; LANES]), lanes.load([z; LANES])]
}

#[inline(always)]
fn store<L: Lanes>(vector: Wide<L>, out: &mut Vectors) {
    for (out, component) in out.iter_mut().zip(vector) {
        *out = [0.0; LANES];
        add(out, component);
    }
}

#[inline(always)]
fn add<R: Real>(sum: &mut R::Cell, value: R) {
    *sum += value;
}

#[inline(always)]
fn plus<L: Lanes>(a: Wide<L>, b: Wide<L>) -> Wide<L> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn minus<L: Lanes>(a: Wide<L>, b: Wide<L>) -> Wide<L> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn times<L: Lanes>(a: Wide<L>, factor: f64) -> Wide<L> {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

#[inline(always)]
fn cross<L: Lanes>(a: Wide<L>, b: Wide<L>) -> Wide<L> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[inline(always)]
fn dot<L: Lanes>(a: Wide<L>, b: Wide<L>) -> L::Real {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// As that of one element.
#[inline(always)]
fn unit<L: Lanes>(vector: Wide<L>) -> Wide<L> {
    let factor = (dot::<L>(vector, vector) + f64::MIN_POSITIVE).sqrt().recip();
    [factor * vector[0], factor * vector[1], factor * vector[2]]
}

/// `sum_a weight_a u_a`
#[inline(always)]
fn sum<L: Lanes>(lanes: L, weights: &[f64], vectors: &[Vectors]) -> Wide<L> {
    let mut sum = load(lanes, &NONE);
    for (&weight, vector) in weights.iter().zip(vectors) {
        sum = plus::<L>(sum, times::<L>(load(lanes, vector), weight));
    }
    sum
}

/// [`Reader::begin`] of four elements.
struct Begin<'a, 'b> {
    nodal: &'a [NodalSpec],
    total: &'a Total,
    /// Mass matrices of the elements, rows first.
    masses: [&'a [f64]; LANES],
    found: &'a mut Elements<'b>,
}

impl Kernel for Begin<'_, '_> {
    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let (found, count) = (self.found, self.nodal.len());
        for (place, vector) in self.nodal.iter().enumerate() {
            let mut u = load(lanes, &found.accelerations[place]);
            u = with_product(lanes, &self.total.turning, load(lanes, &found.levers[place]), u);
            u = with_product(lanes, &self.total.coriolis, load(lanes, &found.rates[place]), u);
            if vector.is_position() {
                for (u, &e) in u.iter_mut().zip(&self.total.e) {
                    *u = *u + e;
                }
            }
            store::<L>(u, &mut found.in_space[place]);
        }
        let mut start = [load(lanes, &NONE); 2];
        let [a, b, c, d] = self.masses;
        let [a, b, c, d] = [
            a.chunks_exact(count),
            b.chunks_exact(count),
            c.chunks_exact(count),
            d.chunks_exact(count),
        ];
        for (place, (((a, b), c), d)) in a.zip(b).zip(c).zip(d).enumerate() {
            let mut inertia = load(lanes, &NONE);
            for (column, of) in found.in_space[..count].iter().enumerate() {
                let mass = lanes.load([a[column], b[column], c[column], d[column]]);
                let [x, y, z] = load(lanes, of);
                inertia = plus::<L>(inertia, [mass * x, mass * y, mass * z]);
            }
            let acting = minus::<L>(inertia, load(lanes, &found.loads[place]));
            store::<L>(acting, &mut found.acting[place]);
            let vector = &self.nodal[place];
            if vector.xi == 0.0 {
                let both = plus::<L>(load(lanes, &found.elastic[place]), acting);
                let force = minus::<L>(load(lanes, &NONE), both);
                if vector.is_position() {
                    start[0] = plus::<L>(start[0], force);
                } else {
                    start[1] = plus::<L>(start[1], cross::<L>(load(lanes, &found.levers[place]), force));
                }
            }
        }
        for (value, out) in start.into_iter().zip(&mut found.start) {
            store::<L>(value, out);
        }
    }
}

/// `sum + A x`
#[inline(always)]
fn with_product<L: Lanes>(_: L, columns: &Columns, x: Wide<L>, mut sum: Wide<L>) -> Wide<L> {
    for (column, x) in columns.each().iter().zip(x) {
        for (sum, &factor) in sum.iter_mut().zip(column) {
            *sum = *sum + x * factor;
        }
    }
    sum
}

/// What the sections of four elements carry, in their own axes.
struct To<'a, 'b> {
    first: usize,
    is_line: bool,
    normal: Option<Vector>,
    reach: &'a Reach,
    axes: [&'a [f64]; 2],
    found: &'a Elements<'b>,
    out: &'a mut [Vectors; 2],
}

impl Kernel for To<'_, '_> {
    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Elements {
            levers, acting, start, ..
        } = self.found;
        let here = sum(lanes, &self.reach.position, levers);
        let [mut force, mut moment] = [load(lanes, &start[0]), load(lanes, &start[1])];
        let lever = minus::<L>(load(lanes, &levers[self.first]), here);
        moment = plus::<L>(moment, cross::<L>(lever, force));
        // Between the start and itself nothing acts.
        if self.reach.xi != 0.0 {
            let between = sum(lanes, &self.reach.forces, acting);
            force = plus::<L>(force, between);
            moment = minus::<L>(moment, cross::<L>(here, between));
            for (row, lever) in self
                .reach
                .levers
                .chunks_exact(self.reach.position.len())
                .zip(levers.iter())
            {
                moment = plus::<L>(moment, cross::<L>(load(lanes, lever), sum(lanes, row, acting)));
            }
        }
        let [y, z] = [sum(lanes, self.axes[0], levers), sum(lanes, self.axes[1], levers)];
        let none = lanes.load([0.0; LANES]);
        let (mut forces, mut moments) = ([none; 3], [none; 3]);
        if self.is_line {
            let along = unit::<L>(y);
            forces[0] = dot::<L>(along, force);
            moments[2] = match self.normal {
                Some(normal) => dot::<L>(moment, even(lanes, normal)),
                None => {
                    let about = dot::<L>(along, moment);
                    let across = minus::<L>(moment, [about * along[0], about * along[1], about * along[2]]);
                    dot::<L>(across, across).sqrt()
                }
            };
        } else {
            let z = match self.normal {
                Some(normal) => even(lanes, normal),
                None => z,
            };
            let (along, y) = (unit::<L>(cross::<L>(y, z)), unit::<L>(y));
            let triad = [along, y, cross::<L>(along, y)];
            for (place, axis) in triad.into_iter().enumerate() {
                forces[place] = dot::<L>(axis, force);
                moments[place] = dot::<L>(axis, moment);
            }
        }
        store::<L>(forces, &mut self.out[0]);
        store::<L>(moments, &mut self.out[1]);
    }
}
