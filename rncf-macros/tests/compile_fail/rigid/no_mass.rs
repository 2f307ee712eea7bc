//! A rigid body without mass.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        output x = arm.x;
    }
}

fn main() {}
