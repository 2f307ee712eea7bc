//! A position in a list of tokens.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};

use super::messages as say;
use super::tree::Name;
use crate::errors::{Area, Mistake};

/// Result of a parser; the mistake is reported by whoever recovers.
pub type Parsed<T> = Result<T, Mistake>;

/// Tokens of one group and a position in them.
pub struct Cursor {
    tokens: Vec<TokenTree>,
    at: usize,
    close: Span,
}

impl Cursor {
    /// At the start of the tokens; `close` is underlined where something is missing at the end.
    pub fn new(stream: TokenStream, close: Span) -> Self {
        let mut tokens = Vec::new();
        flatten(stream, &mut tokens);
        Self { tokens, at: 0, close }
    }

    /// Of the content of a group.
    pub fn of(group: &Group) -> Self {
        Self::new(group.stream(), group.span_close())
    }

    pub fn is_empty(&self) -> bool {
        self.at >= self.tokens.len()
    }

    pub fn peek(&self) -> Option<&TokenTree> {
        self.tokens.get(self.at)
    }

    fn peek_second(&self) -> Option<&TokenTree> {
        self.tokens.get(self.at + 1)
    }

    pub fn next(&mut self) -> Option<TokenTree> {
        let token = self.tokens.get(self.at).cloned();
        self.at += usize::from(token.is_some());
        token
    }

    /// Position, to come back to.
    pub fn mark(&self) -> usize {
        self.at
    }

    /// Back to a marked position.
    pub fn reset(&mut self, mark: usize) {
        self.at = mark;
    }

    /// Span of the next token, or of the closing delimiter.
    pub fn here(&self) -> Span {
        self.peek().map_or(self.close, TokenTree::span)
    }

    /// Span of the token before.
    pub fn before(&self) -> Span {
        self.at
            .checked_sub(1)
            .and_then(|at| self.tokens.get(at))
            .map_or(self.close, TokenTree::span)
    }

    /// From a span to the token before.
    pub fn since(&self, start: Span) -> Area {
        Area {
            start,
            end: self.before(),
        }
    }

    pub fn word(&self) -> Option<&Ident> {
        match self.peek() {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    pub fn is_word(&self, word: &str) -> bool {
        self.word().is_some_and(|ident| ident == word)
    }

    /// Whether the next two tokens are words.
    pub fn is_two_words(&self) -> bool {
        self.word().is_some() && matches!(self.peek_second(), Some(TokenTree::Ident(_)))
    }

    pub fn eat_word(&mut self, word: &str) -> bool {
        let is = self.is_word(word);
        self.at += usize::from(is);
        is
    }

    pub fn is_punct(&self, c: char) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == c)
    }

    /// Whether the token after the next is this punctuation.
    pub fn is_second_punct(&self, c: char) -> bool {
        matches!(self.peek_second(), Some(TokenTree::Punct(punct)) if punct.as_char() == c)
    }

    /// Whether the token after the next is in these brackets.
    pub fn is_second_group(&self, delimiter: Delimiter) -> bool {
        matches!(self.peek_second(), Some(TokenTree::Group(group)) if group.delimiter() == delimiter)
    }

    /// The word that stands after the next two tokens.
    pub fn third_word(&self) -> Option<String> {
        match self.tokens.get(self.at + 2) {
            Some(TokenTree::Ident(ident)) => Some(ident.to_string()),
            _ => None,
        }
    }

    /// The word that stands after the next token.
    pub fn second_word(&self) -> Option<String> {
        match self.peek_second() {
            Some(TokenTree::Ident(word)) => Some(word.to_string()),
            _ => None,
        }
    }

    /// Whether a word and a colon stand here, and no path of Rust.
    pub fn is_named_by_colon(&self) -> bool {
        let is_single = |punct: &Punct| punct.as_char() == ':' && punct.spacing() == Spacing::Alone;
        self.word().is_some() && matches!(self.peek_second(), Some(TokenTree::Punct(punct)) if is_single(punct))
    }

    /// The number that stands after the next token.
    pub fn second_literal(&self) -> Option<String> {
        match self.peek_second() {
            Some(TokenTree::Literal(literal)) => Some(literal.to_string()),
            _ => None,
        }
    }

    /// The group behind the next token.
    pub fn second_group(&self) -> Option<&Group> {
        match self.peek_second() {
            Some(TokenTree::Group(group)) => Some(group),
            _ => None,
        }
    }

    /// Whether the token after the next is this word.
    pub fn is_second_word(&self, word: &str) -> bool {
        matches!(self.peek_second(), Some(TokenTree::Ident(ident)) if ident == word)
    }

    /// Whether the token after the next is punctuation, or there is none.
    pub fn is_second_punct_or_end(&self) -> bool {
        matches!(self.peek_second(), Some(TokenTree::Punct(_)) | None)
    }

    /// Whether no value can begin here: punctuation other than a sign.
    pub fn is_value_excluded(&self) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() != '-')
    }

    pub fn eat_punct(&mut self, c: char) -> bool {
        let is = self.is_punct(c);
        self.at += usize::from(is);
        is
    }

    pub fn group(&self, delimiter: Delimiter) -> Option<&Group> {
        match self.peek() {
            Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
            _ => None,
        }
    }

    pub fn eat_group(&mut self, delimiter: Delimiter) -> Option<Group> {
        let group = self.group(delimiter).cloned();
        self.at += usize::from(group.is_some());
        group
    }

    /// Past everything in the line in which `start` stands.
    pub fn skip_line(&mut self, start: Span) {
        let line = start.start().line;
        while self.peek().is_some_and(|token| token.span().start().line == line) {
            self.next();
        }
    }

    /// What stands here, for messages.
    pub fn found(&self) -> String {
        match self.peek() {
            None => "the end".into(),
            Some(TokenTree::Group(group)) => match group.delimiter() {
                Delimiter::Parenthesis => "`(`".into(),
                Delimiter::Brace => "`{`".into(),
                Delimiter::Bracket => "`[`".into(),
                Delimiter::None => "a group".into(),
            },
            Some(token) => format!("`{token}`"),
        }
    }

    /// What an operator of other languages is here, if one stands here.
    fn foreign(&self) -> Option<&'static str> {
        let doubled = |c| self.is_punct(c) && self.is_second_punct(c);
        match () {
            () if self.is_punct('?') => Some(say::TERNARY),
            () if doubled('&') || doubled('|') => Some(say::NO_LOGIC),
            () if doubled('=') || self.is_punct('!') && self.is_second_punct('=') => Some(say::NO_EQUALITY),
            () if self.is_punct('!') => Some(say::NO_LOGIC),
            () if self.is_punct('<') || self.is_punct('>') => Some(say::LONE_COMPARISON),
            () => None,
        }
    }

    /// The mistake that something else was expected here.
    pub fn expected(&self, what: &str) -> Mistake {
        if let Some(foreign) = self.foreign() {
            return Mistake::new(self.here(), foreign);
        }
        Mistake::new(self.here(), say::expected(what, &self.found()))
    }

    pub fn expect_punct(&mut self, c: char) -> Parsed<()> {
        if self.eat_punct(c) {
            Ok(())
        } else {
            Err(self.expected(&format!("`{c}`")))
        }
    }

    pub fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.eat_word(word) {
            Ok(())
        } else {
            Err(self.expected(&format!("`{word}`")))
        }
    }

    /// The `;` at the end of a statement; where it is missing the token before is underlined.
    pub fn expect_end(&mut self) -> Parsed<()> {
        if self.eat_punct(';') {
            return Ok(());
        }
        let is_assignment = self.word().is_some() && self.is_second_punct('=');
        let is_new = self.is_empty() || self.is_two_words() || is_assignment || self.is_punct('#');
        if is_new {
            return Err(Mistake::new(self.before(), say::missing_semicolon(&self.found())));
        }
        self.no_decimal_comma()?;
        Err(self.expected("`;`"))
    }

    /// Refuses `1,5`, of which the first number has been read.
    fn no_decimal_comma(&self) -> Parsed<()> {
        let before = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        match (before, self.peek_second()) {
            (Some(TokenTree::Literal(left)), Some(TokenTree::Literal(right))) if self.is_punct(',') => {
                let message = say::decimal_comma(&left.to_string(), &right.to_string());
                Err(Mistake::new(self.here(), message))
            }
            _ => Ok(()),
        }
    }

    /// Any word; what it names is said in the message.
    pub fn expect_name(&mut self, what: &str) -> Parsed<Name> {
        let Some(ident) = self.word().cloned() else {
            return Err(self.expected(what));
        };
        self.at += 1;
        Ok(Name::new(ident.to_string(), ident.span()))
    }
}

/// Resolves invisible groups (fragments of other macros): one token as it is, more in parentheses.
fn flatten(stream: TokenStream, out: &mut Vec<TokenTree>) {
    for token in stream {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                let inner: Vec<_> = group.stream().into_iter().collect();
                let is_visibility = inner.first().is_some_and(|first| first.to_string() == "pub");
                if inner.len() < 2 || is_visibility {
                    flatten(group.stream(), out);
                } else {
                    let mut visible = Group::new(Delimiter::Parenthesis, group.stream());
                    visible.set_span(group.span());
                    out.push(TokenTree::Group(visible));
                }
            }
            token => out.push(token),
        }
    }
}
