// SPDX-License-Identifier: Apache-2.0
// Measures the page that run.sh has put it into, in pixels of the browser, and writes the result into its title:
//   wide    elements that are wider than the window, other than those in a box that scrolls
//   clash   texts of a picture that overlap
//   blank   pictures without any text in what they show
(function () {
    const shown = (e) => e.getBoundingClientRect().width > 0;
    const meets = (a, b, x, y) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > x && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > y;
    const scrolls = (e) => e.closest('.wide, pre, figure') && getComputedStyle(e.closest('.wide, pre, figure')).overflowX === 'auto';
    const wide = [...document.querySelectorAll('body *')].filter((e) => shown(e) && !e.closest('svg, pre > *') && !scrolls(e) && e.getBoundingClientRect().right > innerWidth + 1);
    let clash = 0, blank = 0, pictures = 0;

    for (const svg of document.querySelectorAll('svg')) {
        if (!shown(svg))
            continue;
        const frame = svg.getBoundingClientRect();
        const text = [...svg.querySelectorAll('text')].map((t) => t.getBoundingClientRect()).filter((t) => t.width > 0);
        pictures++;
        blank += !text.some((t) => meets(t, frame, 4, 4));
        text.forEach((t, i) => text.slice(i + 1).forEach((u) => { clash += meets(t, u, 2, 4); }));
    }
    document.title = 'wide ' + wide.length + ', clash ' + clash + ', blank ' + blank + ', pictures ' + (pictures > 0 ? 'some' : 'none');
})();
