//! Bodies described otherwise than they are declared: the same model as a ladder of models, chosen at run time.

use crate::emitted::{BodySpec, Fidelity, FrameTie, Line};
use crate::error::ModelError;

/// Describes bodies, by their names, otherwise than they are declared.
///
/// # Errors
/// A name that no body has or that stands twice, and what cannot be described so, by name. What modes cannot
/// describe for other reasons (densities, shared nodes, starts, joints) is refused where it is built.
pub(crate) fn describe(specs: &mut [BodySpec], wanted: &[(String, Fidelity)]) -> Result<(), ModelError> {
    for (place, (name, fidelity)) in wanted.iter().enumerate() {
        if wanted[..place].iter().any(|(other, _)| other == name) {
            return Err(ModelError::new(format!("body `{name}` is described twice")));
        }
        let Some(first) = specs.iter().position(|spec| spec.name == name) else {
            return Err(ModelError::new(unknown(specs, name)));
        };
        let declared = specs[first].fidelity;
        if specs[first].instance.is_some() && *fidelity != declared {
            return Err(ModelError::new(format!(
                "body `{name}` is repeated, and repeated bodies have all their nodal vectors: it cannot be `{fidelity}`"
            )));
        }
        if !declared.deforms() && fidelity.deforms() {
            return Err(ModelError::new(format!(
                "body `{name}` is declared `{declared}` and has no elements that deform: leave `{declared}` out of its declaration to describe it as `{fidelity}`"
            )));
        }
        if specs[first].tie != FrameTie::Joints && *fidelity != Fidelity::Full {
            return Err(ModelError::new(format!(
                "body `{name}` cannot be `{fidelity}` since its frame follows its {}: clamp it in its frame instead of `{}`",
                specs[first].tie.describe(),
                specs[first].tie.word()
            )));
        }
        specs[first].fidelity = *fidelity;
    }
    specs.iter_mut().try_for_each(hold_coordinates)
}

/// Nodes that hold the modal coordinates of bodies from elsewhere.
fn hold_coordinates(spec: &mut BodySpec) -> Result<(), ModelError> {
    let label = spec.label();
    let Line::Nodes(nodes) = &mut spec.line else {
        return Ok(());
    };
    let body = nodes.body().map_err(ModelError::new)?;
    let coordinates = match spec.fidelity {
        Fidelity::Full => {
            return Err(ModelError::new(format!(
                "body `{label}` comes from a file and has modes alone: describe it as modal(4), small(4) with a number of modes, rigid or point"
            )));
        }
        Fidelity::Modal(count) | Fidelity::Small(count) => body.most_modes(count),
        Fidelity::Rigid | Fidelity::Point => 0,
    };
    nodes.hold(coordinates);
    spec.count = nodes.count() - 1;
    Ok(())
}

fn unknown(specs: &[BodySpec], name: &str) -> String {
    let mut names: Vec<&str> = specs.iter().map(|spec| spec.name).collect();
    names.dedup();
    match &names[..] {
        [] => format!("there is no body `{name}`: the model has no meshed bodies"),
        names => format!(
            "there is no meshed body `{name}`: there {} `{}`",
            if names.len() == 1 { "is" } else { "are" },
            names.join("`, `")
        ),
    }
}
