#![allow(dead_code, unused)]
mod modal;
mod runs;
