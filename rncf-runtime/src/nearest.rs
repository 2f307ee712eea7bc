//! The known name nearest to a mistyped one.

/// The candidate with the smallest edit distance to `text`, if it is near enough to be meant.
pub fn nearest<'n>(text: &str, candidates: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let limit = (text.chars().count() / 2).clamp(1, 3);
    // One letter more, less or other makes another word of one that has no more than two.
    let is_alike = |name: &str| text.len().min(name.len()) > 2 || letters(text) == letters(name);
    candidates
        .into_iter()
        .filter(|name| is_alike(name))
        .map(|name| (distance(text, name), name))
        .filter(|&(distance, name)| distance <= limit && distance < name.chars().count())
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, name)| name)
}

/// The letters of a word without underscores in the order of the alphabet.
fn letters(word: &str) -> Vec<char> {
    let mut letters: Vec<char> = word.to_lowercase().chars().filter(|c| c.is_alphanumeric()).collect();
    letters.sort_unstable();
    letters
}

/// Insertions, deletions, substitutions and swaps of neighbours that turn `a` into `b`; letters
/// that differ in case alone count as equal.
fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            if i == 0 || j == 0 {
                rows[i][j] = i + j;
                continue;
            }
            let mut best = (rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]))
                .min(rows[i - 1][j] + 1)
                .min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_edits() {
        assert_eq!(distance("omega", "omega"), 0);
        assert_eq!(distance("T_S", "T_s"), 0);
        assert_eq!(distance("oemga", "omega"), 1);
        assert_eq!(distance("elments", "elements"), 1);
        assert_eq!(distance("", "abc"), 3);
    }

    #[test]
    fn far_names_are_not_suggested() {
        let names = ["omega_s", "elements", "T_s"];
        assert_eq!(nearest("omega", names), Some("omega_s"));
        assert_eq!(nearest("t_s", names), Some("T_s"));
        assert_eq!(nearest("gravity", names), None);
    }
}
