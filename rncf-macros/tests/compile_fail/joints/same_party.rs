//! A joint of a body with itself.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = spherical(arm, arm.at([1, 0, 0] m));
        output x = arm.x;
    }
}

fn main() {}
