# SPDX-License-Identifier: Apache-2.0
# Checks a page of smc report: every tag is closed in order, every id is there once, every link leads to one of the page, nothing is
# fetched, nothing runs.  Prints what is wrong; the exit code says whether something was.
function wrong(text) { print FILENAME ": " text; bad = 1 }

function attribute(tag, name,    i, rest) {
    i = index(tag, " " name "=\"")
    if (i == 0) return ""
    rest = substr(tag, i + length(name) + 3)
    return substr(rest, 1, index(rest, "\"") - 1)
}

function take(tag,    name, id, href) {
    if (tag ~ /^!DOCTYPE html$/) return
    name = tag
    sub(/[ \/].*/, "", name)
    if (substr(tag, 1, 1) == "/") {
        name = substr(tag, 2)
        if (depth == 0 || open[depth] != name) wrong("</" name "> closes <" open[depth] ">")
        depth--
        return
    }
    id = attribute(tag, "id")
    if (id != "" && seen[id]++) wrong("id '" id "' twice")
    href = attribute(tag, "href")
    if (href != "") {
        if (substr(href, 1, 1) != "#") wrong("a link leads out: " href)
        else wanted[substr(href, 2)] = 1
    }
    if (tag ~ / (src|srcset|action|data|poster|on[a-z]+)=/) wrong("fetches or runs something: " tag)
    if (name ~ /^(script|link|img|iframe|object|embed|form|base|audio|video)$/) wrong("<" name "> has no place here")
    if (tag !~ /\/$/) open[++depth] = name
}

{ text = text $0 "\n" }

END {
    n = split(text, piece, "<")
    for (i = 2; i <= n; i++) {
        end = index(piece[i], ">")
        if (end == 0) { wrong("a < that opens no tag"); continue }
        take(substr(piece[i], 1, end - 1))
        if (open[depth] != "style" && index(substr(piece[i], end + 1), ">")) wrong("a > that closes no tag: " substr(piece[i], 1, 60))
    }
    if (depth) wrong("<" open[depth] "> is not closed")
    for (id in wanted) if (!(id in seen)) wrong("no place has the id '" id "'")
    if (text ~ /@import|url\([^#)]/) wrong("the style fetches something")
    exit bad
}
