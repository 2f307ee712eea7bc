//! Courses: what motions and loads do over time alone, where it may be over before a step sees it, as lists of operations that the runtime bounds.
//! Of prescribed positions it is their second derivative: that of the acceleration. Loads per length have courses over time and along the axis:
//! they may lie between the points of an element, or pass one within a step. What is narrow in space has courses over the vectors that it reads.

use std::collections::{HashMap, HashSet};

use super::kernel::Kernel;
use super::markers::{function_name, localise};
use super::motions::timed_coefficients;
use crate::elements::Library;
use crate::model::{
    Distributed, Expr, FrameId, Function, LoadKind, MarkerId, Model, Observable, ParticleVector, RepeatId,
};
use crate::symbolic::{Id, Node, Time};

/// A sine to a lower power is as wide as its period is long.
const NARROW_POWER: u32 = 4;

/// Functions of time, or of it and the place along an axis, that share operations.
#[derive(Clone, Debug)]
pub struct CourseKernel {
    /// Loop whose number of the repetition they depend on.
    pub repeat: Option<RepeatId>,
    /// Values of what does not change, and their number.
    pub numbers: (Kernel, usize),
    /// Operations, as texts of `rncf::emitted::Operation`, operands first.
    pub operations: Vec<String>,
    /// Tables that are looked up, as references in generated code where `model` is the struct of the params.
    pub tables: Vec<String>,
    /// What each function belongs to, and its operation.
    pub functions: Vec<(String, usize)>,
    /// Whether they are positions that something is held at.
    pub are_positions: bool,
    /// Markers of the model whose vectors they read, where the scene does not know.
    pub markers: Vec<MarkerId>,
}

impl CourseKernel {
    /// The function of its numbers, where it has any.
    pub fn kernel(&self) -> Option<&Kernel> {
        (self.numbers.1 > 0).then_some(&self.numbers.0)
    }
}

/// All courses of a model but those of forces on markers and at places: those of all repetitions first, those over markers last.
pub fn courses(model: &Model, library: &Library) -> Vec<CourseKernel> {
    let scopes = std::iter::once(None).chain((0..model.repeats.len()).map(|at| Some(RepeatId(at))));
    let of_time = scopes.filter_map(|repeat| courses_in(model, library, repeat));
    of_time.chain(courses_of_markers(model)).collect()
}

/// What constraints, fields and loads per length do over the markers that they read.
fn courses_of_markers(model: &Model) -> Vec<CourseKernel> {
    let mut names = Vec::new();
    let mut courses = Vec::new();
    let mut add = |of: String, name: &str, markers: &[MarkerId], components: Vec<&Expr>, are_positions| {
        let components: Vec<Expr> = components.into_iter().map(|one| localise(one, markers)).collect();
        let name = function_name(name, &names);
        if let Some(course) = course_of(model, &components, &format!("markers_of_{name}"), &of) {
            names.push(name);
            courses.push(CourseKernel {
                are_positions,
                markers: markers.to_vec(),
                ..course
            });
        }
    };
    for constraint in &model.constraints {
        let rows = constraint.rows.iter().map(|(_, row)| row).collect();
        let of = format!("joint `{}`", constraint.name);
        add(of, &constraint.name, &constraint.markers, rows, true);
    }
    for load in &model.loads {
        if let LoadKind::Field {
            markers, components, ..
        } = &load.kind
        {
            let of = format!("load `{}`", load.name);
            add(of, &load.name, markers, components.iter().collect(), false);
        }
    }
    for density in &model.densities {
        let of = format!("load `{}`", density.name);
        let components = density.components.iter().collect();
        add(of, &density.name, &density.markers, components, false);
    }
    courses
}

/// What a load per length does along the axis of its body, over time and where its particles come to; `None` where it is as wide as what its points see.
pub fn course_along(model: &Model, load: &Distributed, name: &str) -> Option<CourseKernel> {
    let mut time = Time::new(model);
    let repeat = model.bodies[load.body.0].repeat;
    let components = load.forces.iter().flat_map(|(_, components)| components);
    let values: Vec<Id> = components.map(|component| time.expression(component)).collect();
    let places: Vec<Id> = time.vectors(0).map(|(id, _)| id).collect();
    let mut other = time.what_moves();
    other.retain(|id| !places.contains(id));
    let along = [&[time.x], &places[..]].concat();
    let variables = [&[time.t], &along[..]].concat();
    let mut parts = Vec::new();
    values
        .iter()
        .for_each(|&id| time.parts_of(&|id| time.graph.depends_on(id, &variables), id, &other, &mut parts));
    parts.retain(|&part| time.graph.depends_on(part, &along) && time.is_narrow(&variables, part));
    let of = format!("load `{}`", load.name);
    let functions: Vec<(String, Id)> = parts.into_iter().map(|part| (of.clone(), part)).collect();
    let mut arguments = vec!["[x, length]: [f64; 2]"];
    arguments.extend(repeat.map(|_| "index: f64"));
    let name = format!("numbers_of_courses_of_{name}");
    (!functions.is_empty()).then(|| time.course_kernel(&variables, repeat, (name, &arguments), functions))
}

/// What an expression does over the vectors of its markers that may be over before a step sees it, `None` where nothing is; `components` count its own markers, and
/// `of` says in words what it belongs to.
pub fn course_of(model: &Model, components: &[Expr], name: &str, of: &str) -> Option<CourseKernel> {
    let mut time = Time::new(model);
    let values: Vec<Id> = components.iter().map(|component| time.expression(component)).collect();
    let vectors: Vec<Id> = time.vectors(1).map(|(id, _)| id).collect();
    let mut other = time.what_moves();
    other.retain(|id| !vectors.contains(id));
    other.extend([time.x, time.index]);
    let variables = [&[time.t], &vectors[..]].concat();
    let mut parts = Vec::new();
    values
        .iter()
        .for_each(|&id| time.parts_of(&|id| time.ends_somewhere(&variables, id), id, &other, &mut parts));
    parts.retain(|&part| time.graph.depends_on(part, &vectors));
    let functions: Vec<(String, Id)> = parts.into_iter().map(|part| (of.to_string(), part)).collect();
    let name = format!("numbers_of_courses_of_{name}");
    (!functions.is_empty()).then(|| time.course_kernel(&variables, None, (name, &[]), functions))
}

/// An expression that time may act on, and what it belongs to.
struct Root {
    of: String,
    /// Whether it is a position.
    is_position: bool,
    values: Vec<Id>,
}

fn courses_in(model: &Model, library: &Library, repeat: Option<RepeatId>) -> Option<CourseKernel> {
    let mut time = Time::new(model);
    let roots = match repeat {
        None => roots(&mut time, library),
        Some(repeat) => repeated_roots(&mut time, repeat),
    };
    let mut other = time.what_moves();
    other.push(time.x);
    let (index, variables) = (time.index, [time.t]);
    if repeat.is_none() {
        other.push(index);
    }
    let mut functions: Vec<(String, Id)> = Vec::new();
    for root in roots {
        let mut parts = Vec::new();
        root.values
            .iter()
            .for_each(|&id| time.parts_of(&|id| time.graph.depends_on(id, &variables), id, &other, &mut parts));
        for part in parts {
            if !time.is_narrow(&variables, part) || (repeat.is_some() && !time.graph.depends_on(part, &[index])) {
                continue;
            }
            let part = if root.is_position {
                let rate = time.graph.partial(part, time.t);
                time.graph.partial(rate, time.t)
            } else {
                part
            };
            let is_new = functions.iter().all(|&(_, known)| known != part);
            if is_new && time.graph.depends_on(part, &[time.t]) {
                functions.push((root.of.clone(), part));
            }
        }
    }
    let name = match repeat {
        None => "numbers_of_courses".to_string(),
        Some(repeat) => format!("numbers_of_courses_in_loop_{}", repeat.0),
    };
    let arguments: &[&str] = if repeat.is_some() { &["index: f64"] } else { &[] };
    (!functions.is_empty()).then(|| time.course_kernel(&variables, repeat, (name, arguments), functions))
}

fn roots(time: &mut Time<'_>, library: &Library) -> Vec<Root> {
    let model = time.model;
    let mut roots = Vec::new();
    let mut root = |of: String, is_position, values| {
        roots.push(Root {
            of,
            is_position,
            values,
        })
    };
    for (index, frame) in model.frames.iter().enumerate() {
        if frame.free.is_some() || FrameId(index) == crate::model::INERTIAL {
            continue;
        }
        let mut values = time.vector(&frame.origin);
        values.extend(frame.rotation.iter().map(|rotation| time.expression(&rotation.angle)));
        root(format!("the motion of frame `{}`", frame.name), true, values);
    }
    for load in &model.loads {
        let values = time.vector(load.kind.components());
        root(format!("load `{}`", load.name), false, values);
    }
    for density in &model.densities {
        let values = time.vector(&density.components);
        root(format!("load `{}`", density.name), false, values);
    }
    for load in &model.distributed {
        let values = load.forces.iter().flat_map(|(_, components)| time.vector(components));
        let values = values.collect();
        root(format!("load `{}`", load.name), false, values);
    }
    for constraint in &model.constraints {
        let values = constraint.rows.iter().map(|(_, row)| time.expression(row)).collect();
        root(format!("joint `{}`", constraint.name), true, values);
    }
    for force in &model.forces {
        let values = force.components.iter().flat_map(|components| time.vector(components));
        let values = values.collect();
        root(force.in_words(), false, values);
    }
    for body in &model.bodies {
        let timed = timed_coefficients(body, library);
        let values = timed
            .iter()
            .filter_map(|one| one.scale.as_ref())
            .map(|scale| time.expression(scale));
        let values = values.collect();
        root(format!("the stiffness of body `{}`", body.name), false, values);
    }
    roots
}

fn repeated_roots(time: &mut Time<'_>, repeat: RepeatId) -> Vec<Root> {
    let model = time.model;
    let of_loop = model
        .densities
        .iter()
        .filter(|density| model.bodies[density.body.0].repeat == Some(repeat));
    of_loop
        .map(|density| Root {
            of: format!("load `{}`", density.name),
            is_position: false,
            values: time.vector(&density.components),
        })
        .collect()
}

impl Time<'_> {
    /// Symbols of vectors that have been used, and of their rates if the highest derivative is 1, with the operations that have them: the number of the
    /// vector among those that are read, and its component. Of a particle it is the position, which is the first of its vectors.
    fn vectors(&self, highest: usize) -> impl Iterator<Item = (Id, String)> {
        self.observed.iter().filter_map(move |(observable, symbol)| {
            let Observable::Marker {
                marker,
                derivative,
                component,
            } = observable
            else {
                return None;
            };
            let number = match ParticleVector::of(*marker) {
                Some(ParticleVector::Position) if *derivative == 0 => 0,
                Some(_) => return None,
                None => marker.0,
            };
            let word = ["Vector", "Rate"].get(*derivative).filter(|_| *derivative <= highest)?;
            Some((*symbol, format!("{word}({number}, {component})")))
        })
    }

    /// Symbols of what is unknown before a run.
    fn what_moves(&self) -> Vec<Id> {
        let mut symbols: Vec<Id> = self.observed.iter().map(|&(_, symbol)| symbol).collect();
        symbols.extend(self.locals.iter().flatten().chain(&self.strains).flatten());
        symbols.push(self.end_time);
        symbols
    }

    /// The largest parts of an expression that variables alone decide, and in which something counts, each sum and each of its terms, without factors in
    /// which nothing does: a pulse may be small beside another term, or the difference of two that are none.
    fn parts_of(&self, counts: &impl Fn(Id) -> bool, id: Id, other: &[Id], parts: &mut Vec<Id>) {
        if !counts(id) {
            return;
        }
        let graph = &self.graph;
        let is_scaled = match graph.node(id) {
            Node::Negate(_) => true,
            Node::Multiply(a, b) => !(counts(a) && counts(b)),
            Node::Divide(_, b) => !counts(b),
            _ => false,
        };
        let is_sum = matches!(graph.node(id), Node::Add(..) | Node::Subtract(..));
        let is_decided = !graph.depends_on(id, other);
        if is_decided && !is_scaled && !parts.contains(&id) {
            parts.push(id);
        }
        if is_scaled || is_sum || !is_decided {
            for child in graph.children(id) {
                self.parts_of(counts, child, other, parts);
            }
        }
    }

    /// Whether anything in a function of variables falls faster than any power, or switches: what only falls with a power of the distance is felt from
    /// far, and factors like directions change with the turn. Over rates what rises to a value and stays there is friction, and no pulse.
    fn ends_somewhere(&self, variables: &[Id], id: Id) -> bool {
        use Function::{Abs, Cosh, Exp, Sinh, Tanh};
        let graph = &self.graph;
        let places: Vec<Id> = self.vectors(0).map(|(id, _)| id).collect();
        let moves = |id: Id| graph.depends_on(id, &places);
        let changes = |id: Id| graph.depends_on(id, variables);
        let rates: Vec<Id> = self
            .vectors(1)
            .map(|(id, _)| id)
            .filter(|id| !places.contains(id))
            .collect();
        let passes = |id: Id| changes(id) && !graph.depends_on(id, &rates);
        graph.reachable(&[id]).into_iter().any(|id| match graph.node(id) {
            Node::Call(function, of) => {
                let is_sharp = matches!(function, Exp | Cosh) && changes(of);
                is_sharp || matches!(function, Tanh | Sinh | Abs) && passes(of)
            }
            Node::Call2(function, ..) => function != Function::Atan2 && passes(id),
            Node::Lookup(_, at) => changes(at),
            // Steps end where time decides.
            Node::Select(_, [left, right, ..]) => moves(left) || moves(right),
            _ => false,
        })
    }

    /// Whether a function of variables may be over sooner than what else in it shows: not one of polynomials, sines and switches at known times.
    fn is_narrow(&mut self, variables: &[Id], id: Id) -> bool {
        for id in self.graph.reachable(&[id]) {
            if !self.graph.depends_on(id, variables) {
                continue;
            }
            let is_narrow = match self.graph.node(id) {
                Node::Divide(_, divisor) => self.graph.depends_on(divisor, variables),
                Node::Power(base, exponent) => !variables.contains(&base) && exponent >= NARROW_POWER,
                Node::Call(function, _) => !matches!(function, Function::Sin | Function::Cos),
                Node::Call2(..) | Node::Lookup(..) => true,
                Node::Select(_, [left, right, ..]) => {
                    let gap = self.graph.subtract(left, right);
                    let slope = self.graph.partial(gap, self.t);
                    // Steps end at times, and neither elements nor steps at places.
                    let places = variables.iter().filter(|&&id| id != self.t);
                    self.graph.depends_on(slope, variables)
                        || self.graph.depends_on(gap, &places.copied().collect::<Vec<Id>>())
                }
                _ => false,
            };
            if is_narrow {
                return true;
            }
        }
        false
    }

    /// The functions' operations. The kernel of their numbers has a name and arguments between the model and the numbers.
    fn course_kernel(
        self,
        variables: &[Id],
        repeat: Option<RepeatId>,
        (name, arguments): (String, &[&str]),
        functions: Vec<(String, Id)>,
    ) -> CourseKernel {
        let (x, graph) = (self.x, &self.graph);
        let vectors: HashMap<Id, String> = self.vectors(1).collect();
        let roots: Vec<Id> = functions.iter().map(|&(_, id)| id).collect();
        let nodes = graph.reachable(&roots);
        let changes = |id: Id| graph.depends_on(id, variables);
        // What does not change is a number where something that changes reads it.
        let read: HashSet<Id> = nodes
            .iter()
            .filter(|&&id| changes(id))
            .flat_map(|&id| graph.children(id))
            .collect();
        let (mut places, mut operations) = (HashMap::new(), Vec::new());
        let (mut numbers, mut tables): (Vec<Id>, Vec<String>) = (Vec::new(), Vec::new());
        for id in nodes {
            if !changes(id) {
                if read.contains(&id) {
                    places.insert(id, operations.len());
                    operations.push(format!("Number({})", numbers.len()));
                    numbers.push(id);
                }
                continue;
            }
            let at = |id: Id| places[&id];
            let operation = match graph.node(id) {
                Node::Number(_) | Node::Symbol(_) if id == x => "Place".to_string(),
                Node::Number(_) | Node::Symbol(_) if vectors.contains_key(&id) => vectors[&id].clone(),
                Node::Number(_) | Node::Symbol(_) => "Time".to_string(),
                Node::Add(a, b) => format!("Add({}, {})", at(a), at(b)),
                Node::Subtract(a, b) => format!("Subtract({}, {})", at(a), at(b)),
                Node::Multiply(a, b) => format!("Multiply({}, {})", at(a), at(b)),
                Node::Divide(a, b) => format!("Divide({}, {})", at(a), at(b)),
                Node::Negate(a) => format!("Negate({})", at(a)),
                Node::Power(a, n) => format!("Power({}, {n})", at(a)),
                Node::Call(function, a) => format!("{function:?}({})", at(a)),
                Node::Call2(function, a, b) => format!("{function:?}({}, {})", at(a), at(b)),
                Node::Select(comparison, [left, right, then, otherwise]) => {
                    let [left, right, then, otherwise] = [left, right, then, otherwise].map(at);
                    // Which of both holds at equal sides is of no account.
                    let is_less = matches!(
                        comparison,
                        crate::model::Comparison::Less | crate::model::Comparison::LessEqual
                    );
                    let (left, right) = if is_less { (left, right) } else { (right, left) };
                    format!("Select([{left}, {right}, {then}, {otherwise}])")
                }
                Node::Lookup(column, a) => {
                    let table = graph.table(column);
                    let reference = if table.is_param {
                        format!("{}.table()", table.reference())
                    } else {
                        format!("&{}", table.reference())
                    };
                    let known = tables.iter().position(|known| *known == reference);
                    let number = known.unwrap_or_else(|| {
                        tables.push(reference);
                        tables.len() - 1
                    });
                    format!("Lookup({number}, {}, {}, {})", column.column, column.order, at(a))
                }
            };
            places.insert(id, operations.len());
            operations.push(operation);
        }
        let functions = functions.into_iter().map(|(of, id)| (of, places[&id])).collect();
        let count = numbers.len();
        let outputs = numbers.into_iter().enumerate();
        let outputs = outputs.map(|(at, id)| (format!("numbers[{at}]"), id)).collect();
        let mut kernel = self.kernel(
            name,
            "What does not change in motions and loads that do.".to_string(),
            outputs,
        );
        kernel.arguments.truncate(1);
        kernel
            .arguments
            .extend(arguments.iter().map(|argument| argument.to_string()));
        kernel.arguments.push(format!("numbers: &mut [f64; {count}]"));
        CourseKernel {
            repeat,
            numbers: (kernel, count),
            operations,
            tables,
            functions,
            are_positions: false,
            markers: Vec::new(),
        }
    }
}
