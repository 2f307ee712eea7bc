//! What is said about elements that make no sense: what is wrong, and what would be right.

pub const POSITION_AS_FIELD: &str =
    "an energy of `r` itself changes when the body is moved: fields are derivatives such as `r_x`";
pub const INERTIA_OF: &str = "mass moves with `r`, `r_y` or `r_z`, not with their derivatives";
pub const DAMPING: &str = "the damping of an element is that of its material: write `damping = material.damping;`";
pub const STRAIN_OF_STRAINS: &str = "a strain may be a sum of others with constant factors; for another function of strains write `let`, and use it in the energy";
pub const POINTS: &str =
    "a number of Gauss points is a whole number from 1 to 20; what acts at nodes alone has `points nodes`";
pub const POINTS_OF_SOME: &str =
    "other parts of the energy have `points` of their own: give this one some, too, or take those away";
pub const PLACE: &str = "a nodal vector sits at a fraction of the unit element: `at 0`, `at 1/2`, `at 1`";
pub const NO_POSITION: &str = "the first nodal vector at 0 and at 1 is the position: `vector r0 = r at 0, shape ..;`";
pub const COEFFICIENT_PRODUCT: &str = "a coefficient is a product of properties, numbers and params: write `material.young * section.area`, and sums of products as coefficients of their own";
pub const STRESSED: &str = "with `t` this part has a stress in the shape that a body declares: subtract it, or, if it is meant (heated, drawn together, prestressed), write `, active` behind it";
pub const NOT_ACTIVE: &str = "this part is free of stress in the shape that a body declares, at every time, with the defaults of its params: leave out `active`, or give them defaults with which it is not";
pub const OF_SECTION: &str =
    "elements of the library alone are of a section that says its stiffness by itself: write `(section, material)`";
pub const PRODUCT_OF: &str = "the fields of the element are multiplied: write e.g. `dot(a, b)` with `field a = r_x;`";
pub const NOT_FINITE_AT_REST: &str = "this has no finite value, stress or stiffness where nothing is deformed";
pub const CROSS_IN_SPACE: &str = "`cross(a, b)` is a number in the plane alone: write this part `in plane`, and in space its square, `dot(a, a)*dot(b, b) - dot(a, b)^2`";
pub const Z_ALONE: &str = "a section with `r_z` has `r_y`, too: in a plane `r_y` alone is its direction, in space both are; declare vectors of `r_y`, or call these so";

messages! {
    too_large(most, size, place) = "an element has at most {most} coordinates, and this one {size} {place}: declare fewer vectors, and take more elements in `mesh`";
    without_directions(coefficient, property) = "`{coefficient}` is of `section.{property}`, and the sections of this element have no directions, `r_y` and `r_z`: write `section.second_moment`, which in a plane is that about its normal";
    timed_strain(name) = "`{name}` counts from the stress-free shape at every time, so that `t` would cancel: let `t` stand in the energy, e.g. `1/2*EA*({name} - heat)^2` with `let heat = ..;`";
    damping_of_parts(word) = "`{word}` stands in elements of the library alone: all strains of an element have the damping of its material";
    timed_inertia(name) = "`{name}` changes with time, and mass does not: leave out `t`";
    of_library(name) = "`{name}` is an element of the library: choose another name";
    missing(what, example) = "this element has no `{what}`: write e.g. `{example}`";
    taken(name) = "`{name}` has a meaning of its own in elements: choose another name";
    no_vector(of) = "`{of}` is no nodal vector: there are `r`, `r_x`, `r_y` and `r_z`";
    not_interpolated(of, vector) = "no nodal vector interpolates `{of}`: declare some, e.g. `vector d0 = {vector} at 0, shape 1 - xi;` and `vector d1 = {vector} at 1, shape xi;`";
    always_zero(of, degree) = "`{of}` is zero everywhere: the shape functions that it is a derivative of have degree {degree}";
    not_the_coordinate(name, coordinate) = "a shape function is a polynomial of `{coordinate}`, and `{name}` is something else";
    coefficient_unit(name, own, declared) = "`{name}` is {own}, and its declared unit is that of {declared}";
    coefficient_si(unit, si) = "coefficients are in SI units: write `{si}` instead of `{unit}`";
    inertia_unit(of, wanted, found) = "the mass per length that moves with `{of}` is {wanted}, this is {found}";
    defined_already(name) = "`{name}` is defined above for the same case: leave one out, or tell the cases apart by `in plane`, `in space` or `when`";
    unlike_definition(name, own, before) = "`{name}` is {own} here, and {before} above";
    energy_unit(found) = "an energy per length is a force (N), this is {found}";
    stress_factor(coefficient) = "the stress has the same factor `{coefficient}` as its energy";
    component(field, axis) = "`{field}.{axis}` changes when the body is turned: an energy is a function of inner products such as `dot({field}, {field})`";
    field_as_number(field) = "`{field}` is a vector: an energy is a function of inner products such as `dot({field}, {field})`";
    unused_vector(name) = "nothing resists `{name}`: no field is a derivative of what it interpolates; add one, or leave it out";
    both(name) = "the energy and the inertia of an element have coefficients of their own: declare `{name}` once more under another name";
    unused(name) = "nothing reads `{name}`: leave it out";
    no_energy(place) = "this element has no energy {place}";
    several_strains(names) = "this part is of several strains, `{names}`: write one part for each, and what couples two as the square of a strain of its own, e.g. `strain both = ..;`";
    undefined(name, place) = "`{name}` is not defined {place} for all values of the options that this part is for";
    not_stiff(stiffness) = "the second derivative is {stiffness} where nothing is deformed: a strain must be resisted, or nothing holds the body at rest";
    not_stationary(stress) = "this is not stationary where nothing is deformed: there its derivative is {stress} times the coefficient; subtract it, or declare what it is of as a `strain`";
    wrong_stress(strain) = "the stress is not the derivative of the energy, e.g. at a strain of {strain}: leave `stress` out, and it is derived";
    too_few(count, place, points) = "the Gauss points leave {count} motion(s) {place} without resistance that the energy resists: write `points {points};`";
    too_few_of_terms(count, place) = "the Gauss points of the parts leave {count} motion(s) {place} without resistance that the energy resists: give some more `points`";
    loose(count, place) = "the energy leaves {count} motion(s) of an element {place} without resistance, beside those of a rigid body, even where it is tight";
    no_partition(name, sum) = "the shape functions do not reproduce rigid motion: those of `{name}` and the like add up to {sum}, not to 1";
    not_linear(sum) = "the shape functions do not reproduce rigid rotation and uniform strain: with the positions and slopes of a straight element they give r = {sum}, not xi";
    ends_differ(name) = "the node at 1 is the node at 0 of the next element: `{name}` has no counterpart in the same place of the list";
}

/// A shape function that is none.
pub fn not_a_polynomial(coordinate: &str, highest: usize) -> String {
    format!(
        "a shape function is a polynomial of `{coordinate}` up to degree {highest}, with moderate decimal numbers and their quotients"
    )
}

/// A shape function with another value at a node.
pub fn not_interpolating(name: &str, what: &str, [value, place, wanted]: &[String; 3], other: &str) -> String {
    format!(
        "the shape function of `{name}` has the {what} {value} at {place}, where `{other}` sits, and needs {wanted}"
    )
}
