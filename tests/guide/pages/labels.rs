//! Names in drawings stand off lines and off each other.

use rncf_guide::labels::{ABOVE_RIGHT, BELOW_LEFT, Sheet};

#[test]
fn names_keep_off_lines_and_each_other() {
    let mut sheet = Sheet::new([2000.0, 2000.0]);
    let center = [1000.0, 1000.0];
    for end in [[1400.0, 600.0], [600.0, 1400.0], [1000.0, 1500.0]] {
        sheet.line(&[center, end]);
    }
    let mut places = Vec::new();
    for name in ["root", "crank", "slider_pin", "bearing"] {
        let placed = sheet.place(name, &[center], &BELOW_LEFT);
        assert_eq!(placed.covers, 0.0, "{name}");
        assert!(!places.contains(&placed.at), "{name}");
        places.push(placed.at);
    }
}

#[test]
fn a_name_goes_along_its_line_where_its_middle_is_crowded() {
    let mut sheet = Sheet::new([2000.0, 2000.0]);
    sheet.line(&[[100.0, 1000.0], [1900.0, 1000.0]]);
    sheet.spot([1000.0, 1000.0], 400.0);
    let placed = sheet.place("beam", &[[1000.0, 1000.0], [300.0, 1000.0]], &ABOVE_RIGHT);
    assert_eq!(placed.covers, 0.0);
    assert!(placed.at[0] < 600.0, "{:?}", placed.at);
}

#[test]
fn where_there_is_no_room_it_is_told() {
    let mut sheet = Sheet::new([400.0, 400.0]);
    sheet.spot([200.0, 200.0], 200.0);
    assert!(sheet.place("beam", &[[200.0, 200.0]], &ABOVE_RIGHT).covers > 0.0);
}
