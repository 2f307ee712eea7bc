//! Members of zip archives, stored or deflated.

use miniz_oxide::inflate::decompress_to_vec_with_limit as inflate;

/// Signatures of the end of an archive, of an entry of its directory, and of a member.
const END: [u8; 4] = *b"PK\x05\x06";
const ENTRY: [u8; 4] = *b"PK\x01\x02";
const MEMBER: [u8; 4] = *b"PK\x03\x04";
/// Sizes of their fixed parts.
const END_SIZE: usize = 22;
const ENTRY_SIZE: usize = 46;
const MEMBER_SIZE: usize = 30;
/// Sizes that stand elsewhere, in the extra field that begins with this number.
const ELSEWHERE: usize = u32::MAX as usize;
const WIDE: usize = 1;

/// A member, not yet unpacked.
#[derive(Clone, Debug)]
pub struct Member<'a> {
    /// Name.
    pub name: String,
    bytes: &'a [u8],
    method: usize,
    size: usize,
    check: u32,
}

fn number(bytes: &[u8], at: usize, width: usize) -> Option<usize> {
    let own = bytes.get(at..at.checked_add(width)?)?;
    Some(own.iter().rev().fold(0, |sum, &byte| sum << 8 | usize::from(byte)))
}

/// The members of an archive.
///
/// # Errors
/// What is wrong with it.
pub fn members(bytes: &[u8]) -> Result<Vec<Member<'_>>, String> {
    directory(bytes).ok_or_else(|| "is no whole zip archive: was it cut off?".to_string())
}

fn directory(bytes: &[u8]) -> Option<Vec<Member<'_>>> {
    let last = bytes.len().checked_sub(END_SIZE)?;
    let earliest = last.saturating_sub(usize::from(u16::MAX));
    let end = (earliest..=last).rev().find(|&at| bytes[at..].starts_with(&END))?;
    let (count, mut at) = (number(bytes, end + 10, 2)?, number(bytes, end + 16, 4)?);
    let mut members = Vec::new();
    for _ in 0..count {
        if !bytes.get(at..)?.starts_with(&ENTRY) {
            return None;
        }
        let field = |place: usize, width: usize| number(bytes, at + place, width);
        let (name_size, extra_size, comment) = (field(28, 2)?, field(30, 2)?, field(32, 2)?);
        let (method, check) = (field(10, 2)?, field(16, 4)? as u32);
        let (mut packed, mut size, mut start) = (field(20, 4)?, field(24, 4)?, field(42, 4)?);
        let name_start = at + ENTRY_SIZE;
        let name = bytes.get(name_start..name_start.checked_add(name_size)?)?;
        let extra = bytes.get(name_start + name_size..name_start + name_size + extra_size)?;
        // Archives of more than 4 GB; numpy writes so for all sizes that it does not know beforehand.
        let mut place = 0;
        while place + 4 <= extra.len() {
            let (tag, width) = (number(extra, place, 2)?, number(extra, place + 2, 2)?);
            let mut within = place + 4;
            if tag == WIDE {
                for value in [&mut size, &mut packed, &mut start] {
                    if *value == ELSEWHERE {
                        *value = number(extra, within, 8)?;
                        within += 8;
                    }
                }
            }
            place += 4 + width;
        }
        if !bytes.get(start..)?.starts_with(&MEMBER) {
            return None;
        }
        let data = start + MEMBER_SIZE + number(bytes, start + 26, 2)? + number(bytes, start + 28, 2)?;
        members.push(Member {
            name: String::from_utf8_lossy(name).into_owned(),
            bytes: bytes.get(data..data.checked_add(packed)?)?,
            method,
            size,
            check,
        });
        at = name_start + name_size + extra_size + comment;
    }
    Some(members)
}

impl Member<'_> {
    /// What is in it.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn unpacked(&self) -> Result<Vec<u8>, String> {
        let bytes = match self.method {
            0 => (self.bytes.len() == self.size).then(|| self.bytes.to_vec()),
            8 => inflate(self.bytes, self.size)
                .ok()
                .filter(|data| data.len() == self.size),
            other => {
                return Err(format!(
                    "is packed by method {other}, and stored and deflated members alone are read"
                ));
            }
        };
        let bytes = bytes.ok_or("is damaged: it does not unpack")?;
        if checksum(&bytes) != self.check {
            return Err("is damaged: its checksum is another one".into());
        }
        Ok(bytes)
    }
}

/// CRC-32 of zip archives.
pub fn checksum(bytes: &[u8]) -> u32 {
    let step = |mut value: u32| {
        for _ in 0..8 {
            value = if value & 1 == 1 {
                0xedb8_8320 ^ (value >> 1)
            } else {
                value >> 1
            };
        }
        value
    };
    let table: Vec<u32> = (0..256).map(step).collect();
    let next = |sum: u32, &byte: &u8| table[((sum ^ u32::from(byte)) & 0xff) as usize] ^ (sum >> 8);
    !bytes.iter().fold(u32::MAX, next)
}
