//! Forces between two states that conserve energy: where a model has them, and what stands against them.

use super::elastic::{Between, conserving_kernels, conserving_obstacle};
use super::motions::{self, is_free};
use super::variant_kernels::VariantKernels;
use crate::elements::Library;
use crate::model::{Expr, Fidelity, FrameId, LoadKind, Model};

/// The conserving forces of a model.
pub struct Conserving {
    /// Why the model has none, for the user: a sentence without its end.
    pub obstacle: Option<String>,
    /// Force and tangent of every element variant; empty where there is an obstacle.
    pub kernels: Vec<Between>,
}

impl Conserving {
    /// Derives them, if nothing stands against them; `dissipation` is why energy is not conserved at all.
    pub fn derive(
        model: &Model,
        library: &Library,
        (variants, variant_of): (&[VariantKernels], &[usize]),
        dissipation: Option<&str>,
    ) -> Self {
        let not_full = model.bodies.iter().find(|body| body.fidelity != Fidelity::Full);
        let not_full = not_full.map(|body| {
            format!(
                "body `{}` is described by modes or is rigid, not by all its nodal vectors",
                body.name
            )
        });
        let elements = model.bodies.iter().zip(variant_of).find_map(|(body, &variant)| {
            let variant = &variants[variant];
            let why = conserving_obstacle(&variant.variant, library)?;
            Some(format!("body `{}` {why}", body.name))
        });
        let obstacle = dissipation.map(str::to_string).or(not_full).or(elements);
        let kernels = match obstacle {
            Some(_) => Vec::new(),
            None => variants
                .iter()
                .filter_map(|variant| {
                    let elastic = &variant.elastic;
                    conserving_kernels(&variant.variant, library, elastic.form, elastic.fields.as_ref())
                })
                .collect(),
        };
        Self { obstacle, kernels }
    }
}

/// Why energy is not conserved, naming what moves or acts in a prescribed way, or damps; `None` where it is. Moments
/// have no potential in general.
pub fn not_conservative(
    model: &Model,
    library: &Library,
    (variants, variant_of): (&[VariantKernels], &[usize]),
) -> Option<String> {
    let bodies = model.bodies.iter().zip(variant_of);
    let mut damped = bodies
        .filter(|&(body, &variant)| body.fidelity.deforms() && variants[variant].variant.damped)
        .map(|(body, _)| format!("body `{}` is damped", body.name));
    let timed = model
        .bodies
        .iter()
        .find(|body| body.fidelity.deforms() && !motions::timed_coefficients(body, library).is_empty());
    damped
        .next()
        .or_else(|| timed.map(|body| format!("the strain energy of body `{}` changes with time", body.name)))
        .or_else(|| load_that_works(model))
        .or_else(|| force_that_works(model))
        .or_else(|| frame_that_moves(model))
}

fn load_that_works(model: &Model) -> Option<String> {
    if let Some(density) = model.densities.first() {
        return Some(format!("the load per length `{}` has no potential", density.name));
    }
    if let Some(load) = model.distributed.first() {
        return Some(format!("the load per length `{}` has no potential", load.name));
    }
    model.loads.iter().find_map(|load| match &load.kind {
        LoadKind::Around(_) => Some(format!("gravity `{}` changes with the place", load.name)),
        LoadKind::Gravity(components) | LoadKind::Force { components, .. } => {
            motions::varies(model, components).then(|| format!("load `{}` varies with time", load.name))
        }
        LoadKind::Moment { .. } => Some(format!("load `{}` is a moment, which has no potential", load.name)),
        LoadKind::Field { .. } => Some(format!("gravity `{}` changes with the place of its frame", load.name)),
    })
}

fn force_that_works(model: &Model) -> Option<String> {
    let rheonomic = model.constraints.iter().find(|constraint| {
        let rows = constraint.rows.iter().map(|(_, row)| row);
        motions::varies(model, rows)
    });
    if let Some(constraint) = rheonomic {
        return Some(format!("{} `{}` depends on time", constraint.kind, constraint.name));
    }
    model.forces.iter().find_map(|force| {
        let exprs: Vec<&Expr> = force.components.iter().flatten().chain(&force.energy).collect();
        if force.energy.is_none() {
            return Some(format!("force `{}` has no potential", force.name));
        }
        motions::varies(model, exprs).then(|| format!("force `{}` depends on time", force.name))
    })
}

/// A frame that matters and moves in a prescribed way.
fn frame_that_moves(model: &Model) -> Option<String> {
    let bodies = model.bodies.iter().map(|body| body.frame);
    let joints = model.joints.iter().map(|joint| joint.frame);
    let loads = model.loads.iter().filter_map(|load| match load.kind {
        LoadKind::Force { frame, .. } => Some(frame),
        _ => None,
    });
    let free = (0..model.frames.len())
        .map(FrameId)
        .filter(|&frame| is_free(model, frame));
    let used = model.constraints.iter().map(|constraint| &constraint.markers);
    let used = used.chain(model.forces.iter().map(|force| &force.markers)).flatten();
    let used = used.filter_map(|marker| model.markers[marker.0].frame());
    let mut frames = bodies.chain(joints).chain(loads).chain(free).chain(used);
    let moving = frames.find(|&frame| motions::moves(model, frame))?;
    Some(format!(
        "frame `{}` moves in a prescribed way",
        model.frames[moving.0].name
    ))
}
