//! Materials that are given by their energy.

rncf::model! {
    /// A round and a flat bar of a linear material, in space and in a plane, and a round one of rubber.
    pub model Lateral {
        param push = 0 N;
        param pull = 0 N;
        param turn = 0 N*m;
        param nu = 0.3;
        param bend_rubber = 0 N*m;
        param turn_rubber = 0 N*m;
        param mu = 1 MPa;
        param lambda = 2 MPa;
        const young = 1 GPa;
        material linear {
            density = 1000 kg/m^3;
            energy = young / (2 * (1 + nu)) * (nu / (1 - 2*nu) * (E.xx + E.yy + E.zz)^2
                + E.xx^2 + E.yy^2 + E.zz^2 + 2 * (E.xy^2 + E.xz^2 + E.yz^2));
        }
        material hooke {
            density = 1100 kg/m^3;
            energy = mu * (E.xx + E.yy + E.zz)
                - mu / 2 * ln(
                    (1 + 2*E.xx) * ((1 + 2*E.yy) * (1 + 2*E.zz) - 4*E.yz^2)
                    - 2*E.xy * (2*E.xy * (1 + 2*E.zz) - 4*E.yz*E.xz)
                    + 2*E.xz * (4*E.xy*E.yz - 2*E.xz * (1 + 2*E.yy)))
                + lambda / 8 * ln(
                    (1 + 2*E.xx) * ((1 + 2*E.yy) * (1 + 2*E.zz) - 4*E.yz^2)
                    - 2*E.xy * (2*E.xy * (1 + 2*E.zz) - 4*E.yz*E.xz)
                    + 2*E.xz * (4*E.xy*E.yz - 2*E.xz * (1 + 2*E.yy)))^2;
        }
        section round = circle(radius = 10 mm);
        section flat = rectangle(y = 20 mm, z = 10 mm);
        body rod { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 2 * beam(round, linear); }
        body bar { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 2 * beam(flat, linear); }
        body leaf { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 2 * beam(flat, linear); }
        body rubber { spatial; line from [0, 0, 0] m to [0.04, 0, 0] m; mesh 4 * beam(round, hooke); }
        joint root_1 = clamp(rod.start, inertial);
        joint root_2 = clamp(bar.start, inertial);
        joint root_3 = clamp(leaf.start, inertial);
        joint root_4 = clamp(rubber.start, inertial);
        load push_1 = force(rod.end, [pull, push, push]);
        load push_2 = force(bar.end, [pull, push, push]);
        load push_3 = force(leaf.end, [pull, push, 0 N]);
        load turn_1 = moment(rod.end, [turn, 0, 0]);
        load turn_2 = moment(bar.end, [turn, 0, 0]);
        load bend_4 = moment(rubber.end, [0, 0, bend_rubber]);
        load turn_4 = moment(rubber.end, [turn_rubber, 0, 0]);
        output rod = rod.end;
        output bar = bar.end;
        output leaf = leaf.end;
        output rod_ey = rod.end.ey;
        output bar_ey = bar.end.ey;
        output rubber = rubber.end;
        output rubber_ey = rubber.end.ey;
    }
}

rncf::model! {
    /// Two cantilevers of the same linear material, and a bar of a compressible neo-Hookean one.
    pub model Materials {
        param bend = 1 N;
        param turn = 0.2 N*m;
        param pull = 0 N;
        param damping = 0 s;
        param kick = 0 m/s;
        const young = 1 GPa;
        const mu = 1 MPa;
        const lambda = 2 MPa;
        material linear { density = 1000 kg/m^3; young = young; poisson = 0; }
        material kirchhoff {
            density = 1000 kg/m^3;
            energy = young / 2 * (E.xx^2 + E.yy^2 + E.zz^2 + 2 * (E.xy^2 + E.xz^2 + E.yz^2));
        }
        material hooke {
            density = 1100 kg/m^3;
            damping = damping;
            energy = mu * (E.xx + E.yy + E.zz)
                - mu / 2 * ln(
                    (1 + 2*E.xx) * ((1 + 2*E.yy) * (1 + 2*E.zz) - 4*E.yz^2)
                    - 2*E.xy * (2*E.xy * (1 + 2*E.zz) - 4*E.yz*E.xz)
                    + 2*E.xz * (4*E.xy*E.yz - 2*E.xz * (1 + 2*E.yy)))
                + lambda / 8 * ln(
                    (1 + 2*E.xx) * ((1 + 2*E.yy) * (1 + 2*E.zz) - 4*E.yz^2)
                    - 2*E.xy * (2*E.xy * (1 + 2*E.zz) - 4*E.yz*E.xz)
                    + 2*E.xz * (4*E.xy*E.yz - 2*E.xz * (1 + 2*E.yy)))^2;
        }
        section wire = circle(radius = 5 mm);
        section cord = circle(radius = 10 mm);
        body by_moduli { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 4 * beam(wire, linear); }
        body by_energy { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 4 * beam(wire, kirchhoff); }
        body bar {
            spatial;
            line from [0, 0, 0] m to [0.3, 0, 0] m;
            mesh 3 * beam(cord, hooke);
            initial position [x, 0, 0];
            initial velocity [kick * sin(pi * x / 0.6 m), 0, 0];
        }
        joint root_1 = clamp(by_moduli.start, inertial);
        joint root_2 = clamp(by_energy.start, inertial);
        joint root_3 = clamp(bar.start, inertial);
        load bend_1 = force(by_moduli.end, [0, bend, bend / 2]);
        load bend_2 = force(by_energy.end, [0, bend, bend / 2]);
        load turn_1 = moment(by_moduli.end, [turn, 0, 0]);
        load turn_2 = moment(by_energy.end, [turn, 0, 0]);
        load pull_3 = force(bar.end, [pull, 0, 0]);
        output one = by_moduli.end;
        output two = by_energy.end;
        output end = bar.end;
        output ey = bar.at(0.15 m).ey;
        output ez_1 = by_moduli.end.ez;
        output ez_2 = by_energy.end.ez;
        output root_1 = root_1.force;
        output tension = bar.at(0.15 m).axial_force;
    }
}
