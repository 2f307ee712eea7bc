//! Rotating cantilever on a hub: its frequencies over the speed are a classical table.

rncf::model! {
    /// Uniform cantilever on a rotating hub (Wright et al. 1982). Length, mass and bending stiffness are 1 in SI, so that
    /// rad/s are multiples of sqrt(EI/(rhoA L^4)).
    pub model RotatingCantilever {
        /// Angular velocity over sqrt(EI/(rhoA L^4)).
        param eta = 6;
        /// Radius of the hub over the length.
        param hub_ratio = 0;
        /// Number of elements.
        param elements: count = 16;

        const length = 1 m;

        // EI/(EA L^2) = 1e-8: the axis hardly stretches.
        material unit { density = 1 kg/m^3; young = 100 MPa; }
        section slender { area = 1 m^2; second_moment = 1e-8 m^4; }

        motion theta(t) = eta * 1 [rad/s] * t;
        frame hub = rotating(axis = z, angle = theta(t));

        body beam in hub {
            spatial;
            line from [hub_ratio * length, 0 m, 0 m] to [(hub_ratio + 1) * length, 0 m, 0 m];
            mesh elements * cable(slender, unit);
        }
        joint root = clamp(beam.start, hub);

        /// Elongation of the tip.
        output u = beam.end.x - (hub_ratio + 1) * length;
        /// Deflection of the tip in the plane of rotation.
        output v = beam.end.y;
        /// Deflection of the tip along the axis of rotation.
        output w = beam.end.z;
        /// Tension in the root.
        output tension = beam.start.axial_force;

        run { t_end = 1 s; every = 0.01 s; }
    }
}
