//! Indices into the lists of a model, and names in generated code.

macro_rules! index {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub usize);
    };
}

index!(/** Index into `Model::params`. */ ParamId);
index!(/** Index into `Model::motions`. */ MotionId);
index!(/** Index into `Model::frames`; 0 is the inertial frame. */ FrameId);
index!(/** Index into `Model::bodies`. */ BodyId);
index!(/** Index into `Model::joints`. */ JointId);
index!(/** Index into `Model::markers`. */ MarkerId);
index!(/** Index into `Model::constraints`. */ ConstraintId);
index!(/** Index into `Model::repeats`. */ RepeatId);
index!(/** Index into `Model::tables`. */ TableId);
index!(/** Index into the element library's elements. */ ElementId);

/// The inertial frame, always first.
pub const INERTIAL: FrameId = FrameId(0);

/// A name as it stands in identifiers of generated code: `blade[1].rod` as `blade_1_rod`.
pub fn identifier(name: &str) -> String {
    name.replace("].", "_")
        .replace(['[', '.'], "_")
        .replace("]_", "_")
        .replace(']', "")
}
