//! Free frames: where they start, and the ten numbers of the rigid parts that they carry.

use super::kernel::Kernel;
use crate::model::{Frame, Free, Model, Motions, RigidPart};
use crate::symbolic::{Id, linear::Matrix3};
use crate::symbolic::{Time, unit};

/// The axis that a frame with one angle turns about.
fn own_axis(motions: &Motions) -> Option<[f64; 3]> {
    match motions {
        Motions::Planar { normal } => Some(std::array::from_fn(|axis| f64::from(u8::from(axis == *normal)))),
        Motions::Hinged { axis } => Some(unit(*axis)),
        _ => None,
    }
}

/// Start of a free frame relative to its parent, and its rigid parts.
pub fn free_kernel(model: &Model, frame: &Frame, free: &Free) -> Kernel {
    let mut time = Time::new(model);
    let mut outputs = Vec::new();
    for (name, exprs) in [
        ("position", &frame.origin),
        ("velocity", &free.velocity),
        ("spin", &free.spin),
    ] {
        for (i, id) in time.vector(exprs).into_iter().enumerate() {
            outputs.push((format!("spec.{name}[{i}]"), id));
        }
    }
    let mut axis = own_axis(&free.motions).unwrap_or([0.0, 0.0, 1.0]);
    if let Some(rotation) = &frame.rotation {
        let mut angle = time.expression(&rotation.angle);
        let given = unit(rotation.axis);
        // The angle of a frame with one angle counts about the frame's own axis.
        match own_axis(&free.motions) {
            Some(own) if (0..3).map(|i| own[i] * given[i]).sum::<f64>() < 0.0 => angle = time.graph.negate(angle),
            Some(_) => {}
            None => axis = given,
        }
        outputs.push(("spec.angle".to_string(), angle));
    }
    for (i, &component) in axis.iter().enumerate() {
        outputs.push((format!("spec.axis[{i}]"), time.graph.number(component)));
    }
    outputs.extend(rigid(&mut time, &free.parts));
    if let Some(size) = &free.size {
        outputs.push(("spec.size".to_string(), time.expression(size)));
    }
    // What stands here is meant at t = 0.
    let zero = time.graph.zero();
    let start = std::collections::HashMap::from([(time.t, zero)]);
    for (_, id) in &mut outputs {
        *id = time.graph.substitute(*id, &start);
    }
    outputs.retain(|&(_, id)| !time.graph.is_zero(id));
    let what = if free.is_body { "Rigid body" } else { "Free frame" };
    let title = match free.motions {
        Motions::State => format!("State `{}`: its start, and what counts as much.", frame.name),
        _ => format!(
            "{what} `{}`: its start relative to its parent, and its rigid parts.",
            frame.name
        ),
    };
    let mut kernel = time.kernel(
        format!("free_{}", crate::model::identifier(&frame.name)),
        title,
        outputs,
    );
    if !free.parts.is_empty() {
        let names = super::markers::list(free.parts.iter().map(|part| part.name.as_str()));
        kernel.doc.push(format!(
            "Parts {names}: m, S = sum m c and J = sum J_c + m (c.c 1 - c c^T) about the origin, frame axes."
        ));
    }
    if !frame.doc.is_empty() {
        kernel.doc.push(frame.doc.clone());
    }
    kernel.arguments.remove(1);
    kernel
        .arguments
        .push("spec: &mut ::rncf::emitted::FreeSpec".to_string());
    kernel
}

/// Ten numbers about the frame's origin.
fn rigid(time: &mut Time, parts: &[RigidPart]) -> Vec<(String, Id)> {
    let zero = time.graph.zero();
    let (mut total, mut first, mut second) = (zero, vec![zero; 3], [[zero; 3]; 3]);
    for part in parts {
        let mass = time.expression(&part.mass);
        let center = time.vector(&part.center);
        let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|i| time.expression(&part.inertia[i]));
        let own: Matrix3 = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let graph = &mut time.graph;
        total = graph.add(total, mass);
        let moment = graph.scale(mass, &center);
        first = graph.add_vectors(&first, &moment);
        for i in 0..3 {
            for j in 0..3 {
                let across = if i == j {
                    let (k, l) = ((i + 1) % 3, (i + 2) % 3);
                    graph.dot(&[moment[k], moment[l]], &[center[k], center[l]])
                } else {
                    let (low, high) = (i.min(j), i.max(j));
                    let product = graph.multiply(moment[low], center[high]);
                    graph.negate(product)
                };
                let sum = graph.add(own[i][j], across);
                second[i][j] = graph.add(second[i][j], sum);
            }
        }
    }
    let mut outputs = vec![("spec.rigid.mass".to_string(), total)];
    for i in 0..3 {
        outputs.push((format!("spec.rigid.moment[{i}]"), first[i]));
        for j in 0..3 {
            outputs.push((format!("spec.rigid.inertia[({i}, {j})]"), second[i][j]));
        }
    }
    outputs
}
