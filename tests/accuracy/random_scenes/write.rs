//! A tree as the text of a model: every number that is not structure is a param, so that one text serves all draws.

mod balance;
mod observe;

use super::tree::*;

/// How a copy of a scene is written.
#[derive(Clone, Debug)]
pub struct Copy {
    /// Orthogonal: a rotation, or one with a reflection. Applied to every vector.
    pub matrix: Matrix,
    /// Determinant of `matrix`.
    pub parity: f64,
    /// Bodies that can be are cut in two by `merge`.
    pub cut: bool,
    /// Items in the opposite order, with other names.
    pub renamed: bool,
}

impl Copy {
    /// The scene as it is.
    pub const AS_IS: Copy = Copy {
        matrix: Pose::INERTIAL.axes,
        parity: 1.0,
        cut: false,
        renamed: false,
    };
}

/// How an output changes under the matrix of a copy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Nature {
    /// A vector, times the matrix.
    Polar,
    /// A vector, times the matrix and its determinant.
    Axial,
    /// A number that stays.
    Even,
    /// A number, times the determinant.
    Odd,
}

/// What an output measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    Position,
    Velocity,
    Acceleration,
    Spin,
    Angle,
    Force,
    Moment,
    Momentum,
    AngularMomentum,
}

/// An output of the text.
#[derive(Clone, Debug)]
pub struct Observed {
    pub name: String,
    pub nature: Nature,
    pub quantity: Quantity,
    /// For positions: the output that is its time derivative.
    pub rate: Option<String>,
    /// What it is of, in words.
    pub of: String,
}

/// A text with the values of its params.
#[derive(Clone, Debug)]
pub struct Text {
    pub source: String,
    pub values: Vec<f64>,
    pub outputs: Vec<Observed>,
}

struct Writer<'t> {
    tree: &'t Tree,
    copy: &'t Copy,
    params: Vec<(String, f64)>,
    items: Vec<String>,
    outputs: Vec<Observed>,
    /// Plane of the copy and sign of its normal against the turned one.
    plane: Option<(&'static str, f64)>,
}

/// The text of a tree.
pub fn text(tree: &Tree, copy: &Copy, name: &str) -> Text {
    let mut writer = Writer {
        tree,
        copy,
        params: Vec::new(),
        items: Vec::new(),
        outputs: Vec::new(),
        plane: None,
    };
    if tree.plane {
        let normal = turned(&copy.matrix, [0.0, 0.0, 1.0]);
        let axis = (0..3).find(|k| normal[*k].abs() > 0.5).unwrap_or(2);
        writer.plane = Some((["yz", "zx", "xy"][axis], normal[axis] * copy.parity));
    }
    writer.all();
    writer.finish(name)
}

fn is_inner(at: f64) -> bool {
    at > 0.0 && at < 1.0
}

impl Writer<'_> {
    fn name(&self, kind: &str, index: usize) -> String {
        if self.copy.renamed {
            format!("zz_{index}{kind}_q")
        } else {
            format!("{kind}{index}")
        }
    }

    fn frame(&self, frame: Option<usize>) -> String {
        frame.map_or("inertial".to_string(), |frame| self.name("f", frame))
    }

    fn number(&mut self, value: f64, unit: &str) -> String {
        let name = format!("p{}", self.params.len());
        let shown = if unit == "1" { String::new() } else { format!(" {unit}") };
        self.params.push((format!("param {name} = {value:?}{shown};"), value));
        name
    }

    fn count(&mut self, value: usize) -> String {
        let name = format!("p{}", self.params.len());
        self.params
            .push((format!("param {name}: count = {value};"), value as f64));
        name
    }

    /// A vector of params; components that are zero for structural reasons are written as such.
    fn components(&mut self, v: Vector, unit: &str) -> String {
        let texts: Vec<String> = v
            .iter()
            .map(|x| {
                if *x == 0.0 {
                    "0".to_string()
                } else {
                    self.number(*x, unit)
                }
            })
            .collect();
        format!("[{}]", texts.join(", "))
    }

    /// `a + b * what` of two vectors of params; components of which both are zero are written as such.
    fn growing(&mut self, [a, b]: [Vector; 2], units: [&str; 2], what: &str) -> String {
        let mut component = |k: usize| {
            if a[k] == 0.0 && b[k] == 0.0 {
                return "0".to_string();
            }
            let (a, b) = (self.number(a[k], units[0]), self.number(b[k], units[1]));
            format!("{a} + {b} * {what}")
        };
        format!("[{}]", [component(0), component(1), component(2)].join(", "))
    }

    fn polar(&mut self, v: Vector, unit: &str) -> String {
        let v = turned(&self.copy.matrix, v);
        self.components(v, unit)
    }

    fn axial(&mut self, v: Vector, unit: &str) -> String {
        let v = scaled(turned(&self.copy.matrix, v), self.copy.parity);
        self.components(v, unit)
    }

    fn constant(&self, v: Vector, parity: f64) -> String {
        let v = scaled(turned(&self.copy.matrix, v), parity);
        let texts: Vec<String> = v.iter().map(|x| format!("{:?}", x + 0.0)).collect();
        format!("[{}]", texts.join(", "))
    }

    /// A point in the axes of a frame.
    fn point(&mut self, frame: Option<usize>, point: Vector) -> String {
        let local = self.tree.pose(frame).local(point);
        self.polar(clean(local), "m")
    }

    /// Where the cut of a body is, as a fraction.
    fn cut(&self, body: usize) -> Option<(usize, f64)> {
        let body = &self.tree.bodies[body];
        let can = self.copy.cut && body.elements > 1 && body.tie != Tie::MeanAxes;
        can.then(|| (body.elements / 2, (body.elements / 2) as f64 / body.elements as f64))
    }

    fn place(&mut self, place: Place) -> String {
        match place {
            Place::Ground(point) => {
                let point = self.point(None, point);
                format!("inertial.at({point})")
            }
            Place::Frame(frame, point) => {
                let point = self.point(Some(frame), point);
                format!("{}.at({point})", self.name("f", frame))
            }
            Place::Body(body, at) => {
                let name = self.name("b", body);
                let cut = self.cut(body);
                let length = self.tree.bodies[body].length;
                match (cut, at) {
                    (None, 0.0) => format!("{name}.start"),
                    (None, 1.0) => format!("{name}.end"),
                    (None, at) => {
                        let at = self.number(at * length, "m");
                        format!("{name}.at({at})")
                    }
                    (Some(_), 0.0) => format!("{name}.start"),
                    (Some(_), 1.0) => format!("{name}_2.end"),
                    (Some((_, cut)), at) if at <= cut => {
                        let at = self.number(at * length, "m");
                        format!("{name}.at({at})")
                    }
                    (Some((_, cut)), at) => {
                        let at = self.number((at - cut) * length, "m");
                        format!("{name}_2.at({at})")
                    }
                }
            }
        }
    }

    fn all(&mut self) {
        for index in 0..self.tree.frames.len() {
            let item = self.frame_item(index);
            self.items.push(item);
        }
        for index in 0..self.tree.bodies.len() {
            self.body_item(index);
        }
        for index in 0..self.tree.joints.len() {
            self.joint_item(index);
        }
        for index in 0..self.tree.springs.len() {
            let item = self.spring_item(index);
            self.items.push(item);
        }
        for index in 0..self.tree.loads.len() {
            let item = self.load_item(index);
            self.items.push(item);
        }
        if let Some(gravity) = self.tree.gravity {
            let gravity = self.polar(gravity, "m/s^2");
            let name = self.name("g", 0);
            self.items.push(format!("load {name} = gravity({gravity});"));
        }
        self.observe();
    }

    /// `1 - cos(rate t)` or `sin(rate t)`.
    fn wave(&mut self, rate: f64, spinning: bool) -> String {
        let rate = self.number(rate, "rad/s");
        if spinning {
            format!("sin({rate} * t)")
        } else {
            format!("(1 - cos({rate} * t))")
        }
    }

    fn frame_item(&mut self, index: usize) -> String {
        let frame = &self.tree.frames[index];
        let name = self.name("f", index);
        let inside = match frame.parent {
            Some(parent) => format!(" in {}", self.name("f", parent)),
            None => String::new(),
        };
        let parent = self.tree.pose(frame.parent);
        let planar = self.tree.plane;
        // In a plane an angle counts about the normal of the plane, which may be the opposite of the turned one.
        let sign = self.plane.map_or(1.0, |(_, sign)| sign);
        match &frame.kind {
            Kind::Rotating {
                amplitude,
                rate,
                spinning,
            } => {
                let axis = self.constant(frame.axis, self.copy.parity);
                let angle = self.number(frame.angle, "rad");
                let amplitude = self.number(*amplitude, "rad");
                let wave = self.wave(*rate, *spinning);
                let origin = self.polar(clean(parent.local(frame.pose.origin)), "m");
                format!(
                    "frame {name}{inside} = rotating(axis = {axis}, angle = {angle} + {amplitude} * {wave}, origin = {origin});"
                )
            }
            Kind::Moving { way, rate } => {
                let rate = self.number(*rate, "rad/s");
                let origin = turned(&self.copy.matrix, clean(parent.local(frame.pose.origin)));
                let way = turned(&self.copy.matrix, clean(parent.turned_back(*way)));
                let origin = self.growing([origin, way], ["m", "m"], &format!("(1 - cos({rate} * t))"));
                format!("frame {name}{inside} = moving(origin = {origin});")
            }
            Kind::Free | Kind::Rigid { .. } => {
                let origin = self.polar(clean(parent.local(frame.pose.origin)), "m");
                let velocity = self.polar(clean(parent.turned_back(frame.velocity)), "m/s");
                let mut fields = vec![format!("origin = {origin}"), format!("velocity = {velocity}")];
                if let Some((plane, _)) = self.plane {
                    let angle = self.number(sign * frame.angle, "rad");
                    let speed = self.number(sign * frame.spin[2], "rad/s");
                    fields.push(format!("angle = {angle}"));
                    fields.push(format!("speed = {speed}"));
                    if matches!(frame.kind, Kind::Free) {
                        fields.insert(0, format!("plane = {plane}"));
                    }
                } else {
                    let axis = self.constant(frame.axis, self.copy.parity);
                    let angle = self.number(frame.angle, "rad");
                    let spin = self.axial(clean(frame.pose.turned_back(frame.spin)), "rad/s");
                    fields.push(format!("axis = {axis}"));
                    fields.push(format!("angle = {angle}"));
                    fields.push(format!("angular_velocity = {spin}"));
                }
                let Kind::Rigid { mass, center, inertia } = &frame.kind else {
                    return format!("frame {name}{inside} = free({});", fields.join(", "));
                };
                let mass = self.number(*mass, "kg");
                fields.push(format!("mass = {mass}"));
                let center = self.polar(*center, "m");
                fields.push(format!("center = {center}"));
                if planar {
                    let about = self.number(inertia[2][2], "kg*m^2");
                    fields.push(format!("inertia = {about}"));
                } else {
                    let s = &self.copy.matrix;
                    let i = product(&product(s, inertia), &transposed(s));
                    let six = [i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]];
                    let texts: Vec<String> = six.iter().map(|x| self.number(*x, "kg*m^2")).collect();
                    fields.push(format!("inertia = [{}]", texts.join(", ")));
                }
                let plane = self
                    .plane
                    .map_or(String::new(), |(plane, _)| format!("plane {plane}; "));
                format!("rigid {name}{inside} {{ {plane}{}; }}", fields.join("; "))
            }
        }
    }

    fn body_item(&mut self, index: usize) {
        let body = &self.tree.bodies[index];
        let name = self.name("b", index);
        let (material, section) = (self.name("m", index), self.name("s", index));
        let density = self.number(body.density, "kg/m^3");
        let young = self.number(body.young, "Pa");
        let damping = self.number(body.damping, "s");
        let poisson = if body.is_cable {
            String::new()
        } else {
            format!(" poisson = {};", self.number(body.poisson, "1"))
        };
        self.items.push(format!(
            "material {material} {{ density = {density}; young = {young}; damping = {damping};{poisson} }}"
        ));
        let radius = self.number(body.radius, "m");
        let item = match body.side {
            Some(side) => {
                let side = self.number(side, "m");
                format!("section {section} = rectangle(y = 2 * {radius}, z = {side});")
            }
            None => format!("section {section} = circle(radius = {radius});"),
        };
        self.items.push(item);
        let inside = body
            .frame
            .map_or(String::new(), |frame| format!(" in {}", self.name("f", frame)));
        let space = match self.plane {
            Some((plane, _)) => format!("planar {plane};"),
            None => "spatial;".to_string(),
        };
        let to = add(body.from, scaled(body.direction, body.length));
        let parts = match self.cut(index) {
            None => vec![(name.clone(), body.from, to, body.elements)],
            Some((first, at)) => {
                let middle = add(body.from, scaled(body.direction, at * body.length));
                vec![
                    (name.clone(), body.from, middle, first),
                    (format!("{name}_2"), middle, to, body.elements - first),
                ]
            }
        };
        let merged = parts.len() > 1;
        for (name, from, to, elements) in parts {
            let direction = self.tree.pose(body.frame).turned_back(body.direction);
            let (start, end) = (self.point(body.frame, from), self.point(body.frame, to));
            let mut statements = vec![space.clone(), format!("line from {start} to {end};")];
            if let Some(y) = body.section_y {
                let y = self.polar(clean(self.tree.pose(body.frame).turned_back(y)), "1");
                statements.push(format!("section_y {y};"));
            }
            let elements = self.count(elements);
            let (word, options) = match (body.is_cable, body.exact_bending) {
                (true, true) => ("cable", ", bending = exact"),
                (true, false) => ("cable", ""),
                (false, _) => ("beam", ""),
            };
            statements.push(format!("mesh {elements} * {word}({section}, {material}{options});"));
            if body.tie == Tie::MeanAxes {
                statements.push("mean_axes;".to_string());
            }
            if let Some((velocity, spin)) = body.moving {
                // v(x) = v0 + w x (from + x direction), in the inertial frame.
                let at = turned(&self.copy.matrix, clean(add(velocity, cross(spin, from))));
                let along = turned(&self.copy.matrix, clean(cross(spin, direction)));
                let velocity = self.growing([at, along], ["m/s", "1/s"], "x");
                statements.push(format!("initial velocity {velocity};"));
            }
            self.items
                .push(format!("body {name}{inside} {{ {} }}", statements.join(" ")));
        }
        if merged {
            self.items
                .push(format!("joint {name}_along = merge({name}.end, {name}_2.start);"));
        }
        if let (Tie::Clamp, Some(frame)) = (body.tie, body.frame) {
            let frame = self.name("f", frame);
            self.items
                .push(format!("joint {name}_tie = clamp({name}.start, {frame});"));
        }
    }

    fn joint_item(&mut self, index: usize) {
        let joint = &self.tree.joints[index];
        let name = self.name("j", index);
        let (a, b) = (self.place(joint.a), self.place(joint.b));
        let mut arguments = match joint.word {
            // An end is held by a frame, without a point.
            "clamp" | "clamp_full" => match joint.b {
                Place::Frame(frame, _) => format!("{a}, {}", self.name("f", frame)),
                _ => format!("{a}, inertial"),
            },
            _ => format!("{a}, {b}"),
        };
        if !self.tree.plane || matches!(joint.word, "prismatic") {
            if let Some(axis) = joint.axis {
                arguments += &format!(", axis = {}", self.constant(axis, 1.0));
            }
            if let Some(cross) = joint.cross {
                arguments += &format!(", cross = {}", self.constant(cross, 1.0));
            }
        }
        self.items.push(format!("joint {name} = {}({arguments});", joint.word));
        // An angle counts about the joint's axis; in a plane about the plane's normal.
        let sign = self.plane.map_or(self.copy.parity, |(_, sign)| sign);
        if let Some([amplitude, rate]) = joint.drive {
            let amplitude = self.number(sign * amplitude, "rad");
            let wave = self.wave(rate, false);
            self.items.push(format!(
                "joint {name}_drive = drive({name}.angle, {amplitude} * {wave});"
            ));
        }
        if let Some([stiffness, damping]) = joint.coil {
            let stiffness = self.number(stiffness, "N*m/rad");
            let damping = self.number(damping, "N*m*s/rad");
            self.items.push(format!(
                "spring {name}_coil = torsional({name}, stiffness = {stiffness}, damping = {damping});"
            ));
        }
    }

    fn spring_item(&mut self, index: usize) -> String {
        let name = self.name("k", index);
        let spring = &self.tree.springs[index];
        match spring {
            Spring::Linear {
                a,
                b,
                stiffness,
                damping,
                length,
            } => {
                let (a, b) = (self.place(*a), self.place(*b));
                let stiffness = self.number(*stiffness, "N/m");
                let damping = self.number(*damping, "N*s/m");
                let length = self.number(*length, "m");
                format!(
                    "spring {name} = linear({a}, {b}, stiffness = {stiffness}, damping = {damping}, length = {length});"
                )
            }
            Spring::Law { a, b, cubic, length } => {
                let (a, b) = (self.place(*a), self.place(*b));
                let cubic = self.number(*cubic, "N/m^3");
                let rest = self.number(*length, "m");
                format!("spring {name} = law({a}, {b}, force = {cubic} * (length - {rest})^3);")
            }
            Spring::Bushing {
                a,
                b,
                stiffness,
                damping,
            } => {
                let (a, b) = (self.place(*a), self.place(*b));
                let k = self.number(*stiffness, "N/m");
                let c = self.number(*damping, "N*s/m");
                let three = |x: String| match self.plane {
                    None => format!("[{x}, {x}, {x}]"),
                    Some(("xy", _)) => format!("[{x}, {x}, 0]"),
                    Some(("yz", _)) => format!("[0, {x}, {x}]"),
                    Some(_) => format!("[{x}, 0, {x}]"),
                };
                let (k, c) = (three(k), three(c));
                format!("spring {name} = bushing({a}, {b}, stiffness = {k}, damping = {c});")
            }
        }
    }

    /// Components times a wave.
    fn varying(&mut self, v: Vector, rate: f64, unit: &str) -> String {
        if rate == 0.0 {
            return self.components(v, unit);
        }
        let rate = self.number(rate, "rad/s");
        let texts: Vec<String> = v
            .iter()
            .map(|x| {
                if *x == 0.0 {
                    "0".to_string()
                } else {
                    format!("{} * sin({rate} * t)", self.number(*x, unit))
                }
            })
            .collect();
        format!("[{}]", texts.join(", "))
    }

    fn load_item(&mut self, index: usize) -> String {
        let name = self.name("l", index);
        match &self.tree.loads[index] {
            Load::Force { at, force, rate, axes } => {
                let at = self.place(*at);
                let local = clean(self.tree.pose(*axes).turned_back(*force));
                let force = self.varying(turned(&self.copy.matrix, local), *rate, "N");
                format!("load {name} = force({at}, {force}, in = {});", self.frame(*axes))
            }
            Load::Moment { at, moment, rate } => {
                let at = self.place(*at);
                let moment = scaled(turned(&self.copy.matrix, *moment), self.copy.parity);
                let moment = self.varying(moment, *rate, "N*m");
                format!("load {name} = moment({at}, {moment});")
            }
            Load::Follower { at, force } => {
                let at = self.place(*at);
                let force = self.number(*force, "N");
                format!("load {name} = follower({at}, {force});")
            }
            Load::Density { body, force } => {
                let frame = self.tree.bodies[*body].frame;
                let local = clean(self.tree.pose(frame).turned_back(*force));
                let force = self.polar(local, "N/m");
                let name_of = self.name("b", *body);
                let mut item = format!("load {name} = density({name_of}, {force});");
                if self.cut(*body).is_some() {
                    item += &format!(" load {name}_2 = density({name_of}_2, {force});");
                }
                item
            }
        }
    }

    fn finish(mut self, name: &str) -> Text {
        if self.copy.renamed {
            // Outputs keep their order, which is how they are compared.
            let (outputs, mut others): (Vec<String>, Vec<String>) =
                self.items.into_iter().partition(|item| item.starts_with("output"));
            others.reverse();
            self.items = others.into_iter().chain(outputs).collect();
        }
        let mut source = format!("model {name} {{\n");
        for (text, _) in &self.params {
            source += &format!("        {text}\n");
        }
        for item in &self.items {
            source += &format!("        {item}\n");
        }
        source += "    }\n";
        Text {
            source,
            values: self.params.into_iter().map(|(_, value)| value).collect(),
            outputs: self.outputs,
        }
    }
}

/// What is zero but for round-off is a structural zero.
fn clean(v: Vector) -> Vector {
    v.map(|x| if x.abs() < 1e-14 { 0.0 } else { x })
}
