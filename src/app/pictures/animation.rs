//! The animation: one page that needs nothing but itself.

use serde_json::json;

use super::Pictures;
use super::base64::encode;
use crate::app::report::escape;

/// Name of the file.
pub const NAME: &str = "animation.html";

const PAGE: &str = include_str!("animation.html");

/// The page. Points are told in their frames, so that 16 bits over the range of each component suffice.
pub fn page(title: &str, pictures: &Pictures) -> String {
    let frames = pictures.frames.len();
    let mut low = vec![[f64::INFINITY; 3]; frames];
    let mut high = vec![[f64::NEG_INFINITY; 3]; frames];
    for shot in &pictures.shots {
        for (frame, point) in of_frames(pictures).zip(&shot.points) {
            for axis in 0..3 {
                low[frame][axis] = low[frame][axis].min(point[axis]);
                high[frame][axis] = high[frame][axis].max(point[axis]);
            }
        }
    }
    let mut bytes = Vec::new();
    for shot in &pictures.shots {
        for (frame, point) in of_frames(pictures).zip(&shot.points) {
            for axis in 0..3 {
                let range = high[frame][axis] - low[frame][axis];
                let part = if range > 0.0 {
                    (point[axis] - low[frame][axis]) / range
                } else {
                    0.0
                };
                bytes.extend(((part * 65535.0).round() as u16).to_le_bytes());
            }
        }
    }
    let finite = |bounds: &[[f64; 3]]| -> Vec<[f64; 3]> {
        bounds
            .iter()
            .map(|all| all.map(|x| if x.is_finite() { x } else { 0.0 }))
            .collect()
    };
    let curves: Vec<_> = pictures
        .curves
        .iter()
        .map(|curve| json!({"name": curve.name, "frame": curve.frame, "points": curve.points, "flexible": curve.is_flexible}))
        .collect();
    let poses: Vec<_> = pictures
        .shots
        .iter()
        .map(|shot| -> Vec<_> {
            let pose = shot.poses.iter();
            pose.map(|(place, rotation)| json!([place, rotation.matrix()]))
                .collect()
        })
        .collect();
    let data = json!({
        "curves": curves, "frames": pictures.frames, "times": pictures.times, "low": finite(&low), "high": finite(&high),
        "poses": poses, "followed": pictures.followed(), "points": encode(&bytes),
    });
    // Names are identifiers: no text in the data ends the script.
    PAGE.replace("{title}", &escape(title))
        .replace("{data}", &data.to_string())
}

/// The frame of each point.
fn of_frames(pictures: &Pictures) -> impl Iterator<Item = usize> {
    let curves = pictures.curves.iter();
    curves.flat_map(|curve| std::iter::repeat_n(curve.frame, curve.points))
}
