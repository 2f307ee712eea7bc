//! Forces between two states that conserve energy, as text.

use std::fmt::Write;

use super::parts::Parts;
use crate::lower::Equations;
use crate::lower::conserving::Conserving;

/// The sentence of the notes.
pub fn note(equations: &Equations) -> String {
    let Conserving { obstacle, kernels } = &equations.conserving;
    let Some(obstacle) = obstacle else {
        let text = match kernels.is_empty() {
            true => "there is no flexible body to derive forces for",
            false => "forces between two states that conserve energy are derived",
        };
        return format!("Energy-momentum integration: {text}.");
    };
    format!("Energy-momentum integration: no forces that conserve energy are emitted, as {obstacle}.")
}

impl Parts<'_> {
    /// Why there are no conserving forces, if there are none.
    pub(super) fn conserving_obstacle(&self) -> String {
        let obstacle = self.equations.conserving.obstacle.as_ref();
        let obstacle = obstacle.map_or("None".to_string(), |obstacle| format!("Some({obstacle:?})"));
        format!("fn conserving_obstacle(&self) -> ::std::option::Option<&'static str> {{ {obstacle} }}\n")
    }

    /// The functions of the conserving forces.
    pub(super) fn conserving_forces(&self) -> String {
        let Conserving { obstacle, kernels } = &self.equations.conserving;
        if obstacle.is_some() || kernels.is_empty() {
            return String::new();
        }
        let mut text = String::new();
        let kind = self.kind();
        for (place, (name, result)) in [("force", "force"), ("tangent", "stiffness")].into_iter().enumerate() {
            let calls = self.by_body(|index, body| {
                format!(
                    "{}(&{}, {}::rncf::emitted::array(start), ::rncf::emitted::array(end), ::rncf::emitted::array_mut({result}));",
                    kernels[self.equations.variant_of[index]].kernels[place].name,
                    self.row(body),
                    self.reference(index, body),
                )
            });
            let _ = writeln!(
                text,
                "fn conserving_{name}(&self, body: usize, element: usize, start: &[f64], end: &[f64], {result}: &mut [f64]) {{\n{kind}{calls}}}"
            );
        }
        text
    }
}
