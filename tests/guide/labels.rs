//! Places of names in a drawing: beside what they name, off its lines and off each other.

/// A point on the paper; y goes down.
pub type Point = [f64; 2];

/// Size of letters.
pub const TEXT: f64 = 64.0;
/// Mean width of a letter, and how far letters reach above and below their line, as parts of their size.
const WIDE: f64 = 0.56;
const ABOVE: f64 = 0.76;
const BELOW: f64 = 0.24;
/// Ways from a place to its name, nearest first.
const GAPS: [f64; 4] = [36.0, 72.0, 120.0, 190.0];
/// Space that is kept free around a name.
const FREE: f64 = 14.0;

/// Where a name stands: to the right and down of its place where these are 1.
type Side = [f64; 2];

/// Sides of a name, the one that is taken first in front.
pub const ABOVE_RIGHT: [Side; 8] = [
    [1.0, -1.0],
    [-1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [1.0, 0.0],
    [-1.0, 0.0],
];
/// The same for what stands at the ends of lines.
pub const BELOW_LEFT: [Side; 8] = [
    [-1.0, 1.0],
    [1.0, 1.0],
    [-1.0, -1.0],
    [1.0, -1.0],
    [-1.0, 0.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [0.0, -1.0],
];
/// The same for what stands at the tips of arrows.
pub const RIGHT: [Side; 8] = [
    [1.0, 0.0],
    [1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 0.0],
    [-1.0, -1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [0.0, 1.0],
];

/// A rectangle along the edges of the paper.
#[derive(Clone, Copy)]
struct Area {
    low: Point,
    high: Point,
}

impl Area {
    fn widened(self, by: f64) -> Self {
        Self {
            low: self.low.map(|value| value - by),
            high: self.high.map(|value| value + by),
        }
    }

    /// Length of the part of a line inside.
    fn length_inside(&self, [from, to]: [Point; 2]) -> f64 {
        let (mut enters, mut leaves) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            let way = to[axis] - from[axis];
            let [near, far] = [self.low[axis] - from[axis], self.high[axis] - from[axis]];
            if way == 0.0 {
                if near > 0.0 || far < 0.0 {
                    return 0.0;
                }
                continue;
            }
            let (first, last) = ((near / way).min(far / way), (near / way).max(far / way));
            (enters, leaves) = (enters.max(first), leaves.min(last));
        }
        (leaves - enters).max(0.0) * (to[0] - from[0]).hypot(to[1] - from[1])
    }

    /// How far it reaches into another one: the smaller of both sides of what they share.
    fn depth_in(&self, other: &Area) -> f64 {
        let shared = |axis: usize| self.high[axis].min(other.high[axis]) - self.low[axis].max(other.low[axis]);
        shared(0).min(shared(1)).max(0.0)
    }
}

/// A name with its place in a text.
pub struct Placed {
    /// Where its line of letters is anchored.
    pub at: Point,
    /// `start`, `middle` or `end`.
    pub anchor: &'static str,
    /// How much of what is drawn it covers; nothing where there is room.
    pub covers: f64,
}

/// What is drawn on a paper of some size, beside which names are written.
pub struct Sheet {
    size: Point,
    lines: Vec<[Point; 2]>,
    taken: Vec<Area>,
}

impl Sheet {
    /// An empty one.
    pub fn new(size: Point) -> Self {
        Self {
            size,
            lines: Vec::new(),
            taken: Vec::new(),
        }
    }

    /// Names keep off this line.
    pub fn line(&mut self, points: &[Point]) {
        self.lines.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
    }

    /// Names keep off a square around a point.
    pub fn spot(&mut self, at: Point, radius: f64) {
        self.taken.push(Area { low: at, high: at }.widened(radius));
    }

    /// Names keep off a text that begins here.
    pub fn text(&mut self, [x, y]: Point, inside: &str) {
        let low = [x, y - ABOVE * TEXT];
        let high = [x + width(inside), y + BELOW * TEXT];
        self.taken.push(Area { low, high });
    }

    /// A place for a name beside the first of these points where it is off all that is drawn; where there is none, one that is
    /// covered the least.
    pub fn place(&mut self, name: &str, points: &[Point], sides: &[Side]) -> Placed {
        let mut best: Option<(f64, Area, Side)> = None;
        for gap in GAPS {
            for &point in points {
                for &side in sides {
                    let area = beside(point, side, gap, width(name));
                    let covered = self.covered(&area);
                    if best.is_none_or(|(least, ..)| covered < least) {
                        best = Some((covered, area, side));
                    }
                }
            }
            if best.is_some_and(|(covered, ..)| covered == 0.0) {
                break;
            }
        }
        let (covers, area, [across, _]) = best.expect("a name has a point");
        self.taken.push(area);
        let (x, anchor) = match across {
            1.0 => (area.low[0], "start"),
            0.0 => (f64::midpoint(area.low[0], area.high[0]), "middle"),
            _ => (area.high[0], "end"),
        };
        Placed {
            at: [x, area.low[1] + ABOVE * TEXT].map(f64::round),
            anchor,
            covers,
        }
    }

    /// How much of what is drawn stands in an area, and how much of it is off the paper.
    fn covered(&self, area: &Area) -> f64 {
        let free = area.widened(FREE);
        let lines: f64 = self.lines.iter().map(|&line| free.length_inside(line)).sum();
        let taken: f64 = self.taken.iter().map(|other| free.depth_in(other)).sum();
        let outside = |axis: usize| (-area.low[axis]).max(area.high[axis] - self.size[axis]).max(0.0);
        lines + 4.0 * (taken + outside(0) + outside(1))
    }
}

fn width(name: &str) -> f64 {
    WIDE * TEXT * name.chars().count() as f64
}

/// The area of a name on a side of a point.
fn beside(point: Point, side: Side, gap: f64, width: f64) -> Area {
    let size = [width, (ABOVE + BELOW) * TEXT];
    // Across a corner the way is as long as along one edge.
    let gap = if side[0] * side[1] == 0.0 {
        gap
    } else {
        gap / 2f64.sqrt()
    };
    let start = |axis: usize| match side[axis] {
        1.0 => point[axis] + gap,
        0.0 => point[axis] - size[axis] / 2.0,
        _ => point[axis] - gap - size[axis],
    };
    let low = [start(0), start(1)];
    Area {
        low,
        high: [low[0] + size[0], low[1] + size[1]],
    }
}
