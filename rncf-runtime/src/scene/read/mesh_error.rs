//! How far a mesh is from its body, from one state: the principle of Prager and Synge. What sections carry by balance
//! ([`super::section`]) is in equilibrium with inertia and loads whatever the mesh; what the strains of the elements give
//! at the same places is not. The energy of their difference, with the compliances of the section, is the energy of the
//! error: over the energy of what the sections carry it is by how much the mesh is too stiff. Of the lines of this crate that
//! is an equality where the section forces are exact (linear statics of beams, whose nodal forces are), else a bound up to
//! terms of higher order. Single elements need no neighbours, and what jumps along a body (loads, sections) may jump.

use super::section::Reader;
use super::strained::{Components, Flexibility, Kind, Strained};
use crate::emitted::{FIVE, Fidelity, Line, MAX_SIZE, legendre};
use crate::model::{MeshError, Uniform};
use crate::scene::MeshScene;
use crate::scene::pieces::buffers::Regime;
use crate::space::Vector;
use crate::system::State;

/// Part of the energy below which an error is not looked at any closer.
const LOOKED_AT: f64 = 1e-3;
/// Part of the elastic forces that other points of integration may change.
const INTEGRATED: f64 = 0.02;
/// Strain below which all is round-off.
const NOISE: f64 = 1e-9;
/// Points at which curvatures of sections are integrated: Gauss's two.
const FELT: [f64; 2] = [0.5 - 0.288_675_134_594_812_9, 0.5 + 0.288_675_134_594_812_9];
/// How far a mode goes: parts of the longest body, and of the thinnest section's radius of gyration.
const SMALL: f64 = 1e-4;
const THIN: f64 = 0.03;

/// A place of an element at which strains are compared.
struct Place<'f> {
    element: usize,
    /// Half of its weight in sums along the axis, m.
    part: f64,
    flexibility: &'f Flexibility,
    /// Direction of the axis, frame axes.
    along: Vector,
    balanced: Components,
    strained: Components,
}

impl Place<'_> {
    fn difference(&self) -> Components {
        std::array::from_fn(|i| self.balanced[i] - self.strained[i])
    }
}

impl Strained<'_> {
    /// Where strains are compared, and weights, both parts of an element. Of a line the points at which its strains are integrated,
    /// of a section those of its axis: at the fewer points of its gradients curvatures are better than anywhere else, and would not tell.
    fn places(&self) -> Vec<(f64, f64)> {
        match self.kind {
            Kind::Line => FIVE.to_vec(),
            Kind::PlanarSection | Kind::Section => legendre(3),
        }
    }

    /// Compares strains and balance at these places of all elements.
    fn each_place(&self, places: &[(f64, f64)], reader: &mut Reader<'_>, mut call: impl FnMut(Place<'_>)) {
        let body = &self.scene.bodies[self.body];
        let spec = &body.spec;
        let varies = self.scene.parts.varies(self.body);
        // Of every place where they differ along the body, else one for all.
        let mut flexibilities: Vec<Flexibility> = Vec::new();
        let mut shapes: Vec<Vec<f64>> = Vec::new();
        let mut found: Vec<([Vector; 3], [Components; 2])> = Vec::with_capacity(places.len());
        for element in 0..spec.count {
            reader.begin(element);
            let size = spec.element_size();
            let [mut q, mut v, mut undeformed] = [[0.0; MAX_SIZE]; 3];
            body.connectivity.gather(element, &self.scene.buffers.q, &mut q[..size]);
            body.connectivity.gather(element, &self.scene.buffers.v, &mut v[..size]);
            let shape = (0..spec.nodal.len()).flat_map(|local| spec.undeformed(element, local));
            undeformed.iter_mut().zip(shape).for_each(|(own, value)| *own = value);
            let length = spec.element_length(element);
            let mut slope = Vector::zeros();
            if varies || shapes.is_empty() {
                shapes = places.iter().map(|&(xi, _)| self.weights(element, xi)).collect();
            }
            for (&(xi, weight), weights) in places.iter().zip(&shapes) {
                let [free, present, rates] = [&undeformed, &q, &v].map(|local| self.fields_at(weights, &local[..size]));
                let x = spec.arclength(element, xi);
                if varies || flexibilities.is_empty() {
                    flexibilities.truncate(found.len());
                    flexibilities.push(self.flexibility(x, &free));
                }
                let triad = self.triad(&present);
                let forces = self.forces(x, [&free, &present, &rates]);
                let mut balanced = self.components(&triad, reader.carried(xi));
                if self.kind != Kind::Line {
                    balanced[6..].copy_from_slice(&self.swelling(&present, reader.inertia_of_section(xi)));
                    // Slope of the line that is nearest to the couples.
                    for (slope, couple) in slope.iter_mut().zip(self.couples(&present, &forces)) {
                        *slope += 12.0 * weight * (xi - 0.5) * couple / length;
                    }
                }
                found.push((triad, [balanced, self.strained(&triad, &present, &forces)]));
            }
            if self.kind == Kind::Section {
                let locals = [&undeformed, &q, &v].map(|local| &local[..size]);
                self.feel(
                    element,
                    locals,
                    places,
                    &flexibilities,
                    found.iter_mut().map(|(_, [_, strained])| strained),
                );
            }
            for (place, (triad, [mut balanced, strained])) in found.drain(..).enumerate() {
                balanced[6..]
                    .iter_mut()
                    .zip(&slope)
                    .for_each(|(own, slope)| *own += slope);
                call(Place {
                    element,
                    part: 0.5 * places[place].1 * length,
                    flexibility: flexibilities.get(place).unwrap_or(&flexibilities[0]),
                    along: triad[0],
                    balanced,
                    strained,
                });
            }
        }
    }

    /// Where strains of the axis couple with curvatures, they follow them at the points of integration of these alone; between them the
    /// parts of their energies mean nothing to the element. Moments at places are so those of the line through both points, and forces
    /// what strains held fixed make of that.
    fn feel<'a>(
        &self,
        element: usize,
        locals: [&[f64]; 3],
        places: &[(f64, f64)],
        flexibilities: &[Flexibility],
        strained: impl Iterator<Item = &'a mut [f64; 9]>,
    ) {
        let couplings: Vec<_> = flexibilities.iter().map(Flexibility::coupling).collect();
        if couplings.iter().all(Option::is_none) {
            return;
        }
        let felt = FELT.map(|xi| self.moment_of_strains(element, xi, locals));
        for (place, (strained, &(xi, _))) in strained.zip(places).enumerate() {
            let Some(coupling) = couplings.get(place).unwrap_or(&couplings[0]) else {
                continue;
            };
            let moment = Vector::new(strained[3], strained[4], strained[5]);
            let felt = felt[0] + (xi - FELT[0]) / (FELT[1] - FELT[0]) * (felt[1] - felt[0]);
            let force = coupling * (felt - moment);
            for axis in 0..3 {
                strained[axis] += force[axis];
                strained[3 + axis] = felt[axis];
            }
        }
    }

    fn moment_of_strains(&self, element: usize, xi: f64, locals: [&[f64]; 3]) -> Vector {
        let weights = self.weights(element, xi);
        let [free, present, rates] = locals.map(|local| self.fields_at(&weights, local));
        let x = self.scene.bodies[self.body].spec.arclength(element, xi);
        let forces = self.forces(x, [&free, &present, &rates]);
        let strained = self.strained(&self.triad(&present), &present, &forces);
        Vector::new(strained[3], strained[4], strained[5])
    }

    fn measure(&self, reader: &mut Reader<'_>) -> MeshError {
        // Most lines are integrated so.
        let found = self.measure_at(&self.places(), reader);
        if self.kind != Kind::Line || found.error < LOOKED_AT * found.energy {
            return found;
        }
        match self.rule() {
            Some(rule) if rule.len() < FIVE.len() => self.measure_at(&rule, reader),
            Some(_) => found,
            None => MeshError::default(),
        }
    }

    fn measure_at(&self, places: &[(f64, f64)], reader: &mut Reader<'_>) -> MeshError {
        let spec = &self.scene.bodies[self.body].spec;
        let mut sum = MeshError::default();
        // What a straight axis takes up by its tension, `1/2 N |t - t0|^2` with the direction t0 for which it is least.
        let is_straight = matches!(spec.line, Line::Straight { .. });
        let (mut tension, mut pulled) = (0.0, Vector::zeros());
        let mut noise = 0.0;
        self.each_place(places, reader, |place| {
            let Place {
                part,
                flexibility,
                balanced,
                strained,
                ..
            } = &place;
            let held = flexibility.held(balanced[0], spec.element_length(place.element));
            let error = part * flexibility.energy(&place.difference(), held);
            sum.error += error;
            sum.energy += error + part * flexibility.energy(strained, [1.0; 2]);
            let pull = part * balanced[0].max(0.0);
            tension += pull;
            pulled += pull * place.along;
            noise += part * NOISE * NOISE / flexibility.values[0][0];
        });
        if is_straight && tension > 0.0 {
            sum.energy += (tension - pulled.dot(&pulled) / tension).max(0.0);
        }
        // The round-off of a body at rest is no deformation.
        if sum.energy > noise { sum } else { MeshError::default() }
    }

    /// The points at which the elements of a line integrate their energy, or a rule that is as exact; `None` where neither is found. The
    /// strains between fewer points mean nothing: they are where elements lock.
    fn rule(&self) -> Option<Vec<(f64, f64)>> {
        let rules = [5, 4, 3, 2, 1].map(legendre);
        rules.into_iter().find(|rule| self.is_integrated_by(rule))
    }

    /// Whether the elastic forces are those of the strains at these points.
    fn is_integrated_by(&self, rule: &[(f64, f64)]) -> bool {
        let body = &self.scene.bodies[self.body];
        let (spec, size) = (&body.spec, body.spec.element_size());
        let (mut differences, mut all) = (0.0, 0.0);
        for element in 0..spec.count {
            let [mut q, mut v, mut force] = [[0.0; MAX_SIZE]; 3];
            body.connectivity.gather(element, &self.scene.buffers.q, &mut q[..size]);
            body.connectivity.gather(element, &self.scene.buffers.v, &mut v[..size]);
            let parts = &self.scene.parts;
            parts.elastic_force(self.body, element, &q[..size], &v[..size], &mut force[..size]);
            all += force.iter().map(|force| force.abs()).sum::<f64>();
            let local = 0..spec.nodal.len();
            let undeformed: Vec<f64> = local.flat_map(|local| spec.undeformed(element, local)).collect();
            for &(xi, weight) in rule {
                let weights = self.weights(element, xi);
                let fields = [&undeformed[..], &q[..size], &v[..size]].map(|local| self.fields_at(&weights, local));
                let forces = self.forces(spec.arclength(element, xi), fields.each_ref().map(|fields| &fields[..]));
                for (weights, on) in weights.chunks_exact(spec.nodal.len()).zip(&forces) {
                    for (place, sum) in force[..size].iter_mut().enumerate() {
                        let axis = spec.axes[place % spec.dimension()];
                        *sum -= weight * spec.element_length(element) * weights[place / spec.dimension()] * on[axis];
                    }
                }
            }
            differences += force.iter().map(|force| force.abs()).sum::<f64>();
        }
        differences <= INTEGRATED * all
    }
}

impl MeshScene {
    /// Strain energy at the loaded state of all bodies whose meshes are judged, J.
    pub(crate) fn energy_of_meshes(&self) -> f64 {
        let mut energy = 0.0;
        for (index, body) in self.bodies.iter().enumerate() {
            if body.spec.fidelity == Fidelity::Full {
                let mut q = [0.0; MAX_SIZE];
                let size = body.spec.element_size();
                for element in 0..body.spec.count {
                    body.connectivity.gather(element, &self.buffers.q, &mut q[..size]);
                    energy += self.parts.energy(index, element, &q[..size]);
                }
            }
        }
        energy
    }

    /// Energies of the bodies of [`MeshScene::sectioned`] at the loaded state, whose sections are set; without numbers of those that
    /// have no mesh, or elements with other fields than an axis and a section.
    pub(crate) fn measure_meshes(&mut self, out: &mut Vec<MeshError>) {
        out.clear();
        self.each_meshed(|_, meshed| {
            out.push(meshed.map_or_else(MeshError::default, |(strained, reader)| strained.measure(reader)));
        });
    }

    /// Calls for all bodies of [`MeshScene::sectioned`], with what reads them where they have a mesh.
    fn each_meshed(&mut self, mut call: impl FnMut(usize, Option<(&Strained<'_>, &mut Reader<'_>)>)) {
        let mut reaches = self.taken_reaches();
        let sampled = (0..self.bodies.len()).filter(|&body| self.knows_sections(body));
        for (place, body) in sampled.enumerate() {
            let is_full = self.bodies[body].spec.fidelity == Fidelity::Full;
            let strained = is_full.then(|| Strained::new(self, body)).flatten();
            let mut reader = Reader::new(self, body, &mut reaches[body]);
            call(place, strained.as_ref().map(|strained| (strained, &mut reader)));
        }
        self.buffers.reaches = reaches;
    }

    /// Of small motions about a uniform one, `y = Re(shape exp(s t))` of all unknowns: for every body of [`MeshScene::sectioned`] the
    /// stiffness that its mesh has too much, `shape . dK shape`.
    pub(crate) fn mode_errors(&mut self, at: &Uniform, state: &State, s: [f64; 2], shape: &[[f64; 2]]) -> Vec<f64> {
        let count = self.sectioned().len();
        let mut errors = vec![0.0; count];
        let amplitude = self.small_amplitude(shape);
        if !(amplitude > 0.0 && amplitude.is_finite()) {
            return errors;
        }
        // At two moments a quarter of a period apart.
        for turn in [[1.0, 0.0], [0.0, 1.0]] {
            let mut found: [Vec<Vec<Components>>; 2] = [Vec::new(), Vec::new()];
            let mut rules = Vec::new();
            for (found, sign) in found.iter_mut().zip([1.0, -1.0]) {
                let factor = turn.map(|part| sign * amplitude * part);
                let moved = self.moved_state(at, state, s, shape, factor);
                let unknowns = [&moved.x[..], &moved.v, &moved.a];
                self.load(at.t, &moved.turns, unknowns, Regime::Uniform(at.speed()));
                self.evaluate_sections(at.t, at.load(), &moved.lambda);
                self.each_meshed(|body, meshed| {
                    let mut differences = Vec::new();
                    if let Some((strained, reader)) = meshed {
                        if sign > 0.0 {
                            let rule = (strained.kind == Kind::Line).then(|| strained.rule());
                            rules.push(rule.unwrap_or_else(|| Some(strained.places())).unwrap_or_default());
                        }
                        strained.each_place(&rules[body], reader, |place| differences.push(place.difference()));
                    } else if sign > 0.0 {
                        rules.push(Vec::new());
                    }
                    found.push(differences);
                });
            }
            let [up, down] = found;
            self.load_uniform(at, state);
            self.evaluate_sections(at.t, at.load(), &state.lambda);
            self.each_meshed(|body, meshed| {
                let Some((strained, reader)) = meshed else { return };
                let spec = &strained.scene.bodies[strained.body].spec;
                let mut differences = up[body].iter().zip(&down[body]);
                strained.each_place(&rules[body], reader, |place| {
                    let Some((up, down)) = differences.next() else { return };
                    let rate = std::array::from_fn(|i| (up[i] - down[i]) / (2.0 * amplitude));
                    let held = place
                        .flexibility
                        .held(place.balanced[0], spec.element_length(place.element));
                    errors[body] += 2.0 * place.part * place.flexibility.energy(&rate, held);
                });
            });
        }
        errors
    }

    /// A factor that makes a shape so small that what it does is linear, and not as small as round-off.
    fn small_amplitude(&self, shape: &[[f64; 2]]) -> f64 {
        let size = self
            .bodies
            .iter()
            .map(|body| body.spec.line.length())
            .fold(0.0, f64::max);
        let thin = (0..self.bodies.len()).map(|body| {
            let section = self.section_spec(body, 0.0);
            let moment = section.second_moments.iter().copied().fold(0.0, f64::max);
            (moment / section.area).sqrt()
        });
        let thin = thin.filter(|radius| *radius > 0.0).fold(size, f64::min);
        let relative = shape
            .iter()
            .zip(&self.tabulated.sizes)
            .map(|(value, size)| value[0].hypot(value[1]) / size);
        (SMALL * size).min(THIN * thin) / (size * relative.fold(0.0, f64::max))
    }

    /// A state in the uniform motion moved by `factor` (complex) times a mode, with its rates.
    fn moved_state(&mut self, at: &Uniform, state: &State, s: [f64; 2], shape: &[[f64; 2]], factor: [f64; 2]) -> State {
        let mut moved = state.clone();
        self.set_uniform(at, &mut moved);
        let corotations = self.corotations(at);
        let times = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
        let real = |factor: [f64; 2]| -> Vec<f64> { shape.iter().map(|&value| times(factor, value)[0]).collect() };
        let place = real(factor);
        let rate = real(times(factor, s));
        let second = real(times(times(factor, s), s));
        let turns = self.frames.turns.clone();
        moved.rebase(&turns);
        for (unknown, value) in moved.x.iter_mut().enumerate() {
            *value += place[unknown];
            moved.v[unknown] += rate[unknown];
            moved.a[unknown] += second[unknown];
        }
        for corotation in corotations {
            corotation.add_rates([&place, &rate], [&mut moved.v, &mut moved.a]);
        }
        moved
    }
}
