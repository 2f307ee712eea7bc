//! Steady rotation: the force at the root is that of the mass beyond it.

use rncf::equilibrium::{Uniform, steady};
use rncf::model::SectionState;
use rncf::{Model, Rncf, Scene};

use crate::models::{Blades, DENSITY, LENGTH, YOUNG, area};

/// Section states in steady rotation at `t`.
pub fn rotating(scene: &mut dyn Scene, t: f64) -> Vec<SectionState> {
    let found = steady(scene, t).unwrap();
    let mut states = Vec::new();
    scene.uniform_section_states(&Uniform::steady(t), found.state().unwrap(), &mut states);
    states
}

/// Force over area, Pa, at stress-free places of a bar that turns about its start, by shooting:
/// `s' = -rho w^2 r`, `s = E/2 (r'^2 - 1) r'`, r(0) = 0, s(L) = 0; `places` equal parts.
pub fn bar(young: f64, density: f64, length: f64, spin: f64, places: usize) -> Vec<f64> {
    let stress = |stretch: f64| 0.5 * young * (stretch * stretch - 1.0) * stretch;
    let rate = |[r, stretch]: [f64; 2]| {
        let stiffness = 0.5 * young * (3.0 * stretch * stretch - 1.0);
        [stretch, -density * spin * spin * r / stiffness]
    };
    let parts = 200;
    let h = length / (places * parts) as f64;
    let way = |start: f64| {
        let mut y = [0.0, start];
        let mut found = vec![stress(start)];
        for step in 1..=places * parts {
            let at = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let k1 = rate(y);
            let k2 = rate(at(k1, 0.5 * h));
            let k3 = rate(at(k2, 0.5 * h));
            let k4 = rate(at(k3, h));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            if step % parts == 0 {
                found.push(stress(y[1]));
            }
        }
        found
    };
    let (mut low, mut high) = (1.0, 1.5);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if way(middle)[places] > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    way(low)
}

#[test]
fn the_root_stress_is_that_of_the_mass_beyond() {
    let model = Blades {
        omega: 20.0,
        ..Blades::default()
    };
    let mut scene = model.scene::<Rncf>().unwrap();
    let states = rotating(scene.as_mut(), 0.0);
    let root = 0.5 * DENSITY * model.omega.powi(2) * LENGTH * LENGTH;
    for state in &states {
        let wanted = root * (1.0 - (state.x / LENGTH).powi(2));
        let told = state.stress.unwrap();
        assert!((told - wanted).abs() < 1e-4 * root, "{told} {wanted} {state:?}");
        assert!(
            state.moments[2].abs() < 1e-6 && state.forces[1].abs() < 1e-6,
            "{state:?}"
        );
    }
}

#[test]
fn the_force_is_the_physical_one_at_large_strain() {
    let model = Blades {
        omega: 500.0,
        ..Blades::default()
    };
    let mut scene = model.scene::<Rncf>().unwrap();
    let states = rotating(scene.as_mut(), 0.0);
    let n = model.elements;
    let wanted = bar(YOUNG, DENSITY, LENGTH, model.omega, 2 * n);
    let mut worst = 0.0f64;
    for (place, state) in states.iter().enumerate() {
        let (element, place) = ((place / 3) % n, place % 3);
        let wanted = wanted[2 * element + place];
        worst = worst.max((state.forces[0] / area() - wanted).abs() / 3.9e9);
    }
    println!("largest error over the root stress: {worst:.1e}");
    assert!(worst < 1e-6, "{worst}");
    // The second Piola-Kirchhoff stress at the root is less by the stretch.
    let strain = 3.9e9 / YOUNG;
    assert!(wanted[0] / (1.0 + strain) < 0.99 * wanted[0]);
}
