//! What large scenes need of a model: shared nodes, starts in equilibrium, loads per length.

/// Elements that are evaluated side by side.
pub const LANES: usize = 4;

/// Two ends of bodies in one frame that are one node.
#[derive(Clone, Debug)]
pub struct ShareSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// The ends: body, and whether it is the body's end instead of its start.
    pub ends: [(usize, bool); 2],
    /// Whether all nodal vectors are one, else the position alone.
    pub smooth: bool,
}

/// The bodies of a frame start in relative equilibrium with its uniform rotation, without loads.
#[derive(Clone, Debug)]
pub struct StartSpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Frame.
    pub frame: usize,
    /// Angular velocity, rad/s, frame axes; `None`: that of the frame at t = 0.
    pub spin: Option<[f64; 3]>,
}

/// A load per length on one body.
#[derive(Clone, Debug)]
pub struct DensitySpec {
    /// Name in the declaration.
    pub name: &'static str,
    /// Index of its declaration: densities of one kind share kernels.
    pub kind: usize,
    /// Body.
    pub body: usize,
    /// Markers that its values depend on.
    pub markers: &'static [usize],
    /// Number of its values.
    pub values: usize,
}

/// Global number of a repetition: `first` is that of the first of `count`; where there is no such one, a number
/// that no body has.
pub fn instance(first: usize, count: usize, number: f64) -> usize {
    if number == number.trunc() && (0.0..count as f64).contains(&number) {
        first + number as usize
    } else {
        usize::MAX
    }
}
