//! A joint between two prescribed frames.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
        joint weld = weld(hub, inertial.at([0, 0, 0] m));
        output x = arm.x;
    }
}

fn main() {}
