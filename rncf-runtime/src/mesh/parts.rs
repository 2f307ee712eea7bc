//! What the generator emits for one model, as the runtime sees it.

use super::frame::{FrameAction, FrameMotion};
use super::line::Line;
use crate::error::ModelError;
use crate::system::ConstraintLevel;

/// A meshed body.
#[derive(Clone, Debug)]
pub struct BodySpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Index of its declared frame.
    pub frame: usize,
    /// Frame axes of the components of its vectors: two for planar bodies, else three.
    pub axes: &'static [usize],
    /// Stress-free axis in the declared frame.
    pub line: Line,
    /// Number of elements.
    pub count: usize,
    /// Names of an element's nodal vectors by local number, e.g. `position`.
    pub meanings: &'static [&'static str],
    /// Order of each local vector: 0 position, 1 slope.
    pub orders: &'static [usize],
    /// Place of each local vector relative to the first vector of the element's first node.
    pub connectivity: &'static [usize],
    /// Number of vectors of a node.
    pub vectors_per_node: usize,
}

impl BodySpec {
    /// Components of a nodal vector.
    pub fn dimension(&self) -> usize {
        self.axes.len()
    }

    /// Degrees of freedom of one element.
    pub fn element_size(&self) -> usize {
        self.orders.len() * self.dimension()
    }

    /// Node and local number (of the node's first element) of a nodal vector, counted in the body.
    pub fn locate(&self, vector: usize) -> (usize, usize) {
        let place = vector % self.vectors_per_node;
        let local = self.connectivity.iter().position(|&other| other == place).unwrap_or(0);
        (vector / self.vectors_per_node, local)
    }

    /// Nodal vectors of the body.
    pub fn vectors(&self) -> usize {
        (self.count + 1) * self.vectors_per_node
    }
}

/// A place on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// First node.
    Start,
    /// Last node.
    End,
    /// Arclength of the stress-free axis, m.
    At(f64),
}

/// What a joint fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Position, and direction of the slope.
    Clamp,
    /// Position and slope.
    ClampFull,
    /// Position.
    Pin,
}

/// A joint between a body's end and a frame.
#[derive(Clone, Debug)]
pub struct JointSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// What it fixes.
    pub kind: JointKind,
    /// Body.
    pub body: usize,
    /// Whether it is at the body's end instead of its start.
    pub at_end: bool,
    /// Frame that it is fixed to.
    pub frame: usize,
    /// Fixed point in the joint's frame, m; `None`: where the undeformed body is at t = 0.
    pub point: Option<[f64; 3]>,
}

/// Constants of a joint, in its frame's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointData {
    /// Fixed point, m.
    pub point: [f64; 3],
    /// Direction of the slope, unit vector.
    pub tangent: [f64; 3],
    /// Unit vectors normal to it; planar bodies use the first, which lies in the plane.
    pub normals: [[f64; 3]; 2],
}

/// What an eliminated condition prescribes, in the body's axes: value, rate and acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Prescribed {
    /// Position, m, m/s, m/s^2.
    pub position: [[f64; 3]; 3],
    /// Slope.
    pub slope: [[f64; 3]; 3],
}

/// Kind of a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadKind {
    /// Uniform gravity on all bodies.
    Gravity,
    /// Force at a point.
    Force {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
    /// Moment at a point.
    Moment {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
    },
}

/// A load.
#[derive(Clone, Debug)]
pub struct LoadSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// What it is.
    pub kind: LoadKind,
    /// Frame whose axes its components refer to.
    pub frame: usize,
}

/// What is observed at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointQuantity {
    /// Position, m.
    Position,
    /// Velocity relative to the body's frame, m/s.
    Velocity,
    /// Slope dp/dx.
    Slope,
}

/// Something that outputs read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ObservedSpec {
    /// Component of a point, in the body's declared frame.
    Point {
        /// Body.
        body: usize,
        /// Where.
        at: Place,
        /// What.
        what: PointQuantity,
        /// Frame axis 0, 1, 2.
        component: usize,
    },
    /// Component of what a joint exerts on its body, in the joint's frame, about its point.
    Reaction {
        /// Joint.
        joint: usize,
        /// Moment instead of force.
        moment: bool,
        /// Frame axis 0, 1, 2.
        component: usize,
    },
}

/// One model, as emitted: specifications and kernels. Indices follow the order of the declaration;
/// frame 0 is the inertial one. `absolute` means that the body's vectors are in the inertial frame.
pub trait Parts: Clone + Send + Sync + 'static {
    /// Bodies.
    fn bodies(&self) -> Vec<BodySpec>;
    /// Joints.
    fn joints(&self) -> Vec<JointSpec>;
    /// Loads.
    fn loads(&self) -> Vec<LoadSpec>;
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

    /// Prepares what depends on the stress-free shape: nodal vectors of every element of a body, in
    /// local order, one element after the other.
    ///
    /// # Errors
    /// A material or section that makes no physical sense, by name.
    fn prepare(&mut self, body: usize, length: f64, shape: &[f64]) -> Result<(), ModelError>;

    /// Motion of every frame at `t`.
    fn frames(&self, t: f64, motions: &mut [FrameMotion]);
    /// Whether a load's components depend on time.
    fn load_varies(&self, load: usize) -> bool;
    /// Components of a load at `t`, in its frame's axes.
    fn load(&self, load: usize, t: f64) -> [f64; 3];

    /// Mass matrix of an element's vectors (scalars, rows first).
    fn mass(&self, body: usize, mass: &mut [f64]);
    /// Adds the elastic and inertia forces of one element.
    #[allow(clippy::too_many_arguments)]
    fn force(
        &self,
        body: usize,
        element: usize,
        absolute: bool,
        frame: &FrameAction,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        force: &mut [f64],
    );
    /// Adds their derivatives with respect to q and q'.
    #[allow(clippy::too_many_arguments)]
    fn tangent(
        &self,
        body: usize,
        element: usize,
        absolute: bool,
        frame: &FrameAction,
        q: &[f64],
        v: &[f64],
        stiffness: &mut [f64],
        damping: &mut [f64],
    );
    /// Strain energy of one element, J.
    fn energy(&self, body: usize, element: usize, q: &[f64]) -> f64;
    /// Shape functions of an element at `xi` in [0, 1] and their derivatives d/dx.
    fn shapes(&self, body: usize, xi: f64, values: &mut [f64], slopes: &mut [f64]);
    /// Adds the generalised force of a moment (N m, body axes; planar: first component) on a slope.
    fn moment(&self, dimension: usize, slope: &[f64], moment: [f64; 3], force: &mut [f64]);
    /// Adds its derivative with respect to the slope, rows first.
    fn moment_tangent(&self, dimension: usize, slope: &[f64], moment: [f64; 3], tangent: &mut [f64]);

    /// Conditions of a joint on the position and slope of its node: position rows, then direction or
    /// slope rows. `q`, `v`, `a` hold the position, then the slope.
    #[allow(clippy::too_many_arguments)]
    fn condition(
        &self,
        joint: usize,
        absolute: bool,
        level: ConstraintLevel,
        t: f64,
        data: &JointData,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        rows: &mut [f64],
    );
    /// Derivatives of the conditions with respect to position and slope, rows first.
    fn condition_jacobian(&self, joint: usize, absolute: bool, t: f64, data: &JointData, jacobian: &mut [f64]);
    /// What the joint prescribes where its conditions are eliminated.
    fn prescribed(&self, joint: usize, absolute: bool, t: f64, data: &JointData, prescribed: &mut Prescribed);

    /// Values of the output columns from what they observe.
    fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]);
}
