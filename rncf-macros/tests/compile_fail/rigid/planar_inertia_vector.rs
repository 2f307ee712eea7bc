//! Three moments of inertia in a plane.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { plane xy; mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m));
        output x = arm.x;
    }
}

fn main() {}
