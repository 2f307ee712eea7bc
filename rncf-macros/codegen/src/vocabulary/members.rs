//! The words that stand behind a dot, by what stands before it.

/// What a name or a word behind a dot stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thing {
    /// A flexible body.
    Body,
    /// A frame or rigid body.
    Frame,
    /// A place on a body, or a point of a frame.
    Place,
    /// A joint.
    Joint,
    /// A constraint of the model's own.
    Constraint,
    /// All that moves.
    Total,
    /// A vector.
    Vector,
}

/// A word behind a dot: itself, its meaning, and what it stands for where more may follow.
pub type Member = (&'static str, &'static str, Option<Thing>);

const VECTOR: Option<Thing> = Some(Thing::Vector);
const PLACE: Option<Thing> = Some(Thing::Place);

/// Names that are in sight of every model.
pub const GIVEN: &[Member] = &[
    ("inertial", "the frame that does not move", Some(Thing::Frame)),
    ("total", "all that moves", Some(Thing::Total)),
];

/// Places on a flexible body.
pub const PLACES: &[Member] = &[
    ("start", "first end of the axis", PLACE),
    ("end", "last end of the axis", PLACE),
    ("at", "place at an arclength of the stress-free axis, `at(1 m)`", PLACE),
];

/// What every point shows.
pub const OF_POINTS: &[Member] = &[
    ("x", "coordinate of the position, in m", None),
    ("y", "coordinate of the position, in m", None),
    ("z", "coordinate of the position, in m", None),
    (
        "velocity",
        "derivative of the position with respect to time, in m/s",
        VECTOR,
    ),
    ("position", "all coordinates of the position, in m", VECTOR),
    ("acceleration", "of the point in the inertial frame, in m/s^2", VECTOR),
];

/// What places on flexible bodies show in addition.
pub const OF_SECTIONS: &[Member] = &[
    (
        "beside",
        "place of the section beside the axis, `beside([0, 20, 0] mm)`",
        PLACE,
    ),
    (
        "slope",
        "derivative of the position with respect to the arclength",
        VECTOR,
    ),
    ("ey", "y axis of the section", VECTOR),
    ("ez", "z axis of the section", VECTOR),
    ("axial_force", "force along the axis, tension is positive, in N", None),
    ("shear_y", "force along the y axis of the section, in N", None),
    ("shear_z", "force along the z axis of the section, in N", None),
    ("torque", "moment about the axis, in N m", None),
    ("moment_y", "moment about the y axis of the section, in N m", None),
    ("moment_z", "moment about the z axis of the section, in N m", None),
    ("moment", "bending moment of a centre line, in N m", None),
    ("stress", "largest von Mises stress over the section, in Pa", None),
];

/// What frames and rigid bodies show beside what their origins show.
pub const OF_FRAMES: &[Member] = &[
    ("at", "a point of it, `at([1, 0, 0] m)`", PLACE),
    ("center", "centre of mass of a rigid body", PLACE),
    ("ex", "x axis, a unit vector", VECTOR),
    ("ey", "y axis, a unit vector", VECTOR),
    ("ez", "z axis, a unit vector", VECTOR),
    ("direction", "a unit vector fixed in it, `direction([1, 1, 0])`", VECTOR),
    ("angle", "angle of a frame that turns about one axis, in rad", None),
    ("speed", "derivative of that angle with respect to time, in rad/s", None),
    ("angular_velocity", "in its own axes, in rad/s", VECTOR),
];

/// What joints show.
pub const OF_JOINTS: &[Member] = &[
    ("force", "what the joint exerts, in N", VECTOR),
    ("moment", "its moment about the point of the joint, in N m", VECTOR),
    ("angle", "angle of the joint, in rad", None),
    ("slide", "shift of the joint, in m", None),
];

/// What constraints show.
pub const OF_CONSTRAINTS: &[Member] = &[("multiplier", "Lagrange multiplier", None)];

/// Sums over what moves.
pub const BALANCES: &[Member] = &[
    ("mass", "in kg", None),
    ("momentum", "of velocities in the inertial frame, in kg m/s", VECTOR),
    ("angular_momentum", "about the inertial origin, in kg m^2/s", VECTOR),
    ("center_of_mass", "in the inertial frame, in m", VECTOR),
    ("kinetic_energy", "of all motion, in J", None),
    ("strain_energy", "of the elements, in J", None),
    (
        "gravity_energy",
        "potential of the weight, zero at the inertial origin, in J",
        None,
    ),
];

/// Components of a vector.
pub const COMPONENTS: &[Member] = &[
    ("x", "component along x", None),
    ("y", "component along y", None),
    ("z", "component along z", None),
];

impl Thing {
    /// All of them.
    pub const ALL: [Thing; 7] = [
        Thing::Body,
        Thing::Frame,
        Thing::Place,
        Thing::Joint,
        Thing::Constraint,
        Thing::Total,
        Thing::Vector,
    ];

    /// What the word in front of a declared name, or behind the colon of an argument, makes of it.
    pub fn of(keyword: &str) -> Option<Thing> {
        match keyword {
            "body" => Some(Thing::Body),
            "frame" | "rigid" => Some(Thing::Frame),
            "joint" => Some(Thing::Joint),
            "constraint" => Some(Thing::Constraint),
            "place" => Some(Thing::Place),
            _ => None,
        }
    }

    /// The words that may stand behind its dot.
    pub fn members(self) -> impl Iterator<Item = Member> {
        let lists: &[&[Member]] = match self {
            Thing::Body => &[PLACES, BALANCES],
            Thing::Frame => &[OF_FRAMES, OF_POINTS, BALANCES],
            Thing::Place => &[OF_POINTS, OF_SECTIONS],
            Thing::Joint => &[OF_JOINTS],
            Thing::Constraint => &[OF_CONSTRAINTS],
            Thing::Total => &[BALANCES],
            Thing::Vector => &[COMPONENTS],
        };
        lists.iter().flat_map(|list| list.iter().copied())
    }

    /// What a word behind its dot stands for.
    pub fn then(self, word: &str) -> Option<Thing> {
        self.members().find(|(member, ..)| *member == word)?.2
    }
}

/// The words of a list.
pub fn words(list: &'static [Member]) -> impl Iterator<Item = &'static str> {
    list.iter().map(|(word, ..)| *word)
}
