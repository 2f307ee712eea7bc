//! What moves in a mode about a uniform rotation, from its shape: in which sense it circulates about the axis, and parts of
//! its kinetic energy.

use super::circulation::Whirling;
use super::sections::{Displacements, Sections, inner};
use crate::emitted::Interpolant;
use crate::model::{Circulating, Composition, Motion, Uniform};
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::{Padded, padded, spread};
use crate::scene::frames::directions::Direction;
use crate::space::{Matrix, Vector, perpendicular};
use crate::system::State;

/// Sine of the angle to the axis up to which a line counts as a shaft along it: bent ones are shafts as well.
const SHAFT: f64 = 0.3;

/// Directions of the motions of a place: along, and the two ways across it.
struct Axes {
    along: Vector,
    across: [(Motion, Vector); 2],
}

impl Axes {
    /// Of a place that extends along `along`, in a system that turns about `axis`.
    fn new(along: Vector, axis: Option<Vector>) -> Self {
        let first = perpendicular(along);
        let second = along.cross(&first);
        let Some(axis) = axis else {
            return Self {
                along,
                across: [(Motion::Bending, first), (Motion::Bending, second)],
            };
        };
        let up = axis - axis.dot(&along) * along;
        if up.norm() < SHAFT {
            return Self {
                along,
                across: [(Motion::Lateral, first), (Motion::Lateral, second)],
            };
        }
        let up = 1.0 / up.norm() * up;
        Self {
            along,
            across: [(Motion::Flap, up), (Motion::Lag, along.cross(&up))],
        }
    }
}

impl Axes {
    /// Whether the place is one of a shaft along the axis.
    fn is_shaft(&self) -> bool {
        self.across[0].0 == Motion::Lateral
    }

    /// One of three parts of the motion of a vector of the axis.
    fn of_axis(&self, change: &Displaced, slot: usize) -> (Motion, Displaced) {
        match self.across.get(slot) {
            Some(&(motion, direction)) => (motion, along(change, direction)),
            None => (Motion::Axial, along(change, self.along)),
        }
    }

    /// One of three parts of the motion of a vector of the section, which is `own` without it: what tilts it belongs to the deflection along it.
    fn of_section(&self, change: &Displaced, own: Vector, slot: usize) -> (Motion, Displaced) {
        let tilt = along(change, self.along);
        match self.across.get(slot) {
            Some(&(motion, direction)) => {
                let part = own.dot(&direction).abs() / own.norm();
                (motion, tilt.map(|value| part * value))
            }
            None => (Motion::Torsion, each(|part| change[part] - tilt[part])),
        }
    }
}

/// Real and imaginary part of a displacement, inertial axes.
type Displaced = [Vector; 2];

fn each(f: impl Fn(usize) -> Vector) -> Displaced {
    [f(0), f(1)]
}

fn along(displaced: &Displaced, direction: Vector) -> Displaced {
    displaced.map(|value| value.dot(&direction) * direction)
}

/// Sums of energies, twice the kinetic energy over the square of the frequency.
#[derive(Default)]
struct Energies {
    motions: [f64; Motion::ALL.len()],
    bodies: Vec<(String, f64)>,
    whirling: Whirling,
}

impl MeshScene {
    /// What moves across the axis of the rotation.
    pub(crate) fn circulating_of(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Option<Circulating> {
        self.energies(at, state, shape).whirling.sums()
    }

    /// Parts of the kinetic energy in the axes that turn with the system.
    pub(crate) fn composition_of(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Composition {
        let Energies { motions, bodies, .. } = self.energies(at, state, shape);
        Composition::new(&motions, bodies)
    }

    fn energies(&mut self, at: &Uniform, state: &State, shape: &[[f64; 2]]) -> Energies {
        let spin = self.rotation(at).unwrap_or_default();
        let speed = spin.velocity.norm() * at.speed();
        let axis = (speed > 0.0).then(|| 1.0 / spin.velocity.norm() * spin.velocity);
        self.load_uniform(at, state);
        let full = [0, 1].map(|part| {
            let unknowns: Vec<f64> = shape.iter().map(|value| value[part]).collect();
            let mut full = vec![0.0; self.layout.components()];
            self.layout.expand(&unknowns, &mut full);
            full
        });
        let mut energies = Energies {
            whirling: Whirling::about(axis),
            ..Energies::default()
        };
        for index in 0..self.bodies.len() {
            self.body_energies(index, axis.map(|axis| (axis, spin.point)), &full, &mut energies);
        }
        for free in 0..self.frames.free.len() {
            self.frame_energies(free, axis.map(|axis| (axis, spin.point)), &full, &mut energies);
        }
        energies
    }

    /// Shift (inertial axes) and turn (its own axes) of a free frame.
    fn moved(&self, free: usize, full: &[Vec<f64>; 2]) -> [Displaced; 2] {
        let frame = &self.frames.free[free];
        let first = self.layout.vector_components() + frame.first;
        let sum = |part: usize, pick: fn(&Direction) -> Vector| {
            let own = &full[part][first..][..frame.count()];
            let parts = frame.directions.iter().zip(own);
            parts.fold(Vector::zeros(), |sum, (direction, &value)| {
                sum + value * pick(direction)
            })
        };
        [
            each(|part| sum(part, |direction| direction.shift)),
            each(|part| sum(part, |direction| direction.turn)),
        ]
    }

    fn body_energies(
        &self,
        index: usize,
        spun: Option<(Vector, Vector)>,
        full: &[Vec<f64>; 2],
        energies: &mut Energies,
    ) {
        let axis = spun.map(|(axis, _)| axis);
        let body = &self.bodies[index];
        let (mass, spec) = (&body.whole_mass, &body.spec);
        let frame = &self.buffers.frames[body.frame];
        let moved = self.frames.free_of[body.frame].map(|free| self.moved(free, full));
        let [shift, turn] = moved.unwrap_or([[Vector::zeros(); 2]; 2]);
        let first = self.layout.offset(body.first_vector);
        let vector = |values: &[f64], place: usize| -> Vector {
            let [x, y, z, _]: Padded = spread(spec.axes, &values[first..], place);
            Vector::new(x, y, z)
        };
        // The tangent at every node.
        let tangents: Vec<Option<Vector>> = (0..mass.vectors())
            .map(|place| {
                let (node, local) = spec.locate(place);
                let is_slope = spec.nodal[local].of == Interpolant::Position && spec.nodal[local].order == 1;
                is_slope.then(|| (node, frame.direction_to_inertial(vector(&self.buffers.q, place))))
            })
            .fold(Vec::new(), |mut tangents, slope| {
                if let Some((node, slope)) = slope {
                    tangents.resize(tangents.len().max(node + 1), None);
                    tangents[node] = Some(1.0 / slope.norm() * slope);
                }
                tangents
            });
        let ends = [0, spec.meshed_vectors() - 1].map(|place| spec.locate(place).0);
        let chord = ends
            .map(|node| tangents.get(node).copied().flatten())
            .into_iter()
            .flatten()
            .next();
        let (mut changes, mut ways) = (Vec::new(), Vec::new());
        let (mut own, mut is_axis) = (Vec::new(), Vec::new());
        for place in 0..mass.vectors() {
            let (node, local) = spec.locate(place);
            let mut q = vector(&self.buffers.q, place);
            if mass.is_position(place) {
                q += body.offset;
            }
            changes.push(
                each(|part| {
                    let mut change = vector(&full[part], place) + turn[part].cross(&q);
                    change = frame.direction_to_inertial(change);
                    if mass.is_position(place) {
                        change += shift[part];
                    }
                    change
                })
                .map(padded),
            );
            let tangent = tangents.get(node).copied().flatten().or(chord);
            ways.push(Axes::new(tangent.unwrap_or(Vector::x()), axis));
            // The normal of a section moves as the slope does.
            let is_normal = place >= spec.meshed_vectors();
            is_axis.push(is_normal || spec.nodal[local].of == Interpolant::Position);
            own.push(frame.direction_to_inertial(q));
        }
        let sections = Sections::new(mass, &is_axis);
        let centres = sections.centres(&changes);
        let image = sections.image_of_axis(&centres);
        let about = sections.image_of_sections(&changes);
        // What stands beside a rotor is seen as it moves.
        if moved.is_some() || frame.spin != Vector::zeros() {
            for (centre, image) in centres.iter().zip(&image) {
                energies.whirling.add(&short(centre), &short(image));
            }
            if let Some((_, point)) = spun {
                let from_axis = frame.position - point;
                for place in (0..mass.vectors()).filter(|&place| is_axis[place] && !ways[place].is_shaft()) {
                    let image_here = short(&image[place]);
                    match mass.is_position(place) {
                        true => energies.whirling.add_force(from_axis + own[place], &image_here),
                        false => energies
                            .whirling
                            .add_moment(image_here.map(|image| own[place].cross(&image))),
                    }
                    energies
                        .whirling
                        .add_beside(inner(&centres[place..=place], &image[place..=place]));
                }
            }
            let nodes = (0..mass.vectors()).map(|place| spec.locate(place).0);
            let places = nodes.enumerate().filter(|&(place, _)| !is_axis[place]);
            let tilts = shaft_tilts(places, &ways, &own, [&changes, &about]);
            for [tilt, image] in &tilts {
                energies.whirling.add(tilt, image);
            }
        }
        let total = inner(&centres, &image) + inner(&changes, &about);
        energies.whirling.add_whole(total);
        for slot in 0..3 {
            let part = |place: usize| {
                let axes = &ways[place];
                if is_axis[place] {
                    return axes.of_axis(&short(&centres[place]), slot);
                }
                axes.of_section(&short(&changes[place]), own[place], slot)
            };
            let (motions, moved): (Vec<Motion>, Vec<[Padded; 2]>) = (0..mass.vectors())
                .map(part)
                .map(|(motion, moved)| (motion, moved.map(padded)))
                .unzip();
            let images = [sections.image_of_axis(&moved), sections.image_of_sections(&moved)];
            for place in 0..mass.vectors() {
                let image = &images[usize::from(!is_axis[place])][place];
                energies.motions[motions[place] as usize] += inner(&moved[place..=place], &[*image]);
            }
        }
        energies.bodies.push((spec.label(), total));
    }

    /// What a free frame has of mass itself.
    fn frame_energies(
        &self,
        free: usize,
        axis: Option<(Vector, Vector)>,
        full: &[Vec<f64>; 2],
        energies: &mut Energies,
    ) {
        let frame = &self.frames.free[free];
        let (rigid, motion) = (&frame.spec.rigid, &self.buffers.frames[frame.spec.frame]);
        let has_inertia = rigid.inertia != Matrix::zeros();
        if rigid.mass == 0.0 && !has_inertia {
            return;
        }
        let [shift, within] = self.moved(free, full);
        let turn = within.map(|turn| motion.direction_to_inertial(turn));
        let centre = if rigid.mass > 0.0 {
            motion.direction_to_inertial(1.0 / rigid.mass * rigid.moment)
        } else {
            Vector::zeros()
        };
        let centred = each(|part| shift[part] + turn[part].cross(&centre));
        // Inertia about the centre, of the rotation alone.
        let spun = each(|part| {
            let arm = motion.direction_to_frame(centre);
            let about = rigid.inertia * within[part];
            let carried = rigid.mass * arm.cross(&within[part].cross(&arm));
            motion.direction_to_inertial(about - carried)
        });
        // Mass times the square of the distance of its parts from the centre, of all three directions.
        let gyration = 0.5 * rigid.inertia.trace() - rigid.mass * centre.norm_squared();
        let along_axis = axis.map_or(Vector::x(), |(axis, point)| {
            let away = motion.position + centre - point;
            let out = away - away.dot(&axis) * axis;
            // The axis goes through what reaches as far: no unbalance makes a blade of a disc.
            if rigid.mass * out.norm_squared() > gyration.max(0.0) {
                1.0 / out.norm() * out
            } else {
                axis
            }
        });
        let axes = Axes::new(along_axis, axis.map(|(axis, _)| axis));
        let [first, second] = axes.across;
        let energy = |displaced: &Displaced, image: &Displaced, direction: Vector| -> f64 {
            let parts = displaced.iter().zip(image);
            parts
                .map(|(value, image)| value.dot(&direction) * image.dot(&direction))
                .sum()
        };
        let own = centred.map(|value| rigid.mass * value);
        let mut total = 0.0;
        // A rotation about one way across moves what lies along in the other.
        let parts = [
            (Motion::Axial, energy(&centred, &own, axes.along)),
            (first.0, energy(&centred, &own, first.1)),
            (second.0, energy(&centred, &own, second.1)),
            (Motion::Torsion, energy(&turn, &spun, axes.along)),
            (first.0, energy(&turn, &spun, second.1)),
            (second.0, energy(&turn, &spun, first.1)),
        ];
        for (motion, value) in parts {
            // At rest no direction is another than the others.
            let motion = if axis.is_none() { Motion::Translation } else { motion };
            energies.motions[motion as usize] += value.max(0.0);
            total += value.max(0.0);
        }
        energies.whirling.add(&centred, &own);
        if let Some((axis, point)) = axis {
            if along_axis != axis {
                energies.whirling.add_force(motion.position + centre - point, &own);
                energies.whirling.add_moment(spun);
                energies.whirling.add_beside(total);
            }
            // Points on both sides of it see the tilt: along the axis where it lies there, as of a disc, else outwards, as of a blade.
            let tilted = turn.map(|turn| turn.cross(&along_axis));
            energies.whirling.add(&tilted, &tilted.map(|value| gyration * value));
        }
        energies.whirling.add_whole(total);
        energies
            .bodies
            .push((self.parts.frame_name(frame.spec.frame).to_string(), total));
    }
}

/// A section of a shaft is a disc: of each node what a unit vector along the axis does that tilts with its section, and the product with the
/// mass about the centre, from those of the vectors of the sections; of these the places and nodes are given.
fn shaft_tilts(
    places: impl Iterator<Item = (usize, usize)>,
    ways: &[Axes],
    own: &[Vector],
    moved: [&Displacements; 2],
) -> Vec<[Displaced; 2]> {
    let mut tilts: Vec<[Displaced; 2]> = Vec::new();
    for (place, node) in places.filter(|&(place, _)| ways[place].is_shaft()) {
        tilts.resize(tilts.len().max(node + 1), [[Vector::zeros(); 2]; 2]);
        let direction = 1.0 / own[place].norm() * own[place];
        for (tilt, moved) in tilts[node].iter_mut().zip(moved) {
            for (tilt, moved) in tilt.iter_mut().zip(short(&moved[place])) {
                *tilt -= moved.dot(&ways[place].along) * direction;
            }
        }
    }
    tilts
}

fn short(displaced: &[Padded; 2]) -> Displaced {
    displaced.map(|[x, y, z, _]| Vector::new(x, y, z))
}
