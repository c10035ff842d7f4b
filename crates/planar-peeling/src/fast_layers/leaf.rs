//! The leaves: a block of consecutive points, those not on the block's hull in a bit mask.

use super::chain::{Chain, EMPTY, LEFT, Links, NONE, Place, RIGHT};
use super::side::{Context, Side};
use geometry_core::{Kernel2, Observer};

/// How many places a leaf has.
pub(super) const BLOCK: usize = 32;

/// A bit for each place of a leaf: whether its point is there but not on the leaf's hull.
pub(super) type Hidden = u32;

/// Takes out of hiding the points that lie on the hull between the neighbours `beyond`, and returns their chain.
///
/// Most candidates lie under the line from end to end; the others are scanned as a monotone chain.
pub(super) fn light_up<S: Side, K: Kernel2, O: Observer>(
    leaf: usize,
    hidden: &mut Hidden,
    beyond: Chain,
    links: &mut Links,
    context: &mut Context<'_, K, O>,
) -> Chain {
    let base = (leaf * BLOCK) as Place;
    let candidates = between(*hidden, base, beyond);
    if candidates == 0 {
        return EMPTY;
    }
    // Where nothing lies beyond, the outermost candidate is an end of the hull.
    let outermost = [candidates.trailing_zeros(), candidates.ilog2()];
    let ends = [LEFT, RIGHT].map(|way| match beyond[way] {
        NONE => base + outermost[way],
        neighbour => neighbour,
    });
    let above = above::<S, K, O>(candidates, base, ends, context);

    let mut arc = std::mem::take(&mut context.arc);
    arc.clear();
    arc.push(ends[LEFT]);
    for place in places(above, base).chain([ends[RIGHT]]) {
        while let [.., a, b] = arc[..]
            && !context.keeps::<S>(context.point(a), context.point(b), context.point(place))
        {
            arc.pop();
        }
        if place != ends[LEFT] {
            arc.push(place);
        }
    }
    let first = usize::from(beyond[LEFT] != NONE);
    let last = arc.len() - usize::from(beyond[RIGHT] != NONE);
    let lit = &arc[first..last];
    for &place in lit {
        *hidden ^= 1 << (place - base);
    }
    for pair in lit.windows(2) {
        links.set(pair[0], RIGHT, pair[1]);
        links.set(pair[1], LEFT, pair[0]);
    }
    let chain = match lit {
        [] => EMPTY,
        [first, ..] => [*first, lit[lit.len() - 1]],
    };
    context.arc = arc;
    chain
}

/// The candidates strictly between the ends that are vertices if none of the others is there.
#[inline(always)]
fn above<S: Side, K: Kernel2, O: Observer>(
    candidates: Hidden,
    base: Place,
    [l, r]: Chain,
    context: &Context<'_, K, O>,
) -> Hidden {
    let [left, right] = [l, r].map(|place| context.point(place));
    let mut above = 0;
    for place in places(between(candidates, base, [l, r]), base) {
        let is_above = context.keeps::<S>(left, context.point(place), right);
        above |= Hidden::from(is_above) << (place - base);
    }
    above
}

/// The places of the bits of `set` in the leaf that starts at `base`, in order.
#[inline(always)]
fn places(mut set: Hidden, base: Place) -> impl Iterator<Item = Place> {
    std::iter::from_fn(move || {
        let lowest = (set != 0).then(|| set.trailing_zeros());
        set &= set.wrapping_sub(1);
        lowest.map(|bit| base + bit)
    })
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
