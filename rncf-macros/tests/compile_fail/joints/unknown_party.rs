//! A joint to something that is nowhere declared.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; inertia = [0.02, 0.2, 0.2] kg*m^2; }
        rigid rod { mass = 1 kg; inertia = [0.01, 0.1, 0.1] kg*m^2; origin = [1, 0, 0] m; }
        joint pin = revolute(arm.at([1, 0, 0] m), rood, axis = y);
        output x = arm.x;
    }
}

fn main() {}
