//! Params that name the file of a table: another file gives what its rows say, and a wrong one is told.

use std::path::PathBuf;

use rncf::{Formulation, Joints, Model, ModelError, TableFile};

use crate::blades::{at_rest, near};

rncf::model! {
    /// A cantilever whose bending stiffness and twist come from a file.
    pub model Mast {
        /// Force at the tip along z.
        param pull = 0.01 N;
        param length = 2 m;
        param elements: count = 8;
        /// Stiffness along the mast.
        param rows: table = file("beams/data/mast.csv");
        section pole {
            EA = 1 MN; GAy = 1000 MN; GAz = 1000 MN; GJ = 200 N*m^2; EIy = rows.EI; EIz = 4 * rows.EI;
            mass = 2 kg/m; inertia_y = 0.01 kg*m; inertia_z = 0.02 kg*m;
        }
        body mast {
            spatial;
            line from [0 m, 0 m, 0 m] to [length, 0 m, 0 m];
            twist rows.turn;
            mesh elements * beam(pole);
        }
        joint root = clamp(mast.start, inertial);
        load down = force(mast.end, [0 N, 0 N, pull], in = inertial);
        output tip = mast.end.position;
    }
}

rncf::model! {
    /// A strip by the columns of a file, with its nodes at the rows, in a wind that lifts it by a second file.
    pub model Strip {
        param each: count = 4;
        param alpha = 15 deg;
        param rows: table = file("beams/data/strip.csv");
        param polar: table = file("beams/data/polar.csv", at = alpha);
        section layup = columns(rows);
        body strip { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh each at rows * beam(layup); }
        joint root = clamp(strip.start, inertial);
        load air = distributed(strip, [0 [N/m], 0 [N/m], 0.01 [N/m] * polar.lift(alpha)]);
        output tip = strip.end.position;
        output mass = strip.mass;
    }
}

struct File(PathBuf);

impl File {
    fn new(name: &str, text: &str) -> Self {
        let path = std::env::temp_dir().join(format!("rncf-{}-{name}.csv", std::process::id()));
        std::fs::write(&path, text).unwrap();
        Self(path)
    }
}

impl Drop for File {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

pub(super) fn read(of: TableFile, name: &str, text: &str) -> Result<TableFile, ModelError> {
    of.read(&File::new(name, text).0)
}

/// Of a force P at the tip of a mast of length L whose stiffness falls along a line, EI = c + d s at the distance s from the tip:
/// the integral of P s^2 / EI.
#[test]
fn a_tapered_mast_from_a_file_bends_as_its_integral_says() {
    let mut mast = Mast::default();
    let even = at_rest(&mast);
    near(&even[2..3], &[0.01 * 8.0 / 3.0 / 200.0], 1e-6);
    // Columns in another order and other units; the section does not turn.
    mast.rows = read(
        mast.rows,
        "tapered",
        "turn[deg], EI [kN*m^2], x [cm]\n0, 0.3, 0\n0, 0.05, 200\n",
    )
    .unwrap();
    mast.elements = 32;
    let (c, d, length) = (50.0, 125.0, 2.0_f64);
    let integral =
        length.powi(2) / (2.0 * d) - c * length / d.powi(2) + c * c / d.powi(3) * (1.0 + d * length / c).ln();
    near(&at_rest(&mast)[2..3], &[0.01 * integral], 2e-6);
    // Turned by a quarter it bends about its stiff axis.
    mast.rows = read(
        mast.rows,
        "turned",
        "x [m], EI [N*m^2], turn [deg]\n0, 200, 90\n2, 200, 90\n",
    )
    .unwrap();
    near(&at_rest(&mast)[2..3], &[0.01 * 8.0 / 3.0 / 800.0], 1e-6);
    mast.elements = 8;
    // And back: numbers of params are those of files.
    let number = mast.get(3);
    mast.set(3, 0.0);
    assert_eq!(at_rest(&mast), even);
    mast.set(3, number);
    near(&at_rest(&mast)[2..3], &[0.01 * 8.0 / 3.0 / 800.0], 1e-6);
    let again = read(
        mast.rows,
        "turned",
        "x [m], EI [N*m^2], turn [deg]\n0, 200, 90\n2, 200, 90\n",
    )
    .unwrap();
    assert_eq!((again, again.number()), (mast.rows, number));
}

/// The file that a model was built with gives the same bits when it is read by the program.
#[test]
fn the_file_of_the_build_reads_to_the_same_bits() {
    let strip = Strip::default();
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    for declared in [strip.rows, strip.polar] {
        let file = declared.read(folder.join(declared.path())).unwrap();
        assert_eq!((file.places, file.columns), (declared.places, declared.columns));
        assert!(file.number() != 0.0);
    }
}

/// Columns of sections, nodes at the rows, and a table that is looked up: under q the tip of a cantilever moves by q L^4 / (8 EI).
#[test]
fn sections_nodes_and_polars_follow_their_files() {
    let mut strip = Strip::default();
    let tip = |lift: f64, stiffness: f64| [0.01 * lift * 16.0 / 8.0 / stiffness];
    near(&at_rest(&strip)[2..3], &tip(0.5, 300.0), 2e-3);
    let elements = |strip: &Strip| {
        let scene = strip.build(Formulation::Rncf, Joints::Eliminated).unwrap();
        scene.bodies()[0].elements
    };
    assert_eq!(elements(&strip), 4);
    let head = "eta, EA [MN], GAy [MN], GAz [MN], GJ [N*m^2], EIy [N*m^2], EIz [N*m^2], mass [kg/m], inertia_y [kg*m], inertia_z [kg*m], _from";
    let row = |eta: f64| format!("{eta}, 1, 1, 1, 200, 600, 100, 3, 0.01, 0.02, page 7\n");
    let text = format!("{head}\n{}{}{}", row(0.0), row(0.25), row(1.0));
    strip.rows = read(strip.rows, "stiffer", &text).unwrap();
    strip.polar = read(strip.polar, "polar", "alpha [rad], lift\n0, 0\n0.5235987755982988, 2\n").unwrap();
    assert_eq!(elements(&strip), 8);
    let found = at_rest(&strip);
    near(&found[2..3], &tip(1.0, 600.0), 2e-3);
    near(&found[3..4], &[6.0], 1e-12);
}

#[test]
fn wrong_rows_are_told() {
    let mut mast = Mast::default();
    let mut told = |name: &str, text: &str| {
        let build = |rows| {
            mast.rows = rows;
            mast.build(Formulation::Rncf, Joints::Eliminated).map(|_| ())
        };
        read(Mast::default().rows, name, text)
            .and_then(build)
            .unwrap_err()
            .to_string()
    };
    let head = "x [m], EI [N*m^2], turn [deg]\n";
    let negative = told("negative", &format!("{head}0, 200, 0\n1, -5, 0\n2, 200, 0\n"));
    assert!(
        negative.contains("row 2 of table")
            && negative.contains("negative.csv` for `rows`")
            && negative.contains("bending about y"),
        "{negative}"
    );
    let short = told("short", &format!("{head}0, 200, 0\n1.5, 200, 0\n"));
    assert!(
        short.contains("has rows from 0 to 1.5 m") && short.contains("short.csv` for `rows`"),
        "{short}"
    );
    let jump = told("jump", &format!("{head}0, 200, 0\n1, 200, 0\n1, 200, 10\n2, 200, 10\n"));
    assert!(
        jump.contains("twist jumps by 10.0000 deg at x = 1.000000 m") && jump.contains("jump.csv` for `rows`"),
        "{jump}"
    );
    let order = told("order", &format!("{head}0, 200, 0\n-1, 200, 0\n"));
    assert!(order.contains("line 3: places of rows ascend"), "{order}");
    // A number that no file has.
    mast.set(3, 7.0);
    let unread = mast
        .build(Formulation::Rncf, Joints::Eliminated)
        .err()
        .unwrap()
        .to_string();
    assert!(unread.contains("the number of no file"), "{unread}");
}
