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
    let (line, cells, heads) = (2, 1, 2);
    assert_eq!(Rows::read("x, y\n1\n"), Err(Mistake::Cells { line, cells, heads }));
    assert_eq!(Rows::read("# nothing\n"), Err(Mistake::Empty));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 2.0], false), Ok(()));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 2.0], true), Err(Disorder::Order(2)));
    assert_eq!(in_order(&[0.0, 1.0, 1.0, 1.0, 2.0], false), Err(Disorder::Order(3)));
    assert_eq!(in_order(&[0.0, 1.0, 1.0], false), Err(Disorder::StepAtEnd));
    assert_eq!(in_order(&[0.0], false), Err(Disorder::TooFew));
}
