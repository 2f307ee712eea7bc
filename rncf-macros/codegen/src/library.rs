//! The elements of this crate: texts in the language.

use std::sync::LazyLock;

use crate::check;
use crate::elements::{BETWEEN_INTERFACES, Element, Library, full_beam};
use crate::errors::Errors;
use crate::parse;

/// Declarations of elements.
const TEXTS: [&str; 2] = [include_str!("library/cable.rncf"), include_str!("library/beam.rncf")];
/// The beam whose section has a full matrix of stiffness, which is called `beam`, too.
const FULL_BEAM: &str = include_str!("library/full_beam.rncf");
/// What stands between the interfaces of a body from elsewhere, and is not evaluated: no word of the language.
const INTERFACES: &str = include_str!("library/interfaces.rncf");

static STANDARD: LazyLock<Library> = LazyLock::new(|| {
    let mut library = Library::default();
    for text in TEXTS {
        library.elements.extend(declared(text));
    }
    let between = declared(INTERFACES).into_iter().map(|element| Element {
        names: vec![BETWEEN_INTERFACES],
        ..element
    });
    library.elements.extend(between);
    let beam = library.find("beam").map(|at| library.elements[at].clone());
    let full = declared(FULL_BEAM);
    let both = full.iter().zip(&beam);
    library
        .elements
        .extend(both.flat_map(|(full, beam)| full_beam(full, beam)));
    library
});

impl Library {
    /// The elements of this crate.
    pub fn standard() -> Self {
        STANDARD.clone()
    }
}

/// The elements of a text.
///
/// # Panics
/// If the text has a mistake: a defect of this crate.
fn declared(text: &str) -> Vec<Element> {
    let mut errors = Errors::new();
    let tokens = format!("model Library {{ {text} }}").parse().expect("tokens");
    let tree = parse::parse(tokens, &mut errors).expect("a declaration");
    let library = check::element::elements(&tree, &Library::default(), &mut errors);
    let mistakes: Vec<String> = errors.finish().into_iter().map(|mistake| mistake.message).collect();
    assert!(
        mistakes.is_empty(),
        "a text of the library is wrong: {}",
        mistakes.join("; ")
    );
    library.elements
}
