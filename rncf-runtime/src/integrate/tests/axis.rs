//! The time axis: kinks, ends and steps that fit.

use crate::integrate::segments::Segments;

/// Takes steps of `wanted` and returns all ends of steps, with restarts behind kinks.
fn walk(axis: &mut Segments, wanted: f64, fixed: bool) -> Vec<f64> {
    let (mut t, mut ends) = (axis.start(), vec![]);
    while !axis.is_at_end(t) {
        if axis.is_at_kink(t) {
            t = axis.behind_kink();
            axis.pass_kink();
        }
        let h = axis.fit((t, 0.0), wanted, fixed, f64::INFINITY);
        assert!(h > 0.45 * wanted && h <= 1.1 * wanted, "{h} from {t}");
        t += h;
        ends.push(t);
    }
    ends
}

#[test]
fn steps_end_just_before_kinks_and_at_the_end() {
    let kinks = [1.0 / 3.0, 0.7, 0.7 + 5e-15, 5.0, -1.0, f64::NAN];
    for fixed in [false, true] {
        let mut axis = Segments::new(0.0, 1.0, &kinks);
        let ends = walk(&mut axis, 0.0123, fixed);
        assert!(ends.contains(&(1.0_f64 / 3.0).next_down()));
        assert!(ends.contains(&0.7_f64.next_down()));
        assert_eq!(*ends.last().unwrap(), 1.0);
    }
}

#[test]
fn two_kinks_within_round_off_are_one() {
    for (apart, is_one) in [(5e-15, true), (1e-13, false)] {
        let mut axis = Segments::new(0.0, 1.0, &[0.7, 0.7 + apart]);
        assert!(axis.is_at_kink(0.7_f64.next_down()));
        let last = if is_one { 0.7 + apart } else { 0.7 };
        assert_eq!(axis.behind_kink(), last.next_up());
        axis.pass_kink();
        assert_eq!(axis.is_at_end(1.0), is_one);
        assert_eq!(axis.is_at_kink((0.7 + apart).next_down()), !is_one);
    }
}

#[test]
fn kinks_at_the_start_and_the_end_lie_outside() {
    let axis = Segments::new(2.0, 3.0, &[2.0, 3.0]);
    assert_eq!(axis.start(), 2.0_f64.next_up());
    assert!(axis.is_at_end(3.0_f64.next_down()));
}

#[test]
fn fixed_steps_that_divide_the_span_stay_as_they_are() {
    let mut axis = Segments::new(0.0, 1.0, &[]);
    let ends = walk(&mut axis, 0.001, true);
    assert_eq!(ends.len(), 1000);
    assert_eq!(*ends.last().unwrap(), 1.0);
}
