//! Texts of models through the whole generator.

mod influence;
mod language;
mod needs;
