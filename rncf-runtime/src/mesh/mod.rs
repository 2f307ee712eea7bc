//! Meshed bodies: from element kernels to a system.
