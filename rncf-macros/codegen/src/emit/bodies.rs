//! The specifications of bodies.

use std::path::Path;

use super::number::number;
use super::parts::Parts;
use crate::model::{Body, Expr, Fidelity, Imported, Line};

impl Parts<'_> {
    pub(super) fn line(&self, body: &Body) -> String {
        match &body.line {
            Line::Straight { from, to } => {
                format!(
                    "::rncf::emitted::Line::Straight {{ from: {}, to: {} }}",
                    self.vector(from),
                    self.vector(to)
                )
            }
            Line::Arc {
                from,
                direction,
                normal,
                radius,
                angle,
            } => {
                format!(
                    "::rncf::emitted::Line::Arc {{ from: {}, direction: {}, normal: {}, radius: {}, angle: {} }}",
                    self.vector(from),
                    self.vector(direction),
                    self.vector(normal),
                    self.expr(radius),
                    self.expr(angle)
                )
            }
            Line::Imported(imported) => self.imported(body, imported),
            Line::Curve {
                table,
                columns,
                directions,
            } => {
                let directions = directions.map(|direction| match direction {
                    Some(direction) => format!("Some([{}])", direction.map(number).join(", ")),
                    None => "None".to_string(),
                });
                format!(
                    "::rncf::emitted::Line::Curve({}.curve({columns:?}, [{}], &{:?}))",
                    self.model.tables[table.0].reference(),
                    directions.join(", "),
                    body.space.axes()
                )
            }
            Line::Path { range: [from, to], .. } => {
                let index = if body.repeat.is_some() { "instance as f64, " } else { "" };
                format!(
                    "::rncf::emitted::Line::Curve({{ let model = model.clone(); ::rncf::emitted::Curve::along({}, {}, move |x| {{ let mut path = [[0.0; 3]; 2]; path_{}(&model, x, {index}&mut path); path }}) }})",
                    self.expr(from),
                    self.expr(to),
                    body.identifier()
                )
            }
        }
    }

    fn imported(&self, body: &Body, imported: &Imported) -> String {
        let files = imported.files.iter().map(|file| {
            let bytes = included(file);
            format!("({file:?}, {bytes} as &[u8])")
        });
        let interfaces = imported.interfaces.iter().map(|(name, nodes)| {
            let nodes: Vec<String> = nodes.iter().map(|node| format!("{node}_u64")).collect();
            format!("({name:?}, &[{}] as &[u64])", nodes.join(", "))
        });
        let [files, interfaces] = [files.collect::<Vec<_>>(), interfaces.collect()].map(|list| list.join(", "));
        format!(
            "::rncf::emitted::Line::Nodes(::rncf::emitted::Nodes::of(&::rncf::emitted::ImportedSpec {{ body: {:?}, files: &[{files}], units: {:?}, interfaces: &[{interfaces}], keeps_interfaces: {}, damping: {} }}))",
            body.name,
            imported.units,
            imported.keeps_interfaces,
            self.array(&imported.damping)
        )
    }

    pub(super) fn bodies(&self) -> String {
        let mut entries = Vec::new();
        for (index, (body, &variant)) in self.model.bodies.iter().zip(&self.equations.variant_of).enumerate() {
            let variant = &self.equations.variants[variant].variant;
            let connectivity = variant.connectivity(self.library);
            let nodal = variant.vectors(self.library).into_iter().map(|vector| {
                let xi = vector.place.to_f64();
                format!(
                    "::rncf::emitted::NodalSpec {{ meaning: {:?}, of: ::rncf::emitted::Interpolant::{:?}, order: {}, xi: {xi:?} }}",
                    vector.meaning, vector.of, vector.order
                )
            });
            let nodal = nodal.collect::<Vec<_>>().join(", ");
            let section_y = match &body.section_y {
                Some(direction) => format!("Some({})", self.vector(direction)),
                None => "None".to_string(),
            };
            let (stations, twist) = (self.stations(body), self.twist(body));
            let count = match body.stations {
                Some(_) => format!("{stations}.len() - 1"),
                None => self.count(&body.count),
            };
            let instance = if body.repeat.is_some() {
                "Some(instance)"
            } else {
                "None"
            };
            let entry = format!(
                "::rncf::emitted::BodySpec {{ name: {:?}, kind: {index}, instance: {instance}, frame: {}, axes: &{:?}, line: {}, count: {count}, stations: {stations}, nodal: &[{nodal}], connectivity: &{:?}, vectors_per_node: {}, stride: {}, section_y: {section_y}, twist: {twist}, fidelity: ::rncf::emitted::Fidelity::{}, damps: {}, tie: ::rncf::emitted::FrameTie::{:?}, normals: ::std::vec::Vec::new() }}",
                body.name,
                body.frame.0,
                body.space.axes(),
                self.line(body),
                connectivity.places,
                connectivity.per_node,
                connectivity.stride,
                self.fidelity(body),
                self.variant(index).variant.damped,
                body.tie,
            );
            entries.push((body.repeat, entry));
        }
        self.list("bodies", "BodySpec", &entries)
    }

    pub(super) fn count(&self, count: &Expr) -> String {
        match count {
            Expr::Number(value) => format!("{}", *value as usize),
            // A count that is computed is rounded down, and a negative one refused as zero.
            Expr::Param(_) => format!("{} as usize", self.expr(count)),
            other => format!("({}) as usize", self.expr(other)),
        }
    }

    fn fidelity(&self, body: &Body) -> String {
        match &body.fidelity {
            Fidelity::Full => "Full".to_string(),
            Fidelity::Modal(count) => format!("Modal({})", self.count(count)),
            Fidelity::Small(count) => format!("Small({})", self.count(count)),
            Fidelity::Rigid => "Rigid".to_string(),
            Fidelity::Point => "Point".to_string(),
        }
    }
}

/// The bytes of a file beside the crate's manifest, so that cargo expands the model anew when it changes.
pub fn included(file: &str) -> String {
    if Path::new(file).is_absolute() {
        return format!("::core::include_bytes!({file:?})");
    }
    let path = format!("/{file}");
    format!("::core::include_bytes!(::core::concat!(::core::env!(\"CARGO_MANIFEST_DIR\"), {path:?}))")
}
