//! Elastic kernels as constant tensors (Eq. 7).

use super::builder::{Builder, State};
use super::conserving::averaged_value;
use crate::lower::form::Quantity;
use crate::lower::invariants::Response;
use crate::lower::quadratic::{TensorTerm, tensor_terms};
use crate::symbolic::{Array, Id, Invariant, invariants};

/// What the tensors are multiplied with, one entry for each invariant that occurs.
struct Strains {
    /// The inner products themselves: densities without a reference.
    plain: Vec<Id>,
    /// Their change from the stress-free shape.
    changes: Vec<Id>,
    /// The change plus damping times its rate.
    damped: Vec<Id>,
}

impl Builder<'_> {
    /// Builds the kernel; `None` where the energy is not quadratic in the inner products.
    pub(super) fn tensor(&mut self) -> Option<()> {
        let variant = self.variant;
        let terms = tensor_terms(self.element, variant.dimension, &variant.options, variant.quadrature)?;
        // A tensor knows references of measures alone.
        if variant.curved && terms.iter().any(|term| !term.is_measure) {
            return None;
        }
        let all = invariants(self.vectors.len(), variant.dimension);
        let occurs = |&a: &usize| {
            terms
                .iter()
                .any(|term| term.tensor[a].iter().any(|&value| value != 0.0))
        };
        let used: Vec<usize> = (0..all.len()).filter(occurs).collect();
        let list: Vec<Invariant> = used.iter().map(|&a| all[a]).collect();
        if self.quantity == Quantity::Reference {
            self.references = list
                .iter()
                .map(|invariant| invariant.value(&mut self.graph, &self.vectors))
                .collect();
            return Some(());
        }
        let strains = self.strains(&list);
        let mut state = self.unstressed(list);
        for term in &terms {
            self.add_tensor_term(term, &used, &strains, &mut state);
        }
        let names = self.relative_names();
        self.arrays = terms.iter().map(|term| self.array(term, &all, &names)).collect();
        for (invariant, &stress) in state.invariants.iter().zip(&state.stress) {
            self.graph.name(stress, format!("stress_{}", invariant.name(&names)));
        }
        self.energy = state.energy;
        let response = Response {
            invariants: &state.invariants,
            stress: &state.stress,
            stiffness: &state.stiffness,
            viscosity: &state.viscosity,
            vectors: &self.vectors,
            rates: &self.rates,
        };
        match self.quantity {
            Quantity::Force => self.force = response.force(&mut self.graph),
            Quantity::Tangent => {
                (self.stiffness, self.viscosity) = match &self.averaged {
                    Some([_, end]) => (response.averaged_tangent(&mut self.graph, end), None),
                    None => response.tangent(&mut self.graph),
                }
            }
            Quantity::Energy | Quantity::Reference => {}
        }
        Some(())
    }

    /// The tensor of a term on the invariants that occur in it.
    fn array(&self, term: &TensorTerm, all: &[Invariant], names: &[String]) -> Array {
        let occurs = |&a: &usize| term.tensor[a].iter().any(|&value| value != 0.0);
        let used: Vec<usize> = (0..all.len()).filter(occurs).collect();
        let columns: Vec<String> = used.iter().map(|&a| all[a].name(names)).collect();
        let scale = match term.coefficient {
            "" => String::new(),
            coefficient => format!("{coefficient} "),
        };
        let length = match term.power {
            0 => String::new(),
            1 => "length ".to_string(),
            power => format!("length^{power} "),
        };
        let change = if term.is_measure {
            "(I_A - I0_A) (I_B - I0_B)"
        } else {
            "I_A I_B"
        };
        Array {
            name: format!("{}_{}", self.variant.name(self.library), term.name.replace(' ', "_")).to_uppercase(),
            doc: vec![
                format!(
                    "Tensor T_AB of the unit element in `{}`: U = 1/2 {scale}{length}T_AB {change}.",
                    term.name
                ),
                format!("Rows and columns: {}.", columns.join(", ")),
            ],
            rows: used
                .iter()
                .map(|&a| used.iter().map(|&b| term.tensor[a][b]).collect())
                .collect(),
        }
    }

    fn strains(&mut self, list: &[Invariant]) -> Strains {
        let (names, lengths) = (self.relative_names(), self.relative_lengths());
        let mut strains = Strains {
            plain: Vec::new(),
            changes: Vec::new(),
            damped: Vec::new(),
        };
        for (place, invariant) in list.iter().enumerate() {
            let value = averaged_value(*invariant, &mut self.graph, &self.vectors, self.averaged.as_ref());
            self.graph.name(value, invariant.name(&names));
            let curved = self.variant.curved;
            let reference = if curved {
                self.reference_symbol(place)
            } else {
                self.graph
                    .number(invariant.straight() * lengths[invariant.i] * lengths[invariant.j])
            };
            let change = self.graph.subtract(value, reference);
            self.graph.name(change, format!("strain_{}", invariant.name(&names)));
            strains.plain.push(value);
            strains.changes.push(change);
            strains.damped.push(if self.rates.is_empty() {
                change
            } else {
                let rate = invariant.rate(&mut self.graph, &self.vectors, &self.rates);
                let viscous = self.graph.multiply(self.damping, rate);
                self.graph.add(change, viscous)
            });
        }
        strains
    }

    fn unstressed(&mut self, invariants: Vec<Invariant>) -> State {
        let (count, zero) = (invariants.len(), self.graph.zero());
        State {
            invariants,
            stress: vec![zero; count],
            stiffness: vec![vec![zero; count]; count],
            viscosity: if self.rates.is_empty() {
                Vec::new()
            } else {
                vec![vec![zero; count]; count]
            },
            energy: zero,
        }
    }

    /// Adds `scale T_AB` to the stiffness, its product with the strains to the stress, and
    /// `1/2 scale T_AB I_A I_B` to the energy.
    fn add_tensor_term(&mut self, term: &TensorTerm, used: &[usize], strains: &Strains, state: &mut State) {
        let power = self.length_power(term.power);
        let graph = &mut self.graph;
        let scale = graph.multiply(self.coefficients[term.coefficient], power);
        let half = graph.number(0.5);
        let half_scale = graph.multiply(half, scale);
        let (inputs, elastic) = if term.is_measure {
            (&strains.damped, &strains.changes)
        } else {
            (&strains.plain, &strains.plain)
        };
        for (row, &a) in used.iter().enumerate() {
            let numbers: Vec<Id> = used.iter().map(|&b| graph.number(term.tensor[a][b])).collect();
            let sum = graph.dot(&numbers, inputs);
            let stress = graph.multiply(scale, sum);
            state.stress[row] = graph.add(state.stress[row], stress);
            let sum = graph.dot(&numbers, elastic);
            let product = graph.multiply(sum, elastic[row]);
            let energy = graph.multiply(half_scale, product);
            state.energy = graph.add(state.energy, energy);
            for (column, &number) in numbers.iter().enumerate() {
                let entry = graph.multiply(scale, number);
                state.stiffness[row][column] = graph.add(state.stiffness[row][column], entry);
                if term.is_measure && !self.rates.is_empty() {
                    let viscous = graph.multiply(self.damping, entry);
                    state.viscosity[row][column] = graph.add(state.viscosity[row][column], viscous);
                }
            }
        }
    }
}
