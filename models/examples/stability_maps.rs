//! The maps and curves of docs/stability.md.
//!
//! `cargo run --release --example stability_maps [FOLDER]`; the folder is docs/images without one.

use std::path::PathBuf;

use rncf::app::charts::{Chart, Line};
use rncf::app::{Axis, Cells, Figure, Map};
use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf::prelude::*;
use rncf::steady;
use rncf_models::RotatingCantilever;

type Outcome = Result<(), Box<dyn std::error::Error>>;

rncf::model! {
    /// The balanced motor (THEORY 9.3) at its speed, with a damper between disc and ground.
    pub model Shaft {
        param speed = 20000 rpm;
        /// Of the shaft's strains.
        param damping = 1 us;
        /// Of the damper.
        param outside = 0 N*s/m;

        const length = 1.02 m;
        const disc_mass = 7800 [kg/m^3] * pi * 0.0001 [m^3];
        material steel { density = 7800 kg/m^3; young = 210 GPa; poisson = 0.3; damping = damping; }
        section round = circle(radius = 50 mm);
        frame rotor = rotating(axis = x, angle = speed * t);
        body shaft in rotor {
            spatial;
            line from [0, 0, 0] m to [length, 0, 0];
            mesh 4 * beam(round, steel);
        }
        joint drive_end = clamp(shaft.start, rotor);
        joint far_end = pin(shaft.end, rotor);
        fixture disc on shaft.at(length / 2) {
            mass = disc_mass;
            inertia = [disc_mass * 0.005 [m^2], disc_mass * 0.0025083333 [m^2], disc_mass * 0.0025083333 [m^2]];
        }
        spring damper = bushing(shaft.at(length / 2), inertial.at([length / 2, 0, 0]),
            stiffness = [0, 0, 0] N/m, damping = [0 [N s/m], outside, outside]);
        output v_mid = shaft.at(length / 2).y;
        run { t_end = 1 s; every = 1 ms; }
    }
}

/// The rotor of THEORY 8.2 in four modes.
macro_rules! rotor {
    ($name:ident, $($fidelity:tt)*) => {
        rncf::model! {
            pub model $name {
                param eta = 0 rad/s;
                material stiff { density = 1000 kg/m^3; young = 100 GPa; }
                section wire { area = 10 cm^2; second_moment = 10 mm^4; }
                frame hub = rotating(axis = z, angle = eta * t);
                body blade in hub {
                    planar xy;
                    line from [0, 0, 0] m to [1, 0, 0] m;
                    mesh 8 * tether(wire, stiff);
                    $($fidelity)*
                }
                joint root = clamp(blade.start, hub);
                output tip = blade.end.y;
                run { t_end = 1 s; every = 0.01 s; }
            }
        }
    };
}
rotor!(Bending, modal(4););
rotor!(Small, small(4););

rncf::model! {
    /// A rod of 1 kg, 1 m and EI = 32 N m^2 that a hub brings to 10 rad/s within a second.
    pub model Rod {
        /// Axial stiffness.
        param axial = 1 MN;
        const area = 1 m^2;
        const bending = 32 N*m^2;
        motion theta(t) =
            if t <= 1 s { 10 [rad/s] / 1 [s] * (t^2/2 + (1 [s]/(2*pi))^2 * (cos(2*pi*t/1 [s]) - 1)) }
            else { 10 [rad/s] * (t - 0.5 s) };
        frame hub = rotating(axis = z, angle = theta(t));
        material any { density = 1 kg/m^3; young = axial / area; }
        section thin { area = area; second_moment = bending * area / axial; }
        body rod in hub {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 6 * cable(thin, any);
        }
        joint root = clamp(rod.start, hub);
        output v = rod.end.y;
        run { t_end = 2 s; every = 0.01 s; }
    }
}

fn main() -> Outcome {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "docs/images".into()));
    let write = |name: &str, svg: String| -> Outcome {
        let path = folder.join(name);
        std::fs::write(&path, svg)?;
        println!("{}", path.display());
        Ok(())
    };
    write("stability_softening.svg", softening()?)?;
    let steps = [
        ("absolute coordinates, generalized-alpha", Formulation::Ancf, ALPHA),
        ("referenced coordinates, generalized-alpha", Formulation::Rncf, ALPHA),
        ("absolute coordinates, Radau", Formulation::Ancf, Method::Radau),
        ("referenced coordinates, Radau", Formulation::Rncf, Method::Radau),
    ];
    let steps: Result<Vec<Map>, _> = steps
        .into_iter()
        .map(|(name, formulation, method)| fixed_steps(name, formulation, method))
        .collect();
    write(
        "stability_steps.svg",
        Map::to_svg("Fixed steps and axial stiffness", &steps?)?,
    )?;
    let whirl = [
        whirl("without other damping", 0.0)?,
        whirl("with a damper of 100 N s/m at the disc", 100.0)?,
    ];
    write(
        "stability_motor.svg",
        Map::to_svg("Growth of a balanced shaft's whirl", &whirl)?,
    )
}

/// Frequency (rad/s) of the scene's slowest motion about its relative equilibrium, and the rate (1/s) at which it grows.
fn linearised(model: &impl Model) -> Result<[f64; 2], Box<dyn std::error::Error>> {
    let mut scene = model.build(Formulation::Rncf, Joints::Eliminated)?;
    let found = steady(scene.as_mut(), 0.0)?;
    let state = found.state().ok_or("no equilibrium")?.clone();
    let found = modes(scene.as_mut(), &Uniform::steady(0.0), &state, Wanted { count: 4 })?;
    Ok([found[0].im, found[0].re])
}

/// Rates of growth over speed and internal damping.
fn whirl(what: &str, outside: f64) -> Result<Map, Box<dyn std::error::Error>> {
    let speeds: Vec<f64> = (0..=30).map(|k| 10000.0 + 500.0 * f64::from(k)).collect();
    let dampings: Vec<f64> = (0..=10).map(f64::from).collect();
    let mut rates = Vec::new();
    for damping in &dampings {
        for speed in &speeds {
            let model = Shaft {
                speed: speed * std::f64::consts::PI / 30.0,
                damping: 1e-6 * damping,
                outside,
            };
            let [_, rate] = linearised(&model)?;
            // Round-off is no growth.
            rates.push(if rate.abs() < 1e-6 { 0.0 } else { rate });
        }
    }
    Ok(Map {
        heading: format!("Growth [1/s] of the balanced shaft's first whirl, {what}"),
        x: axis("speed [rpm]", speeds, false),
        y: axis("damping of the shaft [us]", dampings, false),
        cells: Cells::Signed(rates),
        marks: vec![(17246.0, "critical speed".into())],
    })
}

fn axis(name: &str, values: Vec<f64>, logarithmic: bool) -> Axis {
    Axis {
        name: name.into(),
        values,
        logarithmic,
    }
}

/// eta and the lowest frequency in the plane of rotation (THEORY 8.2).
const TABLE: [(f64, f64); 13] = [
    (0.0, 3.51602),
    (1.0, 3.54324),
    (2.0, 3.62180),
    (3.0, 3.74351),
    (4.0, 3.89772),
    (5.0, 4.07390),
    (6.0, 4.26323),
    (7.0, 4.45914),
    (8.0, 4.65715),
    (9.0, 4.85434),
    (10.0, 5.04897),
    (11.0, 5.24005),
    (12.0, 5.42705),
];

/// Lowest frequencies in the plane of rotation over the spin.
fn softening() -> Result<String, Box<dyn std::error::Error>> {
    let etas: Vec<f64> = (0..=60).map(|k| 0.2 * f64::from(k)).collect();
    let (mut whole, mut bending, mut small) = (Vec::new(), Vec::new(), Vec::new());
    for &eta in &etas {
        let model = RotatingCantilever {
            eta,
            elements: 8,
            ..RotatingCantilever::default()
        };
        whole.push((eta, linearised(&model)?[0]));
        small.push((eta, linearised(&Small { eta })?[0]));
        let [frequency, _] = linearised(&Bending { eta })?;
        // Where it only grows there is no frequency.
        if frequency > 0.0 {
            bending.push((eta, frequency));
        }
    }
    let mut figure = Figure::default();
    figure.add(
        "Lag frequency of a rotor",
        &["whole (dots: table)", "4 modes that only bend", "small(4)"],
        Chart {
            x: "spin eta [sqrt(EI/(rhoA L^4))]".into(),
            y: "frequency [sqrt(EI/(rhoA L^4))]".into(),
            lines: [whole, bending, small]
                .into_iter()
                .enumerate()
                .map(|(color, points)| Line::new(points, color))
                .chain([Line::dots(TABLE, 0)])
                .collect(),
            marks: vec![(3.516, "3.516".into())],
            ..Chart::default()
        },
    );
    Ok(figure.to_svg("Lag frequency of a rotor over its spin")?)
}

const ALPHA: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };

/// Tip deflection (m) after 2 s, or `None` where the integration ends before.
fn tip(model: &Rod, formulation: Formulation, method: Method, options: Options) -> Option<f64> {
    let mut scene = model.build(formulation, Joints::Eliminated).ok()?;
    let start = scene.rest(0.0);
    let end = 2.0;
    let mut integrator = Integrator::new(scene.as_mut(), start, end, method, options).ok()?;
    while integrator.step().ok()? != Stop::End || integrator.state().t < end * (1.0 - 1e-12) {}
    let state = integrator.state().clone();
    let mut row = vec![0.0; scene.output_columns()];
    scene.outputs(&state, &mut row);
    Some(row[0])
}

/// How far the tip is off with fixed steps, relative to 0.03 m: about `11 rhoA alpha L^4/(120 EI)`, the static deflection
/// under the mean angular acceleration.
fn fixed_steps(name: &str, formulation: Formulation, method: Method) -> Result<Map, Box<dyn std::error::Error>> {
    let steps: Vec<f64> = (0..=10).map(|k| 10f64.powf(-2.6 + 0.2 * f64::from(k))).collect();
    let stiffnesses: Vec<f64> = (0..=6).map(|k| 10f64.powf(3.0 + f64::from(k))).collect();
    let mut classes = Vec::new();
    for &axial in &stiffnesses {
        let model = Rod { axial };
        let options = |rtol: f64, step: StepSize| Options {
            rtol,
            step,
            ..Options::default()
        };
        let exact = tip(
            &model,
            Formulation::Rncf,
            Method::Radau,
            options(1e-9, StepSize::Adaptive),
        )
        .ok_or("no reference")?;
        for &h in &steps {
            let found = tip(&model, formulation, method, options(1e-8, StepSize::Fixed(h)));
            classes.push(match found.map(|found| (found - exact).abs() / 0.03) {
                Some(error) if error < 0.01 => 0,
                Some(error) if error < 0.1 => 3,
                Some(error) if error.is_finite() => 2,
                _ => 1,
            });
        }
    }
    let names = [
        "right to 1 %",
        "Newton fails",
        "off by more than 10 %",
        "off by 1 to 10 %",
    ];
    Ok(Map {
        heading: format!("{name}: tip of a rod spun up to 10 rad/s, fixed steps"),
        x: axis("step [s]", steps, true),
        y: axis("EA [N], at EI = 32 N m^2", stiffnesses, true),
        cells: Cells::Classes(classes, names.map(String::from).to_vec()),
        marks: Vec::new(),
    })
}
