//! Joints that are declared open. An equilibrium closes them, wherever that leads; a run refuses such a start.

use crate::error::{Short, is_of_drive};
use crate::integrate::far_off;
use crate::model::{Scene, Uniform};

/// One sentence where bodies do not stand where a joint holds them.
pub fn closed(scene: &mut dyn Scene) -> Option<String> {
    let start = scene.uniform_guess(&Uniform::at_rest(0.0).scaled(0.0));
    let (size, row) = far_off(scene, &start)?;
    let what = scene.describe_constraint(row);
    // What a drive prescribes, equilibria take to where it is.
    (!is_of_drive(&what)).then(|| {
        format!(
            "The bodies are declared where {what} is open, by {}: what is told here is of the machine with this closed, whose bodies have moved there; a run refuses such a start. Declare the bodies where they are joined.",
            Short(size)
        )
    })
}
