//! A damped rod beside the axis of a hub that gathers speed and trembles.
#![deny(
    warnings,
    missing_docs,
    missing_debug_implementations,
    unused,
    nonstandard_style,
    rust_2018_idioms
)]
#![deny(
    unreachable_pub,
    unused_qualifications,
    unused_results,
    trivial_casts,
    trivial_numeric_casts
)]
#![deny(clippy::all)]
#![forbid(unsafe_code)]

pub mod cords;
pub mod everything;

rncf::model! {
    /// A damped rod beside the axis of a hub that gathers speed and trembles.
    pub model Swing {
        /// Angular acceleration of the hub.
        param gain = 1.5 rad/s^2;
        /// Amplitude of the trembling.
        param amplitude = 3 deg;
        /// Angular frequency of the trembling.
        param nu = 11 rad/s;
        /// Distance of the rod's start from the axis.
        param offset = 20 cm;
        /// Number of elements.
        param elements: count = 5;

        /// Length of the rod.
        const reach = 1.2 m;

        material nylon { density = 1.15 g/cm^3; young = 2.7 GPa; damping = 0.4 ms; }
        section rod { area = pi * (2 mm)^2; second_moment = pi * (2 mm)^4 / 4; }

        /// Angle of the hub.
        motion theta(t) = gain * t^2/2 + amplitude * (1 - cos(nu*t));
        frame hub = rotating(axis = z, angle = theta(t));

        body arm in hub {
            planar xy;
            line from [offset, 0, 0] to [offset + reach, 0, 0];
            mesh elements * tether(rod, nylon, bending = exact);
        }
        joint root = clamp(arm.start, hub);

        /// Elongation of the tip in the frame.
        output u = arm.end.x - (offset + reach);
        /// Deflection of the tip in the frame.
        output v = arm.end.y;

        run { t_end = 2 s; every = 0.1 s; }
    }
}
