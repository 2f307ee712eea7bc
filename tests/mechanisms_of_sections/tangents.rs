//! Tangents of these models against differences.

use rncf::Model;
use rncf_reference::tangents::compare_tangents;

use crate::chains::{Driven, Floating};
use crate::rotors::{Rotor, Spinning};
use crate::running::WAYS;
use rncf_test_models::Materials;

fn both<M: Model>(model: &M) {
    compare_tangents(model, WAYS[0].0, WAYS[0].1);
    compare_tangents(model, WAYS[2].0, WAYS[2].1);
}

#[test]
fn driven_chain() {
    both(&Driven {
        elements: 1,
        ..Driven::default()
    });
}

#[test]
fn floating_chain() {
    both(&Floating {
        elements: 1,
        ..Floating::default()
    });
}

#[test]
fn rotors() {
    both(&Rotor {
        damping: 300.0,
        stiffness_z: 3e5,
        ..Rotor::default()
    });
    both(&Spinning {
        damping: 300.0,
        stiffness_z: 3e5,
        ..Spinning::default()
    });
}

#[test]
fn materials() {
    both(&Materials {
        damping: 1e-3,
        pull: 50.0,
        ..Materials::default()
    });
}
