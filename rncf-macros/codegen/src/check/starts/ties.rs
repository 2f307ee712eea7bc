//! Whether every free frame is determined: one without mass of its own follows from exactly as many
//! conditions as it has motions (THEORY 2 and 6), else the equations of motion are singular. How often a joint
//! in a loop ties it is known at run time only: such a frame is left to it.
//!
//! The conditions are differentiated with respect to the motions of the frame alone, its bodies
//! staying where they are, at t = 0 with the parameters' defaults.

use super::start::{Pose, Start, normals};
use crate::check::fold::with_defaults;
use crate::check::values::arithmetic::{Vector, add, cross, dot, norm, scale, subtract};
use crate::check::values::eigen::symmetric;
use crate::check::values::words::AXES;
use crate::check::{Check, say};
use crate::elements::Library;
use crate::errors::Area;
use crate::model::{
    BodyId, Constraint, Expr, Fidelity, FrameId, FrameTie, Free, Held, Joint, JointKind, Line, Location, Marker,
    MarkerId, Model, Motions, Observable, Space,
};
use crate::parse::tree::{ItemKind, Statement};
use crate::symbolic::Time;

/// Gradient of a condition with respect to the motions of a frame; unused ones are zero.
type Row = [f64; 6];

/// Squares of sines of angles between conditions below which they count as dependent.
const DEPENDENT: f64 = 1e-14;

/// Relative size of what counts as round-off in one condition.
const ROUND_OFF: f64 = 1e-12;

/// Thickness of a rigid body with sections, in lengths: it has inertia about its axis, too.
const THICKNESS: f64 = 0.1;

/// What counts as all of a motion.
const WHOLE: f64 = 1.0 - 1e-6;

/// A motion of a frame: velocity of its origin and angular velocity, frame axes.
#[derive(Clone, Copy)]
struct Mode {
    shift: Vector,
    turn: Vector,
}

/// Conditions that belong together.
struct Tie {
    name: String,
    rows: Vec<Row>,
}

/// Why a free frame is not determined.
#[derive(Clone, Debug, PartialEq)]
pub enum Untied {
    /// It carries neither bodies nor mass.
    Empty,
    /// A joint, or what it follows of a body, hold it a second time.
    Twice {
        /// Name of the joint or body.
        tie: String,
    },
    /// Motions that nothing holds, in words.
    Loose {
        /// E.g. `turning about the x axis`.
        motions: String,
    },
}

/// Whether a free frame is determined.
pub fn check(model: &Model, library: &Library, frame: FrameId) -> Result<(), Untied> {
    let free = model.frames[frame.0].free.as_ref();
    let Some(free) = free.filter(|free| free.motions != Motions::State) else {
        return Ok(());
    };
    let frame = Frame::new(model, library, frame, free);
    if frame.bodies().next().is_none() && free.parts.is_empty() {
        return Err(Untied::Empty);
    }
    if frame.is_tied_in_loops() || frame.moves_with_an_import() {
        return Ok(());
    }
    let (mass, scales) = frame.mass();
    let carries_mass = mass.iter().flatten().any(|entry| *entry != 0.0);
    let ties = frame.joints(&scales);
    if !carries_mass && let Some(tie) = tied_twice(&ties) {
        return Err(Untied::Twice { tie: tie.name.clone() });
    }
    let rows = ties.into_iter().flat_map(|tie| tie.rows);
    let rows: Vec<Row> = rows.chain(frame.constraints(&scales)).collect();
    let loose = null_space(&mass, &rows, frame.modes.len());
    if loose.is_empty() {
        return Ok(());
    }
    let motions = frame.describe(&loose, &scales);
    Err(Untied::Loose { motions })
}

impl Check<'_> {
    /// Checks all free frames; there must be no mistake so far.
    pub(in crate::check) fn ties(&mut self) {
        for at in 0..self.model.frames.len() {
            if let Err(untied) = check(&self.model, &self.library, FrameId(at)) {
                self.untied(FrameId(at), &untied);
            }
        }
    }

    fn untied(&mut self, frame: FrameId, untied: &Untied) {
        let declared = &self.model.frames[frame.0];
        let name = declared.name.as_str();
        let Some(place) = self.names.get(name).map(|item| Area::from(item.name.span)) else {
            return;
        };
        let mut bodies = self.model.bodies.iter().filter(|body| body.frame == frame);
        let is_body = declared.free.as_ref().is_some_and(|free| free.is_body);
        let (area, message) = match (untied, bodies.next()) {
            (Untied::Empty, _) => (place, say::carries_nothing(name)),
            (Untied::Twice { tie }, _) => {
                let (area, what) = self.tie(tie);
                (area.unwrap_or(place), say::tied_twice(what, tie, name))
            }
            (Untied::Loose { motions }, Some(body)) if !is_body => {
                let is_rigid = !body.fidelity.deforms() && bodies.all(|body| !body.fidelity.deforms());
                let message = if is_rigid {
                    say::rigid_lacks_inertia(name, motions)
                } else {
                    say::not_held(&body.name, motions, name)
                };
                (place, message)
            }
            (Untied::Loose { motions }, _) => (place, say::lacks_inertia(name, motions)),
        };
        self.errors.at(area, message);
    }

    /// Where a joint has its name, or a body what its frame follows.
    fn tie(&self, name: &str) -> (Option<Area>, &'static str) {
        let Some(item) = self.names.get(name) else {
            return (None, "the joint");
        };
        let ItemKind::Body { statements, .. } = &item.kind else {
            return (Some(item.name.span.into()), "the joint");
        };
        let word = statements.iter().find_map(|statement| match statement {
            Statement::FrameTie { word } => Some(word),
            _ => None,
        });
        let what = match word {
            Some(word) if word.text == FrameTie::Chord.word() => "the chord of",
            _ => "the mean axes of",
        };
        (word.map(|word| word.span.into()), what)
    }
}

/// A free frame with what it needs for the count.
struct Frame<'m> {
    start: Start<'m>,
    library: &'m Library,
    id: FrameId,
    free: &'m Free,
    pose: Pose,
    modes: Vec<Mode>,
}

impl<'m> Frame<'m> {
    fn new(model: &'m Model, library: &'m Library, id: FrameId, free: &'m Free) -> Self {
        let start = Start::new(model);
        let pose = start.pose(id);
        let modes = modes(&free.motions);
        Self {
            start,
            library,
            id,
            free,
            pose,
            modes,
        }
    }

    fn bodies(&self) -> impl Iterator<Item = (&'m crate::model::Body, BodyId)> {
        let id = self.id;
        let bodies = self.start.model.bodies.iter().enumerate();
        bodies
            .filter(move |(_, body)| body.frame == id)
            .map(|(at, body)| (body, BodyId(at)))
    }

    /// Whether joints in loops tie the frame.
    fn is_tied_in_loops(&self) -> bool {
        let joints = &self.start.model.joints;
        joints
            .iter()
            .any(|joint| joint.frame == self.id && joint.repeat.is_some())
    }

    /// Whether a body from a file has its inertia in the frame: it does not deform, or no joint holds it there.
    fn moves_with_an_import(&self) -> bool {
        let mut joints = self.start.model.joints.iter();
        let mut is_held = |id: BodyId| joints.any(|joint| joint.body == id && joint.frame == self.id);
        let mut imported = self.bodies().filter(|(body, _)| matches!(body.line, Line::Imported(_)));
        imported.any(|(body, id)| !body.fidelity.deforms() || !is_held(id))
    }

    /// Whether a body has sections, so that it can be held, and has inertia, against turning about its axis.
    fn has_section(&self, body: BodyId) -> bool {
        let element = self.start.model.bodies[body.0].element;
        self.library.elements[element.0].has_section()
    }

    /// Length that makes shifts and turns comparable, m.
    fn length(&self) -> f64 {
        let extent = |(_, id): (_, BodyId)| {
            let ends = [Location::Start, Location::End].map(|at| self.start.place(id, &at).0);
            norm(subtract(ends[1], ends[0]))
        };
        let longest = self.bodies().map(extent).fold(0.0, f64::max);
        if longest > 0.0 { longest } else { 1.0 }
    }

    /// Mass matrix of what is rigid in the frame, each motion scaled to a unit diagonal where it
    /// has one, and the scales of the motions.
    fn mass(&self) -> ([Row; 6], Row) {
        let mut mass = [[0.0; 6]; 6];
        for part in &self.free.parts {
            let center = self.start.vector(&part.center);
            let [xx, yy, zz, xy, xz, yz] = part.inertia.each_ref().map(|entry| self.start.value(entry));
            let inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            self.add_mass(&mut mass, self.start.value(&part.mass), center, inertia);
        }
        for (_, id) in self.bodies().filter(|(body, _)| body.fidelity == Fidelity::Point) {
            self.add_mass(&mut mass, 1.0, self.centre(id), [[0.0; 3]; 3]);
        }
        for (_, id) in self.bodies().filter(|(body, _)| body.fidelity == Fidelity::Rigid) {
            let (end, length) = (self.start.place(id, &Location::End).0, self.length());
            let places = [0.0, 0.25, 0.5, 0.75].map(|part| Location::At(Box::new(Expr::Number(part * length))));
            let places = places.map(|at| self.start.place(id, &at).0);
            let ends = [Location::Start, Location::End];
            let arms = ends.iter().flat_map(|at| {
                let axes = self.start.initial_section(id, at);
                axes.map(|axis| add(self.start.place(id, at).0, scale(THICKNESS * length, axis)))
            });
            let arms: Vec<Vector> = arms.filter(|_| self.has_section(id)).collect();
            for place in places.into_iter().chain([end]).chain(arms) {
                self.add_mass(&mut mass, 1.0, place, [[0.0; 3]; 3]);
            }
        }
        let length = self.length();
        let scales: Row = std::array::from_fn(|k| match (mass[k][k], self.modes.get(k)) {
            (own, _) if own > 0.0 => own.sqrt(),
            (_, Some(mode)) if norm(mode.shift) > 0.0 => 1.0 / length,
            _ => 1.0,
        });
        for (i, row) in mass.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry /= scales[i] * scales[j];
            }
        }
        (mass, scales)
    }

    /// Centre of a body's axis. What is round-off of its length is zero: there is no inertia about it.
    fn centre(&self, id: BodyId) -> Vector {
        const POINTS: usize = 64;
        let length = self.start.length(id);
        let sum = (0..POINTS).fold([0.0; 3], |sum, at| {
            let x = (at as f64 + 0.5) / POINTS as f64 * length;
            add(sum, self.start.place(id, &Location::At(Box::new(Expr::Number(x)))).0)
        });
        let centre = scale(1.0 / POINTS as f64, sum);
        centre.map(|component| {
            if component.abs() > 1e-9 * length {
                component
            } else {
                0.0
            }
        })
    }

    fn add_mass(&self, mass: &mut [Row; 6], own: f64, center: Vector, inertia: [[f64; 3]; 3]) {
        let velocity = |mode: &Mode| add(mode.shift, cross(mode.turn, center));
        for (i, a) in self.modes.iter().enumerate() {
            for (j, b) in self.modes.iter().enumerate() {
                let turned = inertia.map(|row| dot(row, b.turn));
                mass[i][j] += own * dot(velocity(a), velocity(b)) + dot(a.turn, turned);
            }
        }
    }

    /// A row of the change of something with each motion, as a sum of products of vectors; what is
    /// round-off of them is zero.
    fn row(&self, scales: &Row, change: impl Fn(&Mode) -> Vec<(Vector, Vector)>) -> Row {
        let mut row = [0.0; 6];
        for (k, mode) in self.modes.iter().enumerate() {
            let (mut sum, mut size) = (0.0, 0.0);
            for (a, b) in change(mode) {
                sum += dot(a, b);
                size += norm(a) * norm(b);
            }
            if sum.abs() > ROUND_OFF * size || !sum.is_finite() {
                row[k] = sum / scales[k];
            }
        }
        row
    }

    /// Conditions on the nodal vectors of its bodies: joints to the frame itself, what it follows.
    fn joints(&self, scales: &Row) -> Vec<Tie> {
        let model = self.start.model;
        let flexible = |body: BodyId| {
            let body = &model.bodies[body.0];
            body.frame == self.id && body.fidelity.deforms()
        };
        let joints = model
            .joints
            .iter()
            .filter(|joint| joint.frame == self.id && flexible(joint.body));
        let mut ties: Vec<Tie> = joints.map(|joint| self.joint(joint, scales)).collect();
        for (body, id) in self.bodies() {
            if body.tie != FrameTie::Joints && flexible(id) {
                let rows = (0..self.modes.len()).map(|k| std::array::from_fn(|j| f64::from(j == k)));
                ties.push(Tie {
                    name: body.name.clone(),
                    rows: rows.collect(),
                });
            }
        }
        ties
    }

    /// `p - const = 0` and `n . d - const = 0`, in frame axes: a point or direction that stays where it
    /// is in space moves backwards in the frame. A direction is a slope, or the axis of a section.
    fn joint(&self, joint: &Joint, scales: &Row) -> Tie {
        let (there, tangent) = self.start.initial_place(joint.body, &joint.at);
        let place = joint.point.as_ref().map_or(there, |point| self.start.vector(point));
        let space = self.start.model.bodies[joint.body.0].space;
        let position = |along: Vector| {
            self.row(scales, |mode| {
                vec![(along, mode.shift), (along, cross(mode.turn, place))]
            })
        };
        let [y, z] = self.start.initial_section(joint.body, &joint.at);
        let direction = |along: Vector, of: Vector| self.row(scales, |mode| vec![(along, cross(mode.turn, of))]);
        let positions = || space.axes().iter().map(|&axis| position(axis_vector(axis)));
        let rows = match joint.kind {
            JointKind::Pin => positions().collect(),
            // The norm of the slope is no motion of the frame.
            JointKind::Clamp | JointKind::ClampFull => {
                let turns: Vec<(Vector, Vector)> = match (space, self.has_section(joint.body)) {
                    (Space::Spatial, true) => vec![(cross(y, z), y), (cross(y, z), z), (z, y)],
                    _ => across(space, tangent).map(|normal| (normal, tangent)).collect(),
                };
                let turns = turns.into_iter().map(|(normal, held)| direction(normal, held));
                positions().chain(turns).collect()
            }
            JointKind::Hold {
                of: Held::Position,
                axis,
            } => vec![position(axis_vector(axis))],
            JointKind::Hold { of, axis } => {
                let held = match of {
                    Held::SectionY => y,
                    Held::SectionZ => z,
                    Held::Slope | Held::Position => tangent,
                };
                vec![direction(axis_vector(axis), held)]
            }
        };
        Tie {
            name: joint.name.clone(),
            rows,
        }
    }

    /// Rows of constraints that change when the frame alone moves.
    fn constraints(&self, scales: &Row) -> Vec<Row> {
        let model = self.start.model;
        let constraints = model.constraints.iter();
        let always = constraints.filter(|constraint| constraint.absolute.is_none());
        always
            .flat_map(|constraint| self.constraint(constraint, scales))
            .collect()
    }

    fn constraint(&self, constraint: &Constraint, scales: &Row) -> Vec<Row> {
        let model = self.start.model;
        let moves = |marker: &MarkerId| model.markers[marker.0].frame() == Some(self.id);
        if !constraint.markers.iter().any(moves) {
            return Vec::new();
        }
        let rows = constraint.rows.iter().map(|(_, expr)| {
            let gradient = self.gradient(expr);
            self.row(scales, |mode| {
                let terms = gradient.iter();
                terms
                    .map(|(marker, along)| (*along, self.change(*marker, mode)))
                    .collect()
            })
        });
        rows.filter(|row| row.iter().all(|entry| entry.is_finite())).collect()
    }

    /// Change of a marker when the frame alone moves, inertial axes.
    fn change(&self, marker: MarkerId, mode: &Mode) -> Vector {
        let declared = &self.start.model.markers[marker.0];
        if declared.frame() != Some(self.id) {
            return [0.0; 3];
        }
        let turn = self.pose.direction(mode.turn);
        match declared {
            Marker::Turn { .. } => [0.0; 3],
            Marker::Angle { .. } => [norm(turn), 0.0, 0.0],
            _ if self.start.model.is_point(marker) => {
                let arm = subtract(self.start.marker(marker), self.pose.origin);
                add(self.pose.direction(mode.shift), cross(turn, arm))
            }
            _ => cross(turn, self.start.marker(marker)),
        }
    }

    /// Gradient of an expression with respect to the markers that move with the frame.
    fn gradient(&self, expr: &Expr) -> Vec<(MarkerId, Vector)> {
        let Some(expr) = specialised(self.start.model, expr) else {
            return Vec::new();
        };
        let mut time = Time::new(self.start.model);
        let root = time.expression(&expr);
        let observed = time.observed.clone();
        let mut symbols = Vec::new();
        let mut inputs = std::collections::HashMap::new();
        for (observable, symbol) in observed {
            let Observable::Marker { marker, component, .. } = observable else {
                return Vec::new();
            };
            inputs.insert(symbol, self.start.marker(marker)[component]);
            symbols.push((marker, component, symbol));
        }
        let mut gradient: Vec<(MarkerId, Vector)> = Vec::new();
        for (marker, component, symbol) in symbols {
            let partial = time.graph.partial(root, symbol);
            let mut along = [0.0; 3];
            along[component] = time.graph.evaluate(&[partial], &inputs)[0];
            gradient.push((marker, along));
        }
        gradient
    }

    /// The motions that nothing holds, in words.
    fn describe(&self, left: &[Row], scales: &Row) -> String {
        let whole = |k: &usize| left.iter().map(|row| row[*k] * row[*k]).sum::<f64>() > WHOLE;
        let mut words: Vec<String> = (0..self.modes.len())
            .filter(whole)
            .map(|k| say_mode(&self.modes[k]))
            .collect();
        if words.len() == self.modes.len() && words.len() > 1 {
            return "any motion".into();
        }
        if words.is_empty() {
            words.extend(left.first().map(|row| self.say_mixture(row, scales)));
        }
        match words.split_last() {
            Some((last, [])) => last.clone(),
            Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
            None => String::new(),
        }
    }

    fn say_mixture(&self, row: &Row, scales: &Row) -> String {
        let (mut shift, mut turn) = ([0.0; 3], [0.0; 3]);
        for (k, mode) in self.modes.iter().enumerate() {
            shift = add(shift, scale(row[k] / scales[k], mode.shift));
            turn = add(turn, scale(row[k] / scales[k], mode.turn));
        }
        say_mode(&if norm(turn) * self.length() > 1e-6 * norm(shift) {
            Mode { shift: [0.0; 3], turn }
        } else {
            Mode { shift, turn: [0.0; 3] }
        })
    }
}

/// An expression without parameters, time and motions: at t = 0, with defaults.
fn specialised(model: &Model, expr: &Expr) -> Option<Expr> {
    if let Some(value) = with_defaults(model, expr, 0.0) {
        return value.is_finite().then_some(Expr::Number(value));
    }
    // A leaf without a value at t = 0 has none; what is observed stays.
    let has_none = expr.parts().is_empty() && !matches!(expr, Expr::Observed(_));
    if has_none || matches!(expr, Expr::Motion(..)) {
        return None;
    }
    expr.with_parts(&mut |part| specialised(model, part))
}

fn axis_vector(axis: usize) -> Vector {
    std::array::from_fn(|k| f64::from(k == axis))
}

/// Directions across a tangent: two, or the one in the plane.
fn across(space: Space, tangent: Vector) -> impl Iterator<Item = Vector> {
    let [first, second] = match space {
        Space::Spatial => normals(tangent).map(Some),
        Space::Planar { normal } => [Some(cross(axis_vector(normal), tangent)), None],
    };
    first.into_iter().chain(second)
}

fn modes(motions: &Motions) -> Vec<Mode> {
    let shift = |axis: usize| Mode {
        shift: axis_vector(axis),
        turn: [0.0; 3],
    };
    let turn = |turn: Vector| Mode { shift: [0.0; 3], turn };
    let turns = || (0..3).map(|axis| turn(axis_vector(axis)));
    let shifts = |normal: usize| Space::Planar { normal }.axes().iter().map(|&axis| shift(axis));
    match *motions {
        Motions::Spatial => (0..3).map(shift).chain(turns()).collect(),
        Motions::Planar { normal } => shifts(normal).chain([turn(axis_vector(normal))]).collect(),
        Motions::Turning => turns().collect(),
        Motions::Hinged { axis } => vec![turn(axis)],
        Motions::Shifting => (0..3).map(shift).collect(),
        Motions::ShiftingPlanar { normal } => shifts(normal).collect(),
        Motions::State => Vec::new(),
    }
}

fn say_mode(mode: &Mode) -> String {
    let (word, vector) = if norm(mode.turn) > 0.0 {
        ("turning about", mode.turn)
    } else {
        ("moving along", mode.shift)
    };
    let vector = scale(1.0 / norm(vector), vector);
    match (0..3).find(|&axis| vector[axis].abs() > WHOLE) {
        Some(axis) => format!("{word} the {} axis", AXES[axis]),
        None => {
            let [x, y, z] = vector.map(|x| (x * 100.0).round() / 100.0 + 0.0);
            format!("{word} the direction [{x}, {y}, {z}]")
        }
    }
}

/// Sum of `g g^T` over unit rows.
fn gram(rows: &[Row]) -> [Row; 6] {
    let size = |row: &Row| row.iter().map(|x| x * x).sum::<f64>();
    let mut gram = [[0.0; 6]; 6];
    for row in rows.iter().filter(|row| size(row) > 0.0) {
        for i in 0..6 {
            for j in 0..6 {
                gram[i][j] += row[i] * row[j] / size(row);
            }
        }
    }
    gram
}

fn rank(rows: &[Row]) -> usize {
    symmetric(gram(rows))
        .0
        .iter()
        .filter(|value| **value > DEPENDENT)
        .count()
}

/// The first tie that holds what others before it hold already.
fn tied_twice(ties: &[Tie]) -> Option<&Tie> {
    let mut rows: Vec<Row> = Vec::new();
    let mut held = 0;
    for tie in ties {
        rows.extend(&tie.rows);
        held += rank(&tie.rows);
        if rank(&rows) < held {
            return Some(tie);
        }
    }
    None
}

/// Orthonormal motions without mass that change no row.
fn null_space(mass: &[Row; 6], rows: &[Row], motions: usize) -> Vec<Row> {
    let mut all = gram(rows);
    for (to, from) in all.iter_mut().zip(mass) {
        for (to, from) in to.iter_mut().zip(from) {
            *to += from;
        }
    }
    // Motions that the frame does not have count as held.
    for (k, row) in all.iter_mut().enumerate().skip(motions) {
        row[k] = 1.0;
    }
    let (values, vectors) = symmetric(all);
    (0..6)
        .filter(|&at| values[at] < DEPENDENT)
        .map(|at| std::array::from_fn(|k| vectors[k][at]))
        .collect()
}
