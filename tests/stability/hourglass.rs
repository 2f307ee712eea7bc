//! T8 of THEORY 10: too few points of integration leave motions without stiffness.

use std::f64::consts::PI;

use rncf::equilibrium::Uniform;
use rncf::modes::{Wanted, modes};
use rncf_reference::section_beam::{Properties, Section};
use rncf_reference::section_chain::{Chain, Hold, Supports, straight};
use rncf_reference::section_modes::dense;
use rncf_reference::section_statics::{Load, Problem};
use rncf_reference::symmetric::eigenvalues;

use crate::scenes::referenced;

rncf::model! {
    /// A beam on a small free body.
    pub model Loose {
        param elements: count = 1;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 50 mm);
        rigid hub { mass = 1 g; inertia = [1e-6, 1e-6, 1e-6] kg*m^2; }
        body beam in hub {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * beam(round, steel);
        }
        joint root = clamp(beam.start, hub);
        output tip = beam.end.position;
    }
}

fn properties(dimension: usize, radius: f64, points: [usize; 2]) -> Properties {
    Properties {
        axis_points: points[0],
        gradient_points: points[1],
        ..Properties::structural(dimension, 1.0, &Section::circle(radius, 1.0, 0.3, 1.0))
    }
}

/// Directions without stiffness of a free chain.
fn loose(points: [usize; 2], elements: usize) -> usize {
    let chain = Chain::along(properties(3, 0.05, points), elements, straight).unwrap();
    let supports = Supports::new(&chain, &[]);
    let forces = chain.forces(chain.stress_free(), &supports);
    let found = eigenvalues(&dense(&forces.tangent));
    let largest = found[found.len() - 1];
    found.iter().filter(|value| value.abs() < 1e-12 * largest).count()
}

#[test]
fn fewer_points_leave_motions_without_stiffness() {
    for (elements, printed) in [(1, [6, 9, 9, 6]), (4, [6, 9, 18, 6])] {
        let found = [[3, 2], [2, 2], [3, 1], [5, 5]].map(|points| loose(points, elements));
        let model = Loose { elements };
        let mut scene = referenced(&model);
        let (state, count) = (scene.rest(0.0), 12);
        let ours = modes(scene.as_mut(), &Uniform::at_rest(0.0), &state, Wanted { count }).unwrap();
        let still = ours.iter().filter(|mode| mode.im == 0.0).count();
        println!("{elements} elements: 3 and 2, 2 and 2, 3 and 1, 5 and 5 points {found:?}; ours {still}");
        assert_eq!(found, printed);
        assert_eq!(still, 6);
    }
}

#[test]
fn newtons_method_fails_with_them() {
    let rolled = |points| {
        let chain = Chain::along(properties(2, 0.02, points), 4, straight).unwrap();
        let problem = Problem {
            supports: Supports::clamp(&chain, Hold::Fixed),
            chain,
            loads: vec![Load::Moment(4, 2.0 * PI * PI / 4.0 * 0.02f64.powi(4))],
            spin: [0.0; 3],
        };
        problem.solve(20).map(|_| ())
    };
    let found = [[3, 2], [2, 2], [2, 1]].map(rolled);
    println!("roll-up with 3 and 2, 2 and 2, 2 and 1 points: {found:?}");
    assert!(found[0].is_ok() && found[1].is_err());
}
