//! Directions fixed in a party: of a frame a marker, of a section a combination of its axes (its slope
//! shears and has no part in it).

use super::algebra::{Vector, add, both, cross, markers_of, numbers, observed, scale};
use super::kinds::unit;
use crate::model::MarkerId;

/// A direction that is fixed in a party.
#[derive(Clone, Debug)]
pub enum Fixed {
    /// A marker: of a frame, or one of the section's axes.
    Marker(MarkerId),
    /// `k_x n + k_y r_y + k_z r_z` with n = r_y x r_z; in a plane n is r_y turned by -90 degrees.
    Section {
        /// r_y.
        y: MarkerId,
        /// r_z; `None` in a plane.
        z: Option<MarkerId>,
        /// k, constant in time.
        along: Vector,
    },
    /// Cross product of two others.
    Cross(Box<Fixed>, Box<Fixed>),
}

impl Fixed {
    /// Components in inertial axes; in a plane without the one along its normal.
    pub fn value(&self, normal: Option<usize>) -> Vector {
        match self {
            Fixed::Marker(marker) => observed(*marker, 0, normal),
            Fixed::Section { y, z, along } => {
                let ry = observed(*y, 0, normal);
                let [kx, ky, kz] = along;
                let (n, rest) = match z {
                    Some(z) => {
                        let rz = observed(*z, 0, normal);
                        (cross(&ry, &rz), scale(kz, &rz))
                    }
                    None => (clockwise(&ry, normal), numbers([0.0; 3])),
                };
                sum([scale(kx, &n), scale(ky, &ry), rest])
            }
            Fixed::Cross(a, b) => cross(&a.value(normal), &b.value(normal)),
        }
    }

    /// Time derivative of the components.
    pub fn rate(&self, normal: Option<usize>) -> Vector {
        match self {
            Fixed::Marker(marker) => observed(*marker, 1, normal),
            Fixed::Section { y, z, along } => {
                let [kx, ky, kz] = along;
                let rate = observed(*y, 1, normal);
                let (n, rest) = match z {
                    Some(z) => {
                        let axes = [*y, *z].map(Fixed::Marker);
                        (turned(&axes[0], &axes[1], normal), scale(kz, &observed(*z, 1, normal)))
                    }
                    None => (clockwise(&rate, normal), numbers([0.0; 3])),
                };
                sum([scale(kx, &n), scale(ky, &rate), rest])
            }
            Fixed::Cross(a, b) => turned(a, b, normal),
        }
    }

    /// Forces on markers with the virtual work `f . dD`.
    pub fn forces(&self, force: &Vector, normal: Option<usize>) -> Vec<(MarkerId, Vector)> {
        match self {
            Fixed::Marker(marker) => vec![(*marker, force.clone())],
            Fixed::Section { y, z, along } => {
                let [kx, ky, kz] = along;
                let Some(z) = z else {
                    let across = scale(kx, &cross(&unit_along(normal), force));
                    return vec![(*y, both(&across, &scale(ky, force), add))];
                };
                let (ry, rz) = (observed(*y, 0, normal), observed(*z, 0, normal));
                let on_y = both(&scale(kx, &cross(&rz, force)), &scale(ky, force), add);
                let on_z = both(&scale(kx, &cross(force, &ry)), &scale(kz, force), add);
                vec![(*y, on_y), (*z, on_z)]
            }
            Fixed::Cross(a, b) => {
                let on_a = cross(&b.value(normal), force);
                let on_b = cross(force, &a.value(normal));
                let mut forces = a.forces(&on_a, normal);
                forces.extend(b.forces(&on_b, normal));
                forces
            }
        }
    }

    /// The markers that it is a function of.
    pub fn markers(&self, normal: Option<usize>) -> Vec<MarkerId> {
        let mut markers = Vec::new();
        for component in self.value(normal) {
            markers_of(&component, &mut markers);
        }
        markers
    }
}

/// Time derivative of `a x b`.
fn turned(a: &Fixed, b: &Fixed, normal: Option<usize>) -> Vector {
    let first = cross(&a.rate(normal), &b.value(normal));
    both(&first, &cross(&a.value(normal), &b.rate(normal)), add)
}

fn unit_along(normal: Option<usize>) -> Vector {
    numbers(unit(normal.unwrap_or(2)))
}

/// A vector of the plane turned by -90 degrees about its normal.
fn clockwise(vector: &Vector, normal: Option<usize>) -> Vector {
    cross(vector, &unit_along(normal))
}

fn sum(parts: [Vector; 3]) -> Vector {
    let [first, second, third] = parts;
    both(&both(&first, &second, add), &third, add)
}
