//! Keywords of Rust as names of components, of their arguments and of loops: each is told once, and nothing follows from it.

rncf::model! {
    /// Rods that a component has.
    pub model Rods {
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        component struct(reach: m) {
            body rod { planar xy; line from [0, 0, 0] m to [reach, 0, 0]; mesh 2 * cable(wire, steel); }
            joint root = clamp(rod.start, inertial);
        }
        component Rod(where: m) {
            body rod { planar xy; line from [0, 0, 0] m to [where, 0, 0]; mesh 2 * cable(wire, steel); }
            joint root = clamp(rod.start, inertial);
        }
        part first = struct(reach = 1 m);
        part second = Rod(where = 1 m);
        for in in 0..3 {
            body rod[in] { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 2 * cable(wire, steel); }
            joint root[in] = clamp(rod[in].start, inertial);
        }
        output tip = second.rod.end;
    }
}

fn main() {}
