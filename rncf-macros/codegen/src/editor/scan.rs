//! Names in tokens: where items begin, and which words are names.

use std::collections::HashMap;

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

use super::{Declared, Place, Scope, Sight, Use};
use crate::parse::ascii::is_identifier;
use crate::vocabulary::members::{GIVEN, Thing};

/// Words in front of names, in models and components.
const ITEMS: [&str; 21] = [
    "param",
    "const",
    "let",
    "motion",
    "frame",
    "material",
    "section",
    "table",
    "element",
    "rigid",
    "body",
    "fixture",
    "joint",
    "constraint",
    "spring",
    "state",
    "load",
    "output",
    "caution",
    "component",
    "part",
];

/// Words in front of names in an element.
const IN_ELEMENTS: [&str; 6] = ["vector", "field", "coefficient", "let", "strain", "energy"];

/// Letters of an item's text that a hover shows.
const LONGEST: usize = 400;

/// All names and their uses.
#[derive(Debug, Default)]
pub struct Found {
    /// The first one is that of the model.
    pub scopes: Vec<Scope>,
    pub uses: Vec<Use>,
    /// Words where a name may stand, in the order of the text.
    pub places: Vec<Place>,
    /// Scopes by the names of components; of elements they are seen from inside alone.
    components: HashMap<String, usize>,
    /// Scopes of what stands in braces, in the order of the text.
    inner: Vec<usize>,
    /// How many of them have been passed.
    passed: usize,
}

/// Finds the names of a declaration.
pub fn scan(tokens: TokenStream) -> Found {
    let mut found = Found {
        scopes: vec![Scope::default()],
        ..Found::default()
    };
    let groups = bodies(tokens);
    for group in &groups {
        found.declarations(&list(group.stream()), 0, &ITEMS);
    }
    for group in &groups {
        found.uses(&list(group.stream()), 0, Some(&ITEMS));
    }
    found
}

fn list(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

/// What stands in the braces of libraries and of the model.
fn bodies(tokens: TokenStream) -> Vec<Group> {
    let braces = tokens.into_iter().filter_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    });
    braces.collect()
}

fn is_punct(token: Option<&TokenTree>, sign: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

fn group(token: Option<&TokenTree>, delimiter: Delimiter) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
        _ => None,
    }
}

/// A word that may be a name of Rust.
fn ident(token: Option<&TokenTree>) -> Option<&Ident> {
    match token {
        Some(TokenTree::Ident(ident)) if is_identifier(&ident.to_string()) => Some(ident),
        _ => None,
    }
}

/// The place behind an item: its semicolon or its braces.
fn end(tokens: &[TokenTree], from: usize) -> usize {
    let is_end = |token: &TokenTree| is_punct(Some(token), ';') || group(Some(token), Delimiter::Brace).is_some();
    let found = tokens[from..].iter().position(is_end);
    found.map_or(tokens.len(), |at| from + at + 1)
}

/// The beginning of an item's text.
fn text(tokens: &[TokenTree]) -> String {
    let from = tokens.first().map(TokenTree::span);
    let whole = from.and_then(|from| from.join(tokens[tokens.len() - 1].span())?.source_text());
    let printed = || {
        let text = tokens.iter().cloned().collect::<TokenStream>().to_string();
        let close = [(" ;", ";"), (" ,", ","), (" . ", "."), (" (", "("), (" ^ ", "^")];
        close.iter().fold(text, |text, (wide, close)| text.replace(wide, close))
    };
    let text = whole.unwrap_or_else(printed);
    match text.char_indices().nth(LONGEST) {
        Some((at, _)) => format!("{} ..", &text[..at]),
        None => text,
    }
}

/// The text of a documentation comment, `#[doc = ".."]` behind its `#`.
fn doc(group: &Group) -> Option<String> {
    let tokens = list(group.stream());
    match tokens.as_slice() {
        [TokenTree::Ident(word), _, TokenTree::Literal(text)] if word == "doc" => {
            let text: syn::LitStr = syn::parse_str(&text.to_string()).ok()?;
            Some(text.value().trim().to_string())
        }
        _ => None,
    }
}

impl Found {
    /// Collects what is declared among the items of a scope.
    fn declarations(&mut self, tokens: &[TokenTree], scope: usize, words: &[&str]) {
        let (mut at, mut docs) = (0, Vec::new());
        while at < tokens.len() {
            if is_punct(tokens.get(at), '#')
                && let Some(attribute) = group(tokens.get(at + 1), Delimiter::Bracket)
            {
                docs.extend(doc(attribute));
                at += 2;
                continue;
            }
            let behind = end(tokens, at);
            let (item, docs) = (&tokens[at..behind], std::mem::take(&mut docs));
            at = behind;
            let Some(TokenTree::Ident(word)) = item.first() else {
                continue;
            };
            let braces = group(item.last(), Delimiter::Brace);
            if word == "for"
                && let Some(braces) = braces
            {
                self.declarations(&list(braces.stream()), scope, words);
                continue;
            }
            let (kind, Some(name)) = (word.to_string(), ident(item.get(1))) else {
                continue;
            };
            if words.contains(&kind.as_str()) {
                self.declare(scope, kind, name, docs.join(" "), item);
            }
        }
    }

    fn declare(&mut self, scope: usize, kind: String, name: &Ident, doc: String, item: &[TokenTree]) {
        let text_of = text(item);
        let component = (kind == "part").then(|| {
            let equals = item.iter().position(|token| is_punct(Some(token), '='))?;
            Some(ident(item.get(equals + 1))?.to_string())
        });
        let braces = group(item.last(), Delimiter::Brace);
        let inner = match kind.as_str() {
            "component" => braces.map(|braces| (braces, ITEMS.as_slice())),
            "element" => braces.map(|braces| (braces, IN_ELEMENTS.as_slice())),
            _ => None,
        };
        if let Some((braces, words)) = inner {
            let own = self.scopes.len();
            self.scopes.push(Scope {
                outer: Some(scope),
                ..Scope::default()
            });
            self.inner.push(own);
            if kind == "component" {
                self.components.insert(name.to_string(), own);
                if let Some(told) = item.iter().find_map(|token| group(Some(token), Delimiter::Parenthesis)) {
                    self.told(&list(told.stream()), own);
                }
            }
            self.declarations(&list(braces.stream()), own, words);
        }
        let declared = Declared {
            name: name.clone(),
            doc,
            text: text_of,
            component: component.flatten(),
            thing: Thing::of(&kind),
            kind,
        };
        let scope = &mut self.scopes[scope];
        let names = match declared.kind.as_str() {
            "output" => &mut scope.outputs,
            _ => &mut scope.names,
        };
        if names.iter().all(|other| other.name != declared.name) {
            names.push(declared);
        }
    }

    /// What a component is told: `name: kind`.
    fn told(&mut self, tokens: &[TokenTree], scope: usize) {
        for at in 0..tokens.len() {
            let is_first = at == 0 || is_punct(tokens.get(at - 1), ',');
            if let Some(name) = ident(tokens.get(at)).filter(|_| is_first && is_punct(tokens.get(at + 1), ':')) {
                let names = &mut self.scopes[scope].names;
                if names.iter().all(|other| other.name != *name) {
                    names.push(Declared {
                        name: name.clone(),
                        kind: "argument".into(),
                        doc: String::new(),
                        text: String::new(),
                        component: None,
                        thing: tokens.get(at + 2).and_then(|kind| Thing::of(&kind.to_string())),
                    });
                }
            }
        }
    }

    /// Collects uses of names; `words` begin items where these may stand.
    fn uses(&mut self, tokens: &[TokenTree], scope: usize, words: Option<&[&str]>) {
        // What is seen behind a dot.
        let mut behind = None;
        let mut is_start = words.is_some();
        let (mut at, mut inner) = (0, None);
        while at < tokens.len() {
            let before = at.checked_sub(1).and_then(|before| tokens.get(before));
            match &tokens[at] {
                TokenTree::Punct(punct) => {
                    is_start = words.is_some() && (punct.as_char() == ';' || is_start && punct.as_char() == '#');
                    if punct.as_char() != '.' {
                        behind = None;
                    }
                }
                TokenTree::Group(group) => {
                    let is_unit = matches!(before, Some(TokenTree::Literal(_)));
                    let is_doc = is_punct(before, '#');
                    let is_brace = group.delimiter() == Delimiter::Brace;
                    let inside = list(group.stream());
                    match inner.take_if(|_| is_brace) {
                        Some((own, words)) => self.uses(&inside, own, Some(words)),
                        None if is_unit || is_doc => {}
                        // Braces of loops have items, and those of bodies statements, which begin with none of these words.
                        None => self.uses(&inside, scope, words.filter(|_| is_brace)),
                    }
                    is_start = is_start && is_doc || words.is_some() && is_brace;
                    let is_call = group.delimiter() == Delimiter::Parenthesis && matches!(behind, Some(Sight::Of(_)));
                    if group.delimiter() != Delimiter::Bracket && !is_call {
                        behind = None;
                    }
                }
                TokenTree::Ident(word) => {
                    let text = word.to_string();
                    if is_start && words.is_some_and(|words| words.contains(&text.as_str())) {
                        if ident(tokens.get(at + 1)).is_some() && matches!(text.as_str(), "component" | "element") {
                            let words: &[&str] = if text == "element" { &IN_ELEMENTS } else { &ITEMS };
                            let end = end(tokens, at);
                            if group(tokens.get(end - 1), Delimiter::Brace).is_some() {
                                inner = self.inner.get(self.passed).map(|own| (*own, words));
                                self.passed += 1;
                            }
                        }
                        at += 2;
                        (is_start, behind) = (false, None);
                        continue;
                    }
                    is_start = false;
                    let is_member = is_punct(before, '.') && !is_range(tokens, at);
                    // What is seen `.in(FRAME)` is what it was.
                    if !(is_member && text == "in") {
                        let sight = if is_member { behind } else { Some(Sight::Scope(scope)) };
                        let sight = sight.filter(|_| is_member || self.may_be_name(tokens, at));
                        behind = sight.and_then(|sight| self.place(word, sight));
                    }
                }
                TokenTree::Literal(_) => {
                    is_start = false;
                    behind = None;
                }
            }
            at += 1;
        }
    }

    /// Whether a word stands where no unit, argument or declaration does.
    fn may_be_name(&self, tokens: &[TokenTree], at: usize) -> bool {
        let before = at.checked_sub(1).and_then(|before| tokens.get(before));
        let is_unit = matches!(before, Some(TokenTree::Literal(_))) || group(before, Delimiter::Bracket).is_some();
        let is_argument = is_punct(tokens.get(at + 1), '=') && !is_punct(tokens.get(at + 2), '=');
        !is_unit && !is_argument && !is_punct(before, ':')
    }

    /// Notes a word where a name may stand; what is seen behind its dot.
    fn place(&mut self, word: &Ident, sight: Sight) -> Option<Sight> {
        ident(Some(&TokenTree::Ident(word.clone())))?;
        self.places.push(Place {
            word: word.clone(),
            sight,
        });
        match sight {
            Sight::Of(thing) => thing.then(&word.to_string()).map(Sight::Of),
            Sight::Scope(scope) => self.mention(word, scope, false),
            Sight::Part(scope) => self.mention(word, scope, true),
        }
    }

    /// Notes the use of a name that a scope sees; what is seen behind its dot.
    fn mention(&mut self, word: &Ident, from: usize, is_member: bool) -> Option<Sight> {
        let mut seen = Some(from);
        while let Some(scope) = seen {
            let found = self.scopes[scope].names.iter().find(|other| other.name == *word);
            if let Some(declared) = found {
                let part = declared.component.as_ref().and_then(|name| self.components.get(name));
                let behind = part.map(|scope| Sight::Part(*scope)).or(declared.thing.map(Sight::Of));
                self.uses.push(Use {
                    name: word.clone(),
                    scope,
                    is_output: false,
                });
                return behind;
            }
            if is_member {
                let is_output = self.scopes[scope].outputs.iter().any(|other| other.name == *word);
                if is_output {
                    self.uses.push(Use {
                        name: word.clone(),
                        scope,
                        is_output,
                    });
                }
                return None;
            }
            seen = self.scopes[scope].outer;
        }
        GIVEN.iter().find(|(name, ..)| word == name)?.2.map(Sight::Of)
    }
}

/// Whether the point before a word is the second one of `0..n`.
fn is_range(tokens: &[TokenTree], at: usize) -> bool {
    at >= 2 && is_punct(tokens.get(at - 2), '.')
}
