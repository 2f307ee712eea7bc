//! What an editor completes: for everything that can be in sight a function, and in it a match for each word where a name may stand.
//! One match with an arm for each would cost a compiler the square of their number.
//!
//! rust-analyzer inserts a marker at the cursor, expands the macro with it beside the expansion of the text as it stands, and asks what is in
//! sight where the marker has come out. Three things follow.
//!
//! * Up to the marker both expansions must be the same. So these functions come first, in front of names, errors and equations,
//!   and every function is there even where nothing is in it.
//! * A word may be half typed and the name of nothing. As a pattern it is one all the same: a new binding.
//! * Words would lead to that binding instead of what they name. So they have no place in the text, but for the marker.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::scan::Found;
use super::{Place, Sight, names, outputs};
use crate::vocabulary::members::{GIVEN, Member, Thing};

/// What rust-analyzer inserts at the cursor, of late and before.
const MARKERS: [&str; 2] = ["raCompletionMarker", "intellijRulezz"];

/// The functions of all that can be in sight.
pub fn functions(found: &Found) -> TokenStream {
    let scopes = (0..found.scopes.len()).flat_map(|scope| [Sight::Scope(scope), Sight::Part(scope)]);
    let sights = scopes.chain(Thing::ALL.map(Sight::Of));
    let functions = sights.enumerate().map(|(at, sight)| {
        let name = format_ident!("place_{at}");
        let words = found.places.iter().filter(|place| place.sight == sight);
        let words = words.map(|Place { word, .. }| pattern(word));
        // The last one is where a word would stand that is not typed yet.
        let body = quote!(#(match "" { #words => (), _ => () })* match "" { _ => () });
        let body = modules(found, sight)
            .into_iter()
            .fold(body, |body, module| quote!({ use super::#module::*; #body }));
        quote!(fn #name() { #body })
    });
    quote!(mod places { #(#functions)* })
}

/// The word at a place, which stands nowhere in the text unless it is the one that is typed.
fn pattern(word: &Ident) -> Ident {
    let text = word.to_string();
    let mut word = word.clone();
    if !MARKERS.iter().any(|marker| text.contains(marker)) {
        word.set_span(Span::call_site());
    }
    word
}

/// Modules whose names are in sight, those first that hide the others.
fn modules(found: &Found, sight: Sight) -> Vec<Ident> {
    match sight {
        Sight::Scope(scope) => {
            let scopes = std::iter::successors(Some(scope), |at| found.scopes[*at].outer);
            scopes.map(names).chain([format_ident!("given")]).collect()
        }
        Sight::Part(scope) => vec![names(scope), outputs(scope)],
        Sight::Of(thing) => vec![behind(thing)],
    }
}

/// The module of the words behind a dot.
fn behind(thing: Thing) -> Ident {
    format_ident!("of_{}", format!("{thing:?}").to_lowercase())
}

/// The modules of what no model declares.
pub fn given() -> TokenStream {
    let constant = |(word, meaning, _): Member| {
        let word = Ident::new(word, Span::call_site());
        quote!(#[doc = #meaning] pub const #word: &str = #meaning;)
    };
    let given = GIVEN.iter().copied().map(constant);
    let behind = Thing::ALL.map(|thing| {
        let (module, words) = (behind(thing), thing.members().map(constant));
        quote!(pub mod #module { #(#words)* })
    });
    quote!(pub mod given { #(#given)* } #(#behind)*)
}
