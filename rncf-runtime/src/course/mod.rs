//! Courses: what motions and loads do over time alone, and loads per length along an axis, as lists of operations, so that they can be bounded over a
//! span and not only be evaluated. A load that is over between two evaluations is found so, whatever function it is made of.

mod close;
mod interval;
mod operations;
mod path;

pub use close::Close;
pub use interval::Interval;
pub use operations::{Courses, Lookup, Operation};
pub use path::Path;
