//! A constraint in which nothing moves freely.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
        constraint level = hub.at([1, 0, 0] m).z;
        output x = arm.x;
    }
}

fn main() {}
