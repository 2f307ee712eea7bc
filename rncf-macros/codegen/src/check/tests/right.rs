//! Models without mistakes, and what they become.

use super::*;
use crate::check::fold;
use crate::model::Binary as Operator;
use crate::model::{
    BodyId, Comparison, Evaluation, Expr, FrameId, Function, INERTIAL, JointId, JointKind, Line, LoadKind, Location,
    MotionId, Observable, ParamId, Quadrature, Space,
};
use Expr::{Binary, Call, If, Motion, Negate, Number, Observed, Param, Power, Time};

fn number(value: f64) -> Box<Expr> {
    Box::new(Number(value))
}

#[test]
fn params_keep_unit_default_and_documentation() {
    let model = model(SPIN_UP);
    let [omega, elements, duration] = model.params.as_slice() else {
        panic!("three parameters")
    };
    assert_eq!(
        (omega.name.as_str(), omega.unit.as_str(), omega.default),
        ("omega_s", "rad/s", 4.0)
    );
    assert_eq!(
        (omega.doc.as_str(), omega.dimension),
        ("Steady angular velocity.", [0, 0, -1, 0, 0, 1])
    );
    assert_eq!(
        (elements.is_count, elements.default, elements.unit.as_str()),
        (true, 6.0, "1")
    );
    assert_eq!(
        (duration.default, duration.unit_si, duration.is_count),
        (15.0, 1.0, false)
    );
    assert_eq!(model.visibility, "pub");
    assert_eq!(
        model.doc,
        "Spin-up manoeuvre of a flexible beam (Ren & Yang 2021, section 4.1.1)."
    );
    assert!(
        model.source.starts_with("pub model SpinUp {\n    /// Steady"),
        "{}",
        model.source
    );
    assert!(model.source.ends_with("every = 0.05 s; }\n}"));
}

#[test]
fn the_motion_is_the_published_one() {
    let model = model(SPIN_UP);
    let (omega, duration) = (Box::new(Param(ParamId(0))), Box::new(Param(ParamId(2))));
    let two_pi = || Box::new(Binary(Multiply, number(2.0), number(std::f64::consts::PI)));
    let binary = |operator, a, b| Box::new(Binary(operator, a, b));
    use Operator::{Add, Divide, Multiply, Subtract};
    let cosine = Call(
        Function::Cos,
        vec![*binary(
            Divide,
            binary(Multiply, two_pi(), Box::new(Time)),
            duration.clone(),
        )],
    );
    let ramp = binary(
        Multiply,
        binary(Divide, omega.clone(), duration.clone()),
        binary(
            Add,
            binary(Divide, Box::new(Power(Box::new(Time), number(2.0))), number(2.0)),
            binary(
                Multiply,
                Box::new(Power(binary(Divide, duration.clone(), two_pi()), number(2.0))),
                binary(Subtract, Box::new(cosine), number(1.0)),
            ),
        ),
    );
    let after = binary(
        Multiply,
        omega,
        binary(Subtract, Box::new(Time), binary(Divide, duration.clone(), number(2.0))),
    );
    let want = If(Comparison::LessEqual, Box::new(Time), duration, ramp, after);
    assert_eq!(model.motions[0].value, want);
    assert_eq!(model.motions[0].unit, "rad");
    let rotation = model.frames[1].rotation.clone().expect("hub turns");
    assert_eq!(rotation.axis, [0.0, 0.0, 1.0]);
    assert_eq!(rotation.angle, Motion(MotionId(0), Box::new(Time)));
    assert_eq!(
        (model.frames[0].name.as_str(), model.frames[1].name.as_str()),
        ("inertial", "hub")
    );
}

#[test]
fn properties_are_exact_to_the_last_bit() {
    let model = model(SPIN_UP);
    let body = &model.bodies[0];
    for (name, value) in [
        ("density", 2766.67),
        ("young", 68.95e9),
        ("poisson", 0.3),
        ("damping", 1e-5),
        ("area", 0.7299e-4),
        ("second_moment", 0.8215e-8),
    ] {
        let Number(found) = body.properties[name] else {
            panic!("{name} is a number")
        };
        assert_eq!(found.to_bits(), f64::to_bits(value), "{name}");
    }
    assert_eq!(
        (body.frame, body.space, &body.count),
        (FrameId(1), Space::Planar { normal: 2 }, &Param(ParamId(1)))
    );
    assert_eq!(
        (body.material_name.as_str(), body.section_name.as_str()),
        ("aluminium", "tube")
    );
    assert_eq!(
        (body.quadrature, body.evaluation, &body.options),
        (Quadrature::Exact, Evaluation::Automatic, &vec![0, 0, 0])
    );
    let Line::Straight { from, to } = &body.line else {
        panic!("straight")
    };
    assert_eq!(from, &[Number(0.0), Number(0.0), Number(0.0)]);
    assert_eq!(to, &[Number(8.0), Number(0.0), Number(0.0)]);
}

/// A unit behind brackets is that of plain numbers; what has the dimension stays as it is.
#[test]
fn numbers_and_quantities_share_a_unit() {
    let components = |vector: &str| {
        let model = model(&SPIN_UP.replace("[0, -g, 0]", vector));
        let LoadKind::Gravity(gravity) = &model.loads[0].kind else {
            panic!("gravity")
        };
        gravity.each_ref().map(|value| fold::constant(value).unwrap())
    };
    assert_eq!(components("[0, -g, 0] mm/s^2"), [0.0, -9.81, 0.0]);
    assert_eq!(components("[2 * 3 - 1, g / 2, 0] mm/s^2"), [0.005, 4.905, 0.0]);
    assert_eq!(components("[-(1 + 1), 3 [m/s^2], 0] mm/s^2"), [-0.002, 3.0, 0.0]);
}

/// A quantity of a table at params is used where tables are looked up, and nowhere else.
#[test]
fn quantities_look_up_tables() {
    let text = |radius: &str| {
        format!(
            "pub model Film {{
                param speed = 10 rad/s;
                table film {{ at = speed; speed = [0, 400] rad/s; k = [1, 9] kN/m; r = [1, 2] mm; }}
                let across = film.k(speed) / 2;
                let inner = film.r(speed);
                frame turning = rotating(axis = z, angle = speed * t);
                rigid rotor in turning {{ mass = 2 kg; inertia = [1, 1, 1] kg*m^2; origin = [{radius}, 0, 0]; }}
                spring oil = bushing(rotor, inertial, stiffness = [across, across, 1 [kN/m]]);
                output x = rotor.x;
            }}"
        )
    };
    let (model, mistakes) = run(&text("1 mm"));
    let told: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
    assert!(told.is_empty() && model.is_some(), "{told:?}");
    let (_, mistakes) = run(&text("inner"));
    let [mistake] = &mistakes[..] else {
        panic!("{mistakes:?}")
    };
    assert!(
        mistake.message.starts_with("a table is looked up in motions"),
        "{}",
        mistake.message
    );
    assert_eq!(mistake.area.source_text().as_deref(), Some("inner"));
}

/// A phase makes no cycles of `2*pi*f*t`, and a ratio of two speeds of rotation, or an angle over a radian, is a number, wherever it stands.
#[test]
fn angles_are_counted() {
    let text = |of: &str| {
        format!(
            "pub model Drive {{
                param f = 0.8 Hz; param phase = 70 deg; param w = 3 rad/s;
                table motor {{ at = n; n = [0, 10, 200] Hz; q = [0, 10, 200] N*m; interpolation = linear; }}
                table slip {{ at = nu; nu = [-1, 0, 2]; k = [3, 2, 1] N*m; interpolation = linear; }}
                table turned {{ at = psi; psi = [-180, 0, 180] deg; k = [3, 2, 3] N*m; }}
                param plain = 3; param ratio = 0.5;
                rigid pump {{ plane xy; mass = 1 kg; inertia = 1 kg*m^2; }}
                rigid turbine {{ plane xy; mass = 1 kg; inertia = 1 kg*m^2; }}
                joint a = revolute(inertial, pump);
                joint b = revolute(pump, turbine);
                {of}
                output x = pump.angle; output y = turbine.angle;
            }}"
        )
    };
    for right in [
        "load l = moment(pump, [0, 0, 3 [N*m] * sin(2*pi*f*t + phase)]);",
        "load l = moment(pump, [0, 0, 3 [N*m] * sin(70 deg - (2*pi*f + w) * t)]);",
        "output z: deg = pump.angle + 2*pi*f*t;",
        "load l = moment(pump, [0, 0, slip.k(turbine.speed / pump.speed)]);",
        "load l = moment(pump, [0, 0, slip.k(pump.angle / (1 rad))]);",
        "spring s = torsional_law(b, moment = 0.1 [N*m] * max(min(rate / 0.5 [rad/s], 1), -1));",
        "spring s = torsional_law(b, moment = 0.1 [N*m] * (2 - max(abs(rate / 0.5 [rad/s]) - 1, 0)));",
        "output z = pump.speed / turbine.speed - 1;",
        "load l = moment(pump, [0, 0, motor.q(f)]);",
        "load l = moment(pump, [0, 0, motor.q(pump.speed / (2*pi))]);",
    ] {
        let (model, mistakes) = run(&text(right));
        let told: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
        assert!(told.is_empty() && model.is_some(), "{right}: {told:?}");
    }
    for (wrong, of) in [
        (
            "load l = moment(pump, [0, 0, 3 [N*m] * sin(f*t + phase)]);",
            "hertz and `1/min` count cycles",
        ),
        (
            "load l = moment(pump, [0, 0, 3 [N*m] * sin(600 [1/min] * t)]);",
            "hertz and `1/min` count cycles",
        ),
        (
            "load l = moment(pump, [0, 0, motor.q(pump.speed)]);",
            "hertz and `1/min` count cycles",
        ),
        ("output z: 1/min = pump.speed;", "hertz and `1/min` count cycles"),
        (
            "component shaker(of: body, f: Hz) { load l = moment(of, [0, 0, 3 [N*m] * sin(2*pi*f*t)]); } part p = shaker(of = pump, f = 600 rpm);",
            "hertz and `1/min` count cycles",
        ),
        (
            "component shaker(of: body, w: rad/s) { load l = moment(of, [0, 0, 3 [N*m] * sin(w*t)]); } part p = shaker(of = pump, w = 10 Hz);",
            "this counts cycles",
        ),
        (
            "frame g = rotating(axis = z, angle = 1500 [1/min] * t);",
            "hertz and `1/min` count cycles",
        ),
        (
            "load l = moment(pump, [0, 0, slip.k(pump.angle)]);",
            "this is an angle, and the rows of `slip` are at plain numbers",
        ),
        (
            "load l = moment(pump, [0, 0, turned.k(3)]);",
            "the place in a table over an angle needs a unit: `3 rad` or `3 deg`",
        ),
        (
            "load l = moment(pump, [0, 0, turned.k(plain)]);",
            "the place in a table over an angle",
        ),
        (
            "section tilted { EA = 1 N; GA = 1 N; GJ = 1 N*m^2; EIy = 1 N*m^2; EIz = 1 N*m^2; mass = 1 kg/m; inertia_y = 1 kg*m; inertia_z = 1 kg*m; principal = 20; }",
            "principal needs a unit: `20 rad` or `20 deg`",
        ),
        (
            "spring s = torsional_law(b, moment = 0.1 [N*m] * max(angle - 1, 0));",
            "what stands beside an angle needs a unit",
        ),
    ] {
        let (_, mistakes) = run(&text(wrong));
        assert!(
            mistakes.iter().any(|mistake| mistake.message.starts_with(of)),
            "{wrong}: {mistakes:?}"
        );
    }
}

/// Words with which statements go on may be names of motions and frames.
#[test]
fn words_of_statements_are_names() {
    let model = model(
        "pub model Lines {
            motion angle(t) = 2 [rad/s] * t;
            motion radius(t) = 1 [m/s] * t;
            frame hub = rotating(axis = z, angle = angle(t) + 30 deg);
            frame cart = moving(origin = [radius(t), 0, 0]);
            for i in 0..2 {
                frame line[i] in hub = rotating(axis = z, angle = i * pi / 4);
                rigid leg[i] in line[i] { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
                joint root[i] = weld(leg[i], line[i]);
            }
            output far = leg[1].x;
        }",
    );
    assert_eq!(model.frames[4].name, "line[1]");
}

#[test]
fn joints_loads_and_outputs_are_resolved() {
    let model = model(SPIN_UP);
    let joint = &model.joints[0];
    assert_eq!(
        (joint.kind, joint.body, &joint.at, joint.frame),
        (JointKind::Clamp, BodyId(0), &Location::Start, FrameId(1))
    );
    assert!(joint.point.is_none());
    let LoadKind::Gravity(gravity) = &model.loads[0].kind else {
        panic!("gravity")
    };
    assert_eq!(gravity, &[Number(0.0), Negate(number(9.81)), Number(0.0)]);
    let LoadKind::Force {
        components, frame, at, ..
    } = &model.loads[1].kind
    else {
        panic!("force")
    };
    assert_eq!(
        (components[1].clone(), *frame, at),
        (Number(10.0), FrameId(1), &Location::End)
    );
    let LoadKind::Moment { components, frame, .. } = &model.loads[2].kind else {
        panic!("moment")
    };
    assert_eq!((components[2].clone(), *frame), (Number(3.0), INERTIAL));
    let summary: Vec<_> = model
        .outputs
        .iter()
        .map(|output| {
            let suffixes: Vec<_> = output.components.iter().map(|(suffix, _)| suffix.as_str()).collect();
            format!("{} [{}] {}", output.name, output.unit, suffixes.join(","))
        })
        .collect();
    assert_eq!(
        summary,
        [
            "u [m] ",
            "tip [m] x,y",
            "vy [m/s] ",
            "s [1] ",
            "m_root [N m] ",
            "f_root [N] x,y"
        ]
    );
    assert_eq!(model.outputs[0].doc, "Elongation of the tip");
    assert_eq!(
        model.outputs[4].components[0].1,
        Observed(Observable::Reaction {
            joint: JointId(0),
            moment: true,
            component: 2
        })
    );
    assert_eq!((&model.run.t_end, &model.run.every), (&Number(20.0), &Number(0.05)));
}

/// A spatial model with everything that the planar one has not; names before their declarations.
#[test]
fn the_rest_of_the_language() {
    let model = model(
        "model Rest {
            output a = wire.end.z * 2 + e;  output b = left.moment;  output c = max(abs(wire.start.y), 1 mm);
            output d = atan2(wire.end.y, wire.end.x);
            body wire in cart {
                spatial;
                line from [0, 0, 0] m to [L, 0, 0 m];
                mesh (3) * tether(thin, steel, bending = exact, quadrature = gauss(3), evaluation = loop);
            }
            const e = 2 * half;  const half = 5 mm;
            joint left = clamp_full(wire.start, cart);
            joint right = pin(wire.end, inertial, at = [1, 0, 0] m);
            frame cart in stage = moving(origin = [x(t), 0 m, 0]);
            frame stage = rotating(axis = [0, 3, 4], angle = pi/2, origin = [1, 2, 3] cm);
            motion x(t) = amplitude * sin(2*pi*f*t) + 0 m;
            motion y(t) = x(t - 1 s);
            param amplitude = 3 mm;  param f = 2 Hz;  param L = 1 m;
            material steel { density = 7.85 g/cm^3; young = 210 GPa; }
            section thin { area = pi * (1 mm)^2 / 4; second_moment = pi * (1 mm)^4 / 64; }
            load pull = force(wire.at(L/2), [0 N, 3 N * sin(2*pi*f*t), 0], in = stage);
        }",
    );
    let names: Vec<_> = model.frames.iter().map(|frame| frame.name.as_str()).collect();
    assert_eq!(names, ["inertial", "stage", "cart"]);
    assert_eq!(
        model.frames[1].rotation.as_ref().map(|rotation| rotation.axis),
        Some([0.0, 0.6, 0.8])
    );
    assert_eq!(model.frames[1].origin, [Number(0.01), Number(0.02), Number(0.03)]);
    assert_eq!(model.bodies[0].frame, FrameId(2));
    assert_eq!(
        (model.bodies[0].options.as_slice(), model.bodies[0].quadrature),
        (&[1, 0, 0][..], Quadrature::Gauss(3))
    );
    assert_eq!(
        (model.bodies[0].evaluation, &model.bodies[0].count),
        (Evaluation::Loop, &Number(3.0))
    );
    assert_eq!(model.bodies[0].properties["density"], Number(7850.0));
    assert_eq!(model.bodies[0].properties["damping"], Number(0.0));
    assert_eq!(model.params[0].unit_si, 1e-3);
    assert_eq!(model.params[0].default.to_bits(), 3e-3_f64.to_bits());
    assert_eq!(model.outputs[1].components.len(), 3);
    assert_eq!(
        (model.outputs[2].unit.as_str(), model.outputs[3].unit.as_str()),
        ("m", "rad")
    );
    assert_eq!(
        model.motions[1].value,
        Motion(
            MotionId(0),
            Box::new(Binary(Operator::Subtract, Box::new(Time), number(1.0)))
        )
    );
    assert_eq!((model.run.t_end, model.run.every), (Number(1.0), Number(0.01)));
    assert_eq!(model.visibility, "");
}

#[test]
fn a_planar_arc() {
    let model = model(
        "pub(crate) model Ring {
            material steel { density = 7850 kg/m^3; young = 210 GPa; }
            section thin { area = 1 mm^2; second_moment = 1 mm^4; }
            body ring {
                planar zx;
                arc from [0, 0, 0] m direction [1, 0, 0] radius 16 m angle 30 deg;
                mesh 8 * cable(thin, steel);
            }
            joint foot = pin(ring.start, inertial);
            output x = ring.at(4 m).x;
        }",
    );
    let Line::Arc { radius, angle, .. } = &model.bodies[0].line else {
        panic!("arc")
    };
    assert_eq!(
        (radius, angle),
        (&Number(16.0), &Number(30.0 * (std::f64::consts::PI / 180.0)))
    );
    assert_eq!(model.bodies[0].space, Space::Planar { normal: 1 });
    assert_eq!(model.visibility, "pub(crate)");
}

/// Words of one statement are names in the expressions of others.
#[test]
fn words_of_statements_are_names_in_expressions() {
    let model = model(
        "model Words {
            param radius = 2 m;  param angle = 3 deg;  param direction = 1 m;
            material steel { density = 7850 kg/m^3; young = 210 GPa; }
            section thin { area = 1 mm^2; second_moment = 1 mm^4; }
            body line {
                planar xy;
                arc from [radius, 2*direction, 0] direction [1, 0, 0] radius (radius) angle angle;
                mesh 8 * cable(thin, steel);
            }
            joint foot = pin(line.start, inertial);
            output x = line.end.x - (radius + direction) / angle;
        }",
    );
    let Line::Arc { radius, angle, .. } = &model.bodies[0].line else {
        panic!("arc")
    };
    assert_eq!((radius, angle), (&Param(ParamId(0)), &Param(ParamId(1))));
}

/// A named argument may be a literal with a compound unit, and products with names stay products.
#[test]
fn literals_in_named_arguments() {
    let angle = |angle: &str| {
        let model = model(&SPIN_UP.replace("angle = theta(t)", &format!("angle = {angle}")));
        model.frames[1].rotation.clone().expect("hub turns").angle
    };
    assert_eq!(angle("2 m rad/m"), Number(2.0));
    assert_eq!(angle("-2 m rad/m, origin = [0, 0, 0] m"), Negate(number(2.0)));
    let product = |b| Binary(Operator::Multiply, number(2.0), Box::new(b));
    assert_eq!(angle("2 rad * elements"), product(Param(ParamId(1))));
    assert_eq!(angle("2 [rad/s] * t"), product(Time));
}

#[test]
fn outputs_are_told_in_the_unit_that_is_asked_for() {
    let text = SPIN_UP.trim_end().strip_suffix('}').map(|items| {
        format!("{items} output turned: deg = 0.5 rad; output place: mm = beam.end; output plain = 0.5 rad; }}")
    });
    let model = model(&text.unwrap_or_default());
    let [turned, tip, plain] = &model.outputs[model.outputs.len() - 3..] else {
        panic!("three outputs");
    };
    assert_eq!((turned.unit.as_str(), plain.unit.as_str()), ("deg", "rad"));
    let degree = std::f64::consts::PI / 180.0;
    assert_eq!(fold::constant(&turned.components[0].1), Some(0.5 / degree));
    assert_eq!((tip.unit.as_str(), tip.components.len()), ("mm", 2));
}
