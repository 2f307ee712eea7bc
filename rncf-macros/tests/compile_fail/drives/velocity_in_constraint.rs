//! A velocity in a constraint.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        constraint still = arm.velocity.x - 1 [m/s];
        output x = arm.x;
    }
}

fn main() {}
