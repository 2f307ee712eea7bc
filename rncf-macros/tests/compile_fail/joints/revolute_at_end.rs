//! A hinge at a flexible end, which has no orientation.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        body beam in inertial {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        rigid rod { mass = 1 kg; inertia = [0.01, 0.1, 0.1] kg*m^2; origin = [1, 0, 0] m; }
        joint root = clamp(beam.start, inertial);
        joint tip = revolute(beam.end, rod, axis = y);
        output x = beam.end.x;
    }
}

fn main() {}
