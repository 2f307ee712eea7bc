//! Scenes at the end of what can be computed: a linkage in one line, bodies and tables from files, loose ties.

rncf::model! {
    /// Two equal links and a coupler as long as the ground, which swing through the line in which all of them lie.
    pub model Swung {
        /// By which the second link is longer.
        param longer = 0 mm;
        /// Length of the first one.
        const length = 1 m;
        rigid first { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0, 0.5, 0] m; speed = -4 rad/s; }
        rigid second { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0, 0.5, 0] m; origin = [1 m, -longer, 0 m]; speed = -4 rad/s; }
        rigid coupler { plane xy; mass = 1 kg; inertia = 0.1 kg*m^2; center = [0.5, 0, 0] m; origin = [0, 1, 0] m; velocity = [4, 0, 0] m/s; }
        joint a = revolute(first, inertial.at([0, 0, 0] m));
        joint b = revolute(second, inertial.at([1 m, -longer, 0 m]));
        joint c = revolute(first.at([0 m, length, 0 m]), coupler);
        joint d = revolute(second.at([0 m, length + longer, 0 m]), coupler.at([1, 0, 0] m));
        output x = coupler.x;
        run { t_end = 1 s; every = 0.1 s; }
    }
}
rncf::model! {
    /// A block of finite elements that is clamped in its frame.
    pub model Panel {
        /// Number of modes.
        param modes: count = 4;
        frame hub = rotating(axis = z, angle = 1 [rad/s] * t);
        body block in hub { import "reference/data/block.npz"; interface left = nodes [1, 8, 15, 22]; interface right = nodes [7, 14, 21, 28]; modal(modes); }
        joint grip = clamp(block.left, hub);
        output bent = block.right.y;
        run { t_end = 0.01 s; every = 0.01 s; }
    }
}
rncf::model! {
    /// An arm of beam elements with the inertia of its deformed shape.
    pub model PanelTurned {
        frame hub = rotating(axis = z, angle = 1 [rad/s] * t);
        body arm in hub { import "guide/arm.npz"; interface root = node 10; interface tip = node 90; modal(4); }
        joint grip = clamp(arm.root, hub);
        output bent = arm.tip.y;
        run { t_end = 0.01 s; every = 0.01 s; }
    }
}
rncf::model! {
    /// The block, pinned in its frame.
    pub model PanelPinned {
        frame hub = rotating(axis = z, angle = 1 [rad/s] * t);
        body block in hub { import "reference/data/block.npz"; interface left = nodes [1, 8, 15, 22]; interface right = nodes [7, 14, 21, 28]; modal(4); }
        joint grip = pin(block.left, hub);
        output bent = block.right.y;
        run { t_end = 0.01 s; every = 0.01 s; }
    }
}
rncf::model! {
    /// A mast whose radii stand in a file.
    pub model Mast {
        /// Radii along the mast.
        param rows: table = file("guide/data/mast.csv");
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section wall = tube(radius = rows.radius, thickness = 3 mm);
        body mast { spatial; line from [0, 0, 0] m to [0, 0, 10] m; mesh 4 * beam(wall, aluminium); }
        joint foot = clamp(mast.start, inertial);
        output mass = mast.mass;
        run { t_end = 0.01 s; every = 0.01 s; }
    }
}
rncf::model! {
    /// A bow whose axis goes through the points of a file.
    pub model Bow {
        /// Points of the axis.
        param way: table = file("guide/tables/points.csv");
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section round = circle(radius = 20 mm);
        body bow { planar xy; curve through way; mesh 4 * cable(round, aluminium); }
        joint foot = clamp(bow.start, inertial);
        output mass = bow.mass;
        run { t_end = 0.01 s; every = 0.01 s; }
    }
}
