//! What a generated model says of itself: parameters, outputs, and how it becomes a scene; and what a scene tells.

mod bodies;
mod circulating;
mod composition;
mod derived;
mod operands;
mod picture;
mod scene;
mod uniform;

pub use crate::emitted::Fidelity;
pub use bodies::{DescribedBody, ExportedBody, MassProperties, MeshError, SectionBody, SectionState};
pub use circulating::{Beside, Circulating, ROUND};
pub use composition::{Composition, Motion};
pub use derived::{ConstantArray, KernelCount};
pub use operands::Operands;
pub use picture::{Configuration, Curve, Sign, SignKind, SignPlace};
pub use scene::{FrameState, Pose, Scene, Warning};
pub use uniform::{Kind, Spin, Uniform};

use crate::emitted::TableForm;
use crate::error::ModelError;

/// How the bodies are described.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Formulation {
    /// Referenced nodal coordinates: nodal vectors in the body's moving frame.
    #[default]
    Rncf,
    /// Absolute nodal coordinates: nodal vectors in the inertial frame.
    Ancf,
}

impl Formulation {
    /// The name on the command line: `rncf` or `ancf`.
    pub fn name(self) -> &'static str {
        match self {
            Formulation::Rncf => "rncf",
            Formulation::Ancf => "ancf",
        }
    }
}

/// A formulation chosen by type: [`Rncf`] or [`Ancf`].
pub trait Formulated {
    /// The formulation that the type stands for.
    const FORMULATION: Formulation;
}

/// Referenced nodal coordinate formulation.
#[derive(Clone, Copy, Debug)]
pub struct Rncf;

/// Absolute nodal coordinate formulation.
#[derive(Clone, Copy, Debug)]
pub struct Ancf;

impl Formulated for Rncf {
    const FORMULATION: Formulation = Formulation::Rncf;
}

impl Formulated for Ancf {
    const FORMULATION: Formulation = Formulation::Ancf;
}

/// What becomes of conditions that are linear in the nodal vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Joints {
    /// Eliminated where their direction does not turn: no multiplier, no index, no drift.
    #[default]
    Eliminated,
    /// All kept as constraints with multipliers (`--no-elimination`).
    Multipliers,
}

/// How the bodies start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Start {
    /// Undeformed and at rest in their frames.
    #[default]
    Rest,
    /// Undeformed, with the velocities that joints and drives ask for.
    Moving,
    /// In relative equilibrium with the spin at the initial time.
    Steady,
}

impl Start {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Rest, Self::Moving, Self::Steady];

    /// As it stands in models, on the command line and in summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rest => "rest",
            Self::Moving => "moving",
            Self::Steady => "steady",
        }
    }
}

/// Kind of a run-time parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParamKind {
    /// A quantity with a unit.
    Quantity,
    /// A number of things: a whole number of at least 1.
    Count,
    /// A file with a table, as [`TableFile::number`](crate::emitted::TableFile::number).
    Table(&'static TableForm),
}

/// A run-time parameter of a model.
#[derive(Clone, Copy, Debug)]
pub struct Param {
    /// Name in the declaration.
    pub name: &'static str,
    /// Quantity or count.
    pub kind: ParamKind,
    /// Unit symbol in the declaration, e.g. `rad/s`; `1` where dimensionless.
    pub unit: &'static str,
    /// One `unit` in SI.
    pub unit_si: f64,
    /// Exponents of m, kg, s, K, A, angle; the last one tells rad/s from 1/s.
    pub dimension: [i8; 6],
    /// Default, SI.
    pub default: f64,
    /// Documentation comment of the declaration.
    pub doc: &'static str,
}

/// An output of a model: a scalar or a vector.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// Name in the declaration.
    pub name: &'static str,
    /// Unit symbol of the values, e.g. `m`, `N m`, `deg/s`, `1`.
    pub unit: &'static str,
    /// Exponent of time in their dimension: -1 of velocities, -2 of accelerations and forces.
    pub time_exponent: f64,
    /// Component suffixes: empty for a scalar, `["x", "y", "z"]` for a vector.
    pub components: &'static [&'static str],
    /// Documentation comment of the declaration.
    pub doc: &'static str,
}

impl Output {
    /// Number of its columns.
    pub fn width(&self) -> usize {
        self.components.len().max(1)
    }
}

/// The run that the declaration asks for by default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunDefaults {
    /// End time, s.
    pub t_end: f64,
    /// Time between two rows of the history, s.
    pub every: f64,
    /// How the bodies start.
    pub start: Start,
}

/// What a reader of the results must know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Caution {
    /// Name in the declaration.
    pub name: &'static str,
    /// The sentence.
    pub text: &'static str,
    /// Outputs that it is about, as indices into [`Model::outputs`]; none: the whole run.
    pub outputs: &'static [usize],
}

/// A model declared with `model!`: its parameters are the fields of the generated struct.
pub trait Model: Default + Clone + Send + Sync + 'static {
    /// Name of the model.
    const NAME: &'static str;
    /// Documentation comment of the model.
    const DOC: &'static str;
    /// Text of the declaration as the compiler saw it.
    const SOURCE: &'static str;
    /// Hash of the equations as the generator wrote them, with all that they are made of: the text, libraries, rows of tables,
    /// imported files. The same models have the same, on all machines.
    const EQUATIONS_HASH: u64;
    /// What the generator left out or chose, one sentence each, for summaries.
    const NOTES: &'static [&'static str];
    /// Constant tensors of its unit elements.
    const CONSTANTS: &'static [ConstantArray];
    /// Functions that were derived for it.
    const KERNELS: &'static [KernelCount];

    /// All parameters, in the order of the declaration.
    fn params() -> &'static [Param];
    /// All outputs, in the order of the declaration.
    fn outputs() -> &'static [Output];
    /// Value of parameter `index` in SI.
    fn get(&self, index: usize) -> f64;
    /// Sets parameter `index` to a value in SI; a count is given as a whole number.
    fn set(&mut self, index: usize, value: f64);
    /// The default run with these parameters.
    fn run(&self) -> RunDefaults;
    /// The cautions whose conditions hold with these parameters for a run up to `t_end`, s; 0 for equilibria
    /// and modes, which last no time.
    fn cautions(&self, _t_end: f64) -> Vec<Caution> {
        Vec::new()
    }
    /// Builds the scene in the formulation chosen at run time, with bodies, by their names, described otherwise than
    /// they are declared: `("rod", Fidelity::Rigid)`.
    ///
    /// # Errors
    /// A parameter that makes no physical sense, and a body that is not there or cannot be described so, by name.
    fn build_as(
        &self,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError>;

    /// Builds the scene in the formulation chosen at run time, with all bodies as they are declared.
    ///
    /// # Errors
    /// A parameter that makes no physical sense, by name.
    fn build(&self, formulation: Formulation, joints: Joints) -> Result<Box<dyn Scene>, ModelError> {
        self.build_as(formulation, joints, &[])
    }

    /// Builds the scene in the formulation chosen by type, e.g. `model.scene::<Ancf>()`.
    ///
    /// # Errors
    /// As [`Model::build`].
    fn scene<F: Formulated>(&self) -> Result<Box<dyn Scene>, ModelError> {
        self.build(F::FORMULATION, Joints::Eliminated)
    }
}

/// A [`Model`] whose type is not known: what reads, runs and reports models is compiled once with it.
pub trait AnyModel: Send + Sync {
    /// [`Model::NAME`].
    fn name(&self) -> &'static str;
    /// [`Model::DOC`].
    fn doc(&self) -> &'static str;
    /// [`Model::SOURCE`].
    fn source(&self) -> &'static str;
    /// [`Model::EQUATIONS_HASH`].
    fn equations_hash(&self) -> u64;
    /// [`Model::NOTES`].
    fn notes(&self) -> &'static [&'static str];
    /// [`Model::CONSTANTS`].
    fn constants(&self) -> &'static [ConstantArray];
    /// [`Model::KERNELS`].
    fn kernels(&self) -> &'static [KernelCount];
    /// [`Model::params`].
    fn params(&self) -> &'static [Param];
    /// [`Model::outputs`].
    fn outputs(&self) -> &'static [Output];
    /// [`Model::get`].
    fn get(&self, index: usize) -> f64;
    /// [`Model::set`].
    fn set(&mut self, index: usize, value: f64);
    /// [`Model::run`].
    fn run(&self) -> RunDefaults;
    /// [`Model::cautions`].
    fn cautions(&self, t_end: f64) -> Vec<Caution>;
    /// [`Model::build_as`].
    ///
    /// # Errors
    /// As there.
    fn build_as(
        &self,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError>;
    /// [`Model::build`].
    ///
    /// # Errors
    /// As there.
    fn build(&self, formulation: Formulation, joints: Joints) -> Result<Box<dyn Scene>, ModelError> {
        self.build_as(formulation, joints, &[])
    }

    /// A copy.
    fn boxed(&self) -> Box<dyn AnyModel>;
}

impl<M: Model> AnyModel for M {
    fn name(&self) -> &'static str {
        M::NAME
    }

    fn doc(&self) -> &'static str {
        M::DOC
    }

    fn source(&self) -> &'static str {
        M::SOURCE
    }

    fn equations_hash(&self) -> u64 {
        M::EQUATIONS_HASH
    }

    fn notes(&self) -> &'static [&'static str] {
        M::NOTES
    }

    fn constants(&self) -> &'static [ConstantArray] {
        M::CONSTANTS
    }

    fn kernels(&self) -> &'static [KernelCount] {
        M::KERNELS
    }

    fn params(&self) -> &'static [Param] {
        M::params()
    }

    fn outputs(&self) -> &'static [Output] {
        M::outputs()
    }

    fn get(&self, index: usize) -> f64 {
        Model::get(self, index)
    }

    fn set(&mut self, index: usize, value: f64) {
        Model::set(self, index, value);
    }

    fn run(&self) -> RunDefaults {
        Model::run(self)
    }

    fn cautions(&self, t_end: f64) -> Vec<Caution> {
        Model::cautions(self, t_end)
    }

    fn build_as(
        &self,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError> {
        Model::build_as(self, formulation, joints, fidelity)
    }

    fn boxed(&self) -> Box<dyn AnyModel> {
        Box::new(self.clone())
    }
}

/// Checks that every quantity is a number and every count at least one.
///
/// # Errors
/// The parameter by name.
pub fn check_params<M: Model>(model: &M) -> Result<(), ModelError> {
    check_values(M::params(), &|index| model.get(index))
}

/// As [`check_params`], compiled once for all models.
fn check_values(params: &[Param], value_of: &dyn Fn(usize) -> f64) -> Result<(), ModelError> {
    for (index, param) in params.iter().enumerate() {
        let value = value_of(index);
        if let (ParamKind::Table(_), false) = (param.kind, value.is_finite()) {
            return Err(ModelError::new(format!(
                "parameter `{}` has the number of no file that was read: set it to one by `TableFile::read`",
                param.name
            )));
        }
        if !value.is_finite() {
            return Err(ModelError::new(format!(
                "parameter `{}` is {value}: give it a finite value",
                param.name
            )));
        }
        if param.kind == ParamKind::Count && value < 1.0 {
            return Err(ModelError::new(format!(
                "parameter `{}` is {value}: it counts things and must be at least 1",
                param.name
            )));
        }
    }
    Ok(())
}
