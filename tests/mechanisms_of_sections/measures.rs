//! Measures of the strain: which force a strain is, and which moment a curvature, for every option of the elements.

use crate::running::loaded;

rncf::model! {
    /// The same bar with every measure of its strain.
    pub model Measures {
        /// End force.
        param pull = 0 N;
        /// End moment.
        param turn = 0 N*m;
        /// End force of the string, which has no shape without.
        param tension = 1 N;
        material soft { density = 1000 kg/m^3; young = 10 MPa; poisson = 0.4; }
        section cord = circle(radius = 10 mm);
        body a { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * cable(cord, soft); }
        body b { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * cable(cord, soft, bending = exact); }
        body c { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * cable(cord, soft, bending = exact, axial = engineering); }
        body d { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * cable(cord, soft, axial = engineering, slack = true); }
        body e { planar xy; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 8 * beam(cord, soft, axial = engineering); }
        body f { spatial; line from [0, 0, 0] m to [0.5, 0, 0] m; mesh 2 * beam(cord, soft, coupling = poisson, axial = engineering); }
        joint root_a = clamp(a.start, inertial);
        joint root_b = clamp(b.start, inertial);
        joint root_c = clamp(c.start, inertial);
        joint root_d = clamp(d.start, inertial);
        joint root_e = clamp(e.start, inertial);
        joint root_f = clamp(f.start, inertial);
        load pull_a = force(a.end, [pull, 0, 0]);
        load pull_b = force(b.end, [pull, 0, 0]);
        load pull_c = force(c.end, [pull, 0, 0]);
        load pull_d = force(d.end, [tension, 0, 0]);
        load pull_e = force(e.end, [pull, 0, 0]);
        load pull_f = force(f.end, [pull, 0, 0]);
        load turn_a = moment(a.end, [0, 0, turn]);
        load turn_b = moment(b.end, [0, 0, turn]);
        load turn_c = moment(c.end, [0, 0, turn]);
        load turn_e = moment(e.end, [0, 0, turn]);
        output a = a.end.x;
        output b = b.end.x;
        output c = c.end.x;
        output d = d.end.x;
        output e = e.end.x;
        output f = f.end.x;
        output axial_a = a.at(0.2 m).axial_force;
        output axial_b = b.at(0.2 m).axial_force;
        output axial_c = c.at(0.2 m).axial_force;
        output axial_d = d.at(0.2 m).axial_force;
        output axial_e = e.at(0.2 m).axial_force;
        output axial_f = f.at(0.2 m).axial_force;
        output slope_a = a.end.slope;
        output slope_b = b.end.slope;
        output slope_c = c.end.slope;
        output y_c = c.end.y;
        output moment_a = a.at(0.2 m).moment;
        output moment_c = c.at(0.2 m).moment;
    }
}

const RADIUS: f64 = 0.01;
const YOUNG: f64 = 1e7;
const LENGTH: f64 = 0.5;

/// Stretch under a dead force with Green's strain, `L (L^2 - 1) / 2 = F / EA`.
fn by_green(share: f64) -> f64 {
    let (mut low, mut high) = (0.6, 2.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle * (middle * middle - 1.0) / 2.0 > share {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

/// A bar that is pulled: its stretch, and the axial force that it shows, which is the end force.
#[test]
fn stretch_and_axial_force_under_an_end_force() {
    let area = std::f64::consts::PI * RADIUS * RADIUS;
    for share in [0.01, 0.1, -0.05] {
        let pull = share * YOUNG * area;
        let row = loaded(&Measures {
            pull,
            tension: pull.max(1.0),
            ..Measures::default()
        });
        let (green, engineering) = (by_green(share), 1.0 + share);
        println!("F = {share} EA: {:.6} {:.6}", green - 1.0, engineering - 1.0);
        // a, b: Green's strain; the string d only pulls.
        let wanted = [green, green, engineering, engineering, engineering, engineering];
        for (k, wanted) in wanted.into_iter().enumerate() {
            if k == 3 && share < 0.0 {
                continue;
            }
            let stretch = row[k] / LENGTH;
            assert!((stretch - wanted).abs() < 1e-9, "{k}: {stretch} instead of {wanted}");
            let force = row[6 + k] / pull;
            assert!((force - 1.0).abs() < 1e-9, "{k}: {force} of the end force");
        }
    }
}

/// A bar that is bent by an end moment: into a circle by the exact curvature, further by the polynomial one, which shortens it.
#[test]
fn turning_under_an_end_moment() {
    let area = std::f64::consts::PI * RADIUS * RADIUS;
    let stiffness = YOUNG * area * RADIUS * RADIUS / 4.0;
    for strain in [0.02, 0.1] {
        let curvature = strain / RADIUS;
        let row = loaded(&Measures {
            turn: stiffness * curvature,
            ..Measures::default()
        });
        // dU/dL = 0 and dU/df' = M of U = EA/2 e^2 + EI/2 L^4 f'^2.
        let mut stretch = 1.0_f64;
        for _ in 0..200 {
            stretch = (1.0 - (strain / stretch.powi(3)).powi(2)).sqrt();
        }
        let polynomial = stretch.powi(-4);
        println!("r f0 = {strain}: f' / f0 = {polynomial:.6}");
        for (k, wanted) in [(12, polynomial), (14, 1.0), (16, 1.0)] {
            let angle = row[k + 1].atan2(row[k]).rem_euclid(2.0 * std::f64::consts::PI);
            let turned = angle / (LENGTH * curvature);
            println!("  {k}: {turned:.6} {wanted:.6}");
            // A cubic axis is bent by 0.13 and 0.63 rad an element.
            let limit = if strain < 0.05 { 1e-5 } else { 3e-3 };
            assert!(
                (turned / wanted - 1.0).abs() < limit,
                "{k}: {turned} instead of {wanted}"
            );
        }
        let moments = [row[19], row[20]].map(|moment| moment / (stiffness * curvature));
        println!("  moments {moments:?}");
        assert!(
            strain > 0.05 || moments.iter().all(|share| (share - 1.0).abs() < 1e-3),
            "{moments:?}"
        );
    }
}
