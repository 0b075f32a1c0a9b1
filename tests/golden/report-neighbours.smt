# The report says in words what `prev`, `rising` and `falling` compare, also in a definition.
args report a.sm --format=text | sed -n '/^  Call /,/^$/p'

-- a.sm --
[state_vector]
U64 G
U32 S
F64 p @read_only
bool stop @read_only
F64 last
bool up
U8 n

[define]
released = falling(stop)

[Run]
.step
    last = prev(p + 1)
    up = rising(stop)
    rising(p > 3): n = n + 1
    released: n = 0

-- stdout --
  Call           Meaning                                                    Steps  Line
  prev(p + 1)    `p + 1` one step before                                        2    15
  rising(stop)   whether `stop` is true now and was false one step before       2    16
  rising(p > 3)  whether `p > 3` is true now and was false one step before      2    17
  falling(stop)  whether `stop` is false now and was true one step before       2    11
