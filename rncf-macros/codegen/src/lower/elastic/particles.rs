//! Elastic kernels of a material that is given by its energy W(E) (THEORY 4.2): one straight-line kernel of
//! the fields at a particle (Y, Z) of the section, summed over section and axis by loops.
//!
//! With the gradient `G = [a + Y b' + Z c', b, c]` the strain is `E = 1/2 (G^T G - G0^T G0)` on the axes of the
//! section, G0 that of the stress-free shape; `sigma = dW/dE`, damped `sigma + s (d2W/dE2) : E'`.

use super::fields::{Groups, Point};
use super::{Builder, Quantity};
use crate::elements::Interpolant;
use crate::lower::invariants::{Blocks, Invariant, Response, invariants, zero_blocks};
use crate::lower::quadratic::length_power;
use crate::lower::signature::{PointInputs, Signature};
use crate::symbolic::{Id, linear::Vector};

/// What a particle adds, on the fields.
pub(super) struct OnFields {
    pub energy: Id,
    pub force: Vec<Vector>,
    pub stiffness: Blocks,
    pub viscosity: Option<Blocks>,
}

/// Component of the strain, in the order of the energy's symbols, of two columns of G.
fn component(i: usize, j: usize) -> usize {
    match (i, j) {
        (0, 1) => 3,
        (0, 2) => 4,
        (1, 2) => 5,
        _ => i,
    }
}

impl Builder<'_> {
    /// The kernel of one quantity at a particle.
    pub(super) fn particle(mut self, groups: &Groups) -> Point {
        let density = self.density.take().expect("a variant with a material");
        let columns = self.columns("");
        let rates = if self.rates.is_empty() {
            Vec::new()
        } else {
            self.columns("v_")
        };
        let before = if self.variant.curved {
            self.columns("o_")
        } else {
            Vec::new()
        };
        let list: Vec<Invariant> = invariants(columns.len(), self.variant.dimension)
            .into_iter()
            .filter(|it| it.product == crate::lower::invariants::Product::Dot)
            .collect();
        let components: Vec<usize> = list.iter().map(|it| component(it.i, it.j)).collect();
        let half = self.graph.number(0.5);
        // What the symbols of strains and rates stand for; strains out of a plane are zero.
        let zero = self.graph.zero();
        let mut real: std::collections::HashMap<Id, Id> = density.strains.map(|strain| (strain, zero)).into();
        let mut along_rates = std::collections::HashMap::new();
        for (it, &k) in list.iter().zip(&components) {
            let value = it.value(&mut self.graph, &columns);
            let rest = if self.variant.curved {
                it.value(&mut self.graph, &before)
            } else {
                self.graph.number(it.orthonormal(it.i == it.j))
            };
            let change = self.graph.subtract(value, rest);
            let strain = self.graph.multiply(half, change);
            real.insert(density.strains[k], strain);
            if !rates.is_empty() {
                let symbol = self.graph.symbol(format!("rate[{k}]"));
                along_rates.insert(density.strains[k], symbol);
                let rate = it.rate(&mut self.graph, &columns, &rates);
                let rate = self.graph.multiply(half, rate);
                real.insert(symbol, rate);
            }
        }
        // S_A = 1/2 (sigma + s D : E'), in the symbols.
        let (weight, length) = (self.graph.symbol("weight"), self.length);
        let weight = self.graph.multiply(weight, length);
        let half_weight = self.graph.multiply(half, weight);
        let mut stress = Vec::new();
        for &k in &components {
            let elastic = self.graph.partial(density.energy, density.strains[k]);
            let rate = self.graph.differentiate(elastic, &along_rates);
            let viscous = self.graph.multiply(self.damping, rate);
            let sum = self.graph.add(elastic, viscous);
            stress.push(self.graph.multiply(half_weight, sum));
        }
        let mut matrix = |with: &dyn Fn(usize) -> Option<Id>| -> Vec<Vec<Id>> {
            let mut rows = Vec::new();
            for &of in &stress {
                let mut row = Vec::new();
                for &k in &components {
                    let slope = match with(k) {
                        Some(symbol) => self.graph.partial(of, symbol),
                        None => self.graph.zero(),
                    };
                    let slope = self.graph.multiply(half, slope);
                    row.push(self.graph.substitute(slope, &real));
                }
                rows.push(row);
            }
            rows
        };
        let stiffness = matrix(&|k| Some(density.strains[k]));
        let viscosity = if rates.is_empty() {
            Vec::new()
        } else {
            matrix(&|k| along_rates.get(&density.strains[k]).copied())
        };
        let stress: Vec<Id> = stress.iter().map(|&id| self.graph.substitute(id, &real)).collect();
        let energy = self.graph.substitute(density.energy, &real);
        let energy = self.graph.multiply(weight, energy);
        let response = Response {
            invariants: &list,
            stress: &stress,
            stiffness: &stiffness,
            viscosity: &viscosity,
            vectors: &columns,
            rates: &rates,
        };
        let on_fields = self.on_fields(energy, &response);
        self.particle_kernel(groups, &on_fields)
    }

    /// Column of G that a field is in, and with which factor.
    fn place(&mut self, field: usize) -> (usize, Id) {
        let declared = self.declared[field];
        let power = self.length_power(length_power(declared));
        match (declared.of, declared.order) {
            (Interpolant::Position, _) => (0, power),
            (Interpolant::SectionY, 0) => (1, power),
            (Interpolant::SectionZ, 0) => (2, power),
            (Interpolant::SectionY, _) => {
                let y = self.particle_y;
                (0, self.graph.multiply(y, power))
            }
            (Interpolant::SectionZ, _) => {
                let z = self.particle_z;
                (0, self.graph.multiply(z, power))
            }
        }
    }

    /// Columns of G, or of its rate or its value in the stress-free shape.
    fn columns(&mut self, prefix: &str) -> Vec<Vector> {
        let dimension = self.variant.dimension;
        let mut columns = vec![vec![self.graph.zero(); dimension]; dimension];
        for field in 0..self.declared.len() {
            let (column, factor) = self.place(field);
            for c in 0..dimension {
                let symbol = self.graph.symbol(self.input_name(prefix, field, c));
                let part = self.graph.multiply(factor, symbol);
                columns[column][c] = self.graph.add(columns[column][c], part);
            }
        }
        columns
    }

    fn on_fields(&mut self, energy: Id, response: &Response) -> OnFields {
        let (count, dimension) = (self.declared.len(), self.variant.dimension);
        let places: Vec<(usize, Id)> = (0..count).map(|field| self.place(field)).collect();
        let mut result = OnFields {
            energy,
            force: Vec::new(),
            stiffness: Vec::new(),
            viscosity: None,
        };
        match self.quantity {
            Quantity::Energy | Quantity::Reference => {}
            Quantity::Force => {
                let force = response.force(&mut self.graph);
                let forces = places
                    .iter()
                    .map(|&(column, factor)| self.graph.scale(factor, &force[column]));
                result.force = forces.collect();
            }
            Quantity::Tangent => {
                let (stiffness, viscosity) = response.combined_tangent(&mut self.graph);
                let mut spread = |blocks: &Blocks| {
                    let mut on_fields = zero_blocks(&mut self.graph, count, dimension);
                    for (f, &(i, left)) in places.iter().enumerate() {
                        for (g, &(j, right)) in places.iter().enumerate() {
                            let factor = self.graph.multiply(left, right);
                            for r in 0..dimension {
                                on_fields[f][g][r] = self.graph.scale(factor, &blocks[i][j][r]);
                            }
                        }
                    }
                    on_fields
                };
                result.stiffness = spread(&stiffness);
                result.viscosity = viscosity.map(|blocks| spread(&blocks));
            }
        }
        result
    }

    fn particle_kernel(mut self, groups: &Groups, on_fields: &OnFields) -> Point {
        let fields: Vec<usize> = (0..self.declared.len()).collect();
        let group_of: Vec<usize> = fields
            .iter()
            .map(|&field| groups.group(self.declared[field].of))
            .collect();
        let (outputs, stiffness, damping) = self.field_outputs(on_fields, &fields, (&group_of, groups.of.len()));
        let names: Vec<&str> = self.declared.iter().map(|field| field.name).collect();
        let inputs = ["", "v_"].map(|prefix| self.input_names(prefix, &fields));
        let before = self.input_names("o_", &fields).concat();
        let blocks = [&stiffness, &damping].map(|blocks| blocks.as_ref().map_or(0, |blocks| blocks.pairs.len()));
        let references = if self.variant.curved { before.len() } else { 0 };
        let signature = Signature {
            variant: self.variant,
            library: self.library,
            references,
        };
        let (points, quantity) = (self.rule, self.quantity);
        let [kernel, particle] = signature.particle(
            points,
            quantity,
            self.graph,
            outputs,
            &PointInputs {
                names,
                inputs,
                before,
                blocks,
            },
        );
        Point {
            kernel,
            particle: Some(particle),
            fields,
            groups: group_of,
            stiffness,
            damping,
            references,
        }
    }
}
