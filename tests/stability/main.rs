//! Where other formulations fail (THEORY 10): the failing forms live here as test code, beside what the program does.

mod astronomical;
mod buckling;
mod collapse;
mod compression;
mod hourglass;
mod locking;
mod scenes;
mod softening;
mod steps;
mod whirl;
