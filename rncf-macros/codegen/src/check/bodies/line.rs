//! Stress-free axes of bodies, and how their sections lie along them.

use super::body::Known;
use crate::check::frames::plane::{is_zero, normal, plane};
use crate::check::values::arithmetic::{cross, dot, norm, subtract};
use crate::check::values::quantity::{Typed, Vector, Wanted};
use crate::check::values::scope::Scope;
use crate::check::values::words::AXES;
use crate::check::{Check, fold, say};
use crate::elements::Element;
use crate::errors::Area;
use crate::joints::algebra;
use crate::model::{Column, Expr as Value, Line, Piece, Space};
use crate::parse::tree::{Expr, Item, Name, Statement};

const FROM: Wanted = Wanted {
    what: "the start of the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const TO: Wanted = Wanted {
    what: "the end of the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const POSITION: Wanted = Wanted {
    what: "the axis",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const RADIUS: Wanted = Wanted {
    what: "the radius",
    dimension: [1, 0, 0, 0, 0, 0],
    unit: "m",
};
const NORMAL: Wanted = Wanted {
    what: "the normal of an arc",
    dimension: [0; 6],
    unit: "1",
};
const SECTION_Y: Wanted = Wanted {
    what: "the section's y axis",
    dimension: [0; 6],
    unit: "1",
};
const DIRECTION: Wanted = Wanted {
    what: "a direction",
    dimension: [0; 6],
    unit: "1",
};

/// Sine of the angle below which two directions count as parallel.
const PARALLEL: f64 = 1e-6;

/// Angle by which one element may be bent or twisted, rad; the run time has the same limit.
const MOST_TURN: f64 = std::f64::consts::FRAC_PI_2;

/// How the section of a body lies along its axis.
pub struct SectionAxes {
    /// Direction of its y axis at the start, where given.
    pub y: Option<[Value; 3]>,
    /// Angle from the start to the end, rad.
    pub twist: Value,
}

impl<'a> Check<'a> {
    pub(in crate::check) fn line(
        &mut self,
        item: &Item,
        statements: &'a [Statement],
        complete: bool,
        known: &mut Known,
    ) -> Option<Line> {
        let missing = "its stress-free axis: `line from [..] m to [..] m;` or `arc ..;`";
        let statement = self.single(
            item,
            statements,
            complete,
            "`line`, `arc` or `curve`",
            missing,
            |statement| match statement {
                Statement::Line { area, .. }
                | Statement::Arc { area, .. }
                | Statement::Curve { area, .. }
                | Statement::Path { area, .. } => Some(*area),
                _ => None,
            },
        )?;
        match statement {
            Statement::Line { area, from, to, .. } => self.straight(*area, from, to, known),
            Statement::Arc { .. } => self.arc(statement, known),
            Statement::Curve { table, directions, .. } => self.curve(table, directions, known),
            Statement::Path {
                position,
                parameter,
                range,
                ..
            } => self.path(position, parameter, range, known),
            _ => None,
        }
    }

    fn straight(&mut self, area: Area, from: &'a Expr, to: &'a Expr, known: &mut Known) -> Option<Line> {
        let from_vector = self.vector(from, Scope::Parameter, FROM);
        let to_vector = self.vector(to, Scope::Parameter, TO);
        let (from_vector, to_vector) = (from_vector?, to_vector?);
        for vector in [&from_vector, &to_vector] {
            self.in_space(vector, known.space, "the axis");
        }
        if let (Some(a), Some(b)) = (from_vector.constant(), to_vector.constant()) {
            let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
            let length = d[0].hypot(d[1]).hypot(d[2]);
            if !(length > 0.0 && length.is_finite()) {
                self.errors.at(area.to(to.area), say::ZERO_LENGTH);
                return None;
            }
            known.length = Some(length);
        }
        known.tangent = direction(&from_vector, &to_vector);
        Some(Line::Straight {
            from: from_vector.values,
            to: to_vector.values,
        })
    }

    /// Where a straight piece lies along an axis with corners; `None` of a whole axis.
    pub(in crate::check) fn piece(&mut self, statements: &'a [Statement]) -> Option<Piece> {
        let (points, number) = statements.iter().find_map(|statement| match statement {
            Statement::Piece { points, number } => Some((points, *number)),
            _ => None,
        })?;
        let places: Option<Vec<[Value; 3]>> = points
            .iter()
            .map(|point| Some(self.vector(point, Scope::Parameter, FROM)?.values))
            .collect();
        let lengths: Vec<Value> = places?
            .windows(2)
            .map(|ends| algebra::norm(&algebra::both(&ends[1], &ends[0], algebra::subtract)))
            .collect();
        let sum = |lengths: &[Value]| lengths.iter().cloned().fold(Value::Number(0.0), algebra::add);
        Some(Piece {
            from: sum(&lengths[..number]),
            whole: sum(&lengths),
        })
    }

    /// `curve through table from direction [..] to direction [..];`
    fn curve(&mut self, name: &Name, declared: &'a [Option<Expr>; 2], known: &Known) -> Option<Line> {
        let mut directions = [None; 2];
        for (direction, expr) in directions.iter_mut().zip(declared) {
            let Some(expr) = expr else { continue };
            let found = self.axis(expr)?;
            if let Some(normal) = known.space.and_then(normal).filter(|&normal| found[normal] != 0.0) {
                let message = say::out_of_plane("the direction", plane(normal), AXES[normal]);
                self.errors.at(expr.area, message);
                return None;
            }
            *direction = Some(found);
        }
        let id = self.table(name)?;
        let table = &self.model.tables[id.0];
        let coordinate = |word: &str| {
            let is_it = |column: &Column| column.name == word && column.dimension == POSITION.dimension;
            table.columns.iter().position(is_it)
        };
        let Some(columns) = coordinate("x")
            .zip(coordinate("y"))
            .zip(coordinate("z"))
            .map(|((x, y), z)| [x, y, z])
        else {
            self.errors.at(name.span, say::CURVE_TABLE);
            return None;
        };
        // Of a file that a run names, the program checks the same of its rows.
        if let Some(normal) = known.space.and_then(normal)
            && let Some(&off) = table.columns[columns[normal]].values.iter().find(|off| **off != 0.0)
        {
            let message = say::curve_off_plane(plane(normal), AXES[normal], off);
            self.errors.at(name.span, message);
            return None;
        }
        let points = table.points(columns);
        let chords = [0, points.len() - 2].map(|at| subtract(points[at + 1], points[at]));
        for ((direction, expr), chord) in directions.iter().zip(declared).zip(chords) {
            let (Some(direction), Some(expr)) = (direction, expr) else {
                continue;
            };
            // Of a file that a run names, too, as it is now: it stands for the others.
            if dot(*direction, chord) <= 0.0 {
                self.errors.at(expr.area, say::CURVE_BACKWARDS);
                return None;
            }
        }
        Some(Line::Curve {
            table: id,
            columns,
            directions,
        })
    }

    /// `curve [..] for s from a to b;`
    fn path(
        &mut self,
        position: &'a Expr,
        parameter: &'a Name,
        [from, to]: &'a [Expr; 2],
        known: &Known,
    ) -> Option<Line> {
        let (start, end) = (self.expr(from, Scope::Parameter), self.expr(to, Scope::Parameter));
        let (start, end) = (start?, end?);
        if start.dimension != end.dimension {
            self.unlike_terms(from, &start, to, &end);
            return None;
        }
        self.same_turns((from, start.nature), (to, end.nature))?;
        if let Some(item) = self.names.get(parameter.text.as_str()) {
            let line = item.name.span.start().line.to_string();
            self.errors
                .at(parameter.span, say::curve_parameter(&parameter.text, &line));
            return None;
        }
        let mut typed = Typed::new(Value::Arclength, start.dimension);
        typed.nature = start.nature.plus(end.nature);
        self.locals.insert(&parameter.text, typed);
        let vector = self.vector(position, Scope::Parameter, POSITION);
        self.locals.clear();
        let vector = vector?;
        self.in_space(&vector, known.space, "the axis");
        let moving = vector.values.iter().zip(vector.areas);
        let moving = moving.chain([(&start.value, from.area), (&end.value, to.area)]);
        for (value, area) in moving {
            if fold::has_motion(value) {
                self.errors.at(area, say::CURVE_WITHOUT_TIME);
                return None;
            }
        }
        if fold::constant(&start.value).is_some_and(|start| fold::constant(&end.value) == Some(start)) {
            self.errors.at(from.area.to(to.area), say::CURVE_RANGE);
            return None;
        }
        if !vector.values.iter().any(fold::has_arclength) {
            self.errors.at(position.area, say::curve_constant(&parameter.text));
            return None;
        }
        Some(Line::Path {
            position: vector.values,
            range: [start.value, end.value],
        })
    }

    fn in_space(&mut self, vector: &Vector, space: Option<Space>, what: &str) {
        if let Some(space) = space {
            self.in_plane(vector, space, what);
        }
    }

    fn arc(&mut self, statement: &'a Statement, known: &mut Known) -> Option<Line> {
        let Statement::Arc {
            from,
            direction,
            normal: declared,
            radius,
            angle,
            ..
        } = statement
        else {
            return None;
        };
        let from = self.vector(from, Scope::Parameter, FROM);
        let direction_vector = self.vector(direction, Scope::Parameter, DIRECTION);
        let normal = self.arc_normal(declared.as_deref(), known.space);
        let radius_value = self.quantity(radius, Scope::Parameter, RADIUS);
        let angle_value = self.angle(angle, Scope::Parameter, "the angle of an arc");
        let radius_constant = radius_value.as_ref().and_then(fold::constant);
        let angle_constant = angle_value.as_ref().and_then(fold::constant);
        if radius_constant.is_some_and(|radius| radius.is_nan() || radius <= 0.0) {
            self.errors.at(radius.area, say::positive("the radius"));
        }
        if angle_constant == Some(0.0) {
            self.errors.at(angle.area, say::ZERO_ANGLE);
        }
        let (from, direction_vector) = (from?, direction_vector?);
        if is_zero(&direction_vector.values) {
            self.errors.at(direction.area, say::ZERO_DIRECTION);
        } else if let (Some(normal), Some(declared)) = (&normal, declared)
            && is_along(normal, &direction_vector.values)
        {
            self.errors.at(declared.area, say::NORMAL_ALONG);
        }
        self.in_space(&from, known.space, "the axis");
        self.in_space(&direction_vector, known.space, "the direction");
        known.length = radius_constant
            .zip(angle_constant)
            .map(|(radius, angle)| (radius * angle).abs());
        Some(Line::Arc {
            from: from.values,
            direction: direction_vector.values,
            normal: normal?,
            radius: radius_value?,
            angle: angle_value?,
        })
    }

    /// The normal of an arc's plane: that of the body's plane, or what is declared.
    fn arc_normal(&mut self, declared: Option<&'a Expr>, space: Option<Space>) -> Option<[Value; 3]> {
        let own = space.and_then(normal);
        let axis = |normal: usize| std::array::from_fn(|axis| Value::Number(f64::from(u8::from(axis == normal))));
        let Some(expr) = declared else {
            // That it is missing in space is reported with the element.
            return Some(axis(own.unwrap_or(2)));
        };
        if let Some(own) = own {
            self.errors.at(expr.area, say::normal_in_plane(plane(own), AXES[own]));
            return Some(axis(own));
        }
        let vector = self.vector(expr, Scope::Parameter, NORMAL)?;
        if is_zero(&vector.values) {
            self.errors.at(expr.area, say::ZERO_DIRECTION);
            return None;
        }
        Some(vector.values)
    }

    /// A curved axis, or a twisted section: its element must know it from a strained one, and the plane of an arc in space be known.
    pub(in crate::check) fn curved(
        &mut self,
        element: &Element,
        options: &[usize],
        statements: &[Statement],
        space: Option<Space>,
    ) {
        let Some(space) = space else {
            return;
        };
        let stressed = element.stressed_by_curvature(space.dimension(), options);
        for statement in statements {
            let (area, normal) = match statement {
                Statement::Arc { area, normal, .. } => (area, normal.is_some()),
                Statement::Curve { area, .. } | Statement::Path { area, .. } => (area, true),
                Statement::Twist { area, .. } if element.has_section() => (area, true),
                _ => continue,
            };
            if let Some(part) = stressed {
                if space == Space::Spatial && !element.has_section() {
                    self.errors.at(*area, say::CURVED_IN_SPACE);
                } else {
                    self.errors.at(*area, say::curved_energy(part));
                }
            } else if !normal && space == Space::Spatial {
                self.errors.at(*area, say::MISSING_NORMAL);
            }
        }
    }

    /// `section_y [..];` and `twist ..;`, for elements with a section in space; `None`: reported.
    pub(in crate::check) fn section_axes(
        &mut self,
        statements: &'a [Statement],
        space: Option<Space>,
        line: Option<&Line>,
    ) -> Option<SectionAxes> {
        let mut axes = SectionAxes {
            y: None,
            twist: Value::Number(0.0),
        };
        let mut is_whole = true;
        let mut lines: [Option<usize>; 2] = [None, None];
        for statement in statements {
            let (which, area, value) = match statement {
                Statement::SectionY { area, value } => (0, *area, value),
                Statement::Twist { area, value } => (1, *area, value),
                _ => continue,
            };
            let word = ["section_y", "twist"][which];
            if let Some(line) = lines[which] {
                let message = say::duplicate_statement(&format!("`{word}`"), &line.to_string());
                self.errors.at(area, message);
                is_whole = false;
                continue;
            }
            lines[which] = Some(area.line());
            is_whole &= self.may_lie(statements, word, area, space);
            if which == 1 {
                match self.along_axis(|check| check.angle(value, Scope::Parameter, "the twist")) {
                    Some(twist) => axes.twist = twist,
                    None => is_whole = false,
                }
                continue;
            }
            axes.y = self.section_y(value, line);
            is_whole &= axes.y.is_some();
        }
        is_whole.then_some(axes)
    }

    fn section_y(&mut self, value: &'a Expr, line: Option<&Line>) -> Option<[Value; 3]> {
        let vector = self.vector(value, Scope::Parameter, SECTION_Y)?;
        let tangent = line.and_then(|line| match line {
            Line::Straight { from, to } => Some(std::array::from_fn(|axis| {
                algebra::subtract(to[axis].clone(), from[axis].clone())
            })),
            Line::Arc { direction, .. } => Some(direction.clone()),
            Line::Imported(_) => Some([1.0, 0.0, 0.0].map(Value::Number)),
            Line::Curve {
                table,
                columns,
                directions,
            } => {
                let points = self.model.tables[table.0].points(*columns);
                let chord = std::array::from_fn(|axis| points[1][axis] - points[0][axis]);
                Some(directions[0].unwrap_or(chord).map(Value::Number))
            }
            // Its sections are checked where they are, when the model is built.
            Line::Path { .. } => None,
        });
        let message = if is_zero(&vector.values) {
            say::ZERO_DIRECTION
        } else if tangent.is_some_and(|tangent| is_along(&vector.values, &tangent)) {
            say::SECTION_Y_ALONG
        } else {
            return Some(vector.values);
        };
        self.errors.at(value.area, message);
        None
    }

    /// Reports elements that would have to be bent or twisted by more than they can follow, with the defaults of the params.
    pub(in crate::check) fn is_fine_enough(
        &mut self,
        statements: &[Statement],
        line: &Line,
        twist: Option<&Value>,
        count: &Value,
    ) {
        let count = self.default(count);
        for statement in statements {
            let (value, area, what) = match (statement, line) {
                (Statement::Arc { angle: written, .. }, Line::Arc { angle, .. }) => (Some(angle), written.area, "bent"),
                (Statement::Twist { value, .. }, _) => (twist, value.area, "twisted"),
                _ => continue,
            };
            let Some(angle) = value.map(|value| self.default(value).abs()) else {
                continue;
            };
            if angle > count * MOST_TURN * (1.0 + PARALLEL) {
                let (each, needed) = (
                    (angle / count).to_degrees(),
                    (angle / MOST_TURN * (1.0 - PARALLEL)).ceil(),
                );
                let message = say::turned_too_far(what, &format!("{each:.0}"), &format!("{needed:.0}"));
                self.errors.at(area, message);
            }
        }
    }

    /// Only sections in space can be turned about the axis.
    fn may_lie(&mut self, statements: &[Statement], word: &str, area: Area, space: Option<Space>) -> bool {
        let element = statements.iter().find_map(|statement| match statement {
            Statement::Mesh { element, .. } => Some(element.name.text.as_str()),
            _ => None,
        });
        let known = element.and_then(|name| Some((name, self.library.find(name)?)));
        let message = match (known, space) {
            (Some((name, id)), _) if !self.library.elements[id].has_section() => say::no_section_axes(name, word),
            (_, Some(Space::Planar { .. })) => say::section_in_plane(word),
            _ => return true,
        };
        self.errors.at(area, message);
        false
    }
}

/// Unit vector from one point to another, where it is the same for all params.
fn direction(from: &Vector, to: &Vector) -> Option<[f64; 3]> {
    let unit = |sample| {
        let (a, b) = (from.sampled(sample)?, to.sampled(sample)?);
        let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let length = norm(d);
        (length > 0.0).then(|| d.map(|x| x / length))
    };
    let first = unit(0)?;
    let is_same = |sample| unit(sample).is_some_and(|other| norm(cross(first, other)) <= PARALLEL);
    (1..fold::SAMPLES).all(is_same).then_some(first)
}

/// Whether two constant vectors are parallel.
fn is_along(a: &[Value; 3], b: &[Value; 3]) -> bool {
    let constant = |vector: &[Value; 3]| -> Option<[f64; 3]> {
        let [x, y, z] = vector.each_ref().map(fold::constant);
        Some([x?, y?, z?])
    };
    let (Some(a), Some(b)) = (constant(a), constant(b)) else {
        return false;
    };
    norm(cross(a, b)) <= PARALLEL * norm(a) * norm(b)
}
