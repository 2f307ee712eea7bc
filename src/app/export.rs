//! Bodies in modes as archives of arrays, as `numpy.savez` writes them, which `import` reads.

use super::arguments::Arguments;
use super::execute::{FAILURE, Failure, MISTAKE};
use super::files;
use crate::model::ExportedBody;
use crate::{Formulation, Joints};

/// Bytes that begin an array, and the boundary at which its numbers begin.
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
const BOUNDARY: usize = 64;
/// Version of zip that is needed, and the first day that its dates know.
const VERSION: u16 = 20;
const FIRST_DAY: u32 = 0x0021_0000;

/// Writes one archive for each body in modes; the lines that name the files.
pub(super) fn execute(arguments: &Arguments) -> Result<String, Failure> {
    let scene = arguments
        .model()
        .build(Formulation::Rncf, Joints::Eliminated)
        .map_err(|error| Failure::new(MISTAKE, error))?;
    let bodies = scene.exported();
    if bodies.is_empty() {
        let message = "no body is described by modes, `modal(n);` or `small(n);`, so that there are none to export";
        return Err(Failure::new(MISTAKE, message));
    }
    let mut lines = String::new();
    for body in &bodies {
        let name = format!("{}.npz", body.name);
        files::write_bytes(&arguments.out, &name, &archive(body)).map_err(|text| Failure::new(FAILURE, text))?;
        lines += &format!("\n  {}", arguments.out.join(name).display());
    }
    Ok(lines)
}

/// The arrays in an archive without compression.
fn archive(body: &ExportedBody) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, shape, values) in &body.arrays {
        let name = format!("{name}.npy");
        let data = array(shape, values);
        // What the member and the entry of the directory have in common.
        let mut head: Vec<u8> = Vec::new();
        for short in [VERSION, 0, 0] {
            head.extend(short.to_le_bytes());
        }
        for long in [FIRST_DAY, checksum(&data), data.len() as u32, data.len() as u32] {
            head.extend(long.to_le_bytes());
        }
        head.extend((name.len() as u16).to_le_bytes());
        head.extend(0_u16.to_le_bytes());
        directory.extend(b"PK\x01\x02");
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&head);
        directory.extend([0; 10]);
        directory.extend((bytes.len() as u32).to_le_bytes());
        directory.extend(name.as_bytes());
        bytes.extend(b"PK\x03\x04");
        bytes.extend(head);
        bytes.extend(name.as_bytes());
        bytes.extend(data);
    }
    let (start, count) = (bytes.len() as u32, body.arrays.len() as u16);
    bytes.extend(&directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend(count.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend((directory.len() as u32).to_le_bytes());
    bytes.extend(start.to_le_bytes());
    bytes.extend(0_u16.to_le_bytes());
    bytes
}

/// One array of f64.
fn array(shape: &[usize], values: &[f64]) -> Vec<u8> {
    let sizes: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({sizes}), }}");
    let before = MAGIC.len() + 2;
    while !(before + header.len() + 1).is_multiple_of(BOUNDARY) {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = MAGIC.to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

/// CRC-32 of zip archives.
fn checksum(bytes: &[u8]) -> u32 {
    let mut sum = u32::MAX;
    for byte in bytes {
        sum ^= u32::from(*byte);
        for _ in 0..8 {
            sum = if sum & 1 == 1 {
                0xedb8_8320 ^ (sum >> 1)
            } else {
                sum >> 1
            };
        }
    }
    !sum
}
