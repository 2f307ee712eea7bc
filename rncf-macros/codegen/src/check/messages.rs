//! What is said about a declaration that makes no sense: what is wrong, and what would be right.

pub use super::messages_along::*;
pub use crate::messages::{
    beyond_repetitions, duplicate, index_outside, meaning_of_its_own, negative_repetition, not_a_number, not_ascii,
    not_repeated, runs_out,
};
pub use crate::suggest::a;

pub const IMPORT_REPEATED: &str = "a body from a file is not repeated yet: declare it once for each place";
pub const NEGATIVE_DAMPING: &str = "damping is not negative";
pub const LONG_CHAIN: &str = "too many names are defined by each other: shorten the chain";
pub const NO_TIME: &str = "`t` has no meaning here: only motions, frames, drives, constraints, forces, outputs and the energies of elements change with time";
pub const LONE_T: &str = "`t` is time: a product is written `2*t`; tonnes stand in brackets, `2 [t]`";
pub const DIVISION_BY_ZERO: &str = "this is zero, and nothing can be divided by it";
pub const TOO_DEEP: &str = "this is nested too deeply together with the names that it uses: shorten it";
pub const NOT_FINITE: &str = "this has no finite value";
pub const VANISHES: &str = "this is too small a number: something of it is rounded to zero";
pub const EXPONENT_RANGE: &str = "the exponent of this unit is too large to make sense";
pub const WHOLE_EXPONENTS: &str = "a parameter needs a unit with whole exponents";
pub const VECTOR_IN_EXPRESSION: &str = "a vector has no place in an expression: write one expression per component";
pub const ACCELERATION: &str = "an acceleration is known when all that acts is: only an `output` can observe it; what resists one is a mass, `fixture`, and a sensor is a small `rigid` on a spring and a damper";
pub const HERTZ: &str = "hertz and `1/min` count cycles and are no angular velocity: write `rad/s`, `rpm` or `deg/s`, or `2*pi` times the frequency";
pub const ANGLE_IN_HERTZ: &str = "hertz and `1/min` count cycles, and this is an angle or angular velocity: tell it in `rad/s`, `rpm` or `deg/s`, or divide it by `2*pi`";
pub const CYCLES_AS_ANGLE: &str =
    "this counts cycles, and a cycle is no unit of angle: tell it in `Hz`, or multiply it by `2*pi`";
pub const DAMPING_TIME: &str = "no solid answers so slowly: `damping` is the time c of the stress `E (strain + c rate)`, for metals about 1e-6 s to 1e-3 s";
pub const NOT_A_COUNT: &str =
    "a number of elements is a whole number of at least 1: write e.g. `6`, or a `param n: count = 6;`";
pub const COUNT_OF_COUNTS: &str = "this is not a whole number for every value of its params: a count is made of whole numbers and `count` params with `+`, `-` and `*`";
pub const CONDITION: &str = "a condition must not depend on the state: `t`, params and constants decide, e.g. `t <= T` or `sin(omega*t) > 0`; a force on one side is written with `max`, e.g. `stiffness * max(0 m, -ball.y)`";
pub const CONDITION_ALONG: &str = "an initial shape, a curve and a property along an axis are smooth functions of their variable: cases cannot depend on that, only on parameters; a `table` may have steps";
pub const INITIAL_WITHOUT_TIME: &str = "an initial shape is a function of `x` alone: leave out motions";
pub const FRAME_EXPECTED: &str = "the name of a frame is expected here, e.g. `inertial`";
pub const AXIS_CONSTANT: &str = "an axis is constant: use `x`, `y`, `z`, numbers or constants";
pub const AXIS_ZERO: &str = "this axis has no direction";
pub const ZERO_LENGTH: &str = "this line has no length: its start and end are the same point";
pub const ZERO_ANGLE: &str = "this arc has no length: its angle is zero";
pub const ZERO_DIRECTION: &str = "this vector has no direction";
pub const MISSING_NORMAL: &str =
    "an arc in space needs the normal of its plane: `arc from [..] m direction [..] normal [0, 0, 1] radius ..`";
pub const CURVED_IN_SPACE: &str = "in space a centre line alone does not know which way it is curved: use the beam with a cross-section, or declare the body planar";
pub const CORNER_OF_LINE: &str = "in space a corner keeps the sections of both sides, and a centre line has none: mesh the body with `beam`, or declare its straight pieces as bodies of their own";
pub const CORNER_WITHOUT_SLOPE: &str = "a corner keeps the slopes of both sides, and the element of this body has none: take an element with `r_x` at its ends, or declare the straight pieces as bodies that `share` their ends";
pub const NO_SLOPE: &str = "the element of this body has positions at its nodes and no slope that could be held: use `pin`, or an element with `r_x` at its ends";
pub const NORMAL_ALONG: &str = "this is along the direction of the arc: the normal stands across the arc's plane";
pub const SECTION_Y_ALONG: &str =
    "this is along the axis at its start: the section's y axis is a direction across the axis";
pub const THICKNESS: &str = "the wall of a tube must be thinner than its radius: a full one is a `circle`";
pub const ENERGY_WITHOUT_TIME: &str = "the energy of a material is a function of the strain alone: leave out motions";
pub const CONDITION_OF_STRAIN: &str =
    "the energy of a material is one smooth function of the strain: its cases cannot depend on it, only on parameters";
pub const CONDITION_OF_ELEMENT: &str = "`t` and params decide the cases of an element's energy: write a law of the strain as one formula, e.g. with `sqrt(e^2 + d^2)`";
pub const WHOLE_STRAIN: &str =
    "`E` is the strain: take a component of it, `E.xx`, `E.yy`, `E.zz`, `E.xy`, `E.xz` or `E.yz`";
pub const GAUSS_POINTS: &str = "`gauss` takes a literal number of points, from 1 to 20: `gauss(3)`";
pub const STATE_OUTSIDE: &str = "a state is known while a model runs: forces and moments at places, laws of springs, rates of states and outputs read it";
pub const STATE_SIZE: &str =
    "the size of a state is positive: what counts as much of it, against which its errors are measured";
pub const POISSON: &str = "poisson must lie between -1 and 0.5";
pub const JOINT_INSIDE: &str =
    "this joint holds an end of a body: use `start` or `end`, and in between `weld` or `spherical`";
pub const HOLD_NOT_REPEATED: &str =
    "in a loop `hold` is for positions of ends: hold axes of sections, and places in between, outside of the loop";
pub const SLOPE_SHEARS: &str = "the slope of a body with cross-sections shears against the section, and without limit where it is held: use the section's axes, `ey` and `ez`";
pub const PLACE_EXPECTED: &str = "a place on a body is expected here: `beam.start`, `beam.end` or `beam.at(4 m)`";
pub const BESIDE_LINE: &str =
    "a centre line has no section that a place beside it could be fixed in: weld a `rigid` body to it, or use a `beam`";
pub const BESIDE_ALONG: &str = "a place beside the axis lies in the section: its first component is a literal 0, another place along the axis is `beam.at(..)`";
pub const BESIDE_PLANE: &str =
    "the section of a planar body has one axis: the third component of `beside` is a literal 0";
pub const BESIDE_TWICE: &str = "this place is beside the axis already: add both distances in one `beside`";
pub const BESIDE_CARRIED: &str = "forces, moments and stresses are those of a whole section: ask the place on the axis";
pub const TORSION: &str = "a moment along the axis would twist the body, and a centre line carries no torsion: use components across the axis";
pub const OBSERVED_OUTSIDE_OUTPUT: &str =
    "what bodies and joints do is known in outputs, constraints, springs and loads alone: write it there";
pub const NOTHING_OBSERVED: &str =
    "this observes nothing: write e.g. `beam.end.x`, `beam.at(4 m).velocity.y` or `root.moment.z`";
pub const PRODUCT_OF_VECTORS: &str = "both are vectors: write `dot(a, b)` or `cross(a, b)`";
pub const DIVISION_BY_VECTOR: &str = "nothing can be divided by a vector: take its `norm(..)`";
pub const THREE_COMPONENTS: &str = "a vector has three components `[x, y, z]`";
pub const PART_OF_LENGTH: &str = "this place is not on the body: parts of its length go from 0 to 1";
pub const RIGID_PLACE: &str =
    "a place on a frame or rigid body is expected here: `arm`, `arm.at([1, 0, 0] m)` or `arm.center`";
pub const PLANAR_AND_SPATIAL: &str = "one of the two moves in a plane and the other one in space or another plane: give both the same `plane`, or make both spatial";
pub const SAME_PARTY: &str = "both are the same: a joint or spring holds two different things";
pub const BOTH_PRESCRIBED: &str = "both move in a prescribed way: between them nothing is left to a joint or spring";
pub const CROSS_NOT_NORMAL: &str = "the two axes of a `universal` must be perpendicular";
pub const COORDINATE_EXPECTED: &str =
    "a coordinate is expected here: `hinge.angle`, `slider.slide` or, of a planar or hinged frame, `arm.angle`";
pub const ANGLE_OF_END: &str = "a centre line has a tangent and no angle of its own: use e.g. `atan2(beam.end.slope.y, beam.end.slope.x)` in an output";
pub const IN_TWICE: &str =
    "`.in(FRAME)` stands once, right behind the place or direction: `beam.end.in(inertial).velocity`";
pub const INERTIAL_ACCELERATION: &str =
    "an acceleration is known in the inertial frame: write `.in(inertial).acceleration`";
pub const RIGID_SLOPE: &str = "only flexible bodies have a slope: use a direction such as `arm.ex`";
pub const NOTHING_CONSTRAINED: &str =
    "nothing that moves freely stands in this: a constraint ties positions, directions or angles";
pub const EVERY_BEYOND: &str =
    "the time between rows is longer than the run: no row would lie between its begin and its end";
pub const NOTHING_SPRUNG: &str =
    "nothing that moves freely stands in this: the coordinate of a spring is made of positions, directions or angles";
pub const COORDINATE_IS_VECTOR: &str =
    "the coordinate of a spring is one number: take a component, or give each its own spring";
pub const SPRING_LENGTH: &str = "this spring needs its length without force: `length = 1 m`";
pub const BUSHING_AXES: &str = "the second place of a bushing gives the axes, and a centre line has none: use a frame, a rigid body or a body with cross-sections, e.g. `inertial.at([1, 0, 0] m)`";
pub const BUSHING_ANGLES: &str = "a centre line has no angles for this bushing: use a body with cross-sections, or leave out `rotational_stiffness`, `rotational_damping` and `coupling`";
pub const BUSHING_OF_NOTHING: &str = "this bushing does nothing: give it e.g. `stiffness = [0, 3e6, 3e6] N/m` or `rotational_stiffness = [0, 200, 200] N*m/rad`";
pub const TORSIONAL_EXPECTED: &str =
    "the name of a joint with an angle, or of a planar or hinged frame, is expected here";
pub const FORCE_ON_PRESCRIBED: &str = "this place moves in a prescribed way: a load on it would do nothing";
pub const FOLLOWER_ON_FRAME: &str =
    "a follower goes along the tangent of a flexible body: on a frame write `force(arm.at(..), [..] N, in = arm)`";
pub const FOLLOWER_COMPONENTS: &str =
    "a follower has one component along the tangent, and in a plane a second one across it: `[1 N, 2 N]`";
pub const FOLLOWER_IN_SPACE: &str =
    "in space nothing says where across the tangent is: give the component along it only, `follower(beam.end, 3 N)`";
pub const AXES_OF_LOAD: &str = "the components stand in the axes of another frame already: leave out `in`, or make them components in it with `.in(..)`";
pub const DENSITY_REPETITION: &str =
    "a density acts on all repetitions of a body: write it in the loop, with the loop's index in brackets";
pub const DISTRIBUTED_AXES: &str =
    "the components of a distributed load stand in inertial axes, or in those of the section: `in = section`";
pub const DISTRIBUTED_IN_SECTION: &str = "with `in = section` the components are written out, along the axis, y and z: `[a, b, c]`, with numbers such as `dot(velocity, section_y)`; `velocity` and the like are vectors in inertial axes";
pub const DISTRIBUTED_POINTS: &str =
    "`points` is a whole number from 1 to 5: the points at which a load is looked at in each element";
pub const DISTRIBUTED_ELSEWHERE: &str = "such a load is a function of `t`, `x`, parameters, tables and its own particle: `position`, `velocity`, `slope`, `tangent`, `section_y`, `section_z`; of nothing at another place";
pub const LINE_WITHOUT_SECTION: &str =
    "a centre line in space has a tangent and no section: write the load with `tangent`, or mesh the body with `beam`";
pub const LINE_WITHOUT_MOMENT: &str = "a centre line in space has no torsion that a moment per length could turn: leave out `moment`, or mesh the body with `beam`";
pub const SECTION_FORCE_IN_PLANE: &str =
    "the body moves in a plane: the third component, along the section's z axis, must be 0";
pub const SECTION_MOMENT_IN_PLANE: &str =
    "the body moves in a plane: a moment has the third component only, about the plane's normal";
pub const DENSITY_ON_MODES: &str = "a density acts on bodies that are described by all their nodal vectors: leave out `modal`, `small`, `rigid` or `point` of this body";
pub const NO_OUTPUT: &str = "the model has no output: add e.g. `output u = beam.end.x;`";

pub const FIXTURE_PLACE: &str =
    "a place for a fixture is expected here: `arm`, `arm.at([1, 0, 0] m)`, `beam.end` or `beam.at(4 m)`";
pub const RIGID_STRAIN: &str = "a rigid body does not deform: strain energy is that of a flexible body or of `total`";
pub const MOMENT_ABOUT_AXIS: &str = "the moment about the axis of a body is its `torque`";
pub const START_OF_INERTIAL: &str =
    "the inertial frame does not turn: name the frame whose bodies start in equilibrium with its rotation";
pub const CAUTION_WITHOUT_TIME: &str = "a caution depends on parameters and `t_end` alone: leave out motions";
pub const NOT_MODES: &str =
    "a number of modes is a whole number of at least 1: write e.g. `4`, or a `param n: count = 4;`";
pub const LONE_AXIS: &str = "an axis does nothing without an angle about it: add `angle = 30 deg`";
pub const LONE_ANGLE: &str = "an angle needs its axis: add `axis = z`, or `plane = xy` where all moves in a plane";
pub const LONE_SPEED: &str = "`speed` is that of the angle in a plane or about a hinge: add `plane = xy`, or write `angular_velocity = [..] rad/s`";
pub const PLANE_SPIN: &str = "in a plane the angular velocity is one number: write e.g. `speed = 2 rad/s`";
pub const PLANE_EXPECTED: &str = "a plane is expected here: `xy`, `yz` or `zx`";
pub const PLANAR_INERTIA: &str = "in a plane the inertia is one number, about the normal: write e.g. `0.1 kg*m^2`";
pub const PLANAR_CENTER: &str = "the centre of mass leaves the plane of the body: its third component must be 0";
pub const SECTION_OF_FIXTURE: &str = "the section below a fixture is rigid, or strains on: `section = elastic;`";
pub const SPATIAL_INERTIA: &str = "in space an inertia has three components `[xx, yy, zz]` or six, `[xx, yy, zz, xy, xz, yz]`; one number is that of a body with `plane xy;`";
pub const NOT_DEFINITE: &str = "no body has this inertia: all principal moments must be greater than zero";
pub const NEGATIVE_INERTIA: &str = "no body has this inertia: no principal moment may be negative";
pub const TRIANGLE: &str = "no body has this inertia: no principal moment is greater than the sum of the other two";

/// A vector of quantities, or of plain numbers, is wanted.
pub fn vector_wanted(what: &str, unit: &str) -> String {
    not_a_vector(what, format!("[x, y, z] {unit}").trim_end_matches(" 1"))
}

pub const NOT_REPETITIONS: &str =
    "a number of repetitions is a whole number of at least 1: write e.g. `6`, or a `param n: count = 6;`";
pub const INDEX_AS_COUNT: &str =
    "the index of a loop has no place in a count: all repetitions have the same number of elements";
pub const WHOLE_REPETITION: &str =
    "repetitions have whole numbers from 0: this is made of the index, whole numbers and `count` params";
pub const REPETITION_EXPRESSION: &str =
    "the number of a repetition is made of the index, whole numbers and counts with `+`, `-`, `*` and `%`";
pub const REMAINDER_OUTSIDE: &str = "`%` stands in the number of a repetition, e.g. `main[(a + 1) % n]`, and in values of loops whose number is known at build time";
pub const REDUCED_OUTSIDE: &str = "only an `output` can look at all repetitions";
pub const NESTED_REDUCTION: &str = "a value over all repetitions does not stand in another one, or in a loop";
pub const MOVING_REPETITION: &str = "here a repetition needs a constant number, e.g. `main[0].end`: over all of them only what a body shows in its own frame is known, such as `main[a].end.x`, `.velocity` or `.axial_force`";
pub const SAME_END_REPEATED: &str = "every repetition of this joint would hold the same end: write the index, e.g. `main[a].start`, or take it out of the loop";
pub const SAME_ENDS_REPEATED: &str =
    "every repetition of this would be about the same two ends: write the index, or take it out of the loop";
pub const REPEATED_TO_FREE: &str = "in a loop joints hold ends of bodies in prescribed frames, or in the frame of the body itself, where the number is a param: make it a `const n = 3;`, or declare this one outside of the loop, for each repetition that needs it";
pub const FIXTURE_NOT_REPEATED: &str = "fixtures on frames and rigid bodies are not repeated by a param: make the number of the loop a `const n = 3;`, or declare one outside of it with the mass and inertia of all of them";
pub const SHARED_INSIDE: &str = "only the ends of bodies are shared: use `start` or `end`, and in between `spherical`";
pub const SAME_END: &str = "both are the same end: two different ends become one node";

messages! {
    unit_of_expression(found, kind) = "the unit behind the brackets is that of plain numbers, beside which values that are {kind} stand as they are; this is {found}";
    curved_energy(part) = "`{part}` has a stress where the axis is curved, or its section twisted, without one: its derivative by an inner product of the fields does not vanish there. Declare what it is of as a `strain` of the element, in a plane e.g. `strain k = cross(a, b);`";
    modes_of_timed(word, element) = "`{word}` describes a body by its stiffness at one time, and the energy of `{element}` changes with `t`: leave `{word}` out, so that all nodal vectors describe the body";
    quantity_as_repetitions(name) = "`{name}` is a quantity; a loop needs a count: declare `param {name}: count = 6;`";
    index_in_constant(name) = "`{name}` is the index of a loop and has no place here: this is the same for all repetitions";
    repeated(name) = "`{name}` is repeated: write the number of the repetition, e.g. `{name}[0]`";
    own_repetition(name, index) = "`{name}` is known in its own repetition: write `{name}[{index}]`, or make the number of the loop a `const n = 3;` for others";
    elsewhere(name) = "`{name}` stands in a loop over a param, and is known to bodies of this loop alone: make the number of the loop a `const n = 3;`, or declare `{name}` outside of the loop";
    repeated_inside(name, index) = "`{name}` is repeated: write `{name}[{index}]`, or a certain one, e.g. `{name}[0]`";
    lone_repetition(name) = "`{name}` is a body: say what of it, e.g. `{name}[0].end.x`";
    reduction_without_loop(name) = "`{name}` goes over repetitions: write e.g. `{name}(a in 0..n, main[a].end.x)`";
    repeated_reaction(name) = "`{name}` is repeated by a param, and reactions of such joints are not observable: make the number of the loop a `const n = 3;`, or look at what the body carries there, e.g. `main[0].start.axial_force`";
    reaction_of_share(name) = "`{name}` is a shared node and exerts nothing: look at what a body carries there, e.g. `main.end.axial_force`";
    load_not_repeated(word) = "a load `{word}` is repeated where the number is known at build time, and that of this loop is a param: make it a `const n = 3;`, or declare the load outside of the loop, for each repetition that needs it, e.g. on `main[0].end`";
    joint_not_repeated(word) = "a `{word}` is repeated where the number is known at build time, and that of this loop is a param: make it a `const n = 3;`, or use `clamp`, `clamp_full`, `pin`, `hold`, `share` or `merge`";
    statement_not_repeated(word) = "a body that is repeated by a param has no `{word}`: make the number of the loop a `const n = 3;`, or leave it out";
    shared_modes(name) = "`{name}` is described by modes, or rigid, and has no nodes of its own to share: describe it by all of them, or use `weld` or `spherical`";
    shared_and_held(line) = "this end is held by the joint in line {line}: a node is shared or held; to tie both ends there, hold the other one in the same way and leave this out";
    shared_frames(first, second) = "the bodies are in the frames `{first}` and `{second}`: only nodes in the same frame are shared; use `spherical` or `weld` between them";
    shared_twice(other) = "`{other}` makes one node of these ends already";
    merged_sections(first, second) = "the stiffnesses of `{first}` and `{second}` differ, so that their strains do where they meet, and merged ends have one slope: use `weld`, or `share` with a joint between them";
    merged_elements(first, second) = "`{first}` and `{second}` have different elements, whose slopes are not alike: use `share`, or the same element";
    duplicate_statement(name, line) = "{name} is already given in line {line}: one is enough";
    twice(name) = "`{name}` is given twice";
    wrong_kind(name, kind, wanted) = "`{name}` is {kind}; {wanted} is expected here";
    recursion(name, chain) = "`{name}` is defined by itself: {chain}";
    surplus(name, usage) = "one argument too many for `{name}`: write e.g. `{usage}`";
    without_name(name, usage) = "`{name}` takes this by a name only: write e.g. `{usage}`";
    usage(name, usage) = "`{name}` is not complete: write e.g. `{usage}`";
    number_range(text) = "`{text}` with this unit is outside the range of numbers";
    missing_star(name) = "`{name}` is no unit: a product is written with `*`";
    unit_or_name(name, unit, line) = "`{name}` is a unit, too, and could be either in `{unit}` (line {line}): give it another name, or write such units in brackets, `[{unit}]`";
    name_in_unit(name, unit, sign) = "`{name}` is no unit, and the name of a value: put the number with its own unit in parentheses, `(3 {unit}) {sign} {name}`";
    part(what) = "{what} is a part of a whole: it must be greater than zero and at most 1";
    torsion_beyond(polar) = "no section has this torsion constant: it is at most the sum of the second moments, {polar} m^4 (of a round section just that)";
    moment_beyond(extent, most) = "no section has this second moment: with its `area` and `{extent}` it is at most `area * {extent}^2`, {most} m^4";
    turned_too_far(what, each, needed) = "each element is {what} by {each} deg here, and none follows more than 90 deg: take at least {needed} elements";
    output_read(name) = "`{name}` is an output, which nothing can read: write its expression here";
    function_near(other, own) = "unknown function `{other}`: did you mean `{own}`?";
    method(name) = "a function stands in front of its arguments: `{name}(..)`";
    unknown_unit(word) = "unknown unit `{word}`: units are e.g. `m`, `mm`, `kg`, `s`, `N`, `Pa`, `GPa`, `rad`, `deg`, `rpm`, `K`";
    unknown_unit_near(word, near) = "unknown unit `{word}`: did you mean `{near}`?";
    no_unit(what, kind, text, unit) = "{what} is {kind}: give the number a unit, e.g. `{text} {unit}`";
    bare_damping(text) = "damping is the time c of the stress `E (strain + c * strain rate)`: give it one, e.g. `1 ms`; a damping ratio of {text} at the angular frequency w is `2 * {text} / w`";
    wrong_dimension(what, kind, found) = "{what} is {kind}, but this is {found}";
    bare_angle(what, text) = "{what} needs a unit: `{text} rad` or `{text} deg`";
    plain_angle(what) = "{what} must show that it is one, but this is a plain number: give it `rad` or `deg`";
    not_a_vector(what, example) = "{what} is a vector: write `{example}`";
    param_in_constant(name) = "`{name}` is a parameter, known at run time only: constants and defaults are made of constants";
    motion_without_time(name) = "`{name}` is a function of time: write `{name}(t)`";
    of_place(word, body) = "`{word}` is that of a place on the body: write e.g. `{body}.end.{word}`";
    whole_thing(name, kind, example) = "`{name}` is {kind}: say what of it, e.g. `{name}.{example}`";
    not_a_value(name, kind) = "`{name}` is {kind} and has no value";
    function_without_argument(name) = "`{name}` is a function: write `{name}(..)`";
    or_unit(message, name) = "{message}; as a unit `{name}` stands right behind a number, and a compound unit in brackets: `4 [rad/s]`";
    split_units(unit) = "in an expression a compound unit stands in brackets: write it once behind the vector, `[1, 2, 3] {unit}`, or `1 [{unit}]` in each component";
    split_unit(number, unit) = "in an expression a compound unit stands in brackets: write `{number} [{unit}]`";
    stray_unit(name) = "unknown name `{name}`; a unit stands behind its number, and in an expression a compound one in brackets: `4 [rad/s]`";
    named_argument(name) = "`{name}` takes no named arguments";
    not_a_function(name, kind) = "`{name}` is {kind}, not a function of time";
    arity(name, wanted, found) = "`{name}` takes {wanted} argument(s), this has {found}";
    kink(name) = "`{name}` has a kink: it stands in outputs, and in springs and loads of what moves; a function of time switches with `if t < T {{ .. }} else {{ .. }}`";
    angle_of_time(what, kind) = "{what} is {kind}, but this is a time (s): multiply time by an angular velocity, e.g. `3 [rad/s] * t`";
    function_of_time(name) = "`{name}` takes an angle, but this is a time (s): multiply time by an angular velocity, e.g. `{name}(3 [rad/s] * t)`";
    bare_declaration(what, kind, name, text, unit) = "{what} is {kind}, but `{name}` is declared as a plain number: if it is meant, give it its unit there, `{text} {unit}`";
    function_of(name, found) = "`{name}` takes a plain number, but this is {found}";
    unlike(found, wanted) = "this is {found}, but it is combined with {wanted}";
    unlike_literal(text, wanted, unit) = "`{text}` is a plain number, but it is combined with {wanted}: give it a unit, e.g. `{text} {unit}`";
    unlike_cases(found, wanted) = "this case is {found}, but the other one is {wanted}";
    exponent_dimension(found) = "an exponent is a plain number, but this is {found}";
    exponent_constant(found) = "the exponent of {found} must be a constant such as `2` or `(1/2)`";
    quantity_as_count(name) = "`{name}` is a quantity; a mesh needs a count: declare `param {name}: count = 6;`";
    quantity_as_modes(name) = "`{name}` is a quantity; modes need a count: declare `param {name}: count = 4;`";
    positive(what) = "{what} must be greater than zero";
    not_negative(what) = "{what} must not be negative";
    matrix_rows(what, unit) = "{what} has three numbers along the axes, `[a, b, c] {unit}`, or three rows of three, `[[a, b, c], [d, e, f], [g, h, i]] {unit}`";
    element_of_plane(element) = "the sections of `{element}` have the direction `r_y` alone, as those in a plane: make the body planar, e.g. `planar xy;`, or give the element vectors of `r_z`, too";
    missing_statement(body, what) = "body `{body}` lacks {what}";
    not_imported(word, body) = "`{word}` says how a body of elements lies, and body `{body}` comes from a file: leave it out";
    import_without_modes(body) = "body `{body}` comes from a file and has no elements: say how many modes describe it, `modal(6);` or `small(6);`, or `rigid;`";
    import_damping(got) = "damping of a body from a file is a part of critical damping (`damping 0.01;`) or a time that is multiplied by its stiffness (`damping 1 ms;`), not {got}";
    import_wrong(what) = "{what}";
    node_twice(id) = "node {id} is an interface already";
    no_node(id, file, count, near) = "`{file}` has no node {id}: of its {count} nodes {near} is nearest";
    unit_of_file(unit, what) = "`{unit}` is no unit of {what}: `units` are those of length, mass and time, `units(mm, t, s)`";
    choices(option, values) = "`{option}` is {values}";
    too_few_points(points, least) = "{points} Gauss point(s) leave deformations without energy (a spurious zero mode): use at least `gauss({least})`";
    missing_of_section(name, list, element, them) = "section `{name}` lacks {list}, which `{element}` needs: add {them}, or let a shape give everything, e.g. `section {name} = circle(radius = 5 mm);` (or `tube`, `rectangle`)";
    sets_both(name, other) = "`{name}` gives `{other}`, too: leave out one of them";
    unequal_moments(name, element) = "in space `{element}` bends alike in all directions, but section `{name}` has two different second moments: use `beam`, a round or square section, or a planar body";
    rate_of_state(state, wanted, rate) = "`start` is {state}, and the rate of that is {wanted}, but this is {rate}: the unit of `start` is that of the rate times s";
    beside_energy(word) = "`energy` stands instead of `young` and `poisson`: leave out `{word}` or `energy`";
    energy_not_finite(name) = "the energy of `{name}` or its first two derivatives are not finite where there is no strain: make it smooth there";
    energy_at_rest(name, value) = "the energy of `{name}` is {value} J/m^3 where there is no strain: it must vanish there, subtract this constant";
    stress_at_rest(name, strain, value) = "the energy of `{name}` grows linearly with `{strain}`: without strain there must be no stress, but its derivative is {value} Pa";
    energy_is_loose(name, strain) = "the energy of `{name}` does not resist `{strain}`: it must grow with the square of every strain, in a plane too, where those across it are free";
    no_strain(name) = "`{name}` is no strain: there are `E.xx`, `E.yy`, `E.zz`, `E.xy`, `E.xz` and `E.yz`";
    symmetric_strain(name, strain) = "`{name}` is the same as `{strain}`: write this one";
    energy_of_line(material, element) = "material `{material}` is known by its energy, which needs an element with cross-section: use `beam`, or give `young` for `{element}`";
    energy_of_block(section, material) = "the energy of `{material}` is integrated over the section, but only properties of `{section}` are known: declare it as `circle(..)`, `tube(..)` or `rectangle(..)`";
    energy_of_own_element(material, element) = "`{material}` is known by its energy, which is integrated over the sections of the library's beam alone, not of `{element}`";
    option_beside_energy(option, material) = "`{option}` has no meaning here, for `{material}` is known by its energy: leave it out";
    no_section_axes(element, word) = "`{element}` has no section axes, which `{word}` turns: leave it out, or use `beam`";
    section_in_plane(word) = "in a plane the section's y axis lies in the plane, to the left of the axis: leave out `{word}`, or make the body `spatial`";
    normal_in_plane(plane, axis) = "the arc of a body in the {plane} plane has the normal {axis}: leave out `normal`";
    own_rule(element, word) = "`{element}` has its own rule of integration and form of code: leave out `{word}`";
    missing_property(kind, name, property, element, need) = "{kind} `{name}` has no `{property}`, which `{element}` needs ({need})";
    plane_axis(plane, axis) = "what moves in the {plane} plane turns about {axis}: leave out `axis`";
    leaves_own_plane(what, plane, axis) = "{what} leaves the {plane} plane: its {axis} component must be 0";
    point_mass(name, word) = "`{name}` is a point mass, which does not turn: leave out `{word}`, or give `{name}` an inertia of its own";
    nested_free(name, parent) = "`{parent}` moves freely, and nothing moves freely in it: declare `{name}` in `inertial`, and join the two";
    prescribed_in_free(parent) = "`{parent}` moves freely, and nothing is prescribed in it: use places such as `{parent}.at([0, 0, 0] m)`, or join a rigid body with a `drive`";
    turning_parent(kind, turning) = "`{kind}` needs axes that do not turn, but `{turning}`, which carries it, does: declare it in `inertial` or in a `moving` frame";
    spatial_frame(frame, plane) = "`{frame}` moves in space and takes the body out of the {plane} plane: move it in the plane, `plane = {plane}`, or make the body `spatial`";
    other_plane(frame, own, plane) = "`{frame}` moves in the {own} plane, but the body lies in the {plane} plane: they must be the same";
    hinge_leaves_plane(frame, plane, axis) = "`{frame}` turns out of the {plane} plane of the body: its hinge must have the axis `{axis}`, or the body be `spatial`";
    body_in_point_mass(name) = "`{name}` is a point mass, which has no axes for a body: give it `inertia`, or declare the body elsewhere and join the two";
    initial_of_modes(word, name) = "`{name}` is described by `{word}`, which starts undeformed and at rest in its frame: leave out `{word}` or the initial shape";
    tie_of_modes(what, name, word) = "`{name}` cannot have both {what} and modes: clamp it in its frame instead of `{word}`";
    tie_of_body(what, name) = "`{name}` is a rigid body and does not follow the {what} of another one: declare the body in a `free` frame";
    tie_of_held(what, name) = "the {what} of a body may move in all directions, but `{name}` does not: declare the body in a `free` frame";
    tie_of_prescribed(what, name) = "`{name}` moves in the prescribed way and follows no {what}: declare the body in a `free` frame";
    tie_in_space(what) = "the {what} of a spatial body may turn in space, but its frame moves in a plane: leave out `plane`";
    fixture_on_prescribed(name) = "`{name}` moves in the prescribed way, so that a mass on it does nothing: put the fixture on a free frame, a rigid body or a flexible one";
    fixture_on_tied(name, what, body) = "`{name}` follows the {what} of `{body}` and carries nothing else: put the fixture on `{body}`";
    carries_nothing(frame) = "`{frame}` moves freely but carries nothing: put a body in it (`body .. in {frame}`), a `fixture .. on {frame}`, or leave it out";
    not_held(body, motions, frame) = "nothing holds `{body}` against {motions} of its free frame `{frame}`: tie it with `clamp(..)`, `pin(..)` or `hold(..)` to `{frame}`, with `mean_axes;` or `chord;`, or add a constraint that turns or moves `{frame}`";
    lacks_inertia(frame, motions) = "`{frame}` has no inertia against {motions}, and nothing holds it: give it `inertia`, or tie what it carries to it";
    rigid_lacks_inertia(frame, motions) = "`{frame}` has no inertia against {motions}, and nothing holds it: add a `fixture .. on {frame}` with `inertia`, or a constraint that holds it";
    forgotten_origin(name, way) = "`{name}` does not say its `origin`, which so is {way} m from this joint: write where it is when the run starts, e.g. `origin = [0, 0, 0] m`, or the point of `{name}` that the joint holds, e.g. `{name}.at(..)`";
    distant_axis(first, second, way) = "the place of this joint is the origin of `{first}`, and that of `{second}` is {way} m away: write the point that is meant, e.g. `{first}.at([0, 0, 0] m)`, or `{second}` in front";
    loose_tie(joint, frame, what, body) = "`{joint}` turns `{frame}`, which has no mass of its own, with the {what} at an end of `{body}`, where only a part of an element resists: the frame, and with it the steps of a run, follow the quickest motions of the mesh; write `chord;` or `mean_axes;` in `{body}` instead, or give `{frame}` mass with a `fixture .. on {frame}`";
    tied_twice(what, name, frame) = "`{frame}` is held a second time, by {what} `{name}`: a free frame without mass of its own needs exactly as many ties as it has motions; join the bodies with each other instead, or give the frame mass with a `fixture .. on {frame}`";
    balance_of_repeated(name) = "`{name}` is repeated, and its sums are known of all together only: write `total`";
    balance_of_massless(name) = "`{name}` has no mass of its own: ask the bodies that it carries, or `total`";
    lacks_field(kind, name, field, example) = "{kind} `{name}` has no `{field}`: write e.g. `{example}`";
    rotation_leaves_plane(frame, plane, axis) = "frame `{frame}` turns out of the {plane} plane of the body: its axis must be `{axis}`, or the body must move in space (`spatial`, a rigid body without `plane`)";
    or_nothing_reads(message, name) = "{message}; a definition of the load's own, `{name} = ..`, must stand in it";
    definition_has_meaning(name) = "`{name}` is declared in the model: give what the load defines another name";
    density_degree(degree) = "this is a polynomial of degree {degree} in `slope` and `position`: degrees to 4 are integrated, so write one of lower degree";
    density_not_polynomial(what) = "{what} of `slope` or `position` is no polynomial, which a density must be to be integrated exactly: use sums, products and whole powers of them, functions only of what is the same along the body";
    density_axes(from, to) = "the components stand in the axes of `{from}`, those of a density in the axes of its body's frame: see places and directions in it, e.g. `inertial.in({to})` or `{to}.ex.in({to})`";
    rate_in_load(name) = "a density or a field is a function of positions, directions and angles: `{name}` has no place in it";
    field_on_prescribed(frame) = "frame `{frame}` moves in a prescribed way: leave out `on`, such gravity acts on everything";
    field_elsewhere(frame) = "a field on `{frame}` is a function of time and of vectors that are fixed in `{frame}` or in prescribed frames: nothing on a body and in no other free frame";
    origin_leaves_plane(frame, plane, axis) = "frame `{frame}` leaves the {plane} plane of the body: the {axis} component of its origin must be 0, or the body must move in space (`spatial`, a rigid body without `plane`)";
    out_of_plane(what, plane, axis) = "{what} leaves the {plane} plane of the body: its {axis} component must be 0, or the body must move in space (`spatial`, a rigid body without `plane`)";
    moment_out_of_plane(plane, axis) = "a moment on a body in the {plane} plane has a {axis} component only: make this 0, or the body must move in space (`spatial`, a rigid body without `plane`)";
    floating(body, frame) = "body `{body}` floats, nothing holds it: tie an end with `clamp` or `pin`, e.g. `joint root = clamp({body}.start, {frame});`";
    end_twice(line) = "this end is already held by the joint in line {line}";
    no_arguments(name) = "`{name}` takes no arguments";
    beyond(length) = "this place is not on the body: the axis goes from 0 m to {length}";
    vector_as_number(axes) = "this is a vector: take one component, {axes}";
    spring_not_known(name) = "what `{name}` exerts is known to loads, outputs and springs behind it";
    not_observable(name, kind) = "`{name}` is {kind}: bodies and joints can be observed";
    always_zero(axis, plane) = "the {axis} component is always zero for a body in the {plane} plane";
    moment_always_zero(axis, plane, normal) = "the {axis} component is always zero for a body in the {plane} plane: its moment is `{normal}`";
    pin_moment(name) = "`{name}` is a pin, and a pin carries no moment";
    carried_by_point(body) = "`{body}` is described as a `point`: its mass is at one place, so that nothing is spread along it that a section could carry; write `rigid;` instead";
    after_component(word) = "nothing can follow a component: leave out `.{word}`";
    number_as_vector(what) = "`{what}` takes vectors, but this is a number";
    different_axes(first, second) = "these have components in the axes of `{first}` and of `{second}`: write `.in(..)` behind one of them";
    no_center(name) = "`{name}` has no centre of mass of its own: only a `rigid` body has";
    no_component(axis) = "this vector has no {axis} component";
    only_in_outputs(word) = "only an `output` can observe `{word}`";
    rate_in_constraint(word) = "this is made of positions, directions and angles: `{word}` has no place in it";
    point_mass_turns(name) = "`{name}` is a point mass and has no orientation: give it an `inertia`";
    point_mass_joint(name, word) = "`{name}` is a point mass and has no orientation for a `{word}`: give it an `inertia`, or use `spherical` or `distance`";
    end_orientation(word) = "a centre line has a tangent and no orientation for a `{word}`: use `clamp`, `clamp_full` or `spherical`, and a `constraint` for more, or mesh the body with `beam`";
    two_ends(word) = "a `{word}` needs a frame or rigid body on one side: between two centre lines use `spherical` and a `constraint` on their slopes, or in a plane `weld`";
    two_sections(word) = "a `{word}` needs a frame or rigid body on one side: between two sections use `weld`";
    no_section(word) = "`{word}` is an axis of a cross-section, and a centre line has none: use `slope`, or mesh the body with `beam`";
    no_twist(plane) = "the section of a body in the {plane} plane does not twist: leave the joint out";
    one_section_axis(plane) = "the section of a body in the {plane} plane has one axis in it: use `ey`";
    not_carried(word, kind, words) = "{kind} carries no `{word}`: use {words}";
    stress_of_stiffness(name) = "section `{name}` says its stiffness by itself, so that its stresses are not known: they follow from `axial_force`, `shear_y`, `torque`, `moment_y` and so on with the layers of the section";
    section_axes_only(word) = "`{word}` has the axes of the section itself: leave out `.in(..)`";
    stress_without_shape(name, extents) = "the stress depends on the shape of section `{name}`: give it {extents} (distance of the outermost fibre), or write `circle(..)`, `tube(..)` or `rectangle(..)`";
    not_in_plane(word, plane, advice) = "a `{word}` makes no sense in the {plane} plane: {advice}";
    axis_along_normal(word, plane, axis) = "in the {plane} plane the axis of a `{word}` is `{axis}`: leave it out";
    axis_in_plane(word, plane, axis) = "the axis of this `{word}` leaves the {plane} plane: its {axis} component must be 0";
    needs_axis(word, usage) = "a `{word}` needs its axis: write e.g. `{usage}`";
    no_coordinate(name, word, coordinate, has) = "`{name}` is a `{word}` joint and has no `{coordinate}`{has}";
    no_rate(name, word, has) = "`{name}` is a `{word}` joint and has no single `rate`{has}";
    no_coordinates(name) = "`{name}` holds a flexible end and has no coordinates: for these `weld` a `rigid` of little mass to the end, and join that";
    not_driven(name, word) = "`{name}` has no coordinate `{word}`: a planar or hinged frame has its `angle`";
    no_angle_in_space(name, word) = "`{name}` turns in space and has no single `{word}`: use its directions `ex`, `ey`, `ez` or its `angular_velocity`";
    angle_of_prescribed(name, word) = "`{name}` moves in a prescribed way: its `{word}` stands in its declaration";
    no_moment(name, word) = "`{name}` is a `{word}` joint, which carries no moment";
    start_twice(frame, name) = "the bodies of `{frame}` start by `{name}` already: one start is enough";
    start_without_bodies(frame) = "no body lives in `{frame}`: name the frame that stands behind `in` of the bodies";
    start_of_modes(body) = "body `{body}` is described by modes or does not deform, and modes have no initial shape: leave out `modal`, `small`, `rigid` or `point`, or this start";
    start_with_velocity(body) = "body `{body}` has an initial velocity, and here it starts at rest in its frame: leave out one of them";
    start_out_of_plane(plane, axis) = "a body of this frame moves in the {plane} plane: the angular velocity has a {axis} component only";
    unused(kind, name) = "nothing uses the {kind} `{name}`: leave it out, or call it `_{name}`";
    unseen(name, others, place) = "no output, caution or start sees `{name}`{others}: observe it (e.g. `output of_{name} = {place};`), leave it out, or call it `_{name}`";
    undamped(part, body, place, element, cure, kind, name) = "this does not damp the {part} of `{body}`: {place} `{element}` has no strain of it, whose rate could be damped; {cure} where that should die away, or call the {kind} `_{name}`";
    unread_property(property, kind, name, why) = "nothing reads the {property} of {kind} `{name}`, for {why}: leave it out, or call the {kind} `_{name}`";
    hold_frame(name, component) = "`hold` keeps a place of a flexible body, and `{name}` is none: write a constraint, e.g. `constraint level = {name}.{component};`";
    added_weight(first, second) = "gravity acts on everything, so that `{first}` and `{second}` are added: leave one out (that of a component stands once for each part), or let its name begin with `_`";
    coordinate_measure(what) = "the coordinate of a spring is a length or an angle, but this is {what}: multiply or divide it by what makes it one";
    coordinate_law(acts) = "along this coordinate acts a {acts}: write `{acts} = ..`, an expression of `value` and `rate`, and nothing else";
    spring_stiffness(word, unit) = "`{word}` needs a stiffness: for a damper alone write `stiffness = 0 [{unit}]`";
}

/// An output in a unit of another quantity.
pub fn output_unit(own: &str, other: &str) -> String {
    format!("this output is {own}, but the unit it is to be told in is that of {other}")
}

/// Nothing became of a declaration, and nothing has been said about it.
pub fn dropped(noun: &str, name: &str) -> String {
    format!("nothing is made of the {noun} `{name}`, and no rule says why, a defect of rncf: write it in another way")
}
