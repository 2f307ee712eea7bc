//! What an editor finds: every name of a declaration as an item of Rust where it is declared, and a mention of that item where it is
//! used. So going to definitions, hovering, finding uses and renaming work in the text of `model!`. It reads tokens, no tree: text
//! that is half typed has its names, too. What is written has no effect, and stands in no text of `generated/`.

mod completion;
mod scan;
#[cfg(test)]
mod tests;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::parse::tree::Tree;
use crate::vocabulary::members::Thing;

/// A declared name.
#[derive(Debug)]
struct Declared {
    name: Ident,
    /// Its word: `body`, `joint`, ..
    kind: String,
    /// Documentation comment.
    doc: String,
    /// The beginning of its text.
    text: String,
    /// Of a part: the component that it is.
    component: Option<String>,
    /// What it stands for, where words may follow its dot.
    thing: Option<Thing>,
}

/// Names that are seen together: those of the model, of a component, of an element.
#[derive(Debug, Default)]
struct Scope {
    outer: Option<usize>,
    names: Vec<Declared>,
    /// Outputs have a name space of their own.
    outputs: Vec<Declared>,
}

/// Where a name is used.
#[derive(Debug)]
struct Use {
    name: Ident,
    scope: usize,
    is_output: bool,
}

/// What is in sight at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sight {
    /// The names of a scope, and of those around it.
    Scope(usize),
    /// Behind the dot of a part: the names and outputs of its component.
    Part(usize),
    /// Behind the dot of something else.
    Of(Thing),
}

/// A word where a name may stand, whether or not it is one.
#[derive(Debug)]
struct Place {
    word: Ident,
    sight: Sight,
}

/// Items for the names of a declaration that a tree was read from. They stand in front of all other items: see [`completion`].
pub fn items(tokens: TokenStream, tree: &Tree) -> TokenStream {
    let found = scan::scan(tokens);
    let model = Ident::new(&tree.name.text, Span::call_site());
    let params: Vec<&str> = tree.params().map(|item| item.name.text.as_str()).collect();
    let uses = found.uses.iter().map(|found_use| {
        let Use { name, scope, is_output } = found_use;
        // Params are fields of the struct, which code outside of the declaration names, too.
        if *scope == 0 && !is_output && params.iter().any(|param| name == param) {
            return quote!(let _ = &model.#name;);
        }
        let module = if *is_output { outputs(*scope) } else { names(*scope) };
        quote!(let _ = declared::#module::#name;)
    });
    let completion = completion::functions(&found);
    let given = completion::given();
    let modules = (0..found.scopes.len()).map(|at| module(&found.scopes, at));
    quote! {
        #[allow(nonstandard_style, unused, missing_docs, unreachable_pub, unused_qualifications, unused_results, clippy::all, clippy::pedantic)]
        const _: () = {
            #[no_implicit_prelude]
            mod declared { #completion #(#modules)* #given }
            fn uses(model: &#model) { #(#uses)* }
        };
    }
}

/// The module of a scope's names.
fn names(scope: usize) -> Ident {
    Ident::new(&format!("names_{scope}"), Span::call_site())
}

/// The module of a scope's outputs.
fn outputs(scope: usize) -> Ident {
    Ident::new(&format!("outputs_{scope}"), Span::call_site())
}

/// The modules of a scope.
fn module(scopes: &[Scope], at: usize) -> TokenStream {
    let scope = &scopes[at];
    let (own, shown) = (names(at), outputs(at));
    let (names, outputs) = (scope.names.iter().map(item), scope.outputs.iter().map(item));
    quote!(pub mod #own { #(#names)* } pub mod #shown { #(#outputs)* })
}

fn item(declared: &Declared) -> TokenStream {
    let Declared {
        name, kind, doc, text, ..
    } = declared;
    let about = format!("{kind} `{name}`");
    let doc = doc.trim();
    let doc = match (doc.is_empty(), text.is_empty()) {
        (true, true) => about,
        (true, false) => format!("{about}\n\n```text\n{text}\n```"),
        (false, true) => format!("{about}: {doc}"),
        (false, false) => format!("{about}: {doc}\n\n```text\n{text}\n```"),
    };
    quote!(#[doc = #doc] pub const #name: &str = #kind;)
}
