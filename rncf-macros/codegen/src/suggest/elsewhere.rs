//! Words of other programs and of textbooks, and what they are called in the language.

/// A word, and those that may be meant by it; where it stands only some of them make sense.
#[rustfmt::skip]
const WORDS: &[(&str, &[&str])] = &[
    // Items.
    ("fn", &["motion"]), ("func", &["motion"]), ("function", &["motion"]), ("def", &["motion", "component"]),
    ("var", &["param"]), ("variable", &["param"]), ("parameter", &["param"]), ("parameters", &["param"]),
    ("float", &["param"]), ("real", &["param"]), ("double", &["param"]),
    ("int", &["count", "param"]), ("integer", &["count", "param"]), ("usize", &["count", "param"]), ("number", &["count"]),
    ("damper", &["damping", "linear", "spring"]), ("dashpot", &["damping", "linear", "spring"]),
    ("sensor", &["output"]), ("probe", &["output"]), ("print", &["output"]), ("measure", &["output"]),
    ("weight", &["gravity", "load"]), ("simulation", &["run"]), ("simulate", &["run"]), ("solver", &["run"]),
    ("support", &["joint"]), ("boundary", &["joint"]), ("connect", &["joint"]), ("connector", &["joint"]),
    ("rigid_body", &["rigid"]), ("flexible", &["body"]), ("profile", &["section"]), ("repeat", &["for"]),
    ("mass", &["fixture", "rigid"]), ("point_mass", &["fixture", "rigid"]), ("parts", &["part"]), ("module", &["component"]),
    // What stands inside of an item: `gravity([0, -9.81, 0] m/s^2)` without `load weight =`.
    ("revolute", &["joint"]), ("pin", &["joint"]), ("clamp", &["joint"]), ("weld", &["joint"]), ("spherical", &["joint"]), ("universal", &["joint"]),
    ("prismatic", &["joint"]), ("cylindrical", &["joint"]), ("distance", &["joint"]), ("coordinate", &["spring"]), ("hold", &["joint"]), ("drive", &["joint"]),
    ("circle", &["section"]), ("rectangle", &["section"]), ("tube", &["section"]), ("distributed", &["load"]), ("bushing", &["spring"]),
    ("torsional", &["spring"]), ("linear", &["spring"]), ("hinged", &["frame"]), ("moving", &["frame"]), ("rotating", &["frame"]), ("free", &["frame"]),
    ("planar", &["body"]), ("spatial", &["body"]), ("line", &["body"]), ("mesh", &["body"]), ("chord", &["body"]), ("mean_axes", &["body"]),
    // Joints.
    ("hinge", &["revolute", "pin", "hinged"]), ("pivot", &["revolute", "pin", "hinged"]),
    ("rotational", &["revolute", "torsional"]), ("rotary", &["revolute"]), ("pinned", &["pin"]),
    ("fixed", &["clamp", "weld", "moving", "inertial"]), ("fix", &["clamp", "weld", "moving"]), ("rigid", &["clamp", "weld"]),
    ("cantilever", &["clamp"]), ("encastre", &["clamp"]), ("built_in", &["clamp"]), ("glue", &["weld"]),
    ("ball", &["spherical"]), ("ball_joint", &["spherical"]), ("spherical_joint", &["spherical"]), ("socket", &["spherical"]),
    ("slider", &["prismatic"]), ("sliding", &["prismatic"]), ("slide", &["prismatic"]), ("translational", &["prismatic"]),
    ("hooke", &["universal"]), ("cardan", &["universal"]), ("gimbal", &["universal"]), ("roller", &["hold"]),
    ("rod", &["distance", "cable"]), ("link", &["distance", "body"]), ("motor", &["drive"]), ("actuator", &["drive"]),
    // Materials and sections.
    ("E", &["young"]), ("modulus", &["young"]), ("youngs_modulus", &["young"]), ("young_modulus", &["young"]),
    ("elastic_modulus", &["young"]), ("elasticity", &["young"]), ("nu", &["poisson"]), ("poissons_ratio", &["poisson"]),
    ("poisson_ratio", &["poisson"]), ("rho", &["density"]), ("yield_stress", &["yield"]), ("yield_strength", &["yield"]),
    ("A", &["area"]), ("I", &["inertia", "second_moment"]), ("Iy", &["second_moment_y"]), ("Iz", &["second_moment_z"]),
    ("Iyy", &["second_moment_y"]), ("Izz", &["second_moment_z"]), ("J", &["inertia", "torsion_constant"]),
    ("moment_of_inertia", &["inertia", "second_moment"]), ("kappa", &["shear_factor"]),
    ("r", &["radius"]), ("diameter", &["radius"]), ("outer", &["radius"]), ("outer_radius", &["radius"]), ("wall", &["thickness"]),
    // Rigid bodies, frames, springs, runs.
    ("m", &["mass"]), ("position", &["origin"]), ("pos", &["position", "origin"]), ("omega", &["angular_velocity", "speed"]),
    ("com", &["center", "center_of_mass"]), ("cm", &["center", "center_of_mass"]), ("cog", &["center", "center_of_mass"]),
    ("center_of_gravity", &["center", "center_of_mass"]), ("v", &["velocity"]), ("acc", &["acceleration"]),
    ("ground", &["inertial", "clamp", "weld"]), ("world", &["inertial"]), ("global", &["inertial"]),
    ("rotate", &["rotating"]), ("rotation", &["rotating", "angle"]), ("spin", &["rotating", "angular_velocity"]),
    ("translate", &["moving"]), ("translating", &["moving"]), ("translation", &["moving"]), ("floating", &["free"]),
    ("spring", &["linear"]), ("nonlinear", &["law"]), ("torsion", &["torsional"]), ("k", &["stiffness"]), ("c", &["damping"]),
    ("gear", &["coordinate", "constraint"]), ("gears", &["coordinate", "constraint"]), ("l0", &["length"]), ("L0", &["length"]), ("rest_length", &["length"]), ("free_length", &["length"]),
    ("dt", &["every"]), ("step", &["every"]), ("time_step", &["every"]), ("timestep", &["every"]), ("interval", &["every"]),
    ("end", &["t_end"]), ("tend", &["t_end"]), ("end_time", &["t_end"]), ("final_time", &["t_end"]), ("duration", &["t_end"]),
    ("time", &["t", "t_end"]),
    // Bodies, loads, places and what is seen of them.
    ("section", &["mesh"]), ("material", &["mesh"]), ("elements", &["mesh"]), ("element", &["mesh"]), ("plane", &["planar"]), ("axis", &["line"]),
    ("timoshenko", &["beam"]), ("reissner", &["beam"]), ("euler_bernoulli", &["cable"]), ("bernoulli", &["cable"]),
    ("truss", &["cable"]), ("bar", &["cable"]), ("rope", &["cable"]), ("string", &["cable"]),
    ("torque", &["moment", "load"]), ("force", &["load"]), ("moment", &["load"]), ("gravity", &["load"]),
    ("pressure", &["distributed"]), ("line_load", &["distributed"]), ("point", &["force"]), ("point_load", &["force"]),
    ("left", &["start"]), ("first", &["start"]), ("begin", &["start"]), ("base", &["start"]),
    ("right", &["end"]), ("tip", &["end"]), ("last", &["end"]), ("middle", &["at"]), ("mid", &["at"]), ("node", &["at"]),
    ("displacement", &["position"]), ("deflection", &["position"]), ("tension", &["axial_force"]),
    ("normal_force", &["axial_force"]), ("bending_moment", &["moment"]), ("von_mises", &["stress"]), ("sigma", &["stress"]),
    ("theta", &["angle"]), ("phi", &["angle"]), ("orientation", &["angle", "slope"]), ("speed", &["velocity"]),
];

/// The valid words that mean elsewhere what this one does.
pub fn synonyms<'a>(word: &str, valid: &[&'a str]) -> Vec<&'a str> {
    // One letter is another symbol in the other case.
    let is_same = |other: &str| other == word || word.len() > 1 && other.eq_ignore_ascii_case(word);
    let Some((_, own)) = WORDS.iter().find(|(other, _)| is_same(other)) else {
        return transposed(word, valid).into_iter().collect();
    };
    let known = |own: &&str| valid.iter().find(|word| *word == own).copied();
    own.iter().filter_map(known).collect()
}

/// `K12` of `K21`: the entry of a symmetric matrix is called after its row in the upper triangle.
fn transposed<'a>(word: &str, valid: &[&'a str]) -> Option<&'a str> {
    let mut letters = word.chars();
    let (name, row, column) = (letters.next()?, letters.next()?, letters.next()?);
    let is_entry = row.is_ascii_digit() && column.is_ascii_digit() && letters.next().is_none();
    let other = format!("{name}{column}{row}");
    valid.iter().find(|entry| is_entry && **entry == other).copied()
}
