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

use super::inertia::{Inertia, cross, unit_mass};
use super::kernel::Kernel;
use super::signature::{Signature, frame_bindings};
use super::variant::Variant;
use crate::elements::Library;
use crate::symbolic::{Graph, Id, linear::Vector};

/// Force and moment on a frame, and their derivatives.
#[derive(Clone, Debug)]
pub struct CarriedKernels {
    /// Force, then moment about the origin.
    pub force: Kernel,
    /// The blocks of `rncf::mesh::CarriedTangent`.
    pub tangent: Kernel,
}

/// The inertia of a fixture on position and slope of its place.
#[derive(Clone, Debug)]
pub struct FixtureKernels {
    /// Components of a vector.
    pub dimension: usize,
    /// Residual in a moving frame.
    pub referenced: Kernel,
    /// Its derivatives.
    pub referenced_tangent: Kernel,
    /// Residual in the inertial frame.
    pub absolute: Kernel,
    /// What a free frame feels.
    pub carried: CarriedKernels,
    /// Whether a fixture of this dimension is on a body in a moving frame.
    pub moving: bool,
    /// Whether one is on a body in a free frame.
    pub free: bool,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// Words for two and three dimensions.
fn word(dimension: usize) -> &'static str {
    if dimension == 2 { "planar" } else { "spatial" }
}

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

/// Moment of a vector at a place: a number in the plane.
fn moment(graph: &mut Graph, place: &[Id], vector: &[Id]) -> Vector {
    if let [x, y] = *place {
        let (left, right) = (graph.multiply(x, vector[1]), graph.multiply(y, vector[0]));
        return vec![graph.subtract(left, right)];
    }
    graph.cross(place, vector)
}

/// Something with constant mass matrix that moves with nodal vectors in a frame.
struct Carrier {
    graph: Graph,
    /// m, kg.
    total: Id,
    /// d_a.
    moments: Vec<Id>,
    /// M_ab.
    mass: Vec<Vec<Id>>,
    /// Order of each nodal vector: 0 position, 1 slope.
    orders: Vec<usize>,
    /// q, q', q''.
    states: [Vec<Vector>; 3],
    frame: FrameSymbols,
}

impl Carrier {
    fn element(variant: &Variant, library: &Library) -> Self {
        let mut inertia = Inertia::new(variant, library);
        let vectors = variant.declaration(library).vectors;
        let unit = unit_mass(variant, library);
        let count = unit.len();
        let mass = (0..count).map(|a| (0..count).map(|b| inertia.entry(&unit, a, b)).collect());
        let mass = mass.collect();
        let moments = inertia.moments();
        let states = ["", "v_", "a_"].map(|prefix| inertia.symbols(prefix));
        let frame = FrameSymbols::new(&mut inertia.graph, variant.dimension);
        Self {
            total: inertia.mass,
            graph: inertia.graph,
            moments,
            mass,
            orders: vectors.iter().map(|vector| vector.order).collect(),
            states,
            frame,
        }
    }

    /// Position and slope with m, m1 and m2 (THEORY 5.4).
    fn fixture(dimension: usize) -> Self {
        let mut graph = Graph::new();
        let [m, m1, m2] = ["m", "m1", "m2"].map(|name| graph.symbol(name));
        let states = ["", "v_", "a_"].map(|prefix| {
            fixture_names(dimension, prefix)
                .chunks(dimension)
                .map(|names| names.iter().map(|name| graph.symbol(name.as_str())).collect())
                .collect()
        });
        let frame = FrameSymbols::new(&mut graph, dimension);
        Self {
            graph,
            total: m,
            moments: vec![m, m1],
            mass: vec![vec![m, m1], vec![m1, m2]],
            orders: vec![0, 1],
            states,
            frame,
        }
    }

    fn dimension(&self) -> usize {
        self.frame.origin.len()
    }

    /// Relative, Coriolis, Euler and centrifugal acceleration of every nodal vector.
    fn accelerations(&mut self, moving: bool) -> Vec<Vector> {
        let [positions, velocities, accelerations] = self.states.clone();
        if !moving {
            return accelerations;
        }
        let graph = &mut self.graph;
        let two = graph.number(2.0);
        let mut total = Vec::new();
        for ((position, velocity), acceleration) in positions.iter().zip(&velocities).zip(accelerations) {
            let relative = cross(graph, &self.frame.spin, velocity);
            let coriolis = graph.scale(two, &relative);
            let euler = cross(graph, &self.frame.spin_rate, position);
            let inner = cross(graph, &self.frame.spin, position);
            let centrifugal = cross(graph, &self.frame.spin, &inner);
            let mut sum = acceleration;
            for term in [coriolis, euler, centrifugal] {
                sum = graph.add_vectors(&sum, &term);
            }
            total.push(sum);
        }
        total
    }

    /// `sum_b weights_b vectors_b`
    fn weighted(&mut self, weights: &[Id], vectors: &[Vector]) -> Vector {
        (0..self.dimension())
            .map(|c| {
                let column: Vec<Id> = vectors.iter().map(|vector| vector[c]).collect();
                self.graph.dot(weights, &column)
            })
            .collect()
    }

    /// R_a.
    fn residual(&mut self, moving: bool) -> Vec<Id> {
        let accelerations = self.accelerations(moving);
        let mut rows = Vec::new();
        for a in 0..self.moments.len() {
            let weights = self.mass[a].clone();
            let sum = self.weighted(&weights, &accelerations);
            let origin = self.graph.scale(self.moments[a], &self.frame.origin);
            rows.extend(self.graph.add_vectors(&sum, &origin));
        }
        rows
    }

    /// F and T.
    fn force(&mut self) -> Vec<Id> {
        let accelerations = self.accelerations(true);
        let (moments, positions) = (self.moments.clone(), self.states[0].clone());
        let inertia = self.weighted(&moments, &accelerations);
        let origin = self.graph.scale(self.total, &self.frame.origin);
        let mut rows = self.graph.add_vectors(&origin, &inertia);
        let first = self.weighted(&moments, &positions);
        let mut turning = moment(&mut self.graph, &first, &self.frame.origin);
        for (b, acceleration) in accelerations.iter().enumerate() {
            let weights: Vec<Id> = self.mass.iter().map(|row| row[b]).collect();
            let place = self.weighted(&weights, &positions);
            let part = moment(&mut self.graph, &place, acceleration);
            turning = self.graph.add_vectors(&turning, &part);
        }
        rows.extend(turning);
        rows
    }

    /// R_a with the sums over b taken first, `M_ab q_b` and `M_ab q'_b`, and F and T as sums over a:
    /// the same numbers, with cheaper derivatives with respect to w.
    fn summed(&mut self) -> (Vec<Id>, Vec<Id>) {
        let [positions, velocities, accelerations] = self.states.clone();
        let zero = self.graph.zero();
        let (mut residual, mut force) = (Vec::new(), vec![zero; self.dimension()]);
        let mut turning = vec![zero; turns(self.dimension())];
        let two = self.graph.number(2.0);
        for (a, place) in positions.iter().enumerate() {
            let weights = self.mass[a].clone();
            let [position, velocity, relative] =
                [&positions, &velocities, &accelerations].map(|vectors| self.weighted(&weights, vectors));
            let graph = &mut self.graph;
            let rate = cross(graph, &self.frame.spin, &velocity);
            let inner = cross(graph, &self.frame.spin, &position);
            let terms = [
                graph.scale(self.moments[a], &self.frame.origin),
                graph.scale(two, &rate),
                cross(graph, &self.frame.spin_rate, &position),
                cross(graph, &self.frame.spin, &inner),
            ];
            let row = terms.iter().fold(relative, |sum, term| graph.add_vectors(&sum, term));
            if self.orders[a] == 0 {
                force = graph.add_vectors(&force, &row);
            }
            let part = moment(graph, place, &row);
            turning = graph.add_vectors(&turning, &part);
            residual.extend(row);
        }
        force.extend(turning);
        (residual, force)
    }

    /// The blocks of the tangent.
    fn tangent(&mut self) -> Vec<(String, Id)> {
        let force = self.force();
        let (residual, summed) = self.summed();
        let [q, v, a] = self.states.clone().map(|vectors| vectors.concat());
        let [e, w, dw] = [&self.frame.origin, &self.frame.spin, &self.frame.spin_rate].map(Vec::clone);
        let graph = &mut self.graph;
        let mut outputs = derivatives(graph, &force, &[e, dw, a].concat(), "mass");
        let width = w.len() + v.len();
        outputs.extend(block(graph, &summed, &w, "damping", (width, 0)));
        outputs.extend(block(graph, &force, &v, "damping", (width, w.len())));
        outputs.extend(derivatives(graph, &residual, &w, "spin"));
        outputs.extend(derivatives(graph, &force, &q, "stiffness"));
        outputs
    }
}

/// Derivatives that are not zero, rows first.
pub(super) fn derivatives(graph: &mut Graph, rows: &[Id], with: &[Id], name: &str) -> Vec<(String, Id)> {
    block(graph, rows, with, name, (with.len(), 0))
}

/// The same in a matrix of a given width, from a given column on.
fn block(graph: &mut Graph, rows: &[Id], with: &[Id], name: &str, (width, from): (usize, usize)) -> Vec<(String, Id)> {
    let mut outputs = Vec::new();
    for (row, &of) in rows.iter().enumerate() {
        for (column, &symbol) in with.iter().enumerate() {
            let derivative = graph.partial(of, symbol);
            if !graph.is_zero(derivative) {
                outputs.push((format!("{name}[{}]", row * width + from + column), derivative));
            }
        }
    }
    outputs
}

/// Values in order.
pub(super) fn values(rows: &[Id], name: &str) -> Vec<(String, Id)> {
    let place = |(row, &id)| (format!("{name}[{row}]"), id);
    rows.iter().enumerate().map(place).collect()
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
    let (size, dimension) = (variant.size(library), variant.dimension);
    let mut arguments = vec![
        format!("row: &{}", signature.row()),
        "frame: &::rncf::mesh::FrameAction".to_string(),
    ];
    arguments.extend(["q", "v", "a"].map(|name| format!("{name}: &[f64; {size}]")));
    let mut bindings = signature.bindings(false, &[("q", ""), ("v", "v_"), ("a", "a_")]);
    bindings.extend(frame_bindings(dimension, ""));
    carried_kernels(
        variant.name(library),
        || Carrier::element(variant, library),
        &arguments,
        &bindings,
        size,
    )
}

fn carried_kernels(
    name: String,
    carrier: impl Fn() -> Carrier,
    arguments: &[String],
    bindings: &[String],
    size: usize,
) -> CarriedKernels {
    let kernel = |suffix: &str, doc: &str, graph: Graph, outputs, last: Vec<String>, assign| Kernel {
        name: format!("{name}_{suffix}"),
        doc: vec![doc.to_string(), "Mass tensors integrated exactly.".to_string()],
        arguments: [arguments, &last].concat(),
        bindings: bindings.to_vec(),
        graph,
        points: None,
        outputs,
        assign,
    };
    let force = {
        let mut carrier = carrier();
        let rows = carrier.force();
        let argument = format!("out: &mut [f64; {}]", rows.len());
        kernel(
            "carried",
            FORCE_DOC,
            carrier.graph,
            values(&rows, "out"),
            vec![argument],
            false,
        )
    };
    let tangent = {
        let mut carrier = carrier();
        let outputs = carrier.tangent();
        let last = blocks(carrier.dimension(), size);
        kernel("carried_tangent", TANGENT_DOC, carrier.graph, outputs, last, true)
    };
    CarriedKernels { force, tangent }
}

/// Names of the components of a fixture's position and slope.
fn fixture_names(dimension: usize, prefix: &str) -> Vec<String> {
    let names = ["r", "s"].iter();
    names
        .flat_map(|vector| {
            AXES[..dimension]
                .iter()
                .map(move |axis| format!("{prefix}{vector}_{axis}"))
        })
        .collect()
}

/// The kernels of fixtures in two or three dimensions.
pub fn fixture_kernels(dimension: usize) -> FixtureKernels {
    let size = 2 * dimension;
    let name = |suffix: &str| format!("fixture_{}_{suffix}", word(dimension));
    let leading = ["constants: [f64; 3]", "frame: &::rncf::mesh::FrameAction"].map(str::to_string);
    let constants = "let [m, m1, m2] = constants;".to_string();
    let state = |(argument, prefix): (&str, &str)| {
        format!("let [{}] = *{argument};", fixture_names(dimension, prefix).join(", "))
    };
    let residual = |moving: bool| {
        let mut carrier = Carrier::fixture(dimension);
        let rows = carrier.residual(moving);
        let states: &[(&str, &str)] = if moving {
            &[("q", ""), ("v", "v_"), ("a", "a_")]
        } else {
            &[("a", "a_")]
        };
        let suffix = if moving {
            "inertia_force"
        } else {
            "absolute_inertia_force"
        };
        let mut arguments = leading.to_vec();
        arguments.extend(states.iter().map(|(argument, _)| format!("{argument}: &[f64; {size}]")));
        arguments.push(format!("force: &mut [f64; {size}]"));
        let mut bindings = vec![constants.clone()];
        bindings.extend(frame_bindings(dimension, suffix));
        bindings.extend(states.iter().copied().map(state));
        let place = if moving {
            "a moving frame"
        } else {
            "the inertial frame; e is minus gravity"
        };
        let doc = format!(
            "Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in {place}: \
             (m, m1; m1, m2) times the accelerations plus (m, m1) e."
        );
        Kernel {
            name: name(suffix),
            doc: vec![doc],
            arguments,
            bindings,
            graph: carrier.graph,
            points: None,
            outputs: values(&rows, "force"),
            assign: false,
        }
    };
    let referenced_tangent = {
        let mut carrier = Carrier::fixture(dimension);
        let rows = carrier.residual(true);
        let [q, v, _] = carrier.states.clone().map(|vectors| vectors.concat());
        let mut outputs = derivatives(&mut carrier.graph, &rows, &q, "stiffness");
        outputs.extend(derivatives(&mut carrier.graph, &rows, &v, "damping_matrix"));
        let mut arguments = leading.to_vec();
        arguments.extend(["stiffness", "damping_matrix"].map(|name| format!("{name}: &mut [f64; {}]", size * size)));
        let mut bindings = vec![constants.clone()];
        bindings.extend(frame_bindings(dimension, "tangent"));
        let doc = "Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' \
                   (gyroscopic).";
        Kernel {
            name: name("inertia_tangent"),
            doc: vec![doc.to_string()],
            arguments,
            bindings,
            graph: carrier.graph,
            points: None,
            outputs,
            assign: false,
        }
    };
    let carried = {
        let mut arguments = leading.to_vec();
        arguments.extend(["q", "v", "a"].map(|name| format!("{name}: &[f64; {size}]")));
        let mut bindings = vec![constants.clone()];
        bindings.extend(frame_bindings(dimension, ""));
        bindings.extend([("q", ""), ("v", "v_"), ("a", "a_")].map(state));
        let carrier = || Carrier::fixture(dimension);
        carried_kernels(
            format!("fixture_{}", word(dimension)),
            carrier,
            &arguments,
            &bindings,
            size,
        )
    };
    FixtureKernels {
        dimension,
        referenced: residual(true),
        referenced_tangent,
        absolute: residual(false),
        carried,
        moving: false,
        free: false,
    }
}

/// Rigid parts of a frame (Eq. 14): `F = m e + w' x S + w x (w x S)`, `T = S x e + J w' + w x J w`.
pub fn rigid_kernels() -> CarriedKernels {
    let build = || {
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
    };
    let kernel = |suffix: &str, doc: &str, graph: Graph, outputs, last: Vec<String>, assign| Kernel {
        name: format!("rigid_{suffix}"),
        doc: vec![doc.to_string()],
        arguments: [
            ["rigid: &::rncf::mesh::RigidSpec", "frame: &::rncf::mesh::FrameAction"]
                .map(str::to_string)
                .to_vec(),
            last,
        ]
        .concat(),
        bindings: frame_bindings(3, ""),
        graph,
        points: None,
        outputs,
        assign,
    };
    let force = {
        let (graph, _, rows) = build();
        let doc = "Adds force and moment about the origin that the inertia of a frame's rigid parts needs, in frame axes \
                   (Eq. 14): F = m e + w' x S + w x (w x S), T = S x e + J w' + w x J w, with the first moment S and the \
                   inertia J about the origin.";
        kernel(
            "carried",
            doc,
            graph,
            values(&rows, "out"),
            vec!["out: &mut [f64; 6]".to_string()],
            false,
        )
    };
    let tangent = {
        let (mut graph, frame, rows) = build();
        let mut outputs = derivatives(&mut graph, &rows, &[frame.origin, frame.spin_rate].concat(), "mass");
        outputs.extend(derivatives(&mut graph, &rows, &frame.spin, "damping"));
        let doc = "Writes the derivatives of force and moment, rows first: `mass` with respect to e and w', `damping` to w. \
                   Entries that are always zero are left alone.";
        kernel("carried_tangent", doc, graph, outputs, blocks(3, 0), true)
    };
    CarriedKernels { force, tangent }
}
