//! Files that are read, and damaged ones that are refused.

use super::{File, FiniteElements, Matrices};

const BEAM: &[u8] = include_bytes!("../../../../tests/reference/data/beam.npz");
const BEAM_MM: &[u8] = include_bytes!("../../../../tests/reference/data/beam_mm.npz");
/// A rod of one element along x with translations alone: 2 kg, 1 m.
const MASS: &str = "%%MatrixMarket matrix coordinate real symmetric\n% a rod\n6 6 9\n1 1 0.666666666666667\n2 2 0.666666666666667\n\
3 3 0.666666666666667\n4 4 0.666666666666667\n5 5 0.666666666666667\n6 6 0.666666666666667\n4 1 0.333333333333333\n\
5 2 0.333333333333333\n6 3 0.333333333333333\n";
const STIFFNESS: &str = "%%MatrixMarket matrix coordinate real general\n6 6 4\n1 1 5.0\n1 4 -5.0\n4 1 -5.0\n4 4 5e0\n";
const NODES: &str = "id, x, y, z\n7, 0, 0, 0\n9, 1.0, 0, 0\n";
/// One mode of two nodes.
const FEM: &str = "** a remark\n** RECORD GROUP 1, HEADER\nREV0 2 1 0 0 0\n**\n** RECORD GROUP 2, NODES\n7 9\n\
** RECORD GROUP 3\n0\n** RECORD GROUP 4\n0\n** RECORD GROUP 5\n0.\n1.D0\n** RECORD GROUP 6\n0 0\n** RECORD GROUP 7\n0 0\n\
** RECORD GROUP 8\n** mode 1\n-1 0 0 0 0 0\n1 0 0 0 0 0\n** RECORD GROUP 9\n2\n** RECORD GROUP 10\n20\n** RECORD GROUP 11\n\
1 1 1 0 0 0\n1 1 1 0 0 0\n";

fn read(path: &str, bytes: &[u8]) -> Result<FiniteElements, String> {
    FiniteElements::read(&[File { path, bytes }])
}

fn market(mass: &str, stiffness: &str, nodes: &str) -> Result<FiniteElements, String> {
    let files = [("m.mtx", mass), ("k.mtx", stiffness), ("nodes.csv", nodes)];
    FiniteElements::read(&files.map(|(path, text)| File {
        path,
        bytes: text.as_bytes(),
    }))
}

fn full(body: &FiniteElements) -> [&super::Sparse; 2] {
    match &body.matrices {
        Matrices::Full { mass, stiffness } => [mass, stiffness],
        Matrices::Modal { .. } => panic!("whole matrices"),
    }
}

#[test]
fn deflated_and_stored_dense_and_sparse_arrays_are_read_alike() {
    let (beam, other) = (read("beam.npz", BEAM).unwrap(), read("beam_mm.npz", BEAM_MM).unwrap());
    assert_eq!((beam.nodes.len(), beam.per_node), (9, 6));
    assert_eq!(beam.ids, [10, 20, 30, 40, 50, 60, 70, 80, 90]);
    assert_eq!(beam.nodes[8], [2.0, 0.0, 0.0]);
    assert_eq!(other.nodes[8], [2000.0, 0.0, 0.0]);
    let scale = |at: usize| if at % 6 < 3 { 1.0 } else { 1e3 };
    for (own, other) in full(&beam).into_iter().zip(full(&other)) {
        for (row, entries) in own.rows.iter().enumerate() {
            for &(column, value) in entries {
                let expected = value * 1e-3 * scale(row) * scale(column);
                assert!((other.at(row, column) - expected).abs() <= 1e-14 * expected.abs());
            }
        }
    }
}

#[test]
fn matrix_market_is_read_in_coordinates_and_as_an_array() {
    let body = market(MASS, STIFFNESS, NODES).unwrap();
    assert_eq!((body.ids.as_slice(), body.per_node), (&[7, 9][..], 3));
    let [mass, stiffness] = full(&body);
    assert_eq!((mass.at(0, 3), stiffness.at(0, 3)), (0.333333333333333, -5.0));
    let values = [5, 0, 0, -5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 0, 0, 0];
    let array = values.map(|value: i32| format!("{value}\n")).concat();
    let array = format!("%%MatrixMarket matrix array real symmetric\n6 6\n{array}");
    assert_eq!(full(&market(MASS, &array, NODES).unwrap())[1], stiffness);
}

#[test]
fn modes_of_a_text_file_are_read() {
    let body = read("rod.fem", FEM.as_bytes()).unwrap();
    assert_eq!((body.ids.as_slice(), body.nodes[1]), (&[7, 9][..], [1.0, 0.0, 0.0]));
    let modes = body.modes.unwrap();
    assert_eq!((modes.count, modes.values[0], modes.values[6]), (1, -1.0, 1.0));
}

#[test]
fn what_is_wrong_is_told() {
    let told = |found: Result<FiniteElements, String>, words: &[&str]| {
        let message = found.unwrap_err();
        assert!(words.iter().all(|word| message.contains(word)), "{message}");
    };
    told(read("beam.npz", &BEAM[..BEAM.len() / 2]), &["beam.npz", "cut off"]);
    told(read("beam.dat", BEAM), &["beam.dat", ".npz", ".fem", "nodes.csv"]);
    told(
        market(&MASS.replace("6 6 9", "6 6 10"), STIFFNESS, NODES),
        &["m.mtx", "cut off"],
    );
    told(
        market(&MASS.replace("0.666666666666667\n2", "nan\n2"), STIFFNESS, NODES),
        &["`M`", "not finite"],
    );
    told(
        market(MASS, &STIFFNESS.replace("1 4 -5.0", "1 4 -4.0"), NODES),
        &["`K`", "not symmetric", "row 1, column 4"],
    );
    told(market(MASS, STIFFNESS, &NODES.replace("9,", "7,")), &["two nodes", "7"]);
    told(
        market(MASS, STIFFNESS, &NODES.replace("9, 1.0", "9, inf")),
        &["node 9", "not finite"],
    );
    told(
        market(MASS, STIFFNESS, &format!("{NODES}11, 2, 0, 0\n")),
        &["6 rows", "3 nodes"],
    );
    told(market(&MASS.replace("real", "complex"), STIFFNESS, NODES), &["complex"]);
    told(
        read("rod.fem", FEM.replace("-1 0 0 0 0 0\n", "-1 0 0 0 0\n").as_bytes()),
        &["group 8", "11", "12"],
    );
    told(
        read("rod.fem", FEM.replace("REV0 2 1 0 0 0", "REV0 2 1 0 0 9").as_bytes()),
        &["header"],
    );
}

/// Every damaged file is read or refused.
#[test]
fn damaged_files_do_not_panic() {
    let mut seed = 7_u64;
    let mut next = |below: usize| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    for (path, bytes) in [("beam.npz", BEAM), ("beam.npz", BEAM_MM), ("rod.fem", FEM.as_bytes())] {
        for length in (0..bytes.len()).step_by(1 + bytes.len() / 300) {
            let _ = read(path, &bytes[..length]);
        }
        for _ in 0..400 {
            let mut damaged = bytes.to_vec();
            for _ in 0..=next(3) {
                let at = next(damaged.len());
                damaged[at] = next(256) as u8;
            }
            let _ = read(path, &damaged);
        }
    }
    for _ in 0..1000 {
        let mut texts = [MASS, STIFFNESS, NODES].map(|text| text.as_bytes().to_vec());
        let which = next(3);
        let at = next(texts[which].len());
        texts[which][at] = b"0123456789 .,-eE%\nx"[next(19)];
        let [mass, stiffness, nodes] = texts.each_ref().map(|text| std::str::from_utf8(text).unwrap_or(""));
        let _ = market(mass, stiffness, nodes);
    }
    // The part behind the checksums, too.
    for _ in 0..400 {
        let mut array =
            b"\x93NUMPY\x01\x00\x46\x00{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }            \n"
                .to_vec();
        array.extend([0; 32]);
        let at = next(array.len());
        array[at] = next(256) as u8;
        let _ = super::array::Array::read(&array);
    }
}

#[test]
fn rows_have_heads_lines_and_numbers() {
    use super::rows::{Disorder, Mistake, Rows, in_order};
    let text = "\u{feff}# a mast\n\nx [in], EI[kN*in^2], _by, k [-]\n0, 1, hand, 2\n\n1, 3, hand, soft\n";
    let rows = Rows::read(text).unwrap();
    let spelled: Vec<String> = rows.heads.iter().map(|head| head.spelled()).collect();
    assert_eq!(spelled, ["inch", "kN*inch^2", "", ""]);
    assert_eq!(rows.heads.iter().position(|head| head.is_note()), Some(2));
    let number = |_: usize, cell: &str| cell.parse().ok();
    assert_eq!(rows.columns(&[1, 0], number).unwrap(), [[1.0, 3.0], [0.0, 1.0]]);
    let (line, name, cell) = (6, "k", "soft");
    assert_eq!(rows.columns(&[0, 3], number), Err(Mistake::Number { line, name, cell }));
    assert_eq!((rows.line(0), rows.line(1)), (4, 6));
    let mistake = Mistake::Cells {
        line: 2,
        cells: 1,
        heads: 2,
        separator: ',',
    };
    assert_eq!(Rows::read("x, y\n1\n"), Err(mistake));
    assert_eq!(Rows::read("# nothing\n"), Err(Mistake::Empty));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 2.0], false), Ok(()));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 2.0], true), Err(Disorder::Order(2)));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 1.0, 2.0], false), Err(Disorder::Order(3)));
    assert_eq!(in_order(&[0.0, 1.0, 1.0], false), Err(Disorder::StepAtEnd));
    assert_eq!(in_order(&[0.0], false), Err(Disorder::TooFew));
}

/// What programs write that is a table all the same.
#[test]
fn odd_texts_are_the_same_table() {
    use super::rows::Rows;
    let texts = [
        "x [m], EI\n0, 1.5\n2, -3e5\n",
        // A byte order mark, and no end of the last line.
        "\u{feff}x [m], EI\n0, 1.5\n2, -3e5",
        "x [m], EI\r\n0, 1.5\r\n2, -3e5\r\n",
        "x [m], EI\r0, 1.5\r2, -3e5\r",
        "x [m]; EI\n0; 1.5\n2; -3e5\n",
        "x [m]\tEI\n0\t1.5\n2\t-3E5\n",
        "\"x [m]\",\"EI\"\n\"0\",\"1.5\"\n\"2\", \"-3e5\"\n",
        "\"x\" [m],\"EI\"\n0,1.5\n2,-3e5\n",
        "# by hand\n\n  \nx[m],EI[-]\n# the root\n0,+1.50\n\n2,-3.e+5\n\n",
        // A spreadsheet with empty cells.
        "x [m],EI,,\n0,1.5,,\n,,,\n2,-3e5,\n",
        "x [m]\tEI\t\n0\t1.5\t\n2\t-3e5\t\n",
        // Text with the separator and with quotation marks, in a column that nothing reads.
        "x [m], _by, EI\n0, \"hand, \"\"once\"\", twice\", 1.5\n2, 5\" pipe, -3e5\n",
    ];
    for text in texts {
        let rows = Rows::read(text).unwrap_or_else(|mistake| panic!("{text:?}: {mistake}"));
        let place = rows.heads.iter().position(|head| head.name == "EI").unwrap();
        let values = rows.columns(&[0, place], |_, cell| cell.parse().ok());
        assert_eq!(values.unwrap(), [[0.0, 2.0], [1.5, -3e5]], "{text:?}");
        assert_eq!((rows.heads[0].name, rows.heads[0].unit), ("x", "m"), "{text:?}");
    }
}

#[test]
fn texts_that_are_no_table_are_told_with_line_and_cure() {
    use super::rows::Rows;
    let cases = [
        ("", "it is empty; its first line names the columns"),
        ("\u{feff}\r\n# x, EI\r\n", "it is empty"),
        (
            "0, 1\n1, 2\n",
            "line 1: `0` is no name of a column; the first line that is no comment",
        ),
        ("# x [m], EI\n0, 1\n", "line 2: `0` is no name of a column"),
        (",x, EI\n0,0,1\n", "line 1: column 1 has no name; take it out"),
        (",,\n0,0\n", "line 1: column 1 has no name"),
        ("x (m), EI\n", "line 1: `x (m)` is no name with a unit"),
        (
            "x [m] EI [N]\n0 1\n",
            "line 1: `x [m] EI [N]` is no name with a unit, `EI [N*m^2]`; between columns stand",
        ),
        ("x EI\n0 1\n", "line 1: `x EI` is no name with a unit"),
        ("x [m, EI\n", "line 1: `x [m` is no name with a unit"),
        ("[m], EI\n", "line 1: `[m]` is no name with a unit"),
        ("x, EI\n0, \"1\n", "line 2: a quotation mark is not closed"),
        ("x, EI\n0\n", "line 2 has 1 cells, and the header 2 columns"),
        (
            "x, EI\n0, 1, 2\n",
            "line 2 has 3 cells, and the header 2 columns; give each column its cell, with commas",
        ),
        (
            "x, EI\n\n0,5, 1,5\n",
            "line 3 has 4 cells, and the header 2 columns; give each column its cell, with commas between them and points in decimals",
        ),
        (
            "x; EI\n0, 1\n",
            "line 2 has 1 cells, and the header 2 columns; give each column its cell, with semicolons",
        ),
        (
            "x; EI\n0; 1,5\n",
            "line 2: `1,5` in column `EI` is no finite number; decimals have a point",
        ),
        (
            "x\tEI\n0\t1,5e3\n",
            "`1,5e3` in column `EI` is no finite number; decimals have a point",
        ),
        (
            "x, EI\n0, 1.5D+05\n",
            "`1.5D+05` in column `EI` is no finite number; an exponent is written with `e`",
        ),
        ("x, EI\n0, \u{2212}1.5\n", "is no finite number; its sign is no `-`"),
        (
            "x, EI\n0, 1 # root\n",
            "`1 # root` in column `EI` is no finite number; a comment has a line of its own",
        ),
        (
            "x, EI\n0, 1 kN\n",
            "`1 kN` in column `EI` is no finite number; units stand in the header",
        ),
        ("x, EI\n0, NaN\n", "line 2: `NaN` in column `EI` is no finite number"),
        (
            "x, EI\n0, 1\n1, -inf\n",
            "line 3: `-inf` in column `EI` is no finite number",
        ),
        (
            "x, EI\n0, \n",
            "line 2: there is nothing in column `EI`; give every row its number",
        ),
        (
            "x, EI\n0, 1e400\n",
            "`1e400` in column `EI` is no finite number; it is too large or too small",
        ),
        (
            "x, EI\n0, 1e-400\n",
            "`1e-400` in column `EI` is no finite number; it is too large or too small",
        ),
        ("x, EI\n0, 1_000\n", "`1_000` in column `EI` is no finite number"),
        ("x, EI\n0, .\n", "`.` in column `EI` is no finite number"),
        ("x, EI\n0, 0x10\n", "`0x10` in column `EI` is no finite number"),
    ];
    for (text, wanted) in cases {
        let numbers = |rows: &Rows| {
            rows.columns(&[0, 1], |_, cell| cell.parse().ok())
                .map(drop)
                .map_err(|mistake| mistake.to_string())
        };
        let found = match Rows::read(text) {
            Ok(rows) => numbers(&rows),
            Err(mistake) => Err(mistake.to_string()),
        };
        let told = found.expect_err(text);
        assert!(told.contains(wanted), "{text:?}: {told}");
    }
    // Zero is a number, however it is written.
    let rows = Rows::read("x, EI\n0e5, -0.00e-7\n").unwrap();
    let zeros = rows.columns(&[0, 1], |_, cell| cell.parse().ok()).unwrap();
    assert_eq!(zeros, [[0.0], [0.0]]);
}
