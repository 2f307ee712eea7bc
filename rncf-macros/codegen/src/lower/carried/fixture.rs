//! Fixtures: position and slope of a place on a body, with three constants (THEORY 5.4).

use super::{ACTION, AXES, CarriedKernels, Carrier, Common, STATES};
use crate::lower::kernel::{Kernel, derivatives, values};
use crate::lower::signature::frame_bindings;

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

/// Names of the components of a fixture's position and slope.
pub(super) fn names(dimension: usize, prefix: &str) -> Vec<String> {
    let names = ["r", "s"].iter();
    names
        .flat_map(|vector| {
            AXES[..dimension]
                .iter()
                .map(move |axis| format!("{prefix}{vector}_{axis}"))
        })
        .collect()
}

/// What the functions of fixtures have in common: the constants, the frame, and some of the states.
fn common(dimension: usize, what: &str, states: &[(&str, &str)]) -> Common {
    let size = 2 * dimension;
    let mut arguments = vec!["constants: [f64; 3]".to_string(), ACTION.to_string()];
    arguments.extend(states.iter().map(|(name, _)| format!("{name}: &[f64; {size}]")));
    let mut bindings = vec!["let [m, m1, m2] = constants;".to_string()];
    bindings.extend(frame_bindings(dimension, what));
    let bound =
        |(argument, prefix): &(&str, &str)| format!("let [{}] = *{argument};", names(dimension, prefix).join(", "));
    bindings.extend(states.iter().map(bound));
    let word = if dimension == 2 { "planar" } else { "spatial" };
    Common {
        name: format!("fixture_{word}"),
        arguments,
        bindings,
    }
}

/// The kernels of fixtures in two or three dimensions.
pub fn fixture_kernels(dimension: usize) -> FixtureKernels {
    FixtureKernels {
        dimension,
        referenced: residual(dimension, true),
        referenced_tangent: tangent(dimension),
        absolute: residual(dimension, false),
        carried: common(dimension, "", &STATES).carried(|| Carrier::fixture(dimension)),
        moving: false,
        free: false,
    }
}

fn residual(dimension: usize, moving: bool) -> Kernel {
    let (what, states, place) = if moving {
        ("inertia_force", &STATES[..], "a moving frame")
    } else {
        (
            "absolute_inertia_force",
            &STATES[2..],
            "the inertial frame; e is minus gravity",
        )
    };
    let mut carrier = Carrier::fixture(dimension);
    let rows = carrier.residual(moving);
    let doc = format!(
        "Adds the inertia forces of a fixture on position r and slope s of its place (THEORY 5.4) in {place}: \
         (m, m1; m1, m2) times the accelerations plus (m, m1) e."
    );
    let common = common(dimension, what, states);
    let mut kernel = common.kernel(what, vec![doc], carrier.graph, values(&rows, "force"));
    kernel.arguments.push(format!("force: &mut [f64; {}]", rows.len()));
    kernel
}

fn tangent(dimension: usize) -> Kernel {
    let mut carrier = Carrier::fixture(dimension);
    let rows = carrier.residual(true);
    let [q, v, _] = carrier.states.clone().map(|vectors| vectors.concat());
    let mut outputs = derivatives(&mut carrier.graph, &rows, &q, "stiffness");
    outputs.extend(derivatives(&mut carrier.graph, &rows, &v, "damping_matrix"));
    let doc = "Adds the derivatives of a fixture's inertia forces with respect to q (Euler and centrifugal) and q' \
               (gyroscopic).";
    let what = "inertia_tangent";
    let mut kernel = common(dimension, what, &[]).kernel(what, vec![doc.to_string()], carrier.graph, outputs);
    let size = rows.len() * rows.len();
    kernel
        .arguments
        .extend(["stiffness", "damping_matrix"].map(|name| format!("{name}: &mut [f64; {size}]")));
    kernel
}
