//! Starts in relative equilibrium, cautions, and strings that go slack.

mod assembled;
mod closed;
mod coils;
mod equilibria;
mod moving;
mod slack;

use rncf::Model;

rncf::model! {
    /// A wire whose short hub makes a torque senseless.
    pub model Cautious {
        param hub = 0 m;
        param pieces: count = 2;
        const limit = 1 day;
        material steel { density = 7800 kg/m^3; young = 210 GPa; }
        section round = circle(radius = 1 mm);
        body wire in inertial {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh pieces * cable(round, steel);
        }
        joint root = clamp(wire.start, inertial);
        output tip = wire.end;
        output torque = root.moment.z;
        caution point = "the hub is a point" on torque, tip if hub <= 0 m;
        caution long = "the run lasts long" if t_end > limit / 2;
        caution coarse = "one piece is coarse" on torque if pieces < 2;
        caution slow = "faster than a metre a day" if hub / t_end > 1 m/day;
    }
}

#[test]
fn cautions_are_told_where_their_conditions_hold() {
    let told = |model: &Cautious, t_end: f64| -> Vec<&'static str> {
        model.cautions(t_end).iter().map(|caution| caution.name).collect()
    };
    let model = Cautious::default();
    assert_eq!(told(&model, 1.0), ["point"]);
    assert_eq!(model.cautions(1.0)[0].outputs, [1, 0]);
    assert_eq!(model.cautions(1.0)[0].text, "the hub is a point");
    assert_eq!(told(&model, 43_201.0), ["point", "long"]);
    let model = Cautious { hub: 1.0, pieces: 1 };
    assert_eq!(told(&model, 1.0), ["coarse", "slow"]);
    assert_eq!(told(&model, 90_000.0), ["long", "coarse"]);
    assert_eq!(model.cautions(90_000.0)[0].outputs, [0_usize; 0]);
}
