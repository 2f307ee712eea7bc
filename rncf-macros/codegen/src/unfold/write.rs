//! Items as they are written: with the names and numbers that they refer to.

use super::messages as say;
use super::names::Reached;
use super::statement::own_names;
use super::{Place, Planned, Step, Unfold};
use crate::errors::Area;
use crate::parse::tree::{
    Argument, Call, Caution, Expr, ExprKind, Field, Fields, Given, If, Item, ItemKind, Keyword, Loop, Name, Parameter,
    Tree,
};
use crate::suggest;
use crate::vocabulary::members::Thing;

/// Deepest expression that becomes of those that stand for each other.
const DEEPEST: usize = 400;

/// Arguments that name axes, whatever else is called so.
const AXES_OF: [&str; 2] = ["axis", "cross"];

impl<'t> Unfold<'t, '_> {
    /// Everything that is planned, with the loops that stay.
    pub(super) fn written(mut self) -> Tree {
        let mut out = Tree::new(self.root.name.clone());
        for step in std::mem::take(&mut self.steps) {
            match step {
                Step::Item(planned) => {
                    self.item_or_pieces(&planned, &mut out.items);
                }
                Step::Told { scope, parameter } => self.quantity(scope, parameter, &mut out),
            }
        }
        for kept in std::mem::take(&mut self.kept) {
            out.loops.push(Loop {
                index: kept.of.index.clone(),
                count: kept.of.count.as_ref().map(|count| self.expr(&kept.at, count)),
                outer: None,
                items: 0..0,
            });
        }
        out.lost = self.lost;
        out.counted = self.counted.into_iter().collect();
        let trees = std::iter::once(self.root).chain(&self.root.components);
        let indices = trees.flat_map(|tree| &tree.loops).filter_map(|one| one.index.as_ref());
        out.indices = indices.map(|index| index.text.clone()).collect();
        out.is_copied = self.is_copied;
        out
    }

    /// A quantity that a part was told, under a name of its own: a constant, or derived from params.
    fn quantity(&mut self, scope: usize, parameter: &Parameter, out: &mut Tree) {
        let Some(told) = self.scopes[scope].told.get(parameter.name.text.as_str()).cloned() else {
            return;
        };
        let before = self.errors.len();
        let value = self.expr(&told.at, told.value);
        let name = self.renamed(scope, &parameter.name);
        let (keyword, kind) = if self.errors.len() > before {
            (Keyword::Let, ItemKind::Broken)
        } else if self.is_fixed(&value) {
            self.fixed.insert(name.text.clone());
            (Keyword::Const, ItemKind::Const(value.clone()))
        } else {
            (Keyword::Let, ItemKind::Let(value.clone()))
        };
        if !matches!(kind, ItemKind::Broken) {
            let (name, kind) = (name.text.clone(), parameter.kind.clone());
            out.given.push(Given { name, kind, value });
        }
        let (doc, repeat) = (String::new(), None);
        out.items.push(Item {
            doc,
            keyword,
            name,
            repeat,
            is_shared: false,
            kind,
        });
    }

    /// Whether an expression is made of numbers and constants alone.
    fn is_fixed(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Index(_) => true,
            ExprKind::Name(name) => name.text == "pi" || self.fixed.contains(&name.text),
            ExprKind::Negate(inner) => self.is_fixed(inner),
            ExprKind::Binary(_, left, right) | ExprKind::Power(left, right) => {
                self.is_fixed(left) && self.is_fixed(right)
            }
            ExprKind::Call(call) => {
                let is_motion = self.existing.contains(&call.name.text);
                !is_motion && call.arguments.iter().all(|argument| self.is_fixed(&argument.value))
            }
            ExprKind::If(choice) => [&choice.left, &choice.right, &choice.then, &choice.otherwise]
                .into_iter()
                .all(|part| self.is_fixed(part)),
            _ => false,
        }
    }

    pub(super) fn item(&mut self, planned: &Planned<'t>) -> Item {
        let Planned { at, item, name, .. } = planned;
        let before = self.errors.len();
        let kind = if planned.is_broken {
            ItemKind::Broken
        } else {
            self.kind(at, &item.kind)
        };
        let is_param = item.is_param();
        let is_hidden = std::mem::take(&mut self.is_hidden);
        let is_broken = (self.errors.len() > before || is_hidden) && !is_param;
        Item {
            doc: item.doc.clone(),
            keyword: item.keyword,
            name: Name::new(name.clone(), item.name.span),
            repeat: planned.repeat,
            is_shared: item.is_shared,
            kind: if is_broken { ItemKind::Broken } else { kind },
        }
    }

    fn kind(&mut self, at: &Place, kind: &'t ItemKind) -> ItemKind {
        match kind {
            ItemKind::Param { count, value } => ItemKind::Param {
                count: *count,
                value: value.as_ref().map(|value| self.expr(at, value)),
            },
            ItemKind::Const(value) => ItemKind::Const(self.expr(at, value)),
            ItemKind::Let(value) => ItemKind::Let(self.expr(at, value)),
            ItemKind::Table(fields) => ItemKind::Table(self.fields(at, fields)),
            ItemKind::FileTable {
                path,
                area,
                arguments,
                is_param,
            } => ItemKind::FileTable {
                path: path.clone(),
                area: *area,
                arguments: self.arguments(at, arguments),
                is_param: *is_param,
            },
            ItemKind::Material(fields) => {
                // The strain in an energy.
                self.local = vec!["E"];
                let fields = self.fields(at, fields);
                self.local.clear();
                ItemKind::Material(fields)
            }
            ItemKind::Section(fields) => ItemKind::Section(self.fields(at, fields)),
            ItemKind::NamedSection(call) => ItemKind::NamedSection(self.call(at, call)),
            ItemKind::Element {
                of_section,
                statements,
                complete,
            } => {
                self.local = own_names(statements);
                let statements = statements.iter().map(|statement| self.of_element(at, statement));
                let statements = statements.collect();
                self.local.clear();
                ItemKind::Element {
                    of_section: *of_section,
                    statements,
                    complete: *complete,
                }
            }
            ItemKind::Motion(value) => ItemKind::Motion(self.expr(at, value)),
            ItemKind::Frame { parent, call } => ItemKind::Frame {
                parent: parent.as_ref().map(|parent| self.name(at, parent)),
                call: self.call(at, call),
            },
            ItemKind::Body {
                frame,
                statements,
                complete,
            } => ItemKind::Body {
                frame: frame.as_ref().map(|frame| self.name(at, frame)),
                statements: statements
                    .iter()
                    .map(|statement| self.statement(at, statement))
                    .collect(),
                complete: *complete,
            },
            ItemKind::Rigid { parent, fields } => ItemKind::Rigid {
                parent: parent.as_ref().map(|parent| self.name(at, parent)),
                fields: self.fields(at, fields),
            },
            ItemKind::Fixture { place, fields } => ItemKind::Fixture {
                place: self.expr(at, place),
                fields: self.fields(at, fields),
            },
            ItemKind::Joint(call) => ItemKind::Joint(self.call(at, call)),
            ItemKind::Corner(call) => ItemKind::Corner(self.call(at, call)),
            ItemKind::Constraint(value) => ItemKind::Constraint(self.expr(at, value)),
            ItemKind::Spring(call) => ItemKind::Spring(self.spring(at, call)),
            ItemKind::State(call) => ItemKind::State(self.call(at, call)),
            ItemKind::Load(call) => ItemKind::Load(self.call(at, call)),
            ItemKind::Start(call) => ItemKind::Start(self.call(at, call)),
            ItemKind::Part(_) | ItemKind::Broken => ItemKind::Broken,
            ItemKind::Output { unit, value } => ItemKind::Output {
                unit: unit.clone(),
                value: self.expr(at, value),
            },
            ItemKind::Caution(caution) => ItemKind::Caution(Box::new(self.caution(at, caution))),
        }
    }

    fn caution(&mut self, at: &Place, caution: &'t Caution) -> Caution {
        Caution {
            text: caution.text.clone(),
            outputs: caution.outputs.iter().map(|output| self.output(at, output)).collect(),
            comparison: caution.comparison,
            left: self.expr(at, &caution.left),
            right: self.expr(at, &caution.right),
        }
    }

    /// The name of an output as it is written: outputs have names of their own.
    fn output(&mut self, at: &Place, name: &'t Name) -> Name {
        let Some(path) = &name.path else {
            return self.renamed(at.scope, name);
        };
        let span = name.span;
        match self.output_path(at, path) {
            Some(text) => Name::new(text, span),
            None => {
                self.errors.at(path.area, say::OUTPUT_NAME);
                Name::new(String::new(), span)
            }
        }
    }

    fn output_path(&mut self, at: &Place, path: &'t Expr) -> Option<String> {
        match &path.kind {
            ExprKind::Name(name) => Some(self.renamed(at.scope, name).text),
            ExprKind::Indexed { base, index } => {
                let number = self.value(at, index, 0)?;
                Some(format!("{}[{number}]", self.renamed(at.scope, base).text))
            }
            ExprKind::Numbered { base, index } => {
                let number = self.value(at, index, 0)?;
                Some(format!("{}[{number}]", self.output_path(at, base)?))
            }
            ExprKind::Member {
                base,
                field,
                arguments: None,
            } => Some(format!("{}.{}", self.output_path(at, base)?, field.text)),
            _ => None,
        }
    }

    /// A name where no expression stands: of a frame or table.
    pub(super) fn name(&mut self, at: &Place, name: &'t Name) -> Name {
        let (reached, area) = match &name.path {
            Some(path) => (self.reach(at, path), path.area),
            None => (self.reach_name(at, name), Area::from(name.span)),
        };
        match reached.map(|reached| self.settled(reached, area)) {
            Some(Some(ExprKind::Name(found))) => found,
            Some(None) => Name::new(name.text.clone(), name.span),
            Some(Some(_)) => {
                self.errors.at(area, say::NAME_WANTED);
                Name::new(name.text.clone(), name.span)
            }
            None if name.path.is_some() => {
                // Unknown names are told where they are resolved.
                let is_known = self.scopes[0].names.contains_key(name.text.as_str());
                if is_known {
                    self.errors.at(area, say::NAME_WANTED);
                }
                Name::new(name.text.clone(), name.span)
            }
            None => name.clone(),
        }
    }

    fn fields(&mut self, at: &Place, fields: &'t Fields) -> Fields {
        let field = |field: &'t Field| Field {
            name: field.name.clone(),
            value: self.expr(at, &field.value),
        };
        Fields {
            area: fields.area,
            fields: fields.fields.iter().map(field).collect(),
            complete: fields.complete,
        }
    }

    pub(super) fn arguments(&mut self, at: &Place, arguments: &'t [Argument]) -> Vec<Argument> {
        let argument = |argument: &'t Argument| {
            let name = argument.name.clone();
            let is_axis = name.as_ref().is_some_and(|name| AXES_OF.contains(&name.text.as_str()));
            let before = is_axis.then(|| std::mem::replace(&mut self.local, vec!["x", "y", "z"]));
            let value = self.expr(at, &argument.value);
            self.local = before.unwrap_or_else(|| std::mem::take(&mut self.local));
            Argument { name, value }
        };
        arguments.iter().map(argument).collect()
    }

    /// A call of something of the language.
    pub(super) fn call(&mut self, at: &Place, call: &'t Call) -> Call {
        Call {
            name: call.name.clone(),
            arguments: self.arguments(at, &call.arguments),
            area: call.area,
        }
    }

    /// A spring; its law has names of its own.
    fn spring(&mut self, at: &Place, call: &'t Call) -> Call {
        let argument = |argument: &'t Argument| {
            let is_law = argument
                .name
                .as_ref()
                .is_some_and(|name| name.text == "force" || name.text == "moment");
            self.local = if is_law {
                vec!["length", "rate", "angle"]
            } else {
                Vec::new()
            };
            let value = self.expr(at, &argument.value);
            self.local.clear();
            let name = argument.name.clone();
            Argument { name, value }
        };
        Call {
            name: call.name.clone(),
            arguments: call.arguments.iter().map(argument).collect(),
            area: call.area,
        }
    }

    /// The element of a mesh as it is written: that of the component, or of the model, or one repetition of these.
    pub(super) fn element(&mut self, at: &Place, name: &'t Name) -> Name {
        match self.scope_of(at, &name.text) {
            Some(scope) if self.scopes[scope].names[name.text.as_str()].item.keyword == Keyword::Element => {
                let declared = &self.scopes[scope].names[name.text.as_str()];
                let is_kept = declared.loops.iter().any(|id| self.scopes[scope].kept.contains(id));
                if is_kept {
                    // That its loop stays has been told of the element.
                    self.lost.push(name.text.clone());
                    return Name::new(name.text.clone(), name.span);
                }
                self.name(at, name)
            }
            _ => {
                if let Some(path) = &name.path {
                    self.errors.at(path.area, say::not_repeated(&name.text));
                }
                name.clone()
            }
        }
    }

    /// Refuses a number: behind a word that is unknown there the word is what is wrong.
    fn not_numbered(&mut self, at: &Place, base: &Expr, index: &Expr) {
        if let ExprKind::Member { base, field, .. } = &base.kind
            && let ExprKind::Name(name) = &base.kind
            && let Some(scope) = self.scope_of(at, &name.text)
        {
            let keyword = self.scopes[scope].names[name.text.as_str()].item.keyword;
            let known = Thing::of(keyword.word()).into_iter().flat_map(Thing::members);
            let known: Vec<&str> = known.map(|(word, ..)| word).collect();
            if !known.is_empty() && !known.contains(&field.text.as_str()) {
                let what = format!("quantity of a {}", keyword.word());
                self.errors.at(field.span, suggest::unknown(&what, &field.text, known));
                return;
            }
        }
        self.errors.at(index.area, say::NOT_NUMBERED);
    }

    /// An expression of a place, as it is written.
    pub(super) fn expr(&mut self, at: &Place, expr: &'t Expr) -> Expr {
        let kind = match self.reach(at, expr) {
            Some(Reached::Item(name)) if self.cornered.contains_key(&name.text) => self.all_pieces(&name, expr.area),
            Some(reached) => match self.settled(reached, expr.area) {
                Some(kind) => kind,
                // Reported; anything stands for it.
                None => expr.kind.clone(),
            },
            None => self.inner(at, expr),
        };
        Expr {
            kind,
            area: expr.area,
            height: expr.height,
        }
    }

    fn boxed(&mut self, at: &Place, expr: &'t Expr) -> Box<Expr> {
        Box::new(self.expr(at, expr))
    }

    fn inner(&mut self, at: &Place, expr: &'t Expr) -> ExprKind {
        match &expr.kind {
            ExprKind::Number { .. } | ExprKind::Index(_) => expr.kind.clone(),
            ExprKind::Name(name) => self.index(at, name),
            ExprKind::Member { base, field, arguments } => {
                if let Some(arguments) = arguments {
                    match self.reach(at, base) {
                        Some(Reached::Part(scope)) => {
                            let reached = self.inside(scope, field);
                            return self.motion(at, reached, arguments, expr);
                        }
                        Some(Reached::Nothing) => return expr.kind.clone(),
                        _ => {}
                    }
                }
                if let Some(found) = self.of_cornered(at, base, field, arguments.as_deref(), expr.area) {
                    return found;
                }
                ExprKind::Member {
                    base: self.boxed(at, base),
                    field: field.clone(),
                    arguments: arguments.as_ref().map(|arguments| self.arguments(at, arguments)),
                }
            }
            ExprKind::Call(call) => match self.reach_name(at, &call.name) {
                Some(Reached::Item(name)) => {
                    let name = if self.existing.contains(&name.text) {
                        name
                    } else {
                        call.name.clone()
                    };
                    let arguments = self.arguments(at, &call.arguments);
                    let area = call.area;
                    ExprKind::Call(Call { name, arguments, area })
                }
                Some(several @ Reached::Several(_)) => self.motion(at, several, &call.arguments, expr),
                _ => ExprKind::Call(self.call(at, call)),
            },
            ExprKind::Applied { base, arguments } => match self.reach(at, base) {
                Some(reached) => self.motion(at, reached, arguments, expr),
                None => {
                    self.errors.at(expr.area, say::NO_CALL);
                    expr.kind.clone()
                }
            },
            ExprKind::Negate(inner) => ExprKind::Negate(self.boxed(at, inner)),
            ExprKind::Binary(operator, left, right) => {
                ExprKind::Binary(*operator, self.boxed(at, left), self.boxed(at, right))
            }
            ExprKind::Remainder(left, right) => {
                // Of known numbers it is one; elsewhere it stands in the number of a repetition only.
                match self.value(at, expr, 0).filter(|_| self.has_number(at)) {
                    Some(value) if value.trunc() == value && value.abs() < 1e15 => ExprKind::Index(value as i64),
                    _ => ExprKind::Remainder(self.boxed(at, left), self.boxed(at, right)),
                }
            }
            ExprKind::Power(base, exponent) => ExprKind::Power(self.boxed(at, base), self.boxed(at, exponent)),
            ExprKind::Indexed { base, index } => ExprKind::Indexed {
                base: base.clone(),
                index: self.boxed(at, index),
            },
            ExprKind::Numbered { base, index } => {
                self.not_numbered(at, base, index);
                expr.kind.clone()
            }
            ExprKind::Reduced(reduced) => self.reduced(at, expr, reduced),
            ExprKind::If(choice) => ExprKind::If(Box::new(If {
                comparison: choice.comparison,
                left: self.expr(at, &choice.left),
                right: self.expr(at, &choice.right),
                then: self.expr(at, &choice.then),
                otherwise: self.expr(at, &choice.otherwise),
            })),
            ExprKind::Vector { components, unit } => ExprKind::Vector {
                components: components.iter().map(|component| self.expr(at, component)).collect(),
                unit: unit.clone(),
            },
        }
    }

    /// Whether a loop that is gone through at build time stands around.
    fn has_number(&self, at: &Place) -> bool {
        at.turns.iter().any(|turn| turn.number.is_some())
    }

    /// The number of an index; other names stay.
    fn index(&mut self, at: &Place, name: &Name) -> ExprKind {
        let turn = at.turns.iter().rev().find(|turn| turn.name == name.text);
        match turn.and_then(|turn| turn.number) {
            Some(value) if !self.local.contains(&name.text.as_str()) => ExprKind::Index(value),
            _ => ExprKind::Name(name.clone()),
        }
    }

    /// A motion of several, or of a part, at a time.
    fn motion(&mut self, at: &Place, reached: Reached<'t>, arguments: &'t [Argument], expr: &Expr) -> ExprKind {
        let arguments = self.arguments(at, arguments);
        match self.settled(reached, expr.area) {
            Some(ExprKind::Name(name)) => ExprKind::Call(Call {
                name,
                arguments,
                area: expr.area,
            }),
            Some(_) => {
                self.errors.at(expr.area, say::NO_CALL);
                expr.kind.clone()
            }
            None => expr.kind.clone(),
        }
    }

    /// Follows what stands for a name; refuses what stands for itself.
    pub(super) fn deeper<T>(
        &mut self,
        height: usize,
        area: Area,
        follow: impl FnOnce(&mut Self) -> Option<T>,
    ) -> Option<T> {
        if self.depth + height > DEEPEST {
            self.errors.at(area, say::TOO_DEEP);
            return None;
        }
        self.depth += height;
        let found = follow(self);
        self.depth -= height;
        found
    }
}
