//! Fixtures: position and slope of a place on a body, and with a section its axes, with ten constants
//! (THEORY 5.4).

use super::{ACTION, AXES, CarriedKernels, Carrier, Common, STATES};
use crate::lower::kernel::{Kernel, derivatives, values};
use crate::lower::signature::frame_bindings;

/// The inertia of a fixture on the vectors of its place.
#[derive(Clone, Debug)]
pub struct FixtureKernels {
    /// Components of a vector.
    pub dimension: usize,
    /// Vectors of the place: position and slope, with a section also its axes.
    pub vectors: usize,
    /// Residual in a moving frame.
    pub referenced: Kernel,
    /// Its derivatives.
    pub referenced_tangent: Kernel,
    /// Residual in the inertial frame.
    pub absolute: Kernel,
    /// What a free frame feels.
    pub carried: CarriedKernels,
    /// Whether a fixture of this kind is on a body in a moving frame.
    pub moving: bool,
    /// Whether one is on a body in a free frame.
    pub free: bool,
}

/// Names of the ten constants in their order: mass, first moments, second moments.
const CONSTANTS: [&str; 10] = ["m", "m_x", "m_y", "m_z", "p_xx", "p_yy", "p_zz", "p_xy", "p_xz", "p_yz"];

/// Name of an entry of the mass matrix of position, slope, y and z axis.
pub(super) fn constant(a: usize, b: usize) -> &'static str {
    const PLACES: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 4, 7, 8], [2, 7, 5, 9], [3, 8, 9, 6]];
    CONSTANTS[PLACES[a][b]]
}

/// Names of the components of a fixture's position, slope and section axes.
pub(super) fn names(dimension: usize, vectors: usize, prefix: &str) -> Vec<String> {
    let names = ["r", "s", "y", "z"][..vectors].iter();
    names
        .flat_map(|vector| {
            AXES[..dimension]
                .iter()
                .map(move |axis| format!("{prefix}{vector}_{axis}"))
        })
        .collect()
}

/// What the functions of fixtures have in common: the constants, the frame, and some of the states.
fn common(dimension: usize, vectors: usize, what: &str, states: &[(&str, &str)]) -> Common {
    let size = vectors * dimension;
    let mut arguments = vec!["constants: [f64; 10]".to_string(), ACTION.to_string()];
    arguments.extend(states.iter().map(|(name, _)| format!("{name}: &[f64; {size}]")));
    let used = |name: &&str| (0..vectors).any(|a| (0..vectors).any(|b| constant(a, b) == *name));
    let constants = CONSTANTS.iter().map(|name| if used(name) { *name } else { "_" });
    let constants: Vec<&str> = constants.collect();
    let mut bindings = vec![format!("let [{}] = constants;", constants.join(", "))];
    bindings.extend(frame_bindings(dimension, what));
    let bound = |(argument, prefix): &(&str, &str)| {
        format!("let [{}] = *{argument};", names(dimension, vectors, prefix).join(", "))
    };
    bindings.extend(states.iter().map(bound));
    let word = if dimension == 2 { "planar" } else { "spatial" };
    let section = if vectors > 2 { "_section" } else { "" };
    Common {
        name: format!("fixture_{word}{section}"),
        arguments,
        bindings,
    }
}

/// The kernels of fixtures in two or three dimensions on position and slope (2 vectors), or also on the
/// section's axes (3 in the plane, 4 in space).
pub fn fixture_kernels(dimension: usize, vectors: usize) -> FixtureKernels {
    FixtureKernels {
        dimension,
        vectors,
        referenced: residual(dimension, vectors, true),
        referenced_tangent: tangent(dimension, vectors),
        absolute: residual(dimension, vectors, false),
        carried: common(dimension, vectors, "", &STATES).carried(|| Carrier::fixture(dimension, vectors)),
        moving: false,
        free: false,
    }
}

fn residual(dimension: usize, vectors: usize, moving: bool) -> Kernel {
    let (what, states, place) = if moving {
        ("inertia_force", &STATES[..], "a moving frame")
    } else {
        (
            "absolute_inertia_force",
            &STATES[2..],
            "the inertial frame; e is minus gravity",
        )
    };
    let of = [
        "position r and slope s",
        "position r, slope s and section axis y",
        "position r, slope s and section axes y, z",
    ][vectors - 2];
    let mut carrier = Carrier::fixture(dimension, vectors);
    let rows = carrier.residual(moving);
    let doc = format!(
        "Adds the inertia forces of a fixture on {of} of its place (THEORY 5.4) in {place}: mass, first moments and \
         second moments (m, m_i; m_i, p_ij) times the accelerations plus (m, m_i) e."
    );
    let common = common(dimension, vectors, what, states);
    let mut kernel = common.kernel(what, vec![doc], carrier.graph, values(&rows, "force"));
    kernel.arguments.push(format!("force: &mut [f64; {}]", rows.len()));
    kernel
}

fn tangent(dimension: usize, vectors: usize) -> Kernel {
    let mut carrier = Carrier::fixture(dimension, vectors);
    let rows = carrier.residual(true);
    let [q, v, _] = carrier.states.clone().map(|vectors| vectors.concat());
    let mut outputs = derivatives(&mut carrier.graph, &rows, &q, "stiffness");
    outputs.extend(derivatives(&mut carrier.graph, &rows, &v, "damping_matrix"));
    let doc = "Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' \
               (gyroscopic).";
    let what = "inertia_tangent";
    let mut kernel = common(dimension, vectors, what, &[]).kernel(what, vec![doc.to_string()], carrier.graph, outputs);
    let size = rows.len() * rows.len();
    kernel
        .arguments
        .extend(["stiffness", "damping_matrix"].map(|name| format!("{name}: &mut [f64; {size}]")));
    kernel
}
