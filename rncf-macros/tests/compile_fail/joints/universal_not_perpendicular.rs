//! A universal joint whose axes are not perpendicular.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = universal(arm, inertial.at([0, 0, 0] m), axis = x, cross = [1, 1, 0]);
        output x = arm.x;
    }
}

fn main() {}
