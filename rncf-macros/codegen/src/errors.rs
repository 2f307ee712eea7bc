//! All mistakes of a declaration, collected with the places that they underline.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};

/// A stretch of source text, from the first to the last token that an error underlines.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    /// Span of the first token.
    pub start: Span,
    /// Span of the last token.
    pub end: Span,
}

impl Area {
    /// From the start of one area to the end of another.
    #[must_use]
    pub fn to(self, other: Area) -> Area {
        Area {
            start: self.start,
            end: other.end,
        }
    }

    /// The source text, where the spans come from parsed text.
    pub fn source_text(self) -> Option<String> {
        self.start.join(self.end)?.source_text()
    }

    /// Line number of the first token, counted from 1 (0 where unknown).
    pub fn line(self) -> usize {
        self.start.start().line
    }
}

impl From<Span> for Area {
    fn from(span: Span) -> Self {
        Area { start: span, end: span }
    }
}

/// What the compiler says to be deprecated where a warning stands.
pub const WARNING: &str = "no_influence";

/// One mistake: what is underlined, what is wrong and what would be right.
#[derive(Clone, Debug)]
pub struct Mistake {
    /// What is underlined.
    pub area: Area,
    /// What is wrong, and what would be right.
    pub message: String,
    /// As a warning: what the compiler says to be deprecated.
    called: &'static str,
}

impl Mistake {
    /// A mistake at a place.
    pub fn new(area: impl Into<Area>, message: impl Into<String>) -> Self {
        Mistake {
            area: area.into(),
            message: message.into(),
            called: WARNING,
        }
    }

    /// The same with another word for what a compiler says to be deprecated.
    pub fn called(self, called: &'static str) -> Self {
        Mistake { called, ..self }
    }

    /// `compile_error!` with this message, underlining from the first to the last token.
    pub fn to_tokens(&self) -> TokenStream {
        let message = &self.message;
        let (start, end) = (self.area.start, self.area.end);
        let call = quote_spanned!(end=> { #message });
        quote_spanned!(start=> ::core::compile_error! #call)
    }

    /// A warning with this message, underlining the first token. On stable Rust a macro warns by the use of something
    /// deprecated, so that `allow(deprecated)` around the macro silences it and `deny(deprecated)` makes it an error.
    pub fn to_warning(&self) -> TokenStream {
        let message = &self.message;
        let word = Ident::new(self.called, self.area.start);
        let item = Ident::new(self.called, Span::call_site());
        quote! {
            #[allow(non_upper_case_globals)]
            const _: () = {
                #[deprecated(note = #message)]
                const #item: () = ();
                #word
            };
        }
    }
}

/// Collects all mistakes, so that one build reports every one of them. Dropping it without having
/// asked for the mistakes ([`Errors::finish`]) is a programming error and panics.
#[derive(Debug, Default)]
pub struct Errors {
    mistakes: Vec<Mistake>,
    asked: bool,
    /// Whether of several at one place the first is enough.
    once: bool,
}

impl Errors {
    /// No mistakes so far.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a mistake.
    pub fn push(&mut self, mistake: Mistake) {
        self.mistakes.push(mistake);
    }

    /// Adds a mistake at a place.
    pub fn at(&mut self, area: impl Into<Area>, message: impl Into<String>) {
        self.push(Mistake::new(area, message));
    }

    /// Whether there is no mistake so far.
    pub fn is_empty(&self) -> bool {
        self.mistakes.is_empty()
    }

    /// Number of mistakes so far.
    pub fn len(&self) -> usize {
        self.mistakes.len()
    }

    /// Items stand there more than once: of mistakes at one place in the text the first is enough.
    pub fn at_each_place_once(&mut self) {
        self.once = true;
    }

    /// All mistakes in the order in which they were found.
    pub fn finish(mut self) -> Vec<Mistake> {
        self.asked = true;
        let mistakes = std::mem::take(&mut self.mistakes);
        if self.once {
            at_each_place_once(mistakes)
        } else {
            mistakes
        }
    }

    /// One `compile_error!` per mistake; nothing where there is none.
    pub fn into_tokens(self) -> TokenStream {
        self.finish().iter().map(Mistake::to_tokens).collect()
    }

    /// The same of a declaration that takes in what stands in other files. The compiler shows no places in other crates, so
    /// that the messages say them.
    pub fn into_tokens_beside(self, declaration: Span) -> TokenStream {
        let (own, mut mistakes) = (declaration.file(), self.finish());
        for mistake in &mut mistakes {
            let start = mistake.area.start;
            let file = start.file();
            if file != own {
                let (line, column) = (start.start().line, start.start().column + 1);
                mistake.message += &format!(" (in {file}:{line}:{column})");
            }
        }
        mistakes.iter().map(Mistake::to_tokens).collect()
    }
}

/// The first mistake at each place in the text.
pub fn at_each_place_once(mut mistakes: Vec<Mistake>) -> Vec<Mistake> {
    let mut places = std::collections::HashSet::new();
    // A span has no equality, but its bytes in the text are shown.
    mistakes.retain(|mistake| places.insert(format!("{:?} {:?}", mistake.area.start, mistake.area.end)));
    mistakes
}

impl Drop for Errors {
    fn drop(&mut self) {
        if !self.asked && !std::thread::panicking() {
            panic!("the mistakes of a declaration were never asked for");
        }
    }
}
