# An average falls with each of its two; the middle of three does not; one that is done wrong does.
warn no-all output-on-zero

-- app.sm --
[state_vector]
U64  G
U32  S
F32  p1 @read_only
F32  p2 @read_only
F32  p3 @read_only
bool mean
bool middle
bool wrong
[Watch] @safe
.step
    mean = (p1 + p2) / 2 < 40                                           #! W0903 'mean'
    middle = max(min(p1, p2), min(max(p1, p2), p3)) < 40
    wrong = min(max(p1, p2), p3) < 40                                   #! W0903 'p3' alone switches on 'wrong'
