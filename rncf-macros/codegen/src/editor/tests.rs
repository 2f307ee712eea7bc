//! Every use of a name has the span of its words, and leads to an item with the span of its declaration.

use proc_macro2::{TokenStream, TokenTree};

use super::scan::scan;
use crate::expand::expand;

/// A model with names of every kind; `tools/test_editor.py` asks a server for the same ones.
const ROTOR: &str = include_str!("rotor.txt");

/// All words in tokens with the places where they are told to stand: line, column.
fn words(tokens: TokenStream, found: &mut Vec<(String, (usize, usize))>) {
    for token in tokens {
        match token {
            TokenTree::Ident(ident) => {
                let start = ident.span().start();
                found.push((ident.to_string(), (start.line, start.column)));
            }
            TokenTree::Group(group) => words(group.stream(), found),
            _ => {}
        }
    }
}

fn places_of(text: &str, word: &str) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    for (at, line) in text.lines().enumerate() {
        let is_end = |c: Option<char>| !c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        let found = line.match_indices(word).filter(|(column, _)| {
            is_end(line[..*column].chars().next_back()) && is_end(line[column + word.len()..].chars().next())
        });
        places.extend(found.map(|(column, _)| (at + 1, column)));
    }
    places
}

/// Of each name all places in the text have a word of the expansion.
#[track_caller]
fn leads(text: &str, names: &[&str]) {
    let mut found = Vec::new();
    words(expand(text.parse().unwrap()), &mut found);
    for name in names {
        for place in places_of(text, name) {
            let is_there = found.contains(&((*name).to_string(), place));
            assert!(is_there, "nothing in the expansion for `{name}` at {place:?}");
        }
    }
}

#[test]
fn every_name_leads_to_its_declaration() {
    let names = [
        "long", "blades", "steel", "hub", "turn", "Blade", "spar", "clip", "blade", "tip", "pull",
    ];
    leads(ROTOR, &names);
    let found = scan(ROTOR.parse().unwrap());
    let uses = |name: &str| found.uses.iter().filter(|found| found.name == name).count();
    assert_eq!(["spar", "hub", "long", "clip"].map(uses), [2, 1, 2, 1]);
    // Names of arguments are those of the component; units, functions and fields are no names.
    assert_eq!(["m", "cos", "end", "force", "area"].map(uses), [0; 5]);
}

#[test]
fn half_typed_text_has_its_names() {
    let text = ROTOR.replace(
        "output tip = blade[1].spar.end;",
        "joint other = clamp(blade[1].spar., hub",
    );
    let text = text.replace("hub\n}", "hub)\n}");
    leads(&text, &["steel", "hub", "spar", "blade", "Blade", "clip"]);
    leads("model M { body rope { planar xy; } joint a = pin(rope. ) }", &["rope"]);
}

#[test]
fn what_is_written_is_rust_and_names_may_be_any() {
    let odd = "model M { param area = 1 m^2; param uses = 1; param names_0 = 2; param model = 1; material m { density = 1 kg/m^3; young = 1 Pa; }
        section s { area = area*uses*names_0*model; second_moment = 1 m^4; } body M_ { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; mesh 1 * cable(s, m); }
        joint str = clamp(M_.start, inertial); output area = M_.end; }";
    let tokens = expand(odd.parse().unwrap());
    let file = syn::parse2::<syn::File>(tokens).expect("the expansion is Rust");
    assert!(file.items.len() > 2);
    leads(odd, &["M_", "s", "names_0"]);
}

/// `gen` is a name of syn's Rust, and none of that of models.
#[test]
fn what_is_no_name_in_rust_is_none_here() {
    let tokens = expand(
        "model M { rigid gen { mass = 1 kg; } output x = gen.x; }"
            .parse()
            .unwrap(),
    );
    let mut found = Vec::new();
    words(tokens, &mut found);
    assert!(found.iter().all(|(word, _)| word != "gen"), "{found:?}");
}

/// Text of the expansion up to the first word that contains `mark`.
fn up_to(tokens: TokenStream, mark: &str) -> String {
    let text = tokens.to_string();
    text[..text.find(mark).unwrap_or(0)].to_string()
}

/// What is in sight where `|` stands in a text, by the name of the modules that are used there. A marker is inserted as rust-analyzer does it.
#[track_caller]
fn in_sight(text: &str) -> String {
    let at = text.find('|').expect("a place");
    let cursor = text[..at].lines().count();
    let marked = text.replace('|', "raCompletionMarker");
    let (marked, plain) = (
        expand(marked.parse().unwrap()),
        expand(text.replace('|', "").parse().unwrap()),
    );
    let mut found = Vec::new();
    words(marked.clone(), &mut found);
    let marks = found.iter().filter(|(word, _)| word.ends_with("raCompletionMarker"));
    assert!(
        marks.clone().any(|(_, (line, _))| *line == cursor),
        "the marker comes out where it was put"
    );
    let before = up_to(marked, "raCompletionMarker");
    assert!(
        plain.to_string().starts_with(&before),
        "before the marker both expansions are the same"
    );
    let function = &before[before.rfind("fn place_").expect("a function")..];
    let used = function
        .split("use super :: ")
        .skip(1)
        .map(|rest| &rest[..rest.find(' ').unwrap()]);
    used.collect::<Vec<_>>().join(" ")
}

#[test]
fn where_a_name_may_stand_names_are_completed() {
    let at = |found: &str, with: &str| in_sight(&ROTOR.replacen(found, with, 1));
    assert_eq!(
        at("output tip = blade[1].spar.end;", "output tip = bl|"),
        "given names_0"
    );
    assert_eq!(at("output tip = blade[1].spar.end;", "output tip = |"), "given names_0");
    assert_eq!(at("blade[1].spar.end", "blade[1].|"), "outputs_1 names_1");
    assert_eq!(at("blade[1].spar.end", "blade[1].spar.en|"), "of_body");
    assert_eq!(at("blade[1].spar.end", "blade[1].spar.at(1 m).|"), "of_place");
    assert_eq!(
        at("blade[1].spar.end", "blade[1].spar.end.in(hub).velocity.|"),
        "of_vector"
    );
    assert_eq!(at("blade[1].spar.end", "total.|"), "of_total");
    // A statement without its end, in a component.
    assert_eq!(
        at("clamp(spar.start, root);", "clamp(spar.start, ro|)"),
        "given names_0 names_1"
    );
    assert_eq!(at("clamp(spar.start, root);", "clamp(root.|, root);"), "of_frame");
    assert_eq!(at("clip.force.x", "clip.|"), "of_joint");
    assert_eq!(at("cable(round, steel)", "cable(ro|, steel)"), "given names_0 names_1");
    assert_eq!(at("long * cos(azimuth)", "lo| * cos(azimuth)"), "given names_0 names_1");
}
