//! What is said of the part of a run that was not compared.

use super::meshes::time;

/// What is said of the rest of a run, behind what was compared; some of it may be told of its mesh.
pub(super) fn not_compared(
    [until, end]: [f64; 2],
    is_told: bool,
    is_whole: bool,
    failed: Option<(f64, String)>,
) -> Option<String> {
    const MORE: &str = "`--thorough` compares all of it, `--unjudged` nothing";
    if until == 0.0 && failed.is_none() && !is_whole {
        let head = if is_told {
            "Beyond what is told here, outputs"
        } else {
            "Outputs"
        };
        return Some(format!(
            "{head} were not compared with those of finer meshes and other steps, which takes longer than the run: nothing is known of their errors. {MORE}."
        ));
    }
    let (until, end) = (time(until), time(end));
    let compared = format!("Outputs were compared with those of finer meshes and other steps until {until} s");
    if let Some((rtol, error)) = failed {
        return Some(format!(
            "{compared}: Radau with a tolerance of {rtol:.0e} came no further, {error}. From there to {end} s nothing is known of their errors."
        ));
    }
    (!is_whole).then(|| {
        format!(
            "{compared}, which took about the time of the run; from there to {end} s nothing is known of their errors. {MORE}."
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_compared_is_told_with_its_reason() {
        let rest = |until, is_told, is_whole, failed| not_compared([until, 3.0], is_told, is_whole, failed);
        let failed = || Some((1e-4, "a step failed".to_string()));
        for is_whole in [false, true] {
            let told = rest(0.5, false, is_whole, failed()).unwrap();
            assert!(
                told.contains("until 0.500 s: Radau with a tolerance of 1e-4 came no further, a step failed."),
                "{told}"
            );
        }
        let told = rest(0.5, false, false, None).unwrap();
        assert!(
            told.contains("until 0.500 s, which took about the time of the run"),
            "{told}"
        );
        // Beside what differs until later, nothing says that it was compared until 0 s.
        let told = rest(0.0, true, false, None).unwrap();
        assert!(told.starts_with("Beyond what is told here"), "{told}");
        assert_eq!(rest(0.5, false, true, None), None);
    }
}
