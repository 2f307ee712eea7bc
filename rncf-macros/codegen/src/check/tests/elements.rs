//! A model with an element of its own, for what is wrong with elements.

pub const ELEMENTS: &str = "pub model Own {
    param stiffening = 2;

    element rope(section, material) {
        domain xi in 0..1;
        vector r0 = r   at 0, shape 1 - 3*xi^2 + 2*xi^3;
        vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;
        vector r1 = r   at 1, shape 3*xi^2 - 2*xi^3;
        vector s1 = r_x at 1, shape -xi^2 + xi^3;
        field a = r_x;
        field b = r_xx;
        coefficient EA: N      = material.young * section.area;
        coefficient EI: N m^2  = material.young * section.second_moment;
        coefficient rhoA: kg/m = material.density * section.area;
        inertia r = rhoA;
        damping = material.damping;
        option law = straight | stiffening_one;
        strain e = (dot(a, a) - 1)/2;
        strain k in plane = cross(a, b);
        energy axial_strain when law is straight       = 1/2*EA*e^2;
        energy axial_strain when law is stiffening_one = EA*(e^2/2 + stiffening*e^4/4), stress EA*(e + stiffening*e^3);
        energy bending in plane = 1/2*EI*k^2;
        energy bending in space = 1/2*EI*(dot(a, a)*dot(b, b) - dot(a, b)^2);
    }

    material steel { density = 7850 kg/m^3; young = 210 GPa; }
    section wire { area = 1 mm^2; second_moment = 0.08 mm^4; }
    body line in inertial { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh 4 * rope(wire, steel, law = stiffening_one); }
    joint top = clamp(line.start, inertial);
    output tip = line.end;
}";

/// It is right, in the plane and in space, and nothing is said about it.
#[test]
fn an_element_of_a_model_is_known_to_it() {
    for text in [ELEMENTS.to_string(), ELEMENTS.replace("spatial;", "planar xy;")] {
        let (model, mistakes) = super::run(&text);
        assert!(mistakes.is_empty(), "{mistakes:?}");
        let model = model.expect("a model");
        assert_eq!(model.bodies[0].options, [1]);
    }
}

/// Time may stand in coefficients, names, conditions and parts of the energy; a stress at rest is said.
#[test]
fn time_may_stand_in_an_energy() {
    let straight = "energy axial_strain when law is straight       = 1/2*EA*e^2;";
    let laws = [
        "energy axial_strain when law is straight = 1/2*EA*e^2*exp(-t/(1 h));",
        "let heat = 1e-3*sin(t/(1 s)); energy axial_strain when law is straight = 1/2*EA*(e - heat)^2, active;",
        "motion warm(t) = stiffening*t/(1 s); energy axial_strain when law is straight = 1/2*EA*(e - warm(t))^2, active;",
        "energy axial_strain when law is straight = if t < 1 s { 1/2*EA*e^2 } else { 1/2*EA*e^2/10 };",
        "energy axial_strain when law is straight = 1/2*EA*(e + 1e-3)^2, active;",
    ];
    for law in laws {
        let (motion, law) = match law.split_once("; energy") {
            Some((motion, law)) if motion.starts_with("motion") => (format!("{motion};"), format!("energy{law}")),
            _ => (String::new(), law.to_string()),
        };
        let text = ELEMENTS
            .replace(straight, &law)
            .replace("    element rope", &format!("{motion} element rope"));
        let text = text.replace("rope(wire, steel, law = stiffening_one)", "rope(wire, steel)");
        let (model, mistakes) = super::run(&text);
        assert!(mistakes.is_empty(), "{law}: {mistakes:?}");
        assert!(model.is_some(), "{law}");
    }
    let ageing = ELEMENTS.replace(
        "* section.area;\n        coefficient EI",
        "* section.area*exp(-t/(1 h));\n        coefficient EI",
    );
    assert_ne!(ageing, ELEMENTS);
    let (_, mistakes) = super::run(&ageing);
    assert!(mistakes.is_empty(), "{mistakes:?}");
}

/// An element of a shared library is known to the model that uses it.
#[test]
fn an_element_of_a_library_is_known() {
    let (start, end) = (
        ELEMENTS.find("    element").unwrap(),
        ELEMENTS.find("    material steel").unwrap(),
    );
    let element = ELEMENTS[start..end].replace("stiffening*e", "2*e");
    let rest = format!("{}{}", &ELEMENTS[..start], &ELEMENTS[end..]).replace("pub model", "model");
    let (model, mistakes) = super::run(&format!("library ropes {{ {element} }} {rest}"));
    assert!(mistakes.is_empty(), "{mistakes:?}");
    assert_eq!(model.expect("a model").bodies[0].options, [1]);
}

/// The elements of the library pass the checks of those of a model, and need the points that are known of them.
#[test]
fn elements_of_the_library_make_sense() {
    use crate::elements::Library;
    for text in [
        include_str!("../../library/cable.rncf"),
        include_str!("../../library/beam.rncf"),
    ] {
        let text = text
            .replace("element cable(", "element other(")
            .replace("also tether;", "")
            .replace("element beam(", "element other(");
        let (_, mistakes) = super::run(&format!("model Others {{ {text} output nothing = 1; }}"));
        let about = |word: &str| mistakes.iter().any(|mistake| mistake.message.contains(word));
        assert!(
            !about("motion") && !about("stationary") && !about("stress"),
            "{mistakes:?}"
        );
    }
    let library = Library::standard();
    let cable = &library.elements[library.find("cable").unwrap()];
    assert_eq!(
        [2, 3].map(|dimension| cable.least_points(dimension, &[0, 0, 0])),
        [3, 3]
    );
}
