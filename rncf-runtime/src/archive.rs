//! Values to bytes and back to the same bits: what a run needs to go on later.
//!
//! One function for both ways, [`Keep::keep`], visits the fields of a value in one order, so that what is written and what is
//! read cannot differ.

/// Bytes that are being written or read.
#[derive(Debug)]
pub struct Archive<'b> {
    way: Way<'b>,
}

#[derive(Debug)]
enum Way<'b> {
    Writing(&'b mut Vec<u8>),
    /// What is left to read; none after the first misfit.
    Reading(Option<&'b [u8]>),
}

/// Bytes that do not have the form of the values that they are read into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misfit;

impl<'b> Archive<'b> {
    /// Appends to bytes.
    pub fn writing(bytes: &'b mut Vec<u8>) -> Self {
        Self {
            way: Way::Writing(bytes),
        }
    }

    /// Reads bytes from their beginning.
    pub fn reading(bytes: &'b [u8]) -> Self {
        Self {
            way: Way::Reading(Some(bytes)),
        }
    }

    /// Whether values are read; else they are written, and stay as they are.
    pub fn is_reading(&self) -> bool {
        matches!(self.way, Way::Reading(_))
    }

    /// Ends the archive: values that were read before are good if there was no misfit.
    ///
    /// # Errors
    /// Bytes are missing, left over, or mean nothing.
    pub fn end(self) -> Result<(), Misfit> {
        match self.way {
            Way::Writing(_) | Way::Reading(Some([])) => Ok(()),
            Way::Reading(_) => Err(Misfit),
        }
    }

    /// Says that what was read means nothing; all further values stay as they are.
    pub fn misfit(&mut self) {
        if let Way::Reading(rest) = &mut self.way {
            *rest = None;
        }
    }

    /// Values of which the reader has as many as the writer had.
    pub fn fixed<T: Keep>(&mut self, values: &mut [T]) {
        let mut length = values.len();
        length.keep(self);
        if length != values.len() {
            return self.misfit();
        }
        values.iter_mut().for_each(|value| value.keep(self));
    }

    /// Bytes as they are; the reader need not know how many.
    pub fn bytes(&mut self, bytes: &mut Vec<u8>) {
        let count = self.count(bytes.len());
        match &mut self.way {
            Way::Writing(all) => all.extend_from_slice(bytes),
            Way::Reading(rest) => {
                let split = rest.and_then(|rest| rest.split_at_checked(count));
                if let Some((these, _)) = split {
                    bytes.clear();
                    bytes.extend_from_slice(these);
                }
                *rest = split.map(|(_, others)| others);
            }
        }
    }

    /// Eight bytes.
    fn word(&mut self, word: &mut [u8; 8]) {
        match &mut self.way {
            Way::Writing(bytes) => bytes.extend_from_slice(word),
            Way::Reading(rest) => {
                let split = rest.and_then(|bytes| bytes.split_first_chunk());
                if let Some((first, _)) = split {
                    *word = *first;
                }
                *rest = split.map(|(_, others)| others);
            }
        }
    }

    /// A number of things of which each takes a byte at least; zero where it cannot be read.
    fn count(&mut self, count: usize) -> usize {
        let mut count = count;
        count.keep(self);
        match &self.way {
            Way::Writing(_) => count,
            Way::Reading(Some(rest)) if count <= rest.len() => count,
            Way::Reading(_) => {
                self.misfit();
                0
            }
        }
    }
}

/// A value that an archive can hold.
pub trait Keep {
    /// Writes the value, or reads it.
    fn keep(&mut self, archive: &mut Archive<'_>);
}

impl Keep for u64 {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut word = self.to_le_bytes();
        archive.word(&mut word);
        *self = u64::from_le_bytes(word);
    }
}

impl Keep for f64 {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut bits = self.to_bits();
        bits.keep(archive);
        *self = f64::from_bits(bits);
    }
}

impl Keep for usize {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut number = *self as u64;
        number.keep(archive);
        match usize::try_from(number) {
            Ok(number) => *self = number,
            Err(_) => archive.misfit(),
        }
    }
}

impl Keep for bool {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut number = u64::from(*self);
        number.keep(archive);
        match number {
            0 | 1 => *self = number == 1,
            _ => archive.misfit(),
        }
    }
}

impl<T: Keep, const N: usize> Keep for [T; N] {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.iter_mut().for_each(|value| value.keep(archive));
    }
}

impl<A: Keep, B: Keep> Keep for (A, B) {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.0.keep(archive);
        self.1.keep(archive);
    }
}

/// A list that grows: the reader need not know its length.
impl<T: Keep + Default> Keep for Vec<T> {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let count = archive.count(self.len());
        if archive.is_reading() {
            self.clear();
            self.resize_with(count, T::default);
        }
        self.iter_mut().for_each(|value| value.keep(archive));
    }
}

impl<T: Keep + Default> Keep for Option<T> {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut is_some = self.is_some();
        is_some.keep(archive);
        if archive.is_reading() {
            *self = is_some.then(T::default);
        }
        if let Some(value) = self {
            value.keep(archive);
        }
    }
}

impl Keep for String {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let mut bytes = std::mem::take(self).into_bytes();
        archive.bytes(&mut bytes);
        match String::from_utf8(bytes) {
            Ok(text) => *self = text,
            Err(_) => archive.misfit(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Debug, Default, PartialEq)]
    struct All {
        number: f64,
        list: Vec<f64>,
        fixed: [f64; 2],
        some: Option<usize>,
        none: Option<bool>,
        text: String,
    }

    impl Keep for All {
        fn keep(&mut self, archive: &mut Archive<'_>) {
            let Self {
                number,
                list,
                fixed,
                some,
                none,
                text,
            } = self;
            number.keep(archive);
            list.keep(archive);
            archive.fixed(fixed);
            some.keep(archive);
            none.keep(archive);
            text.keep(archive);
        }
    }

    fn written() -> (All, Vec<u8>) {
        let mut all = All {
            number: -0.0,
            list: vec![0.1 + 0.2, f64::INFINITY, 5e-324],
            fixed: [1.0, 2.0],
            some: Some(7),
            none: None,
            text: "Körper".into(),
        };
        let mut bytes = Vec::new();
        let mut archive = Archive::writing(&mut bytes);
        all.keep(&mut archive);
        archive.end().unwrap();
        (all, bytes)
    }

    fn read(bytes: &[u8], into: &mut All) -> Result<(), Misfit> {
        let mut archive = Archive::reading(bytes);
        into.keep(&mut archive);
        archive.end()
    }

    #[test]
    fn what_is_read_has_the_same_bits() {
        let (all, bytes) = written();
        let mut again = All {
            none: Some(true),
            list: vec![9.0; 9],
            ..All::default()
        };
        read(&bytes, &mut again).unwrap();
        assert_eq!(again, all);
        assert!(again.number.is_sign_negative());
    }

    #[test]
    fn bytes_of_another_form_are_a_misfit_and_no_panic() {
        let (_, bytes) = written();
        for length in 0..bytes.len() {
            assert_eq!(read(&bytes[..length], &mut All::default()), Err(Misfit), "{length}");
        }
        let mut longer = bytes.clone();
        longer.push(0);
        assert_eq!(read(&longer, &mut All::default()), Err(Misfit));
        // A length that no memory holds, a flag that is none, a text that is none.
        for (place, byte) in [(14, 255), (80, 2), (bytes.len() - 1, 255)] {
            let mut broken = bytes.clone();
            broken[place] = byte;
            assert_eq!(read(&broken, &mut All::default()), Err(Misfit), "{place}");
        }
        let mut bytes = Vec::new();
        Archive::writing(&mut bytes).fixed(&mut [1.0, 2.0]);
        let mut archive = Archive::reading(&bytes);
        archive.fixed(&mut [0.0; 3]);
        assert_eq!(archive.end(), Err(Misfit));
    }
}
