//! What is refused of bodies and joints before a scene is built.

use std::f64::consts::FRAC_PI_2;

use crate::emitted::{BodySpec, JointSpec, Line, LoadKind, MarkerSpec, ObservedSpec, Parts};
use crate::error::ModelError;

/// Elements of one body that are surely not meant: their vectors alone would fill the memory.
const MOST_ELEMENTS: usize = 10_000_000;

/// Parts of an element over which turns are summed; a prime, so that no winding of a coil hides in one.
const PARTS: usize = 31;
/// The same of a twist.
const FEW: usize = 11;

/// A joint may tie a body to its own free frame; everything else between free frames is a constraint.
pub(crate) fn check_joint(
    parts: &dyn Parts,
    joint: &JointSpec,
    body: &BodySpec,
    free: &[bool],
) -> Result<(), ModelError> {
    if joint.frame == body.frame || !free[joint.frame] && !free[body.frame] {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "joint `{}` ties body `{}` to frame `{}`, and one of them moves freely: give it as a constraint",
        joint.name,
        body.label(),
        parts.frame_name(joint.frame)
    )))
}

/// Joints that a loop repeats have no constraint on markers beside them.
pub(crate) fn check_absolute(parts: &dyn Parts, joint: &JointSpec, body: &BodySpec) -> Result<(), ModelError> {
    if body.instance.is_none() {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "joint `{}` ties the repeated body `{}` to frame `{}`, which moves freely: absolute coordinates have no such joints, use the referenced formulation",
        joint.name,
        body.name,
        parts.frame_name(joint.frame)
    )))
}

pub(crate) fn check_body(spec: &BodySpec) -> Result<(), ModelError> {
    if let Line::Curve(curve) = &spec.line
        && let Some(mistake) = curve.mistake()
    {
        return Err(ModelError::new(format!("body `{}`: its curve {mistake}", spec.label())));
    }
    if let Line::Nodes(nodes) = &spec.line {
        return nodes.body().map(|_| ()).map_err(ModelError::new);
    }
    let length = spec.line.length();
    if !(length.is_finite() && length > 0.0) {
        return Err(ModelError::new(format!(
            "body `{}` has the length {length} m: give its line two ends",
            spec.label()
        )));
    }
    if spec.count == 0 {
        return Err(ModelError::new(format!(
            "body `{}` has no elements: its mesh needs at least one",
            spec.label()
        )));
    }
    if spec.count > MOST_ELEMENTS {
        return Err(ModelError::new(format!(
            "body `{}` has {} elements, and at most {MOST_ELEMENTS} are meshed",
            spec.label(),
            spec.count
        )));
    }
    let angle: f64 = match spec.line {
        Line::Arc { angle, .. } => angle,
        Line::Straight { .. } | Line::Nodes(_) => 0.0,
        Line::Curve(_) => summed(spec, PARTS, &|u| spec.line.at(u).1, &|before, after| {
            before.dot(after).clamp(-1.0, 1.0).acos()
        }),
    };
    check_stations(spec)?;
    spec.check_directions()?;
    // Twist may swing within an element and come back.
    let twist = match spec.has_turning_section() {
        true => summed(spec, PARTS, &|u| spec.directed(u), &|before, after| {
            before.turn_to(after)
        }),
        false => summed(spec, FEW, &|u| spec.twist.at(u), &|before, after| {
            (after - before).abs()
        }),
    };
    for (angle, what) in [(angle, "bent"), (twist, "twisted")] {
        let each = angle.abs() / spec.count as f64;
        // The macro has the same limit for the defaults.
        if each > FRAC_PI_2 * (1.0 + 1e-6) {
            return Err(ModelError::new(format!(
                "body `{}`: each of its {} elements is {what} by {:.0} deg, and none follows more than 90 deg: take at least {} elements",
                spec.label(),
                spec.count,
                each.to_degrees(),
                (angle.abs() / FRAC_PI_2 * (1.0 - 1e-6)).ceil()
            )));
        }
    }
    Ok(())
}

/// The sum over the parts of an element of the turns, rad, between what is at their ends: the largest one, times the number of elements.
fn summed<T>(spec: &BodySpec, parts: usize, at: &dyn Fn(f64) -> T, turn: &dyn Fn(&T, &T) -> f64) -> f64 {
    let of_element = |element: usize| {
        let [start, end] = [element, element + 1].map(|node| spec.fraction(node, 0));
        let place = |part: usize| start + part as f64 / parts as f64 * (end - start);
        let ends: Vec<T> = (0..=parts).map(|part| at(place(part))).collect();
        ends.windows(2).map(|ends| turn(&ends[0], &ends[1])).sum::<f64>()
    };
    (0..spec.count).map(of_element).fold(0.0, f64::max) * spec.count as f64
}

/// Refuses a twist that jumps at a step of its table: both elements there have one section. The macro has the same limit.
pub(crate) fn check_twists(parts: &dyn Parts, specs: &[BodySpec]) -> Result<(), ModelError> {
    for (body, spec) in specs.iter().enumerate() {
        for table in parts.tables(body) {
            if let Some((x, jump)) = table.jump(spec.line.length(), 1e-6, |u| spec.twist.at(u)) {
                return Err(ModelError::new(format!(
                    "body `{}`: its twist jumps by {:.4} deg at x = {x:.6} m, at a step of table `{}`, and both elements there have one section: let it turn from row to row, or end the body there and `weld` the next one to it",
                    spec.label(),
                    jump.to_degrees(),
                    table.name
                )));
            }
        }
    }
    Ok(())
}

/// Refuses nodes that do not go from start to end.
fn check_stations(spec: &BodySpec) -> Result<(), ModelError> {
    let stations = &spec.stations;
    if stations.is_empty() {
        return Ok(());
    }
    let mut lengths = stations.windows(2).map(|pair| pair[1] - pair[0]);
    let goes_on = lengths.all(|length| length > 0.0);
    if goes_on && stations.len() == spec.count + 1 && stations[0] == 0.0 && stations[spec.count] == 1.0 {
        return Ok(());
    }
    Err(ModelError::new(format!(
        "body `{}`: its {} stations do not ascend from its start to its end: {stations:?} of its length",
        spec.label(),
        stations.len()
    )))
}

/// Refuses what refers to a repetition that is not there.
///
/// # Errors
/// Who refers to it, and the body with the range of its index.
pub(crate) fn check_instances(parts: &dyn Parts, bodies: &[BodySpec]) -> Result<(), ModelError> {
    let check = |user: &dyn Fn() -> String, body: usize| {
        if body < bodies.len() {
            return Ok(());
        }
        let Some(meant) = bodies.get(usize::MAX - body) else {
            return Err(ModelError::new(format!(
                "{} refers to a body that is not there",
                user()
            )));
        };
        let last = bodies.iter().filter(|other| other.kind == meant.kind).count() - 1;
        Err(ModelError::new(format!(
            "{} refers to a repetition of body `{}` that is not there: its index must be a whole number from 0 to {last}; an index that goes round is written with `%` and the count",
            user(),
            meant.name
        )))
    };
    for joint in parts.joints() {
        check(&|| format!("joint `{}`", joint.name), joint.body)?;
    }
    for share in parts.shares() {
        for (body, _) in share.ends {
            check(&|| format!("joint `{}`", share.name), body)?;
        }
    }
    for load in parts.loads() {
        if let LoadKind::Force { body, .. } | LoadKind::Moment { body, .. } = load.kind {
            check(&|| format!("load `{}`", load.name), body)?;
        }
    }
    for density in parts.densities() {
        check(&|| format!("load `{}`", density.name), density.body)?;
    }
    for fixture in parts.fixtures() {
        check(&|| format!("fixture `{}`", fixture.name), fixture.body)?;
    }
    for marker in parts.markers() {
        if let MarkerSpec::BodyPoint { body, .. }
        | MarkerSpec::SectionPoint { body, .. }
        | MarkerSpec::BodySlope { body, .. }
        | MarkerSpec::BodySection { body, .. }
        | MarkerSpec::InSection { body, .. }
        | MarkerSpec::SectionTurn { body, .. } = marker
        {
            check(&|| "a joint, force or output".to_string(), body)?;
        }
    }
    for observed in parts.observed() {
        if let ObservedSpec::Point { body, .. } | ObservedSpec::Section { body, .. } = observed {
            check(&|| "an output".to_string(), body)?;
        }
    }
    Ok(())
}
