//! An integration that is taken up from where it was last renewed, with a scene built anew, goes on with the same bits: nothing
//! is hidden in scenes or methods.

use rncf::model::Fidelity;
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene, State, StepSize, Stop};
use rncf_models::{CurvedUpwind, Esail, FlyballGovernor, FreeFlight, HeavyTop, Motor, SliderCrank};

use crate::kinks::Switched;
use crate::models::{Conservative, SoftPlanar};
use crate::runs::WAYS;

const HHT: Method = Method::Hht { alpha: -0.05 };
const ALPHA: Method = Method::GeneralizedAlpha { rho_inf: 0.8 };
const METHODS: [Method; 3] = [HHT, ALPHA, Method::Radau];
/// Renewals, in evaluations of the residual.
const RENEWED: u64 = 10;
/// Steps that are compared.
const STEPS: u64 = 60;

fn adaptive() -> Options {
    Options {
        renewed_after: Some(RENEWED),
        ..Options::default()
    }
}

/// A scene and how it runs.
struct Case<'m, M> {
    model: &'m M,
    way: (Formulation, Joints),
    fidelity: Vec<(String, Fidelity)>,
    method: Method,
    options: Options,
    t_end: f64,
}

impl<M: Model> Case<'_, M> {
    fn scene(&self) -> Box<dyn Scene> {
        let (formulation, joints) = self.way;
        self.model.build_as(formulation, joints, &self.fidelity).unwrap()
    }

    /// All that can be seen at the ends of steps and within them up to a number of steps, and what the renewals left.
    fn seen(&self, mut integrator: Integrator<'_, dyn Scene + '_>) -> (Vec<String>, Vec<(usize, Vec<u8>)>) {
        let (mut lines, mut renewed): (Vec<String>, Vec<(usize, Vec<u8>)>) = (Vec::new(), Vec::new());
        let mut row = vec![0.0; integrator.system().output_columns()];
        let mut sections = Vec::new();
        while integrator.statistics().steps < STEPS {
            let stop = integrator.step().unwrap();
            let mut state = integrator.state().clone();
            let last = integrator.previous_time();
            integrator.interpolate(last + 0.3 * (state.t - last), &mut state);
            for state in [state, integrator.state().clone()] {
                let scene = integrator.system();
                scene.outputs(&state, &mut row);
                scene.section_states(&state, &mut sections);
                // Numbers in this form are told to the last bit.
                lines.push(format!("{state:?} {row:?} {sections:?} {:?}", scene.energy(&state)));
            }
            lines.push(format!("{:?}", integrator.statistics()));
            if let Some(bytes) = integrator.renewed()
                && renewed.last().is_none_or(|(_, last)| last != bytes)
            {
                renewed.push((lines.len(), bytes.to_vec()));
            }
            if stop == Stop::End {
                break;
            }
        }
        (lines, renewed)
    }

    /// Compares a run that is taken up from an early and a late renewal with one that is not.
    fn check(&self, name: &str) {
        let told = format!("{name}, {:?}, {:?}", self.way, self.method);
        let mut scene = self.scene();
        let start = scene.rest(0.0);
        let integrator = Integrator::new(scene.as_mut(), start, self.t_end, self.method, self.options).unwrap();
        let (whole, renewed) = self.seen(integrator);
        assert!(renewed.len() >= 2, "{told}: {} renewals", renewed.len());
        for (done, bytes) in [&renewed[0], &renewed[renewed.len() / 2]] {
            let mut scene = self.scene();
            // A run builds its start also where it does not need it.
            let _: State = scene.rest(0.0);
            let integrator = Integrator::resume(scene.as_mut(), bytes, self.method, self.options).unwrap();
            let (again, _) = self.seen(integrator);
            assert_eq!(again.len(), whole.len() - done, "{told}");
            for (k, (again, line)) in again.iter().zip(&whole[*done..]).enumerate() {
                assert!(again == line, "{told}: line {k} behind {done}\n{again}\n{line}");
            }
        }
    }
}

fn check<M: Model>(name: &str, model: &M, ways: &[(Formulation, Joints)], methods: &[Method], t_end: f64) {
    for &way in ways {
        for &method in methods {
            let case = Case {
                model,
                way,
                fidelity: Vec::new(),
                method,
                options: adaptive(),
                t_end,
            };
            case.check(name);
        }
    }
}

#[test]
fn beams_in_all_ways_and_methods_across_a_kink() {
    let model = SoftPlanar {
        T_s: 0.05,
        elements: 3,
        ..SoftPlanar::default()
    };
    check("beam", &model, &WAYS, &METHODS, 1.0);
}

#[test]
fn switches_that_are_found_on_the_way() {
    check("switched", &Switched::default(), &WAYS[..1], &METHODS, 4.0);
}

#[test]
fn mechanisms_tops_and_free_flight() {
    check(
        "slider-crank",
        &SliderCrank::default(),
        &[WAYS[0], WAYS[3]],
        &[ALPHA, Method::Radau],
        1.0,
    );
    check("governor", &FlyballGovernor::default(), &WAYS[..1], &METHODS, 1.0);
    check("top", &HeavyTop::default(), &WAYS[..1], &METHODS, 1.0);
    check(
        "flight",
        &FreeFlight::default(),
        &[WAYS[0], WAYS[2]],
        &[HHT, Method::Radau],
        1.0,
    );
}

#[test]
fn sections_and_what_they_carry() {
    let motor = Motor {
        T_s: 0.05,
        ..Motor::default()
    };
    check("motor", &motor, &[WAYS[0], WAYS[3]], &[ALPHA, Method::Radau], 0.2);
    check(
        "curved",
        &CurvedUpwind::default(),
        &[WAYS[0]],
        &[HHT, Method::Radau],
        1.0,
    );
}

#[test]
fn a_sail_of_tethers_side_by_side() {
    let model = Esail {
        tethers: 4,
        elements: 4,
        ..Esail::default()
    };
    check("sail", &model, &[WAYS[0]], &[HHT, Method::Radau], 1e4);
}

#[test]
fn bodies_in_modes_rigid_bodies_fixed_steps_and_stabilised_constraints() {
    let rod = SliderCrank::default();
    for fidelity in [Fidelity::Modal(4), Fidelity::Small(3), Fidelity::Rigid] {
        for method in [ALPHA, Method::Radau] {
            let case = Case {
                model: &rod,
                way: WAYS[0],
                fidelity: vec![("beam".into(), fidelity)],
                method,
                options: adaptive(),
                t_end: 1.0,
            };
            case.check(&format!("{fidelity}"));
        }
    }
    for (stabilised, step) in [
        (true, StepSize::Adaptive),
        (false, StepSize::Fixed(2e-3)),
        (true, StepSize::Fixed(2e-3)),
    ] {
        for method in METHODS {
            let options = Options {
                stabilised,
                step,
                ..adaptive()
            };
            let case = Case {
                model: &rod,
                way: WAYS[1],
                fidelity: Vec::new(),
                method,
                options,
                t_end: 1.0,
            };
            case.check("stabilised or fixed");
        }
    }
}

#[test]
fn energy_momentum_integration() {
    for step in [StepSize::Adaptive, StepSize::Fixed(0.01)] {
        let case = Case {
            model: &Conservative::default(),
            way: (Formulation::Ancf, Joints::Eliminated),
            fidelity: Vec::new(),
            method: Method::EnergyMomentum,
            options: Options { step, ..adaptive() },
            t_end: 1.0,
        };
        case.check("conservative");
    }
}
