//! The strain energy of an element as its declaration writes it: definitions and terms, each where it applies.

use std::collections::HashMap;

use super::element::{Density, Invariants, Term};
use crate::model::{Binary, ElementQuantity, Expr, fold};
use crate::symbolic::{Graph, Id};
use crate::tensors::Sampling;

/// Where a statement applies: the plane or space, values of options; empty: everywhere.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct When {
    /// 2 or 3.
    pub dimension: Option<usize>,
    /// Places of options and their values.
    pub options: Vec<(usize, usize)>,
}

impl When {
    /// Whether both apply with some values of the options.
    pub fn overlaps(&self, other: &When) -> bool {
        let is_any_space = self.dimension.is_none() || other.dimension.is_none();
        let excludes = |&(place, value): &(usize, usize)| {
            let others = other.options.iter();
            others.clone().any(|one| one.0 == place) && !others.clone().any(|&one| one == (place, value))
        };
        (is_any_space || self.dimension == other.dimension) && !self.options.iter().any(excludes)
    }

    /// Whether it applies with these values of the options.
    pub fn applies(&self, dimension: usize, options: &[usize]) -> bool {
        self.dimension.is_none_or(|own| own == dimension)
            && self
                .options
                .iter()
                .all(|&(at, value)| options.get(at).copied().unwrap_or(0) == value)
    }
}

/// `strain name = value;` or `let name = value;`
#[derive(Clone, Debug)]
pub struct Definition {
    /// Number of the name.
    pub name: usize,
    /// Whether its value in the stress-free shape is subtracted.
    pub is_strain: bool,
    /// Where it applies.
    pub when: When,
    /// Of the inner products of the fields, coefficients and names.
    pub value: Expr,
}

/// What damps a part of the energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nature {
    /// The damping of the body.
    Damped,
    /// Nothing.
    Undamped,
    /// It is no energy: the stress is the rate of its strain, where the body is damped.
    Viscous,
}

/// `energy name = coefficient * density;`
#[derive(Clone, Debug)]
pub struct WrittenTerm {
    /// Name for documentation.
    pub name: &'static str,
    /// Where it applies.
    pub when: When,
    /// The coefficient that is a factor; empty: none is.
    pub coefficient: &'static str,
    /// The rest.
    pub density: Expr,
    /// Derivative of the density with respect to its strain, where it is written.
    pub stress: Option<Expr>,
    /// Where it is integrated, if it says so.
    pub points: Option<Sampling>,
    /// What damps it.
    pub nature: Nature,
}

/// The energy of a declaration.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// Places of the fields of space among those of the plane.
    pub in_plane: Vec<Option<usize>>,
    /// Definitions in order; of a name that is defined where it does not apply the others are looked at.
    pub definitions: Vec<Definition>,
    /// Terms in order.
    pub terms: Vec<WrittenTerm>,
}

/// A term where it applies, as expressions of the inner products and of the changes of its strains.
pub struct Built {
    /// Place among the terms.
    pub term: usize,
    /// The density.
    pub density: Id,
    /// Its stress, where it is written.
    pub stress: Option<Id>,
    /// Strains that it depends on: numbers of their names, symbols of their changes, measures.
    pub strains: Vec<(usize, Id, Id)>,
}

impl Written {
    /// The terms of the energy.
    pub fn terms(&self, graph: &mut Graph, fields: &Invariants, options: &[usize]) -> Vec<Term> {
        let built = self.built(graph, fields, options);
        built.into_iter().map(|built| self.term(graph, built)).collect()
    }

    /// Terms where they apply; those of fields that the plane does not have are left out.
    pub fn built(&self, graph: &mut Graph, fields: &Invariants, options: &[usize]) -> Vec<Built> {
        let mut scope = Scope {
            written: self,
            fields,
            options,
            changes: HashMap::new(),
            is_measure: false,
        };
        // What is named is made in the order of the names.
        for definition in self.definitions.iter().filter(|one| !one.is_strain) {
            if definition.when.applies(fields.dimension, options) {
                scope.value(graph, &definition.value);
            }
        }
        let mut list = Vec::new();
        for (at, term) in self.terms.iter().enumerate() {
            if !term.when.applies(fields.dimension, options) {
                continue;
            }
            let stress = term.stress.as_ref().map(|stress| scope.value(graph, stress));
            let (Some(density), false) = (scope.value(graph, &term.density), stress == Some(None)) else {
                continue;
            };
            let reached = graph.reachable(&[density]);
            let is_in = |symbol: &Id| reached.contains(symbol);
            let mut strains: Vec<(usize, Id, Id)> = scope
                .changes
                .iter()
                .map(|(&name, &(symbol, measure))| (name, symbol, measure))
                .filter(|(_, symbol, _)| is_in(symbol))
                .collect();
            strains.sort_by_key(|&(name, ..)| name);
            list.push(Built {
                term: at,
                density,
                stress: stress.flatten(),
                strains,
            });
        }
        list
    }

    /// With `1/2 e^2` of a strain a measure, with another function of it a law, without any an energy.
    fn term(&self, graph: &mut Graph, built: Built) -> Term {
        let declared = &self.terms[built.term];
        let density = match built.strains.first() {
            None => Density::Energy(built.density),
            Some(&(_, change, measure)) => {
                let (half, square) = (graph.number(0.5), graph.power(change, 2));
                if built.stress.is_none() && built.density == graph.multiply(half, square) {
                    match declared.nature {
                        Nature::Damped => Density::Measure(measure),
                        Nature::Undamped => Density::Undamped(measure),
                        Nature::Viscous => Density::Viscous(measure),
                    }
                } else {
                    let stress = built.stress.unwrap_or_else(|| graph.partial(built.density, change));
                    Density::Law {
                        measure,
                        change,
                        energy: built.density,
                        stress,
                    }
                }
            }
        };
        Term {
            name: declared.name,
            coefficient: declared.coefficient,
            density,
            points: declared.points,
        }
    }
}

impl Written {
    /// Whether an expression is free of strains, or a sum of them with factors that do not change, beside other things.
    pub fn is_linear_in_strains(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Element(ElementQuantity::Named(name)) => self
                .definitions_of(*name)
                .all(|one| one.is_strain || self.is_linear_in_strains(&one.value)),
            Expr::Negate(a) => self.is_linear_in_strains(a),
            Expr::Binary(Binary::Add | Binary::Subtract, a, b) => {
                self.is_linear_in_strains(a) && self.is_linear_in_strains(b)
            }
            Expr::Binary(Binary::Multiply, a, b) if !self.moves(a) => self.is_linear_in_strains(b),
            Expr::Binary(Binary::Multiply | Binary::Divide, a, b) if !self.moves(b) => self.is_linear_in_strains(a),
            _ => !self.has_strains(expr),
        }
    }

    fn has_strains(&self, expr: &Expr) -> bool {
        expr.contains(&|part| {
            matches!(part, Expr::Element(ElementQuantity::Named(name))
                if self.definitions_of(*name).any(|one| one.is_strain || self.has_strains(&one.value)))
        })
    }

    /// Whether an expression changes with the fields, as a strain does.
    fn moves(&self, expr: &Expr) -> bool {
        expr.contains(&|part| match part {
            Expr::Element(ElementQuantity::Dot(..) | ElementQuantity::Cross(..)) => true,
            Expr::Element(ElementQuantity::Named(name)) => self.definitions_of(*name).any(|one| self.moves(&one.value)),
            _ => false,
        })
    }

    fn definitions_of(&self, name: usize) -> impl Iterator<Item = &Definition> {
        self.definitions.iter().filter(move |one| one.name == name)
    }
}

/// A moderate whole number.
fn whole(expr: &Expr) -> Option<i32> {
    let value = fold::constant(expr)?;
    (value.trunc() == value && value.abs() <= 64.0).then_some(value as i32)
}

/// What names mean for the chosen options.
struct Scope<'w> {
    written: &'w Written,
    fields: &'w Invariants,
    options: &'w [usize],
    /// Symbols of the changes of strains, and the measures themselves.
    changes: HashMap<usize, (Id, Id)>,
    /// Whether this is the measure of a strain: what it has of others counts from zero, too.
    is_measure: bool,
}

impl Scope<'_> {
    fn place(&self, field: usize) -> Option<usize> {
        match self.fields.dimension {
            2 => self.written.in_plane.get(field).copied().flatten(),
            _ => Some(field),
        }
    }

    /// The value of an expression; `None` where it has none in this space.
    fn value(&mut self, graph: &mut Graph, expr: &Expr) -> Option<Id> {
        // Constants become one node each: what is made first stands first in products.
        if let Some(constant) = fold::constant(expr) {
            return Some(graph.number(constant));
        }
        Some(match expr {
            Expr::Element(quantity) => self.quantity(graph, *quantity)?,
            Expr::Negate(a) => {
                let a = self.value(graph, a)?;
                graph.negate(a)
            }
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.value(graph, a)?, self.value(graph, b)?);
                match operator {
                    Binary::Add => graph.add(a, b),
                    Binary::Subtract => graph.subtract(a, b),
                    Binary::Multiply => graph.multiply(a, b),
                    Binary::Divide => graph.divide(a, b),
                }
            }
            Expr::Power(base, exponent) if whole(exponent).is_some() => {
                let base = self.value(graph, base)?;
                graph.power(base, whole(exponent)?)
            }
            Expr::Power(base, exponent) => {
                let (base, exponent) = (self.value(graph, base)?, self.value(graph, exponent)?);
                graph.general_power(base, exponent)
            }
            Expr::Call(function, arguments) => match arguments.as_slice() {
                [a] => {
                    let a = self.value(graph, a)?;
                    graph.call(*function, a)
                }
                [a, b] => {
                    let (a, b) = (self.value(graph, a)?, self.value(graph, b)?);
                    graph.call2(*function, a, b)
                }
                _ => return None,
            },
            // The check lets nothing else pass.
            _ => return None,
        })
    }

    fn quantity(&mut self, graph: &mut Graph, quantity: ElementQuantity) -> Option<Id> {
        match quantity {
            ElementQuantity::Dot(i, j) => Some(self.fields.dots[self.place(i)?][self.place(j)?]),
            ElementQuantity::Cross(i, j) => {
                let (i, j) = (self.place(i)?, self.place(j)?);
                (self.fields.dimension == 2).then(|| self.fields.crosses[i][j])
            }
            ElementQuantity::Coefficient(name) => Some(graph.input(name)),
            ElementQuantity::Named(name) => {
                if let Some(&(symbol, measure)) = self.changes.get(&name) {
                    return Some(if self.is_measure { measure } else { symbol });
                }
                let written = self.written;
                let definition = written.definitions.iter().find(|definition| {
                    definition.name == name && definition.when.applies(self.fields.dimension, self.options)
                })?;
                if !definition.is_strain {
                    return self.value(graph, &definition.value);
                }
                let is_within = std::mem::replace(&mut self.is_measure, true);
                let value = self.value(graph, &definition.value);
                self.is_measure = is_within;
                let value = value?;
                let symbol = graph.symbol("change");
                self.changes.insert(name, (symbol, value));
                Some(if self.is_measure { value } else { symbol })
            }
        }
    }
}
