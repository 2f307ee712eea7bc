//! Elastic kernels of a material that is given by its energy W(E) (THEORY 4.2): its derivatives at a strain. The runtime
//! relaxes the lateral strains of every particle and integrates over the section (`emitted/section_energy.rs`).

use std::collections::HashMap;

use crate::elements::{Field, Library};
use crate::lower::form::{FieldBlocks, Groups, Quantity};
use crate::lower::kernel::Kernel;
use crate::lower::material::{Density, Material};
use crate::lower::quadratic::length_power;
use crate::lower::signature::{PointInputs, Signature, camel_case};
use crate::lower::variant::Variant;
use crate::symbolic::Id;
use crate::tensors::Sampling;

/// One kernel and what it turned out to depend on.
pub(super) struct Point {
    pub kernel: Kernel,
    /// What is called at every particle of the section.
    pub particle: Option<Kernel>,
    pub fields: Vec<usize>,
    pub groups: Vec<usize>,
    pub stiffness: Option<FieldBlocks>,
    pub damping: Option<FieldBlocks>,
    pub references: usize,
}

/// Blocks of all pairs of fields, ordered by tile; of a symmetric tangent those of tiles on and above the diagonal.
fn all_blocks(group_of: &[usize], groups: usize, symmetric: bool) -> FieldBlocks {
    let tiles = (0..groups).flat_map(|g| (0..groups).map(move |h| (g, h)));
    let tiles = tiles.filter(|&(g, h)| !symmetric || g <= h);
    let mut blocks = FieldBlocks {
        pairs: Vec::new(),
        tiles: Vec::new(),
    };
    for (tile, (g, h)) in tiles.enumerate() {
        let from = blocks.pairs.len();
        for i in (0..group_of.len()).filter(|&i| group_of[i] == g) {
            let columns = (0..group_of.len()).filter(|&j| group_of[j] == h);
            blocks.pairs.extend(columns.map(|j| (i, j)));
        }
        blocks.tiles.push((tile, from, blocks.pairs.len()));
    }
    blocks
}

/// The kernel of one quantity at a point, which sums over the section.
pub(super) fn section_point(
    variant: &Variant,
    library: &Library,
    groups: &Groups,
    (points, quantity): (Sampling, Quantity),
) -> Point {
    let declared: Vec<&Field> = variant.declaration(library).fields_in(variant.dimension).collect();
    let group_of: Vec<usize> = declared.iter().map(|field| groups.group(field.of)).collect();
    let is_tangent = quantity == Quantity::Tangent;
    let blocks = |symmetric| all_blocks(&group_of, groups.of.len(), symmetric);
    let stiffness = is_tangent.then(|| blocks(!variant.damped));
    let damping = (is_tangent && variant.damped).then(|| blocks(true));
    let name_of = |prefix: &str, field: &Field, c: usize| {
        let unit = if length_power(field) == 0 { "" } else { "unit_" };
        format!("{prefix}{unit}{}_{}", field.name, ["x", "y", "z"][c])
    };
    let names = |prefix: &str| -> Vec<Vec<String>> {
        let vector = |field: &&Field| (0..variant.dimension).map(|c| name_of(prefix, field, c)).collect();
        declared.iter().map(vector).collect()
    };
    let references = if variant.curved {
        declared.len() * variant.dimension
    } else {
        0
    };
    let signature = Signature {
        variant,
        library,
        references,
    };
    let kernel = signature.section_point(
        (points, quantity),
        &PointInputs {
            names: declared.iter().map(|field| field.name).collect(),
            inputs: ["", "v_"].map(names),
            blocks: [&stiffness, &damping].map(|blocks| blocks.as_ref().map_or(0, |blocks| blocks.pairs.len())),
        },
        [&stiffness, &damping].map(|blocks| blocks.as_ref().map(|blocks| blocks.pairs.as_slice())),
    );
    let particle = variant.material.as_ref().and_then(|material| match quantity {
        Quantity::Force => Some(response(material, variant, library)),
        Quantity::Tangent if variant.damped => Some(stiffness_rate(material, variant, library)),
        _ => None,
    });
    Point {
        kernel,
        particle,
        fields: (0..declared.len()).collect(),
        groups: group_of,
        stiffness,
        damping,
        references,
    }
}

/// Second derivatives of an energy on and above the diagonal.
fn stiffness_of(density: &mut Density) -> Vec<(usize, usize, Id)> {
    let Density { graph, energy, strains } = density;
    let mut entries = Vec::new();
    for i in 0..6 {
        let stress = graph.partial(*energy, strains[i]);
        for j in i..6 {
            entries.push((i, j, graph.partial(stress, strains[j])));
        }
    }
    entries
}

fn material_kernel(name: String, what: &str, variant: &Variant, library: &Library, arguments: &[&str]) -> Kernel {
    let row = camel_case(&variant.name(library));
    let mut all = vec![format!("model: &{row}Material"), "strain: &[f64; 6]".to_string()];
    all.extend(arguments.iter().map(|argument| (*argument).to_string()));
    Kernel {
        name,
        doc: vec![what.to_string()],
        arguments: all,
        bindings: Vec::new(),
        graph: crate::symbolic::Graph::new(),
        points: None,
        outputs: Vec::new(),
        assign: true,
    }
}

/// Energy, stress and stiffness at a strain.
fn response(material: &Material, variant: &Variant, library: &Library) -> Kernel {
    let mut density = material.density();
    let mut kernel = material_kernel(
        format!("{}_response", variant.name(library)),
        "Energy per volume W (J/m^3), stress dW/dE and, on and above the diagonal, stiffness d2W/dE2 (Pa) at a Green strain \
         xx, yy, zz, xy, xz, yz.",
        variant,
        library,
        &[
            "energy: &mut f64",
            "stress: &mut [f64; 6]",
            "stiffness: &mut [[f64; 6]; 6]",
        ],
    );
    let mut outputs = vec![("*energy".to_string(), density.energy)];
    for (k, strain) in density.strains.into_iter().enumerate() {
        let stress = density.graph.partial(density.energy, strain);
        outputs.push((format!("stress[{k}]"), stress));
    }
    for (i, j, entry) in stiffness_of(&mut density) {
        outputs.push((format!("stiffness[{i}][{j}]"), entry));
    }
    kernel.outputs = not_zero(outputs, &density);
    kernel.graph = density.graph;
    kernel
}

/// How the stiffness changes along a rate of the strain, which the tangent of damping needs.
fn stiffness_rate(material: &Material, variant: &Variant, library: &Library) -> Kernel {
    let mut density = material.density();
    let mut kernel = material_kernel(
        format!("{}_stiffness_rate", variant.name(library)),
        "Derivative of the stiffness d2W/dE2 along a rate of the strain, on and above the diagonal.",
        variant,
        library,
        &["rate: &[f64; 6]", "stiffness: &mut [[f64; 6]; 6]"],
    );
    let entries = stiffness_of(&mut density);
    let rates: HashMap<Id, Id> = density
        .strains
        .into_iter()
        .enumerate()
        .map(|(k, strain)| (strain, density.graph.symbol(format!("rate[{k}]"))))
        .collect();
    let outputs = entries
        .into_iter()
        .map(|(i, j, entry)| {
            (
                format!("stiffness[{i}][{j}]"),
                density.graph.differentiate(entry, &rates),
            )
        })
        .collect();
    kernel.outputs = not_zero(outputs, &density);
    kernel.graph = density.graph;
    kernel
}

fn not_zero(outputs: Vec<(String, Id)>, density: &Density) -> Vec<(String, Id)> {
    let outputs = outputs.into_iter();
    outputs.filter(|&(_, id)| !density.graph.is_zero(id)).collect()
}
