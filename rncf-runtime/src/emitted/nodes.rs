//! The nodes of a body from elsewhere: its interfaces, and nodes whose vectors hold its modal coordinates.

use std::sync::Arc;

use crate::import::{Imported, ImportedSpec};

/// A body from elsewhere, and how many nodes stand for it. Its first interface is the first node, its last one the last;
/// the nodes behind the first that are no interfaces hold modal coordinates in the components of their axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    body: Result<Arc<Imported>, String>,
    count: usize,
}

impl Nodes {
    /// Reads a body; what is wrong with it is told when the scene is built.
    pub fn of(spec: &ImportedSpec) -> Self {
        let body = Imported::read(spec).map(Arc::new);
        Self {
            body,
            count: spec.interfaces.len().max(2),
        }
    }

    /// The body.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(crate) fn body(&self) -> Result<&Arc<Imported>, String> {
        self.body.as_ref().map_err(String::clone)
    }

    /// Number of nodes.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// Adds nodes that hold so many modal coordinates.
    pub(crate) fn hold(&mut self, coordinates: usize) {
        self.count += coordinates.div_ceil(HELD);
    }

    fn holding(&self) -> usize {
        let interfaces = self.body.as_ref().map_or(0, |body| body.interfaces());
        self.count - interfaces.max(2)
    }

    /// The node of an interface.
    pub(crate) fn node(&self, interface: usize) -> usize {
        match interface {
            0 => 0,
            other => self.holding() + other,
        }
    }

    /// The interface at a node, or the first of the modal coordinates that it holds.
    pub(crate) fn at(&self, node: usize) -> Held {
        let holding = self.holding();
        let last = self.body.as_ref().map_or(0, |body| body.interfaces().saturating_sub(1));
        match node {
            0 => Held::Interface(0),
            node if node <= holding => Held::Coordinates(HELD * (node - 1)),
            node => Held::Interface((node - holding).min(last)),
        }
    }
}

/// Components of the axes of a node.
const HELD: usize = 9;

/// What a node is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Held {
    /// An interface; that of a body with one interface is its last node, too.
    Interface(usize),
    /// It holds modal coordinates from this one on.
    Coordinates(usize),
}
