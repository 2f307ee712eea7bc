//! An arc in space whose plane is not known.

rncf::model! {
    /// A shaft on a turning hub.
    pub model Shaft {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 20 mm);
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body shaft in hub {
            spatial;
            arc from [0, 0, 0] m direction [1, 0, 0] radius 2 m angle 30 deg;
            mesh 4 * beam(round, steel);
        }
        joint root = clamp(shaft.start, hub);
        output tip = shaft.end;
    }
}

fn main() {}
