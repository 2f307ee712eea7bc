//! What each entry of a section's matrices means: its formula for a section that is known by its centres, and the drawing of it.

use std::fmt::Write;

/// Width and height of the drawing; it is shown as a quarter of it.
const WIDTH: f64 = 3840.0;
const HEIGHT: f64 = 2760.0;
const INK: &str = "#333333";
const GREY: &str = "#9A9A9A";
const LINE: &str = "#1F5FA8";
const FORCE: &str = "#C2510C";

/// A section by its centres, with principal axes along y and z.
pub struct Centres {
    /// `EA`, `GAy`, `GAz`, N; `GJ`, `EIy`, `EIz`, N m^2.
    pub moduli: [f64; 6],
    /// y and z of the tension centre, m.
    pub tension: [f64; 2],
    /// y and z of the shear centre, m.
    pub shear: [f64; 2],
    /// kg/m.
    pub mass: f64,
    /// y and z of the centre of mass, m.
    pub center: [f64; 2],
    /// `inertia_y`, `inertia_z`, `inertia_yz`, kg m.
    pub inertia: [f64; 3],
}

/// What an entry comes from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum From {
    /// The strain of its own row.
    Itself,
    /// A tension centre, or centre of mass, beside the axis.
    Centre,
    /// A shear centre beside the axis.
    ShearCentre,
    /// Principal axes that are turned, or what the layup couples; no such section is known by its centres.
    Layup,
    /// Nothing: no section has it.
    Nothing,
}

/// An entry of the upper triangle.
pub struct Entry {
    /// Row and column, counted from 0.
    pub at: [usize; 2],
    /// What stands in the drawing; a line break parts two lines.
    pub text: &'static str,
    /// What it comes from.
    pub from: From,
    /// The same as a number.
    pub value: fn(&Centres) -> f64,
}

const fn entry(row: usize, column: usize, text: &'static str, from: From, value: fn(&Centres) -> f64) -> Entry {
    Entry {
        at: [row, column],
        text,
        from,
        value,
    }
}

/// Stiffness.
pub const STIFFNESS: [Entry; 21] = [
    entry(0, 0, "EA", From::Itself, |s| s.moduli[0]),
    entry(0, 1, "axial-shear", From::Layup, |_| 0.0),
    entry(0, 2, "axial-shear", From::Layup, |_| 0.0),
    entry(0, 3, "axial-twist", From::Layup, |_| 0.0),
    entry(0, 4, "EA zt", From::Centre, |s| s.moduli[0] * s.tension[1]),
    entry(0, 5, "-EA yt", From::Centre, |s| -s.moduli[0] * s.tension[0]),
    entry(1, 1, "GAy", From::Itself, |s| s.moduli[1]),
    entry(1, 2, "shear-shear", From::Layup, |_| 0.0),
    entry(1, 3, "-GAy zs", From::ShearCentre, |s| -s.moduli[1] * s.shear[1]),
    entry(1, 4, "shear-bend", From::Layup, |_| 0.0),
    entry(1, 5, "shear-bend", From::Layup, |_| 0.0),
    entry(2, 2, "GAz", From::Itself, |s| s.moduli[2]),
    entry(2, 3, "GAz ys", From::ShearCentre, |s| s.moduli[2] * s.shear[0]),
    entry(2, 4, "shear-bend", From::Layup, |_| 0.0),
    entry(2, 5, "shear-bend", From::Layup, |_| 0.0),
    entry(3, 3, "GJ + GAy zs²\n+ GAz ys²", From::Itself, |s| {
        s.moduli[3] + s.moduli[1] * s.shear[1].powi(2) + s.moduli[2] * s.shear[0].powi(2)
    }),
    entry(3, 4, "twist-bend", From::Layup, |_| 0.0),
    entry(3, 5, "twist-bend", From::Layup, |_| 0.0),
    entry(4, 4, "EIy + EA zt²", From::Itself, |s| {
        s.moduli[4] + s.moduli[0] * s.tension[1].powi(2)
    }),
    entry(4, 5, "-EA yt zt", From::Centre, |s| {
        -s.moduli[0] * s.tension[0] * s.tension[1]
    }),
    entry(5, 5, "EIz + EA yt²", From::Itself, |s| {
        s.moduli[5] + s.moduli[0] * s.tension[0].powi(2)
    }),
];

/// Mass.
pub const MASS: [Entry; 21] = [
    entry(0, 0, "m", From::Itself, |s| s.mass),
    entry(0, 1, "0", From::Nothing, |_| 0.0),
    entry(0, 2, "0", From::Nothing, |_| 0.0),
    entry(0, 3, "0", From::Nothing, |_| 0.0),
    entry(0, 4, "m zm", From::Centre, |s| s.mass * s.center[1]),
    entry(0, 5, "-m ym", From::Centre, |s| -s.mass * s.center[0]),
    entry(1, 1, "m", From::Itself, |s| s.mass),
    entry(1, 2, "0", From::Nothing, |_| 0.0),
    entry(1, 3, "-m zm", From::Centre, |s| -s.mass * s.center[1]),
    entry(1, 4, "0", From::Nothing, |_| 0.0),
    entry(1, 5, "0", From::Nothing, |_| 0.0),
    entry(2, 2, "m", From::Itself, |s| s.mass),
    entry(2, 3, "m ym", From::Centre, |s| s.mass * s.center[0]),
    entry(2, 4, "0", From::Nothing, |_| 0.0),
    entry(2, 5, "0", From::Nothing, |_| 0.0),
    entry(3, 3, "M55\n+ M66", From::Itself, |s| about_y(s) + about_z(s)),
    entry(3, 4, "0", From::Nothing, |_| 0.0),
    entry(3, 5, "0", From::Nothing, |_| 0.0),
    entry(4, 4, "iy\n+ m zm²", From::Itself, about_y),
    entry(4, 5, "-iyz\n- m ym zm", From::Centre, |s| {
        -s.inertia[2] - s.mass * s.center[0] * s.center[1]
    }),
    entry(5, 5, "iz\n+ m ym²", From::Itself, about_z),
];

fn about_y(s: &Centres) -> f64 {
    s.inertia[0] + s.mass * s.center[1].powi(2)
}

fn about_z(s: &Centres) -> f64 {
    s.inertia[1] + s.mass * s.center[0].powi(2)
}

/// The whole matrix of a section.
pub fn matrix(entries: &[Entry; 21], of: &Centres) -> [[f64; 6]; 6] {
    let mut matrix = [[0.0; 6]; 6];
    for Entry {
        at: [row, column],
        value,
        ..
    } in entries
    {
        (matrix[*row][*column], matrix[*column][*row]) = (value(of), value(of));
    }
    matrix
}

/// Strains with what they do, in the order of rows and columns.
const STRAINS: [[&str; 2]; 6] = [
    ["1 axial", "force N along x"],
    ["2 shear along y", "force Qy"],
    ["3 shear along z", "force Qz"],
    ["4 twist about x", "moment T"],
    ["5 bending about y", "moment My: z > 0 is stretched"],
    ["6 bending about z", "moment Mz: y < 0 is stretched"],
];

type Point = [f64; 2];

/// A paper with y downwards.
#[derive(Default)]
struct Paper(String);

impl Paper {
    fn text(&mut self, [x, y]: Point, anchor: &str, size: f64, color: &str, inside: &str) {
        let inside = inside.replace('>', "&gt;").replace('<', "&lt;");
        let _ = writeln!(
            self.0,
            "<text x=\"{x:.0}\" y=\"{y:.0}\" text-anchor=\"{anchor}\" font-family=\"sans-serif\" font-size=\"{size}\" fill=\"{color}\">{inside}</text>"
        );
    }

    fn path(&mut self, points: &[Point], color: &str, fill: &str, more: &str) {
        let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.0},{y:.0}")).collect();
        let _ = writeln!(
            self.0,
            "<polyline points=\"{}\" fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"10\" stroke-linejoin=\"round\"{more}/>",
            points.join(" ")
        );
    }

    fn circle(&mut self, [x, y]: Point, radius: f64, color: &str, fill: &str) {
        let _ = writeln!(
            self.0,
            "<circle cx=\"{x:.0}\" cy=\"{y:.0}\" r=\"{radius:.0}\" fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"10\"/>"
        );
    }

    /// An arrow along points, with so many heads.
    fn arrow(&mut self, points: &[Point], color: &str, heads: usize) {
        self.path(points, color, "none", "");
        let [from, tip] = [points[points.len() - 2], points[points.len() - 1]];
        let length = (tip[0] - from[0]).hypot(tip[1] - from[1]);
        let along = [(tip[0] - from[0]) / length, (tip[1] - from[1]) / length];
        for head in 0..heads {
            let at = |back: f64, aside: f64| {
                let back = back + 40.0 * head as f64;
                [
                    tip[0] - back * along[0] - aside * along[1],
                    tip[1] - back * along[1] + aside * along[0],
                ]
            };
            self.path(
                &[at(-18.0, 0.0), at(38.0, 26.0), at(38.0, -26.0), at(-18.0, 0.0)],
                color,
                color,
                "",
            );
        }
    }
}

/// The drawing as an SVG document.
pub fn drawing() -> String {
    let mut paper = Paper::default();
    section(&mut paper);
    for (number, names) in STRAINS.iter().enumerate() {
        let corner = [
            1700.0 + 720.0 * (number % 3) as f64,
            106.0 + 560.0 * (number / 3) as f64,
        ];
        strained(&mut paper, corner, number, names);
    }
    let title =
        "Force and moment = K times strain; blue: tension centre, orange: shear centre, green: layup or turned axes";
    paper.text([120.0, 1330.0], "start", 60.0, INK, title);
    let rows = ["N", "Qy", "Qz", "T", "My", "Mz"];
    let columns = ["1 axial", "2 shear y", "3 shear z", "4 twist", "5 bend y", "6 bend z"];
    grid(
        &mut paper,
        &STIFFNESS,
        [330.0, 1480.0],
        [310.0, 180.0],
        (&rows, &columns),
        ('K', 46.0),
    );
    let rows = ["px", "py", "pz", "hx", "hy", "hz"];
    let columns = ["vx", "vy", "vz", "ωx", "ωy", "ωz"];
    grid(
        &mut paper,
        &MASS,
        [2430.0, 1480.0],
        [220.0, 180.0],
        (&rows, &columns),
        ('M', 40.0),
    );
    let title = "Momentum p, h about o = M times velocity";
    paper.text([2430.0, 2650.0], "start", 52.0, INK, title);
    let title =
        "K and M are symmetric. yt, zt; ys, zs; ym, zm: places of the centres. iy, iz, iyz: about the mass centre";
    paper.text([120.0, 2720.0], "start", 52.0, INK, title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0}\" height=\"{:.0}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\">\n\
         <title>The entries of a section's matrices of stiffness and mass: axes, strains, what couples which</title>\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#FFFFFF\"/>\n{}</svg>\n",
        WIDTH / 4.0,
        HEIGHT / 4.0,
        paper.0
    )
}

/// The section as it is seen against x, with its centres and the forces on it.
fn section(paper: &mut Paper) {
    let title = "Section, x comes out of the page";
    paper.text([120.0, 106.0], "start", 60.0, INK, title);
    let o = [620.0, 780.0];
    let outline: Vec<Point> = (0..=60)
        .map(|k| {
            let angle = f64::from(k) * std::f64::consts::TAU / 60.0;
            let (sine, cosine) = angle.sin_cos();
            [700.0 + 400.0 * cosine, 730.0 - 210.0 * sine * (1.0 - 0.35 * cosine)]
        })
        .collect();
    paper.path(&outline, GREY, "#F2F2F2", "");
    let at = |y: f64, z: f64| [o[0] + y, o[1] - z];
    paper.arrow(&[o, at(760.0, 0.0)], INK, 1);
    paper.arrow(&[o, at(0.0, 560.0)], INK, 1);
    paper.text(at(800.0, 22.0), "start", 64.0, INK, "y");
    paper.text(at(-20.0, 600.0), "end", 64.0, INK, "z");
    // Along y and z stand the forces, beside them the moments with two heads.
    paper.arrow(&[at(520.0, -90.0), at(680.0, -90.0)], FORCE, 1);
    paper.text(at(600.0, -180.0), "middle", 56.0, FORCE, "Qy");
    paper.arrow(&[at(520.0, 90.0), at(700.0, 90.0)], FORCE, 2);
    paper.text(at(610.0, 140.0), "middle", 56.0, FORCE, "My");
    paper.arrow(&[at(90.0, 330.0), at(90.0, 480.0)], FORCE, 1);
    paper.text(at(130.0, 400.0), "start", 56.0, FORCE, "Qz");
    paper.arrow(&[at(-90.0, 330.0), at(-90.0, 500.0)], FORCE, 2);
    paper.text(at(-130.0, 400.0), "end", 56.0, FORCE, "Mz");
    let turn: Vec<Point> = (0..=24)
        .map(|k| {
            let angle = std::f64::consts::PI * (0.65 + 0.85 * f64::from(k) / 24.0);
            at(115.0 * angle.cos(), 115.0 * angle.sin())
        })
        .collect();
    paper.arrow(&turn, FORCE, 1);
    paper.text(at(-140.0, -30.0), "end", 56.0, FORCE, "T");
    paper.circle(o, 34.0, FORCE, "#FFFFFF");
    paper.circle(o, 10.0, FORCE, FORCE);
    paper.text(at(44.0, 40.0), "start", 56.0, FORCE, "N");
    paper.text(at(52.0, -72.0), "start", 56.0, INK, "o");
    let centres = [
        ([170.0, 120.0], LINE, "tension centre (yt, zt)"),
        ([60.0, 190.0], FORCE, "shear centre (ys, zs)"),
        ([250.0, 50.0], INK, "mass centre (ym, zm)"),
    ];
    for (number, ([y, z], color, name)) in centres.into_iter().enumerate() {
        let line = 1060.0 + 75.0 * number as f64;
        paper.circle(at(y, z), 16.0, color, color);
        // Names stand below, one line each.
        paper.circle([180.0, line - 20.0], 16.0, color, color);
        paper.text([230.0, line], "start", 56.0, color, name);
    }
    let note = [
        "o: the axis of the body. N to Mz:",
        "what the part beyond exerts on the",
        "part before, about o",
    ];
    for (number, line) in note.iter().enumerate() {
        paper.text([900.0, 1060.0 + 75.0 * number as f64], "start", 48.0, INK, line);
    }
}

/// A piece of a body with one strain, and what it was before.
fn strained(paper: &mut Paper, [x, y]: Point, number: usize, [name, force]: &[&str; 2]) {
    paper.text([x, y], "start", 54.0, INK, name);
    paper.text([x, y + 62.0], "start", 44.0, FORCE, force);
    let [left, middle] = [x + 60.0, y + 255.0 + if number == 5 { 60.0 } else { 0.0 }];
    if number == 3 {
        let corner = |angle: f64| -> Vec<Point> {
            let at = |k: u8| {
                let angle = angle + std::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5);
                [left + 150.0 + 130.0 * angle.cos(), middle + 10.0 - 130.0 * angle.sin()]
            };
            (0..=4).map(at).collect()
        };
        paper.path(&corner(0.0), GREY, "none", " stroke-dasharray=\"30 24\"");
        paper.path(&corner(0.35), LINE, "none", "");
        paper.text([left + 320.0, middle - 40.0], "start", 40.0, INK, "y to the right,");
        paper.text([left + 320.0, middle + 14.0], "start", 40.0, INK, "z up: the end");
        paper.text([left + 320.0, middle + 68.0], "start", 40.0, INK, "turns to z");
        return;
    }
    // Places of a particle at a distance h above the axis.
    let moved = |at: f64, h: f64| -> Point {
        let turned = 0.9 * at;
        match number {
            0 => [1.3 * at, h],
            1 | 2 => [at, h + 0.3 * at],
            4 => [at + h * turned.sin(), -0.45 * at * at + h * turned.cos()],
            _ => [at - h * turned.sin(), 0.45 * at * at + h * turned.cos()],
        }
    };
    let rim = |of: &dyn Fn(f64, f64) -> Point| -> Vec<Point> {
        let along = (0..=12).map(|k| f64::from(k) / 12.0);
        let mut points: Vec<Point> = along.clone().map(|at| of(at, 0.18)).collect();
        points.extend(along.rev().map(|at| of(at, -0.18)));
        points.push(points[0]);
        points
            .into_iter()
            .map(|[along, up]| [left + 380.0 * along, middle - 380.0 * up])
            .collect()
    };
    paper.path(&rim(&|at, h| [at, h]), GREY, "none", " stroke-dasharray=\"30 24\"");
    paper.path(&rim(&moved), LINE, "none", "");
    let up = if matches!(number, 2 | 4) { "z" } else { "y" };
    let o = [left - 50.0, y + 445.0];
    paper.arrow(&[o, [o[0] + 90.0, o[1]]], INK, 1);
    paper.arrow(&[o, [o[0], o[1] - 90.0]], INK, 1);
    paper.text([o[0] + 130.0, o[1] + 14.0], "start", 44.0, INK, "x");
    paper.text([o[0] - 36.0, o[1] - 56.0], "end", 44.0, INK, up);
}

/// A matrix: its upper triangle in words, coloured by what an entry comes from.
fn grid(
    paper: &mut Paper,
    entries: &[Entry; 21],
    [x, y]: Point,
    [wide, high]: Point,
    (rows, columns): (&[&str; 6], &[&str; 6]),
    (letter, size): (char, f64),
) {
    for (number, (row, column)) in rows.iter().zip(columns).enumerate() {
        let at = number as f64;
        paper.text([x - 30.0, y + high * (at + 0.5) + 16.0], "end", 54.0, FORCE, row);
        paper.text([x + wide * (at + 0.5), y - 30.0], "middle", 54.0, LINE, column);
    }
    for Entry {
        at: [row, column],
        text,
        from,
        ..
    } in entries
    {
        let fill = match from {
            From::Itself => "#E4E4E4",
            From::Centre => "#DCE9F7",
            From::ShearCentre => "#FBE6D8",
            From::Layup => "#EAF3DF",
            From::Nothing => "#FFFFFF",
        };
        let [left, top] = [x + wide * *column as f64, y + high * *row as f64];
        let corners = [[0.0, 0.0], [wide, 0.0], [wide, high], [0.0, high], [0.0, 0.0]];
        let corners = corners.map(|[across, down]| [left + across, top + down]);
        paper.path(&corners, "#FFFFFF", fill, "");
        let name = format!("{letter}{}{}", row + 1, column + 1);
        paper.text([left + 14.0, top + 42.0], "start", 32.0, "#777777", &name);
        let lines: Vec<&str> = text.lines().collect();
        let first = top + high / 2.0 + 0.45 * size - 0.4 * size * (lines.len() - 1) as f64;
        for (number, line) in lines.iter().enumerate() {
            let down = first + 1.2 * size * number as f64;
            paper.text([left + wide / 2.0, down], "middle", size, INK, line);
        }
    }
}
