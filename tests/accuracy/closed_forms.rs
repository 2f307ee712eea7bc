//! Small machines of many kinds against their closed forms: what somebody tries on the first day.

use rncf::app::{EquilibriumSettings, RunSettings, modes, run};
use rncf::linalg::c64;
use rncf::prelude::*;

rncf::model! {
    /// A bead on a rod that turns.
    pub model Bead {
        param w = 3 rad/s;
        param r = 0.1 m;
        param mass = 2 kg;
        frame rod = rotating(axis = z, angle = w * t);
        rigid bead in rod { plane xy; mass = mass; inertia = 0.01 kg*m^2; origin = [r, 0 m, 0 m]; }
        joint slide = prismatic(rod, bead, axis = x);
        output way = slide.slide;
        output side = slide.force.in(rod).y;
        run { t_end = 2 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A disc on a shaft that turns; the shaft has two stiffnesses and damps in turning axes, the air damps in fixed ones.
    pub model Rotor {
        param w = 50 rad/s;
        param mass = 2 kg;
        param ky = 2 kN/m;
        param kz = 2 kN/m;
        param inner = 5 N*s/m;
        param outer = 5 N*s/m;
        frame shaft = rotating(axis = x, angle = w * t);
        rigid disc in shaft { plane yz; mass = mass; }
        spring bending = bushing(disc, shaft, stiffness = [0, ky, kz], damping = [0, inner, inner]);
        spring air = bushing(disc, inertial, stiffness = [0, 0, 0] N/m, damping = [0, outer, outer]);
        output y = disc.y;
    }
}

rncf::model! {
    /// Two wheels that roll on each other, the second on a bearing beside the first.
    pub model Gears {
        param k = 30 N*m/rad;
        rigid large { plane xy; mass = 1 kg; inertia = 0.2 kg*m^2; }
        rigid small { plane xy; mass = 1 kg; inertia = 0.05 kg*m^2; origin = [1, 0, 0] m; }
        joint left = revolute(inertial, large);
        joint right = revolute(small.at([0, 0, 0] m), inertial);
        constraint teeth = 2 * left.angle + right.angle;
        spring coil = torsional(left, stiffness = k);
        output angle = left.angle;
    }
}

rncf::model! {
    /// A wire between two walls, stretched.
    pub model Wire {
        param e = 0.01;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round = circle(radius = 0.2 mm);
        body string {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 12 * cable(round, steel, axial = engineering, bending = exact);
            initial position [x * (1 + e), 0 m, 0 m];
        }
        joint left = pin(string.start, inertial);
        joint right = pin(string.end, inertial, at = [1 m * (1 + e), 0 m, 0 m]);
        output y = string.at(0.5 m).y;
    }
}

rncf::model! {
    /// A blade on a hinge beside the axis of its hub, free to flap or to lag.
    pub model Hinged {
        param w = 40 rad/s;
        const e = 0.5 m;
        frame hub = rotating(axis = z, angle = w * t);
        rigid flapping in hub { mass = 30 kg; inertia = [0.1, 60, 60] kg*m^2; origin = [e, 0 m, 0 m]; center = [2.5, 0, 0] m; }
        rigid lagging in hub { mass = 30 kg; inertia = [0.1, 60, 60] kg*m^2; origin = [-e, 0 m, 0 m]; center = [-2.5, 0, 0] m; }
        joint flap = revolute(flapping, hub.at([e, 0 m, 0 m]), axis = y);
        joint lag = revolute(lagging, hub.at([-e, 0 m, 0 m]), axis = z);
        output flapped = flap.angle;
        output lagged = lag.angle;
    }
}

rncf::model! {
    /// A ball that falls on an elastic floor.
    pub model Ball {
        param k = 10 kN/m;
        rigid ball { plane xy; mass = 1 kg; origin = [0, 1, 0] m; }
        load weight = gravity([0, -10, 0] m/s^2);
        load floor = force(ball, [0 N, k * max(-ball.y, 0 m), 0 N]);
        output y = ball.y;
        run { t_end = 3 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A wheel on a coil spring, in space: its angle is known up to whole turns.
    pub model Wound {
        param spin = 1 rad/s;
        param k = 0.1 N*m/rad;
        rigid wheel { mass = 1 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; angular_velocity = [0, 0, spin]; }
        joint axle = revolute(inertial, wheel, axis = z);
        spring coil = torsional(axle, stiffness = k);
        output angle = axle.angle;
        run { t_end = 4 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A nut on a thread, in space.
    pub model Nut {
        param pitch = 20 mm/rad;
        rigid nut { mass = 2 kg; inertia = [0.001, 0.001, 0.002] kg*m^2; }
        joint guide = cylindrical(inertial, nut, axis = z);
        constraint thread = guide.slide - pitch * guide.angle;
        load weight = gravity([0, 0, -9.81] m/s^2);
        output z = nut.z;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// A wheel whose moment is that of the sine of its angle: it may turn for ever.
    pub model Turning {
        rigid wheel { mass = 1 kg; inertia = [0.1, 0.1, 0.1] kg*m^2; angular_velocity = [0, 0, 8] rad/s; }
        joint axle = revolute(inertial, wheel, axis = z);
        load pull = moment(wheel, [0, 0, -0.5 [N*m] * sin(axle.angle)]);
        output energy = wheel.kinetic_energy - 0.5 [N*m] * cos(axle.angle);
        run { t_end = 4 s; every = 0.1 s; }
    }
}

/// The last row of a run with the tolerance `rtol`.
pub(super) fn last<M: Model + Clone + 'static>(model: &M, rtol: f64) -> Result<Vec<f64>, String> {
    let mut settings = RunSettings::default();
    settings.options.rtol = rtol;
    let result = run(model, &settings).map_err(|error| error.to_string())?;
    let columns = 0..result.history.columns.len();
    Ok(columns
        .map(|column| result.history.column(column).last().unwrap())
        .collect())
}

/// Growth rates and angular frequencies.
pub(super) fn exponents<M: Model + Clone + 'static>(model: &M, count: usize) -> Vec<(f64, f64)> {
    let settings = EquilibriumSettings {
        count,
        ..EquilibriumSettings::default()
    };
    let found = modes(model, &settings).unwrap().modes;
    found.iter().map(|mode| (mode.re, mode.im)).collect()
}

pub(super) fn assert_near(found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{found} instead of {wanted}");
}

#[test]
fn a_bead_on_a_turning_rod_flies_out_as_cosh() {
    let bead = Bead::default();
    let row = last(&bead, 1e-8).unwrap();
    let angle = 2.0 * bead.w;
    assert_near(row[0], bead.r * (angle.cosh() - 1.0), 1e-7);
    // Coriolis' force, from the bead on the rod.
    let wanted = 2.0 * bead.mass * bead.w * bead.r * bead.w * angle.sinh();
    assert_near(row[1].abs(), wanted, 1e-6);
}

/// Rotating damping makes a shaft whirl above its critical speed; unequal stiffnesses make it fly out between its two.
#[test]
fn a_damped_rotor_grows_and_decays_as_its_equation_says() {
    let rotor = Rotor::default();
    // With z = y + i z in turning axes: z'' + (2 i w + (ci + ce) / m) z' + (k / m - w^2 + i w ce / m) z = 0.
    let (total, natural) = ((rotor.inner + rotor.outer) / rotor.mass, rotor.ky / rotor.mass);
    let half = c64::new(total / 2.0, rotor.w);
    let rest = c64::new(natural - rotor.w * rotor.w, rotor.w * rotor.outer / rotor.mass);
    let root = (half * half - rest).sqrt();
    let mut wanted = [root - half, -root - half].map(|exponent| (exponent.re, exponent.im.abs()));
    wanted.sort_by(|a, b| a.1.total_cmp(&b.1));
    for ((re, im), found) in wanted.into_iter().zip(exponents(&rotor, 4)) {
        assert_near(found.0, re, 1e-8);
        assert_near(found.1, im, 1e-8);
    }
    let uneven = Rotor {
        w: 37.0,
        kz: 4000.0,
        inner: 0.0,
        outer: 0.0,
        ..rotor
    };
    // s^4 + (p + q + 2 w^2) s^2 + (p - w^2)(q - w^2) = 0 with p = ky / m, q = kz / m.
    let (p, q, w) = (uneven.ky / uneven.mass, uneven.kz / uneven.mass, uneven.w);
    let (sum, product) = (p + q + 2.0 * w * w, (p - w * w) * (q - w * w));
    let growth = ((-sum + (sum * sum - 4.0 * product).sqrt()) / 2.0).sqrt();
    let found = exponents(&uneven, 4);
    let largest = found.iter().map(|exponent| exponent.0).fold(0.0, f64::max);
    assert_near(largest, growth, 1e-8);
}

#[test]
fn frequencies_of_gears_wires_and_hinged_blades() {
    let gears = Gears::default();
    let found = exponents(&gears, 1);
    assert_near(found[0].1, (gears.k / (0.2 + 4.0 * 0.05)).sqrt(), 1e-9);

    let wire = Wire::default();
    let (stretch, pi) = (1.0 + wire.e, std::f64::consts::PI);
    // Tension over mass, per stress-free length; bending of a pinned wire adds its part.
    let (speed2, gyration2) = (210e9 / 7850.0, 0.25 * 0.0002_f64.powi(2));
    for (n, found) in exponents(&wire, 3).iter().enumerate() {
        let wave = (n + 1) as f64 * pi;
        let wanted = wave * (speed2 * (wire.e / stretch + gyration2 * (wave / (stretch * stretch)).powi(2))).sqrt();
        assert_near(found.1, wanted, 2e-5);
    }

    let blade = Hinged::default();
    let found = exponents(&blade, 2);
    let (about_hinge, couple): (f64, f64) = (60.0 + 30.0 * 2.5 * 2.5, 30.0 * 0.5 * 2.5);
    assert_near(found[0].1, blade.w * (couple / about_hinge).sqrt(), 1e-9);
    let flap = (60.0 - 0.1 + 30.0 * 2.5 * 2.5 + couple) / about_hinge;
    assert_near(found[1].1, blade.w * flap.sqrt(), 1e-9);
}

/// Free fall, half a vibration on the floor, free flight, ..: what a contact leaves of errors lasts through the flight.
#[test]
fn a_ball_bounces_as_high_as_it_fell() {
    let alpha = Method::GeneralizedAlpha { rho_inf: 0.8 };
    for (k, rtol, method, tolerance) in [
        (1e4, 1e-6, Method::Radau, 5e-6),
        (1e4, 1e-8, Method::Radau, 5e-8),
        (1e6, 1e-6, Method::Radau, 5e-6),
        (1e6, 1e-8, Method::Radau, 5e-8),
        (1e8, 1e-8, Method::Radau, 5e-8),
        (1e4, 1e-6, alpha, 1e-4),
        (1e6, 1e-8, alpha, 5e-5),
    ] {
        let mut settings = RunSettings {
            method,
            ..RunSettings::default()
        };
        settings.options.rtol = rtol;
        let result = run(&Ball { k }, &settings).unwrap();
        let (found, wanted) = (result.history.column(0).last().unwrap(), bounced(k, 3.0));
        assert!(
            (found - wanted).abs() < tolerance,
            "{k} {rtol} {method:?}: {found} {wanted}"
        );
    }
}

/// Height of the ball at a time.
fn bounced(k: f64, end: f64) -> f64 {
    let (g, w) = (10.0_f64, k.sqrt());
    let speed = (2.0 * g).sqrt();
    // On the floor -y = g/w^2 (1 - cos wt) + speed/w sin wt, until it vanishes again.
    let contact = 2.0 * (std::f64::consts::PI - (speed * w / g).atan()) / w;
    let (fall, flight) = (speed / g, 2.0 * speed / g);
    let since = (end - fall) % (contact + flight);
    let rising = since - contact;
    assert!(rising > 0.0, "in flight");
    speed * rising - 0.5 * g * rising * rising
}

/// In space an angle between axes jumps from pi to -pi. A law that jumps with it stops the run; a periodic one does not.
#[test]
fn an_angle_that_passes_half_a_turn_stops_a_law_that_jumps_there() {
    let gentle = Wound::default();
    let row = last(&gentle, 1e-8).unwrap();
    assert!((row[0] - gentle.spin * 4_f64.sin()).abs() < 1e-6, "{}", row[0]);
    let far = Wound { spin: 8.0, ..gentle };
    for rtol in [1e-4, 1e-6, 1e-8] {
        let message = last(&far, rtol).unwrap_err();
        assert!(message.contains("the angle in `coil` passes half a turn"), "{message}");
        let message = last(&Nut::default(), rtol).unwrap_err();
        assert!(
            message.contains("the angle in `thread` passes half a turn"),
            "{message}"
        );
    }
    // Up to there the nut falls with m g / (m + J / pitch^2).
    let nut = Nut { pitch: 2.0 };
    let row = last(&nut, 1e-8).unwrap();
    assert_near(row[0], -0.5 * 9.81 * 2.0 / (2.0 + 0.0005), 1e-8);
    let energy = last(&Turning::default(), 1e-8).unwrap()[0];
    assert!((energy - (0.05 * 64.0 - 0.5)).abs() < 1e-6, "{energy}");
}
