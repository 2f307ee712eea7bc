//! The free frames of a scene, what holds them, and what follows bodies.

use std::sync::Arc;

use super::free_frames::FreeFrame;
use super::ties::Tie;
use crate::scene::numbering::turned::TurnedColumns;
use crate::space::Vector;

/// The free frames of a scene. Ties and columns are found once the bodies are numbered.
#[derive(Default)]
pub struct SceneFrames {
    /// Free frames whose poses are unknown, ascending.
    pub free: Vec<FreeFrame>,
    /// For every frame its index among the free ones.
    pub free_of: Vec<Option<usize>>,
    /// What ties free frames to the bodies in them.
    pub ties: Vec<Tie>,
    /// Unknown frames that took over velocity and angular velocity (frame axes) of a body as a whole from its initial
    /// velocity.
    pub taken: Vec<(usize, [Vector; 2])>,
    /// Frames that are no unknowns where the bodies are absolute: those that follow bodies, and those that nothing needs.
    /// They stay at their start, but where outputs find their poses.
    pub fixed: Vec<FreeFrame>,
    /// What such frames follow, and the shape of all bodies that this refers to, in their declared frames.
    pub followed: Vec<Tie>,
    pub followed_shape: Vec<f64>,
    /// First unknowns of orientations.
    pub turns: Vec<usize>,
    /// Unknowns that are states.
    pub states: Vec<usize>,
    /// Columns of orientations on the pattern.
    pub turned: Arc<[TurnedColumns]>,
}
