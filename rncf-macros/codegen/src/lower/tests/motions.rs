//! Derivatives of prescribed motions against differences in time.

use super::model::{base, number, times};
use super::{Inputs, evaluate, fill};
use crate::lower::joints::joint_kernels;
use crate::lower::motions::frame_kernel;
use crate::lower::{Kernel, tests::Random};
use crate::model::{Expr, FrameId, FrameTie, Function, Model};

/// The rotor swings on an origin that swings, too.
fn swinging() -> Model {
    let mut model = base();
    // Mean axes read third derivatives.
    model.bodies[0].tie = FrameTie::MeanAxes;
    let swing = |rate: f64| Expr::Call(Function::Sin, vec![times(number(rate), Expr::Time)]);
    model.motions[0].value = swing(1.7);
    model.frames[1].origin = [swing(0.9), number(0.2), swing(1.3)];
    model.joints[0].frame = FrameId(1);
    model
}

/// `derivative(i)` against a difference of `value(i)`; entries that are not written are zero.
fn compare(kernel: &Kernel, inputs: &Inputs, value: &str, derivative: &str) {
    let (t, step) = (0.4, 1e-4);
    let at = |t: f64| {
        let mut inputs = inputs.clone();
        inputs.insert("t".to_string(), t);
        evaluate(kernel, &inputs)
    };
    let [up, down, found] = [t + step, t - step, t].map(at);
    let mut largest = 0.0_f64;
    for i in 0..3 {
        let entry = |values: &Inputs, name: &str| values.get(&format!("{name}[{i}]")).copied().unwrap_or(0.0);
        let difference = (entry(&up, value) - entry(&down, value)) / (2.0 * step);
        let rate = entry(&found, derivative);
        assert!(
            (difference - rate).abs() < 1e-6,
            "{derivative}[{i}]: {rate} instead of {difference}"
        );
        largest = largest.max(rate.abs());
    }
    assert!(largest > 0.0, "{derivative} vanishes");
}

#[test]
fn third_derivatives_of_frames() {
    let kernel = frame_kernel(&swinging(), FrameId(1));
    for (value, derivative) in [
        ("position", "velocity"),
        ("velocity", "acceleration"),
        ("acceleration", "jerk"),
        ("spin", "spin_rate"),
        ("spin_rate", "spin_jerk"),
    ] {
        let [value, derivative] = [value, derivative].map(|name| format!("motion.{name}"));
        compare(&kernel, &Inputs::new(), &value, &derivative);
    }
}

#[test]
fn third_derivatives_of_what_joints_prescribe() {
    let model = swinging();
    let kernel = joint_kernels(&model, &model.joints[0], false, true).prescribed;
    let mut inputs = Inputs::new();
    fill(&kernel, &mut inputs, &mut Random(9));
    for what in ["position", "slope"] {
        for level in 0..3 {
            let name = |level: usize| format!("prescribed.{what}[{level}]");
            compare(&kernel, &inputs, &name(level), &name(level + 1));
        }
    }
}

/// Without constraints on markers and mean axes nothing reads a jerk.
#[test]
fn third_derivatives_are_left_out_where_nothing_reads_them() {
    let mut model = swinging();
    model.bodies[0].tie = FrameTie::Joints;
    let jerks = |kernel: &Kernel, word: &str| kernel.outputs.iter().any(|(place, _)| place.contains(word));
    let frame = frame_kernel(&model, FrameId(1));
    assert!(jerks(&frame, "spin_rate") && !jerks(&frame, "jerk"));
    let prescribed = joint_kernels(&model, &model.joints[0], false, true).prescribed;
    assert!(jerks(&prescribed, "position[2]") && !jerks(&prescribed, "position[3]"));
}
