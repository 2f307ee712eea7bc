//! Scenes that make no sense are refused by the names of their things.

use super::model::Hand;
use super::scenery::everything;
use crate::emitted::{FrameTie, Motions};
use crate::model::{Formulation, Joints};
use crate::scene::MeshScene;
use crate::space::Vector;

fn refused(hand: Hand) -> String {
    let result = MeshScene::new(Box::new(hand), Formulation::Rncf, Joints::Eliminated, &[]);
    result.err().expect("the scene makes no sense").message
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let with = |change: &dyn Fn(&mut Hand)| {
        let mut hand = everything();
        change(&mut hand);
        refused(hand)
    };
    let message = with(&|hand| hand.free[4].velocity[1] = f64::NAN);
    assert!(message.contains("`stone`") && message.contains("finite"), "{message}");
    let message = with(&|hand| hand.free[2].motions = Motions::Hinged { axis: Vector::zeros() });
    assert!(
        message.contains("`door`") && message.contains("unit vector"),
        "{message}"
    );
    let message = with(&|hand| hand.free[1].parent = 2);
    assert!(message.contains("`top`") && message.contains("`turning`"), "{message}");
    let message = with(&|hand| hand.free[2].parent = 3);
    assert!(
        message.contains("`door`") && message.contains("free itself"),
        "{message}"
    );
    let message = with(&|hand| hand.free[3].velocity = Vector::z());
    assert!(message.contains("`sledge`"), "{message}");
    let message = with(&|hand| hand.bodies[1].frame = 3);
    assert!(message.contains("`whip`") && message.contains("`ship`"), "{message}");
    let message = with(&|hand| hand.loads[0].0.frame = 3);
    assert!(message.contains("gravity"), "{message}");
    let message = with(&|hand| hand.joints[0].frame = 0);
    assert!(message.contains("`step`"), "{message}");
    let message = with(&|hand| hand.bodies[0].tie = FrameTie::MeanAxes);
    assert!(message.contains("`mast`") && message.contains("straight"), "{message}");
    let message = with(&|hand| {
        hand.bodies[1].tie = FrameTie::MeanAxes;
        hand.free[3].motions = Motions::Hinged { axis: Vector::z() };
    });
    assert!(
        message.contains("`whip`") && message.contains("3 free motions"),
        "{message}"
    );
}
