//! What is compared: every formulation on every mesh with every method and tolerance, and the key under which a point is
//! found again.

use crate::app::judged::finer::Judging;
use crate::app::line::chart::method_name;
use crate::app::line::parameters::List;
use crate::app::results::run::RunSettings;
use crate::app::writing::numbers::short;
use crate::hash::hash;
use crate::{AnyModel, Formulation, Method, Options, ParamKind};

/// All that is compared.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// Of those that were asked for, the ones that the model can be built in.
    pub formulations: Vec<Formulation>,
    pub meshes: Vec<Mesh>,
    pub methods: Vec<Method>,
    /// The loosest first.
    pub rtols: Vec<f64>,
    /// Settings of all runs but formulation, method and tolerance; both times are given.
    pub base: RunSettings,
}

/// Values of the counts of which several are tried.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mesh {
    /// Index in [`Model::params`] and value.
    pub counts: Vec<(usize, f64)>,
    /// `elements=8`; empty where the model's own counts are taken.
    pub name: String,
}

/// One run of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Setting {
    pub formulation: Formulation,
    /// Index in [`Grid::meshes`].
    pub mesh: usize,
    pub method: Method,
    pub rtol: f64,
}

impl Grid {
    /// All settings; those of a series, which differ in the tolerance alone, follow each other, the loosest first.
    pub fn settings(&self) -> Vec<Setting> {
        let mut settings = Vec::new();
        for &formulation in &self.formulations {
            for mesh in 0..self.meshes.len() {
                for &method in &self.methods {
                    settings.extend(self.rtols.iter().map(|&rtol| Setting {
                        formulation,
                        mesh,
                        method,
                        rtol,
                    }));
                }
            }
        }
        settings
    }

    /// Index of the mesh whose counts are all largest; full products of lists have one.
    pub fn finest(&self) -> usize {
        let finer = |a: &Mesh, b: &Mesh| a.counts.iter().zip(&b.counts).all(|(a, b)| a.1 >= b.1);
        let is_finest = |mesh: &&Mesh| self.meshes.iter().all(|other| finer(mesh, other));
        let finest = self.meshes.iter().find(is_finest);
        finest
            .and_then(|mesh| self.meshes.iter().position(|other| other == mesh))
            .unwrap_or(0)
    }

    /// The model on a mesh.
    pub fn model(&self, model: &dyn AnyModel, mesh: usize) -> Box<dyn AnyModel> {
        let mut model = model.boxed();
        for &(param, value) in &self.meshes[mesh].counts {
            model.set(param, value);
        }
        model
    }

    /// Settings of a run.
    pub fn run(&self, setting: &Setting) -> RunSettings {
        RunSettings {
            formulation: setting.formulation,
            method: setting.method,
            options: Options {
                rtol: setting.rtol,
                ..self.base.options
            },
            judged: Judging::No,
            ..self.base.clone()
        }
    }

    /// Number that stands for the problem and the settings of a run: the model with all that it was built from, all parameters, the times and
    /// options, the version of this crate.
    pub fn identity(&self, model: &dyn AnyModel, setting: &Setting) -> u64 {
        let model = self.model(model, setting.mesh);
        let params: Vec<u64> = (0..model.params().len())
            .map(|index| model.get(index).to_bits())
            .collect();
        let version = env!("CARGO_PKG_VERSION");
        hash(&format!(
            "{version}\n{:016x}\n{}\n{params:?}\n{:?}",
            model.equations_hash(),
            model.source(),
            self.run(setting)
        ))
    }

    /// A setting in words: `rncf, elements=8, hht:-0.05, rtol 1e-4`.
    pub fn name(&self, setting: &Setting) -> String {
        let mesh = &self.meshes[setting.mesh].name;
        let mesh = if mesh.is_empty() {
            String::new()
        } else {
            format!(", {mesh}")
        };
        format!(
            "{}{mesh}, {}, rtol {:e}",
            setting.formulation.name(),
            method_name(setting.method),
            setting.rtol
        )
    }
}

/// All combinations of the lists' values, or the one mesh of the model where there are none.
///
/// # Errors
/// A list of something that is no count: its values make different problems, not meshes of one.
pub(super) fn meshes(model: &dyn AnyModel, lists: &[List]) -> Result<Vec<Mesh>, String> {
    let mut meshes = vec![Mesh {
        counts: Vec::new(),
        name: String::new(),
    }];
    for list in lists {
        let param = &model.params()[list.param];
        if param.kind != ParamKind::Count {
            return Err(format!(
                "`{}` is given as a list, but a chart is of one problem on several meshes, and lists are of counts: give one value, and another `--out` for each of them",
                param.name
            ));
        }
        let mut values = list.values.clone();
        values.sort_by(f64::total_cmp);
        let with = |mesh: &Mesh, value: f64| {
            let mut counts = mesh.counts.clone();
            counts.push((list.param, value));
            let separator = if mesh.name.is_empty() { "" } else { "; " };
            let name = format!("{}{separator}{}={}", mesh.name, param.name, short(value));
            Mesh { counts, name }
        };
        meshes = (meshes.iter())
            .flat_map(|mesh| values.iter().map(|&value| with(mesh, value)).collect::<Vec<_>>())
            .collect();
    }
    Ok(meshes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    fn list(param: usize, values: &[f64]) -> List {
        List {
            param,
            values: values.to_vec(),
        }
    }

    #[test]
    fn lists_of_counts_make_meshes_and_others_are_refused_by_name() {
        let names = |lists: &[List]| {
            meshes(&Rotor::default(), lists).map(|all| all.into_iter().map(|mesh| mesh.name).collect::<Vec<_>>())
        };
        assert_eq!(names(&[]).unwrap(), [""]);
        assert_eq!(names(&[list(1, &[8.0, 4.0])]).unwrap(), ["coils=4", "coils=8"]);
        let refusal = names(&[list(0, &[1.0, 2.0])]).unwrap_err();
        assert!(refusal.starts_with("`omega` is given as a list, but"), "{refusal}");
    }

    #[test]
    fn identities_differ_where_the_problem_or_the_settings_do() {
        let rotor = Rotor::default();
        let mut grid = Grid {
            formulations: vec![Formulation::Rncf, Formulation::Ancf],
            meshes: meshes(&Rotor::default(), &[list(1, &[2.0, 4.0])]).unwrap(),
            methods: vec![Method::Radau, Method::Hht { alpha: -0.05 }],
            rtols: vec![1e-3, 1e-4],
            base: RunSettings::default(),
        };
        assert_eq!(grid.finest(), 1);
        let settings = grid.settings();
        assert_eq!(settings.len(), 16);
        assert_eq!(grid.name(&settings[3]), "rncf, coils=2, hht:-0.05, rtol 1e-4");
        let mut identities: Vec<u64> = settings.iter().map(|setting| grid.identity(&rotor, setting)).collect();
        let other = Rotor {
            loss: 0.5,
            ..Rotor::default()
        };
        identities.push(grid.identity(&other, &settings[0]));
        grid.base.t_end = Some(3.0);
        identities.push(grid.identity(&rotor, &settings[0]));
        identities.sort_unstable();
        identities.dedup();
        assert_eq!(identities.len(), 18);
    }
}
