//! States in equilibria and small motions: however far they go, whatever their units, and in turning axes.

use rncf::app::{EquilibriumSettings, Range, RunSettings, campbell, modes, run, static_equilibria, steady};

mod warm {
    rncf::model! {
        /// A block that a strip pushes as it warms.
        pub model Warm {
            param outside = 400 K;
            rigid block { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            joint slide = prismatic(inertial, block, axis = x);
            spring coil = coordinate(slide.slide, stiffness = 100 N/m, damping = 2 N*s/m);
            state warmth = integral((outside - warmth) / 1 [s], start = 300 K);
            load strip = force(block, [1 [N/K] * (warmth - 300 K), 0, 0]);
            output x = block.x;
            output temperature = warmth;
        }
    }
}

mod valve {
    rncf::model! {
        /// A piston between two chambers of oil whose valve is shut.
        pub model Shut {
            const A = 1e-3 m^2;
            const V = 2e-4 m^3;
            rigid piston { plane xy; mass = 100 kg; inertia = 1 kg*m^2; }
            joint slide = prismatic(inertial, piston, axis = x);
            state left = integral(-1.4e9 [Pa] * A / (V + A * slide.slide) * slide.rate, start = 10 MPa);
            state right = integral(1.4e9 [Pa] * A / (V - A * slide.slide) * slide.rate, start = 10 MPa);
            load oil = force(piston, [A * (left - right) - 300 [N*s/m] * slide.rate - 2e4 [N/m] * slide.slide, 0, 0]);
            output x = piston.x;
        }
    }
}

mod wound {
    rncf::model! {
        /// A pressure that an integral builds up until a weight stands at the wanted place.
        pub model Wound {
            param wanted = 0.1 m;
            rigid piston { plane xy; mass = 2000 kg; inertia = 1 kg*m^2; }
            joint slide = prismatic(inertial, piston, axis = y);
            load weight = gravity([0, -9.81, 0] m/s^2);
            state pressure = integral(1e6 [Pa/m/s] * (wanted - slide.slide), start = 0 Pa);
            load oil = force(piston, [0, 1e-3 [m^2] * pressure - 3e4 [N/m] * slide.slide - 2e4 [N*s/m] * slide.rate, 0]);
            output y = piston.y;
            output of_oil = pressure;
        }
    }
}

mod climbing {
    rncf::model! {
        /// A bob on a spring that a force pulls the more, the longer it hangs.
        pub model Climbing {
            rigid bob { plane xy; mass = 2 kg; inertia = 1 kg*m^2; origin = [0, -1, 0] m; }
            joint slide = prismatic(inertial.at([0, -1, 0] m), bob, axis = y);
            spring coil = linear(inertial.at([0, 0, 0] m), bob, stiffness = 500 N/m, length = 1 m);
            state since = integral(1, start = 0 s);
            load pull = force(bob, [0, 1 [N/s] * since, 0]);
            output y = bob.y;
        }
    }
}

mod washed {
    rncf::model! {
        /// A disc on round supports whose control, in axes that turn with it, answers to fast motions alone.
        pub model Washed {
            param speed = 100 rad/s;
            param gain = 50 N*s/m;
            param unit = 1;
            frame rotor = rotating(axis = z, angle = speed * t);
            rigid disc in rotor { plane xy; mass = 10 kg; }
            spring support = bushing(disc, inertial, stiffness = [100, 100, 0] kN/m, damping = [30, 30, 0] N*s/m);
            state slow_x = integral((disc.in(rotor).x / unit - slow_x) / 10 [ms], start = 0 m);
            state slow_y = integral((disc.in(rotor).y / unit - slow_y) / 10 [ms], start = 0 m);
            load control = force(disc, [
                -gain * (disc.in(rotor).x - unit * slow_x) / 10 [ms],
                -gain * (disc.in(rotor).y - unit * slow_y) / 10 [ms], 0], in = rotor);
            output x = disc.in(rotor).x;
        }
    }
}

mod centred {
    rncf::model! {
        /// The same disc, which integrals hold in the middle.
        pub model Centred {
            param speed = 100 rad/s;
            param size = 1 [m*s];
            frame rotor = rotating(axis = z, angle = speed * t);
            rigid disc in rotor { plane xy; mass = 10 kg; }
            spring support = bushing(disc, inertial, stiffness = [100, 100, 0] kN/m, damping = [30, 30, 0] N*s/m);
            state sum_x = integral(disc.in(rotor).x, start = 0 [m*s], size = size);
            state sum_y = integral(disc.in(rotor).y, start = 0 [m*s], size = size);
            load control = force(disc, [-1e5 [N/m/s] * sum_x, -1e5 [N/m/s] * sum_y, 0], in = rotor);
            output x = disc.in(rotor).x;
        }
    }
}

mod listening {
    rncf::model! {
        /// A hinged blade that turns, and a filter of its angle that nothing listens to.
        pub model Listening {
            param speed = 30 rad/s;
            param gain = 0.01;
            frame rotor = rotating(axis = z, angle = speed * t);
            rigid blade in rotor { mass = 10 kg; inertia = [0.01, 13.3333333, 13.3333333] kg*m^2; center = [2, 0, 0] m; origin = [0.3, 0, 0] m; }
            joint hinge = revolute(rotor.at([0.3, 0, 0] m), blade.at([0, 0, 0] m), axis = y);
            state heard = integral((gain * 1000 * hinge.angle - heard) / 50 [ms], start = 0 rad);
            output angle = hinge.angle;
            output shown = heard;
        }
    }
}

mod bent {
    rncf::model! {
        /// A mass between two springs, one of which only pushes; its damper only resists.
        pub model Bilinear {
            rigid mass { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            joint slide = prismatic(inertial, mass, axis = x);
            spring both = coordinate_law(slide.slide, force = 100 [N/m] * value + 300 [N/m] * max(value, 0 m));
            output x = mass.x;
        }
    }
}

mod dragged {
    rncf::model! {
        /// The same with a spring and a drag whose laws change over without a bend.
        pub model Dragged {
            rigid mass { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            joint slide = prismatic(inertial, mass, axis = x);
            spring both = coordinate_law(slide.slide, force = 100 [N/m] * value + 3 [N/m^2] * value * abs(value) + 2 [N*s^2/m^2] * rate * abs(rate));
            output x = mass.x;
        }
    }
}

mod leaping {
    rncf::model! {
        /// A frame that jumps by a metre, beside a pressure of megapascals.
        pub model Leaping {
            motion x(t) = if t < 0.1 s { 0 m } else { 1 m };
            frame cart = moving(origin = [x(t), 0 m, 0]);
            rigid bob in cart { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
            spring tie = linear(cart.at([0, 0, 0] m), bob.at([0, 1, 0] m), stiffness = 10 N/m, length = 1 m);
            state pressure = integral((1 [MPa] - pressure) / 1 [s], start = 0 Pa, size = 10 MPa);
            output x = bob.x;
            output p = pressure;
            run { t_end = 0.2 s; every = 0.01 s; }
        }
    }
}

fn last(history: &rncf::app::History, name: &str) -> f64 {
    history.column(history.find(name).unwrap()).last().unwrap()
}

/// What errors of a run are held to, 1 K or 1 Pa, says nothing of how far a state goes to its equilibrium.
#[test]
fn states_go_as_far_as_they_have_to() {
    let settings = EquilibriumSettings::default();
    let found = static_equilibria(&warm::Warm::default(), &settings).unwrap();
    assert!((last(&found.history, "temperature") - 400.0).abs() < 1e-9);
    assert!((last(&found.history, "x") - 1.0).abs() < 1e-12);
    let range = EquilibriumSettings {
        range: Some(Range {
            param: 0,
            from: 310.0,
            to: 500.0,
        }),
        ..settings
    };
    let found = static_equilibria(&warm::Warm::default(), &range).unwrap();
    let rows = found.history.keys.iter().zip(found.history.column(0));
    for (outside, x) in rows {
        assert!((x - 0.01 * (outside - 300.0)).abs() < 1e-12, "{outside} {x}");
    }
    // The weight, and the spring at the wanted place.
    let found = static_equilibria(&wound::Wound::default(), &settings).unwrap();
    assert!((last(&found.history, "y") - 0.1).abs() < 1e-12);
    let expected = (2000.0 * 9.81 + 3e4 * 0.1) / 1e-3;
    assert!((last(&found.history, "of_oil") / expected - 1.0).abs() < 1e-12);
}

/// Two chambers are a spring of `2 A^2 B / V`; pressures in pascals stand beside lengths in metres.
#[test]
fn oil_that_is_shut_in_is_a_spring() {
    let found = modes(&valve::Shut {}, &EquilibriumSettings::default()).unwrap();
    let (stiffness, mass, damping) = (2.0 * 1e-6 * 1.4e9 / 2e-4 + 2e4, 100.0, 300.0);
    let re = -0.5 * damping / mass;
    let im = f64::sqrt(stiffness / mass - re * re);
    let mode = found.modes.iter().find(|mode| mode.im > 0.0).unwrap();
    assert!(
        (mode.im / im - 1.0).abs() < 1e-9 && (mode.re / re - 1.0).abs() < 1e-7,
        "{mode:?}"
    );
    // Where it rests, and what both pressures are, nothing holds.
    let still = found.modes.iter().filter(|mode| mode.is_still()).count();
    assert_eq!((found.modes.len(), still), (3, 2));
}

/// A state that goes on for ever is named where a force reads it.
#[test]
fn a_state_that_does_not_come_to_rest_is_named() {
    let found = static_equilibria(&climbing::Climbing {}, &EquilibriumSettings::default());
    let message = found.unwrap_err().to_string();
    assert!(
        message.contains("what a state is the integral of is not zero") && message.contains("(worst: state `since`)"),
        "{message}"
    );
}

/// A filter that lets slow motions pass leaves the stiffness at rest in the frame as it is, whatever the unit of its state: it is zero where the
/// square of the speed is k/m.
#[test]
fn filters_make_no_critical_speeds() {
    let over = |from, to| EquilibriumSettings {
        range: Some(Range { param: 0, from, to }),
        ..EquilibriumSettings::default()
    };
    for (gain, unit) in [(0.0, 1.0), (50.0, 1.0), (50.0, 100.0), (500.0, 0.01)] {
        let model = washed::Washed {
            gain,
            unit,
            ..washed::Washed::default()
        };
        let found = campbell(&model, &over(0.0, 300.0)).unwrap();
        let critical: Vec<_> = found.critical.iter().map(|one| (one.value, one.change)).collect();
        let [(value, 2)] = critical[..] else {
            panic!("{gain} {unit}: {critical:?}")
        };
        assert!((value - 100.0).abs() < 1e-4, "{gain} {unit}: {value}");
    }
    // What an integral holds stands still at no speed.
    for size in [1e-9, 1.0, 1e6] {
        let model = centred::Centred {
            size,
            ..centred::Centred::default()
        };
        let found = campbell(&model, &over(0.0, 300.0)).unwrap();
        assert!(found.critical.is_empty(), "{size}: {:?}", found.critical);
    }
    // The filter has its own eigenvalue, -20 1/s, at every speed, and crosses nothing.
    let found = campbell(&listening::Listening::default(), &over(1.0, 100.0)).unwrap();
    assert_eq!(
        (found.tracks.len(), found.critical.len(), found.crossings.len()),
        (2, 0, 0)
    );
    for row in 0..found.keys.len() {
        let rates: Vec<f64> = found
            .row(row)
            .filter(|mode| mode.im == 0.0)
            .map(|mode| mode.re)
            .collect();
        assert!(matches!(rates[..], [rate] if (rate + 20.0).abs() < 1e-9), "{rates:?}");
    }
    // It moves nothing, and is not seen to turn with the spin.
    let found = modes(&listening::Listening::default(), &EquilibriumSettings::default()).unwrap();
    let filter = found.modes.iter().find(|mode| mode.im == 0.0).unwrap();
    assert_eq!(filter.inertial_frequencies(found.spin), [0.0]);
    assert!(steady(&listening::Listening::default(), &EquilibriumSettings::default()).is_ok());
}

/// Whether a frame jumps is asked in lengths, not in pascals.
#[test]
fn the_size_of_a_state_is_no_length() {
    let message = run(&leaping::Leaping {}, &RunSettings::default())
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("the origin of frame `cart` jumps by 1.000e0 m"),
        "{message}"
    );
}

/// About a kink there are no modes: a mass between unequal springs has the mean of both half periods, at any amplitude.
#[test]
fn modes_at_a_kink_say_so() {
    let found = modes(&bent::Bilinear {}, &EquilibriumSettings::default()).unwrap();
    let told: Vec<&String> = found
        .warnings
        .iter()
        .filter(|told| told.contains("changes over"))
        .collect();
    assert!(
        matches!(told[..], [told] if told.contains("`both`")),
        "{:?}",
        found.warnings
    );
    let found = modes(&dragged::Dragged {}, &EquilibriumSettings::default()).unwrap();
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    assert!((found.modes[0].im - 10.0).abs() < 1e-9);
}
