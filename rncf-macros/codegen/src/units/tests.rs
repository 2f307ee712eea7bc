use super::*;

fn compound(parts: &[(&str, i32)]) -> Compound {
    parts.iter().fold(Compound::ONE, |total, (symbol, exponent)| {
        total.times(find(symbol).unwrap(), *exponent).unwrap()
    })
}

#[test]
fn powers_of_ten_round_once() {
    for (text, parts, want) in [
        ("68.95", &[("GPa", 1)][..], 68.95e9),
        ("0.7299", &[("cm", 2)], 0.7299e-4),
        ("0.8215", &[("cm", 4)], 0.8215e-8),
        ("2766.67", &[("kg", 1), ("m", -3)], 2766.67),
        ("7.85", &[("g", 1), ("cm", -3)], 7850.0),
        ("1_000.5", &[("mm", 1)], 1.0005),
        ("1e-5", &[("ms", 1)], 1e-8),
        ("3", &[("kN", 1), ("mm", 1)], 3.0),
    ] {
        assert_eq!(
            scale(text, compound(parts)).unwrap().to_bits(),
            f64::to_bits(want),
            "{text} {parts:?}"
        );
    }
}

#[test]
fn other_factors_multiply() {
    use std::f64::consts::PI;
    for (text, parts, want) in [
        ("90", &[("deg", 1)][..], PI / 2.0),
        ("60", &[("rpm", 1)], 2.0 * PI),
        ("2", &[("min", 1)], 120.0),
        ("1", &[("AU", 1)], 149_597_870_700.0),
        ("36", &[("km", 1), ("h", -1)], 10.0),
    ] {
        let value = scale(text, compound(parts)).unwrap();
        assert!((value - want).abs() <= 2e-16 * want.abs(), "{text} {parts:?}: {value}");
    }
}

#[test]
fn bad_numbers_are_refused() {
    assert_eq!(scale("0x10", Compound::ONE), Err(ScaleError::NotDecimal));
    assert_eq!(scale("8m", Compound::ONE), Err(ScaleError::NotDecimal));
    assert_eq!(scale("1e400", Compound::ONE), Err(ScaleError::Range));
    assert_eq!(scale("1e-400", Compound::ONE), Err(ScaleError::Range));
    assert_eq!(scale("0e-400", Compound::ONE), Ok(0.0));
    assert_eq!(scale("1e300", compound(&[("GPa", 2)])), Err(ScaleError::Range));
}

/// Dimensions of derived units follow from definitions in other units.
#[test]
fn derived_units_agree_with_their_definitions() {
    for (symbol, parts) in [
        ("N", &[("kg", 1), ("m", 1), ("s", -2)][..]),
        ("Pa", &[("N", 1), ("m", -2)]),
        ("J", &[("N", 1), ("m", 1)]),
        ("W", &[("J", 1), ("s", -1)]),
        ("V", &[("W", 1), ("A", -1)]),
        ("rpm", &[("rev", 1), ("min", -1)]),
        ("t", &[("kg", 1)]),
        ("bar", &[("kPa", 1)]),
    ] {
        assert_eq!(find(symbol).unwrap().dimension, compound(parts).dimension, "{symbol}");
    }
    let (rpm, rev) = (compound(&[("rpm", 1)]).si(), compound(&[("rev", 1), ("min", -1)]).si());
    assert!((rpm - rev).abs() < 1e-16);
}

#[test]
fn symbols_are_unique_ascii_words() {
    for (i, unit) in UNITS.iter().enumerate() {
        assert!(unit.symbol.chars().all(|c| c.is_ascii_alphabetic()));
        assert!(
            UNITS[..i].iter().all(|other| other.symbol != unit.symbol),
            "{} twice",
            unit.symbol
        );
    }
}

#[test]
fn dimensions_have_names() {
    assert_eq!(Dimension::of([1, 0, 0, 0, 0, 0]).describe(false), "a length (m)");
    assert_eq!(
        Dimension::of([0, 0, -1, 0, 0, 1]).describe(true),
        "an angular velocity (rad/s)"
    );
    assert_eq!(Dimension::of([2, 1, -2, 0, 0, 0]).symbol(false), "N m");
    assert_eq!(
        Dimension::of([1, 1, -1, 0, 0, 0]).describe(false),
        "a quantity in m kg/s"
    );
    let root = Dimension::of([1, 0, 0, 0, 0, 0])
        .power(Fraction::of(0.5).unwrap())
        .unwrap();
    assert_eq!(root.symbol(false), "m^(1/2)");
    assert_eq!(
        root.power(Fraction::of(2.0).unwrap()).unwrap(),
        Dimension::of([1, 0, 0, 0, 0, 0])
    );
}

#[test]
fn what_is_no_unit_is_never_taken_for_another_one() {
    let expected = [
        ("in", "inch"),
        ("m2", "m^2"),
        ("mm4", "mm^4"),
        ("kgm", "kg*m"),
        ("Nms", "N*m*s"),
        ("TPa", "1e12 Pa"),
        ("mPa", "1e-3 Pa"),
        ("mbar", "1e-3 bar"),
        ("rads", "rad"),
        ("sec", "s"),
        ("lbs", "lb"),
        ("kgf", "9.80665 N"),
        ("mil", "0.0254 mm"),
        ("mph", "0.44704 m/s"),
    ];
    for (word, wanted) in expected {
        assert_eq!(meant(word).as_deref(), Some(wanted), "{word}");
    }
    // Of these the case is wrong, or nothing is known.
    for word in ["KPa", "Gpa", "foo", "1", ""] {
        assert_eq!(meant(word), None, "{word}");
    }
}
