//! Arrays of constants that generated code reads by name: a reader finds the tensors of the unit element in one place.

use std::collections::HashMap;

use super::graph::{Array, Graph, Id};

impl Graph {
    /// Has the numbers that the roots depend on and that are entries of these arrays read from there. What is equal bit by bit reads the
    /// first entry. Literals stay: whole and half numbers, the given `others`, and what is in two arrays, as these have other reasons, too.
    /// Arrays that nothing reads are left out.
    pub fn read_from(&mut self, roots: impl Iterator<Item = Id>, mut arrays: Vec<Array>, others: &[f64]) {
        let mut places: HashMap<u64, (usize, String)> = HashMap::new();
        let mut ambiguous = Vec::new();
        for (which, array) in arrays.iter().enumerate() {
            for (i, row) in array.rows.iter().enumerate() {
                for (j, &value) in row.iter().enumerate() {
                    let place = || (which, format!("{}[{i}][{j}]", array.name));
                    let (first, _) = places.entry(value.to_bits()).or_insert_with(place);
                    if *first != which {
                        ambiguous.push(value.to_bits());
                    }
                }
            }
        }
        let roots: Vec<Id> = roots.collect();
        let mut read = vec![false; arrays.len()];
        for id in self.reachable(&roots) {
            let Some(value) = self.value(id) else { continue };
            let has_other_reasons = (2.0 * value).fract() == 0.0 || others.contains(&value);
            if !has_other_reasons
                && !ambiguous.contains(&value.to_bits())
                && let Some((which, place)) = places.get(&value.to_bits())
            {
                read[*which] = true;
                self.places_of_numbers.insert(id, place.clone());
            }
        }
        let mut read = read.into_iter();
        arrays.retain(|_| read.next() == Some(true));
        self.arrays = arrays;
    }

    /// Where generated code reads a number; `None` if it is a literal.
    pub fn place_of(&self, number: Id) -> Option<&str> {
        self.places_of_numbers.get(&number).map(String::as_str)
    }

    /// The arrays that generated code reads.
    pub fn arrays(&self) -> &[Array] {
        &self.arrays
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_entries_read_the_first_and_ambiguous_ones_stay_literals() {
        let mut g = Graph::new();
        let [third, seventh, half, fifth] = [1.0 / 3.0, 1.0 / 7.0, 0.5, 0.2].map(|value| g.number(value));
        let array = |name: &str, rows: &[[f64; 2]]| Array {
            name: name.into(),
            doc: Vec::new(),
            rows: rows.iter().map(|row| row.to_vec()).collect(),
        };
        let first = array("A", &[[0.5, 1.0 / 3.0], [1.0 / 3.0, 1.0 / 7.0]]);
        let second = array("B", &[[1.0 / 7.0, 0.2], [0.2, 1.0]]);
        g.read_from([third, seventh, half, fifth].into_iter(), vec![first, second], &[0.2]);
        assert_eq!(g.place_of(third), Some("A[0][1]"));
        for literal in [seventh, half, fifth] {
            assert_eq!(g.place_of(literal), None);
        }
        assert_eq!(g.arrays().len(), 1, "nothing reads B");
    }
}
