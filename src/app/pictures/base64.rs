//! Numbers as text: base64 of RFC 4648.

const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The text of some bytes.
pub fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let word = three
            .iter()
            .enumerate()
            .fold(0u32, |word, (at, &byte)| word | u32::from(byte) << (16 - 8 * at));
        for at in 0..4 {
            text.push(if at <= three.len() {
                char::from(LETTERS[(word >> (18 - 6 * at) & 63) as usize])
            } else {
                '='
            });
        }
    }
    text
}

#[cfg(test)]
pub fn decoded(text: &str) -> Vec<u8> {
    let code = |letter: u8| LETTERS.iter().position(|&own| own == letter).map(|code| code as u32);
    let mut bytes = Vec::new();
    for four in text.as_bytes().chunks(4) {
        let codes: Vec<u32> = four.iter().map_while(|&letter| code(letter)).collect();
        let word = codes
            .iter()
            .enumerate()
            .fold(0, |word, (at, code)| word | code << (18 - 6 * at));
        bytes.extend((0..codes.len() - 1).map(|at| (word >> (16 - 8 * at)) as u8));
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_vectors_of_the_standard() {
        // RFC 4648, section 10.
        let pairs = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, text) in pairs {
            assert_eq!(encode(plain.as_bytes()), text);
            assert_eq!(decoded(text), plain.as_bytes());
        }
    }
}
