//! What a model consists of before anything is computed: unknowns, conditions, what was derived, and what one evaluation of each
//! costs here.

use std::fmt::Write;
use std::time::{Duration, Instant};

use crate::app::line::arguments::Arguments;
use crate::app::results::failure::{Failure, MISTAKE};
use crate::app::writing::numbers::digits;
use crate::linalg::Saddle;
use crate::system::Tangent;
use crate::{AnyModel, Formulation, Joints, Scene, State, System};

/// How long each part is timed.
const TIMED: Duration = Duration::from_millis(20);

/// The text for standard output.
pub(in crate::app) fn execute(arguments: &Arguments) -> Result<String, Failure> {
    let model = arguments.model();
    let wrong = |error: crate::ModelError| Failure::new(MISTAKE, error);
    let formulation = arguments.settings.formulation;
    let build = |joints| model.build_as(formulation, joints, &arguments.settings.fidelity);
    let mut scene = build(arguments.settings.joints).map_err(wrong)?;
    let whole = build(Joints::Multipliers).map_err(wrong)?;
    let mut text = crate::app::line::help::about(model);
    text += &unknowns(scene.as_ref(), whole.as_ref(), formulation);
    text += &bodies(scene.as_ref());
    text += &derived(model);
    text += &work(scene.as_mut());
    text += "\nChosen and left out\n";
    for note in model.notes() {
        let _ = writeln!(text, "  {note}");
    }
    Ok(text)
}

/// Numbers of unknowns and conditions, and what their matrices take.
fn unknowns(scene: &dyn Scene, whole: &dyn Scene, formulation: Formulation) -> String {
    let (n, m) = (scene.unknowns(), scene.constraints());
    let eliminated = whole.constraints().saturating_sub(m);
    let border = scene.border();
    let entries = scene.pattern().entries();
    let of_constraints = scene.constraint_pattern().entries();
    // Mass, damping, stiffness and the matrix of the iteration hold one number for each entry.
    let bytes = 8 * (4 * entries + of_constraints);
    let mut text = format!("\n\nUnknowns, formulation {}\n", formulation.name());
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "  {name:32}{value}");
    };
    line("unknowns", n.to_string());
    line("  of them poses of free bodies", border.to_string());
    line("multipliers of constraints", m.to_string());
    line("eliminated conditions", eliminated.to_string());
    line("entries of the matrices", format!("{entries} of {}", n * n));
    line("entries of the constraints", of_constraints.to_string());
    line(
        "memory of the matrices",
        format!("{} kB", digits(bytes as f64 / 1e3, 3)),
    );
    text
}

/// Bodies with a mesh.
fn bodies(scene: &dyn Scene) -> String {
    let bodies = scene.bodies();
    if bodies.is_empty() {
        return String::new();
    }
    let mut text = "\nBodies\n".to_string();
    for body in bodies {
        let times = body
            .repetitions
            .map_or(String::new(), |count| format!(", {count} times"));
        let described = match body.elements {
            0 => "no elements".to_string(),
            1 => "1 element".to_string(),
            count => format!("{count} elements"),
        };
        let _ = writeln!(text, "  {:32}{described}{times}, {}", body.name, body.fidelity);
    }
    text
}

/// Constants and functions of the generated code.
fn derived(model: &dyn AnyModel) -> String {
    let mut text = String::new();
    if !model.constants().is_empty() {
        text += "\nConstant tensors of the unit elements\n";
        for array in model.constants() {
            let [rows, columns] = array.size;
            let _ = writeln!(text, "  {:44}{rows} x {columns}  {}", array.name, array.doc);
        }
    }
    let kernels = model.kernels();
    if !kernels.is_empty() {
        text += "\nFunctions, with the operations of one evaluation\n";
        let _ = writeln!(
            text,
            "  {:52}{:>8}{:>8}{:>8}{:>8}{:>10}",
            "", "+ -", "*", "/", "calls", "weighted"
        );
        for kernel in kernels {
            let _ = writeln!(
                text,
                "  {:52}{:>8}{:>8}{:>8}{:>8}{:>10}",
                kernel.name,
                kernel.additions,
                kernel.multiplications,
                kernel.divisions,
                kernel.functions,
                kernel.weighted
            );
        }
    }
    text
}

/// What the parts of a step take here, at rest.
fn work(scene: &mut dyn Scene) -> String {
    let state = scene.rest(0.0);
    let (n, m) = (scene.unknowns(), scene.constraints());
    let mut out = vec![0.0; n];
    let residual = timed(|| System::residual(scene, &state, &mut out));
    let entries = scene.pattern().entries();
    let zeros = || vec![0.0; entries];
    let mut tangent = Tangent {
        mass: zeros(),
        stiffness: zeros(),
        damping: zeros(),
    };
    let derivatives = timed(|| scene.tangent(&state, &mut tangent));
    let mut values = zeros();
    // A step of the size at which inertia and stiffness weigh alike is not known; any regular matrix of the pattern takes as long.
    let matrix = timed(|| scene.iteration_matrix(&state, [1.0, 1e-3, 1e-6], &mut values));
    let (factor, solve) = linear(scene, &state, &values, [n, m]);
    let mut text = "\nTime of one evaluation here, at rest\n".to_string();
    let mut line = |name: &str, seconds: Option<f64>| {
        let value = match seconds {
            None => "singular".to_string(),
            Some(seconds) if seconds < 1e-3 => format!("{} us", digits(1e6 * seconds, 3)),
            Some(seconds) => format!("{} ms", digits(1e3 * seconds, 3)),
        };
        let _ = writeln!(text, "  {name:32}{value}");
    };
    line("forces and inertia", Some(residual));
    line("mass, damping and stiffness", Some(derivatives));
    line("matrix of an iteration", Some(matrix));
    line("its factorization", factor);
    line("one solution with it", solve);
    if let (Some(factor), Some(solve)) = (factor, solve) {
        // Radau of order 5: a real and a complex matrix, the latter as four real ones; about four iterations at three stages.
        let iterations = 4.0 * (3.0 * residual + 5.0 * solve);
        let renewed = derivatives + 5.0 * factor;
        line("a step of radau, about", Some(iterations));
        line("  with new matrices, about", Some(iterations + renewed));
    }
    text
}

/// Seconds of a factorization of the matrix with the constraints, and of a solution; `None` where it is singular.
fn linear(scene: &mut dyn Scene, state: &State, values: &[f64], [n, m]: [usize; 2]) -> (Option<f64>, Option<f64>) {
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    let mut saddle: Saddle<f64> =
        Saddle::new(scene.pattern(), scene.border(), scene.constraint_pattern()).sized(scene.sizes());
    if saddle.factor_symmetric(values, &jacobian).is_err() {
        return (None, None);
    }
    let factor = timed(|| {
        let _ = saddle.factor_symmetric(values, &jacobian);
    });
    let (mut dynamics, mut constraints) = (vec![1.0; n], vec![0.0; m]);
    let solve = timed(|| {
        dynamics.fill(1.0);
        constraints.fill(0.0);
        saddle.solve(&mut dynamics, &mut constraints);
    });
    (Some(factor), Some(solve))
}

/// Mean seconds of something that is done again and again.
fn timed(mut work: impl FnMut()) -> f64 {
    work();
    let begin = Instant::now();
    let mut count = 0;
    while count < 3 || begin.elapsed() < TIMED {
        work();
        count += 1;
    }
    begin.elapsed().as_secs_f64() / f64::from(count)
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::path::PathBuf;

    use super::*;
    use crate::app::line::arguments::{Refusal, parse};
    use crate::app::line::command::Command;
    use crate::app::line::program::Program;
    use crate::app::testing::Rotor;

    fn explained(words: &[&str]) -> Result<String, String> {
        let program = Program {
            name: "rotor",
            default: Command::Run,
            more: "",
            out: PathBuf::from("out/rotor"),
        };
        let arguments = match parse(&Rotor::default(), &program, words.iter().map(OsString::from)) {
            Ok(arguments) => arguments,
            Err(Refusal::Mistake(text) | Refusal::Help(text)) => return Err(text),
        };
        execute(&arguments).map_err(|failure| failure.message)
    }

    #[test]
    fn counts_times_and_notes_are_told() {
        for formulation in ["rncf", "ancf"] {
            let text = explained(&["explain", "--formulation", formulation]).unwrap();
            for line in [
                format!("Unknowns, formulation {formulation}"),
                "The spring has no mass.".into(),
            ] {
                assert!(text.contains(&line), "{text}");
            }
            let time = text.lines().find(|line| line.contains("one solution with it")).unwrap();
            assert!(time.ends_with(" us"), "{time}");
        }
    }

    #[test]
    fn what_means_nothing_here_is_refused() {
        for flag in ["--out=x", "--rtol=1e-4", "--t-end=1", "--at=1"] {
            let text = explained(&["explain", flag]).unwrap_err();
            assert!(text.contains("not to `explain`: it integrates nothing"), "{text}");
        }
        let text = explained(&["explain", "stiffness=-1 N/m"]).unwrap_err();
        assert!(text.contains("`stiffness` must be positive"), "{text}");
    }
}
