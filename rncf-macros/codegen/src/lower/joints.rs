//! Conditions of joints: written down as C(q, t) = 0, with every derivative derived.

use std::collections::HashMap;

use super::kernel::Kernel;
use super::motions::Time;
use crate::model::{INERTIAL, Joint, JointKind, Model};
use crate::symbolic::{Graph, Id, linear::Vector};

/// The conditions of a joint in one formulation.
#[derive(Clone, Debug)]
pub struct JointKernels {
    /// Values: position level, and what the rate, acceleration and jerk levels are with the highest
    /// derivative of q set to zero.
    pub levels: [Kernel; 4],
    /// Derivatives with respect to position and slope.
    pub jacobian: Kernel,
    /// What is prescribed where the conditions are eliminated.
    pub prescribed: Kernel,
}

/// Names of the levels, in order.
pub const LEVELS: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];

struct Conditions<'m> {
    time: Time<'m>,
    /// Symbols of position and slope, their rates and accelerations.
    q: [Vec<Id>; 3],
    rows: Vec<Id>,
    /// Prescribed position and slope.
    targets: [Vector; 2],
}

impl<'m> Conditions<'m> {
    fn new(model: &'m Model, joint: &Joint, absolute: bool) -> Self {
        let mut time = Time::new(model);
        let body = &model.bodies[joint.body.0];
        let (axes, dimension) = (body.space.axes(), body.space.dimension());
        let frame = if absolute { INERTIAL } else { body.frame };
        let (rotation, offset) = time.relative_pose(joint.frame, frame);
        let mut symbols =
            |text: &str| -> Vec<Id> { (0..3).map(|i| time.graph.symbol(format!("{text}[{i}]"))).collect() };
        let point = symbols("data.point");
        let tangent = symbols("data.tangent");
        let normals = [symbols("data.normals[0]"), symbols("data.normals[1]")];
        let q = ["q", "v", "a"].map(|word| {
            (0..2 * dimension)
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
        let slope = place(&mut time.graph, &tangent);
        let mut rows = time.graph.subtract_vectors(&q[0][..dimension], &position);
        match joint.kind {
            JointKind::Pin => {}
            JointKind::Hold { of, axis } => {
                let order = of.order();
                let held = axes.iter().position(|&other| other == axis).unwrap_or(0);
                let target = if order == 0 { position[held] } else { slope[held] };
                rows = vec![time.graph.subtract(q[0][order * dimension + held], target)];
            }
            JointKind::ClampFull => rows.extend(time.graph.subtract_vectors(&q[0][dimension..], &slope)),
            JointKind::Clamp => {
                for normal in &normals[..dimension - 1] {
                    let normal = place(&mut time.graph, normal);
                    rows.push(time.graph.dot(&normal, &q[0][dimension..]));
                }
            }
        }
        Self {
            time,
            q,
            rows,
            targets: [position, slope],
        }
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
        kernel.arguments.push("data: &::rncf::mesh::JointData".to_string());
        kernel
            .arguments
            .extend(arguments.iter().map(|argument| argument.to_string()));
        kernel
    }
}

/// Derives the conditions of a joint for vectors in the body's frame, or in the inertial one.
pub fn joint_kernels(model: &Model, joint: &Joint, absolute: bool) -> JointKernels {
    let suffix = if absolute { "absolute" } else { "referenced" };
    let name = |what: &str| format!("joint_{}_{suffix}_{what}", joint.name);
    let states = ["q: &[f64]", "v: &[f64]", "a: &[f64]", "rows: &mut [f64]"];
    let levels = std::array::from_fn(|level| {
        let mut conditions = Conditions::new(model, joint, absolute);
        let mut rows = conditions.rows.clone();
        for _ in 0..level {
            rows = conditions.rate(&rows);
        }
        if level == 1 || level == 2 {
            rows = conditions.without(&rows, level);
        }
        let title = format!("Joint `{}`: conditions, {} level.", joint.name, LEVELS[level]);
        let outputs = rows
            .iter()
            .enumerate()
            .map(|(row, &id)| (format!("rows[{row}]"), id))
            .collect();
        conditions.kernel(name(LEVELS[level]), title, outputs, &states)
    });
    let jacobian = {
        let mut conditions = Conditions::new(model, joint, absolute);
        let (rows, symbols) = (conditions.rows.clone(), conditions.q[0].clone());
        let mut outputs = Vec::new();
        for (row, &id) in rows.iter().enumerate() {
            for (column, &symbol) in symbols.iter().enumerate() {
                let derivative = conditions.time.graph.partial(id, symbol);
                outputs.push((format!("jacobian[{}]", row * symbols.len() + column), derivative));
            }
        }
        let title = format!("Joint `{}`: derivatives of the conditions.", joint.name);
        conditions.kernel(name("jacobian"), title, outputs, &["jacobian: &mut [f64]"])
    };
    let prescribed = {
        let mut conditions = Conditions::new(model, joint, absolute);
        let mut outputs = Vec::new();
        for (what, mut vector) in ["position", "slope"].into_iter().zip(conditions.targets.clone()) {
            for level in 0..4 {
                let place = |(component, &id)| (format!("prescribed.{what}[{level}][{component}]"), id);
                outputs.extend(vector.iter().enumerate().map(place));
                vector = conditions.rate(&vector);
            }
        }
        let title = format!("Joint `{}`: what it prescribes, with three derivatives.", joint.name);
        conditions.kernel(
            name("prescribed"),
            title,
            outputs,
            &["prescribed: &mut ::rncf::mesh::Prescribed"],
        )
    };
    JointKernels {
        levels,
        jacobian,
        prescribed,
    }
}
