//! What is said about tables, curves, and sections that say their stiffness by themselves.

use crate::suggest::written;

pub const COLUMN: &str = "a column is a list of values with one unit: `EI = [2, 1.5, 1] N*m^2;`";
pub const COLUMN_ELSEWHERE: &str = "a column of a table has a value at a place along an axis: it stands in fields of sections and materials, and in `twist`";
pub const ARCLENGTH_ELSEWHERE: &str = "`x` is the place along an axis: it stands in fields of sections and materials, in `twist`, in loads per length and in a `let` that these use";
pub const LOOKUP_ELSEWHERE: &str = "a table is looked up in motions, frames, drives, constraints, loads, laws of springs and outputs: elsewhere its columns have the value at the place along an axis, `table.column`";
pub const LOOKUP: &str = "a column is looked up at one place: `polar.lift(alpha)`";
pub const STEP_AT_END: &str = "the first two or last two rows are at one place: a step stands between other rows";
pub const DAMPING_ALONG: &str = "`damping` is the same along the whole body: leave out `x` and columns of tables";
pub const LOAD_ALONG_CORNERS: &str = "a load along a body with corners is the same along each of its straight pieces: leave out `x` and columns of tables";
pub const CURVE_BACKWARDS: &str =
    "an axis goes from its first point to its last one, and this direction leads the other way";
pub const CURVE_TABLE: &str = "a curve goes through points: its table needs the columns `x`, `y` and `z` in m";
pub const CURVE_RANGE: &str = "this curve has no length: its parameter starts and ends at one value";
pub const CURVE_WITHOUT_TIME: &str = "the axis of a body is the same at all times: leave out motions";
pub const ENERGY_OF_REPETITION: &str = "an `energy` is the same in all repetitions of a loop over a param: leave out the index, or make the number of the loop a `const n = 3;`";
pub const VARYING_ENERGY: &str =
    "a material with an `energy` has one section along the whole body: leave out `x` and columns of tables";

pub fn rows_differ(column: &str, count: usize, first: &str, rows: usize) -> String {
    format!("`{column}` has {count} values, and `{first}` has {rows}: give every column one value for each row")
}

pub fn unreadable_file(path: &str, error: &str) -> String {
    format!("`{path}` cannot be read: {error}")
}

/// A `let` of the place along an axis, used where there is none.
pub fn along_elsewhere(name: &str) -> String {
    format!(
        "`{name}` hangs on the place along an axis: it is used in fields of sections and materials, in `twist` and in loads per length"
    )
}

/// A file that is no table, with the reader's reason.
pub fn wrong_file(path: &str, why: &str) -> String {
    format!("`{path}` is no table: {why}")
}

pub fn unit_of_column(path: &str, column: &str, unit: &str) -> String {
    format!("`{path}`, column `{column}`: `{unit}` is no unit; write e.g. `N*m^2`, or `-` for a plain number")
}

pub fn column_twice(column: &str) -> String {
    format!("there are two columns `{column}`: give each a name of its own")
}

pub fn table_without_places(table: &str) -> String {
    format!(
        "table `{table}` does not say where its rows are: it needs a column `x` (m, along the axis) or `eta` (parts of its length), or the coordinates `x`, `y` and `z` (m) of points, or `at = column`"
    )
}

/// Points of which a column says the places.
pub fn places_of_points(table: &str, column: &str) -> String {
    format!(
        "the rows of `{table}` are points (`x`, `y`, `z`), and their places the sums of the chords between them: leave out `at = {column}`"
    )
}

/// A table whose rows do not stand along an axis.
pub fn lookup_without_place(table: &str, column: &str) -> String {
    format!("the rows of `{table}` do not stand along an axis: say at which place, `{table}.{column}(..)`")
}

pub fn lookup_in_law(table: &str, column: &str) -> String {
    format!("here a table is looked up: say at which place, `{table}.{column}(..)`")
}

pub fn lookup_of(table: &str, wanted: &str, given: &str) -> String {
    format!("the rows of `{table}` are at places that are {wanted}, but this is {given}")
}

pub fn lookup_of_angle(table: &str) -> String {
    format!("this is an angle, and the rows of `{table}` are at plain numbers: give that column a unit, e.g. `deg`")
}

pub fn energy_of_placed_gravity(load: &str) -> String {
    format!(
        "gravity `{load}` is a function of the place, whose potential is not known: leave `gravity_energy` out, and write the potential by hand, as of a mass point `-mu * m / distance`"
    )
}

pub fn open_period(row: &str, column: &str) -> String {
    format!("{row}, the last one, has another `{column}` than the first: rows that repeat end where they begin")
}

pub fn step_in_spline(row: &str) -> String {
    format!(
        "{row} is at the place of the one before it, and a spline has no steps: take `interpolation = monotone`, or leave the row out"
    )
}

pub fn rough_motion(table: &str) -> String {
    format!(
        "what moves in a prescribed way needs a velocity and an acceleration without steps, which the rows of `{table}` do not give: write `interpolation = spline` in it"
    )
}

pub fn table_of_one_row(table: &str) -> String {
    format!("table `{table}` has fewer than two rows, and values between rows need two")
}

pub fn rows_do_not_ascend(row: &str, place: f64, before: f64) -> String {
    format!("{row}: {place} does not come after {before}; rows ascend along the axis, two at one place are a step")
}

pub fn points_coincide(row: &str) -> String {
    format!(
        "{row}: the point is where the one before it is, or at no finite distance from it: points follow each other along an axis"
    )
}

/// A column of a section's table that is no field, and that nothing reads.
pub fn unread_column(column: &str, table: &str, word: &str, near: Option<&str>) -> String {
    let head = format!("nothing reads column `{column}` of `{table}`");
    match near {
        Some(near) => format!("{head}: did you mean `{near}`?"),
        None if column == "twist" => {
            format!("{head}: write `twist {table}.twist;` in the body, or call the column `_twist` where it is meant")
        }
        None => format!(
            "{head}, and it is no field that `{word}` takes: leave it out, read it as `{table}.{column}`, or call it `_{column}` where it is meant"
        ),
    }
}

pub fn not_symmetric([(first, one), (second, other)]: [(&str, f64); 2], row: usize) -> String {
    format!(
        "columns `{first}` and `{second}` are one entry of a symmetric matrix, and differ in row {row}, {one} and {other}: give one of them"
    )
}

pub fn field_and_column(field: &str, column: &str) -> String {
    format!("`{field}` stands here and in column `{column}` of the table: give it once")
}

pub fn column_dimension(column: &str, field: &str, unit: &str) -> String {
    let role = if column == field {
        String::new()
    } else {
        format!(" is the field `{field}` and")
    };
    format!("column `{column}`{role} has another dimension than {unit}: look at the unit in its header")
}

pub fn row_out_of_range(row: usize, place: f64, column: &str, value: f64) -> String {
    format!("row {row} (at {place}): `{column}` is {value}, it must be greater than zero")
}

pub fn two_laws(matrix: &str, constant: &str) -> String {
    format!(
        "`{constant}` stands beside `{matrix}`: a stiffness or mass is given by its matrix or by constants, not by both"
    )
}

pub fn missing_of_law(section: &str, missing: &[&str]) -> String {
    let quoted: Vec<String> = missing.iter().map(|field| format!("`{field}`")).collect();
    let list = quoted.join(", ");
    format!("section `{section}` says its stiffness by itself and lacks {list}")
}

pub fn two_dampings(own: &str) -> String {
    format!("`damping` is that of all strains, and `{own}` stands beside it: give one for all, or each its own")
}

pub fn no_options(option: &str, element: &str, section: &str) -> String {
    format!("`{element}({section})` has no options: leave `{option}` out")
}

pub fn mixed_section(field: &str, law: &str) -> String {
    format!(
        "`{field}` is a size of a section, and `{law}` says its stiffness or mass by itself: a section has the one or the other"
    )
}

pub fn material_of_law(section: &str, element: &str) -> String {
    format!("section `{section}` says stiffness and mass by itself: leave the material out, `{element}({section})`")
}

/// Numbers that an element needs of a section that says its stiffness by itself.
pub fn lacks_numbers(section: &str, missing: &[&str], element: &str, is_spatial: bool) -> String {
    let quoted: Vec<String> = missing.iter().map(|field| format!("`{field}`")).collect();
    let place = if is_spatial { "in space" } else { "in a plane" };
    format!(
        "section `{section}` says its stiffness by itself and lacks {}, which `{element}` needs {place}",
        quoted.join(", ")
    )
}

/// A product of properties that is no field of a section that says its stiffness by itself.
pub fn no_number(section: &str, product: &str, element: &str) -> String {
    format!(
        "`{element}` needs {product}, and section `{section}` says its stiffness and mass by itself, where no field is this product: give it a section and a material"
    )
}

/// What an element with its stiffness and mass on the axis does not know.
pub fn number_elsewhere(section: &str, field: &str, element: &str) -> String {
    format!(
        "`{element}` has its stiffness and mass on the axis, and one `damping`, so that nothing reads `{field}` of section `{section}`: leave it out, write `EA`, `EI`, `mass` and so on, or take `beam({section})`"
    )
}

pub fn unequal_stiffness(section: &str, element: &str) -> String {
    format!(
        "in space `{element}` bends alike in all directions, but section `{section}` has two different `EIy` and `EIz`: take `beam({section})`, or a planar body"
    )
}

/// What would drive a body out of the plane that it stays in.
pub fn leaves_plane(section: &str, field: &str) -> String {
    format!(
        "`{field}` of section `{section}` couples what a body does in its plane with what leaves the plane: leave it out, or write `spatial;`"
    )
}

pub fn curve_off_plane(plane: &str, axis: &str, value: f64) -> String {
    format!("the body stays in the plane {plane}, and a point of its curve has {axis} = {value} m")
}

pub fn curve_parameter(name: &str, line: &str) -> String {
    format!("`{name}` is declared in line {line}: give the curve's parameter another name")
}

pub fn curve_constant(name: &str) -> String {
    format!("this is one point: the place on a curve depends on its parameter `{name}`")
}

pub fn not_covered(table: &str, [first, last]: [f64; 2], body: &str, end: f64, unit: &str) -> String {
    format!(
        "table `{table}` has rows from {first} to {last} {unit}, and the axis of body `{body}` goes from 0 to {end} {unit}: add rows at its ends"
    )
}

pub fn two_places(table: &str) -> String {
    format!("table `{table}` has its places twice, as `x` and as `eta`: say which of them hold, `at = x` or `at = eta`")
}

pub fn beyond_the_length(table: &str, last: f64) -> String {
    format!(
        "table `{table}` has rows up to {last} of the length, and every axis ends at 1: `eta` counts parts of the length, so divide percentages by 100"
    )
}

pub fn twist_in_steps(table: &str, x: f64, step: f64) -> String {
    format!(
        "the twist jumps by {} deg at x = {} m, at a step of table `{table}`, and both elements there have one section: let it turn from row to row, or end the body there and `weld` the next one to it",
        written(step.to_degrees()),
        written(x)
    )
}

pub fn value_along(place: &str, name: &str, value: f64, unit: &str, range: &str) -> String {
    let value = written(value);
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    format!("{place}: {name} is {value}{unit}, and along the whole axis it has to be {range}")
}

pub fn thickness_along(place: &str) -> String {
    format!("{place}: the wall of the tube is not thinner than its radius: a full one is a `circle`")
}

pub fn section_along(place: &str, name: &str, value: f64, most: &str, bound: f64) -> String {
    format!("{place}: no section has a {name} of {value:.4e} m^4, it is at most {most}, {bound:.4e} m^4")
}

pub fn indefinite(head: &str, least: f64, row: &str) -> String {
    format!(
        "{head}: its matrix of stiffness is not positive definite: scaled to a diagonal of ones its least eigenvalue is {least:.3e}, mostly in row {row}: look at the entries that couple it"
    )
}

pub fn mass_entry(head: &str, entry: &str, found: f64, wanted: f64, row: &str) -> String {
    let wanted = written(wanted);
    format!(
        "{head}: {entry} is {found} where a distribution of mass over a section has {wanted}, from the other entries: row {row}"
    )
}

pub fn no_inertia(head: &str, about_y: f64, about_z: f64) -> String {
    let (about_y, about_z) = (written(about_y), written(about_z));
    format!(
        "{head}: its rotary inertia about the centre of mass is {about_y} kg m about y and {about_z} kg m about z: both must be greater than zero"
    )
}

pub fn product_of_inertia(head: &str, product: f64, about_y: f64, about_z: f64) -> String {
    let [product, about_y, about_z] = [product, about_y, about_z].map(written);
    format!(
        "{head}: its product of inertia about the centre of mass, {product} kg m, is larger than the moments {about_y} and {about_z} kg m allow"
    )
}
