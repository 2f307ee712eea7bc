//! Andrews' squeezing mechanism (Schiehlen 1990; IVP test set): seven bodies in a plane, one degree of freedom.

rncf::model! {
    /// Andrews' squeezer: seven planar bodies, ten revolute joints, a motor and a spring. The crank makes two and
    /// a half turns in 30 ms, while the triangle hardly moves.
    pub model AndrewsSqueezer {
        /// Torque of the motor on the crank.
        param torque = 0.033 N*m;

        // Angles at the start, which close all loops.
        const beta_0 = -0.0617138900142764496 rad;
        const gamma_0 = 0.455279819163070380 rad;
        const phi_0 = 0.222668390165885885 rad;
        const delta_0 = 0.487364979543842550 rad;
        const epsilon_0 = 1.23054744454982119 rad;

        // Lengths between joints, under their published names.
        const rr = 7 mm;
        const d = 28 mm;
        const ss = 35 mm;
        const e = 20 mm;
        const zt = 40 mm;
        const zf = 20 mm;
        const u = 40 mm;
        // Fixed points on the ground: A carries k5 and k7, B carries k3, the spring ends at C.
        const x_a = -69.34 mm;
        const y_a = -2.27 mm;
        const x_b = -36.35 mm;
        const y_b = 32.73 mm;

        /// Crank, turning about the origin.
        rigid k1 {
            plane xy;
            mass = 0.04325 kg;
            inertia = 2.194e-6 kg*m^2;
            center = [0.92, 0, 0] mm;
            angle = beta_0;
        }
        /// Rod from the crank's end to the point F, in which four bodies meet.
        rigid k2 {
            plane xy;
            mass = 0.00365 kg;
            inertia = 4.410e-7 kg*m^2;
            center = [-11.5, 0, 0] mm;
            origin = [rr * cos(beta_0), rr * sin(beta_0), 0];
            angle = beta_0;
        }
        /// Triangle on the ground's point B, which the spring pulls.
        rigid k3 {
            plane xy;
            mass = 0.02373 kg;
            inertia = 5.255e-6 kg*m^2;
            center = [10.43, -18.74, 0] mm;
            origin = [x_b, y_b, 0];
            angle = gamma_0;
        }
        /// Rod from k5 to F.
        rigid k4 {
            plane xy;
            mass = 0.00706 kg;
            inertia = 5.667e-7 kg*m^2;
            center = [0, -5.79, 0] mm;
            origin = [x_a + zt * cos(delta_0), y_a + zt * sin(delta_0), 0];
            angle = phi_0 + delta_0;
        }
        /// Lower arm on the ground's point A.
        rigid k5 {
            plane xy;
            mass = 0.07050 kg;
            inertia = 1.169e-5 kg*m^2;
            center = [23.08, 9.16, 0] mm;
            origin = [x_a, y_a, 0];
            angle = delta_0;
        }
        /// Rod from k7 to F.
        rigid k6 {
            plane xy;
            mass = 0.00706 kg;
            inertia = 5.667e-7 kg*m^2;
            center = [5.79, 0, 0] mm;
            origin = [x_a + u * sin(epsilon_0), y_a - u * cos(epsilon_0), 0];
            angle = epsilon_0 - phi_0;
        }
        /// Upper arm on the ground's point A.
        rigid k7 {
            plane xy;
            mass = 0.05498 kg;
            inertia = 1.912e-5 kg*m^2;
            center = [-4.49, -12.28, 0] mm;
            origin = [x_a, y_a, 0];
            angle = epsilon_0;
        }

        joint o = revolute(k1, inertial.at([0, 0, 0] m));
        joint a5 = revolute(k5, inertial.at([x_a, y_a, 0]));
        joint a7 = revolute(k7, inertial.at([x_a, y_a, 0]));
        joint b = revolute(k3, inertial.at([x_b, y_b, 0]));
        joint k = revolute(k1.at([rr, 0, 0]), k2.at([0, 0, 0] m));
        joint e54 = revolute(k5.at([zt, 0, 0]), k4.at([0, 0, 0] m));
        joint h76 = revolute(k7.at([0, -u, 0]), k6.at([0, 0, 0] m));
        joint f23 = revolute(k2.at([-d, 0, 0]), k3.at([0, -ss, 0]));
        joint f24 = revolute(k2.at([-d, 0, 0]), k4.at([0, -e, 0]));
        joint f26 = revolute(k2.at([-d, 0, 0]), k6.at([zf, 0, 0]));

        load motor = moment(k1, [0, 0, torque]);
        spring tension = linear(
            k3.at([20, -18, 0] mm), inertial.at([14, 72, 0] mm), stiffness = 4530 [N/m], length = 77.85 mm
        );

        /// Angle of the crank.
        output beta = k1.angle;
        /// Angle of k2 to the crank.
        output theta = k2.angle - k1.angle;
        /// Angle of the triangle.
        output gamma = k3.angle;
        /// Angle of k4 to k5.
        output phi = k4.angle - k5.angle;
        /// Angle of the lower arm.
        output delta = k5.angle;
        /// Angle of k6 to k7.
        output omega = k6.angle - k7.angle;
        /// Angle of the upper arm.
        output epsilon = k7.angle;

        run { t_end = 0.03 s; every = 0.1 ms; }
    }
}
