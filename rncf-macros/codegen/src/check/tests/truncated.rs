//! Half-typed text never panics, and is never a model.

use super::free::FREE;
use super::joints::JOINTS;
use super::parts::ROTOR;
use super::repeat::SAIL;
use super::*;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::stub::stub;

/// The stream with the first `budget` tokens only, groups closed where they are cut.
fn cut(stream: TokenStream, budget: &mut usize) -> TokenStream {
    let mut out = Vec::new();
    for token in stream {
        if *budget == 0 {
            break;
        }
        *budget -= 1;
        out.push(match token {
            TokenTree::Group(group) => {
                let mut cut = Group::new(group.delimiter(), cut(group.stream(), budget));
                cut.set_span(group.span());
                TokenTree::Group(cut)
            }
            token => token,
        });
    }
    out.into_iter().collect()
}

fn count(stream: TokenStream) -> usize {
    stream
        .into_iter()
        .map(|token| {
            if let TokenTree::Group(group) = token {
                1 + count(group.stream())
            } else {
                1
            }
        })
        .sum()
}

/// Parses and checks; after mistakes the stub must be a file of Rust.
fn survives(tokens: TokenStream) -> bool {
    let mut errors = Errors::new();
    let tree = parse(tokens, &mut errors);
    let tree = tree.map(|tree| crate::unfold::unfold(tree, &mut errors));
    let model = tree
        .as_ref()
        .and_then(|tree| check(tree, &Library::standard(), &mut errors));
    assert_eq!(model.is_none(), !errors.is_empty(), "a model, or mistakes");
    if let Some(tree) = &tree {
        syn::parse2::<syn::File>(stub(tree)).expect("the stub is Rust");
    }
    syn::parse2::<syn::File>(errors.into_tokens()).expect("the errors are Rust");
    model.is_some()
}

#[test]
fn cut_after_every_token() {
    let tokens: TokenStream = SPIN_UP.parse().unwrap();
    let total = count(tokens.clone());
    assert!(total > 300);
    // With its first output the declaration is whole; before, something is always missing.
    let first_output = SPIN_UP.find("output tip").unwrap();
    let needed = count(format!("{}}}", &SPIN_UP[..first_output]).parse().unwrap());
    for budget in 0..total {
        let is_model = survives(cut(tokens.clone(), &mut budget.clone()));
        assert!(
            !is_model || budget + 3 >= needed,
            "a model after {budget} of {total} tokens, {needed} are needed"
        );
    }
    assert!(survives(tokens));
}

#[test]
fn free_frames_cut_after_every_token() {
    let tokens: TokenStream = FREE.parse().unwrap();
    let total = count(tokens.clone());
    for budget in 0..total - 8 {
        assert!(
            !survives(cut(tokens.clone(), &mut budget.clone())),
            "a model after {budget} tokens"
        );
    }
    assert!(survives(tokens));
}

/// What joints and springs hold on to, and what is observed of them.
#[test]
fn half_of_a_linkage() {
    let tokens: TokenStream = JOINTS.parse().unwrap();
    let total = count(tokens.clone());
    for budget in 0..total {
        survives(cut(tokens.clone(), &mut budget.clone()));
    }
    for by in ["", "7", "arm", "knee . angle", "beam . end", "[ 1 , 2 , 3 ]", "z"] {
        let by: TokenStream = by.parse().unwrap();
        for at in 0..total {
            survives(exchanged(tokens.clone(), &mut at.clone(), &by));
        }
    }
    assert!(survives(tokens));
}

/// Components, and loops in each other.
#[test]
fn half_of_a_rotor() {
    let tokens: TokenStream = ROTOR.parse().unwrap();
    let total = count(tokens.clone());
    for budget in (0..total).step_by(3) {
        survives(cut(tokens.clone(), &mut budget.clone()));
    }
    for by in ["", "7", "[ i ]", "blade [ 0 ] . spar", "part", "component", "{ }"] {
        let by: TokenStream = by.parse().unwrap();
        for at in (0..total).step_by(5) {
            survives(exchanged(tokens.clone(), &mut at.clone(), &by));
        }
    }
    assert!(survives(tokens));
}

/// Loops, shared nodes and reductions.
#[test]
fn half_of_a_sail() {
    let tokens: TokenStream = SAIL.parse().unwrap();
    let total = count(tokens.clone());
    for budget in 0..total {
        survives(cut(tokens.clone(), &mut budget.clone()));
    }
    for by in [
        "",
        "7",
        ";",
        "a",
        "[ a ]",
        "main [ 0 ] . end",
        "for",
        "0 . . 3",
        "{ }",
        "%",
    ] {
        let by: TokenStream = by.parse().unwrap();
        for at in 0..total {
            survives(exchanged(tokens.clone(), &mut at.clone(), &by));
        }
    }
    assert!(survives(tokens));
}

/// The stream with one token exchanged for others (or for none).
fn exchanged(stream: TokenStream, at: &mut usize, by: &TokenStream) -> TokenStream {
    let mut out = TokenStream::new();
    for token in stream {
        let here = *at == 0;
        *at = at.wrapping_sub(1);
        match token {
            _ if here => out.extend(by.clone()),
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), exchanged(group.stream(), at, by));
                inner.set_span(group.span());
                out.extend([TokenTree::Group(inner)]);
            }
            token => out.extend([token]),
        }
    }
    out
}

#[test]
fn any_one_token_exchanged() {
    exchange_each(SPIN_UP);
}

#[test]
fn any_one_token_of_free_frames_exchanged() {
    exchange_each(FREE);
}

fn exchange_each(text: &str) {
    let tokens: TokenStream = text.parse().unwrap();
    let total = count(tokens.clone());
    for by in [
        "",
        ";",
        "-",
        "7",
        "m",
        "t",
        "theta",
        "beam . end",
        "( )",
        "[ 1 , 2 , 3 ]",
        "{ }",
        "= =",
        "param",
        "r#fn",
    ] {
        let by: TokenStream = by.parse().unwrap();
        for at in 0..total {
            survives(exchanged(tokens.clone(), &mut at.clone(), &by));
        }
    }
}

#[test]
fn deep_nesting_is_refused() {
    let mut inner: TokenStream = "1".parse().unwrap();
    for _ in 0..3000 {
        inner = TokenStream::from(TokenTree::Group(Group::new(Delimiter::Parenthesis, inner)));
    }
    let text: TokenStream = "const a =".parse().unwrap();
    let semicolon: TokenStream = ";".parse().unwrap();
    let body: TokenStream = [text, inner, semicolon].into_iter().collect();
    let head: TokenStream = "model M".parse().unwrap();
    let model = TokenStream::from(TokenTree::Group(Group::new(Delimiter::Brace, body)));
    assert!(!survives([head, model].into_iter().collect()));
    let long = vec!["1"; 5000].join("+");
    assert!(!survives(format!("model M {{ const a = {long}; }}").parse().unwrap()));
    let minuses = "-".repeat(5000);
    assert!(!survives(
        format!("model M {{ const a = {minuses}1; }}").parse().unwrap()
    ));
    let powers = vec!["2"; 5000].join("^");
    assert!(!survives(format!("model M {{ const a = {powers}; }}").parse().unwrap()));
}

/// Names that use each other add up.
#[test]
fn deep_chains_of_names_are_refused() {
    let deep = |at: usize| format!("{}m{at}(t){}", "sin(".repeat(150), ")".repeat(150));
    let motions: String = (0..40)
        .map(|at| format!("motion m{at}(t) = {};", deep(at + 1)))
        .collect();
    let (model, mistakes) = run(&format!("model M {{ {motions} motion m40(t) = 1; }}"));
    assert!(model.is_none());
    assert!(
        mistakes
            .iter()
            .any(|mistake| mistake.message.contains("nested too deeply together"))
    );
}
