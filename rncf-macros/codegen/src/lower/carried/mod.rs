//! Inertia of what a frame carries, as the frame feels it: elements, fixtures and rigid parts. With
//! the accelerations `a_b = (q'' + 2 w x q' + w' x q + w x (w x q))_b` and the acceleration e of the
//! origin minus gravity, all in frame axes,
//!
//! ```text
//! R_a = d_a e + M_ab a_b                 on the nodal vectors, Eq. (13)
//! F   = m e + d_b a_b                    on the frame, Eq. (11)
//! T   = (d_a q_a) x e + M_ab q_a x a_b   about its origin, Eq. (12)
//! ```
//!
//! Every derivative (THEORY 2.1) is derived from these.

mod carrier;
mod fixture;
mod rigid;

use super::kernel::{Kernel, values};
use super::signature::{Signature, frame_bindings};
use super::variant::Variant;
use crate::elements::Library;
use crate::symbolic::{Graph, Id, linear::Vector};
use carrier::Carrier;

pub use fixture::{FixtureKernels, fixture_kernels};
pub use rigid::rigid_kernels;

/// Force and moment on a frame, and their derivatives.
#[derive(Clone, Debug)]
pub struct CarriedKernels {
    /// Force, then moment about the origin.
    pub force: Kernel,
    /// The blocks of `rncf::mesh::CarriedTangent`.
    pub tangent: Kernel,
}

const AXES: [&str; 3] = ["x", "y", "z"];
const STATES: [(&str, &str); 3] = [("q", ""), ("v", "v_"), ("a", "a_")];
const ACTION: &str = "frame: &::rncf::mesh::FrameAction";

/// Numbers that describe a turning: one in the plane.
fn turns(dimension: usize) -> usize {
    if dimension == 2 { 1 } else { 3 }
}

/// Symbols of what the frame does.
struct FrameSymbols {
    /// Acceleration of the origin minus gravity.
    origin: Vector,
    spin: Vector,
    spin_rate: Vector,
}

impl FrameSymbols {
    fn new(graph: &mut Graph, dimension: usize) -> Self {
        let mut vector =
            |word: &str| -> Vector { AXES.iter().map(|axis| graph.symbol(format!("{word}_{axis}"))).collect() };
        let (mut origin, spin, spin_rate) = (vector("e"), vector("w"), vector("dw"));
        if dimension == 2 {
            origin.truncate(2);
            return Self {
                origin,
                spin: vec![graph.symbol("w")],
                spin_rate: vec![graph.symbol("dw")],
            };
        }
        Self {
            origin,
            spin,
            spin_rate,
        }
    }
}

/// Arguments of the blocks of a tangent with n nodal components.
fn blocks(dimension: usize, n: usize) -> Vec<String> {
    let s = turns(dimension);
    let b = dimension + s;
    let sizes = [
        ("mass", b * (b + n)),
        ("damping", b * (s + n)),
        ("spin", n * s),
        ("stiffness", b * n),
    ];
    let kept = sizes.iter().filter(|&&(_, size)| size > 0);
    kept.map(|(name, size)| format!("{name}: &mut [f64; {size}]")).collect()
}

/// What the functions of one thing have in common.
struct Common {
    /// First words of their names.
    name: String,
    /// Arguments before the results.
    arguments: Vec<String>,
    bindings: Vec<String>,
}

impl Common {
    fn kernel(&self, what: &str, doc: Vec<String>, graph: Graph, outputs: Vec<(String, Id)>) -> Kernel {
        Kernel {
            name: format!("{}_{what}", self.name),
            doc,
            arguments: self.arguments.clone(),
            bindings: self.bindings.clone(),
            graph,
            points: None,
            outputs,
            assign: false,
        }
    }

    /// A function that adds force and moment.
    fn force(&self, doc: Vec<String>, graph: Graph, rows: &[Id]) -> Kernel {
        let mut kernel = self.kernel("carried", doc, graph, values(rows, "out"));
        kernel.arguments.push(format!("out: &mut [f64; {}]", rows.len()));
        kernel
    }

    /// A function that writes the blocks of a tangent.
    fn tangent(&self, doc: Vec<String>, graph: Graph, outputs: Vec<(String, Id)>, blocks: Vec<String>) -> Kernel {
        let mut kernel = self.kernel("carried_tangent", doc, graph, outputs);
        kernel.arguments.extend(blocks);
        kernel.assign = true;
        kernel
    }

    /// Both for something that moves with nodal vectors.
    fn carried(&self, make: impl Fn() -> Carrier) -> CarriedKernels {
        let (mut first, mut second) = (make(), make());
        let rows = first.force();
        let (outputs, blocks) = (second.tangent(), blocks(second.dimension(), second.size()));
        let doc = |text: &str| vec![text.to_string()];
        CarriedKernels {
            force: self.force(doc(FORCE_DOC), first.graph, &rows),
            tangent: self.tangent(doc(TANGENT_DOC), second.graph, outputs, blocks),
        }
    }
}

const FORCE_DOC: &str = "Adds force and moment about the origin that the inertia of what the frame carries needs, in frame \
                         axes (Eqs. 11, 12): F = m e + d_b a_b, T = (d_a q_a) x e + M_ab q_a x a_b, with the accelerations \
                         a = q'' + 2 w x q' + w' x q + w x (w x q) and that of the origin minus gravity, e.";
const TANGENT_DOC: &str = "Writes the derivatives of force F and moment T on the frame, rows first (THEORY 2.1): `mass` with \
                           respect to e, w', q''; `damping` to w, q'; `stiffness` to q; and of the nodal forces with respect to \
                           w, `spin`. Entries that are always zero are left alone.";

/// Force and moment of an element's inertia on its free frame.
pub fn element_kernels(variant: &Variant, library: &Library) -> CarriedKernels {
    let signature = Signature {
        variant,
        library,
        references: 0,
    };
    let size = variant.size(library);
    let mut arguments = vec![format!("row: &{}", signature.row()), ACTION.to_string()];
    arguments.extend(STATES.map(|(name, _)| format!("{name}: &[f64; {size}]")));
    let mut bindings = signature.bindings(false, &STATES);
    bindings.extend(frame_bindings(variant.dimension, ""));
    let common = Common {
        name: variant.name(library),
        arguments,
        bindings,
    };
    let mut kernels = common.carried(|| Carrier::element(variant, library));
    for kernel in [&mut kernels.force, &mut kernels.tangent] {
        kernel.doc.push("Mass tensors integrated exactly.".to_string());
    }
    kernels
}
