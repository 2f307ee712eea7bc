//! Bodies from elsewhere: their modes at the interfaces, and modal coordinates in the nodes that hold them.

use std::fmt;
use std::sync::Arc;

use super::action::FrameAction;
use super::body::{ModalBody, Nodal};
use super::elsewhere::Elsewhere;
use super::expansion::{Elastic, Expansion};
use super::invariants::Action;
use crate::emitted::{
    BodySpec, Fidelity, Held, Interpolant, JointKind, Line, MarkerSpec, ObservedSpec, Place, PointQuantity,
};
use crate::error::ModelError;
use crate::import::{Imported, Wanted};
use crate::model::Warning;
use crate::scene::MeshScene;
use crate::scene::bodies::described::Inertial;
use crate::scene::bodies::place::element_at;
use crate::space::Vector;
use crate::system::State;

/// Rotation of an interface (rad) from which a linear body is told to be bent too far: its error is half the square.
const LARGE: f64 = 0.2;
/// Part of the stiffness at rest that centrifugal terms may take away before it is told.
const TAKEN: f64 = 0.02;

/// An interface that turns farther than linear modes know.
struct TurnsFar<'a> {
    body: &'a str,
    interface: &'a str,
    angle: f64,
}

impl fmt::Display for TurnsFar<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "body `{}`: its interface `{}` turns by {:.1} deg in the body's frame, and a body from a file is linear: its deflection is no longer small",
            self.body,
            self.interface,
            self.angle.to_degrees()
        )
    }
}

impl ModalBody {
    /// A body from elsewhere with the nodes of the scene. `held`: what joints to the body's own frame hold of each interface.
    ///
    /// # Errors
    /// What is wrong with the body, by its name.
    pub(super) fn imported(
        nodal: Nodal,
        spec: &BodySpec,
        body: &Imported,
        held: &[[bool; 6]],
    ) -> Result<Self, ModelError> {
        let wanted = match spec.fidelity {
            Fidelity::Modal(count) | Fidelity::Small(count) => Wanted::Modes(count),
            Fidelity::Rigid | Fidelity::Point | Fidelity::Full => Wanted::Rigid,
        };
        let found = body.reduced(wanted, held).map_err(ModelError::new)?;
        let Line::Nodes(nodes) = &spec.line else {
            return Err(ModelError::new(format!("body `{}` has no nodes of a file", nodal.name)));
        };
        let k = found.frequencies.len();
        let (mut modes, mut momenta) = (vec![0.0; nodal.shape.len() * k], vec![0.0; nodal.shape.len() * k]);
        for vector in 0..spec.vectors() {
            let (node, local) = spec.locate(vector);
            let what = spec.nodal[local];
            let axis = match (what.of, what.order) {
                (Interpolant::Position, 0) => None,
                (Interpolant::Position, _) => Some(0),
                (Interpolant::SectionY, _) => Some(1),
                (Interpolant::SectionZ, _) => Some(2),
            };
            for component in 0..3 {
                let row = (3 * vector + component) * k;
                match (nodes.at(node), axis) {
                    (Held::Interface(interface), axis) => {
                        for mode in 0..k {
                            modes[row + mode] = match axis {
                                None => found.interfaces[mode][interface][0][component],
                                Some(axis) => found.axes[mode][interface][axis][component],
                            };
                        }
                    }
                    (Held::Coordinates(first), Some(axis)) => {
                        let mode = first + 3 * axis + component;
                        if mode < k {
                            modes[row + mode] = 1.0 / found.sizes[mode];
                            momenta[row + mode] = found.sizes[mode];
                        }
                    }
                    (Held::Coordinates(_), None) => {}
                }
            }
        }
        let mut invariants = found.inertia;
        if spec.fidelity == Fidelity::Point {
            invariants = invariants.at_centre(body.extent());
        }
        let mut stiffness = vec![0.0; k * k];
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            stiffness[mode * (k + 1)] = frequency * frequency;
        }
        Ok(Self {
            nodal,
            fidelity: spec.fidelity,
            modes,
            momenta,
            frequencies: found.frequencies,
            sizes: found.sizes,
            loaded: invariants.clone(),
            invariants,
            // What does not deform has no forces.
            elastic: match k {
                0 => Elastic::Elements,
                _ => Elastic::Expanded {
                    stiffness: Expansion::constant(stiffness),
                    damping: found.damping.map(Expansion::constant),
                },
            },
            stiffness: None,
            elsewhere: Some(Elsewhere {
                motions: found.interfaces,
                lacking: found.lacking,
                names: (0..body.interfaces())
                    .map(|interface| body.interface_name(interface))
                    .collect(),
                notes: found.notes,
            }),
        })
    }

    /// What is to be told of a body from elsewhere before it runs.
    pub(super) fn remarks(&self) -> Vec<Warning> {
        let notes = self.elsewhere.iter().flat_map(|elsewhere| &elsewhere.notes);
        let told = |text: &String| Warning {
            text: text.clone(),
            weight: 0.0,
        };
        notes.map(told).collect()
    }

    /// Sums over the mass of a body from elsewhere, from its nodal vectors and their rates in its frame.
    pub(super) fn inertial(&self, spin: Vector, [q, v]: [&[f64]; 2]) -> Option<Inertial> {
        self.elsewhere.as_ref()?;
        let (p, rates) = (self.coordinates(q), self.coordinate_rates(v));
        Some(self.invariants.carried(spin, &p, &rates))
    }

    /// Strain energy of a body from elsewhere, J.
    pub(super) fn strain_of(&self, q: &[f64]) -> Option<f64> {
        self.elsewhere.as_ref()?;
        let p = self.coordinates(q);
        let each = p.iter().zip(&self.frequencies);
        Some(each.map(|(p, frequency)| 0.5 * (frequency * p).powi(2)).sum())
    }

    /// Whether it is known what the modes of a body from elsewhere lack.
    pub(super) fn lacks(&self) -> bool {
        self.elsewhere
            .as_ref()
            .is_some_and(|elsewhere| elsewhere.lacking.is_some())
    }

    /// What is to be told of the modal coordinates of a body from elsewhere.
    pub(super) fn told(&self, frame: &FrameAction, p: &[f64], acting: &[[Vector; 2]]) -> Vec<Warning> {
        let Some(elsewhere) = &self.elsewhere else {
            return Vec::new();
        };
        let mut warnings: Vec<Warning> = elsewhere
            .told_of_modes(&self.nodal.name, p, acting)
            .into_iter()
            .collect();
        let moved = elsewhere.moved(p);
        let turns = moved.iter().map(|[_, turn]| turn.norm());
        let farthest = turns.zip(&elsewhere.names);
        if let Some((angle, interface)) = farthest.max_by(|a, b| a.0.total_cmp(&b.0))
            && angle > LARGE
        {
            let body = &self.nodal.name;
            warnings.push(Warning {
                text: TurnsFar { body, interface, angle }.to_string(),
                weight: angle,
            });
        }
        let action = Action {
            spin_rate: Vector::zeros(),
            ..Action::new(frame, 3)
        };
        let spin = action.spin.norm();
        let remaining = self.least_stiffness(&action);
        if spin > 0.0
            && let Some(remaining) = remaining.filter(|remaining| *remaining < 1.0 - TAKEN)
        {
            warnings.push(Warning {
                text: format!(
                    "body `{}`: at a spin of {spin:.4} rad/s centrifugal forces take {:.1} % of its stiffness at rest, and what tightens it is not in its file: it bends and vibrates as if it were softer by as much or more",
                    self.nodal.name,
                    100.0 * (1.0 - remaining)
                ),
                weight: 1.0 - remaining,
            });
        }
        warnings
    }
}

impl MeshScene {
    /// The body from elsewhere that a body is.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn elsewhere(&self, index: usize) -> Result<Option<Arc<Imported>>, ModelError> {
        let Line::Nodes(nodes) = &self.bodies[index].spec.line else {
            return Ok(None);
        };
        nodes.body().map(|body| Some(body.clone())).map_err(ModelError::new)
    }

    /// Force (N) and moment (N m) of all that acts on every interface of a body from elsewhere, frame axes, in the evaluated forces.
    fn on_interfaces(&self, index: usize) -> Vec<[Vector; 2]> {
        let body = &self.bodies[index];
        let mut acting = Vec::new();
        let Line::Nodes(nodes) = &body.spec.line else {
            return acting;
        };
        for vector in 0..body.spec.vectors() {
            let (node, local) = body.spec.locate(vector);
            let Held::Interface(interface) = nodes.at(node) else {
                continue;
            };
            acting.resize(acting.len().max(interface + 1), [Vector::zeros(); 2]);
            let offset = self.layout.offset(body.first_vector + vector);
            let [force, direction] = [&self.buffers.force, &self.buffers.q].map(|of| self.vector_at(body, of, offset));
            match body.spec.nodal[local].is_position() {
                true => acting[interface][0] -= force,
                false => acting[interface][1] -= direction.cross(&force),
            }
        }
        acting
    }

    /// The same of all bodies at a state, by their number; of others nothing.
    pub(super) fn on_all_interfaces(&mut self, state: &State) -> Vec<Vec<[Vector; 2]>> {
        self.load_state(state);
        self.evaluate_acting(state.t, 1.0, &state.lambda);
        (0..self.bodies.len()).map(|index| self.on_interfaces(index)).collect()
    }

    /// What joints to its own frame hold of every interface of a body from elsewhere; refuses what it cannot be asked for.
    pub(super) fn held_interfaces(&self, index: usize, body: &Imported) -> Result<Vec<[bool; 6]>, ModelError> {
        let spec = &self.bodies[index].spec;
        let name = spec.label();
        let refuse = |what: String| Err(ModelError::new(what));
        let mut held = vec![[false; 6]; body.interfaces()];
        for condition in &self.conditions {
            let joint = &self.joints[condition.joint];
            if joint.body != index {
                continue;
            }
            let interface = if joint.at_end { body.interfaces() - 1 } else { 0 };
            let own = &mut held[interface];
            match joint.kind {
                JointKind::Clamp | JointKind::ClampFull => *own = [true; 6],
                JointKind::Pin => own[..3].fill(true),
                JointKind::Hold {
                    of: Interpolant::Position,
                    order: 0,
                    axis,
                } => own[axis] = true,
                JointKind::Hold { .. } => {
                    return refuse(format!(
                        "joint `{}` holds a direction of body `{name}`, which comes from a file: clamp or pin its interface `{}`",
                        joint.name,
                        body.interface_name(interface)
                    ));
                }
            }
        }
        let is_held = held.iter().flatten().any(|held| *held);
        let is_alone = self.frames.free_of[spec.frame].is_some_and(|free| {
            let bodies = self.bodies.iter().filter(|body| body.spec.frame == spec.frame).count();
            bodies == 1 && !self.frames.free[free].has_rigid_parts()
        });
        if !is_held && !is_alone {
            let frame = self.parts.frame_name(spec.frame);
            return refuse(format!(
                "body `{name}` is held by no joint in its frame `{frame}`, which does not move with it alone: clamp one of its interfaces there, `clamp({name}.{}, {frame})`, or give it a free frame of its own and tie it to others by joints",
                body.interface_name(0)
            ));
        }
        let turns = |at: Place| -> Result<Option<usize>, ModelError> {
            let (element, xi) = element_at(spec, at, "a joint")?;
            let Line::Nodes(nodes) = &spec.line else {
                return Ok(None);
            };
            Ok(match nodes.at(element + xi as usize) {
                Held::Interface(interface) if !body.turns(interface) => Some(interface),
                _ => None,
            })
        };
        let marked = self.parts.markers().into_iter().filter_map(|marker| match marker {
            MarkerSpec::BodySlope { body, at }
            | MarkerSpec::BodySection { body, at, .. }
            | MarkerSpec::InSection { body, at, .. }
            | MarkerSpec::SectionTurn { body, at } => Some((body, at)),
            _ => None,
        });
        let read = self.observed.specs.iter().filter_map(|observed| match *observed {
            ObservedSpec::Point { body, at, what, .. }
                if !matches!(what, PointQuantity::Position | PointQuantity::Velocity) =>
            {
                Some((body, at))
            }
            _ => None,
        });
        for (_, at) in marked.chain(read).filter(|(own, _)| *own == index) {
            if let Some(interface) = turns(at)? {
                return refuse(format!(
                    "a joint, load or output needs how the interface `{}` of body `{name}` turns, and its file has no rotation there: let three or more nodes that are not on a line be the interface, `interface {} = nodes [1, 2, 3];`",
                    body.interface_name(interface),
                    body.interface_name(interface)
                ));
            }
        }
        Ok(held)
    }
}
