//! What a moving frame does to a body in modes, and what the body makes on the frame.

use crate::emitted::FrameMotion;
use crate::space::Vector;

/// What a moving frame does to a body of modes in it, in the order of the body's axes (planar bodies: spin
/// about the normal first).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct FrameAction {
    /// Acceleration of the origin minus gravity, m/s^2.
    pub acceleration: Vector,
    /// Angular velocity, rad/s.
    pub spin: Vector,
    /// Angular acceleration, rad/s^2.
    pub spin_rate: Vector,
}

impl FrameMotion {
    /// What the frame does to a body with the given axes under gravity (m/s^2, inertial axes).
    pub(crate) fn action(&self, axes: &[usize], gravity: Vector) -> FrameAction {
        let acceleration = self.felt(gravity);
        let mut action = FrameAction::default();
        for (place, &axis) in axes.iter().enumerate() {
            action.acceleration[place] = acceleration[axis];
        }
        if let [first, second] = *axes {
            let normal = 3 - first - second;
            action.spin[0] = self.spin[normal];
            action.spin_rate[0] = self.spin_rate[normal];
        } else {
            (action.spin, action.spin_rate) = (self.spin, self.spin_rate);
        }
        action
    }
}

/// Derivatives of what modes make on their frame, all in frame axes, rows first. A vector has d = 2 or 3 components,
/// an angular velocity s = 1 or 3; b = d + s are the rows of force and moment on the frame, and q has
/// n components. e is the origin's acceleration minus gravity.
#[derive(Clone, Debug, Default)]
pub(crate) struct CarriedTangent {
    /// d(force, moment)/d(e, w', q''): b x (b + n); its last n columns are also, transposed, the
    /// derivatives of the q rows with respect to e and w'.
    pub mass: Vec<f64>,
    /// d(force, moment)/d(w, q'): b x (s + n).
    pub damping: Vec<f64>,
    /// d(q rows)/dw: n x s.
    pub spin: Vec<f64>,
    /// d(force, moment)/dq: b x n.
    pub stiffness: Vec<f64>,
}
