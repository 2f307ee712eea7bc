//! A material that would give way under pressure.

rncf::model! {
    /// A rod on a turning hub.
    pub model Rod {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.6; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body rod in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        joint root = clamp(rod.start, hub);
        output tip = rod.end;
    }
}

fn main() {}
