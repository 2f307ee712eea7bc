//! The macros of `rncf`, `model!` and `library!`; everything it does is in `rncf-codegen`.

/// Declares a library: components, materials, sections and tables that several models share.
///
/// It becomes a macro of its name; `use path::name;` in front of a model takes it in.
#[proc_macro]
pub fn library(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    rncf_codegen::expand::library(tokens.into()).into()
}

/// Declares a model: at build time it is checked, its equations are derived and written as Rust.
///
/// The language is described in `docs/language.md`. The macro makes a struct with the model's
/// parameters as fields, which implements `rncf::Model`, and a module with its equations.
#[proc_macro]
pub fn model(tokens: proc_macro::TokenStream) -> proc_macro::TokenStream {
    rncf_codegen::expand::expand(tokens.into()).into()
}
