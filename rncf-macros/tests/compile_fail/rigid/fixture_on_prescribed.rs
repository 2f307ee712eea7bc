//! A mass on a frame that moves as prescribed.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
        fixture ball on hub { mass = 1 kg; }
        output x = arm.x;
    }
}

fn main() {}
