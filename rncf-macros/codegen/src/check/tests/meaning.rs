//! Texts that could be read and mean nothing, or something else: what is wrong in meaning.txt.

/// Models with one more item than this one are wrong in meaning.txt.
pub const MEANING: &str = "
model Meaning {
    param push = 3 N;
    param pull = 0 N;
    param torque = 2 N*m;
    param g = 9.81 m/s^2;
    param frequency = 2 Hz;
    param length = 2 m;
    param small = 1e-3;
    param n: count = 4;
    const w = 2 rad/s;
    motion theta(t) = w * t;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    section block { area = 1 mm^2; second_moment = 1 mm^4; torsion_constant = 1 mm^4; shear_factor = 0.8; }
    frame hub = rotating(axis = z, angle = theta(t));
    frame sail = free(origin = [0, 0, 1] m);
    fixture core on sail { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    rigid arm { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    rigid bob { plane xy; mass = 1 kg; origin = [1, 0, 0] m; }
    rigid lump { mass = 1 kg; origin = [0, 0, 3] m; }
    body beam in hub { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint root = clamp(beam.start, hub);
    joint hinge = revolute(inertial, arm);
    output u = beam.end.x;
}
";

/// Models with one more item than this one are wrong in meaning.txt, in space.
pub const SPACE: &str = "
model Space {
    param torque = 2 N*m;
    param length = 2 m;
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section thin { area = 1 mm^2; second_moment = 1 mm^4; }
    frame sail = free(origin = [0, 0, 1] m);
    fixture core on sail { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    body rod { spatial; line from [0, 0, 0] m to [length, 0, 0]; mesh 2 * cable(thin, steel); }
    body mast in sail { spatial; line from [0, 0, 0] m to [length, 0, 0]; mesh 2 * cable(thin, steel); }
    joint foot = clamp(rod.start, inertial);
    joint step = clamp(mast.start, sail);
    output v = rod.end.x;
}
";
