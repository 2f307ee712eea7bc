//! A mistake in the model, and a crate that uses everything of it: no follow-up errors.

rncf::model! {
    /// A rod on a turning hub.
    pub model Rod {
        /// Angular velocity of the hub.
        param spin = 4 rad/s;
        /// Number of elements.
        param elements: count = 4;
        material steel { density = 7850 kg/m^3; young = 210 kN; poisson = 0.3; }
        section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
        motion theta(t) = spin * t;
        frame hub = rotating(axis = z, angle = theta(t));
        body rod in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * cable(wire, steel);
        }
        joint root = clamp(rod.start, hub);
        output tip = rod.end;
    }
}

use rncf::{Ancf, Formulation, Joints, Model, Scene};

/// A crate's own struct around the model.
#[derive(Clone, Debug, Default)]
pub struct Fleet {
    rods: Vec<Rod>,
}

fn build(rod: &Rod) -> Result<Box<dyn Scene>, rncf::ModelError> {
    rod.build(Formulation::Rncf, Joints::Eliminated)
}

fn main() {
    let mut rod = Rod { spin: 3.0, ..Rod::default() };
    rod.elements += 2;
    rod.set(0, rod.get(0) + rod.spin);
    let names: Vec<&str> = Rod::params().iter().map(|param| param.name).collect();
    let outputs = Rod::outputs().len() + Rod::NOTES.len();
    let fleet = Fleet { rods: vec![rod.clone(); rod.elements] };
    println!("{} {names:?} {outputs} {:?} {}", Rod::NAME, rod.run().t_end, fleet.rods.len());
    let _scene = build(&rod);
    let _absolute = rod.scene::<Ancf>();
}
