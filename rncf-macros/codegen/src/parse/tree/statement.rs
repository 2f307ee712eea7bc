//! Statements of bodies, as they are written.

use super::expression::{Call, Expr, Name};
use crate::errors::Area;

/// A statement of a body.
#[derive(Clone, Debug)]
pub enum Statement {
    /// `planar xy;`, or `spatial;` without a plane.
    Space {
        /// The whole statement.
        area: Area,
        /// `xy`, `yz` or `zx`.
        plane: Option<Name>,
    },
    /// `line from a to b;`, `line from a to b to c;`
    Line {
        /// The word `line`.
        area: Area,
        /// Start.
        from: Expr,
        /// Corners between start and end.
        corners: Vec<Expr>,
        /// End.
        to: Expr,
    },
    /// Which part of an axis with corners this is; nobody writes it.
    Piece {
        /// Start, corners and end of the whole axis.
        points: Vec<Expr>,
        /// Its number, from 0.
        number: usize,
    },
    /// `arc from a direction d [normal n] radius r angle phi;`
    Arc {
        /// The word `arc`.
        area: Area,
        /// Start.
        from: Expr,
        /// Tangent at the start.
        direction: Box<Expr>,
        /// Normal of its plane, where given.
        normal: Option<Box<Expr>>,
        /// Radius.
        radius: Box<Expr>,
        /// Subtended angle.
        angle: Box<Expr>,
    },
    /// `curve through table from direction [..] to direction [..];`
    Curve {
        /// The word `curve`.
        area: Area,
        /// The table with the points.
        table: Name,
        /// Directions at its start and end, as far as they are given.
        directions: Box<[Option<Expr>; 2]>,
    },
    /// `curve [..] for s from a to b;`
    Path {
        /// The word `curve`.
        area: Area,
        /// Position.
        position: Expr,
        /// Name of its parameter.
        parameter: Name,
        /// The parameter at the start and at the end.
        range: Box<[Expr; 2]>,
    },
    /// `section_y [..];`
    SectionY {
        /// The word.
        area: Area,
        /// Direction of the section's y axis at the start.
        value: Expr,
    },
    /// `twist 30 deg;`
    Twist {
        /// The word.
        area: Area,
        /// Angle from the start to the end.
        value: Expr,
    },
    /// `modal(n);`, `small(n);`, `rigid;` or `point;`
    Fidelity {
        /// The word.
        word: Name,
        /// Number of modes; none of a body that does not deform.
        count: Option<Expr>,
    },
    /// `initial position [..];` or `initial velocity [..];`
    Initial {
        /// `position` or `velocity`.
        word: Name,
        /// All of it.
        area: Area,
        /// Function of the arclength.
        value: Expr,
    },
    /// `mean_axes;` or `chord;`
    FrameTie {
        /// The word.
        word: Name,
    },
    /// `import "panel.npz" units(mm, t, s);`
    Import {
        /// The word `import`.
        area: Area,
        /// Paths of the files, and where they stand.
        files: Vec<(String, Area)>,
        /// Names of the units of length, mass and time, where they are not SI.
        units: Option<(Vec<Name>, Area)>,
    },
    /// `interface root = node 1;` or `interface tip = nodes [57, 58, 59];`
    Interface {
        /// Its name.
        name: Name,
        /// Numbers of its nodes.
        nodes: Vec<(u64, Area)>,
    },
    /// `interface_modes;`
    InterfaceModes {
        /// The word.
        word: Name,
    },
    /// `damping 0.01;` or `damping 1 ms;`
    Damping {
        /// The word.
        area: Area,
        /// Part of critical damping, or a time.
        value: Expr,
    },
    /// `mesh count * element(..);`
    Mesh {
        /// The word `mesh`.
        area: Area,
        /// Number of elements; from one row of a table to the next where nodes stand at its rows.
        count: Expr,
        /// The table that has the nodes.
        stations: Option<Name>,
        /// Element with its arguments.
        element: Call,
    },
}
