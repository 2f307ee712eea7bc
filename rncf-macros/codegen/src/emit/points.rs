//! The constants of an element in the form by fields: its vectors, rules and blocks.

use super::number::number;
use crate::lower::camel_case;
use crate::lower::elastic::Between;
use crate::lower::form::{FieldBlocks, FieldKernels, FieldRule};
use crate::lower::material::{Material, SectionRule};
use crate::model::{Body, Expr, SectionShape};
use crate::tensors::Sampling;

/// Statics `{NAME}_VECTORS`, and for each rule `{NAME}_POINTS{n}` or `{NAME}_NODES{n}`, `.._STIFFNESS`, `.._DAMPING`.
pub fn tables(name: &str, dimension: usize, fields: &FieldKernels) -> String {
    let name = name.to_uppercase();
    let groups = &fields.groups;
    let (count, size, vectors) = (groups.of.len(), groups.size(), groups.positions.len());
    let filled = |group: &Vec<usize>| -> Vec<usize> {
        let missing = std::iter::repeat_n(vectors, size - group.len());
        group.iter().copied().chain(missing).collect()
    };
    let nodal: Vec<Vec<usize>> = groups.nodal.iter().map(filled).collect();
    let is_position = |&nodal: &usize| groups.positions.get(nodal).copied().unwrap_or(false);
    let positions: Vec<Vec<bool>> = nodal
        .iter()
        .map(|group| group.iter().map(is_position).collect())
        .collect();
    let mut text = format!(
        "/// Nodal vectors by what they interpolate: {}.\n\
         static {name}_VECTORS: ::rncf::emitted::Vectors<{vectors}, {dimension}, {count}, {size}> = ::rncf::emitted::Vectors {{\n\
         base: {}, nodal: {nodal:?}, positions: {positions:?} }};\n",
        groups
            .of
            .iter()
            .map(|of| format!("{of:?}"))
            .collect::<Vec<_>>()
            .join(", "),
        groups.base,
    );
    for rule in &fields.rules {
        text += &rule_table(&name, size, rule);
    }
    text
}

fn rule_table(name: &str, size: usize, rule: &FieldRule) -> String {
    let (points, fields) = (rule.points.count(), rule.fields.len());
    let table = rule.points.table_of(name);
    let list = |values: &[f64]| {
        format!(
            "[{}]",
            values.iter().map(|&value| number(value)).collect::<Vec<_>>().join(", ")
        )
    };
    let point = |shapes: &Vec<Vec<f64>>| {
        let fields: Vec<String> = shapes.iter().map(|values| list(values)).collect();
        format!("[{}]", fields.join(", "))
    };
    let shapes: Vec<String> = rule.shapes.iter().map(point).collect();
    let mut text = format!(
        "/// Weights of {}, and derivatives of the shape functions there.\n\
         static {table}: ::rncf::emitted::Rule<{points}, {fields}, {size}> = ::rncf::emitted::Rule {{\n\
         groups: {:?}, weights: {}, shapes: [{}] }};\n",
        rule.points,
        rule.groups,
        list(&rule.weights),
        shapes.join(",\n"),
    );
    let blocks = [("STIFFNESS", Some(&rule.stiffness)), ("DAMPING", rule.damping.as_ref())];
    for (word, blocks) in blocks {
        if let Some(blocks) = blocks {
            text += &block_table(name, word, size, rule.points, blocks);
        }
    }
    text
}

fn block_table(name: &str, word: &str, size: usize, points: Sampling, blocks: &FieldBlocks) -> String {
    let FieldBlocks { pairs, tiles } = blocks;
    let (table, points) = (points.table_of(name), points.count());
    format!(
        "/// Blocks that the tangent's kernel writes, by pairs of fields.\n\
         static {table}_{word}: ::rncf::emitted::Blocks<{points}, {}, {}> =\n\
         {table}.blocks(&{pairs:?}, &{tiles:?});\n",
        size * size,
        pairs.len(),
    )
}

/// Statics `{NAME}_POINTS{n}_BETWEEN` of forces between two states; `size` vectors in a group.
pub fn tables_between(name: &str, size: usize, between: &Between) -> String {
    let name = name.to_uppercase();
    let rules = between.rules.iter();
    rules
        .map(|rule| block_table(&name, "BETWEEN", size, rule.points, &rule.blocks))
        .collect()
}

/// The last fields of the struct with the constants of an element whose material is given by its energy, and
/// the struct with its parameters.
pub fn material_fields(name: &str, material: &Material, is_damped: bool) -> String {
    let row = camel_case(name);
    let params = material.params();
    let fields = params
        .iter()
        .map(|(param, _)| format!("/// Parameter of the model.\npub {param}: f64,\n"));
    let rate = if is_damped {
        format!(
            "fn stiffness_rate(&self, strain: &[f64; 6], rate: &[f64; 6], stiffness: &mut [[f64; 6]; 6]) {{\n\
             {name}_stiffness_rate(self, strain, rate, stiffness);\n}}\n"
        )
    } else {
        String::new()
    };
    format!(
        "/// Particles of the section, and factors of its shear.\npub section: ::rncf::emitted::Section<{}>,\n\
         /// Parameters of the energy.\npub material: {row}Material,\n}}\n\
         /// Parameters of the energy of `{}`.\n\
         #[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct {row}Material {{\n{}}}\n\
         impl ::rncf::emitted::StrainEnergy for {row}Material {{\n\
         fn response(&self, strain: &[f64; 6], energy: &mut f64, stress: &mut [f64; 6], stiffness: &mut [[f64; 6]; 6]) {{\n\
         {name}_response(self, strain, energy, stress, stiffness);\n}}\n{rate}}}\n",
        material.section.count(),
        material.name,
        fields.collect::<String>(),
    )
}

/// Statements that bind `material` to the parameters of an energy and check it.
pub fn material_constants(name: &str, material: &Material) -> String {
    let params = material.params();
    let params = params
        .iter()
        .map(|(param, is_count)| format!("{param}: model.{param}{}", if *is_count { " as f64" } else { "" }));
    format!(
        "let material = {}Material {{ {} }};\n::rncf::emitted::resisting({:?}, &material)?;\n",
        camel_case(name),
        params.collect::<Vec<_>>().join(", "),
        material.name,
    )
}

/// Initialisers of these fields; `material` is bound to the parameters.
pub fn material_values(material: &Material, body: &Body, text: impl Fn(&Expr) -> String) -> Vec<String> {
    let section = match (&body.shape, material.section) {
        (SectionShape::Rectangle { sizes: [y, z] }, _) => {
            let torsion = body.properties.get("torsion_constant").map(&text).unwrap_or_default();
            format!("rectangle([{}, {}], {torsion})", text(y), text(z))
        }
        (SectionShape::Circle { radius }, SectionRule::Round) => format!("round({0}, {0}, &material)", text(radius)),
        (SectionShape::Tube { radius, thickness }, SectionRule::Round) => {
            format!("round({}, {}, &material)", text(radius), text(thickness))
        }
        _ => "default()".to_string(),
    };
    vec![
        format!("section: ::rncf::emitted::Section::{section}"),
        "material".to_string(),
    ]
}
