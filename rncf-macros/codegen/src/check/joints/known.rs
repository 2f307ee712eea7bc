//! What other items need to know of a joint.

use crate::check::bodies::body;
use crate::joints::{Kind, Party};
use crate::model::{ConstraintId, FrameId, JointId, JointKind};

/// What other items need to know of a joint; `None`: reported, or not of this sort.
#[derive(Clone, Debug)]
pub struct Known {
    pub id: JointId,
    /// Of an eliminated one.
    pub kind: Option<JointKind>,
    pub body: Option<body::Known>,
    pub frame: Option<FrameId>,
    /// Of one with multipliers.
    pub built: Option<Built>,
    pub is_repeated: bool,
    /// Whether it is a shared node, and no condition.
    pub is_share: bool,
}

/// A joint with multipliers.
#[derive(Clone, Debug)]
pub struct Built {
    pub constraint: ConstraintId,
    /// Its word in the language.
    pub word: String,
    /// Of the library; `None`: a clamp or drive.
    pub kind: Option<&'static Kind>,
    pub parties: [Party; 2],
    pub normal: Option<usize>,
    pub axis: [f64; 3],
    pub has_moment: bool,
    /// Whether the second party stands first: the first one is prescribed and has no markers.
    pub is_reversed: bool,
}
