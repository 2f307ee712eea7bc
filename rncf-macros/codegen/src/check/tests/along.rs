//! A body whose section says its stiffness by itself, along its axis.

/// What the wrong texts of along.txt change.
pub const ALONG: &str = "pub model Mast {
    param stiff = 1e6 [N*m^2];
    table rows { x = [0, 4, 4, 10] m; EI = [3, 2, 1, 1] kN*m^2; turn = [0, 5, 5, 10] deg; }
    table points { x = [0, 5, 10] m; y = [0, 0, 0.1] m; z = [0, 0.1, 0] m; }
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section pole { EA = 1 MN; GAy = 1 MN; GAz = 1 MN; GJ = 1 kN*m^2; EIy = rows.EI; EIz = stiff; mass = 2 kg/m; inertia_y = 0.1 kg*m; inertia_z = 0.1 kg*m; }
    section cone = circle(radius = 20 mm * (1 - x / 20 [m]));
    body mast { spatial; line from [0, 0, 0] m to [10, 0, 0] m; twist rows.turn; mesh 2 at rows * beam(pole); }
    body bent { spatial; curve through points; mesh 3 * beam(cone, steel); }
    joint foot = clamp(mast.start, inertial);
    joint other = clamp(bent.start, inertial);
    output top = mast.end.position;
    output tip = bent.end.position;
}";

/// Of a table that has its places twice those hold that it names.
#[test]
fn the_places_that_are_named_hold() {
    let places = |named: &str| {
        let rows = format!("eta = [0, 0.5, 0.6, 1]; at = {named}; x = [0, 4, 4, 10] m;");
        let model = super::model(&ALONG.replace("x = [0, 4, 4, 10] m;", &rows));
        let table = model.tables.iter().find(|table| table.name == "rows").expect("rows");
        (table.places.clone(), table.is_relative)
    };
    assert_eq!(places("x"), (vec![0.0, 4.0, 4.0, 10.0], false));
    assert_eq!(places("eta"), (vec![0.0, 0.5, 0.6, 1.0], true));
}

/// What several properties share along the axis has a name.
#[test]
fn a_let_reads_the_place_along_an_axis() {
    let inline = super::model(ALONG);
    let named = ALONG
        .replace(
            "    section cone = circle(radius = 20 mm * (1 - x / 20 [m]));",
            "    let taper = 1 - x / 20 [m];\n    let bending = rows.EI;\n    section cone = circle(radius = 20 mm * taper);",
        )
        .replace("EIy = rows.EI", "EIy = bending");
    let named = super::model(&named);
    assert_eq!(format!("{:?}", inline.bodies), format!("{:?}", named.bodies));
}
