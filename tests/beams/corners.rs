//! Bodies whose axis has corners, against a geometrically exact rod and closed forms.

use crate::blades::{at_rest, near};

rncf::model! {
    /// Two angles, one of full sections and one of a centre line, and a bent pipe that grows thinner all along.
    pub model Angles {
        /// Force at the end of the angle of full sections.
        param stiff_load = 1 MN;
        /// Force at the end of the centre line.
        param slender_load = 1 N;
        const leg = 1 m;

        table rows { x = [0, 2] m; mass = [10, 30] kg/m; turn = [0, 90] deg; }
        section bar {
            EA = 1.05e9 N; GAy = 3.43137255e8 N; GAz = 3.43137255e8 N; GJ = 1e5 N*m^2; EIy = 875000 N*m^2; EIz = 218750 N*m^2;
            mass = rows.mass; inertia_y = 0.03 kg*m; inertia_z = 0.01 kg*m;
        }
        body angle {
            spatial;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            mesh 16 * beam(bar);
        }
        joint root = clamp(angle.start, inertial);
        load push = force(angle.end, [stiff_load, 0, 0]);
        output x = angle.end.x - leg;
        output y = angle.end.y - leg;
        output mass = angle.mass;

        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section wire { area = 1 cm^2; second_moment = 1 cm^4; }
        body hook {
            planar xy;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            mesh 4 * cable(wire, steel);
        }
        joint hook_root = clamp(hook.start, inertial);
        load pull = force(hook.end, [slender_load, 0, 0]);
        output hook_x = hook.end.x - leg;
        output hook_y = hook.end.y - leg;
        output corner = hook[1].start.y;
        output moment = hook[0].end.moment;

        section round = circle(radius = 20 mm);
        body twisted {
            spatial;
            line from [0, 0, 0] m to [leg, 0, 0] to [leg, leg, 0];
            section_y [0, 0, 1];
            twist rows.turn;
            mesh 2 * beam(round, steel);
        }
        joint twisted_root = clamp(twisted.start, inertial);
        output turned = twisted[0].end.ey.z;
        output turned_on = twisted.end.ey.z;
    }
}

#[test]
fn a_body_with_corners_bends_as_one() {
    // EXUDYN's LShapeGeomExactBeam2D, converged; a geometrically exact rod.
    let found = at_rest(&Angles::default());
    near(&found[..2], &[0.8592284754, -0.9140520497], 3e-6);
    let less = Angles {
        stiff_load: 0.1e6,
        ..Default::default()
    };
    near(&at_rest(&less)[..2], &[0.4463495787, -0.2849543354], 3e-6);
    // The table runs on behind the corner, from 10 to 30 kg/m.
    near(&found[2..3], &[40.0], 1e-12);
    // Small loads: P L^3/EI (1 + 1/3) + P L/EA, P L^3/(2 EI).
    let (bending, stretch) = (1.0 / (210e9 * 1e-8), 1.0 / (210e9 * 1e-4));
    near(
        &found[3..7],
        &[bending * 4.0 / 3.0 + stretch, -bending / 2.0, -bending / 2.0, -1.0],
        3e-3,
    );
    // The twist runs on, too: 45 and 90 deg about the axis.
    near(&found[7..8], &[0.5_f64.sqrt()], 1e-9);
    assert!(found[8].abs() < 1e-9, "{}", found[8]);
}
