//! What the drawing of a section's matrices says of each entry: a unit strain gives the forces of its column, a unit velocity the momenta.

use std::fs;

use rncf::Model;
use rncf::app::{EquilibriumSettings, History, RunSettings, run, static_equilibria};
use rncf_guide::entries::{Centres, MASS, STIFFNESS, drawing, matrix};

use crate::{column, docs, is_same};

rncf::model! {
    /// A bar of a full matrix under the forces of its end.
    model Full {
        param k11 = 1 N;
        param k12 = 0 N;
        param k13 = 0 N;
        param k14 = 0 N*m;
        param k15 = 0 N*m;
        param k16 = 0 N*m;
        param k22 = 1 N;
        param k23 = 0 N;
        param k24 = 0 N*m;
        param k25 = 0 N*m;
        param k26 = 0 N*m;
        param k33 = 1 N;
        param k34 = 0 N*m;
        param k35 = 0 N*m;
        param k36 = 0 N*m;
        param k44 = 1 N*m^2;
        param k45 = 0 N*m^2;
        param k46 = 0 N*m^2;
        param k55 = 1 N*m^2;
        param k56 = 0 N*m^2;
        param k66 = 1 N*m^2;
        param f1 = 0 N;
        param f2 = 0 N;
        param f3 = 0 N;
        param f4 = 0 N*m;
        param f5 = 0 N*m;
        param f6 = 0 N*m;
        section own { K11 = k11; K12 = k12; K13 = k13; K14 = k14; K15 = k15; K16 = k16; K22 = k22; K23 = k23; K24 = k24; K25 = k25; K26 = k26; K33 = k33; K34 = k34; K35 = k35; K36 = k36; K44 = k44; K45 = k45; K46 = k46; K55 = k55; K56 = k56; K66 = k66; mass = 1 kg/m; inertia_y = 1 kg*m; inertia_z = 1 kg*m; }
        body bar {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            section_y [0, 1, 0];
            mesh 2 * beam(own);
        }
        joint root = clamp(bar.start, inertial);
        load pull = force(bar.end, [f1, f2, f3]);
        load turn = moment(bar.end, [f4, f5, f6]);
        // Shear forces bend a bar; this keeps its moments the same everywhere.
        load kept = distributed(bar, [0, 0, 0] N/m, moment = [0 N, f3, -f2]);
        output tip = bar.end.position;
        output ey = bar.end.ey;
        output ez = bar.end.ez;
        output force: N = bar.at(0.5 m).axial_force;
        output shear_y = bar.at(0.5 m).shear_y;
        output shear_z = bar.at(0.5 m).shear_z;
        output torque = bar.at(0.5 m).torque;
        output moment_y = bar.at(0.5 m).moment_y;
        output moment_z = bar.at(0.5 m).moment_z;
    }
}

rncf::model! {
    /// The same of a section by its centres.
    model ByCentres {
        param ea = 1 N;
        param gay = 1 N;
        param gaz = 1 N;
        param gj = 1 N*m^2;
        param eiy = 1 N*m^2;
        param eiz = 1 N*m^2;
        param ty = 0 m;
        param tz = 0 m;
        param sy = 0 m;
        param sz = 0 m;
        param f1 = 0 N;
        param f2 = 0 N;
        param f3 = 0 N;
        param f4 = 0 N*m;
        param f5 = 0 N*m;
        param f6 = 0 N*m;
        section own {
            EA = ea; GAy = gay; GAz = gaz; GJ = gj; EIy = eiy; EIz = eiz;
            tension_y = ty; tension_z = tz; shear_y = sy; shear_z = sz;
            mass = 1 kg/m; inertia_y = 1 kg*m; inertia_z = 1 kg*m;
        }
        body bar {
            spatial;
            line from [0, 0, 0] m to [1, 0, 0] m;
            section_y [0, 1, 0];
            mesh 2 * beam(own);
        }
        joint root = clamp(bar.start, inertial);
        load pull = force(bar.end, [f1, f2, f3]);
        load turn = moment(bar.end, [f4, f5, f6]);
        // Shear forces bend a bar; this keeps its moments the same everywhere.
        load kept = distributed(bar, [0, 0, 0] N/m, moment = [0 N, f3, -f2]);
        output tip = bar.end.position;
        output ey = bar.end.ey;
        output ez = bar.end.ez;
        output force: N = bar.at(0.5 m).axial_force;
        output shear_y = bar.at(0.5 m).shear_y;
        output shear_z = bar.at(0.5 m).shear_z;
        output torque = bar.at(0.5 m).torque;
        output moment_y = bar.at(0.5 m).moment_y;
        output moment_z = bar.at(0.5 m).moment_z;
    }
}

rncf::model! {
    /// A bar that flies and turns.
    model Flying {
        param mu = 1 kg/m;
        param my = 0 m;
        param mz = 0 m;
        param iy = 1 kg*m;
        param iz = 1 kg*m;
        param iyz = 0 kg*m;
        param v1 = 0 m/s;
        param v2 = 0 m/s;
        param v3 = 0 m/s;
        param v4 = 0 rad/s;
        param v5 = 0 rad/s;
        param v6 = 0 rad/s;
        section own {
            EA = 1000 MN; GAy = 1000 MN; GAz = 1000 MN; GJ = 1000 MN*m^2; EIy = 1000 MN*m^2; EIz = 1000 MN*m^2;
            mass = mu; mass_y = my; mass_z = mz; inertia_y = iy; inertia_z = iz; inertia_yz = iyz;
        }
        fixture ballast on craft { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
        frame craft = free(velocity = [v1, v2, v3], angular_velocity = [v4, v5, v6]);
        body bar in craft {
            spatial;
            line from [-0.5, 0, 0] m to [0.5, 0, 0] m;
            section_y [0, 1, 0];
            mesh 1 * beam(own);
        }
        joint root = clamp(bar.start, craft);
        output momentum = bar.momentum;
        output turning = bar.angular_momentum;
        run { t_end = 1e-6 s; every = 1e-6 s; }
    }
}

/// A strain that is small: beside it its square is left out.
const SMALL: f64 = 1e-5;

type Matrix = [[f64; 6]; 6];

fn set<M: Model>(model: &mut M, name: &str, value: f64) {
    let place = M::params().iter().position(|param| param.name == name).expect(name);
    model.set(place, value);
}

/// The last, or first, row of a vector.
fn at<const N: usize>(history: &History, names: [&str; N], is_last: bool) -> [f64; N] {
    names.map(|name| {
        let column = column(history, name);
        *(if is_last { column.last() } else { column.first() }).expect("a table has rows")
    })
}

/// That under the forces of each column of a stiffness a bar of 1 m has the strain of this column alone, everywhere.
fn has_columns<M: Model>(model: &M, stiffness: &Matrix) {
    for strain in 0..6 {
        let mut bar = model.clone();
        let forces: [f64; 6] = std::array::from_fn(|row| SMALL * stiffness[row][strain]);
        for (row, force) in forces.iter().enumerate() {
            set(&mut bar, &format!("f{}", row + 1), *force);
        }
        let found = static_equilibria(&bar, &EquilibriumSettings::default()).unwrap_or_else(|error| panic!("{error}"));
        let history = &found.history;
        let inside = at(
            history,
            ["force", "shear_y", "shear_z", "torque", "moment_y", "moment_z"],
            true,
        );
        let tip = at(history, ["tip.x", "tip.y", "tip.z"], true);
        let [ey_x, ey_z, ez_x] = at(history, ["ey.x", "ey.z", "ez.x"], true);
        // The end turns from y to z, from z to x, and from x to y.
        let moved = [tip[0] - 1.0, tip[1], tip[2], ey_z, ez_x, -ey_x].map(|value| value / SMALL);
        let mut wanted = [0.0; 6];
        wanted[strain] = 1.0;
        match strain {
            4 => wanted[2] = -0.5,
            5 => wanted[1] = 0.5,
            _ => {}
        }
        let size = stiffness
            .iter()
            .flatten()
            .fold(0.0_f64, |size, value| size.max(value.abs()));
        for row in 0..6 {
            let off = [moved[row] - wanted[row], (inside[row] - forces[row]) / (SMALL * size)];
            assert!(
                off.iter().all(|off| off.abs() < 1e-4),
                "strain {}: {moved:?}, {inside:?} for {forces:?}",
                strain + 1
            );
        }
    }
}

const SECTION: Centres = Centres {
    moduli: [5e6, 2e6, 1.5e6, 3e5, 6e5, 9e5],
    tension: [0.05, 0.11],
    shear: [-0.07, 0.13],
    mass: 7.0,
    center: [0.04, -0.09],
    inertia: [0.3, 0.8, 0.2],
};

#[test]
fn a_unit_strain_gives_the_forces_of_its_column() {
    // No entry is that of another one, none vanishes.
    let mut stiffness = [[0.0; 6]; 6];
    for (place, entry) in STIFFNESS.iter().enumerate() {
        let [row, column] = entry.at;
        let value = if row == column {
            3e5 + 1e4 * place as f64
        } else {
            4e3 * (place as f64 - 9.5)
        };
        (stiffness[row][column], stiffness[column][row]) = (value, value);
    }
    let mut bar = Full::default();
    for entry in &STIFFNESS {
        let [row, column] = entry.at;
        set(&mut bar, &format!("k{}{}", row + 1, column + 1), stiffness[row][column]);
    }
    has_columns(&bar, &stiffness);
}

#[test]
fn centres_give_the_entries_that_are_drawn() {
    let bar = ByCentres {
        ea: SECTION.moduli[0],
        gay: SECTION.moduli[1],
        gaz: SECTION.moduli[2],
        gj: SECTION.moduli[3],
        eiy: SECTION.moduli[4],
        eiz: SECTION.moduli[5],
        ty: SECTION.tension[0],
        tz: SECTION.tension[1],
        sy: SECTION.shear[0],
        sz: SECTION.shear[1],
        ..ByCentres::default()
    };
    has_columns(&bar, &matrix(&STIFFNESS, &SECTION));
}

#[test]
fn a_unit_velocity_gives_the_momenta_of_its_column() {
    let mass = matrix(&MASS, &SECTION);
    for velocity in 0..6 {
        let mut bar = Flying {
            mu: SECTION.mass,
            my: SECTION.center[0],
            mz: SECTION.center[1],
            iy: SECTION.inertia[0],
            iz: SECTION.inertia[1],
            iyz: SECTION.inertia[2],
            ..Flying::default()
        };
        set(&mut bar, &format!("v{}", velocity + 1), 1.0);
        let found = run(&bar, &RunSettings::default()).unwrap_or_else(|error| panic!("{error}"));
        let names = [
            "momentum.x",
            "momentum.y",
            "momentum.z",
            "turning.x",
            "turning.y",
            "turning.z",
        ];
        let found = at(&found.history, names, false);
        for row in 0..6 {
            // The bar is 1 m long, so that its mass turns about y and z, too.
            let along = if row == velocity && row > 3 {
                SECTION.mass / 12.0
            } else {
                0.0
            };
            let wanted = mass[row][velocity] + along;
            assert!(
                (found[row] - wanted).abs() < 1e-9,
                "velocity {}: {found:?}",
                velocity + 1
            );
        }
    }
}

#[test]
fn the_entries_are_drawn() {
    let picture = drawing();
    let path = docs().join("images/section_matrices.svg");
    if std::env::var_os("BLESS").is_some() {
        fs::write(&path, &picture).expect("docs/images is there");
    }
    let kept = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        is_same(&kept, &picture),
        "docs/images/section_matrices.svg is another one: BLESS=1 cargo test -p rncf-guide entries"
    );
}
