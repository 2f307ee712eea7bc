//! Libraries: what several models share, and how models take it in.
//!
//! `library! { pub library blades { .. } }` becomes a macro of the same name, which hands its items to a model:
//! `use path::blades;` in front of `model` becomes a call of it with the rest of the declaration, and that becomes
//! `model! { library blades { .. } .. }`. So libraries go from file to file and from crate to crate as macros do, cargo
//! notices a change, and mistakes point into the library's text.

use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::quote;

use super::cursor::{Cursor, Parsed};
use super::messages as say;
use super::tree::{Keyword, Name, Tree};
use super::{documentation, item, visibility};
use crate::errors::{Errors, Mistake};

/// What stands in a library beside components.
const SHARED: &[Keyword] = &[
    Keyword::Const,
    Keyword::Let,
    Keyword::Table,
    Keyword::Material,
    Keyword::Section,
    Keyword::Element,
    Keyword::Motion,
];

/// A declared library.
pub struct Library {
    /// Documentation and visibility.
    pub visibility: TokenStream,
    /// Its name.
    pub name: Name,
    /// What stands in its braces.
    pub items: Group,
}

/// `[visibility] library name { items }`, all of what is given.
pub fn library(tokens: TokenStream, errors: &mut Errors) -> Parsed<Library> {
    let mut cursor = Cursor::new(tokens, Span::call_site());
    documentation::documentation(&mut cursor, errors);
    let visibility = visibility(&mut cursor);
    if cursor.is_word("use") {
        return Err(Mistake::new(cursor.here(), say::USE_IN_LIBRARY));
    }
    if !cursor.eat_word("library") {
        return Err(cursor.expected("`library name { .. }`"));
    }
    let (name, items) = named(&mut cursor)?;
    if !cursor.is_empty() {
        errors.at(cursor.here(), say::after_library(&cursor.found()));
    }
    // The items are read for their mistakes, which stand here once for all models.
    let mut tree = Tree::new(name.clone());
    shared(&items, &mut tree, errors);
    Ok(Library {
        visibility,
        name,
        items,
    })
}

fn named(cursor: &mut Cursor) -> Parsed<(Name, Group)> {
    let name = cursor.expect_name("the name of a library")?;
    item::check_name(&name)?;
    match cursor.eat_group(Delimiter::Brace) {
        Some(group) => Ok((name, group)),
        None => Err(cursor.expected("`{` and the items of the library")),
    }
}

/// Items of a library, into a model; nothing warns about those that it does not use.
fn shared(items: &Group, tree: &mut Tree, errors: &mut Errors) {
    let first = tree.items.len();
    let words: Vec<&str> = SHARED.iter().map(|keyword| keyword.word()).collect();
    item::items(&mut Cursor::of(items), tree, None, errors);
    for item in &mut tree.items[first..] {
        item.is_shared = true;
        // A table whose file a run names, too.
        if item.is_param() || !SHARED.contains(&item.keyword) {
            let keyword = if item.is_param() { Keyword::Param } else { item.keyword };
            errors.at(item.name.span, say::not_shared(keyword.word(), &words));
        }
    }
    for run in tree.runs.drain(..) {
        errors.at(run.area, say::not_shared("run", &words));
    }
}

/// Libraries in front of a model, `library name { .. }`.
pub fn taken_in(cursor: &mut Cursor, errors: &mut Errors) -> Parsed<Vec<(Name, Group)>> {
    let mut libraries: Vec<(Name, Group)> = Vec::new();
    while cursor.is_word("library") && cursor.is_two_words() {
        cursor.next();
        let (name, items) = named(cursor)?;
        if libraries.iter().any(|(other, _)| other.text == name.text) {
            errors.at(name.span, say::library_twice(&name.text));
            continue;
        }
        libraries.push((name, items));
    }
    Ok(libraries)
}

/// Puts the items of libraries in front of those of a model.
pub fn take_in(libraries: &[(Name, Group)], tree: &mut Tree, errors: &mut Errors) {
    for (_, items) in libraries {
        shared(items, tree, errors);
    }
}

/// The call that a `use` in front of a model becomes: of the library's macro, with the rest of the declaration. `None`
/// where nothing is used.
pub fn used(tokens: &TokenStream, errors: &mut Errors) -> Option<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let is_word = |at: usize, word: &str| matches!(tokens.get(at), Some(TokenTree::Ident(ident)) if ident == word);
    let is_end = |at: usize| matches!(tokens.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == ';');
    let mut at = 0;
    while is_word(at, "library") {
        at += 3;
    }
    if !is_word(at, "use") {
        return None;
    }
    let end = (at + 1..tokens.len()).find(|&at| is_end(at));
    let path = &tokens[at + 1..end.unwrap_or(tokens.len())];
    let is_path = |token: &TokenTree| match token {
        TokenTree::Ident(_) => true,
        TokenTree::Punct(punct) => punct.as_char() == ':',
        TokenTree::Group(group) => group.delimiter() == Delimiter::None,
        TokenTree::Literal(_) => false,
    };
    let Some(end) = end.filter(|_| !path.is_empty() && path.iter().all(is_path)) else {
        errors.at(tokens[at].span(), say::USE);
        return Some(TokenStream::new());
    };
    let path: TokenStream = path.iter().cloned().collect();
    let rest: TokenStream = tokens[..at].iter().chain(&tokens[end + 1..]).cloned().collect();
    Some(quote! { #path ! { #rest } })
}

/// The macro that a library becomes.
pub fn macro_of(library: &Library, folder: &std::path::Path) -> TokenStream {
    let Library {
        visibility,
        name,
        items,
    } = library;
    let (name, hidden) = (
        Ident::new(&name.text, name.span),
        Ident::new(&format!("__rncf_library_{}", name.text), Span::call_site()),
    );
    let items = with_folder(items.stream(), folder);
    // A macro that other crates see belongs to the root of its crate.
    let (export, outside) = match visibility.to_string().as_str() {
        "pub" => (quote!(#[macro_export]), quote!(pub)),
        "" => (quote!(), quote!(pub(self))),
        _ => (quote!(), visibility.clone()),
    };
    quote! {
        #[doc(hidden)]
        #[allow(unused_macros)]
        #export
        macro_rules! #hidden {
            ($($rest:tt)*) => { ::rncf::model! { library #name { #items } $($rest)* } };
        }
        #[doc(hidden)]
        #[allow(unused_imports)]
        #outside use #hidden as #name;
    }
}

/// Files of tables are those beside the library, whoever uses it.
fn with_folder(stream: TokenStream, folder: &std::path::Path) -> TokenStream {
    let mut out: Vec<TokenTree> = Vec::new();
    for token in stream {
        let is_file = matches!(out.last(), Some(TokenTree::Ident(ident)) if ident == "file");
        out.push(match token {
            TokenTree::Group(group) => {
                let mut inner: Vec<TokenTree> = with_folder(group.stream(), folder).into_iter().collect();
                if is_file && let Some(first) = inner.first_mut() {
                    let path = syn::parse_str::<syn::LitStr>(&first.to_string()).map(|text| text.value());
                    if let Ok(path) = path {
                        let span = first.span();
                        let mut literal = Literal::string(&folder.join(path).to_string_lossy());
                        literal.set_span(span);
                        *first = TokenTree::Literal(literal);
                    }
                }
                let mut group_of = Group::new(group.delimiter(), inner.into_iter().collect());
                group_of.set_span(group.span());
                TokenTree::Group(group_of)
            }
            token => token,
        });
    }
    out.into_iter().collect()
}
