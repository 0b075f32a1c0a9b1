// SPDX-License-Identifier: Apache-2.0
// The reference's own code, with counters in its entry functions.  These objects precede the library in the link, so that the linker uses them.
// Calls inside them go to the renamed originals.
#define ref_convert plain_ref_convert
#define ref_true plain_ref_true
#define ref_windows_sample plain_ref_windows_sample
#include "compiler/script/ref_number.c"
#define is_before window_is_before
#include "compiler/script/ref_window.c"
#undef ref_convert
#undef ref_true
#undef ref_windows_sample

#include "tests/diff/watch.h"

Watch watch;

uint64_t ref_convert(SmType type, double x);
bool ref_true(double x);
void ref_windows_sample(RefWindows *w, const uint64_t *cell);

static void note_value(double x)
{
    watch.nan += is_nan(x);
    watch.infinite += is_infinite(x);
}

uint64_t ref_convert(SmType type, double x)
{
    const uint64_t cell = plain_ref_convert(type, x);
    const SmKind kind = sm_type_info[type].kind;
    note_value(x);
    watch.stores++;
    if (kind == SM_KIND_SIGNED || kind == SM_KIND_UNSIGNED) {
        const double lost = x - ref_read(type, cell);
        watch.saturated += lost >= 1 || lost <= -1;
    }
    return cell;
}

bool ref_true(double x)
{
    note_value(x);
    return plain_ref_true(x);
}

void ref_windows_sample(RefWindows *w, const uint64_t *cell)
{
    plain_ref_windows_sample(w, cell);
    for (size_t i = 0; i < w->n; i++)
        watch.filled += w->at[i].filled == w->at[i].what->size && w->at[i].what->size > 1;
}
