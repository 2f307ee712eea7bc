//! What nobody uses is warned about at its name, unless that begins with an underscore.
#![deny(deprecated)]

rncf::model! {
    /// A rod with a param too many.
    pub model Rod {
        param gain = 3;
        param _reserve = 4;
        const half = 1 m;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        body rod {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(wire, steel);
        }
        joint root = clamp(rod.start, inertial);
        output tip = rod.end;
    }
}

#[allow(deprecated)]
mod silenced {
    rncf::model! {
        /// The same where it is meant.
        pub model Rod {
            param gain = 3;
            rigid bob { mass = 1 kg; }
            output x = bob.x;
        }
    }
}

fn main() {
    let _ = (Rod::default(), silenced::Rod::default());
}
