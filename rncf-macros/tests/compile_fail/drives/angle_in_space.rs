//! A drive of the angle of a body that turns in space.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint motor = drive(arm.angle, 2 [rad/s] * t);
        output x = arm.x;
    }
}

fn main() {}
