//! Motions of prescribed frames: poses as expressions of t, their derivatives, and kinks.

use std::collections::HashMap;

use super::kernel::Kernel;
use crate::model::{Binary, Expr, Frame, FrameId, FrameTie, INERTIAL, Model, Motions, Observable, RepeatId};
use crate::symbolic::linear::{Matrix3, Vector};
use crate::symbolic::{Graph, Id, Node};

/// A graph with the time and the parameters of a model.
pub struct Time<'m> {
    /// The model.
    pub model: &'m Model,
    /// The graph.
    pub graph: Graph,
    /// Time.
    pub t: Id,
    /// Arclength of a body's axis.
    pub x: Id,
    /// Number of the repetition, in the scope of emitted loops a variable.
    pub index: Id,
    /// End time of the run.
    pub end_time: Id,
    /// Position and slope of the axis at a particle, by order and component.
    locals: [[Option<Id>; 3]; 2],
    params: Vec<Id>,
    /// Symbols of the components of the strain that have been used.
    strains: [Option<Id>; 6],
    /// Symbols of what outputs observe, in order of first use.
    pub observed: Vec<(Observable, Id)>,
}

impl<'m> Time<'m> {
    /// A graph for expressions of this model.
    pub fn new(model: &'m Model) -> Self {
        let mut graph = Graph::new();
        let t = graph.symbol("t");
        let x = graph.symbol("x");
        let index = graph.symbol("index");
        let end_time = graph.symbol("end_time");
        let params = model.params.iter().map(|param| {
            let field = format!("model.{}", param.name);
            graph.symbol(if param.is_count {
                format!("({field} as f64)")
            } else {
                field
            })
        });
        let params = params.collect();
        Self {
            model,
            graph,
            t,
            x,
            index,
            end_time,
            locals: [[None; 3]; 2],
            params,
            strains: [None; 6],
            observed: Vec::new(),
        }
    }

    /// The symbol of a parameter.
    pub fn param(&self, at: usize) -> Id {
        self.params[at]
    }

    /// The symbol of a component of the strain.
    pub fn strain(&mut self, component: usize) -> Id {
        let graph = &mut self.graph;
        *self.strains[component].get_or_insert_with(|| graph.symbol(format!("strain[{component}]")))
    }

    /// The symbol of a component of the position (order 0) or slope (1) at a particle.
    pub fn local(&mut self, order: usize, component: usize) -> Id {
        let graph = &mut self.graph;
        let name = ["position", "slope"][order];
        *self.locals[order][component].get_or_insert_with(|| graph.symbol(format!("{name}[{component}]")))
    }

    /// An expression at the model's time.
    pub fn expression(&mut self, expr: &Expr) -> Id {
        self.expression_at(expr, self.t)
    }

    /// Three expressions at the model's time.
    pub fn vector(&mut self, exprs: &[Expr; 3]) -> Vector {
        exprs.iter().map(|expr| self.expression(expr)).collect()
    }

    fn expression_at(&mut self, expr: &Expr, t: Id) -> Id {
        match expr {
            Expr::Number(value) => self.graph.number(*value),
            Expr::Param(param) => self.params[param.0],
            Expr::Time => t,
            Expr::Arclength => self.x,
            Expr::Table { table, column } => {
                let text = self.model.tables[table.0].lookup(*column);
                self.graph.input(text)
            }
            Expr::Index => self.index,
            Expr::Local { order, component } => self.local(*order, *component),
            Expr::EndTime => self.end_time,
            Expr::Strain(component) => self.strain(*component),
            Expr::Motion(motion, argument) => {
                let argument = self.expression_at(argument, t);
                let motion = &self.model.motions[motion.0];
                let value = self.expression_at(&motion.value, argument);
                self.graph.name(value, motion.name.clone())
            }
            Expr::Negate(a) => {
                let a = self.expression_at(a, t);
                self.graph.negate(a)
            }
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.expression_at(a, t), self.expression_at(b, t));
                match operator {
                    Binary::Add => self.graph.add(a, b),
                    Binary::Subtract => self.graph.subtract(a, b),
                    Binary::Multiply => self.graph.multiply(a, b),
                    Binary::Divide => self.graph.divide(a, b),
                }
            }
            Expr::Power(base, exponent) => {
                let (base, exponent) = (self.expression_at(base, t), self.expression_at(exponent, t));
                self.graph.general_power(base, exponent)
            }
            Expr::Call(function, arguments) => {
                let arguments: Vec<Id> = arguments
                    .iter()
                    .map(|argument| self.expression_at(argument, t))
                    .collect();
                match arguments[..] {
                    [a, b] => self.graph.call2(*function, a, b),
                    _ => self.graph.call(*function, arguments[0]),
                }
            }
            Expr::If(comparison, left, right, then, otherwise) => {
                let [left, right, then, otherwise] =
                    [left, right, then, otherwise].map(|part| self.expression_at(part, t));
                self.graph.select(*comparison, left, right, then, otherwise)
            }
            Expr::Observed(observable) => {
                if let Some(&(_, symbol)) = self.observed.iter().find(|(other, _)| other == observable) {
                    return symbol;
                }
                let symbol = self.graph.symbol(format!("observed[{}]", self.observed.len()));
                self.observed.push((observable.clone(), symbol));
                symbol
            }
        }
    }

    /// Time derivative, t being the only thing that changes.
    pub fn derivative(&mut self, id: Id) -> Id {
        let derivative = self.graph.partial(id, self.t);
        if let Some(name) = self.graph.name_of(id).map(|name| format!("{name}_t")) {
            self.graph.name(derivative, name);
        }
        derivative
    }

    fn derivatives(&mut self, ids: &[Id]) -> Vector {
        ids.iter().map(|&id| self.derivative(id)).collect()
    }

    fn frame(&self, frame: FrameId) -> &'m Frame {
        &self.model.frames[frame.0]
    }

    /// Rotation matrix and origin of a prescribed frame in the inertial frame.
    ///
    /// # Panics
    /// If the frame is free: its pose is no expression of time.
    pub fn pose(&mut self, frame: FrameId) -> (Matrix3, Vector) {
        if frame == INERTIAL {
            let zero = self.graph.zero();
            return (self.graph.identity(), vec![zero; 3]);
        }
        let declaration = self.frame(frame);
        assert!(
            declaration.free.is_none(),
            "the pose of `{}` is unknown",
            declaration.name
        );
        let (parent, position) = self.pose(declaration.parent);
        let origin = self.vector(&declaration.origin);
        let moved = self.graph.apply(&parent, &origin);
        let position = self.graph.add_vectors(&position, &moved);
        let Some(rotation) = &declaration.rotation else {
            return (parent, position);
        };
        let angle = self.expression(&rotation.angle);
        let own = self.graph.rotation(unit(rotation.axis), angle);
        (self.graph.multiply_matrices(&parent, &own), position)
    }

    /// Angular velocity of a frame in its own axes.
    pub fn spin(&mut self, frame: FrameId) -> Vector {
        if frame == INERTIAL {
            let zero = self.graph.zero();
            return vec![zero; 3];
        }
        let declaration = self.frame(frame);
        let parent = self.spin(declaration.parent);
        let Some(rotation) = &declaration.rotation else {
            return parent;
        };
        let axis = unit(rotation.axis);
        let angle = self.expression(&rotation.angle);
        let rate = self.derivative(angle);
        let own = self.graph.rotation(axis, angle);
        let carried = self.graph.apply_transposed(&own, &parent);
        let axis: Vector = axis.iter().map(|&x| self.graph.number(x)).collect();
        let turning = self.graph.scale(rate, &axis);
        self.graph.add_vectors(&carried, &turning)
    }

    /// Pose of a frame relative to another.
    pub fn relative_pose(&mut self, of: FrameId, to: FrameId) -> (Matrix3, Vector) {
        if of == to {
            let zero = self.graph.zero();
            return (self.graph.identity(), vec![zero; 3]);
        }
        let (rotation, position) = self.pose(of);
        if to == INERTIAL {
            return (rotation, position);
        }
        let (base, origin) = self.pose(to);
        let back = crate::symbolic::linear::transpose(&base);
        let offset = self.graph.subtract_vectors(&position, &origin);
        (
            self.graph.multiply_matrices(&back, &rotation),
            self.graph.apply(&back, &offset),
        )
    }
}

/// A direction of length one.
pub(super) fn unit(axis: [f64; 3]) -> [f64; 3] {
    let size = (axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]).sqrt();
    axis.map(|x| x / size)
}

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
            .map(|(j, &id)| (format!("motion.rotation[{i}][{j}]"), id));
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
    let mut kernel = time.kernel(format!("frame_{}", declaration.name), title, outputs);
    kernel
        .arguments
        .push("motion: &mut ::rncf::mesh::FrameMotion".to_string());
    kernel
        .bindings
        .push("*motion = ::rncf::mesh::FrameMotion::INERTIAL;".to_string());
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
    /// The same of conditions that differ between the repetitions of a loop.
    pub repeated: Vec<(RepeatId, Kernel, usize)>,
}

impl Switches {
    /// Whether no branch ever changes.
    pub fn is_empty(&self) -> bool {
        self.kinks.1 == 0 && self.gaps.1 == 0 && self.repeated.is_empty()
    }
}

/// Finds all conditions that change with time. Those linear in t switch at `-g(0) / g'`; the others where an
/// integrator finds a root of their gap.
pub fn switches(model: &Model) -> Switches {
    let mut time = Time::new(model);
    let roots = timed_roots(&mut time);
    let of_time = time.gaps(&roots);
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
        for gap in time.gaps(&roots) {
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

/// All that time may act on.
fn timed_roots(time: &mut Time<'_>) -> Vec<Id> {
    let model = time.model;
    let mut roots = Vec::new();
    for (index, frame) in model.frames.iter().enumerate() {
        if frame.free.is_none() {
            let (rotation, position) = time.pose(FrameId(index));
            roots.extend(rotation.iter().flatten().copied().chain(position));
        }
    }
    for load in &model.loads {
        roots.extend(time.vector(load.kind.components()));
    }
    for density in &model.densities {
        roots.extend(time.vector(&density.components));
    }
    for (_, row) in model.constraints.iter().flat_map(|constraint| &constraint.rows) {
        roots.push(time.expression(row));
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
    /// Gaps of the conditions below `roots` that time decides. What depends on the state, too, changes its branch
    /// at times that nobody knows before.
    fn gaps(&mut self, roots: &[Id]) -> Vec<Id> {
        let mut of_state: Vec<Id> = self.observed.iter().map(|&(_, symbol)| symbol).collect();
        of_state.extend(self.locals.iter().flatten().chain(&self.strains).flatten());
        of_state.push(self.x);
        let mut gaps = Vec::new();
        for id in self.graph.reachable(roots) {
            let Node::Select(_, [left, right, ..]) = self.graph.node(id) else {
                continue;
            };
            let gap = self.graph.subtract(left, right);
            let of_time = self.graph.depends_on(gap, &[self.t]) && !self.graph.depends_on(gap, &of_state);
            if of_time && !gaps.contains(&gap) {
                gaps.push(gap);
            }
        }
        gaps
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
