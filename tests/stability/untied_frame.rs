//! T14 of THEORY 10: a free frame that its bodies do not tie.

use rncf::error::SolveErrorKind;
use rncf::linalg::symmetric_eigen;
use rncf::{Formulation, Integrator, Joints, Method, Model, Options, Scene};
use rncf_codegen::elements::Library;
use rncf_codegen::expand;

rncf::model! {
    /// Ribbons in a free frame. How often a joint in a loop ties the frame is known when the scene is built.
    pub model Loose {
        param ribbons: count = 1;
        material soft { density = 1500 kg/m^3; young = 0.4 MPa; }
        section flat { area = 10 cm^2; second_moment = 500 cm^4; }
        frame f = free(angular_velocity = [1, 2, 3] rad/s);
        for a in 0..ribbons {
            body ribbon[a] in f {
                spatial;
                line from [0, 0, 0] m to [2, 0, 0] m;
                mesh 2 * cable(flat, soft);
                // An arc: a straight line has no inertia about itself, tied or not.
                initial position [sin(x / 1 m) * 1 m, (1 - cos(x / 1 m)) * 1 m, 0];
            }
            joint knot[a] = hold(ribbon[a].end.z);
        }
        output z = ribbon[0].start.z;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// Singular values of the mass matrix, ascending, unknowns scaled to a diagonal of ones.
fn singular_values(scene: &mut dyn Scene) -> Vec<f64> {
    let (state, n) = (scene.rest(0.0), scene.unknowns());
    let pattern = scene.pattern().clone();
    let mut mass = vec![0.0; pattern.entries()];
    scene.mass(&state, &mut mass);
    let mut full = vec![0.0; n * n];
    for column in 0..n {
        for place in pattern.starts()[column]..pattern.starts()[column + 1] {
            full[pattern.indices()[place] * n + column] = mass[place];
        }
    }
    let scale: Vec<f64> = (0..n).map(|i| full[i * n + i].sqrt()).collect();
    let scaled: Vec<f64> = (0..n * n)
        .map(|at| full[at] / (scale[at / n] * scale[at % n]))
        .collect();
    // Symmetric and not negative: its singular values are the sizes of its eigenvalues.
    let (values, _) = symmetric_eigen(n, &scaled).unwrap();
    let mut values: Vec<f64> = values.iter().map(|value| value.abs()).collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn a_frame_that_nothing_ties_has_a_singular_mass_matrix_and_is_named() {
    // One coordinate held by a condition that is eliminated; with multipliers all are free.
    for (joints, loose) in [(Joints::Multipliers, 6), (Joints::Eliminated, 5)] {
        let mut scene = Loose::default().build(Formulation::Rncf, joints).unwrap();
        let values = singular_values(scene.as_mut());
        println!(
            "{joints:?}: singular values {} of {}",
            crate::short(&values[..8]),
            values.len()
        );
        assert!(values[loose - 1] < 1e-14 && values[loose] > 1e-4, "{values:?}");
        let rest = scene.rest(0.0);
        let refusal = Integrator::new(scene.as_mut(), rest, 1.0, Method::Radau, Options::default()).err();
        let error = refusal.expect("the motions have no inertia");
        println!("{error}");
        assert!(matches!(error.kind, SolveErrorKind::Untied(_)), "{error}");
        let text = error.to_string();
        assert!(
            text.contains("frame `f`") && text.contains("add a condition that holds it"),
            "{text}"
        );
    }
}

#[test]
fn where_the_ties_are_known_the_macro_says_what_is_loose() {
    let declared = |ties: &str| {
        let text = format!(
            "pub model Free {{
                material soft {{ density = 1500 kg/m^3; young = 0.4 MPa; }}
                section flat {{ area = 10 cm^2; second_moment = 500 cm^4; }}
                frame f = free();
                body ribbon in f {{ spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(flat, soft);
                    initial position [sin(x / 1 m) * 1 m, (1 - cos(x / 1 m)) * 1 m, 0]; }}
                {ties}
                output x = ribbon.end.x;
            }}"
        );
        let found = expand::text(text.parse().unwrap(), &Library::standard());
        found
            .err()
            .map(|mistakes| mistakes.into_iter().map(|mistake| mistake.message).collect::<Vec<_>>())
    };
    for (ties, loose) in [
        ("", "against any motion of its free frame `f`"),
        (
            "joint root = clamp(ribbon.start, f);",
            "against turning about the x axis of its free frame `f`",
        ),
    ] {
        let messages = declared(ties).expect("refused");
        println!("{messages:?}");
        assert!(messages.len() == 1 && messages[0].contains(loose), "{messages:?}");
        assert!(messages[0].contains("tie it with `clamp(..)`"), "{messages:?}");
    }
    assert_eq!(
        declared("joint root = clamp(ribbon.start, f); joint twist = hold(ribbon.end.z);"),
        None
    );
}
