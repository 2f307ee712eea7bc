//! The records read as they are described, and agree with the table of extremes.

use rncf_reference::table::{EXTREMES, History, Record};

#[test]
fn records_hold_the_extremes_of_the_table() {
    for (record, row) in [
        (Record::Spin4Elements6, EXTREMES[2]),
        (Record::Spin4Elements16, EXTREMES[3]),
        (Record::Spin10Elements16, EXTREMES[11]),
        (Record::Spin100Elements24, EXTREMES[9]),
    ] {
        let history = record.history().unwrap();
        let (time, v) = history.least_v().unwrap();
        assert!(
            (time - row.time).abs() < 1e-9 && (v - row.v).abs() < 5.1e-7,
            "{record:?}: {v} at {time}"
        );
        let u = history.u.iter().copied().fold(0.0, f64::min);
        assert!((u - row.u).abs() < 5.1e-7, "{record:?}: {u}");
    }
}

#[test]
fn every_record_is_on_the_grid_of_a_tenth() {
    for record in Record::ALL {
        let history = record.history().unwrap();
        assert!(history.t.len() >= 181);
        for (k, t) in history.t.iter().enumerate() {
            assert!((t - 0.1 * k as f64).abs() < 1e-9);
        }
    }
    // The exact curvature changes the extremes at 10 rad/s by less than 5e-5 m, but not by nothing.
    let [polynomial, exact] = [Record::Spin10Elements16, Record::Spin10Elements16Exact].map(|r| r.history().unwrap());
    let change = (polynomial.least_v().unwrap().1 - exact.least_v().unwrap().1).abs();
    assert!(change < 5e-5 && change > 1e-5);
}

#[test]
fn broken_text_is_named() {
    let heading = "# from\nt [s],u [m],v [m]\n";
    let broken = |text: &str| History::parse(&format!("{heading}{text}")).unwrap_err();
    assert!(History::parse("").unwrap_err().contains("empty"));
    assert!(History::parse("t,u,v\n").unwrap_err().contains("heading"));
    assert!(broken("0,1\n").contains("line 3"));
    assert!(broken("0,1,x\n").contains("three numbers"));
    assert!(broken("0,1,2,3\n").contains("three numbers"));
    assert!(broken("0,1,NaN\n").contains("finite"));
    assert!(broken("0,1,2\n0,1,2\n").contains("increase"));
    assert_eq!(
        History::parse(&format!("{heading}0,1,2\n0.5,3,4\n")).unwrap().least_v(),
        Ok((0.0, 2.0))
    );
}
