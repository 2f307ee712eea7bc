//! Bodies that are connected with nothing that is observed.
#![deny(deprecated)]

rncf::model! {
    /// A pendulum beside two bodies that nobody looks at.
    pub model Pendulum {
        rigid bob { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [1, 0, 0] m; }
        joint bearing = revolute(bob.at([-1, 0, 0] m), inertial);
        rigid crank { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [3, 0, 0] m; }
        rigid slider { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; origin = [5, 0, 0] m; }
        joint rod = distance(crank, slider);
        load weight = gravity([0, -9.81, 0] m/s^2);
        output x = bob.x;
    }
}

fn main() {
    let _ = Pendulum::default();
}
