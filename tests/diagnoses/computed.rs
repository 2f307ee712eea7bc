//! The page of messages of programs that compute is true: every wrong line gets its message, every cured one none.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use rncf::app::{EquilibriumSettings, Judging, RunError, RunSettings, modes, run, static_equilibria, steady};
use rncf::{AnyModel, Method, ParamKind, StepSize, TableFile};

use crate::limits::{Bow, Mast, Panel, PanelPinned, PanelTurned, Swung};
use crate::redundant::{Door, DoorOnOne};
use crate::senseless::models::{Hung, Shaken};
use crate::values::{Masses, Pendulum, Struts};
use crate::{massless::Needle, values::Norm};

const PAGE: &str = "../docs/errors/computing.md";

mod models {
    rncf::model! {
        /// A nut that falls along a thread, and a law that reads its angle.
        pub model Nut {
            /// Way for each radian.
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
        /// A ball on a spring, drawn by a force that has no value from a time on.
        pub model Drawn {
            /// When the force ends.
            param late = 2 s;
            /// Where it ends.
            param wall = 2 m;
            rigid ball { mass = 1 kg; origin = [1, 0, 0] m; }
            spring cord = linear(inertial.at([0, 0, 0] m), ball, stiffness = 10 [N/m], length = 1 m);
            load pull = force(ball, [1 [N] * sqrt(1 - t / late) * sqrt(1 - ball.x / wall), 0 [N], 0 [N]]);
            output x = ball.x;
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
    rncf::model! {
        /// A ball on a spring, drawn by a force that ends at a place.
        pub model Stretched {
            /// Of the force at rest.
            param k = 1 N;
            /// Where it ends, from where the ball is at rest.
            param reach = 100 mm;
            rigid ball { mass = 1 kg; origin = [1, 0, 0] m; }
            spring cord = linear(inertial.at([0, 0, 0] m), ball, stiffness = 10 [N/m], length = 1 m);
            constraint rail_y = ball.y;
            constraint rail_z = ball.z;
            load pull = force(ball, [k * (2 + sqrt(1 - (ball.x - 1 m) / reach)), 0 [N], 0 [N]]);
            output x = ball.x;
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
    rncf::model! {
        /// Two balls on a spring that grows steeper and steeper.
        pub model Steep {
            /// Way within which the force grows by e.
            param width = 1 m;
            rigid first { mass = 1 kg; }
            rigid second { mass = 1 kg; origin = [1, 0, 0] m; }
            spring wall = law(first, second, force = 1 [N] * sinh((length - 0.5 m) / width));
            output x = second.x;
            run { t_end = 0.1 s; every = 0.1 s; }
        }
    }
    rncf::model! {
        /// A wheel on an axle, with or without a spring and under a moment.
        pub model Wheel {
            /// Stiffness of the spring on its axle.
            param k = 0 N*m/rad;
            /// Moment about the axle.
            param moment = 1 N*m;
            rigid wheel { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; }
            joint axle = revolute(inertial, wheel);
            spring coil = torsional(axle, stiffness = k);
            load turn = moment(wheel, [0, 0, moment]);
            output angle = axle.angle;
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
    rncf::model! {
        /// A strip across a hub that spins, and a weight that does not turn with it.
        pub model Spun {
            /// Of gravity across the axis.
            param weight = 9.81 m/s^2;
            /// Of the hub.
            param spin = 5 rad/s;
            material rubber { density = 1100 kg/m^3; young = 5 MPa; }
            section round { area = 78.5 mm^2; second_moment = 491 mm^4; }
            motion theta(t) = spin * t;
            frame hub = rotating(axis = z, angle = theta(t));
            body strip in hub { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * cable(round, rubber); }
            joint root = clamp(strip.start, hub);
            load gravity_load = gravity([0, -weight, 0]);
            output tip = strip.end.in(hub);
            run { t_end = 1 s; every = 0.1 s; }
        }
    }
}
use models::{Drawn, Nut, Spun, Steep, Stretched, Wheel};

fn model(name: &str) -> Box<dyn AnyModel> {
    match name {
        "Bow" => Box::new(Bow::default()),
        "Door" => Box::new(Door::default()),
        "DoorOnOne" => Box::new(DoorOnOne::default()),
        "Drawn" => Box::new(Drawn::default()),
        "Steep" => Box::new(Steep::default()),
        "Hung" => Box::new(Hung::default()),
        "Masses" => Box::new(Masses::default()),
        "Mast" => Box::new(Mast::default()),
        "Needle" => Box::new(Needle::default()),
        "Norm" => Box::new(Norm::default()),
        "Nut" => Box::new(Nut::default()),
        "Panel" => Box::new(Panel::default()),
        "PanelTurned" => Box::new(PanelTurned::default()),
        "PanelPinned" => Box::new(PanelPinned::default()),
        "Pendulum" => Box::new(Pendulum::default()),
        "Shaken" => Box::new(Shaken::default()),
        "Spun" => Box::new(Spun::default()),
        "Stretched" => Box::new(Stretched::default()),
        "Struts" => Box::new(Struts::default()),
        "Swung" => Box::new(Swung::default()),
        "Wheel" => Box::new(Wheel::default()),
        other => panic!("the page names a model `{other}`, which no test holds"),
    }
}

/// The fenced blocks of a tag: what stands behind it, and the text.
fn blocks<'a>(text: &'a str, tag: &str) -> Vec<(&'a str, &'a str)> {
    let fence = format!("```{tag} ");
    let parts = text.split(&fence).skip(1);
    parts
        .map(|part| part.split("\n```").next().unwrap_or_default())
        .map(|part| part.split_once('\n').unwrap_or((part, "")))
        .collect()
}

/// The words of a line as a shell splits it, with double quotes alone.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut is_quoted) = (vec![String::new()], false);
    for letter in line.chars() {
        match letter {
            '"' => is_quoted = !is_quoted,
            ' ' if !is_quoted => words.push(String::new()),
            _ => words.last_mut().unwrap().push(letter),
        }
    }
    words
}

/// All that a program of the model says of a line: its message, or its notes.
fn told(model: &mut dyn AnyModel, line: &str) -> Vec<String> {
    let (mut command, mut settings) = ("run".to_string(), RunSettings::default());
    settings.judged = Judging::Affordable;
    let mut about = EquilibriumSettings::default();
    let all = words(line);
    let mut words = all.iter().map(String::as_str).filter(|word| !word.is_empty());
    while let Some(word) = words.next() {
        match word {
            "--rtol" => settings.options.rtol = words.next().unwrap().parse().unwrap(),
            "--step" => {
                let step = words.next().unwrap().split(' ').next().unwrap().parse().unwrap();
                settings.options.step = StepSize::Fixed(step);
            }
            "--t-end" => settings.t_end = words.next().unwrap().split(' ').next().unwrap().parse().ok(),
            "--at" => about.at = words.next().unwrap().split(' ').next().unwrap().parse().ok(),
            _ => match word.split_once('=') {
                None => command = word.to_string(),
                Some((name, value)) => {
                    let index = model.params().iter().position(|param| param.name == name).unwrap();
                    let param = &model.params()[index];
                    if let ParamKind::Table(form) = param.kind {
                        match TableFile::declared(form).read(value) {
                            Ok(file) => model.set(index, file.number()),
                            Err(error) => return vec![error.to_string()],
                        }
                        continue;
                    }
                    let (number, unit) = value.split_once(' ').unwrap_or((value, "1"));
                    assert!(
                        unit.replace('*', " ") == param.unit.replace('*', " ") || param.unit.is_empty() && unit == "1",
                        "{word}"
                    );
                    model.set(index, number.parse::<f64>().unwrap() * param.unit_si);
                }
            },
        }
    }
    let found = match command.as_str() {
        "run" => run(model, &settings).map(|result| result.warnings),
        "static" => static_equilibria(model, &about).map(|result| result.warnings),
        "steady" => steady(model, &about).map(|result| result.warnings),
        "modes" => modes(model, &about).map(|result| result.warnings),
        other => panic!("no command `{other}`"),
    };
    found.unwrap_or_else(|error| vec![error.to_string()])
}

/// Numbers depend on the last digits of others.
fn without_numbers(text: &str) -> String {
    let mut out = String::new();
    let mut is_number = false;
    for letter in text.chars() {
        let part = letter.is_ascii_digit() || is_number && matches!(letter, '.' | 'e' | '-');
        if !part {
            out.push(letter);
        } else if !is_number {
            out.push('#');
        }
        is_number = part;
    }
    out
}

#[test]
fn every_line_gets_its_message_and_its_cure_none() {
    let text = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE)).unwrap();
    let mut differences = Vec::new();
    for (name, part) in blocks(&text, "model") {
        let source: BTreeSet<&str> = model(name).source().lines().map(str::trim).collect();
        for line in part.lines().map(str::trim).filter(|line| !line.is_empty()) {
            assert!(source.contains(line), "{name} has no line: {line}");
        }
    }
    let (wrong, cured) = (blocks(&text, "line"), blocks(&text, "cured-line"));
    assert!(wrong.len() == cured.len() && wrong.len() > 10);
    for ((line, message), (cured, _)) in wrong.iter().zip(&cured) {
        let of = |line: &str| {
            let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
            told(model(name).as_mut(), rest)
        };
        let message = message.strip_prefix("//~ ").expect("a line and its message");
        let found = of(line);
        if !found
            .iter()
            .any(|found| without_numbers(found) == without_numbers(message))
        {
            differences.push(format!("{line}\n//~ {}", found.join("\n//~ ")));
        }
        let calm = of(cured);
        if !calm.is_empty() {
            differences.push(format!("cured: {cured}\n{}", calm.join("\n")));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n\n"));
}

/// The step before may foresee motions and tangents beyond the end: a run comes up to it all the same, and the law is named.
#[test]
fn a_force_is_followed_up_to_where_it_has_values() {
    let methods = [
        Method::Radau,
        Method::Hht { alpha: -0.1 },
        Method::GeneralizedAlpha { rho_inf: 0.8 },
    ];
    for method in methods {
        let settings = RunSettings {
            method,
            ..RunSettings::default()
        };
        for late in [0.5, 0.123] {
            let result = match run(&Drawn { late, wall: 2.0 }, &settings) {
                Err(RunError::Incomplete(result)) => result,
                other => panic!("{method:?} ends with {other:?}"),
            };
            let error = RunError::Incomplete(result.clone()).to_string();
            assert!(
                error.contains("the force of `pull` is not finite"),
                "{method:?}: {error}"
            );
            assert!((result.state.t / late - 1.0).abs() < 1e-6, "{method:?}: {error}");
        }
        // The force does 0.67 e^1.5 J up to a wall at 1 m + e, and the spring takes 5 e^2 J: the ball turns before it, or comes to it.
        assert!(run(&Drawn { late: 9.0, wall: 1.03 }, &settings).is_ok(), "{method:?}");
        let error = run(&Drawn { late: 9.0, wall: 1.01 }, &settings)
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("the force of `pull` is not finite"),
            "{method:?}: {error}"
        );
    }
}
