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
