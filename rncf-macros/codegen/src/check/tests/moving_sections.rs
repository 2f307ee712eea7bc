//! Scenes with bodies that have cross-sections, and their motions.

use super::world::{Mat3, POINT, Pose, Sections, Vec3, World, add, first_body, product, rotation, still, times};
use crate::model::{Expr, Location, Model};

/// Two bodies with sections, one of them in a moving frame, and two rigid ones.
pub const SCENE: &str = "
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section thin = circle(radius = 1 mm);
    motion phi(t) = 2 [rad/s] * t;
    frame hub = rotating(axis = z, angle = phi(t));
    rigid a { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    rigid b { mass = 1 kg; inertia = [1, 1, 1] kg*m^2; }
    body shaft in hub { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(thin, steel); }
    body rod { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(thin, steel); }
    body wire { spatial; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * cable(thin, steel); }
    joint root = clamp(shaft.start, hub);
    joint foot = clamp(rod.start, inertial);
    joint far = clamp(wire.start, inertial);
    output first = a.x;
";

pub const PLANAR: &str = "
    material steel { density = 7850 kg/m^3; young = 210 GPa; poisson = 0.3; }
    section thin = circle(radius = 1 mm);
    frame hub = rotating(axis = z, angle = 3 [rad/s] * t);
    rigid a { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    rigid b { plane xy; mass = 1 kg; inertia = 1 kg*m^2; }
    body shaft in hub { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(thin, steel); }
    body rod { planar xy; line from [0, 0, 0] m to [2, 0, 0] m; mesh 2 * beam(thin, steel); }
    joint root = clamp(shaft.start, hub);
    joint foot = clamp(rod.start, inertial);
    output first = a.x;
";

/// First parties at the point of the joint in `a`, or in a section that moves like it; second ones.
pub const FIRST: [&str; 3] = ["a.at([0.5, 0.25, -0.125] m)", "shaft.end", "shaft.at(0.7 m)"];
pub const SECOND: [&str; 3] = ["b", "rod.start", "rod.at(1 m)"];
pub const IN_PLANE: [&str; 3] = ["a.at([0.5, 0.25, 0] m)", "shaft.end", "shaft.at(0.7 m)"];

/// How a section stands in what moves like it.
pub const OWN: Vec3 = [0.4, -0.3, 0.2];
pub const OTHER: Vec3 = [-0.2, 0.6, 0.3];

/// A small deviation of the second party from its motion, in the axes of the first one.
pub type Small = (Vec3, Vec3);

/// Moving parties: the second one by `shift` and `turn` about the joint's point of the first one, and
/// both in space, or turning about z in the plane.
#[derive(Clone, Copy)]
pub struct Motion<'m> {
    pub shift: &'m dyn Fn(f64) -> Vec3,
    pub turn: &'m dyn Fn(f64) -> Vec3,
    pub small: Small,
    pub is_planar: bool,
    /// How much r_y stretches in a second; r_z and their angle follow.
    pub strain: f64,
}

pub const NONE: Small = ([0.0; 3], [0.0; 3]);

impl Motion<'_> {
    pub fn first(&self, t: f64) -> Pose {
        let pose = first_body(t);
        if !self.is_planar {
            return pose;
        }
        Pose {
            r: [pose.r[0], pose.r[1], 0.0],
            a: rotation([0.0, 0.0, 0.3 + 0.8 * t]),
        }
    }

    pub fn point(&self) -> Vec3 {
        [POINT[0], POINT[1], if self.is_planar { 0.0 } else { POINT[2] }]
    }

    /// The second party's point, and how it has turned out of the first one's axes.
    pub fn second(&self, t: f64) -> (Vec3, Mat3) {
        let first = self.first(t);
        let shift = add((self.shift)(t), if t > 0.0 { self.small.0 } else { [0.0; 3] });
        let turned = rotation((self.turn)(t));
        let turned = if t > 0.0 {
            product(rotation(self.small.1), turned)
        } else {
            turned
        };
        let at = add(first.r, times(first.a, add(self.point(), shift)));
        (at, product(first.a, turned))
    }

    pub fn pose(&self, name: &str, t: f64) -> Pose {
        match name {
            "a" => self.first(t),
            // Its axes are those of `a` when the joint is made.
            "hub" => self.first(0.0),
            _ if self.is_planar => {
                let (r, a) = self.second(t);
                Pose {
                    r,
                    a: product(a, rotation([0.0, 0.0, 0.7])),
                }
            }
            _ => {
                let (at, a) = self.second(t);
                let a = product(a, rotation([0.7, 0.1, -0.4]));
                Pose {
                    r: add(at, times(a, [-0.2, 0.3, -0.1])),
                    a,
                }
            }
        }
    }

    /// Position, slope and axes: the slope has sheared.
    pub fn section(&self, name: &str, t: f64) -> [Vec3; 4] {
        let flat = |w: Vec3| if self.is_planar { [0.0, 0.0, w[2]] } else { w };
        let (r, a) = match name {
            "shaft" => {
                let first = self.first(t);
                (
                    add(first.r, times(first.a, self.point())),
                    product(first.a, rotation(flat(OWN))),
                )
            }
            _ => {
                let (r, a) = self.second(t);
                (r, product(a, rotation(flat(OTHER))))
            }
        };
        // A symmetric stretch in the section: none of it is rotation.
        let stretch = 1.0 + self.strain * t;
        let shear = if self.is_planar { 0.0 } else { 0.5 * self.strain * t };
        let axis = |v: Vec3| times(a, v);
        let slope = axis([1.1, 0.1, if self.is_planar { 0.0 } else { -0.05 }]);
        [
            r,
            slope,
            axis([0.0, stretch, shear]),
            axis([0.0, shear, 1.0 + 0.3 * self.strain * t]),
        ]
    }

    pub fn world<T>(&self, model: &Model, t: f64, of: impl FnOnce(&World) -> T) -> T {
        let pose = |name: &str, t: f64| self.pose(name, t);
        let sections = |name: &str, _: &Location, t: f64| self.section(name, t);
        of(&World {
            model,
            pose: &pose,
            sections: Some(&sections as Sections),
            end: &still,
            t,
        })
    }
}

pub fn near(found: &[f64], want: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), want.len(), "{what}");
    for (found, want) in found.iter().zip(want) {
        assert!((found - want).abs() < tolerance, "{what}: {found} {want}");
    }
}

pub fn output(model: &Model, name: &str) -> Expr {
    let output = model.outputs.iter().find(|output| output.name == name).unwrap();
    output.components[0].1.clone()
}
