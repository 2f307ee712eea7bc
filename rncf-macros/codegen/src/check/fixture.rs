//! Fixtures: rigid parts glued to frames or to places of flexible bodies (THEORY 5.4).

use super::Check;

impl Check<'_> {
    pub(super) fn fixtures(&mut self) {}
}
