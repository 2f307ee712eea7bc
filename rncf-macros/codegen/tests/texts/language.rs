//! The documents are true: every model and every example in them is checked, every refusal is
//! refused in the words that stand there, and every word of the language is described.
//!
//! Fenced blocks are told apart by their tag:
//! * `rust` with a `model!` in it: a whole model, which must expand;
//! * `rncf`: items; what they refer to and do not declare comes from the first model of
//!   the page, else from that of `docs/language.md`;
//! * `shared`: libraries and models that use them, which must expand with them;
//! * `refused`: one item a line, each followed by `//` and the message that it must get.

use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use rncf_codegen::elements::Library;
use rncf_codegen::parse::tree::Keyword;
use rncf_codegen::{expand, units, vocabulary};

use crate::documents::{Page, index_of_words, language, page, pages, prose, section};
use crate::snippets::{blocks, completed, models};

/// Words that the parser knows and no table holds.
#[rustfmt::skip]
const WORDS: &[&str] = &[
    "model", "run", "t_end", "every", "count", "in", "t", "pi", "inertial", "if", "else",
    "rotating", "moving", "axis", "angle", "origin",
    "free", "turning", "hinged", "plane", "angular_velocity", "speed", "mass", "center", "inertia", "on", "offset",
    "gyration", "modal", "small", "point", "mean_axes", "chord", "initial",
    "planar", "spatial", "line", "arc", "mesh", "from", "to", "direction", "radius", "xy", "yz", "zx",
    "normal", "section_y", "twist", "circle", "tube", "rectangle", "shear_factor", "energy", "xx", "yy", "zz", "xz",
    "quadrature", "evaluation", "gauss", "automatic", "tensor", "points", "loop",
    "clamp", "clamp_full", "pin", "at", "start", "end", "gravity", "force", "moment", "density",
    "position", "velocity", "slope", "acceleration", "angular_velocity", "center", "ex", "ey", "ez", "slide", "multiplier",
    "weld", "spherical", "revolute", "universal", "cylindrical", "prismatic", "distance", "hold", "drive", "cross", "length",
    "curve", "through", "import", "units", "interface", "node", "nodes", "interface_modes", "damping", "file", "columns", "beamdyn", "eta", "interpolation", "monotone",
    "linear", "law", "torsional", "torsional_law", "stiffness", "rate", "follower", "dot", "norm",
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt", "abs", "min", "max",
    "atan2", "distributed", "tangent", "section_z", "for", "share", "merge", "sum", "mean", "spinning", "slack", "true", "false",
    "component", "part", "library", "use", "number", "vector", "place",
    "domain", "vector", "shape", "field", "coefficient", "option", "strain", "stress", "when", "is", "and", "space", "also",
];

/// Messages of the mistakes of a declaration.
pub fn messages(tokens: TokenStream) -> Vec<String> {
    let files = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/guide");
    match expand::text_beside(tokens, &Library::standard(), Some(&files)) {
        Ok(_) => Vec::new(),
        Err(mistakes) => mistakes.iter().map(|mistake| mistake.message.clone()).collect(),
    }
}

/// Libraries and the models that use them: what rustc makes of the uses, by hand.
#[test]
fn every_library_is_taken_in() {
    let shared: Vec<String> = documents()
        .iter()
        .flat_map(|page| blocks(&page.text, "shared"))
        .collect();
    assert!(!shared.is_empty());
    for block in shared {
        let file = syn::parse_file(&block).unwrap_or_else(|error| panic!("{error} in\n{block}"));
        let inside = |item: syn::Item| match item {
            syn::Item::Mod(module) => module.content.map(|(_, items)| items).unwrap_or_default(),
            item => vec![item],
        };
        let macros = file.items.into_iter().flat_map(inside).filter_map(|item| match item {
            syn::Item::Macro(item) => Some(item.mac.tokens),
            _ => None,
        });
        let macros: Vec<TokenStream> = macros.collect();
        let [library, model] = macros.as_slice() else {
            panic!("a library and a model in\n{block}")
        };
        let (library, model) = (library.clone(), model.clone());
        let made = expand::library(library.clone()).to_string();
        assert!(
            made.contains("macro_rules") && !made.contains("compile_error"),
            "{made}"
        );
        let is_library = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "library");
        let is_end = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';');
        let library = library.into_iter().skip_while(|token| !is_library(token));
        let model = model.into_iter().skip_while(|token| !is_end(token)).skip(1);
        let found = messages(library.chain(model).collect());
        assert!(found.is_empty(), "{found:?}");
    }
}

/// The pages with models and examples: the language, the guide, elements and the README.
fn documents() -> Vec<Page> {
    let mut documents = language();
    documents.extend(pages("docs/guide"));
    documents.extend(["docs/elements.md", "README.md"].map(page));
    documents
}

/// The model that the examples of a page take from what they do not declare: its own first one, else that of the index.
pub fn example_model(of: &Page) -> TokenStream {
    let own = models(&of.text).into_iter().next();
    own.unwrap_or_else(|| models(&page("docs/language.md").text)[0].clone())
}

#[test]
fn every_whole_model_expands() {
    let mut count = 0;
    for page in documents() {
        for model in models(&page.text) {
            let text = model.to_string();
            assert_eq!(messages(model), Vec::<String>::new(), "{}:\n{text}", page.path);
            count += 1;
        }
    }
    assert!(count >= 3, "found {count} models");
}

#[test]
fn every_example_checks() {
    let mut count = 0;
    for page in documents() {
        let model = example_model(&page);
        for example in blocks(&page.text, "rncf") {
            let found = messages(completed(&model, &example));
            assert_eq!(found, Vec::<String>::new(), "{}:\n{example}", page.path);
            count += 1;
        }
    }
    assert!(count >= 30, "every section has an example, found {count}");
}

#[test]
fn every_refusal_is_refused_in_these_words() {
    let (mut count, mut wrong) = (0, Vec::new());
    for page in documents() {
        let model = example_model(&page);
        let refused = blocks(&page.text, "refused").concat();
        let mut lines = refused.lines().filter(|line| !line.trim().is_empty());
        while let Some(example) = lines.next() {
            let message = lines.next().and_then(|line| line.trim().strip_prefix("// "));
            let message = message.unwrap_or_else(|| panic!("`{example}` is followed by its message"));
            let found = messages(completed(&model, example));
            if found != [message] {
                wrong.push(format!("{}: {example}\n  {}", page.path, found.join("\n  ")));
            }
            count += 1;
        }
    }
    assert!(
        wrong.is_empty(),
        "other messages than in the document:\n{}",
        wrong.join("\n")
    );
    assert!(count >= 70, "found {count} refusals");
}

/// Words of the language without units.
fn words(library: &Library) -> Vec<&str> {
    let mut words: Vec<&str> = WORDS.to_vec();
    words.extend(Keyword::ALL.map(Keyword::word));
    words.extend(
        vocabulary::MATERIAL
            .iter()
            .chain(vocabulary::SECTION)
            .map(|property| property.name),
    );
    for element in &library.elements {
        // Texts cannot name all of them.
        words.extend(element.names.iter().filter(|name| !name.starts_with('(')));
        for option in &element.options {
            words.push(option.name);
            words.extend(&option.values);
        }
    }
    words.sort_unstable();
    words.dedup();
    words
}

/// Whether a word stands in backticks, alone or with what belongs to it, outside of fenced blocks.
fn describes(text: &str, word: &str) -> bool {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let prose = prose(text);
    let mut spans = prose.split('`').skip(1).step_by(2);
    spans.any(|span| span.split(|c| !is_word(c)).any(|part| part == word))
}

#[test]
fn every_word_is_in_the_index_and_described_where_it_says() {
    let library = Library::standard();
    let index = index_of_words(&page("docs/language.md").text);
    let listed: Vec<&str> = index.iter().map(|(word, _)| word.as_str()).collect();
    let missing: Vec<&str> = words(&library)
        .into_iter()
        .filter(|word| !listed.contains(word))
        .collect();
    assert_eq!(
        missing,
        Vec::<&str>::new(),
        "the index of docs/language.md lacks these words"
    );
    assert!(
        listed.is_sorted_by_key(|word| word.to_lowercase()),
        "the index is sorted"
    );
    for (word, places) in &index {
        assert!(!places.is_empty(), "`{word}` stands nowhere");
        for place in places {
            let text = section("docs", place);
            assert!(describes(&text, word), "{place} does not describe `{word}`");
        }
    }
}

#[test]
fn every_unit_is_described() {
    let text = section("docs", "language/values.md#units");
    for unit in units::UNITS {
        assert!(describes(&text, unit.symbol), "`{}` is not described", unit.symbol);
    }
}
