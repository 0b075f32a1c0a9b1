spec 1.11, 5.30   A state vector may declare any name that is not reserved, words of other languages among them.

-- app.sm --
[state_vector]
U64 G
U32 S
bool ELSE
bool otherwise
bool If
bool NOT
bool AND
bool is
bool then
bool when
bool while
bool stop
bool end
bool step
bool entry
bool set
bool goto
bool delta_t
bool TRUE
F64 x

[Run]
.step
    x = 0
    ELSE: x = x + 1
    else: x = x + 2
    otherwise { x = x + 4 }
    If: x = x + 8
    NOT: when: while: x = x + 16
    stop
    { x = x + 32 }
    end: x = x + 64
    step: entry: x = x + 128
    set = goto
    goto = set - 1
    if set: goto = -set
    then > AND: is = then
    if is == TRUE and not NOT or AND == stop: x = x + 256
    if (when) and (If): while = (end)
    set -1 > goto: end = entry
    delta_t = true
    TRUE = false
