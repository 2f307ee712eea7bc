//! The syntax tree: what is written, with the places where it is written; nothing is resolved.

mod expression;
mod statement;

pub use expression::{Argument, Call, Expr, ExprKind, If, Name, Reduced, UnitText};
pub use statement::Statement;

use proc_macro2::{Span, TokenStream};

use crate::errors::Area;

/// A declaration: of a model, or of a component.
#[derive(Clone, Debug)]
pub struct Tree {
    /// Documentation comment.
    pub doc: String,
    /// Visibility as written.
    pub visibility: TokenStream,
    /// Name of the model or component.
    pub name: Name,
    /// Whether it is a component.
    pub is_component: bool,
    /// What a component is told where it is placed.
    pub parameters: Vec<Parameter>,
    /// Components that may be placed in the model.
    pub components: Vec<Tree>,
    /// Items with a name, those of loops included.
    pub items: Vec<Item>,
    /// Loops in order.
    pub loops: Vec<Loop>,
    /// Names of items that could not be read; reported, so that their uses are no mistakes.
    pub lost: Vec<String>,
    /// What parts were told, to be checked by itself.
    pub given: Vec<Given>,
    /// Names of the indices of all loops.
    pub indices: Vec<String>,
    /// Constants that numbers of repetitions were computed from.
    pub counted: Vec<String>,
    /// Whether items stand there more than once, so that one mistake may be found in each of them.
    pub is_copied: bool,
    /// `run` blocks.
    pub runs: Vec<Fields>,
    /// The declaration's text.
    pub source: String,
    /// Whether all of it could be read.
    pub complete: bool,
    /// Where the files of tables begin: the folder of the crate's manifest.
    pub folder: std::path::PathBuf,
}

impl Tree {
    /// A declaration without anything in it.
    pub fn new(name: Name) -> Self {
        Self {
            doc: String::new(),
            visibility: TokenStream::new(),
            name,
            is_component: false,
            parameters: Vec::new(),
            components: Vec::new(),
            items: Vec::new(),
            loops: Vec::new(),
            lost: Vec::new(),
            given: Vec::new(),
            indices: Vec::new(),
            counted: Vec::new(),
            is_copied: false,
            runs: Vec::new(),
            source: String::new(),
            complete: false,
            folder: std::path::PathBuf::new(),
        }
    }

    /// The loops around an item, the outermost first.
    pub fn around(&self, innermost: Option<usize>) -> Vec<usize> {
        let mut around: Vec<usize> =
            std::iter::successors(innermost, |&at| self.loops.get(at).and_then(|inner| inner.outer)).collect();
        around.reverse();
        around
    }

    /// Visibility as text: `pub`, `pub(crate)`, `pub(in crate::a)` or empty.
    pub fn visibility_text(&self) -> String {
        self.visibility
            .to_string()
            .replace("pub (", "pub(")
            .replace(" :: ", "::")
    }
}

/// The keyword of a named item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Keyword {
    Param,
    Const,
    Let,
    Table,
    Material,
    Section,
    Element,
    Motion,
    Frame,
    Rigid,
    Body,
    Fixture,
    Joint,
    Constraint,
    Spring,
    State,
    Load,
    Start,
    Part,
    Output,
    Caution,
}

impl Keyword {
    /// All of them, in the order a user needs them.
    pub const ALL: [Keyword; 21] = [
        Keyword::Param,
        Keyword::Const,
        Keyword::Let,
        Keyword::Table,
        Keyword::Material,
        Keyword::Section,
        Keyword::Element,
        Keyword::Motion,
        Keyword::Frame,
        Keyword::Rigid,
        Keyword::Body,
        Keyword::Fixture,
        Keyword::Joint,
        Keyword::Constraint,
        Keyword::Spring,
        Keyword::State,
        Keyword::Load,
        Keyword::Start,
        Keyword::Part,
        Keyword::Output,
        Keyword::Caution,
    ];

    /// The word in the language.
    pub fn word(self) -> &'static str {
        match self {
            Keyword::Param => "param",
            Keyword::Const => "const",
            Keyword::Let => "let",
            Keyword::Table => "table",
            Keyword::Material => "material",
            Keyword::Section => "section",
            Keyword::Element => "element",
            Keyword::Motion => "motion",
            Keyword::Frame => "frame",
            Keyword::Rigid => "rigid",
            Keyword::Body => "body",
            Keyword::Fixture => "fixture",
            Keyword::Joint => "joint",
            Keyword::Constraint => "constraint",
            Keyword::Spring => "spring",
            Keyword::State => "state",
            Keyword::Load => "load",
            Keyword::Start => "start",
            Keyword::Part => "part",
            Keyword::Output => "output",
            Keyword::Caution => "caution",
        }
    }

    /// What it declares, in a sentence.
    pub fn noun(self) -> &'static str {
        match self {
            Keyword::Rigid => "rigid body",
            other => other.word(),
        }
    }

    /// The keyword with this word.
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|keyword| keyword.word() == word)
    }
}

/// `for index in 0..count { .. }`
#[derive(Clone, Debug)]
pub struct Loop {
    /// Name of the index; `None`: unreadable, reported.
    pub index: Option<Name>,
    /// How often; `None`: unreadable, reported.
    pub count: Option<Expr>,
    /// The loop that it stands in.
    pub outer: Option<usize>,
    /// Its items, those of loops in it included (indices into [`Tree::items`]).
    pub items: std::ops::Range<usize>,
}

/// What a component is told: `name: kind [= value]`
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: Name,
    /// What it is.
    pub kind: ParameterKind,
    /// What it is where nothing is told.
    pub default: Option<Expr>,
}

/// Kinds of what a component is told.
#[derive(Clone, Debug)]
pub enum ParameterKind {
    /// A plain number, `number`.
    Number,
    /// An angle, `angle`.
    Angle,
    /// A quantity, by a unit of it.
    Quantity(UnitText),
    /// A whole number or a count param, `count`.
    Count,
    /// A vector, `vector`.
    Vector,
    /// A place, `place`.
    Place,
    /// A declared item of one of these kinds: `frame`, `body`, `joint`, `motion`, `material`, `section`, `table`.
    Item(&'static [Keyword]),
}

/// A quantity that a part was told.
#[derive(Clone, Debug)]
pub struct Given {
    /// Its name as it is written.
    pub name: String,
    /// What it is to be.
    pub kind: ParameterKind,
    /// What was told.
    pub value: Expr,
}

/// A named item.
#[derive(Clone, Debug)]
pub struct Item {
    /// Documentation comment.
    pub doc: String,
    /// What it declares.
    pub keyword: Keyword,
    /// Its name.
    pub name: Name,
    /// The loop that it stands in (index into [`Tree::loops`]).
    pub repeat: Option<usize>,
    /// Whether it comes from a library, so that it may stand there without use.
    pub is_shared: bool,
    /// Its content.
    pub kind: ItemKind,
}

impl Tree {
    /// The parameters of the program, in their order.
    pub fn params(&self) -> impl Iterator<Item = &Item> {
        self.items.iter().filter(|item| item.is_param())
    }
}

impl Item {
    /// Whether it is a parameter of the program, of whatever kind.
    pub fn is_param(&self) -> bool {
        self.keyword == Keyword::Param || matches!(self.kind, ItemKind::FileTable { is_param: true, .. })
    }
}

/// Content of an item.
#[derive(Clone, Debug)]
pub enum ItemKind {
    /// `param name [: count] = value;` (no value: unreadable, reported)
    Param {
        /// Whether it counts things.
        count: bool,
        /// Default.
        value: Option<Expr>,
    },
    /// `const name = value;`
    Const(Expr),
    /// `let name = value;`
    Let(Expr),
    /// `table name { column = [..] unit; .. }`
    Table(Fields),
    /// `table name = file("path", interpolation = monotone);`
    FileTable {
        /// The path as written, and where.
        path: String,
        /// Where the path stands.
        area: Area,
        /// The arguments behind it.
        arguments: Vec<Argument>,
        /// Whether it is the default of a parameter that names a file.
        is_param: bool,
    },
    /// `material name { field = value; .. }`
    Material(Fields),
    /// `section name { field = value; .. }`
    Section(Fields),
    /// `section name = circle(..);`
    NamedSection(Call),
    /// `element name(section, material) { statements }`
    Element {
        /// `(section)`, where the section says its stiffness by itself.
        of_section: Option<Span>,
        /// What stands in the braces.
        statements: Vec<ElementStatement>,
        /// Whether all statements could be read.
        complete: bool,
    },
    /// `motion name(t) = value;`
    Motion(Expr),
    /// `frame name [in parent] = call;`
    Frame {
        /// `in parent`
        parent: Option<Name>,
        /// How it moves: `rotating(..)`, `free(..)`, ..
        call: Call,
    },
    /// `body name [in frame] { statements }`
    Body {
        /// `in frame`
        frame: Option<Name>,
        /// What stands in the braces.
        statements: Vec<Statement>,
        /// Whether all statements could be read.
        complete: bool,
    },
    /// `rigid name [in parent] { field = value; .. }`
    Rigid {
        /// `in parent`
        parent: Option<Name>,
        /// What stands in the braces; `plane xy;` is a field, too.
        fields: Fields,
    },
    /// `fixture name on place { field = value; .. }`
    Fixture {
        /// Where it sits.
        place: Expr,
        /// What stands in the braces.
        fields: Fields,
    },
    /// `joint name = call;`
    Joint(Call),
    /// A rigid corner between two straight pieces of a body; nobody writes it.
    Corner(Call),
    /// `constraint name = value;`
    Constraint(Expr),
    /// `spring name = call;`
    Spring(Call),
    /// `state name = call;`
    State(Call),
    /// `load name = call;`
    Load(Call),
    /// `output name [: unit] = value;`
    Output {
        /// Unit that it is told in.
        unit: Option<UnitText>,
        /// What is told.
        value: Expr,
    },
    /// `start name = call;`
    Start(Call),
    /// `part name = Component(name = value, ..);`
    Part(Call),
    /// `caution name = "text" [on outputs] if condition;`
    Caution(Box<Caution>),
    /// Unreadable; reported already. Uses of the name are not mistakes.
    Broken,
}

/// A statement of an element.
#[derive(Clone, Debug)]
pub struct ElementStatement {
    /// Documentation comment.
    pub doc: String,
    /// The word it begins with.
    pub word: Name,
    /// What it says.
    pub kind: ElementKind,
}

/// What a statement of an element says.
#[derive(Clone, Debug)]
pub enum ElementKind {
    /// `domain xi in 0..1;`
    Domain {
        /// The coordinate of the unit element.
        coordinate: Name,
    },
    /// `vector s0 = r_x at 0, shape xi - 2*xi^2 + xi^3;`
    Vector {
        /// Its name.
        name: Name,
        /// The derivative of the position that it is.
        of: Name,
        /// Where it sits.
        place: Expr,
        /// Its shape function.
        shape: Expr,
    },
    /// `field a = r_x;`
    Field {
        /// Its name.
        name: Name,
        /// The derivative of the position that it is.
        of: Name,
    },
    /// `coefficient EA: N = material.young * section.area;`
    Coefficient {
        /// Its name.
        name: Name,
        /// Its unit.
        unit: UnitText,
        /// Its value.
        value: Expr,
    },
    /// `inertia r = rhoA;`
    Inertia {
        /// What moves.
        of: Name,
        /// The mass per length.
        coefficient: Name,
    },
    /// `damping = material.damping;`
    Damping(Expr),
    /// `option bending = polynomial | exact;`
    Option {
        /// Its name.
        name: Name,
        /// Its values, the default first.
        values: Vec<Name>,
    },
    /// `let name = value;` or `strain name = value;`
    Definition {
        /// Whether its stress-free value is subtracted.
        is_strain: bool,
        /// Its name.
        name: Name,
        /// Where it applies.
        when: When,
        /// Its value.
        value: Expr,
    },
    /// `energy name = value, stress value, points count, active;`
    Energy {
        /// Its name.
        name: Name,
        /// Where it applies.
        when: When,
        /// Energy per length.
        value: Expr,
        /// Its derivative with respect to its strain, where written.
        stress: Option<Expr>,
        /// Gauss points of its own.
        points: Option<Expr>,
        /// `active`: it has a stress in the shape that a body declares; `undamped`; `viscous`: the stress is of the strain's rate.
        nature: Option<Box<Name>>,
    },
    /// `points 5;`
    Points(Expr),
    /// `also tether;`
    Also(Name),
}

/// `when option is value and .. in plane`
#[derive(Clone, Debug)]
pub struct When {
    /// Options and their values.
    pub options: Vec<(Name, Name)>,
    /// `plane` or `space`.
    pub space: Option<Name>,
}

/// `"text" [on outputs] if left < right`
#[derive(Clone, Debug)]
pub struct Caution {
    /// The sentence.
    pub text: String,
    /// Outputs that it is about.
    pub outputs: Vec<Name>,
    /// The comparison.
    pub comparison: crate::model::Comparison,
    /// Its left side.
    pub left: Expr,
    /// Its right side.
    pub right: Expr,
}

/// `{ name = value; .. }`
#[derive(Clone, Debug)]
pub struct Fields {
    /// The word before the braces.
    pub area: Area,
    /// Fields in order.
    pub fields: Vec<Field>,
    /// Whether all of them could be read.
    pub complete: bool,
}

/// `name = value;`
#[derive(Clone, Debug)]
pub struct Field {
    /// Name.
    pub name: Name,
    /// Value.
    pub value: Expr,
}
