//! Words behind a dot for what bodies have as a whole, and for what their sections carry.

use crate::model::{About, BalanceQuantity, SectionQuantity};

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// The word that only a particle of a distributed load has.
pub const PARTICLE: &str = "velocity";

/// All that moves.
pub const TOTAL: &str = "total";

const ENERGY: [i8; 6] = [2, 1, -2, 0, 0, 0];

/// Sums over what moves: words, what they mean, and their dimension.
pub const BALANCES: &[(&str, BalanceQuantity, [i8; 6])] = &[
    ("mass", BalanceQuantity::Mass, [0, 1, 0, 0, 0, 0]),
    ("momentum", BalanceQuantity::Momentum, [1, 1, -1, 0, 0, 0]),
    (
        "angular_momentum",
        BalanceQuantity::AngularMomentum(About::Origin),
        [2, 1, -1, 0, 0, 0],
    ),
    ("center_of_mass", BalanceQuantity::CenterOfMass, [1, 0, 0, 0, 0, 0]),
    ("kinetic_energy", BalanceQuantity::KineticEnergy, ENERGY),
    ("strain_energy", BalanceQuantity::StrainEnergy, ENERGY),
    ("gravity_energy", BalanceQuantity::GravityEnergy, ENERGY),
];

/// Whether a word asks for a sum over what moves.
pub fn is_balance(word: &str) -> bool {
    BALANCES.iter().any(|(known, ..)| *known == word)
}

/// The words of such sums, for suggestions.
pub fn balance_words() -> impl Iterator<Item = &'static str> {
    BALANCES.iter().map(|(word, ..)| *word)
}

const FORCE: [i8; 6] = [1, 1, -2, 0, 0, 0];
const MOMENT: [i8; 6] = [2, 1, -2, 0, 0, 0];
const STRESS: [i8; 6] = [-1, 1, -2, 0, 0, 0];

/// What sections carry: words, what they mean, and their dimension.
pub const CARRIED: &[(&str, SectionQuantity, [i8; 6])] = &[
    ("axial_force", SectionQuantity::AxialForce, FORCE),
    ("shear_y", SectionQuantity::ShearY, FORCE),
    ("shear_z", SectionQuantity::ShearZ, FORCE),
    ("torque", SectionQuantity::Torque, MOMENT),
    ("moment_y", SectionQuantity::MomentY, MOMENT),
    ("moment_z", SectionQuantity::MomentZ, MOMENT),
    ("moment", SectionQuantity::Moment, MOMENT),
    ("stress", SectionQuantity::Stress, STRESS),
];

/// Whether a word behind a place asks for what its section carries.
pub fn is_carried(word: &str) -> bool {
    CARRIED.iter().any(|(known, ..)| *known == word)
}
