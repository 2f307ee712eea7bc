//! Conditions of joints: written down as C(q, t) = 0, with every derivative derived.

use std::collections::HashMap;

use super::kernel::Kernel;
use crate::model::{Held, INERTIAL, Joint, JointKind, Model};
use crate::symbolic::Time;
use crate::symbolic::{Graph, Id, linear::Vector};

/// The conditions of a joint in one formulation.
#[derive(Clone, Debug)]
pub struct JointKernels {
    /// Values: position level, and what the rate, acceleration and jerk levels are with the highest
    /// derivative of q set to zero; `None` where nothing is left of it, as of conditions that do not change
    /// with time.
    pub levels: [Option<Kernel>; 4],
    /// Derivatives with respect to the position and the directions after it, without zeros.
    pub jacobian: Kernel,
    /// What is prescribed where the conditions are eliminated, without zeros.
    pub prescribed: Kernel,
}

/// Names of the levels, in order.
pub const LEVELS: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];

struct Conditions<'m> {
    time: Time<'m>,
    /// Symbols of the position and of the directions after it, their rates and accelerations.
    q: [Vec<Id>; 3],
    rows: Vec<Id>,
    /// Prescribed position and directions.
    targets: Vec<Vector>,
}

/// Directions that the conditions of a joint are about, by the names of their constants: the slope, or the
/// axes of the section where the body has them.
fn directions(kind: JointKind, has_section: bool, dimension: usize) -> &'static [&'static str] {
    const ALL: [&str; 2] = ["data.tangent", "data.second"];
    let holds_slope = matches!(kind, JointKind::Hold { of: Held::Slope, .. });
    if has_section && !holds_slope {
        &ALL[..dimension - 1]
    } else {
        &ALL[..1]
    }
}

impl<'m> Conditions<'m> {
    fn new(model: &'m Model, joint: &Joint, has_section: bool, absolute: bool) -> Self {
        let mut time = Time::new(model);
        let body = &model.bodies[joint.body.0];
        let (axes, dimension) = (body.space.axes(), body.space.dimension());
        let frame = if absolute { INERTIAL } else { body.frame };
        let (rotation, offset) = time.relative_pose(joint.frame, frame);
        let mut symbols =
            |text: &str| -> Vec<Id> { (0..3).map(|i| time.graph.symbol(format!("{text}[{i}]"))).collect() };
        let point = symbols("data.point");
        let directions = directions(joint.kind, has_section, dimension);
        let directions: Vec<Vector> = directions.iter().map(|name| symbols(name)).collect();
        let normals = ["data.normals[0]", "data.normals[1]"].map(&mut symbols);
        let q = ["q", "v", "a"].map(|word| {
            (0..(1 + directions.len()) * dimension)
                .map(|i| time.graph.symbol(format!("{word}[{i}]")))
                .collect::<Vec<Id>>()
        });
        let pick = |vector: &[Id]| -> Vector { axes.iter().map(|&axis| vector[axis]).collect() };
        let place = |graph: &mut Graph, vector: &[Id]| {
            let turned = graph.apply(&rotation, vector);
            pick(&turned)
        };
        let moved = time.graph.apply(&rotation, &point);
        let moved = time.graph.add_vectors(&offset, &moved);
        let position = pick(&moved);
        let mut targets = vec![position];
        for along in &directions {
            targets.push(place(&mut time.graph, along));
        }
        let mut rows = time.graph.subtract_vectors(&q[0][..dimension], &targets[0]);
        match joint.kind {
            JointKind::Pin => {}
            JointKind::Hold { of, axis } => {
                let vector = match of {
                    Held::Position => 0,
                    Held::Slope | Held::SectionY => 1,
                    Held::SectionZ => 2,
                };
                let unit: Vec<Id> = (0..3)
                    .map(|i| time.graph.number(f64::from(u8::from(i == axis))))
                    .collect();
                let along = place(&mut time.graph, &unit);
                let now = &q[0][vector * dimension..(vector + 1) * dimension];
                let apart = time.graph.subtract_vectors(now, &targets[vector]);
                rows = vec![time.graph.dot(&along, &apart)];
            }
            JointKind::ClampFull => {
                let targets = targets[1..].concat();
                rows.extend(time.graph.subtract_vectors(&q[0][dimension..], &targets));
            }
            // No axis of the section turns out of its plane, and it does not twist; it may strain and shear.
            JointKind::Clamp if directions.len() > 1 => {
                let graph = &mut time.graph;
                let half = graph.number(0.5);
                let normal = graph.cross(&targets[1], &targets[2]);
                let [y, z] = [1, 2].map(|place| &q[0][place * dimension..(place + 1) * dimension]);
                rows.extend([y, z].map(|axis| graph.dot(&normal, axis)));
                let (over, under) = (graph.dot(&targets[2], y), graph.dot(&targets[1], z));
                let twist = graph.subtract(over, under);
                rows.push(graph.multiply(half, twist));
            }
            JointKind::Clamp => {
                for normal in &normals[..dimension - 1] {
                    let normal = place(&mut time.graph, normal);
                    rows.push(time.graph.dot(&normal, &q[0][dimension..2 * dimension]));
                }
            }
        }
        Self { time, q, rows, targets }
    }

    /// Total time derivative along q, v, a; the derivative of a is zero.
    fn rate(&mut self, ids: &[Id]) -> Vec<Id> {
        let one = self.time.graph.one();
        let mut rates = HashMap::from([(self.time.t, one)]);
        for level in 0..2 {
            rates.extend(self.q[level].iter().copied().zip(self.q[level + 1].iter().copied()));
        }
        ids.iter()
            .map(|&id| self.time.graph.differentiate(id, &rates))
            .collect()
    }

    /// The rows with one level of q's derivatives set to zero.
    fn without(&mut self, ids: &[Id], level: usize) -> Vec<Id> {
        let zero = self.time.graph.zero();
        let replacements = self.q[level].iter().map(|&symbol| (symbol, zero)).collect();
        ids.iter()
            .map(|&id| self.time.graph.substitute(id, &replacements))
            .collect()
    }

    fn kernel(self, name: String, title: String, outputs: Vec<(String, Id)>, arguments: &[&str]) -> Kernel {
        let mut kernel = self.time.kernel(name, title, outputs);
        kernel.arguments.push("data: &::rncf::emitted::JointData".to_string());
        kernel
            .arguments
            .extend(arguments.iter().map(|argument| argument.to_string()));
        kernel
    }
}

/// Derives the conditions of a joint for vectors in the body's frame, or in the inertial one.
/// `has_section`: the body's nodes carry the axes of its section.
pub fn joint_kernels(model: &Model, joint: &Joint, has_section: bool, absolute: bool) -> JointKernels {
    let suffix = if absolute { "absolute" } else { "referenced" };
    let identifier = crate::model::identifier(&joint.name);
    let name = |what: &str| format!("joint_{identifier}_{suffix}_{what}");
    let states = ["q: &[f64]", "v: &[f64]", "a: &[f64]", "rows: &mut [f64]"];
    let levels = std::array::from_fn(|level| {
        let mut conditions = Conditions::new(model, joint, has_section, absolute);
        let mut rows = conditions.rows.clone();
        for _ in 0..level {
            rows = conditions.rate(&rows);
        }
        if level == 1 || level == 2 {
            rows = conditions.without(&rows, level);
        }
        let title = format!("Joint `{}`: conditions, {} level.", joint.name, LEVELS[level]);
        let mut outputs = super::kernel::values(&rows, "rows");
        outputs.retain(|&(_, id)| !conditions.time.graph.is_zero(id));
        (!outputs.is_empty()).then(|| conditions.kernel(name(LEVELS[level]), title, outputs, &states))
    });
    let jacobian = {
        let mut conditions = Conditions::new(model, joint, has_section, absolute);
        let (rows, symbols) = (conditions.rows.clone(), conditions.q[0].clone());
        let outputs = super::kernel::derivatives(&mut conditions.time.graph, &rows, &symbols, "jacobian");
        let title = format!("Joint `{}`: derivatives of the conditions.", joint.name);
        conditions.kernel(name("jacobian"), title, outputs, &["jacobian: &mut [f64]"])
    };
    let prescribed = {
        let mut conditions = Conditions::new(model, joint, has_section, absolute);
        let mut outputs = Vec::new();
        for (what, mut vector) in ["position", "slope", "second"]
            .into_iter()
            .zip(conditions.targets.clone())
        {
            for level in 0..=super::motions::highest_derivative(model) {
                let place = |(component, &id)| (format!("prescribed.{what}[{level}][{component}]"), id);
                outputs.extend(vector.iter().enumerate().map(place));
                vector = conditions.rate(&vector);
            }
        }
        outputs.retain(|&(_, id)| !conditions.time.graph.is_zero(id));
        let title = format!("Joint `{}`: what it prescribes, and its derivatives.", joint.name);
        conditions.kernel(
            name("prescribed"),
            title,
            outputs,
            &["prescribed: &mut ::rncf::emitted::Prescribed"],
        )
    };
    JointKernels {
        levels,
        jacobian,
        prescribed,
    }
}
