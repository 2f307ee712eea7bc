//! Inertia at the level of nodal vectors (THEORY 2). The mass matrix M^ab of a body's nodal vectors is constant
//! and couples vectors, not components: inertia forces of all elements and fixtures are one product with it,
//!
//! ```text
//! u_b = q''_b + 2 w x q'_b + w' x q_b + w x (w x q_b) + c_b e,    e = A^T (r'' - g), c_b = 1 on positions
//! R_a = M^ab u_b                                                  inertia part of (13)
//! A^T R_r = sum_a c_a R_a,   R_pi = sum_a q_a x R_a               (11), (12), over all vectors
//! ```
//!
//! The sums run over eliminated vectors, too; elastic forces drop out of them.
//! Planar bodies are taken in space, with vectors in their plane.

use pulp::Arch;

use super::force::{At, Force};
use crate::emitted::Fidelity;
use crate::linalg::{Vectorised, dispatch};
use crate::scene::bodies::nodal_mass::{NodalMass, Transport, add_scaled};
use crate::scene::frames::free_frames::SPATIAL;
use crate::scene::mesh_scene::MeshScene;
use crate::scene::numbering::assembly::couple_all;
use crate::scene::pieces::buffers::Buffers;
use crate::scene::pieces::combination::Combination;
use crate::scene::pieces::combined::Combined;
use crate::space::{Matrix, Vector};
use crate::system::Tangent;

/// Inertia and gravity of elements, fixtures and rigid parts.
pub(crate) struct Inertia;

impl Force for Inertia {
    fn couple(&self, scene: &MeshScene, entries: &mut Vec<(usize, usize)>) {
        let layout = &scene.layout;
        let unknowns_of = |free: usize| {
            let first = scene.first_unknown(free);
            first..first + scene.frames.free[free].count()
        };
        // Frames do not feel each other: each moves in one that is prescribed.
        for free in 0..scene.frames.free.len() {
            couple_all(&unknowns_of(free).collect::<Vec<_>>(), entries);
        }
        for body in &scene.bodies {
            let Some(free) = scene.frames.free_of[body.frame] else {
                continue;
            };
            let own = layout.offset(body.first_vector)..layout.offset(body.first_vector + body.spec.vectors());
            for unknown in scene.unknowns_of(own) {
                entries.extend(unknowns_of(free).flat_map(|border| [(unknown, border), (border, unknown)]));
            }
        }
    }

    fn add(&self, scene: &mut MeshScene, at: &At) {
        scene.add_inertia_forces(at.gravity);
    }

    fn add_tangent(&self, scene: &mut MeshScene, at: &At, out: &mut Tangent) {
        let matrices = [&mut out.mass, &mut out.damping, &mut out.stiffness];
        for (place, values) in matrices.into_iter().enumerate() {
            scene.add_inertia_borders(at.gravity, &Combination::only(place), values);
        }
    }

    fn add_combined(&self, scene: &mut MeshScene, at: &At, out: &mut Combined) {
        scene.add_inertia_borders(at.gravity, out.combination, out.values);
    }
}

impl MeshScene {
    /// Masses of the nodal vectors of a body: with its elements, and of fixtures alone.
    pub(crate) fn nodal_masses(&self, index: usize) -> [NodalMass; 2] {
        let body = &self.bodies[index];
        let on_body = || self.fixtures.iter().filter(|fixture| fixture.point.body == index);
        let normals = || on_body().flat_map(|fixture| fixture.entries_of_normal(&body.spec));
        let fixed: Vec<(usize, Vec<f64>)> = on_body()
            .map(|fixture| (fixture.point.element, fixture.mass().to_vec()))
            .collect();
        let fixed = || fixed.iter().map(|(element, local)| (*element, &local[..]));
        let elements = (0..body.spec.count).map(|element| (element, body.mass_of(element)));
        let on_it = NodalMass::new(&body.spec, fixed(), normals());
        let whole = match body.spec.fidelity {
            Fidelity::Point => {
                let own = NodalMass::new(&body.spec, elements, []);
                own.at_centre(&body.spec).plus(&on_it, &body.spec)
            }
            _ => NodalMass::new(&body.spec, elements.chain(fixed()), normals()),
        };
        [whole, on_it]
    }

    /// Adds the inertia forces of elements, fixtures and rigid parts at the loaded state, on nodal vectors and on
    /// free frames.
    pub(crate) fn add_inertia_forces(&mut self, gravity: Vector) {
        let rigid = self.frames.free.iter().map(|frame| {
            let motion = &self.buffers.frames[frame.spec.frame];
            Transport::new(motion, SPATIAL, gravity).of_rigid(&frame.spec.rigid)
        });
        let mut on_frames: Vec<[Vector; 2]> = rigid.collect();
        let Buffers {
            q,
            v,
            a,
            force,
            frames,
            nodal,
            ..
        } = &mut self.buffers;
        for body in &self.bodies {
            let mass = body.nodal_mass(self.in_modes);
            if mass.is_empty() {
                continue;
            }
            let axes = body.spec.axes;
            let transport = Transport::new(&frames[body.frame], axes, gravity);
            let first = self.layout.offset(body.first_vector);
            let own = first..first + mass.vectors() * axes.len();
            let [places, rates, accelerations] = [&*q, &*v, &*a].map(|full| &full[own.clone()]);
            let mut forces_of = |mass: &NodalMass, at: [&[f64]; 3], out: &mut [f64]| {
                let forces = Forces {
                    mass,
                    axes,
                    transport: &transport,
                    at,
                    summed: self.frames.free_of[body.frame].is_some(),
                    scratch: &mut *nodal,
                    out,
                };
                dispatch(Arch::new(), forces)
            };
            let small = body.modes.as_ref().filter(|modes| !self.in_modes && modes.is_linear());
            let sums = match small {
                // Inertia of small deformations is that of the undeformed shape; fixtures follow the deformed one.
                Some(modes) => {
                    let mut undeformed = vec![0.0; places.len()];
                    forces_of(&body.fixed_mass, [modes.shape(), rates, accelerations], &mut undeformed);
                    let out = &mut force[own.clone()];
                    out.iter_mut().zip(undeformed).for_each(|(sum, value)| *sum -= value);
                    forces_of(&body.fixed_mass, [places, rates, accelerations], out);
                    forces_of(mass, [modes.shape(), rates, accelerations], out)
                }
                None => forces_of(mass, [places, rates, accelerations], &mut force[own.clone()]),
            };
            if let Some(free) = self.frames.free_of[body.frame] {
                for (sum, value) in on_frames[free].iter_mut().zip(sums) {
                    *sum += value;
                }
            }
        }
        for (free, sums) in on_frames.into_iter().enumerate() {
            self.add_to_unknowns(free, sums);
        }
    }

    /// Adds force and moment (frame axes) on a free frame to the forces of its unknowns.
    pub(crate) fn add_to_unknowns(&mut self, free: usize, [force, moment]: [Vector; 2]) {
        let frame = &self.frames.free[free];
        let force = self.buffers.frames[frame.spec.frame].direction_to_inertial(force);
        let first = self.layout.vector_components() + frame.first;
        for (place, direction) in frame.directions.iter().enumerate() {
            self.buffers.force[first + place] += direction.shift.dot(&force) + direction.turn.dot(&moment);
        }
    }
}

/// [`forces`] with the instructions of the processor.
struct Forces<'a> {
    mass: &'a NodalMass,
    axes: &'a [usize],
    transport: &'a Transport,
    at: [&'a [f64]; 3],
    /// Whether force and moment on the frame are wanted.
    summed: bool,
    scratch: &'a mut Vec<f64>,
    out: &'a mut [f64],
}

impl Vectorised for Forces<'_> {
    type Output = [Vector; 2];

    #[inline(always)]
    fn run<const F: bool>(self) -> [Vector; 2] {
        match *self.axes {
            // Nothing leaves the plane.
            [first, second] if !self.summed => forces::<2, 2>(self, [0, 1], [first, second]),
            [first, second] => forces::<2, 4>(self, [first, second], [0, 1, 2, 3]),
            [_, _, _] => forces::<3, 4>(self, [0, 1, 2], [0, 1, 2, 3]),
            _ => Default::default(),
        }
    }
}

/// Adds the inertia forces of a body on its vectors, which have `D` components; their force and moment about the frame's
/// origin. Each stands at its place among the `W` components that are computed, which are along these axes of the frame; a
/// fourth axis is zero.
#[inline(always)]
fn forces<const D: usize, const W: usize>(of: Forces<'_>, places: [usize; D], axes: [usize; W]) -> [Vector; 2] {
    let Forces { mass, transport, .. } = of;
    let turning = columns(&transport.turning(), places, axes);
    let coriolis = columns(&transport.coriolis(), places, axes);
    let e = along(transport.e, axes);
    let [q, v, a] = of.at;
    let (q, v, a) = (q.as_chunks::<D>().0, v.as_chunks::<D>().0, a.as_chunks::<D>().0);
    let count = mass.vectors();
    let (q, v, a, is_position) = (&q[..count], &v[..count], &a[..count], &mass.is_position[..count]);
    of.scratch.resize(W * count, 0.0);
    let (accelerations, _) = of.scratch.as_chunks_mut::<W>();
    for (place, acceleration) in accelerations[..count].iter_mut().enumerate() {
        let mut u = spread(&places, &a[place]);
        for j in 0..D {
            add_scaled(&mut u, q[place][j], &turning[j]);
        }
        for j in 0..D {
            add_scaled(&mut u, v[place][j], &coriolis[j]);
        }
        if is_position[place] {
            add_scaled(&mut u, 1.0, &e);
        }
        *acceleration = u;
    }
    let (mut force, mut moment) = ([0.0; W], Vector::zeros());
    let (out, _) = of.out.as_chunks_mut::<D>();
    let mut rows = mass.rows();
    for (place, out) in out[..count].iter_mut().enumerate() {
        let g = rows.next_times(accelerations);
        for (out, &at) in out.iter_mut().zip(&places) {
            *out += g[at % W];
        }
        if of.summed {
            if is_position[place] {
                add_scaled(&mut force, 1.0, &g);
            }
            moment += first(&spread::<D, W>(&places, &q[place])).cross(&first(&g));
        }
    }
    [first(&force), moment]
}

/// Columns of a matrix, those of the axes at `places`, along the axes.
#[inline(always)]
fn columns<const D: usize, const W: usize>(matrix: &Matrix, places: [usize; D], axes: [usize; W]) -> [[f64; W]; D] {
    let mut columns = [[0.0; W]; D];
    for j in 0..D {
        for i in (0..W).filter(|&i| axes[i] < 3) {
            columns[j][i] = matrix[(axes[i], axes[places[j]])];
        }
    }
    columns
}

/// A vector along some axes, of which the fourth is zero.
fn along<const W: usize>(vector: Vector, axes: [usize; W]) -> [f64; W] {
    let mut components = [0.0; W];
    for i in (0..W).filter(|&i| axes[i] < 3) {
        components[i] = vector[axes[i]];
    }
    components
}

/// A vector at the places of its components.
#[inline(always)]
fn spread<const D: usize, const W: usize>(places: &[usize; D], values: &[f64; D]) -> [f64; W] {
    let mut all = [0.0; W];
    for (&place, &value) in places.iter().zip(values) {
        all[place % W] = value;
    }
    all
}

/// The first three of some components, zeros beyond their end.
#[inline(always)]
fn first<const W: usize>(values: &[f64; W]) -> Vector {
    Vector::from_fn(|axis, _| values.get(axis).copied().unwrap_or(0.0))
}
