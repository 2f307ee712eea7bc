//! A strip as a cable in space, which bends alike in all directions.

rncf::model! {
    /// A shaft on a turning hub.
    pub model Shaft {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section strip = rectangle(y = 20 mm, z = 5 mm);
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body shaft in hub {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(strip, steel);
        }
        joint root = clamp(shaft.start, hub);
        output tip = shaft.end;
    }
}

fn main() {}
