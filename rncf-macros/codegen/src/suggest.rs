//! 'Did you mean': the nearest valid word, or the list of all of them.

pub mod elsewhere;

/// Most valid words that are listed.
const MOST_LISTED: usize = 40;

/// "unknown kind `word`", with the nearest valid word, or with all of them.
pub fn unknown<'a>(kind: &str, word: &str, valid: impl IntoIterator<Item = &'a str>) -> String {
    let valid: Vec<&str> = valid.into_iter().collect();
    let head = if kind.contains('`') {
        format!("`{word}` is no {kind}")
    } else {
        format!("unknown {kind} `{word}`")
    };
    let alike = alike(word, &valid);
    match () {
        () if word == "diameter" && valid.contains(&"radius") => format!("{head}: write `radius`, half of it"),
        () if !alike.is_empty() => format!("{head}: did you mean {}?", list(&alike)),
        () if valid.is_empty() => format!("{head}: the model declares none"),
        () if valid.len() > MOST_LISTED => format!("{head}: use {}, ..", list(&valid[..MOST_LISTED])),
        () => format!("{head}: use {}", list(&valid)),
    }
}

/// A noun with its article.
pub fn a(noun: &str) -> String {
    let article = if noun.trim_start_matches('`').starts_with(['a', 'e', 'i', 'o']) {
        "an"
    } else {
        "a"
    };
    format!("{article} {noun}")
}

/// The valid words that may be meant: those that mean the same elsewhere, or the nearest one.
pub fn alike<'a>(word: &str, valid: &[&'a str]) -> Vec<&'a str> {
    let synonyms = elsewhere::synonyms(word, valid);
    match nearest(word, valid) {
        _ if !synonyms.is_empty() => synonyms,
        Some(near) => vec![near],
        None => begun(word, valid),
    }
}

/// `a`, `b` or `c`
pub fn list(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
        None => "nothing".into(),
    }
}

/// The valid words that have one letter more than a short word: `EIy` and `EIz` of `EI`.
fn begun<'a>(word: &str, valid: &[&'a str]) -> Vec<&'a str> {
    let has_one_more = |candidate: &&&str| candidate.len() == word.len() + 1 && candidate.starts_with(word);
    let found = valid.iter().filter(has_one_more).copied();
    if word.len() == 2 { found.collect() } else { Vec::new() }
}

/// The valid word that is the fewest edits away, if those are few.
pub fn nearest<'a>(word: &str, valid: &[&'a str]) -> Option<&'a str> {
    let most = (word.chars().count() / 3).max(1);
    // One letter more, less or other makes another word of one that has no more than two.
    let is_alike = |candidate: &str| word.len().min(candidate.len()) > 2 || letters(word) == letters(candidate);
    valid
        .iter()
        .filter(|candidate| is_alike(candidate))
        .map(|candidate| (edits(word, candidate), *candidate))
        .filter(|(edits, candidate)| {
            *edits <= most && (*edits < candidate.chars().count() || candidate.eq_ignore_ascii_case(word))
        })
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// The letters of a word without underscores in the order of the alphabet.
fn letters(word: &str) -> Vec<char> {
    let word = word.to_ascii_lowercase();
    let mut letters: Vec<char> = word.chars().filter(char::is_ascii_alphanumeric).collect();
    letters.sort_unstable();
    letters
}

/// Edit distance with swaps of neighbours; only the case being different counts as one edit.
fn edits(a: &str, b: &str) -> usize {
    if a.eq_ignore_ascii_case(b) {
        return usize::from(a != b);
    }
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = change.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// A computed number in six digits.
pub fn written(value: f64) -> String {
    let short: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let size = short.abs();
    if size == 0.0 || (1e-4..1e6).contains(&size) {
        format!("{short}")
    } else {
        format!("{short:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_found() {
        assert_eq!(
            unknown("field", "yuong", ["density", "young"]),
            "unknown field `yuong`: did you mean `young`?"
        );
        assert_eq!(
            unknown("field", "q", ["density", "young"]),
            "unknown field `q`: use `density` or `young`"
        );
        assert_eq!(
            unknown("unit", "pa", ["Pa", "kPa"]),
            "unknown unit `pa`: did you mean `Pa`?"
        );
        assert_eq!(
            unknown("field", "EI", ["EA", "EIy", "EIz"]),
            "unknown field `EI`: did you mean `EIy` or `EIz`?"
        );
        assert_eq!(nearest("S", &["N", "s"]), Some("s"));
        for (word, valid) in [("phi", ["pi", "t"]), ("in", ["min", "m"]), ("i", ["pi", "t"])] {
            assert_eq!(nearest(word, &valid), None, "{word}");
        }
        assert_eq!(
            unknown("joint", "hinge", ["clamp", "pin", "revolute"]),
            "unknown joint `hinge`: did you mean `revolute` or `pin`?"
        );
        for (inside, item) in [("revolute", "joint"), ("mesh", "body"), ("distributed", "load")] {
            assert_eq!(
                unknown("item", inside, ["body", "joint", "load", "motion"]),
                format!("unknown item `{inside}`: did you mean `{item}`?")
            );
        }
        assert_eq!(nearest("xz", &["xy", "yz", "zx"]), Some("zx"));
    }
}
