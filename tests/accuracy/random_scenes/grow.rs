//! Random scenes. What a scene consists of follows from the seed alone, its numbers from seed and draw.

use super::random::Random;
use super::tree::*;

/// Something that others can be attached to.
#[derive(Clone, Copy)]
enum Part {
    Ground(Option<usize>),
    Rigid(usize),
    Body(usize),
}

struct Grower {
    kinds: Random,
    numbers: Random,
    tree: Tree,
    parts: Vec<Part>,
    /// Rigid motion at t = 0 of what nothing holds.
    motion: Option<(Vector, Vector)>,
    /// Directions along the axes of coordinates.
    aligned: bool,
}

/// The scene of a seed with the numbers of a draw.
pub fn grow(seed: u64, draw: u64) -> Tree {
    let mut kinds = Random::new(seed, 1);
    let numbers = Random::new(seed, 1000 + draw);
    let plane = kinds.chance(0.4);
    let aligned = kinds.chance(0.3);
    let tree = Tree {
        seed,
        draw,
        plane,
        frames: Vec::new(),
        bodies: Vec::new(),
        joints: Vec::new(),
        springs: Vec::new(),
        loads: Vec::new(),
        gravity: None,
        t_end: 0.25,
    };
    let mut grower = Grower {
        kinds,
        numbers,
        tree,
        parts: Vec::new(),
        motion: None,
        aligned,
    };
    grower.all();
    grower.tree
}

impl Grower {
    fn all(&mut self) {
        let grounded = self.kinds.chance(0.75);
        if grounded {
            self.parts.push(Part::Ground(None));
            for _ in 0..self.kinds.one(&[0, 0, 0, 1, 1, 2]) {
                self.prescribed();
            }
        } else {
            let plane = self.tree.plane;
            let spin = if plane {
                [0.0, 0.0, 1.0]
            } else {
                self.numbers.direction(false)
            };
            let speed = self.numbers.scale(0.3, 8.0);
            self.motion = Some((self.numbers.direction(plane), scaled(spin, speed)));
            // Springs to the ground may hold it.
        }
        for _ in 0..self.kinds.one(&[1, 1, 2, 2, 3, 4]) {
            self.part();
        }
        if self.kinds.chance(0.35) {
            self.spring();
        }
        if self.kinds.chance(0.8) {
            let plane = self.tree.plane;
            let down = if self.aligned {
                [0.0, -1.0, 0.0]
            } else {
                self.numbers.direction(plane)
            };
            self.tree.gravity = Some(scaled(down, 9.81));
        }
        let loads = self.kinds.one(&[0, 1, 1, 2]);
        let least = usize::from(self.tree.gravity.is_none());
        for _ in 0..loads.max(least) {
            self.load();
        }
    }

    fn direction(&mut self) -> Vector {
        let plane = self.tree.plane;
        if self.aligned {
            let axis = self.kinds.below(if plane { 2 } else { 3 });
            let sign = self.kinds.one(&[-1.0, 1.0]);
            std::array::from_fn(|k| if k == axis { sign } else { 0.0 })
        } else {
            self.numbers.direction(plane)
        }
    }

    /// A direction that is the same in all draws.
    fn axis(&mut self) -> Vector {
        if self.tree.plane {
            return [0.0, 0.0, 1.0];
        }
        if self.aligned {
            let axis = self.kinds.below(3);
            return std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
        }
        self.kinds.direction(false)
    }

    fn point(&mut self, size: f64) -> Vector {
        let plane = self.tree.plane;
        let mut point: Vector = std::array::from_fn(|_| self.numbers.between(-size, size));
        if plane {
            point[2] = 0.0;
        }
        point
    }

    /// A frame whose motion is prescribed; its ground can be attached to.
    fn prescribed(&mut self) {
        let parent = if self.tree.frames.is_empty() || self.kinds.chance(0.4) {
            None
        } else {
            Some(self.tree.frames.len() - 1)
        };
        let rate = self.numbers.between(1.0, 4.0);
        let (kind, axis, angle) = if self.kinds.chance(0.75) {
            let amplitude = self.numbers.between(-0.6, 0.6);
            let axis = self.axis();
            let angle = if self.aligned {
                0.0
            } else {
                self.numbers.between(-2.0, 2.0)
            };
            (
                Kind::Rotating {
                    amplitude,
                    rate,
                    spinning: false,
                },
                axis,
                angle,
            )
        } else {
            let way = self.direction();
            let way = scaled(way, self.numbers.between(0.02, 0.3));
            (Kind::Moving { way, rate }, [0.0, 0.0, 1.0], 0.0)
        };
        let origin = self.point(0.6);
        self.push_frame(kind, parent, axis, angle, origin);
        self.parts.push(Part::Ground(Some(self.tree.frames.len() - 1)));
    }

    fn push_frame(&mut self, kind: Kind, parent: Option<usize>, axis: Vector, angle: f64, origin: Vector) -> usize {
        let axes = product(&self.tree.pose(parent).axes, &rotation(axis, angle));
        let (velocity, spin) = match self.motion {
            Some((v, w)) => (add(v, cross(w, origin)), w),
            None => ([0.0; 3], [0.0; 3]),
        };
        self.tree.frames.push(Frame {
            kind,
            parent,
            axis,
            angle,
            pose: Pose { axes, origin },
            velocity,
            spin,
        });
        self.tree.frames.len() - 1
    }

    /// A place on a part, m. The fraction of a body's length is structure: ends or in between.
    fn on(&mut self, part: Part) -> Place {
        match part {
            Part::Ground(frame) => {
                let point = self.point(1.0);
                frame.map_or(Place::Ground(point), |frame| Place::Frame(frame, point))
            }
            Part::Rigid(frame) => {
                let offset = self.point(0.25);
                Place::Frame(frame, add(self.tree.frames[frame].pose.origin, offset))
            }
            Part::Body(body) => {
                // Before the cut of a copy.
                let inner = self.numbers.between(0.1, 0.3);
                let at = [0.0, 1.0, 1.0, 1.0, 2.0][self.kinds.below(5)];
                Place::Body(body, if at == 2.0 { inner } else { at })
            }
        }
    }

    /// The same point as a place of another frame or the ground.
    fn part(&mut self) {
        let first = self.parts.iter().all(|part| matches!(part, Part::Ground(_)));
        let parent = if self.parts.is_empty() {
            None
        } else if first {
            Some(self.parts[self.kinds.below(self.parts.len())])
        } else {
            // Rather what was there last.
            let k = self
                .kinds
                .below(self.parts.len())
                .max(self.kinds.below(self.parts.len()));
            Some(self.parts[k])
        };
        let at = parent.map(|parent| self.on(parent));
        let point = at.map_or([0.0; 3], |at| self.tree.point(at));
        match self.kinds.below(if self.tree.plane { 3 } else { 4 }) {
            0 => self.rigid(parent, at, point),
            // In space nothing but a frame holds a straight line that floats.
            1 => self.flexible(parent, at, point, self.tree.plane || parent.is_some()),
            _ => self.flexible(parent, at, point, false),
        }
    }

    fn parent_frame(&mut self) -> Option<usize> {
        let prescribed: Vec<usize> = (0..self.tree.frames.len())
            .filter(|f| matches!(self.tree.frames[*f].kind, Kind::Rotating { .. } | Kind::Moving { .. }))
            .collect();
        (!prescribed.is_empty() && self.kinds.chance(0.3)).then(|| prescribed[self.kinds.below(prescribed.len())])
    }

    fn rigid(&mut self, parent: Option<Part>, at: Option<Place>, point: Vector) {
        let offset = self.point(0.3);
        let mass = self.numbers.scale(0.2, 3.0);
        let size = self.numbers.between(0.05, 0.2);
        let inertia = self.inertia(mass * size * size);
        let center = if self.kinds.chance(0.3) {
            self.point(0.05)
        } else {
            [0.0; 3]
        };
        let axis = self.axis();
        let angle = if self.aligned {
            0.0
        } else {
            self.numbers.between(-2.5, 2.5)
        };
        let inside = self.parent_frame();
        let kind = Kind::Rigid { mass, center, inertia };
        let frame = self.push_frame(kind, inside, axis, angle, add(point, offset));
        self.parts.push(Part::Rigid(frame));
        let (Some(parent), Some(at)) = (parent, at) else { return };
        let on_line = matches!(parent, Part::Body(body) if self.tree.bodies[body].is_cable);
        let words: &[&str] = match (on_line, self.tree.plane) {
            (true, _) => &["spherical"],
            (false, true) => &["revolute", "revolute", "weld", "prismatic"],
            (false, false) => &[
                "spherical",
                "revolute",
                "revolute",
                "universal",
                "cylindrical",
                "prismatic",
                "planar",
                "weld",
            ],
        };
        let word = self.kinds.one(words);
        self.joint(word, at, Place::Frame(frame, point));
    }

    fn inertia(&mut self, size: f64) -> Matrix {
        let parts: Vector = std::array::from_fn(|_| size * self.numbers.between(0.3, 1.0));
        let own = [
            [parts[1] + parts[2], 0.0, 0.0],
            [0.0, parts[0] + parts[2], 0.0],
            [0.0, 0.0, parts[0] + parts[1]],
        ];
        if self.tree.plane || self.aligned {
            return own;
        }
        let turn = rotation(self.numbers.direction(false), self.numbers.between(0.0, 3.0));
        product(&product(&turn, &own), &transposed(&turn))
    }

    fn joint(&mut self, word: &'static str, a: Place, b: Place) {
        let plane = self.tree.plane;
        let has_axis = matches!(word, "revolute" | "universal" | "cylindrical" | "prismatic" | "planar");
        let axis = match (has_axis, plane, word) {
            (true, true, "prismatic") => Some(if self.aligned {
                let k = self.kinds.below(2);
                std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })
            } else {
                self.kinds.direction(true)
            }),
            (true, ..) => Some(self.axis()),
            _ => None,
        };
        let other = match (word, axis) {
            ("universal", Some(axis)) => {
                let helper = if axis[0].abs() < 0.7 {
                    [1.0, 0.0, 0.0]
                } else {
                    [0.0, 1.0, 0.0]
                };
                let across = cross(axis, helper);
                Some(scaled(across, 1.0 / norm(across)))
            }
            _ => None,
        };
        let turns = word == "revolute";
        let drive = (turns && self.kinds.chance(0.15))
            .then(|| [self.numbers.between(-0.7, 0.7), self.numbers.between(2.0, 7.0)]);
        let coil = (turns && drive.is_none() && self.kinds.chance(0.3))
            .then(|| [self.numbers.scale(0.1, 10.0), self.numbers.one(&[0.0, 0.02])]);
        self.tree.joints.push(Joint {
            word,
            a,
            b,
            axis,
            cross: other,
            drive,
            coil,
        });
    }

    fn flexible(&mut self, parent: Option<Part>, at: Option<Place>, point: Vector, is_cable: bool) {
        let plane = self.tree.plane;
        let length = self.numbers.between(0.5, 1.2);
        let direction = self.direction();
        let radius = length * self.numbers.between(0.012, 0.03);
        let density = self.numbers.between(900.0, 3000.0);
        // First frequency of the clamped beam, rad/s.
        let first = self.numbers.scale(12.0, 60.0);
        let young = density * (first * length * length / (3.516 * radius / 2.0)).powi(2);
        let side = (!is_cable && self.kinds.chance(0.3)).then(|| radius * self.numbers.between(1.0, 3.0));
        let section_y = (!plane && !is_cable).then(|| {
            let helper = if self.aligned {
                let k = (0..3).find(|k| direction[*k] == 0.0).unwrap_or(0);
                std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 })
            } else {
                self.numbers.direction(false)
            };
            let across = subtract(helper, scaled(direction, dot(helper, direction)));
            scaled(across, 1.0 / norm(across))
        });
        let damped = self.kinds.chance(0.8);
        let damping = if damped { self.numbers.scale(1e-4, 2e-3) } else { 0.0 };
        let mut body = Body {
            frame: None,
            is_cable,
            from: point,
            direction,
            length,
            elements: 2 + self.kinds.below(3),
            radius,
            side,
            section_y,
            density,
            young,
            poisson: self.numbers.between(0.1, 0.4),
            damping,
            exact_bending: is_cable && self.kinds.chance(0.3),
            tie: Tie::None,
            moving: None,
        };
        if !is_cable {
            body.elements = 1 + self.kinds.below(3);
        }
        let index = self.tree.bodies.len();
        let start = Place::Body(index, 0.0);
        // A straight centre line does not hold a frame against turning about it.
        let may_tie = plane || !is_cable;
        let choice = self.kinds.below(4);
        let mut joined = false;
        match (parent, choice) {
            (Some(Part::Rigid(frame)), 0 | 1) => {
                body.frame = Some(frame);
                let word = if is_cable || self.kinds.chance(0.8) {
                    "clamp"
                } else {
                    "weld"
                };
                self.tree.bodies.push(body);
                self.joint(word, start, Place::Frame(frame, point));
                joined = true;
            }
            (Some(Part::Ground(Some(frame))), 0..=2) => {
                body.frame = Some(frame);
                let word = self.kinds.one(&["clamp", "clamp", "pin"]);
                self.tree.bodies.push(body);
                self.joint(word, start, Place::Frame(frame, point));
                joined = true;
            }
            (None, _) | (_, 1 | 2) if may_tie => {
                body.tie = if self.kinds.chance(0.5) {
                    Tie::Clamp
                } else {
                    Tie::MeanAxes
                };
                let axis = self.axis();
                let angle = if self.aligned {
                    0.0
                } else {
                    self.numbers.between(-2.5, 2.5)
                };
                let origin = if body.tie == Tie::Clamp {
                    point
                } else {
                    add(point, self.point(0.2))
                };
                body.frame = Some(self.push_frame(Kind::Free, None, axis, angle, origin));
                self.tree.bodies.push(body);
            }
            _ => {
                body.moving = self.motion;
                self.tree.bodies.push(body);
            }
        }
        self.parts.push(Part::Body(index));
        let (Some(parent), Some(at)) = (parent, at) else { return };
        if joined {
            return;
        }
        let lines = (
            is_cable,
            matches!(parent, Part::Body(body) if self.tree.bodies[body].is_cable),
        );
        let to_ground = matches!(parent, Part::Ground(_));
        let words: &[&str] = match (lines, plane) {
            ((true, true) | (false, true), _) => &["spherical"],
            ((true, false), _) if to_ground || matches!(parent, Part::Rigid(_)) => &["clamp", "spherical"],
            ((true, false), _) => &["spherical"],
            ((false, false), true) => &["weld", "revolute", "revolute", "prismatic"],
            ((false, false), false) => &[
                "weld",
                "weld",
                "spherical",
                "revolute",
                "revolute",
                "universal",
                "cylindrical",
                "prismatic",
                "planar",
            ],
        };
        let word = self.kinds.one(words);
        if word == "clamp" {
            self.joint(word, start, at);
        } else {
            self.joint(word, at, start);
        }
    }

    /// A spring or a distance between two of the parts, closing a loop where they hang together.
    fn spring(&mut self) {
        let count = self.parts.len();
        if count < 2 {
            return;
        }
        let first = self.kinds.below(count);
        let second = (first + 1 + self.kinds.below(count - 1)) % count;
        let (mut first, mut second) = (self.parts[first], self.parts[second]);
        if matches!(first, Part::Ground(_)) {
            std::mem::swap(&mut first, &mut second);
        }
        if matches!((first, second), (Part::Ground(_), Part::Ground(_))) {
            return;
        }
        let (a, b) = (self.on(first), self.on(second));
        let apart = norm(subtract(self.tree.point(a), self.tree.point(b)));
        let stiffness = self.numbers.scale(3.0, 300.0);
        let damping = if self.kinds.chance(0.3) { 0.2 } else { 0.0 };
        let factor = self.numbers.between(0.6, 1.1);
        let bushing = !matches!(second, Part::Body(_)) && self.kinds.chance(0.3);
        // Force at 0.3 m like that of the linear spring.
        let cubic = stiffness / 0.09;
        let law = self.kinds.chance(0.25);
        let rigidly = self.kinds.chance(0.25);
        if rigidly {
            self.joint("distance", a, b);
        } else if bushing {
            self.tree.springs.push(Spring::Bushing {
                a,
                b,
                stiffness,
                damping,
            });
        } else if law {
            self.tree.springs.push(Spring::Law {
                a,
                b,
                cubic,
                length: factor * apart,
            });
        } else {
            self.tree.springs.push(Spring::Linear {
                a,
                b,
                stiffness,
                damping,
                length: factor * apart,
            });
        }
    }

    fn load(&mut self) {
        let moving: Vec<Part> = self
            .parts
            .iter()
            .copied()
            .filter(|part| !matches!(part, Part::Ground(_)))
            .collect();
        let part = moving[self.kinds.below(moving.len())];
        let at = self.on(part);
        let plane = self.tree.plane;
        let varies = self.kinds.chance(0.5);
        let rate = if varies { self.numbers.between(3.0, 20.0) } else { 0.0 };
        let weight = match part {
            Part::Body(body) => {
                let body = &self.tree.bodies[body];
                10.0 * body.density * std::f64::consts::PI * body.radius * body.radius * body.length
            }
            _ => 10.0,
        };
        let size = weight * self.numbers.between(0.2, 1.0);
        let along = self.direction();
        let axes = if self.tree.frames.is_empty() || self.kinds.chance(0.6) {
            None
        } else {
            let frame = self.kinds.below(self.tree.frames.len());
            // Mean axes are those of the referenced formulation alone.
            (!self.tree.follows_mean(frame)).then_some(frame)
        };
        let is_line = matches!(part, Part::Body(body) if self.tree.bodies[body].is_cable);
        let load = match (self.kinds.below(5), part) {
            (0, Part::Body(_)) => Load::Follower { at, force: size },
            (1, _) if !is_line => {
                let about = if plane { [0.0, 0.0, 1.0] } else { along };
                Load::Moment {
                    at,
                    moment: scaled(about, 0.1 * size),
                    rate,
                }
            }
            (2, Part::Body(body))
                if self.tree.bodies[body].frame.is_none_or(|f| {
                    matches!(self.tree.frames[f].kind, Kind::Rotating { .. } | Kind::Moving { .. })
                }) =>
            {
                Load::Density {
                    body,
                    force: scaled(along, size / self.tree.bodies[body].length),
                }
            }
            _ => Load::Force {
                at,
                force: scaled(along, size),
                rate,
                axes,
            },
        };
        self.tree.loads.push(load);
    }
}
