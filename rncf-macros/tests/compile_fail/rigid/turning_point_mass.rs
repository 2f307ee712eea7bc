//! A point mass with an angular velocity.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; angular_velocity = [0, 0, 1] rad/s; }
        output x = arm.x;
    }
}

fn main() {}
