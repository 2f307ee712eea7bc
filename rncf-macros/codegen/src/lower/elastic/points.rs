//! Elastic kernels by integration points, unrolled or in a loop.

use std::collections::HashMap;

use super::builder::Builder;
use crate::lower::form::{Form, Quantity, rules};
use crate::lower::invariants::{Blocks, Response, mirror, zero_blocks};
use crate::lower::kernel::PointLoop;
use crate::lower::quadratic::{length_power, relative_shapes};
use crate::symbolic::{Graph, Id, linear::Vector};
use crate::tensors::Sampling;

/// What one point adds.
struct Contribution {
    energy: Id,
    force: Vec<Vector>,
    stiffness: Blocks,
    viscosity: Option<Blocks>,
}

impl Builder<'_> {
    pub(super) fn points(&mut self) {
        self.start_sums();
        let rules = rules(self.variant, self.element);
        if self.form == Form::Points {
            for &points in &rules {
                self.rule = points;
                for row in self.table(points) {
                    let row: Vec<Id> = row.iter().map(|&value| self.graph.number(value)).collect();
                    let partial = self.point(&row);
                    self.add_point(partial);
                }
            }
            return;
        }
        self.rule = rules[0];
        let table = self.table(rules[0]);
        let row: Vec<Id> = (0..table[0].len())
            .map(|k| self.graph.symbol(format!("table[{k}]")))
            .collect();
        let partial = self.point(&row);
        let mut varying = row;
        if self.quantity != Quantity::Reference {
            varying.extend(self.references.iter().copied());
        }
        let names = self.relative_names();
        let mut columns = vec!["weight".to_string()];
        for field in &self.declared {
            columns.extend(names.iter().map(|name| format!("{}[{name}]", field.name)));
        }
        self.points = Some(PointLoop {
            count: table.len(),
            columns,
            table,
            varying,
            sums: Vec::new(),
        });
        self.add_point(partial);
    }

    /// For each point its weight, then for each field the shape derivatives of the relative vectors.
    fn table(&self, points: Sampling) -> Vec<Vec<f64>> {
        let rule = points.rule();
        let shapes = relative_shapes(&self.nodal);
        let row = |point: usize| {
            let mut row = vec![rule.weights[point]];
            for field in &self.declared {
                row.extend(shapes.iter().map(|(index, shape)| {
                    if self.nodal[*index].of == field.of {
                        shape.derivative(field.order).at(rule.points[point])
                    } else {
                        0.0
                    }
                }));
            }
            row
        };
        (0..points.count()).map(row).collect()
    }

    fn start_sums(&mut self) {
        let (count, dimension) = (self.vectors.len(), self.variant.dimension);
        self.force = vec![vec![self.graph.zero(); dimension]; count];
        self.stiffness = zero_blocks(&mut self.graph, count, dimension);
        if !self.rates.is_empty() {
            self.viscosity = Some(zero_blocks(&mut self.graph, count, dimension));
        }
    }

    /// Contribution of one point: fields, stress, and its projection on the relative vectors.
    fn point(&mut self, row: &[Id]) -> Contribution {
        let count = self.vectors.len();
        let weight = self.graph.multiply(row[0], self.length);
        let shape = |field: usize, vector: usize| row[1 + field * count + vector];
        let (vectors, rates) = (self.vectors.clone(), self.rates.clone());
        let fields = self.fields(&vectors, &shape, "");
        let field_rates = if rates.is_empty() {
            Vec::new()
        } else {
            self.fields(&rates, &shape, "v_")
        };
        if let Some([start, end]) = self.ends.clone() {
            self.averaged = Some([self.fields(&start, &shape, "o_"), self.fields(&end, &shape, "e_")]);
        }
        let state = self.field_state(&fields, &field_rates, weight);
        let response = Response {
            invariants: &state.invariants,
            stress: &state.stress,
            stiffness: &state.stiffness,
            viscosity: &state.viscosity,
            vectors: &fields,
            rates: &field_rates,
        };
        let mut contribution = Contribution {
            energy: state.energy,
            force: Vec::new(),
            stiffness: Vec::new(),
            viscosity: None,
        };
        match self.quantity {
            Quantity::Energy | Quantity::Reference => {}
            Quantity::Force => {
                let force = response.force(&mut self.graph);
                let scaled = self.scale_by_order(force);
                for vector in 0..count {
                    let mut sum = vec![self.graph.zero(); self.variant.dimension];
                    for (field, force) in scaled.iter().enumerate() {
                        let term = self.graph.scale(shape(field, vector), force);
                        sum = self.graph.add_vectors(&sum, &term);
                    }
                    contribution.force.push(sum);
                }
            }
            Quantity::Tangent => {
                let symmetric = state.viscosity.is_empty() && self.averaged.is_none();
                let (stiffness, viscosity) = match &self.averaged {
                    Some([_, end]) => (response.averaged_tangent(&mut self.graph, end), None),
                    None => response.tangent(&mut self.graph),
                };
                contribution.stiffness = self.project(&stiffness, &shape, symmetric);
                contribution.viscosity = viscosity.map(|blocks| self.project(&blocks, &shape, false));
            }
        }
        contribution
    }

    /// Fields `r_x, r_xx, ..` at a point from relative vectors.
    fn fields(&mut self, vectors: &[Vector], shape: &impl Fn(usize, usize) -> Id, prefix: &str) -> Vec<Vector> {
        let mut fields = Vec::new();
        let declared = self.declared.clone();
        for (index, field) in declared.into_iter().enumerate() {
            let mut sum = vec![self.graph.zero(); self.variant.dimension];
            for (place, vector) in vectors.iter().enumerate() {
                let term = self.graph.scale(shape(index, place), vector);
                sum = self.graph.add_vectors(&sum, &term);
            }
            let scale = self.length_power(length_power(field));
            let scaled = self.graph.scale(scale, &sum);
            for (c, &id) in scaled.iter().enumerate() {
                if self.form == Form::Loop {
                    self.graph
                        .name(id, format!("{prefix}{}_{}", field.name, ["x", "y", "z"][c]));
                }
            }
            fields.push(scaled);
        }
        fields
    }

    /// Powers of the length that belong to the fields, applied to forces on them.
    fn scale_by_order(&mut self, force: Vec<Vector>) -> Vec<Vector> {
        let mut scaled = Vec::new();
        for (field, force) in self.declared.clone().into_iter().zip(force) {
            let scale = self.length_power(length_power(field));
            scaled.push(self.graph.scale(scale, &force));
        }
        scaled
    }

    /// Blocks on fields projected on relative vectors.
    fn project(&mut self, blocks: &Blocks, shape: &impl Fn(usize, usize) -> Id, symmetric: bool) -> Blocks {
        let (count, dimension) = (self.vectors.len(), self.variant.dimension);
        let fields = self.declared.len();
        let mut result = zero_blocks(&mut self.graph, count, dimension);
        for f in 0..fields {
            // half[j] = sum_g l^.. block(f, g) shape(g, j)
            let mut half = vec![vec![vec![self.graph.zero(); dimension]; dimension]; count];
            for g in 0..fields {
                let power = length_power(self.declared[f]) + length_power(self.declared[g]);
                let scale = self.length_power(power);
                for r in 0..dimension {
                    for c in 0..dimension {
                        let entry = self.graph.multiply(scale, blocks[f][g][r][c]);
                        for j in 0..count {
                            let term = self.graph.multiply(shape(g, j), entry);
                            half[j][r][c] = self.graph.add(half[j][r][c], term);
                        }
                    }
                }
            }
            for i in 0..count {
                for j in if symmetric { i } else { 0 }..count {
                    for r in 0..dimension {
                        for c in if symmetric && i == j { r } else { 0 }..dimension {
                            let term = self.graph.multiply(shape(f, i), half[j][r][c]);
                            result[i][j][r][c] = self.graph.add(result[i][j][r][c], term);
                        }
                    }
                }
            }
        }
        if symmetric {
            mirror(&mut result);
        }
        result
    }

    /// Adds a point: directly where unrolled, as a sum over the loop otherwise.
    fn add_point(&mut self, point: Contribution) {
        let graph = &mut self.graph;
        let mut loops = self.points.as_mut();
        let mut seen: HashMap<Id, Id> = HashMap::new();
        let mut add = |graph: &mut Graph, sum: Id, term: Id, name: String| match loops.as_mut() {
            None => graph.add(sum, term),
            Some(_) if graph.is_zero(term) => sum,
            Some(points) => *seen.entry(term).or_insert_with(|| {
                let symbol = graph.symbol(name);
                points.sums.push((symbol, term));
                symbol
            }),
        };
        if matches!(self.quantity, Quantity::Energy) {
            self.energy = add(graph, self.energy, point.energy, "energy_sum".to_string());
        }
        for (i, vector) in point.force.iter().enumerate() {
            for (c, &term) in vector.iter().enumerate() {
                self.force[i][c] = add(graph, self.force[i][c], term, format!("force_{i}_{c}"));
            }
        }
        let mut add_blocks = |graph: &mut Graph, sums: &mut Blocks, blocks: &Blocks, name: &str| {
            for (i, row) in blocks.iter().enumerate() {
                for (j, block) in row.iter().enumerate() {
                    for (r, line) in block.iter().enumerate() {
                        for (c, &term) in line.iter().enumerate() {
                            let name = format!("{name}_{i}{j}_{r}{c}");
                            sums[i][j][r][c] = add(graph, sums[i][j][r][c], term, name);
                        }
                    }
                }
            }
        };
        add_blocks(graph, &mut self.stiffness, &point.stiffness, "stiffness");
        if let (Some(sums), Some(blocks)) = (&mut self.viscosity, &point.viscosity) {
            add_blocks(graph, sums, blocks, "damping");
        }
    }
}
