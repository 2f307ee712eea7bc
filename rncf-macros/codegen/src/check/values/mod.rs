//! Values: names, units, dimensions, and what holds numbers.

pub mod arithmetic;
pub mod constant;
pub mod eigen;
pub mod expr;
pub mod matrix;
pub mod param;
pub mod quantity;
pub mod read;
pub mod repeat;
pub mod scope;
pub mod split_unit;
pub mod table;
pub mod unit;
pub mod vector;
pub mod words;
