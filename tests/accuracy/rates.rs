//! Rates of joints, beside those of springs at the same places.

use rncf::app::{RunSettings, run};

rncf::model! {
    /// Two arms of one kind that turn and slow down, one by a load that reads the rate, with beads that slide along them.
    pub model Tachometer {
        rigid arm { mass = 2 kg; inertia = [0.1, 0.3, 0.4] kg*m^2; angular_velocity = [0, 0, 3] rad/s; }
        rigid bead { mass = 0.5 kg; inertia = [0.01, 0.01, 0.01] kg*m^2; origin = [0.4, 0, 0] m; velocity = [0.2, 1.2, 0] m/s; angular_velocity = [0, 0, 3] rad/s; }
        joint hinge = revolute(inertial, arm.at([0, 0, 0] m), axis = z);
        joint guide = prismatic(arm, bead, axis = x);
        spring watch = linear(arm, bead, stiffness = 0 N/m, damping = 0 N*s/m);
        load brake = moment(arm, [0, 0, -0.2 [N*m*s] * hinge.rate]);
        rigid other { mass = 2 kg; inertia = [0.1, 0.3, 0.4] kg*m^2; angular_velocity = [0, 0, 3] rad/s; }
        rigid ring { mass = 0.5 kg; inertia = [0.01, 0.01, 0.01] kg*m^2; origin = [0.4, 0, 0] m; velocity = [0.2, 1.2, 0] m/s; angular_velocity = [0, 0, 3] rad/s; }
        joint pivot = revolute(inertial, other.at([0, 0, 0] m), axis = z);
        joint rail = prismatic(other, ring, axis = x);
        spring damper = torsional(pivot, stiffness = 0 N*m/rad, damping = 0.2 N*m*s/rad);
        output slid = guide.rate;
        output stretched = watch.rate;
        output turned = hinge.rate;
        output damped = damper.rate;
        run { t_end = 2 s; every = 50 ms; }
    }
}

#[test]
fn joints_tell_their_rates() {
    let found = run(&Tachometer {}, &RunSettings::default()).unwrap();
    let columns: Vec<Vec<f64>> = (0..4).map(|column| found.history.column(column).collect()).collect();
    let apart = |a: usize, b: usize| {
        let both = columns[a].iter().zip(&columns[b]);
        both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    assert!(
        apart(0, 1) < 1e-12 && columns[0].iter().any(|rate| *rate > 1.0),
        "{:?}",
        columns[0]
    );
    assert!(apart(2, 3) < 1e-5 && columns[2][40] < 1.0, "{:?}", columns[2]);
}
