//! A moment on a point mass.

rncf::model! {
    /// A mechanism.
    pub model Mechanism {
        rigid arm { mass = 2 kg; }
        load twist = moment(arm, [0, 0, 1] N*m);
        output x = arm.x;
    }
}

fn main() {}
