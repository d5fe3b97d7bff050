//! For tests: whether a rotation or a reflection maps a web onto itself.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use glam::DVec3;

use crate::Web;

/// Whether a rotation by 360 / n degrees about the middle maps the web onto itself.
pub(crate) fn is_turned(web: &Web, n: usize) -> bool {
    let (sin, cos) = (TAU / n as f64).sin_cos();
    maps(web, 1e-12 * web.radius(), |p| DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z))
}

/// Whether the reflection of x maps the web onto itself, to the bit.
pub(crate) fn is_mirrored(web: &Web) -> bool {
    maps(web, 0.0, |p| DVec3::new(-p.x, p.y, p.z))
}

/// Whether `map` maps every knot onto a knot within `tolerance`, m, every rope onto a rope of the same class and rest
/// length, and the knots of the outline, the corners and the centre each onto themselves.
fn maps(web: &Web, tolerance: f64, map: impl Fn(DVec3) -> DVec3) -> bool {
    let knots = web.knots.iter().map(|knot| knot.position);
    // knots in a grid of small cells: the search for an image visits the cells nearby
    let size = 1e-3 * web.radius();
    let cell = |p: DVec3| ((p.x / size).round() as i64, (p.y / size).round() as i64);
    let mut near: BTreeMap<(i64, i64), Vec<usize>> = BTreeMap::new();
    for (knot, position) in knots.clone().enumerate() {
        near.entry(cell(position)).or_default().push(knot);
    }
    let image = |position: DVec3| {
        let (x, y) = cell(position);
        let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
        let candidates = around.filter_map(|at| near.get(&at)).flatten();
        candidates.copied().find(|&knot| web.knots[knot].position.distance(position) <= tolerance)
    };
    let Some(images) = knots.map(|p| image(map(p))).collect::<Option<Vec<usize>>>() else { return false };

    let ropes = |image: &dyn Fn(usize) -> usize| -> Vec<_> {
        let rope = |rope: &crate::Rope| {
            let (a, b) = (image(rope.a), image(rope.b));
            (a.min(b), a.max(b), rope.class.clone(), (web.rest_length(rope) * 1e9).round() as i64)
        };
        let mut ropes: Vec<_> = web.ropes.iter().map(rope).collect();
        ropes.sort();
        ropes
    };
    let outline: Vec<usize> = web.outline.iter().flatten().copied().collect();
    let same = |knots: &[usize]| {
        let there: BTreeSet<usize> = knots.iter().copied().collect();
        there == knots.iter().map(|&knot| images[knot]).collect()
    };
    ropes(&|knot| knot) == ropes(&|knot| images[knot])
        && [&outline, &web.corners, &web.centre].into_iter().all(|k| same(k))
}
