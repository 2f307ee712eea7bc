//! References written by hand.
