//! Documentation, visibility and the text of a declaration.

use quote::quote;

use super::parse;
use super::tree::{ItemKind, Keyword, Tree};
use crate::errors::Errors;

fn tree(tokens: proc_macro2::TokenStream) -> Tree {
    let mut errors = Errors::new();
    let tree = parse(tokens, &mut errors);
    let mistakes: Vec<_> = errors.finish().into_iter().map(|mistake| mistake.message).collect();
    assert_eq!(mistakes, Vec::<String>::new());
    tree.expect("a tree")
}

#[test]
fn the_source_is_the_text_without_its_indentation() {
    let text = "/// Doc\n    pub(crate) model M {\n        const a = 3 m;\n\n        param b = 2;\n    }";
    let tree = tree(text.parse().unwrap());
    assert_eq!(
        tree.source,
        "pub(crate) model M {\n    const a = 3 m;\n\n    param b = 2;\n}"
    );
    assert_eq!(tree.visibility_text(), "pub(crate)");
}

/// Tokens that other macros have made have no text of their own.
#[test]
fn without_text_the_source_is_printed() {
    let tree = tree(quote! {
        model M {
            const a = 3 m/s^2;
            motion x(t) = if t <= 2 s { t } else { -t };
            body b in c { planar xy; line from [0, 0, 0] m to [1, 0, 0] m; }
            output u = sin(b.end.x);
        }
    });
    let want = "\
model M {
    const a = 3 m/s^2;
    motion x(t) = if t <= 2 s { t } else { - t };
    body b in c {
        planar xy;
        line from [0, 0, 0] m to [1, 0, 0] m;
    }
    output u = sin(b.end.x);
}";
    assert_eq!(tree.source, want);
}

#[test]
fn documentation_keeps_its_lines() {
    let text = "/// First\n///\n///   indented\npub(in crate::a) model M { /** Block */ param a = 1; }";
    let tree = tree(text.parse().unwrap());
    assert_eq!(tree.doc, "First\n\n  indented");
    assert_eq!(tree.items[0].doc, "Block");
    assert_eq!(tree.visibility_text(), "pub(in crate::a)");
}

/// A mistake in one item leaves the others, and a parameter its field.
#[test]
fn reading_goes_on_after_a_mistake() {
    let mut errors = Errors::new();
    let text =
        "model M { param a: count = ; const b = (1 + ; ) ; material c { young = ; poisson = 0.3; } param d = 4; }";
    let tree = parse(text.parse().unwrap(), &mut errors).expect("a tree");
    let messages: Vec<_> = errors.finish().into_iter().map(|mistake| mistake.message).collect();
    assert_eq!(messages, ["expected a value, found `;`"; 3]);
    assert!(!tree.complete);
    let names: Vec<_> = tree
        .items
        .iter()
        .map(|item| (item.keyword, item.name.text.as_str()))
        .collect();
    assert_eq!(
        names,
        [
            (Keyword::Param, "a"),
            (Keyword::Const, "b"),
            (Keyword::Material, "c"),
            (Keyword::Param, "d")
        ]
    );
    assert!(matches!(
        tree.items[0].kind,
        ItemKind::Param {
            count: true,
            value: None
        }
    ));
    assert!(matches!(tree.items[1].kind, ItemKind::Broken));
    let ItemKind::Material(fields) = &tree.items[2].kind else {
        panic!("a material")
    };
    assert_eq!((fields.fields.len(), fields.complete), (1, false));
}

#[test]
#[should_panic(expected = "never asked for")]
fn mistakes_that_nobody_asks_for_are_noticed() {
    drop(Errors::new());
}
