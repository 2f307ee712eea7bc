//! Files that ParaView opens: one .vtu for each picture, and a .pvd that lists them over time.

use std::fmt::Write;

use super::Pictures;
use super::base64::encode;

/// Name of the list of all pictures.
pub const LIST: &str = "paraview.pvd";
/// Folder of the single pictures.
pub const FOLDER: &str = "paraview";

/// Name of a picture in [`FOLDER`].
pub fn name(picture: usize) -> String {
    format!("{picture:04}.vtu")
}

/// The list.
pub fn list(pictures: &Pictures) -> String {
    let mut text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n".to_string();
    for (picture, t) in pictures.times.iter().enumerate() {
        let file = name(picture);
        let _ = writeln!(
            text,
            "<DataSet timestep=\"{t:?}\" part=\"0\" file=\"{FOLDER}/{file}\"/>"
        );
    }
    text + "</Collection>\n</VTKFile>\n"
}

/// One picture: lines in inertial axes, relative to the origin of the followed frame, m; the number of the
/// curve and whether it is a flexible body for each line.
pub fn picture(pictures: &Pictures, picture: usize) -> String {
    let shot = &pictures.shots[picture];
    let mut points = Vec::with_capacity(24 * shot.points.len());
    for place in pictures.places(shot, pictures.followed()) {
        place.iter().for_each(|x| points.extend(x.to_le_bytes()));
    }
    let (mut connectivity, mut offsets, mut types) = (Vec::new(), Vec::new(), Vec::new());
    let (mut numbers, mut flexible) = (Vec::new(), Vec::new());
    let mut next = 0i64;
    for (number, curve) in pictures.curves.iter().enumerate() {
        for point in next..next + curve.points as i64 {
            connectivity.extend(point.to_le_bytes());
        }
        next += curve.points as i64;
        offsets.extend(next.to_le_bytes());
        types.push(POLY_LINE);
        numbers.extend((number as i64).to_le_bytes());
        flexible.push(u8::from(curve.is_flexible));
    }
    let mut text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n".to_string();
    let _ = writeln!(
        text,
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>",
        shot.points.len(),
        pictures.curves.len()
    );
    array(&mut text, "Float64\" NumberOfComponents=\"3", "Points", &points);
    text += "</Points>\n<Cells>\n";
    array(&mut text, "Int64", "connectivity", &connectivity);
    array(&mut text, "Int64", "offsets", &offsets);
    array(&mut text, "UInt8", "types", &types);
    text += "</Cells>\n<CellData>\n";
    array(&mut text, "Int64", "curve", &numbers);
    array(&mut text, "UInt8", "flexible", &flexible);
    text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
}

/// VTK's number of a line of many points.
const POLY_LINE: u8 = 4;

fn array(text: &mut String, kind: &str, name: &str, bytes: &[u8]) {
    // The header, the number of bytes, is encoded with the data.
    let with_header = [&(bytes.len() as u64).to_le_bytes()[..], bytes].concat();
    let _ = writeln!(
        text,
        "<DataArray type=\"{kind}\" Name=\"{name}\" format=\"binary\">{}</DataArray>",
        encode(&with_header)
    );
}
