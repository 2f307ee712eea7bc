//! A pipe on nine elastic supports: the ground is everywhere and hardly anything turns, where referenced coordinates cost more
//! than absolute ones.

rncf::model! {
    /// A pipe on nine elastic supports, shaken by a force between two of them. It has a frame of its own that it hardly needs,
    /// as nothing turns far: every support ties the frame and the pipe to the ground.
    pub model PinnedPipe {
        /// Number of elements.
        param elements: count = 16;
        /// Stiffness of a support along each axis.
        param support = 40 kN/m;
        /// Amplitude of the force.
        param push = 200 N;
        /// Its angular frequency.
        param rate = 60 rad/s;

        const length = 8 m;

        material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
        section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }

        /// Follows the pipe's chord.
        frame own = free(plane = xy);
        body pipe in own {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(tube, aluminium);
            chord;
        }

        spring support_0 = bushing(pipe.start, inertial.at([0, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_1 = bushing(pipe.at(1 m), inertial.at([1, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_2 = bushing(pipe.at(2 m), inertial.at([2, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_3 = bushing(pipe.at(3 m), inertial.at([3, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_4 = bushing(pipe.at(4 m), inertial.at([4, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_5 = bushing(pipe.at(5 m), inertial.at([5, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_6 = bushing(pipe.at(6 m), inertial.at([6, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_7 = bushing(pipe.at(7 m), inertial.at([7, 0, 0] m), stiffness = [support, support, 0 [N/m]]);
        spring support_8 = bushing(pipe.end, inertial.at([8, 0, 0] m), stiffness = [support, support, 0 [N/m]]);

        load shake = force(pipe.at(3.5 m), [0 N, push * sin(rate * t), 0 N], in = inertial);

        /// Deflection under the force.
        output v = pipe.at(3.5 m).in(inertial).y;
        /// Deflection of the far end.
        output v_end = pipe.end.in(inertial).y;

        run { t_end = 0.5 s; every = 2.5 ms; }
    }
}
