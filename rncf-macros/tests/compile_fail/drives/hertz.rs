//! A drive in cycles per second.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        joint motor = drive(pin.angle, 2 Hz * t);
        output x = arm.x;
    }
}

fn main() {}
