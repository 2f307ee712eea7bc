//! A material that is stressed without strain.

rncf::model! {
    /// A shaft on a turning hub.
    pub model Shaft {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        material rubber { density = 1100 kg/m^3; energy = 1 MPa * (E.xx^2 + E.yy^2 + E.xy^2 + E.xx); }
        section round = circle(radius = 20 mm);
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body shaft in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * beam(round, rubber);
        }
        joint root = clamp(shaft.start, hub);
        output tip = shaft.end;
    }
}

fn main() {}
