//! Which words may be names, and ASCII spellings of what people like to write otherwise.

/// Characters and what to write instead.
#[rustfmt::skip]
const SPELLINGS: &[(char, &str)] = &[
    ('α', "alpha"), ('β', "beta"), ('γ', "gamma"), ('δ', "delta"), ('ε', "epsilon"), ('ζ', "zeta"), ('η', "eta"),
    ('θ', "theta"), ('ϑ', "theta"), ('ι', "iota"), ('κ', "kappa"), ('λ', "lambda"), ('μ', "mu"), ('µ', "u"),
    ('ν', "nu"), ('ξ', "xi"), ('ο', "omicron"), ('π', "pi"), ('ρ', "rho"), ('σ', "sigma"), ('ς', "sigma"),
    ('τ', "tau"), ('υ', "upsilon"), ('φ', "phi"), ('ϕ', "phi"), ('χ', "chi"), ('ψ', "psi"), ('ω', "omega"),
    ('Γ', "Gamma"), ('Δ', "Delta"), ('Θ', "Theta"), ('Λ', "Lambda"), ('Ξ', "Xi"), ('Π', "Pi"), ('Σ', "Sigma"),
    ('Φ', "Phi"), ('Ψ', "Psi"), ('Ω', "Omega"), ('·', "*"), ('ä', "ae"), ('ö', "oe"), ('ü', "ue"), ('ß', "ss"),
    ('Ä', "Ae"), ('Ö', "Oe"), ('Ü', "Ue"), ('é', "e"), ('è', "e"), ('å', "a"), ('ø', "o"), ('₀', "0"), ('₁', "1"),
    ('₂', "2"), ('₃', "3"),
];

/// An ASCII spelling of a word, or `None` where it is ASCII.
pub fn suggestion(word: &str) -> Option<String> {
    if word.is_ascii() {
        return None;
    }
    let spelled = word
        .chars()
        .map(|c| match SPELLINGS.iter().find(|(other, _)| *other == c) {
            Some((_, spelling)) => (*spelling).to_string(),
            None if c.is_ascii() => c.to_string(),
            None => "_".into(),
        });
    Some(spelled.collect())
}

/// Whether Rust takes a word as a name.
pub fn is_identifier(word: &str) -> bool {
    // `gen` is none since edition 2024, of which nothing is known here.
    word != "gen" && syn::parse_str::<syn::Ident>(word).is_ok()
}
