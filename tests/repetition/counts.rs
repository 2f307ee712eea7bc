//! Counts that are computed from counts.

use rncf::prelude::*;

use super::{run, scene};

/// A comb of cables, with `$n` for a count of which the others are made.
macro_rules! comb {
    ($name:ident, { $($count:tt)* }, $back:expr, $teeth:expr, $fine:expr, $modes:expr) => {
        rncf::model! {
            pub model $name {
                $($count)*
                material rubber { density = 1000 kg/m^3; young = 20 MPa; poisson = 0.3; }
                section round = circle(radius = 8 mm);
                body back { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh $back * cable(round, rubber); }
                joint clasp = clamp(back.start, inertial);
                for a in 0..$teeth {
                    body tooth[a] { spatial; line from [0.1 m * a, 0 m, 0 m] to [0.1 m * a, 1 m, 0 m]; mesh $fine * cable(round, rubber); }
                    joint root[a] = clamp(tooth[a].start, inertial);
                }
                body handle { spatial; line from [0, 0, 1] m to [1, 0, 1] m; mesh 8 * cable(round, rubber); modal($modes); }
                joint grip = clamp(handle.start, inertial);
                load weight = gravity([0, 0, -9.81] m/s^2);
                output tip = back.end.z;
                output low = sum(a in 0..$teeth, tooth[a].end.z);
            }
        }
    };
}

comb!(Computed, { param n: count = 2; }, (2*n + 1), (2*n - 1), (3 - n + n*n), (n + 2));
comb!(Written, {}, 5, 3, 5, 4);
comb!(WrittenOnce, {}, 3, 1, 3, 3);
comb!(TooFew, { param n: count = 3; }, (n - 2), 1, 1, 1);

/// What a short fall puts out.
fn fall(model: &impl Model) -> Vec<Vec<f64>> {
    run(&mut *scene(model), 0.02, 1e-6, StepSize::Fixed(2e-3))
}

#[test]
fn computed_counts_are_those_that_are_written() {
    let mut model = Computed::default();
    assert_eq!(fall(&model), fall(&Written::default()));
    model.n = 1;
    assert_eq!(fall(&model), fall(&WrittenOnce::default()));
}

#[test]
fn a_count_below_one_names_its_body() {
    let built = |n| TooFew { n }.build(Formulation::Rncf, Joints::Eliminated);
    assert!(built(3).is_ok());
    let message = built(2).err().expect("no elements").message;
    assert_eq!(message, "body `back` has no elements: its mesh needs at least one");
}
