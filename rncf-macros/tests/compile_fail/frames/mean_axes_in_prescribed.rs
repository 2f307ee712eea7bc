//! Mean axes of a frame that moves as prescribed.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
        body beam in hub {
            spatial;
            mean_axes;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        output x = beam.end.x;
    }
}

fn main() {}
