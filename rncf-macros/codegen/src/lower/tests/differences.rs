//! What depends on differences of places alone.

use super::checked;
use crate::lower::constraints::constraint_kernels;
use crate::lower::forces::force_kernels;

#[test]
fn differences_are_told_from_what_is_zero_at_nearly_all_places() {
    let model = checked(
        "model Places {
            table curve { at = way; way = [0, 1, 9] m; push = [0, 1, 2] N; interpolation = linear; }
            rigid a { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
            rigid b { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; origin = [3, 0, 0] m; }
            rigid c { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; origin = [5, 0, 0] m; }
            spring cord = law(a, b, force = 2 [N/m] * (length - 1 m) + 1 [N] * exp(-(length / 1 mm)^2));
            spring measured = law(a, b, force = curve.push(length));
            load jet = force(a, [1 [N] * exp(-(a.x / 1 mm)^2), 0, 0]);
            load cam = force(a, [curve.push(a.x), 0, 0]);
            load drag = force(a, [-1 [N*s/m] * (a.velocity.x - b.velocity.x), 0, 0]);
            load wind = force(a, [-1 [N*s/m] * a.velocity.x, 0, 0]);
            constraint between = 0.25 * a.x + 0.75 * b.x - c.x;
            constraint wall = a.y + b.y - c.y;
            output all = a.x + b.x + c.x;
        }",
    );
    let names = |is: &dyn Fn(usize) -> bool, all: Vec<&str>| -> Vec<String> {
        let these = all.into_iter().enumerate().filter(|(index, _)| is(*index));
        these.map(|(_, name)| name.to_string()).collect()
    };
    let forces = force_kernels(&model);
    let of_differences = |index: usize| forces.iter().any(|kernels| kernels.of_differences.contains(&index));
    let all = model.forces.iter().map(|force| force.name.as_str()).collect();
    assert_eq!(names(&of_differences, all), ["cord", "measured", "drag"]);
    let constraints = constraint_kernels(&model);
    let of_differences = |index: usize| {
        constraints
            .iter()
            .any(|kernels| kernels.of_differences.contains(&index))
    };
    let all = model
        .constraints
        .iter()
        .map(|constraint| constraint.name.as_str())
        .collect();
    assert_eq!(names(&of_differences, all), ["between"]);
}
