//! Keywords of Rust as names of each kind: each is told once, and nothing follows from it.

rncf::model! {
    /// A rod on a turning hub.
    pub model Rod {
        param type = 4 rad/s;
        param ref = 2 m;
        material mut { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        motion move(t) = type * t;
        frame fn = rotating(axis = z, angle = move(t));
        body loop in fn {
            planar xy;
            line from [0, 0, 0] m to [ref, 0, 0];
            mesh 4 * cable(wire, mut);
        }
        joint use = clamp(loop.start, fn);
        output match = loop.end;
    }
}

fn main() {}
