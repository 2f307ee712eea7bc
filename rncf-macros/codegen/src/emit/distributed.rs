//! Loads per length at points, and gravity that changes from place to place, in the `Parts` implementation.

use std::fmt::Write;

use super::courses::{looked_up, made};
use super::parts::Parts;
use crate::lower::Kernel;
use crate::lower::distributed::DistributedKernels;
use crate::model::{Distributed, fold};

const VECTORS: &str = "&[::rncf::emitted::Vector]";

/// Where functions of kinks write.
const GAPS: &str = "&mut out[first..]";

/// The arm of a load whose function appends what it writes.
fn appended(index: usize, call: &str, kernel: &Kernel) -> String {
    let count = kernel.outputs.len();
    format!("{index} => {{\nlet first = out.len();\nout.resize(first + {count}, 0.0);\n{call}\n}}\n")
}

impl Parts<'_> {
    /// Such loads and their functions.
    pub(super) fn distributed(&self) -> String {
        let mut text = String::new();
        let loads = &self.model.distributed;
        if loads.is_empty() {
            return text;
        }
        let entries = loads.iter().zip(&self.equations.distributed);
        let entries: Vec<_> = entries
            .map(|(load, kernels)| self.distributed_entry(load, kernels))
            .collect();
        text += &self.list("distributed", "DistributedSpec", &entries);
        let repeats: Vec<_> = loads.iter().map(|load| self.model.bodies[load.body.0].repeat).collect();
        let counts: Vec<String> = repeats
            .iter()
            .map(|repeat| repeat.map_or("1".to_string(), |repeat| format!("self.counts[{}]", repeat.0)))
            .collect();
        let kind = if repeats.iter().all(Option::is_none) {
            String::new()
        } else {
            format!(
                "let (load, instance) = ::rncf::emitted::declared(&[{}], load);\n",
                counts.join(", ")
            )
        };
        let arms = |kernel: &dyn Fn(&DistributedKernels) -> Option<&Kernel>, results: &str| {
            let all = self.equations.distributed.iter().enumerate();
            let arms = all.filter_map(|(index, kernels)| {
                let number = if repeats[index].is_some() {
                    "instance as f64, "
                } else {
                    ""
                };
                let kernel = kernel(kernels)?;
                let call = format!("{}(&self.model, t, at, {number}z, velocity, {results})", kernel.name);
                Some(match results {
                    GAPS => appended(index, &call, kernel),
                    _ => format!("{index} => {call},\n"),
                })
            });
            format!("match load {{\n{}_ => {{}}\n}}\n", arms.collect::<String>())
        };
        let arguments = format!("load: usize, t: f64, at: [f64; 2], z: {VECTORS}, velocity: {VECTORS}");
        let _ = write!(
            text,
            "fn distributed_force(&self, {arguments}, out: &mut [f64]) {{\nout.fill(0.0);\n{kind}{}}}\n\
             fn distributed_tangent(&self, {arguments}, by_value: &mut [f64], by_velocity: &mut [f64]) {{\nby_value.fill(0.0);\nby_velocity.fill(0.0);\n{kind}{}}}\n",
            arms(&|kernels| Some(&kernels.force), "out"),
            arms(&|kernels| kernels.tangent.as_ref(), "by_value, by_velocity"),
        );
        let _ = write!(
            text,
            "fn distributed_gaps(&self, {arguments}, out: &mut ::std::vec::Vec<f64>) {{\n{kind}{}}}\n",
            arms(&|kernels| kernels.gaps.as_ref(), GAPS)
        );
        let courses = self.equations.distributed.iter().enumerate();
        let courses = courses.filter_map(|(index, kernels)| {
            let made = made(kernels.course.as_ref()?, "at[0]", "at, ");
            Some(format!("{index} => ::std::option::Option::Some({made}),\n"))
        });
        let courses: String = courses.collect();
        let _ = write!(
            text,
            "fn distributed_course(&self, load: usize, at: [f64; 2]) -> ::std::option::Option<::rncf::emitted::Courses> {{\n{kind}{}}}\n",
            looked_up("load", &courses)
        );
        text
    }

    fn distributed_entry(
        &self,
        load: &Distributed,
        kernels: &DistributedKernels,
    ) -> (Option<crate::model::RepeatId>, String) {
        let repeat = self.model.bodies[load.body.0].repeat;
        let mut tables: Vec<usize> = load
            .forces
            .iter()
            .flat_map(|(_, components)| components)
            .flat_map(fold::tables)
            .map(|table| table.0)
            .collect();
        tables.sort_unstable();
        tables.dedup();
        let tables: Vec<String> = tables
            .into_iter()
            .map(|table| self.table_itself(table, "model"))
            .collect();
        let vectors: Vec<usize> = kernels.vectors.iter().map(|&vector| vector as usize).collect();
        let entry = format!(
            "::rncf::emitted::DistributedSpec {{ name: {:?}, body: {}{}, points: {}, vectors: &{vectors:?}, tables: ::std::vec::Vec::from([{}]) }}",
            load.name,
            self.first_of(load.body),
            if repeat.is_some() { " + instance" } else { "" },
            load.points,
            tables.join(", ")
        );
        (repeat, entry)
    }

    /// Gravity as a function of the place.
    pub(super) fn around(&self) -> String {
        let kernels = &self.equations.around;
        if kernels.is_empty() {
            return String::new();
        }
        let arms = |which: usize, result: &str| -> String {
            let arms = kernels.iter();
            arms.map(|one| {
                let (load, name) = (one.load, &one.kernels[which].name);
                format!("{load} => {name}(&self.model, t, place, {result}),\n")
            })
            .collect()
        };
        let courses = kernels.iter().filter_map(|one| {
            let made = made(one.course.as_ref()?, "0.0", "");
            Some(format!("{} => ::std::option::Option::Some({made}),\n", one.load))
        });
        let gaps = kernels.iter().filter_map(|one| {
            let kernel = one.gaps.as_ref()?;
            let call = format!("{}(&self.model, t, place, {GAPS})", kernel.name);
            Some(appended(one.load, &call, kernel))
        });
        format!(
            "fn around(&self, load: usize, t: f64, place: ::rncf::emitted::Vector) -> [f64; 3] {{\nlet mut gravity = [0.0; 3];\nmatch load {{\n{}_ => {{}}\n}}\ngravity\n}}\n\
             fn around_gradient(&self, load: usize, t: f64, place: ::rncf::emitted::Vector, gradient: &mut [f64; 9]) {{\ngradient.fill(0.0);\nmatch load {{\n{}_ => {{}}\n}}\n}}\n\
             fn around_gaps(&self, load: usize, t: f64, place: ::rncf::emitted::Vector, out: &mut ::std::vec::Vec<f64>) {{\nmatch load {{\n{}_ => {{}}\n}}\n}}\n\
             fn around_course(&self, load: usize) -> ::std::option::Option<::rncf::emitted::Courses> {{\n{}}}\n",
            arms(0, "&mut gravity"),
            arms(1, "gradient"),
            gaps.collect::<String>(),
            looked_up("load", &courses.collect::<String>())
        )
    }
}
