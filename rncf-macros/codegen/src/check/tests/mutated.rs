//! Mutated texts never panic: they are models that can be written down as Rust, or have mistakes that are told.
//!
//! `cargo test --release -p rncf-codegen mutated -- --ignored --nocapture` runs 100,000 of them; `SEED=..` begins elsewhere.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

use super::free::FREE;
use super::joints::JOINTS;
use super::meaning::{MEANING, SPACE};
use super::parts::ROTOR;
use super::repeat::SAIL;
use super::*;
use crate::expand;
use crate::stub::stub;
use crate::units::UNITS;

/// Splitmix64: a stream of numbers from a seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    fn one<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        &of[self.below(of.len())]
    }
}

/// Declarations between the braces of every `model!` of a file.
fn declarations(path: &Path) -> Vec<TokenStream> {
    let text = std::fs::read_to_string(path).expect("a file of models");
    let file = syn::parse_file(&text).expect("Rust");
    let macros = file.items.into_iter().filter_map(|item| match item {
        syn::Item::Macro(item) => Some(item.mac),
        _ => None,
    });
    let models = macros.filter(|one| one.path.segments.last().is_some_and(|segment| segment.ident == "model"));
    models.map(|one| one.tokens).collect()
}

/// All declarations of the repository's models and of the tests here.
fn corpus() -> Vec<TokenStream> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/src");
    let files = std::fs::read_dir(folder).expect("the folder of models");
    let mut paths: Vec<_> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    paths.sort();
    let sources = paths
        .iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let mut corpus: Vec<TokenStream> = sources.flat_map(|path| declarations(path)).collect();
    assert!(corpus.len() > 15, "{} models", corpus.len());
    corpus.extend([SPIN_UP, FREE, JOINTS, SAIL, ROTOR, MEANING, SPACE].map(|text| text.parse().expect("tokens")));
    corpus
}

/// Tokens with the ends of groups, so that any of them can be changed.
#[derive(Clone)]
enum Part {
    Token(TokenTree),
    Open(Delimiter, Span),
    Close,
}

fn flat(stream: TokenStream, out: &mut Vec<Part>) {
    for token in stream {
        match token {
            TokenTree::Group(group) => {
                out.push(Part::Open(group.delimiter(), group.span()));
                flat(group.stream(), out);
                out.push(Part::Close);
            }
            token => out.push(Part::Token(token)),
        }
    }
}

/// The tokens again; groups are closed where their ends are lost.
fn folded(parts: Vec<Part>) -> TokenStream {
    let mut open: Vec<(Delimiter, Span, Vec<TokenTree>)> = vec![(Delimiter::None, Span::call_site(), Vec::new())];
    let close = |open: &mut Vec<(Delimiter, Span, Vec<TokenTree>)>| {
        if open.len() > 1
            && let Some((delimiter, span, tokens)) = open.pop()
        {
            let mut group = Group::new(delimiter, tokens.into_iter().collect());
            group.set_span(span);
            open.last_mut().expect("the outermost").2.push(TokenTree::Group(group));
        }
    };
    for part in parts {
        match part {
            Part::Token(token) => open.last_mut().expect("the outermost").2.push(token),
            Part::Open(delimiter, span) => open.push((delimiter, span, Vec::new())),
            Part::Close => close(&mut open),
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    open.pop().expect("the outermost").2.into_iter().collect()
}

const NUMBERS: [&str; 12] = [
    "0",
    "1",
    "2",
    "0.5",
    "1e308",
    "1e-308",
    "1e-320",
    "1e200",
    "1e-200",
    "3.7",
    "1e9",
    "100000000000000000000",
];
const SIGNS: [char; 14] = ['-', '+', '*', '/', '^', '%', '=', '<', ';', ',', '.', ':', '?', '&'];

/// One change somewhere.
fn mutate(parts: &mut Vec<Part>, words: &[Ident], random: &mut Random) {
    let at = random.below(parts.len());
    let literals: Vec<usize> = (0..parts.len())
        .filter(|&at| matches!(parts[at], Part::Token(TokenTree::Literal(_))))
        .collect();
    let number = |random: &mut Random| {
        let literal: Literal = random.one(&NUMBERS).parse().expect("a number");
        Part::Token(TokenTree::Literal(literal))
    };
    match random.below(10) {
        0 => drop(parts.remove(at)),
        1 => parts.insert(at, parts[at].clone()),
        2 => {
            let last = parts.len() - 1;
            parts.swap(at, (at + 1).min(last));
        }
        3 => {
            let other = random.below(parts.len());
            parts.swap(at, other);
        }
        4..=6 if !literals.is_empty() => {
            let at = *random.one(&literals);
            parts[at] = number(random);
            if random.below(4) == 0 {
                parts.insert(at, Part::Token(TokenTree::Punct(Punct::new('-', Spacing::Alone))));
            }
        }
        7 if !literals.is_empty() => {
            // The word behind a number is mostly its unit.
            let behind = (random.one(&literals) + 1).min(parts.len() - 1);
            let unit = Ident::new(random.one(UNITS).symbol, Span::call_site());
            parts[behind] = Part::Token(TokenTree::Ident(unit));
        }
        8 => parts[at] = Part::Token(TokenTree::Ident(random.one(words).clone())),
        _ => parts.insert(
            at,
            Part::Token(TokenTree::Punct(Punct::new(*random.one(&SIGNS), Spacing::Alone))),
        ),
    }
}

/// What became of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fate {
    Refused,
    Model,
    Written,
}

/// Reads and checks; writes the expansion of some models.
fn fate(tokens: TokenStream, is_written: bool) -> Fate {
    let library = Library::standard();
    let mut errors = Errors::new();
    let tree = parse(tokens, &mut errors);
    let tree = tree.map(|tree| crate::unfold::unfold(tree, &mut errors));
    let model = tree.as_ref().and_then(|tree| check(tree, &library, &mut errors));
    assert_eq!(model.is_none(), !errors.is_empty(), "a model, or mistakes");
    let mistakes = errors.into_tokens();
    if let Some(tree) = tree.as_ref().filter(|_| model.is_none()) {
        syn::parse2::<syn::File>(stub(tree)).expect("the stub is Rust");
    }
    syn::parse2::<syn::File>(mistakes).expect("the errors are Rust");
    match model {
        None => Fate::Refused,
        Some(model) if is_written => {
            let text = expand::written_out(&model, &library);
            syn::parse_file(&text).expect("the expansion is Rust");
            Fate::Written
        }
        Some(_) => Fate::Model,
    }
}

/// Texts with seeds from `first` on; every `written`th model is written.
fn run_mutants(first: u64, count: u64, written: u64) -> [usize; 3] {
    let corpus = corpus();
    let mut fates = [0; 3];
    let mut panics = Vec::new();
    for seed in first..first + count {
        let mut random = Random(seed);
        let mut parts = Vec::new();
        flat(random.one(&corpus).clone(), &mut parts);
        let words: Vec<Ident> = parts
            .iter()
            .filter_map(|part| match part {
                Part::Token(TokenTree::Ident(ident)) => Some(ident.clone()),
                _ => None,
            })
            .collect();
        for _ in 0..1 + random.below(3) {
            mutate(&mut parts, &words, &mut random);
        }
        let is_written = random.next().is_multiple_of(written);
        let tokens = folded(parts);
        match catch_unwind(AssertUnwindSafe(|| fate(tokens, is_written))) {
            Ok(fate) => fates[fate as usize] += 1,
            Err(_) => panics.push(seed),
        }
    }
    assert!(
        panics.is_empty(),
        "{} of {count} texts panic, by seed: {panics:?}",
        panics.len()
    );
    fates
}

#[test]
fn mutated_models_do_not_panic() {
    let [refused, models, written] = run_mutants(0, 600, 64);
    assert!(refused > 100 && models + written > 20, "{refused} {models} {written}");
}

#[test]
#[ignore = "minutes: 100,000 texts"]
fn a_hundred_thousand_mutated_models_do_not_panic() {
    let number =
        |name: &str, default: u64| std::env::var(name).map_or(default, |text| text.parse().expect("a whole number"));
    let (first, count) = (number("SEED", 1_000_000), number("COUNT", 100_000));
    let [refused, models, written] = run_mutants(first, count, 64);
    println!(
        "{count} texts, seeds from {first}: {refused} refused, {models} models, {written} of them written as Rust too, no panic"
    );
}
