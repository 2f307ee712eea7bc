//! Loads per length and gravity fields in the `Parts` implementation.

use std::fmt::Write;

use super::kernel::fits_lanes;
use super::parts::Parts;
use crate::lower::courses::CourseKernel;
use crate::lower::density::DensityKernels;
use crate::lower::{Equations, Kernel, camel_case};
use crate::model::Density;

/// Arguments of the functions of four elements.
const FOUR: &str = "density: usize, elements: &[(usize, usize); 4], values: &[[f64; 4]], q: &[[f64; 4]]";
const VECTORS: &str = "&[::rncf::emitted::Vector]";

impl Equations {
    /// The functions of loads per length and fields in the order of the text, and whether each is written for four elements side by
    /// side, too.
    pub(super) fn load_kernels(&self) -> Vec<(&Kernel, bool)> {
        let mut kernels = Vec::new();
        for density in &self.densities {
            let values = density.value.iter().chain(&density.gradient);
            kernels.extend(values.map(|kernel| (kernel, false)));
            kernels.extend([&density.force, &density.tangent].map(|kernel| (kernel, fits_lanes(kernel))));
        }
        let mut single: Vec<&Kernel> = Vec::new();
        for distributed in &self.distributed {
            single.push(&distributed.force);
            single.extend(&distributed.tangent);
            single.extend(&distributed.gaps);
            single.extend(distributed.course.as_ref().and_then(CourseKernel::kernel));
        }
        for around in &self.around {
            single.extend(&around.kernels);
            single.extend(&around.gaps);
            single.extend(around.course.as_ref().and_then(CourseKernel::kernel));
        }
        for field in &self.fields {
            single.push(&field.value);
            single.extend(&field.gradient);
        }
        kernels.extend(single.into_iter().map(|kernel| (kernel, false)));
        kernels
    }
}

impl Parts<'_> {
    /// Loads per length and their functions.
    pub(super) fn densities(&self) -> String {
        if self.model.densities.is_empty() {
            return String::new();
        }
        let entries = self.model.densities.iter().zip(&self.equations.densities).enumerate();
        let entries = entries.map(|(kind, (density, kernels))| {
            let repeat = self.model.bodies[density.body.0].repeat;
            let markers: Vec<usize> = density.markers.iter().map(|marker| marker.0).collect();
            let instance = if repeat.is_some() { " + instance" } else { "" };
            let entry = format!(
                "::rncf::emitted::DensitySpec {{ name: {:?}, kind: {kind}, body: {}{instance}, markers: &{markers:?}, values: {} }}",
                density.name,
                self.first_of(density.body),
                kernels.values
            );
            (repeat, entry)
        });
        let entries: Vec<_> = entries.collect();
        let mut text = self.list("densities", "DensitySpec", &entries);
        text += &self.density_values();
        for (name, what, results) in [
            ("density_force4", "force", "force: &mut [[f64; 4]]"),
            (
                "density_tangent4",
                "tangent",
                "by_q: &mut [[f64; 4]], by_values: &mut [[f64; 4]]",
            ),
        ] {
            let arms = self.by_density(|density, kernels| {
                let kernel = if what == "force" {
                    &kernels.force
                } else {
                    &kernels.tangent
                };
                self.of_four(density, kernels, kernel, results)
            });
            let _ = writeln!(
                text,
                "fn {name}(&self, {FOUR}, {results}) {{\n{}{arms}}}",
                self.density_kind("_")
            );
        }
        text
    }

    /// Makes of a global number of a density its declaration, and the number of the repetition.
    fn density_kind(&self, instance: &str) -> String {
        let repeats = self.model.densities.iter();
        let counts = repeats.map(|density| match self.model.bodies[density.body.0].repeat {
            Some(repeat) => format!("self.counts[{}]", repeat.0),
            None => "1".to_string(),
        });
        let counts: Vec<String> = counts.collect();
        if counts.iter().all(|count| count == "1") {
            return String::new();
        }
        format!(
            "let (density, {instance}) = ::rncf::emitted::declared(&[{}], density);\n",
            counts.join(", ")
        )
    }

    /// One arm for each density.
    fn by_density(&self, arm: impl Fn(&Density, &DensityKernels) -> String) -> String {
        let all = self.model.densities.iter().zip(&self.equations.densities).enumerate();
        let arms = all.map(|(index, (density, kernels))| format!("{index} => {{\n{}}}\n", arm(density, kernels)));
        format!("match density {{\n{}_ => {{}}\n}}\n", arms.collect::<String>())
    }

    fn density_values(&self) -> String {
        let call = |density: &Density, kernel: Option<&Kernel>, out: &str| {
            let Some(kernel) = kernel else { return String::new() };
            let index = match self.model.bodies[density.body.0].repeat {
                Some(_) => "instance as f64, ",
                None => "",
            };
            format!("{}(&self.model, t, {index}z, velocity, {out});\n", kernel.name)
        };
        let values = self.by_density(|density, kernels| call(density, kernels.value.as_ref(), "out"));
        let gradient = self.by_density(|density, kernels| call(density, kernels.gradient.as_ref(), "gradient"));
        let kind = self.density_kind("instance");
        format!(
            "fn density_values(&self, density: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, out: &mut [f64]) {{\n{kind}{values}}}\n\
             fn density_values_gradient(&self, density: usize, t: f64, z: {VECTORS}, velocity: {VECTORS}, gradient: &mut [f64]) {{\ngradient.fill(0.0);\n{kind}{gradient}}}\n"
        )
    }

    /// Calls a kernel for four elements, or for one after the other.
    fn of_four(&self, density: &Density, kernels: &DensityKernels, kernel: &Kernel, results: &str) -> String {
        let body = &self.model.bodies[density.body.0];
        let size = self.variant(density.body.0).variant.size(self.library);
        let length = match body.repeat {
            Some(_) if body.varies() => format!(
                "elements.map(|(body, element)| self.row_{}[self.kind(body).1][element].length)",
                body.identifier()
            ),
            Some(_) => format!(
                "elements.map(|(body, _)| self.row_{}[self.kind(body).1].length)",
                body.identifier()
            ),
            None if body.varies() => format!(
                "elements.map(|(_, element)| self.row_{}[element].length)",
                body.identifier()
            ),
            None => format!("[self.row_{}.length; 4]", body.identifier()),
        };
        let results: Vec<&str> = results
            .split(", ")
            .filter_map(|result| Some(result.split_once(": ")?.0))
            .collect();
        let number = |result: &str| match result {
            "force" => size,
            "by_q" => size * size,
            _ => size * kernels.values,
        };
        let own: String = results
            .iter()
            .map(|result| format!("let mut own_{result} = [0.0; {}];\n", number(result)))
            .collect();
        let arguments: Vec<String> = results.iter().map(|result| format!("&mut own_{result}")).collect();
        let sums: String = results
            .iter()
            .map(|result| format!("::rncf::emitted::add_lane({result}, lane, &own_{result});\n"))
            .collect();
        let one_by_one = format!(
            "for lane in 0..4 {{\n{own}let values: [f64; {}] = ::rncf::emitted::lane(values, lane);\nlet q: [f64; {size}] = ::rncf::emitted::lane(q, lane);\n{}(&[length[lane]], &values, &q, {});\n{sums}}}\n",
            kernels.values,
            kernel.name,
            arguments.join(", ")
        );
        if !fits_lanes(kernel) {
            return format!("let length = {length};\n{one_by_one}");
        }
        let fields: String = results
            .iter()
            .map(|result| format!(", {result}: ::rncf::emitted::array_mut({result})"))
            .collect();
        format!(
            "let length = {length};\nlet four = {} {{ length: &[length], values: ::rncf::emitted::array(values), q: ::rncf::emitted::array(q){fields} }};\nif !::rncf::emitted::lanes::run(four) {{\n{one_by_one}}}\n",
            camel_case(&kernel.name)
        )
    }

    /// Gravity fields.
    pub(super) fn fields(&self) -> String {
        if self.equations.fields.is_empty() {
            return String::new();
        }
        let fields = &self.equations.fields;
        let values = fields.iter().map(|field| {
            let load = field.load;
            format!("{load} => {}(&self.model, t, z, &mut gravity),\n", field.value.name)
        });
        let gradients = fields.iter().filter_map(|field| {
            let kernel = field.gradient.as_ref()?;
            Some(format!(
                "{} => {}(&self.model, t, z, gradient),\n",
                field.load, kernel.name
            ))
        });
        format!(
            "fn field(&self, load: usize, t: f64, z: {VECTORS}) -> [f64; 3] {{\nlet mut gravity = [0.0; 3];\nmatch load {{\n{}_ => {{}}\n}}\ngravity\n}}\n\
             fn field_gradient(&self, load: usize, t: f64, z: {VECTORS}, gradient: &mut [f64]) {{\ngradient.fill(0.0);\nmatch load {{\n{}_ => {{}}\n}}\n}}\n",
            values.collect::<String>(),
            gradients.collect::<String>()
        )
    }
}
