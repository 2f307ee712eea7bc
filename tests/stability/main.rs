//! Where other formulations fail (THEORY 10): the failing forms live here as test code, beside what the program does.

mod astronomical;
mod steps;
