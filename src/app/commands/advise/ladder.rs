//! What stands on the ladder: descriptions of the bodies, meshes, and what can be chosen at all.

use crate::app::line::parameters::List;
use crate::model::{DescribedBody, Fidelity};
use crate::{AnyModel, Formulation, Joints, ModelError, ParamKind};

/// Numbers of modes on the ladder.
const MODES: [usize; 4] = [1, 2, 4, 8];
/// Meshes beside that of the model, as multiples of its counts.
const MESHES: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];

/// One description of the bodies on one mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Setting {
    /// Params that count elements, and their values.
    pub counts: Vec<(usize, f64)>,
    /// All bodies that are described in one way or another.
    pub fidelity: Vec<(String, Fidelity)>,
}

/// What can be chosen of a model.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Choices {
    /// Bodies that may be described otherwise, with their declared description.
    pub bodies: Vec<(String, Fidelity)>,
    /// Meshes from coarse to fine; a single empty one where no param counts elements.
    pub meshes: Vec<Vec<(usize, f64)>>,
    /// The model's own mesh.
    pub declared: Vec<(usize, f64)>,
    /// Whether there are bodies beside them that deform.
    pub has_others: bool,
    /// What is not questioned, one sentence each.
    pub notes: Vec<String>,
}

/// Position on the ladder from cheap to rich.
fn rank(fidelity: Fidelity) -> usize {
    match fidelity {
        Fidelity::Point => 0,
        Fidelity::Rigid => 1,
        Fidelity::Modal(count) | Fidelity::Small(count) => 1 + count,
        Fidelity::Full => usize::MAX,
    }
}

/// All descriptions from cheap to rich.
pub(super) fn descriptions() -> Vec<Fidelity> {
    let modes = MODES.into_iter().map(Fidelity::Modal);
    [Fidelity::Point, Fidelity::Rigid]
        .into_iter()
        .chain(modes)
        .chain([Fidelity::Full])
        .collect()
}

/// Those from cheap to rich that a body which is declared so can have.
pub(super) fn within(declared: Fidelity) -> Vec<Fidelity> {
    let all = descriptions().into_iter();
    all.filter(|fidelity| declared.deforms() || !fidelity.deforms())
        .collect()
}

impl Choices {
    /// Finds what can be chosen: bodies that are not repeated, and params on which the number of elements depends.
    ///
    /// # Errors
    /// That of the scene as declared, or of a list that is no mesh.
    pub fn of(model: &dyn AnyModel, formulation: Formulation, joints: Joints, lists: &[List]) -> Result<Self, String> {
        let scene = model.build(formulation, joints).map_err(|error| error.to_string())?;
        let all = scene.bodies();
        let counted = counted(model, &all, |model| {
            model.build(formulation, joints).map(|scene| scene.bodies())
        });
        let has_others = all
            .iter()
            .any(|body| body.repetitions.is_some() && body.fidelity.deforms());
        let mut notes = Vec::new();
        let mut bodies = Vec::new();
        for body in &all {
            match body.repetitions {
                Some(_) => notes.push(format!("`{}` is repeated and keeps all its nodal vectors.", body.name)),
                None => bodies.push((body.name.to_owned(), body.fidelity)),
            }
            if !body.fidelity.deforms() {
                notes.push(format!(
                    "`{}` is declared `{}`: nothing richer is tried.",
                    body.name, body.fidelity
                ));
            }
        }
        for body in all.iter().filter(|body| body.fidelity.deforms()) {
            if !counted.iter().any(|(_, names)| names.contains(&body.name)) {
                notes.push(format!(
                    "No param counts the elements of `{}`: its mesh is not questioned.",
                    body.name
                ));
            }
        }
        let params: Vec<usize> = counted.iter().map(|(param, _)| *param).collect();
        let declared = params.iter().map(|&param| {
            let is_listed = lists.iter().any(|list| list.param == param);
            (
                param,
                if is_listed {
                    model.params()[param].default
                } else {
                    model.get(param)
                },
            )
        });
        let declared: Vec<(usize, f64)> = declared.collect();
        let meshes = if lists.is_empty() {
            scaled(&declared)
        } else {
            listed(model, &declared, lists)?
        };
        Ok(Self {
            bodies,
            meshes,
            declared,
            has_others,
            notes,
        })
    }

    /// The model as it is declared.
    pub fn as_declared(&self) -> Setting {
        Setting {
            counts: self.declared.clone(),
            fidelity: self.bodies.clone(),
        }
    }

    /// All bodies described alike, as far as their declaration allows, on a mesh.
    pub fn together(&self, fidelity: Fidelity, mesh: usize) -> Setting {
        let at_most = |declared: Fidelity| {
            let own = within(declared).into_iter().rev();
            own.clone().find(|own| rank(*own) <= rank(fidelity)).unwrap_or(declared)
        };
        let bodies = self.bodies.iter();
        Setting {
            counts: self.meshes[mesh].clone(),
            fidelity: bodies
                .map(|(name, declared)| (name.clone(), at_most(*declared)))
                .collect(),
        }
    }

    /// Whether the mesh of a setting counts: something deforms.
    pub fn deforms(&self, setting: &Setting) -> bool {
        self.has_others || setting.fidelity.iter().any(|(_, fidelity)| fidelity.deforms())
    }

    /// The setting with one body described in another way.
    pub fn with(setting: &Setting, body: usize, fidelity: Fidelity) -> Setting {
        let mut setting = setting.clone();
        setting.fidelity[body].1 = fidelity;
        setting
    }

    /// Descriptions of a body below the given one, from rich to cheap.
    pub fn below(&self, body: usize, fidelity: Fidelity) -> Vec<Fidelity> {
        let own = within(self.bodies[body].1).into_iter().rev();
        own.filter(|own| rank(*own) < rank(fidelity)).collect()
    }

    /// A setting in words: `modal(2)`, `full, elements = 8`, `crank: rigid, rod: modal(2)`.
    pub fn name(&self, model: &dyn AnyModel, setting: &Setting) -> String {
        let mut words: Vec<String> = Vec::new();
        match &setting.fidelity[..] {
            [] => words.push("as declared".into()),
            [(_, first), others @ ..] if others.iter().all(|(_, other)| other == first) => {
                words.push(first.to_string());
            }
            all => words.extend(all.iter().map(|(body, fidelity)| format!("{body}: {fidelity}"))),
        }
        if self.meshes.len() > 1 {
            words.extend(
                setting
                    .counts
                    .iter()
                    .map(|&(param, value)| format!("{} = {value}", model.params()[param].name)),
            );
        }
        words.join(", ")
    }
}

/// Params that count elements, with the bodies whose elements they count.
fn counted(
    model: &dyn AnyModel,
    bodies: &[DescribedBody],
    bodies_of: impl Fn(&dyn AnyModel) -> Result<Vec<DescribedBody>, ModelError>,
) -> Vec<(usize, Vec<&'static str>)> {
    let mut found = Vec::new();
    for (index, param) in model.params().iter().enumerate() {
        if param.kind != ParamKind::Count {
            continue;
        }
        let mut other = model.boxed();
        other.set(index, 2.0 * model.get(index));
        // A count with which there is no scene counts something else.
        let Ok(others) = bodies_of(other.as_ref()) else {
            continue;
        };
        let alike = |(a, b): (&DescribedBody, &DescribedBody)| a.name == b.name && a.repetitions == b.repetitions;
        if others.len() != bodies.len() || !bodies.iter().zip(&others).all(alike) {
            continue;
        }
        let pairs = bodies.iter().zip(&others);
        let names: Vec<&'static str> = pairs
            .filter(|(a, b)| a.elements != b.elements)
            .map(|(a, _)| a.name)
            .collect();
        if !names.is_empty() {
            found.push((index, names));
        }
    }
    found
}

/// Meshes around the declared one, each twice as fine as the one before.
fn scaled(declared: &[(usize, f64)]) -> Vec<Vec<(usize, f64)>> {
    let mesh = |factor: f64| -> Vec<(usize, f64)> {
        let count = |&(param, value): &(usize, f64)| (param, (value * factor).round().max(1.0));
        declared.iter().map(count).collect()
    };
    let mut meshes: Vec<_> = MESHES.into_iter().map(mesh).collect();
    meshes.dedup();
    meshes
}

/// Meshes that are given, from coarse to fine.
fn listed(model: &dyn AnyModel, declared: &[(usize, f64)], lists: &[List]) -> Result<Vec<Vec<(usize, f64)>>, String> {
    for list in lists {
        let name = model.params()[list.param].name;
        if declared.iter().all(|(param, _)| *param != list.param) {
            return Err(format!(
                "`{name}` is given as a list but counts no elements: `advise` varies meshes and descriptions of bodies alone"
            ));
        }
        if list.values.len() != lists[0].values.len() {
            return Err(format!(
                "`{}` and `{name}` are given as lists of different lengths: the meshes take one of each, from coarse to fine",
                model.params()[lists[0].param].name
            ));
        }
    }
    let sorted: Vec<(usize, Vec<f64>)> = lists
        .iter()
        .map(|list| {
            let mut values = list.values.clone();
            values.sort_by(f64::total_cmp);
            (list.param, values)
        })
        .collect();
    let count = |&(param, value): &(usize, f64), mesh: usize| {
        let list = sorted.iter().find(|(other, _)| *other == param);
        (param, list.map_or(value, |(_, values)| values[mesh]))
    };
    let meshes = 0..lists[0].values.len();
    Ok(meshes
        .map(|mesh| declared.iter().map(|entry| count(entry, mesh)).collect())
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn choices() -> Choices {
        Choices {
            bodies: vec![
                ("crank".into(), Fidelity::Full),
                ("rod".into(), Fidelity::Small(3)),
                ("stub".into(), Fidelity::Rigid),
            ],
            meshes: scaled(&[(1, 8.0)]),
            declared: vec![(1, 8.0)],
            has_others: false,
            notes: Vec::new(),
        }
    }

    fn words(setting: &Setting) -> String {
        let words: Vec<String> = setting
            .fidelity
            .iter()
            .map(|(_, fidelity)| fidelity.to_string())
            .collect();
        words.join(" ")
    }

    #[test]
    fn bodies_are_described_alike_as_far_as_they_can_be() {
        let choices = choices();
        assert_eq!(words(&choices.together(Fidelity::Full, 0)), "full full rigid");
        assert_eq!(
            words(&choices.together(Fidelity::Modal(2), 0)),
            "modal(2) modal(2) rigid"
        );
        assert_eq!(words(&choices.together(Fidelity::Point, 0)), "point point point");
        assert_eq!(words(&choices.as_declared()), "full small(3) rigid");
    }

    #[test]
    fn what_lies_below_a_description_comes_from_rich_to_cheap() {
        let below = choices().below(0, Fidelity::Modal(4));
        let expected = [Fidelity::Modal(2), Fidelity::Modal(1), Fidelity::Rigid, Fidelity::Point];
        assert_eq!(below, expected);
        assert_eq!(choices().below(2, Fidelity::Rigid), [Fidelity::Point]);
        assert_eq!(choices().below(1, Fidelity::Full)[0], Fidelity::Modal(8));
    }

    #[test]
    fn meshes_double_and_stay_whole() {
        let counts = |declared: f64| -> Vec<f64> { scaled(&[(0, declared)]).iter().map(|mesh| mesh[0].1).collect() };
        assert_eq!(counts(8.0), [2.0, 4.0, 8.0, 16.0, 32.0]);
        assert_eq!(counts(1.0), [1.0, 2.0, 4.0]);
        assert_eq!(scaled(&[]), [Vec::new()]);
    }
}
