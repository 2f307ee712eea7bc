//! A scene as a tree: what it consists of, with all lengths and directions in inertial axes at t = 0.

/// A vector, inertial axes at t = 0.
pub type Vector = [f64; 3];
/// A matrix by rows.
pub type Matrix = [[f64; 3]; 3];

/// Axes (columns, inertial) and origin (m) of a frame at t = 0.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// From the frame's axes to inertial ones.
    pub axes: Matrix,
    /// Origin, m.
    pub origin: Vector,
}

impl Pose {
    /// Of the inertial frame.
    pub const INERTIAL: Pose = Pose {
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        origin: [0.0; 3],
    };

    /// A point in the frame's axes.
    pub fn local(&self, point: Vector) -> Vector {
        self.turned_back(subtract(point, self.origin))
    }

    /// A direction in the frame's axes.
    pub fn turned_back(&self, v: Vector) -> Vector {
        std::array::from_fn(|j| (0..3).map(|i| self.axes[i][j] * v[i]).sum())
    }
}

/// What a frame is.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Turns about an axis by `amplitude * (1 - cos(rate t))`, or, spinning from the start, `amplitude * sin(rate t)`.
    Rotating { amplitude: f64, rate: f64, spinning: bool },
    /// Is shifted along `way` by `1 - cos(rate t)`.
    Moving { way: Vector, rate: f64 },
    /// Moves freely and carries a body that it is tied to.
    Free,
    /// Rigid body: mass, centre (m, its own axes), inertia about the centre (its own axes).
    Rigid { mass: f64, center: Vector, inertia: Matrix },
}

/// A frame. The parent is an index, `None` inertial; `axis` is constant over all draws, in the axes of the parent.
#[derive(Clone, Debug)]
pub struct Frame {
    pub kind: Kind,
    pub parent: Option<usize>,
    pub axis: Vector,
    pub angle: f64,
    pub pose: Pose,
    /// Velocity of the origin at t = 0, m/s.
    pub velocity: Vector,
    /// Angular velocity at t = 0, rad/s.
    pub spin: Vector,
}

/// How a body in a free frame ties it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tie {
    None,
    Clamp,
    MeanAxes,
}

/// A straight flexible body.
#[derive(Clone, Debug)]
pub struct Body {
    pub frame: Option<usize>,
    pub is_cable: bool,
    pub from: Vector,
    pub direction: Vector,
    pub length: f64,
    pub elements: usize,
    pub radius: f64,
    /// Other side of a rectangle, where the section is one: `y = 2 radius`, `z = this`.
    pub side: Option<f64>,
    pub section_y: Option<Vector>,
    pub density: f64,
    pub young: f64,
    pub poisson: f64,
    pub damping: f64,
    pub exact_bending: bool,
    pub tie: Tie,
    /// Rigid motion at t = 0 (velocity of the origin, angular velocity), for bodies in inertial coordinates.
    pub moving: Option<(Vector, Vector)>,
}

/// Where something acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// The inertial frame at a point.
    Ground(Vector),
    /// A frame at a point.
    Frame(usize, Vector),
    /// A body at a fraction of its length.
    Body(usize, f64),
}

/// A joint by its word. Axes are in the axes of A and constant over all draws.
#[derive(Clone, Debug)]
pub struct Joint {
    pub word: &'static str,
    pub a: Place,
    pub b: Place,
    pub axis: Option<Vector>,
    pub cross: Option<Vector>,
    /// Drives the angle by `x * (1 - cos(y t))`.
    pub drive: Option<[f64; 2]>,
    /// Torsional stiffness and damping about it.
    pub coil: Option<[f64; 2]>,
}

/// A spring between two places.
#[derive(Clone, Debug)]
pub enum Spring {
    Linear {
        a: Place,
        b: Place,
        stiffness: f64,
        damping: f64,
        length: f64,
    },
    Law {
        a: Place,
        b: Place,
        cubic: f64,
        length: f64,
    },
    /// The same stiffness and damping in all directions; b is of a frame.
    Bushing {
        a: Place,
        b: Place,
        stiffness: f64,
        damping: f64,
    },
}

/// A load.
#[derive(Clone, Debug)]
pub enum Load {
    /// `force * sin(rate t)`, or constant for rate 0, in the axes of a frame.
    Force {
        at: Place,
        force: Vector,
        rate: f64,
        axes: Option<usize>,
    },
    Moment {
        at: Place,
        moment: Vector,
        rate: f64,
    },
    /// Along the tangent.
    Follower {
        at: Place,
        force: f64,
    },
    /// Constant load per length in the axes of the body's frame.
    Density {
        body: usize,
        force: Vector,
    },
}

/// A whole scene.
#[derive(Clone, Debug)]
pub struct Tree {
    pub seed: u64,
    pub draw: u64,
    pub plane: bool,
    pub frames: Vec<Frame>,
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    pub springs: Vec<Spring>,
    pub loads: Vec<Load>,
    pub gravity: Option<Vector>,
    pub t_end: f64,
}

impl Tree {
    /// Pose of a frame at t = 0.
    pub fn pose(&self, frame: Option<usize>) -> Pose {
        frame.map_or(Pose::INERTIAL, |frame| self.frames[frame].pose)
    }

    /// Where a place is at t = 0.
    pub fn point(&self, place: Place) -> Vector {
        match place {
            Place::Ground(point) | Place::Frame(_, point) => point,
            Place::Body(body, at) => {
                let body = &self.bodies[body];
                add(body.from, scaled(body.direction, at * body.length))
            }
        }
    }

    /// Whether a frame follows the mean axes of a body.
    pub fn follows_mean(&self, frame: usize) -> bool {
        self.bodies
            .iter()
            .any(|body| body.frame == Some(frame) && body.tie == Tie::MeanAxes)
    }

    /// The frame in whose axes a joint's axes are given, where A is this.
    pub fn axes_of(&self, place: Place) -> Option<usize> {
        match place {
            Place::Ground(_) => None,
            Place::Frame(frame, _) => Some(frame),
            Place::Body(body, _) => self.bodies[body].frame,
        }
    }
}

pub fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] + b[k])
}

pub fn subtract(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[k] - b[k])
}

pub fn scaled(a: Vector, x: f64) -> Vector {
    a.map(|a| a * x)
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

/// `A v`.
pub fn turned(a: &Matrix, v: Vector) -> Vector {
    std::array::from_fn(|i| (0..3).map(|j| a[i][j] * v[j]).sum())
}

/// `A B`.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// `A^T`.
pub fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// The rotation by an angle about an axis.
pub fn rotation(axis: Vector, angle: f64) -> Matrix {
    let n = scaled(axis, 1.0 / norm(axis));
    let (sin, cos) = angle.sin_cos();
    let spin = [[0.0, -n[2], n[1]], [n[2], 0.0, -n[0]], [-n[1], n[0], 0.0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let unit = if i == j { cos } else { 0.0 };
            unit + sin * spin[i][j] + (1.0 - cos) * n[i] * n[j]
        })
    })
}
