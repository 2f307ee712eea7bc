//! Materials that are given by their strain energy density: what a variant of an element needs of them.

use crate::model::{Body, Expr, Model, Param, SectionShape};
use crate::symbolic::Time;
use crate::symbolic::{Graph, Id};

/// How an energy density is integrated over the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionRule {
    /// Circle and tube: two rings of six points, exact to degree 5 in Y and Z for a full circle.
    Round,
    /// Rectangle: 3 x 3 Gauss points.
    Rectangle,
}

impl SectionRule {
    /// Number of points.
    pub fn count(self) -> usize {
        match self {
            Self::Round => 12,
            Self::Rectangle => 9,
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Round => "round",
            Self::Rectangle => "rectangle",
        }
    }
}

/// A strain energy density, integrated over a section.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name in the declaration.
    pub name: String,
    /// Energy per volume as a function of [`Expr::Strain`].
    pub energy: Expr,
    /// The parameters of the model: name, and whether it counts things.
    params: Vec<(String, bool)>,
    /// Integration over the section.
    pub section: SectionRule,
}

/// A graph with a density and the symbols of the strains.
pub struct Density {
    /// The graph.
    pub graph: Graph,
    /// Energy per volume.
    pub energy: Id,
    /// Symbols of xx, yy, zz, xy, xz, yz.
    pub strains: [Id; 6],
}

impl Material {
    /// The material of a body; `None` where it is given by its moduli.
    pub fn of(model: &Model, body: &Body) -> Option<Self> {
        let section = match body.shape {
            SectionShape::Rectangle { .. } => SectionRule::Rectangle,
            SectionShape::Circle { .. } | SectionShape::Tube { .. } => SectionRule::Round,
            SectionShape::General { .. } => return None,
        };
        let params = model.params.iter();
        Some(Self {
            name: body.material_name.clone(),
            energy: body.strain_energy.clone()?,
            params: params.map(|param| (param.name.clone(), param.is_count)).collect(),
            section,
        })
    }

    /// Part of the variant's name.
    pub fn suffix(&self) -> String {
        format!("_of_{}_{}", crate::model::identifier(&self.name), self.section.word())
    }

    /// Names of the parameters, the fields of `row.material`.
    pub fn params(&self) -> Vec<&(String, bool)> {
        let used = |at: usize| mentions(&self.energy, at);
        let all = self.params.iter().enumerate();
        all.filter(|&(at, _)| used(at)).map(|(_, param)| param).collect()
    }

    /// The density in a graph of its own; parameters are read from `model`.
    pub fn density(&self) -> Density {
        let param = |(name, is_count): &(String, bool)| Param {
            name: name.clone(),
            doc: String::new(),
            unit: String::new(),
            unit_si: 1.0,
            dimension: [0; 6],
            default: 1.0,
            is_count: *is_count,
            is_table: false,
        };
        let model = Model {
            params: self.params.iter().map(param).collect(),
            ..Model::default()
        };
        let mut time = Time::new(&model);
        let energy = time.expression(&self.energy);
        let strains = std::array::from_fn(|component| time.strain(component));
        Density {
            graph: time.graph,
            energy,
            strains,
        }
    }
}

/// Whether an expression depends on a parameter.
fn mentions(expr: &Expr, param: usize) -> bool {
    expr.contains(&|expr| matches!(expr, Expr::Param(id) if id.0 == param))
}
