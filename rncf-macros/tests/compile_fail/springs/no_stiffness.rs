//! A spring without stiffness.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        spring strut = linear(arm.at([1, 0, 0] m), inertial.at([1, 0, 1] m), length = 1 m);
        output x = arm.x;
    }
}

fn main() {}
