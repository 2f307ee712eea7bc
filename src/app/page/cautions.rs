//! Cautions in a page: above all charts, or below that of the output that they are about.

use std::fmt::Write;

use crate::Caution;
use crate::app::writing::html::escape;

/// What stands below the chart of an output, as paragraphs of the page.
pub(in crate::app) fn below(cautions: &[Caution], output: usize) -> String {
    paragraphs(cautions.iter().filter(|caution| caution.outputs.contains(&output)))
}

/// What stands above all charts.
pub(in crate::app) fn above(cautions: &[Caution]) -> String {
    paragraphs(cautions.iter().filter(|caution| caution.outputs.is_empty()))
}

fn paragraphs<'a>(cautions: impl Iterator<Item = &'a Caution>) -> String {
    let mut text = String::new();
    for caution in cautions {
        let _ = writeln!(text, "<p class=\"caution\">{}</p>", escape(caution.text));
    }
    text
}

#[cfg(test)]
mod tests {
    use crate::AnyModel;
    use crate::app::RunSettings;
    use crate::app::page::report::run_part;
    use crate::app::page::summary;
    use crate::app::runs::run::run;
    use crate::app::testing::Rotor;

    #[test]
    fn a_caution_stands_where_its_condition_holds() {
        let settings = RunSettings {
            t_end: Some(0.5),
            ..RunSettings::default()
        };
        let calm = run(&Rotor::default(), &settings).unwrap();
        assert!(calm.cautions.is_empty() && calm.warnings.is_empty());
        let rotor = Rotor {
            coils: 7,
            ..Rotor::default()
        };
        let result = run(&rotor, &settings).unwrap();
        let sentence = format!("{}: seven coils touch <each other>", Rotor::default().outputs()[0].name);
        // The warnings of the scene itself follow.
        assert_eq!(result.warnings[..2], [sentence.clone(), "seven is many".into()]);
        let summary = summary::of_run(&rotor, &result);
        assert_eq!(summary["notes"][1], sentence.as_str());
        let page = run_part(&Rotor::default(), &result, None).unwrap();
        let chart = "<p class=\"caution\">seven coils touch &lt;each other&gt;</p>";
        assert_eq!(page.matches(chart).count(), 1);
        let figure = page.find("</figure>").unwrap();
        assert!(page.find(chart).unwrap() < figure);
        assert!(page.starts_with("<p class=\"caution\">seven is many</p>"));
    }
}
