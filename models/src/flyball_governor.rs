//! Stiff flyball governor (IFToMM benchmark A05): stiff dampers beside slow swinging.

rncf::model! {
    /// Flyball governor: two arms with balls on a spinning shaft, held by stiff, strongly damped springs on a slider.
    pub model FlyballGovernor {
        /// Spin at the start. Some sources begin with 2 pi rad/s.
        param omega_0 = 2 * pi * 0.16 Hz;

        const raised = 30 deg;
        // Square rods, 10 mm wide and 1 m long, about their own axis and across it.
        const along = 0.3 kg * (2e-4 [m^2]) / 12;
        const across = 0.3 kg * (1.0001 [m^2]) / 12;

        /// Shaft, from the ground to the arms' pins.
        rigid shaft {
            mass = 0.3 kg;
            inertia = [across, across, along];
            center = [0, 0, 0.5] m;
            angular_velocity = [0, 0, omega_0];
        }
        /// Slider; the springs stand on it beside the shaft.
        rigid slider {
            mass = 3 kg;
            inertia = [0.005, 0.005, 0.005] kg*m^2;
            origin = [0, 0, 0.5] m;
            angular_velocity = [0, 0, omega_0];
        }
        // The arms' own x axes lie along the rods, both to the right.
        rigid right {
            mass = 0.3 kg;
            inertia = [along, across, across];
            center = [0.5, 0, 0] m;
            origin = [0.05, 0, 1] m;
            axis = y;
            angle = raised;
            velocity = [0, 0.05 m * omega_0, 0];
            angular_velocity = [-omega_0 * sin(raised), 0, omega_0 * cos(raised)];
        }
        rigid left {
            mass = 0.3 kg;
            inertia = [along, across, across];
            center = [-0.5, 0, 0] m;
            origin = [-0.05, 0, 1] m;
            axis = y;
            angle = -raised;
            velocity = [0, -0.05 m * omega_0, 0];
            angular_velocity = [omega_0 * sin(raised), 0, omega_0 * cos(raised)];
        }
        fixture right_ball on right.at([1, 0, 0] m) { mass = 5 kg; }
        fixture left_ball on left.at([-1, 0, 0] m) { mass = 5 kg; }

        joint foot = revolute(shaft, inertial.at([0, 0, 0] m), axis = z);
        joint guide = prismatic(shaft, slider, axis = z);
        joint right_pin = revolute(shaft.at([0.05, 0, 1] m), right.at([0, 0, 0] m), axis = y);
        joint left_pin = revolute(shaft.at([-0.05, 0, 1] m), left.at([0, 0, 0] m), axis = y);

        // At the start they are as long as at rest: the slider falls a little until they carry it.
        spring right_strut = linear(
            slider.at([0.05, 0, 0] m), right.at([0.5, 0, 0] m),
            stiffness = 8e5 [N/m], damping = 4e4 [N*s/m], length = 0.5 m
        );
        spring left_strut = linear(
            slider.at([-0.05, 0, 0] m), left.at([-0.5, 0, 0] m),
            stiffness = 8e5 [N/m], damping = 4e4 [N*s/m], length = 0.5 m
        );
        load weight = gravity([0, 0, -9.81] m/s^2);

        /// Angle of the arms below the horizontal.
        output alpha = asin(-right.ex.z);
        /// Height of the slider.
        output s = slider.z;
        /// Spin of the shaft.
        output spin = shaft.angular_velocity.z;

        run { t_end = 10 s; every = 0.01 s; }
    }
}
