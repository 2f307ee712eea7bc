//! Cycles per second as an angular velocity.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; angular_velocity = [0, 0, 3] Hz; }
        output x = arm.x;
    }
}

fn main() {}
