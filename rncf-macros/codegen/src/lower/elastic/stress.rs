//! Stress at an integration point: the energy density is differentiated with respect to symbols for
//! the invariants of the fields, then the symbols are replaced by what they stand for.

use std::collections::HashMap;

use super::builder::{Builder, State, kept_at_point};
use super::conserving::averaged_value;
use crate::elements::{Density, Term, at_rest, field_invariants};
use crate::lower::form::{Form, Quantity, points};
use crate::symbolic::Invariant;
use crate::symbolic::{Graph, Id, linear::Vector};

/// Symbols of a point and what they stand for.
struct Symbols {
    invariants: Vec<Invariant>,
    values: Vec<Id>,
    /// Rates of the invariants.
    rates: Vec<Id>,
    /// What values and rates are at the point.
    real: HashMap<Id, Id>,
    /// What values are in a straight, unstretched shape.
    straight: HashMap<Id, Id>,
    is_damped: bool,
}

/// Stress on every invariant and energy, as expressions of the symbols.
struct Response {
    stress: Vec<Id>,
    energy: Id,
}

impl Symbols {
    /// Rate of a measure, an expression of the values.
    fn rate(&self, graph: &mut Graph, measure: Id) -> Id {
        let chain = self.values.iter().copied().zip(self.rates.iter().copied()).collect();
        graph.differentiate(measure, &chain)
    }

    /// Inner products that count from their references: what stands for them in an energy of those of a straight shape.
    fn shifted(&self, graph: &mut Graph, products: &[Id], references: &[Id]) -> HashMap<Id, Id> {
        let pairs = products.iter().zip(references);
        let shifted = pairs.map(|(&product, &reference)| {
            let change = graph.subtract(product, reference);
            (product, graph.add(change, self.straight[&product]))
        });
        shifted.collect()
    }
}

impl Response {
    /// Adds `factor d(of)/dI`.
    fn add_stress(&mut self, graph: &mut Graph, symbols: &Symbols, of: Id, factor: Id) {
        for (stress, &symbol) in self.stress.iter_mut().zip(&symbols.values) {
            let slope = graph.partial(of, symbol);
            let part = graph.multiply(factor, slope);
            *stress = graph.add(*stress, part);
        }
    }
}

impl Builder<'_> {
    /// Stress on the invariants of the fields, times the weight.
    pub(super) fn field_state(&mut self, fields: &[Vector], rates: &[Vector], weight: Id) -> State {
        let (mut symbols, mut terms) = self.point_symbols(fields, rates);
        let default = points(self.element, self.variant.quadrature);
        terms.retain(|term| term.points.unwrap_or(default) == self.rule);
        let slots = self.bind_coefficients(&mut symbols, &terms);
        if self.quantity == Quantity::Reference {
            self.add_references(&symbols, &terms);
        }
        let zero = self.graph.zero();
        let mut response = Response {
            stress: vec![zero; symbols.values.len()],
            energy: zero,
        };
        let has_references = self.variant.curved && self.quantity != Quantity::Reference;
        let mut index = 0;
        for term in &terms {
            let factor = self.graph.multiply(self.coefficients[term.coefficient], weight);
            let counted = term.density.counted(&self.graph, &symbols.values);
            match term.density {
                Density::Viscous(measure) => self.add_viscous(&symbols, measure, factor, &mut response),
                Density::Measure(measure) | Density::Undamped(measure) | Density::Law { measure, .. } => {
                    let reference = if has_references {
                        self.point_reference(slots, index)
                    } else {
                        self.graph.substitute(measure, &symbols.straight)
                    };
                    self.add_measure(&symbols, (term.density, measure), reference, factor, &mut response);
                }
                Density::Energy(mut density) => {
                    if has_references {
                        let references: Vec<Id> = (index..index + counted.len())
                            .map(|index| self.point_reference(slots, index))
                            .collect();
                        let shifted = symbols.shifted(&mut self.graph, &counted, &references);
                        density = self.graph.substitute(density, &shifted);
                    }
                    self.add_energy(&symbols, density, factor, &mut response);
                }
            }
            index += counted.len();
        }
        self.passed += slots;
        self.replace(&symbols, &response)
    }

    fn point_symbols(&mut self, fields: &[Vector], rates: &[Vector]) -> (Symbols, Vec<Term>) {
        let (element, graph) = (self.element, &mut self.graph);
        let (declared, list) = field_invariants(graph, element, self.variant.dimension);
        let terms = (element.energy)(graph, &declared, &self.variant.options);
        let mut symbols = Symbols {
            invariants: list.iter().map(|&(invariant, _)| invariant).collect(),
            values: list.iter().map(|&(_, symbol)| symbol).collect(),
            rates: list.iter().map(|_| graph.symbol("rate")).collect(),
            real: HashMap::new(),
            straight: HashMap::new(),
            is_damped: !rates.is_empty(),
        };
        for (place, &(invariant, symbol)) in list.iter().enumerate() {
            let value = averaged_value(invariant, graph, fields, self.averaged.as_ref());
            symbols.real.insert(symbol, value);
            if symbols.is_damped {
                symbols
                    .real
                    .insert(symbols.rates[place], invariant.rate(graph, fields, rates));
            }
            let value = at_rest(invariant, &self.declared);
            symbols.straight.insert(symbol, graph.number(value));
        }
        (symbols, terms)
    }

    /// Lets coefficients that vary stand for what an element keeps of them, behind the values of the measures at a point; how
    /// many numbers it keeps there.
    fn bind_coefficients(&mut self, symbols: &mut Symbols, terms: &[Term]) -> usize {
        let [measures, count] = kept_at_point((self.variant, self.library), terms, &self.graph, &symbols.values);
        let coefficients = self.variant.varying_coefficients(self.library);
        let slots = measures + count;
        for (place, coefficient) in coefficients.iter().enumerate() {
            let kept = if self.quantity == Quantity::Reference {
                self.graph
                    .symbol(format!("reference[{}]", self.passed + measures + place))
            } else {
                self.point_reference(slots, measures + place)
            };
            let symbol = self.coefficients[coefficient.name];
            symbols.real.insert(symbol, kept);
            symbols.straight.insert(symbol, kept);
        }
        slots
    }

    /// Values of the measures at the point: what the other kernels subtract.
    fn add_references(&mut self, symbols: &Symbols, terms: &[Term]) {
        for term in terms {
            for counted in term.density.counted(&self.graph, &symbols.values) {
                let value = self.graph.substitute(counted, &symbols.real);
                self.references.push(value);
            }
        }
        // What is kept of coefficients is there already.
        for coefficient in self.variant.varying_coefficients(self.library) {
            let kept = symbols.real[&self.coefficients[coefficient.name]];
            self.references.push(kept);
        }
    }

    /// Reference value of measure `index` at a point.
    fn point_reference(&mut self, slots: usize, index: usize) -> Id {
        if self.form != Form::Loop {
            return self.reference_symbol(self.passed + index);
        }
        while self.references.len() <= index {
            let next = self.references.len();
            let symbol = self.graph.symbol(format!("reference[point * {slots} + {next}]"));
            self.references.push(symbol);
        }
        self.references[index]
    }

    /// `1/2 factor (s - s0)^2`, with the stress `factor (s - s0 + c s') ds/dI`, or energy and stress of a law.
    fn add_measure(
        &mut self,
        symbols: &Symbols,
        (density, measure): (Density, Id),
        reference: Id,
        factor: Id,
        response: &mut Response,
    ) {
        let graph = &mut self.graph;
        let change = graph.subtract(measure, reference);
        let rate = symbols.is_damped.then(|| [symbols.rate(graph, measure), self.damping]);
        let strain = density.stress(graph, change, rate);
        let scaled = graph.multiply(factor, strain);
        response.add_stress(graph, symbols, measure, scaled);
        let part = density.energy(graph, change, factor);
        response.energy = graph.add(response.energy, part);
    }

    /// Stress `factor s' ds/dI` of the rate of a measure.
    fn add_viscous(&mut self, symbols: &Symbols, measure: Id, factor: Id, response: &mut Response) {
        if !symbols.is_damped {
            return;
        }
        let graph = &mut self.graph;
        let rate = symbols.rate(graph, measure);
        let scaled = graph.multiply(factor, rate);
        response.add_stress(graph, symbols, measure, scaled);
    }

    fn add_energy(&mut self, symbols: &Symbols, density: Id, factor: Id, response: &mut Response) {
        let graph = &mut self.graph;
        response.add_stress(graph, symbols, density, factor);
        let part = graph.multiply(factor, density);
        response.energy = graph.add(response.energy, part);
    }

    /// Derivatives of the stress, and everything with the symbols replaced; invariants without
    /// stress are dropped.
    fn replace(&mut self, symbols: &Symbols, response: &Response) -> State {
        let used: Vec<usize> = (0..response.stress.len())
            .filter(|&index| !self.graph.is_zero(response.stress[index]))
            .collect();
        let matrix = |builder: &mut Self, with: &[Id]| -> Vec<Vec<Id>> {
            let entry = |builder: &mut Self, row: usize, column: usize| {
                let derivative = builder.graph.partial(response.stress[row], with[column]);
                builder.graph.substitute(derivative, &symbols.real)
            };
            used.iter()
                .map(|&row| used.iter().map(|&column| entry(builder, row, column)).collect())
                .collect()
        };
        let stiffness = matrix(self, &symbols.values);
        let viscosity = if symbols.is_damped {
            matrix(self, &symbols.rates)
        } else {
            Vec::new()
        };
        let mut real = |id: Id| self.graph.substitute(id, &symbols.real);
        State {
            invariants: used.iter().map(|&index| symbols.invariants[index]).collect(),
            stress: used.iter().map(|&index| real(response.stress[index])).collect(),
            stiffness,
            viscosity,
            energy: real(response.energy),
        }
    }
}
