//! Arrays as an archive, as `numpy.savez` writes them, which `import` reads.

use super::files::checksum;

/// Bytes that begin an array, and the boundary at which its numbers begin.
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
const BOUNDARY: usize = 64;
/// Version of zip that is needed, and the first day that its dates know.
const VERSION: u16 = 20;
const FIRST_DAY: u32 = 0x0021_0000;

/// Name, sizes and values of an array, the last index fastest.
pub type Named = (&'static str, Vec<usize>, Vec<f64>);

/// The arrays in an archive without compression.
pub fn archive(arrays: &[Named]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, shape, values) in arrays {
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
    let (start, count) = (bytes.len() as u32, arrays.len() as u16);
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
