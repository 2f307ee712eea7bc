//! What other crates may take in: an element, a component that is made of it, and one that has an element of its own.

rncf::library! {
    /// Cords that stiffen and age.
    pub library cords {
        material light { density = 1 kg/m^3; }
        section thin { area = 0.3 m^2; }
        const stiffening = 2;

        /// Cord with the tension `300 N (l + 2 l^3)` of the stretch less one, l.
        element cord(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = 300 [N]*(l^2/2 + stiffening*l^4/4);
        }

        /// A stone on a cord that is a part of it.
        component Plumb(stiffness: N, side: m, ageing: s) {
            element own(section, material) {
                domain xi in 0..1;
                vector r0 = r at 0, shape 1 - xi;
                vector r1 = r at 1, shape xi;
                field a = r_x;
                coefficient rhoA: kg/m = material.density * section.area;
                inertia r = rhoA;
                strain l = norm(a) - 1;
                energy stretching = stiffness*exp(-t/ageing)*(l^2/2 + stiffening*l^4/4);
            }
            body line in inertial {
                spatial;
                line from [side, 0 m, 0 m] to [side, 0 m, -1 m];
                mesh 1 * own(thin, light);
            }
            joint top = pin(line.start, inertial);
            joint guide_x = hold(line.end.x);
            joint guide_y = hold(line.end.y);
            fixture stone on line.end { mass = 10 kg; }
            output drop = -line.end.z - 1 m;
        }
    }
}
