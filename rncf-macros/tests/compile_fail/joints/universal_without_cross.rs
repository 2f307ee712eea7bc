//! A universal joint with one axis only.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = universal(arm, inertial.at([0, 0, 0] m), axis = x);
        output x = arm.x;
    }
}

fn main() {}
