//! Data compressed as RFC 1951 says it (deflate), as members of zip archives are.

/// Lengths of code words that there are at most.
const LONGEST: usize = 15;
/// Least lengths of copies, and how many further bits each has.
#[rustfmt::skip]
const LENGTHS: [(u16, u8); 29] = [
    (3, 0), (4, 0), (5, 0), (6, 0), (7, 0), (8, 0), (9, 0), (10, 0), (11, 1), (13, 1), (15, 1), (17, 1), (19, 2),
    (23, 2), (27, 2), (31, 2), (35, 3), (43, 3), (51, 3), (59, 3), (67, 4), (83, 4), (99, 4), (115, 4), (131, 5),
    (163, 5), (195, 5), (227, 5), (258, 0),
];
/// The same of distances.
#[rustfmt::skip]
const DISTANCES: [(u16, u8); 30] = [
    (1, 0), (2, 0), (3, 0), (4, 0), (5, 1), (7, 1), (9, 2), (13, 2), (17, 3), (25, 3), (33, 4), (49, 4), (65, 5),
    (97, 5), (129, 6), (193, 6), (257, 7), (385, 7), (513, 8), (769, 8), (1025, 9), (1537, 9), (2049, 10), (3073, 10),
    (4097, 11), (6145, 11), (8193, 12), (12289, 12), (16385, 13), (24577, 13),
];
/// Order in which lengths of the code of lengths stand.
const ORDER: [usize; 19] = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];

struct Bits<'a> {
    bytes: &'a [u8],
    /// Next byte.
    at: usize,
    held: u32,
    count: u32,
}

impl Bits<'_> {
    fn take(&mut self, count: u32) -> Option<u32> {
        while self.count < count {
            self.held |= u32::from(*self.bytes.get(self.at)?) << self.count;
            self.at += 1;
            self.count += 8;
        }
        let value = self.held & ((1 << count) - 1);
        self.held >>= count;
        self.count -= count;
        Some(value)
    }
}

/// A code: how many words have each length, and what they mean in their order.
struct Code {
    counts: [u16; LONGEST + 1],
    symbols: Vec<u16>,
}

impl Code {
    /// From the length of the word of each symbol; `None`: there are more words than there can be.
    fn new(lengths: &[u8]) -> Option<Self> {
        let mut counts = [0; LONGEST + 1];
        for &length in lengths {
            counts[usize::from(length)] += 1;
        }
        counts[0] = 0;
        let (mut left, mut starts) = (1_i32, [0_usize; LONGEST + 2]);
        for length in 1..=LONGEST {
            left = 2 * left - i32::from(counts[length]);
            if left < 0 {
                return None;
            }
            starts[length + 1] = starts[length] + usize::from(counts[length]);
        }
        let mut symbols = vec![0; lengths.len()];
        for (symbol, &length) in lengths.iter().enumerate().filter(|(_, length)| **length > 0) {
            let place = &mut starts[usize::from(length)];
            symbols[*place] = symbol as u16;
            *place += 1;
        }
        Some(Self { counts, symbols })
    }

    fn read(&self, bits: &mut Bits) -> Option<usize> {
        let (mut word, mut first, mut index) = (0_i32, 0_i32, 0_i32);
        for length in 1..=LONGEST {
            word |= bits.take(1)? as i32;
            let count = i32::from(self.counts[length]);
            if word - first < count {
                return self
                    .symbols
                    .get((index + word - first) as usize)
                    .map(|symbol| usize::from(*symbol));
            }
            index += count;
            first = (first + count) << 1;
            word <<= 1;
        }
        None
    }
}

/// The data, of which there are `size` bytes; `None`: they are not that.
pub fn inflate(bytes: &[u8], size: usize) -> Option<Vec<u8>> {
    let mut bits = Bits {
        bytes,
        at: 0,
        held: 0,
        count: 0,
    };
    // What a header promises is not reserved before it has come.
    let mut out = Vec::with_capacity(size.min(8 * bytes.len()));
    loop {
        let is_last = bits.take(1)? == 1;
        match bits.take(2)? {
            0 => {
                (bits.held, bits.count) = (0, 0);
                let header = bytes.get(bits.at..bits.at + 4)?;
                let length = u16::from_le_bytes([header[0], header[1]]);
                if length != !u16::from_le_bytes([header[2], header[3]]) {
                    return None;
                }
                let start = bits.at + 4;
                out.extend_from_slice(bytes.get(start..start + usize::from(length))?);
                bits.at = start + usize::from(length);
            }
            1 => {
                let mut lengths = [8; 288];
                lengths[144..256].fill(9);
                lengths[256..280].fill(7);
                block(&mut bits, &Code::new(&lengths)?, &Code::new(&[5; 30])?, size, &mut out)?;
            }
            2 => {
                let [literals, distances] = codes(&mut bits)?;
                block(&mut bits, &literals, &distances, size, &mut out)?;
            }
            _ => return None,
        }
        if out.len() > size {
            return None;
        }
        if is_last {
            return (out.len() == size).then_some(out);
        }
    }
}

/// The codes of a block that brings its own.
fn codes(bits: &mut Bits) -> Option<[Code; 2]> {
    let literals = bits.take(5)? as usize + 257;
    let distances = bits.take(5)? as usize + 1;
    let count = bits.take(4)? as usize + 4;
    let mut lengths = [0; 19];
    for &place in &ORDER[..count] {
        lengths[place] = bits.take(3)? as u8;
    }
    let code = Code::new(&lengths)?;
    let mut all: Vec<u8> = Vec::new();
    while all.len() < literals + distances {
        let (value, times) = match code.read(bits)? {
            16 => (*all.last()?, bits.take(2)? + 3),
            17 => (0, bits.take(3)? + 3),
            18 => (0, bits.take(7)? + 11),
            length => (length as u8, 1),
        };
        all.extend((0..times).map(|_| value));
    }
    if all.len() > literals + distances {
        return None;
    }
    Some([Code::new(&all[..literals])?, Code::new(&all[literals..])?])
}

fn block(bits: &mut Bits, literals: &Code, distances: &Code, size: usize, out: &mut Vec<u8>) -> Option<()> {
    loop {
        match literals.read(bits)? {
            literal @ 0..256 => out.push(literal as u8),
            256 => return Some(()),
            symbol => {
                let &(length, further) = LENGTHS.get(symbol - 257)?;
                let length = usize::from(length) + bits.take(u32::from(further))? as usize;
                let &(distance, further) = DISTANCES.get(distances.read(bits)?)?;
                let distance = usize::from(distance) + bits.take(u32::from(further))? as usize;
                let start = out.len().checked_sub(distance)?;
                for place in start..start + length {
                    out.push(out[place]);
                }
            }
        }
        if out.len() > size {
            return None;
        }
    }
}
