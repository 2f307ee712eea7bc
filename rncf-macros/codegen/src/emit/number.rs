//! The one place where an f64 is printed.

/// The shortest text that reads back to the same bits; always a float literal of Rust.
pub fn number(value: f64) -> String {
    // Debug prints the shortest exact form, with an exponent outside 1e-5..1e16.
    format!("{value:?}")
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn reads_back_to_the_same_bits() {
        assert_eq!(number(1e-300), "1e-300");
        assert_eq!(number(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(number(1.0), "1.0");
        let mut bits = 0x3ff0_0000_0000_0001u64;
        for _ in 0..20_000 {
            bits = bits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let value = f64::from_bits(bits);
            if value.is_finite() {
                let text = number(value);
                assert_eq!(text.parse::<f64>().unwrap().to_bits(), bits, "{text}");
                assert!(text.contains(['.', 'e']), "{text} would be an integer literal");
            }
        }
    }
}
