//! Properties that no element of their bodies reads.
#![deny(deprecated)]

rncf::model! {
    /// Nothing twists in a plane; that a centre line needs no Poisson's ratio is no matter.
    pub model Rod {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; yield = 250 MPa; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; torsion_constant = 0.16 mm^4; }
        body rod {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        joint root = clamp(rod.start, inertial);
        output tip = rod.end;
    }
}

fn main() {
    let _ = Rod::default();
}
