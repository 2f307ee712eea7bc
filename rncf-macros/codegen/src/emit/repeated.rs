//! What loops make of a model: kernels stand once for each declaration, specifications are expanded at run time.
//! Bodies and joints have global numbers there: that of the first repetition of the declaration plus that of the
//! repetition. A model without loops is written as if there were none.

use std::fmt::Write;

use super::parts::Parts;
use crate::lower::loads::Reduced;
use crate::model::{BodyId, Expr, JointId, Location, Observable, Reduction, RepeatId};

/// Where what is repeated `count` times begins, in constants of the parameters.
fn firsts(counts: &[String]) -> String {
    format!("::rncf::emitted::firsts([{}])", counts.join(", "))
}

impl Parts<'_> {
    /// Whether there are loops: then global numbers need not be those of declarations.
    pub(super) fn has_loops(&self) -> bool {
        !self.model.repeats.is_empty()
    }

    /// Fields of the equations that tell declarations and repetitions apart.
    pub(super) fn numbering_fields(&self) -> String {
        if !self.has_loops() {
            return String::new();
        }
        format!(
            "/// How often each loop is gone through.\npub counts: [usize; {}],\n\
             /// Number of the first repetition of every body.\npub firsts: [usize; {}],\n\
             /// Number of the first repetition of every joint.\npub first_joints: [usize; {}],\n",
            self.model.repeats.len(),
            self.model.bodies.len(),
            self.model.joints.len()
        )
    }

    /// Their values, with `model` in scope: statements, and the fields.
    pub(super) fn numbering_values(&self) -> [String; 2] {
        if !self.has_loops() {
            return [String::new(), String::new()];
        }
        let counts = self.model.repeats.iter().map(|repeat| self.times(&repeat.count));
        let counts = counts.collect::<Vec<_>>().join(", ");
        let times = |repeat: Option<RepeatId>| match repeat {
            Some(repeat) => format!("counts[{}]", repeat.0),
            None => "1".to_string(),
        };
        let bodies: Vec<String> = self.model.bodies.iter().map(|body| times(body.repeat)).collect();
        let joints: Vec<String> = self.model.joints.iter().map(|joint| times(joint.repeat)).collect();
        [
            format!("let counts = [{counts}];\n"),
            format!(
                "counts,\nfirsts: {},\nfirst_joints: {},\n",
                firsts(&bodies),
                firsts(&joints)
            ),
        ]
    }

    /// The methods that tell declarations and repetitions apart.
    pub(super) fn numbering_methods(&self) -> String {
        if !self.has_loops() {
            return String::new();
        }
        "/// Declaration of a body, and number of the repetition.\n\
         pub fn kind(&self, body: usize) -> (usize, usize) {\n\
         let declaration = self.firsts.partition_point(|&first| first <= body) - 1;\n\
         (declaration, body - self.firsts[declaration])\n}\n\
         /// Number of the first repetition of a declared body.\n\
         pub fn first(&self, declaration: usize) -> usize {\nself.firsts[declaration]\n}\n\
         /// Declaration of a joint.\n\
         pub fn joint_kind(&self, joint: usize) -> usize {\n\
         self.first_joints.partition_point(|&first| first <= joint) - 1\n}\n"
            .to_string()
    }

    /// Text of how often a loop is gone through; a count that is computed is rounded down.
    fn times(&self, count: &Expr) -> String {
        match count {
            Expr::Param(param) if self.model.params[param.0].is_count => {
                format!("model.{}", self.model.params[param.0].name)
            }
            other => self.count(other),
        }
    }

    /// Checks of the loops' counts.
    pub(super) fn loop_checks(&self) -> String {
        let check = |repeat: &crate::model::Repeat| {
            let count = self.expr(&repeat.count);
            format!("::rncf::emitted::repetitions({:?}, {count})?;\n", repeat.index)
        };
        self.model.repeats.iter().map(check).collect()
    }

    /// Statements once for each repetition, with `instance` and `index` in scope, or as they are.
    pub(super) fn in_loop(&self, repeat: Option<RepeatId>, statements: &str) -> String {
        match repeat {
            None => statements.to_string(),
            Some(repeat) => format!(
                "for instance in 0..self.counts[{}] {{\nlet index = instance as f64;\n{statements}}}\n",
                repeat.0
            ),
        }
    }

    /// A method that returns a list, entries of loops once for each repetition.
    pub(super) fn list(&self, name: &str, kind: &str, entries: &[(Option<RepeatId>, String)]) -> String {
        if entries.is_empty() {
            return format!(
                "fn {name}(&self) -> ::std::vec::Vec<::rncf::emitted::{kind}> {{ ::std::vec::Vec::new() }}\n"
            );
        }
        let head =
            format!("fn {name}(&self) -> ::std::vec::Vec<::rncf::emitted::{kind}> {{\nlet model = &self.model;\n");
        if entries.iter().all(|(repeat, _)| repeat.is_none()) {
            let entries: String = entries.iter().map(|(_, entry)| format!("{entry},\n")).collect();
            return format!("{head}::std::vec::Vec::from([\n{entries}])\n}}\n");
        }
        let pushes = entries
            .iter()
            .map(|(repeat, entry)| self.in_loop(*repeat, &format!("specs.push({entry});\n")));
        format!(
            "{head}let mut specs = ::std::vec::Vec::new();\n{}specs\n}}\n",
            pushes.collect::<String>()
        )
    }

    /// Global number of the body that a place is on.
    pub(super) fn body_at(&self, body: BodyId, at: &Location) -> String {
        match (self.model.bodies[body.0].repeat, at.instance()) {
            (Some(repeat), Some(instance)) => format!(
                "::rncf::emitted::instance(self.first({}), self.counts[{}], {})",
                body.0,
                repeat.0,
                self.expr(instance)
            ),
            _ => self.first_of(body),
        }
    }

    /// Global number of a body, the first where it is repeated.
    pub(super) fn first_of(&self, body: BodyId) -> String {
        if self.has_loops() {
            format!("self.first({})", body.0)
        } else {
            body.0.to_string()
        }
    }

    /// Global number of a joint, the first where it is repeated.
    pub(super) fn first_of_joint(&self, joint: JointId) -> String {
        if self.has_loops() {
            format!("self.first_joints[{}]", joint.0)
        } else {
            joint.0.to_string()
        }
    }

    /// Makes of a global number of a joint its declaration.
    pub(super) fn of_joint(&self) -> &'static str {
        if self.has_loops() {
            "let joint = self.joint_kind(joint);\n"
        } else {
            ""
        }
    }

    /// Ends of bodies that are one node.
    pub(super) fn shares(&self) -> String {
        let entries = self.model.shares.iter().map(|share| {
            let ends = share.ends.each_ref().map(|(body, at)| {
                let at_end = *at.place() == Location::End;
                format!("({}, {at_end})", self.body_at(*body, at))
            });
            let entry = format!(
                "::rncf::emitted::ShareSpec {{ name: {:?}, ends: [{}], smooth: {} }}",
                share.name,
                ends.join(", "),
                share.smooth
            );
            (share.repeat, entry)
        });
        self.list("shares", "ShareSpec", &entries.collect::<Vec<_>>())
    }

    /// What outputs read: what they name themselves, then what each reduction reads, repetition by repetition.
    pub(super) fn observed(&self) -> String {
        let (observed, reduced) = (&self.equations.outputs.1, &self.equations.reduced);
        let one = |observable: &Observable| Some((None, self.observed_spec(observable)?));
        let plain: Vec<_> = observed.iter().filter_map(one).collect();
        if reduced.is_empty() {
            return self.list("observed", "ObservedSpec", &plain);
        }
        let mut text = String::from(
            "fn observed(&self) -> ::std::vec::Vec<::rncf::emitted::ObservedSpec> {\nlet model = &self.model;\nlet mut specs = ::std::vec::Vec::new();\n",
        );
        for (_, entry) in plain {
            let _ = writeln!(text, "specs.push({entry});");
        }
        for reduction in reduced.iter().filter(|reduction| !reduction.observed.is_empty()) {
            let pushes = reduction
                .observed
                .iter()
                .filter_map(|observable| self.observed_spec(observable));
            let pushes: String = pushes.map(|entry| format!("specs.push({entry});\n")).collect();
            text += &self.in_loop(Some(reduction.repeat), &pushes);
        }
        text + "specs\n}\n"
    }

    /// Output columns: reductions first, then the columns from them and all else.
    pub(super) fn outputs(&self) -> String {
        let reduced = &self.equations.reduced;
        let head = "fn outputs(&self, t: f64, observed: &[f64], out: &mut [f64]) {\n";
        if reduced.is_empty() {
            return format!("{head}outputs(&self.model, t, observed, out);\n}}\n");
        }
        let all = self.equations.outputs.1.len();
        let plain = all - reduced.len();
        let mut text = format!(
            "{head}let model = &self.model;\nlet (plain, mut rest) = observed.split_at({plain});\nlet mut seen = [0.0; {all}];\nseen[..{plain}].copy_from_slice(plain);\n"
        );
        for (
            place,
            Reduced {
                reduction,
                repeat,
                observed,
                kernel,
            },
        ) in reduced.iter().enumerate()
        {
            let reduction = match reduction {
                Reduction::Max => "Max",
                Reduction::Min => "Min",
                Reduction::Sum => "Sum",
                Reduction::Mean => "Mean",
            };
            let _ = writeln!(
                text,
                "seen[{}] = ::rncf::emitted::reduce(::rncf::emitted::Reduction::{reduction}, self.counts[{}], {}, &mut rest, |index, observed| {{\nlet mut value = [0.0];\n{}(model, t, index, observed, &mut value);\nvalue[0]\n}});",
                plain + place,
                repeat.0,
                observed.len(),
                kernel.name
            );
        }
        text + "outputs(model, t, &seen, out);\n}\n"
    }
}
