//! Tables of numbers along an axis.

use super::curve::Curve;
use super::stations::go_on;
use crate::course::{Interval, Lookup};
use crate::error::ModelError;
use crate::import::spline;

/// Relative size of what counts as round-off of places along an axis.
const ROUND_OFF: f64 = 1e-9;
/// Part of all that a column takes on by which a line through one span misses the next row where it bends: less is left to the control of the error.
const BENT: f64 = 1e-4;

/// Columns of numbers at places along an axis, ascending; between two equal places the columns step.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    /// Name in the declaration.
    pub name: &'static str,
    /// Places: m, or fractions of the length.
    pub places: &'static [f64],
    /// Whether places are fractions of the length.
    pub is_relative: bool,
    /// What values between rows follow.
    pub between: Between,
    /// Columns, SI.
    pub columns: &'static [&'static [f64]],
}

/// What the values of a table follow between its rows.
#[derive(Clone, Copy, Debug)]
pub enum Between {
    /// A line.
    Line,
    /// A monotone cubic (Fritsch and Carlson), whose slope has no steps.
    Monotone,
    /// A cubic spline, whose slope and curvature have no steps, with the slope of each column at each row.
    Spline(&'static [&'static [f64]]),
    /// The same with a slope of zero in the first and last row, beyond which it stays as it is.
    Clamped(&'static [&'static [f64]]),
    /// The same of rows that repeat, so that it has a value everywhere; the last row is the first one again.
    Periodic(&'static [&'static [f64]]),
}

impl Table {
    /// Value of a column at the arclength `x` of an axis with the length `length`, m. At a step the one beyond it; outside of
    /// the table the one at its end.
    pub fn at(&self, column: usize, x: f64, length: f64) -> f64 {
        let (places, values) = (self.places, self.columns[column]);
        let x = if self.is_relative { x / length } else { x };
        let last = places.len() - 1;
        if x.is_nan() || x >= places[last] {
            return values[last];
        }
        if x < places[0] {
            return values[0];
        }
        self.within(column, x)[0]
    }

    /// Value of a column (`order` 0) or its first, second or third derivative at a place in the unit of the places; at a step that beyond it,
    /// outside of the rows no number.
    pub fn look_up(&self, column: usize, order: usize, place: f64) -> f64 {
        let (first, last) = (self.places[0], self.places[self.places.len() - 1]);
        if self.repeats() {
            return self.within(column, first + (place - first).rem_euclid(last - first))[order];
        }
        if self.rests() && !(first..=last).contains(&place) {
            return self.beyond(column, order, place);
        }
        let margin = ROUND_OFF * (last - first);
        if !(first - margin..=last + margin).contains(&place) {
            return f64::NAN;
        }
        self.within(column, place)[order]
    }

    /// Whether it has a value everywhere.
    fn repeats(&self) -> bool {
        matches!(self.between, Between::Periodic(_))
    }

    /// Whether it stays as it is beyond its rows.
    fn rests(&self) -> bool {
        matches!(self.between, Between::Clamped(_))
    }

    /// Whether its rows cover such places.
    fn covers(&self, places: Interval) -> bool {
        self.places[0] <= places.low && places.high <= self.places[self.places.len() - 1]
    }

    /// Value of a column or a derivative at a place beyond the rows, where it stays as it is; no number at none.
    fn beyond(&self, column: usize, order: usize, place: f64) -> f64 {
        if order > 0 || place.is_nan() {
            return 0.0 * place;
        }
        let values = self.columns[column];
        if place < self.places[0] {
            values[0]
        } else {
            values[values.len() - 1]
        }
    }

    /// Whether there are lines between the rows.
    fn is_of_lines(&self) -> bool {
        matches!(self.between, Between::Line)
    }

    /// Places of rows within a column that is looked up at which it jumps, or bends by more than a small part of all that it takes on; none of a smooth one.
    pub fn kinks(&self, column: usize) -> Vec<f64> {
        let (places, values) = (self.places, self.columns[column]);
        let [least, most] = [f64::min, f64::max].map(|pick| values.iter().copied().fold(values[0], pick));
        let is_kink = |&row: &usize| {
            let [before, behind] = [places[row] - places[row - 1], places[row + 1] - places[row]];
            let [left, right] = [values[row] - values[row - 1], values[row + 1] - values[row]];
            let is_step = before == 0.0 || behind == 0.0;
            let bend = (right / behind - left / before) * before.min(behind);
            self.is_of_lines() && (is_step || bend.abs() > BENT * (most - least))
        };
        let rows = (1..places.len() - 1).filter(is_kink);
        rows.map(|row| places[row]).collect()
    }

    /// Places of rows at which the second derivative of a column of a spline bends by more than a small part of all that it takes on; none of others.
    pub fn kinks_of_acceleration(&self, column: usize) -> Vec<f64> {
        let spans = match self.between {
            Between::Spline(_) | Between::Clamped(_) => self.places.len() - 1,
            Between::Line | Between::Monotone | Between::Periodic(_) => return Vec::new(),
        };
        let at = |span: usize| self.within_span(column, span, 0.0);
        let last = self.within_span(column, spans - 1, 1.0)[2];
        let accelerations = (0..spans).map(|span| at(span)[2]).chain([last]);
        let [least, most] = accelerations.fold([last; 2], |[least, most], one| [least.min(one), most.max(one)]);
        let is_kink = |&row: &usize| {
            let width = f64::min(
                self.places[row] - self.places[row - 1],
                self.places[row + 1] - self.places[row],
            );
            (at(row)[3] - at(row - 1)[3]).abs() * width > BENT * (most - least)
        };
        let mut kinks: Vec<f64> = (1..spans).filter(is_kink).map(|row| self.places[row]).collect();
        if self.rests() {
            // At its ends the acceleration jumps.
            kinks.insert(0, self.places[0]);
            kinks.push(self.places[spans]);
        }
        kinks
    }

    /// Value of a column within the rows and its derivatives.
    fn within(&self, column: usize, x: f64) -> [f64; 4] {
        let places = self.places;
        let row = places.partition_point(|&place| place <= x).clamp(1, places.len() - 1) - 1;
        self.within_span(column, row, (x - places[row]) / (places[row + 1] - places[row]))
    }

    /// Value of a column and its derivatives within the span that begins at a row, at a share of it.
    fn within_span(&self, column: usize, row: usize, share: f64) -> [f64; 4] {
        let (places, values) = (self.places, self.columns[column]);
        let (width, rise) = (places[row + 1] - places[row], values[row + 1] - values[row]);
        if self.is_of_lines() {
            return [values[row] + share * rise, rise / width, 0.0, 0.0];
        }
        let slopes = [row, row + 1].map(|at| self.slope(column, at, row));
        spline::cubic(width, [values[row], values[row + 1]], slopes, share)
    }

    /// Shares of a span at which a derivative is extreme, beside its ends: they may lie outside of the span, or be no numbers.
    fn extremes(&self, column: usize, row: usize, order: usize) -> Vec<f64> {
        let width = self.places[row + 1] - self.places[row];
        let [_, slope, curvature, jerk] = self.within_span(column, row, 0.0);
        // Of the cubic in the share.
        let (slope, curvature, jerk) = (slope * width, curvature * width.powi(2), jerk * width.powi(3));
        match (order, self.between) {
            // Lines and monotone cubics are extreme at their ends.
            (0, Between::Spline(_) | Between::Clamped(_) | Between::Periodic(_)) => {
                let root = (curvature * curvature - 2.0 * jerk * slope).sqrt();
                let sum = -(curvature + root.copysign(curvature));
                vec![sum / jerk, 2.0 * slope / sum]
            }
            (1, _) => vec![-curvature / jerk],
            _ => Vec::new(),
        }
    }

    /// Slope of the cubic at a row, seen from the span that begins at row `span`.
    fn slope(&self, column: usize, row: usize, span: usize) -> f64 {
        match self.between {
            Between::Spline(slopes) | Between::Clamped(slopes) | Between::Periodic(slopes) => slopes[column][row],
            Between::Line | Between::Monotone => spline::monotone_slope(self.places, self.columns[column], row, span),
        }
    }

    /// Refuses an axis that the table does not cover, and rows beyond the whole length.
    ///
    /// # Errors
    /// The table, the body and both ends.
    pub fn check(&self, body: &str, length: f64) -> Result<(), ModelError> {
        let end = if self.is_relative { 1.0 } else { length };
        let (first, last) = (self.places[0], self.places[self.places.len() - 1]);
        if self.is_relative && last > 1.0 + ROUND_OFF {
            return Err(ModelError::new(format!(
                "table `{}` has rows up to {last} of the length, and every axis ends at 1: `eta` counts parts of the length, so divide percentages by 100",
                self.name
            )));
        }
        if first <= ROUND_OFF * end && last >= end * (1.0 - ROUND_OFF) {
            return Ok(());
        }
        let unit = if self.is_relative { "of the length" } else { "m" };
        Err(ModelError::new(format!(
            "table `{}` has rows from {first} to {last} {unit}, and the axis of body `{body}` goes from 0 to {end} {unit}: add rows at its ends",
            self.name
        )))
    }

    /// Name in the declaration, of a file that a run names, too, whose own name says both.
    pub(crate) fn declared_name(&self) -> &'static str {
        self.name.rsplit("` for `").next().unwrap_or(self.name)
    }

    /// The curve through the points of three columns, m, with unit vectors along its ends where these have a direction, of a body with
    /// these axes: one that moves in a plane has two, and its curve lies in it. [`Curve::mistake`] tells what is wrong with a row.
    pub fn curve(&self, columns: [usize; 3], directions: [Option<[f64; 3]>; 2], axes: &[usize]) -> Curve {
        const NAMES: [char; 3] = ['x', 'y', 'z'];
        let coordinates = columns.map(|column| self.columns[column]);
        for across in (0..NAMES.len()).filter(|axis| !axes.contains(axis)) {
            if let Some(row) = coordinates[across].iter().position(|&off| off != 0.0) {
                let plane: String = axes.iter().map(|&axis| NAMES[axis]).collect();
                return Curve::none(format!(
                    "has {} = {} m in row {} of table `{}`, and the body stays in the plane {plane}: make that zero, or the body `spatial`",
                    NAMES[across],
                    coordinates[across][row],
                    row + 1,
                    self.name
                ));
            }
        }
        let [x, y, z] = coordinates;
        let points: Vec<[f64; 3]> = (0..x.len()).map(|row| [x[row], y[row], z[row]]).collect();
        Curve::through(&points, directions).told(|mistake| format!("{mistake}, in table `{}`", self.name))
    }

    /// The first step of the table at which a function of the fraction of an axis (m) jumps by more than `least`: the arclength there,
    /// m, and the jump.
    pub(crate) fn jump(&self, length: f64, least: f64, value: impl Fn(f64) -> f64) -> Option<(f64, f64)> {
        let inside = self.steps(length).filter(|u| (0.0..=1.0).contains(u));
        let jump = |u: f64| (u * length, value(u * (1.0 + ROUND_OFF)) - value(u * (1.0 - ROUND_OFF)));
        inside.map(jump).find(|(_, jump)| jump.abs() > least)
    }

    /// Fractions of an axis (m) at the steps, in it or not.
    pub(crate) fn steps(&self, length: f64) -> impl Iterator<Item = f64> {
        let whole = if self.is_relative { 1.0 } else { length };
        let steps = self.places.windows(2).filter(|pair| pair[0] == pair[1]);
        steps.map(move |pair| pair[0] / whole)
    }

    /// Fractions of an axis (m) at the rows, steps once, each span in `each` parts. Rows beyond the end of the axis are left out.
    pub fn stations(&self, length: f64, each: usize) -> Vec<f64> {
        let whole = if self.is_relative { 1.0 } else { length };
        let mut stations = vec![0.0];
        let mut rows: Vec<f64> = self.places.iter().map(|place| place / whole).collect();
        rows.retain(|&place| place > ROUND_OFF && place < 1.0 - ROUND_OFF);
        rows.dedup();
        for end in rows.into_iter().chain([1.0]) {
            go_on(&mut stations, end, each);
        }
        stations
    }
}

impl Lookup for Table {
    fn bounds(&self, column: usize, order: usize, places: Interval) -> Interval {
        let (rows, values) = (self.places, self.columns[column]);
        let (first, last) = (rows[0], rows[rows.len() - 1]);
        let period = last - first;
        if self.repeats() && !self.covers(places) {
            if places.width().is_nan() || places.width() >= period {
                return self.bounds(column, order, Interval::new(first, last));
            }
            let low = first + (places.low - first).rem_euclid(period);
            let high = low + places.width();
            let here = self.bounds(column, order, Interval::new(low, high.min(last)));
            return match high > last {
                true => here.hull(self.bounds(column, order, Interval::new(first, high - period))),
                false => here,
            };
        }
        if self.rests() && !self.covers(places) && !places.width().is_nan() {
            let ends = [places.low, places.high];
            let outer = ends.into_iter().filter(|place| !(first..=last).contains(place));
            let outer = outer.map(|place| Interval::point(self.beyond(column, order, place)));
            let (low, high) = (places.low.max(first), places.high.min(last));
            let inner = (low <= high).then(|| self.bounds(column, order, Interval::new(low, high)));
            return outer.chain(inner).reduce(Interval::hull).unwrap_or(Interval::ALL);
        }
        if places.high < first || places.low > last {
            return Interval::ALL;
        }
        let (low, high) = (places.low.max(first), places.high.min(last));
        let mut bounds = [low, high].map(|place| Interval::point(self.within(column, place)[order]));
        let mut take = |value: f64| bounds[0] = bounds[0].hull(Interval::point(value));
        let inner = rows.partition_point(|&row| row <= low)..rows.partition_point(|&row| row < high);
        if order == 0 {
            inner.clone().for_each(|row| take(values[row]));
            // At a step that begins the span both sides count.
            inner
                .start
                .checked_sub(1)
                .filter(|&row| rows[row] == low)
                .into_iter()
                .for_each(|row| take(values[row]));
        }
        for span in inner.start.saturating_sub(1)..inner.end.min(rows.len() - 1) {
            let width = rows[span + 1] - rows[span];
            if width > 0.0 {
                let [from, to] = [low, high].map(|place| ((place - rows[span]) / width).clamp(0.0, 1.0));
                let inside = self.extremes(column, span, order).into_iter();
                let inside = inside.filter(|share| (from..=to).contains(share));
                let ends = [from, to].into_iter().filter(|_| order > 0);
                ends.chain(inside)
                    .for_each(|share| take(self.within_span(column, span, share)[order]));
            }
        }
        bounds[0].hull(bounds[1])
    }

    fn slopes(&self, column: usize, order: usize, places: Interval) -> Interval {
        let smooth = match self.between {
            Between::Line => 0,
            Between::Monotone => 1,
            // At its ends the second derivative jumps.
            Between::Clamped(_) if !self.covers(places) => 1,
            Between::Spline(_) | Between::Clamped(_) | Between::Periodic(_) => 2,
        };
        if order > smooth || self.places.windows(2).any(|pair| pair[0] == pair[1]) {
            return Interval::ALL;
        }
        self.bounds(column, order + 1, places)
    }
}

#[cfg(test)]
mod tests {
    use crate::emitted::table::*;

    static MAST: Table = Table {
        name: "mast",
        places: &[0.0, 1.0, 1.0, 3.0],
        is_relative: false,
        between: Between::Line,
        columns: &[&[1.0, 2.0, 5.0, 9.0]],
    };

    #[test]
    fn between_rows_is_a_line_and_at_equal_places_a_step() {
        let at = |x: f64| MAST.at(0, x, 3.0);
        assert_eq!([at(0.0), at(0.5), at(1.0), at(2.0), at(3.0)], [1.0, 1.5, 5.0, 7.0, 9.0]);
        assert!((MAST.at(0, 1.0_f64.next_down(), 3.0) - 2.0).abs() < 1e-15);
    }

    #[test]
    fn smooth_columns_pass_through_the_rows_and_do_not_overshoot() {
        static ROWS: Table = Table {
            name: "rows",
            places: &[0.0, 0.1, 0.4, 0.6, 1.0],
            is_relative: true,
            between: Between::Monotone,
            columns: &[&[0.0, 1.0, 1.0, 3.0, 4.0]],
        };
        let at = |u: f64| ROWS.at(0, 10.0 * u, 10.0);
        for (row, &place) in ROWS.places.iter().enumerate() {
            assert!((at(place) - ROWS.columns[0][row]).abs() < 1e-14);
        }
        let values: Vec<f64> = (0..=200).map(|step| at(f64::from(step) / 200.0)).collect();
        assert!(values.windows(2).all(|pair| pair[1] >= pair[0] - 1e-14));
        assert!((at(0.25) - 1.0).abs() < 1e-14);
    }

    /// Fritsch and Butland's mean of the slopes 1 and 1/2 of spans of 1 and 2: (5 + 4) / (5 / 1 + 4 / (1/2)).
    #[test]
    fn slopes_of_smooth_columns_are_weighted_harmonic_means() {
        static ROWS: Table = Table {
            name: "rows",
            places: &[0.0, 1.0, 3.0],
            is_relative: false,
            between: Between::Monotone,
            columns: &[&[0.0, 1.0, 2.0]],
        };
        for place in [1.0, 1.0_f64.next_down()] {
            assert!((ROWS.look_up(0, 1, place) - 9.0 / 13.0).abs() < 1e-14, "{place}");
        }
    }

    #[test]
    fn looked_up_columns_have_their_slope_and_end_at_the_last_row() {
        static POLAR: Table = Table {
            name: "polar",
            places: &[-0.3, 0.0, 0.2, 0.7],
            is_relative: false,
            between: Between::Monotone,
            columns: &[&[-1.0, 0.1, 1.2, 0.8]],
        };
        let (at, slope) = (|x: f64| POLAR.look_up(0, 0, x), |x: f64| POLAR.look_up(0, 1, x));
        for x in [-0.29, -0.1, 0.07, 0.15, 0.3, 0.69] {
            let difference = (at(x + 1e-6) - at(x - 1e-6)) / 2e-6;
            assert!((slope(x) - difference).abs() < 1e-8, "{x}: {} {difference}", slope(x));
        }
        assert_eq!([at(-0.3), at(0.2), at(0.7)], [-1.0, 1.2, 0.8]);
        assert!(at(0.71).is_nan() && at(-0.31).is_nan() && at(f64::NAN).is_nan());
        assert_eq!([MAST.look_up(0, 1, 0.5), MAST.look_up(0, 1, 1.0)], [1.0, 2.0]);
    }

    /// Slopes of zero at both ends, and in the middle for symmetry: `3 s^2 - 2 s^3`.
    #[test]
    fn clamped_columns_rest_at_their_ends_and_beyond() {
        static PROGRAM: Table = Table {
            name: "program",
            places: &[0.0, 1.0, 2.0],
            is_relative: false,
            between: Between::Clamped(&[&[0.0, 0.0, 0.0]]),
            columns: &[&[0.0, 1.0, 0.0]],
        };
        let at = |order: usize, t: f64| PROGRAM.look_up(0, order, t);
        assert_eq!([at(0, -1.0), at(0, 0.5), at(0, 3.0)], [0.0, 0.5, 0.0]);
        assert_eq!([at(1, -1.0), at(1, 0.5), at(2, 3.0)], [0.0, 1.5, 0.0]);
        assert!(at(0, f64::NAN).is_nan() && at(1, f64::NAN).is_nan());
        assert_eq!(PROGRAM.kinks_of_acceleration(0), [0.0, 1.0, 2.0]);
        for (low, high) in [(-1.0, 0.3), (0.2, 0.7), (1.5, 4.0), (-2.0, 5.0), (2.5, 3.0)] {
            let places = Interval::new(low, high);
            for order in 0..3 {
                let bounds = PROGRAM.bounds(0, order, places);
                let inside = |share: i32| at(order, low + (high - low) * f64::from(share) / 64.0);
                let values: Vec<f64> = (0..=64).map(inside).collect();
                let is_in = |value: &f64| bounds.low - 1e-12 <= *value && *value <= bounds.high + 1e-12;
                assert!(values.iter().all(is_in), "{low} {high} {order}: {bounds:?}");
            }
        }
    }

    #[test]
    fn an_axis_beyond_the_table_is_refused_and_stations_are_its_rows() {
        assert!(MAST.check("pole", 3.0).is_ok());
        assert!(
            MAST.check("pole", 3.1)
                .unwrap_err()
                .to_string()
                .contains("from 0 to 3 m")
        );
        let percent = Table {
            is_relative: true,
            places: &[0.0, 40.0, 40.0, 100.0],
            ..MAST
        };
        let told = percent.check("pole", 3.0).unwrap_err().to_string();
        assert!(told.contains("rows up to 100 of the length"), "{told}");
        assert_eq!(MAST.stations(3.0, 1), vec![0.0, 1.0 / 3.0, 1.0]);
        assert_eq!(MAST.stations(4.0, 2).len(), 7);
    }

    /// Bounds over places contain all values there, beyond the rows of a periodic one, too.
    #[test]
    fn bounds_contain_what_columns_take_on() {
        static SLOPES: &[&[f64]] = &[&[1.0, -3.0, 2.0, 1.0]];
        let table = |between| Table {
            name: "rows",
            places: &[0.0, 1.0, 1.5, 3.0],
            is_relative: false,
            between,
            columns: &[&[0.0, 2.0, -1.0, 0.0]],
        };
        let spline = table(Between::Spline(SLOPES));
        let periodic = table(Between::Periodic(SLOPES));
        for (table, from) in [
            (table(Between::Line), 0.0_f64),
            (table(Between::Monotone), 0.0),
            (spline, 0.0_f64),
            (periodic, -7.3),
        ] {
            for (start, width) in [(0.1, 0.3), (0.8, 0.9), (0.0, 2.9), (1.6, 0.01), (2.7, 0.3), (2.7, 5.0)] {
                let low = from + start;
                let high = if from < 0.0 {
                    low + width
                } else {
                    f64::min(low + width, 3.0)
                };
                for order in 0..3 {
                    let bounds = table.bounds(0, order, Interval::new(low, high)).wider(1e-9);
                    for step in 0..=100 {
                        let place = low + (high - low) * f64::from(step) / 100.0;
                        let value = table.look_up(0, order, place);
                        assert!(
                            bounds.contains(Interval::point(value)),
                            "{table:?} {low} {high} {order}: {value} {bounds:?}"
                        );
                    }
                }
            }
        }
        assert_eq!(periodic.look_up(0, 0, 4.0), periodic.look_up(0, 0, 1.0));
        assert_eq!(periodic.look_up(0, 1, -3.0), periodic.look_up(0, 1, 0.0));
    }
}
