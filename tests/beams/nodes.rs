//! Nodes stand where something acts: what acts within a body bends it as exactly as what acts at its end.

use rncf::AnyModel;
use rncf::app::{EquilibriumSettings, Judging, modes, static_equilibria};

rncf::model! {
    /// Cantilevers of 1 m with a moment at 0.37 m: alone, and two in a loop; and one whose moment comes from a welded arm.
    pub model Within {
        param n: count = 8;
        param moment = 0.1 N*m;
        param at = 0.37 m;
        const down = -0.5 N;
        material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
        section bar { area = 1e-3 m^2; second_moment = 1e-6 m^4; }
        body alone { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh n * cable(bar, steel); }
        joint foot = clamp(alone.start, inertial);
        load bend = moment(alone.at(at), [0 [N*m], 0 [N*m], moment]);
        for i in 0..2 {
            body pair[i] { planar xy; line from [0 m, 1 m + i * 1 m, 0 m] to [1 m, 1 m + i * 1 m, 0 m]; mesh n * cable(bar, steel); }
            joint root[i] = clamp(pair[i].start, inertial);
            load turn[i] = moment(pair[i].at(at), [0 [N*m], 0 [N*m], moment]);
        }
        body girder { planar xy; line from [0, 5, 0] m to [1, 5, 0] m; mesh n * cable(bar, steel); }
        joint support = clamp(girder.start, inertial);
        body arm { planar xy; line from [at, 5 m, 0 m] to [at, 5.2 m, 0 m]; mesh 2 * cable(bar, steel); }
        joint knot = weld(girder.at(at), arm.start);
        load push = force(arm.end, [down, 0 N, 0 N]);
        output tip: um = alone.end.y;
        output first: um = pair[0].end.y - 1 m;
        output second: um = pair[1].end.y - 2 m;
        output welded: um = girder.end.y - 5 m;
    }
}

rncf::model! {
    /// A shaft at rest whose disc stands between equal elements.
    pub model Disc {
        param n: count = 6;
        material steel { density = 7850 kg/m^3; young = 211 GPa; poisson = 0.3; }
        section round = circle(radius = 25 mm);
        body shaft { spatial; line from [0, 0, 0] m to [1.2, 0, 0] m; mesh n * beam(round, steel); }
        joint left = clamp(shaft.start, inertial);
        joint right = spherical(shaft.end, inertial.at([1.2, 0, 0] m));
        fixture disc on shaft.at(0.34 m) { mass = 30 kg; inertia = [0.4, 0.2, 0.2] kg*m^2; }
        output y = shaft.at(0.34 m).y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// `M a (L - a / 2) / (E I)`: within elements it was 1.6 % off with eight of them, and half as much with twice as many.
#[test]
fn moments_within_a_body_bend_it_exactly() {
    for n in [2, 3, 8] {
        let model = Within { n, ..Within::default() };
        let settings = EquilibriumSettings {
            steps: 1,
            ..EquilibriumSettings::default()
        };
        let found = static_equilibria(&model, &settings).unwrap();
        let want = 1e6 * 0.1 * 0.37 * (1.0 - 0.185) / 210e3;
        for (index, part) in [(0, 1e-6), (1, 1e-6), (2, 1e-6), (3, 1e-5)] {
            let tip = found.history.column(index).last().unwrap();
            assert!((tip - want).abs() < part * want, "{n}, {index}: {tip} {want}");
        }
    }
}

/// Frequencies of bending with the disc converge as those of a shaft with its disc at a node.
#[test]
fn a_disc_between_equal_elements_has_a_node() {
    let lowest = |n: u32| {
        let settings = EquilibriumSettings {
            count: 6,
            judged: Judging::Affordable,
            ..EquilibriumSettings::default()
        };
        let model: Box<dyn AnyModel> = Box::new(Disc { n: n as _ });
        let found = modes(model.as_ref(), &settings).unwrap();
        (
            found.modes.iter().map(|mode| mode.im).collect::<Vec<f64>>(),
            found.agreement,
        )
    };
    let (fine, _) = lowest(24);
    let (coarse, told) = lowest(6);
    for (a, b) in coarse.iter().zip(&fine) {
        assert!((a - b).abs() < 1e-3 * b, "{coarse:?} {fine:?}");
    }
    assert!(told.unwrap().starts_with("Compared with twice as many elements"));
}

rncf::model! {
    /// Discs of a loop whose number is a param, between equal elements of one shaft, and on shafts of another loop.
    pub model Discs {
        param n: count = 8;
        param k: count = 3;
        material steel { density = 7850 kg/m^3; young = 211 GPa; poisson = 0.3; }
        section round = circle(radius = 25 mm);
        body shaft { planar xy; line from [0, 0, 0] m to [1.2, 0, 0] m; mesh n * cable(round, steel); }
        joint left = clamp(shaft.start, inertial);
        for i in 0..k {
            fixture disc[i] on shaft.at(0.23 m + i * 0.31 m) { mass = 30 kg; gyration = 80 mm; }
        }
        for j in 0..k {
            body rod[j] { planar xy; line from [0 m, 1 m + j * 1 m, 0 m] to [1.2 m, 1 m + j * 1 m, 0 m]; mesh n * cable(round, steel); }
            joint root[j] = clamp(rod[j].start, inertial);
            fixture lump[j] on rod[j].at(0.23 m + j * 0.31 m) { mass = 30 kg; gyration = 80 mm; }
        }
        output y = shaft.end.y;
        output z = rod[0].end.y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

rncf::model! {
    /// The same, written out, with nodes at rows of tables.
    pub model Written {
        param n: count = 2;
        table all { x = [0, 0.23, 0.54, 0.85, 1.2] m; }
        table first { x = [0, 0.23, 1.2] m; }
        table second { x = [0, 0.54, 1.2] m; }
        table third { x = [0, 0.85, 1.2] m; }
        material steel { density = 7850 kg/m^3; young = 211 GPa; poisson = 0.3; }
        section round = circle(radius = 25 mm);
        body shaft { planar xy; line from [0, 0, 0] m to [1.2, 0, 0] m; mesh n at all * cable(round, steel); }
        body _rod_a { planar xy; line from [0, 1, 0] m to [1.2, 1, 0] m; mesh n at first * cable(round, steel); }
        body _rod_b { planar xy; line from [0, 2, 0] m to [1.2, 2, 0] m; mesh n at second * cable(round, steel); }
        body _rod_c { planar xy; line from [0, 3, 0] m to [1.2, 3, 0] m; mesh n at third * cable(round, steel); }
        joint left = clamp(shaft.start, inertial);
        joint a = clamp(_rod_a.start, inertial);
        joint b = clamp(_rod_b.start, inertial);
        joint c = clamp(_rod_c.start, inertial);
        fixture disc_a on shaft.at(0.23 m) { mass = 30 kg; gyration = 80 mm; }
        fixture disc_b on shaft.at(0.54 m) { mass = 30 kg; gyration = 80 mm; }
        fixture disc_c on shaft.at(0.85 m) { mass = 30 kg; gyration = 80 mm; }
        fixture lump_a on _rod_a.at(0.23 m) { mass = 30 kg; gyration = 80 mm; }
        fixture lump_b on _rod_b.at(0.54 m) { mass = 30 kg; gyration = 80 mm; }
        fixture lump_c on _rod_c.at(0.85 m) { mass = 30 kg; gyration = 80 mm; }
        output y = shaft.end.y;
        run { t_end = 1 s; every = 10 ms; }
    }
}

/// A loop over a param that holds nothing but fixtures did not compile.
#[test]
fn places_of_loops_are_nodes() {
    let settings = EquilibriumSettings {
        count: 8,
        ..EquilibriumSettings::default()
    };
    let of = |model: &dyn AnyModel| -> Vec<f64> {
        let found = modes(model, &settings).unwrap().modes;
        found.iter().map(|mode| mode.im).collect()
    };
    let (looped, written) = (of(&Discs::default()), of(&Written { n: 6 }));
    assert_eq!(looped.len(), 8);
    for (a, b) in looped.iter().zip(&written) {
        assert!((a - b).abs() < 5e-4 * b, "{looped:?} {written:?}");
    }
}

rncf::model! {
    /// Forces on a bar at four places from end to end: three times 0.1 is more than 0.3.
    pub model Thirds {
        param apart = 0.1 m;
        material m { density = 1000 kg/m^3; young = 10 GPa; poisson = 0.3; }
        section strip = rectangle(y = 10 mm, z = 10 mm);
        body bar { spatial; line from [0, 0, 0] m to [0.3, 0, 0] m; mesh 2 * beam(strip, m); }
        joint root = clamp(bar.start, inertial);
        for i in 0..4 { load pull[i] = force(bar.at(i * apart), [1 N, 0 N, 0 N]); }
        output reaction = root.force.x;
        output there = bar.at(3 * apart).x - bar.end.x;
    }
}

#[test]
fn a_place_that_is_the_end_but_for_round_off_is_there() {
    let settings = EquilibriumSettings {
        steps: 1,
        ..EquilibriumSettings::default()
    };
    let found = static_equilibria(&Thirds::default(), &settings).unwrap();
    let last = |column| found.history.column(column).last().unwrap();
    assert!(
        (last(0).abs() - 4.0).abs() < 1e-9 && last(1).abs() < 1e-15,
        "{} {}",
        last(0),
        last(1)
    );
    let beyond = Thirds { apart: 0.1001 };
    assert!(
        static_equilibria(&beyond, &settings)
            .unwrap_err()
            .to_string()
            .contains("0.3 m long")
    );
}

/// Modes of large systems are compared with finer meshes where that is asked for, and a note says so.
#[test]
fn modes_that_were_not_compared_are_told() {
    let told = |n: u32, judged: Judging| {
        let settings = EquilibriumSettings {
            count: 1,
            judged,
            ..EquilibriumSettings::default()
        };
        let found = modes(&Disc { n: n as _ }, &settings).unwrap();
        let is_told = found
            .warnings
            .iter()
            .any(|warning| warning.contains("were not compared"));
        assert_eq!(
            is_told,
            found.agreement.is_none() && judged != Judging::No,
            "{:?}",
            found.warnings
        );
        (found.unknowns, is_told)
    };
    let (few, many) = (told(6, Judging::Affordable), told(40, Judging::Affordable));
    assert!(few.0 <= 400 && !few.1 && many.0 > 400 && many.1, "{few:?} {many:?}");
    assert!(!told(40, Judging::No).1);
}
