//! Texts of models through the whole generator, and the documents.

mod documents;
mod errors;
mod identity;
mod influence;
mod language;
mod needs;
mod places;
mod snippets;
