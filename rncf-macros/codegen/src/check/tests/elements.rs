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
        // Six parts in a thousand million a second.
        "let heat = 6e-9*t/(1 s); energy axial_strain when law is straight = 1/2*EA*(e - heat)^2, active;",
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

/// A string of a component, with what the component is told in its law.
const OF_COMPONENT: &str = "pub model Ropes {
    param stiffening = 2;
    material steel { density = 7850 kg/m^3; }
    section wire { area = 1 mm^2; }
    component Hanging(stiffness: N, side: m) {
        let soft = stiffness/2;
        element string(section, material) {
            domain xi in 0..1;
            vector r0 = r at 0, shape 1 - xi;
            vector r1 = r at 1, shape xi;
            field a = r_x;
            coefficient rhoA: kg/m = material.density * section.area;
            inertia r = rhoA;
            strain l = norm(a) - 1;
            energy stretching = soft*(l^2/2 + stiffening*l^4/4);
        }
        body line in inertial { spatial; line from [side, 0 m, 0 m] to [side, 0 m, -1 m]; mesh 1 * string(wire, steel); }
        joint top = pin(line.start, inertial);
        output z = line.end.z;
    }
    part left = Hanging(stiffness = 2 N, side = 0 m);
    for i in 0..2 { part others[i] = Hanging(stiffness = 3 N * (1 + i), side = 1 m * i); }
}";

/// Parts have elements of their own.
#[test]
fn an_element_of_a_component_is_that_of_its_part() {
    let elements = |text: &str| {
        let (model, mistakes) = super::run(text);
        assert!(mistakes.is_empty(), "{mistakes:?}");
        let mut elements: Vec<usize> = model
            .expect("a model")
            .bodies
            .iter()
            .map(|body| body.element.0)
            .collect();
        elements.dedup();
        elements.len()
    };
    assert_eq!(elements(OF_COMPONENT), 3);
    // What reads nothing of the part is one element, whose kernels are written once.
    assert_eq!(
        elements(
            &OF_COMPONENT
                .replace("= soft*(", "= 1 [N]*stiffening*(")
                .replace("        let soft = stiffness/2;\n", "")
        ),
        1
    );
}

#[test]
fn mistakes_in_elements_of_components_are_told_once_and_there() {
    for (from, to, word, text) in [
        (
            "energy stretching = soft*(",
            "energy stretching = softt*(",
            "softt",
            "unknown name `softt`: did you mean `soft`?",
        ),
        (
            "string(",
            "cable(",
            "cable",
            "`cable` is an element of the library: choose another name",
        ),
        ("1 * string(", "1 * strin(", "strin", "unknown element `strin`"),
        (
            "strain l = norm(a) - 1",
            "strain l = a.x - 1",
            "a.x",
            "`a.x` changes when the body is turned",
        ),
    ] {
        let (_, mistakes) = super::run(&OF_COMPONENT.replace(from, to));
        assert_eq!(mistakes.len(), 1, "{mistakes:?}");
        assert!(mistakes[0].message.starts_with(text), "{mistakes:?}");
        assert_eq!(mistakes[0].area.source_text().unwrap_or_default(), word);
    }
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

/// The beam with a full matrix of stiffness is a text, whose coefficients are what the runtime's sections give, in their order.
#[test]
fn coefficients_of_the_full_beam_are_those_of_its_section() {
    use crate::elements::Library;
    use crate::vocabulary::{PIVOTS, PIVOTS_OF_RATES};
    let library = Library::standard();
    for (is_viscous, wanted) in [(false, PIVOTS.to_vec()), (true, [PIVOTS, PIVOTS_OF_RATES].concat())] {
        let at = library.find_of_stiffness("beam", is_viscous).unwrap();
        let element = &library.elements[at];
        let names: Vec<&str> = element.coefficients.iter().map(|one| one.name).collect();
        assert_eq!(names, wanted);
        let of_section = element
            .coefficients
            .iter()
            .all(|one| one.factors == [one.name] && one.scale.is_none());
        assert!(of_section, "{:?}", element.coefficients);
    }
}
