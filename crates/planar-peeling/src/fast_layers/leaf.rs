//! The leaves: a block of consecutive points, those not on the block's hull in a bit mask.

use super::chain::{Chain, EMPTY, LEFT, Links, NONE, Place, RIGHT};
use super::side::{Context, Side};
use geometry_core::{Kernel2, Observer};

/// How many places a leaf has.
pub(super) const BLOCK: usize = 16;

/// A bit for each place of a leaf: whether its point is there but not on the leaf's hull.
pub(super) type Hidden = u32;

/// Takes out of hiding the points that lie on the hull between the neighbours `beyond`, and returns their chain.
pub(super) fn light_up<S: Side, K: Kernel2, O: Observer>(
    leaf: usize,
    hidden: &mut Hidden,
    beyond: Chain,
    links: &mut Links,
    context: &Context<'_, K, O>,
) -> Chain {
    let base = (leaf * BLOCK) as Place;
    let mut candidates = between(*hidden, base, beyond);
    let floor = usize::from(beyond[LEFT] != NONE);
    let mut len = floor;
    let mut chain = [NONE; BLOCK + 2];
    let mut corners = [[0.0; 2]; BLOCK + 2];
    chain[0] = beyond[LEFT];
    corners[0] = context.point(beyond[LEFT]);
    loop {
        let place = if candidates == 0 {
            beyond[RIGHT]
        } else {
            base + candidates.trailing_zeros()
        };
        if place == NONE {
            break;
        }
        let point = context.point(place);
        while len >= 2 && !context.keeps::<S>(corners[len - 2], corners[len - 1], point) {
            len -= 1;
        }
        if candidates == 0 {
            break;
        }
        candidates &= candidates - 1;
        chain[len] = place;
        corners[len] = point;
        len += 1;
    }
    let lit = &chain[floor..len.max(floor)];
    for &place in lit {
        *hidden ^= 1 << (place - base);
    }
    for pair in lit.windows(2) {
        links.set(pair[0], RIGHT, pair[1]);
        links.set(pair[1], LEFT, pair[0]);
    }
    match lit {
        [] => EMPTY,
        [first, ..] => [*first, lit[lit.len() - 1]],
    }
}

/// The bits of `hidden` strictly between the places `beyond` of the leaf that starts at `base`.
fn between(hidden: Hidden, base: Place, beyond: Chain) -> Hidden {
    let mut bits = hidden;
    if beyond[LEFT] != NONE {
        bits &= !1 << (beyond[LEFT] - base);
    }
    if beyond[RIGHT] != NONE {
        bits &= (1 << (beyond[RIGHT] - base)) - 1;
    }
    bits
}
