//! The same models with their bodies described in several ways.

// Models from one template do not use all of its params.
#![allow(deprecated)]

/// The beam of the spin-up (THEORY 9.1) in modes.
macro_rules! spin_up {
    ($name:ident, { $($fidelity:tt)* }) => {
        rncf::model! {
            pub model $name {
                param omega_s = 4 rad/s;
                param T_s = 15 s;
                param elements: count = 6;
                param modes: count = 4;
                material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
                section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
                motion theta(t) =
                    if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
                    else { omega_s * (t - T_s/2) };
                frame hub = rotating(axis = z, angle = theta(t));
                body beam in hub {
                    planar xy;
                    line from [0, 0, 0] m to [8, 0, 0] m;
                    mesh elements * cable(tube, aluminium);
                    $($fidelity)*
                }
                joint root = clamp(beam.start, hub);
                output u = beam.end.x - 8 m;
                output v = beam.end.y;
                run { t_end = 20 s; every = 0.05 s; }
            }
        }
    };
}
spin_up!(SpinUpModal, {
    modal(modes);
});
spin_up!(SpinUpSmall, {
    small(modes);
});

/// Rotor without dimensions, THEORY 8.2: 1 kg/m, 1 N m^2 and 1 m, so that eta is the spin in rad/s, and
/// EI/(EA L^2) = 1e-8.
macro_rules! rotor {
    ($name:ident, { $($fidelity:tt)* }) => {
        rncf::model! {
            pub model $name {
                param eta = 0 rad/s;
                param elements: count = 8;
                param modes: count = 4;
                material stiff { density = 1000 kg/m^3; young = 100 GPa; }
                section wire { area = 10 cm^2; second_moment = 10 mm^4; }
                frame hub = rotating(axis = z, angle = eta * t);
                body blade in hub {
                    spatial;
                    line from [0, 0, 0] m to [1, 0, 0] m;
                    mesh elements * tether(wire, stiff);
                    $($fidelity)*
                }
                joint root = clamp(blade.start, hub);
                output tip = blade.end;
            }
        }
    };
}
rotor!(Rotor, {});
rotor!(RotorModal, {
    modal(modes);
});
rotor!(RotorSmall, {
    small(modes);
});

/// A hub with mass that flies and turns in the plane, with a soft arm.
macro_rules! hub_with_arm {
    ($name:ident, { $($fidelity:tt)* }) => {
        rncf::model! {
            pub model $name {
                param torque = 0 N*m;
                param elements: count = 3;
                param modes: count = 4;
                material rubber { density = 1000 kg/m^3; young = 2 MPa; }
                section strip { area = 5 cm^2; second_moment = 5 cm^4; }
                rigid hub {
                    plane xy; mass = 2 kg; inertia = 0.1 kg*m^2; center = [0.1, 0.05, 0] m;
                    origin = [0.3, -0.2, 0] m; angle = 20 deg; velocity = [0.5, -1, 0] m/s; speed = 2 rad/s;
                }
                body arm in hub {
                    planar xy;
                    line from [0.2, 0, 0] m to [1.2, 0, 0] m;
                    mesh elements * cable(strip, rubber);
                    $($fidelity)*
                }
                joint root = clamp(arm.start, hub);
                load turn = moment(hub, [0, 0, torque * sin(3 [rad/s] * t)]);
                output place = hub;
                output angle = hub.angle;
                output tip = arm.end;
                output seen = arm.end.in(inertial);
            }
        }
    };
}
hub_with_arm!(HubArm, {});
hub_with_arm!(HubArmModal, {
    modal(modes);
});

/// Without a load, so that its energy stays.
macro_rules! flying_arm {
    ($name:ident, { $($fidelity:tt)* }) => {
        rncf::model! {
            pub model $name {
                param elements: count = 3;
                param modes: count = 4;
                material rubber { density = 1000 kg/m^3; young = 2 MPa; }
                section strip { area = 5 cm^2; second_moment = 5 cm^4; }
                rigid hub {
                    mass = 2 kg; inertia = [0.1, 0.15, 0.2] kg*m^2; center = [0.1, 0.05, -0.02] m;
                    velocity = [0.5, -1, 0.3] m/s; angular_velocity = [0.7, -0.5, 2] rad/s;
                }
                body arm in hub {
                    spatial;
                    line from [0.2, 0, 0] m to [1.2, 0, 0] m;
                    mesh elements * cable(strip, rubber);
                    $($fidelity)*
                }
                joint root = clamp(arm.start, hub);
                output place = hub;
                output tip = arm.end;
                output seen = arm.end.in(inertial);
            }
        }
    };
}
flying_arm!(FlyingArm, {});
flying_arm!(FlyingArmModal, {
    modal(modes);
});
flying_arm!(FlyingArmRigid, {
    rigid;
});

rncf::model! {
    /// A rigid body with the ten numbers of [`FlyingArmRigid`]: 0.5 kg on 1 m.
    pub model OneRigid {
        rigid hub {
            mass = 2 kg; inertia = [0.1, 0.15, 0.2] kg*m^2; center = [0.1, 0.05, -0.02] m;
            velocity = [0.5, -1, 0.3] m/s; angular_velocity = [0.7, -0.5, 2] rad/s;
        }
        fixture rod on hub.at([0.7, 0, 0] m) { mass = 0.5 kg; inertia = [0, 1 [kg*m^2] / 24, 1 [kg*m^2] / 24]; }
        output place = hub;
        output tip = hub.at([1.2, 0, 0] m).in(hub);
        output seen = hub.at([1.2, 0, 0] m).in(inertial);
    }
}

rncf::model! {
    /// A rigid rod on a hinge under gravity.
    pub model RigidPendulum {
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section thin { area = 1 cm^2; second_moment = 1 cm^4; }
        frame hinge = hinged(axis = z, angle = 20 deg, speed = 1 rad/s);
        body rod in hinge {
            planar xy;
            line from [0, 0, 0] m to [1.5, 0, 0] m;
            mesh 2 * cable(thin, steel);
            rigid;
        }
        load weight = gravity([0, -9.81, 0] m/s^2);
        output angle = hinge.angle;
        output speed = hinge.speed;
        output tip = rod.end.in(inertial);
    }
}

/// Two arms on hubs, the second one on a pin at the end of the first one, under gravity.
macro_rules! double_pendulum {
    ($name:ident, { $($first:tt)* }, { $($second:tt)* }) => {
        rncf::model! {
            pub model $name {
                param elements: count = 2;
                param modes: count = 4;
                material rubber { density = 1000 kg/m^3; young = 20 MPa; }
                section strip { area = 5 cm^2; second_moment = 5 cm^4; }
                rigid upper_hub { plane xy; mass = 0.2 kg; inertia = 0.01 kg*m^2; speed = 1 rad/s; }
                rigid lower_hub { plane xy; mass = 0.1 kg; inertia = 0.01 kg*m^2; origin = [1, 0, 0] m; velocity = [0, 1, 0] m/s; speed = -1 rad/s; }
                body upper in upper_hub {
                    planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * cable(strip, rubber);
                    $($first)*
                }
                body lower in lower_hub {
                    planar xy; line from [0, 0, 0] m to [0.7, 0, 0] m; mesh elements * cable(strip, rubber);
                    $($second)*
                }
                joint upper_root = clamp(upper.start, upper_hub);
                joint lower_root = clamp(lower.start, lower_hub);
                joint pivot = revolute(upper_hub, inertial);
                joint elbow = revolute(lower_hub, upper.end);
                load weight = gravity([0, -9.81, 0] m/s^2);
                output elbow_at = upper.end.in(inertial);
                output tip = lower.end.in(inertial);
                output pull = elbow.force;
            }
        }
    };
}
double_pendulum!(TwoArms, {}, {});
double_pendulum!(
    TwoArmsModal,
    {
        modal(modes);
    },
    {}
);
double_pendulum!(
    TwoArmsBothModal,
    {
        modal(modes);
    },
    {
        modal(modes);
    }
);
double_pendulum!(
    TwoArmsRigid,
    {
        modal(modes);
    },
    {
        rigid;
    }
);
