//! A tube without a hole.

rncf::model! {
    /// A shaft on a turning hub.
    pub model Shaft {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section pipe = tube(radius = 20 mm, thickness = 20 mm);
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body shaft in hub {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * beam(pipe, steel);
        }
        joint root = clamp(shaft.start, hub);
        output tip = shaft.end;
    }
}

fn main() {}
