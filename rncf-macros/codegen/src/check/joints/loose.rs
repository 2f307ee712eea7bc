//! Ties of a free frame that nothing resists: no mistake, but a warning at the word. A frame without mass of its own that is
//! clamped to the slope or section at the end of a body turns with it, and this end has the inertia of a part of an element:
//! the frame, and all coordinates in it, follow the quickest bending of the mesh.

use crate::check::fold;
use crate::check::messages as say;
use crate::elements::Library;
use crate::errors::{Area, Mistake};
use crate::model::{Fidelity, FrameId, Held, Joint, JointKind, Model};
use crate::parse::tree::{Keyword, Tree};

/// What the compiler says to be deprecated where such a warning stands.
pub const WARNING: &str = "follows_noise";

/// Warnings about a model without mistakes. A leading underscore of the joint's name silences them.
pub fn loose_ties(tree: &Tree, model: &Model, library: &Library) -> Vec<Mistake> {
    let mut warnings = Vec::new();
    for joint in &model.joints {
        if joint.name.starts_with('_') || !is_loose(model, joint) {
            continue;
        }
        let item = tree
            .items
            .iter()
            .find(|item| item.keyword == Keyword::Joint && item.name.text == joint.name);
        let body = &model.bodies[joint.body.0];
        let what = if library.elements[body.element.0].has_section() {
            "section"
        } else {
            "slope"
        };
        let frame = &model.frames[joint.frame.0].name;
        if let Some(item) = item {
            let message = say::loose_tie(&joint.name, frame, what, &body.name);
            warnings.push(Mistake::new(Area::from(item.name.span), message).called(WARNING));
        }
    }
    warnings
}

/// Whether a joint turns a frame without mass with a slope or section that carries no inertia.
fn is_loose(model: &Model, joint: &Joint) -> bool {
    let body = &model.bodies[joint.body.0];
    let turns = match joint.kind {
        JointKind::Clamp | JointKind::ClampFull => true,
        JointKind::Hold { of, .. } => of != Held::Position,
        JointKind::Pin => false,
    };
    let carried = model.fixtures.iter().any(|fixture| {
        let turning = &fixture.constants[4..];
        fixture.body == joint.body
            && fixture.at == joint.at
            && turning.iter().any(|moment| fold::constant(moment) != Some(0.0))
    });
    let is_own = body.frame == joint.frame && body.fidelity == Fidelity::Full;
    turns && !carried && is_own && is_massless(model, joint.frame)
}

/// Whether a frame is free and nothing in it is rigid.
fn is_massless(model: &Model, frame: FrameId) -> bool {
    let bodies = model.bodies.iter().filter(|body| body.frame == frame);
    let free = model.frames[frame.0].free.as_ref();
    free.is_some_and(|free| free.parts.is_empty()) && bodies.into_iter().all(|body| body.fidelity.deforms())
}
