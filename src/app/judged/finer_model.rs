//! A model whose scenes have finer meshes.

use super::finer::FINER;
use crate::model::{ConstantArray, Fidelity, KernelCount, Output, Param, RunDefaults};
use crate::{AnyModel, Caution, Formulation, Joints, ModelError, Scene};

/// A model with so many elements for each one, and bodies that deform without modes.
pub(in crate::app) struct FinerModel {
    pub model: Box<dyn AnyModel>,
    pub times: usize,
}

impl FinerModel {
    /// With [`FINER`] elements for each one.
    pub fn of(model: &dyn AnyModel) -> Self {
        Self {
            model: model.boxed(),
            times: FINER,
        }
    }
}

impl AnyModel for FinerModel {
    fn name(&self) -> &'static str {
        self.model.name()
    }

    fn doc(&self) -> &'static str {
        self.model.doc()
    }

    fn source(&self) -> &'static str {
        self.model.source()
    }

    fn equations_hash(&self) -> u64 {
        self.model.equations_hash()
    }

    fn notes(&self) -> &'static [&'static str] {
        self.model.notes()
    }

    fn constants(&self) -> &'static [ConstantArray] {
        self.model.constants()
    }

    fn kernels(&self) -> &'static [KernelCount] {
        self.model.kernels()
    }

    fn params(&self) -> &'static [Param] {
        self.model.params()
    }

    fn outputs(&self) -> &'static [Output] {
        self.model.outputs()
    }

    fn get(&self, index: usize) -> f64 {
        self.model.get(index)
    }

    fn set(&mut self, index: usize, value: f64) {
        self.model.set(index, value);
    }

    fn run(&self) -> RunDefaults {
        self.model.run()
    }

    fn cautions(&self, t_end: f64) -> Vec<Caution> {
        self.model.cautions(t_end)
    }

    /// The scene of the model itself where it has no mesh.
    fn build_as(
        &self,
        formulation: Formulation,
        joints: Joints,
        fidelity: &[(String, Fidelity)],
    ) -> Result<Box<dyn Scene>, ModelError> {
        let build = || self.model.build_as(formulation, joints, fidelity);
        build()?.with_finer_meshes(self.times).unwrap_or_else(build)
    }

    fn boxed(&self) -> Box<dyn AnyModel> {
        Box::new(Self {
            model: self.model.boxed(),
            times: self.times,
        })
    }
}
