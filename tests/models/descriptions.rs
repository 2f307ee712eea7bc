//! Beams in all descriptions: whole, in modes, for small deformations, rigid, and in mean axes.

rncf::model! {
    /// The same cantilever whole and in modes, and a rigid one on a hinge with a spring.
    pub model Ladder {
        param elements: count = 8;
        param modes: count = 6;
        param press = 0 N;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section strip = rectangle(y = 40 mm, z = 20 mm);
        frame place = moving(origin = [0, 0, 1] m);
        frame hinge = hinged(axis = z, angle = 20 deg);
        body whole in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); }
        body in_modes in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); modal(modes); }
        body little in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); small(modes); }
        body stiff in hinge { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); rigid; }
        joint root_1 = clamp(whole.start, place);
        joint root_2 = clamp(in_modes.start, place);
        joint root_3 = clamp(little.start, place);
        spring coil = torsional(hinge, stiffness = 200 N*m/rad, angle = 20 deg);
        load push_1 = force(whole.end, [0, press, press / 2]);
        load push_2 = force(in_modes.end, [0, press, press / 2]);
        load push_3 = force(little.end, [0, press, press / 2]);
        output tip_1 = whole.end;
        output tip_2 = in_modes.end;
        output tip_3 = little.end;
        output tip_4 = stiff.end;
    }
}

rncf::model! {
    /// The beam in mean axes.
    pub model Flying {
        param elements: count = 8;
        material aluminium { density = 2700 kg/m^3; young = 70 GPa; poisson = 0.33; }
        section strip = rectangle(y = 40 mm, z = 20 mm);
        frame place = free(velocity = [1, 0, 0] m/s);
        body bar in place { spatial; line from [0, 0, 0] m to [1, 0, 0] m; mesh elements * beam(strip, aluminium); mean_axes; }
        output tip = bar.end;
    }
}
