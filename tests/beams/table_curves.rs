//! Axes whose points come from a file that a run names.

use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;
use std::path::PathBuf;

use rncf::{Formulation, Joints, Model, ModelError};

use crate::blades::{at_rest, near};
use crate::table_files::read;

rncf::model! {
    /// A pipe whose points and sections come from one file.
    pub model Pipe {
        /// Force at the tip.
        param pull = 1 mN;
        param elements: count = 64;
        /// Points and stiffness along the pipe.
        param rows: table = file("beams/data/quarter.csv");
        section wall = columns(rows);
        body pipe { spatial; curve through rows; section_y [0, 0, 1]; mesh elements * beam(wall); }
        joint root = clamp(pipe.start, inertial);
        load up = force(pipe.end, [0 N, 0 N, pull], in = inertial);
        output tip = pipe.end.position;
        output mass = pipe.mass;
    }
}

rncf::model! {
    /// The same pipe, its file being read when it is built.
    pub model PipeOfBuild {
        param pull = 1 mN;
        param elements: count = 64;
        table rows = file("beams/data/quarter.csv");
        section wall = columns(rows);
        body pipe { spatial; curve through rows; section_y [0, 0, 1]; mesh elements * beam(wall); }
        joint root = clamp(pipe.start, inertial);
        load up = force(pipe.end, [0 N, 0 N, pull], in = inertial);
        output tip = pipe.end.position;
        output mass = pipe.mass;
    }
}

rncf::model! {
    /// A cable in a plane and a pipe whose stiffness stands in a table by itself, along one axis, with nodes at the points.
    pub model Layers {
        param way: table = file("guide/tables/points.csv");
        param layup: table = file("beams/data/layup.csv");
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section round = circle(radius = 5 mm);
        section wall { EA = 1 MN; GAy = 1 MN; GAz = 1 MN; GJ = 90 N*m^2; EIy = layup.EI; EIz = layup.EI; mass = 2 kg/m; inertia_y = 0.1 kg*m; inertia_z = 0.1 kg*m; }
        body cable_ { planar xy; curve through way; mesh 8 * cable(round, steel); }
        body pipe { spatial; curve through way; section_y [0, 0, 1]; mesh 2 at way * beam(wall); }
        joint root = clamp(cable_.start, inertial);
        joint foot = clamp(pipe.start, inertial);
        output tip = cable_.end.position;
        output end = pipe.end.position;
        output mass = pipe.mass;
    }
}

/// Length of the natural spline through (0, 0), (1, 0.3), (2, 0.5), (4, 0.2), its parameter being the sum of the chords: curvatures
/// from two equations by Cramer's rule, Simpson's rule with 20,000 parts a span.
const OF_SPLINE: f64 = 4.097_800_134_626_476;

/// A place of the axis by a parameter from 0 to 1, and its derivative, m.
type Path = fn(f64) -> [[f64; 3]; 2];

fn quarter(u: f64) -> [[f64; 3]; 2] {
    let (sine, cosine) = (FRAC_PI_2 * u).sin_cos();
    let whole = 2.0 * FRAC_PI_2;
    [
        [2.0 * sine, 2.0 * (1.0 - cosine), 0.0],
        [whole * cosine, whole * sine, 0.0],
    ]
}

/// A turn and a half about the x axis.
fn helix(u: f64) -> [[f64; 3]; 2] {
    let turn = 6.0 * FRAC_PI_2;
    let (sine, cosine) = (turn * u).sin_cos();
    [
        [3.0 * u, 0.5 * sine, 0.5 * (1.0 - cosine)],
        [3.0, 0.5 * turn * cosine, 0.5 * turn * sine],
    ]
}

/// A file with points of a path, evenly by its parameter, in units and an order of its own, and sections whose bending and torsion
/// are `part` of those at the start.
fn file(path: Path, rows: usize, part: fn(f64) -> f64) -> String {
    let head = "z [cm], EA [kN], GAy [MN], GAz [MN], EIz [kN*m^2], EIy [kN*m^2], GJ [kN*m^2], mass [kg/m], inertia_y [kg*m], inertia_z [kg*m], y [mm], x [m]";
    let mut text = format!("{head}\n");
    for row in 0..rows {
        let u = row as f64 / (rows - 1) as f64;
        let ([x, y, z], part) = (path(u)[0], part(u));
        let (stiff, around, twisted) = (0.3 * part, 0.2 * part, 0.15 * part);
        let (z, y) = (100.0 * z, 1000.0 * y);
        let _ = writeln!(
            text,
            "{z}, 1000, 1, 1, {stiff}, {around}, {twisted}, 2, 0.01, 0.02, {y}, {x}"
        );
    }
    text
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    a.map(|x| x / dot(a, a).sqrt())
}

/// Castigliano's theorem on the path itself: how far the tip moves along z under a force along z, and the length of the axis; Simpson's rule.
fn by_castigliano(path: Path, part: fn(f64) -> f64, pull: f64) -> [f64; 2] {
    const PARTS: usize = 4000;
    let force = [0.0, 0.0, 1.0];
    let tip = path(1.0)[0];
    let mut sums = [0.0; 2];
    for at in 0..=PARTS {
        let u = at as f64 / PARTS as f64;
        let [place, slope] = path(u);
        let speed = dot(slope, slope).sqrt();
        let tangent = unit(slope);
        let off: [f64; 3] = std::array::from_fn(|i| force[i] - dot(force, tangent) * tangent[i]);
        let y = unit(off);
        let z = cross(tangent, y);
        let moment = cross(std::array::from_fn(|i| tip[i] - place[i]), force);
        let stiff = [150.0, 200.0, 300.0].map(|at_start| at_start * part(u));
        let bent: f64 = [tangent, y, z]
            .iter()
            .zip(stiff)
            .map(|(axis, stiff)| dot(moment, *axis).powi(2) / stiff)
            .sum();
        let strained: f64 = [tangent, y, z].iter().map(|axis| dot(force, *axis).powi(2) / 1e6).sum();
        let weight = if at == 0 || at == PARTS {
            1.0
        } else if at % 2 == 1 {
            4.0
        } else {
            2.0
        };
        let width = weight / (3 * PARTS) as f64 * speed;
        sums[0] += width * pull * (bent + strained);
        sums[1] += width;
    }
    sums
}

/// Of an even quarter of a circle of radius R the same is P R^3 (pi / 4 / EI + (3 pi / 4 - 2) / GJ) + P pi R / (2 GA).
#[test]
fn castiglianos_sum_is_that_of_a_quarter_of_a_circle() {
    let [found, length] = by_castigliano(quarter, |_| 1.0, 1e-3);
    let wanted = 8e-3 * (FRAC_PI_2 / 2.0 / 300.0 + (1.5 * FRAC_PI_2 - 2.0) / 150.0) + 1e-3 * FRAC_PI_2 * 2.0 / 1e6;
    near(&[found, length], &[wanted, 2.0 * FRAC_PI_2], 1e-12);
}

#[test]
fn the_axis_follows_the_points_of_the_file() {
    let mut pipe = Pipe::default();
    let check = |pipe: &Pipe, path: Path, part, relative: f64| {
        let [bent, length] = by_castigliano(path, part, pipe.pull);
        let [x, y, z] = path(1.0)[0];
        let found = at_rest(pipe);
        near(&[found[2] - z, found[3]], &[bent, 2.0 * length], relative);
        assert!((found[0] - x).hypot(found[1] - y) < 2.0 * bent, "{found:?}");
    };
    let tapered = |u: f64| 1.0 - 0.5 * u;
    check(&pipe, quarter, tapered, 2e-4);
    // More rows and fewer, even sections, another curve.
    pipe.rows = read(pipe.rows, "even", &file(quarter, 65, |_| 1.0)).unwrap();
    check(&pipe, quarter, |_| 1.0, 1e-4);
    pipe.rows = read(pipe.rows, "coarse", &file(quarter, 17, |_| 1.0)).unwrap();
    check(&pipe, quarter, |_| 1.0, 1e-3);
    pipe.elements = 144;
    pipe.rows = read(pipe.rows, "helix", &file(helix, 241, tapered)).unwrap();
    check(&pipe, helix, tapered, 2e-4);
    // In absolute coordinates, too.
    let scene = pipe.build(Formulation::Ancf, Joints::Eliminated).unwrap();
    assert_eq!(scene.bodies()[0].elements, 144);
    // Too few of them are told by the name that the statement takes.
    pipe.elements = 16;
    let mut scene = pipe.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    let start = scene.rest(0.0);
    let found = scene
        .warnings(&start)
        .into_iter()
        .map(|warning| warning.text)
        .collect::<String>();
    assert!(
        found.contains("helix.csv` for `rows` has 241 rows") && found.contains("`mesh at rows * ..`"),
        "{found}"
    );
}

/// Read by the program or when it is built, the rows are the same, and so are all bits.
#[test]
fn a_file_of_the_run_and_one_of_the_build_give_the_same_bits() {
    let mut pipe = Pipe::default();
    let of_build = at_rest(&PipeOfBuild::default());
    assert_eq!(at_rest(&pipe), of_build);
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    pipe.rows = pipe.rows.read(folder.join(pipe.rows.path())).unwrap();
    assert!(pipe.rows.number() != 0.0);
    assert_eq!(at_rest(&pipe), of_build);
}

/// Nodes at the points, sections by the arclength in m, a planar body along the same points.
#[test]
fn tables_along_one_axis_go_together() {
    let mut layers = Layers::default();
    let elements = |layers: &Layers| {
        let scene = layers.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        scene.bodies()[1].elements
    };
    assert_eq!(elements(&layers), 4);
    let head = "x [m], y [m], z [m]\n";
    layers.way = read(
        layers.way,
        "longer",
        &format!("{head}0,0,0\n1,0.3,0\n2,0.5,0\n4,0.2,0\n"),
    )
    .unwrap();
    assert_eq!(elements(&layers), 6);
    let found = at_rest(&layers);
    assert_eq!(&found[..5], &[4.0, 0.2, 4.0, 0.2, 0.0]);
    near(&found[5..], &[2.0 * OF_SPLINE], 1e-11);
}

#[test]
fn points_that_are_no_axis_are_told() {
    let head = "x [m], y [m], z [m]\n";
    let built = |way: &str, layup: Option<&str>| -> Result<(), ModelError> {
        let mut layers = Layers::default();
        layers.way = read(layers.way, "way", &format!("{head}{way}"))?;
        if let Some(rows) = layup {
            layers.layup = read(layers.layup, "layup", &format!("x [m], EI [N*m^2]\n{rows}"))?;
        }
        layers.build(Formulation::Rncf, Joints::Eliminated).map(|_| ())
    };
    let told = |way: &str, layup: Option<&str>, parts: &[&str]| {
        let found = built(way, layup).unwrap_err().to_string();
        assert!(parts.iter().all(|part| found.contains(part)), "{found}");
    };
    built("0,0,0\n1,1,0\n", None).unwrap();
    told(
        "0,0,0\n1,1,0\n2,2,-0.5\n",
        None,
        &[
            "body `cable_`",
            "z = -0.5 m in row 3",
            "way.csv` for `way`",
            "the plane xy",
        ],
    );
    told(
        "0,0,0\n1,1,0\n1,1,0\n2,0,0\n",
        None,
        &["line 4", "way.csv` for `way`", "where the one before"],
    );
    told(
        "0,0,0\n1e308,1e308,0\n-1e308,1,0\n",
        None,
        &["line 3", "finite distance"],
    );
    told(
        "0,0,0\n1,1,0\n8,8,0\n",
        None,
        &[
            "table `layup` has rows from 0 to 9 m",
            "the axis of body `pipe` goes from 0 to 11.3",
        ],
    );
    told(
        "0,0,0\n3,0,0\n",
        Some("0, 100\n2.9, 100\n"),
        &["layup.csv` for `layup` has rows from 0 to 2.9 m", "goes from 0 to 3 m"],
    );
    let mut pipe = Pipe::default();
    let with = |points: &str| {
        let rows = points.lines().map(|point| format!("{point},1,1,1,1,1,1,1,1,1\n"));
        rows.collect::<String>()
    };
    let (up, over) = ("0,0,0\n1,0,0.1\n1.5,0,1\n2,0,3\n", "0,0,0\n1,0,0.1\n1.5,0,1\n1.5,0,3\n");
    let head = "x [m], y [m], z [m], EA [N], GAy [N], GAz [N], GJ [N*m^2], EIy [N*m^2], EIz [N*m^2], mass [kg/m], inertia_y [kg*m], inertia_z [kg*m]\n";
    pipe.rows = read(pipe.rows, "up", &format!("{head}{}", with(up))).unwrap();
    pipe.build(Formulation::Rncf, Joints::Eliminated).unwrap();
    // The spline leans back before its end, between two nodes.
    pipe.rows = read(pipe.rows, "over", &format!("{head}{}", with(over))).unwrap();
    let found = pipe
        .build(Formulation::Rncf, Joints::Eliminated)
        .err()
        .unwrap()
        .to_string();
    assert!(found.contains("`section_y`") && found.contains("at x = 2.9"), "{found}");
    let straight = "0,0,0,1,1,1,1,1,1,1,1,1\n0,0,3,1,1,1,1,1,1,1,1,1\n";
    pipe.rows = read(pipe.rows, "straight", &format!("{head}{straight}")).unwrap();
    let found = pipe
        .build(Formulation::Rncf, Joints::Eliminated)
        .err()
        .unwrap()
        .to_string();
    assert!(
        found.contains("`section_y`") && found.contains("at its start"),
        "{found}"
    );
}
