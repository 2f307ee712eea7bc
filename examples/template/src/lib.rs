//! The model of this crate. Change it, run it with `cargo run --release`, use it in Python after `pip install .`.

rncf::model! {
    /// A rope that falls from the horizontal and swings in a plane.
    pub model Swing {
        param length = 1 m;
        /// Acceleration of free fall.
        param g = 9.81 m/s^2;
        param elements: count = 24;
        material rubber { density = 1150 kg/m^3; young = 2 MPa; poisson = 0.45; }
        section cord = circle(radius = 5 mm);
        body rope in inertial {
            planar xy;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh elements * cable(cord, rubber);
        }
        joint hook = pin(rope.start, inertial);
        load weight = gravity([0, -g, 0]);
        /// The free end.
        output tip = rope.end;
        /// Force of the hook on the rope.
        output pull = hook.force;
        run { t_end = 1 s; every = 0.01 s; }
    }
}

#[cfg(feature = "python")]
rncf::python!(swing: Swing);
