//! What the generator emits for one model, as the runtime sees it.

use super::conditions::{JointConditions, MarkerConstraints};
use super::elements::{Bodies, ConservingForces, TimedEnergies};
use super::forces::{
    Densities, DistributedLoads, GravityFields, Loads, MarkerForces, PlacedGravity, SectionMoments, SlopeMoments,
};
use super::frame::FrameMotion;
use super::free::FreeSpec;
use super::markers::MarkerSpec;
use super::observed::ObservedSpec;
use crate::course::Courses;
use crate::error::ModelError;

/// One model, as emitted: specifications and kernels. Indices follow the order of the declaration;
/// frame 0 is the inertial one. `absolute` means that the body's vectors are in the inertial frame.
///
/// No method has a body here, so that what is forgotten does not compile. What a model has nothing of it says with
/// `Without..`: its lists are then empty, and the kernels of what they would hold are not called.
pub trait Parts:
    Bodies
    + ConservingForces
    + TimedEnergies
    + JointConditions
    + Loads
    + SlopeMoments
    + SectionMoments
    + MarkerConstraints
    + MarkerForces
    + Densities
    + DistributedLoads
    + PlacedGravity
    + GravityFields
    + Send
    + Sync
    + 'static
{
    /// What outputs read, in the order of [`Parts::outputs`]'s argument.
    fn observed(&self) -> Vec<ObservedSpec>;
    /// Number of output columns.
    fn output_columns(&self) -> usize;
    /// Number of frames, the inertial one included.
    fn frame_count(&self) -> usize;
    /// Name of a frame.
    fn frame_name(&self, frame: usize) -> &'static str;
    /// Whether energy is conserved: nothing moves or acts in a prescribed way, nothing damps.
    fn conservative(&self) -> bool;
    /// Times at which a derivative of a motion or load may jump, s.
    fn kinks(&self) -> Vec<f64>;
    /// Appends the gaps (left less right side) of conditions in motions and loads that time decides in another way than
    /// by [`Parts::kinks`], at time `t`, s, and their time derivatives.
    fn gaps(&self, t: f64, out: &mut Vec<[f64; 2]>);
    /// What motions and loads do over time, and constraints, fields and loads over the markers that they read, that a step could jump over.
    fn courses(&self) -> Vec<Courses>;
    /// Motion of every prescribed frame at `t`, jerks included where there are constraints on
    /// markers or mean axes; entries of free frames are not read.
    fn frames(&self, t: f64, motions: &mut [FrameMotion]);
    /// Why there are no forces between two states that conserve energy: a sentence without its end; `None` where
    /// [`ConservingForces::conserving_force`] does.
    fn conserving_obstacle(&self) -> Option<&'static str>;
    /// Values of the output columns from what they observe.
    fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]);
    /// Checks mass and inertia of rigid parts that depend on parameters.
    ///
    /// # Errors
    /// A mass or inertia that no body has, by name.
    fn check(&self) -> Result<(), ModelError>;
    /// Free frames, ascending.
    fn free(&self) -> Vec<FreeSpec>;
    /// Markers.
    fn markers(&self) -> Vec<MarkerSpec>;
}
