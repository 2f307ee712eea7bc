//! Expressions of a model as nodes of a graph: of time, of the place along an axis, of what outputs observe; poses of prescribed
//! frames.

use std::collections::HashMap;

use super::graph::{Graph, Id};
use super::linear::{self, Matrix3, Vector};
use crate::model::fold::may_lack_value;
use crate::model::{Binary, Expr, Frame, FrameId, INERTIAL, Model, Observable};

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
    pub(crate) locals: [[Option<Id>; 3]; 2],
    pub(crate) params: Vec<Id>,
    /// Symbols of the components of the strain that have been used.
    pub(crate) strains: [Option<Id>; 6],
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
            Expr::Lookup { table, column, at } => {
                let at = self.expression_at(at, t);
                let model = self.model;
                self.graph.look_up(&model.tables[table.0], *column, at)
            }
            Expr::Index => self.index,
            Expr::Local { order, component } => self.local(*order, *component),
            Expr::EndTime => self.end_time,
            Expr::Strain(component) => self.strain(*component),
            // It has a meaning inside of an element's declaration alone.
            Expr::Element(quantity) => self.graph.input(format!("{quantity:?}")),
            Expr::Motion(motion, argument) => {
                let argument = self.expression_at(argument, t);
                let motion = &self.model.motions[motion.0];
                let value = self.expression_at(&motion.value, argument);
                self.graph.name(value, crate::model::identifier(&motion.name))
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
                let may_lack_value = [left, right].into_iter().any(|side| may_lack_value(side));
                let [left, right, then, mut otherwise] =
                    [left, right, then, otherwise].map(|part| self.expression_at(part, t));
                if may_lack_value {
                    // What is no number is on neither side, and so is their sum.
                    let neither = self.graph.add(left, right);
                    otherwise = self
                        .graph
                        .select(comparison.otherwise(), left, right, otherwise, neither);
                }
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
            Expr::Slope(of, by) => {
                let (of, by) = (self.expression_at(of, t), self.expression_at(by, t));
                self.graph.partial(of, by)
            }
            Expr::Rate(of) => {
                let mut rates = HashMap::from([(t, self.graph.one())]);
                of.each_observable(&mut |observable| {
                    if let Some(rate) = observable.rate() {
                        let [value, rate] = [observable.clone(), rate].map(Expr::Observed);
                        rates.insert(self.expression_at(&value, t), self.expression_at(&rate, t));
                    }
                });
                let of = self.expression_at(of, t);
                self.graph.differentiate(of, &rates)
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

    /// Time derivatives of several.
    pub fn derivatives(&mut self, ids: &[Id]) -> Vector {
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
        let back = linear::transpose(&base);
        let offset = self.graph.subtract_vectors(&position, &origin);
        (
            self.graph.multiply_matrices(&back, &rotation),
            self.graph.apply(&back, &offset),
        )
    }
}

/// A direction of length one.
pub fn unit(axis: [f64; 3]) -> [f64; 3] {
    let size = (axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]).sqrt();
    axis.map(|x| x / size)
}

/// A vector at the arclength `x` and its derivative, with the parameters' defaults.
pub fn along_axis(model: &Model, exprs: &[Expr; 3], x: f64, index: f64) -> [[f64; 3]; 2] {
    path_of(model, exprs, index)(x)
}

/// The same as a function of the arclength, derived once.
pub fn path_of(model: &Model, exprs: &[Expr; 3], index: f64) -> impl Fn(f64) -> [[f64; 3]; 2] + use<> {
    let mut time = Time::new(model);
    let [values, slopes] = derived(&mut time, exprs);
    let mut inputs = HashMap::from([(time.t, 0.0), (time.index, index)]);
    for (at, param) in model.params.iter().enumerate() {
        inputs.insert(time.param(at), param.default);
    }
    let roots: Vec<Id> = values.into_iter().chain(slopes).collect();
    let (graph, x) = (time.graph, time.x);
    move |at| {
        let mut inputs = inputs.clone();
        inputs.insert(x, at);
        let numbers = graph.evaluate(&roots, &inputs);
        [0, 3].map(|first| std::array::from_fn(|axis| numbers[first + axis]))
    }
}

/// Components and their derivatives with respect to the arclength.
pub fn derived(time: &mut Time, exprs: &[Expr; 3]) -> [[Id; 3]; 2] {
    let values = exprs.each_ref().map(|expr| time.expression(expr));
    let x = time.x;
    let slopes = values.map(|value| time.graph.partial(value, x));
    [values, slopes]
}
