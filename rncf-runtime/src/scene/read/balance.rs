//! Mass, momentum, angular momentum, centre of mass and energies of bodies, of rigid bodies and of all. They are sums over
//! nodal vectors with the constants M^ab, relative to the origin of each body's frame, so that far away nothing cancels.

use crate::emitted::{About, BalanceQuantity, Fidelity, MAX_SIZE, Owner};
use crate::error::ModelError;
use crate::scene::MeshScene;
use crate::scene::bodies::nodal_mass::{Padded, padded, spread};
use crate::scene::pieces::marker::Marker;
use crate::space::Vector;

/// A point from which places and velocities are seen, inertial axes.
#[derive(Clone, Copy, Default)]
struct Seen {
    /// m.
    from: Vector,
    /// m/s.
    moving: Vector,
    /// The frame in which it rests, and where, frame axes: beside what is far away the way from its origin is known by this alone.
    fixed: Option<(usize, Vector)>,
}

/// Sums over what moves, in inertial axes; places, velocities and the angular momentum as they are seen from a point.
#[derive(Clone, Copy, Default)]
struct Balance {
    /// kg.
    mass: f64,
    /// First moment, kg m.
    moment: Vector,
    /// kg m/s.
    momentum: Vector,
    /// kg m^2/s.
    spin: Vector,
    /// J.
    kinetic: f64,
}

impl Balance {
    fn plus(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            moment: self.moment + other.moment,
            momentum: self.momentum + other.momentum,
            spin: self.spin + other.spin,
            kinetic: self.kinetic + other.kinetic,
        }
    }

    /// The same of what is seen from a point that is `arm` from the reference and moves with `velocity`, here given with
    /// places and velocities relative to that point.
    fn carried(self, arm: Vector, velocity: Vector) -> Self {
        let momentum = self.momentum + self.mass * velocity;
        Self {
            mass: self.mass,
            moment: self.moment + self.mass * arm,
            momentum,
            spin: self.spin + (arm.cross(&momentum) + self.moment.cross(&velocity)),
            kinetic: self.kinetic + velocity.dot(&self.momentum) + 0.5 * self.mass * velocity.dot(&velocity),
        }
    }
}

impl MeshScene {
    /// Refuses balances of what has none.
    ///
    /// # Errors
    /// A body whose momentum is not that of its motion, by name.
    pub(crate) fn check_balance(&self, of: Owner, what: BalanceQuantity) -> Result<(), ModelError> {
        let Some(body) = self
            .bodies_of(of)
            .find(|&body| matches!(self.bodies[body].spec.fidelity, Fidelity::Small(_)))
        else {
            return Ok(());
        };
        if what == BalanceQuantity::Mass {
            return Ok(());
        }
        Err(ModelError::new(format!(
            "an output asks for the {} of body `{}`, which `small` describes: its inertia is that of the undeformed shape, and what it keeps is not that of its motion; describe it by `modal` or by all its nodal vectors",
            what.describe(),
            self.bodies[body].spec.label()
        )))
    }

    fn bodies_of(&self, of: Owner) -> std::ops::Range<usize> {
        match of {
            Owner::All => 0..self.bodies.len(),
            Owner::Body(body) => body..body + 1,
            Owner::Frame(_) => 0..0,
        }
    }

    /// Value at the loaded state.
    pub(crate) fn balance_of(&self, of: Owner, what: BalanceQuantity, t: f64, component: usize) -> f64 {
        let origin = Seen::default();
        match what {
            BalanceQuantity::Mass => self.balance(of, origin).mass,
            BalanceQuantity::Momentum => self.balance(of, origin).momentum[component],
            BalanceQuantity::CenterOfMass => self.center_of(of).from[component],
            BalanceQuantity::AngularMomentum(about) => self.spin_about(of, about)[component],
            BalanceQuantity::KineticEnergy => self.balance(of, origin).kinetic,
            BalanceQuantity::StrainEnergy => self.strain_energy(of),
            BalanceQuantity::GravityEnergy => -self.gravity(t).dot(&self.balance(of, origin).moment),
        }
    }

    /// Angular momentum about a point. What moves with the point is left out where it comes in: far away, or fast, round-off of it would be as large
    /// as what turns.
    fn spin_about(&self, of: Owner, about: About) -> Vector {
        let seen = match about {
            About::Origin => Seen::default(),
            About::Marker(marker) => {
                let marker = &self.links.markers[marker];
                let [from, moving, ..] = self.jet(marker);
                let fixed = match *marker {
                    Marker::Fixed { frame, at, .. } => Some((frame, at)),
                    _ => None,
                };
                Seen { from, moving, fixed }
            }
            About::CenterOf(of) => self.center_of(of),
        };
        let found = self.balance(of, seen);
        if about == About::CenterOf(of) {
            // There is no first moment about it.
            return found.spin;
        }
        found.spin + found.moment.cross(&seen.moving)
    }

    fn center_of(&self, of: Owner) -> Seen {
        let found = self.balance(of, Seen::default());
        Seen {
            from: 1.0 / found.mass * found.moment,
            moving: 1.0 / found.mass * found.momentum,
            fixed: None,
        }
    }

    /// Way to the origin of a frame from where it is seen, and its velocity from there.
    fn way_and_velocity(&self, frame: usize, seen: Seen) -> [Vector; 2] {
        let motion = &self.buffers.frames[frame];
        let way = match seen.fixed {
            Some((own, at)) if own == frame => -motion.direction_to_inertial(at),
            _ => motion.position - seen.from,
        };
        [way, motion.velocity - seen.moving]
    }

    fn balance(&self, of: Owner, seen: Seen) -> Balance {
        let mut sum = Balance::default();
        for body in self.bodies_of(of) {
            sum = sum.plus(self.balance_of_body(body, seen));
        }
        let counts = |frame: usize| of == Owner::All || of == Owner::Frame(frame);
        for frame in self.frames.free.iter().filter(|frame| counts(frame.spec.frame)) {
            let (rigid, motion) = (&frame.spec.rigid, &self.buffers.frames[frame.spec.frame]);
            let moment = motion.direction_to_inertial(rigid.moment);
            let spin = motion.direction_to_inertial(motion.spin);
            let turning = rigid.inertia * motion.spin;
            let own = Balance {
                mass: rigid.mass,
                moment,
                momentum: spin.cross(&moment),
                spin: motion.direction_to_inertial(turning),
                kinetic: 0.5 * motion.spin.dot(&turning),
            };
            let [way, velocity] = self.way_and_velocity(frame.spec.frame, seen);
            sum = sum.plus(own.carried(way, velocity));
        }
        sum
    }

    fn balance_of_body(&self, index: usize, seen: Seen) -> Balance {
        let body = &self.bodies[index];
        let (mass, frame) = (&body.whole_mass, &self.buffers.frames[body.frame]);
        let first = self.layout.offset(body.first_vector);
        let vector = |full: &[f64], place: usize| -> Vector {
            let [x, y, z, _]: Padded = spread(body.spec.axes, &full[first..], place);
            Vector::new(x, y, z)
        };
        // Places and velocities relative to the frame's origin, inertial axes.
        let moved = (0..mass.vectors()).map(|place| {
            let (mut q, v) = (vector(&self.buffers.q, place), vector(&self.buffers.v, place));
            if mass.is_position(place) {
                q += body.offset;
            }
            [frame.direction_to_inertial(q), frame.rate_to_inertial(q, v)]
        });
        let moved: Vec<[Vector; 2]> = moved.collect();
        let rates: Vec<[Padded; 1]> = moved.iter().map(|[_, rate]| [padded(*rate)]).collect();
        let mut own = Balance::default();
        for (place, [at, rate]) in moved.iter().enumerate() {
            let [[x, y, z, _]] = mass.product(place, &rates);
            let momentum = Vector::new(x, y, z);
            if mass.is_position(place) {
                own.mass += mass.first(place);
            }
            own.moment += mass.first(place) * *at;
            own.momentum += mass.first(place) * *rate;
            own.spin += at.cross(&momentum);
            own.kinetic += 0.5 * rate.dot(&momentum);
        }
        let components = first..first + body.spec.vectors() * body.spec.dimension();
        let at = [&self.buffers.q, &self.buffers.v].map(|full| &full[components.clone()]);
        if let Some(sums) = body.modes.as_ref().and_then(|modes| modes.inertial(frame.spin, at)) {
            own = own.plus(Balance {
                mass: sums.mass,
                moment: frame.direction_to_inertial(sums.moment),
                momentum: frame.direction_to_inertial(sums.momentum),
                spin: frame.direction_to_inertial(sums.spin),
                kinetic: sums.kinetic,
            });
        }
        let [way, velocity] = self.way_and_velocity(body.frame, seen);
        own.carried(way, velocity)
    }

    /// Elastic energy of elements, J; none where a body does not deform.
    fn strain_energy(&self, of: Owner) -> f64 {
        let mut energy = 0.0;
        for index in self.bodies_of(of) {
            let body = &self.bodies[index];
            if !body.spec.fidelity.deforms() {
                continue;
            }
            let first = self.layout.offset(body.first_vector);
            let components = first..first + body.spec.vectors() * body.spec.dimension();
            let own = body
                .modes
                .as_ref()
                .and_then(|modes| modes.strain_energy(&self.buffers.q[components]));
            if let Some(own) = own {
                energy += own;
                continue;
            }
            let size = body.spec.element_size();
            for element in 0..body.spec.count {
                let mut q = [0.0; MAX_SIZE];
                body.connectivity.gather(element, &self.buffers.q, &mut q[..size]);
                energy += self.parts.energy(index, element, &q[..size]);
            }
        }
        energy
    }
}
