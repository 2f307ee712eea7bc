//! Loads per length that read velocity, slope and section axes, and gravity that changes from place to place.

use rncf::prelude::*;
use rncf_reference::tangents::compare_tangents;

rncf::model! {
    /// All kinds of bodies in all kinds of frames, in wind and under gravity of a point.
    pub model Winds {
        param wind = 3 m/s;
        param rho = 1.2 kg/m^3;
        param pressure = 30 N/m;
        param mu = 400 m^3/s^2;
        table polar {
            at = alpha;
            alpha = [-180, -90, -20, 0, 10, 25, 90, 180] deg; lift = [0, -0.8, -0.9, 0.2, 1.1, 1.2, 0.9, 0]; drag = [0.1, 1.8, 0.3, 0.02, 0.03, 0.3, 1.9, 0.1];
            moment = [0, 0.3, 0.1, -0.05, -0.1, -0.15, -0.3, 0];
            interpolation = monotone;
        }
        table plan { x = [0, 1, 2.2] m; chord = [0.3, 0.25, 0.1] m; }
        material rubber { density = 900 kg/m^3; young = 20 MPa; poisson = 0.4; }
        section foil = rectangle(y = 120 mm, z = 30 mm);
        section cord = circle(radius = 10 mm);
        frame hub = rotating(axis = z, angle = 2 [rad/s] * t);
        frame sail = free(origin = [3, 1, 0.5] m, axis = [0.6, 0, 0.8], angle = 0.4 rad, angular_velocity = [0.2, -0.1, 0.5] rad/s);
        fixture core on sail { mass = 2 kg; inertia = [0.1, 0.2, 0.25] kg*m^2; }
        rigid stone { mass = 3 kg; inertia = [0.3, 0.4, 0.6] kg*m^2; center = [0.1, 0, 0.05] m; origin = [0, 5, 1] m; }
        rigid ball { mass = 3 kg; origin = [0, -5, 1] m; }
        rigid slab { plane xy; mass = 3 kg; inertia = 0.4 kg*m^2; origin = [6 m, -5 m, 0]; }
        body blade in hub { spatial; line from [1, 0, 0] m to [3, 0, 0.2] m; twist 8 [deg/m] * x; mesh 2 * beam(foil, rubber); }
        body strip { planar xy; line from [0, 2, 0] m to [1, 2, 0] m; mesh 2 * cable(cord, rubber); }
        body plank in hub { planar xy; line from [0, 3, 0] m to [1, 3, 0] m; mesh 2 * beam(foil, rubber); }
        body tail in sail { spatial; line from [0, 0, 0] m to [1.2, 0.3, 0] m; mesh 2 * cable(cord, rubber); }
        body spar in sail { spatial; line from [0, 0, 0] m to [-1.2, 0.3, 0] m; mesh 2 * beam(foil, rubber); }
        fixture disc on blade.end { mass = 0.2 kg; inertia = [2, 1, 1] g*m^2; section = elastic; }
        joint a = clamp(blade.start, hub);
        joint b = clamp(strip.start, inertial);
        joint c = clamp(plank.start, hub);
        joint d = clamp(tail.start, sail);
        joint e = clamp(spar.start, sail);
        load air = distributed(blade, [0, q * plan.chord * polar.drag(alpha), q * plan.chord * polar.lift(alpha)],
            flow = [wind * (1 + 0.1 * sin(3 [rad/s] * t)), 0, 0] - velocity, v = dot(flow, section_y), w = dot(flow, section_z),
            alpha = atan2(w, v), q = 0.5 * rho * (v^2 + w^2),
            moment = [q * plan.chord^2 * polar.moment(alpha) + 20 N * sin(3 * x / (1 m)), 2 N, 0], in = section, points = 2);
        load squeeze = distributed(strip, [5 [N/m], pressure, 0], in = section, moment = [0, 0, 3 N * cos(2 * x / (1 m))]);
        load push = distributed(plank, [5 [N/m], pressure * dot(tangent, section_y), 0] , in = section, moment = [0, 0, 4 N]);
        load drag = distributed(tail, -0.5 * rho * 0.2 [m] * norm(across) * across, across = velocity - dot(velocity, tangent) * tangent);
        load stream = distributed(spar, -0.5 [kg/(m*s)] * (velocity - wind / (1 m) * cross([0, 0, 1], position)), moment = 3 [N] * section_z + 1 [kg*m/(m*s)] * velocity);
        load attraction = gravity(-mu * (position - [0.3, 0, 0.1] m) / norm(position - [0.3, 0, 0.1] m)^3);
        output tips = blade.end.position;
        output others = [strip.end.y, plank.end.y, stone.z];
        output tails = tail.end.in(inertial);
        output rest = [spar.end.in(inertial).x, ball.z, slab.x];
    }
}

#[test]
fn derivatives_are_those_of_the_forces() {
    compare_tangents(&Winds::default(), Formulation::Rncf, Joints::Eliminated);
    compare_tangents(&Winds::default(), Formulation::Ancf, Joints::Multipliers);
}
