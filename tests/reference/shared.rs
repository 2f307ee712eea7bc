//! A library of models, which test targets take in as that of another crate.

rncf::library! {
    pub library blades {
        material alloy { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section strip = rectangle(y = 60 mm, z = 20 mm);
        /// A slender blade, edgewise in the plane of rotation.
        component Blade(azimuth: angle, root: frame, length: m = 3 m, count: count) {
            let along = cos(azimuth);
            let across = sin(azimuth);
            body spar in root {
                spatial;
                line from [0 m, 0 m, 0 m] to [0 m, length * along, length * across];
                section_y [0, -across, along];
                mesh count * beam(strip, alloy);
            }
            joint clip = clamp(spar.start, root);
            output root_moment = clip.moment;
            output mass = spar.mass;
        }
    }
}
