//! Engines: programs that compute, each in a process of its own, behind one small pipe protocol.
//!
//! Our methods and outside programs run under the same method: the harness starts a child process, asks for its
//! version, hands it points, and asks for samples, for the hull, for counters. What goes wrong with a child is a
//! recorded [`Fault`](fault::Fault), never a fault of the harness. The protocol is written down in `bench-harness/PROTOCOL.md`.
//!
//! | module | holds |
//! |---|---|
//! | [`protocol`] | commands, replies, and how they look in the pipe |
//! | [`answer`] | a hull as it travels, and the values it stands for |
//! | [`cut`] | whether triangles cut up the facets of a proved hull |
//! | [`fault`] | what goes wrong in a conversation |
//! | [`client`] | the harness's end: a child process, a deadline on every reply |
//! | [`server`] | the engine's end: the loop that answers |
//! | [`own`] | our registered methods as engines |
//! | [`yardstick`] | work of a known size, measured as if it were an engine |
//! | [`meter`] | the resolution of the clock, the peak of memory |
//! | [`catalogue`] | every engine known, and how to start it |
//! | [`peers`] | the outside programs: what they need, how they are built |

pub mod answer;
pub mod catalogue;
pub mod client;
pub mod cut;
pub mod fault;
mod incoming;
pub mod meter;
pub mod own;
pub mod peers;
pub mod protocol;
pub mod server;
pub mod yardstick;
