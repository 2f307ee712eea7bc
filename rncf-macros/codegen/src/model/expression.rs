//! Resolved expressions in SI, and what of the simulated system they observe.

use super::ids::{BodyId, ConstraintId, FrameId, JointId, MarkerId, MotionId, ParamId, RepeatId, TableId};

/// A resolved expression in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// A number in SI; `pi` is one too, constants of the declaration are folded into these.
    Number(f64),
    /// A run-time parameter (a count is converted to a number).
    Param(ParamId),
    /// Time, s.
    Time,
    /// Number of the repetition, from 0, as a plain number; in what stands in a loop only.
    Index,
    /// Component of the position (m) or slope dp/dx of the axis at the particle, axes of the body's frame; in
    /// densities only.
    Local {
        /// 0 position, 1 slope.
        order: usize,
        /// Frame axis 0, 1, 2.
        component: usize,
    },
    /// End time of the run, s; in conditions of cautions only.
    EndTime,
    /// Arclength of a body's stress-free axis from its start, m; in what varies along it only.
    Arclength,
    /// A column of a table at this arclength.
    Table {
        /// Which table.
        table: TableId,
        /// Number of the column.
        column: usize,
    },
    /// A column of a table at a place among its rows.
    Lookup {
        /// Which table.
        table: TableId,
        /// Number of the column.
        column: usize,
        /// The place, in the unit of the table's places.
        at: Box<Expr>,
    },
    /// Component of the Green strain tensor, section axes with x along the body: xx, yy, zz, xy, xz, yz;
    /// in the energy density of a material only (THEORY 4.2).
    Strain(usize),
    /// What the energy of an element that is declared in the language refers to; there only.
    Element(ElementQuantity),
    /// A motion at another time.
    Motion(MotionId, Box<Expr>),
    /// Negation.
    Negate(Box<Expr>),
    /// A sum, difference, product or quotient.
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// `base ^ exponent`.
    Power(Box<Expr>, Box<Expr>),
    /// A function of one argument (two for `atan2`, `min`, `max`).
    Call(Function, Vec<Expr>),
    /// `if left < right { then } else { otherwise }`.
    If(Comparison, Box<Expr>, Box<Expr>, Box<Expr>, Box<Expr>),
    /// Something of the simulated system; in outputs, constraints and forces.
    Observed(Observable),
    /// Derivative of what is a function of markers by a component of one, which the second part observes; in forces.
    Slope(Box<Expr>, Box<Expr>),
    /// Rate of what is a function of markers and time; in forces.
    Rate(Box<Expr>),
}

impl Expr {
    /// The expressions that it is made of, in order.
    pub fn parts(&self) -> Vec<&Expr> {
        match self {
            Expr::Number(_)
            | Expr::Param(_)
            | Expr::Time
            | Expr::Arclength
            | Expr::Table { .. }
            | Expr::Index
            | Expr::Local { .. }
            | Expr::EndTime
            | Expr::Strain(_)
            | Expr::Element(_)
            | Expr::Observed(_) => Vec::new(),
            Expr::Motion(_, inner) | Expr::Negate(inner) | Expr::Rate(inner) | Expr::Lookup { at: inner, .. } => {
                vec![inner]
            }
            Expr::Binary(_, left, right) | Expr::Power(left, right) | Expr::Slope(left, right) => vec![left, right],
            Expr::Call(_, arguments) => arguments.iter().collect(),
            Expr::If(_, left, right, then, otherwise) => vec![left, right, then, otherwise],
        }
    }

    /// The same of other parts, where each has one.
    pub fn with_parts(&self, of: &mut dyn FnMut(&Expr) -> Option<Expr>) -> Option<Expr> {
        let mut boxed = |expr: &Expr| of(expr).map(Box::new);
        Some(match self {
            Expr::Motion(motion, inner) => Expr::Motion(*motion, boxed(inner)?),
            Expr::Negate(inner) => Expr::Negate(boxed(inner)?),
            Expr::Lookup { table, column, at } => Expr::Lookup {
                table: *table,
                column: *column,
                at: boxed(at)?,
            },
            Expr::Binary(operator, left, right) => Expr::Binary(*operator, boxed(left)?, boxed(right)?),
            Expr::Power(base, exponent) => Expr::Power(boxed(base)?, boxed(exponent)?),
            Expr::Call(function, arguments) => Expr::Call(*function, arguments.iter().map(of).collect::<Option<_>>()?),
            Expr::If(comparison, left, right, then, otherwise) => Expr::If(
                *comparison,
                boxed(left)?,
                boxed(right)?,
                boxed(then)?,
                boxed(otherwise)?,
            ),
            Expr::Slope(of, by) => Expr::Slope(boxed(of)?, boxed(by)?),
            Expr::Rate(of) => Expr::Rate(boxed(of)?),
            leaf => leaf.clone(),
        })
    }

    /// Its value at t = 0.
    pub fn at_time_zero(&self) -> Self {
        match self {
            Expr::Time => Expr::Number(0.0),
            other => other
                .with_parts(&mut |part| Some(part.at_time_zero()))
                .unwrap_or_else(|| other.clone()),
        }
    }

    /// Calls with everything that it observes.
    pub fn each_observable(&self, of: &mut dyn FnMut(&Observable)) {
        if let Expr::Observed(observable) = self {
            of(observable);
        }
        self.parts().into_iter().for_each(|part| part.each_observable(of));
    }

    /// Whether it or something that it is made of is of a kind.
    pub fn contains(&self, is: &dyn Fn(&Expr) -> bool) -> bool {
        is(self) || self.parts().into_iter().any(|part| part.contains(is))
    }
}

/// What the formulas of an element refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementQuantity {
    /// Inner product of two fields, by their numbers in space.
    Dot(usize, usize),
    /// Cross product of two fields, a number; in the plane.
    Cross(usize, usize),
    /// A coefficient.
    Coefficient(&'static str),
    /// A strain, counted from its stress-free value, or another name, by its number.
    Named(usize),
}

/// Two-operand arithmetic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
}

/// What a reduction over repetitions tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// Largest value.
    Max,
    /// Smallest value.
    Min,
    /// Sum.
    Sum,
    /// Mean.
    Mean,
}

/// Comparison in `if`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}

impl Comparison {
    /// What holds of two numbers where this does not.
    pub fn otherwise(self) -> Self {
        match self {
            Comparison::Less => Comparison::GreaterEqual,
            Comparison::LessEqual => Comparison::Greater,
            Comparison::Greater => Comparison::LessEqual,
            Comparison::GreaterEqual => Comparison::Less,
        }
    }
}

/// The usual functions; `Abs`, `Min`, `Max` and `Atan2` in outputs only (they have kinks). `Remainder` (`a % b`, with
/// the sign of b) in the index of a repetition only.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Min,
    Max,
    Atan2,
    Remainder,
}

impl Function {
    /// Value of a function of one argument; `None` for one of two.
    pub fn of(self, x: f64) -> Option<f64> {
        Some(match self {
            Function::Sin => x.sin(),
            Function::Cos => x.cos(),
            Function::Tan => x.tan(),
            Function::Asin => x.asin(),
            Function::Acos => x.acos(),
            Function::Atan => x.atan(),
            Function::Sinh => x.sinh(),
            Function::Cosh => x.cosh(),
            Function::Tanh => x.tanh(),
            Function::Exp => x.exp(),
            Function::Ln => x.ln(),
            Function::Sqrt => x.sqrt(),
            Function::Abs => x.abs(),
            Function::Min | Function::Max | Function::Atan2 | Function::Remainder => return None,
        })
    }

    /// Value of a function of two arguments; `None` for one of one.
    pub fn of_two(self, x: f64, y: f64) -> Option<f64> {
        Some(match self {
            // What is no number stays none.
            Function::Min if x < y || x.is_nan() => x,
            Function::Max if x > y || x.is_nan() => x,
            Function::Min | Function::Max => y,
            Function::Atan2 => x.atan2(y),
            Function::Remainder => x.rem_euclid(y),
            _ => return None,
        })
    }
}

/// A component of something observed.
#[derive(Clone, Debug, PartialEq)]
pub enum Observable {
    /// Component of a marker or of its time derivatives, inertial axes. Constraints use derivative 0
    /// only, forces 0 and 1.
    Marker {
        /// Which marker.
        marker: MarkerId,
        /// 0 value, 1 velocity, 2 acceleration.
        derivative: usize,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Value over all repetitions of a loop, of an expression that may contain [`Expr::Index`]; in outputs.
    Reduced {
        /// What is told.
        reduction: Reduction,
        /// The loop.
        repeat: RepeatId,
        /// What is looked at in each repetition.
        value: Box<Expr>,
    },
    /// Component of what a constraint exerts on its first party, inertial axes; in outputs. The
    /// moment is about the first point among its markers.
    ConstraintReaction {
        /// Which constraint.
        constraint: ConstraintId,
        /// Moment (N m) instead of force (N).
        moment: bool,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Multiplier of one row of a constraint; in outputs.
    Multiplier {
        /// Which constraint.
        constraint: ConstraintId,
        /// Row.
        row: usize,
    },
    /// Component of a body's point: position, velocity (relative to the body's frame) or slope
    /// dp/dx, in the axes of the body's declared frame.
    Point {
        /// Which body.
        body: BodyId,
        /// Where on it.
        at: Location,
        /// What of it.
        what: PointQuantity,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
    /// Component of a sum over what moves, inertial axes; in outputs.
    Balance {
        /// Whose.
        of: Owner,
        /// What.
        what: BalanceQuantity,
        /// 0, 1, 2 for x, y, z; 0 of a scalar.
        component: usize,
    },
    /// What a body carries at a place: what the part beyond it exerts on the part before it; in outputs.
    Section {
        /// Which body.
        body: BodyId,
        /// Where on it.
        at: Location,
        /// What of it.
        what: SectionQuantity,
    },
    /// Component of what a joint exerts on its body, in the axes of the joint's frame; the moment
    /// is about the joint's point.
    Reaction {
        /// Which joint.
        joint: JointId,
        /// Moment (N m) instead of force (N).
        moment: bool,
        /// 0, 1, 2 for x, y, z.
        component: usize,
    },
}

impl Observable {
    /// The time derivative of a component of a marker.
    pub fn rate(&self) -> Option<Observable> {
        let &Observable::Marker {
            marker,
            derivative,
            component,
        } = self
        else {
            return None;
        };
        Some(Observable::Marker {
            marker,
            derivative: derivative + 1,
            component,
        })
    }
}

/// Whose mass, momentum or energy it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Owner {
    /// All that moves.
    All,
    /// A meshed body with its fixtures.
    Body(BodyId),
    /// The rigid parts of a free frame.
    Frame(FrameId),
}

/// The point that an angular momentum is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum About {
    /// The inertial origin.
    Origin,
    /// A point.
    Marker(MarkerId),
    /// A centre of mass.
    CenterOf(Owner),
}

/// A sum over what moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BalanceQuantity {
    /// kg.
    Mass,
    /// kg m/s.
    Momentum,
    /// kg m^2/s, with velocities in the inertial frame.
    AngularMomentum(About),
    /// m.
    CenterOfMass,
    /// J.
    KineticEnergy,
    /// Of the elements, J.
    StrainEnergy,
    /// Potential of uniform gravity, zero in the inertial origin, J.
    GravityEnergy,
}

/// What is observed at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PointQuantity {
    /// Position, m.
    Position,
    /// Velocity, m/s.
    Velocity,
    /// Slope dp/dx, 1.
    Slope,
    /// Derivative of the position along the section's y axis, 1.
    SectionY,
    /// Derivative of the position along the section's z axis, 1.
    SectionZ,
}

/// What a section carries, in the axes of the section (of a centre line: along and across its slope).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SectionQuantity {
    /// Force along the axis, N; tension is positive.
    AxialForce,
    /// Force along the section's y axis, N.
    ShearY,
    /// Force along the section's z axis, N.
    ShearZ,
    /// Moment about the axis, N m.
    Torque,
    /// Moment about the section's y axis, N m.
    MomentY,
    /// Moment about the section's z axis, N m; of a planar body that about the plane's normal.
    MomentZ,
    /// Magnitude of the bending moment, N m.
    Moment,
    /// Largest von Mises stress over the section, Pa.
    Stress,
}

/// A place on a body.
#[derive(Clone, Debug, PartialEq)]
pub enum Location {
    /// First node.
    Start,
    /// Last node.
    End,
    /// Arclength of the stress-free axis from the start, m.
    At(Box<Expr>),
    /// Part of the length of the stress-free axis from the start.
    Part(Box<Expr>),
    /// A place on one repetition of a repeated body.
    Of {
        /// Number of the repetition, from 0; may contain [`Expr::Index`].
        instance: Box<Expr>,
        /// Where on it; not [`Location::Of`].
        place: Box<Location>,
    },
}

impl Location {
    /// Whether it is a place along the axis, not an end.
    pub fn is_along(&self) -> bool {
        matches!(self.place(), Location::At(_) | Location::Part(_))
    }

    /// The place on the body or on its repetition.
    pub fn place(&self) -> &Location {
        match self {
            Location::Of { place, .. } => place,
            own => own,
        }
    }

    /// Number of the repetition.
    pub fn instance(&self) -> Option<&Expr> {
        match self {
            Location::Of { instance, .. } => Some(instance),
            _ => None,
        }
    }
}
