// SPDX-License-Identifier: Apache-2.0
// The width of a text.  The reader's font is unknown, so each character has its largest width in the usual fonts: DejaVu Sans, and
// Liberation Sans, which has the widths of Arial and Helvetica.  The drawn text is never wider.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/report/diagram_model.h"

// Widths of the characters from ' ' to '~' in thousandths of the font size; [1]: bold.
static const uint16_t ascii_width[2][95] = {
    {318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
     636, 636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 556,
     1015, 684, 686, 722, 770, 667, 611, 778, 752, 295, 500, 667, 557, 863, 748, 787,
     667, 787, 722, 667, 611, 732, 684, 989, 685, 667, 685, 390, 337, 390, 838, 556,
     500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
     635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838},
    {348, 456, 521, 838, 696, 1002, 872, 306, 457, 457, 523, 838, 380, 415, 380, 365,
     696, 696, 696, 696, 696, 696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 611,
     1000, 774, 762, 734, 830, 683, 683, 821, 837, 372, 556, 775, 637, 995, 837, 850,
     733, 850, 770, 720, 682, 812, 774, 1103, 771, 724, 725, 457, 365, 457, 838, 556,
     500, 675, 716, 593, 716, 678, 435, 716, 712, 343, 343, 665, 343, 1042, 712, 687,
     716, 716, 493, 595, 478, 712, 652, 924, 645, 652, 582, 712, 365, 712, 838}};

enum { OTHER_WIDTH = 1000 };      // width of every character outside ASCII, in thousandths of the font size

// Returns the width of the character at s in thousandths of the font size, and stores its length in *bytes.
static int32_t character_width(const char *s, size_t n, bool bold, size_t *bytes)
{
    uint32_t code;

    *bytes = utf8_decode(s, n, &code);
    if (*bytes == 0)
        *bytes = 1;
    return *bytes == 1 && *s >= ' ' && *s <= '~' ? ascii_width[bold][*s - ' '] : OTHER_WIDTH;
}

int32_t diagram_text_width(const char *text, int32_t size, bool bold)
{
    const size_t n = strlen(text);
    int64_t sum = 0;
    size_t bytes;

    for (size_t i = 0; i < n; i += bytes)
        sum += character_width(text + i, n - i, bold, &bytes);
    return (int32_t)((sum * size + 999) / 1000);
}

// Returns the number of bytes from the start of the text whose width is at most w.
static size_t count_fitting_bytes(const char *text, size_t n, int32_t size, bool bold, int32_t w)
{
    int64_t sum = 0;
    size_t bytes, i;

    for (i = 0; i < n; i += bytes) {
        sum += character_width(text + i, n - i, bold, &bytes);
        if (sum * size > (int64_t)w * 1000)
            break;
    }
    return i < n ? i : n;
}

static const char ellipsis[] = "\xe2\x80\xa6";    // …

// Returns the text, or the longest start of it that fits with "…".
const char *diagram_text_truncate(Arena *arena, const char *text, int32_t size, bool bold, int32_t w)
{
    const size_t n = strlen(text), fits = count_fitting_bytes(text, n, size, bold, w);

    if (fits == n)
        return text;
    return format_in(arena, "%.*s%s", (int)count_fitting_bytes(text, n, size, bold, w - diagram_text_width(ellipsis, size, bold)), text, ellipsis);
}

// ---- wrapping ----

// Costs of a line and of a line break at a position.  A condition is easiest to read if its lines end before "and" and "or", and if no call is
// broken.  An additional line costs less than breaking a call.
enum { NEW_LINE = 4, BEFORE_COMPARISON = 2, AFTER_COMMA = 3, ELSEWHERE = 4, AFTER_OPERATOR = 6, IN_GROUP = 2, IN_CALL = 6, NO_SPACE = 60 };

// Returns the cost of replacing the space at text[i] by a line break, outside of all brackets.
static uint32_t break_cost(const char *text, size_t i)
{
    const char *next = text + i + 1;

    return strncmp(next, "and ", 4) == 0 || strncmp(next, "or ", 3) == 0 ? 0
         : strchr("<>=!", *next)                                         ? BEFORE_COMPARISON
         : text[i - 1] == ','                                            ? AFTER_COMMA
         : strchr("<>=+-*/", text[i - 1])                                ? AFTER_OPERATOR
                                                                         : ELSEWHERE;
}

// The cheapest way to break the rest of a text, from a position on: where its first line ends, and the cost of all its lines.  `brackets`: the
// additional cost of a break at this position, because of the brackets around it.
typedef struct BestBreak { size_t end; uint32_t cost, brackets; } BestBreak;

// For each character: what a line break at it costs in addition, because of the brackets that are open there.
static void set_bracket_costs(const char *text, BestBreak *best)
{
    uint64_t calls = 0;           // a bit for each open bracket, lowest for the innermost: it encloses the arguments of a call
    uint32_t cost = 0;

    for (size_t i = 0; text[i]; i++) {
        if (text[i] == '(') {
            calls = calls << 1 | (i > 0 && !strchr(" (-", text[i - 1]));
            cost += calls & 1 ? IN_CALL : IN_GROUP;
        } else if (text[i] == ')' && cost > 0) {
            cost -= calls & 1 ? IN_CALL : IN_GROUP;
            calls >>= 1;
        }
        best[i].brackets = cost;
    }
}

// Chooses the end of a line that begins at text[i].  best[j] is known for all j > i.  Of equally cheap ends it takes the last, which fills the
// line most.
static void choose_line_end(const char *text, size_t n, size_t i, int32_t size, int32_t w, BestBreak *best)
{
    const size_t fits = i + count_fitting_bytes(text + i, n - i, size, false, w);

    if (fits == n) {
        best[i].end = n;
        best[i].cost = 0;
        return;
    }
    best[i].end = fits > i ? fits : i + 1;
    best[i].cost = NEW_LINE + NO_SPACE + best[best[i].end].cost;
    for (size_t end = i + 1; end <= fits; end++) {
        uint32_t cost;
        if (text[end] != ' ' || strncmp(text + i, ellipsis, end - i) == 0)        // "… and" stays together
            continue;
        cost = NEW_LINE + break_cost(text, end) + best[end].brackets + best[end + 1].cost;
        if (cost <= best[i].cost) {
            best[i].end = end;
            best[i].cost = cost;
        }
    }
}

static void add_line(Arena *arena, DiagramLines *out, const char *text, int32_t size)
{
    DiagramLine line = {text, diagram_text_width(text, size, false)};

    vec_push(arena, out, line);
}

// Wraps a text to at most `lines` lines, none wider than w.
DiagramLines diagram_text_wrap(Arena *arena, const char *text, int32_t size, int32_t w, size_t lines)
{
    const size_t n = strlen(text);
    BestBreak *best = ARENA_ARRAY(arena, BestBreak, n + 1);
    DiagramLines out = {NULL, 0, 0};
    size_t at = 0;

    set_bracket_costs(text, best);
    for (size_t i = n; i-- > 0;)
        choose_line_end(text, n, i, size, w, best);
    while (out.n + 1 < lines && best[at].end < n) {
        add_line(arena, &out, format_in(arena, "%.*s", (int)(best[at].end - at), text + at), size);
        at = best[at].end + (text[best[at].end] == ' ');
    }
    add_line(arena, &out, diagram_text_truncate(arena, text + at, size, false, w), size);
    return out;
}

// Whether the last line ends with "…".
bool diagram_text_is_truncated(const DiagramLines *lines)
{
    const char *last = lines->at[lines->n - 1].text;
    const size_t n = strlen(last), tail = sizeof ellipsis - 1;

    return n >= tail && strcmp(last + n - tail, ellipsis) == 0;
}
