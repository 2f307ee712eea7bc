//! Arrays of numbers as numpy writes them (`.npy`).

/// An array, its last index fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Sizes.
    pub shape: Vec<usize>,
    /// Values.
    pub values: Vec<f64>,
}

/// First bytes.
const MAGIC: &[u8] = b"\x93NUMPY";

impl Array {
    /// Reads one.
    ///
    /// # Errors
    /// What is wrong with it, as the end of a sentence.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        let rest = bytes.strip_prefix(MAGIC).ok_or("is no array of numpy")?;
        let cut = || "is cut off".to_string();
        let (&major, rest) = rest.split_first().ok_or_else(cut)?;
        let width = if major == 1 { 2 } else { 4 };
        let size = rest.get(1..1 + width).ok_or_else(cut)?;
        let size = size.iter().rev().fold(0, |sum, &byte| sum << 8 | usize::from(byte));
        let start = 1 + width;
        let header = rest.get(start..start.saturating_add(size)).ok_or_else(cut)?;
        let header = String::from_utf8_lossy(header).into_owned();
        let data = &rest[start + size..];
        let kind = value_of(&header, "descr").ok_or("has no kind of number")?;
        let kind = kind.trim_matches(['\'', '"']);
        let is_fortran = value_of(&header, "fortran_order") == Some("True");
        let shape = value_of(&header, "shape").ok_or("has no shape")?;
        let numbers = shape
            .trim_matches(['(', ')'])
            .split(',')
            .map(str::trim)
            .filter(|part| !part.is_empty());
        let shape: Option<Vec<usize>> = numbers.map(|part| part.trim_end_matches('L').parse().ok()).collect();
        let shape = shape.ok_or("has no readable shape")?;
        let count = shape.iter().try_fold(1_usize, |all, &one| all.checked_mul(one));
        let count = count.ok_or("has a shape that no memory holds")?;
        let values = numbers_of(kind, data, count)?;
        let mut array = Self { shape, values };
        if is_fortran && array.shape.len() > 1 {
            array.transpose();
        }
        Ok(array)
    }

    /// From the first index fastest to the last.
    fn transpose(&mut self) {
        let (count, shape) = (self.values.len(), &self.shape);
        let mut values = Vec::with_capacity(count);
        for place in 0..count {
            let (mut rest, mut other, mut stride) = (place, 0, count);
            // Indices of the place from the last to the first; strides grow from the first.
            for &size in shape.iter().rev() {
                stride /= size;
                other += (rest % size) * stride;
                rest /= size;
            }
            values.push(self.values[other]);
        }
        self.values = values;
    }

    /// Its sizes for messages: `3 x 4`.
    pub fn describe(&self) -> String {
        match &self.shape[..] {
            [] => "one number".into(),
            [one] => format!("{one} numbers"),
            sizes => sizes.iter().map(usize::to_string).collect::<Vec<_>>().join(" x "),
        }
    }
}

/// The text behind a key of the header, which is a dictionary of Python.
fn value_of<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let at = header
        .find(&format!("'{key}'"))
        .or_else(|| header.find(&format!("\"{key}\"")))?;
    let rest = header[at + key.len() + 2..]
        .trim_start()
        .strip_prefix(':')?
        .trim_start();
    let end = match rest.starts_with('(') {
        true => rest.find(')')? + 1,
        false => rest.find([',', '}'])?,
    };
    Some(rest[..end].trim())
}

fn numbers_of(kind: &str, data: &[u8], count: usize) -> Result<Vec<f64>, String> {
    let mut letters = kind.chars();
    let order = letters.next().unwrap_or(' ');
    let is_big = match order {
        '<' | '|' => false,
        '=' => cfg!(target_endian = "big"),
        '>' => true,
        _ => false,
    };
    let refused = || {
        format!(
            "holds `{kind}`, and what is read are real numbers (`<f8`, `<f4`) and whole ones: save it with `astype(float)`"
        )
    };
    let (letter, width) = kind
        .trim_start_matches(['<', '>', '|', '='])
        .split_at_checked(1)
        .ok_or_else(refused)?;
    let width: usize = width.parse().map_err(|_| refused())?;
    if !matches!((letter, width), ("f", 4 | 8) | ("i" | "u", 1 | 2 | 4 | 8)) {
        return Err(refused());
    }
    if count.checked_mul(width).is_none_or(|size| size != data.len()) {
        return Err(format!("has {} bytes for {count} numbers of {width}", data.len()));
    }
    let number = |bytes: &[u8]| {
        let mut own = [0; 8];
        for (place, byte) in own.iter_mut().zip(bytes) {
            *place = *byte;
        }
        if is_big {
            own[..width].reverse();
        }
        let bits = u64::from_le_bytes(own);
        let unused = 64 - 8 * width as u32;
        match (letter, width) {
            ("f", 8) => f64::from_bits(bits),
            ("f", _) => f64::from(f32::from_bits(bits as u32)),
            ("u", _) => bits as f64,
            _ => (((bits << unused) as i64) >> unused) as f64,
        }
    };
    Ok(data.chunks_exact(width).map(number).collect())
}
