//! Loads per length of bodies, and gravity fields on what free frames carry.

use super::load::GRAVITY;
use crate::check::bodies::body;
use crate::check::frames::plane::normal;
use crate::check::values::quantity::{Nature, Vector, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::vector::Vectorial;
use crate::check::{Arguments, Check, Shape, fold, say};
use crate::errors::Area;
use crate::joints::algebra;
use crate::model::{self, Binary, Density, Expr as Value, Fidelity, FrameId, INERTIAL, LoadKind, Space};
use crate::parse::tree::{Call, Expr, ExprKind, Item};
use crate::units::Dimension;

const DENSITY: Wanted = Wanted {
    what: "a load per length",
    dimension: [0, 1, -2, 0, 0, 0],
    unit: "N/m",
};

/// Highest total degree of a density in the position and slope of the particle.
const HIGHEST_DEGREE: usize = 4;

/// Names of the vectors of a particle, by order, and their dimensions.
const LOCALS: [(&str, [i8; 6]); 2] = [("position", [1, 0, 0, 0, 0, 0]), ("slope", [0; 6])];

impl<'a> Check<'a> {
    /// `density(BODY, VECTOR)`
    pub(in crate::check) fn density(&mut self, item: &Item, call: &'a Call) -> Option<()> {
        let shape = Shape {
            positional: 2,
            named: &[],
            required: &[],
            usage: "density(beam, -w*slope)",
        };
        let arguments = self.arguments(call, &shape)?;
        let [place, expr] = arguments.positional[..] else {
            return None;
        };
        let (body, instance) = self.named_body(place)?;
        if item.repeat.is_some() && instance != Some(Value::Index)
            || instance.is_some_and(|instance| instance != Value::Index)
        {
            self.errors.at(place.area, say::DENSITY_REPETITION);
            return None;
        }
        let (space, frame) = (body.space?, body.frame?);
        let is_whole = |declared: &model::Body| declared.fidelity == Fidelity::Full;
        if !self.model.bodies.get(body.id.0).is_none_or(is_whole) {
            self.errors.at(place.area, say::DENSITY_ON_MODES);
            return None;
        }
        self.particle = LOCALS
            .into_iter()
            .enumerate()
            .map(|(order, (name, dimension))| (name, local(order, dimension, space, frame)))
            .collect();
        let vector = self.density_vector(expr, body);
        self.particle.clear();
        let vector = vector?;
        self.in_plane(&vector, space, "the load");
        for (value, area) in vector.values.iter().zip(vector.areas) {
            match degree(value) {
                Ok(degree) if degree <= HIGHEST_DEGREE => {}
                Ok(degree) => {
                    self.errors.at(area, say::density_degree(&degree.to_string()));
                    return None;
                }
                Err(what) => {
                    self.errors.at(area, say::density_not_polynomial(what));
                    return None;
                }
            }
        }
        let mut markers = Vec::new();
        vector
            .values
            .iter()
            .for_each(|value| algebra::markers_of(value, &mut markers));
        self.model.densities.push(Density {
            name: item.name.text.clone(),
            doc: item.doc.clone(),
            body: body.id,
            markers,
            components: vector.values,
        });
        Some(())
    }

    fn density_vector(&mut self, expr: &'a Expr, body: body::Known) -> Option<Vector> {
        let (vector, frame) = self.load_vector(expr, DENSITY)?;
        let own = body.frame?;
        if let Some(frame) = frame.filter(|frame| *frame != own) {
            let [from, to] = [frame, own].map(|frame| self.model.frames[frame.0].name.clone());
            self.errors.at(expr.area, say::density_axes(&from, &to));
            return None;
        }
        Some(vector)
    }

    /// A vector of constants, parameters, time, positions and directions, and the frame of its components.
    fn load_vector(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<(Vector, Option<FrameId>)> {
        self.is_distributed = true;
        let vector = self.distributed(expr, wanted);
        self.is_distributed = false;
        vector
    }

    fn distributed(&mut self, expr: &'a Expr, wanted: Wanted) -> Option<(Vector, Option<FrameId>)> {
        if let ExprKind::Vector { .. } = expr.kind {
            return Some((self.vector(expr, Scope::Constraint, wanted)?, None));
        }
        let vector = self.wanted_vector(expr, Scope::Constraint, wanted)?;
        let (areas, area): ([Area; 3], Area) = ([expr.area; 3], expr.area);
        let values = vector.values;
        Some((Vector { values, areas, area }, vector.frame))
    }

    /// `gravity(VECTOR, on = FRAME)`
    pub(in crate::check) fn field(&mut self, arguments: &Arguments<'a>, on: &'a Expr) -> Option<LoadKind> {
        let frame = self.frame_argument(on)?;
        if !self.is_free(frame) {
            let name = self.model.frames[frame.0].name.clone();
            self.errors.at(on.area, say::field_on_prescribed(&name));
            return None;
        }
        let expr = arguments.positional[0];
        let (mut vector, axes) = self.load_vector(expr, GRAVITY)?;
        let normal = self.frame_normal(frame);
        if let Some(axes) = axes.filter(|axes| *axes != INERTIAL) {
            vector.values = self.in_inertial_axes(&vector.values, axes, normal);
        }
        if let Some(normal) = normal {
            self.in_plane(&vector, Space::Planar { normal }, "gravity");
        }
        let mut markers = Vec::new();
        vector
            .values
            .iter()
            .for_each(|value| algebra::markers_of(value, &mut markers));
        for marker in &markers {
            let of = self.model.markers[marker.0].frame();
            if of.is_none_or(|of| of != frame && self.is_free(of)) {
                let name = self.model.frames[frame.0].name.clone();
                self.errors.at(expr.area, say::field_elsewhere(&name));
                return None;
            }
        }
        Some(LoadKind::Field {
            frame,
            markers,
            components: vector.values,
        })
    }
}

/// Position or slope of the particle, axes of the body's frame; in a plane two components.
fn local(order: usize, dimension: [i8; 6], space: Space, frame: FrameId) -> Vectorial {
    let component = |axis| {
        if normal(space) == Some(axis) {
            return Value::Number(0.0);
        }
        Value::Local { order, component: axis }
    };
    Vectorial {
        values: [0, 1, 2].map(component),
        axes: space.axes().to_vec(),
        dimension: Dimension::of(dimension),
        nature: Nature::default(),
        frame: Some(frame),
    }
}

/// Total degree of a polynomial in position and slope; else the operation that makes it none.
fn degree(expr: &Value) -> Result<usize, &'static str> {
    let constant = |expr: &Value, what: &'static str| match degree(expr)? {
        0 if !fold::has_local(expr) => Ok(0),
        _ => Err(what),
    };
    match expr {
        Value::Local { .. } => Ok(1),
        Value::Negate(inner) => degree(inner),
        Value::Binary(Binary::Add | Binary::Subtract, a, b) => Ok(degree(a)?.max(degree(b)?)),
        Value::Binary(Binary::Multiply, a, b) => Ok(degree(a)? + degree(b)?),
        Value::Binary(Binary::Divide, a, b) => {
            constant(b, "a quotient")?;
            degree(a)
        }
        Value::Power(base, exponent) => {
            constant(exponent, "a power")?;
            match fold::constant(exponent) {
                _ if !fold::has_local(base) => Ok(0),
                Some(n) if n >= 0.0 && n == n.trunc() && n <= 64.0 => Ok(degree(base)? * n as usize),
                _ => Err("a power"),
            }
        }
        Value::Call(_, arguments) => {
            for argument in arguments {
                constant(argument, "a function such as `norm` or `sqrt`")?;
            }
            Ok(0)
        }
        Value::If(_, left, right, then, otherwise) => {
            constant(left, "a condition")?;
            constant(right, "a condition")?;
            Ok(degree(then)?.max(degree(otherwise)?))
        }
        _ => Ok(0),
    }
}
