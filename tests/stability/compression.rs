//! T15 of THEORY 10: the St. Venant-Kirchhoff law grows softer below the stretch `1/sqrt 3`, and a bar collapses to a
//! shape that no material has. The equations do not mind; the scene tells.

use rncf::app::{RunSettings, run};
use rncf::equilibrium::critical_factor;
use rncf_reference::element::{Data, ElasticForce, GaussElement, Weights};

use crate::scenes::referenced;

rncf::model! {
    /// A bar under a growing load along it, in the plane and damped.
    pub model Pressed {
        /// Load over EA.
        param load = 0.15;
        param elements: count = 4;
        const stiffness = 1 [kPa] * 1 [m^2];
        motion grow(t) = if t < 5 s { t / 5 [s] } else { 1 };
        material foam { density = 1 kg/m^3; young = 1 kPa; damping = 0.1 s; }
        section square { area = 1 m^2; second_moment = 10 m^4; }
        body bar {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh elements * cable(square, foam);
        }
        joint root = clamp(bar.start, inertial);
        load press = force(bar.end, [-load * stiffness * grow(t), 0 N, 0 N], in = inertial);
        output length = bar.end.x;
        output across = bar.end.y;
        run { t_end = 20 s; every = 0.1 s; }
    }
}

rncf::model! {
    /// The same with a string that does not push, let loose.
    pub model Slack {
        material foam { density = 1 kg/m^3; young = 1 kPa; }
        section square { area = 1 m^2; second_moment = 1e-4 m^4; }
        body bar {
            planar xy;
            line from [0, 0, 0] m to [1, 0, 0] m;
            mesh 4 * cable(square, foam, slack = true);
            initial position [0.4 * x, 0, 0];
        }
        joint root = clamp(bar.start, inertial);
        output middle = bar.at(0.5 m).x;
        run { t_end = 0.1 s; every = 0.01 s; }
    }
}

/// Axial force and stiffness of a bar of length 1 with `EA = 1` at a stretch: derivatives of its energy by the length.
fn bar(stretch: f64) -> [f64; 2] {
    let element = GaussElement::straight(Data {
        dimension: 2,
        length: 1.0,
        mass_per_length: 1.0,
        axial_stiffness: 1.0,
        bending_stiffness: 0.0,
        exponent: 0,
        damping: 0.0,
        points: 5,
    })
    .unwrap();
    let q = [0.0, 0.0, stretch, 0.0, stretch, 0.0, stretch, 0.0];
    // Both slopes and the end grow with the stretch.
    let along = [0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0];
    let (mut force, mut tangent) = ([0.0; 8], [0.0; 64]);
    element.add_force_and_tangent(&q, &[0.0; 8], Weights::POSITION, &mut force, &mut tangent);
    let normal = (0..8).map(|i| along[i] * force[i]).sum();
    let stiffness = (0..64).map(|k| along[k / 8] * tangent[k] * along[k % 8]).sum();
    [normal, stiffness]
}

#[test]
fn the_law_softens_below_one_over_the_root_of_three() {
    for stretch in [1.0, 0.8, 0.6, 0.57, 0.4, 0.1] {
        let [force, stiffness] = bar(stretch);
        println!("stretch {stretch}: force {force:.4} EA, stiffness {stiffness:.3} EA");
        assert!((force - 0.5 * (stretch * stretch - 1.0) * stretch).abs() < 1e-14);
        assert_eq!(stiffness < 0.0, stretch < 3f64.sqrt().recip());
    }
}

#[test]
fn a_bar_that_collapses_is_named() {
    for (load, collapses) in [(0.15, false), (0.19, false), (0.2, true)] {
        let model = Pressed {
            load,
            ..Pressed::default()
        };
        let result = run(&model, &RunSettings::default()).unwrap();
        let history = &result.history;
        let length = history.column(0).last().unwrap();
        println!("load {load} EA: length {length:.4} m; {:?}", result.warnings);
        // The run comes to its end in both cases: beyond the largest force the bar has turned inside out.
        assert_eq!(length < 0.0, collapses);
        let named = |text: &String| text.starts_with("body `bar`") && text.contains("1/sqrt 3");
        assert_eq!(
            result.warnings.iter().filter(|text| named(text)).count(),
            usize::from(collapses)
        );
    }
}

/// Under a static load the way ends at the largest force that the law has, `EA / (3 sqrt 3)`.
#[test]
fn the_static_way_ends_at_the_largest_force() {
    let model = Pressed {
        load: 0.3,
        ..Pressed::default()
    };
    let found = critical_factor(referenced(&model).as_mut(), 20.0).unwrap().unwrap();
    let largest = 0.3 * found.factor;
    println!("largest force {largest:.5} EA, limit: {}", found.is_limit);
    assert!(found.is_limit && (largest * 27f64.sqrt() - 1.0).abs() < 1e-3);
}

#[test]
fn a_slack_string_is_not() {
    let result = run(&Slack::default(), &RunSettings::default()).unwrap();
    let middle = result.history.column(0).next().unwrap();
    assert!(middle < 0.25, "{middle}");
    assert!(result.warnings.is_empty());
}
