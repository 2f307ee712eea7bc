//! Short runs of scenes whose instructions are counted: `bench/instructions.sh` runs each under callgrind and compares with
//! what is recorded.
//!
//! `cargo run --release --example instructions -- spin_up`; without a name it prints all names.

use std::process::ExitCode;

use rncf::app::{RunSettings, run};
use rncf::model::AnyModel;
use rncf::prelude::*;
use rncf_models::{
    AndrewsSqueezer, Esail, FreeFlight, HeavyTop, Nrel5mwBlade, PinnedPipe, SliderCrank, SpinUp, SpinUpSpatial,
};

rncf::model! {
    /// A tube on a hub that is spun up, by the sizes of its section and its material.
    model TubeOfMaterial {
        motion theta(t) = 2 [rad/s^2] * t^2;
        frame hub = rotating(axis = z, angle = theta(t));
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.3; }
        section wall = tube(radius = 50 mm, thickness = 3 mm);
        body boom in hub { spatial; line from [0, 0, 0] m to [8, 0, 0] m; mesh 8 * beam(wall, aluminium); }
        joint root = clamp(boom.start, hub);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = boom.end.in(hub);
        run { t_end = 1 s; every = 0.02 s; }
    }
}

rncf::model! {
    /// The same tube by matrices of stiffness and mass about an axis beside its centre, all entries of bending and torsion coupled.
    model TubeOfMatrices {
        motion theta(t) = 2 [rad/s^2] * t^2;
        frame hub = rotating(axis = z, angle = theta(t));
        section wall {
            K11 = 64.0 MN; K22 = 13.0 MN; K33 = 13.0 MN; K44 = 60 kN*m^2; K55 = 76 kN*m^2; K66 = 76 kN*m^2;
            K12 = 0.1 MN; K13 = 0.1 MN; K14 = 10 kN*m; K15 = 60 kN*m; K16 = -60 kN*m; K23 = 0.1 MN; K24 = 20 kN*m; K25 = 10 kN*m; K26 = 10 kN*m;
            K34 = 20 kN*m; K35 = 10 kN*m; K36 = 10 kN*m; K45 = 2 kN*m^2; K46 = 2 kN*m^2; K56 = 2 kN*m^2;
            mass = 2.47 kg/m; inertia_y = 2.9 g*m; inertia_z = 2.9 g*m;
        }
        body boom in hub { spatial; line from [0, 0, 0] m to [8, 0, 0] m; mesh 8 * beam(wall); }
        joint root = clamp(boom.start, hub);
        load weight = gravity([0, 0, -9.81] m/s^2);
        output tip = boom.end.in(hub);
        run { t_end = 1 s; every = 0.02 s; }
    }
}

/// A scene and how it runs: as far as a user's run of it tells what costs, and no farther.
struct Counted {
    name: &'static str,
    model: Box<dyn AnyModel>,
    settings: RunSettings,
}

/// The settings of a run until `t_end`, s, with some rows.
fn until(t_end: f64) -> RunSettings {
    RunSettings {
        t_end: Some(t_end),
        every: Some(t_end / 50.0),
        ..RunSettings::default()
    }
}

fn with(method: Method, options: Options, t_end: f64) -> RunSettings {
    RunSettings {
        method,
        options,
        ..until(t_end)
    }
}

fn scenes() -> Vec<Counted> {
    let tolerance = |rtol| Options {
        rtol,
        ..Options::default()
    };
    let fixed = |step| Options {
        step: StepSize::Fixed(step),
        ..Options::default()
    };
    let beam = |elements| SpinUp {
        elements,
        ..SpinUp::default()
    };
    let blade = SpinUpSpatial {
        elements: 24,
        ..SpinUpSpatial::default()
    };
    let sail = Esail {
        tethers: 20,
        elements: 8,
        ..Esail::default()
    };
    let ancf = RunSettings {
        formulation: Formulation::Ancf,
        ..until(1.0)
    };
    let conserving = RunSettings {
        formulation: Formulation::Ancf,
        ..with(Method::EnergyMomentum, tolerance(1e-6), 0.1)
    };
    let (hht, alpha) = (Method::Hht { alpha: -0.3 }, Method::GeneralizedAlpha { rho_inf: 0.8 });
    vec![
        counted("spin_up", beam(16), until(4.0)),
        counted("spin_up_hht", beam(16), with(hht, tolerance(1e-6), 2.0)),
        counted("spin_up_ancf", beam(8), ancf),
        counted("spin_up_spatial", blade, until(3.0)),
        counted("free_flight", FreeFlight::default(), until(0.2)),
        counted("free_flight_energy", FreeFlight::default(), conserving),
        counted("slider_crank", SliderCrank::default(), until(0.5)),
        counted("heavy_top", HeavyTop::default(), until(0.2)),
        counted("andrews_squeezer", AndrewsSqueezer::default(), until(0.005)),
        counted("pinned_pipe", PinnedPipe::default(), until(0.05)),
        counted("blade", Nrel5mwBlade::default(), until(0.1)),
        counted("tube_of_material", TubeOfMaterial::default(), until(0.2)),
        counted("tube_of_matrices", TubeOfMatrices::default(), until(0.2)),
        counted("esail", sail, with(alpha, fixed(1.0), 10.0)),
    ]
}

fn counted(name: &'static str, model: impl AnyModel + 'static, settings: RunSettings) -> Counted {
    Counted {
        name,
        model: Box::new(model),
        settings,
    }
}

fn main() -> ExitCode {
    let scenes = scenes();
    let Some(name) = std::env::args().nth(1) else {
        scenes.iter().for_each(|scene| println!("{}", scene.name));
        return ExitCode::SUCCESS;
    };
    let Some(scene) = scenes.iter().find(|scene| scene.name == name) else {
        eprintln!("error: there is no scene `{name}`");
        return ExitCode::FAILURE;
    };
    match run(scene.model.as_ref(), &scene.settings) {
        Ok(result) => {
            println!("{name}: {} steps", result.statistics.steps);
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
