//! Where things are at t = 0.

use super::model;
use crate::check::starts::start::{Start, normals};
use crate::check::values::arithmetic::{Vector, cross, dot, norm, subtract};
use crate::model::{BodyId, Expr, Location, Marker, MarkerId, Model};

fn near(found: Vector, want: Vector) {
    assert!(norm(subtract(found, want)) < 1e-14, "{found:?} {want:?}");
}

/// An arc in a frame that is turned by a quarter about z, one metre along x.
fn arc(angle: &str) -> Model {
    model(&format!(
        "model Arc {{
            param r = 2 m;
            material steel {{ density = 7850 kg/m^3; young = 210 GPa; }}
            section thin {{ area = 1 mm^2; second_moment = 1 mm^4; }}
            motion phi(t) = 90 deg + 3 [rad/s] * t;
            frame hub = rotating(axis = z, angle = phi(t), origin = [1, 0, 0] m);
            body ring in hub {{
                planar xy;
                arc from [0, 1, 0] m direction [3, 0, 0] radius r angle {angle};
                mesh 2 * cable(thin, steel);
            }}
            joint foot = clamp(ring.start, hub);
            output x = ring.end.x;
        }}"
    ))
}

#[test]
fn arcs_turn_about_the_normal() {
    for (angle, sign) in [("90 deg", 1.0), ("-90 deg", -1.0)] {
        let mut model = arc(angle);
        let body = BodyId(0);
        let start = Start::new(&model);
        let (place, tangent) = start.place(body, &Location::Start);
        near(place, [0.0, 1.0, 0.0]);
        near(tangent, [1.0, 0.0, 0.0]);
        let (place, tangent) = start.place(body, &Location::End);
        near(place, [2.0, 1.0 + sign * 2.0, 0.0]);
        near(tangent, [0.0, sign, 0.0]);
        let third = Location::At(Box::new(Expr::Number(std::f64::consts::FRAC_PI_3)));
        let (place, _) = start.place(body, &third);
        near(place, [1.0, 1.0 + sign * (2.0 - 3.0_f64.sqrt()), 0.0]);
        // In the inertial frame, and fixed in it.
        let frame = model.bodies[0].frame;
        model.markers.push(Marker::BodyPoint {
            body,
            at: Location::End,
        });
        model.markers.push(Marker::BodySlope {
            body,
            at: Location::End,
        });
        model.markers.push(Marker::Matching {
            frame,
            marker: MarkerId(0),
        });
        let start = Start::new(&model);
        near(start.marker(MarkerId(0)), [1.0 - (1.0 + sign * 2.0), 2.0, 0.0]);
        near(start.marker(MarkerId(1)), [-sign, 0.0, 0.0]);
        near(start.marker(MarkerId(2)), start.marker(MarkerId(0)));
        assert!(start.model.is_point(MarkerId(2)) && !start.model.is_point(MarkerId(1)));
    }
}

#[test]
fn normals_are_a_right_handed_triad() {
    for along in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.6, 0.0, -0.8], [0.48, 0.6, 0.64]] {
        let [first, second] = normals(along);
        assert!((dot(cross(along, first), second) - 1.0).abs() < 1e-14);
        assert!(dot(along, first).abs() < 1e-15 && (norm(first) - 1.0).abs() < 1e-15);
    }
}
