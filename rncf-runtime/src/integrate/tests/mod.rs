//! Tests of the driver and of the alpha family on small systems with known solutions.

mod adaptive;
mod axis;
mod energy;
mod heavy_top;
mod lie;
mod long;
mod order;
mod radau;
mod radau_lie;
mod radau_orders;
mod renewal;
mod start;
mod swarm;
mod systems;
