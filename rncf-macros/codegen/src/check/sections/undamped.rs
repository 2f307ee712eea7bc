//! Damping that leaves a part of the energy as it is: no mistake, but a warning at the word. A part that is of no strain has no rate: the bending of a
//! centre line in space, which knows its curvature up to a turn about the tangent. A rate of the curvature would depend on how fast the material turns
//! there, which the line does not know, and would damp rigid rotations of a bent body.

use crate::check::messages as say;
use crate::elements::{Density, Library};
use crate::errors::Mistake;
use crate::model::{Body, Expr, Line, Model, Space};
use crate::parse::tree::{ItemKind, Keyword, Tree};

/// What the compiler says to be deprecated where such a warning stands.
pub const WARNING: &str = "not_damped";

/// Warnings about a model without mistakes, one for a material, or for a section that says its stiffness by itself. A leading underscore of its name
/// silences them.
pub fn undamped_parts<'a>(tree: &Tree, model: &'a Model, library: &Library) -> Vec<Mistake> {
    let mut warnings = Vec::new();
    for item in &tree.items {
        let (ItemKind::Material(fields) | ItemKind::Section(fields)) = &item.kind else {
            continue;
        };
        let (name, kind) = (&item.name.text, item.keyword.word());
        let field = fields.fields.iter().find(|field| field.name.text == "damping");
        let owner = |body: &'a Body| match item.keyword {
            Keyword::Material => &body.material_name,
            _ => &body.section_name,
        };
        let mut bodies = model.bodies.iter().filter(|body| owner(body) == name);
        let found = bodies.find_map(|body| Some((body, undamped(body, library)?)));
        let (Some(field), Some((body, part))) = (field, found) else {
            continue;
        };
        if item.is_shared || item.name.word().starts_with('_') {
            continue;
        }
        let element = &library.elements[body.element.0];
        let place = if body.space == Space::Spatial {
            "in space"
        } else {
            "in a plane"
        };
        let cure = if element.is_of_library {
            "take `beam`"
        } else {
            "write its energy as that of a `strain`"
        };
        let message = say::undamped(&part, &body.name, place, element.names[0], cure, kind, name);
        warnings.push(Mistake::new(field.name.span, message).called(WARNING));
    }
    warnings
}

/// The first part of the energy of a damped body that is not damped.
fn undamped(body: &Body, library: &Library) -> Option<String> {
    let element = &library.elements[body.element.0];
    let is_damped = body
        .properties
        .get(element.damping)
        .is_some_and(|value| *value != Expr::Number(0.0));
    if !is_damped || !body.fidelity.deforms() || body.strain_energy.is_some() || matches!(body.line, Line::Imported(_))
    {
        return None;
    }
    let (_, terms) = element.terms_in(body.space.dimension(), &body.options);
    let part = terms.iter().find(|term| matches!(term.density, Density::Energy(_)))?;
    Some(part.name.to_owned())
}
