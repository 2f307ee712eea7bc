//! A method for positions leaves something of the rates of constraints in every step. Where steps become short it must not be
//! taken for an error of theirs.

use rncf::app::{Judging, RunSettings, run};

use crate::runs::adaptive;

rncf::model! {
    /// A body on a ball joint and one on a hinge beside it, thrown round: it whips through 30 rad/s.
    pub model Whip {
        rigid upper {
            mass = 0.52 kg;
            inertia = [0.1796, 0.3452, 0.2407, 0.04, -0.0599, 0.0465] kg*m^2;
            origin = [0.958, -0.508, 1.843] m;
            axis = [-0.6721702382976923, -0.21160914909371792, 0.7095130293142304];
            angle = 0.43000000000000016 rad;
            velocity = [1.32674136794133, -1.4796975794729366, -1.3123916697742366] m/s;
            angular_velocity = [-1.106258201393148, -3.0261882189220417, 1.7742080664814863] rad/s;
        }
        rigid lower {
            mass = 3.275 kg;
            inertia = [0.1171, 0.1909, 0.1939, 0.031, 0.0317, -0.0315] kg*m^2;
            center = [0.111, 0.004, 0.102] m;
            origin = [-1.913, 1.8139999999999998, -0.614] m;
            velocity = [1.909340485071107, -9.807464833350949, -9.863355295653085] m/s;
            angular_velocity = [-0.42870208092521983, -2.6316675005121866, 2.533767412415446] rad/s;
        }
        joint ball = spherical(
            inertial.at([1.4092628595524728, -0.7991529326669427, 2.6274665712367633] m),
            upper.at([0.374, -0.624, 0.612] m)
        );
        joint hinge = revolute(
            upper.at([-1.548401507576521, 3.823357832599075, -1.1887824255254005] m),
            lower.at([0.475, 0.374, 0.129] m),
            axis = [0.92, -0.54, -0.76]
        );
        load weight = gravity([4.767, -3.795, 2.252] m/s^2);
        output place = lower.position;
        output kinetic = total.kinetic_energy;
        output energy = total.kinetic_energy + total.gravity_energy;
        run { t_end = 3 s; every = 0.02 s; }
    }
}

/// The energy is kept; stops at 0.2 and 0.5 s were the end of the last three of these.
#[test]
fn a_whip_is_followed_with_every_tolerance() {
    for (rtol, most) in [(1e-6, 1e-5), (1e-5, 4e-5), (3e-5, 2e-4), (1e-4, 6e-4)] {
        let settings = RunSettings {
            options: adaptive(rtol),
            judged: Judging::No,
            ..RunSettings::default()
        };
        let found = run(&Whip {}, &settings).unwrap();
        let column = |name: &str| found.history.column(found.history.find(name).unwrap());
        let kinetic = column("kinetic").fold(0.0, f64::max);
        let energy: Vec<f64> = column("energy").collect();
        let off = energy.iter().map(|now| (now - energy[0]).abs()).fold(0.0, f64::max) / kinetic;
        println!(
            "{rtol:e}: {off:e}, {} steps, {} rejected",
            found.statistics.steps, found.statistics.rejected_steps
        );
        assert!(off < most, "{rtol:e}: {off:e}");
        assert!(found.statistics.rejected_steps < found.statistics.steps / 2);
    }
}
