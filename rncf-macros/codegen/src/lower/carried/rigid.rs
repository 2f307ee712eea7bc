//! Rigid parts of a frame (Eq. 14): ten numbers about its origin.

use super::{ACTION, CarriedKernels, Common, FrameSymbols, blocks};
use crate::lower::kernel::derivatives;
use crate::lower::signature::frame_bindings;
use crate::symbolic::{Graph, Id, linear::Vector};

const FORCE_DOC: &str = "Adds force and moment about the origin that the inertia of a frame's rigid parts needs, in frame \
                         axes (Eq. 14): F = m e + w' x S + w x (w x S), T = S x e + J w' + w x J w, with the first moment S \
                         and the inertia J about the origin.";
const TANGENT_DOC: &str = "Writes the derivatives of force and moment, rows first: `mass` with respect to e and w', `damping` \
                           to w. Entries that are always zero are left alone.";

/// `F = m e + w' x S + w x (w x S)`, `T = S x e + J w' + w x J w`.
fn force() -> (Graph, FrameSymbols, Vec<Id>) {
    let mut graph = Graph::new();
    let frame = FrameSymbols::new(&mut graph, 3);
    let mass = graph.symbol("rigid.mass");
    let first: Vector = (0..3).map(|i| graph.symbol(format!("rigid.moment[{i}]"))).collect();
    let second: [[Id; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| graph.symbol(format!("rigid.inertia[{i}][{j}]"))));
    let origin = graph.scale(mass, &frame.origin);
    let euler = graph.cross(&frame.spin_rate, &first);
    let inner = graph.cross(&frame.spin, &first);
    let centrifugal = graph.cross(&frame.spin, &inner);
    let sum = graph.add_vectors(&origin, &euler);
    let mut rows = graph.add_vectors(&sum, &centrifugal);
    let lever = graph.cross(&first, &frame.origin);
    let momentum = graph.apply(&second, &frame.spin);
    let change = graph.apply(&second, &frame.spin_rate);
    let gyroscopic = graph.cross(&frame.spin, &momentum);
    let sum = graph.add_vectors(&lever, &change);
    rows.extend(graph.add_vectors(&sum, &gyroscopic));
    (graph, frame, rows)
}

/// What a frame feels of its rigid parts.
pub fn rigid_kernels() -> CarriedKernels {
    let common = Common {
        name: "rigid".to_string(),
        arguments: vec!["rigid: &::rncf::mesh::RigidSpec".to_string(), ACTION.to_string()],
        bindings: frame_bindings(3, ""),
    };
    let (graph, _, rows) = force();
    let force_kernel = common.force(vec![FORCE_DOC.to_string()], graph, &rows);
    let (mut graph, frame, rows) = force();
    let mut outputs = derivatives(&mut graph, &rows, &[frame.origin, frame.spin_rate].concat(), "mass");
    outputs.extend(derivatives(&mut graph, &rows, &frame.spin, "damping"));
    CarriedKernels {
        force: force_kernel,
        tangent: common.tangent(vec![TANGENT_DOC.to_string()], graph, outputs, blocks(3, 0)),
    }
}
