//! How far outputs are from a reference (THEORY 10, metric i): largest and rms difference over the rows of the history.

use crate::AnyModel;
use crate::app::results::history::History;

/// Difference of one column from that of a reference, in the SI unit of the output.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::app) struct ColumnError {
    /// Largest over the rows.
    pub max: f64,
    /// Root of the mean square over the rows.
    pub rms: f64,
}

/// Differences column by column. Both histories have the same rows and columns.
pub(in crate::app) fn errors(history: &History, reference: &History) -> Vec<ColumnError> {
    let rows = history.keys.len().max(1) as f64;
    let column = |index: usize| {
        let (mut max, mut sum) = (0.0_f64, 0.0);
        for (value, exact) in history.column(index).zip(reference.column(index)) {
            let difference = (value - exact).abs();
            max = max.max(difference);
            sum += difference * difference;
        }
        ColumnError {
            max,
            rms: (sum / rows).sqrt(),
        }
    };
    (0..history.columns.len()).map(column).collect()
}

/// For each column the largest |value - first value| of its output, SI, by which errors are divided. The components of
/// a vector share theirs: what hardly moves along one axis is measured by the motion along the others.
pub(in crate::app) fn scales(model: &dyn AnyModel, reference: &History) -> Vec<f64> {
    let change = |index: usize| {
        let mut column = reference.column(index);
        let first = column.next().unwrap_or(0.0);
        column.fold(0.0_f64, |largest, value| largest.max((value - first).abs()))
    };
    let mut scales = Vec::with_capacity(reference.columns.len());
    for output in model.outputs() {
        let count = output.width();
        let columns = scales.len()..scales.len() + count;
        let largest = columns.map(change).fold(0.0, f64::max);
        scales.extend(std::iter::repeat_n(largest, count));
    }
    scales
}

/// The largest error of the chosen columns relative to their scales, which are positive.
pub(in crate::app) fn worst(errors: &[ColumnError], scales: &[f64], chosen: &[usize]) -> f64 {
    let relative = chosen.iter().map(|&index| errors[index].max / scales[index]);
    relative.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::results::history::Column;
    use crate::app::testing::Rotor;

    fn history(rows: &[[f64; 3]]) -> History {
        let mut history = History::new(&Rotor::default(), Column::time());
        for (index, row) in rows.iter().enumerate() {
            history.push(index as f64, row).unwrap();
        }
        history
    }

    #[test]
    fn errors_are_largest_and_rms_and_vectors_share_their_scale() {
        let reference = history(&[[1.0, 0.0, 5.0], [3.0, 0.1, 4.0], [-3.0, 0.0, 5.0]]);
        let other = history(&[[1.0, 0.2, 5.0], [3.4, 0.1, 4.0], [-3.0, 0.0, 5.3]]);
        let found = errors(&other, &reference);
        let expected = [(0.4, 0.4), (0.2, 0.2), (0.3, 0.3)];
        for (error, (max, sum)) in found.iter().zip(expected) {
            assert!((error.max - max).abs() < 1e-15, "{error:?}");
            assert!((error.rms - sum / 3f64.sqrt()).abs() < 1e-15, "{error:?}");
        }
        let scales = scales(&Rotor::default(), &reference);
        assert_eq!(scales, [4.0, 4.0, 1.0]);
        assert!((worst(&found, &scales, &[0, 1]) - 0.1).abs() < 1e-15);
        assert!((worst(&found, &scales, &[0, 2]) - 0.3).abs() < 1e-15);
    }
}
