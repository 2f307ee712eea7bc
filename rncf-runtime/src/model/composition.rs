//! What moves in a mode.

/// A kind of motion, of bodies that extend along a line and of rigid bodies; of those that turn about an axis off which
/// they are, the line is the way from the axis to the centre of mass, of others the axis itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Across the line, along the axis of the rotation (out of its plane).
    Flap,
    /// Across the line, in the plane of the rotation.
    Lag,
    /// Across a line that lies along the axis of the rotation: bending, shifting and tilting of a shaft.
    Lateral,
    /// Across the line where nothing turns.
    Bending,
    /// Of a rigid body where nothing turns: all but its rotation about x.
    Translation,
    /// About the line.
    Torsion,
    /// Along the line.
    Axial,
}

impl Motion {
    /// All, in the order of their numbers.
    pub const ALL: [Self; 7] = [
        Self::Flap,
        Self::Lag,
        Self::Lateral,
        Self::Bending,
        Self::Translation,
        Self::Torsion,
        Self::Axial,
    ];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flap => "flap",
            Self::Lag => "lag",
            Self::Lateral => "lateral",
            Self::Bending => "bending",
            Self::Translation => "rigid motion",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
        }
    }
}

/// Parts of the kinetic energy of a mode, as seen by an observer that turns with the system; each sum is 1, or nothing moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Composition {
    /// By kinds of motion, the largest first; those that take no part are left out.
    pub motions: Vec<(Motion, f64)>,
    /// By bodies and frames with mass, as declared.
    pub bodies: Vec<(String, f64)>,
}

/// Parts below this are round-off.
const NOTHING: f64 = 1e-9;

impl Composition {
    pub(crate) fn new(energies: &[f64], mut bodies: Vec<(String, f64)>) -> Self {
        let sum: f64 = energies.iter().sum();
        let mut motions: Vec<(Motion, f64)> = Motion::ALL
            .into_iter()
            .zip(energies)
            .map(|(motion, energy)| (motion, energy / sum))
            .filter(|&(_, part)| part > NOTHING)
            .collect();
        motions.sort_by(|a, b| b.1.total_cmp(&a.1));
        let sum: f64 = bodies.iter().map(|body| body.1).sum();
        bodies.iter_mut().for_each(|body| body.1 /= sum);
        if !(sum > 0.0 && sum.is_finite()) {
            bodies.clear();
        }
        Self { motions, bodies }
    }
}
