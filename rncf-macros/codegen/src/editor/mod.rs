//! What an editor finds: every name of a declaration as an item of Rust where it is declared, and a mention of that item where it is
//! used. So going to definitions, hovering, finding uses and renaming work in the text of `model!`. It reads tokens, no tree: text
//! that is half typed has its names, too. What is written has no effect, and stands in no text of `generated/`.

mod scan;
#[cfg(test)]
mod tests;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::parse::tree::Tree;

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

/// Items for the names of a declaration that a tree was read from.
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
        let path = path(&found.scopes, *scope);
        if *is_output {
            quote!(let _ = #path outputs::#name;)
        } else {
            quote!(let _ = #path #name;)
        }
    });
    let modules = module(&found.scopes, 0);
    quote! {
        #[allow(nonstandard_style, unused, missing_docs, unreachable_pub, unused_qualifications, unused_results, clippy::all, clippy::pedantic)]
        const _: () = {
            #modules
            fn uses(model: &#model) { #(#uses)* }
        };
    }
}

fn own(scope: usize) -> Ident {
    Ident::new(&format!("names_{scope}"), Span::call_site())
}

/// The path to the names of a scope, with a last `::`.
fn path(scopes: &[Scope], scope: usize) -> TokenStream {
    let outer = scopes[scope].outer.map(|outer| path(scopes, outer));
    let own = own(scope);
    quote!(#outer #own::)
}

/// The names of a scope, and inside of it those of the scopes in it.
fn module(scopes: &[Scope], at: usize) -> TokenStream {
    let Scope { names, outputs, .. } = &scopes[at];
    let (own, names, outputs) = (own(at), names.iter().map(item), outputs.iter().map(item));
    let inner = (0..scopes.len()).filter(|inner| scopes[*inner].outer == Some(at));
    let inner = inner.map(|inner| module(scopes, inner));
    quote!(pub mod #own { #(#names)* pub mod outputs { #(#outputs)* } #(#inner)* })
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
