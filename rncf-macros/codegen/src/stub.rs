//! What stands in for a model that has mistakes, so that the rest of the user's crate sees no
//! follow-up errors: the struct with its parameters, and a `Model` whose bodies are unreachable.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::check::Spans;
use crate::parse::tree::{Item, ItemKind, Tree};

/// The struct of the declaration with its parameters (also of those whose value could not be read)
/// and a stub of `::rncf::Model`. Emit it beside the errors; without any tree there is nothing to
/// stand in for.
pub fn stub(tree: &Tree) -> TokenStream {
    let Spans { name: span, .. } = Spans::of(tree);
    let name = Ident::new(&tree.name.text, span);
    let visibility = &tree.visibility;
    let doc = if tree.doc.is_empty() {
        &tree.name.text
    } else {
        &tree.doc
    };
    let fields = fields(tree);
    let text = &tree.name.text;
    quote! {
        #[doc = #doc]
        #[allow(dead_code, non_snake_case)]
        #[derive(Clone, Debug)]
        #visibility struct #name { #(#fields),* }

        #[allow(clippy::all)]
        const _: () = {
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    ::core::unreachable!()
                }
            }

            impl ::rncf::Model for #name {
                const NAME: &'static str = #text;
                const DOC: &'static str = "";
                const SOURCE: &'static str = "";
                const EQUATIONS_HASH: u64 = 0;
                const NOTES: &'static [&'static str] = &[];
                const CONSTANTS: &'static [::rncf::model::ConstantArray] = &[];
                const KERNELS: &'static [::rncf::model::KernelCount] = &[];

                fn params() -> &'static [::rncf::Param] {
                    ::core::unreachable!()
                }
                fn outputs() -> &'static [::rncf::Output] {
                    ::core::unreachable!()
                }
                fn get(&self, _: usize) -> f64 {
                    ::core::unreachable!()
                }
                fn set(&mut self, _: usize, _: f64) {
                    ::core::unreachable!()
                }
                fn run(&self) -> ::rncf::RunDefaults {
                    ::core::unreachable!()
                }
                fn build_as(
                    &self,
                    _: ::rncf::Formulation,
                    _: ::rncf::Joints,
                    _: &[(::std::string::String, ::rncf::emitted::Fidelity)],
                ) -> ::core::result::Result<::std::boxed::Box<dyn ::rncf::Scene>, ::rncf::ModelError> {
                    ::core::unreachable!()
                }
            }
        };
    }
}

/// One field per parameter; of two with the same name the first.
fn fields(tree: &Tree) -> Vec<TokenStream> {
    let params: Vec<&Item> = tree.params().collect();
    let is_first = |at: usize| params[..at].iter().all(|other| other.name.text != params[at].name.text);
    (0..params.len())
        .filter(|at| is_first(*at))
        .map(|at| field(params[at]))
        .collect()
}

fn field(item: &Item) -> TokenStream {
    let name = identifier(&item.name.text, item.name.span);
    let doc = if item.doc.is_empty() {
        &item.name.text
    } else {
        &item.doc
    };
    let kind = match item.kind {
        ItemKind::Param { count: true, .. } => quote!(usize),
        ItemKind::FileTable { .. } => quote!(::rncf::TableFile),
        _ => quote!(f64),
    };
    quote!(#[doc = #doc] pub #name: #kind)
}

/// The parser has refused names that are no identifiers.
fn identifier(text: &str, span: Span) -> Ident {
    Ident::new(text, span)
}
