//! Constraints and forces that depend on differences of places alone are evaluated near what they act on.

use crate::scene::MeshScene;

/// Distance of a start, in sizes of what the frame carries, from which on differences are taken near it.
const FAR: f64 = 10.0;

impl MeshScene {
    /// The free frames near which constraints and forces of differences are evaluated: where a scene is far from the
    /// origin, so that differences of its places would lose digits. Sizes must be known.
    pub(crate) fn find_anchors(&mut self) {
        let near = |is_of_differences: bool, markers: &[usize]| is_of_differences.then(|| self.anchor(markers))?;
        let constraints = self.links.constraints.iter();
        let anchors: Vec<Option<usize>> = constraints
            .map(|linked| near(linked.spec.of_differences, linked.spec.markers))
            .collect();
        let forces = self.links.forces.iter();
        self.links.anchors = forces.map(|push| near(push.of_differences, &push.markers)).collect();
        for (linked, anchor) in self.links.constraints.iter_mut().zip(anchors) {
            linked.anchor = anchor;
        }
    }

    /// The first free frame among those of the points, if it starts far away.
    fn anchor(&self, markers: &[usize]) -> Option<usize> {
        let border = self.layout.unknowns() - self.layout.border();
        let points = markers
            .iter()
            .map(|&marker| &self.links.markers[marker])
            .filter(|marker| marker.is_point());
        let mut frames = points.filter_map(|marker| self.frames.free_of[self.marker_frame(marker)]);
        let free = frames.find(|&free| self.frames.free[free].shifts() > 0)?;
        let frame = &self.frames.free[free];
        (frame.start.position.norm() > FAR * self.tabulated.sizes[border + frame.first]).then_some(free)
    }
}
