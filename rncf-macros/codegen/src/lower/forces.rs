//! Forces on markers: f(z, z', t) with both tangents, and the potential. Forces that differ in
//! nothing but their markers share their functions.

use super::branches;
use super::courses::{CourseKernel, course_of};
use super::differences::of_differences;
use super::kernel::{Kernel, derivatives};
use super::markers::{Marked, describe, function_name, list, localise};
use super::peaks;
use crate::model::{Expr, Model};
use crate::symbolic::Id;

/// The functions of one or more forces.
#[derive(Clone, Debug)]
pub struct ForceKernels {
    /// Indices of the forces.
    pub of: Vec<usize>,
    /// Those of them that depend on differences of places alone.
    pub of_differences: Vec<usize>,
    /// Forces on the markers.
    pub force: Kernel,
    /// Their derivatives with respect to z and z', where not zero.
    pub tangent: Option<Kernel>,
    /// Potential.
    pub energy: Option<Kernel>,
    /// Where angles in it jump, and its kinks and peaks.
    pub branches: Option<Kernel>,
    /// What it does over its vectors that steps could jump over.
    pub course: Option<CourseKernel>,
}

/// The functions of all forces of a model, each once.
pub fn force_kernels(model: &Model) -> Vec<ForceKernels> {
    let local: Vec<(usize, Vec<Expr>, Option<Expr>)> = model
        .forces
        .iter()
        .map(|force| {
            let components = force.components.iter().flatten();
            (
                force.markers.len(),
                components
                    .map(|component| localise(component, &force.markers))
                    .collect(),
                force.energy.as_ref().map(|energy| localise(energy, &force.markers)),
            )
        })
        .collect();
    let mut names = Vec::new();
    let mut kernels = Vec::new();
    for (index, law) in local.iter().enumerate() {
        if local[..index].contains(law) {
            continue;
        }
        let of: Vec<usize> = (index..local.len()).filter(|&other| local[other] == *law).collect();
        let name = function_name(&model.forces[index].name, &names);
        names.push(name.clone());
        let title = format!(
            "Force {}",
            list(of.iter().map(|&other| model.forces[other].name.as_str()))
        );
        let (count, components, energy) = law;
        let law = Law {
            model,
            count: *count,
            components,
            name,
            title,
            markers: describe(model, &model.forces[index].name, &model.forces[index].markers),
        };
        kernels.push(ForceKernels {
            of_differences: of_differences(model, components, &of, |other| &model.forces[other].markers),
            of,
            force: law.force(),
            tangent: law.tangent(),
            energy: energy.as_ref().map(|energy| law.energy(energy)),
            branches: law.branches(),
            course: course_of(model, components, &law.name, ""),
        });
    }
    kernels
}

struct Law<'m> {
    model: &'m Model,
    count: usize,
    components: &'m [Expr],
    name: String,
    title: String,
    /// What z is.
    markers: String,
}

impl Law<'_> {
    fn kernel(
        &self,
        marked: Marked,
        what: &str,
        title: &str,
        outputs: Vec<(String, Id)>,
        arguments: &[&str],
    ) -> Kernel {
        let title = format!("{}: {title}", self.title);
        let mut kernel = marked.kernel(format!("force_{what}_{}", self.name), title, outputs, arguments);
        for argument in arguments
            .iter()
            .filter_map(|argument| argument.strip_suffix(": &[::rncf::emitted::Vector]"))
        {
            kernel
                .bindings
                .push(format!("let {argument} = &{argument}[..{}];", self.count));
        }
        kernel
    }

    fn in_graph(&self, marked: &mut Marked) -> Vec<Id> {
        self.components
            .iter()
            .map(|component| marked.time.expression(component))
            .collect()
    }

    fn force(&self) -> Kernel {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let force = self.in_graph(&mut marked);
        let graph = &marked.time.graph;
        let outputs = force.iter().enumerate().filter(|&(_, &id)| !graph.is_zero(id));
        let outputs = outputs.map(|(place, &id)| (format!("out[{place}]"), id)).collect();
        let title = "writes f(z, z', t) on its markers, inertial axes; entries that are always zero are left alone.";
        let arguments = [
            "z: &[::rncf::emitted::Vector]",
            "velocity: &[::rncf::emitted::Vector]",
            "out: &mut [f64]",
        ];
        let mut kernel = self.kernel(marked, "value", title, outputs, &arguments);
        kernel.doc.push(self.markers.clone());
        kernel
    }

    fn tangent(&self) -> Option<Kernel> {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let force = self.in_graph(&mut marked);
        marked.time.graph.guard_roots(&force);
        let (z, velocity) = (marked.symbols[0].clone(), marked.symbols[1].clone());
        let mut outputs = derivatives(&mut marked.time.graph, &force, &z, "by_value");
        outputs.extend(derivatives(&mut marked.time.graph, &force, &velocity, "by_velocity"));
        let title = "writes df/dz and df/dz', rows first; entries that are always zero are left alone.";
        let arguments = [
            "z: &[::rncf::emitted::Vector]",
            "velocity: &[::rncf::emitted::Vector]",
            "by_value: &mut [f64]",
            "by_velocity: &mut [f64]",
        ];
        (!outputs.is_empty()).then(|| self.kernel(marked, "tangent", title, outputs, &arguments))
    }

    fn branches(&self) -> Option<Kernel> {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let mut outputs = branches::outputs(&mut marked, self.components);
        let force = self.in_graph(&mut marked);
        outputs.extend(peaks::outputs(&mut marked, &force, outputs.len()));
        let arguments = [
            "z: &[::rncf::emitted::Vector]",
            "velocity: &[::rncf::emitted::Vector]",
            "out: &mut [f64]",
        ];
        (!outputs.is_empty()).then(|| self.kernel(marked, "branches", branches::TITLE, outputs, &arguments))
    }

    fn energy(&self, energy: &Expr) -> Kernel {
        let mut marked = Marked::values_and_rates(self.model, self.count);
        let energy = marked.time.expression(energy);
        let outputs = vec![("*energy".to_string(), energy)];
        self.kernel(
            marked,
            "energy",
            "its potential (J).",
            outputs,
            &["z: &[::rncf::emitted::Vector]", "energy: &mut f64"],
        )
    }
}
