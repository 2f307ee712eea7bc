//! A free frame with five ties.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        frame own = free();
        body beam in own {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        joint root = clamp(beam.start, own);
        output x = beam.end.x;
    }
}

fn main() {}
