//! A drive of a coordinate that the joint does not have.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint pin = revolute(arm, inertial.at([0, 0, 0] m), axis = y);
        joint motor = drive(pin.slide, 1 [m/s] * t);
        output x = arm.x;
    }
}

fn main() {}
