//! Motions of prescribed frames: poses as expressions of t, their derivatives, and kinks.

use std::collections::HashMap;

use super::kernel::Kernel;
use crate::elements::{Coefficient, Library};
use crate::model::{Between, Body, Expr, FrameId, FrameTie, Model, Motions, RepeatId};
use crate::symbolic::{Id, Node, Time};

/// How often what moves in a prescribed way is differentiated: the jerk is read by constraints on markers, on their
/// own jerk level, and by ties of frames alone.
pub fn highest_derivative(model: &Model) -> usize {
    let constrained = !model.constraints.is_empty() || model.bodies.iter().any(|body| body.tie != FrameTie::Joints);
    if constrained { 3 } else { 2 }
}

/// Motion of a frame: pose, velocity, acceleration; spin and its derivative; where they are read, both jerks.
pub fn frame_kernel(model: &Model, frame: FrameId) -> Kernel {
    let mut time = Time::new(model);
    let (rotation, position) = time.pose(frame);
    let velocity = time.derivatives(&position);
    let acceleration = time.derivatives(&velocity);
    let spin = time.spin(frame);
    let spin_rate = time.derivatives(&spin);
    let mut vectors = vec![
        ("position", position),
        ("velocity", velocity),
        ("acceleration", acceleration),
        ("spin", spin),
        ("spin_rate", spin_rate),
    ];
    let highest = highest_derivative(model);
    if highest == 3 {
        let [jerk, spin_jerk] = [2, 4].map(|rate| time.derivatives(&vectors[rate].1));
        vectors.extend([("jerk", jerk), ("spin_jerk", spin_jerk)]);
    }
    let mut outputs = Vec::new();
    for (name, vector) in &vectors {
        outputs.extend(
            vector
                .iter()
                .enumerate()
                .map(|(i, &id)| (format!("motion.{name}[{i}]"), id)),
        );
    }
    outputs.retain(|&(_, id)| !time.graph.is_zero(id));
    for (i, row) in rotation.iter().enumerate() {
        let entries = row
            .iter()
            .enumerate()
            .map(|(j, &id)| (format!("motion.rotation[({i}, {j})]"), id));
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let differs = |j: usize, id: Id| time.graph.value(id) != Some(unit(i, j));
        outputs.extend(
            entries
                .enumerate()
                .filter(|&(j, (_, id))| differs(j, id))
                .map(|(_, entry)| entry),
        );
    }
    let declaration = &model.frames[frame.0];
    let count = if highest == 3 { "three" } else { "two" };
    let title = format!(
        "Motion of frame `{}` and its first {count} derivatives.",
        declaration.name
    );
    let mut kernel = time.kernel(
        format!("frame_{}", crate::model::identifier(&declaration.name)),
        title,
        outputs,
    );
    kernel
        .arguments
        .push("motion: &mut ::rncf::emitted::FrameMotion".to_string());
    kernel
        .bindings
        .push("*motion = ::rncf::emitted::FrameMotion::INERTIAL;".to_string());
    if !declaration.doc.is_empty() {
        kernel.doc.push(declaration.doc.clone());
    }
    kernel
}

impl Time<'_> {
    /// A kernel of the model's parameters and t that overwrites its outputs.
    pub fn kernel(self, name: String, title: String, outputs: Vec<(String, Id)>) -> Kernel {
        Kernel {
            name,
            doc: vec![title],
            arguments: vec![format!("model: &{}", self.model.name), "t: f64".to_string()],
            bindings: Vec::new(),
            graph: self.graph,
            points: None,
            outputs,
            assign: true,
        }
    }
}

/// What tells when motions and loads change their branches.
#[derive(Clone, Debug)]
pub struct Switches {
    /// Times of switches whose condition is linear in t, and their number.
    pub kinks: (Kernel, usize),
    /// Gaps, left less right side, of the other conditions that time alone decides, each with its time derivative, and
    /// their number.
    pub gaps: (Kernel, usize),
    /// Times at the rows of linear tables that are looked up at t, as texts of generated code where `model` is at hand.
    pub rows: Vec<String>,
    /// The same of conditions that differ between the repetitions of a loop.
    pub repeated: Vec<(RepeatId, Kernel, usize)>,
}

impl Switches {
    /// Whether no branch ever changes.
    pub fn is_empty(&self) -> bool {
        self.kinks.1 == 0 && self.gaps.1 == 0 && self.rows.is_empty() && self.repeated.is_empty()
    }
}

/// Finds all conditions that change with time. Those linear in t switch at `-g(0) / g'`; the others where an
/// integrator finds a root of their gap.
pub fn switches(model: &Model, library: &Library) -> Switches {
    let mut time = Time::new(model);
    let moved = motions(&mut time);
    let mut roots = [moved.clone(), timed_roots(&mut time)].concat();
    let bodies = model.bodies.iter();
    let timed = bodies.flat_map(|body| timed_coefficients(body, library));
    roots.extend(
        timed
            .filter_map(|one| one.scale.as_ref())
            .map(|scale| time.expression(scale)),
    );
    let of_time = time.gaps(&roots, &moved);
    let rows = time.rows(&roots, &moved);
    let zero = time.graph.zero();
    let start = HashMap::from([(time.t, zero)]);
    let (mut kinks, mut others) = (Vec::new(), Vec::new());
    for gap in of_time {
        let slope = time.graph.partial(gap, time.t);
        if time.graph.depends_on(gap, &[time.index]) {
            continue;
        }
        if time.graph.depends_on(slope, &[time.t]) || time.has_branches(gap) {
            others.push([gap, slope]);
            continue;
        }
        let first = time.graph.substitute(gap, &start);
        let ratio = time.graph.divide(first, slope);
        let kink = time.graph.negate(ratio);
        if !kinks.contains(&kink) {
            kinks.push(kink);
        }
    }
    let graph = time.graph.clone();
    let count = kinks.len();
    let outputs = kinks
        .into_iter()
        .enumerate()
        .map(|(index, id)| (format!("kinks[{index}]"), id))
        .collect();
    let title = "Times at which a derivative of a motion or load may jump (s).".to_string();
    let mut kernel = time.kernel("kinks".to_string(), title, outputs);
    kernel.arguments.remove(1);
    kernel.arguments.push(format!("kinks: &mut [f64; {count}]"));
    let gaps = Time {
        graph,
        ..Time::new(model)
    }
    .gap_kernel("gaps".to_string(), others);
    Switches {
        kinks: (kernel, count),
        gaps,
        rows,
        repeated: repeated_switches(model),
    }
}

/// Conditions that differ between the repetitions of loads per length, by loop.
fn repeated_switches(model: &Model) -> Vec<(RepeatId, Kernel, usize)> {
    let mut kernels = Vec::new();
    for at in 0..model.repeats.len() {
        let mut time = Time::new(model);
        let repeated = model
            .densities
            .iter()
            .filter(|density| model.bodies[density.body.0].repeat.is_some_and(|repeat| repeat.0 == at));
        let roots: Vec<Id> = repeated.flat_map(|density| time.vector(&density.components)).collect();
        let mut gaps = Vec::new();
        for gap in time.gaps(&roots, &[]) {
            if time.graph.depends_on(gap, &[time.index]) {
                gaps.push([gap, time.graph.partial(gap, time.t)]);
            }
        }
        if gaps.is_empty() {
            continue;
        }
        let (mut kernel, count) = time.gap_kernel(format!("gaps_of_loop_{at}"), gaps);
        kernel.arguments.insert(2, "index: f64".to_string());
        kernels.push((RepeatId(at), kernel, count));
    }
    kernels
}

/// Coefficients of a body's strain energy that change with time.
pub fn timed_coefficients<'l>(body: &Body, library: &'l Library) -> Vec<&'l Coefficient> {
    let element = &library.elements[body.element.0];
    let mut list = element.coefficients_in(body.space.dimension(), &body.options);
    list.retain(|one| one.is_timed());
    list
}

/// What moves in a prescribed way: frames, and what is constrained.
fn motions(time: &mut Time<'_>) -> Vec<Id> {
    let model = time.model;
    let mut roots = Vec::new();
    for (index, frame) in model.frames.iter().enumerate() {
        if frame.free.is_none() {
            let (rotation, position) = time.pose(FrameId(index));
            roots.extend(rotation.iter().flatten().copied().chain(position));
        }
    }
    for (_, row) in model.constraints.iter().flat_map(|constraint| &constraint.rows) {
        roots.push(time.expression(row));
    }
    roots
}

/// All else that time may act on beside strain energies.
fn timed_roots(time: &mut Time<'_>) -> Vec<Id> {
    let model = time.model;
    let mut roots = Vec::new();
    for load in &model.loads {
        roots.extend(time.vector(load.kind.components()));
    }
    for density in &model.densities {
        roots.extend(time.vector(&density.components));
    }
    for (_, components) in model.distributed.iter().flat_map(|load| &load.forces) {
        roots.extend(time.vector(components));
    }
    for force in &model.forces {
        for components in &force.components {
            roots.extend(time.vector(components));
        }
        roots.extend(force.energy.iter().map(|energy| time.expression(energy)));
    }
    roots
}

impl Time<'_> {
    /// Gaps of the conditions and rows of tables below `roots` that time decides. What depends on the state, too, changes its branch
    /// at times that nobody knows before. Of what is `moved`, accelerations count.
    fn gaps(&mut self, roots: &[Id], moved: &[Id]) -> Vec<Id> {
        let moved = self.graph.reachable(moved);
        let mut of_state: Vec<Id> = self.observed.iter().map(|&(_, symbol)| symbol).collect();
        of_state.extend(self.locals.iter().flatten().chain(&self.strains).flatten());
        of_state.push(self.x);
        let mut gaps = Vec::new();
        for id in self.graph.reachable(roots) {
            let sides = match self.graph.node(id) {
                Node::Select(_, [left, right, ..]) => vec![[left, right]],
                Node::Lookup(column, at) if at != self.t => {
                    let table = self.graph.table(column);
                    let mut rows = table.kinks(column.column);
                    if moved.binary_search(&id).is_ok() {
                        rows.extend(table.kinks_of_acceleration());
                    }
                    rows.into_iter().map(|row| [at, self.graph.number(row)]).collect()
                }
                _ => continue,
            };
            for [left, right] in sides {
                let gap = self.graph.subtract(left, right);
                let of_time = self.graph.depends_on(gap, &[self.t]) && !self.graph.depends_on(gap, &of_state);
                if of_time && !gaps.contains(&gap) {
                    gaps.push(gap);
                }
            }
        }
        gaps
    }

    /// Rows of linear tables that are looked up at t below `roots`, and of splines below what is `moved`.
    fn rows(&self, roots: &[Id], moved: &[Id]) -> Vec<String> {
        let moved = self.graph.reachable(moved);
        let mut rows = Vec::new();
        for id in self.graph.reachable(roots) {
            let Node::Lookup(column, at) = self.graph.node(id) else {
                continue;
            };
            let table = self.graph.table(column);
            let kinks = match table.between {
                Between::Line => "kinks",
                Between::Spline | Between::Clamped if moved.binary_search(&id).is_ok() => "kinks_of_acceleration",
                Between::Spline | Between::Clamped | Between::Monotone | Between::Periodic => continue,
            };
            let row = format!("{}.{kinks}({})", table.reference(), column.column);
            if at == self.t && !rows.contains(&row) {
                rows.push(row);
            }
        }
        rows
    }

    /// Whether a value has cases itself.
    fn has_branches(&self, id: Id) -> bool {
        let below = self.graph.reachable(&[id]);
        below
            .into_iter()
            .any(|id| matches!(self.graph.node(id), Node::Select(..)))
    }

    /// A kernel of gaps and their derivatives.
    fn gap_kernel(self, name: String, gaps: Vec<[Id; 2]>) -> (Kernel, usize) {
        let count = gaps.len();
        let outputs = gaps.into_iter().flatten().enumerate();
        let outputs = outputs
            .map(|(index, id)| (format!("gaps[{}][{}]", index / 2, index % 2), id))
            .collect();
        let title = "Left less right side of conditions of t, and their time derivatives.".to_string();
        let mut kernel = self.kernel(name, title, outputs);
        kernel.arguments.push(format!("gaps: &mut [[f64; 2]; {count}]"));
        (kernel, count)
    }
}

/// Whether a frame's pose is unknown.
pub fn is_free(model: &Model, frame: FrameId) -> bool {
    model.frames[frame.0].free.is_some()
}

/// Whether a frame moves in a prescribed way. A free one does so only where its origin stays that of
/// a parent which moves.
pub fn moves(model: &Model, frame: FrameId) -> bool {
    let declaration = &model.frames[frame.0];
    if let Some(free) = &declaration.free {
        let hangs = matches!(free.motions, Motions::Turning | Motions::Hinged { .. });
        return hangs && moves(model, declaration.parent);
    }
    let mut time = Time::new(model);
    let (rotation, position) = time.pose(frame);
    let t = time.t;
    rotation
        .iter()
        .flatten()
        .chain(&position)
        .any(|&id| time.graph.depends_on(id, &[t]))
}

/// Whether any of some expressions depends on time.
pub fn varies<'e>(model: &Model, exprs: impl IntoIterator<Item = &'e Expr>) -> bool {
    let mut time = Time::new(model);
    let t = time.t;
    exprs.into_iter().any(|expr| {
        let id = time.expression(expr);
        time.graph.depends_on(id, &[t])
    })
}
