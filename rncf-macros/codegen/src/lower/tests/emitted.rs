//! What is written for a model with everything that moves freely.

use super::model::{base, moving, number};
use super::{Inputs, evaluate};
use crate::elements::Library;
use crate::expand;
use crate::lower::courses::courses;
use crate::lower::free::free_kernel;
use crate::lower::lower;
use crate::lower::motions::switches;
use crate::model::{Binary, Comparison, Expr, Force, ForceKind, Function, MarkerId, Model, MotionId};

fn text(model: &Model) -> String {
    expand::format(&expand::written_out(model, &Library::standard()))
}

#[test]
fn only_what_is_needed_is_written() {
    let text = text(&moving());
    for there in [
        "fn free(",
        "fn cable_spatial_mass(",
        "fn cable_planar_mass(",
        "fn fixtures(",
        "fn marker_constraint_hessian(",
        "0 | 2 => constraint_gradient_pin(",
        "fn joint_root_referenced_position(",
        "Fidelity::Small(3)",
        "tie: ::rncf::emitted::FrameTie::MeanAxes",
        "When::Absolute(0)",
        "ObservedSpec::ConstraintReaction",
    ] {
        assert!(text.contains(there), "{there} is missing");
    }
    // Where the pose of a frame is unknown, nothing can be written that needs it.
    for absent in [
        // The runtime has inertia forces.
        "inertia_",
        "carried",
        "fn frame_hub(",
        "fn joint_root_absolute_position(",
        "constraint_hessian_pin",
    ] {
        assert!(!text.contains(absent), "{absent} should not be there");
    }
    assert!(text.contains("fn frame_rotor("));
    let still = self::text(&base());
    for absent in ["FreeSpec {", "carried", "FixtureSpec {", "MarkerSpec::", "rigid:"] {
        assert!(!still.contains(absent), "{absent} should not be there");
    }
}

/// Two parts about the frame's origin, by hand.
#[test]
fn rigid_parts_add_up() {
    let model = moving();
    let frame = &model.frames[2];
    let kernel = free_kernel(&model, frame, frame.free.as_ref().unwrap());
    let inputs = Inputs::from([("model.mass".to_string(), 2.0), ("model.gap".to_string(), 0.5)]);
    let values = evaluate(&kernel, &inputs);
    let at = |place: &str| values.get(&format!("spec.{place}")).copied().unwrap_or(0.0);
    for (place, wanted) in [
        ("position[0]", 1.0),
        ("position[1]", 0.5),
        ("velocity[2]", 0.3),
        ("spin[2]", 2.0),
        ("axis[2]", 1.0),
        ("rigid.mass", 5.0),
        ("rigid.moment[0]", 2.0 * 0.1 - 3.0 * 0.5),
        ("rigid.moment[1]", 0.4),
        ("rigid.moment[2]", 0.6 + 1.2),
        ("rigid.inertia[(0, 0)]", 1.0 + 2.0 * 0.13 + 3.0 * 0.16),
        ("rigid.inertia[(1, 1)]", 2.0 + 2.0 * 0.10 + 3.0 * 0.41),
        ("rigid.inertia[(2, 2)]", 3.0 + 2.0 * 0.05 + 3.0 * 0.25),
        ("rigid.inertia[(0, 1)]", 0.1 - 2.0 * 0.02),
        ("rigid.inertia[(1, 0)]", 0.1 - 2.0 * 0.02),
        ("rigid.inertia[(2, 0)]", 0.2 - 2.0 * 0.03 + 3.0 * 0.2),
        ("rigid.inertia[(1, 2)]", 0.3 - 2.0 * 0.06),
    ] {
        assert!(
            (at(place) - wanted).abs() < 1e-14,
            "{place}: {} instead of {wanted}",
            at(place)
        );
    }
    // A planar frame counts its angle about its own normal, whichever axis was written.
    let sled = &model.frames[3];
    let values = evaluate(&free_kernel(&model, sled, sled.free.as_ref().unwrap()), &inputs);
    assert_eq!(values["spec.axis[2]"], 1.0);
    assert!((values["spec.angle"] + 20.0_f64.to_radians()).abs() < 1e-15);
}

#[test]
fn kinks_of_constraints_and_forces_are_known() {
    let mut model = moving();
    model.frames.remove(1);
    // Without the rotor only the constraint knows the motion.
    model.frames.insert(1, model.frames[0].clone());
    let found = switches(&model, &Library::standard());
    let (kernel, count) = found.kinks;
    assert_eq!((found.gaps.1, found.repeated.len()), (0, 0));
    assert_eq!(count, 1);
    assert_eq!(evaluate(&kernel, &Inputs::new())["kinks[0]"], 2.0);
}

#[test]
fn conditions_that_are_not_linear_in_time_are_written_as_gaps() {
    let mut model = moving();
    let angle = Expr::Binary(Binary::Multiply, Box::new(number(3.0)), Box::new(Expr::Time));
    let wave = Expr::Call(Function::Sin, vec![angle]);
    let [wave, level, on, off] = [wave, number(0.5), number(1.0), number(0.0)].map(Box::new);
    model.forces.push(Force {
        name: "gate".to_string(),
        doc: String::new(),
        markers: vec![MarkerId(0)],
        components: vec![[
            number(0.0),
            Expr::If(Comparison::Greater, wave, level, on, off),
            number(0.0),
        ]],
        energy: None,
        kind: ForceKind::Load,
    });
    let (kernel, count) = switches(&model, &Library::standard()).gaps;
    assert_eq!(count, 1);
    let values = evaluate(&kernel, &Inputs::from([("t".to_string(), 0.2)]));
    assert!((values["gaps[0][0]"] - (0.6_f64.sin() - 0.5)).abs() < 1e-15);
    assert!((values["gaps[0][1]"] - 3.0 * 0.6_f64.cos()).abs() < 1e-15);
    let text = text(&model);
    assert!(text.contains("pub fn gaps(") && text.contains("fn gaps(&self, t: f64"));
}

#[test]
fn pulses_of_time_are_written_as_operations() {
    let binary = |operator, a: Expr, b: Expr| Expr::Binary(operator, Box::new(a), Box::new(b));
    let power = |base: Expr, exponent: f64| Expr::Power(Box::new(base), Box::new(number(exponent)));
    let call = |function, of: Expr| Expr::Call(function, vec![of]);
    let mut model = moving();
    let before = courses(&model, &Library::standard()).len();
    model.forces.push(Force {
        name: "blow".to_string(),
        doc: String::new(),
        markers: vec![MarkerId(0)],
        components: Vec::new(),
        energy: None,
        kind: ForceKind::Load,
    });
    let mut found = |component: Expr| {
        model.forces.last_mut().unwrap().components = vec![[number(0.0), component, number(0.0)]];
        courses(&model, &Library::standard())
    };
    let square = power(binary(Binary::Divide, Expr::Time, number(0.1)), 2.0);
    let rational = binary(Binary::Divide, number(2.0), binary(Binary::Add, number(1.0), square));
    // A sum has its terms beside it, and a factor that does not change is left out.
    let both = binary(Binary::Add, rational, power(call(Function::Sin, Expr::Time), 50.0));
    let list = found(both);
    let last = list.last().unwrap();
    assert_eq!(list.len(), before.max(1));
    let of_blow = last.functions.iter().filter(|(of, _)| of == "load `blow`").count();
    assert_eq!(of_blow, 3, "{:?}", last.functions);
    assert!(last.operations.iter().any(|one| one.starts_with("Power(")));
    // Sines and polynomials hide nothing.
    let even = binary(
        Binary::Multiply,
        power(Expr::Time, 2.0),
        call(Function::Sin, Expr::Time),
    );
    assert_eq!(found(even).len(), before);
}

#[test]
fn energy_is_conserved_where_nothing_drives_or_damps() {
    let conservative = |model: &Model| lower(model, &Library::standard()).conservative;
    let mut model = moving();
    assert!(!conservative(&model));
    // The strut damps, the thrust has no potential, the hinge is driven.
    model.forces.remove(2);
    model.forces.remove(0);
    assert!(!conservative(&model));
    model.constraints[1].rows.pop();
    assert!(conservative(&model));
    model.forces.push(Force {
        name: "push".to_string(),
        doc: String::new(),
        markers: vec![MarkerId(0)],
        components: vec![[
            number(0.0),
            Expr::Motion(MotionId(0), Box::new(Expr::Time)),
            number(0.0),
        ]],
        energy: None,
        kind: ForceKind::Load,
    });
    assert!(!conservative(&model));
}
