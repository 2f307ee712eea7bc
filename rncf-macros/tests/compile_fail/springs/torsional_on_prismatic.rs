//! A torsional spring on a joint that does not turn.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        joint guide = prismatic(arm, inertial.at([0, 0, 0] m), axis = z);
        spring coil = torsional(guide, stiffness = 3 [N*m/rad], angle = 0 rad);
        output x = arm.x;
    }
}

fn main() {}
