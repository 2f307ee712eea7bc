//! Elastic kernels of elements with many nodal vectors: for each integration rule one straight-line
//! kernel of the fields at a point; the runtime carries nodal vectors there and back (`emitted/points.rs`).

use super::builder::{Builder, State};
use super::particles::Point;
use super::particles::section_point;
use crate::elements::Library;
use crate::lower::form::{FieldBlocks, FieldKernels, FieldRule, Form, Groups, Quantity, rules};
use crate::lower::invariants::{Blocks, Response};
use crate::lower::kernel::Kernel;
use crate::lower::quadratic::{length_power, relative_shapes};
use crate::lower::signature::{PointInputs, Signature};
use crate::lower::variant::Variant;
use crate::symbolic::Invariant;
use crate::symbolic::{Cost, Id, linear::Vector};
use crate::tensors::Sampling;

/// Derives the kernels at a point.
pub fn field_kernels(variant: &Variant, library: &Library) -> FieldKernels {
    let groups = Groups::of(&variant.vectors(library));
    let rules = rules(variant, variant.declaration(library));
    let rules = rules.into_iter().map(|points| {
        let [force, tangent, energy] = [Quantity::Force, Quantity::Tangent, Quantity::Energy].map(|quantity| {
            if variant.material.is_some() {
                return section_point(variant, library, &groups, (points, quantity));
            }
            let mut builder = Builder::new(variant, library, Form::Fields, quantity);
            builder.rule = points;
            builder.field_point(&groups)
        });
        let shapes = shapes(variant, library, &groups, &tangent.fields, points);
        FieldRule {
            points,
            groups: tangent.groups,
            fields: tangent.fields,
            weights: points.rule().weights,
            shapes,
            stiffness: tangent.stiffness.unwrap_or_else(no_blocks),
            damping: tangent.damping,
            references: tangent.references,
            particles: [force.particle, tangent.particle].into_iter().flatten().collect(),
            kernels: [force.kernel, tangent.kernel, energy.kernel],
        }
    });
    FieldKernels {
        rules: rules.collect(),
        particles: variant
            .material
            .as_ref()
            .map_or(0, |material| material.section.count() + 2),
        groups,
    }
}

fn no_blocks() -> FieldBlocks {
    FieldBlocks {
        pairs: Vec::new(),
        tiles: Vec::new(),
    }
}

fn shapes(
    variant: &Variant,
    library: &Library,
    groups: &Groups,
    fields: &[usize],
    points: Sampling,
) -> Vec<Vec<Vec<f64>>> {
    let declared: Vec<_> = variant.declaration(library).fields_in(variant.dimension).collect();
    let vectors = variant.vectors(library);
    let relative = relative_shapes(&vectors);
    let rule = points.rule();
    let at = |field: usize, xi: f64| {
        let field = declared[field];
        let mut values = vec![0.0; groups.size()];
        for (place, nodal) in groups.nodal[groups.group(field.of)].iter().enumerate() {
            let shape = relative.iter().find(|(index, _)| index == nodal);
            values[place] = shape.map_or(0.0, |(_, shape)| shape.derivative(field.order).at(xi));
        }
        values
    };
    let points = rule.points.iter();
    points
        .map(|&xi| fields.iter().map(|&field| at(field, xi)).collect())
        .collect()
}

/// What a stress at a point does to the fields.
pub(super) struct OnFields {
    pub energy: Id,
    pub force: Vec<Vector>,
    pub stiffness: Blocks,
    pub viscosity: Option<Blocks>,
}

/// Places and values.
type Outputs = Vec<(String, Id)>;

impl Builder<'_> {
    /// The kernel of one quantity at a point of the rule.
    fn field_point(mut self, groups: &Groups) -> Point {
        let [inputs, fields] = self.field_symbols("");
        let [input_rates, rates] = if self.rates.is_empty() {
            [Vec::new(), Vec::new()]
        } else {
            self.field_symbols("v_")
        };
        let mut state = self.field_state(&fields, &rates, self.length);
        self.on_unit_element(&mut state);
        let on_fields = self.respond(&state, &inputs, &input_rates);
        let used: Vec<usize> = (0..fields.len())
            .filter(|&field| state.invariants.iter().any(|it| it.i == field || it.j == field))
            .collect();
        let group_of: Vec<usize> = used
            .iter()
            .map(|&field| groups.group(self.declared[field].of))
            .collect();
        let (outputs, stiffness, damping) = self.field_outputs(&on_fields, &used, (&group_of, groups.of.len()));
        let names: Vec<&str> = used.iter().map(|&field| self.declared[field].name).collect();
        let inputs = ["", "v_"].map(|prefix| self.input_names(prefix, &used));
        let blocks = [&stiffness, &damping].map(|blocks| blocks.as_ref().map_or(0, |blocks| blocks.pairs.len()));
        let references = self.references.len();
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references,
        };
        let kernel = signature.field_point(
            self.rule,
            self.quantity,
            self.graph,
            outputs,
            &PointInputs { names, inputs, blocks },
        );
        Point {
            kernel,
            particle: None,
            fields: used,
            groups: group_of,
            stiffness,
            damping,
            references,
        }
    }

    /// Text of the input for a component of a field: its derivative on the unit element.
    fn input_name(&self, prefix: &str, field: usize, c: usize) -> String {
        let declared = self.declared[field];
        let unit = if length_power(declared) == 0 { "" } else { "unit_" };
        format!("{prefix}{unit}{}_{}", declared.name, ["x", "y", "z"][c])
    }

    pub(super) fn input_names(&self, prefix: &str, fields: &[usize]) -> Vec<Vec<String>> {
        let names = |&field: &usize| {
            (0..self.variant.dimension)
                .map(|c| self.input_name(prefix, field, c))
                .collect()
        };
        fields.iter().map(names).collect()
    }

    /// The fields' derivatives on the unit element, and the fields.
    pub(super) fn field_symbols(&mut self, prefix: &str) -> [Vec<Vector>; 2] {
        let (mut inputs, mut fields) = (Vec::new(), Vec::new());
        for (index, field) in self.declared.clone().into_iter().enumerate() {
            let scale = self.length_power(length_power(field));
            let (mut input, mut vector) = (Vec::new(), Vec::new());
            for c in 0..self.variant.dimension {
                let symbol = self.graph.symbol(self.input_name(prefix, index, c));
                let value = self.graph.multiply(scale, symbol);
                input.push(symbol);
                vector.push(
                    self.graph
                        .name(value, format!("{prefix}{}_{}", field.name, ["x", "y", "z"][c])),
                );
            }
            inputs.push(input);
            fields.push(vector);
        }
        [inputs, fields]
    }

    /// The stress on invariants of the fields as one on those of their derivatives on the unit element.
    pub(super) fn on_unit_element(&mut self, state: &mut State) {
        let power = |builder: &Self, it: &Invariant| {
            length_power(builder.declared[it.i]) + length_power(builder.declared[it.j])
        };
        let powers: Vec<i32> = state.invariants.iter().map(|it| power(self, it)).collect();
        for (row, &p) in powers.iter().enumerate() {
            let scale = self.length_power(p);
            state.stress[row] = self.graph.multiply(scale, state.stress[row]);
            for matrix in [&mut state.stiffness, &mut state.viscosity] {
                let Some(line) = matrix.get_mut(row) else { continue };
                for (entry, &q) in line.iter_mut().zip(&powers) {
                    let scale = self.length_power(p + q);
                    *entry = self.graph.multiply(scale, *entry);
                }
            }
        }
    }

    /// Force, tangent and energy of a stress on the inner products of fields.
    pub(super) fn respond(&mut self, state: &State, fields: &[Vector], rates: &[Vector]) -> OnFields {
        let response = Response {
            invariants: &state.invariants,
            stress: &state.stress,
            stiffness: &state.stiffness,
            viscosity: &state.viscosity,
            vectors: fields,
            rates,
        };
        let mut result = OnFields {
            energy: state.energy,
            force: Vec::new(),
            stiffness: Vec::new(),
            viscosity: None,
        };
        match self.quantity {
            Quantity::Energy | Quantity::Reference => {}
            Quantity::Force => result.force = response.force(&mut self.graph),
            Quantity::Tangent => {
                (result.stiffness, result.viscosity) = match &self.averaged {
                    Some([_, end]) => (response.averaged_tangent(&mut self.graph, end), None),
                    None => response.combined_tangent(&mut self.graph),
                }
            }
        }
        result
    }

    /// What a kernel writes, and which blocks these are.
    pub(super) fn field_outputs(
        &mut self,
        on_fields: &OnFields,
        used: &[usize],
        groups: (&[usize], usize),
    ) -> (Outputs, Option<FieldBlocks>, Option<FieldBlocks>) {
        match self.quantity {
            Quantity::Energy | Quantity::Reference => (vec![("*energy".to_string(), on_fields.energy)], None, None),
            Quantity::Force => {
                let mut outputs = Vec::new();
                for (place, &field) in used.iter().enumerate() {
                    for (c, &value) in on_fields.force[field].iter().enumerate() {
                        outputs.push((format!("forces[{place}][{c}]"), value));
                    }
                }
                (outputs, None, None)
            }
            Quantity::Tangent => {
                let symmetric = on_fields.viscosity.is_none() && self.averaged.is_none();
                let (mut outputs, stiffness) = self.blocks(&on_fields.stiffness, "stiffness", symmetric, used, groups);
                let damping = on_fields.viscosity.as_ref().map(|viscosity| {
                    let (more, damping) = self.blocks(viscosity, "damping_matrix", true, used, groups);
                    outputs.extend(more);
                    damping
                });
                (outputs, Some(stiffness), damping)
            }
        }
    }

    /// Blocks that do not vanish, ordered by tile; of a symmetric tangent those of tiles on and above the
    /// diagonal.
    fn blocks(
        &mut self,
        blocks: &Blocks,
        name: &str,
        symmetric: bool,
        used: &[usize],
        (groups, count): (&[usize], usize),
    ) -> (Outputs, FieldBlocks) {
        let all = (0..count).flat_map(|g| (0..count).map(move |h| (g, h)));
        let all = all.filter(|&(g, h)| !symmetric || g <= h);
        let (mut outputs, mut list) = (Vec::new(), no_blocks());
        for (tile, (g, h)) in all.enumerate() {
            let from = list.pairs.len();
            for i in (0..used.len()).filter(|&i| groups[i] == g) {
                for j in (0..used.len()).filter(|&j| groups[j] == h) {
                    let block = &blocks[used[i]][used[j]];
                    if block.iter().flatten().all(|&entry| self.graph.is_zero(entry)) {
                        continue;
                    }
                    for (place, &entry) in block.iter().flatten().enumerate() {
                        outputs.push((format!("{name}[{}][{place}]", list.pairs.len()), entry));
                    }
                    list.pairs.push((i, j));
                }
            }
            if from < list.pairs.len() {
                list.tiles.push((tile, from, list.pairs.len()));
            }
        }
        (outputs, list)
    }
}

impl FieldKernels {
    /// Pairs of groups of a symmetric tangent, or of any.
    pub fn tiles(&self, symmetric: bool) -> usize {
        let count = self.groups.of.len();
        if symmetric {
            count * (count + 1) / 2
        } else {
            count * count
        }
    }

    /// Counted operations of a quantity, the way to the fields and back included.
    pub fn cost(&self, quantity: Quantity, dimension: usize) -> Cost {
        let size = self.groups.size();
        let pairs = |count: usize| Cost {
            additions: count,
            multiplications: count,
            ..Cost::default()
        };
        let mut cost = Cost::default();
        for rule in &self.rules {
            let kernel = match quantity {
                Quantity::Force => &rule.kernels[0],
                Quantity::Tangent => &rule.kernels[1],
                Quantity::Energy | Quantity::Reference => &rule.kernels[2],
            };
            let states = if rule.damping.is_some() && quantity != Quantity::Energy {
                2
            } else {
                1
            };
            let to = rule.fields.len() * size * dimension;
            let blocks = rule.stiffness.pairs.len() + rule.damping.as_ref().map_or(0, |blocks| blocks.pairs.len());
            let back = match quantity {
                Quantity::Force => to,
                Quantity::Tangent => blocks * dimension * dimension * size * size,
                Quantity::Energy | Quantity::Reference => 1,
            };
            let damped = rule.damping.is_some() && quantity == Quantity::Tangent;
            let mut particles = rule.particles.iter().take(if damped { 2 } else { 1 }).peekable();
            let inside = match particles.peek() {
                Some(_) => particles.fold(Cost::default(), |sum, particle| sum + particle.cost() * self.particles),
                None => kernel.cost(),
            };
            cost = cost + (inside + pairs(states * to + back)) * rule.points.count();
        }
        cost
    }

    /// Statements in the kernels of one quantity: what the compiler has to work on.
    pub fn size(&self) -> usize {
        let kernels = self.rules.iter().flat_map(|rule| &rule.kernels);
        kernels.map(Kernel::size).sum()
    }
}
