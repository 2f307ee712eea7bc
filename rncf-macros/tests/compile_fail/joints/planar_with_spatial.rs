//! A joint between a planar and a spatial body.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        rigid disc { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; }
        joint pin = revolute(arm, disc, axis = z);
        output x = arm.x;
    }
}

fn main() {}
