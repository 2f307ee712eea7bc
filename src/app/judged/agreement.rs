//! How far outputs of a run or of equilibria are from those of finer meshes and other steps, where that is too little for a warning.

use super::compared::{Off, TOLD};
use super::marks::largest;
use crate::Output;
use crate::app::writing::sentences::listed;

/// Most outputs that are named.
const MOST: usize = 3;
/// Outputs whose part is at least this of the largest one are named with it.
const LIKE: f64 = 0.1;
/// Least part that is told: less is round-off.
const LEAST: f64 = 1e-15;

/// One sentence on a run that was compared until its end, with finer meshes or not; where these had steps of a much `looser` tolerance of Radau, with that.
pub(in crate::app) fn of_run(outputs: &[Output], off: &[Off], has_meshes: bool, looser: Option<f64>) -> Option<String> {
    let meshes = if has_meshes { "twice as many elements and " } else { "" };
    let steps = looser.map_or("other steps".to_string(), |rtol| {
        format!("steps of Radau with the tolerance {rtol:.0e}, whose errors are in this")
    });
    sentence(outputs, off, &format!("{meshes}{steps}"))
}

/// The same of equilibria, which were compared with those of finer meshes, and of the critical values on their way.
pub(in crate::app) fn of_equilibria(outputs: &[Output], off: &[Off], critical: Option<f64>) -> Option<String> {
    let critical = of_values(critical);
    let text = sentence(outputs, off, "twice as many elements")?;
    Some(format!("{}{critical}.", text.trim_end_matches('.')))
}

/// The same of frequencies at a place of a diagram, and its critical values: the largest part by which one is off, and the number of its mode.
pub(in crate::app) fn of_modes(
    place: &str,
    (most, mode): (f64, usize),
    damping: Option<(f64, usize)>,
    critical: Option<f64>,
) -> String {
    let critical = of_values(critical);
    let damping = damping.map_or(String::new(), |(most, mode)| {
        format!(", dampings by at most {:.1e} (mode {mode})", most.max(LEAST))
    });
    format!(
        "Compared with twice as many elements, frequencies{place} differ by at most {:.1e} of them (mode {mode}){damping}{critical}.",
        most.max(LEAST)
    )
}

fn of_values(critical: Option<f64>) -> String {
    critical.map_or(String::new(), |part| {
        format!(", critical values by {:.1e} of theirs", part.max(LEAST))
    })
}

fn sentence(outputs: &[Output], off: &[Off], with: &str) -> Option<String> {
    let most = largest(off);
    if off.is_empty() || most > TOLD {
        return None;
    }
    let (open, others): (Vec<&Off>, Vec<&Off>) = off.iter().partition(|of| of.is_open);
    // Of what is nothing beside what it is made of, nothing is said.
    let known: Vec<&Off> = others.into_iter().filter(|of| of.nothing.is_none()).collect();
    let most = known.first().map_or(0.0, |of| of.part);
    let like = known.iter().filter(|of| of.part >= LIKE * most);
    let names: Vec<String> = like.map(|of| format!("`{}`", of.name(outputs))).collect();
    let size = |of: &&Off| {
        let (Output { name, unit, .. }, size) = (outputs[of.output], of.part * of.nothing.unwrap_or_default());
        let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
        format!("`{name}` by {size:.1e}{unit}")
    };
    let open: Vec<String> = open.iter().map(size).collect();
    let open = listed(&open, MOST).map(|open| {
        format!("{open}: what changes so little beside what it is made of is not known with this tolerance")
    });
    let known = listed(&names, MOST).map(|names| {
        format!(
            "outputs differ by at most {:.1e} of their largest change ({names})",
            most.max(LEAST)
        )
    });
    let found = match (known, open) {
        (Some(known), Some(open)) => format!("{known}, and {open}"),
        (Some(one), None) => one,
        (None, Some(open)) => format!("outputs differ, {open}"),
        (None, None) => "no output changes by more than errors of what it is made of".to_string(),
    };
    Some(format!("Compared with {with}, {found}."))
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
            component: None,
            part,
            nothing: None,
            is_open: false,
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
                "Compared with twice as many elements and steps of Radau with the tolerance 1e-4, whose errors are in this, outputs differ by at most 3.1e-4 of"
            )
        );
        let mut open = off(1, 1e-5);
        (open.nothing, open.is_open) = (Some(6.0), true);
        assert_eq!(
            of_run(&outputs, &[off(0, 2e-4), open], false, None).unwrap(),
            "Compared with other steps, outputs differ by at most 2.0e-4 of their largest change (`tip`), and `root` by 6.0e-5 m: what changes so little beside what it is made of is not known with this tolerance."
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
