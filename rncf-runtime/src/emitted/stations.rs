//! Nodes of a mesh at places where something acts.

/// Part of an element of equal ones below which a place is no place of its own: it is within the element beside it.
const NEAR: f64 = 0.02;

/// Goes on from the last of some nodes to another one in equal parts.
pub(super) fn go_on(stations: &mut Vec<f64>, end: f64, parts: usize) {
    let start = stations[stations.len() - 1];
    let within = (1..parts).map(|at| start + (end - start) * at as f64 / parts as f64);
    stations.extend(within.chain([end]));
}

/// Fractions of an axis (m) at the nodes of at least `count` elements, with a node at each of the places (m of arclength). Between
/// places elements are of equal length, and each next one goes where they are longest.
///
/// Places at the ends or next to another one get no node of their own; what is no number, or on no axis, is left to the checks of places.
pub fn stations_at(length: f64, count: usize, places: &[f64]) -> Vec<f64> {
    let count = count.max(1);
    let near = NEAR / count as f64;
    let mut ends: Vec<f64> = places.iter().map(|place| place / length).collect();
    ends.retain(|&end| end > near && end < 1.0 - near);
    ends.sort_unstable_by(f64::total_cmp);
    let mut last = 0.0;
    ends.retain(|&end| {
        let is_new = end - last > near;
        if is_new {
            last = end;
        }
        is_new
    });
    ends.push(1.0);
    let starts = [0.0].into_iter().chain(ends.iter().copied());
    let mut parts: Vec<(f64, f64, usize)> = starts.zip(&ends).map(|(from, &to)| (from, to, 1)).collect();
    let element = |&(from, to, count): &(f64, f64, usize)| (to - from) / count as f64;
    for _ in parts.len()..count {
        // Of equally long ones the first.
        let longest = (0..parts.len()).reduce(|most, at| {
            let is_longer = element(&parts[at]) > element(&parts[most]) * (1.0 + 1e-12);
            if is_longer { at } else { most }
        });
        if let Some(longest) = longest {
            parts[longest].2 += 1;
        }
    }
    let mut stations = vec![0.0];
    for (_, to, count) in parts {
        go_on(&mut stations, to, count);
    }
    stations
}

#[cfg(test)]
mod tests {
    use super::stations_at;

    #[test]
    fn places_are_nodes_and_elements_as_equal_as_they_can_be() {
        assert_eq!(stations_at(1.0, 4, &[]), [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert_eq!(stations_at(2.0, 4, &[1.0]), [0.0, 0.25, 0.5, 0.75, 1.0]);
        let nodes = stations_at(1.2, 8, &[1.07, 0.34]);
        assert_eq!(nodes.len(), 9);
        assert!(nodes.contains(&(0.34 / 1.2)) && nodes.contains(&(1.07 / 1.2)));
        assert!(nodes.windows(2).all(|pair| pair[1] - pair[0] < 0.16), "{nodes:?}");
        // As many as places need, and none next to another one.
        assert_eq!(stations_at(1.0, 2, &[0.1, 0.4, 0.4001, 0.7, 1.0, f64::NAN]).len(), 5);
    }
}
