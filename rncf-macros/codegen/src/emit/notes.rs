//! What was chosen and left out, and why, in sentences: documentation of the generated struct, and notes of a run.

use crate::elements::{Interpolant, Library, NodalVector};
use crate::lower::constraints::members;
use crate::lower::joints::JointKernels;
use crate::lower::markers::list;
use crate::lower::motions;
use crate::lower::{Equations, VariantKernels};
use crate::model::{Body, Fidelity, FrameTie, INERTIAL, Joint, Line, Model, Motions, Space};

/// What was chosen and left out, and why.
pub fn notes(model: &Model, library: &Library, equations: &Equations) -> Vec<String> {
    let mut notes = Vec::new();
    for (body, &variant) in model.bodies.iter().zip(&equations.variant_of) {
        let variant = &equations.variants[variant];
        if let Line::Imported(imported) = &body.line {
            notes.push(format!(
                "Body `{}` comes from `{}`: its modes are found when the scene is built.",
                body.name,
                imported.files.join("`, `")
            ));
            notes.push(placed(model, body));
            notes.extend(described(body));
            continue;
        }
        notes.push(format!(
            "Body `{}` uses `{}`. {}",
            body.name, variant.name, variant.elastic.choice
        ));
        if let Space::Planar { .. } = body.space {
            notes.push(format!(
                "Body `{}` is planar: two components a vector, no motion along the normal.",
                body.name
            ));
        }
        notes.push(section(body, &variant.variant.vectors(library)));
        notes.extend(plain(body, variant));
        notes.push(placed(model, body));
        notes.extend(described(body));
    }
    for (joint, kernels) in model.joints.iter().zip(&equations.joints) {
        notes.extend(eliminated(model, joint, kernels));
    }
    notes.extend(moving(model, equations));
    notes.extend(jerks(model));
    notes.extend(absent(model, equations));
    notes.push(super::conserving::note(equations));
    notes
}

/// What a body does not need.
fn plain(body: &Body, variant: &VariantKernels) -> Option<String> {
    let mut without = Vec::new();
    if !variant.variant.damped {
        let owner = if body.has_own_stiffness() {
            "section"
        } else {
            "material"
        };
        without.push(format!(
            "its {owner} has no damping: no rates of strain and no damping matrix"
        ));
    }
    if !variant.variant.curved {
        without.push("its axis is straight: no stress-free curvature for each element".to_string());
    }
    (!without.is_empty()).then(|| format!("Body `{}`: {}.", body.name, without.join("; ")))
}

/// Joints whose conditions are linear in the nodal vectors.
fn eliminated(model: &Model, joint: &Joint, kernels: &(Option<JointKernels>, Option<JointKernels>)) -> Option<String> {
    let (referenced, absolute) = kernels;
    // In the frame of the body, where it has one of its own.
    let own = if model.bodies[joint.body.0].frame == INERTIAL {
        absolute
    } else {
        referenced
    };
    let own = own.as_ref()?;
    let rates = if own.levels[1..].iter().all(Option::is_none) {
        "; they do not change with time, so that there are no functions for their rates"
    } else {
        ""
    };
    Some(format!(
        "Joint `{}`: its conditions are linear in the nodal vectors of `{}` and eliminated, neither unknowns nor multipliers{rates}.",
        joint.name, model.bodies[joint.body.0].name
    ))
}

/// Third derivatives of what moves in a prescribed way.
fn jerks(model: &Model) -> Option<String> {
    let prescribed = model.frames.iter().skip(1).any(|frame| frame.free.is_none());
    (prescribed && motions::highest_derivative(model) < 3).then(|| {
        "Prescribed motions have two derivatives: the third is read by constraints with multipliers and by mean axes \
         alone, and there are none."
            .to_string()
    })
}

/// Kinds of things that are not declared, so that nothing is written for them.
fn absent(model: &Model, equations: &Equations) -> Option<String> {
    let kinds = [
        (model.bodies.is_empty(), "flexible bodies"),
        (equations.free.is_empty(), "free frames and rigid bodies"),
        (model.fixtures.is_empty(), "fixtures"),
        (model.constraints.is_empty(), "constraints with multipliers"),
        (model.forces.is_empty(), "springs and forces on moving places"),
        (equations.loads.is_empty(), "gravity and dead loads"),
        (
            equations.moments.is_empty() && equations.section_moments.is_none(),
            "dead moments",
        ),
        (equations.fields.is_empty(), "gravity fields"),
        (
            model.densities.is_empty() && model.distributed.is_empty(),
            "loads per length",
        ),
        (equations.initial.is_empty(), "initial shapes"),
        (model.starts.is_empty(), "starts in equilibrium"),
        (equations.switches.is_empty(), "kinks of motions"),
        (model.cautions.is_empty(), "cautions"),
    ];
    let absent: Vec<&str> = kinds
        .iter()
        .filter(|(is_absent, _)| *is_absent)
        .map(|(_, kind)| *kind)
        .collect();
    (!absent.is_empty()).then(|| {
        format!(
            "Not declared, so that no function is written for it: {}.",
            absent.join(", ")
        )
    })
}

/// What the nodes of a body carry beside position and slope.
fn section(body: &Body, vectors: &[&NodalVector]) -> String {
    let axes = vectors.iter().filter(|vector| vector.of != Interpolant::Position);
    let names: Vec<&str> = axes.map(|vector| vector.name).collect();
    let which = match body.space {
        Space::Planar { .. } => "the section's y axis",
        Space::Spatial => "the section's y and z axes",
    };
    if names.is_empty() {
        return format!(
            "Body `{}` is a centre line: no axes of the section, hence no shear, no torsion and no rotary inertia.",
            body.name
        );
    }
    let motions = match body.space {
        Space::Planar { .. } => "shear and have rotary inertia; there is no torsion in a plane",
        Space::Spatial => "shear, twist and have rotary inertia",
    };
    format!(
        "Body `{}` has nodal vectors for {which} ({}): sections {motions}.",
        body.name,
        names.join(", ")
    )
}

/// Where a body lives.
fn placed(model: &Model, body: &Body) -> String {
    let (name, frame) = (&body.name, &model.frames[body.frame.0]);
    if body.frame == INERTIAL {
        return format!(
            "Body `{name}` lives in the inertial frame: RNCF and ANCF are the same, no kernels for a moving frame."
        );
    }
    if frame.free.is_none() {
        return format!(
            "Body `{name}` moves in the prescribed frame `{}`: no unknowns for the frame, its reactions are evaluated.",
            frame.name
        );
    }
    let follows = match body.tie {
        FrameTie::Joints => "",
        FrameTie::MeanAxes => ", which follows the body's mean axes",
        FrameTie::Chord => ", which follows the body's chord",
    };
    format!(
        "Body `{name}` moves in the free frame `{}`{follows}: force and moment of its inertia on the frame, and their \
         derivatives, are derived; conditions that depend on the frame's pose are constraints with multipliers.",
        frame.name
    )
}

/// How finely a body's deformation is described, where not by all nodal vectors.
fn described(body: &Body) -> Option<String> {
    let name = &body.name;
    match body.fidelity {
        Fidelity::Full => None,
        Fidelity::Modal(_) => Some(format!(
            "Body `{name}` deforms in its lowest modes in its frame (Eqs. 15-17)."
        )),
        Fidelity::Small(_) => Some(format!(
            "Body `{name}` deforms little, in its lowest modes in its frame (Eqs. 18-20)."
        )),
        Fidelity::Rigid => Some(format!(
            "Body `{name}` does not deform: no unknowns, its elastic forces are not evaluated in a run."
        )),
        Fidelity::Point => Some(format!(
            "Body `{name}` is its mass at its centre of mass: no unknowns, no rotary inertia, its elastic forces are not \
             evaluated in a run."
        )),
    }
}

/// Free frames, constraints, forces and fixtures.
fn moving(model: &Model, equations: &Equations) -> Vec<String> {
    let mut notes = Vec::new();
    for frame in &model.frames {
        if let Some(free) = &frame.free {
            let what = if free.is_body { "Rigid body" } else { "Frame" };
            notes.push(format!(
                "{what} `{}` is free in {}.",
                frame.name,
                unknowns(&free.motions)
            ));
        }
    }
    for kernels in &equations.constraints {
        let names = members(model, &kernels.of);
        let form = match kernels.hessian {
            Some(_) => "gradient and second derivatives are derived",
            None => "linear in its vectors, no second derivatives",
        };
        let count = kernels.levels[0].outputs.len();
        let multipliers = if count == 1 { "multiplier" } else { "multipliers" };
        notes.push(format!("Constraint {names}: {count} {multipliers}; {form}."));
    }
    for kernels in &equations.forces {
        let names = list(kernels.of.iter().map(|&index| model.forces[index].name.as_str()));
        let potential = if kernels.energy.is_some() { "a" } else { "no" };
        notes.push(format!(
            "Force {names}: {potential} potential; its tangents are derived."
        ));
    }
    for fixture in &model.fixtures {
        let body = &model.bodies[fixture.body.0].name;
        notes.push(format!(
            "Fixture `{}` adds constants to the inertia of `{body}` and no unknowns.",
            fixture.name
        ));
    }
    notes
}

fn unknowns(motions: &Motions) -> &'static str {
    match motions {
        Motions::Spatial => "six motions: three positions and a rotation vector that begins anew every step",
        Motions::Planar { .. } => "three motions: two positions and an angle",
        Motions::Turning => "three motions: a rotation vector that begins anew every step",
        Motions::Hinged { .. } => "one motion: an angle",
        Motions::Shifting => "three motions: a point mass does not turn",
        Motions::ShiftingPlanar { .. } => "two motions: a point mass does not turn",
        Motions::State => "no motion: a number with an equation of its own",
    }
}
