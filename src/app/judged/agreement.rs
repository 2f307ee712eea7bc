//! How far outputs of a run or of equilibria are from those of finer meshes and other steps, where that is too little for a warning.

use super::marks::{Off, TOLD, largest};
use crate::Output;
use crate::app::writing::sentences::listed;

/// Most outputs that are named.
const MOST: usize = 3;
/// Outputs whose part is at least this of the largest one are named with it.
const LIKE: f64 = 0.1;
/// Least part that is told: less is round-off.
const LEAST: f64 = 1e-15;

/// One sentence on a run that was compared until its end, with finer meshes or not; where these had steps of a much `looser` tolerance, with that.
pub(in crate::app) fn of_run(outputs: &[Output], off: &[Off], has_meshes: bool, looser: Option<f64>) -> Option<String> {
    let meshes = if has_meshes { "twice as many elements and " } else { "" };
    let steps = looser.map_or("other steps".to_string(), |rtol| {
        format!("steps of the tolerance {rtol:.0e}, whose errors are in this")
    });
    sentence(outputs, off, &format!("{meshes}{steps}"))
}

/// The same of equilibria, which were compared with those of finer meshes, and of the critical values on their way.
pub(in crate::app) fn of_equilibria(outputs: &[Output], off: &[Off], critical: Option<f64>) -> Option<String> {
    let critical = critical.map_or(String::new(), |part| {
        format!(", critical values by {:.1e} of theirs", part.max(LEAST))
    });
    let text = sentence(outputs, off, "twice as many elements")?;
    Some(format!("{}{critical}.", text.trim_end_matches('.')))
}

/// The same of frequencies: the largest part by which one is off, and the number of its mode.
pub(in crate::app) fn of_modes(most: f64, mode: usize) -> String {
    format!(
        "Compared with twice as many elements, frequencies differ by at most {:.1e} of them (mode {mode}).",
        most.max(LEAST)
    )
}

fn sentence(outputs: &[Output], off: &[Off], with: &str) -> Option<String> {
    let most = largest(off);
    if off.is_empty() || most > TOLD {
        return None;
    }
    let like = off.iter().filter(|of| of.part >= LIKE * most);
    let names: Vec<String> = like.map(|of| format!("`{}`", outputs[of.output].name)).collect();
    Some(format!(
        "Compared with {with}, outputs differ by at most {:.1e} of their largest change ({}).",
        most.max(LEAST),
        listed(&names, MOST)?
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outputs_that_differ_most_are_named() {
        let output = |name| Output {
            name,
            unit: "m",
            time_exponent: 0.0,
            components: &[],
            doc: "",
        };
        let outputs = ["tip", "root", "middle"].map(output);
        let off = |output, part| Off {
            output,
            part,
            nothing: None,
        };
        let some = [off(2, 3.14e-4), off(0, 2e-4), off(1, 1e-6)];
        assert_eq!(
            of_run(&outputs, &some, true, None).unwrap(),
            "Compared with twice as many elements and other steps, outputs differ by at most 3.1e-4 of their largest change (`middle`, `tip`)."
        );
        assert!(
            of_run(&outputs, &some, false, None)
                .unwrap()
                .starts_with("Compared with other steps,")
        );
        assert!(
            of_run(&outputs, &some, true, Some(1e-4)).unwrap().starts_with(
                "Compared with twice as many elements and steps of the tolerance 1e-4, whose errors are in this, outputs differ by at most 3.1e-4 of"
            )
        );
        // Warnings tell what is more.
        assert_eq!(of_run(&outputs, &[off(0, 0.02)], true, None), None);
        assert!(
            of_equilibria(&outputs, &some, Some(5e-3))
                .unwrap()
                .ends_with(", critical values by 5.0e-3 of theirs.")
        );
        assert_eq!(of_equilibria(&outputs, &[], None), None);
    }
}
