//! Matrices that are kept over steps go stale as absolute coordinates rotate; in a rotating frame they do not.

use rncf::linalg::Saddle;
use rncf::{Formulation, Joints, Model, Scene};

rncf::model! {
    /// A rod that spins at constant speed.
    pub model Spinning {
        param elements: count = 4;
        material steel { density = 7850 kg/m^3; young = 210 GPa; }
        section round { area = 78.5 mm^2; second_moment = 491 mm^4; }
        frame hub = rotating(axis = z, angle = 1 [rad/s] * t);
        body rod in hub { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh elements * cable(round, steel); }
        joint root = clamp(rod.start, hub);
        output v = rod.end.y;
        run { t_end = 1 s; every = 0.1 s; }
    }
}

/// Values of Newton's matrix for steps of size `h` (s) of the trapezoidal rule where the undeformed rod is at `t`.
fn matrix(scene: &mut dyn Scene, h: f64, t: f64) -> (Vec<f64>, Vec<f64>) {
    let state = scene.rest(t);
    let (mut values, mut border) = (
        vec![0.0; scene.pattern().entries()],
        vec![0.0; scene.constraint_pattern().entries()],
    );
    scene.iteration_matrix(&state, [1.0, h / 2.0, h * h / 4.0], &mut values);
    scene.constraint_jacobian(&state, &mut border);
    (values, border)
}

/// By what Newton's error is multiplied per iteration after a turn by `angle` (rad), with the matrix from before it.
fn contraction(formulation: Formulation, h: f64, angle: f64) -> f64 {
    let mut scene = Spinning::default().build(formulation, Joints::Eliminated).unwrap();
    let (pattern, borders) = (scene.pattern().clone(), scene.constraint_pattern().clone());
    let (old, old_border) = matrix(scene.as_mut(), h, 0.0);
    let (new, new_border) = matrix(scene.as_mut(), h, angle);
    let mut saddle = Saddle::new(&pattern, scene.border(), &borders);
    saddle.factor_symmetric(&old, &old_border).unwrap();
    let (n, m) = (pattern.rows(), borders.columns());
    // Power iteration with 1 - old^-1 new.
    let mut x: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * (1.7 * i as f64).sin()).collect();
    let mut y = vec![0.0; m];
    let (mut growth, rounds) = (0.0, 200);
    for round in 0..2 * rounds {
        let (mut dynamics, mut constraints) = (vec![0.0; n], vec![0.0; m]);
        pattern.multiply_add(1.0, &new, &x, &mut dynamics);
        borders.multiply_add(1.0, &new_border, &y, &mut dynamics);
        borders.transpose_multiply_add(1.0, &new_border, &x, &mut constraints);
        saddle.solve(&mut dynamics, &mut constraints);
        x.iter_mut().zip(&dynamics).for_each(|(x, change)| *x -= change);
        y.iter_mut().zip(&constraints).for_each(|(y, change)| *y -= change);
        let size = x.iter().chain(&y).map(|value| value * value).sum::<f64>().sqrt();
        if size < 1e-12 {
            return size;
        }
        x.iter_mut().chain(&mut y).for_each(|value| *value /= size);
        if round >= rounds {
            growth += size.ln() / f64::from(rounds);
        }
    }
    growth.exp()
}

#[test]
fn absolute_coordinates_wear_a_matrix_out_by_turning() {
    // A step of 1 ms at 30 rad/s turns by 0.03 rad. From 1 on Newton's iteration diverges.
    for (h, angle, absolute) in [
        (1e-3, 0.01, 0.3..0.4),
        (1e-3, 0.03, 1.2..1.6),
        (1e-3, 0.1, 5.0..20.0),
        (1e-2, 0.01, 1.4..1.8),
        (1e-2, 1.0, 1e3..1e5),
    ] {
        let found = [Formulation::Ancf, Formulation::Rncf].map(|formulation| contraction(formulation, h, angle));
        println!(
            "h {h:.0e} s, turned by {angle} rad: absolute {:.2e}, in the frame {:.1e}",
            found[0], found[1]
        );
        assert!(absolute.contains(&found[0]) && found[1] < 1e-12, "{found:?}");
    }
}
